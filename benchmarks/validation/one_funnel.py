"""What a calibration of friction would find in a funnel of another radius, by which the retained mass changes."""

import json
import re
import shutil
import tempfile
from pathlib import Path

from bench import RESULTS, input_deck, repose
from contours import coefficient, misfit_at
from repose.program import call

RADII = (11.0, 11.11, 11.2, 11.3, 11.44)  # mm; the second is that of CarboHSP's decks, the last that of sand's
MASS = re.compile(r'(figure = "retained_mass_kg".*\nlaboratory = )(\S+)')


def own_radius(deck):
    """Of the vessel of a deck, in mm."""
    (rim, _), *_ = next(wall["points"] for wall in input_deck(deck)["wall"] if wall["type"] == "profile")
    return float(rim.removesuffix(" mm"))


def mass_per_radius():
    """How the retained mass grows with the radius, kg/mm, from both radii of CarboHSP in `studies.py funnel`."""
    table = json.loads((RESULTS / "funnel.json").read_text())["table"]
    low, high = [row for row in table if row["deck"] == "scatter_carbohsp.toml"]
    return 1e-3 * (high["retained, g"] - low["retained, g"]) / (high["radius, mm"] - low["radius, mm"])


def estimates_with(options, calibration, masses):
    """The calibration, estimated again in a copy, for each retained mass (kg) in place of the laboratory's."""
    with tempfile.TemporaryDirectory() as folder:
        copy, changed = Path(folder) / calibration.directory.name, Path(folder) / "changed.toml"
        shutil.copytree(calibration.directory, copy)
        text = (copy / calibration.deck_file).read_text()
        for mass in masses:
            deck, count = MASS.subn(rf"\g<1>{mass:.6g}", text)
            if count != 1:
                raise SystemExit(f"{calibration.directory / calibration.deck_file}: not one laboratory's retained_mass_kg but {count}")
            changed.write_text(deck)
            call(["estimate", copy, "--deck", changed], program=options.program)
            yield repose.Calibration(copy).estimate


def by_radius(options, calibration):
    """A row for each radius and crossing there, or the nearest point: the laboratory's retained mass less what the radius makes of it,
    the coefficients with standard errors, the misfits there and of the deck's own coefficients, which are the thesis's, and the intervals of the region."""
    base = calibration.deck["base"]
    thesis = [coefficient(base, parameter["key"]) for parameter in calibration.deck["parameter"]]
    own, slope = own_radius(base), mass_per_radius()
    laboratory = next(o["laboratory"] for o in calibration.laboratory if o["figure"] == "retained_mass_kg")
    rows = []
    masses = [laboratory - slope * (radius - own) for radius in RADII]
    for radius, mass, estimate in zip(RADII, masses, estimates_with(options, calibration, masses)):
        nearest = estimate["nearest"]
        region = {f"region of {name}": " or ".join(sorted({f"{interval['lower']:.3f} to {interval['upper']:.3f}" for interval in intervals}))
                  for name, intervals in zip(calibration.parameters, zip(*(part["intervals"] for part in estimate["parts"])))}
        for point in estimate["points"] or [{"values": nearest["values"], "standard_errors": None}]:
            errors = point["standard_errors"]
            rows.append({"radius, mm": radius, "retained in the deck's, g": 1e3 * mass, "crosses": errors is not None,
                         **{name: f"{value:.3f}" + (f" +- {errors[k]:.3f}" if errors else "")
                            for k, (name, value) in enumerate(zip(calibration.parameters, point["values"]))},
                         "T": 0.0 if errors else nearest["misfit"],
                         "T of the thesis's": misfit_at(estimate["surfaces"], thesis), **region})
    return rows
