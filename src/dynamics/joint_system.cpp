#include "dynamics/joint_system.hpp"

#include <algorithm>

#include "dynamics/islands.hpp"

namespace graze {

namespace {

template <class Array>
auto inner(const Array& a, const Array& b) {
  typename Array::value_type sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Adds `times` of b to a.
template <class T, std::size_t N>
void add(std::array<T, N>& a, const std::array<T, N>& b, T times) {
  for (std::size_t i = 0; i < N; ++i) a[i] += b[i] * times;
}

/// The part of the rate that a loop's row would give its bodies alone, by which it yields.
template <class T>
inline constexpr T loop_yielding = T(1) / T(2048);

template <class T>
std::array<T, 6> coordinates(const Vec3<T>& linear, const Vec3<T>& angular) {
  return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
}
template <class T>
std::array<T, 3> coordinates(const plane::Vec2<T>& linear, const T& angular) {
  return {linear.x, linear.y, angular};
}

template <class T>
void set_inverse_mass(std::array<std::array<T, 6>, 6>& matrix, const InverseMass<T>& mass) {
  for (std::size_t i = 0; i < 3; ++i) {
    matrix[i][i] = mass.mass;
    for (std::size_t k = 0; k < 3; ++k) matrix[3 + i][3 + k] = mass.inertia.row[i][k];
  }
}
template <class T>
void set_inverse_mass(std::array<std::array<T, 3>, 3>& matrix, const plane::InverseMass<T>& mass) {
  matrix[0][0] = matrix[1][1] = mass.mass;
  matrix[2][2] = mass.inertia;
}

/// The joints of each body, by their numbers.
class JointsOfBodies {
 public:
  JointsOfBodies(std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies, std::size_t count)
      : begin_(count + 1, 0), joints_(2 * bodies.size()) {
    for (const auto& [a, b] : bodies) ++begin_[a + 1], ++begin_[b + 1];
    for (std::size_t i = 0; i < count; ++i) begin_[i + 1] += begin_[i];
    std::vector<std::uint32_t> filled(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t j = 0; j < bodies.size(); ++j)
      for (const std::uint32_t body : {bodies[j].first, bodies[j].second}) joints_[filled[body]++] = j;
  }
  std::span<const std::uint32_t> of(std::uint32_t body) const {
    return std::span(joints_).subspan(begin_[body], begin_[body + 1] - begin_[body]);
  }

 private:
  std::vector<std::uint32_t> begin_, joints_;
};

}  // namespace

template <class T, class Space>
void JointSystem<T, Space>::prepare(std::span<const JointRows<T, Space>> joint_rows,
                                    std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies,
                                    std::span<const std::uint8_t> movable) {
  links_.clear();
  linkages_.clear();
  loops_.clear();
  holds_all_ = true;
  held_.assign(bodies.size(), 0);
  responses_.resize(movable.size());
  if (bodies.empty()) return;
  const JointsOfBodies joints(bodies, movable.size());
  std::vector<std::uint8_t> reached(movable.size(), 0);
  std::vector<std::uint32_t> queue;
  const auto reach_from = [&](std::uint32_t root) {
    reached[root] = 1;
    queue.assign(1, root);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const std::uint32_t j : joints.of(queue[i])) {
        const auto [a, b] = bodies[j];
        const std::uint32_t other = a == queue[i] ? b : a;
        if (reached[other] != 0 || movable[other] == 0) continue;
        reached[other] = held_[j] = 1;
        links_.push_back({.joint = j,
                          .body = other,
                          .next = queue[i],
                          .body_is_a = other == a,
                          .next_moves = movable[queue[i]] != 0});
        queue.push_back(other);
      }
  };
  for (const bool moves : {false, true})
    for (std::uint32_t i = 0; i < movable.size(); ++i)
      if ((movable[i] != 0) == moves && reached[i] == 0 && !joints.of(i).empty()) reach_from(i);
  find_linkages(joint_rows, bodies, movable);
}

/// Finds what the joints of no tree close, each linkage by itself.
template <class T, class Space>
void JointSystem<T, Space>::find_linkages(std::span<const JointRows<T, Space>> joints,
                                          std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies,
                                          std::span<const std::uint8_t> movable) {
  std::vector<std::uint32_t> moved;
  std::vector<IslandLink> ties;
  bool closed = false;
  for (std::uint32_t j = 0; j < bodies.size(); ++j) {
    const auto [a, b] = bodies[j];
    if (movable[a] == 0 && movable[b] == 0) continue;
    moved.push_back(j);
    ties.push_back({a, b});
    closed = closed || held_[j] == 0;
  }
  if (!closed) return;
  Islands groups;
  groups.find(movable, ties);
  std::vector<std::uint32_t> group_of(movable.size());
  for (std::uint32_t g = 0; g < groups.ranges().size(); ++g)
    for (const std::uint32_t i : groups.bodies_of(groups.ranges()[g])) group_of[i] = g;
  const auto group = [&](const Link& link) { return group_of[link.body]; };
  std::stable_sort(links_.begin(), links_.end(), [&](const Link& p, const Link& q) { return group(p) < group(q); });
  std::size_t first = 0;
  for (std::uint32_t g = 0; g < groups.ranges().size(); ++g) {
    std::size_t end = first;
    while (end < links_.size() && group(links_[end]) == g) ++end;
    std::vector<std::uint32_t> closing;
    for (const std::uint32_t tie : groups.links_of(groups.ranges()[g]))
      if (held_[moved[tie]] == 0) closing.push_back(moved[tie]);
    if (!closing.empty()) add_linkage({.first_link = first, .end_link = end}, joints, bodies, closing);
    first = end;
  }
}

/// Adds a linkage with as many of its loops as may be solved at once; with none if those would be fewer than half,
/// since the others would give way all the same.
template <class T, class Space>
void JointSystem<T, Space>::add_linkage(Linkage linkage, std::span<const JointRows<T, Space>> joints,
                                        std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies,
                                        std::span<const std::uint32_t> closing) {
  const std::size_t links = linkage.end_link - linkage.first_link;
  linkage.first_loop = loops_.size();
  if (!linkages_.empty()) {
    const Linkage& last = linkages_.back();
    linkage.first_row = last.first_row + last.rows;
    linkage.first_factor = last.first_factor + last.rows * last.rows;
  }
  for (const std::uint32_t j : closing) {
    const std::size_t rows = joints[j].locked(), more = linkage.rows + rows;
    if (more > most_loop_rows || more * links > most_loop_work) continue;
    loops_.push_back({j, bodies[j].first, bodies[j].second, linkage.rows, rows});
    linkage.rows = more;
  }
  linkage.end_loop = loops_.size();
  const std::size_t solved = linkage.end_loop - linkage.first_loop;
  holds_all_ = holds_all_ && solved == closing.size();
  if (2 * solved < closing.size()) {
    loops_.resize(linkage.first_loop);
    return;
  }
  for (const Loop& loop : loops_of(linkage)) held_[loop.joint] = 1;
  linkages_.push_back(linkage);
}

template <class T, class Space>
auto JointSystem<T, Space>::pushed_by(const MeasuredRow<T, Space>& row, bool is_a) -> Freedoms {
  return is_a ? coordinates(-row.linear, -row.angular_a) : coordinates(row.linear, row.angular_b);
}

template <class T, class Space>
auto JointSystem<T, Space>::times(const std::array<Freedoms, freedoms>& matrix, const Freedoms& v) -> Freedoms {
  Freedoms out;
  for (std::size_t i = 0; i < freedoms; ++i) out[i] = inner(matrix[i], v);
  return out;
}

/// Ties the body and all that hangs on it to the next one.
template <class T, class Space>
void JointSystem<T, Space>::tie(Link& link, const JointRows<T, Space>& joint) {
  Response &body = responses_[link.body], &next = responses_[link.next];
  std::array<Freedoms, most_rows> response_of_body;
  link.rows = joint.locked();
  for (std::size_t i = 0; i < link.rows; ++i) {
    link.of_body[i] = pushed_by(joint.locked_row(i), link.body_is_a);
    link.of_next[i] = pushed_by(joint.locked_row(i), !link.body_is_a);
    response_of_body[i] = times(body.inverse_mass, link.of_body[i]);
    link.response[i] = link.next_moves ? times(next.inverse_mass, link.of_next[i]) : Freedoms{};
  }
  const auto element = [&](std::size_t i, std::size_t k) {
    return inner(response_of_body[i], link.of_body[k]) + inner(link.response[i], link.of_next[k]);
  };
  // Bodies that hang on a body take from the response of that body alone, which is the scale.
  const auto scale = [&](std::size_t i) {
    return inner(times(body.alone, link.of_body[i]), link.of_body[i]) +
           inner(times(next.alone, link.of_next[i]), link.of_next[i]);
  };
  link.factors.factor(link.rows, element, scale);
  if (!link.next_moves) return;
  for (std::size_t d = 0; d < freedoms; ++d) {
    Rows column{};
    for (std::size_t i = 0; i < link.rows; ++i) column[i] = link.response[i][d];
    column = link.factors.solved(column);
    for (std::size_t i = 0; i < link.rows; ++i) add(next.inverse_mass[d], link.response[i], -column[i]);
  }
}

template <class T, class Space>
void JointSystem<T, Space>::factor(std::span<const JointRows<T, Space>> joints,
                                   std::span<const SolverBody<T, Space>> bodies) {
  const auto set_alone = [&](std::uint32_t i) {
    responses_[i].alone = {};
    set_inverse_mass(responses_[i].alone, bodies[i].mass);
    responses_[i].inverse_mass = responses_[i].alone;
  };
  for (const Link& link : links_) set_alone(link.body), set_alone(link.next);
  for (const Loop& loop : loops_) set_alone(loop.a), set_alone(loop.b);
  for (std::size_t i = links_.size(); i-- > 0;) tie(links_[i], joints[links_[i].joint]);
  if (linkages_.empty()) return;
  set_loop_rows(joints);
  velocity_.assign(responses_.size(), {});
  for (const Linkage& linkage : linkages_) factor_loops(linkage);
}

/// Sets the rows of the joints that close loops where they are now.
template <class T, class Space>
void JointSystem<T, Space>::set_loop_rows(std::span<const JointRows<T, Space>> joints) {
  loop_rows_.clear();
  loop_factors_.assign(linkages_.back().first_factor + linkages_.back().rows * linkages_.back().rows, T(0));
  for (const Loop& loop : loops_) {
    const JointRows<T, Space>& joint = joints[loop.joint];
    for (std::size_t i = 0; i < loop.rows; ++i) {
      LoopRow row{pushed_by(joint.locked_row(i), true), pushed_by(joint.locked_row(i), false), T(0)};
      row.yielding = loop_yielding<T> * (inner(times(responses_[loop.a].alone, row.of_a), row.of_a) +
                                         inner(times(responses_[loop.b].alone, row.of_b), row.of_b));
      loop_rows_.push_back(row);
    }
  }
}

/// Sets `velocity_` to the velocities of a linkage's bodies by an impulse of 1 on a loop's row, with the trees holding.
template <class T, class Space>
void JointSystem<T, Space>::respond_to(const Linkage& linkage, const Loop& loop, const LoopRow& row) {
  const auto links = std::span(links_).subspan(linkage.first_link, linkage.end_link - linkage.first_link);
  for (const Link& link : links) velocity_[link.body] = velocity_[link.next] = {};
  velocity_[loop.a] = times(responses_[loop.a].alone, row.of_a);
  velocity_[loop.b] = times(responses_[loop.b].alone, row.of_b);
  sweep(
      links,
      [&](const Link& link) {
        Rows rates{};
        for (std::size_t i = 0; i < link.rows; ++i)
          rates[i] = -inner(link.of_body[i], velocity_[link.body]) - inner(link.of_next[i], velocity_[link.next]);
        return rates;
      },
      [&](const Link& link) {
        for (std::size_t i = 0; i < link.rows; ++i) {
          add(velocity_[link.body], times(responses_[link.body].alone, link.of_body[i]), link.impulses[i]);
          add(velocity_[link.next], times(responses_[link.next].alone, link.of_next[i]), link.impulses[i]);
        }
      });
}

template <class T, class Space>
void JointSystem<T, Space>::factor_loops(const Linkage& linkage) {
  const std::span<const LoopRow> rows = rows_of(linkage);
  const std::size_t n = rows.size();
  const auto lower = [&](std::size_t i, std::size_t j) -> T& {
    return loop_factors_[linkage.first_factor + i * n + j];
  };
  for (const Loop& loop : loops_of(linkage))
    for (std::size_t k = loop.first_row; k < loop.first_row + loop.rows; ++k) {
      respond_to(linkage, loop, rows[k]);
      for (const Loop& other : loops_of(linkage))
        for (std::size_t i = std::max(k, other.first_row); i < other.first_row + other.rows; ++i)
          lower(i, k) = inner(rows[i].of_a, velocity_[other.a]) + inner(rows[i].of_b, velocity_[other.b]);
      lower(k, k) += rows[k].yielding;
    }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      T k = lower(i, j);
      for (std::size_t m = 0; m < j; ++m)
        if (lower(m, m) > T(0)) k -= lower(i, m) * lower(j, m) / lower(m, m);
      // A row that yields leaves a pivot; rounding may still take one away, as of a body that nothing turns.
      lower(i, j) = j < i ? k * lower(j, j) : k > rows[i].yielding / T(2) ? T(1) / k : T(0);
    }
}

