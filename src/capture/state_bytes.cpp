#include "graze/state_bytes.hpp"

#include <cmath>

#include "capture/frames.hpp"
#include "dynamics/kept_state.hpp"
#include "graze/error.hpp"

namespace graze {
namespace capture {

// `Writing` and `Reading` find lists of fields by argument-dependent lookup in this namespace; an unnamed one is not
// searched.

/// The first bytes of a state. They hold the end of a line in two forms: a transfer that changes these has changed the
/// rest too.
constexpr std::string_view state_magic{"graze state\r\n\n", 14};
/// The version of the format. A reader takes its own version and the one before it, which lacks `warm_start` among the
/// settings and is the same otherwise.
constexpr std::uint16_t state_version = 3, oldest_state_version = 2;

template <class Io, class T>
void fields(Io& io, FreeBody<T>& body) {
  io(body.center, body.rotation, body.linear, body.angular_momentum, body.inverse_inertia);
}
template <class Io, class T>
void fields(Io& io, plane::FreeBody<T>& body) {
  io(body.center, body.rotation, body.linear, body.angular_momentum, body.inverse_inertia);
}
template <class Io, class T, class Space>
void fields(Io& io, BodyMass<T, Space>& mass) {
  io(mass.mass, mass.inverse_mass, mass.inertia, mass.inverse_inertia, mass.principal);
}
template <class Io, class T, class Space>
void fields(Io& io, std::shared_ptr<const PieceMaterials<T, Space>>& pieces) {
  PieceMaterials<T, Space> all;
  if (pieces) all = *pieces;
  io(all);
  if constexpr (std::is_same_v<Io, Reading>)
    if (!all.of_piece.empty()) pieces = std::make_shared<const PieceMaterials<T, Space>>(std::move(all));
}
template <class Io, class T, class Space>
void fields(Io& io, SimulatedBody<T, Space>& b) {
  io(b.free, b.spin, b.mass, b.material, b.pieces, b.gravity_factor, b.linear_damping, b.angular_damping, b.size,
     b.depth, b.radius, b.force, b.torque, b.rested, b.sub_steps, b.movable, b.moves, b.may_sleep, b.asleep, b.placed);
}
template <class Io, class T, class Space>
void fields(Io& io, JointPlace<T, Space>& place) {
  JointInPlace<T, Space>& joint = place.in_place;
  io(joint.joint, joint.a, joint.b, joint.frame_a, joint.frame_b);
  fields(io, joint.impulses, sizeof(T));
  io(joint.impulse_step, place.generation, place.alive);
}
template <class Io>
void fields(Io& io, ContactEvent& event) {
  io(event.kind, event.trigger, event.a, event.b);
}
template <class Io, class Turning>
void fields(Io& io, RollingImpulse<Turning>& rolling) {
  io(rolling.pair.a, rolling.pair.b, rolling.feature, rolling.impulse);
}
template <class Io, class T, class Space>
void fields(Io& io, StepReport<T, Space>& r) {
  // Counts are of 64 bits in the file, whatever they are in memory.
  for (std::size_t* count : {&r.awake, &r.islands, &r.contacts, &r.colors, &r.stopped}) {
    std::uint64_t number = *count;
    io(number);
    if constexpr (std::is_same_v<Io, Reading>) *count = static_cast<std::size_t>(number);
  }
  io(r.most_sub_steps, r.deepest, r.mean_depth, r.residual, r.kinetic_energy, r.potential_energy, r.momentum,
     r.angular_momentum);
}

/// The state's fields, in the order of the file.
template <class Io, class Kept>
void fields_of_state(Io& io, Kept& kept) {
  fields_of_all(io, kept.bodies);
  fields_of_all(io, kept.joints);
  fields_of_all(io, kept.ids);
  fields_of_all(io, kept.kinds);
  fields_of_all(io, kept.poses);
  fields_of_all(io, kept.found_at);
  fields_of_all(io, kept.linear);
  fields_of_all(io, kept.angular);
  fields_of_all(io, kept.impulses);
  fields_of_all(io, kept.rolling);
  fields_of_all(io, kept.events);
  io(kept.settings, kept.last, kept.last_step, kept.usual_step);
}

/// Whether all numbers of some values are finite; it takes them as `Writing` does.
class FiniteNumbers {
 public:
  bool all = true;

  template <class... Values>
  void operator()(Values&... values) {
    (one(values), ...);
  }

