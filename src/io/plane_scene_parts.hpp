// The parts that both readers of plane scenes share: bodies by name, filters by the names of collision systems.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graze/io/plane_scene.hpp"

namespace graze::io {

/// A scene that grows collider by collider.
class PlaneSceneBuilder {
 public:
  explicit PlaneSceneBuilder(std::string source) { scene_.source = std::move(source); }

  /// A collider but for its shape and place. `collide_with` and `not_collide_with` exclude each other.
  struct Role {
    std::string body;  ///< a name that several colliders may share; empty for a body of its own
    MotionType motion = MotionType::fixed;
    bool trigger = false;
    std::vector<std::string> systems, collide_with, not_collide_with;
    PlaneMotion physics;  ///< the same of all that is one body
  };

  /// Adds a collider, to a body that is there or else to that of its role, and returns the body. Throws `InvalidValue`
  /// for more collision systems than bits, or for a body that moves in two ways.
  std::uint32_t add(std::string name, const Role& role, plane::Shaped shape, const plane::Pose2d& pose,
                    std::optional<std::uint32_t> body = {});
  void set_gravity(const plane::Vec2d& gravity) { scene_.gravity = gravity; }
  void note(std::string sentence) { scene_.notices.push_back(std::move(sentence)); }
  std::size_t size() const { return scene_.colliders.size(); }
  PlaneScene take() { return std::move(scene_); }

 private:
  std::uint32_t body_of(const std::string& name, const Role& role);
  std::uint64_t bits_of(const std::vector<std::string>& names);

  PlaneScene scene_;
  std::map<std::string, std::uint32_t> bodies_, systems_;
};

/// The motion of that name: static, kinematic or dynamic; or nothing.
std::optional<MotionType> motion_named(std::string_view name);

}  // namespace graze::io
