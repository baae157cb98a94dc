"""output.contacts and output.walls: VTK reads the contacts and the walls beside each snapshot. On each grain of a bed
at rest the forces add up to its weight; walls are where they are at the time; both are the same on any number of ranks.

Usage: contacts_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import filecmp
import glob
import os
import sys
import unittest

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from repose_runs import FolderTest, Program

sys.dont_write_bytecode = True

RUN = ["particles.0.mass=0.03 g", "particles.0.height=15 mm", "phase.settle.max_time=400 ms",
       "phase.settle.min_time=400 ms",
       "phase.settle.kinetic_energy=1e-40", "phase.discharge.max_time=1 ms", "phase.discharge.min_time=1 ms",
       "output.snapshot_interval=50 ms", "output.contacts=true", "output.walls=true"]
VESSEL, LID, PLATE = 0, 1, 2
GRAVITY = 9.81


# Three grains that nothing touches, and walls of all kinds on their way.
SCENE = """
[domain]
min = [-0.1, -0.1, -0.1]
max = [0.1, 0.1, 0.1]
[[material]]
name = "glass"
youngs_modulus = 5e6
poisson_ratio = 0.25
density = 2500.0
[[pair]]
materials = ["glass", "glass"]
restitution = 0.6
sliding_friction = 0.4
rolling_friction = 0.05
[[wall]]
name = "floor"
type = "plane"
material = "glass"
point = [0.0, 0.0, -0.09]
[[wall.motion]]
type = "translation"
velocity = [0.0, 0.0, 0.5]
phases = ["move"]
[[wall]]
name = "door"
type = "rectangle"
material = "glass"
corner = [0.05, 0.0, -0.01]
edge_u = [0.02, 0.0, 0.0]
edge_v = [0.0, 0.0, 0.03]
[[wall.motion]]
type = "rotation"
angular_velocity = 157.07963267948966
[[wall]]
name = "piston"
type = "disc"
material = "glass"
centre = [-0.05, 0.0, 0.05]
radius = 0.01
[[wall.motion]]
type = "oscillation"
amplitude = [0.0, 0.0, 0.004]
frequency = 25.0
[[wall]]
name = "wedge"
type = "mesh"
material = "glass"
file = "wedge.stl"
scale = 0.001
[[wall.motion]]
type = "translation"
velocity = [0.0, -2.0, 0.0]
[[wall]]
name = "ring"
type = "profile"
material = "glass"
present = false
points = [[0.09, 0.01], [0.08, 0.0]]
[[particles]]
type = "lattice"
material = "glass"
diameter = 0.001
counts = [3, 1, 1]
spacing = 0.004
first = [0.0, 0.0, 0.05]
[time]
step = 5e-6
[[phase]]
name = "wait"
until = "steps"
steps = 1000
[[phase]]
name = "move"
until = "steps"
steps = 1000
add_walls = ["ring"]
remove_walls = ["piston"]
[output]
snapshot_interval = "5 ms"
walls = true
"""
WEDGE = np.array([[[0.0, 60.0, 0.0], [10.0, 60.0, 0.0], [0.0, 60.0, 20.0]],
                  [[0.0, 60.0, 0.0], [0.0, 60.0, 20.0], [0.0, 80.0, 0.0]]])


def poly_data(path):
    """What VTK reads, and its arrays of cells by name."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    cells = reader.GetOutput().GetCellData()
    names = [cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())]
    return reader.GetOutput(), {name: vtk_to_numpy(cells.GetArray(name)) for name in names}


class Walls:
    """The walls of a file as VTK reads them: corners of the polygons of each, by its place in the deck."""

    def __init__(self, path):
        data, arrays = poly_data(path)
        assert data.GetNumberOfPolys() == data.GetNumberOfCells() == len(arrays["wall"])
        points = vtk_to_numpy(data.GetPoints().GetData())
        self.time = data.GetFieldData().GetArray("TimeValue").GetValue(0)
        self.polygons = {}
        for k, wall in enumerate(arrays["wall"].tolist()):
            cell = data.GetCell(k)
            corners = points[[cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]]
            self.polygons.setdefault(wall, []).append(corners)

    def box(self, wall):
        corners = np.concatenate(self.polygons[wall])
        return np.array([corners.min(axis=0), corners.max(axis=0)])


class Lines:
    """The contacts of a file as VTK reads them."""

    def __init__(self, path):
        data, self.arrays = poly_data(path)
        self.count = data.GetNumberOfLines()
        points = vtk_to_numpy(data.GetPoints().GetData())
        ends = [[data.GetCell(k).GetPointId(end) for end in (0, 1)] for k in range(self.count)]
        self.centre, self.other = (points[np.array(ends).reshape(-1, 2)[:, end]] for end in (0, 1))
        self.time = data.GetFieldData().GetArray("TimeValue").GetValue(0)

    def force_on(self, grains):
        """The sum of the contacts' forces on each."""
        force = self.arrays["normal_force"] + self.arrays["tangential_force"]
        total = np.zeros((grains, 3))
        np.add.at(total, self.arrays["first"], force)
        between = self.arrays["second"] >= 0
        np.add.at(total, self.arrays["second"][between], -force[between])
        return total


