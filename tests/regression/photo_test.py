"""Photographs of simulated piles by the ruler of the simulation: photo_test.py EXECUTABLE MPIEXEC SOURCE_DIR [slow [FOLDER]].

A ray caster (photographer.py) photographs states at rest; what `repose photo` finds in the pictures is compared with what
`repose measure` says of the grains. `slow`: 52 pictures from the side and 52 from above of 13 states; else some of one. Three
of the 13 are no heaps but layers two or three grains high; `repose photo pile` may refuse those, by a line that says so.
"""

import contextlib
import copy
import json
import os
import sys
import tempfile
import unittest
from dataclasses import replace

import numpy as np

import photographer
from photographer import Camera
from repose_runs import Program

ANGLE = 0.3  # degrees, of the exact ruler's in the same view
SEPARATE, TOUCHING = 0.02, 0.05  # of the count, where less and where more than a fifth of the grains touch
BASE = 0.05  # of the base's diameter: the layer under these piles covers 0.73 to 0.80 of the plate, which moves it by 3 %
BEYOND = 0.0015  # m beyond the base: its very foot is a matter of the rule, as the ruler's own is
FLAT = 12.0  # degrees: what is flatter here is a layer
SMALLEST = 0.5  # grains: a count of few cannot be exact to 2 %

SIDE = [Camera(name="light", tilt=1.5),
        Camera(name="dark", light_grains=False, plate=0.0, tilt=-2.0, megapixels=6.0),
        Camera(name="noisy", megapixels=24.0, plate=0.8, noise=0.03, blur=2.5, tilt=0.3),
        Camera(name="dark_on_plate", light_grains=False, plate=0.6, tilt=0.7, lamp=(0.8, -0.3, 0.5), megapixels=8.0)]
TOP = [Camera(name="light", tilt=1.5, megapixels=6.0),
       Camera(name="dark", light_grains=False, tilt=-2.0, megapixels=12.0),
       Camera(name="noisy", megapixels=24.0, noise=0.03, blur=2.0, tilt=0.5),
       Camera(name="textured", light_grains=False, lamp=(0.8, -0.3, 0.5), megapixels=8.0, texture=0.03)]


def state(plate, sliding, rolling, restitution, seed):
    """Overrides of scatter_mini.toml; plate: m below the orifice."""
    return plate, [
        f"run.seed={seed}", "output.snapshot_interval=0", f"pair.0.sliding_friction={sliding}",
        f"pair.0.rolling_friction={rolling}", f"pair.0.restitution={restitution}",
        f"domain.min=[-0.05, -0.05, {-plate - 1e-3}]", f"wall.plate.corner=[-0.05, -0.05, {-plate}]",
        f"measurement.angle_of_repose.plate_height={-plate}", f"measurement.scattering.plate_height={-plate}"]


STATES = [state(0.02, 0.8, 0.2, 0.5, 1), state(0.02, 0.3, 0.1, 0.5, 2), state(0.02, 0.5, 0.3, 0.7, 3),
          state(0.02, 0.6, 0.15, 0.3, 4), state(0.03, 0.7, 0.25, 0.6, 5), state(0.03, 0.4, 0.2, 0.8, 6),
          state(0.04, 0.827, 0.172, 0.5, 7), state(0.04, 0.5, 0.1, 0.6, 8), state(0.04, 0.3, 0.3, 0.4, 9),
          state(0.015, 0.8, 0.3, 0.6, 10), state(0.02, 0.7, 0.1, 0.4, 11), state(0.015, 0.5, 0.2, 0.4, 12),
          state(0.03, 0.8, 0.3, 0.3, 13)]

TWICE_THE_STEP = ["time.rayleigh_fraction=0.4", "time.hertz_fraction=0.2"]  # any pile will do


