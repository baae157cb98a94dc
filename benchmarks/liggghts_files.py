"""What benchmarks give to LIGGGHTS and LAMMPS: grains as data files, walls as triangles."""

import math


def write_data(path, bounds, types, grains):
    """Grains for `read_data` (atom style granular).

    bounds  (low, high) in x, y and z, m
    types   number of atom types
    grains  iterable of (type, radius, density, position, velocity, spin), in SI
    """
    grains = list(grains)
    with open(path, "w") as file:
        file.write(f"grains\n\n{len(grains)} atoms\n{types} atom types\n\n")
        for axis, (low, high) in zip("xyz", bounds):
            file.write(f"{low!r} {high!r} {axis}lo {axis}hi\n")
        file.write("\nAtoms\n\n")
        for i, (kind, radius, density, position, _, _) in enumerate(grains, 1):
            file.write(f"{i} {kind} {2 * radius!r} {density} {' '.join(map(repr, position))}\n")
        file.write("\nVelocities\n\n")
        for i, (_, _, _, _, velocity, spin) in enumerate(grains, 1):
            file.write(f"{i} {' '.join(map(repr, [*velocity, *spin]))}\n")


def write_stl(path, triangles):
    """Triangles, each three points in m, as ASCII STL."""
    with open(path, "w") as file:
        file.write("solid wall\n")
        for corners in triangles:
            file.write("facet normal 0 0 0\nouter loop\n")
            for x, y, z in corners:
                file.write(f"vertex {x!r} {y!r} {z!r}\n")
            file.write("endloop\nendfacet\n")
        file.write("endsolid wall\n")


def turned(points, segments=64):
    """Triangles of a polyline (r, z) turned around the z axis: a polygon as far beyond the circle as within it."""
    polygon = 2.0 / (1.0 + math.cos(math.pi / segments))
    turn = [2.0 * math.pi * (k % segments) / segments for k in range(segments + 1)]
    for (r1, z1), (r2, z2) in zip(points, points[1:]):
        for a, b in zip(turn, turn[1:]):
            p, q, s, t = ((polygon * r * math.cos(angle), polygon * r * math.sin(angle), z)
                          for r, z, angle in ((r1, z1, a), (r1, z1, b), (r2, z2, a), (r2, z2, b)))
            yield p, q, s
            yield q, t, s
