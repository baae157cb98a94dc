"""What a sensitivity study has found."""

import math

from repose.plots.style import new_figure
from repose.units import quantity, words


def draw_effects(axes, found, value, error, factor, title):
    names = [words(name) for name in found]
    values = [math.nan if e[value] is None else factor * e[value] for e in found.values()]
    errors = [0.0 if e[error] is None else factor * e[error] for e in found.values()]
    axes.barh(names, values, xerr=errors, color="tab:blue", alpha=0.7, capsize=3)
    axes.axvline(0.0, color="black", linewidth=0.8)
    axes.invert_yaxis()
    axes.set_title(title, fontsize=9)


def effects(study, figures=None):
    """The effect of each parameter of a `Sensitivity` on each figure, with standard errors, and beside it Morris's mu*."""
    figures = figures or study.figures
    has_walks = bool(study.result["morris"])
    columns = 2 if has_walks else 1
    drawn, panels = new_figure(len(figures), columns, figsize=(4.8 * columns, 2.2 * len(figures)), squeeze=False)
    for row, name in zip(panels, figures):
        shown, factor = quantity(name)
        draw_effects(row[0], study.effects(name), "effect", "standard_error", factor, f"{shown}: from lower to upper value")
        if has_walks:
            draw_effects(row[1], study.morris(name), "mu_star", "mu_star_error", factor, f"{shown}: Morris mu* over the range")
    drawn.suptitle(study.title, fontsize=11)
    return drawn
