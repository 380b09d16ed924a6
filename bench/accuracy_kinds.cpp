// How far Graze's own answers about all of its kinds are from the truth: that of the tests' reference, in extended
// precision, about the tests' specimens. Sizes are from a tenth to twice the scale, which is from 0.1 mm to 100 km.
#include "accuracy_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "accuracy_truth.hpp"
#include "common/specimen.hpp"
#include "graze/cast.hpp"
#include "graze/raycast.hpp"
#include "largest_error.hpp"
#include "measure.hpp"
#include "plane/moving_figures.hpp"
#include "reference/certificate.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

using reference::Placed;
constexpr int all_kinds = testing::kind_count;
using testing::PlacedSpecimen;
using testing::Random;
using SpecimenKind = testing::Kind;

/// A contact deeper than this share of the size, before a hit or where there was none, was missed.
constexpr Real missed = 2e-5L;

reference::Vector wide(const Vec3f& v) { return {v.x, v.y, v.z}; }

PlacedSpecimen random_body(SpecimenKind kind, float scale, float reach, Random& random) {
  PlacedSpecimen body{testing::random_specimen(kind, scale, random), {}, testing::random_rotation(random)};
  if (kind != SpecimenKind::half_space) body.translation = testing::random_vector(random, reach);
  return body;
}

/// Scales in turn, for each of which there is the same number of questions.
float scale_of(std::size_t i) { return std::array<float, 4>{1e-4f, 0.01f, 1.0f, 1e5f}[i % 4]; }

// --- One shape ---

struct ShapeErrors {
  LargestError outside, inside, on_surface, ray;
};

template <class T>
void ask_point(const PlacedSpecimen& body, const Placed& truth, const Vec3f& point, Real size, ShapeErrors& errors) {
  const auto told = closest(testing::build<T>(body.specimen), testing::pose_of<T>(body), converted<T>(point));
  const Real so = reference::signed_distance(truth, reference::place(reference::point(), wide(point))).distance;
  (so > 0 ? errors.outside : errors.inside).add((Real(told.distance) - so) / size);
  const reference::Vector there{told.point.x, told.point.y, told.point.z};
  errors.on_surface.add(reference::signed_distance(truth, reference::place(reference::point(), there)).distance / size);
}

/// A ray that begins outside. A hit where it passes by less than `missed` is none too many.
template <class T>
void ask_ray(const PlacedSpecimen& body, const Placed& truth, const Vec3f& from, const Vec3f& way, Real size,
             LargestError& errors) {
  if (reference::outside_distance(truth, wide(from)) <= 0) return;
  const Ray<T> ray{converted<T>(from), converted<T>(way)};
  const T length = graze::length(ray.direction);
  const auto told = raycast(testing::build<T>(body.specimen), testing::pose_of<T>(body), ray, length);
  const auto so = ray_meeting(truth, wide(from), wide(way), size);
  if (told.has_value() == so.has_value()) {
    if (told) errors.add((Real(told->t) / reference::length(wide(way)) - so->t) * so->closing / size);
    return;
  }
  if (told) {
    const reference::Vector there = wide(from) + wide(way) * (Real(told->t) / reference::length(wide(way)));
    if (reference::outside_distance(truth, there) < missed * size) return;
  }
  errors.add_wrong();
}

template <class T>
ShapeErrors ask_shapes(SpecimenKind kind, std::size_t questions) {
  Random random(1 + static_cast<unsigned>(kind));
  ShapeErrors errors;
  for (std::size_t i = 0; i < questions; ++i) {
    const float scale = scale_of(i);
    const PlacedSpecimen body = random_body(kind, scale, 0.3f * scale, random);
    const Placed truth = testing::reference_of(body);
    const Real size = std::max<Real>(reference::bounding_radius(truth.shape), scale);
    ask_point<T>(body, truth, testing::random_vector(random, (i % 8 < 4 ? 0.3f : 1.0f) * scale), size, errors);
    const Vec3f from = testing::random_vector(random, 3 * scale);
    ask_ray<T>(body, truth, from, (body.translation - from) * 2.0f + testing::random_vector(random, scale), size,
               errors.ray);
  }
  return errors;
}