class Laboratory:
    """A state at rest, its grains as a list, and a photo deck for it."""

    def __init__(self, program, directory, plate, sets):
        self.program, self.directory, self.plate = program, directory, plate
        deck = program.deck("scatter_mini.toml")
        self.sets = [s for s in sets if not s.startswith("run.")]
        if not os.path.exists(os.path.join(directory, "summary.json")):
            program.run(deck, directory, *sets, options=["--quiet"])
        snapshot = sorted(f for f in os.listdir(directory) if f.endswith(".hdf"))[-1]
        self.centres, self.radii = photographer.read_grains(os.path.join(directory, snapshot), below=0.0)
        self.write_list("grains.csv")
        self.deck = os.path.join(directory, "base.toml")
        with open(deck) as file:
            text = file.read().replace('base_radius = "10 mm"\n', "")
        with open(self.deck, "w") as file:
            file.write(text)

    def write_list(self, name):
        """The grains, for `repose measure`."""
        self.list = os.path.join(self.directory, name)
        np.savetxt(self.list, np.column_stack([self.centres, self.radii]), delimiter=",", header="x,y,z,radius", comments="")

    def exact(self, *sets):
        """measurement.json of the grains themselves."""
        output = os.path.join(self.directory, "exact")
        arguments = ["measure", self.list, "--deck", self.deck, "--output", output]
        for s in self.sets + list(sets):
            arguments += ["--set", s]
        done = self.program.call(*arguments)
        assert done.returncode == 0, done.stderr
        return read_json(os.path.join(output, "measurement.json"))

    def photo(self, kind, picture, pixels_per_mm, sets=(), encoding="jpeg", options=(), refusal=None):
        """What `repose photo` finds in a picture; `picture` may be several. None when it refuses by the words `refusal`."""
        pictures = picture if isinstance(picture, list) else [picture]
        files = []
        for number, p in enumerate(pictures):
            files.append(os.path.join(self.directory, f"{kind}_{number}.{encoding}"))
            with open(files[-1], "wb") as file:
                file.write(p if isinstance(p, bytes) else photographer.encoded(p, encoding))
        deck = os.path.join(self.directory, "photo.toml")
        with open(deck, "w") as file:
            file.write(f"base = \"base.toml\"\nset = {json.dumps(self.sets + list(sets))}\n[scale]\n"
                       f"pixels_per_mm = {pixels_per_mm}\n")
        output = os.path.join(self.directory, "found")
        done = self.program.call("photo", kind, *files, "--deck", deck, "--output", output, *options)
        if refusal and done.returncode == 2 and refusal in done.stderr:
            return None
        assert done.returncode == 0, done.stderr
        return read_json(os.path.join(output, f"{kind}.json"))


def read_json(path):
    with open(path) as file:
        return json.load(file)


def touching_share(centres, radii, beyond):
    """Of the grains farther from the axis than `beyond`, those that touch another one as seen from above."""
    outside = np.nonzero(np.hypot(centres[:, 0], centres[:, 1]) >= beyond)[0]
    touching = 0
    for i in outside:
        gaps = np.hypot(*(centres[:, :2] - centres[i, :2]).T) - radii - radii[i]
        gaps[i] = np.inf
        touching += gaps.min() < 0.1 * radii[i]
    return touching / max(1, len(outside))


def compare_pile(lab, camera):
    """A line of the table, and whether the photograph agrees."""
    exact = lab.exact("measurement.angle_of_repose.azimuths=1")["angle_of_repose_deg"]
    picture, scale = photographer.side_view(lab.centres, lab.radii, -lab.plate, camera)
    found = lab.photo("pile", picture, scale, refusal="two straight flanks" if exact < FLAT else None)
    if found is None:
        return f"pile  {camera.name:13} {exact:7.2f} degrees, refused", True
    found = found["angle_of_repose"]["mean_deg"]
    return f"pile  {camera.name:13} {exact:7.2f} {found:7.2f} degrees", abs(found - exact) <= ANGLE


def compare_plate(lab, camera):
    base = lab.exact()["scattering"]["base_diameter_m"]
    beyond = 0.5 * base + BEYOND
    sets = [f"measurement.scattering.base_radius={beyond!r}", "measurement.scattering.area_1_width=2 mm",
            f"measurement.scattering.area_3_radius={beyond + 0.004!r}"]
    scattering = lab.exact(*sets)["scattering"]
    exact = sum(scattering[f"area_{n}"]["count"] for n in (1, 2, 3))
    picture, scale = photographer.top_view(lab.centres, lab.radii, -lab.plate, camera)
    found = lab.photo("plate", picture, scale, sets)
    count = sum(found[f"area_{n}"]["mean"] for n in (1, 2, 3))
    found_base = found["photographs"][0]["base_diameter_m"]
    touching = touching_share(lab.centres, lab.radii, beyond)
    bound = max(SMALLEST, (TOUCHING if touching > 0.2 else SEPARATE) * exact)
    line = (f"plate {camera.name:13} {exact:7d} {count:7.0f} grains, {100 * touching:.0f} % touch; base {1e3 * base:.2f} "
            f"{1e3 * found_base:.2f} mm")
    return line, abs(count - exact) <= bound and abs(found_base / base - 1.0) <= BASE