/// One pass over the rows of a linkage's loops. With `bias` they yield to the impulses that they bear by now.
template <class T, class Space>
void JointSystem<T, Space>::solve_loops(const Linkage& linkage, std::span<JointRows<T, Space>> joints,
                                        std::span<SolverBody<T, Space>> bodies, bool bias) {
  const std::span<const LoopRow> rows = rows_of(linkage);
  const std::size_t n = rows.size();
  const auto lower = [&](std::size_t i, std::size_t j) { return loop_factors_[linkage.first_factor + i * n + j]; };
  std::vector<T>& v = loop_rates_;
  v.assign(n, T(0));
  for (const Loop& loop : loops_of(linkage)) {
    const Rows wanted = joints[loop.joint].wanted(bodies[loop.a], bodies[loop.b], bias);
    for (std::size_t i = 0; i < loop.rows; ++i) {
      const std::size_t k = loop.first_row + i;
      v[k] = wanted[i] - (bias ? rows[k].yielding * joints[loop.joint].locked_impulse(i) : T(0));
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) v[i] -= lower(i, j) * v[j];
  for (std::size_t i = 0; i < n; ++i) v[i] *= lower(i, i);
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t j = i + 1; j < n; ++j) v[i] -= lower(j, i) * v[j];
  for (const Loop& loop : loops_of(linkage)) {
    Rows impulses{};
    for (std::size_t i = 0; i < loop.rows; ++i) impulses[i] = v[loop.first_row + i];
    joints[loop.joint].push_locked(impulses, bodies[loop.a], bodies[loop.b]);
  }
}

