"""Pictures by matplotlib. Each function returns a `matplotlib.figure.Figure`, or None where there is nothing to draw:

    figure = repose.plots.energies(repose.Run("results/quick"))
    figure.savefig("energies.pdf")
"""

from repose.plots.compression import compression
from repose.plots.corner import corner
from repose.plots.course import discharge, energies, walls
from repose.plots.curves import curve
from repose.plots.effects import effect, effects
from repose.plots.grains import grains, speeds
from repose.plots.heat import heat, temperatures
from repose.plots.lines import line, lines
from repose.plots.plane import contours, crossing, plane
from repose.plots.search import search
from repose.plots.shear import shear

__all__ = ["calibration", "compression", "contours", "corner", "crossing", "curve", "discharge", "effect", "effects",
           "energies", "grains", "heat", "line", "lines", "plane", "search", "shear", "speeds", "temperatures", "walls"]


def calibration(study):
    """What a `Calibration` has found: its posterior, contours over two parameters, or the runs over each of one or
    three."""
    if study.posterior is not None:
        return corner(study)
    return plane(study) if study.surfaces is not None else lines(study)
