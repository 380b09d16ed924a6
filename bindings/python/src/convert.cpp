#include "convert.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace graze::python {

namespace {

/// Throws for an array that holds something else than numbers, or more: NumPy would read texts and spans of time as
/// numbers, and drop an imaginary part and a mask.
void check_plain(const py::handle& from, const char* name) {
  if (!py::isinstance<py::array>(from)) return;
  const auto array = py::reinterpret_borrow<py::array>(from);
  const char kind = array.dtype().kind();
  if (kind == 'c') throw py::type_error(std::string(name) + ": expected real numbers, got complex ones");
  if (std::string_view("fiubO").find(kind) == std::string_view::npos)
    throw py::type_error(std::string(name) + ": expected an array of numbers, got one of " +
                         std::string(py::str(array.dtype())));
  const auto* plain = reinterpret_cast<PyObject*>(py::detail::npy_api::get().PyArray_Type_);
  if (reinterpret_cast<const PyObject*>(Py_TYPE(from.ptr())) != plain && py::hasattr(from, "mask"))
    throw py::type_error(std::string(name) + ": expected an array without a mask, got a masked one");
}

}  // namespace

bool read_numbers(py::handle from, double* to, py::ssize_t size) {
  if (PyTuple_Check(from.ptr()) || PyList_Check(from.ptr())) {
    if (PySequence_Fast_GET_SIZE(from.ptr()) != size) return false;
    PyObject** items = PySequence_Fast_ITEMS(from.ptr());
    for (py::ssize_t i = 0; i < size; ++i) {
      to[i] = PyFloat_AsDouble(items[i]);
      if (to[i] == -1 && PyErr_Occurred()) {
        PyErr_Clear();
        return false;
      }
    }
    return true;
  }
  if (!py::isinstance<py::array>(from)) return false;
  check_plain(from, "array");
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(from);
  if (!array || array.size() != size) return false;
  std::copy_n(array.data(), size, to);
  return true;
}

namespace {

/// A quaternion of unit length as it stands, as batches take it; any other brought to unit length.
Quatd rotation_of(const Quatd& q) {
  const double squared = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return std::abs(squared - 1) <= unit_slack ? q : validate::rotation(q, "rotation");
}

/// The rotation of a matrix by the largest of the four components (Shepperd 1978, "Quaternion from rotation matrix").
Quatd quaternion_of(const double (&m)[16], const char* path) {
  const Mat3d r{{Vec3d{m[0], m[1], m[2]}, Vec3d{m[4], m[5], m[6]}, Vec3d{m[8], m[9], m[10]}}};
  const double trace = r.row[0].x + r.row[1].y + r.row[2].z;
  const double parts[4] = {r.row[0].x, r.row[1].y, r.row[2].z, trace};
  std::size_t largest = 3;
  for (std::size_t i = 0; i < 3; ++i)
    if (parts[i] > parts[largest]) largest = i;
  double q[4];
  if (largest == 3) {
    q[0] = r.row[2].y - r.row[1].z;
    q[1] = r.row[0].z - r.row[2].x;
    q[2] = r.row[1].x - r.row[0].y;
    q[3] = 1 + trace;
  } else {
    const std::size_t i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
    q[i] = 1 - trace + 2 * parts[i];
    q[j] = r.row[j][i] + r.row[i][j];
    q[k] = r.row[k][i] + r.row[i][k];
    q[3] = r.row[k][j] - r.row[j][k];
  }
  const Quatd found = validate::rotation(Quatd{q[0], q[1], q[2], q[3]}, path);
  // A scaled, mirrored or sheared matrix is no pose: it differs from that of the rotation by more than rounding.
  const Mat3d back = rotation_matrix(found);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!(std::abs(back.row[i][j] - r.row[i][j]) <= 1e-6))
        validate::fail(path, "a rotation and a translation, without scale, shear or mirroring",
                       "[" + std::to_string(i) + "][" + std::to_string(j) + "] = " + validate::number(r.row[i][j]));
  return found;
}

bool read_matrix(py::handle from, Posed& to) {
  double m[16];
  if (!read_numbers(from, m, 16)) return false;
  for (std::size_t i = 0; i < 4; ++i)
    if (m[12 + i] != (i == 3 ? 1 : 0))
      validate::fail("pose[3][" + std::to_string(i) + "]", i == 3 ? "1" : "0", m[12 + i]);
  to = {validate::point(Vec3d{m[3], m[7], m[11]}, "translation"), quaternion_of(m, "pose")};
  return true;
}

}  // namespace

bool read_vector(py::handle from, Vec3d& to) {
  double numbers[3];
  if (!read_numbers(from, numbers, 3)) return false;
  to = {numbers[0], numbers[1], numbers[2]};
  return true;
}

