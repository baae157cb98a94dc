#pragma once

namespace repose {

/// beta = ln e / sqrt(ln^2 e + pi^2) (thesis eq. 2.10); e = 0 gives -1, e = 1 gives 0. The Hertz damping built on it
/// returns the restitution coefficient e it is fed (Tsuji, Tanaka, Ishida 1992, doi:10.1016/0032-5910(92)88030-L), and
/// so does Hooke's.
double damping_ratio(double restitution);

/// The same where the normal force never pulls, for 0 < e <= 1: the negative of the zeta that solves
/// ln e = -2 zeta arccos(zeta) / sqrt(1 - zeta^2), or with arcosh and zeta^2 - 1 beyond 1 (Schwager, Poeschel 2007,
/// doi:10.1007/s10035-007-0065-z, for Hooke; docs/theory.md for Hertz, the same equation). Below -1 for e < exp(-2).
double damping_ratio_without_attraction(double restitution);

}  // namespace repose
