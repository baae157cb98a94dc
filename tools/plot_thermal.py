#!/usr/bin/python3
"""Draws the result of a thermal tool beside it. Usage: tools/plot_thermal.py RESULT.json...

RESULT.json is what `repose thermal TOOL --output DIR` or `repose compare --output DIR` has written; the picture is
RESULT.png in the same folder.
"""
import json
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first: there need not be a screen)


def column(rows, key):
    return [row[key] for row in rows]


def draw_bed(result, axes):
    rows = result["conductivity"]
    temperature, k = column(rows, "temperature_K"), column(rows, "conductivity_W_mK")
    spread = column(rows, "conductivity_deviation_W_mK")
    axes.plot(temperature, k, label="model")
    axes.fill_between(temperature, [a - b for a, b in zip(k, spread)], [a + b for a, b in zip(k, spread)], alpha=0.2,
                      label="densities within one standard deviation")
    axes.plot(temperature, column(rows, "without_radiation_W_mK"), "--", label="without radiation")
    axes.plot(temperature, column(rows, "air_conductivity_W_mK"), ":", label="air")
    for m in result["measurements"]:
        axes.errorbar(m["temperature_K"], m["conductivity_W_mK"], m["deviation_W_mK"], fmt="o", label=m["name"])
    axes.set(xlabel="temperature, K", ylabel="conductivity, W/(m K)")


def draw_network(result, axes):
    for number, bed in enumerate(result["beds"]):
        rows, colour = bed["conductivity"], f"C{number}"
        temperature = column(rows, "temperature_K")
        axes.plot(temperature, column(rows, "conductivity_W_mK"), "o-", color=colour,
                  label=f"network, porosity {bed['porosity']:.3f}")
        axes.plot(temperature, column(rows, "model_W_mK"), "--", color=colour, label="model, the same porosity")
    axes.set(xlabel="temperature, K", ylabel="conductivity, W/(m K)")


def draw_tps(result, axes):
    for transient in result["transients"]:
        series = transient["series"]
        used = series["time_s"][series["first_used"]:][:len(series["residual_K"])]
        k = transient["conductivity_W_mK"]
        axes.plot(used, [1e3 * r for r in series["residual_K"]], ".",
                  label=f"{os.path.basename(transient['file'])}: {k['value']:.4g} W/(m K)")
    axes.axhline(0.0, color="black", linewidth=0.5)
    axes.set(xlabel="time, s", ylabel="residual, mK")


def draw_synthesise(result, axes):
    axes.plot(result["time_s"], result["rise_K"], ".", label="made up")
    axes.set(xlabel="time, s", ylabel="rise of temperature, K")


def draw_sensor(result, axes):
    names, errors, printed = [], [], []
    for material in result["materials"]:
        for reading in material["room"]:
            error = reading["specific_heat_error"]
            if error is None:
                continue
            names.append(f"{material['name']}\n{reading['insulation']} {1e3 * reading['radius_m']:.3g} mm")
            errors.append(error["percent"])
            printed.append(error.get("printed", float("nan")))
    axes.bar(range(len(names)), errors, alpha=0.5, label="computed")
    axes.plot(range(len(names)), printed, "k_", markersize=20, label="printed")
    axes.set_xticks(range(len(names)), names, fontsize=6)
    axes.set(ylabel="error of the specific heat, %")


def draw_mixture(result, axes):
    rows = result["states"]
    axes.plot(column(rows, "temperature_K"), [1e6 * x for x in column(rows, "specific_heat_difference")], "o",
              label="specific heat")
    axes.plot(column(rows, "temperature_K"), [1e6 * x for x in column(rows, "volumetric_difference")], "s",
              label="volumetric heat capacity")
    axes.axhline(1e6 * result["negligible"], color="black", linewidth=0.5, label="negligible below")
    axes.set(xlabel="temperature, K", ylabel="what the air changes, 1e-6")


def draw_compare(result, axes):
    for number, figure in enumerate(result["figures"]):
        low, middle, high = (figure[key] / figure["bound"] for key in ("low", "difference", "high"))
        axes.errorbar(middle, -number, xerr=[[middle - low], [high - middle]], fmt="o", capsize=4,
                      label=f"{figure['column']}: {figure['verdict']}")
    for bound in (-1.0, 1.0):
        axes.axvline(bound, color="black", linewidth=0.5)
    axes.set_yticks([])
    axes.set(xlabel="difference of the means over its bound")


DRAW = {"bed": draw_bed, "network": draw_network, "tps": draw_tps, "synthesise": draw_synthesise,
        "sensor": draw_sensor, "mixture": draw_mixture, "compare": draw_compare}


def plot(path):
    """The path of the picture, which appears whole or not at all."""
    with open(path, encoding="utf-8") as file:
        result = json.load(file)
    figure, axes = plt.subplots(figsize=(7, 4.5))
    DRAW[result["tool"]](result, axes)
    axes.set_title(result["title"], fontsize=10)
    axes.legend(fontsize=7)
    figure.tight_layout()
    picture = os.path.splitext(path)[0] + ".png"
    figure.savefig(picture + ".partial", format="png", dpi=150)
    os.replace(picture + ".partial", picture)
    plt.close(figure)
    return picture


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    for path in sys.argv[1:]:
        try:
            print(plot(path))
        except (OSError, ValueError, KeyError, TypeError) as error:
            sys.exit(f"{path}: not a result of a thermal tool, or not to be read: {error!r}")


if __name__ == "__main__":
    main()
