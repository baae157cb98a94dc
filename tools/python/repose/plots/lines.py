"""A calibration of one parameter, or of three: the runs over each."""

from repose.plots.plane import LABORATORY, LEVEL_MARKS, REGION
from repose.plots.style import new_figure
from repose.units import quantity, words


def draw_runs_over(axes, study, parameter, figure, factor):
    """Dots with a mark of its own for each level, crosses for plugged runs; `gid` is the row of the grid."""
    grid, values = study.grid, study.column(figure)
    for n, level in enumerate(study.levels or [None]):
        label = level
        for row in range(grid.rows):
            value = values[row]
            if value != value or grid["state"][row] == "failed" or (level is not None and grid["level"][row] != level):
                continue
            at = [grid[parameter][row]], [factor * value]
            if grid["state"][row] == "plugged":
                axes.plot(*at, "x", color="0.4", markersize=7, gid=f"run-{row}")
                continue
            axes.plot(*at, LEVEL_MARKS[n % len(LEVEL_MARKS)], color="0.4", markersize=4, label=label, gid=f"run-{row}")
            label = None


def draw_line(axes, study, observable, parameter):
    """A figure over a parameter."""
    estimate, k = study.estimate, study.parameters.index(parameter)
    name, factor = quantity(observable["figure"])
    draw_runs_over(axes, study, parameter, observable["figure"], factor)
    value, error = factor * observable["laboratory"], factor * observable["standard_error"]
    axes.axhline(value, color=LABORATORY, linestyle="--")
    axes.axhspan(value - 2 * error, value + 2 * error, color=LABORATORY, alpha=0.2)
    for point in estimate["points"]:
        interval = estimate["parts"][point["part"]]["intervals"][k]
        axes.axvspan(interval["lower"], interval["upper"], color=REGION, alpha=0.15)
        axes.axvline(point["values"][k], color=REGION)
    axes.set(xlabel=words(parameter), ylabel=name)


def line(study, figure, parameter):
    """One figure of a `Calibration` over one parameter; the marks of runs have the `gid` "run-" and their row in the
    grid."""
    drawn, axes = new_figure(figsize=(4.6, 3.4))
    draw_line(axes, study, next(o for o in study.estimate["observables"] if o["figure"] == figure), parameter)
    return drawn


def lines(study):
    """Each figure of a `Calibration` over each parameter, with the laboratory's value and the estimate."""
    observables = study.estimate["observables"]
    figure, panels = new_figure(len(observables), len(study.parameters), squeeze=False, sharex="col",
                                figsize=(4.2 * len(study.parameters), 3.2 * len(observables)))
    for row, observable in zip(panels, observables):
        for axes, parameter in zip(row, study.parameters):
            draw_line(axes, study, observable, parameter)
            axes.label_outer()
    figure.suptitle(study.estimate["title"], fontsize=11)
    return figure
