// The plane beside Debian's Box2D 2.4: manifolds and distances, one pair at a time and in batches, on one thread.
//
//   bench_plane [--pairs N] [--cached N] [--rounds N]
//
// Pairs: numbers of PCG32 (seed 42, the first two thrown away). Of each shape h and w in [0.25, 1): circles of radius
// h, capsules of half length h and radius w / 2, boxes of half sizes h and w (rounded ones by 0.1), polygons on
// circles of radius h, each vertex up to a fifth of a step off; the centres so far apart that half the pairs overlap.
// Stacked boxes stand edge on edge, up to 5 mm apart or deep and 0.01 rad tilted. "One" is the smaller number of pairs,
// which fit the cache, over and over; "batch" is all of them, streamed from memory. Relative poses are computed inside
// the timed call; Box2D's manifold includes its points in the world (`b2WorldManifold`), as all others do. Box2D 2.4
// has no capsules and rounds all polygons a little; times are the least of the rounds, in ns a pair.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#ifdef GRAZE_BENCH_BOX2D
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#endif

#include "command_line.hpp"
#include "graze/plane/batch.hpp"
#include "measure.hpp"

namespace graze::plane {

namespace {

using bench::processor_seconds;

/// PCG32 (O'Neill 2014, "PCG: a family of simple fast space-efficient statistically good algorithms").
class Pcg {
 public:
  Pcg() {
    next();
    next();
  }
  double between(double low, double high) { return low + (high - low) * (next() >> 8) * 0x1p-24; }

 private:
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + 1442695040888963407u;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27),
               turn = static_cast<std::uint32_t>(old >> 59);
    return (mixed >> turn) | (mixed << ((32 - turn) & 31));
  }
  std::uint64_t state_ = 42;
};

enum class Kind { circle, capsule, box, rounded_box, hexagon, octagon, segment };

struct Item {
  Shapef shape = Circle<float>(1);
  double radius = 1;  ///< that bounds it
  Vec2d half{};
  std::vector<Vec2f> vertices{};
};

Item make(Kind kind, Pcg& random) {
  const double h = random.between(0.25, 1), w = random.between(0.25, 1);
  const auto number = [](double x) { return static_cast<float>(x); };
  switch (kind) {
  case Kind::circle: return {Circle<float>(number(h)), h, {h, h}, {}};
  case Kind::capsule: return {Capsule<float>(number(2 * h), number(w / 2)), h + w / 2, {h, w}, {}};
  case Kind::box: return {Box<float>({number(2 * h), number(2 * w)}), std::hypot(h, w), {h, w}, {}};
  case Kind::rounded_box:
    return {{Box<float>({number(2 * h), number(2 * w)}), 0.1f}, std::hypot(h, w) + 0.1, {h, w}, {}};
  case Kind::segment: return {Segment<float>({number(-h), 0}, {number(h), 0}), h, {h, 0}, {}};
  case Kind::hexagon:
  case Kind::octagon: break;
  }
  const int count = kind == Kind::hexagon ? 6 : 8;
  const double step = 6.283185307179586 / count, start = random.between(0, step);
  std::vector<Vec2f> points;
  for (int i = 0; i < count; ++i) {
    const double angle = start + step * (i + random.between(-0.2, 0.2));
    points.push_back({number(h * std::cos(angle)), number(h * std::sin(angle))});
  }
  const ConvexPolygon<float> polygon(points);
  const auto vertices = polygon.vertices();
  return {polygon, h, {h, h}, {vertices.begin(), vertices.end()}};
}

/// Pairs of a row of the table.
struct Pairs {
  std::vector<Item> items_a, items_b;
  std::vector<Shapef> a, b;
  std::vector<Pose2f> pose_a, pose_b;
};

Pairs make_pairs(Kind kind_a, Kind kind_b, double spread, bool stacked, std::size_t count) {
  Pcg random;
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const Item a = make(kind_a, random), b = make(kind_b, random);
    const double apart = random.between(0, spread) * (a.radius + b.radius), bearing = random.between(-3.14159, 3.14159);
    const Vec2d offset{random.between(-10, 10), random.between(-10, 10)};
    double angle_a = random.between(-3.14159, 3.14159), angle_b = random.between(-3.14159, 3.14159);
    const double t = random.between(-3, 3), s = random.between(-3, 3), turn = random.between(-0.7, 0.7);
    Vec2d between{apart * std::cos(bearing), apart * std::sin(bearing)};
    if (stacked) {
      angle_b = angle_a + turn / 0.7 * 0.01;
      const Vec2d own{t / 6 * (a.half.x + b.half.x), a.half.y + b.half.y + s / 3 * 0.005};
      between = {std::cos(angle_a) * own.x - std::sin(angle_a) * own.y,
                 std::sin(angle_a) * own.x + std::cos(angle_a) * own.y};
    }
    const auto pose = [](const Vec2d& at, double angle) {
      return Pose2f{plane::converted<float>(at), plane::converted<float>(Rot2d::from_angle(angle))};
    };
    pairs.items_a.push_back(a);
    pairs.items_b.push_back(b);
    pairs.a.push_back(a.shape);
    pairs.b.push_back(b.shape);
    pairs.pose_a.push_back(pose(offset, angle_a));
    pairs.pose_b.push_back(pose(offset + between, angle_b));
  }
  return pairs;
}

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

