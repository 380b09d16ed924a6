// Questions to a world of the plane, and its impacts, against asking every body.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

#include "common/executors.hpp"
#include "plane/world_scenario.hpp"

namespace graze::plane {
namespace {

/// Bodies of all kinds, some of them triggers and in other categories, some moved and removed after an update.
template <class T>
void fill(World<T>& world, std::mt19937& random) {
  std::vector<BodyId> ids;
  for (int i = 0; i < 150; ++i) ids.push_back(world.add(random_body<T>(14, random)));
  world.add({HalfPlane<T>(), {{T(0), T(-12)}, {}}});
  world.update();
  for (int i = 0; i < 40; ++i) {
    const std::size_t at = random() % ids.size();
    if (!world.bodies().contains(ids[at])) continue;
    if (i % 2 == 0)
      world.move(ids[at], random_pose<T>(7, random));
    else
      world.remove(ids[at]);
  }
  world.add({random_shape<T>(random), random_pose<T>(7, random)});
}

template <class T>
std::vector<BodyId> asked(const World<T>& world, const QueryFilter& filter) {
  std::vector<BodyId> all;
  for (std::uint32_t i = 0; i < world.bodies().size(); ++i) {
    if (world.bodies().alive()[i] == 0) continue;
    const BodyId id = world.bodies().id(i);
    const Body<T> body = world.bodies().body(id);
    if ((filter.triggers || !body.trigger) && may_collide(filter.filter, body.filter) &&
        (!filter.accept || filter.accept(id)))
      all.push_back(id);
  }
  return all;
}

std::vector<QueryFilter> filters() {
  QueryFilter all, category, odd;
  all.triggers = true;
  category.filter.mask = 2;
  odd.accept = [](BodyId id) { return id.index % 2 == 1; };
  return {{}, all, category, odd};
}

template <class T>
class PlaneWorldQueries : public ::testing::Test {
 protected:
  PlaneWorldQueries() { fill(world, random); }

  Vec2<T> vector(double reach) { return random_pose<T>(reach / 2, random).translation; }

  std::mt19937 random{4};
  World<T> world;
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneWorldQueries, Scalars);

TYPED_TEST(PlaneWorldQueries, OverlappingAndNearest) {
  using T = TypeParam;
  std::size_t touched = 0;
  for (int i = 0; i < 60; ++i) {
    const Shape<T> shape = i % 3 == 0 ? Shape<T>(Circle<T>(T(0))) : random_shape<T>(this->random);
    const Pose2<T> pose = random_pose<T>(7, this->random);
    for (const QueryFilter& filter : filters()) {
      std::vector<BodyId> touching;
      std::vector<BodyDistance<T>> all;
      for (const BodyId id : asked(this->world, filter)) {
        const Body<T> body = this->world.bodies().body(id);
        if (overlap(shape, pose, body.shape, body.pose)) touching.push_back(id);
        all.push_back({id, distance(shape, pose, body.shape, body.pose)});
        if (all.back().distance.status == Status::unbounded)
          all.back().distance.distance = -std::numeric_limits<T>::infinity();
      }
      std::sort(all.begin(), all.end(), [](const auto& p, const auto& q) {
        return p.distance.distance != q.distance.distance ? p.distance.distance < q.distance.distance : p.body < q.body;
      });
      touched += touching.size();

      std::vector<BodyId> found;
      this->world.overlapping(shape, pose, filter, found);
      EXPECT_EQ(found, touching);
      EXPECT_EQ(this->world.overlaps_any(shape, pose, filter), !touching.empty());

      for (const std::size_t count : {1u, 5u, 1000u})
        for (const T limit : {T(0.5), std::numeric_limits<T>::infinity()}) {
          std::vector<BodyDistance<T>> near;
          this->world.nearest(shape, pose, count, limit, filter, near);
          const auto end =
              std::find_if(all.begin(), all.end(), [&](const auto& d) { return d.distance.distance > limit; });
          const std::size_t expected = std::min<std::size_t>(count, static_cast<std::size_t>(end - all.begin()));
          ASSERT_EQ(near.size(), expected);
          for (std::size_t k = 0; k < expected; ++k) {
            EXPECT_EQ(near[k].body, all[k].body);
            EXPECT_EQ(near[k].distance.distance, all[k].distance.distance);
          }
        }
      const auto first = this->world.closest(shape, pose, std::numeric_limits<T>::infinity(), filter);
      ASSERT_EQ(first.has_value(), !all.empty());
      EXPECT_EQ(first->body, all.front().body);
    }
  }
  EXPECT_GT(touched, 80u);
}

TYPED_TEST(PlaneWorldQueries, Rays) {
  using T = TypeParam;
  std::size_t hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray<T> ray{this->vector(16), this->vector(1)};
    const T length = i % 2 == 0 ? std::numeric_limits<T>::infinity() : T(5);
    for (const QueryFilter& filter : filters()) {
      std::vector<BodyRayHit<T>> all, found;
      for (const BodyId id : asked(this->world, filter)) {
        const Body<T> body = this->world.bodies().body(id);
        if (const auto hit = raycast(body.shape, body.pose, ray, length)) all.push_back({id, *hit});
      }
      std::stable_sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.hit.t < q.hit.t; });
      this->world.raycast_all(ray, length, filter, found);
      ASSERT_EQ(found.size(), all.size());
      for (std::size_t k = 0; k < all.size(); ++k) {
        EXPECT_EQ(found[k].body, all[k].body);
        EXPECT_EQ(found[k].hit.t, all[k].hit.t);
      }
      const auto first = this->world.raycast(ray, length, filter);
      ASSERT_EQ(first.has_value(), !all.empty());
      EXPECT_EQ(this->world.raycast_any(ray, length, filter), !all.empty());
      EXPECT_TRUE(!first || first->body == all.front().body);
      hits += all.size();
    }
  }
  EXPECT_GT(hits, 200u);
}

