"""What a sensitivity study has found."""

import math

from repose.plots.style import WIDTH, new_figure
from repose.units import quantity, words

KINDS = {"one_at_a_time": ("effect", "standard_error", "from lower to upper value"),
         "morris": ("mu_star", "mu_star_error", "Morris mu* over the range")}


def draw_effects(axes, study, figure, kind):
    """Bars with their standard errors, if these are known; a word where an effect could not be told."""
    value, error, title = KINDS[kind]
    found = study.effects(figure) if kind == "one_at_a_time" else study.morris(figure)
    name, factor = quantity(figure)
    values = [math.nan if e[value] is None else factor * e[value] for e in found.values()]
    errors = [None if e[error] is None else [factor * e[error]] for e in found.values()]
    for place, (mean, spread) in enumerate(zip(values, errors)):
        if math.isnan(mean):
            axes.text(0.02, place, "none", transform=axes.get_yaxis_transform(), va="center", fontsize=8, color="0.35")
        else:
            axes.barh([place], [mean], xerr=spread, color="tab:blue", alpha=0.7, capsize=3)
    axes.axvline(0.0, color="black", linewidth=0.8)
    axes.set_yticks(range(len(found)), [words(parameter) for parameter in found])
    axes.set_ylim(len(found) - 0.5, -0.5)
    axes.set_title(f"{name}: {title}", fontsize=9)


def effect(study, figure, kind="one_at_a_time"):
    """The effect of each parameter of a `Sensitivity` on one figure; `kind` may be "morris"."""
    drawn, axes = new_figure(figsize=(WIDTH, 0.8 + 0.4 * len(study.parameters)))
    draw_effects(axes, study, figure, kind)
    return drawn


def effects(study):
    """The effects of all parameters of a `Sensitivity` on all figures, and beside them Morris's mu*."""
    kinds = list(KINDS)[:2 if study.result["morris"] else 1]
    drawn, panels = new_figure(len(study.figures), len(kinds), figsize=(4.8 * len(kinds), 2.2 * len(study.figures)),
                               squeeze=False)
    for row, figure in zip(panels, study.figures):
        for axes, kind in zip(row, kinds):
            draw_effects(axes, study, figure, kind)
    drawn.suptitle(study.title, fontsize=11)
    return drawn
