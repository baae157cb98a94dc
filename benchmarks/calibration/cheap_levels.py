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


def values_of(calibration, figure):
    """{point: the values of its seeds}."""
    grid = calibration.grid
    found = {}
    for *point, value in zip(*(grid[name] for name in calibration.parameters), grid[figure]):
        found.setdefault(tuple(point), []).append(float(value))
    return found


def work_of(calibration):
    """Particle-steps and seconds of cpu time of each complete run."""
    summaries = [run.summary for run in calibration.runs if run is not None and run.is_complete]
    return [(s["steps"] * s["particles"]["inserted"], s["timing"]["loop_cpu_s"]) for s in summaries]


def row(title, mini, cheap):
    """What a run costs, correlation of the means over the points, and the scatter of a run, in g and degrees."""
    costs = [[statistics.mean(column) for column in zip(*work_of(calibration))] for calibration in (cheap, mini)]
    content = {"level": title, "particle-steps": costs[0][0] / costs[1][0], "cpu time": costs[0][1] / costs[1][1]}
    for figure, factor in (("discharged_mass_kg", 1e3), ("angle_of_repose_deg", 1.0)):
        own, other = values_of(mini, figure), values_of(cheap, figure)
        means = [[factor * statistics.mean(values[point]) for point in own] for values in (own, other)]
        scatter = statistics.mean(statistics.variance(seeds) for seeds in other.values()) ** 0.5
        content |= {f"{figure} correlation": statistics.correlation(*means), f"{figure} scatter": factor * scatter}
    return content


def compare(searches, study, laboratory):
    """A row for discharge_mini and each candidate, from two seeds at nine points."""
    mini = searches.first_batch("alone", study, laboratory)
    rows = [row("discharge_mini", mini, mini)]
    for name, (title, sets) in CANDIDATES.items():
        cheap = searches.first_batch(name, replace(study, sets=study.sets + sets), laboratory)
        rows.append(row(title, mini, cheap))
    return rows
