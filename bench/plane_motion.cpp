// Casts, times of impact and rays in the plane, one at a time and in batches, beside Box2D.
//
// "Cast" is B moving without turning, "impact" B moving and turning, "ray" a ray along B's way from where B starts.
// "One" and "batch" are those of plane_contacts.cpp; "mixed" is all pairs of all rows shuffled. Box2D's casts stop a
// little before what they meet, by its slop.
#include <cstdio>
#include <random>

#include "plane_box2d.hpp"
#include "plane_pairs.hpp"

namespace graze::plane {

namespace {

/// The velocities of the bodies that move, without their turns.
std::vector<Velocity<float>> straightened(std::vector<Velocity<float>> motion) {
  for (Velocity<float>& v : motion) v.angular = 0;
  return motion;
}

/// The time of a cast in a batch of all pairs.
double time_of_batch(const Options& options, const Pairs& pairs, const std::vector<Velocity<float>>& motion_b) {
  const std::vector<Velocity<float>> at_rest(1);
  const Bodies<float> a(pairs.a, pairs.pose_a), b(pairs.b, pairs.start_b);
  std::vector<std::optional<CastHit<float>>> hits;
  return least_time(options, pairs.a.size(), 1, [&] { cast(Batch<float>(a, b), at_rest, motion_b, 1.0f, hits); });
}

/// The time of a cast alone, all pairs one after the other.
double time_alone(const Options& options, const Pairs& pairs, const std::vector<Velocity<float>>& motion_b) {
  return least_time(options, pairs.a.size(), 1, for_each_of(pairs.a.size(), [&](std::size_t i) {
                      if (const auto hit =
                              cast(pairs.a[i], pairs.pose_a[i], {}, pairs.b[i], pairs.start_b[i], motion_b[i], 1.0f))
                        kept = kept + double(hit->t);
                    }));
}

}  // namespace

void print_motion_head() {
  std::printf("\n%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "", "", "one", "", "", "batch", "", "Box2D",
              "", "", "faster", "", "");
  std::printf("%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "pair", "hit", "cast", "impact", "ray", "cast",
              "impact", "cast", "impact", "ray", "cast", "impact", "ray");
}

void print_mixed_casts(const Options& options, const std::vector<Pairs>& rows) {
  std::mt19937 random(1);
  Pairs mixed;
  for (std::size_t i = 0; i < options.pairs; ++i) {
    const Pairs& from = rows[random() % rows.size()];
    const std::size_t k = random() % from.a.size();
    mixed.a.push_back(from.a[k]), mixed.b.push_back(from.b[k]);
    mixed.pose_a.push_back(from.pose_a[k]), mixed.start_b.push_back(from.start_b[k]);
    mixed.motion_b.push_back(from.motion_b[k]);
  }
  const auto straight = straightened(mixed.motion_b);
  std::printf("\nmixed: casts %.1f one by one, %.1f in a batch; impacts %.1f and %.1f\n",
              time_alone(options, mixed, straight), time_of_batch(options, mixed, straight),
              time_alone(options, mixed, mixed.motion_b), time_of_batch(options, mixed, mixed.motion_b));
}

void print_motion_row(const Options& options, const std::string& name, const Pairs& pairs) {
  const std::size_t count = std::min(options.cached, options.pairs), turns = turns_of(count);
  const auto timed = [&](const auto& f) { return least_time(options, count, turns, for_each_of(count, f)); };
  const std::vector<Velocity<float>> straight = straightened(pairs.motion_b);
  const auto cast_one = [&](std::size_t i, const Velocity<float>& v) {
    return cast(pairs.a[i], pairs.pose_a[i], {}, pairs.b[i], pairs.start_b[i], v, 1.0f);
  };
  std::size_t hits = 0;
  for (std::size_t i = 0; i < count; ++i) hits += cast_one(i, straight[i]).has_value();
  const auto keep = [](const auto& hit) {
    if (hit) kept = kept + double(hit->t);
  };
  const double cast_time = timed([&](std::size_t i) { keep(cast_one(i, straight[i])); }),
               impact_time = timed([&](std::size_t i) { keep(cast_one(i, pairs.motion_b[i])); }),
               ray_time = timed([&](std::size_t i) {
                 const Ray<float> ray{pairs.start_b[i].translation, pairs.motion_b[i].linear};
                 keep(raycast(pairs.a[i], pairs.pose_a[i], ray, 8.0f));
               });
  std::printf("%-24s %4.0f %% %9.1f %9.1f %9.1f %9.1f %9.1f", name.c_str(), 100.0 * double(hits) / double(count),
              cast_time, impact_time, ray_time, time_of_batch(options, pairs, straight),
              time_of_batch(options, pairs, pairs.motion_b));
#ifdef GRAZE_BENCH_BOX2D
  std::vector<Box2dBody> a(count), b(count);
  std::vector<b2Vec2> way(count);
  std::vector<b2Sweep> at_a(count), sweep_b(count);
  for (std::size_t i = 0; i < count; ++i) {
    fill(a[i], pairs.items_a[i], pairs.pose_a[i]);
    fill(b[i], pairs.items_b[i], pairs.start_b[i]);
    way[i] = {pairs.motion_b[i].linear.x, pairs.motion_b[i].linear.y};
    at_a[i] = box2d_sweep(a[i].pose, {0, 0}, 0);
    sweep_b[i] = box2d_sweep(b[i].pose, way[i], pairs.motion_b[i].angular);
  }
  const double its_cast = timed([&](std::size_t i) { box2d_cast(a[i], b[i], way[i]); }),
               its_impact = timed([&](std::size_t i) { box2d_impact(a[i], b[i], at_a[i], sweep_b[i]); });
  std::printf(" %9.1f %9.1f", its_cast, its_impact);
  if (box2d_has(pairs.a[0])) {
    const double its_ray = timed([&](std::size_t i) { box2d_ray(a[i], b[i].pose.p, way[i]); });
    std::printf(" %9.1f %8.1fx %8.1fx %8.1fx", its_ray, its_cast / cast_time, its_impact / impact_time,
                its_ray / ray_time);
  } else {
    std::printf(" %9s %8.1fx %8.1fx %9s", "-", its_cast / cast_time, its_impact / impact_time, "-");
  }
#endif
  std::printf("\n");
}

}  // namespace graze::plane
