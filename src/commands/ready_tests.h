#pragma once

#include <string>
#include <vector>

namespace repose {

/// A deck of input/ that `repose new` offers: READY_TESTS in the CMakeLists.txt of this folder names them, and puts
/// their texts into the program.
struct ReadyTest {
  std::string name;  ///< of the deck, without .toml
  std::string deck;  ///< its text
};

const std::vector<ReadyTest>& ready_tests();

}  // namespace repose
