// Captures: everything that a world or a simulation was told, in a file that runs again to the same bits.
//
// A bug that shows once in ten minutes is found by stepping through the frame in which it shows, as often as one likes.
// `CapturedSimulation` and `CapturedWorld` stand where a `Simulation` or a `World` would; each call that changes
// something is carried out and then written, and every step or update ends a frame with hashes of what came out.
// `replay` makes the calls again and says where it first comes to something else.
//
// Guarantee: what was refused by an exception is not written. A frame is in the stream when the call that ends it
// returns: whatever ends the program then loses at most the frame that it was in. A replay on the same build gives the
// same bits, in another build or on another processor those that Graze gives there. Whatever bytes `replay` gets, it
// takes no more memory than in proportion to them, and ends with a report or with an `InvalidValue` that names the file
// and the frame. Writing costs the size of what was said and two hashes over what moved.
//
// In the plane, `plane::CapturedSimulation` and `plane::CapturedWorld` (`graze/plane/capture.hpp`) do the same.
//
// Shapes are built from what the file holds of them, so that a captured run and its replay have the same: a convex
// hull from its vertices alone, whose faces and vertices may therefore be numbered in another order than the caller's.
#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"

namespace graze {

template <class T, class Space>
class CaptureWriter;
template <class T, class Space>
struct CapturedStates;

/// A function that takes the bytes of a capture, the head and then a frame at a call, and says whether it could.
using CaptureSink = std::function<bool(std::string_view bytes)>;

/// The names of the bodies of a capture, those that were removed among them.
class BodyNames {
 public:
  /// Empty for a body without one.
  std::string_view of(BodyId id) const {
    const auto found = names_.find(id);
    return found == names_.end() ? std::string_view() : found->second;
  }
  /// By handle, in the order of their indices.
  const std::map<BodyId, std::string>& all() const { return names_; }
  /// Another name for a body; an empty one is none.
  void set(BodyId id, std::string name) {
    if (name.empty())
      names_.erase(id);
    else
      names_[id] = std::move(name);
  }

 private:
  std::map<BodyId, std::string> names_;
};

/// A simulation whose calls are written to a stream, which must outlive it, or handed to a sink; with neither it is
/// only a simulation. What is said of the calls there holds here.
template <class T, class Space = graze::Space<T>>
class GRAZE_API CapturedSimulation {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Velocity = typename Space::Velocity;
  using Dynamics = typename Rigid<Space>::Dynamics;
  using Material = graze::Material<T, Vec>;

 public:
  /// Throws `InvalidValue` when the stream takes no more bytes, as all calls here do.
  explicit CapturedSimulation(std::ostream* out, const SimulationSettings<T, Space>& settings = {},
                              Executor* executor = nullptr);
  /// A simulation that hands its frames to a sink. Throws as with a stream.
  explicit CapturedSimulation(const CaptureSink& sink, const SimulationSettings<T, Space>& settings = {},
                              Executor* executor = nullptr);
  ~CapturedSimulation();
  CapturedSimulation(const CapturedSimulation&) = delete;
  CapturedSimulation& operator=(const CapturedSimulation&) = delete;

  /// Throws `InvalidValue` for a shape of the user's own, too: a file cannot hold its support function.
  BodyId add(Body<T, Space> body, const Dynamics& dynamics = {}, const Material& material = {});
  JointId add(const Joint<T, Space>& joint);
  void remove(BodyId id);
  void remove(JointId id);
  void step(T dt);
  void apply_impulse(BodyId id, const Vec& impulse, const Vec& point);
  void apply_angular_impulse(BodyId id, const Turning& impulse);
  void apply_force(BodyId id, const Vec& force);
  void apply_torque(BodyId id, const Turning& torque);
  void set_velocity(BodyId id, const Velocity& velocity);
  void set_pose(BodyId id, const Pose& pose);
  void move_to(BodyId id, const Pose& pose, T dt);
  void set_material(BodyId id, const Material& material);
  void wake(BodyId id);
  void set_gravity(const Vec& gravity);
  /// A name by which a replay calls the body from here on (`BodyNames`). It is written and not kept: the run stays as
  /// it is.
  void set_name(BodyId id, std::string_view name);

