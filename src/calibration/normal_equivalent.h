#pragma once

namespace repose {

/// The z of a normal distribution that is as unlikely as a t of Student's with `freedom` degrees of freedom, with the
/// sign of t (C.14): up to 5 degrees of freedom by both distributions, from 6 on by Wallace, Ann. Math. Stat. 30 (1959)
/// 1121, within 0.03 up to z = 3 and exact for infinitely many; between 5 and 6 it goes from the one to the other.
double normal_equivalent(double t, double freedom);

/// ln dz/dt of it.
double log_slope_of_normal_equivalent(double t, double freedom);

}  // namespace repose
