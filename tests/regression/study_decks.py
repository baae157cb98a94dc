"""Studies of runs of two hundred grains, for the tests of the Python package and of reports. What the grains do does
not matter."""

import json

REDUCED = ["particles.0.mass=0.03 g", "particles.0.height=20 mm", "output.snapshot_interval=0",
           "phase.settle.max_time=15 ms",
           "phase.settle.min_time=0", "phase.discharge.max_time=60 ms", "phase.discharge.min_time=0",
           "measurement.discharge.plugged_share=0.02"]
SLIDING = '[[parameter]]\nname = "sliding"\nkey = "pair.0.sliding_friction"\n'
RESTITUTION = '[[parameter]]\nname = "restitution"\nkey = "pair.0.restitution"\n'
RANGES = SLIDING + "min = 0.1\nmax = 0.7\n" + RESTITUTION + "min = 0.2\nmax = 0.8\n"
MASS = '[[observable]]\nfigure = "discharged_mass_kg"\nlaboratory = 8e-6\ndeviation = 1e-6\nrepeats = 4\n'
REST = '[[observable]]\nfigure = "retained_mass_kg"\nlaboratory = 22e-6\ndeviation = 1e-6\nrepeats = 4\n'
GRID = SLIDING + "values = [0.1, 0.4]\n" + RESTITUTION + "min = 0.2\nmax = 0.8\npoints = 3\n" + MASS + REST
SEARCH = (RANGES + MASS + REST +
          'discrepancy_share = 0.1\n[[level]]\nname = "small"\nset = ["particles.0.mass=0.02 g"]\n'
          'start = 6\n[[level]]\nname = "large"\n'
          "[adaptive]\nstart = 4\nbatch = 2\nbudget_core_hours = 0.0027\nhalf_width = 0.01\n")
MORRIS = ('figures = ["discharged_mass_kg"]\n[morris]\ntrajectories = 2\n' + SLIDING +
          "min = 0.1\nmax = 0.7\nfixed = 0.4\n" +
          RESTITUTION + "min = 0.2\nmax = 0.8\nfixed = 0.5\n")
CASE = """
[[case]]
name = "{name}"
deck = "{deck}"
set = {set}
[[case.compare]]
figure = "discharged_mass_kg"
laboratory = 40e-6
deviation = 2e-6
published = 41e-6
[[case.compare]]
figure = "{figure}"
laboratory = 30.0
"""


def case_text(name, deck, set, figure="angle_of_repose_deg"):
    """A case of a validation."""
    return CASE.format(name=name, deck=deck, set=json.dumps(set), figure=figure)


def head(base, title="in small"):
    """What the file of a study begins with."""
    return f'title = {json.dumps(title)}\nbase = "{base}"\nseeds = 2\nset = {json.dumps(REDUCED)}\n'
