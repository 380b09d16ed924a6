#include "graze/mass.hpp"

#include "dynamics/body_mass.hpp"
#include "dynamics/inertia_check.hpp"

namespace graze {

namespace {

/// The inverse of a number > 0, zero for an infinite one. The path is put together only for an error.
template <class T>
T inverse(T value, const char* name, int index = -1) {
  const T inverted = T(1) / value;
  if (value > T(0) && std::isfinite(inverted)) return inverted;
  validate::fail(index < 0 ? name : std::string(name) + "[" + std::to_string(index) + "]",
                 "a number > 0 with a finite inverse", static_cast<double>(value));
}

/// The part of a tensor's largest element by which rounding may make two elements differ that are one: half of the
/// digits, since a tensor may have been turned and moved many times.
template <class T>
constexpr T rounding = sizeof(T) == sizeof(float) ? T(4e-4) : T(2e-8);

template <class T>
Mat3<T> turned(const Mat3<T>& tensor, const Quat<T>& rotation) {
  const Mat3<T> r = rotation_matrix(rotation);
  return r * tensor * transposed(r);
}

/// Whether a symmetric matrix is positive definite: its leading minors are positive (Sylvester's criterion).
template <class T>
bool is_positive_definite(const Mat3<T>& m) {
  return m.row[0].x > T(0) && cross(m.row[0], m.row[1]).z > T(0) && dot(m.row[0], cross(m.row[1], m.row[2])) > T(0);
}

/// The inverse of a positive definite matrix by its cofactors.
template <class T>
Mat3<T> inverse_of(const Mat3<T>& m) {
  const Vec3<T> x = cross(m.row[1], m.row[2]), y = cross(m.row[2], m.row[0]), z = cross(m.row[0], m.row[1]);
  const T volume = dot(m.row[0], x);
  return Mat3<T>::from_columns(x / volume, y / volume, z / volume);
}

/// Throws for a tensor, scaled by `scale` to a largest element of 1, that no body has: one that is not positive
/// definite, or of which a principal moment is larger than the sum of the others, which is more than half of the trace.
template <class T>
void check_tensor(const Mat3<T>& scaled, T scale) {
  if (!is_positive_definite(scaled))
    validate::fail("inertia", "a positive definite tensor", static_cast<double>(T(1) / scale));
  const T half_trace = (scaled.row[0].x + scaled.row[1].y + scaled.row[2].z) / T(2) + rounding<T>;
  if (is_positive_definite(Mat3<T>::diagonal({half_trace, half_trace, half_trace}) - scaled)) return;
  const Vec3<T> moments = principal_axes(scaled).diagonal;
  validate::fail("inertia", "a tensor of which no principal moment is larger than the sum of the others",
                 static_cast<double>(greatest(moments.x, greatest(moments.y, moments.z)) / scale));
}

}  // namespace

template <class T>
InverseMass<T> inverse_mass(T mass, const Vec3<T>& inertia, const Quat<T>& rotation) {
  InverseMass<T> inverted{inverse(mass, "mass"), {}};
  const Vec3<T> about{inverse(inertia.x, "inertia", 0), inverse(inertia.y, "inertia", 1),
                      inverse(inertia.z, "inertia", 2)};
  if (!inverted.movable()) return inverted;
  check_triangle_inequality(inertia, "inertia");
  inverted.inertia = turned(Mat3<T>::diagonal(about), rotation);
  return inverted;
}

template <class T>
InverseMass<T> inverse_mass(T mass, const Mat3<T>& inertia, const Quat<T>& rotation) {
  InverseMass<T> inverted{inverse(mass, "mass"), {}};
  if (!inverted.movable()) return inverted;
  T largest(0);
  for (const Vec3<T>& row : inertia.row) largest = greatest(largest, max_abs(row));
  const T scale = inverse(largest, "inertia");
  const Mat3<T> mirrored = transposed(inertia);
  for (int i = 0; i < 3; ++i)
    if (const T off = max_abs(inertia.row[i] - mirrored.row[i]); !(off <= rounding<T> * largest))
      validate::fail("inertia", "a symmetric tensor", static_cast<double>(off));
  const Mat3<T> scaled = inertia * scale;
  check_tensor(scaled, scale);
  inverted.inertia = turned(inverse_of(scaled) * scale, rotation);
  return inverted;
}

template <class T>
Mat3<T> inertia_of(const Shape<T>& shape, T mass) {
  const MassProperties<T> of = mass_properties(shape);
  if (!(of.volume > T(0)))
    validate::fail("shape", "a solid, of which the volume is > 0", static_cast<double>(of.volume));
  return of.inertia * (mass / of.volume);
}

template InverseMass<float> inverse_mass(float, const Vec3<float>&, const Quat<float>&);
template InverseMass<double> inverse_mass(double, const Vec3<double>&, const Quat<double>&);
template InverseMass<float> inverse_mass(float, const Mat3<float>&, const Quat<float>&);
template InverseMass<double> inverse_mass(double, const Mat3<double>&, const Quat<double>&);
template Mat3<float> inertia_of(const Shape<float>&, float);
template Mat3<double> inertia_of(const Shape<double>&, double);

}  // namespace graze
