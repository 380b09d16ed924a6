#include "dynamics/body_mass.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "dynamics/inertia_check.hpp"
#include "graze/plane/mass.hpp"

namespace graze {

namespace {

/// Rounds of Jacobi's method: it converges quadratically, and five suffice in double.
constexpr int most_rounds = 12;

/// The quaternion of a rotation matrix, by its largest component (Shepperd 1978).
template <class T>
Quat<T> quaternion_of(const Mat3<T>& m) {
  const T x = m.row[0].x, y = m.row[1].y, z = m.row[2].z, one(1);
  const T squares[4] = {one + x - y - z, one - x + y - z, one - x - y + z, one + x + y + z};
  std::size_t largest = 3;
  for (std::size_t i = 0; i < 3; ++i)
    if (squares[i] > squares[largest]) largest = i;
  const T xy = m.row[0].y + m.row[1].x, yz = m.row[1].z + m.row[2].y, zx = m.row[2].x + m.row[0].z;
  const T wx = m.row[2].y - m.row[1].z, wy = m.row[0].z - m.row[2].x, wz = m.row[1].x - m.row[0].y;
  switch (largest) {
  case 0: return normalized(Quat<T>{squares[0], xy, zx, wx});
  case 1: return normalized(Quat<T>{xy, squares[1], yz, wy});
  case 2: return normalized(Quat<T>{zx, yz, squares[2], wz});
  default: return normalized(Quat<T>{wx, wy, wz, squares[3]});
  }
}

template <class T>
void check_positive(T value, const std::string& path) {
  if (!(value > T(0)) || !std::isfinite(T(1) / value))
    validate::fail(path, "a number > 0 with a finite inverse", static_cast<double>(value));
}

/// Throws where a shape and a density make no finite positive mass or inertia.
template <class T>
void check_finite_positive(T value, const char* path) {
  if (!(value > T(0)) || !std::isfinite(value) || !std::isfinite(T(1) / value))
    validate::fail(path, "a finite number > 0 with a finite inverse", static_cast<double>(value));
}

template <class T>
void check_not_negative(T value, const char* path) {
  if (!(value >= T(0)) || !std::isfinite(value))
    validate::fail(path, "a finite number >= 0", static_cast<double>(value));
}

template <class T>
void check_inertia(const Vec3<T>& inertia) {
  for (std::size_t i = 0; i < 3; ++i) check_positive(inertia[i], "inertia_diagonal[" + std::to_string(i) + "]");
  check_triangle_inequality(inertia, "inertia_diagonal");
}

/// Checks the numbers that both spaces have.
template <class Dynamics>
void check_numbers(const Dynamics& dynamics) {
  if (dynamics.mass) check_positive(*dynamics.mass, "mass");
  check_positive(dynamics.density, "density");
  if (!std::isfinite(dynamics.density))
    validate::fail("density", "a finite number", static_cast<double>(dynamics.density));
  if (const char* expectation = validate::fault_of_coordinate(dynamics.gravity_factor))
    validate::fail("gravity_factor", expectation, static_cast<double>(dynamics.gravity_factor));
  check_not_negative(dynamics.linear_damping, "linear_damping");
  check_not_negative(dynamics.angular_damping, "angular_damping");
}

template <class T>
void check(const Dynamics<T>& dynamics) {
  check_numbers(dynamics);
  if (dynamics.center_of_mass) validate::point(*dynamics.center_of_mass, "center_of_mass");
  if (dynamics.inertia_diagonal) check_inertia(*dynamics.inertia_diagonal);
}

}  // namespace

template <class T>
PrincipalAxes<T> principal_axes(const Mat3<T>& tensor) {
  Mat3<T> a = tensor, axes = Mat3<T>::identity();
  for (int round = 0; round < most_rounds; ++round) {
    bool turned = false;
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t q = p + 1; q < 3; ++q) {
        const T off = a.row[p][q];
        const T size = std::abs(a.row[p][p]) + std::abs(a.row[q][q]);
        if (!(std::abs(off) > std::numeric_limits<T>::epsilon() * size)) continue;
        turned = true;
        // The tangent of the angle that makes the element zero, the smaller of two (Golub, Van Loan, section 8.5).
        const T tau = (a.row[q][q] - a.row[p][p]) / (T(2) * off);
        const T root = std::sqrt(T(1) + tau * tau);
        const T t = tau < T(0) ? T(1) / (tau - root) : T(1) / (tau + root);
        const T c = T(1) / std::sqrt(T(1) + t * t), s = t * c;
        Mat3<T> turn = Mat3<T>::identity();
        turn.row[p][p] = turn.row[q][q] = c;
        turn.row[p][q] = s;
        turn.row[q][p] = -s;
        a = transposed(turn) * a * turn;
        axes = axes * turn;
      }
    if (!turned) break;
  }
  return {{a.row[0].x, a.row[1].y, a.row[2].z}, quaternion_of(axes)};
}

