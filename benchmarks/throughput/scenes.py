"""What is run: a box of settled grains or the small discharge test, as decks of repose and data files of its peers."""

import json
import pathlib
import sys
import tomllib
from dataclasses import asdict, dataclass

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER.parents[1] / "tools" / "python")]
import liggghts_files  # noqa: E402
import repose  # noqa: E402

INPUTS = FOLDER / "inputs"
DISCHARGE_DECK = FOLDER.parents[1] / "input" / "discharge_mini.toml"
DENSITY = tomllib.loads(DISCHARGE_DECK.read_text())["material"][0]["density"]

LISTED = """
[[particles]]
type = "csv"
file = "{grains}"

[time]
step = {dt!r}

[output]
series_interval = 1e3
"""


@dataclass
class Scene:
    """A folder with grains.csv for repose and grains.data for LIGGGHTS and LAMMPS, and what is around the grains."""
    kind: str  # "bed" or "discharge"
    folder: str
    count: int
    dt: float  # s
    largest: float  # m, diameter
    half: float = 0.0  # m, half the edge of the box
    height: float = 0.0  # m, of the domain

    def save(self):
        pathlib.Path(self.folder, "scene.json").write_text(json.dumps(asdict(self), indent=1))

    @staticmethod
    def load(folder):
        return Scene(**json.loads(pathlib.Path(folder, "scene.json").read_text()))

    def write_deck(self, path, phases):
        """A deck with the grains' list and the given text for its phases."""
        text = (INPUTS / "bed.toml" if self.kind == "bed" else DISCHARGE_DECK).read_text()
        if self.kind == "discharge":
            text = text[:text.index("[[particles]]")] + "[measurement.discharge]\norifice_height = 0.0\n"
        grains = pathlib.Path(self.folder, "grains.csv")
        path.write_text(text + LISTED.format(grains=grains, dt=self.dt) + phases)
        return str(path)

    def overrides(self, tilted=False):
        """The size of the box and the direction of gravity, as key=value."""
        if self.kind == "discharge":
            return []
        h = self.half
        values = [f"domain.min=[{-2 * h},{-2 * h},-0.001]", f"domain.max=[{2 * h},{2 * h},{self.height}]"]
        for axis, (x, y) in {"x": (1, 0), "y": (0, 1)}.items():
            values += [f"wall.{axis}_low.point=[{-x * h},{-y * h},0]", f"wall.{axis}_high.point=[{x * h},{y * h},0]"]
        if tilted:
            values.append(f"gravity=[{9.81 * 0.5**0.5},0,{-9.81 * 0.5**0.5}]")
        return values

    def bounds(self):
        """Of the domain, for the data files."""
        if self.kind == "discharge":
            return [(-0.03, 0.03), (-0.03, 0.03), (-0.021, 0.06)]
        return [(-self.half - 1e-3, self.half + 1e-3)] * 2 + [(-1e-3, self.height)]

    def write_grains(self, position, velocity, radius):
        """No contact history and no spin: all programs start alike."""
        write_list(pathlib.Path(self.folder, "grains.csv"), position, velocity, radius)
        write_data(pathlib.Path(self.folder, "grains.data"), self.bounds(), position, velocity, radius)


def set_options(overrides):
    """Words of the command line that override keys of a deck."""
    return [word for value in overrides for word in ("--set", value)]


def write_list(path, position, velocity, radius):
    with open(path, "w") as file:
        file.write("x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n")
        for x, v, r in zip(position.tolist(), velocity.tolist(), radius.tolist()):
            file.write(",".join(map(repr, x + v)) + f",0,0,0,{r!r},carbohsp\n")


def write_data(path, bounds, position, velocity, radius, kind=1):
    at_rest = [0, 0, 0]  # no spin
    grains = zip(radius.tolist(), position.tolist(), velocity.tolist())
    liggghts_files.write_data(path, bounds, 2, ((kind, r, DENSITY, x, v, at_rest) for r, x, v in grains))


def read_snapshot(folder, which=-1):
    """Position, velocity and radius in one of a run's snapshots, in the order of time."""
    snapshot = repose.Run(folder).snapshots[which]
    return snapshot.position, snapshot.velocity, snapshot.radius
