// An HDF5 file of valid structure, described in text (hdf5_image.h), as a checkpoint.
#include <cmath>

#include "hdf5_image.h"
#include "output/checkpoint_reader.h"
#include "target.h"

namespace repose::fuzz {

bool accepts(std::string_view input) {
  const std::string image = hdf5_image(parse_hdf5_items(input));
  Checkpoint checkpoint;
  if (!is_done([&] { checkpoint = parse_checkpoint(image, "checkpoint.hdf"); })) return false;
  const Particles& particles = checkpoint.particles;
  expect(particles.record.size() == particles.owned && particles.sum.size() == particles.owned &&
             particles.id.size() == particles.owned && particles.material.size() == particles.owned,
         "every particle has all it needs");
  expect(checkpoint.memory.pairs.rows() == particles.owned && checkpoint.memory.walls.rows() == particles.owned,
         "every particle has its contacts");
  expect(checkpoint.memory.pairs.offset.back() == checkpoint.memory.pairs.items.size() &&
             checkpoint.memory.walls.offset.back() == checkpoint.memory.walls.items.size(),
         "every contact has its particle");
  for (const ParticleRecord& p : particles.record) expect(p.radius > 0.0 && std::isfinite(p.radius), "a radius is one");
  return true;
}

}  // namespace repose::fuzz