  /// Keeps the state as it is now under a number, instead of what was kept there. A replay keeps it as well, which is
  /// why there are so few numbers. Throws `InvalidValue` for one that there is not.
  static constexpr std::size_t most_states = 16;
  void save(std::size_t number);
  /// Goes back to what was kept. Throws `InvalidValue` where nothing was, and as `Simulation::restore`.
  void restore(std::size_t number);

  /// For everything that is asked.
  const Simulation<T, Space>& simulation() const { return simulation_; }
  /// What is recorded.
  const World<T, Space>& world() const { return simulation_.world(); }

 private:
  Simulation<T, Space> simulation_;
  std::unique_ptr<CapturedStates<T, Space>> states_;
  std::unique_ptr<CaptureWriter<T, Space>> writer_;
};

/// A world whose calls are written to a stream or a sink; as `CapturedSimulation`.
template <class T, class Space = graze::Space<T>>
class GRAZE_API CapturedWorld {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Shape = typename Space::Shape;

 public:
  /// Throws `InvalidValue` for settings with a last word on pairs (`allow`), which a file cannot hold.
  explicit CapturedWorld(std::ostream* out, const WorldSettings<T>& settings = {}, Executor* executor = nullptr);
  /// A world that hands its frames to a sink. Throws as with a stream.
  explicit CapturedWorld(const CaptureSink& sink, const WorldSettings<T>& settings = {}, Executor* executor = nullptr);
  ~CapturedWorld();
  CapturedWorld(const CapturedWorld&) = delete;
  CapturedWorld& operator=(const CapturedWorld&) = delete;

  BodyId add(Body<T, Space> body);
  void remove(BodyId id);
  void move(BodyId id, const Pose& pose);
  void move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular);
  void set_shape(BodyId id, Shape shape);
  void set_filter(BodyId id, const Filter& filter);
  void set_fast(BodyId id, bool fast);
  /// A name by which a replay calls the body from here on, as `CapturedSimulation::set_name`.
  void set_name(BodyId id, std::string_view name);
  void update(T duration = T(0));
  void find_impacts(T duration);

  /// What is recorded.
  const World<T, Space>& world() const { return world_; }

 private:
  World<T, Space> world_;
  std::unique_ptr<CaptureWriter<T, Space>> writer_;
};

/// What is captured, while it is played: after a frame, or after the calls behind the last one.
using Replayed =
    std::variant<const Worldf*, const Worldd*, const Simulationf*, const Simulationd*, const plane::Worldf*,
                 const plane::Worldd*, const plane::Simulationf*, const plane::Simulationd*>;

/// Where a replay first comes to something else than the run that was captured.
struct ReplayDifference {
  std::size_t frame;  ///< counted from 1
  std::size_t call;   ///< of the frame, counted from 1; the last one ends the frame
  std::string what;   ///< "step: other poses", "add: another handle", "remove: body: expected ..."
  /// The body that the call is about, if it is about one.
  std::optional<BodyId> body = {};
};

/// What a replay did.
struct ReplayReport {
  bool simulation = false;            ///< otherwise a world
  bool plane = false;                 ///< of the plane, otherwise of space
  bool single = false;                ///< float
  std::size_t frames = 0, calls = 0;  ///< how many frames and calls were replayed
  bool cut = false;                   ///< the stream ends within a frame, which was left out
  BodyNames names;                    ///< of the bodies, as they were called last
  /// Where an answer was first another one; none where all were the same.
  std::optional<ReplayDifference> difference;
};

/// Gets what is played after every frame, and what its bodies are called by then.
using ReplayFunction = std::function<void(std::size_t frame, const Replayed& played, const BodyNames& names)>;

/// Runs a capture again, to its end or to the first difference, and calls `each` with what is played after every frame.
/// `name` is for messages. Throws `InvalidValue` for bytes that are no capture, of a version that this library does not
/// know, or damaged: with the frame, and where in the file it begins.
GRAZE_API ReplayReport replay(std::istream& in, const std::string& name, const ReplayFunction& each = {},
                              Executor* executor = nullptr);

}  // namespace graze