def crowded(lab):
    """The same plate with a neighbour that touches put beside every second grain out of the pile, where there is room."""
    more = copy.copy(lab)
    rng = np.random.default_rng(3)
    beyond = 0.5 * lab.exact()["scattering"]["base_diameter_m"] + BEYOND
    centres, radii = list(lab.centres), list(lab.radii)
    for i in np.nonzero(np.hypot(lab.centres[:, 0], lab.centres[:, 1]) >= beyond + 4 * lab.radii)[0][::2]:
        direction = rng.uniform(0, 2 * np.pi)
        place = lab.centres[i] + 2.02 * lab.radii[i] * np.array([np.cos(direction), np.sin(direction), 0.0])
        free = np.hypot(*(np.array(centres)[:, :2] - place[:2]).T) > 2.01 * lab.radii[i]
        if free.all() and np.hypot(*place[:2]) > beyond:
            centres.append(place)
            radii.append(lab.radii[i])
    more.centres, more.radii = np.array(centres), np.array(radii)
    more.write_list("crowded.csv")
    return more


class Photographs(unittest.TestCase):
    lab = None
    most_megapixels = 24.0

    def compare(self, lab):
        for compare, cameras in ((compare_pile, SIDE), (compare_plate, TOP)):
            for camera in (c for c in cameras if c.megapixels <= self.most_megapixels):
                line, agrees = compare(lab, camera)
                print(line, "" if agrees else "*", flush=True)
                with self.subTest(line):
                    self.assertTrue(agrees, line)

    def test_agree_with_the_ruler(self):
        self.compare(self.lab)


