// Blows and free motion of single bodies, in space and in the plane.
#include "motion_methods.hpp"
#include "plane_batch.hpp"
#include "space_batch.hpp"

namespace graze::python {

namespace {

/// The mass of a body in space: given by three moments or a matrix.
struct SpaceMotion : SpaceBatch {
  using VectorGiven = python::Vector;
  using TurningGiven = python::Vector;
  using InertiaGiven = python::Vector;
  using Body = StruckBody<double>;
  using Blow = graze::Blow<double>;
  using Free = FreeBody<double>;

  static constexpr const char* inertia_doc =
      "inertia: three moments about the axes of `pose`, or a 3x3 matrix in its frame, about the centre of mass";
  static constexpr const char* moments_doc =
      "inertia: the moments about the axes of `pose`, infinite where it does not turn";

  static const Vec3d& value_of(const python::Vector& v) { return v.value; }
  static py::array_t<double> object_of(const Vec3d& v) { return array_of(v); }
  static InverseMass<double> inverse(double mass, const py::object& inertia, const Posed& pose) {
    constexpr double never = std::numeric_limits<double>::infinity();
    Vec3d moments{never, never, never};
    if (inertia.is_none() || read_vector(inertia, moments)) return inverse_mass(mass, moments, pose.rotation);
    const Rows tensor = rows(inertia, 3, "inertia");
    if (tensor.shape(0) != 3) validate::fail("inertia", "three moments or a matrix of shape (3, 3)", "another shape");
    Mat3d matrix;
    for (std::size_t i = 0; i < 3; ++i) matrix.row[i] = vector_of(tensor.data(static_cast<py::ssize_t>(i), 0));
    return inverse_mass(mass, matrix, pose.rotation);
  }
  static InverseMass<double> inverse_of_shape(const Shaped& shape, double mass, const Posed& pose) {
    return std::isinf(mass) ? inverse(mass, py::none(), pose)
                            : inverse_mass(mass, inertia_of(shape, mass), pose.rotation);
  }
  static Free free_body(const Posed& pose, const Vec3d& inertia) {
    Vec3d inverse;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(inertia[i] > 0)) validate::fail("inertia[" + std::to_string(i) + "]", "a number > 0", inertia[i]);
      inverse[i] = 1 / inertia[i];
    }
    return {pose.translation, pose.rotation, {}, {}, inverse};
  }
};

/// The mass of a body in the plane: given by numbers.
struct PlaneMotion : PlaneBatch {
  using VectorGiven = Vector2;
  using TurningGiven = double;
  using InertiaGiven = double;
  using Body = plane::StruckBody<double>;
  using Blow = plane::Blow<double>;
  using Free = plane::FreeBody<double>;

  static constexpr const char* inertia_doc = "inertia: about the centre of mass";
  static constexpr const char* moments_doc = "inertia: about the centre of mass, infinite where it does not turn";

  static const plane::Vec2d& value_of(const Vector2& v) { return v.value; }
  static double value_of(double turning) { return turning; }
  static py::array_t<double> object_of(const plane::Vec2d& v) { return array_of(v); }
  static double object_of(double turning) { return turning; }
  static double inverse_of(double value, const char* path) {
    if (!(value > 0) || !std::isfinite(1 / value))
      validate::fail(path, "a number > 0 that can be inverted, or infinity", value);
    return 1 / value;
  }
  static plane::InverseMass<double> inverse(double mass, const py::object& inertia, const plane::Pose2d&) {
    return {inverse_of(mass, "mass"), inertia.is_none() ? 0 : inverse_of(number_from(inertia, "inertia"), "inertia")};
  }
  static plane::InverseMass<double> inverse_of_shape(const plane::Shaped& shape, double mass, const plane::Pose2d&) {
    if (std::isinf(mass)) return {};
    const plane::MassProperties<double> whole = mass_properties(shape);
    if (!(whole.area > 0)) validate::fail("shape", "a shape with an area", whole.area);
    return {inverse_of(mass, "mass"), inverse_of(mass * whole.inertia / whole.area, "mass")};
  }
  static Free free_body(const plane::Pose2d& pose, double inertia) {
    return {pose.translation, pose.rotation, {}, 0, inverse_of(inertia, "inertia")};
  }
};

const char* text_of(AtFault fault) {
  constexpr const char* words[] = {"neither", "a", "b", "both"};
  return words[static_cast<std::size_t>(fault)];
}

/// The quantities of a blow in the order in which they are computed.
py::dict object_of(const Response<double>& r, const StruckBody<double>& a, const StruckBody<double>& b) {
  py::dict out;
  out["approach"] = array_of(r.approach.whole);
  out["approach_along_normal"] = r.approach.normal;
  out["approach_tangential"] = array_of(r.approach.tangential);
  out["at_fault"] = text_of(r.at_fault);
  out["effective_mass"] = r.effective_mass;
  out["normal_impulse"] = r.normal_impulse;
  out["sliding"] = array_of(r.sliding);
  out["stopping_impulse"] = array_of(r.stopping_impulse);
  out["friction_limit"] = r.friction_limit;
  out["friction_impulse"] = array_of(r.friction_impulse);
  out["impulse"] = array_of(r.impulse);
  out["a"] = StruckBody<double>{r.a, a.mass};
  out["b"] = StruckBody<double>{r.b, b.mass};
  return out;
}

}  // namespace

void add_motion(py::module_& m) {
  MotionMethods<SpaceMotion>::add(m);
  m.def(
      "response",
      [](const StruckBody<double>& a, const StruckBody<double>& b, const Vector& point, const Vector& normal,
         double restitution, double friction) {
        const StruckContact<double> contact{validate::point(point.value, "point"),
                                            unit_vector<SpaceMotion>(normal.value, "normal"),
                                            coefficient(restitution, "restitution"), coefficient(friction, "friction")};
        return object_of(response(contact, a, b), a, b);
      },
      py::arg("a"), py::arg("b"), py::arg("point"), py::arg("normal"), py::arg("restitution") = 0.0,
      py::arg("friction") = 0.6,
      R"(What two bodies do when they meet at a point: a dictionary of all that a blow computes.

normal: unit, from a to b. approach, at_fault, effective_mass, normal_impulse, sliding, friction_impulse
and so on, `impulse` on b, and the bodies `a` and `b` after it.

>>> import graze
>>> ball = graze.StruckBody.of_shape(graze.Sphere(1), 2.0, (0, 0, 0), linear=(3, 0, 0))
>>> wall = graze.StruckBody(float("inf"))
>>> graze.response(ball, wall, (1, 0, 0), (1, 0, 0), restitution=0.5)["normal_impulse"]
9.0
)");
}

void add_plane_motion(py::module_& m) { MotionMethods<PlaneMotion>::add(m); }

}  // namespace graze::python
