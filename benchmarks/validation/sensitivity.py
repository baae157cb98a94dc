"""Which parameters matter: Table 3.6 of the thesis one at a time at reduced size, drawn as its Figures 3.9 and 3.10."""

import matplotlib

from bench import SCATTERING, UNITS, Bench, input_deck, row_of, save_means, spreads, with_seeds

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def study(options):
    """Each parameter at both ends of its range, the others held. The laboratory is the reduced test with the coefficients
    that the thesis found."""
    asked = input_deck("sensitivity_carbohsp.toml")
    held = [f"{p['key']}={p['fixed']}" for p in asked["parameter"]]
    runs = {}
    for p in asked["parameter"]:
        for end in ("min", "max"):
            runs |= with_seeds(f"sensitivity_{p['name']}_{end}", "scatter_mini.toml", [*held, f"{p['key']}={p[end]}"], options.seeds)
    runs |= with_seeds("sensitivity_laboratory", "scatter_mini.toml", ["pair.0.restitution=0.71"], options.seeds)
    summaries = Bench(options).run_all(runs)
    found = {p["name"]: {end: spreads(summaries, f"sensitivity_{p['name']}_{end}", options.seeds, SCATTERING)
                         for end in ("min", "max")} for p in asked["parameter"]}
    laboratory = spreads(summaries, "sensitivity_laboratory", options.seeds, SCATTERING)
    rows = [{"parameter": p["name"], "value": p[end], **row_of(found[p["name"]][end])}
            for p in asked["parameter"] for end in ("min", "max")]
    rows.append({"parameter": "calibrated", "value": "", **row_of(laboratory)})
    draw(asked["parameter"], found, laboratory, options.work / "sensitivity.png")
    save_means(options, "sensitivity", summaries, rows, effects=found, laboratory=laboratory)


def draw(parameters, found, laboratory, path):
    """Bars for both ends of each parameter, blue for the highest as in the thesis, and a line for the laboratory."""
    drawn, panels = pyplot.subplots(2, 2, figsize=(8.0, 5.6), layout="constrained")
    for axes, figure in zip(panels.flat, SCATTERING):
        name, factor = UNITS[figure]
        for shift, end, colour in ((-0.18, "max", "tab:blue"), (0.18, "min", "tab:orange")):
            for place, p in enumerate(parameters):
                value = found[p["name"]][end][figure]
                if value["mean"] is None:
                    axes.text(place + shift, 0.02, "none", transform=axes.get_xaxis_transform(), ha="center", va="bottom",
                              rotation=90, fontsize=8, color=colour)
                    continue
                axes.bar(place + shift, factor * value["mean"], 0.34, yerr=factor * (value["standard_error"] or 0.0), color=colour,
                         alpha=0.8, capsize=3, label=f"{end}imum" if place == 1 else None)
        if laboratory[figure]["mean"] is not None:
            axes.axhline(factor * laboratory[figure]["mean"], color="black", linestyle="--", linewidth=1.0, label="calibrated")
        axes.set_xticks(range(len(parameters)), [p["name"].replace("_", "\n") for p in parameters], fontsize=8)
        axes.set_ylabel(name)
        if figure.endswith("count"):
            axes.set_yscale("log")
    drawn.get_layout_engine().set(rect=(0.0, 0.0, 1.0, 0.95))  # room for the legend
    drawn.legend(*panels[0, 0].get_legend_handles_labels(), loc="upper center", ncol=3, fontsize=8)
    drawn.savefig(path, dpi=110)
    pyplot.close(drawn)
