// A capture played again.
#include <istream>

#include "capture/play.hpp"
#include "capture/shape_bytes.hpp"
#include "capture/states.hpp"
#include "graze/error.hpp"

namespace graze {

using capture::Call;
using capture::Damaged;
using capture::Outcome;
using capture::Reading;

namespace {

/// A difference from the run that was captured.
struct Other {
  std::string what;
};

/// The shapes of a capture, and the frame that is read.
template <class T, class Space>
class Player {
  using Shape = typename Space::Shape;

 public:
  explicit Player(std::uint16_t version) : call_count_(capture::call_count(version)) {}

  template <class V>
  V read() {
    V value{};
    (*io_)(value);
    if constexpr (std::is_same_v<V, BodyId>) body_ = value;
    return value;
  }
  /// Reads the calls of a frame, `one(call)` each.
  template <class One>
  void frame(std::string_view bytes, std::size_t& calls, const One& one) {
    Reading io(bytes);
    io_ = &io;
    while (io.left() > 0) {
      const auto number = read<std::uint8_t>();
      if (number >= call_count_) throw Damaged{"a call that there is not"};
      const Call call = static_cast<Call>(number);
      ++calls;
      body_.reset();
      try {
        if (call == Call::shape)
          shapes_.push_back(capture::read_shape<Shape>(io));
        else
          one(call);
      } catch (const InvalidValue& e) {
        throw Other{std::string(name_of(call)) + " is refused: " + e.what()};
      } catch (const Other& other) {
        throw Other{std::string(name_of(call)) + ": " + other.what};
      }
    }
  }
  const Shape& shape() {
    const auto number = read<std::uint32_t>();
    if (number >= shapes_.size()) throw Damaged{"a shape that was not said before"};
    return shapes_[number];
  }
  Body<T, Space> body() {
    Body<T, Space> body{shape()};
    (*io_)(body);
    return body;
  }
  template <class Id>
  void check(Id id) {
    if (!(read<Id>() == id)) throw Other{"another handle"};
  }
  void check(const World<T, Space>& world) {
    if (const char* what = capture::difference(read<Outcome>(), capture::outcome_of(world))) throw Other{what};
  }

  /// Gives a body its name from here on.
  void name(const World<T, Space>& world, BodyNames& names) {
    const auto id = read<BodyId>();
    auto name = read<std::string>();
    if (!world.bodies().contains(id)) throw Other{"no such body"};
    names.set(id, std::move(name));
  }
  /// The body of the call that was read last.
  std::optional<BodyId> about() const { return body_; }

