#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/scenes.h"

/// Small scenes that hit a guard, and the message it gives.
namespace repose::test {

inline constexpr double radius = 1e-3;

/// Runs until a PhysicsError; its message must be the same on all ranks. Empty when none comes.
template <class Work>
std::string physics_error_of(const Work& work) {
  std::string message;
  try {
    work();
  } catch (const PhysicsError& error) {
    message = error.what();
  }
  std::string of_root = message;
  Communicator(MPI_COMM_WORLD).broadcast(of_root);
  EXPECT_EQ(message, of_root);
  return message;
}
inline std::string physics_error(Scene& scene, std::int64_t steps) {
  return physics_error_of([&] { scene.run(steps); });
}
/// The same, the set-up included.
inline std::string physics_error(const Deck& deck, const std::vector<Grain>& grains, std::int64_t steps) {
  return physics_error_of([&] {
    Scene scene(deck, grains);
    scene.simulation().begin_phase("only");
    scene.run(steps);
  });
}

inline void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
  }
}

/// Grains at rest, far apart, so that every rank owns some.
inline std::vector<Grain> bystanders(int count) {
  std::vector<Grain> grains;
  for (int k = 0; k < count; ++k) grains.push_back({{0.02 * k, 0.5, 0.01 * (k % 3)}, {}, {}, radius});
  return grains;
}

}  // namespace repose::test
