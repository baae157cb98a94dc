"""How the benchmarks report: results as JSON, with the machine and the commit, and tables for documents."""

import argparse
import json
import pathlib
import platform
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tools" / "python"))  # of the package repose, for all that import this


def machine():
    with open("/proc/cpuinfo") as file:
        lines = [[part.strip() for part in line.split(":", 1)] for line in file if ":" in line]
    first = dict(reversed(lines))  # of each key the first value
    names = [value for key, value in lines if key == "model name"]
    processor = platform.processor()
    if names:  # the name alone does not tell one generation from another
        processor = f"{names[0]}, family {first.get('cpu family')}, model {first.get('model')}"
    return {"processor": processor, "cores": len(names), "cache": first.get("cache size", "unknown")}


def commit():
    done = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


def save(path, **content):
    """Keys one below the other; the values of `rows` one to a line."""
    path.parent.mkdir(parents=True, exist_ok=True)
    head = {"date": time.strftime("%Y-%m-%d"), "machine": machine(), "commit": commit()}
    rows = content.pop("rows", [])
    text = json.dumps({**head, **content}, indent=1)
    if rows:
        text = text[:-2] + ',\n "rows": [\n  ' + ",\n  ".join(json.dumps(row) for row in rows) + "\n ]\n}"
    path.write_text(text + "\n")
    print(f"wrote {path}")


def usual_options(description, name):
    """A parser of what most benchmarks take: the program, a folder to work in, and where the results of `name` go."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", default=None, help="the program (default: $REPOSE or the one built)")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "benchmarks" / name, help="a folder")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "benchmarks" / "results" / name,
                        help="where the results go")
    return parser


def print_table(rows, digits=3):
    """A table for a document."""
    columns = list(rows[0])
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(shown(row.get(c), digits) for c in columns) + " |")


def shown(value, digits):
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.{digits}g}" if abs(value) < 10**digits else f"{value:.0f}"
    return str(value)
