#!/usr/bin/python3
"""Runs a writer of sample snapshots (tests/unit/output_snapshot_writer.cpp) and reads its files with h5py and with
VTK's reader, which is ParaView's: read_snapshot.py COMMAND ... (the command gets a folder as its last argument)."""

import os
import subprocess
import sys
import tempfile

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

VTK_VERTEX = 1
TOTALS = (0, 1, 100, 300000)  # particles; the last has arrays of several chunks


def expected_arrays(total):
    """The figures of tests/unit/output_samples.h, by the same arithmetic: equal to the bit."""
    row = np.arange(total, dtype=np.float64)
    return {
        "id": 2 * np.arange(total, dtype=np.int64) + 1,
        "position": np.column_stack([row / 3.0, -row / 7.0, 1e-3 * row]),
        "velocity": np.column_stack([0.1 * row, 0.2 * row, -1.0 / (row + 1.0)]),
        "angular_velocity": np.column_stack([1e5 * row, -row, np.full(total, 0.5)]),
        "radius": 1e-4 + 1e-9 * row,
        "mass": 1e-8 * (row + 1.0),
        "material": (np.arange(total) % 2).astype(np.int32),
    }


def check_equal(what, actual, expected):
    actual = np.asarray(actual)
    if actual.shape != expected.shape or actual.dtype != expected.dtype or not np.array_equal(actual, expected):
        sys.exit(f"{what}: {actual.dtype}{actual.shape} differs from the expected {expected.dtype}{expected.shape}")


def check_attributes(file, total):
    expected = {
        "step": 120000, "time_s": 0.6, "state_hash": "0123456789abcdef",
        "inserted": total + 5, "inside": total, "left": 5,
        "deck": "# " + 100000 * "x" + '\ntitle = "Grieß"\n', "build_vector_level": "avx2",
    }
    for name, value in expected.items():
        if file.attrs[name] != value:
            sys.exit(f"{file.filename}: attribute {name} is {file.attrs[name]!r}")
    if list(file.attrs["materials"]) != ["glass", "steel"]:
        sys.exit(f"{file.filename}: materials are {file.attrs['materials']}")
    for name in ("version", "commit", "compiler", "flags", "mpi", "hdf5"):
        if not file.attrs["build_" + name]:
            sys.exit(f"{file.filename}: attribute build_{name} is empty")


def check_with_h5py(path, total):
    with h5py.File(path, "r") as file:
        check_attributes(file, total)
        for name, values in expected_arrays(total).items():
            check_equal(f"{path}: h5py: {name}", file["particles"][name][...], values)
        units = {"position": "m", "velocity": "m/s", "angular_velocity": "rad/s", "radius": "m", "mass": "kg"}
        for name, unit in units.items():
            if file["particles"][name].attrs["unit"] != unit:
                sys.exit(f"{path}: unit of {name}")
        if total > 0 and file["particles/position"].compression != "gzip":
            sys.exit(f"{path}: not compressed")
        if file["VTKHDF/Points"] != file["particles/position"]:
            sys.exit(f"{path}: VTKHDF/Points is a copy, not a link")
        # VTK 9.1 takes any text; the reader of ParaView 5.11 (VTK 9.2) one that fills its bytes, without a zero at the end.
        kind = file["VTKHDF"].attrs.get_id("Type").get_type()
        if (kind.get_size(), kind.get_strpad()) != (len("UnstructuredGrid"), h5py.h5t.STR_NULLPAD):
            sys.exit(f"{path}: the attribute Type of /VTKHDF is of {kind.get_size()} bytes")


def check_with_vtk(path, total):
    reader = vtkHDFReader()
    if not reader.CanReadFile(path):
        sys.exit(f"{path}: VTK does not know the file")
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if (grid.GetNumberOfPoints(), grid.GetNumberOfCells()) != (total, total):
        sys.exit(f"{path}: VTK: {grid.GetNumberOfPoints()} points, {grid.GetNumberOfCells()} cells, not {total}")
    if total == 0:
        return
    expected = expected_arrays(total)
    check_equal(f"{path}: VTK: points", vtk_to_numpy(grid.GetPoints().GetData()), expected.pop("position"))
    data = grid.GetPointData()
    if data.GetNumberOfArrays() != len(expected):
        sys.exit(f"{path}: VTK: {data.GetNumberOfArrays()} point arrays")
    for name, values in expected.items():
        check_equal(f"{path}: VTK: {name}", vtk_to_numpy(data.GetArray(name)), values)
    for cell in {0, total // 2, total - 1}:
        if grid.GetCellType(cell) != VTK_VERTEX or grid.GetCell(cell).GetPointId(0) != cell:
            sys.exit(f"{path}: VTK: cell {cell} is not the vertex of its particle")


def main():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(sys.argv[1:] + [folder], check=True)
        if sorted(os.listdir(folder)) != sorted(f"{total}.hdf" for total in TOTALS):
            sys.exit(f"unexpected files: {os.listdir(folder)}")
        for total in TOTALS:
            path = os.path.join(folder, f"{total}.hdf")
            check_with_h5py(path, total)
            check_with_vtk(path, total)


if __name__ == "__main__":
    main()
