#include <algorithm>

#include <fmt/core.h>

#include "output/collect_particles.h"
#include "output/vector_rows.h"
#include "run/measurements/measurement.h"

namespace repose {

const std::vector<MeasurementKind>& measurement_kinds() {
  static const std::vector<MeasurementKind> kinds = {
      discharge_measurement(),      angle_of_repose_measurement(),
      scattering_measurement(),     tilt_onset_measurement(),
      surface_angle_measurement(),  bulk_density_measurement(),
      retained_slope_measurement(), heat_measurement(),
      servo_measurement(),          shear_measurement(),
      compression_measurement(),    flow_energy_measurement(),
      tilting_box_measurement(),
  };
  return kinds;
}

std::string name_of(const MeasurementKind& kind) {
  std::string name = kind.section.substr(kind.section.rfind('.') + 1);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string absence_of(const MeasurementKind& kind) { return fmt::format("no {}, so no {}", kind.of, name_of(kind)); }

Figures no_figures(Figure::From from) {
  Figures figures = Figures::object();
  for (const MeasurementKind& kind : measurement_kinds()) {
    for (const Figure& figure : kind.figures) {
      const bool is_asked = from == Figure::From::run || figure.from == Figure::From::grains;
      if (is_asked && figure.key.find('.') == std::string::npos) figures[figure.key] = figure.absent;
    }
  }
  return figures;
}

GatheredGrains gather_grains(const Simulation& simulation) {
  const Communicator& comm = simulation.comm();
  const ParticleTable table =
      collect_particles(comm, simulation.materials(), simulation.particles(), simulation.planned());
  const std::vector<double> position = comm.gather(table.position);
  const std::vector<double> radius = comm.gather(table.radius);
  GatheredGrains grains = {.spheres = std::vector<Sphere>(radius.size()), .mass = comm.gather(table.mass)};
  for (std::size_t i = 0; i < radius.size(); ++i) grains.spheres[i] = {vector_at(position, i), radius[i]};
  return grains;
}

}  // namespace repose
