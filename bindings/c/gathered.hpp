// Many pairs as C describes them, handed to the C++ batches a chunk at a time.
//
// Guarantee: everything is checked before the first pair is computed. Poses that stand one behind the other are read
// where they are; all others are gathered for a chunk of pairs, which stays in the cache.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "c/arguments.hpp"
#include "graze/broad_phase.hpp"
#include "graze/executor.hpp"

namespace graze::c {

inline constexpr std::size_t chunk_size = 1024;

/// Elements that are gathered at a time for an executor, or none: enough for its threads to share.
inline std::size_t chunk_for(const Executor* executor) {
  constexpr std::size_t for_each_thread = 8192, most_threads = 1024;
  return executor ? for_each_thread * std::min(executor->concurrency(), most_threads) : chunk_size;
}

/// One side of a batch. `Space` names the types of a dimension and scalar.
template <class Space>
class Side {
 public:
  using Shape = typename Space::Shape;
  using Pose = typename Space::Pose;

  Side(const typename Space::CBodies& bodies, const std::string& path) : bodies_(bodies) {
    array(bodies.shapes, bodies.shape_count, (path + ".shapes").c_str());
    array(bodies.translations, bodies.pose_count, (path + ".translations").c_str());
    size_ = bodies.shape_count == 1 ? bodies.pose_count : bodies.shape_count;
    if (bodies.pose_count != size_ && bodies.pose_count != 1)
      validate::fail(path + ".pose_count", "as many as shapes, or one", static_cast<double>(bodies.pose_count));
    if (bodies.shape_count == 0 && bodies.pose_count != 0)
      validate::fail(path + ".shape_count", "one for the poses", 0);
    for (std::size_t i = 0; i < bodies.shape_count; ++i) {
      const auto* shape = element(bodies.shapes, bodies.shape_stride, i);
      if (shape == nullptr || shape->tag != std::decay_t<decltype(*shape)>::own_tag)
        opened(shape, at((path + ".shapes").c_str(), i).c_str());
    }
    for (std::size_t i = 0; i < bodies.pose_count; ++i)
      if (const Pose p = pose(i); !good(p)) refuse(p, at((path + ".poses").c_str(), i));
  }

  std::size_t size() const { return size_; }

  /// The bodies from `begin` to `end`, or the single one.
  typename Space::Bodies gathered(std::size_t begin, std::size_t end) {
    if (size_ == 1) begin = 0, end = 1;
    const auto [first_shape, last_shape] = range(bodies_.shape_count, begin, end);
    if (bodies_.shape_count != 1 || shapes_.empty()) {
      shapes_.clear();
      shapes_.reserve(last_shape - first_shape);
      for (std::size_t i = first_shape; i < last_shape; ++i)
        shapes_.push_back(Space::lent(element(bodies_.shapes, bodies_.shape_stride, i)->value));
    }
    const auto [first_pose, last_pose] = range(bodies_.pose_count, begin, end);
    return {std::span<const Shape>(shapes_), poses(first_pose, last_pose)};
  }

 private:
  struct Range {
    std::size_t first, last;
  };
  static Range range(std::size_t count, std::size_t begin, std::size_t end) {
    return count == 1 ? Range{0, 1} : Range{begin, end};
  }

  Pose pose(std::size_t i) const {
    Pose p;
    p.translation = same_bytes<decltype(p.translation)>(element(bodies_.translations, bodies_.translation_stride, i));
    if (bodies_.rotations != nullptr)
      p.rotation = same_bytes<decltype(p.rotation)>(element(bodies_.rotations, bodies_.rotation_stride, i));
    return p;
  }
  std::span<const Pose> poses(std::size_t first, std::size_t last) {
    const auto translations = reinterpret_cast<std::uintptr_t>(bodies_.translations);
    const auto rotations = reinterpret_cast<std::uintptr_t>(bodies_.rotations);
    if (bodies_.translation_stride == sizeof(Pose) && bodies_.rotation_stride == sizeof(Pose) &&
        rotations == translations + offsetof(Pose, rotation) && translations % alignof(Pose) == 0)
      return {reinterpret_cast<const Pose*>(bodies_.translations) + first, last - first};
    poses_.clear();
    poses_.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) poses_.push_back(pose(i));
    return poses_;
  }

  typename Space::CBodies bodies_;
  std::size_t size_;
  std::vector<Shape> shapes_;
  std::vector<Pose> poses_;
};

/// The pairs of a batch.
template <class Space>
class Pairs {
 public:
  explicit Pairs(const typename Space::CBatch& batch) : batch_(batch), a_(batch.a, "batch.a"), b_(batch.b, "batch.b") {
    array(batch.places, batch.place_count, "batch.places");
    if (batch.places == nullptr) {
      size_ = a_.size() == 1 ? b_.size() : a_.size();
      if (b_.size() != size_ && b_.size() != 1)
        validate::fail("batch.b", "as many bodies as batch.a, or one", static_cast<double>(b_.size()));
      if (a_.size() == 0 || b_.size() == 0) size_ = 0;
      return;
    }
    size_ = batch.place_count;
    for (std::size_t i = 0; i < size_; ++i) {
      const GrazeIdPair place = element(batch.places, batch.place_stride, i);
      if (place.a >= a_.size()) validate::fail(at("batch.places", i) + ".a", "a place in batch.a", double(place.a));
      if (place.b >= b_.size()) validate::fail(at("batch.places", i) + ".b", "a place in batch.b", double(place.b));
    }
  }

  std::size_t size() const { return size_; }

  /// Calls `f(batch, first)` for pieces of at most `chunk` pairs, in order.
  template <class F>
  void in_chunks(std::size_t chunk, const F& f) {
    if (batch_.places == nullptr) {
      for (std::size_t begin = 0; begin < size_; begin += chunk) {
        const std::size_t end = begin + std::min(chunk, size_ - begin);
        f(typename Space::Batch(a_.gathered(begin, end), b_.gathered(begin, end)), begin);
      }
      return;
    }
    const auto a = a_.gathered(0, a_.size());
    const auto b = b_.gathered(0, b_.size());
    std::vector<IdPair> places;
    for (std::size_t begin = 0; begin < size_; begin += chunk) {
      const std::size_t end = begin + std::min(chunk, size_ - begin);
      places.clear();
      for (std::size_t i = begin; i < end; ++i)
        places.push_back(same_bytes<IdPair>(element(batch_.places, batch_.place_stride, i)));
      f(typename Space::Batch(a, b, places), begin);
    }
  }

 private:
  typename Space::CBatch batch_;
  Side<Space> a_, b_;
  std::size_t size_ = 0;
};

}  // namespace graze::c
