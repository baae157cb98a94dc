"""A snapshot of all particles: run_<step>.hdf, or the neighbourhood_<step>.hdf of a run that a guard has ended."""

import pathlib
import tomllib

import numpy as np

from repose.files import ReposeError


def open_hdf5(path):
    """h5py is imported here: ParaView's own Python, which reads walls alone, may lack it."""
    import h5py
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise ReposeError(f"{path}: cannot be read: {error}") from None


def build_of(path):
    """Version, commit and so on of the program that wrote an HDF5 file."""
    with open_hdf5(path) as file:
        return {name[6:]: str(value) for name, value in file.attrs.items() if name.startswith("build_")}


def array(name, meaning):
    return property(lambda self: self[name], doc=meaning)


class Snapshot:
    """Particles at one time, in the order of their numbers. Arrays are read when they are asked for, by attribute or by
    name (`snapshot["radius"]`), and kept."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self._arrays = {}
        with open_hdf5(self.path) as file:
            if "particles/position" not in file or "time_s" not in file.attrs:
                raise ReposeError(f"{path}: is no snapshot")
            self._attributes = {name: value for name, value in file.attrs.items()}
            self.count = len(file["particles/position"])  #: particles in it
            self.names = list(file["particles"])  #: of its arrays

    id = array("id", "Number of each particle.")
    position = array("position", "m; a row (x, y, z) for each particle.")
    velocity = array("velocity", "m/s; rows (x, y, z).")
    angular_velocity = array("angular_velocity", "rad/s; rows (x, y, z).")
    radius = array("radius", "m.")
    mass = array("mass", "kg.")
    temperature = array("temperature", "K; of a run with [heat] alone.")
    material = array("material", "Place of each particle's material in `materials`.")

    def __getitem__(self, name):
        if name not in self._arrays:
            if name not in self.names:
                raise ReposeError(f'{self.path}: has no array "{name}", but {", ".join(self.names)}')
            with open_hdf5(self.path) as file:
                self._arrays[name] = file["particles"][name][...]
        return self._arrays[name]

    def __len__(self):
        return self.count

    def __repr__(self):
        return f"<Snapshot {self.path.name}: {self.count} particles at {self.time_s:.6g} s>"

    @property
    def time_s(self):
        """s, since the start of the run."""
        return float(self._attributes["time_s"])

    @property
    def step(self):
        """Steps since the start of the run."""
        return int(self._attributes["step"])

    @property
    def state_hash(self):
        """Of ids, positions, velocities, spins and contact histories."""
        return str(self._attributes["state_hash"])

    @property
    def inserted(self):
        """Particles that have come by then: those inside and those that left."""
        return int(self._attributes["inserted"])

    @property
    def left(self):
        """Particles that have left the domain."""
        return int(self._attributes["left"])

    @property
    def materials(self):
        """Names."""
        return [str(name) for name in self._attributes["materials"]]

    @property
    def material_names(self):
        """The material of each particle by its name."""
        return np.array(self.materials)[self.material]

    @property
    def deck_text(self):
        """The resolved deck of the run."""
        return str(self._attributes["deck"])

    @property
    def deck(self):
        """The resolved deck of the run, as a dict."""
        return tomllib.loads(self.deck_text)

    @property
    def build(self):
        """Version, commit, compiler and so on of the program that wrote it."""
        return build_of(self.path)
