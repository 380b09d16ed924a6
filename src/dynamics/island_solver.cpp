#include "dynamics/island_solver.hpp"

#include <algorithm>

namespace graze {

namespace {

/// What a contact may sink under its load, of the smaller body's size, before the island takes more sub-steps.
template <class T>
constexpr T visible_sink = T(0.001);

/// Fewer sub-steps soften every contact, which then sinks: only where it sinks by less than this part of the above, and
/// by half at a time, for every change swings. Bodies that are new begin with the most.
template <class T>
constexpr T calm_sink = T(0.5);

/// A body is let fall by no more than this part of its size in a sub-step.
template <class T>
constexpr T fall_in_sub_step = T(0.02);

/// Contacts or bodies of an island that a task has: enough that to hand it out costs little beside.
constexpr std::size_t per_task = 64;

}  // namespace

template <class T, class Space>
void IslandSolver<T, Space>::clear(Executor* executor) {
  executor_ = executor;
  movable_.clear();
  contacts_.clear();
  added_.clear();
  touching_.clear();
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
  residual_ = T(0);
}

template <class T, class Space>
std::uint32_t IslandSolver<T, Space>::add(const IslandBody<T, Space>& body) {
  SolverBody<T, Space> b;
  b.linear = body.free.linear;
  b.angular = body.movable ? angular_velocity(body.free) : body.spin;
  b.center = body.free.center;
  b.rotation = body.free.rotation;
  b.first_center = body.first.center;
  b.first_rotation = body.first.rotation;
  b.moved = b.center - b.first_center;
  b.turned = b.rotation == b.first_rotation ? RotationIn<Space>{} : b.rotation * conjugate(b.first_rotation);
  if (body.movable) b.mass = {body.inverse_mass, in_world(body.free.inverse_inertia, body.free.rotation)};
  states_.push_back(body);
  movable_.push_back(body.movable ? 1 : 0);
  bodies_.push_back(b);
  inertias_.push_back(body.movable
                          ? in_world(finite_inertia(body.inertia, body.free.inverse_inertia), body.free.rotation)
                          : InertiaIn<Space>{});
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

template <class T, class Space>
std::uint32_t IslandSolver<T, Space>::add_once(std::uint32_t index, const IslandBody<T, Space>& body) {
  const auto at = std::lower_bound(immovable_.begin(), immovable_.end(), index,
                                   [](const auto& known, std::uint32_t i) { return known.first < i; });
  if (at != immovable_.end() && at->first == index) return at->second;
  const auto place = static_cast<std::uint32_t>(bodies_.size());
  immovable_.insert(at, {index, place});
  return add(body);
}

template <class T, class Space>
void IslandSolver<T, Space>::add(const TouchingBodies<T, Space>& touching,
                                 std::span<const ContactManifold<T, Space>> manifolds) {
  added_.push_back({touching, manifolds});
  touching_.push_back({touching.a, touching.b});
}

/// Calls `f` with each number below `count`, on the island's threads.
template <class T, class Space>
template <class F>
void IslandSolver<T, Space>::each(std::size_t count, const F& f) {
  if (!executor_ || count <= per_task) {
    for (std::size_t i = 0; i < count; ++i) f(i);
    return;
  }
  for_each_chunk(*executor_, count, per_task, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) f(i);
  });
}

/// Calls `f` with each contact and its bodies, one colour after the other. Of a body that nothing pushes, which several
/// contacts of a colour have, `f` is given a copy.
template <class T, class Space>
template <class F>
void IslandSolver<T, Space>::each_by_color(const F& f) {
  const auto with_bodies = [&](Contact& contact) {
    const auto [a, b] = std::pair(contact.touching.a, contact.touching.b);
    if (movable_[a] != 0 && movable_[b] != 0) {
      f(contact, bodies_[a], bodies_[b]);
    } else if (movable_[a] != 0) {
      SolverBody<T, Space> copy = bodies_[b];
      f(contact, bodies_[a], copy);
    } else {
      SolverBody<T, Space> copy = bodies_[a];
      f(contact, copy, bodies_[b]);
    }
  };
  for (const Coloring::Range& color : coloring_.colors()) {
    const auto contacts = std::span(contacts_).subspan(color.first, color.end - color.first);
    if (color.ordered)
      for (Contact& contact : contacts) with_bodies(contact);
    else
      each(contacts.size(), [&](std::size_t i) { with_bodies(contacts[i]); });
  }
}

