#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/math.h"
#include "deck/deck.h"
#include "scene/walls/triangle.h"
#include "support/draw.h"

/// Meshes of simple bodies and their STL files.
namespace repose::test {

using Triangles = std::vector<Corners>;

/// With all digits, so that the reader gets back the same doubles.
inline std::string ascii_stl(const Triangles& triangles) {
  std::string text = "solid body\n";
  for (const Corners& c : triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const Vec3& p : c) text += fmt::format("  vertex {} {} {}\n", p.x, p.y, p.z);
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid body\n";
}

/// In single precision.
inline std::string binary_stl(const Triangles& triangles, const std::string& title = "body") {
  std::string text = title;
  text.resize(80, ' ');
  const auto append = [&](const auto& value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    text.append(bytes, sizeof(value));
  };
  append(static_cast<std::uint32_t>(triangles.size()));
  for (const Corners& c : triangles) {
    for (int k = 0; k < 3; ++k) append(0.0F);
    for (const Vec3& p : c) {
      for (const double x : {p.x, p.y, p.z}) append(static_cast<float>(x));
    }
    append(std::uint16_t{0});
  }
  return text;
}

inline void add_quadrangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, bool other_diagonal,
                           Triangles& out) {
  if (other_diagonal) {
    out.push_back({a, b, d});
    out.push_back({b, c, d});
  } else {
    out.push_back({a, b, c});
    out.push_back({a, c, d});
  }
}

/// The square |x|, |y| <= half at z = 0 in n x n irregular cells (n even) whose diagonals and windings are drawn; the
/// vertices in the middle row lie on y = 0.
inline Triangles irregular_square(double half, int n) {
  Draw draw(11);
  const double cell = 2.0 * half / n;
  std::vector<Vec3> points;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      Vec3 p = {-half + cell * i, j == n / 2 ? 0.0 : -half + cell * j, 0.0};
      if (i > 0 && i < n) p.x += draw(-0.3, 0.3) * cell;
      if (j > 0 && j < n && j != n / 2) p.y += draw(-0.3, 0.3) * cell;
      points.push_back(p);
    }
  }
  const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(j * (n + 1) + i)]; };
  Triangles square;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      add_quadrangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), draw(0.0, 1.0) < 0.5, square);
      if (draw(0.0, 1.0) < 0.5) std::swap(square.back()[0], square.back()[1]);
    }
  }
  return square;
}

/// The frustum around the z axis from radius r0 at z0 to r1 at z1, of n facets in each of m rings. The middles of the
/// facets lie on the smooth surface, the first of them at y = 0.
inline Triangles frustum(double r0, double z0, double r1, double z1, int n, int m = 1) {
  const auto at = [&](int i, int k) {
    const double s = static_cast<double>(k) / m;
    const double r = (r0 + s * (r1 - r0)) / std::cos(pi / n);
    const double angle = 2.0 * pi * (i % n - 0.5) / n;
    return Vec3{r * std::cos(angle), r * std::sin(angle), z0 + s * (z1 - z0)};
  };
  Triangles side;
  for (int k = 0; k < m; ++k) {
    for (int i = 0; i < n; ++i) add_quadrangle(at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1), false, side);
  }
  return side;
}

/// The surface of a box.
inline Triangles box(const Vec3& low, const Vec3& high) {
  const auto at = [&](int i) {
    return Vec3{i % 2 > 0 ? high.x : low.x, i / 2 % 2 > 0 ? high.y : low.y, i / 4 > 0 ? high.z : low.z};
  };
  Triangles faces;
  for (const auto& [a, b, c, d] :
       {std::array{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
    add_quadrangle(at(a), at(b), at(c), at(d), false, faces);
  }
  return faces;
}

inline WallDeck mesh_deck(const std::string& file = "body.stl") {
  WallDeck deck;
  deck.name = "mesh";
  deck.type = WallType::mesh;
  deck.material = "wall";
  deck.file = file;
  return deck;
}

}  // namespace repose::test
