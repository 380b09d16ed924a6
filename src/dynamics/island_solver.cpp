#include "dynamics/island_solver.hpp"

#include <algorithm>

namespace graze {

namespace {

/// Passes that relax the velocities of an island with both contacts and joints. A contact is solved without the
/// joints of its bodies: one pass takes back too little or too much of a blow's impulse, which the next sub-step
/// begins with, and the blow is given once more. Measured in 393 chains of 3 to 27 links that collide, the last up to
/// a hundred times as heavy: with one pass the energy rises by up to a tenth of what they can fall, with two by
/// 0.035, with four by 0.007.
constexpr int passes_among_joints = 4;

/// Passes that push bodies apart that overlap: what lies on them has to be lifted along.
constexpr int pushing_passes = 8;

/// Passes that relax the velocities of an island in which bodies overlap, at most. Contacts that push bodies apart give
/// each of a row of n bodies the speed of those below it and more; one pass takes back that of its neighbours alone.
/// They end where no point that pushes parts any faster than by `parted` of the speed at which contacts push.
constexpr int passes_in_overlap = 64;
template <class T>
constexpr T parted = T(0.01);

/// The part of a size by which points are deeper than their bodies came in a step where these were put into each other.
template <class T>
constexpr T put_in = T(0.003);

/// Bodies, and chunks of contacts, of an island in one task: so many that handing it out costs little in comparison.
constexpr std::size_t bodies_per_block = 64, chunks_per_task = 4;

}  // namespace

template <class T, class Space>
void IslandSolver<T, Space>::clear(Executor* executor) {
  executor_ = executor;
  movable_.clear();
  contacts_.clear();
  states_.clear();
  bodies_.clear();
  pushed_ = 0;
  immovable_.clear();
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
  b.linear_before = b.linear;
  b.angular_before = b.angular;
  movable_.push_back(body.movable ? 1 : 0);
  states_.push_back(body);
  bodies_.push_back(b);
  if (body.movable) {
    bodies_.back().mass.mass = body.inverse_mass;
    turn_inertia(pushed_++);
  }
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

/// Sets the inertia of a body in the world to that where it is.
template <class T, class Space>
void IslandSolver<T, Space>::turn_inertia(std::size_t i) {
  IslandBody<T, Space>& state = states_[i];
  const FreeBodyIn<Space>& free = state.free;
  bodies_[i].mass.inertia = in_world(free.inverse_inertia, free.rotation);
  state.world_inertia = in_world(finite_inertia(state.inertia, free.inverse_inertia), free.rotation);
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
  contacts_.add(touching, manifolds);
}

/// Calls `f` with each number below `count`, on the island's threads.
template <class T, class Space>
template <class F>
void IslandSolver<T, Space>::each(std::size_t count, std::size_t per_task, const F& f) {
  if (!executor_ || count <= per_task) {
    for (std::size_t i = 0; i < count; ++i) f(i);
    return;
  }
  for_each_chunk(*executor_, count, per_task, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) f(i);
  });
}
/// Calls `f` with blocks of the bodies that can be pushed.
template <class T, class Space>
template <class F>
void IslandSolver<T, Space>::each_pushed(const F& f) {
  each((pushed_ + bodies_per_block - 1) / bodies_per_block, 1, [&](std::size_t block) {
    const std::size_t first = block * bodies_per_block;
    f(BodyBlock<T, Space>{&states_[first], &bodies_[first], std::min(bodies_per_block, pushed_ - first)});
  });
}

/// Calls `f` with each bundle of contacts and its kernels, one colour after the other.
template <class T, class Space>
template <class F>
void IslandSolver<T, Space>::each_bundle(const F& f) {
  for (const auto& color : contacts_.colors()) {
    const std::size_t count = color.end_chunk - color.first_chunk;
    each(count, color.ordered ? count : chunks_per_task, [&](std::size_t i) {
      for (const ContactBundle<T, Space>& bundle : contacts_.bundles_of(color.first_chunk + i))
        f(contacts_.kernels_of(bundle), bundle);
    });
  }
}

