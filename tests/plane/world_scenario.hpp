// Worlds of the plane that live: what the tests of threads, memory and questions update and compare.
#pragma once

#include <vector>

#include "graze/plane/world.hpp"
#include "plane/figures.hpp"

namespace graze::plane {

/// Any shape there is, about as large as one; half-planes are rare, since they touch nearly everything.
template <class T>
Shape<T> random_shape(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random));
  };
  switch (random() % 13) {
  case 0: {
    const std::vector<Vec2<T>> l{
        {T(-1), T(-1)}, {T(1), T(-1)}, {T(1), uniform(-0.8, 0)}, {uniform(-0.6, 0.5), T(0)}, {T(-0.7), T(1)}};
    return Polygon<T>(l);
  }
  case 1: {
    std::vector<Vec2<T>> points;
    for (int i = -3; i <= 3; ++i) points.push_back({static_cast<T>(i) / T(2), uniform(-0.4, 0.4)});
    return Chain<T>(points, false, random() % 2 == 0 ? ChainSides::one : ChainSides::both);
  }
  case 2: {
    std::vector<Placed<T>> children;
    for (int i = 0; i < 3; ++i)
      children.push_back({random_figure<T>(static_cast<int>(random() % figure_kinds), 0.5, random).shape,
                          random_pose<T>(0.4, random)});
    return Compound<T>(children);
  }
  case 3:
    if (random() % 8 == 0) return HalfPlane<T>();
    [[fallthrough]];
  default: return random_figure<T>(static_cast<int>(random() % figure_kinds), 1, random).shape;
  }
}

template <class T>
Body<T> random_body(double reach, std::mt19937& random) {
  Body<T> body{random_shape<T>(random), random_pose<T>(reach / 2, random)};
  body.fixed = random() % 5 == 0;
  body.trigger = random() % 7 == 0;
  if (random() % 4 == 0) body.filter.category = 2;
  if (random() % 4 == 0) body.filter.mask = ~std::uint64_t{2};
  return body;
}

/// A world in which bodies come, move little, jump, change shape or filter and go: the same for the same seed.
template <class T>
class Scenario {
 public:
  Scenario(unsigned seed, std::size_t count, double reach, Executor* executor = nullptr, WorldSettings<T> settings = {})
      : random_(seed), reach_(reach), world_(std::move(settings), executor) {
    for (std::size_t i = 0; i < count; ++i) ids_.push_back(world_.add(random_body<T>(reach_, random_)));
  }

  void step(bool few) {
    for (BodyId& id : ids_) {
      if (few && random_() % 20 != 0) continue;
      const Body<T> body = world_.bodies().body(id);
      if (body.fixed && random_() % 10 != 0) continue;
      switch (random_() % 40) {
      case 0:
        world_.remove(id);
        id = world_.add(random_body<T>(reach_, random_));
        break;
      case 1: world_.move(id, random_pose<T>(reach_ / 2, random_)); break;
      case 2: world_.set_shape(id, random_shape<T>(random_)); break;
      case 3: world_.set_filter(id, random_body<T>(reach_, random_).filter); break;
      default: world_.move(id, {body.pose.translation + random_pose<T>(0.02, random_).translation, body.pose.rotation});
      }
    }
    world_.update();
  }

  World<T>& world() { return world_; }
  const std::vector<BodyId>& ids() const { return ids_; }

 private:
  std::mt19937 random_;
  double reach_;
  World<T> world_;
  std::vector<BodyId> ids_;
};

}  // namespace graze::plane
