"""Makes the starting states with repose and keeps them: settled beds, the same beds in motion, the discharge test."""

import math
import pathlib
import shutil
import subprocess

import numpy as np

import vessel
from scenes import DENSITY, DISCHARGE_DECK, Scene, read_snapshot, set_options, write_data

DIAMETERS = {"mono": (440e-6, 440e-6), "range": (208e-6, 724e-6)}  # smallest and largest, m
STEP_440 = 5e-6  # s, time step of grains of 440 um; goes with the diameter
DEPTH = 20       # of a settled bed, in mean grains
SOLID = 0.57     # its solid fraction, roughly
FLOW_TIME = 20e-3  # s of tilted gravity before a moving bed is measured
SPEED = 0.1        # m/s, random, mixes the falling grains

SETTLE = """
[[phase]]
name = "settle"
until = "kinetic_energy"
kinetic_energy = {energy}
min_time = 0.06
max_time = 0.3
"""
FLOW = """
[[phase]]
name = "flow"
until = "time"
time = {time}
"""


def repose(program, scene, phases, tilted=False):
    """Runs a scene with the given phases; the output folder."""
    output = pathlib.Path(scene.folder, "making")
    deck = scene.write_deck(pathlib.Path(scene.folder, "making.toml"), phases)
    run(program, deck, output, scene.overrides(tilted))
    return output


def run(program, deck, output, overrides):
    """`program` is a list: repose, or mpirun and its options before it."""
    subprocess.run(["nice", *program, "run", deck, "--output", output, "--restart", *set_options(overrides)], check=True)


def settled(work, program, size, sizes):
    """The scene of a settled bed, made unless it is there."""
    folder = work / f"settled_{sizes}_{size}"
    if (folder / "scene.json").exists():
        return Scene.load(folder)
    folder.mkdir(parents=True, exist_ok=True)
    smallest, largest = DIAMETERS[sizes]
    random = np.random.default_rng(1)
    # The logarithm of the diameter is uniform: as many grains between 200 and 300 um as between 400 and 600.
    radius = 0.5 * np.exp(random.uniform(math.log(smallest), math.log(largest), size))
    volume = 4.0 / 3.0 * math.pi * float(np.sum(radius**3))
    depth = DEPTH * (6.0 * volume / (math.pi * size)) ** (1.0 / 3.0)
    half = 0.5 * math.sqrt(volume / (SOLID * depth))
    position = loose_lattice(random, size, 1.25 * largest, largest, half)
    scene = Scene("bed", str(folder), size, STEP_440 * smallest / DIAMETERS["mono"][0], largest, half,
                  float(position[:, 2].max()) + 2e-3)
    scene.write_grains(position, random.uniform(-SPEED, SPEED, (size, 3)), radius)
    mass = DENSITY * volume / size
    position, _, radius = read_snapshot(repose(program, scene, SETTLE.format(energy=mass * 1e-7)))
    return finish(scene, position, np.zeros_like(position), radius)


def loose_lattice(random, count, spacing, largest, half):
    """A cubic lattice between the walls, each site moved at random within the free gap."""
    per_edge = int((2 * half - largest) / spacing) + 1
    pitch = (2 * half - largest) / max(per_edge - 1, 1)
    site = np.arange(count)
    layer, rest = np.divmod(site, per_edge**2)
    gap = 0.5 * (spacing - largest)
    position = np.column_stack([rest % per_edge * pitch, rest // per_edge * pitch, layer * spacing])
    position += random.uniform(-gap, gap, position.shape)
    position[:, :2] = np.clip(position[:, :2] - (half - 0.5 * largest), 0.5 * largest - half, half - 0.5 * largest)
    position[:, 2] += 0.5 * largest + gap
    return position


def moving(work, program, size, sizes):
    """The settled bed after some time under gravity tilted by 45 degrees, with its velocities."""
    rest = settled(work, program, size, sizes)
    folder = work / f"moving_{sizes}_{size}"
    if (folder / "scene.json").exists():
        return Scene.load(folder)
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(pathlib.Path(rest.folder, "grains.csv"), folder)
    scene = Scene(**{**vars(rest), "folder": str(folder)})
    output = repose(program, scene, FLOW.format(time=FLOW_TIME), tilted=True)
    return finish(scene, *read_snapshot(output))


def discharge(work, program, segment):
    """The discharge test: the loose column at its start, or (segment) settled, before the lid goes."""
    folder = work / ("discharge_segment" if segment else "discharge")
    if (folder / "scene.json").exists():
        return Scene.load(folder)
    folder.mkdir(parents=True, exist_ok=True)
    overrides = ["phase.discharge.time=1e-5", "output.snapshot_times=[5e-6,0.25]"]
    if not segment:
        overrides.append("phase.fill.time=5e-6")
    run(program, DISCHARGE_DECK, folder / "making", overrides)
    position, velocity, radius = read_snapshot(folder / "making", 0)
    if segment:
        position, velocity, radius = read_snapshot(folder / "making", 1)
    scene = Scene("discharge", str(folder), len(radius), STEP_440, DIAMETERS["mono"][1])
    vessel.write_mesh(folder / "vessel.stl")
    rim, rim_radius = vessel.rim()
    write_data(folder / "rim.data", scene.bounds(), rim, np.zeros_like(rim), rim_radius, kind=2)
    return finish(scene, position, velocity, radius)


def finish(scene, position, velocity, radius):
    scene.write_grains(position, velocity, radius)
    scene.save()
    shutil.rmtree(pathlib.Path(scene.folder, "making"))
    return scene