struct Options {
  std::size_t pairs = 100000, cached = 2000, rounds = 12;
};

/// The least time of a pair, in ns, of `turns` passes over `count` pairs.
double least(const Options& options, std::size_t count, std::size_t turns, const std::function<void()>& pass) {
  double best = 1e300;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    const double start = processor_seconds();
    for (std::size_t k = 0; k < turns; ++k) pass();
    best = std::min(best, processor_seconds() - start);
  }
  return best * 1e9 / static_cast<double>(count * turns);
}

volatile double kept = 0;  ///< what answers add up to, so that none is left out

#ifdef GRAZE_BENCH_BOX2D
struct Box2dBody {
  b2CircleShape circle;
  b2PolygonShape polygon;
  bool is_circle = false;
  b2DistanceProxy proxy;
  b2Vec2 ends[2];
  b2Transform pose;
};

void fill(Box2dBody& body, const Item& item, const Pose2f& pose) {
  body.pose.p = {pose.translation.x, pose.translation.y};
  body.pose.q.s = pose.rotation.sine;
  body.pose.q.c = pose.rotation.cosine;
  if (const auto* circle = item.shape.as<Circle<float>>()) {
    body.is_circle = true;
    body.circle.m_radius = circle->radius();
    body.proxy.Set(&body.circle, 0);
  } else if (const auto* box = item.shape.as<Box<float>>()) {
    body.polygon.SetAsBox(box->half_extents().x, box->half_extents().y);
    if (item.shape.rounding() != 0) body.polygon.m_radius = item.shape.rounding();
    body.proxy.Set(&body.polygon, 0);
  } else if (const auto* capsule = item.shape.as<Capsule<float>>()) {
    body.ends[0] = {0, -capsule->half_height()};
    body.ends[1] = {0, capsule->half_height()};
    body.proxy.Set(body.ends, 2, capsule->radius_top());
  } else if (const auto* segment = item.shape.as<Segment<float>>()) {
    body.ends[0] = {segment->a().x, segment->a().y};
    body.ends[1] = {segment->b().x, segment->b().y};
    body.proxy.Set(body.ends, 2, 0);
  } else {
    std::vector<b2Vec2> points;
    for (const Vec2f& v : item.vertices) points.push_back({v.x, v.y});
    body.polygon.Set(points.data(), static_cast<int>(points.size()));
    body.proxy.Set(&body.polygon, 0);
  }
}

void box2d_manifold(const Box2dBody& a, const Box2dBody& b) {
  b2Manifold manifold;
  manifold.pointCount = 0;
  if (a.is_circle)
    b2CollideCircles(&manifold, &a.circle, a.pose, &b.circle, b.pose);
  else if (b.is_circle)
    b2CollidePolygonAndCircle(&manifold, &a.polygon, a.pose, &b.circle, b.pose);
  else
    b2CollidePolygons(&manifold, &a.polygon, a.pose, &b.polygon, b.pose);
  if (manifold.pointCount == 0) return;
  b2WorldManifold world;
  world.Initialize(&manifold, a.pose, a.is_circle ? a.circle.m_radius : a.polygon.m_radius, b.pose,
                   b.is_circle ? b.circle.m_radius : b.polygon.m_radius);
  kept = kept + double(world.separations[0]);
}

void box2d_distance(const Box2dBody& a, const Box2dBody& b) {
  b2DistanceInput input;
  input.proxyA = a.proxy;
  input.proxyB = b.proxy;
  input.transformA = a.pose;
  input.transformB = b.pose;
  input.useRadii = true;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput output;
  b2Distance(&output, &cache, &input);
  kept = kept + double(output.distance);
}
#endif

