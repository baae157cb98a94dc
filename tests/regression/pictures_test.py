"""The tools that draw a run: what they write is there, is not empty, and shows the run; the walls of a deck have the right
places and areas for VTK; a folder that is no run is refused in one line.

Usage: pictures_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import math
import os
import subprocess
import sys
import unittest
import warnings
from types import SimpleNamespace

import matplotlib.image
import numpy as np
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from repose_runs import Program, SharedFolderTest, read_series

REDUCED = ("particles.0.mass=0.1 g", "phase.settle.max_time=20 ms", "phase.settle.min_time=1 ms",
           "phase.discharge.max_time=80 ms", "phase.discharge.min_time=80 ms", "output.series_interval=2 ms")
SIDES = 72  # of a circle in repose.walls


def ring(r):
    """Area and radius of a circle as a polygon."""
    return 0.5 * SIDES * r * r * math.sin(2.0 * math.pi / SIDES)


class Pictures(SharedFolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.run_folder = os.path.join(cls.folder, "run")
        cls.program.run(cls.program.deck("discharge_quick.toml"), cls.run_folder, *REDUCED)

    def tool(self, name, *arguments):
        return subprocess.run([os.path.join(self.program.source, "tools", name), *arguments], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=120, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})

    def test_the_course_of_a_run(self):
        output = os.path.join(self.folder, "pictures")
        done = self.tool("plot_run.py", self.run_folder, "--output", output)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = [f"{name}.{ending}" for name in ("discharge", "energies", "grains", "speeds", "walls") for ending in ("pdf", "png")]
        self.assertEqual(sorted(os.listdir(output)), sorted(names))
        for name in names:
            path = os.path.join(output, name)
            if name.endswith(".png"):
                image = matplotlib.image.imread(path)[..., :3]
                coloured = np.ptp(image, axis=2) > 0.3
                self.assertGreater(coloured.mean(), 1e-3, f"{name}: no curve")
                self.assertGreater((image.min(axis=2) == 1.0).mean(), 0.5, f"{name}: no white ground")
            else:
                with open(path, "rb") as file:
                    self.assertEqual(file.read(5), b"%PDF-")
        self.assertGreater(read_series(self.run_folder)[-1]["discharged_mass_kg"], 0.0, "nothing to draw")

    def test_what_is_not_there_is_not_drawn(self):
        """The first rows of a run: no grain has moved below, none touches a wall."""
        begun, output = os.path.join(self.folder, "begun"), os.path.join(self.folder, "begun_pictures")
        os.mkdir(begun)
        for name in ("series.csv", "walls.csv", "deck.resolved.toml"):
            with open(os.path.join(self.run_folder, name)) as source, open(os.path.join(begun, name), "w") as copy:
                copy.writelines(source.readlines()[:2 if name.endswith(".csv") else None])
        done = self.tool("plot_run.py", begun, "--output", output)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(sorted(os.listdir(output)), ["energies.pdf", "energies.png"])

    def test_walls_go_in_a_phase_too_short_for_a_row(self):
        from repose.plots.course import first_rows, is_present
        series = {"time_s": np.array([0.0, 1.0, 2.0, 3.0]), "phase": np.array([0.0, 0.0, 2.0, 2.0])}
        deck = {"phase": [{"name": "settle"}, {"name": "open", "remove_walls": ["lid"]},
                          {"name": "discharge", "add_walls": ["gate"]}]}
        for wall, present in (({"name": "lid"}, [True, True, True, False]),
                              ({"name": "gate", "present": False}, [False, False, False, True])):
            self.assertEqual(is_present(wall, series["time_s"], first_rows(series), deck).tolist(), present, wall["name"])

    def test_a_phase_begins_between_two_rows(self):
        from repose.plots.course import phase_begins
        series = {"time_s": np.array([0.0, 0.2, 0.4, 0.6]), "phase": np.array([0.0, 0.0, 0.0, 1.0])}
        summary = {"timestep_s": 0.1, "phases": [{"steps": 4}, {"steps": 7}]}
        run = SimpleNamespace(series=series, summary=summary, is_complete=True)
        self.assertEqual(phase_begins(run).tolist(), [0.0, 0.4])
        run.is_complete = False
        self.assertEqual(phase_begins(run).tolist(), [0.0, 0.6])

    def test_names_of_phases_cover_no_other(self):
        from repose.plots.course import rows_of_names
        self.assertEqual(rows_of_names([0.0, 0.02, 0.05, 0.1, 0.13], [0.1, 0.1, 0.02, 0.1, 0.1]), [0, 1, 2, 0, 1])

    def test_the_weight_is_that_of_all_grains_that_were_poured(self):
        from repose.plots.course import weight_of_grains

        class Grains(list):
            mass = property(np.array)

        run = SimpleNamespace(snapshots=[Grains([1.0]), Grains([1.0, 2.0]), Grains([2.0])], deck={"gravity": [0.0, 0.0, -10.0]})
        self.assertEqual(weight_of_grains(run), 30.0)
        self.assertIsNone(weight_of_grains(SimpleNamespace(snapshots=[])))

    def test_effects_that_are_none_keep_their_places(self):
        from repose.plots import effect
        some = {"effect": 1e-3, "standard_error": 1e-4}
        for second, count in (({"effect": None, "standard_error": None}, 2), (some, 1)):
            found = {"sliding_friction": {"effect": None, "standard_error": None}, "restitution": second}
            study = SimpleNamespace(parameters=list(found), effects=lambda figure, found=found: found)
            with warnings.catch_warnings(action="error"):
                figure = effect(study, "angle_of_repose_deg")
                figure.savefig(os.path.join(self.folder, "effects.png"))
            axes = figure.axes[0]
            self.assertEqual([label.get_text() for label in axes.get_yticklabels()], ["sliding friction", "restitution"])
            self.assertEqual([text.get_text() for text in axes.texts], ["none"] * count)
            self.assertEqual(len(axes.patches), 2 - count)

    def test_a_yield_locus_takes_several_runs(self):
        done = self.tool("shear.py", "--yield-locus", self.run_folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^shear.py: --yield-locus needs .*\n$")

    def test_a_folder_that_is_no_run(self):
        done = self.tool("plot_run.py", self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^plot_run.py: .* is no directory of a run: .*\n$")

    def surfaces(self, deck, folder=None):
        """Bounds and area of each wall, as VTK reads it."""
        from repose.walls import vtp_of, wall_surfaces
        found = {}
        for name, _, points, polygons in wall_surfaces(deck, folder):
            path = os.path.join(self.folder, "wall.vtp")
            with open(path, "w") as file:
                file.write(vtp_of(points, polygons))
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(path)
            triangles = vtkTriangleFilter()
            triangles.SetInputConnection(reader.GetOutputPort())
            mass = vtkMassProperties()
            mass.SetInputConnection(triangles.GetOutputPort())
            mass.Update()
            found[name] = reader.GetOutput().GetBounds(), mass.GetSurfaceArea()
        return found

    def check(self, surface, bounds, area):
        self.assertTrue(np.allclose(surface[0], bounds, rtol=0.0, atol=1e-9), surface[0])
        self.assertAlmostEqual(surface[1] / area, 1.0, delta=1e-6)

    def test_walls_of_the_quick_deck(self):
        walls = self.surfaces(os.path.join(self.run_folder, "deck.resolved.toml"))
        self.assertEqual(list(walls), ["vessel", "lid", "plate"])
        side = SIDES * 2.0 * 0.004 * math.sin(math.pi / SIDES) * 0.04
        self.check(walls["vessel"], (-0.004, 0.004, -0.004, 0.004, 0.0, 0.04), side + ring(0.004) - ring(0.00175))
        self.check(walls["lid"], (-0.00175, 0.00175, -0.00175, 0.00175, 0.0, 0.0), ring(0.00175))
        self.check(walls["plate"], (-0.015, 0.015, -0.015, 0.015, -0.01, -0.01), 9e-4)

    def test_planes_end_at_the_domain_and_meshes_are_placed(self):
        deck = os.path.join(self.folder, "walls.toml")
        with open(deck, "w") as file:
            file.write('[domain]\nmin = [0.0, 0.0, 0.0]\nmax = [1.0, 2.0, 3.0]\n'
                       '[[wall]]\nname = "level"\ntype = "plane"\npoint = [9.0, 0.0, 1.0]\nnormal = [0.0, 0.0, 1.0]\n'
                       '[[wall]]\nname = "slope"\ntype = "plane"\npoint = [0.5, 0.0, 0.5]\nnormal = [-1.0, 0.0, 1.0]\n'
                       '[[wall]]\nname = "mesh"\ntype = "mesh"\nfile = "one.stl"\nscale = 0.5\nrotate_axis = [0.0, 0.0, 2.0]\n'
                       'rotate_angle = 90.0\ntranslate = [1.0, 1.0, 1.0]\n')
        with open(os.path.join(self.folder, "one.stl"), "w") as file:
            file.write("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
                       "endsolid s\n")
        walls = self.surfaces(deck)
        self.check(walls["level"], (0.0, 1.0, 0.0, 2.0, 1.0, 1.0), 2.0)
        self.check(walls["slope"], (0.0, 1.0, 0.0, 2.0, 0.0, 1.0), 2.0 * math.sqrt(2.0))
        self.check(walls["mesh"], (0.5, 1.0, 1.0, 2.0, 1.0, 1.0), 0.25)

    def test_the_hopper_of_triangles(self):
        output = os.path.join(self.folder, "hopper")
        done = self.program.call("run", self.program.deck("mesh_hopper.toml"), "--output", output, "--time-limit", "00:00:01")
        self.assertIn(done.returncode, (0, 75), done.stderr)
        walls = self.surfaces(os.path.join(output, "deck.resolved.toml"), os.path.join(self.program.source, "input"))
        self.assertEqual(list(walls), ["hopper", "lid", "plate"])
        half = math.pi / 24  # of a facet of a cylinder of 12 mm, above a cone to 5 mm
        edge, outlet = 0.024 * math.sin(half), 0.010 * math.sin(half)
        slant = math.hypot(0.007 * math.cos(half), 0.02)
        self.check(walls["hopper"], (-0.012, 0.012, -0.012, 0.012, 0.0, 0.06),
                   24 * (0.04 * edge + 0.5 * slant * (edge + outlet)))
        self.check(walls["lid"], (-0.005, 0.005, -0.005, 0.005, 0.0, 0.0), ring(0.005))


if __name__ == "__main__":
    Pictures.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
