"""Starting the program."""

import itertools
import json
import os
import pathlib
import shutil
import subprocess

from repose.calibration import Calibration
from repose.files import ReposeError
from repose.run_directory import Run
from repose.validation import Validation

BUILDS = ("release", "ci")


def find_program():
    """The path of the program: what REPOSE in the environment names, what was installed or built with this package, or
    the first `repose` of PATH."""
    named = os.environ.get("REPOSE")
    if named:
        return named
    tools = pathlib.Path(__file__).resolve().parents[2]  # share/repose, or tools of the source
    if tools.parent.name == "share":
        near = [tools.parents[1] / "bin" / "repose"]
    else:
        near = [tools.parent / "build" / build / "src" / "repose" for build in BUILDS]
    for path in near:
        if path.is_file():
            return str(path)
    found = shutil.which("repose")
    if not found:
        raise ReposeError("the program repose is neither beside this package nor in PATH; name it in REPOSE or by "
                          "program=")
    return found


def value_text(value):
    """A value of a deck as `--set` takes it: numbers and lists as TOML, texts bare."""
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(json.dumps(item) if isinstance(item, str) else value_text(item) for item in value) + "]"
    if hasattr(value, "tolist"):  # of numpy
        return value_text(value.tolist())
    return str(value).lower() if isinstance(value, bool) else repr(value)


def reason_of(stderr):
    """The one line that says why a call failed: the program's own, or the beginning of what mpirun has put between lines of
    dashes; None for an empty text."""
    said = [line for line in stderr.strip().splitlines() if not line.startswith("repose: warning: ")]
    own = [line for line in said if line.startswith("repose: ")]
    if own:
        return own[-1].removeprefix("repose: ")
    framed = [n for n, line in enumerate(said) if line and not line.strip("-")]
    if not framed:
        return said[-1] if said else None
    paragraph = itertools.takewhile(str.strip, itertools.dropwhile(lambda line: not line.strip(), said[framed[0] + 1:]))
    return " ".join(line.strip() for line in paragraph if line.strip("-")) or said[-1]


def call(arguments, ranks=1, program=None, mpirun="mpirun"):
    """Runs `repose` with arguments; what it prints. `mpirun` starts it on several ranks. A failure raises ReposeError
    with the program's one line, which no warning is, and its exit code."""
    launcher = [mpirun, "-n", str(ranks)] if ranks > 1 else []
    command = [*launcher, program or find_program(), *arguments]
    command = [os.fspath(word) for word in command]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    except OSError as error:
        raise ReposeError(f"{command[0]}: cannot be started: {error.strerror}") from None
    if done.returncode != 0:
        raise ReposeError(reason_of(done.stderr) or f"ended with exit code {done.returncode}", done.returncode)
    return done.stdout


def set_options(values):
    """Words of the command line for {key of the deck: value}, or for a list of texts "key=value"."""
    if isinstance(values, dict):
        values = [f"{key}={value_text(value)}" for key, value in values.items()]
    return [word for value in values or () for word in ("--set", value)]


def run(deck, output, set=None, ranks=1, program=None, restart=False, options=(), mpirun="mpirun"):
    """Runs a deck and returns its `Run`.

    deck      path of a deck (TOML)
    output    directory of the results
    set       {key: value} in place of values of the deck; numbers in SI, texts with their unit: {"run.seed": 2,
              "particles.0.mass": "0.3 g", "wall.lid.radius": 2e-3}; or a list of texts "key=value"
    ranks     processes, started by mpirun when there are several
    program   path of repose; see `find_program`
    restart   go on with a run that was stopped, or take it as it is when it is complete
    options   more words of the command line, such as ("--time-limit", "01:00:00")

    Raises ReposeError with the program's one line when it fails; its `code` is the exit code.
    """
    words = ["run", deck, "--output", output, "--quiet", *set_options(set), *(["--restart"] if restart else []),
             *options]
    call(words, ranks, program, mpirun)
    return Run(output)


def calibrate(deck, output, set=None, ranks=1, program=None, options=(), mpirun="mpirun"):
    """Does what is missing of the runs of a calibration (TOML) and returns its `Calibration`. As `run`."""
    call(["calibrate", deck, "--output", output, "--quiet", *set_options(set), *options], ranks, program, mpirun)
    return Calibration(output)


def validate(deck, output, set=None, ranks=1, program=None, options=(), mpirun="mpirun"):
    """Does what is missing of the cases of a validation (TOML) and returns its `Validation`. As `run`."""
    call(["validate", deck, "--output", output, "--quiet", *set_options(set), *options], ranks, program, mpirun)
    return Validation(output)
