"""Every command of the documents that begins with repose, with mpirun and repose, or with a Python tool is run as it stands there,
on reduced decks; forms such as `repose run DECK --output DIR [--quiet]` are compared with the help, and so are benchmarks,
which take too long, there and in the documents beside them. So a new command in a
document is run without a change here. What cannot be run is in NOT_RUN with its reason; what takes too long gets a
reduction. Entries that nothing in the documents needs any more are errors, too.

Usage: documents_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import glob
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

from repose_runs import PATIENCE

SHORT = ("phase.settle.max_time=2 ms", "phase.settle.min_time=1 ms", "phase.discharge.max_time=2 ms", "phase.discharge.min_time=2 ms")
LIFTED = ("phase.settle.min_time=0", "phase.settle.max_time=2 ms", "phase.lift.time=2 ms", "phase.rest.min_time=0", "phase.rest.max_time=2 ms")
# Overrides for commands that read a file of this name.
REDUCED = {
    "carbohsp_mono.toml": ("particles.0.mass=0.05 g", *SHORT),
    "discharge_quick.toml": ("particles.0.mass=0.05 g", *SHORT),
    "draw_down.toml": ("phase.settle.min_time=0", "phase.settle.max_time=2 ms", "phase.draw_down.min_time=0",
                       "phase.draw_down.max_time=2 ms"),
    "granuheap.toml": LIFTED,
    "heated_drum.toml": ("phase.fill.time=2 ms", "phase.turn.time=4 ms", "measurement.surface_angle.from=0.001"),
    "ledge.toml": ("phase.settle.time=2 ms", "phase.collapse.time=2 ms"),
    "lifted_cylinder.toml": LIFTED,
    "lifted_cylinder_disc.toml": LIFTED,
    "moving_bed_exchanger.toml": ("phase.settle.time=2 ms", "phase.sink.time=2 ms"),
    "periodic_chute.toml": ("phase.flow.time=5 ms",),
    "powder_rheometer.toml": ("particles.0.count=500", "phase.settle.min_time=0", "phase.settle.max_time=2 ms", "phase.stir.time=2 ms"),
    "tilting_box.toml": ("phase.settle.min_time=0", "phase.settle.max_time=2 ms", "phase.tilt.max_time=2 ms", "phase.rest.time=2 ms"),
    "validation.toml": ("particles.0.mass=0.02 g", *SHORT),
    "uniaxial_compression.toml": ("particles.0.count=378", "wall.lid.centre=[0, 0, 0.012]", "measurement.compression.height=12 mm"),
    "direct_shear.toml": ("particles.0.count=1500", "phase.fill.min_time=0", "phase.fill.max_time=2 ms", "phase.press.min_time=0",
                          "phase.press.max_time=2 ms", "phase.shear.time=4 ms", "measurement.shear.from=2 ms"),
    "ring_shear.toml": ("particles.0.count=1500", "phase.fill.min_time=0", "phase.fill.max_time=2 ms", "phase.press.time=2 ms",
                        "phase.preshear.time=2 ms", "phase.relax.time=1 ms", "phase.shear.time=4 ms", "measurement.shear.from=2 ms"),
}
# Changes in the copies of studies.
FEW_GRAINS = ", ".join(f'"{s}"' for s in (
    "particles.0.mass=0.1 g", "phase.settle.max_time=20 ms", "phase.settle.min_time=1 ms",
    "phase.discharge.max_time=80 ms", "phase.discharge.min_time=80 ms", "measurement.discharge.plugged_share=0.02"))
CHANGED = {
    "calibrate_quick.toml": [("seeds = 2", f"seeds = 1\nset = [{FEW_GRAINS}]")],
    "calibrate_levels_quick.toml": [('"output.snapshot_interval=0"', FEW_GRAINS), ("seeds = 2", "seeds = 1"),
                                    ("budget_core_hours = 0.2 ", "budget = 20 "),
                                    ("angle_of_repose_deg", "discharge_time_s")],  # so few grains make no pile
    "calibrate_tests_quick.toml": [("[0.1, 0.3, 0.5, 0.7]", "[0.1, 0.7]"), ("[0.02, 0.12, 0.22, 0.32]", "[0.02, 0.32]"),
                                   ("particles.0.mass=0.2 g", "particles.0.mass=0.05 g"), ("seeds = 3", "seeds = 1"),
                                   ("min_time=150 ms", "min_time=110 ms"), ("max_time=150 ms", "max_time=110 ms"),
                                   ("count=900", "count=200"), ("phase.turn.time=1.2", "phase.turn.time=0.7")],
    "calibrate_prior_quick.toml": [('"output.snapshot_interval=0"', FEW_GRAINS), ("start = 24", "start = 8"),
                                   ("budget = 28", "budget = 10"), ("angle_of_repose_deg", "discharge_time_s")],
    "calibrate_photo.toml": [("discharge_mini", "discharge_quick"), ("seeds = 2", "seeds = 1"),
                             ("[0.2, 0.325, 0.45, 0.575]", "[0.5, 0.6, 0.65, 0.7]"),
                             ('"output.snapshot_times=[]"', '"particles.0.mass=0.3 g"')],
}
# Words of the documents and what they stand for here, where the rest of the command can be run.
STANDS_FOR = {"DECK": "input/discharge_quick.toml", "DIR": "results/a_run", "results/quick/run_0000089762.hdf": "results/quick/run_*.hdf",
              "results/validation/carbohsp_mono/run_0001113900.hdf": "results/validation/carbohsp_mono/run_*.hdf",
              "results/validation/sand_multi/run_0003010800.hdf": "results/validation/sand_multi/run_*.hdf"}
# Beginnings of commands, and why they are not run.
NOT_RUN = {}
FORM = re.compile(r"(?<!=)\[|\.\.\.|\b(SCRIPT|TUTORIALS|DECK|FILE|FILES|DIR|TEST|TOOL|SNAPSHOT|RESULT)\b|\bA\.csv\b|<")
BEGINS = re.compile(r"(\w+=\S+ )*((mpirun|mpiexec)( -\S+ \S+)* )?((build/release/src/)?repose(?!:) \S|(tools|benchmarks/\w+)/\w+\.py( |$))")
LONGEST = 120 * PATIENCE  # s for one command


class Place:
    """Where in a document something stands."""

    def __init__(self, document, line, section):
        self.document, self.line, self.section = document, line, section

    def __str__(self):
        return f"{self.document}:{self.line}"


def blocks_of(path, name):
    """(place, language, lines) of every code block, and (place, None, [text]) of every code span in a line of prose; the
    language of an indented block is ''."""
    language, lines, place, section = None, [], None, ""
    with open(path) as file:
        for number, line in enumerate([*file.read().splitlines(), ""], 1):
            fence = line.startswith("```")
            if fence and language is not None and language != "":
                yield place, language, lines
                language, lines = None, []
            elif fence:
                language, lines, place = line[3:] or "text", [], Place(name, number, section)
            elif language not in (None, ""):
                lines.append(line)
            elif line.startswith("    ") and not line.startswith("     -"):
                if language is None:
                    language, lines, place = "", [], Place(name, number, section)
                lines.append(line[4:])
            else:
                if language == "":
                    yield place, "", lines
                    language, lines = None, []
                section = line if line.startswith("## ") else section
                for span in re.findall(r"`([^`]+)`", line):
                    yield Place(name, number, section), None, [span]


def commands_of(lines):
    """The commands of a block: continuation lines joined, comments cut off."""
    text = re.sub(r"\\\n\s*", "", "\n".join(lines))
    return [re.sub(r"\s+#( .*)?$", "", line) for line in text.splitlines() if BEGINS.match(line)]


def check_options(command, words, said):
    """The options among the words of a command are those of its help."""
    for option in re.findall(r"(?<![\w-])--[\w-]+", words):
        assert re.search(rf"^  (-\w,)?{option}\b", said, re.M), f"{command}: there is no {option}"


class Workshop:
    """A folder in which the commands find what the documents speak of."""

    def __init__(self, executable, mpiexec, source, folder):
        self.folder, self.source = folder, source
        self.used, self.helps, self.ran = set(), {}, 0
        programs = os.path.join(folder, "build", "release", "src")
        os.makedirs(programs)
        os.symlink(os.path.abspath(executable), os.path.join(programs, "repose"))
        for name in ("tools", "benchmarks"):
            os.symlink(os.path.join(source, name), os.path.join(folder, name))
        shutil.copytree(os.path.join(source, "input"), os.path.join(folder, "input"))
        for name, changes in CHANGED.items():
            path = os.path.join(folder, "input", name)
            with open(path) as file:
                text = file.read()
            for old, new in changes:
                assert text.count(old) == 1, f"{name}: {old}"
                text = text.replace(old, new)
            with open(path, "w") as file:
                file.write(text)
        self.env = {**os.environ, "PATH": f"{programs}:{os.path.dirname(mpiexec)}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1",
                    "PYTHONPATH": os.path.join(source, "tools", "python"), "REPOSE": os.path.join(programs, "repose"),
                    "REPOSE_PYTHON": sys.executable}

    def say(self, words, env=(), timeout=LONGEST):
        done = subprocess.run(words, cwd=self.folder, env={**self.env, **dict(env)}, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=timeout)
        assert done.returncode == 0, f"{shlex.join(words)}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr}"
        return done.stdout

    def help_of(self, names):
        if names not in self.helps:
            self.helps[names] = self.say(["repose", *names, "--help"])
        return self.helps[names]

    def check_form(self, command):
        """The names of the command and of its options are those of the help."""
        words = command.split("repose ", 1)[1].split()
        names = []
        while words and re.fullmatch(r"[a-z]+", words[0]):
            names.append(words.pop(0))
        check_options(command, " ".join(words), self.help_of(tuple(names)))

    def check_benchmark(self, command):
        """The script, its study and its options are those of its help."""
        words = shlex.split(command)
        first_option = next((k for k, word in enumerate(words) if word.startswith("-")), len(words))
        check_options(command, command, self.say([*words[:first_option], "--help"]))
        self.ran += 1

    def run(self, command):
        """Runs it, reduced, on two ranks at most, and returns what it says."""
        words = shlex.split(command)
        env = []
        while "=" in words[0]:
            env.append(words.pop(0).split("=", 1))
        for k, word in enumerate(words):
            if word in STANDS_FOR:
                self.used.add(word)
                found = sorted(glob.glob(os.path.join(self.folder, STANDS_FOR[word])))
                words[k] = os.path.relpath(found[-1], self.folder) if "*" in STANDS_FOR[word] and found else STANDS_FOR[word]
        if words[0] == "mpirun" and "-n" in words:
            words[words.index("-n") + 1] = str(min(int(words[words.index("-n") + 1]), 3))
        elif words[0] == "mpirun":
            words[1:1] = ["-n", "2"]
        for name in {os.path.basename(word) for word in words}:
            self.used.add(name)
            if not {"calibrate", "sensitivity", "thermal"} & set(words):
                words += [part for override in REDUCED.get(name, ()) for part in ("--set", override)]
        self.ran += 1
        return self.say(words, env)


def check_first_deck(workshop, path):
    """The first deck of the user guide gives the lines that stand below its commands."""
    said, expected = "", []
    for place, language, lines in blocks_of(path, "user-guide.md"):
        if place.section != "## A first deck":
            continue
        if language == "toml":  # the deck, by the name that it is to be saved as
            with open(os.path.join(workshop.folder, "heap.toml"), "w") as file:
                file.write("\n".join(lines))
            continue
        commands = commands_of(lines)
        for command in commands:
            if not FORM.search(command):
                said += workshop.run(command)
        if language == "" and not commands:
            expected += lines
    assert len(expected) > 8, expected
    lines = said.splitlines()
    for line in expected:
        assert line in lines, f"user-guide.md: \"{line}\" is not what is printed:\n{said}"


def is_run_elsewhere(place):
    return place.document == "docs/user-guide.md" and place.section == "## A first deck"


def is_form(command, language):
    """Whether a command has words that stand for others. What only names a command in prose is one, too."""
    if language is None:
        return FORM.search(command) or re.fullmatch(r"repose [a-z ]+|tools/\S+", command)
    return FORM.search(re.sub("|".join(map(re.escape, STANDS_FOR)), "", command))


def check_command(workshop, command, language):
    reason = [begin for begin in NOT_RUN if command.startswith(begin)]
    workshop.used.update(reason)
    if reason:
        return
    if command.startswith("benchmarks/"):
        workshop.check_benchmark(command)
    elif not is_form(command, language):
        workshop.run(command)
    elif "repose " in command:
        workshop.check_form(command)
    else:
        tool = command.split()[0]
        assert os.access(os.path.join(workshop.source, tool), os.X_OK), f"there is no {tool} that can be run"


def check_commands(workshop, name, path):
    for place, language, lines in blocks_of(path, name):
        if is_run_elsewhere(place) or language not in (None, "", "sh", "bash", "console", "text"):
            continue
        for command in commands_of(lines):
            begin = time.monotonic()
            try:
                check_command(workshop, command, language)
            except (AssertionError, subprocess.TimeoutExpired) as error:
                sys.exit(f"{place}: {error}")
            if time.monotonic() - begin > 2.0:
                print(f"{place}: {command} ({time.monotonic() - begin:.1f} s)", flush=True)


def check_python(workshop, *paths):
    """The examples in Python read a run in results/discharge_quick."""
    workshop.run("repose run input/discharge_quick.toml --output results/discharge_quick")
    examples = ["\n".join(lines) for path in paths for _, language, lines in blocks_of(path, path) if language == "python"]
    assert len(examples) > 5, examples
    for example in examples:
        assert workshop.say([sys.executable, "-c", example]).strip(), f"an example prints nothing:\n{example}"


def check_summary_keys(workshop, readme):
    """The README names every key of summary.json."""
    with open(os.path.join(workshop.folder, "results/discharge_quick/summary.json")) as summary, open(readme) as document:
        text = document.read()
        missing = [key for key in json.load(summary) if f"`{key}`" not in text]
    assert not missing, f"README.md lacks these keys of summary.json: {missing}"


def main():
    source = os.path.abspath(sys.argv[3])
    guide = os.path.join(source, "docs", "user-guide.md")
    with tempfile.TemporaryDirectory() as folder:
        workshop = Workshop(sys.argv[1], sys.argv[2], source, folder)
        check_first_deck(workshop, guide)
        check_python(workshop, guide, os.path.join(source, "docs", "python.md"))
        check_summary_keys(workshop, os.path.join(source, "README.md"))
        documents = [os.path.join(source, "README.md"), guide, *sorted(set(glob.glob(os.path.join(source, "docs", "*.md"))) - {guide})]
        documents += sorted(glob.glob(os.path.join(source, "benchmarks", "*", "README.md")))
        for path in documents:
            check_commands(workshop, os.path.relpath(path, source), path)
        unused = {*REDUCED, *STANDS_FOR, *NOT_RUN} - workshop.used
        assert not unused, f"no document needs these entries any more: {sorted(unused)}"
        assert workshop.ran > 12, f"only {workshop.ran} commands were found"
        print(f"{workshop.ran} commands were run, {len(workshop.helps)} compared with their help")


main()
