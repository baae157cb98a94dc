"""PolyData of VTK's XML format as the program writes it: arrays behind the XML, compressed by zlib or as they are."""

import pathlib
import xml.etree.ElementTree as tree
import zlib

import numpy as np

from repose.files import ReposeError

TYPES = {"Float64": np.float64, "Int64": np.int64, "Int32": np.int32}
MARK = b'<AppendedData encoding="raw">\n_'


def inflated(data, offset):
    """The bytes of an array of several compressed blocks: their number, size, that of the last, compressed sizes."""
    count = int(np.frombuffer(data, np.uint64, 1, offset)[0])
    sizes = np.frombuffer(data, np.uint64, count, offset + 24)
    ends = offset + 24 + 8 * count + np.cumsum(sizes, dtype=np.int64)
    return b"".join(zlib.decompress(data[end - int(size):end]) for size, end in zip(sizes, ends))


def plain(data, offset):
    size = int(np.frombuffer(data, np.uint64, 1, offset)[0])
    return data[offset + 8:offset + 8 + size]


def read_poly_data(path):
    """Its arrays by name, those of several components as rows."""
    try:
        head, mark, data = pathlib.Path(path).read_bytes().partition(MARK)
    except OSError as error:
        raise ReposeError(f"{path}: cannot be read: {error.strerror}") from None
    try:
        root = tree.fromstring(head + b"</VTKFile>")
        bytes_of = inflated if "compressor" in root.attrib else plain
        arrays = {}
        for node in root.iter("DataArray"):
            values = np.frombuffer(bytes_of(data, int(node.get("offset"))), TYPES[node.get("type")])
            width = int(node.get("NumberOfComponents"))
            arrays[node.get("Name")] = values.reshape(-1, width) if width > 1 else values
    except (tree.ParseError, KeyError, TypeError, ValueError, IndexError, zlib.error):
        arrays = {}
    if not arrays or not mark:
        raise ReposeError(f"{path}: is no PolyData of repose, or damaged")
    return arrays
