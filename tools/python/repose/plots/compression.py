"""A bed that is compressed."""

import numpy as np

from repose.plots.style import HEIGHT, WIDTH, new_figure, styled


@styled
def compression(bed):
    """Porosity over stress, and the moduli of the unloadings with the power law through them, of a
    `repose.compression.Compression`."""
    figure, (course, moduli) = new_figure(1, 2, figsize=(1.6 * WIDTH, HEIGHT))
    course.semilogx(bed.stress, bed.porosity)
    course.set_xlabel("stress, Pa")
    course.set_ylabel("porosity")
    stress, modulus = bed.unloadings["stress_Pa"], bed.unloadings["modulus_Pa"]
    moduli.loglog(stress, modulus, "o")
    if bed.exponent is not None:
        middle = np.exp(np.log(modulus).mean() - bed.exponent * np.log(stress).mean())
        moduli.loglog(np.sort(stress), middle * np.sort(stress) ** bed.exponent, "-",
                      label=f"exponent {bed.exponent:.3f} ± {bed.exponent_error:.3f}")
        moduli.legend()
    moduli.set_xlabel("stress, Pa")
    moduli.set_ylabel("modulus of unloading, Pa")
    return figure