template <class T, class Space>
void IslandSolver<T, Space>::add(JointInPlace<T, Space>& joint, std::uint32_t a, std::uint32_t b) {
  joined_.push_back(&joint);
  joint_bodies_.emplace_back(a, b);
}

template <class T, class Space>
IslandLoad<T> IslandSolver<T, Space>::load(std::span<const SolverPoint<T, Space>> points, T step, T gravity,
                                           T share) const {
  IslandLoad<T> load;
  std::size_t pressing = 0;
  contacts_.each_manifold([&](const TouchingBodies<T, Space>& touching, const ContactManifold<T, Space>& m) {
    T pressed(0);
    const T size = touching.between.size;
    for (const SolverPoint<T, Space>& p : points.subspan(m.first_point, m.point_count))
      pressed += greatest(T(0), dot(p.impulse, m.normal)) * share;
    const T inverse_mass = bodies_[touching.a].mass.mass + bodies_[touching.b].mass.mass;
    const T strain = pressed / step * inverse_mass / size;
    load.strain = greatest(load.strain, strain);
    load.smallest = least(load.smallest, size);
    if (!(pressed > T(0)) || !(gravity > T(0))) return;
    load.mean_strain += strain;
    load.mean_borne += strain * size / gravity;
    ++pressing;
  });
  if (pressing > 0) {
    load.mean_strain /= T(pressing);
    load.mean_borne /= T(pressing);
  }
  T speeds(0), movable(0);
  for (const IslandBody<T, Space>& body : states_) {
    if (!body.movable) continue;
    speeds += length_squared(body.free.linear);
    movable += T(1);
  }
  load.mean_square_speed = speeds / movable;
  return load;
}

/// The force on all bodies together.
template <class T, class Space>
T IslandSolver<T, Space>::weight() const {
  T all(0);
  for (const IslandBody<T, Space>& body : states_)
    if (body.movable) all += length(body.influences.acceleration) / body.inverse_mass;
  return all;
}

/// Looks for contacts of bodies that were put where they are, and that are deeper than the bodies came in a step.
template <class T, class Space>
void IslandSolver<T, Space>::find_overlap(std::span<const SolverPoint<T, Space>> points, T step) {
  if (std::none_of(states_.begin(), states_.end(), [](const auto& state) { return state.placed; })) return;
  contacts_.each_manifold([&](const TouchingBodies<T, Space>& touching, const ContactManifold<T, Space>& m) {
    if (!states_[touching.a].placed && !states_[touching.b].placed) return;
    const SolverBody<T, Space>&a = bodies_[touching.a], &b = bodies_[touching.b];
    const T deepest = put_in<T> * touching.between.size;
    for (const SolverPoint<T, Space>& p : points.subspan(m.first_point, m.point_count)) {
      if (-p.distance <= deepest) continue;
      placed_[touching.a] = placed_[touching.b] = 1;
      const T speed = dot(b.velocity(p.b - b.center) - a.velocity(p.a - a.center), m.normal);
      overlap_ = overlap_ || -p.distance > deepest + std::abs(speed) * step;
    }
  });
}

template <class T, class Space>
void IslandSolver<T, Space>::choose_sub_steps(std::span<const SolverPoint<T, Space>> points, const StepTime<T>& time,
                                              T gravity, int least, int most) {
  // A body on a joint moves along a chord of its arc: the error is the square of the sub-step, and a quarter of it with
  // two for one.
  sub_steps_ = !joined_.empty() ? std::min(2 * least, most) : contacts_.empty() ? 1 : least;
  placed_.assign(states_.size(), 0);
  overlap_ = false;
  if (contacts_.empty()) return;
  find_overlap(points, time.step);
  const IslandLoad<T> borne = load(points, time.step, gravity, time.share);
  smallest_ = borne.smallest;
  int last = 0;
  for (const IslandBody<T, Space>& body : states_) {
    if (!body.movable) continue;
    if (body.sub_steps == 0) sub_steps_ = std::max(sub_steps_, std::min(most_for_one, most));
    last = std::max(last, std::min(body.sub_steps, most));
  }
  sub_steps_ = sub_step_count(borne, time.usual_step, gravity, last, sub_steps_, most);
}

