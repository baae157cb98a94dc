"""A hopper from an STL file: the same bits on one and on four ranks and whatever the lists, no grain through the wall, and
the discharge of the same hopper as a profile.

Usage: mesh_hopper_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import os
import re
import shutil
import sys
import tempfile

from repose_runs import Program, read_series

SHORT = ("phase.fill.time=0.15", "phase.discharge.time=0.35")
LISTS = ("neighbours.skin=0.8", "neighbours.inner_skin=0.05")
PROFILE = """type = "profile"
material = "steel"
points = [["5 mm", 0.0], ["12 mm", "20 mm"], ["12 mm", "60 mm"]]
"""


def with_profile(program, folder):
    """The deck with the mesh's wall in closed form."""
    with open(program.deck("mesh_hopper.toml")) as file:
        text = file.read()
    text, count = re.subn(r'type = "mesh".*?scale[^\n]*\n', PROFILE, text, flags=re.DOTALL)
    assert count == 1, text
    path = os.path.join(folder, "profile.toml")
    with open(path, "w") as file:
        file.write(text)
    return path


def check_report(program, folder):
    """The defects of a mesh are told before a run; a file that is no STL is refused in one line."""
    deck = shutil.copy(program.deck("mesh_hopper.toml"), folder)
    with open(program.deck("hopper.stl")) as file:
        text = file.read()
    facet = text[text.index(" facet"):text.index("endfacet") + len("endfacet\n")]
    stl = os.path.join(folder, "hopper.stl")
    with open(stl, "w") as file:
        file.write(text.replace("endsolid", facet + "endsolid"))
    told = program.call("check", deck)
    assert told.returncode == 0, told.stderr
    assert "96 triangles in 48 flat patches; 48 edges with one triangle" in told.stdout, told.stdout
    assert "1 duplicate" in told.stdout, told.stdout
    place = re.search(r"1 duplicate; from \((.*)\) to \((.*)\) m", told.stdout)
    larger = program.call("check", deck, "--set", "wall.hopper.scale=1").stdout
    assert place and place[0] not in larger, told.stdout + larger
    with open(stl, "w") as file:
        file.write(text[:5000])
    refused = program.call("check", deck)
    assert refused.returncode == 2 and refused.stderr.count("\n") == 1, refused
    assert "hopper.stl:" in refused.stderr, refused.stderr


def main():
    program = Program(*sys.argv[1:4])
    deck = program.deck("mesh_hopper.toml")
    with tempfile.TemporaryDirectory() as folder:
        check_report(program, folder)
        alone, lists, profile = program.run_all([
            (deck, f"{folder}/alone", *SHORT), (deck, f"{folder}/lists", *SHORT, *LISTS),
            (with_profile(program, folder), f"{folder}/profile", *SHORT)])
        together = program.run(deck, f"{folder}/together", *SHORT, ranks=4)
        escaped = [row["discharged_mass_kg"] for row in read_series(f"{folder}/alone") if row["time_s"] < 0.15]
    assert alone["state_hash"] == together["state_hash"] == lists["state_hash"]
    assert alone["lists"]["rebuilds"] != lists["lists"]["rebuilds"]
    assert len(escaped) > 10 and max(escaped) == 0.0, escaped
    print("discharge", alone["discharge_time_s"], "s, profile", profile["discharge_time_s"], "s")
    assert alone["discharged_mass_kg"] > 0.99 * profile["discharged_mass_kg"]
    assert abs(alone["discharge_time_s"] / profile["discharge_time_s"] - 1.0) < 0.1


main()
