#pragma once

#include <cmath>
#include <type_traits>

namespace repose {

/// Three components, each a double or, in the hot loops, a Quad of four lanes. Evaluated exactly as written (the build
/// forbids contraction), so that results are reproducible.
template <class Real>
struct Vector3 {
  Real x = {};
  Real y = {};
  Real z = {};

  constexpr bool operator==(const Vector3&) const = default;
};
using Vec3 = Vector3<double>;

#define REPOSE_VEC3     \
  template <class Real> \
  [[gnu::always_inline]] constexpr

REPOSE_VEC3 Vector3<Real> operator+(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
REPOSE_VEC3 Vector3<Real> operator-(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
REPOSE_VEC3 Vector3<Real> operator-(const Vector3<Real>& a) { return {-a.x, -a.y, -a.z}; }
REPOSE_VEC3 Vector3<Real> operator*(const std::type_identity_t<Real>& s, const Vector3<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
REPOSE_VEC3 Vector3<Real> operator*(const Vector3<Real>& a, const std::type_identity_t<Real>& s) { return s * a; }
REPOSE_VEC3 Vector3<Real>& operator+=(Vector3<Real>& a, const Vector3<Real>& b) { return a = a + b; }
REPOSE_VEC3 Vector3<Real>& operator-=(Vector3<Real>& a, const Vector3<Real>& b) { return a = a - b; }
REPOSE_VEC3 Real dot(const Vector3<Real>& a, const Vector3<Real>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
REPOSE_VEC3 Vector3<Real> cross(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
REPOSE_VEC3 Real squared_norm(const Vector3<Real>& a) { return dot(a, a); }

#undef REPOSE_VEC3

/// A number as a Real, the same in every lane (exactly: minus zero stays minus zero).
template <class Real>
[[gnu::always_inline]] constexpr Real broadcast(double x) {
  return x - Real{};
}
template <class Real>
[[gnu::always_inline]] constexpr Vector3<Real> broadcast(const Vec3& v) {
  return {broadcast<Real>(v.x), broadcast<Real>(v.y), broadcast<Real>(v.z)};
}

// What contact laws need beyond arithmetic, by the same names for a double and for a Quad (quad.h).
[[gnu::always_inline]] inline double square_root(double x) { return std::sqrt(x); }
[[gnu::always_inline]] inline double magnitude(double x) { return std::fabs(x); }
[[gnu::always_inline]] inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

inline double norm(const Vec3& a) { return std::sqrt(squared_norm(a)); }

}  // namespace repose
