// An HDF5 file of valid structure, described in text (hdf5_image.h), as a snapshot of particles.
#include "hdf5_image.h"
#include "output/file_contents.h"
#include "output/snapshot_reader.h"
#include "particle_promises.h"

namespace repose::fuzz {

bool accepts(std::string_view input) {
  const std::string image = hdf5_image(parse_hdf5_items(input));
  const auto materials = two_materials();
  is_done([&] { file_contents(image, "state.hdf"); });
  is_done([&] {
    const SnapshotParticles found = snapshot_particles(image, "state.hdf");
    check_particles(found.particles, found.materials.size());
  });
  NewParticles particles;
  if (!is_done([&] { particles = parse_snapshot(image, "state.hdf", materials); })) return false;
  check_particles(particles, materials.size());
  return true;
}

}  // namespace repose::fuzz
