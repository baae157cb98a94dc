#include "measurement/bulk_density.h"

#include <algorithm>

#include <fmt/core.h>

#include "run/measurements/measurement.h"

namespace repose {
namespace {

void add(const std::optional<BulkDensity>& found, Figures& figures) {
  if (!found) return;
  if (found->density) figures["bulk_density_kg_m3"] = *found->density;
  figures["porosity"] = found->porosity;
  figures["bulk_density_top_m"] = found->top;
}

/// The bed before the vessel opens; at the end of a run in which none does.
class BulkDensityWatch : public Watch {
 public:
  void vessel_opens(const Simulation& simulation) override {
    const auto& phases = simulation.deck().phases;
    const auto opens = [](const PhaseDeck& phase) { return !phase.remove_walls.empty(); };
    if (std::any_of(phases.begin(), phases.end(), opens)) see(simulation);
  }

  void finish(const Simulation& simulation, const ReadFile&, Figures& figures) override {
    if (!seen_) see(simulation);
    add(found_, figures);
  }

  void visit_state(StateWriter& v) const override { visit(*this, v); }
  void visit_state(StateReader& v) override { visit(*this, v); }

 private:
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor& v) {
    v("seen", self.seen_);
    v("found", self.found_);
  }

  void see(const Simulation& simulation) {
    seen_ = true;
    const GatheredGrains grains = gather_grains(simulation);
    const Deck& deck = simulation.deck();
    found_ = bulk_density(deck.bulk_density, deck.domain, grains.spheres, grains.mass);
  }

  bool seen_ = false;
  std::optional<BulkDensity> found_;  ///< rank 0
};

/// Of the bed in a file.
void measure(const FinishedState& state, Figures& figures) {
  add(bulk_density(state.deck.bulk_density, state.deck.domain, state.grains, state.mass), figures);
}

std::string lines(const Figures& figures) {
  const auto porosity = number_in(figures, "porosity");
  if (!porosity) return {};
  const auto density = number_in(figures, "bulk_density_kg_m3");
  return (density ? fmt::format("bulk density {:.5g} kg/m3, ", *density) : std::string()) +
         fmt::format("porosity {:.4g}\n", *porosity);
}

}  // namespace

MeasurementKind bulk_density_measurement() {
  return {.section = "measurement.bulk_density",
          .is_enabled = [](const Deck& deck) { return deck.bulk_density.enabled; },
          .figures = {{.key = "bulk_density_kg_m3", .from = Figure::From::grains},
                      {.key = "porosity", .from = Figure::From::grains},
                      {.key = "bulk_density_top_m", .from = Figure::From::grains}},
          .watch = [](const Simulation&, const SeriesFolder&) -> std::unique_ptr<Watch> {
            return std::make_unique<BulkDensityWatch>();
          },
          .measure = measure,
          .lines = lines,
          .of = "settled bed over the whole box"};
}

}  // namespace repose
