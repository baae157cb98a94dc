#!/usr/bin/python3
"""Prints the measured figures of a run. Usage: tools/print_summary.py DIR/summary.json"""
import json
import sys


UNITS = (("_kg_s", "g/s", 1e3), ("_kg", "g", 1e3), ("_deg", "deg", 1.0), ("_m", "mm", 1e3), ("_s", "s", 1.0))
NOT_MEASURED = ("time_s", "timestep_s")  # numbers of the run, not of the grains


def text(value, unit, scale=1.0):
    """The value in the unit, or a dash for null: not measured in this run, or nothing there to measure."""
    return "-" if value is None else f"{scale * value:.4g} {unit}"


def measured(summary):
    """Pairs of a figure's name and its printed value: every key that ends in a unit and has a value, with its error."""
    for key, value in summary.items():
        unit = next((u for u in UNITS if key.endswith(u[0])), None)
        if unit is None or key in NOT_MEASURED or "_stderr" in key or value is None:
            continue
        ending, name, scale = unit
        printed = text(value, name, scale)
        error = summary.get(f"{key[:-len(ending)]}_stderr{ending}")
        if error is not None:
            printed += f" +- {scale * error:.2g} {name} (standard error)"
        yield key[:-len(ending)].replace("_", " "), printed


def grains(area):
    return "-" if area is None else f"{area['count']} +- {area['error']:.0f}"


def scattering_rows(scattering):
    yield "base of the pile", text(scattering["base_diameter_m"], "mm in diameter", 1e3)
    for number in (1, 2, 3):
        yield f"grains on area {number}", grains(scattering[f"area_{number}"])
    yield "grains off the plate", str(scattering["off_plate"])


def rows(summary):
    particles = summary["particles"]
    yield "status", summary["status"] + (", orifice plugged" if summary.get("plugged") else "")
    yield "particles", f"{particles['inserted']} inserted = {particles['inside']} inside + {particles['left']} left"
    yield "simulated time", f"{text(summary['time_s'], 's')} in {summary['steps']} steps"
    yield from measured(summary)
    if summary.get("scattering") is not None:
        yield from scattering_rows(summary["scattering"])
    yield "wall time", f"{text(summary['wall_seconds'], 's')} on {summary['ranks']} ranks"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        summary = json.load(file)
    for name, value in rows(summary):
        print(f"{name:<28}{value}")


if __name__ == "__main__":
    main()
