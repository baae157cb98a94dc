#include "measurement/discharge.h"

#include <fmt/core.h>

#include "measurement/discharged_mass.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

/// The mass below the orifice over time, from the opening of the vessel.
class DischargeWatch : public Watch {
 public:
  void vessel_opens(const Simulation& simulation) override {
    opened_ = true;
    add(simulation);
  }
  void look(const Simulation& simulation) override { add(simulation); }
  void phase_ends(const Simulation& simulation) override { add(simulation); }

  void finish(const Simulation& simulation, const ReadFile&, Figures& figures) override {
    if (!opened_) return;
    const double total = total_mass(simulation.comm(), simulation.materials(), simulation.mass_unit(),
                                    simulation.particles(), simulation.left_here());
    const Discharge d = record_.result(total, simulation.deck().discharge.plugged_share);
    figures["discharged_mass_kg"] = d.mass;
    figures["retained_mass_kg"] = d.retained_mass;
    if (d.time) figures["discharge_time_s"] = *d.time;
    if (d.rate) figures["discharge_rate_kg_s"] = *d.rate;
    figures["plugged"] = d.plugged;
  }

  void visit_state(StateWriter& v) const override { visit(*this, v); }
  void visit_state(StateReader& v) override { visit(*this, v); }

 private:
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor& v) {
    v("opened", self.opened_);
    v("record", self.record_);
  }

  void add(const Simulation& simulation) {
    if (!opened_) return;
    const double mass =
        discharged_mass(simulation.comm(), simulation.deck().discharge.orifice_height, simulation.materials(),
                        simulation.mass_unit(), simulation.particles(), simulation.left_here());
    const auto& samples = record_.samples();
    if (samples.empty() || simulation.time() > samples.back().time) record_.add(simulation.time(), mass);
  }

  bool opened_ = false;
  DischargeRecord record_;
};

/// Of the grains in a file; the course of the discharge is not in it.
void measure(const FinishedState& state, Figures& figures) {
  if (state.mass.empty()) return;
  double below = 0.0;
  double above = 0.0;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    (state.grains[i].centre.z < state.deck.discharge.orifice_height ? below : above) += state.mass[i];
  }
  figures["discharged_mass_kg"] = below;
  figures["retained_mass_kg"] = above;
}

std::string lines(const Figures& figures) {
  const auto number = [&](const char* key, double factor) {
    const auto value = number_in(figures, key);
    return value ? fmt::format("{:.4g}", factor * *value) : std::string("-");
  };
  if (!number_in(figures, "discharged_mass_kg")) return {};
  return fmt::format("discharged {} g, retained {} g{}, in {} s at {} g/s\n", number("discharged_mass_kg", 1e3),
                     number("retained_mass_kg", 1e3), figures.value("plugged", false) ? " (plugged)" : "",
                     number("discharge_time_s", 1.0), number("discharge_rate_kg_s", 1e3));
}

}  // namespace

MeasurementKind discharge_measurement() {
  return {.section = "measurement.discharge",
          .is_enabled = [](const Deck& deck) { return deck.discharge.enabled; },
          .figures = {{.key = "discharged_mass_kg", .from = Figure::From::grains},
                      {.key = "retained_mass_kg", .from = Figure::From::grains},
                      {.key = "discharge_time_s"},
                      {.key = "discharge_rate_kg_s"},
                      {.key = "plugged", .kind = Figure::Kind::other}},
          .watch = [](const Simulation&, const SeriesFolder&) -> std::unique_ptr<Watch> {
            return std::make_unique<DischargeWatch>();
          },
          .measure = measure,
          .lines = lines};
}

}  // namespace repose