template <class T, class Space>
void IslandSolver<T, Space>::prepare_contacts(std::span<const SolverPoint<T, Space>> points, T share) {
  coloring_.find(movable_, touching_);
  std::uint32_t manifolds = 0, rows = 0;
  for (const std::uint32_t i : coloring_.order()) {
    Contact& contact = contacts_.emplace_back(added_[i]);
    contact.first_manifold = manifolds;
    contact.first_row = rows;
    for (const ContactManifold<T, Space>& m : contact.found) {
      contact.manifold_count += m.point_count != 0 ? 1 : 0;
      rows += m.point_count;
    }
    manifolds += contact.manifold_count;
  }
  manifolds_.resize(manifolds);
  points_.resize(rows);
  each(contacts_.size(), [&](std::size_t i) {
    const Contact& contact = contacts_[i];
    std::uint32_t row = contact.first_row, manifold = contact.first_manifold;
    for (const ContactManifold<T, Space>& m : contact.found) {
      if (m.point_count == 0) continue;
      manifolds_[manifold++] =
          prepare<T, Space>(contact.touching, bodies_, m, points.subspan(m.first_point, m.point_count), share, row,
                            std::span(points_).subspan(row, m.point_count));
      row += m.point_count;
    }
  });
}

template <class T, class Space>
void IslandSolver<T, Space>::add(JointInPlace<T, Space>& joint, std::uint32_t a, std::uint32_t b) {
  joined_.push_back(&joint);
  joint_bodies_.emplace_back(a, b);
}

template <class T, class Space>
void IslandSolver<T, Space>::choose_sub_steps(T step, T gravity, int least, int most) {
  // What a joint holds moves along a chord of its arc: off by the square of the sub-step, a quarter of it with two for
  // one.
  sub_steps_ = !joined_.empty() ? std::min(2 * least, most) : manifolds_.empty() ? 1 : least;
  const auto sinks = [&](const ManifoldRows<T, Space>& m, int count, T share) {
    const T h = step / T(count);
    if (gravity * h * h > fall_in_sub_step<T> * m.size) return true;
    T pressed(0);
    for (const PointRow<T, Space>& r : std::span(points_).subspan(m.first_row, m.row_count)) pressed += r.impulse;
    return predicted_sink(pressed / step, m.inverse_mass, h) > share * visible_sink<T> * m.size;
  };
  // Points have the impulse of the whole step until the number is known.
  const auto too_few = [&](int count, T share) {
    return std::any_of(manifolds_.begin(), manifolds_.end(),
                       [&](const ManifoldRows<T, Space>& m) { return sinks(m, count, share); });
  };
  while (sub_steps_ < most && too_few(sub_steps_, T(1))) sub_steps_ *= 2;
  int last = 0;
  for (const IslandBody<T, Space>& body : states_)
    if (body.movable) last = std::max(last, body.sub_steps == 0 ? most : std::min(body.sub_steps, most));
  if (!manifolds_.empty() && sub_steps_ < last)
    sub_steps_ = std::max(sub_steps_, too_few(last / 2, calm_sink<T>) ? last : last / 2);
  const T part = T(1) / T(sub_steps_);
  for (PointRow<T, Space>& r : points_) r.impulse *= part;
  for (ManifoldRows<T, Space>& m : manifolds_) m.friction.scale(part);
}

template <class T, class Space>
void IslandSolver<T, Space>::begin_body(std::size_t i, const SubStep<T>& time) {
  IslandBody<T, Space>& state = states_[i];
  SolverBody<T, Space>& body = bodies_[i];
  if (!state.movable) {
    body.linear_before = body.linear;
    body.angular_before = body.angular;
    return;
  }
  body.linear = state.free.linear;
  body.pressed = SolverBody<T, Space>::Pressed::freely;
  body.angular = angular_velocity(state.free);
  body.linear_before = body.linear;
  body.angular_before = body.angular;
  const T h = time.h * state.share;
  body.linear = (body.linear + state.acceleration * h) * (T(1) / (T(1) + state.linear_damping * h));
  body.angular = (body.angular + body.mass.inertia * (state.torque * h)) * (T(1) / (T(1) + state.angular_damping * h));
}
template <class T, class Space>
void IslandSolver<T, Space>::begin_sub_step(const SubStep<T>& time) {
  each(bodies_.size(), [&](std::size_t i) { begin_body(i, time); });
}

/// The angular momentum of what nothing turned stays bit for bit.
template <class T, class Space>
void IslandSolver<T, Space>::move_body(std::size_t i, const SubStep<T>& time) {
  IslandBody<T, Space>& state = states_[i];
  SolverBody<T, Space>& body = bodies_[i];
  const T h = time.h * state.share;
  FreeBodyIn<Space> moving = state.free;
  moving.linear = body.moving_velocity();
  typename Space::Turning gained{};
  if (state.movable) {
    if (!(body.angular == body.angular_before)) gained = inertias_[i] * (body.angular - body.angular_before);
    moving.angular_momentum += body.pressed == SolverBody<T, Space>::Pressed::freely ? gained / T(2) : gained;
  } else {
    moving = spinning(moving, state.spin);
  }
  advance(moving, typename Space::Vec{}, h);
  state.free.center = body.center = moving.center;
  state.free.rotation = body.rotation = moving.rotation;
  body.moved = body.center - body.first_center;
  body.turned =
      body.rotation == body.first_rotation ? RotationIn<Space>{} : body.rotation * conjugate(body.first_rotation);
  if (!state.movable) return;
  state.free.linear = body.linear;
  state.free.angular_momentum += gained;
  body.linear_before = body.linear;
  body.angular = angular_velocity(state.free);
  body.angular_before = body.angular;
}
template <class T, class Space>
void IslandSolver<T, Space>::move(const SubStep<T>& time) {
  each(bodies_.size(), [&](std::size_t i) { move_body(i, time); });
}

