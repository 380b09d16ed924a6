// Casts of every pair of convex shapes against the independent reference, straight and turning.
//
// A claim of no contact at a time is proven by a direction along which the reference finds the shapes apart; a claim of
// contact by a point that is near both shapes. Where the proof fails the reference's own distance decides. For one cast
// in `bisect_every` the time itself is found by the reference alone: dense samples, then bisection.
//
// How many casts a pair of kinds: GRAZE_TEST_CASTS in the environment, else 60; GRAZE_TEST_SEARCH_EVERY for bisection.
#include "graze/cast.hpp"

#include <gtest/gtest.h>

#include "common/asked_number.hpp"
#include "common/specimen.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

using reference::Real;

int casts_to_test() { return asked_number("GRAZE_TEST_CASTS", 60); }
int bisect_every() { return asked_number("GRAZE_TEST_SEARCH_EVERY", 60); }

reference::Vector vector_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

struct Mover {
  PlacedSpecimen placed;
  Vec3f linear{}, angular{};

  std::string text() const {
    char out[200];
    std::snprintf(out, sizeof out, "\n  linear %.9g %.9g %.9g angular %.9g %.9g %.9g", double(linear.x),
                  double(linear.y), double(linear.z), double(angular.x), double(angular.y), double(angular.z));
    return describe(placed) + out;
  }
  template <class T>
  Velocity<T> velocity() const {
    return {graze::converted<T>(linear), graze::converted<T>(angular)};
  }
};

/// The reference's body on its way, turned by Rodrigues' formula in extended precision.
class ReferenceMover {
 public:
  explicit ReferenceMover(const Mover& m)
      : start_(reference_of(m.placed)),
        linear_(vector_of(graze::converted<double>(m.linear))),
        angular_(vector_of(graze::converted<double>(m.angular))) {}

  reference::Placed at(Real t) const {
    reference::Placed p = start_;
    p.translation = p.translation + linear_ * t;
    const Real rate = reference::length(angular_);
    if (rate == 0) return p;
    const reference::Vector u = angular_ * (1 / rate);
    const Real c = std::cos(rate * t), s = std::sin(rate * t);
    for (reference::Vector* v : {&p.axis_x, &p.axis_y, &p.axis_z})
      *v = *v * c + cross(u, *v) * s + u * (dot(u, *v) * (1 - c));
    return p;
  }
  const reference::Placed& start() const { return start_; }

 private:
  reference::Placed start_;
  reference::Vector linear_, angular_;
};

/// One question, and everything needed to judge its answer.
template <class T>
struct CastCase {
  const Mover &a, &b;
  Shape<double> shape_a = build<double>(a.placed.specimen), shape_b = build<double>(b.placed.specimen);
  Posed pose_a = pose_of<double>(a.placed), pose_b = pose_of<double>(b.placed);
  ReferenceMover ra{a}, rb{b};
  Real size = reference::size(ra.start(), rb.start());
  Real tolerance = static_cast<Real>(cast_tolerance<T>) * size + 1e-14L * (size + reach());
  double duration = 1;

  Real reach() const {
    return static_cast<Real>(length(pose_b.translation - pose_a.translation)) +
           static_cast<Real>(length(b.linear - a.linear));
  }
  CastCase(const Mover& first, const Mover& second) : a(first), b(second) {}

  /// The tolerance where a user tells how large his shape is, and tells more than it is.
  Real stated() const {
    Real told = size;
    for (const Shape<double>* shape : {&shape_a, &shape_b})
      if (const auto* user = shape->template as<UserConvex<double>>())
        told = std::max(told, static_cast<Real>(user->core_extent() + shape->rounding()));
    return tolerance + static_cast<Real>(cast_tolerance<T>) * (told - size);
  }

  std::optional<CastHit<T>> ask(const CastOptions& options = {}) const {
    return cast(build<T>(a.placed.specimen), pose_of<T>(a.placed), a.velocity<T>(), build<T>(b.placed.specimen),
                pose_of<T>(b.placed), b.velocity<T>(), static_cast<T>(duration), options);
  }
  Distance<double> library_distance(double t) const {
    return distance(shape_a, pose_at(pose_a, a.velocity<double>(), t), shape_b,
                    pose_at(pose_b, b.velocity<double>(), t));
  }
  Real reference_distance(Real t) const { return reference::signed_distance(ra.at(t), rb.at(t)).distance; }

