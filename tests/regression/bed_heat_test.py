"""Heat in grains from outside: what beds at rest conduct is what the network of their snapshots conducts; pictures of it.

Usage: bed_heat_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import json
import os
import re
import subprocess
import sys

import h5py
import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from repose_runs import Program, SharedFolderTest

PERIOD = 2.64e-3  # m, of packed_bed_charging.toml
RADIUS = 220e-6
SOLID = {"conductivity": 2.0, "specific_heat": 800.0, "emissivity": 0.9, "stiffness_ratio": 2.5e-5}
TEMPERATURE = 300.0  # K, about which all differ little

HEAD = f"""
[domain]
min = [0.0, 0.0, -0.001]
max = [{PERIOD}, {PERIOD}, 0.02]
periodic = ["x", "y"]
[[material]]
name = "carbohsp"
youngs_modulus = 5e6
poisson_ratio = 0.3
density = 3592.0
{{solid}}
[[pair]]
materials = ["carbohsp", "carbohsp"]
restitution = 0.5
sliding_friction = 0.5
rolling_friction = 0.1
[time]
step = 5e-6
[[phase]]
name = "rest"
until = "time"
time = {{time!r}}
mechanics = false
[heat]
temperature = {TEMPERATURE!r}
every = {{every}}
{{heat}}
"""
BLOCK = '[[particles]]\ntype = "csv"\nfile = "{file}"\ntemperature = {temperature!r}\nisothermal = {isothermal}\n'
WALL = """[[wall]]
name = "{name}"
type = "plane"
material = "carbohsp"
point = [0.0, 0.0, {level!r}]
normal = [0.0, 0.0, {normal}]
[wall.heat]
type = "temperature"
temperature = {temperature!r}
"""


class Heat(SharedFolderTest):
    def deck(self, name, time, every, heat, solid=SOLID):
        """Begins a deck of grains that stay where they are."""
        properties = "\n".join(f"{key} = {value!r}" for key, value in solid.items())
        path = self.path(name)
        with open(path, "w") as file:
            file.write(HEAD.format(solid=properties, time=time, every=every, heat=heat))
        return path

    def append(self, path, text):
        with open(path, "a") as file:
            file.write(text)

    def grains(self, name, positions):
        """A list of grains, each number written so that it reads back exactly."""
        with open(self.path(name), "w") as file:
            file.write("x,y,z,radius,material\n")
            file.writelines(",".join(repr(float(x)) for x in row) + f",{RADIUS!r},carbohsp\n" for row in positions)
        return name

    def run_of(self, name):
        import repose
        return repose.Run(self.path(name))

    def last_snapshot(self, name):
        return self.run_of(name).snapshots[-1]

    def network(self, snapshot, low, high, *overrides, solid=SOLID):
        """The row at TEMPERATURE of `repose thermal network`, its porosity beside it."""
        path = self.path(self.id() + "_network.toml")
        keys = ("conductivity", "emissivity", "stiffness_ratio")
        with open(path, "w") as file:
            file.write('[[material]]\nname = "carbohsp"\n' + "\n".join(f"{key} = {solid[key]!r}" for key in keys) +
                       f'\n[box]\nmin = [0.0, 0.0, {low!r}]\nmax = [{PERIOD!r}, {PERIOD!r}, {high!r}]\nperiodic = ["x", "y"]\n'
                       f"[temperature]\nmin = {TEMPERATURE!r}\nmax = {TEMPERATURE!r}\ncount = 1\n")
        settings = [word for override in overrides for word in ("--set", override)]
        done = self.program.call("thermal", "network", str(snapshot.path), "--deck", path, "--output", self.path("network"), *settings)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("network", "network.json")) as file:
            bed, = json.load(file)["beds"]
        return bed["porosity"], bed["conductivity"][0]["conductivity_W_mK"]

    def test_a_packed_bed_conducts_as_the_network_of_its_snapshot(self):
        """Grains beyond two levels keep the temperatures of a uniform gradient; when all others have come to rest between
        them the heat that crosses the bed is that of the network."""
        settled = self.program.run(self.program.deck("packed_bed_charging.toml"), self.path("settled"), "particles.0.count=300",
                                   "phase.charge.time=0.01", "measurement.bulk_density.max=[2.64e-3, 2.64e-3, 3e-3]")
        self.assertEqual(settled["particles"]["inside"], 300)
        bed = self.last_snapshot("settled")
        z = bed.position[:, 2]
        low, high = 0.8e-3, float(np.quantile(z, 0.85))
        porosity, conductivity = self.network(bed, low, high)

        gradient = 10.0  # K/m
        given = TEMPERATURE + gradient * (z - 0.5 * (low + high))
        free = (z > low) & (z < high)
        self.assertTrue(100 < np.count_nonzero(free) < 250)
        models = f'gas = "air"\nradiation = true\nporosity = {porosity!r}\n'
        steady = self.deck("steady.toml", 150.0, 25000, models)
        self.append(steady, BLOCK.format(file=self.grains("free.csv", bed.position[free]), temperature=TEMPERATURE, isothermal="false"))
        for k in np.flatnonzero(~free):
            self.append(steady, BLOCK.format(file=self.grains(f"{k}.csv", bed.position[k:k + 1]), temperature=float(given[k]),
                                             isothermal="true"))
        self.program.run(steady, self.path("steady"))
        # One more thermal step in which none is held: what the hot ones lose is what crosses the bed.
        begin = self.last_snapshot("steady")
        step = 25000 * 5e-6
        release = self.deck("release.toml", step, 25000, models)
        self.append(release, f'[[particles]]\ntype = "snapshot"\nfile = "{begin.path}"\n')
        self.program.run(release, self.path("release"))
        end = self.last_snapshot("release")
        np.testing.assert_array_equal(begin.position, end.position)
        capacity = 3592.0 * 4.0 / 3.0 * np.pi * RADIUS ** 3 * SOLID["specific_heat"]
        rise = end["temperature"] - begin["temperature"]
        hot, cold = begin.position[:, 2] >= high, begin.position[:, 2] <= low
        lost, gained = -capacity * rise[hot].sum() / step, capacity * rise[cold].sum() / step
        self.assertAlmostEqual(gained / lost, 1.0, delta=1e-6)  # it is steady
        self.assertAlmostEqual(lost / (gradient * PERIOD ** 2) / conductivity, 1.0, delta=1e-6)

    def test_a_cubic_lattice_between_walls_conducts_as_its_network(self):
        solid = SOLID | {"emissivity": 1e-15, "stiffness_ratio": 1.0}
        spacing, layers = PERIOD / 6, 12
        overlap = 2 * RADIUS - spacing
        self.assertLess(abs(overlap), 1e-12)
        spacing_z = 2 * RADIUS * 0.999
        places = np.array([(PERIOD / 6 * (i + 0.5), PERIOD / 6 * (j + 0.5), RADIUS + spacing_z * k)
                           for k in range(layers) for j in range(6) for i in range(6)])
        lattice = self.deck("lattice.toml", 3000.0, 60000, "", solid)
        self.append(lattice, BLOCK.format(file=self.grains("lattice.csv", places), temperature=TEMPERATURE, isothermal="false"))
        top = float(places[-1, 2] + RADIUS)
        depth = 0.5 * (2 * RADIUS - spacing_z)
        for name, level, normal, temperature in (("cold", depth, 1, TEMPERATURE - 10.0), ("hot", top - depth, -1, TEMPERATURE + 10.0)):
            self.append(lattice, WALL.format(name=name, level=level, normal=normal, temperature=temperature))
        self.append(lattice, "[output]\nseries_interval = 30.0\n")
        self.program.run(lattice, self.path("lattice"))
        snapshot = self.last_snapshot("lattice")
        walls = self.run_of("lattice").walls
        flux = {name: np.diff(walls[f"{name}_heat_J"][-2:])[0] / np.diff(walls["time_s"][-2:])[0] / PERIOD ** 2
                for name in ("cold", "hot")}
        self.assertAlmostEqual(flux["hot"] / -flux["cold"], 1.0, delta=1e-9)
        layer = np.rint((snapshot.position[:, 2] - RADIUS) / spacing_z)
        means = np.array([snapshot["temperature"][layer == k].mean() for k in range(layers)])
        gradient = (means[-1] - means[0]) / (spacing_z * (layers - 1))
        # In as good as no air, and without radiation: contacts alone.
        _, conductivity = self.network(snapshot, float(places[36, 2] + 0.5 * spacing_z), float(places[-36, 2] - 0.5 * spacing_z),
                                       "pressure=1e-30", "max_gap=0", solid=solid)
        self.assertAlmostEqual(flux["hot"] / gradient / conductivity, 1.0, delta=1e-9)

    def test_exports_have_the_temperatures(self):
        deck = self.deck("exported.toml", 1.0, 20000, "")
        for k, temperature in enumerate((310.0, 350.0)):
            place = (0.3e-3, 0.3e-3, (k + 1) * 5e-3)  # alone: it keeps its temperature
            self.append(deck, BLOCK.format(file=self.grains(f"alone_{k}.csv", [place]), temperature=temperature, isothermal="false"))
        self.program.run(deck, self.path("exported"))
        snapshot = self.last_snapshot("exported")
        expected = snapshot["temperature"].tolist()
        self.assertEqual([round(value, 6) for value in expected], [310.0, 350.0])
        for form in ("vtp", "h5md"):
            done = self.program.call("export", str(snapshot.path), "--format", form, "--output", self.path(f"exported.{form}"))
            self.assertEqual(done.returncode, 0, done.stderr)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(self.path("exported.vtp"))
        reader.Update()
        array = reader.GetOutput().GetPointData().GetArray("temperature")
        self.assertEqual([array.GetValue(k) for k in range(2)], expected)
        with h5py.File(self.path("exported.h5md")) as file:
            temperature = file["particles/grains/temperature"]
            self.assertEqual(temperature["value"][...].tolist(), [expected])
            self.assertEqual(temperature["time"][...].tolist(), [snapshot.time_s])
            self.assertEqual(temperature["value"].attrs["unit"], "K")
            boundary = file["particles/grains/box"].attrs["boundary"]
            self.assertEqual((boundary.dtype, boundary.tolist()), ("S8", [b"periodic", b"periodic", b"none"]))

    def test_pictures_of_heat(self):
        run = self.path("settled_for_pictures")
        self.program.run(self.program.deck("packed_bed_charging.toml"), run, "particles.0.count=200", "phase.charge.time=2.0",
                         "measurement.bulk_density.max=[2.64e-3, 2.64e-3, 2e-3]")
        tool = os.path.join(self.program.source, "tools", "plot_run.py")
        done = subprocess.run([tool, run, "--output", self.path("pictures"), "--part", "0.5"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name in ("heat", "temperatures"):
            self.assertIn(f"{name}.png", done.stdout)
            self.assertTrue(os.path.getsize(self.path("pictures", f"{name}.pdf")) > 5000)
        import repose
        figure = repose.plots.heat(repose.Run(run))
        highest = figure.axes[0].lines[0].get_ydata()
        self.assertGreater(highest[-1], highest[0] + 100.0)
        self.assertEqual([text.get_text() for text in figure.axes[1].get_legend().get_texts()], ["floor"])
        snapshot = repose.Run(run).snapshots[-1]
        shown = repose.plots.temperatures(snapshot, "x", 0.5).axes[0].collections[0].get_array()
        self.assertTrue(0 < len(shown) < len(snapshot))
        self.assertAlmostEqual(shown.max(), snapshot["temperature"].max(), delta=100.0)
        with self.assertRaisesRegex(repose.ReposeError, re.escape('an axis is x, y or z, not "w"')):
            repose.plots.temperatures(snapshot, "w")
        bad = subprocess.run([tool, run, "--part", "0"], capture_output=True, text=True)
        self.assertEqual(bad.returncode, 2)
        self.assertIn("0 is no share above 0 and at most 1", bad.stderr)


if __name__ == "__main__":
    import unittest
    Heat.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
