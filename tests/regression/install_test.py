"""cmake --install: the installed program runs an installed deck, everything that belongs to it is there, and the man page and the
completion know the command line as it is.

Usage: install_test.py EXECUTABLE MPIEXEC SOURCE_DIR BUILD_DIR CMAKE
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

from repose_runs import Program

REDUCED = ("particles.0.mass=0.05 g", "particles.0.height=20 mm", "phase.settle.max_time=3 ms", "phase.settle.min_time=1 ms",
           "phase.discharge.max_time=3 ms", "phase.discharge.min_time=3 ms")


def said(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300, **options)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def section(help_text, title):
    """The lines of a section of the help that begin an entry."""
    found = re.search(rf"^{title}:\n((?:  .*\n)+)", help_text, re.M)
    return [line.strip() for line in found.group(1).splitlines() if re.match(r"  \S", line)] if found else []


class CommandHelp:
    """What `repose COMMAND --help` says of one command."""

    def __init__(self, program, name):
        self.name = name
        text = said(program, *name.split(), "--help")
        entries = section(text, "Options")
        self.options = {re.search(r"--[\w-]+", entry).group() for entry in entries}
        self.required = {re.search(r"--[\w-]+", entry).group() for entry in entries if "REQUIRED" in entry}
        self.choices = {re.search(r"--[\w-]+", entry).group(): set(found.group(1).split(",")) for entry in entries
                        if (found := re.search(r":\{(.*?)\}", entry))}
        self.positionals = len(section(text, "Positionals"))
        self.subcommands = [entry.split()[0] for entry in section(text, "Subcommands")]


def all_commands(program):
    """Those that can be run, and those that only hold others ('' is the program itself)."""
    found = {}
    names = [""]
    while names:
        found[names[0]] = command = CommandHelp(program, names[0])
        names = names[1:] + [f"{command.name} {name}".strip() for name in command.subcommands]
    return found


class Install(unittest.TestCase):
    source = build = cmake = mpiexec = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.prefix = folder.name
        said(cls.cmake, "--install", cls.build, "--prefix", cls.prefix)
        cls.program = cls.path("bin/repose")
        cls.commands = all_commands(cls.program)

    @classmethod
    def path(cls, *names):
        return os.path.join(cls.prefix, *names)

    def test_the_commands_are_found(self):
        self.assertGreater(len(self.commands), 15)
        self.assertIn("--restart", self.commands["run"].options)
        self.assertEqual(self.commands["run"].required, {"--output"})
        self.assertIn("avx2", self.commands["run"].choices["--vector-level"])
        self.assertIn("thermal tps", self.commands)

    def test_the_installed_program_runs_an_installed_deck(self):
        installed = Program(self.program, self.mpiexec, self.path("share/repose"))
        results = [installed.run(installed.deck("discharge_quick.toml"), self.path(f"results{ranks}"), *REDUCED, ranks=ranks)
                   for ranks in (0, 2)]
        self.assertEqual(results[0]["status"], "done")
        self.assertEqual(results[0]["state_hash"], results[1]["state_hash"])
        for deck in ("validation.toml", "mesh_hopper.toml", "hopper.stl"):
            self.assertTrue(os.path.exists(installed.deck(deck)), deck)

    def test_it_finds_its_libraries_by_itself(self):
        alone = {key: value for key, value in os.environ.items() if key != "LD_LIBRARY_PATH"}
        libraries = said("ldd", self.program, env=alone)
        self.assertNotIn("not found", libraries)
        paths = re.search(r"R(?:UN)?PATH.*\[(.*)\]", said("readelf", "-d", self.program))
        self.assertIsNotNone(paths, "no path of libraries that the linker does not search")
        for path in paths.group(1).split(":"):
            self.assertFalse(path.startswith((os.path.abspath(self.build), os.path.abspath(self.source))), path)

    def test_it_is_not_made_for_one_processor(self):
        self.assertNotRegex(said(self.program, "--version"), "-march|-mtune=native|-mcpu")

    def test_scripts_and_tools_are_there(self):
        for name in ("run", "scaling", "calibrate"):
            path = self.path(f"share/repose/jobscripts/{name}.sbatch")
            said("bash", "-n", path)
            with open(path) as file:
                self.assertIn("#SBATCH --partition=PARTITION\n", file.read())
        for name in sorted(os.listdir(os.path.join(self.source, "tools"))):
            if name.endswith(".py"):
                self.assertTrue(os.access(self.path("share/repose/tools", name), os.X_OK), name)
        for name in ("README.md", "LICENSE", "docs/user-guide.md", "docs/pictures/discharge.png"):
            self.assertTrue(os.path.exists(self.path("share/doc/repose", name)), name)

    def test_the_python_package_is_there(self):
        """`import repose` finds the installed program, and `repose report` the installed package."""
        output, package = self.path("results_python"), self.path("share/repose/python")
        env = {key: value for key, value in os.environ.items() if key not in ("REPOSE", "PYTHONPATH")}
        code = (f"import repose; assert repose.find_program() == {self.program!r}, repose.find_program(); "
                f"print(repose.run({self.path('share/repose/input/discharge_quick.toml')!r}, {output!r}, "
                f"set={list(REDUCED)!r}).summary['state_hash'])")
        said_hash = said(sys.executable, "-B", "-c", code, env={**env, "PYTHONPATH": package}).strip()
        with open(os.path.join(output, "summary.json")) as file:
            self.assertIn(f'"state_hash": "{said_hash}"', file.read())
        report = said(self.program, "report", output, env={**env, "REPOSE_PYTHON": sys.executable}).strip()
        self.assertEqual(report, os.path.join(output, "report.html"))
        said(self.path("share/repose/tools/print_summary.py"), output, env=env)
        self.assertFalse(os.path.exists(os.path.join(package, "repose", "report", "__pycache__")), "repose report leaves files there")

    def test_the_man_page_has_the_command_line(self):
        page = self.path("share/man/man1/repose.1")
        warnings = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8", page], capture_output=True, text=True)
        self.assertEqual((warnings.returncode, warnings.stderr), (0, ""))
        with open(page) as file:
            headings = [h.replace("\\-", "-") for h in re.findall(r'^\.SS "(.*)"$', file.read(), re.M)]
        described = {}
        for heading in headings:
            name = re.match(r"(?:(?:thermal|photo) )?\w+", heading).group()
            described[name] = heading
        runnable = {name: command for name, command in self.commands.items() if not command.subcommands}
        self.assertEqual(set(described), set(runnable))
        for name, command in runnable.items():
            optional = set(re.findall(r"\[(--[\w-]+)", described[name]))
            required = set(re.findall(r"(?<!\[)(--[\w-]+)", described[name]))
            self.assertEqual(optional | required, command.options - {"--help"}, described[name])
            self.assertEqual(required, command.required, described[name])
            operands = re.match(r"(?:(?:thermal|photo) )?\w+((?: [A-Z.]+)*)", described[name]).group(1).split()
            self.assertEqual(bool(operands), bool(command.positionals), described[name])

    def complete(self, *words, folder=None):
        """What the Tab key offers for the last of the words."""
        script = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _repose; printf "%s\\n" "${COMPREPLY[@]}"'
        completion = self.path("share/bash-completion/completions/repose")
        return set(said("bash", "-c", script, "bash", completion, self.path("bin/repose"), *words, cwd=folder).split())

    def test_the_completion_has_the_command_line(self):
        for name, command in self.commands.items():
            words = name.split()
            self.assertEqual(self.complete(*words, "-"), command.options, name)
            if command.subcommands:
                self.assertEqual(self.complete(*words, ""), set(command.subcommands), name)
            for option, choices in command.choices.items():
                self.assertEqual(self.complete(*words, option, ""), choices, name)
        self.assertEqual(self.complete("ru"), {"run"})
        self.assertEqual(self.complete("run", "deck.toml", "--re"), {"--restart"})
        self.assertEqual(self.complete("new", "led"), {"ledge"})

    def test_the_completion_offers_files_that_fit(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("deck.toml", "run_1.hdf", "grid.h5", "grains.csv", "in.chute"):
                open(os.path.join(folder, name), "w").close()
            os.mkdir(os.path.join(folder, "results"))
            for words, names in ((("run", ""), {"deck.toml"}), (("info", ""), {"run_1.hdf", "grid.h5"}),
                                 (("export", ""), {"run_1.hdf"}), (("run", "deck.toml", "--output", ""), set()),
                                 (("measure", "run_1.hdf", "--deck", ""), {"deck.toml"}),
                                 (("thermal", "tps", ""), {"grains.csv"}), (("run", "de"), {"deck.toml"}), (("import", "in."), {"in.chute"})):
                expected = {name for name in names | {"results"} if name.startswith(words[-1])}
                self.assertEqual(self.complete(*words, folder=folder), expected, words)


if __name__ == "__main__":
    _, _, Install.mpiexec, Install.source, Install.build, Install.cmake = sys.argv
    unittest.main(argv=sys.argv[:1], verbosity=2)
