#include "thermal/beds/grain_links.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "base/error.h"

namespace repose::thermal {
namespace {

/// Cells at least as wide as the longest reach; in a periodic direction a whole number of them.
class Cells {
 public:
  Cells(const std::vector<Grain>& grains, const Periods& periods, double reach) : periods_(periods) {
    constexpr double most = 1e6;  // cells in a direction, whose product is the number of a cell; none of them is stored
    for (std::size_t d = 0; d < 3; ++d) {
      const auto [low, high] = std::minmax_element(
          grains.begin(), grains.end(), [d](const Grain& a, const Grain& b) { return a.centre[d] < b.centre[d]; });
      low_[d] = low->centre[d];
      const double length = periods.length[d] > 0.0 ? periods.length[d] : high->centre[d] - low_[d];
      count_[d] = static_cast<std::ptrdiff_t>(std::clamp(std::floor(length / reach), 1.0, most));
      width_[d] = std::max(length / static_cast<double>(count_[d]), reach * 1e-9);
      if (periods.length[d] > 0.0 && count_[d] < 3) {
        throw DeckError(
            fmt::format("the bed is {} m long in a periodic direction; at least three reaches of {} m are "
                        "needed",
                        length, reach));
      }
    }
    order_.resize(grains.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (const Grain& g : grains) cell_.push_back(index(place(g.centre)));
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return cell_[a] < cell_[b]; });
  }

  using Place = std::array<std::ptrdiff_t, 3>;

  Place place(const Point& x) const {
    Place p{};
    for (std::size_t d = 0; d < 3; ++d)
      p[d] = std::clamp(static_cast<std::ptrdiff_t>(std::floor((x[d] - low_[d]) / width_[d])), std::ptrdiff_t{0},
                        count_[d] - 1);
    return p;
  }

  /// Calls visit(grain) for those in the cells around x.
  template <class Visit>
  void around(const Point& x, Visit&& visit) const {
    const Place centre = place(x);
    for (int k = 0; k < 27; ++k) {
      Place p = {centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1, centre[2] + k / 9 - 1};
      bool is_inside = true;
      for (std::size_t d = 0; d < 3; ++d) {
        if (periods_.length[d] > 0.0) p[d] = (p[d] + count_[d]) % count_[d];
        is_inside = is_inside && p[d] >= 0 && p[d] < count_[d];
      }
      if (!is_inside) continue;
      const std::ptrdiff_t wanted = index(p);
      auto at = std::lower_bound(order_.begin(), order_.end(), wanted,
                                 [&](std::size_t grain, std::ptrdiff_t cell) { return cell_[grain] < cell; });
      for (; at != order_.end() && cell_[*at] == wanted; ++at) visit(*at);
    }
  }

 private:
  std::ptrdiff_t index(const Place& p) const { return (p[2] * count_[1] + p[1]) * count_[0] + p[0]; }

  const Periods& periods_;
  Point low_{};
  Point width_{};
  Place count_{};
  std::vector<std::size_t> order_;
  std::vector<std::ptrdiff_t> cell_;
};

/// To the nearest image.
Point difference_of(const Point& from, const Point& to, const Periods& periods) {
  Point difference{};
  for (std::size_t d = 0; d < 3; ++d) {
    difference[d] = to[d] - from[d];
    const double length = periods.length[d];
    if (length > 0.0) difference[d] -= length * std::round(difference[d] / length);
  }
  return difference;
}

}  // namespace

std::vector<Link> links_of(const std::vector<Grain>& grains, const Periods& periods, double max_gap) {
  double largest = 0.0;
  for (const Grain& g : grains) largest = std::max(largest, g.radius);
  const Cells cells(grains, periods, (2.0 + max_gap) * largest);
  std::vector<Link> links;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    cells.around(grains[i].centre, [&](std::size_t j) {
      if (j <= i) return;
      const Point d = difference_of(grains[i].centre, grains[j].centre, periods);
      const double distance = std::hypot(d[0], d[1], d[2]);
      const double radii = grains[i].radius + grains[j].radius;
      if (distance <= radii * (1.0 + 0.5 * max_gap)) links.push_back({i, j, d, distance});
    });
  }
  return links;
}

}  // namespace repose::thermal
