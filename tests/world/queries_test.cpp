// Questions to a world against asking every body.
#include <gtest/gtest.h>

#include <thread>

#include "common/specimen.hpp"
#include "graze/world.hpp"

namespace graze {
namespace {

using testing::Random;

template <class T>
Shape<T> random_shape(Random& random, float scale = 1) {
  const auto kind = static_cast<testing::Kind>(random() % testing::bounded_kinds);
  return testing::build<T>(testing::random_specimen(kind, scale, random));
}

template <class T>
Pose<T> random_pose(Random& random, float reach) {
  return {converted<T>(testing::random_vector(random, reach)),
          normalized(converted<T>(testing::random_rotation(random)))};
}

/// Bodies of all kinds, some of them triggers and in other categories, some moved and removed after an update.
template <class T>
void fill(World<T>& world, Random& random) {
  std::vector<BodyId> ids;
  for (int i = 0; i < 120; ++i) {
    Body<T> body{random_shape<T>(random), random_pose<T>(random, 6)};
    body.trigger = random() % 6 == 0;
    if (random() % 3 == 0) body.filter.category = 2;
    ids.push_back(world.add(body));
  }
  world.add({HalfSpace<T>(), {{0, -5, 0}, {}}});
  world.update();
  for (int i = 0; i < 30; ++i) {
    const std::size_t at = random() % ids.size();
    if (!world.bodies().contains(ids[at])) continue;
    if (i % 2 == 0)
      world.move(ids[at], random_pose<T>(random, 6));
    else
      world.remove(ids[at]);
  }
  world.add({random_shape<T>(random), random_pose<T>(random, 6)});
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
class WorldQueries : public ::testing::Test {
 protected:
  WorldQueries() { fill(world, random); }

  Random random{4};
  World<T> world;
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WorldQueries, Scalars);

TYPED_TEST(WorldQueries, OverlappingAndNearest) {
  using T = TypeParam;
  for (int i = 0; i < 60; ++i) {
    const Shape<T> shape = i % 3 == 0 ? Shape<T>(Sphere<T>(T(0))) : random_shape<T>(this->random);
    const Pose<T> pose = random_pose<T>(this->random, 7);
    for (const QueryFilter& filter : filters()) {
      std::vector<BodyId> touching;
      std::vector<BodyDistance<T>> all;
      for (const BodyId id : asked(this->world, filter)) {
        const Body<T> body = this->world.bodies().body(id);
        if (overlap(shape, pose, body.shape, body.pose)) touching.push_back(id);
        all.push_back({id, distance(shape, pose, body.shape, body.pose)});
      }
      std::sort(all.begin(), all.end(), [](const auto& p, const auto& q) {
        return p.distance.distance != q.distance.distance ? p.distance.distance < q.distance.distance : p.body < q.body;
      });

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
}

TYPED_TEST(WorldQueries, Rays) {
  using T = TypeParam;
  std::size_t hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray<T> ray{converted<T>(testing::random_vector(this->random, 8)),
                     converted<T>(testing::random_vector(this->random, 1))};
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

TYPED_TEST(WorldQueries, Casts) {
  using T = TypeParam;
  std::size_t hits = 0;
  for (int i = 0; i < 60; ++i) {
    const Shape<T> shape = random_shape<T>(this->random, 0.5f);
    const Pose<T> pose = random_pose<T>(this->random, 8);
    Velocity<T> velocity{converted<T>(testing::random_vector(this->random, 6)), {}};
    if (i % 3 == 0) velocity.angular = converted<T>(testing::random_vector(this->random, 3));
    QueryFilter filter;
    filter.accept = [&](BodyId id) {  // a half-space and what turns
      return i % 3 != 0 || !this->world.bodies().body(id).shape.template as<HalfSpace<T>>();
    };
    std::vector<BodyCastHit<T>> all, found;
    for (const BodyId id : asked(this->world, filter)) {
      const Body<T> body = this->world.bodies().body(id);
      if (const auto hit = graze::cast<T>(shape, pose, velocity, body.shape, body.pose, {}, T(1.5)))
        all.push_back({id, *hit});
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.hit.t < q.hit.t; });
    this->world.cast_all(shape, pose, velocity, T(1.5), filter, found);
    ASSERT_EQ(found.size(), all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(found[k].body, all[k].body);
      EXPECT_EQ(found[k].hit.t, all[k].hit.t);
    }
    const auto first = this->world.cast(shape, pose, velocity, T(1.5), filter);
    ASSERT_EQ(first.has_value(), !all.empty());
    EXPECT_TRUE(!first || first->hit.t == all.front().hit.t);
    hits += all.size();
  }
  EXPECT_GT(hits, 30u);
}

/// The first question after a change brings the tree up to date, whichever thread asks it.
TYPED_TEST(WorldQueries, FromSeveralThreads) {
  using T = TypeParam;
  const Shape<T> ball(Sphere<T>(T(2)));
  std::vector<std::vector<BodyId>> found(4);
  std::vector<std::thread> threads;
  for (auto& of_thread : found) threads.emplace_back([&] { this->world.overlapping(ball, {}, {}, of_thread); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(found[0].empty());
  for (const auto& of_thread : found) EXPECT_EQ(of_thread, found[0]);
}

}  // namespace
}  // namespace graze
