"""Grains of a snapshot, as one sees them from a side."""

from dataclasses import dataclass

import numpy as np
from matplotlib.collections import EllipseCollection

from repose.files import ReposeError
from repose.plots.style import WIDTH, new_figure, styled
from repose.units import prefixed

ACROSS = {"x": (1, 2), "y": (0, 2), "z": (0, 1)}  # what is seen along each axis: right and up


@dataclass
class Shade:
    """By what grains are coloured: a value each."""

    values: np.ndarray
    label: str
    colours: str
    greatest: float = None  # with a colour of its own; greater ones have the same


def seen(snapshot, axis, part, shade):
    """The grains as seen along an axis ("x", "y" or "z"), the nearest in front. `part`: share of the bed's depth that is
    shown, from its back on; 0.5 cuts it open in the middle. None without grains."""
    if axis not in ACROSS:
        raise ReposeError(f'an axis is x, y or z, not "{axis}"')
    if len(snapshot) == 0:
        return None
    right, up = ACROSS[axis]
    depth = snapshot.position[:, 3 - right - up] * (1.0 if axis == "y" else -1.0)  # greater: farther behind
    shown = depth >= depth.max() - part * np.ptp(depth)
    order = np.flatnonzero(shown)[np.argsort(-depth[shown], kind="stable")]
    places = snapshot.position[order][:, (right, up)]
    radii = snapshot.radius[order]
    low, high = (places - radii[:, None]).min(axis=0), (places + radii[:, None]).max(axis=0)
    factor, unit = prefixed((high - low).max(), "m")
    width, height = factor * (high - low)
    scale = min(WIDTH / width, 1.6 * WIDTH / height)
    figure, axes = new_figure(figsize=(max(width * scale, 1.2) + 2.0, height * scale + 0.6))
    discs = EllipseCollection(2.0 * factor * radii, 2.0 * factor * radii, np.zeros(len(radii)), units="xy",
                              offsets=factor * places, offset_transform=axes.transData, array=shade.values[order],
                              cmap=shade.colours, linewidths=0.1, edgecolors="0.3", rasterized=True)
    if shade.greatest is not None:
        discs.set_clim(0.0, shade.greatest)
    axes.add_collection(discs)
    axes.set_xlim(factor * low[0], factor * high[0])
    axes.set_ylim(factor * low[1], factor * high[1])
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel(f"{'xyz'[right]}, {unit}")
    axes.set_ylabel(f"{'xyz'[up]}, {unit}")
    figure.colorbar(discs, label=shade.label)
    return figure


@styled
def grains(snapshot, axis="y", part=1.0):
    """The grains as `seen`, by their numbers: those of a fill are numbered from its bottom upwards, so that the colours show
    what has moved where."""
    return seen(snapshot, axis, part, Shade(snapshot.id, "number of the grain", "viridis"))


@styled
def speeds(snapshot, axis="y", part=1.0):
    """The grains as `seen`, by their speeds, up to that of the fastest hundredth: what shears and what rests."""
    speed = np.linalg.norm(snapshot.velocity, axis=1)
    fast = float(np.percentile(speed, 99.0)) if len(speed) else 0.0
    factor, unit = prefixed(fast, "m/s")
    return seen(snapshot, axis, part, Shade(factor * speed, f"speed, {unit}", "viridis", factor * fast))
