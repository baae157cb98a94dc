"""Efficiency on a cluster, from what was measured and from figures of a network. What is assumed stands in ASSUMPTIONS
and in docs/performance.md."""

import json
import math

import numpy as np

# HDR InfiniBand, one adapter (ConnectX-6) per node: 200 Gb/s and less than 0.6 us by its manual,
# https://docs.nvidia.com/networking/display/ConnectX6EN/Introduction. To that come switches and MPI: 1.5 us is assumed.
ASSUMPTIONS = {
    "latency_s": 1.5e-6,           # of a message, from one rank to another on any node
    "overhead_s": 0.5e-6,          # of processor time per message sent or received
    "node_bandwidth_B_s": 25e9,    # shared by its ranks
    "ranks_per_node": 64,          # a branch of the tree of the bisection: one block of space
    "copy_B_s": 5e9,               # of a rank, from and to what the adapter reads and writes
    "ghost_s": 12e-9,              # packing and reading one, all of the stage of the ghosts on two ranks of a node (measured)
    # Of a part in the corner of a node's block of 4 x 4 x 4: the others are read in place.
    "neighbours_elsewhere": 19 / 26,
    "ghosts_elsewhere": 1 / 2,
    "exchanges_per_rebuild": 3,    # with all others: how much, then the messages
    "histogram_rounds": 4,         # of the bisection, for each level of the tree
    "histogram_B": 1024,
}
SCENES = (  # name, grains of a run on so many ranks
    ("156 000 grains", lambda ranks: 156000),
    ("1 000 000 grains", lambda ranks: 1000000),
    ("100 000 000 grains", lambda ranks: 100000000),
    ("50 000 grains per rank", lambda ranks: 50000 * ranks),
)
MOTION = 72  # bytes of a ghost in each step
RANKS = (100, 300, 1000, 3000, 10000)


def read(results, name):
    files = sorted(results.glob(f"{name}.json"))
    if not files:
        raise SystemExit(f"there is no {name}.json in {results}: measure first")
    return json.loads(files[-1].read_text())


class Measured:
    """What the figures of a run and of divided snapshots say of a part with n grains."""

    def __init__(self, results):
        discharge = read(results, "discharge_*")["runs"]
        one = discharge["1"][0]
        grain_steps = one["particles"]["inside"] * one["steps"]
        self.grain_s = one["timing"]["loop_cpu_s"] / grain_steps  # of a grain and a step, with its contacts and lists
        stages = one["timing"]["stages"]
        share = stages["pair_contacts"]["mean_s"] / sum(stage["mean_s"] for stage in stages.values())
        self.pair_s = self.grain_s * share / (one["parallel"]["pairs_per_step"]["mean"] / one["particles"]["inside"])
        rows = [row for row in read(results, "partition")["rows"] if row["planes"] == "new"]
        self.pairs = np.mean([row["pairs_per_particle"] for row in rows])
        parts = sorted({row["parts"] for row in rows}, reverse=True)
        by_parts = [[row for row in rows if row["parts"] == count] for count in parts]
        self.log_n = [math.log(np.mean([r["particles"] for r in of]) / of[0]["parts"]) for of in by_parts]
        self.tables = {key: [np.mean([pick(r) for r in of]) for of in by_parts] for key, pick in {
            "imbalance": lambda r: r["cost_imbalance"],
            "twice": lambda r: r["pairs_evaluated_over_pairs"] - 1.0,
            "ghosts": lambda r: r["ghosts_per_particle"],
            "neighbours": lambda r: r["neighbours"]["max"],
            "busiest": lambda r: r["bytes_per_step"]["max"] / r["bytes_per_step"]["mean"]}.items()}
        run = read(results, "balance_*")
        division = {kind: np.mean([r["cost_imbalance"] for r in run["rows"] if r["planes"] == kind]) for kind in ("new", "bound")}
        self.drift = division["bound"] / division["new"]
        several = run["runs"].get("balanced", run["runs"]["one_rank"])
        self.bisections = several["parallel"]["bisections"] / several["lists"]["rebuilds"]  # new planes per rebuild
        several = discharge["8"][0]
        self.collectives = several["parallel"]["collectives_per_step"]
        self.rebuilds = several["lists"]["rebuilds"] / several["steps"]

    def of_part(self, key, n):
        """What belongs to the surface of a part goes with it, from the smallest parts, which mostly have others on all
        sides: of few large ones most sides are free. The number of neighbours is the most of any division. The rest
        is interpolated."""
        if key in ("twice", "ghosts"):
            return float(self.tables[key][0] * math.exp((self.log_n[0] - math.log(n)) / 3.0))
        if key == "neighbours":
            return float(max(self.tables[key]))
        return float(np.interp(math.log(n), self.log_n, self.tables[key]))

    def busiest_ghosts(self, n):
        return n * self.of_part("ghosts", n) * self.of_part("busiest", n)

    def holds(self, n):
        return math.log(n) > self.log_n[0] - 0.05