 private:
  template <class V>
  void one(V& value) {
    if constexpr (std::is_floating_point_v<V>)
      all = all && std::isfinite(value);
    else if constexpr (!std::is_integral_v<V> && !std::is_enum_v<V>)
      fields(*this, value);
  }
};

template <class T>
T square(const Quat<T>& q) {
  return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}
template <class T>
T square(const plane::Rot2<T>& r) {
  return r.cosine * r.cosine + r.sine * r.sine;
}
/// The part by which a rotation's square may differ from 1. Every step makes rotations unit vectors again, which leaves
/// a few roundings: in single precision a ten-thousandth of this. A forged one is further off, or does no harm.
constexpr double off_unit = 1e-3;

template <class Rotation>
bool is_unit(const Rotation& rotation) {
  return std::abs(static_cast<double>(square(rotation)) - 1) < off_unit;
}
template <class Pose>
bool is_sound(const Pose& pose) {
  return is_accepted(pose.translation) && is_unit(pose.rotation);
}
template <class T, class Space>
bool is_sound(SimulatedBody<T, Space>& b) {
  FiniteNumbers finite;
  finite(b.free, b.spin, b.force, b.torque, b.mass.principal, b.rested);
  return finite.all && is_accepted(b.free.center) && is_unit(b.free.rotation) && is_unit(b.mass.principal.rotation) &&
         is_accepted(angular_velocity(b.free)) && b.depth >= 0 && b.rested >= 0 && b.sub_steps >= 0 &&
         b.sub_steps <= 1024;
}

/// Throws `Damaged` for a state that no simulation was in, and `InvalidValue` for invalid settings and materials.
template <class Kept>
void check_state(Kept& kept) {
  const std::size_t count = kept.bodies.size();
  for (const std::size_t other :
       {kept.kinds.size(), kept.poses.size(), kept.found_at.size(), kept.linear.size(), kept.angular.size()})
    if (other != count) throw Damaged{"arrays of different lengths"};
  std::uint32_t least = 0;
  for (const BodyId id : kept.ids) {
    if (id.index < least || id.index >= count) throw Damaged{"bodies that are not in the order of their indices"};
    least = id.index + 1;
  }
  const auto indices = [](const ContactEvent& e) { return std::pair(e.a.index, e.b.index); };
  for (std::size_t i = 0; i < kept.events.size(); ++i) {
    if (i > 0 && indices(kept.events[i - 1]) > indices(kept.events[i]))
      throw Damaged{"events that are not in the order of their bodies"};
  }
  FiniteNumbers finite;
  for (std::size_t i = 0; i < count; ++i) {
    check(kept.bodies[i].material);
    if (const auto& pieces = kept.bodies[i].pieces) {
      for (const auto& material : pieces->materials) check(material);
      for (const std::uint32_t place : pieces->of_piece)
        if (place >= pieces->materials.size()) throw Damaged{"a piece with a material that is not there"};
    }
    if (!is_sound(kept.bodies[i]) || !is_sound(kept.poses[i]) || !is_sound(kept.found_at[i]) ||
        !is_accepted(kept.linear[i]) || !is_accepted(kept.angular[i]))
      throw Damaged{"a body with an invalid motion"};
  }
  for (auto& impulse : kept.impulses) finite(impulse);
  for (auto& rolling : kept.rolling) finite(rolling.impulse);
  for (auto& place : kept.joints)
    for (auto& impulse : place.in_place.impulses) finite(impulse, place.in_place.impulse_step);
  finite(kept.last_step, kept.usual_step);
  if (!finite.all) throw Damaged{"an impulse or a step that is not finite"};
  check(kept.settings);
}

template <class T, class Space>
std::string head(std::uint16_t of_version) {
  Writing head;
  head(of_version, std::is_same_v<Space, plane::Space<T>>, std::is_same_v<T, float>);
  return std::string(state_magic) + head.bytes;
}

}  // namespace capture

template <class T, class Space>
std::string state_bytes(const State<T, Space>& state) {
  if (!state.kept_) throw InvalidValue("state", "a state that a simulation saved", "an empty one");
  capture::Writing body, sum;
  capture::fields_of_state(body, *state.kept_);
  sum(capture::checksum(body.bytes));
  return capture::head<T, Space>(capture::state_version) + sum.bytes + body.bytes;
}

template <class T, class Space>
State<T, Space> read_state(std::string_view bytes) {
  if (!bytes.starts_with(capture::state_magic)) throw InvalidValue("state", "the bytes of a state", "other bytes");
  std::uint16_t version = capture::state_version;
  while (version >= capture::oldest_state_version && !bytes.starts_with(capture::head<T, Space>(version))) --version;
  if (version < capture::oldest_state_version)
    throw InvalidValue("state", "a state of version 2 or 3 of this precision and dimension", "another one");
  State<T, Space> state;
  state.kept_ = std::make_unique<typename State<T, Space>::Kept>();
  try {
    capture::Reading io(bytes.substr(capture::head<T, Space>(version).size()));
    io.has_warm_start = version > capture::oldest_state_version;
    std::uint64_t sum = 0;
    io(sum);
    if (sum != capture::checksum(bytes.substr(bytes.size() - io.left()))) throw capture::Damaged{"other bytes"};
    capture::fields_of_state(io, *state.kept_);
    if (io.left() > 0) throw capture::Damaged{"more bytes than it has values for"};
    capture::check_state(*state.kept_);
  } catch (const capture::Damaged& damaged) {
    throw InvalidValue("state", "the bytes that state_bytes wrote", damaged.why);
  } catch (const InvalidValue& e) {
    throw e.below("state");
  }
  return state;
}

#define GRAZE_STATE_BYTES(T, Space)                                                                                    \
  template std::string state_bytes(const State<T, Space>&);                                                            \
  template State<T, Space> read_state(std::string_view);
GRAZE_STATE_BYTES(float, Space<float>)
GRAZE_STATE_BYTES(double, Space<double>)
GRAZE_STATE_BYTES(float, plane::Space<float>)
GRAZE_STATE_BYTES(double, plane::Space<double>)
#undef GRAZE_STATE_BYTES

}  // namespace graze
