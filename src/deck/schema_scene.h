#pragma once

#include "deck/schema_types.h"

/// Schema of the scene: materials, walls and particles.
namespace repose {

template <class V>
void describe(V& v, MaterialDeck& m) {
  v("name", m.name, Unit::none, any_value, required, "name, used once: a letter, then letters, digits, _ or -");
  v("youngs_modulus", m.youngs_modulus, Unit::pascal, above(0), required, "Young's modulus");
  v("poisson_ratio", m.poisson_ratio, Unit::none, from_to_below(0, 0.5), required, "Poisson's ratio");
  v("density", m.density, Unit::density, above(0), required, "density of the solid");
}

template <class V>
void describe(V& v, PairDeck& p) {
  v("materials", p.materials, Unit::none, any_value, required, "the two materials, which may be the same");
  v("restitution", p.restitution, Unit::none, from_to(0, 1), required, "coefficient of restitution");
  v("sliding_friction", p.sliding_friction, Unit::none, at_least(0), required, "Coulomb's coefficient of friction");
  v("rolling_friction", p.rolling_friction, Unit::none, at_least(0), required,
    "coefficient of rolling friction (EPSD2)");
}

template <class V>
void describe_mesh(V& v, WallDeck& w) {
  const bool is_mesh = w.type == WallType::mesh;
  v("file", w.file, Unit::none, any_value, required.when(is_mesh, "type = mesh"),
    "path from the deck's folder to an STL file, binary or ASCII");
  v("scale", w.scale, Unit::none, above(0), optional.when(is_mesh, "type = mesh"),
    "metres per unit of the file, such as 0.001 for mm");
  v("rotate_axis", w.rotate_axis, Unit::none, any_value, optional.when(is_mesh, "type = mesh"),
    "axis through the file's origin, of any length");
  v("rotate_angle", w.rotate_angle, Unit::none, from_to(-360, 360), optional.when(is_mesh, "type = mesh"),
    "angle around it by the right-hand rule, in degrees");
  v("translate", w.translate, Unit::metre, any_value, optional.when(is_mesh, "type = mesh"),
    "displacement, after scale and rotation");
  v("feature_angle", w.feature_angle, Unit::none, from_to(0.1, 90), optional.when(is_mesh, "type = mesh"),
    "facets that turn by less, in degrees, are one smooth surface, touched once");
}

template <class V>
void describe(V& v, WallDeck& w) {
  v("name", w.name, Unit::none, any_value, required, "name, used once");
  v("type", w.type, Unit::none, any_value, required,
    "profile: a polyline turned around an axis; plane: without bounds; mesh: triangles from an STL file");
  const bool is_profile = w.type == WallType::profile;
  const bool is_plane = w.type == WallType::plane;
  const bool is_disc = w.type == WallType::disc;
  const bool is_rectangle = w.type == WallType::rectangle;
  v("material", w.material, Unit::none, any_value, required, "name of its material");
  v("present", w.present, Unit::none, any_value, optional, "false: a phase adds it");
  v("points", w.points, Unit::metre, any_value, required.when(is_profile, "type = profile"),
    "polyline: r >= 0 from the axis, z along it");
  v("axis_origin", w.axis_origin, Unit::metre, any_value, optional.when(is_profile, "type = profile"),
    "point of the axis where z = 0");
  v("axis_direction", w.axis_direction, Unit::none, any_value, optional.when(is_profile, "type = profile"),
    "direction of z, of any length");
  v("point", w.point, Unit::metre, any_value, required.when(is_plane, "type = plane"), "a point of the plane");
  v("normal", w.normal, Unit::none, any_value, optional.when(is_plane || is_disc, "type = plane, disc"),
    "normal, of any length");
  v("centre", w.centre, Unit::metre, any_value, required.when(is_disc, "type = disc"), "centre");
  v("radius", w.radius, Unit::metre, above(0), required.when(is_disc, "type = disc"), "radius");
  v("corner", w.corner, Unit::metre, any_value, required.when(is_rectangle, "type = rectangle"), "a corner");
  v("edge_u", w.edge_u, Unit::metre, any_value, required.when(is_rectangle, "type = rectangle"),
    "edge from the corner");
  v("edge_v", w.edge_v, Unit::metre, any_value, required.when(is_rectangle, "type = rectangle"),
    "other edge from the corner, perpendicular to edge_u");
  describe_mesh(v, w);
}

template <class V>
void describe(V& v, ParticlesDeck& p) {
  v("type", p.type, Unit::none, any_value, required, "fill: a jittered lattice in a region; csv: a list");
  const bool is_fill = p.type == ParticlesType::fill;
  v("file", p.file, Unit::none, any_value, required.when(!is_fill, "type = csv"),
    "path from the deck's folder; columns x,y,z,vx,vy,vz,wx,wy,wz,radius,material");
  v("material", p.material, Unit::none, any_value, required.when(is_fill, "type = fill"), "name of the material");
  v("diameter", p.diameter, Unit::metre, above(0), required.when(is_fill, "type = fill"), "diameter of the spheres");
  v("mass", p.mass, Unit::kilogram, above(0), optional_else("none; this or count").when(is_fill, "type = fill"),
    "total mass, to within one particle");
  v("count", p.count, Unit::none, at_least(1), optional_else("none; this or mass").when(is_fill, "type = fill"),
    "number of particles");
  describe_region(v, p, is_fill);
  v("spacing", p.spacing, Unit::metre, above(0), optional_else("1.1 diameters").when(is_fill, "type = fill"),
    "lattice constant, at least the diameter");
  v("jitter", p.jitter, Unit::none, from_to(0, 1), optional.when(is_fill, "type = fill"),
    "share of the free gap by which a particle may be moved");
  v("velocity", p.velocity, Unit::speed, any_value, optional.when(is_fill, "type = fill"), "initial velocity");
}

template <class V>
void describe_region(V& v, ParticlesDeck& p, bool is_fill) {
  v("region", p.region, Unit::none, any_value, required.when(is_fill, "type = fill"),
    "shape of the region; a cylinder is upright (z)");
  const bool is_cylinder = is_fill && p.region == RegionShape::cylinder;
  const bool is_box = is_fill && p.region == RegionShape::box;
  v("centre", p.centre, Unit::metre, any_value, required.when(is_cylinder, "region = cylinder"),
    "centre of the bottom");
  v("radius", p.radius, Unit::metre, above(0), required.when(is_cylinder, "region = cylinder"), "radius at the bottom");
  v("radius_top", p.radius_top, Unit::metre, above(0), optional_else("radius").when(is_cylinder, "region = cylinder"),
    "radius at the top (a cone frustum)");
  v("height", p.height, Unit::metre, above(0), required.when(is_cylinder, "region = cylinder"), "height");
  v("min", p.min, Unit::metre, any_value, required.when(is_box, "region = box"), "lowest corner");
  v("max", p.max, Unit::metre, any_value, required.when(is_box, "region = box"), "highest corner");
}

}  // namespace repose
