#!/usr/bin/python3
"""Heat from plates into a moving bed over its speed, beside published correlations; see README.md."""

import json
import math
import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, print_table, save, usual_options  # noqa: E402  (and where the package is)
import repose  # noqa: E402
from repose.plots.style import new_figure, styled  # noqa: E402
from repose.program import call, set_options  # noqa: E402

INPUT = ROOT / "input"
SPEEDS = (5e-3, 10e-3, 20e-3, 40e-3)  # m/s
WAY = 30e-3  # m, of the piston
PLATE, DEPTH, HALF_GAP, DIAMETER = 20e-3, 2.64e-3, 2.5e-3, 440e-6  # m, of the deck
INLET, WALL = 300.0, 350.0  # K
FILM = 0.5 * (INLET + WALL)
CORE = {"box.min": [-2.06e-3, 0.0, -18e-3], "box.max": [2.06e-3, DEPTH, -2e-3]}  # of the bed between the plates


def exchange(options, speed):
    """The run with that speed, at the end of which the piston is half a plate's length below the plates."""
    output = options.work / f"{1e3 * speed:g}_mm_s"
    return repose.run(INPUT / "moving_bed_exchanger.toml", output, program=options.program, restart=True,
                      set={"wall.piston.motion.0.velocity": [0.0, 0.0, -speed], "phase.sink.time": WAY / speed})


FILM_ALONE = {"temperature.min": FILM, "temperature.max": FILM, "temperature.count": 1}


def air(options):
    """Conductivity and free path of air at the mean temperature."""
    output = options.work / "air"
    call(["thermal", "bed", INPUT / "thermal_bed_carbohsp.toml", "--output", output, *set_options(FILM_ALONE)],
         program=options.program)
    row = json.loads((output / "bed.json").read_text())["conductivity"][0]
    return {"conductivity": row["air_conductivity_W_mK"], "free_path": row["free_path_m"]}


def bed_of(options, run):
    """Porosity, conductivity by its network and volumetric heat of the bed between the plates."""
    output = options.work / "network"
    material = run.deck["material"][0]
    own = {"box.periodic": ["y"], "material.0.stiffness_ratio": material["stiffness_ratio"]}
    call(["thermal", "network", run.snapshot_paths[-1], "--deck", INPUT / "thermal_network.toml", "--output", output,
          *set_options(FILM_ALONE | CORE | own)], program=options.program)
    bed, = json.loads((output / "network.json").read_text())["beds"]
    return {"porosity": bed["porosity"], "conductivity": bed["conductivity"][0]["conductivity_W_mK"],
            "heat": (1.0 - bed["porosity"]) * material["density"] * material["specific_heat"]}


