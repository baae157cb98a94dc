#pragma once

#include <string>
#include <vector>

#include "deck/wall_keys.h"
#include "files/read_file.h"
#include "scene/walls/mesh_features.h"
#include "scene/walls/triangle_mesh.h"
#include "scene/walls/triangle_tree.h"
#include "scene/walls/wall_face.h"
#include "scene/walls/wall_touch.h"

namespace repose {

/// A surface of triangles, felt from both sides. A touch is a place where the distance from the centre to the surface
/// has a local minimum: a face that the centre projects onto, or an edge or a vertex when it projects onto nothing
/// next to it. What is flat acts as one face (MeshFeatures). Of touches whose normals differ by less than the feature
/// angle only the nearest counts: they stand for one smooth surface, however finely it is cut into facets.
struct Mesh {
  TriangleMesh surface;
  MeshFeatures features;
  std::vector<Corners> corners;  ///< of the triangles
  TriangleTree tree;
  double cos_feature_angle;
  double rounding;  ///< m, beyond that of any distance computed here

  static bool is(WallType type) { return type == WallType::mesh; }
  /// From the STL file that the deck names. DeckError when it is none.
  static Mesh made(const WallDeck& deck, const ReadFile& read_file);
};

/// How a mesh is placed: a point p of the file goes to translate + R (scale p), with the rotation R by rotate_angle
/// (degrees) around rotate_axis through the origin.
struct MeshPlacement {
  double scale = 1.0;
  Vec3 rotate_axis{0.0, 0.0, 1.0};
  double rotate_angle = 0.0;
  Vec3 translate;
};

/// A mesh from the triangles of a file; `feature_angle` in degrees, above 0. std::invalid_argument, saying what is
/// wrong, when no triangle has an area or the placed mesh is smaller than 1e-6 m or reaches beyond 1e6 m.
Mesh make_mesh(const std::vector<Corners>& triangles, const MeshPlacement& placement, double feature_angle);

/// How far in m the plane of a flat patch may be from its triangles, with a margin. A vertex very far away makes the
/// whole mesh coarse, as its file has single precision.
double flatness(const Mesh& mesh);

/// As those of the other shapes (wall_shape.h).
void find_touches(const Mesh& mesh, const Vec3& centre, double reach, int wall, TouchBuffer& out);
double distance(const Mesh& mesh, const Vec3& centre);
Face face_of(const Mesh& mesh, int feature);

/// Whether the surface is nearer than `reach` (m), or nearly so; much faster than the distance.
bool is_within(const Mesh& mesh, const Vec3& centre, double reach);

/// Whether a particle can touch the face `feature`, onto which its centre projects, and nothing else of the mesh until
/// it has moved by `skin` (m); `reach` (m) is its radius and the skin. May be false when it could be true.
bool keeps_to_face(const Mesh& mesh, int feature, const Vec3& centre, double reach, double skin);

/// Whether two features have a vertex in common, or are patches of one smooth surface.
bool adjacent_features(const Mesh& mesh, int a, int b);

/// What the mesh consists of, its defects and where it is, in one line.
std::string describe(const Mesh& mesh);

}  // namespace repose
