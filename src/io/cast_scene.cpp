#include "graze/io/cast_scene.hpp"

#include <algorithm>

#include "io/convert.hpp"

namespace graze::io {

namespace {

/// A body for a cast: its shape, and the pose whose origin it turns about.
template <class T>
Placed<T> turning_about(const Collider& collider, const Mover& mover) {
  const Shape<T> shape = in_precision<T>(collider.shape);
  Posed local = collider.pose;
  local.translation = local.translation - mover.pivot;
  if (local.translation == Vec3d{}) return {shape, converted<T>(collider.pose)};
  return {Compound<T>(std::vector<Placed<T>>{{shape, converted<T>(local)}}), {converted<T>(mover.pivot), {}}};
}

template <class T>
std::vector<SceneHit> cast_in(const Scene& scene, const SceneCast& question, const Mover& mover) {
  const Velocity<T> velocity{validate::point(converted<T>(question.velocity.linear), "motion"),
                             validate::point(converted<T>(question.velocity.angular), "spin")};
  const T duration = validate::extent(static_cast<T>(question.duration), "duration");
  validate::point(converted<T>(mover.pivot), "about");
  const bool spins = question.velocity.angular != Vec3d{};
  std::vector<SceneHit> hits;
  for (const std::uint32_t i : mover.colliders) {
    const Collider& own = scene.colliders[i];
    if (spins && own.shape.as<HalfSpace<double>>()) throw InvalidValue(own.name, "no spin of a half-space", "one");
    const Placed<T> body =
        spins ? turning_about<T>(own, mover) : Placed<T>{in_precision<T>(own.shape), converted<T>(own.pose)};
    for (std::uint32_t j = 0; j < scene.colliders.size(); ++j) {
      const Collider& other = scene.colliders[j];
      if (other.trigger || other.body == own.body || !may_collide(own.filter, other.filter)) continue;
      const auto hit = cast<T>(body.shape, body.pose, velocity, in_precision<T>(other.shape), converted<T>(other.pose),
                               {}, duration, question.options);
      if (hit)
        hits.push_back({static_cast<double>(hit->t), i, j, converted<double>(hit->point),
                        converted<double>(hit->normal), static_cast<double>(hit->depth), hit->status});
    }
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const SceneHit& a, const SceneHit& b) { return a.t != b.t ? a.t < b.t : a.depth > b.depth; });
  return hits;
}

}  // namespace

Posed Mover::pose_at(const Posed& pose, const Velocity<double>& velocity, double t) const {
  return compose(graze::pose_at(Posed{pivot, {}}, velocity, t), Posed{pose.translation - pivot, pose.rotation});
}

Mover find_mover(const Scene& scene, const SceneCast& question) {
  Mover mover;
  const auto bodies = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const Body& body) { return body.name == question.from; });
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    if (bodies > 0 ? scene.bodies[c.body].name == question.from : c.name == question.from) mover.colliders.push_back(i);
  }
  const auto& found = mover.colliders;
  if (bodies > 1 || (bodies == 0 && found.size() > 1))
    throw InvalidValue("from", "the name of one body or collider",
                       std::to_string(bodies > 1 ? static_cast<std::size_t>(bodies) : found.size()) + " named \"" +
                           question.from + '"');
  const auto is_trigger = [&](std::uint32_t i) { return scene.colliders[i].trigger; };
  mover.colliders.erase(std::remove_if(mover.colliders.begin(), mover.colliders.end(), is_trigger),
                        mover.colliders.end());
  if (found.empty())
    throw InvalidValue("from", "the name of a body or collider that is no trigger", '"' + question.from + '"');
  mover.pivot = question.about ? *question.about : scene.colliders[found.front()].pose.translation;
  return mover;
}

std::vector<SceneHit> cast_scene(const Scene& scene, const SceneCast& question) {
  const Mover mover = find_mover(scene, question);
  return question.precision == Precision::double_precision ? cast_in<double>(scene, question, mover)
                                                           : cast_in<float>(scene, question, mover);
}

}  // namespace graze::io
