#!/usr/bin/env python3
"""Writes a round funnel, a cylinder above a cone, as ASCII STL in mm to the standard output; by default input/hopper.stl."""

import argparse
import math

# name, default and meaning of the numbers
NUMBERS = (("facets", 24, "around the axis"), ("r_top", 12.0, "radius of the cylinder, mm"), ("r_outlet", 5.0, "radius of the outlet, mm"),
           ("z_top", 60.0, "height of the upper rim, mm"), ("z_edge", 20.0, "height at which the cone begins, mm"),
           ("z_outlet", 0.0, "height of the outlet, mm"))


def ring(facets, radius, z):
    angles = [2.0 * math.pi * k / facets for k in range(facets)]
    return [(radius * math.cos(a), radius * math.sin(a), z) for a in angles]


def band(low, high):
    """The triangles between two rings, their normals inwards."""
    for k in range(len(low)):
        n = (k + 1) % len(low)
        yield low[k], high[k], low[n]
        yield low[n], high[k], high[n]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name, default, meaning in NUMBERS:
        parser.add_argument(name, nargs="?", type=type(default), default=default, help=f"{meaning}; {default:g}")
    given = parser.parse_args()
    rings = [ring(given.facets, r, z)
             for r, z in ((given.r_outlet, given.z_outlet), (given.r_top, given.z_edge), (given.r_top, given.z_top))]
    print("solid funnel")
    for low, high in zip(rings, rings[1:]):
        for corners in band(low, high):
            print(" facet normal 0 0 0\n  outer loop")
            for corner in corners:
                print("   vertex " + " ".join(f"{x:.6g}" for x in corner))
            print("  endloop\n endfacet")
    print("endsolid funnel")


main()