TYPED_TEST(PlaneWorldQueries, Casts) {
  using T = TypeParam;
  for (const Separating separating : {Separating::hit, Separating::ignored}) {
    std::size_t hits = 0;
    for (int i = 0; i < 60; ++i) {
      const Shape<T> shape = random_figure<T>(i % figure_kinds, 0.5, this->random).shape;
      const Pose2<T> pose = random_pose<T>(8, this->random);
      Velocity<T> velocity{this->vector(12), T(0)};
      if (i % 3 == 0) velocity.angular = this->vector(6).x;
      QueryFilter filter;
      filter.accept = [&](BodyId id) {  // a half-plane and what turns
        return i % 3 != 0 || !this->world.bodies().body(id).shape.template as<HalfPlane<T>>();
      };
      std::vector<BodyCastHit<T>> all, found;
      for (const BodyId id : asked(this->world, filter)) {
        const Body<T> body = this->world.bodies().body(id);
        if (const auto hit = cast<T>(shape, pose, velocity, body.shape, body.pose, {}, T(1.5), {separating}))
          all.push_back({id, *hit});
      }
      std::stable_sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.hit.t < q.hit.t; });
      this->world.cast_all(shape, pose, velocity, T(1.5), filter, found, {separating});
      ASSERT_EQ(found.size(), all.size());
      for (std::size_t k = 0; k < all.size(); ++k) {
        EXPECT_EQ(found[k].body, all[k].body);
        EXPECT_EQ(found[k].hit.t, all[k].hit.t);
      }
      const auto first = this->world.cast(shape, pose, velocity, T(1.5), filter, {separating});
      ASSERT_EQ(first.has_value(), !all.empty());
      EXPECT_TRUE(!first || first->hit.t == all.front().hit.t);
      hits += all.size();
    }
    EXPECT_GT(hits, 30u);
  }
}