/// What the pass without bias changed.
template <class T, class Space>
void IslandSolver<T, Space>::end_body(std::size_t i) {
  if (!states_[i].movable) return;
  states_[i].free.linear = bodies_[i].linear;
  if (!(bodies_[i].angular == bodies_[i].angular_before))
    states_[i].free.angular_momentum += inertias_[i] * (bodies_[i].angular - bodies_[i].angular_before);
}
template <class T, class Space>
void IslandSolver<T, Space>::end_sub_step() {
  each(bodies_.size(), [&](std::size_t i) { end_body(i); });
}

template <class T, class Space>
void IslandSolver<T, Space>::warm_start_contacts() {
  each_by_color([&](Contact& contact, SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
    for (const ManifoldRows<T, Space>& m : manifolds_of(contact)) warm_start<T, Space>(m, rows_of(m), a, b);
  });
}

template <class T, class Space>
void IslandSolver<T, Space>::solve_joints(bool bias) {
  joint_system_.solve(joints_, bodies_, bias);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    SolverBody<T, Space>&a = bodies_[joint_bodies_[j].first], &b = bodies_[joint_bodies_[j].second];
    if (!joint_system_.holds(j)) joints_[j].solve_loop(a, b, bias);
    joints_[j].solve_free(a, b, bias);
    if (bias && !by_mean_) a.pressed = b.pressed = SolverBody<T, Space>::Pressed::tied;
  }
}

/// The rows of joints where bodies are at the end of the sub-step.
template <class T, class Space>
void IslandSolver<T, Space>::arrive() {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    joints_[j].arrive(bodies_[joint_bodies_[j].first], bodies_[joint_bodies_[j].second]);
  joint_system_.factor(joints_, bodies_);
}

/// One pass. That with bias decides how bodies move, and notes along what they are pressed.
template <class T, class Space>
void IslandSolver<T, Space>::solve_rows(const ContactStep<T>& step, bool bias) {
  each_by_color([&](Contact& contact, SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
    for (ManifoldRows<T, Space>& m : manifolds_of(contact)) {
      const bool slides = graze::solve<T, Space>(m, rows_of(m), a, b, step, bias);
      if (bias) graze::note_pressed<T, Space>(m, rows_of(m), slides, a, b);
    }
  });
  solve_joints(bias);
}

template <class T, class Space>
void IslandSolver<T, Space>::solve(T step, T gravity) {
  const T h = step / T(sub_steps_);
  SubStep<T> time{h, T(1) / h, step, false};
  joints_.resize(joined_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].prepare(*joined_[j], time);
  joint_system_.prepare(joints_, joint_bodies_, movable_);
  time.joined_by_mean = by_mean_ = manifolds_.empty() && joint_system_.holds_all();
  for (JointRows<T, Space>& joint : joints_) joint.set_step(time);
  const ContactStep<T> contact = contact_step(time, gravity);
  for (int s = 0; s < sub_steps_; ++s) {
    begin_sub_step(time);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      SolverBody<T, Space>&a = bodies_[joint_bodies_[j].first], &b = bodies_[joint_bodies_[j].second];
      joints_[j].refresh(a, b);
      joints_[j].warm_start(a, b);
    }
    joint_system_.factor(joints_, bodies_);
    warm_start_contacts();
    solve_rows(contact, true);
    move(time);
    if (by_mean_) arrive();
    solve_rows(contact, false);
    end_sub_step();
  }
  find_residual();
}

template <class T, class Space>
void IslandSolver<T, Space>::find_residual() {
  for (const ManifoldRows<T, Space>& m : manifolds_)
    for (const PointRow<T, Space>& r : std::span(points_).subspan(m.first_row, m.row_count)) {
      if (!(r.impulse > T(0))) continue;
      const SolverBody<T, Space>&a = bodies_[m.a], &b = bodies_[m.b];
      const T speed = dot(b.linear - a.linear, m.normal) + dot(r.turn_b, b.angular) - dot(r.turn_a, a.angular);
      residual_ = greatest(residual_, -speed);
    }
}

template <class T, class Space>
void IslandSolver<T, Space>::store(std::span<SolverPoint<T, Space>> points) {
  each(manifolds_.size(), [&](std::size_t i) {
    const ManifoldRows<T, Space>& m = manifolds_[i];
    graze::store<T, Space>(m, rows_of(m), points.subspan(m.first_point, m.row_count), T(sub_steps_));
  });
  for (const JointRows<T, Space>& j : joints_) j.store();
}

template class IslandSolver<float, Space<float>>;
template class IslandSolver<double, Space<double>>;
template class IslandSolver<float, plane::Space<float>>;
template class IslandSolver<double, plane::Space<double>>;

}  // namespace graze
