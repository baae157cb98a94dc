"""A shear cell."""

import numpy as np

from repose.plots.style import HEIGHT, WIDTH, new_figure, styled
from repose.shear import steady_locus


@styled
def shear(tests):
    """Shear stress over way, and the line through the steady stresses, of several `repose.shear.Shear`."""
    figure, (course, locus) = new_figure(1, 2, figsize=(1.6 * WIDTH, HEIGHT))
    for test in tests:
        line, = course.plot(1e3 * test.way, 1e-3 * test.shear, label=f"{1e-3 * test.steady_normal:.3g} kPa")
        locus.plot(1e-3 * test.steady_normal, 1e-3 * test.steady_shear, "o", color=line.get_color())
    course.set_xlabel("way, mm")
    course.set_ylabel("shear stress, kPa")
    course.legend(title="normal stress", ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.2))
    if len(tests) > 1:
        angle, cohesion = steady_locus(tests)
        ends = np.array([0.0, max(test.steady_normal for test in tests)])
        locus.plot(1e-3 * ends, 1e-3 * (cohesion + np.tan(np.radians(angle)) * ends), "k-", label=f"{angle:.1f} degrees")
        locus.legend()
    locus.set_xlim(left=0.0)
    locus.set_ylim(bottom=0.0)
    locus.set_xlabel("normal stress, kPa")
    locus.set_ylabel("shear stress, kPa")
    return figure
