#pragma once

#include <nlohmann/json.hpp>

#include "support/scenes.h"

namespace repose::test {

/// What the JSON beside a trace of LIGGGHTS (tests/reference) says of materials and pairs.
inline Coefficients coefficients_of(const nlohmann::json& j) {
  Coefficients c;
  c.youngs_modulus = j["youngs_modulus"];
  c.poisson_ratio = j["poisson_ratio"];
  c.density = j["particles"][0]["rho"];
  c.restitution_pp = j["restitution_pp"];
  c.restitution_pw = j["restitution_pw"];
  c.sliding_pp = j["sliding_pp"];
  c.sliding_pw = j["sliding_pw"];
  c.rolling_pp = j["rolling_pp"];
  c.rolling_pw = j["rolling_pw"];
  return c;
}

}  // namespace repose::test