template <class T, class Space>
template <class Wanted, class Push>
void JointSystem<T, Space>::sweep(std::span<Link> links, const Wanted& wanted, const Push& push) {
  for (const Link& link : links)
    for (const std::uint32_t i : {link.body, link.next}) responses_[i].change = responses_[i].pushed = {};
  for (std::size_t l = links.size(); l-- > 0;) {
    Link& link = links[l];
    const Freedoms& change = responses_[link.body].change;
    Freedoms& of_next = responses_[link.next].change;
    Rows rates = wanted(link);
    for (std::size_t i = 0; i < link.rows; ++i)
      rates[i] -= inner(link.of_body[i], change) + inner(link.of_next[i], of_next);
    link.impulses = link.factors.solved(rates);
    for (std::size_t i = 0; i < link.rows; ++i) add(of_next, link.response[i], link.impulses[i]);
  }
  for (Link& link : links) {
    Freedoms& on_next = responses_[link.next].pushed;
    Rows late{};
    for (std::size_t i = 0; i < link.rows; ++i) late[i] = -inner(link.response[i], on_next);
    late = link.factors.solved(late);
    for (std::size_t i = 0; i < link.rows; ++i) {
      link.impulses[i] += late[i];
      add(on_next, link.of_next[i], link.impulses[i]);
      add(responses_[link.body].pushed, link.of_body[i], link.impulses[i]);
    }
    push(link);
  }
}

