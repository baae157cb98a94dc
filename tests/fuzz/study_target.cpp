// Parameters to run at and figures to compare: what calibrate reads, else what sensitivity reads.
#include <cmath>

#include "deck/calibration_deck.h"
#include "deck/sensitivity_deck.h"
#include "target.h"

namespace repose::fuzz {
namespace {

void expect_sound(const StudyDeck& study) {
  for (const ParameterDeck& p : study.parameters) {
    expect(p.min < p.max, "a parameter has a range");
    expect(p.name.find('/') == std::string::npos && p.name.find('.') == std::string::npos, "a name is no path");
  }
}

bool accepts_calibration(std::string_view input) {
  CalibrationDeck deck;
  if (!is_done([&] { deck = read_calibration_deck(std::string(input), "calibration.toml"); })) return false;
  expect_sound(deck.study);
  if (deck.points.size() > 1000) return true;
  double count = 1.0;
  for (const ParameterDeck& p : deck.study.parameters)
    count *= static_cast<double>(std::max<std::int64_t>(p.points, 1));
  if (count > 1000.0) return true;  // sound, but slow to look at
  for (const std::vector<double>& point : points_of(deck)) {
    expect(point.size() == deck.study.parameters.size(), "a point has a value for each parameter");
    for (std::size_t k = 0; k < point.size(); ++k) {
      const ParameterDeck& p = deck.study.parameters[k];
      const double slack = 1e-11 * std::fmax(std::fabs(p.min), std::fabs(p.max));
      expect(point[k] >= p.min - slack && point[k] <= p.max + slack, "it lies in its range");
    }
  }
  return true;
}

}  // namespace

bool accepts(std::string_view input) {
  if (accepts_calibration(input)) return true;
  SensitivityDeck deck;
  if (!is_done([&] { deck = read_sensitivity_deck(std::string(input), "sensitivity.toml"); })) return false;
  expect_sound(deck.study);
  return true;
}

}  // namespace repose::fuzz