template <class T, class Space>
void IslandSolver<T, Space>::begin_sub_step(const SubStep<T>& time) {
  each_pushed([&](const BodyBlock<T, Space>& block) { body_kernels_.begin(block, time); });
}

template <class T, class Space>
void IslandSolver<T, Space>::move(const SubStep<T>& time) {
  each_pushed([&](const BodyBlock<T, Space>& block) { body_kernels_.move(block, time); });
  move_unpushed(time);
  // Links that fold turn by radians a step, and where a joint takes a push to turn a slender one by less than it does,
  // it corrects too much, the more so each time. Contacts go by the inertia that they began with.
  if (joints_.empty()) return;
  for (std::size_t i = 0; i < pushed_; ++i) turn_inertia(i);
}

/// Moves bodies that nothing pushes by the velocities that they are given.
template <class T, class Space>
void IslandSolver<T, Space>::move_unpushed(const SubStep<T>& time) {
  for (std::size_t i = pushed_; i < bodies_.size(); ++i) {
    IslandBody<T, Space>& state = states_[i];
    SolverBody<T, Space>& body = bodies_[i];
    FreeBodyIn<Space> moving = spinning(state.free, state.spin);
    advance(moving, typename Space::Vec{}, time.h * state.influences.share);
    state.free.center = body.center = moving.center;
    state.free.rotation = body.rotation = moving.rotation;
    body.moved = body.center - body.first_center;
    body.turned =
        body.rotation == body.first_rotation ? RotationIn<Space>{} : body.rotation * conjugate(body.first_rotation);
  }
}

template <class T, class Space>
void IslandSolver<T, Space>::end_sub_step() {
  each_pushed([&](const BodyBlock<T, Space>& block) { body_kernels_.end(block); });
}

template <class T, class Space>
void IslandSolver<T, Space>::solve_joints(bool bias) {
  joint_system_.solve(joints_, bodies_, bias);
  bool driven = false;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    SolverBody<T, Space>&a = bodies_[joint_bodies_[j].first], &b = bodies_[joint_bodies_[j].second];
    if (!joint_system_.holds(j)) joints_[j].solve_loop(a, b, bias);
    joints_[j].solve_free(a, b, bias);
    driven = driven || !joints_[j].all_locked();
    if (bias && !by_mean_) {
      a.tie();
      b.tie();
    }
  }
  // A drive or bound pushes no axis that its own joint locks, but those of the other joints of a linkage; what is left
  // of that would build up, so the locked axes are solved once more.
  if (driven && joints_.size() > 1) joint_system_.solve(joints_, bodies_, bias);
}

/// Sets the rows of joints where bodies are at the end of the sub-step.
template <class T, class Space>
void IslandSolver<T, Space>::arrive() {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    joints_[j].arrive(bodies_[joint_bodies_[j].first], bodies_[joint_bodies_[j].second]);
  joint_system_.factor(joints_, bodies_);
}

/// Relaxes the velocities: the impulses that only moved bodies out of each other are taken back.
template <class T, class Space>
void IslandSolver<T, Space>::relax(const ContactStep<T>& step) {
  const int passes = joints_.empty() || contacts_.empty() ? 1 : passes_among_joints;
  for (int pass = 0; pass < passes; ++pass) solve_rows(step, false);
  if (!overlap_) return;
  const T slow = parted<T> * fastest_push(step, smallest_);
  for (int pass = passes; pass < passes_in_overlap && parting() > slow; ++pass) solve_rows(step, false);
}

/// One pass over all rows. The one with bias decides how bodies move, and records the normals that press them.
template <class T, class Space>
void IslandSolver<T, Space>::solve_rows(const ContactStep<T>& step, bool bias) {
  each_bundle([&](const auto& kernels, const auto& bundle) { kernels.solve(bundle, bodies_.data(), step, bias); });
  solve_joints(bias);
}

