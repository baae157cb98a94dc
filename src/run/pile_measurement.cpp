#include "run/pile_measurement.h"

#include <cstdio>

#include <fmt/format.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/atomic_file.h"
#include "measurement/pile.h"
#include "output/collect_particles.h"
#include "output/vector_rows.h"
#include "pictures/silhouette_picture.h"
#include "pictures/top_view_picture.h"

namespace repose {

std::vector<Sphere> gather_grains(const Simulation& simulation) {
  const Communicator& comm = simulation.comm();
  const ParticleTable table =
      collect_particles(comm, simulation.materials(), simulation.particles(), simulation.planned());
  const std::vector<double> position = comm.gather(table.position);
  const std::vector<double> radius = comm.gather(table.radius);
  std::vector<Sphere> grains(radius.size());
  for (std::size_t i = 0; i < radius.size(); ++i) {
    grains[i] = {vector_at(position, i), radius[i]};
  }
  return grains;
}

namespace {

AngleOfReposeParameters parameters_of(const AngleOfReposeDeck& deck) {
  AngleOfReposeParameters parameters;
  parameters.plate_height = deck.plate_height;
  parameters.axis = deck.axis;
  parameters.fit_from = deck.fit_from;
  parameters.fit_to = deck.fit_to;
  parameters.azimuths = static_cast<std::size_t>(deck.azimuths);
  if (deck.camera == Camera::perspective) {
    parameters.camera_distance = deck.camera_distance;
    parameters.camera_height = deck.camera_height;
  }
  return parameters;
}

/// What cannot be measured, such as with a camera inside the pile, must not cost the rest of a run's results.
template <class Measure>
void warn_of_failure(const RunLog& log, const char* figure, Measure&& measure) {
  try {
    measure();
  } catch (const DeckError& error) {
    log.warn(fmt::format("no {}: {}", figure, error.what()));
  }
}

std::string area_text(const AreaCount& area) {
  const std::string to = area.to ? fmt::format("to {:.4g} mm", 1e3 * *area.to) : "to the edge";
  return fmt::format("{} +- {:.0f} (from {:.4g} {})", area.count, area.error, 1e3 * area.from, to);
}

std::string scattering_lines(const Scattering& s) {
  std::string text = s.measured_base_radius
                         ? fmt::format("base of the pile {:.4g} mm in diameter\n", 2e3 * *s.measured_base_radius)
                         : std::string("no base of a pile\n");
  text += fmt::format("grains on area 1 {}\n", area_text(s.area_1));
  if (s.area_2) text += fmt::format("grains on area 2 {}\n", area_text(*s.area_2));
  text += fmt::format("grains on area 3 {}\n", area_text(s.area_3));
  for (const AreaCount& area : s.area_1_widened) text += fmt::format("area 1 widened {}\n", area_text(area));
  for (const AreaCount& area : s.area_3_widened) text += fmt::format("area 3 widened {}\n", area_text(area));
  return text + fmt::format("grains off the plate {}\n", s.off_plate);
}

}  // namespace

void measure_angle_of_repose(const AngleOfReposeDeck& deck, std::span<const Sphere> grains, const std::string& picture,
                             PileSummary& summary) {
  const AngleOfReposeParameters parameters = parameters_of(deck);
  const std::vector<Sphere> pile = find_pile(grains, deck.plate_height, deck.max_height);
  const std::optional<AngleOfRepose> angle = angle_of_repose(pile, parameters);
  if (!angle) return;
  if (!picture.empty()) write_text_file(picture, silhouette_png(*angle, pile, parameters));
  summary.angle_of_repose_deg = angle->mean_deg;
  summary.angle_of_repose_left_deg = angle->left_deg;
  summary.angle_of_repose_right_deg = angle->right_deg;
  summary.angle_of_repose_stderr_deg = angle->stderr_deg;
  summary.pile_height_m = angle->pile_height;
}

void measure_scattering(const ScatteringDeck& deck, std::span<const Sphere> grains, std::int64_t left_domain,
                        const std::string& picture, PileSummary& summary) {
  summary.scattering = scattering(deck, grains, left_domain);
  if (summary.scattering && !picture.empty()) write_text_file(picture, top_view_png(deck, *summary.scattering, grains));
}

void summarise_pile(const Simulation& simulation, const std::string& directory, const RunLog& log, Summary& summary) {
  const Deck& deck = simulation.deck();
  const bool has_pile = deck.angle_of_repose.enabled && !summary.plugged.value_or(false);
  if (!has_pile && !deck.scattering.enabled) return;
  const std::vector<Sphere> grains = gather_grains(simulation);
  agree_after_root(simulation.comm(), [&] {
    if (has_pile) {
      warn_of_failure(log, "angle of repose", [&] {
        measure_angle_of_repose(deck.angle_of_repose, grains, directory + "/" + silhouette_file, summary.pile);
      });
    }
    if (deck.scattering.enabled) {
      warn_of_failure(log, "scattering", [&] {
        measure_scattering(deck.scattering, grains, summary.left, directory + "/" + top_view_file, summary.pile);
      });
    }
  });
}

std::string pile_lines(const PileSummary& pile) {
  const auto degrees = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4g}", *value) : std::string("-");
  };
  std::string text;
  if (pile.angle_of_repose_deg) {
    text += fmt::format("angle of repose {} +- {} degrees (left {}, right {})\n", degrees(pile.angle_of_repose_deg),
                        degrees(pile.angle_of_repose_stderr_deg), degrees(pile.angle_of_repose_left_deg),
                        degrees(pile.angle_of_repose_right_deg));
  }
  if (pile.scattering) text += scattering_lines(*pile.scattering);
  return text;
}

}  // namespace repose
