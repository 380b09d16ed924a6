// The two sides of a batch from Python, in space and in the plane, which differ in their `Words` (`SpaceBatch`,
// `PlaneBatch`).
//
// Guarantee: poses in an array of rows are read where they stand, everything is checked before the first pair is
// computed, and answers are found while other threads of Python run.
#pragma once

#include "convert.hpp"

#include <optional>
#include <span>
#include <string>

namespace graze::python {

/// One side of a batch: shapes and poses, and the Python objects whose memory they stand in.
template <class Words>
class Side {
 public:
  using Shape = typename Words::Shape;
  using Pose = typename Words::Pose;

  Side(const py::object& shapes, const py::object& poses, const std::string& name) {
    read_shapes(shapes, name);
    read_poses(poses, "poses_" + name);
  }
  typename Words::Bodies bodies() const { return {shapes_, poses_}; }

 private:
  void read_shapes(const py::object& shapes, const std::string& name) {
    if (const auto* made = Words::array_of_shapes(shapes)) {
      array_ = shapes;
      shapes_ = *made;
      return;
    }
    if (py::isinstance<Shape>(shapes))
      own_shapes_.push_back(shapes.cast<const Shape&>());
    else
      for (const py::handle shape : shapes) {
        if (!py::isinstance<Shape>(shape))
          throw py::type_error(name + "[" + std::to_string(own_shapes_.size()) + "]: expected a " + Words::shape_name);
        own_shapes_.push_back(shape.cast<const Shape&>());
      }
    shapes_ = own_shapes_;
  }
  void read_poses(const py::object& poses, const std::string& name) {
    const py::ssize_t dimensions = py::isinstance<py::array>(poses) ? py::array(poses).ndim() : 0;
    if (dimensions == 2 && py::array(poses).shape(1) == Words::pose_size) {
      rows_ = rows(poses, Words::pose_size, name.c_str());
      poses_ = {reinterpret_cast<const Pose*>(rows_.data()), static_cast<std::size_t>(rows_.shape(0))};
      for (std::size_t i = 0; i < poses_.size(); ++i) Words::check(poses_[i], name, i);
      return;
    }
    Pose one;
    if (dimensions != 3 && !py::isinstance<py::list>(poses) && read_pose(poses, one))
      own_poses_.push_back(one);
    else
      for (const py::handle pose : poses) add(pose, name + "[" + std::to_string(own_poses_.size()) + "]");
    poses_ = own_poses_;
  }
  void add(py::handle pose, const std::string& path) {
    Pose read;
    try {
      if (!read_pose(pose, read)) throw py::type_error(path + ": expected a pose");
    } catch (const InvalidValue& error) {
      throw error.below(path);
    }
    own_poses_.push_back(read);
  }

  py::object array_;
  Rows rows_;
  std::vector<Shape> own_shapes_;
  std::vector<Pose> own_poses_;
  std::span<const Shape> shapes_;
  std::span<const Pose> poses_;
};

/// The two sides and the places of the pairs.
template <class Words>
class Question {
 public:
  Question(const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b,
           const py::object& pairs)
      : a_(a, poses_a, "a"),
        b_(b, poses_b, "b"),
        pairs_(pairs.is_none() ? IndexRows() : index_rows(pairs, 2, "pairs")),
        batch_(pairs.is_none() ? Batch(a_.bodies(), b_.bodies()) : Batch(a_.bodies(), b_.bodies(), places())) {}

  const typename Words::Batch& batch() const { return batch_; }
  /// The answers to all, found while other threads of Python run.
  template <class Answers, class F>
  Answers found(F&& ask) const {
    const py::gil_scoped_release free;
    Answers answers;
    ask(batch_, answers);
    return answers;
  }

 private:
  using Batch = typename Words::Batch;
  std::span<const IdPair> places() const {
    static_assert(sizeof(IdPair) == 2 * sizeof(std::uint32_t));
    return {reinterpret_cast<const IdPair*>(pairs_.data()), static_cast<std::size_t>(pairs_.shape(0))};
  }

  Side<Words> a_, b_;
  IndexRows pairs_;
  Batch batch_;
};

}  // namespace graze::python
