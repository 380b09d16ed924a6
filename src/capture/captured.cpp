#include "graze/capture.hpp"

#include <unordered_map>

#include "capture/frames.hpp"
#include "capture/shape_bytes.hpp"
#include "capture/states.hpp"
#include "graze/error.hpp"

namespace graze {

using capture::Call;

/// Gathers the calls of a frame and writes it when it ends.
template <class T, class Space>
class CaptureWriter {
  using Shape = typename Space::Shape;

 public:
  template <class Settings>
  CaptureWriter(const CaptureSink& sink, capture::Kind kind, const Settings& settings) : sink_(sink) {
    capture::write_head(sink_, kind, std::is_same_v<T, float>);
    frame_(settings);
    write();
  }
  CaptureWriter(const CaptureWriter&) = delete;
  CaptureWriter& operator=(const CaptureWriter&) = delete;
  /// Writes the calls behind the last frame, without its end. A stream that takes no more has reported so before.
  ~CaptureWriter() {
    try {
      if (!frame_.bytes.empty()) write();
    } catch (const InvalidValue&) {
    }
  }

  /// The shape that the file holds for this one, and its number.
  std::pair<Shape, std::uint32_t> shape(const Shape& shape) {
    capture::Writing bytes;
    capture::write_shape(bytes, shape);
    const auto [place, added] = numbers_.try_emplace(bytes.bytes, static_cast<std::uint32_t>(shapes_.size()));
    if (added) {
      capture::Reading again(place->first);
      shapes_.push_back(capture::read_shape<Shape>(again));
      frame_(Call::shape);
      frame_.bytes += place->first;
    }
    return {shapes_[place->second], place->second};
  }
  template <class... Values>
  void call(Call call, const Values&... values) {
    frame_(call, values...);
  }
  template <class... Values>
  void end(Call call, const World<T, Space>& world, const Values&... values) {
    frame_(call, values..., capture::outcome_of(world));
    write();
  }

 private:
  void write() {
    capture::write_frame(sink_, frame_.bytes);
    frame_.bytes.clear();
  }