template <class T>
BodyMass<T, Space<T>> body_mass(const Shape<T>& shape, const Dynamics<T>& dynamics, bool movable) {
  check(dynamics);
  const Quat<T> given = validate::rotation(dynamics.inertia_orientation, "inertia_orientation");
  const MassProperties<T> of = mass_properties(shape);
  const bool solid = of.volume > T(0);
  BodyMass<T, Space<T>> body;
  body.mass = std::numeric_limits<T>::infinity();
  body.principal.translation = dynamics.center_of_mass.value_or(of.center);
  if (!movable) return body;
  if (!solid && !(dynamics.mass && dynamics.inertia_diagonal))
    validate::fail("shape", "a solid, or a mass and an inertia", shape.name());
  const T mass = dynamics.mass ? *dynamics.mass : of.volume * dynamics.density;
  if (!dynamics.mass) check_finite_positive(mass, "mass of the shape");
  body.mass = mass;
  body.inverse_mass = T(1) / mass;
  if (dynamics.inertia_diagonal) {
    body.principal.rotation = given;
    body.inertia = *dynamics.inertia_diagonal;
  } else if (std::isfinite(mass)) {
    const PrincipalAxes<T> axes = principal_axes(of.inertia * (mass / of.volume));
    body.principal.rotation = axes.rotation;
    body.inertia = axes.diagonal;
    for (std::size_t i = 0; i < 3; ++i) check_finite_positive(body.inertia[i], "inertia of the shape");
  }
  if (body.inverse_mass == T(0)) return body;
  for (std::size_t i = 0; i < 3; ++i) body.inverse_inertia[i] = T(1) / body.inertia[i];
  return body;
}

template <class T>
BodyMass<T, plane::Space<T>> body_mass(const plane::Shape<T>& shape, const plane::Dynamics<T>& dynamics, bool movable) {
  check_numbers(dynamics);
  if (dynamics.center_of_mass) plane::detail::checked_point(*dynamics.center_of_mass, "center_of_mass");
  if (dynamics.inertia) check_positive(*dynamics.inertia, "inertia");
  const plane::MassProperties<T> of = plane::mass_properties(shape);
  const bool solid = of.area > T(0);
  BodyMass<T, plane::Space<T>> body;
  body.mass = std::numeric_limits<T>::infinity();
  body.principal.translation = dynamics.center_of_mass.value_or(of.center);
  if (!movable) return body;
  if (!solid && !(dynamics.mass && dynamics.inertia))
    validate::fail("shape", "a shape with an area, or a mass and an inertia", shape.name());
  const T mass = dynamics.mass ? *dynamics.mass : of.area * dynamics.density;
  if (!dynamics.mass) check_finite_positive(mass, "mass of the shape");
  body.mass = mass;
  body.inverse_mass = T(1) / mass;
  if (dynamics.inertia) {
    body.inertia = *dynamics.inertia;
  } else if (std::isfinite(mass)) {
    body.inertia = of.inertia * (mass / of.area);
    check_finite_positive(body.inertia, "inertia of the shape");
  }
  if (body.inverse_mass != T(0)) body.inverse_inertia = T(1) / body.inertia;
  return body;
}

#define GRAZE_BODY_MASS(T)                                                                                             \
  template BodyMass<T, Space<T>> body_mass(const Shape<T>&, const Dynamics<T>&, bool);                                 \
  template BodyMass<T, plane::Space<T>> body_mass(const plane::Shape<T>&, const plane::Dynamics<T>&, bool);            \
  template PrincipalAxes<T> principal_axes(const Mat3<T>&);
GRAZE_BODY_MASS(float)
GRAZE_BODY_MASS(double)
#undef GRAZE_BODY_MASS

}  // namespace graze
