#!/usr/bin/env python3
"""Writes a round funnel, a cylinder above a cone, as ASCII STL in mm to the standard output.

Usage: make_funnel.py [FACETS [R_TOP R_OUTLET Z_TOP Z_EDGE Z_OUTLET]]
Default: 24 12 5 60 20 0, which is input/hopper.stl.
"""

import math
import sys


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
    given = [float(a) for a in sys.argv[1:]]
    defaults = [24, 12.0, 5.0, 60.0, 20.0, 0.0]
    facets, r_top, r_outlet, z_top, z_edge, z_outlet = given + defaults[len(given):]
    rings = [ring(int(facets), r, z) for r, z in ((r_outlet, z_outlet), (r_top, z_edge), (r_top, z_top))]
    print("solid funnel")
    for low, high in zip(rings, rings[1:]):
        for corners in band(low, high):
            print(" facet normal 0 0 0\n  outer loop")
            for corner in corners:
                print("   vertex " + " ".join(f"{x:.6g}" for x in corner))
            print("  endloop\n endfacet")
    print("endsolid funnel")


main()
