#!/usr/bin/python3
"""Draws the result of a thermal tool beside it. Usage: tools/plot_thermal.py RESULT.json...

RESULT.json is what `repose thermal TOOL --output DIR` or `repose compare --output DIR` has written; the picture is
RESULT.png in the same folder.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "python"), os.path.join(HERE, "..", "python")]  # of the source, installed
from repose_needs import need  # noqa: E402

need("numpy", "matplotlib")
from repose.files import ReposeError, read_json  # noqa: E402
from repose.plots.style import new_figure  # noqa: E402


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


def draw_network(result, over_temperature, over_porosity):
    for number, bed in enumerate(result["beds"]):
        rows, colour = bed["conductivity"], f"C{number}"
        temperature = column(rows, "temperature_K")
        over_temperature.plot(temperature, column(rows, "conductivity_W_mK"), "o-", color=colour,
                              label=f"network, porosity {bed['porosity']:.3f}")
        over_temperature.plot(temperature, column(rows, "model_W_mK"), "--", color=colour,
                              label="model, the same porosity")
    over_temperature.set(xlabel="temperature, K", ylabel="conductivity, W/(m K)")
    beds = sorted(result["beds"], key=lambda bed: bed["porosity"])
    porosity = column(beds, "porosity")
    for number, at in enumerate(sorted({0, len(beds[0]["conductivity"]) - 1})):
        rows, colour = [bed["conductivity"][at] for bed in beds], f"C{number + 2}"
        over_porosity.plot(porosity, column(rows, "conductivity_W_mK"), "o-", color=colour,
                           label=f"network, {rows[0]['temperature_K']:.0f} K")
        over_porosity.plot(porosity, column(rows, "model_W_mK"), "s--", color=colour, markerfacecolor="none",
                           label="model")
    over_porosity.set(xlabel="porosity")
    over_porosity.legend(fontsize=7)


def draw_tps(result, line, residuals):
    for number, transient in enumerate(result["transients"]):
        series, colour = transient["series"], f"C{number}"
        k, count = transient["conductivity_W_mK"], len(series["residual_K"])
        first = series["first_used"]
        time, rise = series["time_s"][first:first + count], series["rise_K"][first:first + count]
        fitted = [a - b for a, b in zip(rise, series["residual_K"])]
        line.plot(series["source"], rise, ".", color=colour, markersize=3,
                  label=f"{os.path.basename(transient['file'])}: {k['value']:.4g} W/(m K)")
        line.plot([series["source"][0], series["source"][-1]], [fitted[0], fitted[-1]], color=colour, linewidth=0.8)
        residuals.plot(time, [1e3 * r for r in series["residual_K"]], ".", color=colour, markersize=3)
    line.set(xlabel="D(tau)", ylabel="rise of temperature, K")
    residuals.axhline(0.0, color="black", linewidth=0.5)
    residuals.set(xlabel="time, s", ylabel="residual, mK")


def draw_synthesise(result, axes):
    axes.plot(result["time_s"], result["rise_K"], ".", label="made up")
    axes.set(xlabel="time, s", ylabel="rise of temperature, K")


def draw_errors(axes, readings, key):
    """Errors against the literature: computed, with what rounding allows, and printed."""
    rows = [(place, reading[key]) for place, (_, reading) in enumerate(readings)]
    rows = [(place, error) for place, error in rows if error is not None]
    places = [place for place, _ in rows]
    low = [error["percent"] - error["lowest_possible"] for _, error in rows]
    high = [error["highest_possible"] - error["percent"] for _, error in rows]
    axes.errorbar(places, [error["percent"] for _, error in rows], yerr=[low, high], fmt="o", capsize=4,
                  label="computed, and what rounding allows")
    axes.plot(places, [error.get("printed", float("nan")) for _, error in rows], "k_", markersize=16, label="printed")


def draw_corrections(axes, materials, key):
    """Readings with mica at temperature, as they were read and corrected."""
    for number, material in enumerate(material for material in materials if material["hot"]):
        temperature = column(material["hot"], "temperature_K")
        values = column(material["hot"], key)
        axes.plot(temperature, column(values, "reading"), "x", color=f"C{number}", label=f"{material['name']}, read")
        axes.errorbar(temperature, column(values, "corrected"), yerr=column(values, "corrected_deviation"), fmt="o",
                      capsize=4, color=f"C{number}", label=f"{material['name']}, corrected")
    axes.set(xlabel="temperature, K")


def draw_sensor(result, heat_errors, conductivity_errors, heat, conductivity):
    readings = [(material["name"], reading) for material in result["materials"] for reading in material["room"]
                if reading["specific_heat_error"] or reading["conductivity_error"]]
    for axes, key, name in ((heat_errors, "specific_heat_error", "specific heat"),
                            (conductivity_errors, "conductivity_error", "conductivity")):
        draw_errors(axes, readings, key)
        axes.set_xticks(range(len(readings)),
                        [f"{name}, {r['insulation']} {1e3 * r['radius_m']:.3g} mm" for name, r in readings],
                        fontsize=6, rotation=60, ha="right")
        axes.set(ylabel=f"error of the {name}, %")
    draw_corrections(heat, result["materials"], "specific_heat_J_kgK")
    heat.set(ylabel="specific heat, J/(kg K)")
    if any(material["hot"] for material in result["materials"]):
        heat.legend(fontsize=7)
    draw_corrections(conductivity, result["materials"], "conductivity_W_mK")
    conductivity.set(ylabel="conductivity, W/(m K)")


def draw_mixture(result, axes):
    rows = result["states"]
    axes.semilogy(column(rows, "temperature_K"), [abs(x) for x in column(rows, "specific_heat_difference")], "o",
                  label="specific heat")
    axes.semilogy(column(rows, "temperature_K"), column(rows, "volumetric_difference"), "s",
                  label="volumetric heat capacity")
    axes.axhline(result["negligible"], color="black", linewidth=0.5, label="negligible below")
    axes.set(xlabel="temperature, K", ylabel="relative change by the air")


def draw_compare(result, axes):
    names = []
    for number, figure in enumerate(result["figures"]):
        low, middle, high = (figure[key] / figure["bound"] for key in ("low", "difference", "high"))
        axes.errorbar(middle, -number, xerr=[[middle - low], [high - middle]], fmt="o", capsize=4)
        names.append(f"{figure['column']}:\n{figure['verdict'].split(':')[0]}")
    for bound, label in ((-1.0, None), (1.0, "bounds of equivalence")):
        axes.axvline(bound, color="black", linewidth=0.5, label=label)
    axes.set_yticks([-number for number in range(len(names))], names, fontsize=7)
    axes.set(xlabel="difference of the means over its bound", ylim=(0.5 - len(names), 0.5))


DRAW = {"bed": draw_bed, "network": draw_network, "tps": draw_tps, "synthesise": draw_synthesise,
        "sensor": draw_sensor, "mixture": draw_mixture, "compare": draw_compare}


PANELS = {"network": (1, 2), "tps": (1, 2), "sensor": (2, 2)}  # rows and columns; one of the others


def plot(path):
    """The path of the picture, which appears whole or not at all."""
    result = read_json(path)
    if not isinstance(result, dict) or result.get("tool") not in DRAW:
        raise ReposeError(f"{path}: is no result of a thermal tool: it has no \"tool\" of {', '.join(DRAW)}")
    rows, columns = PANELS.get(result["tool"], (1, 1))
    figure, axes = new_figure(rows, columns, figsize=(4 + 3 * columns, 4.5 * rows), squeeze=False)
    DRAW[result["tool"]](result, *axes.flat)
    figure.suptitle(result["title"], fontsize=10)
    axes[0][0].legend(fontsize=7)
    picture = os.path.splitext(path)[0] + ".png"
    figure.savefig(picture + ".partial", format="png", dpi=150)
    os.replace(picture + ".partial", picture)
    return picture


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    for path in sys.argv[1:]:
        try:
            print(plot(path))
        except (ReposeError, OSError) as error:
            sys.exit(f"plot_thermal.py: {error}")
        except (ValueError, LookupError, TypeError) as error:
            sys.exit(f"plot_thermal.py: {path}: is no result of a thermal tool, or damaged: {error}")


if __name__ == "__main__":
    main()
