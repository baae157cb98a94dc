"""Questions of the thesis at reduced size: which parameters matter, what a larger orifice does, where sand clogs, how dense
beds lie."""

import statistics
import tomllib

import matplotlib

import contours
from bench import ROOT, Bench, flat_floor, print_table, repose, save, vessel, with_seeds

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

FIGURES = ("discharged_mass_kg", "angle_of_repose_deg", "scattering.area_1.count", "scattering.area_3.count")


def spread(summaries, name, seeds, figure):
    """Mean and standard error of a figure over the seeds that have it, and how many have."""
    values = [repose.files.number_in(summaries[f"{name}_{seed}"], figure) for seed in range(1, seeds + 1)]
    values = [value for value in values if value is not None]
    error = statistics.stdev(values) / len(values) ** 0.5 if len(values) > 1 else None
    return {"mean": statistics.mean(values) if values else None, "standard_error": error, "runs": len(values)}


def identities(summaries):
    """What tells a run from any other."""
    return {name: {"state_hash": s["state_hash"], "steps": s["steps"], "particles": s["particles"]["inserted"]}
            for name, s in summaries.items()}


def shown(value, factor):
    if value["mean"] is None:
        return "none"
    error = "" if value["standard_error"] is None else f" +- {factor * value['standard_error']:.2g}"
    return f"{factor * value['mean']:.4g}{error}"


UNITS = {"discharged_mass_kg": ("discharged, g", 1e3), "angle_of_repose_deg": ("angle, degrees", 1.0),
         "scattering.area_1.count": ("area 1", 1.0), "scattering.area_3.count": ("area 3", 1.0)}


def row_of(spreads):
    return {name: shown(spreads[figure], factor) for figure, (name, factor) in UNITS.items() if figure in spreads}


# Sensitivity -----------------------------------------------------------------------------------------------------------------

def sensitivity(options):
    """Table 3.6 one at a time, drawn as Figures 3.9 and 3.10: each parameter at both ends of its range, the others held. The
    laboratory is the reduced test with the coefficients that the thesis found."""
    study = tomllib.loads((ROOT / "input" / "sensitivity_carbohsp.toml").read_text())
    held = [f"{p['key']}={p['fixed']}" for p in study["parameter"]]
    runs = {}
    for p in study["parameter"]:
        for end in ("min", "max"):
            runs |= with_seeds(f"sensitivity_{p['name']}_{end}", "scatter_mini.toml", [*held, f"{p['key']}={p[end]}"], options.seeds)
    runs |= with_seeds("sensitivity_laboratory", "scatter_mini.toml", ["pair.0.restitution=0.71"], options.seeds)
    summaries = Bench(options).run_all(runs)
    found = {p["name"]: {end: {f: spread(summaries, f"sensitivity_{p['name']}_{end}", options.seeds, f) for f in FIGURES}
                         for end in ("min", "max")} for p in study["parameter"]}
    laboratory = {f: spread(summaries, "sensitivity_laboratory", options.seeds, f) for f in FIGURES}
    rows = [{"parameter": p["name"], "value": p[end], **row_of(found[p["name"]][end])}
            for p in study["parameter"] for end in ("min", "max")]
    rows.append({"parameter": "calibrated", "value": "", **row_of(laboratory)})
    draw_sensitivity(study["parameter"], found, laboratory, options.results / "sensitivity.png")
    save(options.results / "sensitivity.json", seeds=options.seeds, effects=found, laboratory=laboratory,
         runs=identities(summaries), rows=rows)
    print_table(rows)


def draw_sensitivity(parameters, found, laboratory, path):
    """Bars for both ends of each parameter, blue for the highest as in the thesis, and a line for the laboratory."""
    drawn, panels = pyplot.subplots(2, 2, figsize=(8.0, 5.6), layout="constrained")
    for axes, figure in zip(panels.flat, FIGURES):
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
    drawn.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=3, fontsize=8)
    drawn.savefig(path, dpi=150)
    pyplot.close(drawn)


# The hot orifice -------------------------------------------------------------------------------------------------------------

STEEL = 17e-6  # 1/K: linear expansion of an austenitic steel; the thesis names none
DIAMETERS = (5.0, 5.05, 5.2, 5.5)  # mm: cold, at 600 degrees, and larger still so that the trend stands out of the scatter


