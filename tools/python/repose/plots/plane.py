"""A calibration over two parameters: contours of each figure with the runs, the laboratory and the region."""

import numpy as np

from repose.plots.style import new_figure
from repose.units import quantity, words

REGION, LABORATORY, CHEAP = "tab:red", "black", "tab:purple"
LEVEL_MARKS = "osD^v"


def mark_points(axes, points, marker, name, **style):
    """One mark for each point of {(x, y): gid}, one entry of the legend for all."""
    for number, (point, gid) in enumerate(points.items()):
        axes.plot(*point, marker, color="0.25", label=None if number else name, gid=gid, clip_on=False,
                  linestyle="none", **style)


def points_where(study, chosen):
    """{(x, y): gid} of chosen rows; the gid has the rows at the point, as in "run-4-5"."""
    x, y = (study.grid[name] for name in study.parameters)
    rows_at = {}
    for row in range(study.grid.rows):
        if chosen[row]:
            rows_at.setdefault((x[row], y[row]), []).append(row)
    return {point: "run-" + "-".join(map(str, rows)) for point, rows in rows_at.items()}


def draw_runs(axes, study, figure):
    """Dots where the figure was found, with a mark of its own for each level; crosses where runs were plugged, had
    none, or failed. The last level's are full."""
    grid, values = study.grid, study.column(figure)
    state, has_value = np.where(study.asked_rows(figure), grid["state"], ""), values == values
    found = (state == "done") & has_value
    for n, level in enumerate(study.levels):
        mark_points(axes, points_where(study, found & (grid["level"] == level)), LEVEL_MARKS[n % len(LEVEL_MARKS)],
                    level,
                    markersize=5, fillstyle="full" if n + 1 == len(study.levels) else "none")
    marks = (("o", "run", found if not study.levels else found & False, 4), ("x", "plugged", state == "plugged", 7),
             ("+", "no value", (state == "done") & ~has_value, 7), ("1", "failed", state == "failed", 7))
    for marker, name, some, size in marks:
        mark_points(axes, points_where(study, some), marker, name, markersize=size)


def draw_cheap_level(axes, study, figure):
    """What the cheapest level alone would have said: its contour of the laboratory's value, or with None its region."""
    alone = study.first_level_surfaces
    if alone is None:
        return
    name = study.levels[0]
    if figure is None:
        if alone.misfit.min() <= alone.limit < alone.misfit.max():
            axes.contour(alone.x, alone.y, alone.misfit, levels=[alone.limit], colors=[CHEAP], linewidths=1.0,
                         linestyles=":")
            axes.plot([], [], ":", color=CHEAP, label=f"region of {name} alone")
        return
    for n, line in enumerate(alone.laboratory_lines[figure]):
        axes.plot(*line.T, ":", color=CHEAP, linewidth=1.2, label=None if n else f"laboratory by {name} alone")


def draw_laboratory(axes, surfaces, observable, factor, colour=LABORATORY):
    """The laboratory's contour, and the band of two standard errors about it."""
    error = 2.0 * observable["standard_error"]
    low, high = (factor * (observable["laboratory"] + side * error) for side in (-1, 1))
    if high > low:
        axes.contourf(surfaces.x, surfaces.y, factor * surfaces.mean[observable["figure"]], levels=[low, high],
                      colors=[colour],
                      alpha=0.2)
    for n, line in enumerate(surfaces.laboratory_lines[observable["figure"]]):
        axes.plot(*line.T, "--", color=colour, linewidth=1.5, label=None if n else "laboratory")


def draw_region(axes, study):
    surfaces, estimate = study.surfaces, study.estimate
    if surfaces.misfit.min() <= surfaces.limit < surfaces.misfit.max():
        axes.contour(surfaces.x, surfaces.y, surfaces.misfit, levels=[surfaces.limit], colors=[REGION], linewidths=1.5)
        by = "" if "posterior" not in estimate else " of the figures alone"
        axes.plot([], [], color=REGION, label=f"{100 * estimate['confidence']:.0f} % region{by}")
    for n, point in enumerate(estimate["points"]):
        axes.plot(*point["values"], "*", color=REGION, markersize=13, markeredgecolor="white",
                  label=None if n else "calibrated")
    if not estimate["points"]:
        axes.plot(*estimate["nearest"]["values"], "d", color=REGION, markersize=8, label="nearest")


def draw_figure(axes, study, observable):
    """Contours of one figure."""
    surfaces = study.surfaces
    name, factor = quantity(observable["figure"])
    values = factor * surfaces.mean[observable["figure"]]
    axes.contourf(surfaces.x, surfaces.y, values, levels=12, cmap="Blues", alpha=0.6)
    lines = axes.contour(surfaces.x, surfaces.y, values, levels=12, colors="0.4", linewidths=0.6)
    axes.clabel(lines, fontsize=7)
    draw_laboratory(axes, surfaces, observable, factor)
    draw_cheap_level(axes, study, observable["figure"])
    draw_runs(axes, study, observable["figure"])
    draw_region(axes, study)
    axes.set_title(name, fontsize=10)
    axes.legend(fontsize=7, loc="best")


def draw_meeting(axes, study):
    """The laboratory's contours of all figures, and where they meet."""
    surfaces = study.surfaces
    for n, observable in enumerate(study.estimate["observables"]):
        name, factor = quantity(observable["figure"])
        draw_laboratory(axes, surfaces, observable, factor, f"C{n}")
        axes.plot([], [], "--", color=f"C{n}", label=name)
    draw_cheap_level(axes, study, None)
    draw_region(axes, study)
    handles, names = axes.get_legend_handles_labels()
    shown = [(handle, name) for handle, name in zip(handles, names) if name != "laboratory"]
    axes.legend(*zip(*shown), fontsize=7, loc="best")
    axes.set_title("where they meet", fontsize=10)
    axes.set(xlim=(surfaces.x[0], surfaces.x[-1]), ylim=(surfaces.y[0], surfaces.y[-1]))


def name_axes(axes, study):
    x, y = study.parameters
    axes.set(xlabel=words(x), ylabel=words(y))


def contours(study, figure):
    """The surface of one figure of a `Calibration` over two parameters. The marks of runs have the `gid` "run-" and
    their rows in the grid: "run-4-5"."""
    observable = next(o for o in study.estimate["observables"] if o["figure"] == figure)
    drawn, axes = new_figure(figsize=(4.6, 4.2))
    draw_figure(axes, study, observable)
    name_axes(axes, study)
    return drawn


def crossing(study):
    """Where the laboratory's contours of all figures of a `Calibration` over two parameters meet."""
    drawn, axes = new_figure(figsize=(4.6, 4.2))
    draw_meeting(axes, study)
    name_axes(axes, study)
    return drawn


def plane(study):
    """`contours` of all figures and `crossing` side by side."""
    observables = study.estimate["observables"]
    count = len(observables) + 1
    figure, panels = new_figure(1, count, figsize=(4.6 * count, 4.4), sharey=True)
    for axes, observable in zip(panels, observables):
        draw_figure(axes, study, observable)
    draw_meeting(panels[-1], study)
    for axes in panels:
        name_axes(axes, study)
        axes.label_outer()
    figure.suptitle(study.estimate["title"], fontsize=11)
    return figure
