#include "pile_measurement.h"

#include "measurement/draw.h"
#include "measurement/pile.h"

namespace repose {

std::vector<Sphere> gather_spheres(const Communicator& comm, const ParticleTable& table) {
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

}  // namespace repose