 private:
  const std::size_t call_count_;
  Reading* io_ = nullptr;
  std::vector<Shape> shapes_;
  std::optional<BodyId> body_;
};

template <class T, class Space>
const World<T, Space>& world_of(const World<T, Space>& world) {
  return world;
}
template <class T, class Space>
const World<T, Space>& world_of(const Simulation<T, Space>& simulation) {
  return simulation.world();
}

template <class T, class Space>
void make(Call call, Player<T, Space>& from, Simulation<T, Space>& s, CapturedStates<T, Space>& states) {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  const auto id = [&] { return from.template read<BodyId>(); };
  const auto vec = [&] { return from.template read<Vec>(); };
  switch (call) {
  case Call::add_body: {
    const Body<T, Space> body = from.body();
    const auto dynamics = from.template read<typename Rigid<Space>::Dynamics>();
    const auto material = from.template read<graze::Material<T, Vec>>();
    return from.check(s.add(body, dynamics, material));
  }
  case Call::add_joint: return from.check(s.add(from.template read<Joint<T, Space>>()));
  case Call::remove_body: return s.remove(id());
  case Call::remove_joint: return s.remove(from.template read<JointId>());
  case Call::apply_impulse: {
    const BodyId body = id();
    const Vec impulse = vec();
    return s.apply_impulse(body, impulse, vec());
  }
  case Call::apply_angular_impulse: {
    const BodyId body = id();
    return s.apply_angular_impulse(body, from.template read<Turning>());
  }
  case Call::apply_force: {
    const BodyId body = id();
    return s.apply_force(body, vec());
  }
  case Call::apply_torque: {
    const BodyId body = id();
    return s.apply_torque(body, from.template read<Turning>());
  }
  case Call::set_velocity: {
    const BodyId body = id();
    return s.set_velocity(body, from.template read<typename Space::Velocity>());
  }
  case Call::set_pose: {
    const BodyId body = id();
    return s.set_pose(body, from.template read<typename Space::Pose>());
  }
  case Call::move_to: {
    const BodyId body = id();
    const auto pose = from.template read<typename Space::Pose>();
    return s.move_to(body, pose, from.template read<T>());
  }
  case Call::set_material: {
    const BodyId body = id();
    return s.set_material(body, from.template read<graze::Material<T, Vec>>());
  }
  case Call::set_materials: {
    const BodyId body = id();
    const auto pieces = from.template read<PieceMaterials<T, Space>>();
    return s.set_materials(body, pieces.materials, pieces.of_piece);
  }
  case Call::set_joint: {
    const auto joint = from.template read<JointId>();
    return s.set_joint(joint, from.template read<Joint<T, Space>>());
  }
  case Call::set_filter: {
    const BodyId body = id();
    return s.set_filter(body, from.template read<Filter>());
  }
  case Call::wake: return s.wake(id());
  case Call::set_gravity: return s.set_gravity(vec());
  case Call::save: return states.save(from.template read<std::uint8_t>(), s);
  case Call::restore: return states.restore(from.template read<std::uint8_t>(), s);
  case Call::step: s.step(from.template read<T>()); return from.check(s.world());
  default: throw Damaged{"a call that a simulation has not"};
  }
}

template <class T, class Space>
void make(Call call, Player<T, Space>& from, World<T, Space>& w, CapturedStates<T, Space>&) {
  const auto id = [&] { return from.template read<BodyId>(); };
  switch (call) {
  case Call::add_body: return from.check(w.add(from.body()));
  case Call::remove_body: return w.remove(id());
  case Call::move: {
    const BodyId body = id();
    return w.move(body, from.template read<typename Space::Pose>());
  }
  case Call::move_with_velocity: {
    const BodyId body = id();
    const auto pose = from.template read<typename Space::Pose>();
    const auto linear = from.template read<typename Space::Vec>();
    return w.move(body, pose, linear, from.template read<typename Space::Turning>());
  }
  case Call::set_shape: {
    const BodyId body = id();
    return w.set_shape(body, from.shape());
  }
  case Call::set_filter: {
    const BodyId body = id();
    return w.set_filter(body, from.template read<Filter>());
  }
  case Call::set_fast: {
    const BodyId body = id();
    return w.set_fast(body, from.template read<bool>());
  }
  case Call::update: w.update(from.template read<T>()); return from.check(w);
  case Call::find_impacts: w.find_impacts(from.template read<T>()); return from.check(w);
  default: throw Damaged{"a call that a world has not"};
  }
}

/// Plays the frames of a capture. Settings that a constructor refuses were not those of a run.
template <class T, class Space, class Played, class Settings>
void play_frames(capture::FrameReader& frames, std::uint16_t version, ReplayReport& report, Executor* executor,
                 const ReplayFunction& each) {
  const std::optional<std::string> first = frames.next();
  if (!first) return;
  std::unique_ptr<Played> played;
  Player<T, Space> player(version);
  CapturedStates<T, Space> states;
  try {
    Settings settings;
    Reading io(*first);
    io.has_warm_start = version >= capture::warm_start_version;
    io(settings);
    if (io.left() > 0) throw Damaged{"more than its settings"};
    played = std::make_unique<Played>(settings, executor);
  } catch (const Damaged& damage) {
    frames.fail(damage.why);
  } catch (const InvalidValue& e) {
    frames.fail(e.what());
  }
  while (const std::optional<std::string> bytes = frames.next()) {
    std::size_t calls = 0;
    try {
      player.frame(*bytes, calls, [&](Call call) {
        if (call == Call::set_name)
          player.name(world_of(*played), report.names);
        else
          make(call, player, *played, states);
      });
    } catch (const Damaged& damage) {
      frames.fail(damage.why);
    } catch (const Other& other) {
      report.difference = ReplayDifference{report.frames + 1, calls, other.what, player.about()};
      return;
    }
    report.calls += calls;
    ++report.frames;
    if (each) each(report.frames, static_cast<const Played*>(played.get()), report.names);
  }
}

}  // namespace

template <class T>
ReplayReport capture::play(FrameReader& frames, const Head& head, const ReplayFunction& each, Executor* executor) {
  ReplayReport report;
  report.simulation = is_simulation(head.kind);
  report.plane = is_of_plane(head.kind);
  report.single = head.single;
  const auto of = [&]<class Space>(Space) {
    if (report.simulation)
      play_frames<T, Space, Simulation<T, Space>, SimulationSettings<T, Space>>(frames, head.version, report, executor,
                                                                                each);
    else
      play_frames<T, Space, World<T, Space>, WorldSettings<T>>(frames, head.version, report, executor, each);
  };
  report.plane ? of(plane::Space<T>{}) : of(Space<T>{});
  report.cut = frames.cut();
  return report;
}

#define GRAZE_PLAY(T)                                                                                                  \
  template ReplayReport capture::play<T>(capture::FrameReader&, const capture::Head&, const ReplayFunction&, Executor*);
GRAZE_PLAY(float)
GRAZE_PLAY(double)
#undef GRAZE_PLAY

ReplayReport replay(std::istream& in, const std::string& name, const ReplayFunction& each, Executor* executor) {
  const auto from = [&](char* to, std::size_t count) {
    in.read(to, static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(in.gcount());
  };
  capture::FrameReader frames(from, name);
  const capture::Head head = frames.head();
  return head.single ? capture::play<float>(frames, head, each, executor)
                     : capture::play<double>(frames, head, each, executor);
}

}  // namespace graze
