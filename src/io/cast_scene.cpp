#include "graze/io/cast_scene.hpp"

#include <algorithm>

#include "io/scene_collide.hpp"

namespace graze::io {

namespace {

template <class T>
using InSpace = graze::Space<T>;
template <class T>
using InPlane = plane::Space<T>;

template <class T>
Velocity<T> velocity_in(InSpace<T>, const Velocity<double>& v) {
  return {validate::point(converted<T>(v.linear), "motion"), validate::point(converted<T>(v.angular), "spin")};
}
template <class T>
plane::Velocity<T> velocity_in(InPlane<T>, const Velocity<double>& v) {
  const Vec3<T> linear = validate::point(converted<T>(v.linear), "motion"),
                angular = validate::point(converted<T>(v.angular), "spin");
  if (v.linear.z != 0) validate::fail("motion[2]", "0 in the plane", v.linear.z);
  for (int i = 0; i < 2; ++i)
    if (v.angular[i] != 0) validate::fail("spin[" + std::to_string(i) + "]", "0 in the plane", v.angular[i]);
  return {{linear.x, linear.y}, angular.z};
}

/// The place of a vector of the question among those of the scene.
Vec3d place_in(InSpace<double>, const Vec3d& v) { return v; }
plane::Vec2d place_in(InPlane<double>, const Vec3d& v) { return {v.x, v.y}; }

bool is_half_space(const Shaped& shape) { return shape.as<HalfSpace<double>>() != nullptr; }
bool is_half_space(const plane::Shaped& shape) { return shape.as<plane::HalfPlane<double>>() != nullptr; }

/// Makes a body of the collider at `place` turn about `pivot`: as the one child of a compound whose origin lies there.
template <class T>
void turn_about(graze::Body<T>& body, Posed place, const Vec3d& pivot) {
  place.translation = place.translation - pivot;
  body.shape = Compound<T>(std::vector<Placed<T>>{{body.shape, converted<T>(place)}});
  body.pose = {converted<T>(pivot), {}};
}
template <class T>
void turn_about(plane::Body<T>& body, plane::Pose2d place, const plane::Vec2d& pivot) {
  place.translation = place.translation - pivot;
  body.shape = plane::Compound<T>(std::vector<plane::Placed<T>>{{body.shape, plane::converted<T>(place)}});
  body.pose = {plane::converted<T>(pivot), {}};
}

template <class T, template <class> class In, class AnyScene>
std::vector<SceneHit> cast_in(const AnyScene& scene, const SceneCast& question, const Mover& mover) {
  const auto velocity = velocity_in<T>(In<T>{}, question.velocity);
  const T duration = validate::extent(static_cast<T>(question.duration), "duration");
  validate::point(converted<T>(mover.pivot), "about");
  const auto pivot = place_in(In<double>{}, mover.pivot);
  const bool spins = question.velocity.angular != Vec3d{};
  std::vector<SceneHit> hits;
  for (const std::uint32_t i : mover.colliders) {
    const auto& own = scene.colliders[i];
    if (spins && is_half_space(own.shape)) throw InvalidValue(own.name, "no spin of a half-space", "one");
    auto body = in_world<T>(scene, own, false);
    if (spins && !(own.pose.translation == pivot)) turn_about(body, own.pose, pivot);
    for (std::uint32_t j = 0; j < scene.colliders.size(); ++j) {
      const auto& other = scene.colliders[j];
      if (other.trigger || other.body == own.body || !may_collide(own.filter, other.filter)) continue;
      const auto there = in_world<T>(scene, other, true);
      const auto hit =
          In<T>::cast(body.shape, body.pose, velocity, there.shape, there.pose, {}, duration, question.options);
      if (hit)
        hits.push_back({static_cast<double>(hit->t), i, j, in_space(hit->point), in_space(hit->normal),
                        static_cast<double>(hit->depth), hit->status});
    }
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const SceneHit& a, const SceneHit& b) { return a.t != b.t ? a.t < b.t : a.depth > b.depth; });
  return hits;
}

template <class AnyScene>
Mover mover_of(const AnyScene& scene, const SceneCast& question) {
  Mover mover;
  const auto bodies = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const auto& body) { return body.name == question.from; });
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const auto& c = scene.colliders[i];
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
  mover.pivot = question.about ? *question.about : in_space(scene.colliders[found.front()].pose.translation);
  return mover;
}

template <template <class> class In, class AnyScene>
std::vector<SceneHit> cast_any(const AnyScene& scene, const SceneCast& question) {
  const Mover mover = mover_of(scene, question);
  return question.precision == Precision::double_precision ? cast_in<double, In>(scene, question, mover)
                                                           : cast_in<float, In>(scene, question, mover);
}

}  // namespace

Posed Mover::pose_at(const Posed& pose, const Velocity<double>& velocity, double t) const {
  return compose(graze::pose_at(Posed{pivot, {}}, velocity, t), Posed{pose.translation - pivot, pose.rotation});
}

Mover find_mover(const Scene& scene, const SceneCast& question) { return mover_of(scene, question); }

std::vector<SceneHit> cast_scene(const Scene& scene, const SceneCast& question) {
  return cast_any<InSpace>(scene, question);
}
std::vector<SceneHit> cast_scene(const PlaneScene& scene, const SceneCast& question) {
  if (question.about && question.about->z != 0) validate::fail("about[2]", "0 in the plane", question.about->z);
  return cast_any<InPlane>(scene, question);
}

}  // namespace graze::io
