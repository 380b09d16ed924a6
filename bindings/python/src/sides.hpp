// The two sides of a batch from Python, in space and in the plane, which differ in their `Words` (`SpaceBatch`,
// `PlaneBatch`).
//
// Guarantee: poses in an array of rows are read where they stand, everything is checked before the first pair is
// computed, and answers are found while other threads of Python run.
#pragma once

#include "convert.hpp"
#include "spare.hpp"
#include "threads.hpp"
#include "usual_poses.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace graze::python {

/// One side of a batch: shapes and poses, and the Python objects whose memory they stand in.
template <class Words>
class Side {
 public:
  using Shape = typename Words::Shape;
  using Shapes = typename Words::Shapes;
  using Pose = typename Words::Pose;
  using Bodies = typename Words::Bodies;

  Side(const py::object& shapes, const py::object& poses, const std::string& name) {
    read_shapes(shapes, name);
    read_poses(poses, "poses_" + name);
  }
  Bodies bodies() const { return shapes().template bodies<Bodies, Pose>(poses_); }

 private:
  const Shapes& shapes() const { return given_ != nullptr ? *given_ : own_shapes_; }
  void read_shapes(const py::object& shapes, const std::string& name) {
    given_ = Words::array_of_shapes(shapes);
    if (given_ != nullptr) {
      array_ = shapes;
      return;
    }
    std::vector<Shape> read;
    if (py::isinstance<Shape>(shapes))
      read.push_back(shapes.cast<const Shape&>());
    else
      for (const py::handle shape : shapes) {
        if (!py::isinstance<Shape>(shape))
          throw py::type_error(name + "[" + std::to_string(read.size()) + "]: expected a " + Words::shape_name);
        read.push_back(shape.cast<const Shape&>());
      }
    own_shapes_ = Shapes(std::move(read));
  }
  void read_poses(const py::object& poses, const std::string& name) {
    const py::ssize_t dimensions = py::isinstance<py::array>(poses) ? py::array(poses).ndim() : 0;
    if (dimensions == 2 && py::array(poses).shape(1) == Words::pose_size) {
      rows_ = rows(poses, Words::pose_size, name.c_str());
      poses_ = {reinterpret_cast<const Pose*>(rows_.data()), static_cast<std::size_t>(rows_.shape(0))};
      check_poses(name);
      return;
    }
    Pose one;
    if (dimensions != 3 && !py::isinstance<py::list>(poses) && read_pose(poses, one))
      own_poses_.push_back(one);
    else
      for (const py::handle pose : poses) add(pose, name + "[" + std::to_string(own_poses_.size()) + "]");
    poses_ = own_poses_;
  }
  /// Checks poses that are used as they are: some at a time quickly, and each by itself where that leaves doubts. Some
  /// are so few that rotations in single precision leave none.
  void check_poses(const std::string& name) const {
    constexpr std::size_t some = 64;
    for (std::size_t begin = 0; begin < poses_.size(); begin += some) {
      const std::size_t count = std::min(some, poses_.size() - begin);
      if (are_usual<Words::vector_size, Words::pose_size>(rows_.data() + begin * Words::pose_size, count)) continue;
      for (std::size_t i = begin; i < begin + count; ++i) Words::check(poses_[i], name, i);
    }
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
  const Shapes* given_ = nullptr;  ///< those of `array_`
  Shapes own_shapes_;
  std::vector<Pose> own_poses_;
  std::span<const Pose> poses_;
};

/// Cuts `count` items and calls `f(begin, end, chunk)` for each chunk, on threads if there are any, while other threads
/// of Python run. `make(chunks, size)` is called before, once these are known.
template <class Make, class F>
void cut(Threads* threads, std::size_t count, const Make& make, const F& f) {
  const py::gil_scoped_release free;
  if (threads == nullptr || count < 2) {
    make(std::size_t{1}, count);
    return f(std::size_t{0}, count, std::size_t{0});
  }
  // More chunks than threads, for some take longer, and few enough that each is worth its while.
  constexpr std::size_t chunks_a_thread = 8, largest = 4096;
  const std::size_t size = std::clamp<std::size_t>(count / (chunks_a_thread * threads->concurrency()), 1, largest);
  make((count + size - 1) / size, size);
  std::mutex mutex;
  std::exception_ptr thrown;  // the first: nothing may leave a thread but this way
  for_each_chunk(*threads, count, size, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    try {
      f(begin, end, chunk);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  });
  if (thrown) std::rethrow_exception(thrown);
}

/// One answer for each place, by `ask(place)`.
template <class Answer, class Ask>
std::vector<Answer> each_of(Threads* threads, std::size_t count, const Ask& ask) {
  auto found = spare_of<std::vector<Answer>>();
  found.resize(count);
  cut(
      threads, count, [](std::size_t, std::size_t) {},
      [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) found[i] = ask(i);
      });
  return found;
}

/// The two sides and the places of the pairs, and the threads that answer.
template <class Words>
class Question {
 public:
  using Batch = typename Words::Batch;

  Question(const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b,
           const py::object& pairs, const ThreadsArgument& threads)
      : a_(a, poses_a, "a"),
        b_(b, poses_b, "b"),
        pairs_(pairs.is_none() ? IndexRows() : index_rows(pairs, 2, "pairs")),
        batch_(pairs.is_none() ? Batch(a_.bodies(), b_.bodies()) : Batch(a_.bodies(), b_.bodies(), places())),
        threads_(threads.of_call()) {}

  const Batch& batch() const { return batch_; }

  /// The answers to all, found while other threads of Python run. `ask(batch, answers)` is asked about some of the
  /// pairs; `append(answers, part, begin)` puts the answers from the pair `begin` on behind those before them.
  template <class Answers, class Ask, class Append>
  Answers found(const Ask& ask, const Append& append) const {
    Answers answers = spare_of<Answers>();
    std::vector<Answers> parts;
    std::size_t each = 0;
    cut(
        threads_.get(), batch_.size(),
        [&](std::size_t chunks, std::size_t size) {
          parts.resize(chunks > 1 ? chunks : 0);
          each = size;
        },
        [&](std::size_t begin, std::size_t end, std::size_t chunk) {
          parts.empty() ? ask(batch_, answers) : ask(batch_.part(begin, end), parts[chunk]);
        });
    if (parts.empty()) return answers;
    const py::gil_scoped_release free;
    each_array(answers, [](auto& array) { array.clear(); });
    for (std::size_t chunk = 0; chunk < parts.size(); ++chunk) append(answers, parts[chunk], chunk * each);
    return answers;
  }
  /// One answer a pair, found while other threads of Python run. `ask(batch, answers)` as before.
  template <class Answer, class Ask>
  std::vector<Answer> found_rows(const Ask& ask) const {
    using Rows = std::vector<Answer>;
    return found<Rows>(ask, [](Rows& all, const Rows& part, std::size_t) { behind(all, part); });
  }
  /// One answer a pair, by `ask(place)` for each pair's place.
  template <class Answer, class Ask>
  std::vector<Answer> found_each(const Ask& ask) const {
    return each_of<Answer>(threads_.get(), batch_.size(), ask);
  }

 private:
  std::span<const IdPair> places() const {
    static_assert(sizeof(IdPair) == 2 * sizeof(std::uint32_t));
    return {reinterpret_cast<const IdPair*>(pairs_.data()), static_cast<std::size_t>(pairs_.shape(0))};
  }

  Side<Words> a_, b_;
  IndexRows pairs_;
  Batch batch_;
  std::shared_ptr<Threads> threads_;
};

}  // namespace graze::python
