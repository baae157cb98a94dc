#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "thermal/plane_source/synthetic_transient.h"
#include "thermal/plane_source/tps_criteria.h"
#include "thermal/tool_input.h"

namespace repose::thermal {

enum class SourceType { rings, disc };
constexpr auto enumerators(SourceType) { return std::array<std::string_view, 2>{"rings", "disc"}; }

struct SensorDeck {
  SourceType type = SourceType::rings;
  double radius = 0.0;
  double radius_deviation = 0.0;
  std::int64_t rings = 15;
  double cutoff = 0.01;
  Thermometer thermometer;
};

/// How a transient is evaluated.
struct EvaluationDeck {
  double power = 0.0;  ///< W; 0: the file has it
  double power_deviation = 0.0;
  std::int64_t first = 10;
  std::int64_t last = 0;
  double bulk_density = 0.0;  ///< kg/m3; 0: no mass heat capacity
};

/// How often a measurement is to be repeated.
struct RepeatsDeck {
  std::int64_t min = 3;
  double interval = 2700.0;
  std::vector<double> starts;  ///< s, of the files in their order
};

struct SyntheticDeck {
  bool enabled = false;
  SyntheticTransient transient;
};

struct TpsDeck {
  std::string title;
  SensorDeck sensor;
  EvaluationDeck evaluation;
  TpsLimits limits;
  RepeatsDeck repeats;
  SyntheticDeck synthetic;
};

/// Reads and checks it. DeckError as of read_tool_deck.
TpsDeck read_tps_deck(const ToolInput& input);

/// All keys of it, as `repose keys` prints them.
std::string tps_keys();

/// The dimensionless rise of the deck's sensor.
SourceFunction source_of(const SensorDeck& sensor);

}  // namespace repose::thermal
