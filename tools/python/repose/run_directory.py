"""The directory of one run."""

import functools
import pathlib

from repose.contact_forces import ContactForces
from repose.contacts import Contacts
from repose.files import ReposeError, Table, number_in, read_json, read_rows, read_table, read_text, read_toml
from repose.snapshot import Snapshot, build_of

PICTURES = ("silhouette", "top_view")


def numbers_in(content, before=""):
    """Every number below a section, by its dotted name."""
    for key, value in content.items():
        if isinstance(value, dict):
            yield from numbers_in(value, f"{before}{key}.")
        elif value is None or (isinstance(value, (int, float)) and not isinstance(value, bool)):
            yield before + key, value


class Run:
    """What `repose run DECK --output DIR` has left in DIR, complete or not. Files are read when they are asked for."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        if not (self.directory / "deck.resolved.toml").exists():
            raise ReposeError(f"{directory}: is no directory of a run: it has no deck.resolved.toml")

    def __repr__(self):
        return f"<Run {self.directory}: {'complete' if self.is_complete else 'not complete'}>"

    @property
    def is_complete(self):
        """Whether the run has come to its end: summary.json is written then."""
        return (self.directory / "summary.json").exists()

    @functools.cached_property
    def summary(self):
        """summary.json as a dict; README.md lists its keys."""
        if not self.is_complete:
            raise ReposeError(f"{self.directory}: has no summary.json: the run is not complete")
        return read_json(self.directory / "summary.json")

    @property
    def title(self):
        """Of [run] in the deck."""
        return self.deck.get("run", {}).get("title", "")

    @functools.cached_property
    def deck(self):
        """deck.resolved.toml as a dict, with all defaults; SI units."""
        return read_toml(self.directory / "deck.resolved.toml")

    @property
    def deck_text(self):
        """deck.resolved.toml as it stands."""
        return read_text(self.directory / "deck.resolved.toml")

    @functools.cached_property
    def figures(self):
        """What was measured: every number of summary.json but those of the computation, by its name in decks
        (`discharged_mass_kg`, `scattering.area_1.count`). None: not measured, or not there to be measured."""
        computed = ("ranks", "steps", "time_s", "timestep_s", "restarts", "wall_seconds", "particle_steps_per_second",
                    "timing", "lists",
                    "parallel", "memory", "build", "particles")
        return dict(numbers_in({key: value for key, value in self.summary.items() if key not in computed}))

    def figure(self, name):
        """One figure by its name in decks, such as `angle_of_repose_deg` or `scattering.area_1.count`; in the unit at
        the end of its name (`_kg`, `_m`, `_s`, `_deg`: degrees), counts are numbers. None when it was not measured."""
        return number_in(self.summary, name)

    def error(self, name):
        """The standard error of a figure within this run, in its unit, for an angle of repose or a count; None for
        others. It does not have what differs from seed to seed."""
        if name.endswith(".count"):
            name = name[:-5] + "error"
        elif name.endswith("_deg"):
            name = name[:-4] + "_stderr_deg"
        else:
            return None
        try:
            return number_in(self.summary, name)
        except ReposeError:
            return None

    @property
    def is_plugged(self):
        """Whether the discharge has plugged; None when it was not measured."""
        return self.summary.get("plugged")

    def _table(self, name):
        path = self.directory / name
        if not path.exists() or not read_rows(path)[1]:
            return None
        return read_table(path)

    @property
    def series(self):
        """series.csv, as far as it is: `time_s`, energies in J, `discharged_mass_kg` and so on; None without rows."""
        return self._table("series.csv")

    @property
    def walls(self):
        """walls.csv: `<wall>_force_x_N` and `<wall>_torque_x_Nm` of every wall over `time_s`; None without rows."""
        return self._table("walls.csv")

    @property
    def surface_angle(self):
        """surface_angle.csv, the slope of the bed in a drum (degrees) over `time_s`; None when it was not asked for."""
        return self._table("surface_angle.csv")

    @property
    def shear(self):
        """shear.csv: `shear_stress_Pa` and `normal_stress_Pa` in the plane of a shear cell over `shear_time_s`, the time since its
        phase began; None when it was not asked for."""
        return self._table("shear.csv")

    @property
    def compression(self):
        """compression.csv: `stress_Pa`, `height_m` and `porosity` of a bed under a lid over `time_s`; None when it was not asked for."""
        return self._table("compression.csv")

    @property
    def flow_energy(self):
        """flow_energy.csv, force, torque and work of a blade over its way; None when it was not asked for."""
        return self._table("flow_energy.csv")

    @property
    def trace(self):
        """trace.csv: every particle every few steps, for small cases; None when it was not asked for."""
        return self._table("trace.csv")

    @property
    def snapshots(self):
        """List of `Snapshot`, in the order of time; their arrays are read when asked for."""
        return [Snapshot(path) for path in self.snapshot_paths]

    @property
    def snapshot_paths(self):
        """Of the snapshots, in the order of time."""
        return sorted(self.directory.glob("run_*.hdf"), key=lambda path: int(path.stem.split("_")[1]))

    def snapshot(self, time_s):
        """The `Snapshot` nearest to a time in s."""
        snapshots = self.snapshots
        if not snapshots:
            raise ReposeError(f"{self.directory}: has no snapshots")
        return min(snapshots, key=lambda snapshot: abs(snapshot.time_s - time_s))

    @property
    def checkpoint_paths(self):
        """Of the checkpoints, in the order of time; none when the run is complete."""
        return sorted(self.directory.glob("checkpoint_*.hdf"), key=lambda path: int(path.stem.split("_")[1]))

    @property
    def contact_paths(self):
        """Of the files of contacts (`output.contacts`), in the order of time."""
        return sorted(self.directory.glob("contacts_*.vtp"), key=lambda path: int(path.stem.split("_")[1]))

    def contacts(self, n=-1):
        """`ContactForces` beside `snapshots[n]`: who touches whom with what force, in N; the last by default."""
        snapshots = self.snapshot_paths
        if not self.contact_paths:
            raise ReposeError(f"{self.directory}: has no contacts_<step>.vtp: the deck has no output.contacts = true")
        if not -len(snapshots) <= n < len(snapshots):
            raise ReposeError(f"{self.directory}: has no snapshot {n}, but {len(snapshots)} of them")
        path = self.directory / snapshots[n].name.replace("run_", "contacts_").replace(".hdf", ".vtp")
        if not path.exists():
            raise ReposeError(f"{path}: is missing: the deck had no output.contacts = true when {snapshots[n].name} was written")
        return ContactForces(path)

    @property
    def checkpoint_contacts(self):
        """`Contacts` of the newest checkpoint; None without one, as when the run is complete."""
        paths = self.checkpoint_paths
        return Contacts(paths[-1]) if paths else None

    @property
    def build(self):
        """Version, commit, compiler and so on of the program, as the newest file says that does; empty when none does
        yet."""
        if self.is_complete:
            return self.summary["build"]
        paths = (self.checkpoint_paths or self.snapshot_paths)[-1:]
        return build_of(paths[0]) if paths else {}

    def picture(self, name, ending="svg"):
        """The path of `silhouette` or `top_view`, as `svg`, `png` or `pdf`; None when the run has made none."""
        path = self.directory / f"{name}.{ending}"
        return path if path.exists() else None

    @property
    def failure(self):
        """Why it failed, for a run of a calibration or a sensitivity study; None when it did not."""
        path = self.directory / "failed.json"
        return read_json(path)["reason"] if path.exists() and not self.is_complete else None

    @property
    def progress(self):
        """How far it is: `time_s` of the last row, `phase` (its name), `most_time_s`, the end at the latest, if the
        deck has one."""
        series, phases = self.series or Table(), self.deck.get("phase", [])
        place = int(series["phase"][-1]) if series else 0
        time_s = float(series["time_s"][-1]) if series else 0.0
        rests = [phase.get("time", phase.get("max_time")) for phase in phases[place:]]
        begun = float(series["time_s"][series["phase"] == place][0]) if series else 0.0
        most = begun + sum(rests) if rests and None not in rests else None
        return {"time_s": time_s, "phase": phases[place]["name"] if phases else "", "most_time_s": most}