def orifice(options):
    """Section 4.2: the hole of the reduced scattering test as it grows with temperature, nothing else changed."""
    runs = {}
    for diameter in DIAMETERS:
        radius = 0.5e-3 * diameter
        sets = [f"wall.vessel.points=[[0.006, 0.06], [0.006, 0.0], [{radius:.6g}, 0.0]]", f"wall.lid.radius={radius:.6g}",
                "pair.0.restitution=0.71"]
        runs |= with_seeds(f"orifice_{diameter:g}", "scatter_mini.toml", sets, options.seeds)
    summaries = Bench(options).run_all(runs)
    figures = (*FIGURES, "discharge_rate_kg_s")
    found = {f"{d:g}": {f: spread(summaries, f"orifice_{d:g}", options.seeds, f) for f in figures} for d in DIAMETERS}
    rows = [{"diameter, mm": d, "warmer by, K": (d / DIAMETERS[0] - 1.0) / STEEL, **row_of(found[f"{d:g}"]),
             "rate, g/s": shown(found[f"{d:g}"]["discharge_rate_kg_s"], 1e3)} for d in DIAMETERS]
    save(options.results / "orifice.json", seeds=options.seeds, expansion_1_K=STEEL, found=found, runs=identities(summaries), rows=rows)
    print_table(rows)


# Clogging --------------------------------------------------------------------------------------------------------------------

CORNERS = ((0.3, 0.4), (0.5, 0.4), (0.3, 0.6), (0.5, 0.6), (0.6, 0.6), (0.5, 0.7), (0.7, 0.7), (0.9, 0.9))  # sliding, rolling friction


def clogging(options):
    """Section 3.5: with which friction multi-size sand plugs the hole of 5 mm, in a vessel of 8 mm radius with 3 g."""
    runs = {}
    for sliding, rolling in CORNERS:
        runs |= with_seeds(f"clogging_{sliding}_{rolling}", "sand_multi.toml",
                           [*contours.SMALL_SAND, f"pair.0.sliding_friction={sliding}", f"pair.0.rolling_friction={rolling}"], options.seeds)
    summaries = Bench(options).run_all(runs)
    rows = []
    for sliding, rolling in CORNERS:
        own = [summaries[f"clogging_{sliding}_{rolling}_{seed}"] for seed in range(1, options.seeds + 1)]
        rows.append({"sliding": sliding, "rolling": rolling, "plugged": f"{sum(s['plugged'] for s in own)} of {len(own)}",
                     "discharged, g": shown(spread(summaries, f"clogging_{sliding}_{rolling}", options.seeds, "discharged_mass_kg"), 1e3)})
    save(options.results / "clogging.json", seeds=options.seeds, runs=identities(summaries), rows=rows)
    print_table(rows)


# Bulk density ----------------------------------------------------------------------------------------------------------------

SETTLE = ["phase.discharge.min_time=0.001", "phase.discharge.max_time=0.002",  # the bed alone
          'measurement.bulk_density={min=["-5 mm", "-5 mm", "1.5 mm"], max=["5 mm", "5 mm", "12 mm"]}']
TALL = vessel("8 g", flat_floor(0.011, 0.067), 0.03)
BEDS = {  # deck and overrides
    "CarboHSP, one size": ("carbohsp_mono.toml", []),
    "falls from 200 mm": ("carbohsp_mono.toml", ["particles.0.velocity=[0.0, 0.0, -2.0]"]),
    "friction 0.1 and 0.1": ("carbohsp_mono.toml", ["pair.0.sliding_friction=0.1", "pair.0.rolling_friction=0.1"]),
    "friction 0.9 and 0.5": ("carbohsp_mono.toml", ["pair.0.sliding_friction=0.9", "pair.0.rolling_friction=0.5"]),
    "ten times as stiff": ("carbohsp_mono.toml", ["material.0.youngs_modulus=5e7", "material.1.youngs_modulus=5e7"]),
    "CarboHSP, many sizes": ("carbohsp_multi.toml", []),
    "sand, many sizes": ("sand_multi.toml", []),
}


def bulk_density(options):
    """Of a settled bed of 8 g in a cylinder of 11 mm: what filling, friction, stiffness and sizes do to it."""
    runs = {f"bed_{k}": (deck, [*TALL, *(["particles.0.spacing=600 um"] if "mono" in deck else []), *SETTLE, *own])
            for k, (deck, own) in enumerate(BEDS.values())}
    summaries = Bench(options).run_all(runs)
    rows = [{"bed": name, "bulk density, kg/m3": summaries[f"bed_{k}"]["bulk_density_kg_m3"], "porosity": summaries[f"bed_{k}"]["porosity"]}
            for k, name in enumerate(BEDS)]
    save(options.results / "bulk_density.json", runs=identities(summaries), rows=rows)
    print_table(rows, digits=4)
