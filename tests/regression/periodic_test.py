"""The endless chute, in a reduced size: the same state on one rank and on four, nothing lost, and a layer that flows.

Usage: periodic_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import sys
import tempfile

from repose_runs import Program, read_series

REDUCED = ["particles.0.count=500", "phase.0.time=0.12"]


def main():
    program = Program(*sys.argv[1:4])
    deck = program.deck("periodic_chute.toml")
    with tempfile.TemporaryDirectory() as folder:
        alone, thick = program.run_all([
            (deck, f"{folder}/1", *REDUCED),
            (deck, f"{folder}/thick", *REDUCED, "neighbours.skin=1.0", "neighbours.inner_skin=0.1")])
        together = program.run(deck, f"{folder}/4", *REDUCED, ranks=4)
        rows = read_series(f"{folder}/1")
        assert rows == read_series(f"{folder}/4")
    assert alone["state_hash"] == together["state_hash"] == thick["state_hash"], (alone, together, thick)
    assert alone["particles"]["inside"] == alone["particles"]["inserted"] == 500, alone["particles"]
    # Without friction a bead would have g sin 26 deg t = 0.52 m/s.
    mass = 500 * 2500.0 * 3.141592653589793 / 6.0 * 1e-9
    speed = (2.0 * rows[-1]["translational_energy_J"] / mass) ** 0.5
    print("speed", speed, "m/s, contacts", rows[-1]["pair_contacts"])
    assert 0.1 < speed < 0.52, speed
    assert rows[-1]["pair_contacts"] > 50, rows[-1]


main()
