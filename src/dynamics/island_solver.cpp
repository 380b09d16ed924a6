#include "dynamics/island_solver.hpp"

#include <algorithm>

namespace graze {

namespace {

/// What a contact may sink under its load, of the smaller body's size, before the island takes more sub-steps.
template <class T>
constexpr T visible_sink = T(0.001);

/// A body is let fall by no more than this part of its size in a sub-step.
template <class T>
constexpr T fall_in_sub_step = T(0.02);

template <class T>
Mat3<T> in_world(const Vec3<T>& diagonal, const Quat<T>& rotation) {
  const Mat3<T> r = rotation_matrix(rotation);
  return r * Mat3<T>::diagonal(diagonal) * transposed(r);
}

/// An inertia that is infinite never gains angular momentum: any number will do.
template <class T>
Vec3<T> finite(const Vec3<T>& inertia, const Vec3<T>& inverse) {
  return {inverse.x > T(0) ? inertia.x : T(0), inverse.y > T(0) ? inertia.y : T(0),
          inverse.z > T(0) ? inertia.z : T(0)};
}

}  // namespace

template <class T>
void IslandSolver<T>::clear() {
  states_.clear();
  bodies_.clear();
  inertias_.clear();
  immovable_.clear();
  manifolds_.clear();
  points_.clear();
  joints_.clear();
  joined_.clear();
  joint_bodies_.clear();
  sub_steps_ = 1;
  colors_ = 0;
  residual_ = T(0);
}

template <class T>
std::uint32_t IslandSolver<T>::add(const IslandBody<T>& body) {
  SolverBody<T> b;
  b.linear = body.free.linear;
  b.angular = body.movable ? angular_velocity(body.free) : body.spin;
  b.center = body.free.center;
  b.rotation = body.free.rotation;
  b.first_center = body.first.center;
  b.first_rotation = body.first.rotation;
  b.moved = b.center - b.first_center;
  b.turned = b.rotation == b.first_rotation ? Quat<T>{} : b.rotation * conjugate(b.first_rotation);
  if (body.movable) b.mass = {body.inverse_mass, in_world(body.free.inverse_inertia, body.free.rotation)};
  states_.push_back(body);
  bodies_.push_back(b);
  inertias_.push_back(body.movable ? in_world(finite(body.inertia, body.free.inverse_inertia), body.free.rotation)
                                   : Mat3<T>{});
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

template <class T>
std::uint32_t IslandSolver<T>::add_once(std::uint32_t index, const IslandBody<T>& body) {
  const auto at = std::lower_bound(immovable_.begin(), immovable_.end(), index,
                                   [](const auto& known, std::uint32_t i) { return known.first < i; });
  if (at != immovable_.end() && at->first == index) return at->second;
  const std::uint32_t place = static_cast<std::uint32_t>(bodies_.size());
  immovable_.insert(at, {index, place});
  return add(body);
}

template <class T>
void IslandSolver<T>::add(const TouchingBodies<T>& touching, const ContactManifold<T>& manifold,
                          std::span<const SolverPoint<T>> points, T share) {
  manifolds_.push_back(prepare<T>(touching, bodies_, manifold, points, share, points_));
}

template <class T>
void IslandSolver<T>::add(JointInPlace<T>& joint, std::uint32_t a, std::uint32_t b) {
  joined_.push_back(&joint);
  joint_bodies_.emplace_back(a, b);
}

template <class T>
void IslandSolver<T>::choose_sub_steps(T step, T gravity, int least, int most) {
  // What a joint holds moves along a chord of its arc: off by the square of the sub-step, a quarter of it with two for
  // one.
  sub_steps_ = !joined_.empty() ? std::min(2 * least, most) : manifolds_.empty() ? 1 : least;
  const auto sinks = [&](const ManifoldRows<T>& m) {
    const T h = step / T(sub_steps_);
    if (gravity * h * h > fall_in_sub_step<T> * m.size) return true;
    T pressed(0);
    for (const PointRow<T>& r : std::span(points_).subspan(m.first_row, m.row_count)) pressed += r.impulse;
    return predicted_sink(pressed / step, m.inverse_mass, m.borne, h) > visible_sink<T> * m.size;
  };
  // Points have the impulse of the whole step until the number is known.
  while (sub_steps_ < most && std::any_of(manifolds_.begin(), manifolds_.end(), sinks)) sub_steps_ *= 2;
  const T part = T(1) / T(sub_steps_);
  for (PointRow<T>& r : points_) r.impulse *= part;
  for (ManifoldRows<T>& m : manifolds_) {
    m.friction_u *= part;
    m.friction_v *= part;
    m.twist *= part;
  }
}

template <class T>
void IslandSolver<T>::begin_sub_step(const SubStep<T>& time) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    IslandBody<T>& state = states_[i];
    SolverBody<T>& body = bodies_[i];
    if (!state.movable) {
      body.linear_before = body.linear;
      body.angular_before = body.angular;
      continue;
    }
    body.linear = state.free.linear;
    body.pressed = SolverBody<T>::Pressed::freely;
    body.angular = angular_velocity(state.free);
    body.linear_before = body.linear;
    body.angular_before = body.angular;
    const T h = time.h * state.share;
    body.linear = (body.linear + state.acceleration * h) * (T(1) / (T(1) + state.linear_damping * h));
    body.angular =
        (body.angular + body.mass.inertia * (state.torque * h)) * (T(1) / (T(1) + state.angular_damping * h));
  }
}

