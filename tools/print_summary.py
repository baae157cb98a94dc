#!/usr/bin/python3
"""Prints the measured figures of a run. Usage: tools/print_summary.py DIR/summary.json"""
import json
import sys


def figure(value, unit, scale=1.0):
    """The value in the unit, or a dash for null: not measured in this run, or nothing there to measure."""
    return "-" if value is None else f"{scale * value:.4g} {unit}"


def grains(area):
    return "-" if area is None else f"{area['count']} +- {area['error']:.0f}"


def scattering_rows(scattering):
    yield "base of the pile", figure(scattering["base_diameter_m"], "mm in diameter", 1e3)
    for number in (1, 2, 3):
        yield f"grains on area {number}", grains(scattering[f"area_{number}"])
    yield "grains off the plate", str(scattering["off_plate"])


def rows(summary):
    """Pairs of a quantity's name and its printed value, from the keys that every summary.json has."""
    get = summary.get
    angle = figure(get("angle_of_repose_deg"), "deg")
    if get("angle_of_repose_stderr_deg") is not None:
        angle += f" +- {summary['angle_of_repose_stderr_deg']:.2g} deg (standard error)"
    particles = summary["particles"]
    yield "status", summary["status"] + (", orifice plugged" if get("plugged") else "")
    yield "particles", f"{particles['inserted']} inserted = {particles['inside']} inside + {particles['left']} left"
    yield "simulated time", f"{figure(get('time_s'), 's')} in {summary['steps']} steps"
    yield "discharged mass", figure(get("discharged_mass_kg"), "g", 1e3)
    yield "retained mass", figure(get("retained_mass_kg"), "g", 1e3)
    yield "discharge time", figure(get("discharge_time_s"), "s")
    yield "discharge rate", figure(get("discharge_rate_kg_s"), "g/s", 1e3)
    yield "angle of repose, left", figure(get("angle_of_repose_left_deg"), "deg")
    yield "angle of repose, right", figure(get("angle_of_repose_right_deg"), "deg")
    yield "angle of repose, mean", angle
    if get("scattering") is not None:
        yield from scattering_rows(summary["scattering"])
    yield "wall time", f"{figure(get('wall_seconds'), 's')} on {summary['ranks']} ranks"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        summary = json.load(file)
    for name, value in rows(summary):
        print(f"{name:<24}{value}")


if __name__ == "__main__":
    main()
