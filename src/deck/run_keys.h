#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deck/key.h"

/// The run as a whole, what it writes, its guards and its lists.
namespace repose {

struct RunDeck {
  std::string title;
  std::uint64_t seed = 1;
  std::int64_t check_every = 100;  ///< steps between looks at what a phase waits for and at the discharge
};

template <class V>
void describe(V& v, RunDeck& r) {
  v("title", r.title, Unit::none, any_value, optional, "free text, copied to the results");
  v("seed", r.seed, Unit::none, at_least(0), optional, "seed of every random number");
  v("check_every", r.check_every, Unit::none, from_to(1, 1e6), optional,
    "steps between looks at what a phase waits for, other than time and steps, and between samples of the discharge");
}

struct OutputDeck {
  double snapshot_interval = 0.0;  ///< 0: only the snapshots at snapshot_times and at the end
  std::vector<double> snapshot_times;
  double series_interval = 0.01;
  double progress_seconds = 5.0;      ///< wall seconds between progress lines
  double checkpoint_minutes = 10.0;   ///< wall minutes between checkpoints; 0: not by time
  std::int64_t checkpoint_steps = 0;  ///< steps between checkpoints; 0: not by steps
  bool contacts = false;
  bool walls = false;
  bool trace = false;
  std::int64_t trace_every = 10;
};

template <class V>
void describe(V& v, OutputDeck& o) {
  v("snapshot_interval", o.snapshot_interval, Unit::second, at_least(0), optional,
    "time between snapshots; 0: only snapshot_times and the end");
  v("snapshot_times", o.snapshot_times, Unit::second, at_least(0), optional, "further snapshots");
  v("series_interval", o.series_interval, Unit::second, above(0), optional, "time between rows of the time series");
  v("progress_seconds", o.progress_seconds, Unit::second, above(0), optional, "wall-clock time between progress lines");
  v("checkpoint_minutes", o.checkpoint_minutes, Unit::none, at_least(0), optional,
    "wall-clock minutes between checkpoints; 0: not by time");
  v("checkpoint_steps", o.checkpoint_steps, Unit::none, at_least(0), optional,
    "steps between checkpoints; 0: not by steps");
  v("contacts", o.contacts, Unit::none, any_value, optional,
    "write all contacts with their forces beside each snapshot (contacts_<step>.vtp)");
  v("walls", o.walls, Unit::none, any_value, optional,
    "write the walls where they are beside each snapshot (walls_<step>.vtp)");
  v("trace", o.trace, Unit::none, any_value, optional, "write every particle to a CSV file; for small cases");
  v("trace_every", o.trace_every, Unit::none, at_least(1), optional, "steps between rows of the trace");
}

struct GuardsDeck {
  double max_overlap = 0.3;  ///< of the smaller radius
};

template <class V>
void describe(V& v, GuardsDeck& g) {
  v("max_overlap", g.max_overlap, Unit::none, above_to(0, 0.5), optional,
    "largest overlap as a share of the smaller radius");
}

struct NeighboursDeck {
  double skin = 0.3;           ///< outer skin at rest, in particle radii (each particle's share)
  double inner_skin = 0.003;   ///< inner skin at rest, in particle radii
  double max_imbalance = 1.1;  ///< cost of the busiest rank over the mean that triggers rebalancing
};

template <class V>
void describe(V& v, NeighboursDeck& n) {
  v("skin", n.skin, Unit::none, above_to(0, 10), optional,
    "outer skin at rest in particle radii, each particle's share");
  v("inner_skin", n.inner_skin, Unit::none, above_to(0, 10), optional,
    "inner skin at rest in particle radii, at most skin");
  v("max_imbalance", n.max_imbalance, Unit::none, above(1), optional,
    "cost of the busiest rank over the mean that triggers rebalancing");
}

}  // namespace repose
