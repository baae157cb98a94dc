// Micro-benchmarks of the stages of a time step, on the bed of bed.toml after it has settled. One process, one core.
// Arguments that are not Google Benchmark's are overrides of the deck, such as particles.0.count=1000.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <mpi.h>

#include "contact/fixed_point.h"
#include "deck/read_deck.h"
#include "domain/ghost_exchange.h"
#include "integration/velocity_verlet.h"
#include "neighbours/pair_lists.h"
#include "neighbours/skin_watch.h"
#include "shared_file.h"
#include "simulation.h"

namespace {

using namespace repose;

/// What the benchmarks work on: copies of a settled bed's state, so that each may change its own.
struct Bed {
  Communicator comm{MPI_COMM_WORLD};
  Deck deck;
  Simulation simulation;
  SkinRule outer, inner;

  explicit Bed(const std::vector<std::string>& overrides)
      : deck(read_deck(read_shared_file(comm, REPOSE_BED_DECK), "bed.toml", overrides)),
        simulation(comm, deck, {}, best_vector_level()) {
    for (std::int64_t k = 0; k < deck.phases.front().steps; ++k) simulation.step();
    simulation.check_guards();
    outer = {deck.neighbours.skin, 320.0 * simulation.time_step().step};
    inner = {deck.neighbours.inner_skin, 32.0 * simulation.time_step().step};
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
  for (std::size_t i = 0; i < particles.owned; ++i) reach.push_back(reach_of(particles.record[i], bed->outer));
  const Csr<PairMemory> memory = bed->simulation.pairs().memory(particles);
  for (auto _ : state) {
    PairLists pairs;
    pairs.build(particles, reach, memory);
    benchmark::DoNotOptimize(pairs.listed());
  }
  set_items(state, particles.owned);
}
BENCHMARK(list_build)->Unit(benchmark::kMicrosecond);

void distance_filter(benchmark::State& state) {
  PairLists pairs = bed->simulation.pairs();
  for (auto _ : state) pairs.select_near(bed->simulation.particles(), bed->inner);
  set_items(state, pairs.listed());
}
BENCHMARK(distance_filter)->Unit(benchmark::kMicrosecond);

void contact_kernel(benchmark::State& state, VectorLevel level) {
  if (best_vector_level() < level) return state.SkipWithError("this processor lacks the level");
  PairLists pairs = bed->simulation.pairs();
  Particles particles = bed->simulation.particles();
  const PairParameters& pair = bed->simulation.materials().pair(0, 0);
  for (auto _ : state) {
    for (PairGroup& group : pairs.groups()) {
      const PairLoopAlarms alarms = evaluate_pairs(level, group.blocks, group.fetch, pair, 0.0, 0.3,
                                                   particles.record.data(), particles.sum.data());
      benchmark::DoNotOptimize(alarms.any());
    }
  }
  set_items(state, pairs.lanes());
}
BENCHMARK_CAPTURE(contact_kernel, sse2, VectorLevel::sse2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(contact_kernel, avx2, VectorLevel::avx2)->Unit(benchmark::kMicrosecond);
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
  SkinWatch watch(bed->inner, bed->outer);
  watch.inner_selected(particles);
  for (auto _ : state) {
    const StepNotes notes =
        step_first_half(best_vector_level(), {}, 0.0, bed->deck.domain, watch.inner_marks(), particles);
    step_second_half(best_vector_level(), {}, 0.0, particles);
    benchmark::DoNotOptimize(notes.skin_used_up);
  }
  set_items(state, particles.owned);
}
BENCHMARK(integration)->Unit(benchmark::kMicrosecond);

/// The order-independent sum of one component: scaling, range check and conversion.
void accumulation(benchmark::State& state) {
  std::vector<double> values;
  for (const ParticleRecord& p : bed->simulation.particles().record) values.push_back(p.velocity.z);
  for (auto _ : state) {
    std::int64_t sum = 0;
    bool in_range = true;
    for (const double value : values) in_range &= add_fixed_point(to_fixed_point(value, 0x1p40), sum);
    benchmark::DoNotOptimize(sum);
    benchmark::DoNotOptimize(in_range);
  }
  set_items(state, values.size());
}
BENCHMARK(accumulation)->Unit(benchmark::kMicrosecond);

/// A quarter of the particles, scattered.
void ghost_packing(benchmark::State& state) {
  const Particles& particles = bed->simulation.particles();
  std::vector<std::size_t> sent;
  for (std::size_t i = 0; i < particles.owned; i += 4) sent.push_back(i);
  std::vector<Motion> buffer(sent.size());
  for (auto _ : state) {
    pack_motion(particles.record, sent, buffer);
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
