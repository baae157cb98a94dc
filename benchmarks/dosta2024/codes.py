"""How each program runs a case."""

import sys
import tomllib

import numpy as np

from inputs import FOLDER, drum_triangles, from_snapshot, grains, repose as package, with_ball, write_data
from liggghts_files import turned, write_stl

sys.path.insert(0, str(FOLDER.parent / "throughput"))
import measure  # noqa: E402
import peers  # noqa: E402

SKIN = {"penetration": 0.6e-3, "drum": 0.2e-3, "silo": 0.4e-3}     # m, of the lists of LIGGGHTS; README.md says why
SAMPLES = {"penetration": 0.1e-3, "drum": 0.2e-3, "silo": 0.5e-3}  # s, between the rows of its log
LENGTH = {"penetration": "impact", "drum": "turn", "drum_mesh": "turn", "silo": "discharge"}  # phase of each deck
# Orifice radius in m: height of the lip. The cone has 45 degrees, the cylinder above it a height of 0.3 m.
LIP = {0.03: -0.0554222, 0.02: -0.0593008}
STEP = {"M1": 1.5e-6, "M2": 2e-6}  # s, of the silo


def silo_points(orifice):
    top = LIP[orifice] + 0.1 - orifice
    return [[orifice, LIP[orifice]], [0.1, top], [0.1, top + 0.3]]


def silo_overrides(args):
    """The silo's other orifice, material and number of grains, as key=value."""
    points = silo_points(args.orifice)
    return [f"wall.silo.points={points}", f"wall.lid.centre=[0,0,{LIP[args.orifice]}]",
            f"wall.lid.radius={args.orifice}", f"measurement.discharge.orifice_height={LIP[args.orifice]}",
            f"time.step={STEP[args.material]}"]


def settled_silo(args, folder):
    """The snapshot of the silo's grains at rest, made unless it is there."""
    top = silo_points(args.orifice)[1][1]
    overrides = [*silo_overrides(args), f"particles.0.material={args.material}", f"particles.0.count={args.count}",
                 f"particles.0.centre=[0,0,{top}]", f"phase.discharge.time={STEP[args.material]}"]
    output = folder / f"settled_{args.material}_{args.orifice}_{args.count}"
    if not (output / "summary.json").exists():
        run_repose(args, folder / "silo.toml", output, overrides)
    return package.Run(output).snapshot_paths[-1]


def log_of(output):
    return output.with_name(output.name + ".out")


def run_repose(args, deck, output, overrides):
    words = [word for value in overrides for word in ("--set", value)]
    command = [*measure.launcher(args.ranks), args.repose, "run", deck, "--output", output, *words]
    return measure.timed([str(word) for word in command], log_of(output))


def repose(args, folder, output):
    """Runs a case; the time it took."""
    overrides = [f"phase.{LENGTH[args.case]}.time={args.time}", *args.set]
    deck = folder / f"{args.case}.toml"
    if args.case == "silo":
        snapshot = settled_silo(args, folder)
        deck = folder / "silo_discharge.toml"
        deck.write_text(from_snapshot((folder / "silo.toml").read_text(), snapshot.relative_to(folder)))
        overrides += silo_overrides(args)
    return run_repose(args, deck, output, overrides)


def liggghts(args, folder, output):
    """Runs a case by its input script; the time it took."""
    output.mkdir(parents=True, exist_ok=True)
    case = args.case.removesuffix("_mesh")
    deck = tomllib.loads((folder / f"{case}.toml").read_text())
    dt = STEP[args.material] if case == "silo" else float(deck["time"]["step"].removesuffix(" us")) * 1e-6
    values = {"inputs": FOLDER / "liggghts", "data": output / "grains.data", "mesh": output / "wall.stl", "dt": dt,
              "skin": SKIN[case], "every": round(SAMPLES[case] / dt), "steps": round(args.time / dt),
              "lip": LIP[args.orifice]}
    write_inputs(args, case, folder, output, deck["domain"])
    words = [str(word) for key, value in values.items() for word in ("-var", key, value)]
    command = [*measure.launcher(args.ranks), args.liggghts, "-in", str(FOLDER / "liggghts" / f"{case}.liggghts"),
               "-log", str(output / "log"), *words]
    return measure.timed(command, log_of(output))


def write_inputs(args, case, folder, output, domain):
    if case == "silo":
        settled = package.Snapshot(settled_silo(args, folder))
        state = settled.position, settled.velocity, settled.radius, [args.material] * len(settled)
        write_stl(output / "wall.stl", turned(silo_points(args.orifice)))
    elif case == "drum":
        position, radius, material = grains(case)
        state = position, np.zeros_like(position), radius, material
        write_stl(output / "wall.stl", drum_triangles())
    else:
        state = with_ball(*grains(case))
    write_data(output / "grains.data", (domain["min"], domain["max"]), *state)


def version(args):
    return peers.version("liggghts-debian", args.liggghts)
