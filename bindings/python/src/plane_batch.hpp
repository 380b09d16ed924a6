// The types and functions of the plane with which `sides.hpp` and `row_batches.hpp` are written.
#pragma once

#include "graze/plane/proximity.hpp"
#include "plane_convert.hpp"
#include "shape_array.hpp"

namespace graze::python {

/// The words of the plane: vectors of two numbers, a number for a velocity of turning; rows of four numbers for poses.
struct PlaneBatch {
  using Shape = plane::Shaped;
  using Pose = plane::Pose2d;
  using Placement = Placement2;
  using Vector = plane::Vec2d;
  using Turning = double;
  using Velocity = plane::Velocity<double>;
  using Bodies = plane::Bodies<double>;
  using Batch = plane::Batch<double>;
  using Ray = plane::Ray<double>;
  using RayHit = plane::RayHit<double>;
  using CastHit = plane::CastHit<double>;
  using Closest = plane::Closest<double>;
  using Distance = plane::Distance<double>;
  using PieceDistance = plane::PieceDistance<double>;
  static_assert(sizeof(Pose) == 4 * sizeof(double), "four numbers a pose, as NumPy's rows have them");

  static constexpr py::ssize_t vector_size = 2, turning_size = 1, pose_size = 4;
  static constexpr bool back_faces = false;  ///< nothing in the plane has a back
  static constexpr const char* vector_type = "(2,)f8";
  static constexpr const char* shape_name = "graze.plane.Shape";
  static constexpr const char* vectors = "shape (n, 2), or two numbers";
  static constexpr const char* turnings = "shape (n,), or one number (counter-clockwise)";

  using Shapes =
      ShapesOf<Shape, plane::Circle<double>, plane::Capsule<double>, plane::Box<double>, plane::HalfPlane<double>>;
  static const Shapes* array_of_shapes(const py::object&) { return nullptr; }
  static Vector vector_of(const double* row) { return {row[0], row[1]}; }
  static Turning turning_of(const double* row) { return *row; }
  static void check(const Vector& v, const std::string& path) {
    static_cast<void>(plane::detail::checked_point(v, path));
  }
  static void check(double turning, const std::string& path) {
    if (const char* expectation = validate::fault_of_coordinate(turning)) validate::fail(path, expectation, turning);
  }
  /// Checks a pose of an array, which is used as it is: its rotation has to be of unit length already.
  static void check(const Pose& p, const std::string& name, std::size_t i) {
    const double square = p.rotation.cosine * p.rotation.cosine + p.rotation.sine * p.rotation.sine;
    if (!validate::fault_of_coordinate(p.translation.x) && !validate::fault_of_coordinate(p.translation.y) &&
        std::abs(square - 1) <= unit_slack)
      return;
    const std::string path = name + "[" + std::to_string(i) + "]";
    check(p.translation, path + ".translation");
    validate::fail(path + ".rotation", "a cosine and a sine of unit length (within 1e-6)", std::sqrt(square));
  }
};

}  // namespace graze::python