/// The angular momentum of what nothing turned stays bit for bit.
template <class T>
void IslandSolver<T>::move(const SubStep<T>& time) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    IslandBody<T>& state = states_[i];
    SolverBody<T>& body = bodies_[i];
    const T h = time.h * state.share;
    FreeBody<T> moving = state.free;
    moving.linear = body.moving_velocity();
    Vec3<T> gained{};
    if (state.movable) {
      if (!(body.angular == body.angular_before)) gained = inertias_[i] * (body.angular - body.angular_before);
      moving.angular_momentum += body.pressed == SolverBody<T>::Pressed::freely ? gained / T(2) : gained;
    } else {
      moving.inverse_inertia = {T(1), T(1), T(1)};
      moving.angular_momentum = state.spin;
    }
    advance(moving, Vec3<T>{}, h);
    state.free.center = body.center = moving.center;
    state.free.rotation = body.rotation = moving.rotation;
    body.moved = body.center - body.first_center;
    body.turned = body.rotation == body.first_rotation ? Quat<T>{} : body.rotation * conjugate(body.first_rotation);
    if (!state.movable) continue;
    state.free.linear = body.linear;
    state.free.angular_momentum += gained;
    body.linear_before = body.linear;
    body.angular = angular_velocity(state.free);
    body.angular_before = body.angular;
  }
}

/// What the pass without bias changed.
template <class T>
void IslandSolver<T>::end_sub_step() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!states_[i].movable) continue;
    states_[i].free.linear = bodies_[i].linear;
    if (!(bodies_[i].angular == bodies_[i].angular_before))
      states_[i].free.angular_momentum += inertias_[i] * (bodies_[i].angular - bodies_[i].angular_before);
  }
}

template <class T>
void IslandSolver<T>::solve_rows(const ContactStep<T>& step, bool bias) {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    joints_[j].solve(bodies_[joint_bodies_[j].first], bodies_[joint_bodies_[j].second], bias);
  for (ManifoldRows<T>& m : manifolds_)
    graze::solve<T>(m, std::span(points_).subspan(m.first_row, m.row_count), bodies_[m.a], bodies_[m.b], step, bias);
}

template <class T>
void IslandSolver<T>::note_pressed() {
  for (const auto& [a, b] : joint_bodies_)
    if (!manifolds_.empty()) bodies_[a].pressed = bodies_[b].pressed = SolverBody<T>::Pressed::tied;
  for (const ManifoldRows<T>& m : manifolds_)
    graze::note_pressed<T>(m, std::span(points_).subspan(m.first_row, m.row_count), bodies_[m.a], bodies_[m.b]);
}

template <class T>
void IslandSolver<T>::solve(T step, T gravity) {
  const T h = step / T(sub_steps_);
  const SubStep<T> time{h, T(1) / h, step, manifolds_.empty()};
  const ContactStep<T> contact = contact_step(time, gravity);
  joints_.resize(joined_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].prepare(*joined_[j], time);
  for (int s = 0; s < sub_steps_; ++s) {
    begin_sub_step(time);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      SolverBody<T>&a = bodies_[joint_bodies_[j].first], &b = bodies_[joint_bodies_[j].second];
      joints_[j].refresh(a, b);
      joints_[j].warm_start(a, b);
    }
    for (const ManifoldRows<T>& m : manifolds_)
      warm_start<T>(m, std::span(points_).subspan(m.first_row, m.row_count), bodies_[m.a], bodies_[m.b]);
    solve_rows(contact, true);
    note_pressed();
    move(time);
    solve_rows(contact, false);
    end_sub_step();
  }
  find_residual();
}

template <class T>
void IslandSolver<T>::find_residual() {
  for (const ManifoldRows<T>& m : manifolds_)
    for (const PointRow<T>& r : std::span(points_).subspan(m.first_row, m.row_count)) {
      if (!(r.impulse > T(0))) continue;
      const SolverBody<T>&a = bodies_[m.a], &b = bodies_[m.b];
      const T speed = dot(b.linear - a.linear, m.normal) + dot(r.turn_b, b.angular) - dot(r.turn_a, a.angular);
      residual_ = greatest(residual_, -speed);
    }
}

template <class T>
void IslandSolver<T>::store(std::span<SolverPoint<T>> points) {
  for (const ManifoldRows<T>& m : manifolds_)
    graze::store<T>(m, std::span(points_).subspan(m.first_row, m.row_count), points.subspan(m.first_point, m.row_count),
                    T(sub_steps_));
  for (const JointRows<T>& j : joints_) j.store();
}

template class IslandSolver<float>;
template class IslandSolver<double>;

}  // namespace graze
