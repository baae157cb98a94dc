#pragma once

#include <cstdlib>
#include <string>

namespace repose::test {

/// As long as it lives at most so many ranks share memory (NodeMemory).
class NodeRanks {
 public:
  explicit NodeRanks(int most) : NodeRanks(std::to_string(most)) {}
  explicit NodeRanks(const std::string& setting) { setenv("REPOSE_NODE_RANKS", setting.c_str(), 1); }
  ~NodeRanks() { unsetenv("REPOSE_NODE_RANKS"); }
  NodeRanks(const NodeRanks&) = delete;
  NodeRanks& operator=(const NodeRanks&) = delete;
};

}  // namespace repose::test