def measured(run, speed):
    """Coefficients in W/(m2 K) while the piston moves on below the plates."""
    walls = run.walls
    end = walls["time_s"][-1]
    begin = end - (WAY - PLATE) / speed
    late = walls["time_s"] >= begin - 1e-9
    times = walls["time_s"][late]
    given = sum(walls[f"{side}_plate_heat_J"][late] for side in ("left", "right"))
    halves = [(given[b] - given[a]) / (times[b] - times[a])
              for a, b in ((0, len(times) // 2), (len(times) // 2, -1))]
    power = (given[-1] - given[0]) / (times[-1] - times[0])
    area = 2.0 * PLATE * DEPTH
    snapshot = run.snapshots[-1]
    between = (snapshot.position[:, 2] > -PLATE) & (snapshot.position[:, 2] < 0.0)
    flow = snapshot.mass[between].sum() / PLATE * speed
    outlet = INLET + power / (flow * run.deck["material"][0]["specific_heat"])
    mean = (outlet - INLET) / math.log((WALL - INLET) / (WALL - outlet))
    return {"speed": speed, "contact_time": PLATE / speed, "flow": flow / (2.0 * HALF_GAP * DEPTH),
            "outlet": outlet, "overall": power / area / mean, "coefficient": power / area / (WALL - INLET),
            "unsteadiness": halves[1] / halves[0] - 1.0}


def penetration(bed, time):
    """Mean over the time of a half space that is suddenly as warm as the wall, W/(m2 K)."""
    return 2.0 / math.sqrt(math.pi) * math.sqrt(bed["conductivity"] * bed["heat"] / time)


def at_wall_schluender(gas, deck):
    """VDI Heat Atlas, section M6: from a wall into the first layer of grains, smooth surfaces that cover 80 % of it."""
    ratio = 2.0 * gas["free_path"] / DIAMETER
    grain = 4.0 * gas["conductivity"] / DIAMETER * ((1.0 + ratio) * math.log(1.0 + 1.0 / ratio) - 1.0)
    beside = 2.0 * gas["conductivity"] / DIAMETER / (math.sqrt(2.0) + ratio)
    radiation = 4.0 * 5.670374e-8 * FILM ** 3 / (sum(1.0 / m["emissivity"] for m in deck["material"]) - 1.0)
    return 0.8 * grain + 0.2 * beside + radiation


def at_wall_sullivan_sabersky(gas):
    """Sullivan and Sabersky 1975: a gap of air of 0.085 diameters, fitted to their measurements."""
    return gas["conductivity"] / (0.085 * DIAMETER)


def in_series(first, second):
    return 1.0 / (1.0 / first + 1.0 / second)


def row_of(run, speed, bed, wall):
    row = measured(run, speed) | {"bed": bed}
    inside = penetration(bed, row["contact_time"])
    return row | {name: in_series(at_wall, inside) for name, at_wall in wall.items()} | {
        "at_wall": 1.0 / (1.0 / row["coefficient"] - 1.0 / inside)}


def over(row, correlation):
    return f"{100.0 * (row['coefficient'] / row[correlation] - 1.0):+.0f}"


def table(rows):
    return [{"speed, mm/s": f"{1e3 * row['speed']:g}", "porosity": row["bed"]["porosity"],
             "k, W/(m K)": row["bed"]["conductivity"], "flow, kg/(m² s)": row["flow"],
             "outlet, K": f"{row['outlet']:.1f}", "overall U, W/(m² K)": row["overall"], "h, W/(m² K)": row["coefficient"],
             "Sullivan and Sabersky": row["sullivan_sabersky"],
             "h over it, %": over(row, "sullivan_sabersky"),
             "Schlünder": row["schluender"], "h over it, % ": over(row, "schluender"),
             "at the wall, W/(m² K)": row["at_wall"]} for row in rows]


@styled
def picture(rows):
    figure, axes = new_figure()
    speeds = [1e3 * row["speed"] for row in rows]
    for key, label, style in (("schluender", "Schlünder, VDI Heat Atlas M6", "--"),
                              ("sullivan_sabersky", "Sullivan and Sabersky 1975", "-")):
        axes.plot(speeds, [row[key] for row in rows], style, color="0.3", label=label)
    axes.plot(speeds, [row["coefficient"] for row in rows], "o", color="C3", label="repose")
    axes.set_xscale("log")
    axes.set_xticks(speeds, [f"{v:g}" for v in speeds])
    axes.minorticks_off()
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("speed of the bed, mm/s")
    axes.set_ylabel("heat transfer coefficient, W/(m² K)")
    axes.legend()
    return figure


def main():
    parser = usual_options(__doc__, "heat_exchanger")
    parser.add_argument("--at-a-time", type=int, default=2, help="runs, each on one core")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(options.at_a_time) as pool:
        runs = list(pool.map(lambda speed: exchange(options, speed), SPEEDS))
    gas = air(options)
    wall = {"schluender": at_wall_schluender(gas, runs[0].deck), "sullivan_sabersky": at_wall_sullivan_sabersky(gas)}
    rows = [row_of(run, speed, bed_of(options, run), wall) for run, speed in zip(runs, SPEEDS)]
    print_table(table(rows))
    save(options.results / "exchanger.json", rows=rows, air=gas, wall=wall)
    picture(rows).savefig(options.results / "exchanger.png", dpi=200)


if __name__ == "__main__":
    main()
