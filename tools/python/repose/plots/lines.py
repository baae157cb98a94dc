"""A calibration of one parameter, or of three: the runs over each."""

from repose.plots.plane import LABORATORY, LEVEL_MARKS, REGION
from repose.plots.style import new_figure
from repose.units import quantity, words


def draw_runs_over(axes, study, parameter, figure, factor):
    """Dots with a mark of its own for each level; `gid` is the row of the grid."""
    grid = study.grid
    for n, level in enumerate(study.levels or [None]):
        label = level
        for row in range(grid.rows):
            value = grid[figure][row]
            if value != value or grid["state"][row] == "failed" or (level is not None and grid["level"][row] != level):
                continue
            axes.plot([grid[parameter][row]], [factor * value], LEVEL_MARKS[n % len(LEVEL_MARKS)], color="0.4", markersize=4,
                      label=label, gid=f"run-{row}")
            label = None


def lines(study):
    """Each figure of a `Calibration` over each parameter, with the laboratory's value and the estimate."""
    estimate = study.estimate
    parameters, observables = study.parameters, estimate["observables"]
    figure, panels = new_figure(len(observables), len(parameters), squeeze=False, sharex="col",
                                figsize=(4.2 * len(parameters), 3.2 * len(observables)))
    for row, observable in zip(panels, observables):
        name, factor = quantity(observable["figure"])
        for k, (axes, parameter) in enumerate(zip(row, parameters)):
            draw_runs_over(axes, study, parameter, observable["figure"], factor)
            value, error = factor * observable["laboratory"], factor * observable["standard_error"]
            axes.axhline(value, color=LABORATORY, linestyle="--")
            axes.axhspan(value - 2 * error, value + 2 * error, color=LABORATORY, alpha=0.2)
            for point in estimate["points"]:
                interval = estimate["parts"][point["part"]]["intervals"][k]
                axes.axvspan(interval["lower"], interval["upper"], color=REGION, alpha=0.15)
                axes.axvline(point["values"][k], color=REGION)
            axes.set_xlabel(words(parameter))
        row[0].set_ylabel(name)
    figure.suptitle(estimate["title"], fontsize=11)
    return figure
