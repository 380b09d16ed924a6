// Values as bytes of a capture, and back: one list of fields a type serves both ways.
//
// Guarantee: numbers as their bits, the least significant byte first; values that were read lay within the bytes there,
// or `Damaged` is thrown. No count is trusted before so many bytes are there.
#pragma once

#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "dynamics/surfaces.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::capture {

static_assert(std::endian::native == std::endian::little, "captures are written as numbers lie in memory");

/// A frame whose bytes are not those of a capture.
struct Damaged {
  std::string why;
};

class Writing {
 public:
  std::string bytes;

  template <class... Values>
  void operator()(const Values&... values) {
    (one(values), ...);
  }

 private:
  template <class V>
  void one(const V& value) {
    if constexpr (std::is_same_v<V, bool>) {
      bytes += value ? '\1' : '\0';
    } else if constexpr (std::is_arithmetic_v<V>) {
      char raw[sizeof(V)];
      std::memcpy(raw, &value, sizeof(V));
      bytes.append(raw, sizeof(V));
    } else if constexpr (std::is_enum_v<V>) {
      one(static_cast<std::uint8_t>(value));
    } else {
      fields(*this, const_cast<V&>(value));  // which for writing only reads
    }
  }
};

class Reading {
 public:
  explicit Reading(std::string_view bytes) : left_(bytes) {}

  /// Whether settings of simulations hold `warm_start`. Those of older files do not: there it is on.
  bool has_warm_start = true;

  std::size_t left() const { return left_.size(); }
  /// Takes the next `count` bytes, or as many as are left.
  std::string_view take(std::size_t count) {
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(taken.size());
    return taken;
  }
  template <class... Values>
  void operator()(Values&... values) {
    (one(values), ...);
  }

 private:
  template <class V>
  void one(V& value) {
    if constexpr (std::is_same_v<V, bool>) {
      std::uint8_t byte = 0;
      one(byte);
      if (byte > 1) throw Damaged{"a truth value that is neither"};
      value = byte == 1;
    } else if constexpr (std::is_arithmetic_v<V>) {
      if (left_.size() < sizeof(V)) throw Damaged{"it ends within a number"};
      std::memcpy(&value, left_.data(), sizeof(V));
      left_.remove_prefix(sizeof(V));
    } else if constexpr (std::is_enum_v<V>) {
      std::uint8_t number = 0;
      one(number);
      if (number > last_of(V{})) throw Damaged{"a choice that there is not"};
      value = static_cast<V>(number);
    } else {
      fields(*this, value);
    }
  }
  static constexpr std::uint8_t last_of(Combine) { return static_cast<std::uint8_t>(Combine::multiply); }
  static constexpr std::uint8_t last_of(JointSpace) { return static_cast<std::uint8_t>(JointSpace::angular); }
  static constexpr std::uint8_t last_of(DriveMode) { return static_cast<std::uint8_t>(DriveMode::acceleration); }
  static constexpr std::uint8_t last_of(EventKind) { return static_cast<std::uint8_t>(EventKind::end); }
  static constexpr std::uint8_t last_of(Sides) { return static_cast<std::uint8_t>(Sides::front); }
  static constexpr std::uint8_t last_of(plane::ChainSides) {
    return static_cast<std::uint8_t>(plane::ChainSides::both);
  }

  std::string_view left_;
};

/// Writes a count and so many values, each of at least `least_bytes`.
template <class V>
void fields(Writing& io, std::vector<V>& values, std::size_t) {
  io(std::uint64_t{values.size()});
  for (const V& value : values) io(value);
}
template <class V>
void fields(Reading& io, std::vector<V>& values, std::size_t least_bytes) {
  std::uint64_t count = 0;
  io(count);
  if (count > io.left() / least_bytes) throw Damaged{"more values than it has bytes for"};
  values.resize(static_cast<std::size_t>(count));
  for (V& value : values) io(value);
}

/// The bytes that a value takes at least in the file.
template <class V>
std::size_t bytes_of() {
  Writing bytes;
  bytes(V{});
  return bytes.bytes.size();
}
template <class Io, class V>
void fields_of_all(Io& io, std::vector<V>& values) {
  fields(io, values, bytes_of<V>());
}

/// Writes a count and so many bytes.
inline void fields(Writing& io, std::string& text) {
  io(std::uint64_t{text.size()});
  io.bytes += text;
}
inline void fields(Reading& io, std::string& text) {
  std::uint64_t count = 0;
  io(count);
  if (count > io.left()) throw Damaged{"a text longer than its frame"};
  text = io.take(static_cast<std::size_t>(count));
}

