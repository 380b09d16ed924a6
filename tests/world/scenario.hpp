// Worlds that live: what the tests of a world's threads and memory update and compare.
#pragma once

#include <algorithm>
#include <vector>

#include "common/specimen.hpp"
#include "graze/world.hpp"

namespace graze::testing {

template <class T>
Shape<T> random_shape(Random& random) {
  const auto kind = static_cast<Kind>(random() % kind_count);
  // A half-space touches nearly everything: one in fourteen would be the only thing tested.
  const bool rare = kind == Kind::half_space && random() % 8 != 0;
  return build<T>(random_specimen(rare ? Kind::box : kind, 1.0f, random));
}

template <class T>
Pose<T> random_pose(Random& random, float reach) {
  return {converted<T>(random_vector(random, reach)), converted<T>(random_rotation(random))};
}

template <class T>
Body<T> random_body(Random& random, float reach, bool any_fixed = true) {
  Body<T> body{random_shape<T>(random), random_pose<T>(random, reach)};
  body.fixed = random() % 5 == 0 && any_fixed;
  body.trigger = random() % 7 == 0;
  if (random() % 4 == 0) body.filter.category = 2;
  if (random() % 4 == 0) body.filter.mask = ~std::uint64_t{2};
  return body;
}

/// What is said of one update, in words that can be compared: every bit of it.
template <class T>
struct Snapshot {
  std::vector<ContactPair<T>> pairs;
  std::vector<ContactManifold<T>> manifolds;
  std::vector<SolverPoint<T>> points;
  std::vector<ContactEvent> events;

  static Snapshot of(const World<T>& world) {
    const auto& c = world.contacts();
    return {c.pairs, c.manifolds, c.points, {world.events().begin(), world.events().end()}};
  }
  friend bool operator==(const Snapshot& s, const Snapshot& t) {
    const auto same = [](const auto& v, const auto& w, const auto& equal) {
      return std::equal(v.begin(), v.end(), w.begin(), w.end(), equal);
    };
    return same(s.pairs, t.pairs,
                [](const auto& p, const auto& q) {
                  return p.a == q.a && p.b == q.b && p.overlap == q.overlap && p.first_manifold == q.first_manifold &&
                         p.manifold_count == q.manifold_count;
                }) &&
           same(s.manifolds, t.manifolds,
                [](const auto& m, const auto& n) {
                  return m.normal == n.normal && m.piece_a == n.piece_a && m.piece_b == n.piece_b &&
                         m.first_point == n.first_point && m.point_count == n.point_count;
                }) &&
           same(s.points, t.points,
                [](const auto& p, const auto& q) {
                  return p.a == q.a && p.b == q.b && p.distance == q.distance && p.feature == q.feature &&
                         p.impulse == q.impulse;
                }) &&
           same(s.events, t.events, [](const auto& e, const auto& f) {
             return e.kind == f.kind && e.a == f.a && e.b == f.b && e.pair == f.pair && e.trigger == f.trigger;
           });
  }
};

/// A world in which bodies come, move little, jump, change shape and go: the same for the same seed.
template <class T>
class Scenario {
 public:
  Scenario(std::uint64_t seed, std::size_t count, Executor* executor = nullptr, bool any_fixed = true)
      : random_(seed), world_({}, executor), any_fixed_(any_fixed) {
    for (std::size_t i = 0; i < count; ++i) ids_.push_back(world_.add(random_body<T>(random_, 3, any_fixed)));
  }

  void step(bool few) {
    for (BodyId& id : ids_) {
      if (few && random_() % 20 != 0) continue;
      const Body<T> body = world_.bodies().body(id);
      if (body.fixed && random_() % 10 != 0) continue;
      const auto nudge = converted<T>(random_vector(random_, 0.05f));
      switch (random_() % 40) {
      case 0:
        world_.remove(id);
        id = world_.add(random_body<T>(random_, 3, any_fixed_));
        break;
      case 1: world_.move(id, random_pose<T>(random_, 3)); break;
      case 2: world_.set_shape(id, random_shape<T>(random_)); break;
      case 3: world_.set_filter(id, random_body<T>(random_, 3).filter); break;
      default: world_.move(id, {body.pose.translation + nudge, body.pose.rotation}); break;
      }
    }
    world_.update();
  }

  World<T>& world() { return world_; }
  const std::vector<BodyId>& ids() const { return ids_; }

 private:
  Random random_;
  World<T> world_;
  std::vector<BodyId> ids_;
  bool any_fixed_;
};

}  // namespace graze::testing