bool read_pose(py::handle from, Posed& to) {
  if (from.is_none()) {
    to = {};
    return true;
  }
  if (py::isinstance<Posed>(from)) {
    to = *from.cast<const Posed*>();
    return true;
  }
  Vec3d translation;
  double q[4];
  if (PyTuple_Check(from.ptr()) && PyTuple_GET_SIZE(from.ptr()) == 2) {
    if (!read_vector(PyTuple_GET_ITEM(from.ptr(), 0), translation) ||
        !read_numbers(PyTuple_GET_ITEM(from.ptr(), 1), q, 4))
      return false;
  } else if (double numbers[7]; read_numbers(from, numbers, 7)) {
    translation = {numbers[0], numbers[1], numbers[2]};
    std::copy_n(numbers + 3, 4, q);
  } else if (read_vector(from, translation)) {
    q[0] = q[1] = q[2] = 0;
    q[3] = 1;
  } else {
    return py::isinstance<py::array>(from) && read_matrix(from, to);
  }
  to = {validate::point(translation, "translation"), rotation_of({q[0], q[1], q[2], q[3]})};
  return true;
}

double number_from(const py::object& from, const char* path) {
  double number = 0;
  if (!read_numbers(py::make_tuple(from), &number, 1))
    throw py::type_error(std::string(path) + ": expected a number, got " + std::string(py::str(py::repr(from))));
  return number;
}

py::array_t<double> array_of_points(std::span<const Vec3d> points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const Vec3d& p : points)
    for (std::size_t i = 0; i < 3; ++i) *out++ = p[i];
  return array;
}

namespace {

/// What Python passed as an array, in its own type.
py::array given_array(py::handle from, const char* name) {
  check_plain(from, name);
  const py::array given = py::array::ensure(from);
  if (!given) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": expected an array of numbers");
  }
  check_plain(given, name);
  return given;
}

/// Whether an array is an empty list, which NumPy knows no columns of.
bool no_rows(const py::array& array) { return array.ndim() == 1 && array.size() == 0; }

/// Throws for an array that has not so many columns.
void check_rows(const py::array& array, py::ssize_t columns, const char* name) {
  if (array.ndim() == 2 && array.shape(1) == columns) return;
  std::string shape;
  for (py::ssize_t i = 0; i < array.ndim(); ++i) shape += (i ? ", " : "") + std::to_string(array.shape(i));
  validate::fail(name, "an array of shape (n, " + std::to_string(columns) + ")", "shape (" + shape + ")");
}

/// The indices of an array whose numbers `Number` holds. They are copied: the caller's array may be changed by another
/// thread after they were checked.
template <class Number>
IndexRows copied_indices(const py::array& given, py::ssize_t columns, const char* name) {
  const auto array = py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(given);
  IndexRows indices(py::array::ShapeContainer{array.shape(0), columns});
  std::uint32_t* to = indices.mutable_data();
  for (py::ssize_t i = 0; i < array.size(); ++i) {
    const Number index = array.data()[i];
    to[i] = static_cast<std::uint32_t>(index);
    if (!std::in_range<std::uint32_t>(index))
      validate::fail(std::string(name) + "[" + std::to_string(i / columns) + "][" + std::to_string(i % columns) + "]",
                     "an index from 0 to 4294967295", std::to_string(index));
  }
  return indices;
}

}  // namespace

Rows rows(py::handle from, py::ssize_t columns, const char* name) {
  const py::array given = given_array(from, name);
  const auto array = Rows::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": expected an array of numbers");
  }
  if (no_rows(array)) return Rows(py::array::ShapeContainer{py::ssize_t{0}, columns});
  check_rows(array, columns, name);
  return array;
}

IndexRows index_rows(py::handle from, py::ssize_t columns, const char* name) {
  const py::array given = given_array(from, name);
  const char kind = given.dtype().kind();
  if (given.size() > 0 && kind != 'i' && kind != 'u')
    throw py::type_error(std::string(name) + ": expected an array of whole numbers");
  if (no_rows(given)) return IndexRows(py::array::ShapeContainer{py::ssize_t{0}, columns});
  check_rows(given, columns, name);
  if (given.dtype().is(py::dtype::of<std::uint32_t>())) return copied_indices<std::uint32_t>(given, columns, name);
  return kind == 'u' ? copied_indices<std::uint64_t>(given, columns, name)
                     : copied_indices<std::int64_t>(given, columns, name);
}

py::dtype record_type(std::initializer_list<Field> fields, std::size_t size) {
  py::list names, types, offsets;
  for (const Field& field : fields) {
    names.append(field.name);
    types.append(field.type);
    offsets.append(field.offset);
  }
  return py::dtype(names, types, offsets, static_cast<py::ssize_t>(size));
}

}  // namespace graze::python
