#pragma once

#include <array>

namespace repose {

struct GaussNode {
  double place;
  double weight;
};

/// Gauss-Legendre with 5 nodes on [0, 1] (Abramowitz and Stegun, table 25.4): exact to the ninth power.
inline constexpr std::array<GaussNode, 5> gauss_nodes = {{{0.0469100770306680, 0.1184634425280945},
                                                          {0.2307653449471585, 0.2393143352496832},
                                                          {0.5, 0.2844444444444444},
                                                          {0.7692346550528415, 0.2393143352496832},
                                                          {0.9530899229693320, 0.1184634425280945}}};

/// The integral of f over [begin, end].
template <class F>
double gauss_integral(double begin, double end, F&& f) {
  double sum = 0.0;
  for (const auto& [place, weight] : gauss_nodes) sum += weight * f(begin + place * (end - begin));
  return sum * (end - begin);
}

}  // namespace repose