template <class Io, class V>
void fields(Io& io, std::optional<V>& value) {
  bool there = value.has_value();
  io(there);
  if (there && !value) value.emplace();
  if (there) io(*value);
}
template <class Io, class T>
void fields(Io& io, Vec3<T>& v) {
  io(v.x, v.y, v.z);
}
template <class Io, class T>
void fields(Io& io, plane::Vec2<T>& v) {
  io(v.x, v.y);
}
template <class Io, class T>
void fields(Io& io, plane::Rot2<T>& rotation) {
  io(rotation.cosine, rotation.sine);
}
template <class Io, class T>
void fields(Io& io, plane::Pose2<T>& pose) {
  io(pose.translation, pose.rotation);
}
template <class Io, class T>
void fields(Io& io, plane::Velocity<T>& velocity) {
  io(velocity.linear, velocity.angular);
}
template <class Io, class T>
void fields(Io& io, Quat<T>& q) {
  io(q.x, q.y, q.z, q.w);
}
template <class Io, class T>
void fields(Io& io, Pose<T>& pose) {
  io(pose.translation, pose.rotation);
}
template <class Io, class T>
void fields(Io& io, Velocity<T>& velocity) {
  io(velocity.linear, velocity.angular);
}
template <class Io>
void fields(Io& io, BodyId& id) {
  io(id.index, id.generation);
}
template <class Io>
void fields(Io& io, JointId& id) {
  io(id.index, id.generation);
}
template <class Io>
void fields(Io& io, Filter& filter) {
  io(filter.category, filter.mask, filter.group);
}
template <class Io, class T, class Vec>
void fields(Io& io, Material<T, Vec>& m) {
  io(m.static_friction, m.dynamic_friction, m.restitution, m.rolling_friction, m.friction_combine,
     m.restitution_combine, m.surface_velocity);
}
template <class Io, class T, class Space>
void fields(Io& io, PieceMaterials<T, Space>& pieces) {
  fields_of_all(io, pieces.materials);
  fields_of_all(io, pieces.of_piece);
}
template <class Io, class T>
void fields(Io& io, Dynamics<T>& d) {
  io(d.mass, d.center_of_mass, d.inertia_diagonal, d.inertia_orientation, d.density, d.gravity_factor, d.linear_damping,
     d.angular_damping, d.kinematic, d.may_sleep);
}
template <class Io, class T>
void fields(Io& io, plane::Dynamics<T>& d) {
  io(d.mass, d.center_of_mass, d.inertia, d.density, d.gravity_factor, d.linear_damping, d.angular_damping, d.kinematic,
     d.may_sleep);
}
template <class Io, class T>
void fields(Io& io, JointLimit<T>& limit) {
  io(limit.space, limit.axes[0], limit.axes[1], limit.axes[2], limit.min, limit.max, limit.stiffness, limit.damping);
}
template <class Io, class T>
void fields(Io& io, JointDrive<T>& drive) {
  io(drive.space, drive.mode, drive.axis, drive.position_target, drive.velocity_target, drive.stiffness, drive.damping,
     drive.max_force);
}
template <class Io, class T, class Space>
void fields(Io& io, Joint<T, Space>& joint) {
  io(joint.a, joint.b, joint.frame_a, joint.frame_b);
  fields(io, joint.limits, 8);
  fields(io, joint.drives, 8);
  io(joint.enable_collision);
}
template <class Io, class T, class Space>
void fields(Io& io, SimulationSettings<T, Space>& s) {
  io(s.gravity, s.sub_steps, s.most_sub_steps, s.sleep, s.continuous, s.longest_step);
  if constexpr (std::is_same_v<Io, Reading>)
    if (!io.has_warm_start) return;
  io(s.warm_start);
}

/// The settings but for the callback that decides about pairs, which is a function.
template <class Io, class T>
void fields(Io& io, WorldSettings<T>& s) {
  io(s.margin);
  std::uint64_t points = s.points_per_pair.value_or(0);
  io(points);
  if (points != 0) s.points_per_pair = static_cast<std::size_t>(points);
}
/// A body but for its shape.
template <class Io, class T, class Space>
void fields(Io& io, Body<T, Space>& b) {
  io(b.pose, b.linear, b.angular, b.filter, b.fixed, b.trigger, b.fast);
}

}  // namespace graze::capture
