"""What cheap levels tell of discharge_mini, and for what: their runs at the points of one first design beside its own."""

import statistics
from dataclasses import replace


def soft(diameter, count, spacing, modulus, step):
    """Overrides of discharge_mini: mm, number, mm, MPa, us."""
    return [f"particles.0.diameter={diameter} mm", f"particles.0.count={count}", f"particles.0.spacing={spacing} mm",
            f"material.0.youngs_modulus={modulus} MPa", f"material.1.youngs_modulus={modulus} MPa", f"time.step={step} us"]


# With less than 0.2 MPa (0.3 for grains of their own size) overlaps come to 0.3 radii where grains fall on one another.
CANDIDATES = {
    "d66": ("0.66 mm, 0.5 MPa", soft(0.66, 2774, 1.155, 0.5, 22.5)),
    "d55": ("0.55 mm, 0.2 MPa", soft(0.55, 4793, 0.77, 0.2, 28)),
    "d44": ("0.44 mm, 0.3 MPa", soft(0.44, 9362, 0.616, 0.3, 19)),
    "light": ("0.44 mm, 0.3 MPa, 0.9 g", soft(0.44, 5617, 0.616, 0.3, 19)),
}


def values_of(calibration, figure, points):
    """Of each of `points`, or of each that there is, the values of its seeds."""
    grid = calibration.grid
    found = {}
    for x, y, value in zip(grid[calibration.parameters[0]], grid[calibration.parameters[1]], grid[figure]):
        found.setdefault((x, y), []).append(float(value))
    return [found[point] for point in points or found], points or list(found)


def deviation(values):
    """Of one run: pooled over the points."""
    return statistics.mean(statistics.variance(seeds) for seeds in values) ** 0.5


def mean_costs(calibration):
    """Particle-steps and seconds of a run."""
    summaries = [run.summary for run in calibration.runs if run is not None and run.is_complete]
    return (statistics.mean(s["steps"] * s["particles"]["inserted"] for s in summaries),
            statistics.mean(s["timing"]["loop_cpu_s"] for s in summaries))


def row(name, figures, own, others, costs):
    """Correlation of the means over the points, and the scatter of a run, in g and degrees."""
    content = {"level": name, "particle-steps": costs[0], "cpu time": costs[1]}
    for figure, factor in figures.items():
        mini, cheap = own[figure], others[figure]
        means = [[factor * statistics.mean(seeds) for seeds in values] for values in (mini, cheap)]
        content |= {f"{figure} correlation": statistics.correlation(*means), f"{figure} scatter": factor * deviation(cheap)}
    return content


def compare(searches, study, laboratory, adaptive):
    """A row for discharge_mini and each candidate, from two seeds at nine points."""
    figures = {"discharged_mass_kg": 1e3, "angle_of_repose_deg": 1.0}
    mini = searches.calibrate("start_alone", study.search(searches.base, laboratory, adaptive))
    own, points = {}, None
    for figure in figures:
        own[figure], points = values_of(mini, figure, points)
    full = mean_costs(mini)
    rows = [row("discharge_mini", figures, own, own, (1.0, 1.0))]
    for name, (title, sets) in CANDIDATES.items():
        deck = replace(study, sets=study.sets + sets).search(searches.base, laboratory, adaptive)
        cheap = searches.calibrate(f"cheap_{name}", deck)
        others = {figure: values_of(cheap, figure, points)[0] for figure in figures}
        rows.append(row(title, figures, own, others, [a / b for a, b in zip(mean_costs(cheap), full)]))
    return rows