def collective_s(ranks, size):
    """Of log2(ranks) rounds, each with a message of `size` bytes from every rank; long ones scatter and gather by halves
    (Rabenseifner), so that each byte travels twice."""
    bandwidth = ASSUMPTIONS["node_bandwidth_B_s"] / ASSUMPTIONS["ranks_per_node"]
    rounds = math.ceil(math.log2(ranks))
    message = ASSUMPTIONS["latency_s"] + ASSUMPTIONS["overhead_s"]
    return min(rounds * (message + size / bandwidth), 2 * rounds * message + 2 * size / bandwidth)


def step_s(measured, ranks, n):
    """Seconds of a step on `ranks` ranks of n grains each: work, ghosts, reductions, rebuilds."""
    a = ASSUMPTIONS
    twice = measured.of_part("twice", n)
    work = measured.of_part("imbalance", n) * measured.drift * n * (
        measured.grain_s + measured.pairs * measured.pair_s * twice)
    ghosts = measured.busiest_ghosts(n)
    of_node = measured.busiest_ghosts(n * a["ranks_per_node"])
    messages = measured.of_part("neighbours", n) * a["neighbours_elsewhere"]
    exchange = (2 * messages * a["overhead_s"] + a["latency_s"] + a["ghosts_elsewhere"] * ghosts * MOTION / a["copy_B_s"]
                + of_node * MOTION / a["node_bandwidth_B_s"], ghosts * a["ghost_s"])
    reductions = measured.collectives * collective_s(ranks, 8)
    all_to_all = collective_s(ranks, 4 * ranks)  # half of 8 bytes for each rank in each round
    levels = range(math.ceil(math.log2(ranks)))
    bisection = sum(a["histogram_rounds"] * collective_s(ranks, 2**level * a["histogram_B"]) for level in levels)
    rebuilds = measured.rebuilds * (a["exchanges_per_rebuild"] * all_to_all + measured.bisections * bisection)
    return work, exchange, reductions, rebuilds


def predict(measured):
    """Rows of the table; a part smaller than the smallest that was divided gets none."""
    rows = []
    for name, grains in SCENES:
        for ranks in RANKS:
            n = grains(ranks) / ranks
            if not measured.holds(n) or (n > 1e5):
                continue
            work, (network, packing), reductions, rebuilds = step_s(measured, ranks, n)
            ideal = n * measured.grain_s
            # Ghosts travel while interior contacts are evaluated, a third of the work at the least, if MPI lets them.
            hidden = work + packing + max(0.0, network - work / 3.0) + reductions + rebuilds
            rows.append({"scene": name, "ranks": ranks, "grains per rank": round(n), "step us": 1e6 * hidden,
                         "work us": 1e6 * work, "ghosts us": 1e6 * (network + packing), "reductions us": 1e6 * reductions,
                         "rebuilds us": 1e6 * rebuilds, "efficiency": ideal / hidden,
                         "if nothing is hidden": ideal / (work + packing + network + reductions + rebuilds)})
    return rows
