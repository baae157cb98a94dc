#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "files/read_file.h"
#include "measurement/sphere.h"
#include "output/state_json.h"
#include "output/time_series.h"
#include "run/measurements/figures.h"
#include "simulation/simulation.h"

namespace repose {

/// A measurement that watches a run. Every member but sync is collective; the recorder calls them and gives no state to
/// it that a guard has found unfit.
class Watch {
 public:
  virtual ~Watch() = default;

  virtual void phase_begins(const Simulation&, const std::string& /*name*/) {}
  /// The first phase that removes a wall begins; the first of all when none does.
  virtual void vessel_opens(const Simulation&) {}
  /// Every run.check_every steps.
  virtual void look(const Simulation&) {}
  virtual void phase_ends(const Simulation&) {}
  /// Whether it wants to see the state after this step, besides; then `sample` is called.
  virtual bool is_due(std::int64_t) const { return false; }
  virtual void sample(const Simulation&) {}
  /// Whether it has seen what a phase with this condition waits for.
  virtual bool has_seen(PhaseUntil) const { return false; }
  /// Its figures at the end of the run. `read_file` reads the files that the deck names.
  virtual void finish(const Simulation& simulation, const ReadFile& read_file, Figures& figures) = 0;
  /// Brings its files to the disk. For rank 0.
  virtual void sync() {}

  /// What it has to remember over a restart.
  virtual void visit_state(StateWriter&) const {}
  virtual void visit_state(StateReader&) {}
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    self.visit_state(v);
  }

 protected:
  Watch() = default;
  Watch(const Watch&) = default;
  Watch& operator=(const Watch&) = default;
};

/// Grains at rest at the end of a run, or in a file that `repose measure` reads.
struct FinishedState {
  const Deck& deck;
  std::vector<Sphere> grains;
  std::vector<double> mass;          ///< kg; empty when it is not known
  std::optional<std::int64_t> left;  ///< grains that have left the domain; a list does not tell
  std::string directory;             ///< of the pictures; empty: none are drawn
};

/// A key of summary.json.
struct Figure {
  enum class Kind { number, other };
  std::string key;           ///< with dots where it stands in an object: those objects are figures of their own
  Kind kind = Kind::number;  ///< a number can be asked for by studies
  Figures absent = nullptr;  ///< its value where nothing was measured
  enum class From { grains, run };
  From from = From::run;  ///< grains: those of a file tell as well
};

/// Where a watch of a run writes its series.
struct SeriesFolder {
  std::string directory;
  Existing existing;
};

/// One of the measurements of a deck: how it is called, what it gives, and how it comes about. It has `watch`, or
/// `measure`, or both: then a run is watched and a file is measured.
struct MeasurementKind {
  std::string section;  ///< of the deck
  bool (*is_enabled)(const Deck& deck);
  std::vector<Figure> figures;
  std::vector<std::string> files = {};  ///< in the output folder; a new run removes those of an earlier one
  std::unique_ptr<Watch> (*watch)(const Simulation& simulation, const SeriesFolder& folder) = nullptr;
  /// Adds what can be told from the grains at the end to the figures, some of which may be there. DeckError when it
  /// cannot be measured, FileError when a picture cannot be written. For one rank.
  void (*measure)(const FinishedState& state, Figures& figures) = nullptr;
  /// The figures as lines for a person; empty when there are none.
  std::string (*lines)(const Figures& figures) = nullptr;
  std::string of = "pile";  ///< what has to be there to be measured
};

/// All of them, in the order in which they are made; a later one may look at the figures of an earlier one.
const std::vector<MeasurementKind>& measurement_kinds();

/// As in "no angle of repose".
std::string name_of(const MeasurementKind& kind);
/// "no pile, so no angle of repose"
std::string absence_of(const MeasurementKind& kind);

/// The figures of a run, or of grains, of which nothing was measured.
Figures no_figures(Figure::From from = Figure::From::run);

MeasurementKind discharge_measurement();
MeasurementKind angle_of_repose_measurement();
MeasurementKind scattering_measurement();
MeasurementKind tilt_onset_measurement();
MeasurementKind surface_angle_measurement();
MeasurementKind bulk_density_measurement();
MeasurementKind retained_slope_measurement();
MeasurementKind heat_measurement();
MeasurementKind servo_measurement();
MeasurementKind shear_measurement();
MeasurementKind compression_measurement();
MeasurementKind flow_energy_measurement();
MeasurementKind tilting_box_measurement();

struct GatheredGrains {
  std::vector<Sphere> spheres;
  std::vector<double> mass;  ///< kg
};

/// Collective. All grains of this moment on rank 0, in the order of their ids; nothing elsewhere.
GatheredGrains gather_grains(const Simulation& simulation);

}  // namespace repose