  /// Whether the reference can show the shapes to be further apart than `least` at a time.
  bool apart(double t, Real least) const {
    const Distance<double> d = library_distance(t);
    const Real proven = reference::separation(ra.at(t), rb.at(t), vector_of(d.normal));
    return proven > least || reference_distance(t) > least;
  }
  std::string text() const { return a.text() + "\n" + b.text(); }
};

/// The time in [low, high] at which the library's distance is least, near enough to find an overlap that samples miss.
template <class T>
double lowest(const CastCase<T>& c, double low, double high) {
  for (int i = 0; i < 30; ++i) {
    const double p = low + (high - low) * 0.382, q = low + (high - low) * 0.618;
    (c.library_distance(p).distance < c.library_distance(q).distance ? high : low) =
        c.library_distance(p).distance < c.library_distance(q).distance ? q : p;
  }
  return (low + high) / 2;
}

template <class T>
void check_miss(const CastCase<T>& c) {
  constexpr int samples = 32;
  int nearest = 0;
  double least_distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    const double t = c.duration * i / samples, d = c.library_distance(t).distance;
    if (d < least_distance) {
      least_distance = d;
      nearest = i;
    }
    ASSERT_TRUE(c.apart(t, 0)) << "missed a hit at " << t << "\n" << c.text();
  }
  const double t =
      lowest(c, c.duration * std::max(0, nearest - 1) / samples, c.duration * std::min(samples, nearest + 1) / samples);
  ASSERT_TRUE(c.apart(t, 0)) << "missed a hit at " << t << "\n" << c.text();
}

/// In contact, as stated, at the time of a hit: rounding the time to T may move the bodies a little.
template <class T>
void check_contact(const CastCase<T>& c, const CastHit<T>& hit) {
  const Real t = hit.t;
  const reference::Placed a = c.ra.at(t), b = c.rb.at(t);
  const reference::Vector n = vector_of(graze::converted<double>(hit.normal)),
                          p = vector_of(graze::converted<double>(hit.point));
  const Real moved = std::is_same_v<T, float> ? 4e-6L * (c.size + c.reach()) : 0;
  const Real allowed = c.tolerance + moved;
  EXPECT_NEAR(static_cast<double>(reference::length(n)), 1, (std::is_same_v<T, float> ? 1e-6 : 1e-12));
  ASSERT_EQ(hit.status, Status::converged) << c.text();
  const Real apart = reference::separation(a, b, reference::normalized(n));
  if (hit.t == 0 && hit.depth > 0) {
    ASSERT_NEAR(static_cast<double>(apart), static_cast<double>(-hit.depth), static_cast<double>(allowed)) << c.text();
    ASSERT_FALSE(c.apart(0, c.tolerance)) << c.text();
    return;
  }
  ASSERT_LE(reference::outside_distance(a, p), allowed) << "t " << hit.t << "\n" << c.text();
  ASSERT_LE(reference::outside_distance(b, p), allowed) << "t " << hit.t << "\n" << c.text();
  ASSERT_GE(apart, -allowed) << "t " << hit.t << "\n" << c.text();
}

template <class T>
void check_no_earlier(const CastCase<T>& c, T until) {
  if (until == T(0)) return;
  constexpr int samples = 16;
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(until) * i / samples;
    ASSERT_TRUE(c.apart(t, std::is_same_v<T, float> ? 0 : c.tolerance / 5))
        << "hit at " << until << ", but in contact at " << t << "\n"
        << c.text();
  }
  if (std::is_same_v<T, double>) {
    const double t = static_cast<double>(until) * (1 - 1e-6);
    ASSERT_TRUE(c.apart(t, c.tolerance / 5)) << "in contact at " << t << " before " << until << "\n" << c.text();
  }
}

/// The first time of contact by the reference alone.
template <class T>
std::optional<Real> first_by_reference(const CastCase<T>& c) {
  constexpr int samples = 40;
  Real before = 0;
  for (int i = 0; i <= samples; ++i) {
    Real t = static_cast<Real>(c.duration) * i / samples;
    if (c.reference_distance(t) > 0) {
      before = t;
      continue;
    }
    for (int k = 0; k < 50 && i > 0; ++k) {
      const Real middle = (before + t) / 2;
      (c.reference_distance(middle) > 0 ? before : t) = middle;
    }
    return t;
  }
  return std::nullopt;
}

