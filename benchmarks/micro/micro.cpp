// Micro-benchmarks of the stages of a time step, on the bed of bed.toml after it has settled. One process, one core.
// Arguments that are not Google Benchmark's are overrides of the deck, such as particles.0.count=1000.

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <mpi.h>

#include "contact/lanes.h"
#include "deck/read_deck.h"
#include "domain/ghost_exchange.h"
#include "files/shared_file.h"
#include "integration/velocity_verlet.h"
#include "neighbours/pair_lists.h"
#include "simulation/simulation.h"

namespace {

using namespace repose;

/// What the benchmarks work on: copies of a settled bed's state, so that each may change its own.
struct Bed {
  Communicator comm{MPI_COMM_WORLD};
  Deck deck;
  Simulation simulation;

  explicit Bed(const std::vector<std::string>& overrides)
      : deck(read_deck(read_shared_file(comm, REPOSE_BED_DECK), "bed.toml", overrides)),
        simulation(comm, deck, {}, best_vector_level()) {
    simulation.advance(deck.phases.front().steps);
    simulation.check_guards();
  }
};

std::unique_ptr<Bed> bed;

/// A list benchmark's items are particles, a contact benchmark's are listed pairs.
void set_items(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(static_cast<std::int64_t>(items) * state.iterations());
}

void list_build(benchmark::State& state) {
  const Particles& particles = bed->simulation.particles();
  std::vector<double> reach;
  for (std::size_t i = 0; i < particles.owned; ++i)
    reach.push_back(reach_of(particles.record[i], bed->simulation.skins().outer()));
  const Csr<PairMemory> memory = bed->simulation.pairs().memory(particles);
  for (auto _ : state) {
    PairLists pairs;
    const auto records = std::span(particles.record).first(particles.total());
    pairs.build(particles, near_pairs(records, reach, particles.owned), memory);
    benchmark::DoNotOptimize(pairs.listed());
  }
  set_items(state, particles.owned);
}
BENCHMARK(list_build)->Unit(benchmark::kMicrosecond);

void distance_filter(benchmark::State& state) {
  PairLists pairs = bed->simulation.pairs();
  for (auto _ : state) pairs.select_near(bed->simulation.skins().inner_spheres());
  set_items(state, pairs.listed());
}
BENCHMARK(distance_filter)->Unit(benchmark::kMicrosecond);

void contact_kernel(benchmark::State& state, VectorLevel level) {
  if (!is_available(level)) return state.SkipWithError("this processor lacks the level");
  PairLists pairs = bed->simulation.pairs();
  Particles particles = bed->simulation.particles();
  const PairParameters& pair = bed->simulation.materials().pair(0, 0);
  for (auto _ : state) {
    for (PairGroup& group : pairs.groups()) {
      const ContactAlarms alarms =
          evaluate_pairs(level, group.blocks, pair, 0.0, 0.3, particles.record.data(), particles.sum.data());
      benchmark::DoNotOptimize(alarms.any());
    }
  }
  set_items(state, pairs.lanes());
}
BENCHMARK_CAPTURE(contact_kernel, sse2, VectorLevel::sse2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(contact_kernel, avx2, VectorLevel::avx2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(contact_kernel, avx512x4, VectorLevel::avx512x4)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(contact_kernel, avx512, VectorLevel::avx512)->Unit(benchmark::kMicrosecond);

void wall_kernel(benchmark::State& state) {
  WallContacts contacts = bed->simulation.wall_contacts();
  Particles particles = bed->simulation.particles();
  for (auto _ : state) {
    const WallAlarms alarms = contacts.evaluate(best_vector_level(), bed->simulation.walls(),
                                                bed->simulation.materials(), 0.0, 0.3, particles);
    benchmark::DoNotOptimize(alarms.any());
  }
  set_items(state, particles.owned);
}
BENCHMARK(wall_kernel)->Unit(benchmark::kMicrosecond);

void integration(benchmark::State& state) {
  Particles particles = bed->simulation.particles();
  const SkinWatch& watch = bed->simulation.skins();
  std::vector<std::int32_t> moved(particles.owned);
  for (auto _ : state) {
    const StepNotes notes =
        step_first_half(best_vector_level(), {}, 0.0, bed->deck.domain, watch.inner_marks(), moved, particles);
    step_second_half(best_vector_level(), {}, 0.0, particles);
    benchmark::DoNotOptimize(notes.moved);
  }
  set_items(state, particles.owned);
}
BENCHMARK(integration)->Unit(benchmark::kMicrosecond);

/// Forces and torques, already scaled, into the fixed-point sums of the particles in their order.
void accumulation(benchmark::State& state) {
  Particles particles = bed->simulation.particles();
  std::vector<std::int32_t> index(particles.owned / 4 * 4);
  std::iota(index.begin(), index.end(), 0);
  const QuadVec3 value =
      to_fixed_point({broadcast<Quad>(1.0), broadcast<Quad>(2.0), broadcast<Quad>(3.0)}, broadcast<Quad>(0x1p20));
  for (auto _ : state) {
    QuadBits difference = {};
    at_level(best_vector_level(), [&]() REPOSE_INLINE {
      for (std::size_t k = 0; k < index.size(); k += 4) {
        scatter(value, value, &index[k], particles.sum.data(), difference);
      }
    });
    benchmark::DoNotOptimize(difference);
    benchmark::DoNotOptimize(particles.sum.data());
  }
  set_items(state, index.size());
}
BENCHMARK(accumulation)->Unit(benchmark::kMicrosecond);

/// A quarter of the particles, scattered.
void ghost_packing(benchmark::State& state) {
  const Particles& particles = bed->simulation.particles();
  std::vector<std::size_t> sent;
  for (std::size_t i = 0; i < particles.owned; i += 4) sent.push_back(i);
  std::vector<Motion> buffer(sent.size());
  for (auto _ : state) {
    pack_motion(particles.record, sent, {}, buffer);
    benchmark::DoNotOptimize(buffer.data());
    benchmark::ClobberMemory();
  }
  set_items(state, sent.size());
}
BENCHMARK(ghost_packing)->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  bed = std::make_unique<Bed>(std::vector<std::string>(argv + 1, argv + argc));
  benchmark::RunSpecifiedBenchmarks();
  bed.reset();
  MPI_Finalize();
}
