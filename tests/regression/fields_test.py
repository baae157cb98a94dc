"""repose fields: VTK reads what it writes; mass and momentum are those of the grains, walls carry the weight of a bed at rest,
and bad requests are refused in one line.

Usage: fields_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import glob
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from repose_runs import FolderTest, Program, read_series

# A bed that has come to rest long before it is stopped, with its lid, so that a checkpoint stays.
RUN = ["particles.0.mass=0.03 g", "particles.0.height=15 mm", "phase.settle.max_time=1000 s",
       "phase.settle.kinetic_energy=1e-40", "output.snapshot_interval=20 ms"]
AT_REST = 0.4  # s
STEEP = 9.81


class Image:
    """Fields as VTK reads them: one array of each name, and texts and numbers of the whole."""

    def __init__(self, path):
        reader = vtkXMLImageDataReader()
        reader.SetFileName(path)
        reader.Update()
        image = reader.GetOutput()
        assert reader.GetErrorCode() == 0 and image.GetNumberOfCells() > 0, path
        cells, head = image.GetCellData(), image.GetFieldData()
        self.arrays = {cells.GetArrayName(i): vtk_to_numpy(cells.GetArray(i)) for i in range(cells.GetNumberOfArrays())}
        self.head = {head.GetArrayName(i): head.GetAbstractArray(i).GetValue(0) for i in range(head.GetNumberOfArrays())}
        self.spacing, self.origin = np.array(image.GetSpacing()), np.array(image.GetOrigin())
        self.cells = np.array(image.GetDimensions()) - 1

    def integral(self, name):
        return self.arrays[name].sum(axis=0) * np.prod(self.spacing)

    def centres(self, axis):
        """Of the cells, in the order of the arrays."""
        index = np.unravel_index(np.arange(np.prod(self.cells)), self.cells, order="F")[axis]
        return self.origin[axis] + (index + 0.5) * self.spacing[axis]


class Fields(FolderTest):
    @classmethod
    def setUpClass(cls):
        cls.run_folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.run_folder.cleanup)
        cls.run_directory = os.path.join(cls.run_folder.name, "run")
        settings = [word for setting in RUN for word in ("--set", setting)]
        words = [cls.program.executable, "run", cls.program.deck("discharge_quick.toml"), "--output", cls.run_directory, *settings]
        with subprocess.Popen(words, stdout=subprocess.DEVNULL) as running:
            while running.poll() is None and cls.simulated() < AT_REST:
                time.sleep(0.1)
            running.send_signal(signal.SIGUSR1)
            assert running.wait() == 75
        cls.snapshots = sorted(glob.glob(os.path.join(cls.run_directory, "run_*.hdf")))
        cls.checkpoint = sorted(glob.glob(os.path.join(cls.run_directory, "checkpoint_*.hdf")))[-1]

    @classmethod
    def simulated(cls):
        """Seconds of the last row of series.csv."""
        begun = os.path.exists(os.path.join(cls.run_directory, "series.csv"))
        rows = read_series(cls.run_directory) if begun else []
        return rows[-1]["time_s"] if rows else 0.0

    def fields(self, *arguments):
        done = self.program.call("fields", *arguments, "--output", self.path("fields"))
        self.assertEqual(done.returncode, 0, done.stderr)
        images = sorted(glob.glob(self.path("fields/*.vti")))
        return done.stdout, [Image(path) for path in images]

    def test_snapshots_give_mass_and_momentum_of_their_grains(self):
        chosen = self.snapshots[:2]
        text, images = self.fields(*chosen)
        self.assertIn("contact stress of normal forces", text)
        self.assertIn("without contacts with lid", text)
        series = xml.etree.ElementTree.parse(self.path("fields/fields.pvd")).getroot().find("Collection")
        self.assertEqual([entry.get("file") for entry in series], sorted(os.listdir(self.path("fields")))[1:])
        for path, image, entry in zip(chosen, images, series):
            with h5py.File(path) as file:
                mass = file["particles/mass"][...] if "particles/mass" in file else None
                radius, velocity = file["particles/radius"][...], file["particles/velocity"][...]
                self.assertEqual(image.head["TimeValue"], file.attrs["time_s"])
                self.assertEqual(float(entry.get("timestep")), file.attrs["time_s"])
            volume = 4 / 3 * np.pi * radius ** 3
            mass = 3592.0 * volume if mass is None else mass
            self.assertAlmostEqual(image.integral("mass_density") / mass.sum(), 1.0, delta=1e-13)
            self.assertAlmostEqual(image.integral("solid_fraction") / volume.sum(), 1.0, delta=1e-13)
            momentum = mass @ velocity
            np.testing.assert_allclose(image.integral("momentum_density"), momentum,
                                       atol=1e-12 * mass.sum() * np.abs(velocity).max())
            self.assertEqual(image.head["contact_forces"], "normal")
            # A sum of squares is the energy about the mean motion of cells: not above that of the grains.
            energy = np.trace(image.integral("kinetic_stress").reshape(3, 3)) / 2
            self.assertGreater(energy, 0.0)
            self.assertLess(energy, mass @ (velocity ** 2).sum(axis=1) / 2)
        np.testing.assert_allclose(images[0].head["kernel_half_width"], 3 * 440e-6, rtol=1e-12)
        np.testing.assert_allclose(images[0].spacing, 440e-6, rtol=1e-12)

    def test_a_checkpoint_of_a_bed_at_rest_gives_its_weight(self):
        text, (image,) = self.fields(self.checkpoint, "--width", "1.2 mm", "--spacing", "2e-4")
        self.assertIn("contact stress of normal and tangential forces", text)
        self.assertNotIn("without", text)
        self.assertEqual(image.head["kernel_half_width"], 0.0012)
        self.assertEqual(image.head["contact_forces"], "normal and tangential")
        weight = STEEP * image.integral("mass_density")
        np.testing.assert_allclose(image.integral("wall_force_density") / weight, [0, 0, 1], atol=1e-5)
        # Across a level the stress carries what lies above it, less what the vessel's side wall carries of that: the
        # divergence of the stress is the density times gravity and the walls' force. Both are means over layers of cells.
        layer = image.centres(2)
        levels = np.unique(layer)
        area = image.spacing[0] * image.spacing[1]
        flow = np.array([image.arrays["contact_stress"][layer == z, 8].sum() * area for z in levels])
        load = np.array([(image.arrays["wall_force_density"][layer == z, 2] - STEEP * image.arrays["mass_density"][layer == z]
                          ).sum() * area for z in levels])
        slope = (flow[2:] - flow[:-2]) / (2 * image.spacing[2])
        simpson = (load[:-2] + 4 * load[1:-1] + load[2:]) / 6
        np.testing.assert_allclose(slope, simpson, atol=3e-3 * np.abs(load).max())
        # xy and yx are equal where no moment acts: with rolling friction nearly.
        stress = image.integral("contact_stress").reshape(3, 3)
        self.assertLess(np.abs(stress - stress.T).max(), 0.05 * np.trace(stress))
        np.testing.assert_allclose(image.arrays["pressure"], (image.arrays["contact_stress"] + image.arrays["kinetic_stress"])
                                   [:, [0, 4, 8]].sum(axis=1) / 3, rtol=1e-12, atol=1e-18)

    def test_bad_requests_are_refused(self):
        out = ["--output", self.path("fields")]
        for width in ("0", "-1 mm", "inf", "nan", "2 kg", "wide"):
            self.fails(2, r"--width .*must be a length above 0", "fields", self.checkpoint, *out, f"--width={width}")
        self.fails(2, "more than 2e.07; give a larger --spacing", "fields", self.checkpoint, *out, "--spacing", "1 um")
        self.fails(2, "another file is of step", "fields", self.checkpoint, self.checkpoint, *out)
        self.fails(4, "is no HDF5 file", "fields", self.program.deck("discharge_quick.toml"), *out)
        self.fails(2, "no material is named", "fields", self.snapshots[0], *out, "--deck",
                   self.program.deck("sand_mono.toml"))
        for other in ("packing.toml", "sand_mono.toml"):
            self.fails(2, "has other materials or walls than the deck in .*checkpoint_", "fields", self.checkpoint, *out,
                       "--deck", self.program.deck(other))
        self.fails(4, "absent.hdf: cannot open", "fields", self.checkpoint, self.path("absent.hdf"), *out)
        self.assertFalse(os.path.exists(self.path("fields")))


if __name__ == "__main__":
    Fields.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