// --- Two shapes ---

struct PairErrors {
  LargestError apart, overlapping, cast, impact;
};

template <class T>
void ask_distance(const PlacedSpecimen& a, const PlacedSpecimen& b, Real size, PairErrors& errors) {
  const Real so = reference::signed_distance(testing::reference_of(a), testing::reference_of(b)).distance;
  const auto told = distance(testing::build<T>(a.specimen), testing::pose_of<T>(a), testing::build<T>(b.specimen),
                             testing::pose_of<T>(b));
  (so > 0 ? errors.apart : errors.overlapping).add((Real(told.distance) - so) / size);
}

/// A body that moves, in extended precision.
struct Moving {
  Placed start;
  Velocity<float> velocity;

  Placed at(Real t) const {
    Placed there = start;
    there.translation = start.translation + wide(velocity.linear) * t;
    const reference::Vector turn = wide(velocity.angular);
    const Real rate = reference::length(turn);
    if (rate == 0) return there;
    const reference::Vector n = turn * (1 / rate);
    const Real c = std::cos(rate * t), s = std::sin(rate * t);
    for (reference::Vector* axis : {&there.axis_x, &there.axis_y, &there.axis_z})
      *axis = *axis * c + cross(n, *axis) * s + n * (dot(n, *axis) * (1 - c));
    return there;
  }
  /// The most by which a point of it moves, beside the linear velocity, in a unit of time.
  Real sweep() const { return reference::length(wide(velocity.angular)) * reference::bounding_radius(start.shape); }
};

/// How far apart or deep bodies are at the time of a hit; wrong where they were deep before, or without one.
template <class T>
void ask_cast(const PlacedSpecimen& a, const Velocity<float>& of_a, const PlacedSpecimen& b,
              const Velocity<float>& of_b, Real size, LargestError& errors) {
  const Moving ma{testing::reference_of(a), of_a}, mb{testing::reference_of(b), of_b};
  const auto in = [](const Velocity<float>& v) { return Velocity<T>{converted<T>(v.linear), converted<T>(v.angular)}; };
  const auto hit = cast<T>(testing::build<T>(a.specimen), testing::pose_of<T>(a), in(of_a),
                           testing::build<T>(b.specimen), testing::pose_of<T>(b), in(of_b), T(1));
  if (hit && hit->t == T(0)) return;
  reference::Vector last{0, 1, 0};  // the direction that told them apart before
  const auto apart = [&](Real t, Real enough) {
    const Placed pa = ma.at(t), pb = mb.at(t);
    if (const Real along = reference::separation(pa, pb, last); along > enough) return along;
    const reference::Signed so = reference::signed_distance(pa, pb);
    last = so.normal;
    return so.distance;
  };
  const Real speed = reference::length(wide(of_b.linear) - wide(of_a.linear)) + ma.sweep() + mb.sweep();
  Real met_at = 0;
  const Real until = hit ? Real(hit->t) : 1;
  if (plane::stay_apart(apart, until, speed, missed * size, met_at) == plane::Apart::met) return errors.add_wrong();
  if (hit) errors.add(reference::signed_distance(ma.at(until), mb.at(until)).distance / size);
}

