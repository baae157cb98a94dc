"""repose info and repose export: what a file says is what h5py finds in it, what is exported is read by VTK, by measure and by
decks, and bad files are refused in one line.

Usage: info_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import csv
import glob
import json
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from repose_runs import Program

SMALL = ["particles.0.mass=0.05 g", "particles.0.height=20 mm", "phase.settle.max_time=3 ms", "phase.settle.min_time=1 ms",
         "phase.discharge.max_time=3 ms", "phase.discharge.min_time=3 ms", "output.snapshot_interval=2 ms",
         "run.title=grains, \"in small\""]
STUDY = """
title = "four frictions, overlaps forbidden"
base = "{base}"
seeds = 1
set = {sets}
[[parameter]]
name = "sliding"
key = "pair.0.sliding_friction"
values = [0.1, 0.2, 0.3, 0.4]
[[parameter]]
name = "overlap"
key = "guards.max_overlap"
values = [0.3, 1e-6]
[[observable]]
figure = "retained_mass_kg"
laboratory = 50e-6
deviation = 1e-6
[[observable]]
figure = "discharged_mass_kg"
laboratory = 1e-6
deviation = 1e-6
"""


class Info(unittest.TestCase):
    program = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.quick = cls.program.deck("discharge_quick.toml")
        cls.summary = cls.program.run(cls.quick, cls.path("run"), *SMALL)
        cls.snapshot = sorted(glob.glob(cls.path("run", "run_*.hdf")))[-1]
        stopped = cls.program.call("run", cls.quick, "--output", cls.path("stopped"), "--time-limit", "00:00:01",
                                   *[w for s in SMALL for w in ("--set", s)], "--set", "phase.discharge.max_time=100",
                                   "--set", "phase.discharge.min_time=100", "--set", "output.checkpoint_steps=500")
        assert stopped.returncode == 75, stopped.stderr
        cls.checkpoint = sorted(glob.glob(cls.path("stopped", "checkpoint_*.hdf")))[-1]

    @classmethod
    def path(cls, *names):
        return os.path.join(cls.folder.name, *names)

    def info(self, file, ranks=0):
        done = self.program.call("info", file, ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        return dict((line[:13].strip(), line[13:]) for line in done.stdout.splitlines())

    def refused(self, *arguments, message):
        done = self.program.call(*arguments)
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertRegex(done.stderr, message)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_a_snapshot(self):
        said = self.info(self.snapshot, ranks=2)
        with h5py.File(self.snapshot) as file:
            self.assertEqual(said["kind"], "snapshot")
            self.assertEqual(said["title"], 'grains, "in small"')
            self.assertEqual(int(said["step"]), file.attrs["step"])
            self.assertEqual(said["time"], f"{float(file.attrs['time_s'])!r} s")
            count = len(file["particles/id"])
            self.assertEqual(said["particles"], f"{count} ({count} inserted, 0 left)")
            self.assertEqual(said["materials"], f"carbohsp {count}, steel 0")
            self.assertEqual(said["diameters"], "0.44 to 0.44 mm")
            self.assertEqual(said["state"], self.summary["state_hash"])
            self.assertIn(file.attrs["build_commit"], said["build"])

    def test_a_checkpoint(self):
        said = self.info(self.checkpoint)
        with h5py.File(self.checkpoint) as file:
            self.assertEqual((said["kind"], int(said["step"])), ("checkpoint", file.attrs["step"]))
            self.assertEqual(said["state"], file.attrs["state_hash"])
            self.assertEqual(said["materials"], f"carbohsp {len(file['particles/id'])}, steel 0")

    def test_a_grid_counts_runs_in_each_state(self):
        study = self.path("study.toml")
        with open(study, "w") as file:
            file.write(STUDY.format(base=self.quick, sets=json.dumps(SMALL)))
        done = self.program.call("calibrate", study, "--output", self.path("grid"))
        grid = self.path("grid", "grid.h5")
        self.assertTrue(os.path.exists(grid), done.stderr)
        with h5py.File(grid) as file:
            states = [state.decode() for state in file["runs/state"][...]]
        said = self.info(grid)
        self.assertEqual((said["kind"], said["title"]), ("grid of runs", "four frictions, overlaps forbidden"))
        self.assertEqual((said["parameters"], said["figures"]), ("sliding, overlap", "retained_mass_kg, discharged_mass_kg"))
        names = ("waiting", "running", "done", "plugged", "failed")
        self.assertEqual(said["runs"], f"{len(states)}: " + ", ".join(f"{name} {states.count(name)}" for name in names))
        self.assertGreater(states.count("failed"), 0)
        self.assertGreater(states.count("done") + states.count("plugged"), 0)
        self.refused("export", grid, "--format", "csv", "--output", self.path("x.csv"), message="grid.h5: is no snapshot")

    def export(self, name, format, snapshot=None):
        done = self.program.call("export", snapshot or self.snapshot, "--format", format, "--output", self.path(name))
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.path(name)

    def test_vtk_reads_the_vtp(self):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(self.export("grains.vtp", "vtp"))
        reader.Update()
        data = reader.GetOutput()
        with h5py.File(self.snapshot) as file:
            particles = {name: file["particles"][name][...] for name in file["particles"]}
            time = float(file.attrs["time_s"])
        self.assertEqual(data.GetNumberOfVerts(), len(particles["id"]))
        ids = [data.GetCell(k).GetPointId(0) for k in range(data.GetNumberOfCells())]
        self.assertEqual(ids, list(range(len(ids))))
        self.assertTrue(np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), particles.pop("position")))
        for name, values in particles.items():
            self.assertTrue(np.array_equal(vtk_to_numpy(data.GetPointData().GetArray(name)), values), name)
        self.assertEqual(data.GetPointData().GetNumberOfArrays(), len(particles))
        self.assertEqual(data.GetFieldData().GetArray("TimeValue").GetValue(0), time)

    def test_measure_and_decks_read_the_csv(self):
        path = self.export("grains.csv", "csv")
        with open(path) as file:
            rows = list(csv.DictReader(file))
        with h5py.File(self.snapshot) as file:
            self.assertEqual([[float(row[c]) for c in "xyz"] for row in rows], file["particles/position"][...].tolist())
        figures = [self.program.call("measure", file, "--deck", self.quick).stdout for file in (self.snapshot, path)]
        masses = [[line for line in text.splitlines() if "retained" in line] for text in figures]
        self.assertEqual(masses[0], masses[1])
        self.assertEqual(len(masses[0]), 1, figures)
        with open(self.quick) as file:
            head, rest = file.read().split("[[particles]]")
        settling = sorted(glob.glob(self.path("run", "run_*.hdf")))[0]  # the lid is there
        self.export("grains.csv", "csv", settling)
        deck = self.path("listed.toml")
        with open(deck, "w") as file:
            file.write(head + '[[particles]]\ntype = "csv"\nfile = "grains.csv"\n\n[[phase]]' + rest.split("[[phase]]", 1)[1])
        checked = self.program.call("check", deck)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertIn(str(len(rows)), checked.stdout)

    def test_bad_files_are_refused_in_one_line(self):
        with open(self.snapshot, "rb") as file:
            whole = file.read()
        with open(self.path("cut.hdf"), "wb") as file:
            file.write(whole[:len(whole) // 2])
        with open(self.path("flipped.hdf"), "wb") as file:
            file.write(whole[:5000] + bytes([whole[5000] ^ 1]) + whole[5001:])
        with h5py.File(self.path("other.hdf"), "w") as file:
            file["something"] = 1
        with h5py.File(self.path("pretender.hdf"), "w") as file:
            file.attrs.update(state_hash="0", inserted=1, deck="[[", build_version="1", build_commit="1", build_compiler="1")
        with h5py.File(self.path("states.hdf"), "w") as file:
            file.attrs.update(deck="", build_version="1", build_commit="1", build_compiler="1")
            for name in ("parameters", "figures"):
                file["runs/" + name] = [[1.0]]
                file["runs/" + name].attrs.create("names", ["a"], dtype=h5py.string_dtype())
            file["runs/state"] = [1.0, 2.0]
        for name, message in (("states.hdf", "state: it is not of texts"), ("cut.hdf", "cut.hdf: "), ("flipped.hdf", "flipped.hdf: .*checksum"),
                              ("other.hdf", "neither a snapshot nor a checkpoint"), ("pretender.hdf", "cannot read"),
                              ("missing.hdf", "No such file")):
            self.refused("info", self.path(name), message=message)
            self.refused("export", self.path(name), "--format", "vtp", "--output", self.path("x.vtp"), message=name)
        self.refused("info", self.quick, message="is no HDF5 file")
        self.refused("export", self.checkpoint, "--format", "csv", "--output", self.path("x.csv"), message="is no snapshot")
        self.refused("export", self.snapshot, "--format", "csv", "--output", self.path("none", "x.csv"), message="x.csv: cannot")
        self.assertFalse(glob.glob(self.path("x.*")))

    def test_an_export_replaces_exports_alone(self):
        before = pathlib.Path(self.snapshot).read_bytes()
        self.refused("export", self.snapshot, "--format", "h5md", "--output", self.snapshot, message="is the snapshot itself")
        self.assertEqual(pathlib.Path(self.snapshot).read_bytes(), before)
        pathlib.Path(self.path("notes.txt")).write_text("mine")
        self.refused("export", self.snapshot, "--format", "csv", "--output", self.path("notes.txt"), message="is no export")
        self.assertEqual(pathlib.Path(self.path("notes.txt")).read_text(), "mine")
        for format in ("csv", "vtp", "dump", "h5md"):
            self.export(f"twice.{format}", format)
            self.export(f"twice.{format}", format)
        for name, text in (("mine.csv", "x,y,z,radius\n"), ("walls.vtp", '<?xml version="1.0"?>\n<VTKFile type="PolyData">\n')):
            pathlib.Path(self.path(name)).write_text(text)
            self.refused("export", self.snapshot, "--format", name.split(".")[1], "--output", self.path(name), message="is no export")
        other = shutil.copy(self.snapshot, self.path("other.hdf"))
        self.refused("export", self.snapshot, "--format", "h5md", "--output", other, message="is no export")
        self.assertEqual(pathlib.Path(other).read_bytes(), before)


if __name__ == "__main__":
    Info.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
