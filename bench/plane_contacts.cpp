// Contacts and distances in the plane, one pair at a time and in batches, beside Box2D.
//
// "One" is the smaller number of pairs, which fit the cache, over and over; "batch" is all of them, streamed from
// memory. Relative poses are computed inside the timed call.
#include <algorithm>
#include <cstdio>

#include "plane_box2d.hpp"
#include "plane_pairs.hpp"

namespace graze::plane {

namespace {

/// Shapes of one kind, held tightly, where they are neither polygons nor rounded.
template <class C>
std::vector<C> concrete(const std::vector<Shapef>& shapes) {
  std::vector<C> out;
  for (const Shapef& s : shapes) out.push_back(*s.as<C>());
  return out;
}
template <class F>
void with_bodies(const std::vector<Shapef>& shapes, const std::vector<Pose2f>& poses, const F& f) {
  const auto of = [&]<class C>(const std::vector<C>& tight) { f(Bodies<float>(tight, poses)); };
  if (shapes[0].rounding() != 0) return of(shapes);
  shapes[0].visit([&](const auto& c) {
    using C = std::decay_t<decltype(c)>;
    if constexpr (std::is_same_v<C, Circle<float>> || std::is_same_v<C, Capsule<float>> ||
                  std::is_same_v<C, Box<float>> || std::is_same_v<C, Segment<float>>)
      of(concrete<C>(shapes));
    else
      of(shapes);
  });
}

}  // namespace

void print_contacts_row(const Options& options, const std::string& name, const Pairs& pairs) {
  const std::size_t cached = std::min(options.cached, options.pairs), turns = turns_of(cached);
  Manifolds<float> manifolds;
  const auto one_contacts = [&](std::size_t i) {
    manifolds.clear();
    contacts(pairs.a[i], pairs.pose_a[i], pairs.b[i], pairs.pose_b[i], 0.0f, manifolds);
    if (!manifolds.empty()) kept = kept + double(manifolds[0].points[0].distance);
  };
  const auto one_distance = [&](std::size_t i) {
    kept = kept + double(distance(pairs.a[i], pairs.pose_a[i], pairs.b[i], pairs.pose_b[i]).distance);
  };
  const double contacts_one = least_time(options, cached, turns, for_each_of(cached, one_contacts)),
               distance_one = least_time(options, cached, turns, for_each_of(cached, one_distance));
  double contacts_batch = 0, distance_batch = 0, overlap_batch = 0, overlapping = 0;
  with_bodies(pairs.a, pairs.pose_a, [&](const Bodies<float>& a) {
    with_bodies(pairs.b, pairs.pose_b, [&](const Bodies<float>& b) {
      const Batch<float> batch(a, b);
      BatchContacts<float> found;
      std::vector<Distance<float>> distances;
      std::vector<std::uint8_t> touch;
      contacts_batch = least_time(options, batch.size(), 1, [&] { contacts(batch, 0.0f, found); });
      distance_batch = least_time(options, batch.size(), 1, [&] { distance(batch, distances); });
      overlap_batch = least_time(options, batch.size(), 1, [&] { overlap(batch, touch); });
      overlapping = double(std::count(touch.begin(), touch.end(), 1)) / double(touch.size());
    });
  });
  std::printf("%-24s %4.0f %% %9.1f %9.1f %9.1f %9.1f %9.1f", name.c_str(), 100 * overlapping, contacts_one,
              contacts_batch, distance_one, distance_batch, overlap_batch);
#ifdef GRAZE_BENCH_BOX2D
  std::vector<Box2dBody> bodies_a(cached), bodies_b(cached);
  for (std::size_t i = 0; i < cached; ++i) {
    fill(bodies_a[i], pairs.items_a[i], pairs.pose_a[i]);
    fill(bodies_b[i], pairs.items_b[i], pairs.pose_b[i]);
  }
  const double its_distance = least_time(
      options, cached, turns, for_each_of(cached, [&](std::size_t i) { box2d_distance(bodies_a[i], bodies_b[i]); }));
  if (box2d_has(pairs.a[0]) && box2d_has(pairs.b[0])) {
    const double its_contacts = least_time(
        options, cached, turns, for_each_of(cached, [&](std::size_t i) { box2d_manifold(bodies_a[i], bodies_b[i]); }));
    std::printf(" %9.1f %9.1f %8.1fx %8.1fx", its_contacts, its_distance, its_contacts / contacts_one,
                its_contacts / contacts_batch);
  } else {
    std::printf(" %9s %9.1f %9s %9s", "-", its_distance, "-", "-");
  }
  std::printf(" %8.1fx %8.1fx", its_distance / distance_one, its_distance / distance_batch);
#endif
  std::printf("\n");
}

}  // namespace graze::plane