/// Sets up the rows of contacts, with the impulses of the last step or none.
template <class T, class Space>
void IslandSolver<T, Space>::prepare_contacts(std::span<const SolverPoint<T, Space>> points, const StepTime<T>& whole) {
  const T number = T(sub_steps_);
  WarmStart<T> warm{};
  if (whole.warm_start) warm = {whole.share / number, T(1) / number, weight() * whole.step / number};
  each_bundle([&](const auto& kernels, const auto& bundle) {
    kernels.prepare(bundle, bodies_.data(), points.data(), whole.step, warm);
  });
}

/// Sets the rows of joints where the bodies are now, with the impulses of the last sub-step or none.
template <class T, class Space>
void IslandSolver<T, Space>::begin_joints(bool warm_start) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    SolverBody<T, Space>&a = bodies_[joint_bodies_[j].first], &b = bodies_[joint_bodies_[j].second];
    joints_[j].refresh(a, b);
    if (warm_start)
      joints_[j].warm_start(a, b);
    else
      joints_[j].start_cold();
  }
  joint_system_.factor(joints_, bodies_);
}

template <class T, class Space>
void IslandSolver<T, Space>::solve(std::span<const SolverPoint<T, Space>> points, const StepTime<T>& whole, T gravity) {
  contacts_.build(movable_);
  const T step = whole.step;
  prepare_contacts(points, whole);
  const T h = step / T(sub_steps_);
  SubStep<T> time{h, T(1) / h, step, false};
  joints_.resize(joined_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].prepare(*joined_[j], time);
  joint_system_.prepare(joints_, joint_bodies_, movable_);
  time.joined_by_mean = by_mean_ = contacts_.empty() && joint_system_.holds_all();
  for (JointRows<T, Space>& joint : joints_) joint.set_step(time);
  const ContactStep<T> contact = contact_step(time, gravity, whole.usual_step, sub_steps_);
  for (int s = 0; s < sub_steps_; ++s) {
    begin_sub_step(time);
    begin_joints(whole.warm_start);
    if (whole.warm_start)
      each_bundle([&](const auto& kernels, const auto& bundle) { kernels.warm_start(bundle, bodies_.data()); });
    else if (s > 0)
      prepare_contacts(points, whole);  // rows keep what they pushed
    for (int pass = 0; pass < (overlap_ ? pushing_passes : 1); ++pass) solve_rows(contact, true);
    move(time);
    if (by_mean_) arrive();
    relax(contact);
    end_sub_step();
  }
  find_residual();
}

/// The greatest number that `of` tells of a bundle and its kernels.
template <class T, class Space>
template <class F>
T IslandSolver<T, Space>::greatest_speed(const F& of) {
  T fastest(0);
  for (std::size_t chunk = 0; chunk < contacts_.chunk_count(); ++chunk)
    for (const ContactBundle<T, Space>& bundle : contacts_.bundles_of(chunk))
      fastest = greatest(fastest, of(contacts_.kernels_of(bundle), bundle));
  return fastest;
}
template <class T, class Space>
void IslandSolver<T, Space>::find_residual() {
  residual_ = greatest_speed([&](const auto& kernels, const auto& b) { return kernels.approach(b, bodies_.data()); });
}
template <class T, class Space>
T IslandSolver<T, Space>::parting() {
  return greatest_speed([&](const auto& kernels, const auto& b) { return kernels.parting(b, bodies_.data()); });
}

template <class T, class Space>
void IslandSolver<T, Space>::store(std::span<SolverPoint<T, Space>> points) {
  each_bundle([&](const auto& kernels, const auto& bundle) { kernels.store(bundle, T(sub_steps_), points.data()); });
  for (const JointRows<T, Space>& j : joints_) j.store();
}

template class IslandSolver<float, Space<float>>;
template class IslandSolver<double, Space<double>>;
template class IslandSolver<float, plane::Space<float>>;
template class IslandSolver<double, plane::Space<double>>;

}  // namespace graze
