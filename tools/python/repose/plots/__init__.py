"""Pictures by matplotlib. Each function returns a `matplotlib.figure.Figure`, or None where there is nothing to draw:

    figure = repose.plots.energies(repose.Run("results/quick"))
    figure.savefig("energies.pdf")
"""

from repose.plots.course import discharge, energies, walls
from repose.plots.curves import curve
from repose.plots.effects import effect, effects
from repose.plots.heat import heat, temperatures
from repose.plots.lines import line, lines
from repose.plots.plane import contours, crossing, plane
from repose.plots.search import search

__all__ = ["calibration", "contours", "crossing", "curve", "discharge", "effect", "effects", "energies", "heat", "line",
           "lines", "plane", "search", "temperatures", "walls"]


def calibration(study):
    """What a `Calibration` has found: contours over two parameters, or the runs over each of one or three."""
    return plane(study) if study.surfaces is not None else lines(study)
