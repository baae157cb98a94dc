"""How each program runs a scene: its command line, and what it says about the run afterwards."""

import math
import pathlib
import re
import tomllib

from scenes import INPUTS, repose, set_options

PHASES = """
[[phase]]
name = "relax"
until = "steps"
steps = {relax}

[[phase]]
name = "measure"
until = "steps"
steps = {steps}
"""
# Of the peers' neighbour lists; README.md has the figures.
SKIN = 44e-6  # m
BIN = 1.2     # edge of the cells of their search, in diameters of the largest grain


class Repose:
    def __init__(self, name, executable):
        self.name, self.executable = name, executable

    def command(self, scene, case, relax, steps, folder):
        phases = PHASES.format(relax=relax, steps=steps)
        if case == "discharge_mini":
            phases += 'remove_walls = ["lid"]\n'
        sets = set_options(scene.overrides(tilted=case == "moving"))
        deck = scene.write_deck(folder.with_suffix(".toml"), phases)
        return [self.executable, "run", deck, "--output", str(folder), "--quiet", *sets]

    def figures(self, folder):
        """Loop seconds of the steps that were asked for, kinetic energy and grains kept at the end."""
        run = repose.Run(folder)
        summary, energy = run.summary, float(run.series["translational_energy_J"][-1])
        figures = {"kinetic_energy_J": energy, "wall_seconds": summary["wall_seconds"],
                   "vector_level": summary["build"]["vector_level"],
                   "inside": summary["particles"]["inside"], **summary["timing"]}
        if summary["retained_mass_kg"] is not None and summary["discharged_mass_kg"] is not None:
            total = summary["retained_mass_kg"] + summary["discharged_mass_kg"]
            figures["kept"] = round(summary["particles"]["inserted"] * summary["retained_mass_kg"] / total)
        return figures


class Peer:
    """LIGGGHTS or LAMMPS: an input script of this folder with variables."""

    def __init__(self, name, executable):
        self.name, self.executable = name, executable
        self.kind = "lammps" if name == "lammps" else "liggghts"

    def command(self, scene, case, relax, steps, folder):
        values = {**coefficients(), "inputs": INPUTS, "data": f"{scene.folder}/grains.data",
                  "mesh": f"{scene.folder}/vessel.stl", "rim": f"{scene.folder}/rim.data", "dt": scene.dt,
                  "half": scene.half, "gx": int(case == "moving"), "relax": relax, "steps": steps,
                  "skin": SKIN, "bin": BIN * scene.largest}
        script = INPUTS / f"{'discharge' if scene.kind == 'discharge' else 'bed'}.{self.kind}"
        variables = [word for key, value in values.items() for word in ("-var", key, str(value))]
        return [self.executable, "-in", str(script), "-log", str(pathlib.Path(folder, "log")), *variables]

    def figures(self, folder):
        log = pathlib.Path(folder, "log").read_text()
        rows = re.findall(r"^\s*Step\s+Atoms\s+KinEng.*\n((?:\s*\d+\s.*\n)+)Loop time of (\S+)", log, re.MULTILINE)
        last = rows[-1][0].splitlines()[-1].split()
        figures = {"loop_seconds": float(rows[-1][1]), "inside": int(last[1]), "kinetic_energy_J": float(last[2])}
        figures["dangerous_builds"] = sum(map(int, re.findall(r"^Dangerous builds = (\d+)", log, re.MULTILINE)))
        kept = re.search(r"^kept (\d+)", log, re.MULTILINE)
        return {**figures, "kept": int(kept[1])} if kept else figures


def coefficients():
    """The deck's material as the peers' variables."""
    deck = tomllib.loads((INPUTS / "bed.toml").read_text())
    young, nu = deck["material"][0]["youngs_modulus"], deck["material"][0]["poisson_ratio"]
    values = {"young": young, "poisson": nu}
    for name, pair in zip(("grain", "wall"), deck["pair"]):
        values |= {f"e_{name}": pair["restitution"], f"mu_{name}": pair["sliding_friction"],
                   f"mu_r_{name}": pair["rolling_friction"]}
    # LAMMPS: tangential over normal damping as in LIGGGHTS, the root of the stiffnesses' ratio; and a rolling spring
    # as stiff as the tangential one at a typical overlap of 1e-3 diameters of 440 um.
    shear = young / (4.0 * (2.0 - nu) * (1.0 + nu))
    return {**values, "xt": math.sqrt(2.0 * (1.0 - nu) / (2.0 - nu)), "k_r": 8.0 * shear * math.sqrt(110e-6 * 0.44e-6)}


def make(name, executable):
    return Repose(name, executable) if name == "repose" else Peer(name, executable)