class Contacts(FolderTest):
    def run_on(self, ranks, *settings):
        output = self.path(f"run{ranks}")
        self.program.run(self.program.deck("discharge_quick.toml"), output, *RUN, *settings, ranks=ranks)
        return output

    def test_on_each_grain_at_rest_they_add_up_to_its_weight(self):
        output = self.run_on(2)
        snapshots, files = (sorted(glob.glob(f"{output}/{name}")) for name in ("run_*.hdf", "contacts_*.vtp"))
        self.assertEqual([os.path.basename(path)[9:19] for path in files],
                         [os.path.basename(path)[4:14] for path in snapshots])
        with h5py.File(snapshots[-2]) as file:  # before the lid goes
            mass, radius, position = (file["particles"][name][...] for name in ("mass", "radius", "position"))
            self.assertEqual(list(file["particles/id"][...]), list(range(len(mass))))
            time = file.attrs["time_s"]
        lines = Lines(files[-2])
        self.assertEqual(lines.time, time)
        between = lines.arrays["second"] >= 0
        self.assertTrue(np.all(lines.arrays["first"][between] < lines.arrays["second"][between]))
        self.assertTrue(np.all(lines.arrays["wall"][between] == -1))
        self.assertEqual(set(lines.arrays["wall"][~between]), {VESSEL, LID})
        weight = GRAVITY * mass
        off = lines.force_on(len(mass)) - np.outer(weight, [0, 0, 1])
        self.assertLess(np.abs(off).max(), 1e-4 * weight.max())
        on_walls = (lines.arrays["normal_force"] + lines.arrays["tangential_force"])[~between].sum(axis=0)
        np.testing.assert_allclose(on_walls / weight.sum(), [0, 0, 1], atol=1e-5)
        # Lines run from the grains, and are as long as what touches.
        np.testing.assert_array_equal(lines.centre, position[lines.arrays["first"]])
        np.testing.assert_array_equal(lines.other[between], position[lines.arrays["second"][between]])
        length = np.linalg.norm(lines.centre - lines.other, axis=1)
        reach = radius[lines.arrays["first"]] + np.where(between, radius[lines.arrays["second"]], 0.0)
        self.assertTrue(np.all((length < reach) & (length > 0.9 * reach)))
        branch = (lines.centre - lines.other) / length[:, np.newaxis]
        normal = np.sum(lines.arrays["normal_force"] * branch, axis=1)
        across = lines.arrays["normal_force"] - normal[:, np.newaxis] * branch
        self.assertLess(np.abs(across).max(), 1e-9 * normal.max())
        self.assertLess(np.abs(np.sum(lines.arrays["tangential_force"] * branch, axis=1)).max(), 1e-9 * normal.max())
        self.assertGreater(np.linalg.norm(lines.arrays["tangential_force"], axis=1).max(), 0.05 * normal.max())
        self.assertNotIn(LID, Lines(files[-1]).arrays["wall"])
        self.check_package(output, files, lines, mass)
        walls = [Walls(path) for path in sorted(glob.glob(f"{output}/walls_*.vtp"))]
        self.assertEqual([w.time for w in walls], [Lines(path).time for path in files])
        self.assertEqual([set(w.polygons) for w in walls],
                         [{VESSEL, LID, PLATE}] * (len(walls) - 1) + [{VESSEL, PLATE}])
        np.testing.assert_allclose(walls[0].box(VESSEL), [[-4e-3, -4e-3, 0.0], [4e-3, 4e-3, 40e-3]], atol=1e-15)
        self.assertLess(np.linalg.norm(lines.other[lines.arrays["wall"] == LID][:, :2], axis=1).max(), 1.75e-3)

    def check_package(self, output, files, lines, mass):
        """The Python package reads what VTK reads."""
        import repose
        run = repose.Run(output)
        self.assertEqual([run.contacts(n).time_s for n in range(len(files))], [s.time_s for s in run.snapshots])
        found = run.contacts(-2)
        self.assertEqual(len(found), lines.count)
        for name, values in (*lines.arrays.items(), ("centre", lines.centre), ("other", lines.other)):
            np.testing.assert_array_equal(getattr(found, name), values)
        some = [7, 3, len(mass) - 1]
        np.testing.assert_allclose(found.force_on(some), lines.force_on(len(mass))[some], rtol=0.0, atol=1e-18)
        self.assertEqual(found.force_on([]).shape, (0, 3))
        damaged, walls = self.path("damaged.vtp"), files[0].replace("contacts", "walls")
        with open(files[-1], "rb") as whole, open(damaged, "wb") as file:
            file.write(whole.read()[:-400])
        for message, read in ((f"has no snapshot 99, but {len(files)} of them", lambda: run.contacts(99)),
                              ("is no PolyData of repose, or damaged", lambda: repose.ContactForces(damaged)),
                              ("vtp: has no contacts", lambda: repose.ContactForces(walls)),
                              ("cannot be read", lambda: repose.ContactForces(self.path("absent.vtp")))):
            self.assertRaisesRegex(repose.ReposeError, message, read)
        os.rename(files[0], self.path("away"))  # as of a run that was asked for contacts later on
        self.assertEqual(run.contacts(-1).time_s, run.snapshots[-1].time_s)
        self.assertEqual(run.contacts(1).time_s, run.snapshots[1].time_s)
        self.assertRaisesRegex(repose.ReposeError, "contacts_.*vtp: is missing", lambda: run.contacts(0))
        os.rename(self.path("away"), files[0])

    def test_walls_stand_where_they_are_at_the_time(self):
        deck, output = self.path("scene.toml"), self.path("run")
        with open(deck, "w") as file:
            file.write(SCENE)
        with open(self.path("wedge.stl"), "w") as file:
            facets = ["facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners) +
                      "endloop\nendfacet\n" for corners in WEDGE]
            file.write("solid wedge\n" + "".join(facets) + "endsolid wedge\n")
        self.program.run(deck, output, ranks=2)
        names = sorted(name for name in os.listdir(output) if name.startswith("walls_"))
        self.assertEqual(names, ["walls_0000001000.vtp", "walls_0000002000.vtp"])
        self.assertEqual([name for name in os.listdir(output) if name.startswith("contacts_")], [])
        waited, moved = (Walls(os.path.join(output, name)) for name in names)
        self.assertEqual((set(waited.polygons), set(moved.polygons)), ({0, 1, 2, 3}, {0, 1, 3, 4}))

        def near(walls, wall, low, high):
            np.testing.assert_allclose(walls.box(wall), [low, high], atol=1e-9)

        near(waited, 0, [-0.1, -0.1, -0.09], [0.1, 0.1, -0.09])
        near(moved, 0, [-0.1, -0.1, -0.0875], [0.1, 0.1, -0.0875])
        turn = np.pi / 4
        along = np.array([np.cos(turn), np.sin(turn), 0.0])
        near(waited, 1, 0.05 * along + [0.0, 0.0, -0.01], 0.07 * along + [0.0, 0.0, 0.02])
        near(moved, 1, [0.0, 0.05, -0.01], [0.0, 0.07, 0.02])
        height = 0.05 + 0.004 * np.sin(2 * np.pi * 25 * 0.005)
        near(waited, 2, [-0.06, -0.01, height], [-0.04, 0.01, height])
        for walls, way in ((waited, 0.01), (moved, 0.02)):
            np.testing.assert_allclose(walls.polygons[3], 1e-3 * WEDGE - [0.0, way, 0.0], atol=1e-9)
        near(moved, 4, [-0.09, -0.09, 0.0], [0.09, 0.09, 0.01])
        self.assertEqual(len(moved.polygons[4]), 72)

    def test_they_are_the_same_on_any_number_of_ranks(self):
        short = ["phase.settle.max_time=60 ms", "phase.settle.min_time=60 ms", "output.snapshot_interval=15 ms"]
        one, three = (self.run_on(ranks, *short) for ranks in (0, 3))
        names = sorted(name for name in os.listdir(one) if name.endswith(".vtp"))
        self.assertGreaterEqual(len(names), 8)
        self.assertEqual(filecmp.cmpfiles(one, three, names, shallow=False)[0], names)
        last = max(name for name in names if name.startswith("contacts_"))
        self.assertGreater(Lines(os.path.join(one, last)).count, 100)

    def test_those_of_an_earlier_run_go(self):
        output = self.path("run0")
        os.mkdir(output)
        for name in ("contacts_0000000007.vtp", "walls_0000000007.vtp", "contacts_mine.vtp"):
            open(os.path.join(output, name), "w").close()
        self.run_on(0, "phase.settle.max_time=1 ms", "phase.settle.min_time=1 ms", "output.contacts=false",
                    "output.walls=false")
        self.assertEqual([name for name in os.listdir(output) if name.endswith(".vtp")], ["contacts_mine.vtp"])


if __name__ == "__main__":
    Contacts.program = Program(*sys.argv[1:4])
    sys.path.insert(0, os.path.join(Contacts.program.source, "tools", "python"))
    unittest.main(argv=sys.argv[:1], verbosity=2)
