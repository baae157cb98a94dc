"""Contacts, from the checkpoint of a run that is not complete: who touches whom, and what the contact remembers."""

import numpy as np

from repose.files import ReposeError
from repose.snapshot import open_hdf5


class Contacts:
    """Those of a checkpoint that remember something: a tangential spring or a rolling moment. Touching surfaces have
    done so since their first step, unless the deck has no friction. Particles are named by their numbers.

    pairs           rows of two particles, the lower number first, in order
    spring          m, tangential displacement of each pair; rows (x, y, z), from the higher number to the lower
    rolling         N m, rolling moment of each pair, as well
    wall_particle   particle of each contact with a wall
    wall            place of that wall in the deck, from 0
    wall_spring, wall_rolling   as of pairs
    """

    def __init__(self, path):
        with open_hdf5(path) as file:
            if "pair_contacts/partner" not in file or "particles/id" not in file:
                raise ReposeError(f"{path}: is no checkpoint")
            self.ids = np.sort(file["particles/id"][...])  #: of all particles
            self.time_s = float(file.attrs["time_s"])  #: s
            self.step = int(file.attrs["step"])
            ids = file["particles/id"][...]
            self._read_pairs(file, ids)
            self._read_walls(file, ids)

    def _read_pairs(self, file, ids):
        owner = np.repeat(ids, file["particles/pair_contacts"][...])
        partner = file["pair_contacts/partner"][...]
        once = np.flatnonzero(owner < partner)  # both particles carry the contact
        once = once[np.lexsort((partner[once], owner[once]))]
        history = file["pair_contacts/history"][...][once]
        self.pairs = np.column_stack([owner[once], partner[once]])
        self.spring, self.rolling = history[:, :3], history[:, 3:]

    def _read_walls(self, file, ids):
        owner, wall = np.repeat(ids, file["particles/wall_contacts"][...]), file["wall_contacts/wall"][...]
        order = np.lexsort((wall, owner))
        history = file["wall_contacts/history"][...][order]
        self.wall_particle, self.wall = owner[order], wall[order]
        self.wall_spring, self.wall_rolling = history[:, :3], history[:, 3:]

    def coordination(self):
        """Contacts of each particle of `ids` with other particles."""
        numbers, counts = np.unique(self.pairs, return_counts=True)
        found = np.zeros(len(self.ids), dtype=int)
        found[np.searchsorted(self.ids, numbers)] = counts
        return found
