// The types and functions of space with which `sides.hpp` and `row_batches.hpp` are written.
#pragma once

#include "answers.hpp"
#include "shapes.hpp"

namespace graze::python {

/// The words of space: vectors of three numbers, also for velocities of turning; rows of seven numbers for poses.
struct SpaceBatch {
  using Shape = Shaped;
  using Pose = Posed;
  using Placement = python::Placement;
  using Vector = Vec3d;
  using Turning = Vec3d;
  using Velocity = graze::Velocity<double>;
  using Bodies = graze::Bodies<double>;
  using Batch = graze::Batch<double>;
  using Ray = graze::Ray<double>;
  using RayHit = graze::RayHit<double>;
  using CastHit = graze::CastHit<double>;
  using Closest = graze::Closest<double>;
  using Distance = graze::Distance<double>;
  using PieceDistance = graze::PieceDistance<double>;
  static_assert(sizeof(Pose) == 7 * sizeof(double), "seven numbers a pose, as NumPy's rows have them");

  static constexpr py::ssize_t vector_size = 3, turning_size = 3, pose_size = 7;
  static constexpr bool back_faces = true;  ///< triangles have one
  static constexpr const char* vector_type = "(3,)f8";
  static constexpr const char* shape_name = "graze.Shape";
  static constexpr const char* vectors = "shape (n, 3), or three numbers";
  static constexpr const char* turnings = "shape (n, 3), or three numbers";

  using Shapes = ShapeArray;
  static const Shapes* array_of_shapes(const py::object& shapes) {
    return py::isinstance<Shapes>(shapes) ? &shapes.cast<const Shapes&>() : nullptr;
  }
  static Vector vector_of(const double* row) { return {row[0], row[1], row[2]}; }
  static Turning turning_of(const double* row) { return vector_of(row); }
  static void check(const Vector& v, const std::string& path) { validate::point(v, path); }
  /// Checks a pose of an array, which is used as it is: its quaternion has to be of unit length already.
  static void check(const Pose& p, const std::string& name, std::size_t i) {
    const Quatd& q = p.rotation;
    const double square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
    if (!validate::fault_of_coordinate(p.translation.x) && !validate::fault_of_coordinate(p.translation.y) &&
        !validate::fault_of_coordinate(p.translation.z) && std::abs(square - 1) <= unit_slack)
      return;
    const std::string path = name + "[" + std::to_string(i) + "]";
    validate::point(p.translation, path + ".translation");
    validate::fail(path + ".rotation", "a quaternion of unit length (within 1e-6)", std::sqrt(square));
  }
};

}  // namespace graze::python