template <class T>
void check_against_bisection(const CastCase<T>& c, const std::optional<CastHit<T>>& hit) {
  const auto t = first_by_reference(c);
  if (!t) return;  // a graze between samples: the certificates have judged it
  ASSERT_TRUE(hit) << "missed the hit at " << *t << "\n" << c.text();
  ASSERT_LE(hit->t, *t + 1e-12L) << c.text();
  const Real apart = c.reference_distance(hit->t);
  if (hit->t > T(0)) {
    ASSERT_LE(std::abs(apart), c.stated()) << c.text();
  }
}

/// Bodies some sizes apart, thrown at each other well enough to meet in two of three cases.
std::pair<Mover, Mover> random_movers(Kind ka, Kind kb, float scale, bool turning, Random& random) {
  Mover a{{random_specimen(ka, scale, random), random_vector(random, scale), random_rotation(random)}, {}, {}};
  Mover b{{random_specimen(kb, scale, random), random_vector(random, 3 * scale), random_rotation(random)}, {}, {}};
  const Vec3f aim = a.placed.translation - b.placed.translation + random_vector(random, 0.7f * scale);
  const Vec3f common = random_vector(random, scale);
  a.linear = common;
  b.linear = common + aim * uniform(random, 0.5f, 2);
  if (turning) {
    a.angular = random_vector(random, 6);
    if (ka != Kind::half_space || kb != Kind::half_space) b.angular = random_vector(random, 6);
  }
  return {a, b};
}

class Casts : public ::testing::TestWithParam<std::pair<Kind, Kind>> {
 protected:
  Random random{
      static_cast<std::uint64_t>(static_cast<int>(GetParam().first) * 100 + static_cast<int>(GetParam().second))};

  template <class T>
  void check(bool turning, float scale, int casts) {
    const auto [ka, kb] = GetParam();
    int hits = 0, unknown = 0;
    // A support function that is rounded to float can stop GJK at some ten times that: the answer then says so.
    const bool rounded = std::is_same_v<T, float> && (ka == Kind::user || kb == Kind::user);
    for (int i = 0; i < casts; ++i) {
      const auto [a, b] = random_movers(ka, kb, scale, turning, random);
      const CastCase<T> c(a, b);
      const auto hit = c.ask();
      if (rounded && hit && hit->status == Status::bounded) {
        ++unknown;
        check_no_earlier(c, hit->t);
      } else if (hit) {
        hits += hit->t > T(0);
        check_contact(c, *hit);
        check_no_earlier(c, hit->t);
      } else {
        check_miss(c);
      }
      // The reference takes milliseconds for a distance of curved shapes: those are left to long runs.
      const bool slow = curved(ka) || curved(kb);
      if (std::is_same_v<T, double> && i % bisect_every() == 0 && (!slow || casts >= 1000))
        check_against_bisection(c, hit);
      if (HasFatalFailure()) return;
    }
    EXPECT_LE(unknown, 1 + casts / 1000);
    // Two segments in space hardly ever meet.
    if (casts >= 50 && kb != Kind::segment && ka != Kind::segment) {
      EXPECT_GT(hits, casts / 10);
    }
  }
};

TEST_P(Casts, StraightAgreeWithTheReference) { check<double>(false, 1, casts_to_test()); }
TEST_P(Casts, TurningAgreeWithTheReference) { check<double>(true, 1, casts_to_test()); }
TEST_P(Casts, InFloat) {
  check<float>(false, 1, casts_to_test() / 4);
  check<float>(true, 1, casts_to_test() / 4);
}
TEST_P(Casts, AreScaleFree) {
  for (const float scale : {1e-4f, 1e4f}) {
    check<double>(false, scale, casts_to_test() / 8);
    check<double>(true, scale, casts_to_test() / 8);
  }
}

std::vector<std::pair<Kind, Kind>> all_pairs() {
  std::vector<std::pair<Kind, Kind>> pairs;
  for (int i = 0; i < bounded_kinds; ++i)
    for (int j = i; j < kind_count; ++j) pairs.push_back({static_cast<Kind>(i), static_cast<Kind>(j)});
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(Shapes, Casts, ::testing::ValuesIn(all_pairs()), [](const auto& info) {
  return std::string(name_of(info.param.first)) + "_" + name_of(info.param.second);
});

}  // namespace
}  // namespace graze::testing
