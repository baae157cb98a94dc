"""repose measure: a finished state gives the run's figures again, from its snapshot and from a CSV, and known piles give
what they are made to have.

Usage: measure_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import glob
import json
import math
import os
import random
import re
import sys
import unittest
import zlib

import h5py

from repose_runs import FolderTest, Program

# The scattering test in small: 2497 grains through the whole orifice, from a narrow vessel onto a plate 10 mm below.
REDUCED = ("particles.0.mass=0.4 g", "particles.0.radius=4 mm", "particles.0.height=38 mm", "particles.0.spacing=700 um",
           'wall.vessel.points=[["4 mm", "40 mm"], ["4 mm", 0.0], ["2.5 mm", 0.0]]',
           'wall.plate.corner=["-50 mm", "-50 mm", "-10 mm"]', "measurement.scattering.plate_height=-10 mm",
           "measurement.angle_of_repose.plate_height=-10 mm", "phase.settle.min_time=40 ms", "phase.settle.max_time=60 ms",
           "phase.discharge.min_time=150 ms", "phase.discharge.max_time=220 ms",
           "measurement.scattering.area_1_width=2 mm", "measurement.scattering.area_3_radius=20 mm",
           "measurement.scattering.area_1_widened=[4e-3, 1.0]", "measurement.scattering.area_3_widened=[15e-3]")
PLATE_HEIGHT = -0.04  # of the deck as it is
PILE_FIGURES = ("angle_of_repose_deg", "angle_of_repose_left_deg", "angle_of_repose_right_deg",
                "angle_of_repose_stderr_deg", "pile_height_m", "scattering")
PICTURES = [f"{name}.{ending}" for name in ("silhouette", "top_view") for ending in ("png", "pdf", "svg")]
FORMATS = {"png": b"\x89PNG\r\n\x1a\n", "pdf": b"%PDF-", "svg": b"<?xml"}
RADIUS = 0.22e-3


def pictures_in(folder):
    """Their names; each has to begin as its format does."""
    names = sorted(name for name in os.listdir(folder) if name.split(".")[-1] in FORMATS)
    for name in names:
        with open(os.path.join(folder, name), "rb") as file:
            beginning = FORMATS[name.split(".")[-1]]
            assert file.read(len(beginning)) == beginning, f"{name} is no such picture"
    return names


def letters_of_pdf(path):
    """Those that its fonts draw, by the tables from their glyphs to Unicode."""
    with open(path, "rb") as file:
        streams = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", file.read(), re.DOTALL)
    letters = set()
    for stream in streams:
        try:
            text = zlib.decompress(stream)
        except zlib.error:
            continue
        if b"begincmap" in text:
            letters |= {chr(int(code, 16)) for code in re.findall(rb"^<[0-9a-f]+> <([0-9a-f]{4})>$", text, re.M)}
    return letters


def sets(overrides):
    return [word for override in overrides for word in ("--set", override)]


def rings_of_a_cone(height, angle):
    """Grains that touch a cone on the plate from inside, in rings at contact distance."""
    slope = math.tan(math.radians(angle))
    cosine = math.cos(math.radians(angle))
    grains, z = [], RADIUS
    while (r := (height - z - RADIUS / cosine) / slope) >= 0.0:
        count = max(1, math.ceil(math.pi * r / RADIUS))
        turns = [2.0 * math.pi * k / count for k in range(count)]
        grains += [(r * math.cos(t), r * math.sin(t), PLATE_HEIGHT + z, RADIUS) for t in turns]
        z += 2.0 * RADIUS * slope * cosine
    return grains


def lying(x, y):
    return x, y, PLATE_HEIGHT + RADIUS, RADIUS


def write_csv(path, grains, header="x,y,z,radius"):
    with open(path, "w") as file:
        file.write(header + "\n" + "".join(",".join(map(str, g)) + "\n" for g in grains))
    return path


class Measure(FolderTest):
    def setUp(self):
        super().setUp()
        self.deck = self.program.deck("scatter_carbohsp.toml")

    def measure(self, file, *overrides, ranks=0):
        """What was printed, and the figures."""
        done = self.program.call("measure", file, "--deck", self.deck, "--output", self.path("measured"),
                                 *sets(overrides), ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("measured/measurement.json")) as text:
            return done.stdout, json.load(text)

    def test_the_bed_in_the_vessel(self):
        """Before it opens, by any number of ranks, and from the snapshot of that moment."""
        self.deck = self.program.deck("discharge_quick.toml")
        box = ('measurement.bulk_density={ min = ["-2 mm", "-2 mm", "1 mm"], max = ["2 mm", "2 mm", "20 mm"] }',
               'measurement.retained_slope={ orifice_height = 0.0, radius = "4 mm" }', "output.snapshot_times=[0.0, 0.05]",
               "phase.settle.max_time=50 ms", "phase.discharge.max_time=250 ms")
        one, three = (self.program.run(self.deck, self.path(str(ranks)), *box, ranks=ranks, options=("--quiet",))
                      for ranks in (1, 3))
        self.assertTrue(1700 < one["bulk_density_kg_m3"] < 2100, one["bulk_density_kg_m3"])
        self.assertAlmostEqual(one["porosity"], 1.0 - one["bulk_density_kg_m3"] / 3592.0, delta=1e-12)
        self.assertTrue(20 < one["retained_slope_deg"] < 60, one["retained_slope_deg"])
        self.assertTrue(os.path.exists(self.path("1/run_0000000000.hdf")))
        bed = ("bulk_density_kg_m3", "porosity", "bulk_density_top_m")
        for key in (*bed, "retained_slope_deg"):
            self.assertEqual(one[key], three[key], key)
        text, again = self.measure(self.path(f"1/run_{one['phases'][0]['steps']:010d}.hdf"), *box)
        for key in bed:
            self.assertEqual(again[key], one[key], key)
        self.assertIn(f"porosity {one['porosity']:.4g}", text)
        text, again = self.measure(self.path(f"1/run_{one['steps']:010d}.hdf"), *box)
        self.assertEqual(again["retained_slope_deg"], one["retained_slope_deg"])
        self.assertIn("no settled bed over the whole box, so no bulk density", text)

    def test_a_run_measured_again(self):
        run = self.program.run(self.deck, self.path("run"), *REDUCED, ranks=2, options=("--quiet",))
        s = run["scattering"]
        counts = [s[area]["count"] for area in ("area_1", "area_2", "area_3")]
        print("base", s["base_diameter_m"], "areas", counts, "off the plate", s["off_plate"])
        self.assertTrue(6e-3 < s["base_diameter_m"] < 24e-3, s)
        self.assertGreater(counts[0], 30)
        self.assertGreater(counts[2], 3)
        self.assertEqual(s["area_1_widened"][1]["count"], sum(counts))
        self.assertEqual(s["off_plate"], run["particles"]["left"])
        self.assertEqual(pictures_in(self.path("run")), sorted(PICTURES))

        snapshot = self.path(f"run/run_{run['steps']:010d}.hdf")
        for ranks in (0, 2):
            text, again = self.measure(snapshot, *REDUCED, ranks=ranks)
            for key in PILE_FIGURES:
                self.assertEqual(again[key], run[key], key)
            self.assertEqual(again["left"], run["particles"]["left"])
            self.assertAlmostEqual(again["retained_mass_kg"] / run["retained_mass_kg"], 1.0, delta=1e-9)
            self.assertIn(f"grains on area 1 {counts[0]} +- ", text)
            for name in (n for n in PICTURES if not n.endswith(".svg")):  # Cairo numbers its parts on through a process
                with open(self.path("run/" + name), "rb") as one, open(self.path("measured/" + name), "rb") as other:
                    self.assertEqual(one.read(), other.read(), name)
        self.assertEqual(again["discharged_mass_kg"] < run["discharged_mass_kg"], run["particles"]["left"] > 0)

        other_keys = self.measure(snapshot, *REDUCED, "measurement.scattering.area_1_width=4 mm")[1]
        self.assertEqual(other_keys["scattering"]["area_1"], s["area_1_widened"][0])

        with h5py.File(snapshot) as file:
            grains = [(*map(float, p), float(r))
                      for p, r in zip(file["particles/position"][...], file["particles/radius"][...])]
        random.Random(1).shuffle(grains)
        listed = self.measure(write_csv(self.path("grains.csv"), grains), *REDUCED)[1]
        self.assertIsNone(listed["left"])
        self.assertIsNone(listed["retained_mass_kg"])  # a list without materials has no masses
        s["off_plate"] -= run["particles"]["left"]     # which it does not know
        self.assertEqual(listed["scattering"], s)
        self.assertAlmostEqual(listed["angle_of_repose_deg"], run["angle_of_repose_deg"], delta=1e-9)
        named = [(*g, "carbohsp") for g in grains]
        with_masses = self.measure(write_csv(self.path("named.csv"), named, "x,y,z,radius,material"), *REDUCED)[1]
        self.assertAlmostEqual(with_masses["retained_mass_kg"] / run["retained_mass_kg"], 1.0, delta=1e-9)

    def test_a_cone_of_known_angle(self):
        for angle in (20.0, 30.0, 40.0):
            grains = rings_of_a_cone(5e-3, angle)
            grains += [lying(x, y) for x in (-0.0495, 0.0495) for y in (-0.0495, 0.0495)]  # in the plate's corners
            grains += [lying(0.03 + 1e-3 * k, 0.0) for k in range(9)]
            path = write_csv(self.path("cone.csv"), grains)
            text, m = self.measure(path)
            self.assertAlmostEqual(m["angle_of_repose_deg"], angle, delta=0.5)
            self.assertAlmostEqual(m["pile_height_m"], 5e-3, delta=2.0 * RADIUS)
            self.assertEqual(m["scattering"]["area_3"]["count"], 4)
            self.assertEqual(m["scattering"]["area_2"]["count"], 9)
            self.assertAlmostEqual(m["scattering"]["base_diameter_m"], 1e-2 / math.tan(math.radians(angle)), delta=1.5e-3)
            self.assertIn(f"{len(grains)} particles\n", text)

    def test_without_a_pile(self):
        path = write_csv(self.path("flat.csv"), [lying(1e-3 * k, 0.0) for k in range(30)])
        text, m = self.measure(path)
        self.assertIn("no pile", text)
        for key in PILE_FIGURES:
            self.assertIsNone(m[key], key)
        self.assertEqual(pictures_in(self.path("measured")), [])

    def test_pictures_in_three_formats(self):
        cone = write_csv(self.path("cone.csv"), rings_of_a_cone(5e-3, 30.0))
        for name, signs in (("with_fonts", {"°", "±"}), ("without_fonts", set())):
            with open(self.path("none.conf"), "w") as file:
                file.write("<fontconfig></fontconfig>")
            env = {} if signs else {"FONTCONFIG_FILE": self.path("none.conf")}
            done = self.program.call("measure", cone, "--deck", self.deck, "--output", self.path(name), env=env)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(pictures_in(self.path(name)), sorted(PICTURES))
            letters = letters_of_pdf(self.path(f"{name}/silhouette.pdf"))
            self.assertTrue(set("Angleofps:0123456789") - letters <= set("0123456789"), letters)
            # Without a font Cairo draws these two as boxes.
            self.assertEqual({"°", "±"} & letters, signs)
            if not signs:
                self.assertTrue(set("deg+-") <= letters, letters)

    def test_a_picture_that_cannot_be_replaced(self):
        cone = write_csv(self.path("cone.csv"), rings_of_a_cone(5e-3, 30.0))
        os.makedirs(self.path("measured/top_view.svg/not_empty"))
        self.fails(4, "measured/top_view.svg: ", "measure", cone, "--deck", self.deck, "--output", self.path("measured"))
        self.assertFalse(glob.glob(self.path("measured/*.partial")))

    def test_pictures_of_an_earlier_run_go(self):
        os.mkdir(self.path("run"))
        for name in PICTURES:
            with open(self.path("run/" + name), "w") as file:
                file.write("of an earlier run")
        self.program.run(self.deck, self.path("run"), *REDUCED, "phase.settle.min_time=0.1 ms", "phase.settle.max_time=0.1 ms",
                         "phase.discharge.min_time=0.1 ms", "phase.discharge.max_time=0.1 ms")
        self.assertEqual(pictures_in(self.path("run")), [])

    def test_what_is_refused(self):
        cone = write_csv(self.path("cone.csv"), rings_of_a_cone(5e-3, 30.0))
        with_deck = ("--deck", self.deck)
        self.fails(4, "absent.csv: cannot open: No such file", "measure", self.path("absent.csv"), *with_deck)
        self.fails(4, "is a directory", "measure", self.folder, *with_deck)
        self.fails(2, "bad.csv:1: the header line must read x,y,z,radius or ", "measure",
                   write_csv(self.path("bad.csv"), [], "x;y;z"), *with_deck)
        with open(self.path("cut.hdf"), "wb") as file:
            file.write(b"\x89HDF\r\n\x1a\nand no more")
        for ranks in (0, 2):
            self.fails(4, "cut.hdf: cannot read as a snapshot", "measure", self.path("cut.hdf"), *with_deck, ranks=ranks)
        self.fails(4, "cannot create the output folder", "measure", cone, *with_deck, "--output", cone)
        self.fails(2, "area_3_radius = 0.005 m lies within the base", "measure", cone, *with_deck, "--set",
                   "measurement.scattering.area_3_radius=5 mm")
        self.fails(2, "--set measurement.scattering.area_3_radius=80 mm: .* leaves nothing for area 3", "measure", cone,
                   *with_deck, "--set", "measurement.scattering.area_3_radius=80 mm")
        self.fails(2, "nothing to measure", "measure", cone, "--deck", self.program.deck("periodic_chute.toml"))

    def test_what_is_refused_costs_nothing(self):
        cone = write_csv(self.path("cone.csv"), rings_of_a_cone(5e-3, 30.0))
        output, refused = self.path("measured"), ("--set", "measurement.scattering.area_3_radius=5 mm")
        self.fails(2, "lies within the base", "measure", cone, "--deck", self.deck, "--output", output, *refused)
        self.assertFalse(os.path.exists(output))
        self.assertEqual(self.program.call("measure", cone, "--deck", self.deck, "--output", output).returncode, 0)
        names = sorted(os.listdir(output))
        self.assertIn("measurement.json", names)
        times = [os.stat(os.path.join(output, name)).st_mtime_ns for name in names]
        self.fails(2, "lies within the base", "measure", cone, "--deck", self.deck, "--output", output, *refused)
        self.assertEqual(sorted(os.listdir(output)), names)
        self.assertEqual([os.stat(os.path.join(output, name)).st_mtime_ns for name in names], times)


if __name__ == "__main__":
    Measure.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
