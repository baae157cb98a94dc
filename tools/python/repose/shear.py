"""A shear cell, straight or round: shear stress over the way of the half that moves, yield locus."""

import math

import numpy as np

from repose.files import ReposeError


def speed_of_halves(deck):
    """m/s, at which the halves of the cell of [measurement.shear] move past each other; of a ring, at its mean radius."""
    cell = deck["measurement"]["shear"]
    for wall in deck["wall"]:
        for motion in wall.get("motion", []):
            if motion["type"] == cell["type"] and cell["phase"] in (motion.get("phases") or [cell["phase"]]):
                if cell["type"] == "translation":
                    return float(np.linalg.norm(motion["velocity"]))
                inner, outer = cell["inner_radius"], cell["outer_radius"]
                return abs(motion["angular_velocity"]) * 2.0 / 3.0 * (outer**3 - inner**3) / (outer**2 - inner**2)
    raise ReposeError(f'no wall moves by {cell["type"]} in the phase "{cell["phase"]}"')


class Shear:
    """What [measurement.shear] of a run has found.

    way (m), shear, normal (Pa): arrays over the samples of shear.csv; steady_shear, steady_normal, friction_deg, peak_deg: from
    summary.json, None of a plane that bears no load; peak_shear: the shear stress of the peak under the steady normal one."""

    def __init__(self, run):
        samples, summary = run.shear, run.summary
        if samples is None or summary.get("shear_stress_Pa") is None:
            raise ReposeError(f"{run.directory}: has no shear stresses: its deck has no [measurement.shear], or too short a phase")
        self.way = samples["shear_time_s"] * speed_of_halves(run.deck)
        self.shear, self.normal = np.abs(samples["shear_stress_Pa"]), samples["normal_stress_Pa"]
        self.steady_shear, self.steady_normal = summary["shear_stress_Pa"], summary["normal_stress_Pa"]
        self.friction_deg, self.peak_deg = summary["internal_friction_deg"], summary["internal_friction_peak_deg"]
        self.peak_shear = (self.steady_shear if self.peak_deg is None
                           else self.steady_normal * math.tan(math.radians(self.peak_deg)))


def steady_locus(runs):
    """(angle of internal friction in degrees, cohesion in Pa) of the line through the steady stresses of several `Shear`."""
    return line_through([[run.steady_normal, run.steady_shear] for run in runs])


def yield_locus(runs):
    """`flow_properties` of several `Shear` of beds that were consolidated alike, from their peaks; the first was sheared under the
    stress of its consolidation, so that its steady stresses are those of the consolidation."""
    return flow_properties([[run.steady_normal, run.peak_shear] for run in runs], (runs[0].steady_normal, runs[0].steady_shear))


def line_through(points):
    """(angle in degrees, offset) of the line through points (normal, shear stress), by least squares."""
    slope, offset = np.polyfit(*np.transpose(points), 1)
    return math.degrees(math.atan(slope)), float(offset)


def flow_properties(points, consolidation):
    """What a yield locus through points (normal, shear stress) of failure says of beds that were consolidated at the steady stresses
    `consolidation` (normal, shear), in Pa (Jenike 1964, Bulletin 123 of the Utah Engineering Experiment Station; ASTM D6773):

    internal_friction_deg, cohesion_Pa; unconfined_yield_strength_Pa: of Mohr's circle through zero that touches the locus;
    major_consolidation_stress_Pa, effective_internal_friction_deg: of the one through the point of consolidation that touches it
    at no greater normal stress; flowability: the ratio of the two stresses, None without strength."""
    angle, cohesion = line_through(points)
    normal, shear = consolidation
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    # of a circle with its centre at m: (m - normal)^2 + shear^2 = (cohesion cosine + m sine)^2
    half = (normal + cohesion * sine * cosine) / cosine**2
    rest = (normal**2 + shear**2 - (cohesion * cosine) ** 2) / cosine**2
    centre = half - math.sqrt(max(0.0, half**2 - rest))  # 0: the point lies on the locus or above
    radius = math.hypot(centre - normal, shear)
    strength = 2.0 * cohesion * cosine / (1.0 - sine)
    return {"internal_friction_deg": angle, "cohesion_Pa": cohesion, "unconfined_yield_strength_Pa": strength,
            "major_consolidation_stress_Pa": centre + radius,
            "effective_internal_friction_deg": math.degrees(math.asin(min(1.0, radius / centre))),
            "flowability": (centre + radius) / strength if strength > 0.0 else None}
