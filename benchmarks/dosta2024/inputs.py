"""Makes what the decks and the scripts of LIGGGHTS read, from the published coordinates."""

import gzip
import pathlib
import shutil
import sys

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER.parents[1] / "tools" / "python")]
import liggghts_files  # noqa: E402
import repose  # noqa: E402,F401  (for the modules beside this one)
from liggghts_files import write_stl  # noqa: E402

COORDINATES = FOLDER / "coordinates"
CASES = ("penetration", "drum", "silo")
DENSITY = {"M1": 2500.0, "M2": 2000.0, "steel": 7200.0}  # kg/m3, as in the decks
BALL = ((0.0, 0.0, 0.06), (0.0, 0.0, -5.0), 0.01)        # m, m/s, m, as in penetration.toml
DRUM_MESH = 'type = "mesh"\nmaterial = "steel"\nfile = "drum.stl"\n'


def read_table(name, columns):
    """The rows of a published table below its header line; shorter lines are no rows."""
    with gzip.open(COORDINATES / f"{name}.txt.gz", "rt") as file:
        rows = [line.split() for line in file.readlines()[1:]]
    return np.array([row for row in rows if len(row) == columns], dtype=float)


def grains(case):
    """Position, radius and material of the grains of a case, in the published order."""
    table = read_table(case, 4)
    return table[:, 1:], table[:, 0], np.where(table[:, 0] > 0.0015, "M2", "M1")


def drum_triangles():
    return read_table("drum_walls", 9).reshape(-1, 3, 3).tolist()


def write_csv(path, position, radius, material):
    with open(path, "w") as file:
        file.write("x,y,z,radius,material\n")
        for x, r, name in zip(position.tolist(), radius.tolist(), material):
            file.write(",".join(map(repr, x)) + f",{r!r},{name}\n")


def write_data(path, bounds, position, velocity, radius, material):
    """The grains for LIGGGHTS, at rest or with velocities; types as in liggghts/model.liggghts."""
    kind = {name: number for number, name in enumerate(DENSITY, 1)}
    at_rest = [0, 0, 0]  # no spin
    grains = zip(radius.tolist(), position.tolist(), velocity.tolist(), material)
    liggghts_files.write_data(path, list(zip(*bounds)), len(DENSITY),
                              ((kind[name], r, DENSITY[name], x, v, at_rest) for r, x, v, name in grains))


def with_ball(position, radius, material):
    """The grains of the penetration and the ball: position, velocity, radius, material."""
    x, v, r = BALL
    velocity = np.vstack([np.zeros_like(position), v])
    return np.vstack([position, x]), velocity, np.append(radius, r), np.append(material, "steel")


def with_mesh(text):
    """The drum's deck with the triangles in the place of the closed form."""
    begin = text.index('type = "profile"')
    end = text.index("\n", text.index("axis_direction", begin)) + 1
    return text[:begin] + DRUM_MESH + text[end:]


def from_snapshot(text, file):
    """The silo's deck from a settled state on: its grains are a snapshot, its only phase the discharge."""
    begin, end = text.index("[[particles]]"), text.index("[time]")
    settle, discharge = text.index("[[phase]]"), text.rindex("[[phase]]")
    grains_block = f'[[particles]]\ntype = "snapshot"\nfile = "{file}"\n\n'
    return text[:begin] + grains_block + text[end:settle] + text[discharge:]


def prepare(folder):
    """Decks with all that they read, in one folder: penetration.toml, drum.toml, drum_mesh.toml, silo.toml."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for case in CASES:
        shutil.copy(FOLDER / f"{case}.toml", folder)
    for case in ("penetration", "drum"):
        write_csv(folder / f"{case}.csv", *grains(case))
    write_stl(folder / "drum.stl", drum_triangles())
    (folder / "drum_mesh.toml").write_text(with_mesh((FOLDER / "drum.toml").read_text()))
