"""The posterior of a calibration: what is known of each parameter, and of each pair."""

import numpy as np

from repose.plots.plane import REGION
from repose.plots.style import new_figure, styled
from repose.units import words

BINS, PAIR_BINS = 40, 30
SHARES = (0.95, 0.68)


def smoothed(counts):
    """By a kernel of three deviations over either axis, so that lines of equal density are no combs."""
    kernel = np.exp(-0.5 * (np.arange(-4, 5) / 1.3) ** 2)
    for axis in (0, 1):
        edge = np.apply_along_axis(np.convolve, axis, np.ones_like(counts), kernel, "same")
        counts = np.apply_along_axis(np.convolve, axis, counts, kernel, "same") / edge
    return counts


def levels_of(density):
    """Densities above which the shares of all lie, ascending."""
    descending = np.sort(density.ravel())[::-1]
    held = np.cumsum(descending) / descending.sum()
    return [descending[min(np.searchsorted(held, share), len(descending) - 1)] for share in SHARES]


def extent(samples):
    """Where nearly all samples are, with some room."""
    low, high = np.quantile(samples, (0.001, 0.999))
    return low - 0.1 * (high - low), high + 0.1 * (high - low)


def clipped(limits, parameter):
    return max(limits[0], parameter["min"]), min(limits[1], parameter["max"])


def draw_marginal(axes, posterior, name, limits):
    marginal = posterior.marginals[name]
    axes.hist(posterior.samples[name], bins=BINS, range=limits, density=True, color="tab:blue", alpha=0.35,
              histtype="stepfilled")
    x = np.linspace(*limits, 200)
    axes.plot(x, posterior.prior_density(name, x), "--", color="0.4")
    axes.axvspan(marginal["interval"]["lower"], marginal["interval"]["upper"], color=REGION, alpha=0.1)
    axes.set_yticks([])
    if not marginal["determined"]:
        axes.set_title("not determined", fontsize=7)


def draw_pair(axes, samples, x, y, x_limits, y_limits):
    counts, x_edges, y_edges = np.histogram2d(samples[x], samples[y], bins=PAIR_BINS, range=(x_limits, y_limits))
    density = smoothed(counts).T
    lower, upper = levels_of(density)
    if not 0.0 < lower < upper < density.max():
        axes.plot(samples[x], samples[y], ".", color="tab:blue", markersize=1)
        return
    middles = [0.5 * (edges[1:] + edges[:-1]) for edges in (x_edges, y_edges)]
    axes.contourf(*middles, density, levels=[lower, upper, density.max()], colors=["#c6dbef", "#6baed6"])
    axes.contour(*middles, density, levels=[lower], colors=[REGION], linewidths=1.0)


@styled
def corner(study):
    """The posterior of a `Calibration`: of each parameter with its prior (dashed) and its interval, of each pair the
    regions that hold 68 and 95 % of it, and the most likely point; None without a posterior."""
    posterior = study.posterior
    if posterior is None:
        return None
    parameters = study.estimate["parameters"]
    count = len(parameters)
    figure, panels = new_figure(count, count, squeeze=False, sharex="col",
                                figsize=(max(4.6, 1.7 * count), max(4.0, 1.6 * count)))
    limits = {p["name"]: clipped(extent(posterior.samples[p["name"]]), p) for p in parameters}
    for row in range(count):
        for column in range(count):
            axes = panels[row, column]
            x, y = parameters[column]["name"], parameters[row]["name"]
            if column > row:
                axes.set_axis_off()
                continue
            if column == row:
                draw_marginal(axes, posterior, x, limits[x])
            else:
                draw_pair(axes, posterior.samples, x, y, limits[x], limits[y])
                axes.set_ylim(limits[y])
                axes.plot(study.values[x], study.values[y], "*", color=REGION, markersize=7, markeredgecolor="white")
            axes.set_xlim(limits[x])
            axes.tick_params(labelsize=7, axis="both", labelleft=column == 0 and row > 0)
            axes.tick_params(axis="x", rotation=45, labelbottom=row == count - 1)
            if row == count - 1:
                axes.set_xlabel(words(x), fontsize=8)
            if column == 0 and row > 0:
                axes.set_ylabel(words(y), fontsize=8)
    figure.suptitle(study.estimate["title"], fontsize=11)
    return figure
