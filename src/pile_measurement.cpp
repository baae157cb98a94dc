#include "pile_measurement.h"

#include <cstdio>

#include <fmt/format.h>

#include "base/error.h"
#include "measurement/draw.h"
#include "measurement/pile.h"
#include "output/agreement.h"
#include "output/collect_particles.h"

namespace repose {

std::vector<Sphere> gather_grains(const Simulation& simulation) {
  const Communicator& comm = simulation.comm();
  const ParticleTable table =
      collect_particles(comm, simulation.materials(), simulation.particles(), simulation.planned());
  const std::vector<double> position = comm.gather(table.position);
  const std::vector<double> radius = comm.gather(table.radius);
  std::vector<Sphere> grains(radius.size());
  for (std::size_t i = 0; i < radius.size(); ++i) {
    grains[i] = {{position[3 * i], position[3 * i + 1], position[3 * i + 2]}, radius[i]};
  }
  return grains;
}

std::optional<AngleOfRepose> measure_angle_of_repose(const AngleOfReposeDeck& deck, std::span<const Sphere> grains,
                                                     const std::string& picture) {
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
  const std::vector<Sphere> pile = find_pile(grains, deck.plate_height, deck.max_height);
  const std::optional<AngleOfRepose> angle = angle_of_repose(pile, parameters);
  if (angle) write_silhouette_png(picture, *angle, pile, parameters);
  return angle;
}

void summarise_pile(const Simulation& simulation, const std::string& picture, Summary& summary) {
  const std::vector<Sphere> grains = gather_grains(simulation);
  agree_after_root(simulation.comm(), [&] {
    std::optional<AngleOfRepose> angle;
    try {
      angle = measure_angle_of_repose(simulation.deck().angle_of_repose, grains, picture);
    } catch (const DeckError& error) {  // such as a camera inside the pile: the rest of the results is good
      fmt::print(stderr, "repose: warning: no angle of repose: {}\n", error.what());
    }
    if (!angle) return;
    summary.angle_of_repose_deg = angle->mean_deg;
    summary.angle_of_repose_left_deg = angle->left_deg;
    summary.angle_of_repose_right_deg = angle->right_deg;
    summary.angle_of_repose_stderr_deg = angle->stderr_deg;
  });
}

}  // namespace repose
