// What the cores of a machine allow ranks that must wait for one another at every step, whatever those ranks send: each
// rank simulates the whole deck for itself, in turns of some steps as fast as it can and with a reduction at every
// step. Prints the wall times in s of both kinds of turns as JSON, one for each rank: `mpirun -n 2 repose_lockstep DECK
// STEPS TURNS [KEY=VALUE...]`. All ranks do the same work at the same steps, so what the reduction costs is its latency
// and the waiting for whichever core is slower at the time.

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include <mpi.h>
#include <nlohmann/json.hpp>

#include "deck/read_deck.h"
#include "files/shared_file.h"
#include "simulation/simulation.h"
#include "tool.h"

namespace {

using namespace repose;

/// Wall time in s of so many steps of this rank.
double time_of(Simulation& simulation, int steps, const Communicator* in_step_with) {
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    if (in_step_with != nullptr) in_step_with->max(k);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void run(const std::vector<std::string>& words) {
  const Communicator everyone(MPI_COMM_WORLD);
  const Communicator alone = Communicator::self();
  const std::string& path = words[0];
  const int steps = std::stoi(words[1]);
  const int turns = std::stoi(words[2]);
  const Deck deck = read_deck(read_whole_file(path), path, {words.begin() + 3, words.end()});
  Simulation simulation(alone, deck, reader_beside(alone, path), best_vector_level());
  double free = 0.0;
  double in_step = 0.0;
  for (int turn = 0; turn < turns; ++turn) {
    everyone.barrier();
    free += time_of(simulation, steps, nullptr);
    everyone.barrier();
    in_step += time_of(simulation, steps, &everyone);
  }
  const nlohmann::json result = {{"free_s", everyone.all_gather(free)}, {"in_step_s", everyone.all_gather(in_step)}};
  if (everyone.is_root()) std::puts(result.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool(argc, argv, 3, "repose_lockstep DECK STEPS TURNS [KEY=VALUE...]", run);
}
