#pragma once

/// Constants of nature, SI, exact or rounded to ten digits (CODATA 2018, doi:10.1103/RevModPhys.93.025010).
namespace repose {

inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< W/(m2 K4)
inline constexpr double gas_constant = 8.31446261815324;    ///< J/(mol K)

}  // namespace repose
