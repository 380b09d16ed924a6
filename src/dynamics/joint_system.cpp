#include "dynamics/joint_system.hpp"

#include <algorithm>

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
void JointSystem<T, Space>::prepare(std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies,
                                    std::span<const std::uint8_t> movable) {
  links_.clear();
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
  // What hangs on a body is taken from the response of the body alone.
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
  for (const Link& link : links_)
    for (const std::uint32_t i : {link.body, link.next}) {
      responses_[i].alone = {};
      set_inverse_mass(responses_[i].alone, bodies[i].mass);
      responses_[i].inverse_mass = responses_[i].alone;
    }
  for (std::size_t i = links_.size(); i-- > 0;) tie(links_[i], joints[links_[i].joint]);
}

template <class T, class Space>
void JointSystem<T, Space>::solve(std::span<JointRows<T, Space>> joints, std::span<SolverBody<T, Space>> bodies,
                                  bool bias) {
  const auto ends = [&](const Link& link) {
    return link.body_is_a ? std::pair(link.body, link.next) : std::pair(link.next, link.body);
  };
  for (const Link& link : links_)
    for (const std::uint32_t i : {link.body, link.next}) responses_[i].change = responses_[i].pushed = {};
  for (std::size_t l = links_.size(); l-- > 0;) {
    Link& link = links_[l];
    const auto [a, b] = ends(link);
    const Freedoms& change = responses_[link.body].change;
    Freedoms& of_next = responses_[link.next].change;
    Rows wanted = joints[link.joint].wanted(bodies[a], bodies[b], bias);
    for (std::size_t i = 0; i < link.rows; ++i)
      wanted[i] -= inner(link.of_body[i], change) + inner(link.of_next[i], of_next);
    link.impulses = link.factors.solved(wanted);
    for (std::size_t i = 0; i < link.rows; ++i) add(of_next, link.response[i], link.impulses[i]);
  }
  for (Link& link : links_) {
    Freedoms& on_next = responses_[link.next].pushed;
    Rows late{};
    for (std::size_t i = 0; i < link.rows; ++i) late[i] = -inner(link.response[i], on_next);
    late = link.factors.solved(late);
    for (std::size_t i = 0; i < link.rows; ++i) {
      link.impulses[i] += late[i];
      add(on_next, link.of_next[i], link.impulses[i]);
      add(responses_[link.body].pushed, link.of_body[i], link.impulses[i]);
    }
    const auto [a, b] = ends(link);
    joints[link.joint].push_locked(link.impulses, bodies[a], bodies[b]);
  }
}

template class JointSystem<float, Space<float>>;
template class JointSystem<double, Space<double>>;
template class JointSystem<float, plane::Space<float>>;
template class JointSystem<double, plane::Space<double>>;

}  // namespace graze