/// The first question after a change brings the tree up to date, whichever thread asks it.
TYPED_TEST(PlaneWorldQueries, FromSeveralThreads) {
  using T = TypeParam;
  const Shape<T> disc(Circle<T>(T(4)));
  std::vector<std::vector<BodyId>> found(4);
  std::vector<std::thread> threads;
  for (auto& of_thread : found) threads.emplace_back([&] { this->world.overlapping(disc, {}, {}, of_thread); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(found[0].empty());
  for (const auto& of_thread : found) EXPECT_EQ(of_thread, found[0]);
}

template <class T>
class PlaneImpacts : public ::testing::Test {};
TYPED_TEST_SUITE(PlaneImpacts, Scalars);

TYPED_TEST(PlaneImpacts, AsEveryPairAskedByItself) {
  using T = TypeParam;
  std::mt19937 random(7);
  std::size_t met = 0;
  graze::testing::ThreadExecutor executor(3);
  for (int frame = 0; frame < 6; ++frame) {
    World<T> world({}, &executor);
    for (int i = 0; i < 120; ++i) {
      Body<T> body = random_body<T>(40, random);
      body.linear = random_pose<T>(frame % 2 == 0 ? 20 : 4, random).translation;
      if (random() % 2 == 0 && !body.shape.template as<HalfPlane<T>>())
        body.angular = random_pose<T>(4, random).translation.x;
      body.fast = random() % 3 == 0;
      if (body.fixed) body.linear = {}, body.angular = T(0);
      world.add(body);
    }
    const T duration = T(0.1);
    world.update(duration);
    std::map<std::pair<std::uint32_t, std::uint32_t>, T> found;
    T last(0);
    for (const Impact<T>& impact : world.impacts()) {
      EXPECT_LT(impact.a.index, impact.b.index);
      EXPECT_GE(impact.hit.t, last);
      last = impact.hit.t;
      EXPECT_TRUE(found.insert({{impact.a.index, impact.b.index}, impact.hit.t}).second);
    }
    const BodyArrays<T>& bodies = world.bodies();
    std::size_t expected = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
      for (std::uint32_t j = i + 1; j < bodies.size(); ++j) {
        if (bodies.fast()[i] == 0 && bodies.fast()[j] == 0) continue;
        if (bodies.fixed()[i] != 0 && bodies.fixed()[j] != 0) continue;
        if (!may_collide(bodies.filters()[i], bodies.filters()[j])) continue;
        const Body<T> a = bodies.body(bodies.id(i)), b = bodies.body(bodies.id(j));
        const auto hit = cast<T>(a.shape, a.pose, {a.linear, a.angular}, b.shape, b.pose, {b.linear, b.angular},
                                 duration, {Separating::ignored});
        expected += hit.has_value();
        const auto at = found.find({i, j});
        ASSERT_EQ(hit.has_value(), at != found.end()) << i << ' ' << j;
        EXPECT_TRUE(!hit || hit->t == at->second);
      }
    EXPECT_EQ(found.size(), expected);
    met += expected;
    world.update();
    EXPECT_TRUE(world.impacts().empty());
  }
  EXPECT_GT(met, 50u);
}

/// A bullet does not pass a wall that is thinner than its way, and what rests on the ground or leaves it meets nothing.
TYPED_TEST(PlaneImpacts, ABulletMeetsTheWallAndWhatSlidesMeetsNothing) {
  using T = TypeParam;
  World<T> world;
  const BodyId ground = world.add({.shape = HalfPlane<T>(), .fixed = true});
  const BodyId wall = world.add({.shape = Box<T>({T(0.02), T(4)}), .pose = {{T(0), T(2)}, {}}, .fixed = true});
  Body<T> bullet{.shape = Circle<T>(T(0.01)), .pose = {{T(-3), T(3)}, {}}, .linear = {T(500), T(0)}, .fast = true};
  const BodyId shot = world.add(bullet);
  Body<T> crate{.shape = Box<T>({T(1), T(1)}), .pose = {{T(3), T(0.5)}, {}}, .linear = {T(10), T(0)}, .fast = true};
  world.add(crate);  // slides
  crate.pose.translation = {T(6), T(0.499)};
  crate.linear = {T(0), T(20)};
  world.add(crate);  // leaves, a little sunk
  crate.pose.translation = {T(9), T(0.5)};
  crate.linear = {T(0), T(-20)};
  const BodyId pressed = world.add(crate);
  world.update(T(0.1));
  ASSERT_EQ(world.impacts().size(), 2u);
  EXPECT_EQ(world.impacts()[0].a, ground);
  EXPECT_EQ(world.impacts()[0].b, pressed);
  EXPECT_EQ(world.impacts()[0].hit.t, T(0));
  EXPECT_EQ(world.impacts()[1].a, wall);
  EXPECT_EQ(world.impacts()[1].b, shot);
  EXPECT_NEAR(world.impacts()[1].hit.t, T(2.98) / T(500), T(1e-7));
}

}  // namespace
}  // namespace graze::plane