  CaptureSink sink_;
  capture::Writing frame_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<Shape> shapes_;
};

namespace {

template <class T, class Space>
void check_body(const World<T, Space>& world, BodyId id) {
  if (!world.bodies().contains(id)) refuse_missing("body", "a body of the world", id);
}

}  // namespace

template <class T, class Space>
CapturedSimulation<T, Space>::CapturedSimulation(const CaptureSink& sink, const SimulationSettings<T, Space>& settings,
                                                 Executor* executor)
    : simulation_(settings, executor), states_(std::make_unique<CapturedStates<T, Space>>()) {
  if (sink) writer_ = std::make_unique<CaptureWriter<T, Space>>(sink, capture::kind_of<T, Space>(true), settings);
}
template <class T, class Space>
CapturedSimulation<T, Space>::CapturedSimulation(std::ostream* out, const SimulationSettings<T, Space>& settings,
                                                 Executor* executor)
    : CapturedSimulation(capture::sink_into(out), settings, executor) {}
template <class T, class Space>
CapturedSimulation<T, Space>::~CapturedSimulation() = default;

template <class T, class Space>
BodyId CapturedSimulation<T, Space>::add(Body<T, Space> body, const Dynamics& dynamics, const Material& material) {
  if (!writer_) return simulation_.add(std::move(body), dynamics, material);
  auto [shape, number] = writer_->shape(body.shape);
  body.shape = std::move(shape);
  const BodyId id = simulation_.add(body, dynamics, material);
  writer_->call(Call::add_body, number, body, dynamics, material, id);
  return id;
}
template <class T, class Space>
JointId CapturedSimulation<T, Space>::add(const Joint<T, Space>& joint) {
  const JointId id = simulation_.add(joint);
  if (writer_) writer_->call(Call::add_joint, joint, id);
  return id;
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_joint(JointId id, const Joint<T, Space>& joint) {
  simulation_.set_joint(id, joint);
  if (writer_) writer_->call(Call::set_joint, id, joint);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_filter(BodyId id, const Filter& filter) {
  simulation_.set_filter(id, filter);
  if (writer_) writer_->call(Call::set_filter, id, filter);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::remove(BodyId id) {
  simulation_.remove(id);
  if (writer_) writer_->call(Call::remove_body, id);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::remove(JointId id) {
  simulation_.remove(id);
  if (writer_) writer_->call(Call::remove_joint, id);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::apply_impulse(BodyId id, const Vec& impulse, const Vec& point) {
  simulation_.apply_impulse(id, impulse, point);
  if (writer_) writer_->call(Call::apply_impulse, id, impulse, point);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::apply_angular_impulse(BodyId id, const Turning& impulse) {
  simulation_.apply_angular_impulse(id, impulse);
  if (writer_) writer_->call(Call::apply_angular_impulse, id, impulse);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::apply_force(BodyId id, const Vec& force) {
  simulation_.apply_force(id, force);
  if (writer_) writer_->call(Call::apply_force, id, force);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::apply_torque(BodyId id, const Turning& torque) {
  simulation_.apply_torque(id, torque);
  if (writer_) writer_->call(Call::apply_torque, id, torque);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_velocity(BodyId id, const Velocity& velocity) {
  simulation_.set_velocity(id, velocity);
  if (writer_) writer_->call(Call::set_velocity, id, velocity);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_pose(BodyId id, const Pose& pose) {
  simulation_.set_pose(id, pose);
  if (writer_) writer_->call(Call::set_pose, id, pose);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::move_to(BodyId id, const Pose& pose, T dt) {
  simulation_.move_to(id, pose, dt);
  if (writer_) writer_->call(Call::move_to, id, pose, dt);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_material(BodyId id, const Material& material) {
  simulation_.set_material(id, material);
  if (writer_) writer_->call(Call::set_material, id, material);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_materials(BodyId id, std::span<const Material> materials,
                                                 std::span<const std::uint32_t> of_piece) {
  simulation_.set_materials(id, materials, of_piece);
  if (!writer_) return;
  const PieceMaterials<T, Space> pieces{{materials.begin(), materials.end()}, {of_piece.begin(), of_piece.end()}};
  writer_->call(Call::set_materials, id, pieces);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::wake(BodyId id) {
  simulation_.wake(id);
  if (writer_) writer_->call(Call::wake, id);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_gravity(const Vec& gravity) {
  simulation_.set_gravity(gravity);
  if (writer_) writer_->call(Call::set_gravity, gravity);
}
template <class T, class Space>
void CapturedSimulation<T, Space>::set_name(BodyId id, std::string_view name) {
  check_body(simulation_.world(), id);
  if (writer_) writer_->call(Call::set_name, id, std::string(name));
}
template <class T, class Space>
void CapturedSimulation<T, Space>::save(std::size_t number) {
  states_->save(number, simulation_);
  if (writer_) writer_->call(Call::save, static_cast<std::uint8_t>(number));
}
template <class T, class Space>
void CapturedSimulation<T, Space>::restore(std::size_t number) {
  states_->restore(number, simulation_);
  if (writer_) writer_->call(Call::restore, static_cast<std::uint8_t>(number));
}
template <class T, class Space>
void CapturedSimulation<T, Space>::step(T dt) {
  simulation_.step(dt);
  if (writer_) writer_->end(Call::step, simulation_.world(), dt);
}

template <class T, class Space>
CapturedWorld<T, Space>::CapturedWorld(std::ostream* out, const WorldSettings<T>& settings, Executor* executor)
    : CapturedWorld(capture::sink_into(out), settings, executor) {}
template <class T, class Space>
CapturedWorld<T, Space>::CapturedWorld(const CaptureSink& sink, const WorldSettings<T>& settings, Executor* executor)
    : world_(settings, executor) {
  if (settings.allow) throw InvalidValue("settings.allow", "none: a file cannot hold a function", "a function");
  if (sink) writer_ = std::make_unique<CaptureWriter<T, Space>>(sink, capture::kind_of<T, Space>(false), settings);
}
template <class T, class Space>
CapturedWorld<T, Space>::~CapturedWorld() = default;

template <class T, class Space>
BodyId CapturedWorld<T, Space>::add(Body<T, Space> body) {
  if (!writer_) return world_.add(std::move(body));
  auto [shape, number] = writer_->shape(body.shape);
  body.shape = std::move(shape);
  const BodyId id = world_.add(body);
  writer_->call(Call::add_body, number, body, id);
  return id;
}
template <class T, class Space>
void CapturedWorld<T, Space>::set_shape(BodyId id, Shape shape) {
  if (!writer_) return world_.set_shape(id, std::move(shape));
  auto [held, number] = writer_->shape(shape);
  world_.set_shape(id, std::move(held));
  writer_->call(Call::set_shape, id, number);
}
template <class T, class Space>
void CapturedWorld<T, Space>::remove(BodyId id) {
  world_.remove(id);
  if (writer_) writer_->call(Call::remove_body, id);
}
template <class T, class Space>
void CapturedWorld<T, Space>::move(BodyId id, const Pose& pose) {
  world_.move(id, pose);
  if (writer_) writer_->call(Call::move, id, pose);
}
template <class T, class Space>
void CapturedWorld<T, Space>::move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular) {
  world_.move(id, pose, linear, angular);
  if (writer_) writer_->call(Call::move_with_velocity, id, pose, linear, angular);
}
template <class T, class Space>
void CapturedWorld<T, Space>::set_filter(BodyId id, const Filter& filter) {
  world_.set_filter(id, filter);
  if (writer_) writer_->call(Call::set_filter, id, filter);
}
template <class T, class Space>
void CapturedWorld<T, Space>::set_fast(BodyId id, bool fast) {
  world_.set_fast(id, fast);
  if (writer_) writer_->call(Call::set_fast, id, fast);
}
template <class T, class Space>
void CapturedWorld<T, Space>::set_name(BodyId id, std::string_view name) {
  check_body(world_, id);
  if (writer_) writer_->call(Call::set_name, id, std::string(name));
}
template <class T, class Space>
void CapturedWorld<T, Space>::update(T duration) {
  world_.update(duration);
  if (writer_) writer_->end(Call::update, world_, duration);
}
template <class T, class Space>
void CapturedWorld<T, Space>::find_impacts(T duration) {
  world_.find_impacts(duration);
  if (writer_) writer_->end(Call::find_impacts, world_, duration);
}

template class CapturedSimulation<float>;
template class CapturedSimulation<double>;
template class CapturedSimulation<float, plane::Space<float>>;
template class CapturedSimulation<double, plane::Space<double>>;
template class CapturedWorld<float>;
template class CapturedWorld<double>;
template class CapturedWorld<float, plane::Space<float>>;
template class CapturedWorld<double, plane::Space<double>>;

}  // namespace graze
