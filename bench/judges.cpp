#include "judges.hpp"

#include <cmath>
#include <optional>

#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "graze_shape.hpp"

namespace graze::bench {

namespace {

using Shared = OncePerCorners<std::optional<Shape<double>>>;

Shape<double> shape_of(const Body& body, Shared& shared) {
  return *shared.of(body, [](const Body& b) { return std::optional(graze_shape<double>(b)); });
}

}  // namespace

Reference::Reference(const std::vector<Pair>& pairs) : pairs_(&pairs) {
  Shared shared;
  for (const Pair& pair : pairs)
    for (const Body* body : {&pair.a, &pair.b}) shapes_.push_back(shape_of(*body, shared));
}

double Reference::gap(std::size_t i, double t) const {
  Posed pose = pair(i).a.pose;
  pose.translation += pair(i).motion * t;
  return distance(a(i), pose, b(i), pair(i).b.pose).distance / pair(i).size();
}

Judge distance_judge(const Reference& reference, Query query) {
  auto truth = std::make_shared<std::vector<double>>();
  for (std::size_t i = 0; i < reference.size(); ++i) truth->push_back(reference.gap(i));
  return [truth, query, &reference](std::size_t i, const Answer& answer) {
    const double so = (*truth)[i];
    Verdict verdict{std::abs(so) > band, so < 0, answer.overlap != (so < 0)};
    // On a mesh each triangle touched has a depth of its own along its normal, which no distance tells.
    const bool has_one_depth = reference.pair(i).b.kind != Kind::mesh;
    if (query == Query::distance || (so < -band && has_one_depth))
      verdict.error = std::abs(answer.distance / reference.pair(i).size() - so);
    return verdict;
  };
}

Judge ray_judge(const Reference& reference) {
  return [&reference](std::size_t i, const Answer& answer) {
    const Pair& pair = reference.pair(i);
    const double length_of = length(pair.motion), size = pair.a.reach();
    const Ray<double> ray{pair.b.pose.translation, pair.motion};
    const auto hit = raycast(reference.a(i), pair.a.pose, ray, length_of);
    Verdict verdict;
    verdict.meets = hit.has_value();
    if (hit && answer.overlap) verdict.error = std::abs(answer.time * length_of - hit->t) / size;
    if (hit && answer.overlap && verdict.error <= fine) return verdict;
    if (!hit && !answer.overlap) return verdict;
    // A ray that grazes the surface may be said to hit or not.
    verdict.wrong = true;
    if (hit && answer.overlap) return verdict;
    const auto at = [&](double t) {
      return closest(reference.a(i), pair.a.pose, pair.b.pose.translation + pair.motion * t).distance / size;
    };
    double low = 0, high = 1;
    for (int step = 0; step < 60; ++step) {
      const double one = low + (high - low) / 3, other = high - (high - low) / 3;
      (at(one) < at(other) ? high : low) = at(one) < at(other) ? other : one;
    }
    verdict.counts = std::abs(at((low + high) / 2)) > band;
    return verdict;
  };
}

double least_gap(const Reference& reference, std::size_t i) {
  constexpr double golden = 0.6180339887498949;
  double low = 0, high = 1;
  double one = high - golden * (high - low), other = low + golden * (high - low);
  double at_one = reference.gap(i, one), at_other = reference.gap(i, other);
  for (int step = 0; step < 40; ++step)
    if (at_one < at_other) {
      high = other, other = one, at_other = at_one;
      one = high - golden * (high - low), at_one = reference.gap(i, one);
    } else {
      low = one, one = other, at_one = at_other;
      other = low + golden * (high - low), at_other = reference.gap(i, other);
    }
  return std::min(at_one, at_other);
}

bool wrong_cast(const Reference& reference, std::size_t i, double least, double t, double same) {
  if (t == never) return least <= 0;
  return least > 0 || std::abs(reference.gap(i, t)) > same;
}

Judge cast_judge(const Reference& reference) {
  auto least = std::make_shared<std::vector<double>>();
  for (std::size_t i = 0; i < reference.size(); ++i) least->push_back(least_gap(reference, i));
  return [least, &reference](std::size_t i, const Answer& answer) {
    const double nearest = (*least)[i];
    Verdict verdict{std::abs(nearest) > coarse, nearest <= 0};
    verdict.wrong = wrong_cast(reference, i, nearest, answer.time, coarse);
    if (verdict.counts && verdict.meets && answer.overlap) verdict.error = std::abs(reference.gap(i, answer.time));
    return verdict;
  };
}

MakeTouching make_touching() {
  auto shared = std::make_shared<Shared>();
  // Corners stay for as long as pairs do, whose maker keeps them.
  return [shared](const Body& body_a, const Body& body_b) -> Touching {
    return [a = shape_of(body_a, *shared), b = shape_of(body_b, *shared)](const Posed& pose_a, const Posed& pose_b) {
      return overlap(a, pose_a, b, pose_b);
    };
  };
}

}  // namespace graze::bench
