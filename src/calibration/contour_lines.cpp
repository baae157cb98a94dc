#include "calibration/contour_lines.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace repose {
namespace {

/// A side of a cell: 2 (its lower or left node), plus 1 when it goes upwards from that node.
using Side = std::size_t;

struct Sheet {
  const std::function<double(double, double)>& surface;
  PlaneRange x, y;
  double level;
  std::size_t cells;
  std::vector<double> above;  ///< surface less level at the nodes

  std::size_t node(std::size_t i, std::size_t j) const { return j * (cells + 1) + i; }
  PlanePoint place(std::size_t node) const {
    const double u = static_cast<double>(node % (cells + 1)) / static_cast<double>(cells);
    const double v = static_cast<double>(node / (cells + 1)) / static_cast<double>(cells);
    return {(1.0 - u) * x.lower + u * x.upper, (1.0 - v) * y.lower + v * y.upper};
  }
  double at(const PlanePoint& p) const { return surface(p.x, p.y) - level; }

  /// The point of the level on a side, by bisection.
  PlanePoint crossing(Side side) const {
    const std::size_t first = side / 2;
    PlanePoint a = place(first);
    PlanePoint b = place(side % 2 == 0 ? first + 1 : first + cells + 1);
    const bool a_above = above[first] >= 0.0;
    for (int halving = 0; halving < 20; ++halving) {
      const PlanePoint middle = {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
      ((at(middle) >= 0.0) == a_above ? a : b) = middle;
    }
    return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  }
};

/// Pairs of sides of the cell above node (i, j) that the line connects.
std::vector<std::pair<Side, Side>> segments(const Sheet& s, std::size_t i, std::size_t j) {
  const std::array<std::size_t, 4> nodes = {s.node(i, j), s.node(i + 1, j), s.node(i + 1, j + 1), s.node(i, j + 1)};
  const std::array<Side, 4> sides = {2 * nodes[0], 2 * nodes[1] + 1, 2 * nodes[3], 2 * nodes[0] + 1};
  std::vector<Side> crossed;  // around the cell
  for (std::size_t k = 0; k < 4; ++k) {
    if (std::isnan(s.above[nodes[k]])) return {};
    if ((s.above[nodes[k]] >= 0.0) != (s.above[nodes[(k + 1) % 4]] >= 0.0)) crossed.push_back(sides[k]);
  }
  if (crossed.size() == 2) return {{crossed[0], crossed[1]}};
  if (crossed.size() != 4) return {};
  // A saddle: its middle says which opposite corners are connected.
  const PlanePoint low = s.place(nodes[0]);
  const PlanePoint high = s.place(nodes[2]);
  const bool middle = s.at({0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}) >= 0.0;
  if (middle == (s.above[nodes[0]] >= 0.0)) return {{crossed[0], crossed[1]}, {crossed[2], crossed[3]}};
  return {{crossed[3], crossed[0]}, {crossed[1], crossed[2]}};
}

/// The sides that each crossed side is connected with.
using Links = std::map<Side, std::vector<Side>>;

void unlink(Links& links, Side from, Side to) {
  std::erase(links[from], to);
  std::erase(links[to], from);
}

/// Follows the line from a side to its end, or around, and takes it out of the links.
ContourLine follow(const Sheet& sheet, Links& links, Side side) {
  ContourLine line = {sheet.crossing(side)};
  while (!links[side].empty()) {
    const Side next = links[side].front();
    unlink(links, side, next);
    side = next;
    line.push_back(sheet.crossing(side));
  }
  return line;
}

}  // namespace

std::vector<ContourLine> contour_lines(const std::function<double(double x, double y)>& surface, PlaneRange x,
                                       PlaneRange y, double level, int cells) {
  Sheet sheet = {surface, x, y, level, static_cast<std::size_t>(cells), {}};
  for (std::size_t node = 0; node < (sheet.cells + 1) * (sheet.cells + 1); ++node) {
    sheet.above.push_back(sheet.at(sheet.place(node)));
  }
  Links links;
  for (std::size_t j = 0; j < sheet.cells; ++j) {
    for (std::size_t i = 0; i < sheet.cells; ++i) {
      for (const auto& [a, b] : segments(sheet, i, j)) {
        links[a].push_back(b);
        links[b].push_back(a);
      }
    }
  }
  std::vector<ContourLine> lines;
  // Open lines first, from their ends; what is left are closed ones.
  for (const std::size_t ends : {1U, 2U}) {
    for (auto& [side, others] : links) {
      if (others.size() == ends) lines.push_back(follow(sheet, links, side));
    }
  }
  return lines;
}

}  // namespace repose