void print_row(const Options& options, const std::string& name, const Pairs& pairs) {
  const std::size_t cached = std::min(options.cached, options.pairs), turns = std::max<std::size_t>(1, 40000 / cached);
  const auto each = [&](std::size_t count, const auto& f) {
    return [&, count] {
      for (std::size_t i = 0; i < count; ++i) f(i);
    };
  };
  Manifolds<float> manifolds;
  const auto one_contacts = [&](std::size_t i) {
    manifolds.clear();
    contacts(pairs.a[i], pairs.pose_a[i], pairs.b[i], pairs.pose_b[i], 0.0f, manifolds);
    if (!manifolds.empty()) kept = kept + double(manifolds[0].points[0].distance);
  };
  const auto one_distance = [&](std::size_t i) {
    kept = kept + double(distance(pairs.a[i], pairs.pose_a[i], pairs.b[i], pairs.pose_b[i]).distance);
  };
  const double contacts_one = least(options, cached, turns, each(cached, one_contacts)),
               distance_one = least(options, cached, turns, each(cached, one_distance));
  double contacts_batch = 0, distance_batch = 0, overlap_batch = 0, overlapping = 0;
  with_bodies(pairs.a, pairs.pose_a, [&](const Bodies<float>& a) {
    with_bodies(pairs.b, pairs.pose_b, [&](const Bodies<float>& b) {
      const Batch<float> batch(a, b);
      BatchContacts<float> found;
      std::vector<Distance<float>> distances;
      std::vector<std::uint8_t> touch;
      contacts_batch = least(options, batch.size(), 1, [&] { contacts(batch, 0.0f, found); });
      distance_batch = least(options, batch.size(), 1, [&] { distance(batch, distances); });
      overlap_batch = least(options, batch.size(), 1, [&] { overlap(batch, touch); });
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
  const auto has_manifold = [](const Shapef& s) {
    return s.as<Circle<float>>() || s.as<Box<float>>() || s.as<ConvexPolygon<float>>();
  };
  const double its_distance =
      least(options, cached, turns, each(cached, [&](std::size_t i) { box2d_distance(bodies_a[i], bodies_b[i]); }));
  if (has_manifold(pairs.a[0]) && has_manifold(pairs.b[0])) {
    const double its_contacts =
        least(options, cached, turns, each(cached, [&](std::size_t i) { box2d_manifold(bodies_a[i], bodies_b[i]); }));
    std::printf(" %9.1f %9.1f %8.1fx %8.1fx", its_contacts, its_distance, its_contacts / contacts_one,
                its_contacts / contacts_batch);
  } else {
    std::printf(" %9s %9.1f %9s %9s", "-", its_distance, "-", "-");
  }
  std::printf(" %8.1fx %8.1fx", its_distance / distance_one, its_distance / distance_batch);
#endif
  std::printf("\n");
}

}  // namespace

}  // namespace graze::plane

int main(int argc, char** argv) {
  using namespace graze::plane;
  Options options;
  graze::bench::CommandLine("Manifolds and distances in the plane, beside Box2D.")
      .number("--pairs", options.pairs, "pairs of a batch")
      .number("--cached", options.cached, "pairs that are asked about one at a time, over and over")
      .number("--rounds", options.rounds, "rounds, of which the fastest counts")
      .read(argc, argv);
  std::printf("%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "", "", "contacts", "", "distance", "",
              "overlap", "Box2D", "", "faster", "", "", "");
  std::printf("%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "pair", "meet", "one", "batch", "one", "batch",
              "batch", "manifold", "distance", "one", "batch", "distance", "batch");
  struct Row {
    const char* name;
    Kind a, b;
    double spread;
    bool stacked;
  };
  const Row rows[] = {
      {"circle-circle", Kind::circle, Kind::circle, 1.967, false},
      {"capsule-circle", Kind::capsule, Kind::circle, 1.6, false},
      {"capsule-capsule", Kind::capsule, Kind::capsule, 1.344, false},
      {"box-circle", Kind::box, Kind::circle, 1.75, false},
      {"box-capsule", Kind::box, Kind::capsule, 1.477, false},
      {"box-box", Kind::box, Kind::box, 1.602, false},
      {"rounded box-rounded box", Kind::rounded_box, Kind::rounded_box, 1.602, false},
      {"segment-box", Kind::segment, Kind::box, 1.3, false},
      {"hexagon-hexagon", Kind::hexagon, Kind::hexagon, 1.839, false},
      {"octagon-octagon", Kind::octagon, Kind::octagon, 1.889, false},
      {"hexagon-capsule", Kind::hexagon, Kind::capsule, 1.555, false},
      {"stacked boxes", Kind::box, Kind::box, 1, true},
  };
  for (const Row& row : rows)
    print_row(options, row.name, make_pairs(row.a, row.b, row.spread, row.stacked, options.pairs));
}