template <class T, class Space>
void JointSystem<T, Space>::solve_trees(std::span<JointRows<T, Space>> joints, std::span<SolverBody<T, Space>> bodies,
                                        bool bias) {
  const auto ends = [&](const Link& link) {
    return link.body_is_a ? std::pair(link.body, link.next) : std::pair(link.next, link.body);
  };
  sweep(
      links_,
      [&](const Link& link) {
        const auto [a, b] = ends(link);
        return joints[link.joint].wanted(bodies[a], bodies[b], bias);
      },
      [&](const Link& link) {
        const auto [a, b] = ends(link);
        joints[link.joint].push_locked(link.impulses, bodies[a], bodies[b]);
      });
}

template <class T, class Space>
void JointSystem<T, Space>::solve(std::span<JointRows<T, Space>> joints, std::span<SolverBody<T, Space>> bodies,
                                  bool bias) {
  solve_trees(joints, bodies, bias);
  if (linkages_.empty()) return;
  for (const Linkage& linkage : linkages_) solve_loops(linkage, joints, bodies, bias);
  solve_trees(joints, bodies, bias);
}

template class JointSystem<float, Space<float>>;
template class JointSystem<double, Space<double>>;
template class JointSystem<float, plane::Space<float>>;
template class JointSystem<double, plane::Space<double>>;

}  // namespace graze
