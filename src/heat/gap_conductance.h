#pragma once

/// Heat conducted between two grains that touch or nearly do, through their contact and through the gas around it.
namespace repose {

/// Two grains of a pair.
struct GrainPair {
  double radius_1 = 0.0;  ///< m
  double radius_2 = 0.0;
  double conductivity_1 = 0.0;  ///< W/(m K)
  double conductivity_2 = 0.0;
  double gap = 0.0;             ///< m between the surfaces; 0 or less when they touch
  double contact_radius = 0.0;  ///< m; 0 when they do not touch
};

/// What fills the gap.
struct GapFill {
  double conductivity = 0.0;  ///< of the gas in the continuum, W/(m K)
  double free_path = 0.0;     ///< l of (B.7), m: the gas conducts over g + l instead of g
  double radiation = 0.0;     ///< heat transfer coefficient h_r between the surfaces, W/(m2 K) (T.18)
};

/// Radius of the circle of the contact of two grains in m, Hertz: sqrt(R_eff overlap), times the cube root of the
/// simulated over the real Young's modulus, as the same force presses the real grains less flat (T.15).
double contact_radius(double radius_1, double radius_2, double overlap, double stiffness_ratio);
/// The same by that cube root.
double contact_radius_by_root(double radius_1, double radius_2, double overlap, double stiffness_root);

/// Conductance of the contact's circle in W/K: 2 k a with the harmonic mean of the conductivities (T.16). Batchelor and
/// O'Brien 1977, doi:10.1098/rspa.1977.0100, for grains of equal conductivity; for two Cheng, Yu and Zulli 1999.
double contact_conductance(const GrainPair& pair);

/// Conductance in W/K through the gas around the contact, in columns along the line of centres: solid, gap, solid in
/// series, inside the double cone that the pair's share of the bed is (T.17). Cheng, Yu and Zulli 1999,
/// doi:10.1016/S0009-2509(99)00125-6, with the mean radius of the faces between Voronoi cells in a bed of `porosity`,
/// 0.560 R (1 - porosity)^(-1/3), of Yang, Zou and Yu 2002, doi:10.1103/PhysRevE.65.041302. What fills the gap, and
/// cones of different heights for grains of different radii, are additions (docs/theory-thermal.md).
double gap_conductance(const GrainPair& pair, const GapFill& fill, double porosity);

/// h_r in W/(m2 K) of two surfaces at `temperature` in K (T.18).
double radiative_coefficient(double temperature, double emissivity_1, double emissivity_2);

}  // namespace repose
