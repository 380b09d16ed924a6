// Captures: the calls made to a world or a simulation, in a file that replays to the same bits.
//
// A bug that shows once in ten minutes is found by stepping through the frame in which it shows, as often as one likes.
// `CapturedSimulation` and `CapturedWorld` take the place of a `Simulation` or a `World`; each call that changes
// something is carried out and then written, and every step or update ends a frame with hashes of its results. `replay`
// makes the calls again and reports the first one whose results differ.
//
// Guarantee: a call refused by an exception is not written. A frame is in the stream when the call that ends it
// returns: a crash then loses at most the frame in which it happens. A replay on the same build gives the same bits, in
// another build or on another processor those that Graze gives there. Whatever bytes `replay` reads, its memory stays
// in proportion to them, and it ends with a report or with an `InvalidValue` that names the file and the frame. Writing
// costs the size of the calls' arguments and two hashes over the bodies that moved.
//
// In the plane, `plane::CapturedSimulation` and `plane::CapturedWorld` (`graze/plane/capture.hpp`) do the same.
//
// Shapes are built from the data in the file, so that a captured run and its replay have the same: a convex hull from
// its vertices alone, whose faces and vertices may therefore be numbered in another order than the caller's.
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

/// Receiver of a capture's bytes: called with the head, then with one frame at a time. Returns false if it cannot take
/// them.
using CaptureSink = std::function<bool(std::string_view bytes)>;

/// The names of a capture's bodies, removed bodies included.
class BodyNames {
 public:
  /// The name of a body; empty if it has none.
  std::string_view of(BodyId id) const {
    const auto found = names_.find(id);
    return found == names_.end() ? std::string_view() : found->second;
  }
  /// All names by handle, in the order of the handles' indices.
  const std::map<BodyId, std::string>& all() const { return names_; }
  /// Renames a body; an empty name takes the name away.
  void set(BodyId id, std::string name) {
    if (name.empty())
      names_.erase(id);
    else
      names_[id] = std::move(name);
  }

 private:
  std::map<BodyId, std::string> names_;
};

/// A simulation whose calls are written to a stream, which must outlive it, or handed to a sink; with neither it is an
/// ordinary simulation. `Simulation` documents the calls.
template <class T, class Space = graze::Space<T>>
class GRAZE_API CapturedSimulation {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Velocity = typename Space::Velocity;
  using Dynamics = typename Rigid<Space>::Dynamics;
  using Material = graze::Material<T, Vec>;

 public:
  /// A simulation that writes its calls to `out`. This and all calls of the class throw `InvalidValue` when the stream
  /// takes no more bytes.
  explicit CapturedSimulation(std::ostream* out, const SimulationSettings<T, Space>& settings = {},
                              Executor* executor = nullptr);
  /// A simulation that hands its frames to a sink. Throws as with a stream.
  explicit CapturedSimulation(const CaptureSink& sink, const SimulationSettings<T, Space>& settings = {},
                              Executor* executor = nullptr);
  ~CapturedSimulation();
  CapturedSimulation(const CapturedSimulation&) = delete;
  CapturedSimulation& operator=(const CapturedSimulation&) = delete;

  /// Adds a body. Throws `InvalidValue` also for a shape of the user's own, whose support function a file cannot hold.
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
  void set_materials(BodyId id, std::span<const Material> materials, std::span<const std::uint32_t> of_piece);
  void set_joint(JointId id, const Joint<T, Space>& joint);
  void set_filter(BodyId id, const Filter& filter);
  void wake(BodyId id);
  void set_gravity(const Vec& gravity);
  /// Names a body for a replay, from here on (`BodyNames`). The name is written to the capture only and has no
  /// influence on the run.
  void set_name(BodyId id, std::string_view name);

  /// Number of states that can be kept; few, because a replay keeps them as well.
  static constexpr std::size_t most_states = 16;
  /// Keeps the current state under `number`, in place of the state kept there before. Throws `InvalidValue` for a
  /// number that is not below `most_states`.
  void save(std::size_t number);
  /// Goes back to the state kept under `number`. Throws `InvalidValue` where none was kept, and where
  /// `Simulation::restore` does.
  void restore(std::size_t number);

  /// The simulation itself, for all queries.
  const Simulation<T, Space>& simulation() const { return simulation_; }
  /// The simulation's world.
  const World<T, Space>& world() const { return simulation_.world(); }

 private:
  Simulation<T, Space> simulation_;
  std::unique_ptr<CapturedStates<T, Space>> states_;
  std::unique_ptr<CaptureWriter<T, Space>> writer_;
};

/// A world whose calls are written to a stream or a sink, as `CapturedSimulation` writes those of a simulation.
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
  /// Names a body for a replay, from here on, as `CapturedSimulation::set_name` does.
  void set_name(BodyId id, std::string_view name);
  void update(T duration = T(0));
  void find_impacts(T duration);

  /// The captured world.
  const World<T, Space>& world() const { return world_; }

 private:
  World<T, Space> world_;
  std::unique_ptr<CaptureWriter<T, Space>> writer_;
};

/// The world or simulation that a replay drives, as it stands after a frame or after the calls behind the last frame.
using Replayed =
    std::variant<const Worldf*, const Worldd*, const Simulationf*, const Simulationd*, const plane::Worldf*,
                 const plane::Worldd*, const plane::Simulationf*, const plane::Simulationd*>;

/// The first place at which a replay differs from the captured run.
struct ReplayDifference {
  std::size_t frame;  ///< number of the frame, counted from 1
  std::size_t call;   ///< number of the call within the frame, counted from 1; the last call ends the frame
  std::string what;   ///< "step: other poses", "add: another handle", "remove: body: expected ..."
  /// The body concerned; none for a call that is not about a body.
  std::optional<BodyId> body = {};
};

/// The outcome of a replay.
struct ReplayReport {
  bool simulation = false;            ///< true for a simulation, false for a world
  bool plane = false;                 ///< true for the plane, false for space
  bool single = false;                ///< true for float, false for double
  std::size_t frames = 0, calls = 0;  ///< number of frames and calls that were replayed
  bool cut = false;                   ///< the stream ends within a frame, which was left out
  BodyNames names;                    ///< names of the bodies, as last set
  /// The first difference; none where all answers were equal.
  std::optional<ReplayDifference> difference;
};

/// Function called after every frame, with its number, the replayed object and the names of the bodies.
using ReplayFunction = std::function<void(std::size_t frame, const Replayed& played, const BodyNames& names)>;

/// Runs a capture again, to its end or to the first difference, and calls `each` after every frame. `name` appears in
/// messages. Throws `InvalidValue` for bytes that are no capture, of a version unknown to this library, or damaged:
/// with the frame, and where in the file it begins.
GRAZE_API ReplayReport replay(std::istream& in, const std::string& name, const ReplayFunction& each = {},
                              Executor* executor = nullptr);

}  // namespace graze
