#pragma once

#include <string>
#include <vector>

#include "deck/read_deck.h"
#include "files/shared_file.h"

namespace repose::test {

/// Collective. A small discharge: grains fall, settle a little, the gate opens, some leave the domain through its
/// floor. With further overrides.
inline Deck small_discharge(const std::vector<std::string>& overrides = {}) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string path = std::string(REPOSE_SOURCE_DIR) + "/input/discharge_quick.toml";
  std::vector<std::string> all = {"particles.0.mass=0.06 g",
                                  "particles.0.height=10 mm",
                                  "domain.min=[-0.004, -0.004, -0.003]",
                                  "time.step=6e-6",
                                  "wall.plate.present=false",
                                  "wall.vessel.points=[[0.002,0.04],[0.002,0],[0.00125,0]]",
                                  "wall.lid.radius=0.00125",
                                  "particles.0.radius=0.002",
                                  "particles.0.spacing=0.0006",
                                  "measurement.angle_of_repose.plate_height=-0.003",
                                  "measurement.scattering.plate_height=-0.003"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return read_deck(read_shared_file(world, path), path, all);
}

}  // namespace repose::test
