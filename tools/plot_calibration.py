#!/usr/bin/python3
"""Draws what `repose calibrate` or `repose sensitivity` has found, beside it, as PNG and PDF.

Usage: tools/plot_calibration.py DIR...

DIR holds estimate.json and grid.csv (calibration.png, calibration.pdf) or sensitivity.json (sensitivity.png, .pdf).
"""

import csv
import json
import math
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first: there need not be a screen)

UNITS = (("_kg", "g", 1e3), ("_deg", "degrees", 1.0), ("_kg_s", "g/s", 1e3), ("_m", "mm", 1e3), ("_s", "s", 1.0))
REGION, LABORATORY, CHEAP = "tab:red", "black", "tab:purple"
LEVEL_MARKS = "osD^v"


def read_json(folder, name):
    with open(os.path.join(folder, name)) as file:
        return json.load(file)


def quantity(figure):
    """Name with its unit, and the factor from SI to it."""
    for ending, unit, factor in sorted(UNITS, key=lambda u: -len(u[0])):
        if figure.endswith(ending):
            return f"{figure[:-len(ending)]}, {unit}".replace("_", " "), factor
    return figure.replace("_", " ").replace(".", " "), 1.0


def label(name):
    return name.replace("_", " ")


def runs_of(folder):
    with open(os.path.join(folder, "grid.csv")) as file:
        return list(csv.DictReader(file))


def draw_runs(axes, rows, x, y, figure):
    """Dots where the figure was found, with a mark of its own for each level; crosses where runs were plugged, had none, or
    failed. The last level's are full."""
    found = [r for r in rows if r["state"] == "done" and r[figure]]
    levels = levels_of(rows)
    for n, level in enumerate(levels):
        points = {(float(r[x]), float(r[y])) for r in found if r["level"] == level}
        if points:
            axes.plot(*zip(*points), LEVEL_MARKS[n % len(LEVEL_MARKS)], color="0.25", markersize=5, label=level,
                      clip_on=False, linestyle="none", fillstyle="full" if n + 1 == len(levels) else "none")
    marks = (("o", "run", [] if levels else found), ("x", "plugged", [r for r in rows if r["state"] == "plugged"]),
             ("+", "no value", [r for r in rows if r["state"] == "done" and not r[figure]]),
             ("1", "failed", [r for r in rows if r["state"] == "failed"]))
    for marker, name, some in marks:
        points = {(float(r[x]), float(r[y])) for r in some}
        if points:
            axes.plot(*zip(*points), marker, color="0.25", markersize=4 if marker == "o" else 7, label=name, clip_on=False,
                      linestyle="none")


def levels_of(rows):
    """Names, the cheapest first; none when the runs are of one level."""
    return list(dict.fromkeys(r["level"] for r in rows if "level" in r))


def draw_cheap_level(axes, estimate, number):
    """What the cheapest level alone would have said: its contour of the laboratory's value, or with None its region."""
    if "first_level_alone" not in estimate:
        return
    alone, name = estimate["first_level_alone"]["surfaces"], estimate["levels"][0]["name"]
    if number is None:
        if any(v <= alone["limit"] for row in alone["misfit"] for v in row):
            axes.contour(alone["x"], alone["y"], alone["misfit"], levels=[alone["limit"]], colors=[CHEAP], linewidths=1.0,
                         linestyles=":")
            axes.plot([], [], ":", color=CHEAP, label=f"region of {name} alone")
        return
    for n, line in enumerate(alone["observables"][number]["laboratory_lines"]):
        axes.plot(*zip(*line), ":", color=CHEAP, linewidth=1.2, label=None if n else f"laboratory by {name} alone")


def draw_laboratory(axes, surfaces, found, observable, factor, colour=LABORATORY):
    """The laboratory's contour, and the band of two standard errors about it."""
    error = 2.0 * observable["standard_error"]
    low, high = (factor * (observable["laboratory"] + side * error) for side in (-1, 1))
    values = [[factor * v for v in row] for row in found["mean"]]
    if high > low:
        axes.contourf(surfaces["x"], surfaces["y"], values, levels=[low, high], colors=[colour], alpha=0.2)
    for n, line in enumerate(found["laboratory_lines"]):
        axes.plot(*zip(*line), "--", color=colour, linewidth=1.5, label=None if n else "laboratory")


def draw_region(axes, estimate):
    surfaces = estimate["surfaces"]
    if any(v <= surfaces["limit"] for row in surfaces["misfit"] for v in row):
        axes.contour(surfaces["x"], surfaces["y"], surfaces["misfit"], levels=[surfaces["limit"]], colors=[REGION],
                     linewidths=1.5)
        axes.plot([], [], color=REGION, label=f"{100 * estimate['confidence']:.0f} % region")
    for n, point in enumerate(estimate["points"]):
        axes.plot(*point["values"], "*", color=REGION, markersize=13, markeredgecolor="white",
                  label=None if n else "calibrated")
    if not estimate["points"]:
        axes.plot(*estimate["nearest"]["values"], "d", color=REGION, markersize=8, label="nearest")


