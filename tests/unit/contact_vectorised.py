#!/usr/bin/env python3
"""Disassembles the contact loops and checks that all levels are vectorised, and nothing is fused.

contact_vectorised.py LIBRARY: the static library or object file that holds it. Exit code 77: cannot be told here.
"""
import platform
import re
import shutil
import subprocess
import sys

# Per level the registers that its square roots and divisions must use.
LEVELS = {"run_plain": "xmm", "run_avx2": "ymm", "run_x4_avx512": "ymm", "run_avx512": "zmm"}
# The number of functions each loop is compiled to: one for the thesis's law and one for that with options, each for
# every shape of a face.
LOOPS = {"evaluate_pairs": 2, "evaluate_walls": 3, "evaluate_faces": 6}
SKIP = 77


def functions(disassembly):
    """Instructions of every function, by its (mangled) name."""
    found, lines = {}, None
    for line in disassembly.splitlines():
        head = re.match(r"[0-9a-f]+ <(.+)>:$", line)
        if head:
            lines = found.setdefault(head[1], [])
        elif lines is not None and line.startswith(" "):
            lines.append(line.split("\t", 1)[-1])
    return found


def problems(level, instructions):
    register = LEVELS[level]
    text = "\n".join(instructions)
    for operation in ("sqrt", "div"):
        if not re.search(rf"^v?{operation}pd\s.*%{register}\d", text, re.MULTILINE):
            yield f"{level} has no packed {operation}pd on {register} registers"
        scalar = re.findall(rf"^v?{operation}sd\s.*", text, re.MULTILINE)
        if scalar:
            yield f"{level} has {len(scalar)} scalar instructions {operation}sd"
    fused = re.findall(r"^vf(?:n?m)(?:add|sub)\w*", text, re.MULTILINE)
    if fused:
        yield f"{level} has {len(fused)} fused multiply-adds, which change the bits"


def main():
    if platform.machine() not in ("x86_64", "AMD64"):
        print(f"skipped: no x86-64 instructions on {platform.machine()}")
        return SKIP
    objdump = shutil.which("objdump")
    if objdump is None:
        print("skipped: objdump (package binutils) is missing")
        return SKIP
    run = subprocess.run([objdump, "-d", "--no-show-raw-insn", sys.argv[1]], check=True, capture_output=True, text=True)
    found = functions(run.stdout)
    failures = []
    for level in LEVELS:
        for loop, count in LOOPS.items():
            bodies = [body for name, body in found.items()
                      if level in name and loop in name and not name.endswith(".cold")]
            if len(bodies) != count:
                failures.append(f"{loop} for {level} was found {len(bodies)} times, not {count}, in {sys.argv[1]}")
            for body in bodies:
                failures.extend(f"{loop}: {problem}" for problem in problems(level, body))
                print(f"{loop}, {level}: {len(body)} instructions")
    for failure in failures:
        print(failure)
    return 1 if failures else 0


sys.exit(main())
