#!/usr/bin/python3
"""Prints the measured figures of a run. Usage: tools/print_summary.py DIR/summary.json (or DIR)"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
from repose_needs import need  # noqa: E402

need("numpy")
import repose  # noqa: E402
from repose.units import display  # noqa: E402


def text(value, unit, scale=1.0):
    """The value in the unit, or a dash for null: not measured in this run, or nothing there to measure."""
    return "-" if value is None else f"{scale * value:.4g} {unit}"


def measured(run):
    """Pairs of a figure's name and its printed value: every figure with a unit and a value, with its error."""
    for key, value in run.figures.items():
        name, unit, scale = display(key)
        unit = unit.replace("degrees", "deg")
        if not unit or "." in key or key == "time_s" or "_stderr" in key or value is None:
            continue
        error = run.error(key)
        yield name, text(value, unit, scale) + (f" +- {scale * error:.2g} {unit} (standard error)" if error is not None
                                                else "")


def grains(area):
    return "-" if area is None else f"{area['count']} +- {area['error']:.0f}"


def scattering_rows(scattering):
    yield "base of the pile", text(scattering["base_diameter_m"], "mm in diameter", 1e3)
    for number in (1, 2, 3):
        yield f"grains on area {number}", grains(scattering[f"area_{number}"])
    yield "grains off the plate", str(scattering["off_plate"])


def rows(run):
    summary = run.summary
    particles = summary["particles"]
    yield "status", summary["status"] + (", orifice plugged" if summary.get("plugged") else "")
    yield "particles", f"{particles['inserted']} inserted = {particles['inside']} inside + {particles['left']} left"
    yield "simulated time", f"{text(summary['time_s'], 's')} in {summary['steps']} steps"
    yield from measured(run)
    if summary.get("scattering") is not None:
        yield from scattering_rows(summary["scattering"])
    yield "wall time", f"{text(summary['wall_seconds'], 's')} on {summary['ranks']} ranks"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        for name, value in rows(repose.Run(sys.argv[1].removesuffix("summary.json") or ".")):
            print(f"{name:<28}{value}")
    except repose.ReposeError as error:
        sys.exit(f"print_summary.py: {error}")


if __name__ == "__main__":
    main()
