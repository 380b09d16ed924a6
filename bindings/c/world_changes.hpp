// The changes of a world of C's, captured or not.
//
// Its functions are virtual, so that a program without captured worlds links nothing of captures: a module of
// WebAssembly is smaller by that. One call of the C interface is one virtual call.
#pragma once

#include <memory>

#include "graze/capture.hpp"

namespace graze::c {

template <class T, class Space>
void check_body(const World<T, Space>& world, BodyId id) {
  if (!world.bodies().contains(id)) refuse_missing("id", "a body of the world", id);
}

template <class T, class Space>
class WorldChanges {
 public:
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Shape = typename Space::Shape;

  virtual ~WorldChanges() = default;
  virtual BodyId add(Body<T, Space> body) = 0;
  virtual void remove(BodyId id) = 0;
  virtual void move(BodyId id, const Pose& pose) = 0;
  virtual void move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular) = 0;
  virtual void set_shape(BodyId id, Shape shape) = 0;
  virtual void set_filter(BodyId id, const Filter& filter) = 0;
  virtual void set_fast(BodyId id, bool fast) = 0;
  /// Sets a name, which is kept in a capture alone.
  virtual void set_name(BodyId id, const char* name) = 0;
  virtual void update(T duration) = 0;
  virtual void find_impacts(T duration) = 0;

  /// The world for all queries.
  virtual const World<T, Space>& world() const = 0;
  /// The world itself, to be changed in ways that no capture holds; null for a captured one.
  virtual World<T, Space>* uncaptured() = 0;
};

/// The changes of `Inner`, a `World` or a `CapturedWorld`.
template <class Inner, class T, class Space>
class WorldChangesOf final : public WorldChanges<T, Space> {
  using Base = WorldChanges<T, Space>;

 public:
  template <class... Arguments>
  explicit WorldChangesOf(Arguments&&... arguments) : inner_(std::forward<Arguments>(arguments)...) {}

  BodyId add(Body<T, Space> body) override { return inner_.add(std::move(body)); }
  void remove(BodyId id) override { inner_.remove(id); }
  void move(BodyId id, const typename Base::Pose& pose) override { inner_.move(id, pose); }
  void move(BodyId id, const typename Base::Pose& pose, const typename Base::Vec& linear,
            const typename Base::Turning& angular) override {
    inner_.move(id, pose, linear, angular);
  }
  void set_shape(BodyId id, typename Base::Shape shape) override { inner_.set_shape(id, std::move(shape)); }
  void set_filter(BodyId id, const Filter& filter) override { inner_.set_filter(id, filter); }
  void set_fast(BodyId id, bool fast) override { inner_.set_fast(id, fast); }
  void set_name(BodyId id, const char* name) override {
    if constexpr (captured)
      inner_.set_name(id, name);
    else
      check_body(inner_, id);
  }
  void update(T duration) override { inner_.update(duration); }
  void find_impacts(T duration) override { inner_.find_impacts(duration); }
  const World<T, Space>& world() const override {
    if constexpr (captured)
      return inner_.world();
    else
      return inner_;
  }
  World<T, Space>* uncaptured() override {
    if constexpr (captured)
      return nullptr;
    else
      return &inner_;
  }

 private:
  static constexpr bool captured = std::is_same_v<Inner, CapturedWorld<T, Space>>;
  Inner inner_;
};

}  // namespace graze::c
