// Casts, times of impact and rays in the plane, one at a time, beside Box2D.
//
// "Cast" is B moving without turning, "impact" B moving and turning, "ray" a ray along B's way from where B starts.
// Box2D's casts stop a little before what they meet, by its slop.
#include <cstdio>

#include "plane_box2d.hpp"
#include "plane_pairs.hpp"

namespace graze::plane {

void print_motion_head() {
  std::printf("\n%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "", "", "one", "", "", "Box2D", "", "", "faster", "",
              "");
  std::printf("%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "pair", "hit", "cast", "impact", "ray", "cast",
              "impact", "ray", "cast", "impact", "ray");
}

void print_motion_row(const Options& options, const std::string& name, const Pairs& pairs) {
  const std::size_t count = std::min(options.cached, options.pairs), turns = turns_of(count);
  const auto timed = [&](const auto& f) { return least_time(options, count, turns, for_each_of(count, f)); };
  std::vector<Velocity<float>> straight = pairs.motion_b;
  for (Velocity<float>& v : straight) v.angular = 0;
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
  std::printf("%-24s %4.0f %% %9.1f %9.1f %9.1f", name.c_str(), 100.0 * double(hits) / double(count), cast_time,
              impact_time, ray_time);
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
