"""Damaged checkpoints: the restart says so, takes the older one and comes to the same results; two damaged ones end it.

Usage: damaged_checkpoint_test.py EXECUTABLE MPIEXEC SOURCE_DIR FAILING_DISK_LIBRARY TRIALS [SEED]
"""

import os
import random
import shutil
import sys
import tempfile

from faulty_runs import Program, messages
from interrupted import BRIEF, leave_checkpoints, restart
from results import check_same_results, checkpoints_of


def flip_bit(content, draw):
    bit = draw.randrange(8 * len(content))
    content[bit // 8] ^= 1 << bit % 8
    return f"bit {bit} flipped"


def truncate(content, draw):
    del content[draw.randrange(len(content)):]
    return f"truncated to {len(content)} bytes"


def append(content, _):
    content += b"\0"
    return "a byte too many"


def blank(content, draw):
    size = draw.randint(1, 8192)
    at = draw.randrange(len(content))
    block = content[at:at + size]
    content[at:at + size] = bytes(b ^ 0xFF for b in block)
    return f"{len(block)} bytes from {at} on inverted"


def damage(path, how, draw):
    with open(path, "rb") as file:
        content = bytearray(file.read())
    what = how(content, draw)
    with open(path, "wb") as file:
        file.write(content)
    return what


class Damaged:
    def __init__(self, program, library, deck, folder, begun, reference, draw):
        self.library = library
        self.program, self.deck, self.folder, self.begun, self.reference = program, deck, folder, begun, reference
        self.draw = draw

    def copy(self):
        output = os.path.join(self.folder, "copy")
        shutil.rmtree(output, ignore_errors=True)
        shutil.copytree(self.begun, output)
        return output, *checkpoints_of(output)

    def newest_is_skipped(self, how, ranks):
        output, newest, older = self.copy()
        what = damage(os.path.join(output, newest), how, self.draw)
        out, err = restart(self.program, self.deck, output, *BRIEF, ranks=ranks)
        assert f"repose: warning: {os.path.join(output, newest)}: " in err, f"{what}: {err}"
        assert f"goes on from {os.path.join(output, older)}" in out, f"{what}: {out}"
        check_same_results(output, self.reference)
        print(f"{newest}, {what}: {err.strip().splitlines()[0]}", flush=True)

    def skipped_one_does_not_count(self):
        """Checkpoints at other steps than before: the damaged one goes when the first of them is there, not the good ones."""
        output, newest, older = self.copy()
        damage(os.path.join(output, newest), flip_bit, self.draw)
        leave_checkpoints(self.program, self.library, self.deck, output, *BRIEF, "output.checkpoint_steps=45",
                          options=("--restart",))
        expected = ["checkpoint_0000000270.hdf", "checkpoint_0000000225.hdf"]
        assert checkpoints_of(output) == expected, checkpoints_of(output)

    def all_are_refused(self):
        output, newest, older = self.copy()
        for name in (newest, older):
            damage(os.path.join(output, name), flip_bit, self.draw)
        _, err = restart(self.program, self.deck, output, *BRIEF, ranks=2, code=4)
        assert len(messages(err)) == 1 and output in messages(err)[0], err
        assert err.count("repose: warning: ") == 2, err
        assert checkpoints_of(output) == [newest, older], "the evidence is gone"


def main():
    program, library, trials = Program(*sys.argv[1:4]), sys.argv[4], int(sys.argv[5])
    seed = int(sys.argv[6]) if len(sys.argv) > 6 else random.randrange(10**6)
    print("seed", seed, flush=True)
    deck = program.deck("discharge_quick.toml")
    with tempfile.TemporaryDirectory() as folder:
        reference, begun = os.path.join(folder, "reference"), os.path.join(folder, "begun")
        program.run(deck, reference, *BRIEF)
        leave_checkpoints(program, library, deck, begun, *BRIEF)
        assert checkpoints_of(begun) == ["checkpoint_0000000300.hdf", "checkpoint_0000000200.hdf"], checkpoints_of(begun)
        damaged = Damaged(program, library, deck, folder, begun, reference, random.Random(seed))
        for trial in range(trials):
            damaged.newest_is_skipped((flip_bit, truncate, flip_bit, blank, append)[trial % 5], 2 if trial % 6 == 0 else 0)
        damaged.skipped_one_does_not_count()
        damaged.all_are_refused()


main()
