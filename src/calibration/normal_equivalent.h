#pragma once

namespace repose {

/// The z of a normal distribution that is as unlikely as a t of Student's with `freedom` degrees of freedom, with the
/// sign of t (C.14): Wallace, Ann. Math. Stat. 30 (1959) 1121; within 0.02 up to z = 3 for 3 degrees of freedom or
/// more, exact for infinitely many.
double normal_equivalent(double t, double freedom);

/// ln dz/dt of it.
double log_slope_of_normal_equivalent(double t, double freedom);

}  // namespace repose