class OneState(Photographs):
    """What one state can show, beside; the largest pictures are left to the slow test."""

    most_megapixels = 6.0

    def test_more_than_a_fifth_of_the_grains_touch(self):
        for camera in (TOP[0], replace(TOP[3], megapixels=6.0)):
            line, agrees = compare_plate(crowded(self.lab), camera)
            print(line, flush=True)
            self.assertGreater(int(line.split("grains, ")[1].split(" %")[0]), 20, line)
            self.assertTrue(agrees, line)

    def test_several_photographs_and_a_calibration(self):
        calibration = os.path.join(self.lab.directory, "calibration.toml")
        with open(calibration, "w") as file:
            file.write('base = "base.toml"\n[[parameter]]\nname = "a"\nkey = "pair.0.sliding_friction"\nmin = 0.1\nmax = 0.9\n'
                       'points = 3\n[[observable]]\nfigure = "angle_of_repose_deg"\nlaboratory = 33.0  # by eye\ndeviation = 1\n')
        views = [photographer.side_view(self.lab.centres, self.lab.radii, -self.lab.plate, replace(SIDE[0], seed=s, tilt=s))
                 for s in (0, 1)]
        found = self.lab.photo("pile", [v[0] for v in views], views[0][1], options=["--calibration", calibration])
        angles = [p["angle_of_repose_deg"] for p in found["photographs"]]
        self.assertAlmostEqual(found["angle_of_repose"]["mean_deg"], sum(angles) / 2, places=12)
        with open(calibration) as file:
            text = file.read()
        self.assertIn(f"laboratory = {sum(angles) / 2:.6g}  # by eye\n", text)
        self.assertIn("repeats = 2\n", text)

    def test_a_photograph_is_upright_as_its_exif_says(self):
        picture, scale = photographer.side_view(self.lab.centres, self.lab.radii, -self.lab.plate, SIDE[0])
        upright = self.lab.photo("pile", picture, scale, encoding="png")["photographs"][0]["angle_of_repose_left_deg"]
        for orientation in (1, 3, 6, 8):
            found = self.lab.photo("pile", photographer.encoded(picture, "jpeg", orientation), scale)["photographs"][0]
            self.assertAlmostEqual(found["angle_of_repose_left_deg"], upright, delta=0.1, msg=orientation)
        found = self.lab.photo("pile", picture, scale, encoding="tiff")["photographs"][0]
        self.assertEqual(found["angle_of_repose_left_deg"], upright)
        compressed = photographer.encoded(picture, "tiff", compression="jpeg", quality=92)
        found = self.lab.photo("pile", compressed, scale, encoding="tiff")["photographs"][0]
        self.assertAlmostEqual(found["angle_of_repose_left_deg"], upright, delta=0.1)

    def test_views_that_measure_draws_are_photographs(self):
        output = os.path.join(self.lab.directory, "views")
        arguments = ["measure", self.lab.list, "--deck", self.lab.deck, "--output", output, "--pixels-per-mm", "60"]
        for s in [*self.lab.sets, "measurement.angle_of_repose.azimuths=1"]:
            arguments += ["--set", s]
        self.assertEqual(self.lab.program.call(*arguments).returncode, 0)
        exact = read_json(os.path.join(output, "measurement.json"))
        for kind in ("pile", "plate"):
            with open(os.path.join(output, f"{kind}_view.png"), "rb") as file:
                found = self.lab.photo(kind, file.read(), 60.0, encoding="png")
            if kind == "pile":
                self.assertAlmostEqual(found["angle_of_repose"]["mean_deg"], exact["angle_of_repose_deg"], delta=ANGLE)
            else:
                base = exact["scattering"]["base_diameter_m"]
                self.assertAlmostEqual(found["photographs"][0]["base_diameter_m"] / base, 1.0, delta=BASE)
        arguments[arguments.index("60")] = "1e9"
        self.assertEqual(self.lab.program.call(*arguments).returncode, 2)
        self.assertEqual(read_json(os.path.join(output, "measurement.json")), exact, "a refused scale has cost the results before")

    def test_what_is_no_photograph_is_refused_in_one_line(self):
        picture, scale = photographer.side_view(self.lab.centres, self.lab.radii, -self.lab.plate, SIDE[0])
        whole = photographer.encoded(picture, "jpeg")
        png = photographer.encoded(picture, "png")
        rng = np.random.default_rng(5)
        damaged = [b"", b"x" * 1000, whole[:len(whole) // 2], png[:len(png) // 2], whole[:20]]
        for _ in range(20):
            at = rng.integers(len(png))
            damaged.append(png[:at] + bytes(rng.integers(256, size=40).tolist()) + png[at + 40:])
        for number, data in enumerate(damaged):
            path = os.path.join(self.lab.directory, "damaged.jpg")
            with open(path, "wb") as file:
                file.write(data)
            done = self.lab.program.call("photo", "pile", path, "--deck", os.path.join(self.lab.directory, "photo.toml"))
            self.assertEqual(done.returncode, 4, f"{number}: {done.stdout}{done.stderr}")
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn("damaged.jpg: ", done.stderr)


class ManyStates(Photographs):
    folder = None
    program = None

    def test_agree_with_the_ruler(self):
        directories = [os.path.join(self.folder, str(k)) for k in range(len(STATES))]
        self.program.run_all([(self.program.deck("scatter_mini.toml"), d, *sets) for d, (_, sets) in zip(directories, STATES)
                              if not os.path.exists(os.path.join(d, "summary.json"))], options=["--quiet"])
        for directory, (plate, sets) in zip(directories, STATES):
            print(f"state {os.path.basename(directory)}")
            self.compare(Laboratory(self.program, directory, plate, sets))


def main():
    program = Program(*sys.argv[1:4])
    is_slow = sys.argv[4:5] == ["slow"]
    kept = contextlib.nullcontext(sys.argv[5]) if len(sys.argv) > 5 else tempfile.TemporaryDirectory()
    with kept as folder:
        if is_slow:
            ManyStates.folder, ManyStates.program = folder, program
            case = ManyStates
        else:
            plate, sets = STATES[0]
            OneState.lab = Laboratory(program, os.path.join(folder, "state"), plate, [*sets, *TWICE_THE_STEP])
            case = OneState
        done = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromTestCase(case))
    sys.exit(not done.wasSuccessful())


if __name__ == "__main__":
    main()
