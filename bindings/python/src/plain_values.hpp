// Plain values in Python: pickled by their members, and shown as the call that makes them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "convert.hpp"
#include "plane_convert.hpp"

namespace graze::python {

/// A member as plain Python: a number, a tuple.
inline py::object member_of(const Vec3d& v) { return tuple_of(v); }
inline py::object member_of(const plane::Vec2d& v) { return tuple_of(v); }
inline py::object member_of(const Quatd& q) { return tuple_of(q); }
inline py::object member_of(const plane::Rot2d& r) { return py::make_tuple(r.cosine, r.sine); }
inline py::object member_of(const Mat3d& m) {
  return py::make_tuple(tuple_of(m.row[0]), tuple_of(m.row[1]), tuple_of(m.row[2]));
}
inline py::object member_of(Status status) { return py::int_(static_cast<int>(status)); }
template <class Number>
requires std::is_arithmetic_v<Number> py::object member_of(Number number) { return py::cast(number); }

inline void read_member(const py::handle& from, Vec3d& to) {
  if (!read_vector(from, to)) throw py::type_error("state: expected three numbers");
}
inline void read_member(const py::handle& from, plane::Vec2d& to) {
  if (!read_vector(from, to)) throw py::type_error("state: expected two numbers");
}
inline void read_member(const py::handle& from, Quatd& to) {
  double q[4];
  if (!read_numbers(from, q, 4)) throw py::type_error("state: expected four numbers");
  to = {q[0], q[1], q[2], q[3]};
}
inline void read_member(const py::handle& from, plane::Rot2d& to) {
  double r[2];
  if (!read_numbers(from, r, 2)) throw py::type_error("state: expected two numbers");
  to = {r[0], r[1]};
}
inline void read_member(const py::handle& from, Mat3d& to) {
  const auto rows = from.cast<py::tuple>();
  for (std::size_t i = 0; i < 3; ++i) read_member(rows[i], to.row[i]);
}
inline void read_member(const py::handle& from, Status& to) {
  const int number = from.cast<int>();
  if (number < 0 || number > static_cast<int>(Status::unbounded))
    validate::fail("state", "a status from 0 to 2", std::to_string(number));
  to = static_cast<Status>(number);
}
template <class Number>
requires std::is_arithmetic_v<Number>
void read_member(const py::handle& from, Number& to) { to = from.cast<Number>(); }

/// Pickles a struct by these members, in their order.
template <class Value, class... Members>
auto pickled(Members... members) {
  return py::pickle([members...](const Value& value) { return py::make_tuple(member_of(value.*members)...); },
                    [members...](const py::tuple& state) {
                      if (state.size() != sizeof...(Members))
                        validate::fail("state", std::to_string(sizeof...(Members)) + " members",
                                       std::to_string(state.size()));
                      Value value{};
                      std::size_t i = 0;
                      (read_member(state[i++], value.*members), ...);
                      return value;
                    });
}

/// Pickles a manifold, with its points as objects of their own.
template <class Manifold>
auto pickled_manifold() {
  return py::pickle(
      [](const Manifold& m) {
        py::list points;
        for (const auto& point : m.points) points.append(py::cast(point));
        return py::make_tuple(member_of(m.normal), points, m.piece_a, m.piece_b, member_of(m.status), m.error);
      },
      [](const py::tuple& state) {
        if (state.size() != 6) validate::fail("state", "6 members", std::to_string(state.size()));
        Manifold m;
        read_member(state[0], m.normal);
        for (const py::handle point : state[1].cast<py::list>())
          m.points.push_back(point.cast<std::decay_t<decltype(m.points[0])>>());
        read_member(state[2], m.piece_a);
        read_member(state[3], m.piece_b);
        read_member(state[4], m.status);
        read_member(state[5], m.error);
        return m;
      });
}

/// Named arguments, in their order.
using Arguments = std::vector<std::pair<const char*, py::object>>;

/// The text of a call with named arguments.
inline std::string call_text(const std::string& name, const Arguments& arguments) {
  std::string text = name + "(";
  const char* comma = "";
  for (const auto& [key, value] : arguments) {
    text += comma + std::string(key) + "=" + std::string(py::str(py::repr(value)));
    comma = ", ";
  }
  return text + ")";
}

/// The name of an object's class with that of the module in which users find it, "graze.plane.World".
inline std::string class_name(const py::object& self) {
  const py::handle type = py::type::handle_of(self);
  return std::string(py::str(type.attr("__module__"))) + "." + std::string(py::str(type.attr("__qualname__")));
}

}  // namespace graze::python
