// Gives one target, without a fuzzer, every file of two folders: replay_TARGET SEEDS REGRESSIONS. The seeds must be
// accepted; what is a regression need only be no finding.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "target.h"

namespace {

/// How many files of the folder there are, and how many of them the target accepts.
struct Count {
  int files = 0;
  int accepted = 0;
};

Count replay(const std::filesystem::path& folder) {
  Count count;
  if (!std::filesystem::exists(folder)) return count;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::cout << entry.path().string() << ": " << std::flush;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string input{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const bool is_accepted = repose::fuzz::accepts(input);
    std::cout << (is_accepted ? "accepted" : "refused") << std::endl;
    ++count.files;
    count.accepted += is_accepted ? 1 : 0;
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const Count seeds = replay(argv[1]);
  replay(argv[2]);
  return seeds.files > 0 && seeds.accepted == seeds.files ? 0 : 1;
}
