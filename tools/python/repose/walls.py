"""The walls of a resolved deck as surfaces to look at: points and polygons, in m, where they are before anything moves.

Planes have no end: they are cut at the sides of the domain. For ParaView (tools/open_in_paraview.py); needs nothing but
Python.
"""
import itertools
import math
import os
import struct
import tomllib

SIDES = 72  # of a circle


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def plus(a, *multiples):
    """a + sum of factor times vector."""
    return [x + sum(factor * vector[k] for factor, vector in multiples) for k, x in enumerate(a)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def frame(axis):
    """Three perpendicular unit vectors, the last along the axis."""
    w = unit(axis)
    u = unit(cross(w, [1.0, 0.0, 0.0] if abs(w[0]) < 0.9 else [0.0, 1.0, 0.0]))
    return u, cross(w, u), w


def profile(wall, _deck, _folder):
    u, v, w = frame(wall["axis_direction"])
    rings = wall["points"]
    points = []
    for r, z in rings:
        turns = (2.0 * math.pi * k / SIDES for k in range(SIDES))
        points += [plus(wall["axis_origin"], (r * math.cos(t), u), (r * math.sin(t), v), (z, w)) for t in turns]
    polygons = [[ring * SIDES + k, ring * SIDES + (k + 1) % SIDES, (ring + 1) * SIDES + (k + 1) % SIDES,
                 (ring + 1) * SIDES + k] for ring in range(len(rings) - 1) for k in range(SIDES)]
    return points, polygons


def disc(wall, _deck, _folder):
    u, v, _ = frame(wall["normal"])
    turns = (2.0 * math.pi * k / SIDES for k in range(SIDES))
    r = wall["radius"]
    return [plus(wall["centre"], (r * math.cos(t), u), (r * math.sin(t), v)) for t in turns], [list(range(SIDES))]


def rectangle(wall, _deck, _folder):
    c, u, v = wall["corner"], wall["edge_u"], wall["edge_v"]
    return [c, plus(c, (1.0, u)), plus(c, (1.0, u), (1.0, v)), plus(c, (1.0, v))], [[0, 1, 2, 3]]


def plane(wall, deck, _folder):
    """The part within the domain: a large square, cut by the six sides one after the other."""
    low, high = deck["domain"]["min"], deck["domain"]["max"]
    u, v, w = frame(wall["normal"])
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    centre = plus(middle, (dot(minus(wall["point"], middle), w), w))
    size = math.dist(low, high) + math.dist(centre, middle)
    polygon = [plus(centre, (a * size, u), (b * size, v)) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    for k in range(3):
        for sign, bound in ((1.0, high[k]), (-1.0, -low[k])):
            polygon = cut(polygon, k, sign, bound)
    return polygon, [list(range(len(polygon)))] if len(polygon) > 2 else []


def cut(polygon, k, sign, bound):
    """What of a polygon has sign times its coordinate k at most at the bound (Sutherland and Hodgman 1974)."""
    kept = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        over_a, over_b = sign * a[k] - bound, sign * b[k] - bound
        if over_a <= 0.0:
            kept.append(a)
        if (over_a <= 0.0) != (over_b <= 0.0):
            kept.append(plus(a, (over_a / (over_a - over_b), minus(b, a))))
    return kept


def read_stl(path):
    """Corners of the triangles, three after each other, of a binary or ASCII file."""
    with open(path, "rb") as file:
        data = file.read()
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        return [list(struct.unpack_from("<3f", data, 84 + 50 * t + 12 * (1 + c))) for t in range(count)
                for c in range(3)]
    words = data.decode().split()
    return [[float(x) for x in words[i + 1:i + 4]] for i, word in enumerate(words) if word.lower() == "vertex"]


def mesh(wall, _deck, folder):
    """Scaled, turned (Rodrigues), moved, as `repose run` does it."""
    axis = unit(wall["rotate_axis"])
    angle = math.radians(wall["rotate_angle"])
    points = []
    for corner in read_stl(os.path.join(folder, wall["file"])):
        p = [wall["scale"] * x for x in corner]
        turned = plus([0.0] * 3, (math.cos(angle), p), (math.sin(angle), cross(axis, p)),
                      ((1.0 - math.cos(angle)) * dot(axis, p), axis))
        points.append(plus(turned, (1.0, wall["translate"])))
    return points, [[k, k + 1, k + 2] for k in range(0, len(points), 3)]


SHAPES = {"profile": profile, "disc": disc, "rectangle": rectangle, "plane": plane, "mesh": mesh}


def wall_surfaces(deck_path, folder=None):
    """Name, whether it is present from the start, points and polygons of each wall; files of meshes are relative to the
    folder, by default that of the deck."""
    with open(deck_path, "rb") as file:
        deck = tomllib.load(file)
    folder = folder or os.path.dirname(deck_path)
    return [(wall["name"], wall.get("present", True), *SHAPES[wall["type"]](wall, deck, folder))
            for wall in deck.get("wall", ())]


def vtp_of(points, polygons):
    """The surface as a file of VTK's XML format for PolyData."""
    def rows(values):
        return "\n".join(" ".join(f"{x!r}" for x in row) for row in values)

    ends = list(itertools.accumulate(len(p) for p in polygons))
    return (f'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">\n<PolyData>\n'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" '
            f'NumberOfPolys="{len(polygons)}">\n<Points>\n'
            f'<DataArray type="Float64" NumberOfComponents="3" format="ascii">\n'
            f'{rows(points)}\n</DataArray>\n</Points>\n<Polys>\n'
            f'<DataArray type="Int64" Name="connectivity" format="ascii">\n{rows(polygons)}\n</DataArray>\n'
            f'<DataArray type="Int64" Name="offsets" format="ascii">\n{rows([ends])}\n</DataArray>\n'
            f'</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n')
