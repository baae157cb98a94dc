#include "photo/patches.h"

#include <algorithm>

#include "base/math.h"

namespace repose::photo {
namespace {

/// Sets of numbers that turned out to be one (union-find with path halving).
class Sets {
 public:
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }
  std::int32_t find(std::int32_t i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  /// The smaller number stands for both.
  std::int32_t join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    parent(std::max(a, b)) = std::min(a, b);
    return std::min(a, b);
  }
  std::size_t size() const { return parent_.size(); }

 private:
  std::int32_t& parent(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

/// Labels that may be several within one patch, and which belong together.
Sets label_rows(Patches& patches, std::size_t height, const std::function<bool(std::size_t, std::size_t)>& belongs) {
  Sets sets;
  const std::size_t w = patches.width;
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < w; ++x) {
      if (!belongs(x, y)) continue;
      std::int32_t label = x > 0 ? patches.at(x - 1, y) : -1;
      for (std::size_t above = x > 0 ? x - 1 : 0; y > 0 && above <= std::min(x + 1, w - 1); ++above) {
        const std::int32_t other = patches.at(above, y - 1);
        if (other >= 0) label = label < 0 ? sets.find(other) : sets.join(label, other);
      }
      patches.label[y * w + x] = label < 0 ? sets.add() : label;
    }
  }
  return sets;
}

/// Sums from which area, centre and roundness follow.
struct Sums {
  double x = 0.0, y = 0.0, squares = 0.0;
};

}  // namespace

Patches find_patches(std::size_t width, std::size_t height,
                     const std::function<bool(std::size_t x, std::size_t y)>& belongs) {
  Patches result{.width = width, .label = std::vector<std::int32_t>(width * height, -1), .all = {}};
  Sets sets = label_rows(result, height, belongs);
  std::vector<std::int32_t> number(sets.size(), -1);
  std::vector<Sums> sums;
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::int32_t& label = result.label[y * width + x];
      if (label < 0) continue;
      std::int32_t& n = number[static_cast<std::size_t>(sets.find(label))];
      if (n < 0) {
        n = static_cast<std::int32_t>(result.all.size());
        result.all.push_back({.left = x, .right = x, .top = y, .bottom = y});
        sums.emplace_back();
      }
      label = n;
      Patch& patch = result.all[static_cast<std::size_t>(n)];
      Sums& sum = sums[static_cast<std::size_t>(n)];
      const auto u = static_cast<double>(x);
      const auto v = static_cast<double>(y);
      patch.area += 1.0;
      sum.x += u;
      sum.y += v;
      sum.squares += u * u + v * v;
      patch.left = std::min(patch.left, x);
      patch.right = std::max(patch.right, x);
      patch.bottom = y;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    Patch& p = result.all[i];
    p.x = sums[i].x / p.area;
    p.y = sums[i].y / p.area;
    // A pixel is a square: a sixth of its area is its own second moment.
    const double moment = sums[i].squares - p.area * (p.x * p.x + p.y * p.y) + p.area / 6.0;
    p.roundness = p.area * p.area / (2.0 * pi * moment);
  }
  return result;
}

Largest largest(const std::vector<Patch>& patches) {
  Largest result;
  const auto area = [&](std::int32_t i) { return i < 0 ? -1.0 : patches[static_cast<std::size_t>(i)].area; };
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(patches.size()); ++i) {
    if (area(i) > area(result.first)) {
      result.second = result.first;
      result.first = i;
    } else if (area(i) > area(result.second)) {
      result.second = i;
    }
  }
  return result;
}

}  // namespace repose::photo