def draw_plane(folder, estimate):
    x, y = (p["name"] for p in estimate["parameters"])
    surfaces, rows = estimate["surfaces"], runs_of(folder)
    count = len(estimate["observables"])
    figure, panels = plt.subplots(1, count + 1, figsize=(4.6 * (count + 1), 4.4), sharey=True, layout="constrained")
    for number, (axes, observable, found) in enumerate(zip(panels, estimate["observables"], surfaces["observables"])):
        name, factor = quantity(observable["figure"])
        values = [[factor * v for v in row] for row in found["mean"]]
        axes.contourf(surfaces["x"], surfaces["y"], values, levels=12, cmap="Blues", alpha=0.6)
        lines = axes.contour(surfaces["x"], surfaces["y"], values, levels=12, colors="0.4", linewidths=0.6)
        axes.clabel(lines, fontsize=7)
        draw_laboratory(axes, surfaces, found, observable, factor)
        draw_cheap_level(axes, estimate, number)
        draw_runs(axes, rows, x, y, observable["figure"])
        draw_region(axes, estimate)
        axes.set_title(name, fontsize=10)
        axes.legend(fontsize=7, loc="best")
    for n, (observable, found) in enumerate(zip(estimate["observables"], surfaces["observables"])):
        draw_laboratory(panels[-1], surfaces, found, observable, quantity(observable["figure"])[1], f"C{n}")
        panels[-1].plot([], [], "--", color=f"C{n}", label=quantity(observable["figure"])[0])
    draw_cheap_level(panels[-1], estimate, None)
    draw_region(panels[-1], estimate)
    handles, names = panels[-1].get_legend_handles_labels()
    shown = [(h, n) for h, n in zip(handles, names) if n != "laboratory"]
    panels[-1].legend(*zip(*shown), fontsize=7, loc="best")
    panels[-1].set_title("where they meet", fontsize=10)
    panels[-1].set(xlim=(surfaces["x"][0], surfaces["x"][-1]), ylim=(surfaces["y"][0], surfaces["y"][-1]))
    for axes in panels:
        axes.set_xlabel(label(x))
    panels[0].set_ylabel(label(y))
    figure.suptitle(estimate["title"], fontsize=11)
    return figure


def draw_pairs(folder, estimate):
    """One or three parameters: the runs over each parameter, and where the laboratory and the estimate are."""
    parameters, rows = estimate["parameters"], runs_of(folder)
    count = len(estimate["observables"])
    figure, panels = plt.subplots(count, len(parameters), figsize=(4.2 * len(parameters), 3.2 * count), squeeze=False,
                                  sharex="col", layout="constrained")
    for row, observable in zip(panels, estimate["observables"]):
        name, factor = quantity(observable["figure"])
        for k, (axes, parameter) in enumerate(zip(row, parameters)):
            some = [r for r in rows if r[observable["figure"]] and r["state"] != "failed"]
            for n, level in enumerate(levels_of(rows) or [None]):
                own = [r for r in some if level is None or r["level"] == level]
                axes.plot([float(r[parameter["name"]]) for r in own], [factor * float(r[observable["figure"]]) for r in own],
                          LEVEL_MARKS[n % len(LEVEL_MARKS)], color="0.4", markersize=4, label=level)
            value, error = factor * observable["laboratory"], factor * observable["standard_error"]
            axes.axhline(value, color=LABORATORY, linestyle="--")
            axes.axhspan(value - 2 * error, value + 2 * error, color=LABORATORY, alpha=0.2)
            for point in estimate["points"]:
                interval = estimate["parts"][point["part"]]["intervals"][k]
                axes.axvspan(interval["lower"], interval["upper"], color=REGION, alpha=0.15)
                axes.axvline(point["values"][k], color=REGION)
            axes.set_xlabel(label(parameter["name"]))
        row[0].set_ylabel(name)
    figure.suptitle(estimate["title"], fontsize=11)
    return figure


def draw_effects(axes, effects, value, error, title):
    names = [label(e["parameter"]) for e in effects]
    values = [math.nan if e[value] is None else e[value] for e in effects]
    errors = [0.0 if e[error] is None else e[error] for e in effects]
    axes.barh(names, values, xerr=errors, color="tab:blue", alpha=0.7, capsize=3)
    axes.axvline(0.0, color="black", linewidth=0.8)
    axes.invert_yaxis()
    axes.set_title(title, fontsize=9)


def draw_sensitivity(result):
    figures = list(dict.fromkeys(e["figure"] for e in result["one_at_a_time"]))
    kinds = [("one_at_a_time", "effect", "standard_error", "from lower to upper value")]
    if result["morris"]:
        kinds.append(("morris", "mu_star", "mu_star_error", "Morris mu* over the range"))
    figure, panels = plt.subplots(len(figures), len(kinds), figsize=(4.8 * len(kinds), 2.2 * len(figures)), squeeze=False,
                                  layout="constrained")
    for row, name in zip(panels, figures):
        shown, factor = quantity(name)
        for axes, (kind, value, error, title) in zip(row, kinds):
            effects = [{**e, value: e[value] and factor * e[value], error: e[error] and factor * e[error]}
                       for e in result[kind] if e["figure"] == name]
            draw_effects(axes, effects, value, error, f"{shown}: {title}")
    figure.suptitle(result["title"], fontsize=11)
    return figure


def save(figure, folder, name):
    for ending in ("png", "pdf"):
        path = os.path.join(folder, f"{name}.{ending}")
        figure.savefig(path, dpi=150)
        print(path)
    plt.close(figure)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__.strip())
    for folder in sys.argv[1:]:
        if os.path.exists(os.path.join(folder, "estimate.json")):
            estimate = read_json(folder, "estimate.json")
            save(draw_plane(folder, estimate) if "surfaces" in estimate else draw_pairs(folder, estimate), folder,
                 "calibration")
        elif os.path.exists(os.path.join(folder, "sensitivity.json")):
            save(draw_sensitivity(read_json(folder, "sensitivity.json")), folder, "sensitivity")
        else:
            sys.exit(f"{folder}: has neither estimate.json nor sensitivity.json")


if __name__ == "__main__":
    main()
