#include "commands/measure.h"

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "deck/resolved_deck.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/shared_file.h"
#include "output/snapshot_reader.h"
#include "run/pile_measurement.h"
#include "scene/insertion/particle_csv.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

/// The grains of a file, and how many had left before it was written, if it tells.
struct FinishedState {
  std::vector<Sphere> grains;
  std::vector<double> mass;  ///< kg; empty when the materials are unknown
  std::optional<std::int64_t> left;
};

FinishedState read_state(const Deck& deck, const std::string& file) {
  const std::string bytes = read_whole_file(file);
  FinishedState state;
  NewParticles particles;
  if (is_snapshot(bytes)) {
    particles = parse_snapshot(bytes, file, deck.materials);
    state.left = left_before_snapshot(bytes, file);
  } else {
    particles = parse_measured_csv(bytes, file, deck.materials);
  }
  for (std::size_t i = 0; i < particles.size(); ++i)
    state.grains.push_back({particles.position[i], particles.radius[i]});
  for (std::size_t i = 0; i < particles.material.size(); ++i) {
    const auto material = static_cast<std::size_t>(particles.material[i]);
    state.mass.push_back(sphere_mass(particles.radius[i], deck.materials[material].density));
  }
  return state;
}

void measure_masses(const DischargeDeck& deck, const FinishedState& state, MeasurementSummary& summary) {
  if (!deck.enabled || state.mass.empty()) return;
  double below = 0.0;
  double above = 0.0;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    (state.grains[i].centre.z < deck.orifice_height ? below : above) += state.mass[i];
  }
  summary.discharged_mass_kg = below;
  summary.retained_mass_kg = above;
}

/// What an earlier measurement has left in the same directory would pass for this one's.
void prepare_directory(const std::string& output) {
  create_output_directory(output);
  for (const char* name : {"measurement.json", silhouette_file, top_view_file}) {
    std::filesystem::remove(output + "/" + name);
  }
}

MeasurementSummary measure(const Deck& deck, const std::string& file, const std::string& output) {
  const FinishedState state = read_state(deck, file);
  if (!output.empty()) prepare_directory(output);
  const auto path = [&](const char* name) { return output.empty() ? std::string() : output + "/" + name; };
  MeasurementSummary summary;
  summary.file = file;
  summary.title = deck.run.title;
  summary.particles = std::ssize(state.grains);
  summary.left = state.left;
  measure_masses(deck.discharge, state, summary);
  if (deck.angle_of_repose.enabled) {
    measure_angle_of_repose(deck.angle_of_repose, state.grains, path(silhouette_file), summary.pile);
  }
  if (deck.scattering.enabled) {
    measure_scattering(deck.scattering, state.grains, state.left.value_or(0), path(top_view_file), summary.pile);
  }
  summary.build = build_info("");
  summary.deck = resolved_deck(deck);
  if (!output.empty()) write_text_file(path("measurement.json"), measurement_json(summary));
  return summary;
}

std::string lines_of(const Deck& deck, const MeasurementSummary& s) {
  std::string text = fmt::format("{} particles{}\n", s.particles,
                                 s.left ? fmt::format(", {} had left the domain before", *s.left) : std::string());
  if (s.discharged_mass_kg) {
    text += fmt::format("below the orifice {:.6g} g, retained {:.6g} g\n", 1e3 * *s.discharged_mass_kg,
                        1e3 * *s.retained_mass_kg);
  }
  if (s.pile.pile_height_m) text += fmt::format("height of the pile {:.4g} mm\n", 1e3 * *s.pile.pile_height_m);
  if (deck.angle_of_repose.enabled && !s.pile.angle_of_repose_deg) text += "no pile, so no angle of repose\n";
  if (deck.scattering.enabled && !s.pile.scattering) text += "no pile, so no scattering\n";
  return text + pile_lines(s.pile);
}

}  // namespace

std::string measure_file(const Communicator& comm, const Deck& deck, const std::string& file,
                         const std::string& output) {
  if (!deck.discharge.enabled && !deck.angle_of_repose.enabled && !deck.scattering.enabled) {
    throw DeckError(
        "nothing to measure: the deck has none of [measurement.discharge], [measurement.angle_of_repose] and "
        "[measurement.scattering]");
  }
  std::string text;
  agree_after_root(comm, [&] { text = lines_of(deck, measure(deck, file, output)); });
  return text;
}

}  // namespace repose
