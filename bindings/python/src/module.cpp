// The Python module `graze._graze`; the package's __init__.py shows its names as graze's own.
#include "answers.hpp"
#include "raised.hpp"
#include "shapes.hpp"
#include "threads.hpp"

#include <string_view>

namespace {

/// Raises ValueError for an `InvalidValue`. Its message may hold bytes that are no UTF-8, of the name of a file, and
/// would be lost with them.
void raise_value_error(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const graze::InvalidValue& error) {
    const std::string_view text = error.what();
    PyObject* message = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace");
    if (message == nullptr) return;
    PyErr_SetObject(PyExc_ValueError, message);
    Py_DECREF(message);
  }
}

}  // namespace

PYBIND11_MODULE(_graze, m) {
  using namespace graze::python;
  pybind11::register_local_exception_translator(&raise_value_error);
  m.attr("__version__") = GRAZE_VERSION_TEXT;
  add_threads(m);
  add_pose(m);
  add_shapes(m);
  add_answers(m);
  add_queries(m);
  add_batches(m);
  add_motion(m);
  add_world(m);
  add_broad(m);
  add_draw(m);
  add_simulation(m);
  add_replay(m);
  add_scenes(m);
  add_plane(m);
  raise_after_calls(m);
}