template <class T>
PairErrors ask_kinds(SpecimenKind kind_a, SpecimenKind kind_b, std::size_t pairs) {
  Random random(1000 + static_cast<unsigned>(kind_a) * all_kinds + static_cast<unsigned>(kind_b));
  PairErrors errors;
  for (std::size_t i = 0; i < pairs; ++i) {
    const float scale = scale_of(i), reach = (i % 8 < 4 ? 0.5f : 1.2f) * scale;
    const PlacedSpecimen a = random_body(kind_a, scale, reach, random), b = random_body(kind_b, scale, reach, random);
    const Real size = reference::size(testing::reference_of(a), testing::reference_of(b));
    ask_distance<T>(a, b, size, errors);
    // One comes from afar; out of a half-space, into which everything random falls, along its normal.
    const bool ground = kind_b == SpecimenKind::half_space;
    const PlacedSpecimen& target = ground ? b : a;
    PlacedSpecimen far = ground ? a : b;
    far.translation =
        (ground ? rotate(b.rotation, {0, 1, 0}) : normalized(testing::random_vector(random, 1))) * (4 * scale);
    const Vec3f way = (target.translation - far.translation) * 1.5f + testing::random_vector(random, scale);
    const Vec3f turn = testing::random_vector(random, 3), other = testing::random_vector(random, ground ? 0.0f : 3.0f);
    ask_cast<T>(far, {way, {}}, target, {}, size, errors.cast);
    ask_cast<T>(far, {way, turn}, target, {{}, other}, size, errors.impact);
  }
  return errors;
}

// --- Tables ---

std::string words_of(SpecimenKind kind) {
  std::string name = testing::name_of(kind);
  std::ranges::replace(name, '_', ' ');
  return name;
}

template <class Errors>
std::string both(const Errors& wide, const Errors& narrow, LargestError Errors::*query) {
  return (wide.*query).text() + " / " + (narrow.*query).text();
}

void print(const char* heading, const std::string& words, const Table& table) {
  std::string text = table.text();
  while (text.ends_with("\n\n")) text.pop_back();
  std::printf("\n## %s\n\n%s\n\n%s", heading, words.c_str(), text.c_str());
}

}  // namespace

void print_accuracy_of_kinds(std::size_t questions, std::size_t pairs, const std::regex& only) {
  Table shapes({"largest, double / float", "closest, outside", "closest, inside", "point", "ray"});
  Table two({"largest, double / float", "apart", "overlapping", "cast", "impact"});
  for (int a = 0; a < all_kinds; ++a) {
    const auto kind_a = static_cast<SpecimenKind>(a);
    const std::string of_a = words_of(kind_a);
    if (std::regex_search("point-" + of_a, only)) {
      progress(std::size_t(a), all_kinds, "point-" + of_a);
      const auto wide = ask_shapes<double>(kind_a, questions), narrow = ask_shapes<float>(kind_a, questions);
      const auto cell = [&](LargestError ShapeErrors::*query) { return both(wide, narrow, query); };
      shapes.add({of_a, cell(&ShapeErrors::outside), cell(&ShapeErrors::inside), cell(&ShapeErrors::on_surface),
                  cell(&ShapeErrors::ray)});
    }
    for (int b = a; b < all_kinds; ++b) {
      const auto kind_b = static_cast<SpecimenKind>(b);
      const std::string name = of_a + "-" + words_of(kind_b);
      if (kind_a == SpecimenKind::half_space || !std::regex_search("kinds " + name, only)) continue;
      progress(std::size_t(a * all_kinds + b), all_kinds * all_kinds, name);
      const auto wide = ask_kinds<double>(kind_a, kind_b, pairs), narrow = ask_kinds<float>(kind_a, kind_b, pairs);
      const auto cell = [&](LargestError PairErrors::*query) { return both(wide, narrow, query); };
      two.add({name, cell(&PairErrors::apart), cell(&PairErrors::overlapping), cell(&PairErrors::cast),
               cell(&PairErrors::impact)});
    }
  }
  print("Points and rays, every kind",
        std::to_string(questions) +
            " shapes of each kind of Graze, a third of them rounded, from 0.1 mm to 100 km. \"Closest\" is the signed\n"
            "distance of a point, \"point\" how far what it tells is off the surface, \"ray\" as above.",
        shapes);
  print(
      "Every two kinds",
      std::to_string(pairs) +
          " pairs of such shapes. \"Apart\" and \"overlapping\" are signed distances; \"cast\" is one moving without\n"
          "turning and \"impact\" both turning, but for half-spaces: how far apart, or deep, they are at the time "
          "told.\n"
          "No contact deeper than 2e-5 of the size was found before a hit or where there was none, or its share "
          "stands\n"
          "in brackets.",
      two);
}

}  // namespace graze::bench
