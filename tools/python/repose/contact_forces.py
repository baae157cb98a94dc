"""Contacts with their forces, of a run with `output.contacts`: contacts_<step>.vtp beside the snapshot of the same
step."""

import pathlib

import numpy as np

from repose.files import ReposeError
from repose.poly_data import read_poly_data

ARRAYS = ("first", "second", "wall", "normal_force", "tangential_force", "position", "TimeValue")


class ContactForces:
    """All contacts at one time, in the order of the numbers of their particles.

    first, second       numbers of the two particles, the lower one first; `second` is -1 at a wall
    wall                place of the wall in the deck, from 0; -1 between particles
    normal_force        N, rows (x, y, z), on the first; on the second it is the opposite
    tangential_force    N, as well
    centre              m, rows (x, y, z): of the first
    other               m: centre of the second, beside the first also across a periodic boundary; the point of the wall
                        that is touched
    time_s              s, since the start of the run
    """

    def __init__(self, path):
        self.path = pathlib.Path(path)
        arrays = read_poly_data(path)
        if not all(name in arrays for name in ARRAYS):
            raise ReposeError(f"{path}: has no contacts")
        self.first, self.second, self.wall = (arrays[name] for name in ARRAYS[:3])
        self.normal_force, self.tangential_force = arrays["normal_force"], arrays["tangential_force"]
        self.centre, self.other = arrays["position"][::2], arrays["position"][1::2]
        self.time_s = float(arrays["TimeValue"][0])

    def __len__(self):
        return len(self.first)

    def __repr__(self):
        return f"<ContactForces {self.path.name}: {len(self)} contacts at {self.time_s:.6g} s>"

    def force_on(self, ids):
        """N: the sum of all contacts of each of these particles, rows (x, y, z). At rest it carries their weight."""
        ids = np.asarray(ids)
        total = np.zeros((len(ids), 3))
        if not len(ids):
            return total
        order = np.argsort(ids, kind="stable")
        force = self.normal_force + self.tangential_force
        for numbers, of_contact in ((self.first, force), (self.second, -force)):
            place = np.searchsorted(ids, numbers, sorter=order)
            place = order[np.minimum(place, len(ids) - 1)]
            listed = ids[place] == numbers
            np.add.at(total, place[listed], of_contact[listed])
        return total
