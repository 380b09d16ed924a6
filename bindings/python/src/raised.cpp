#include "raised.hpp"

#include <atomic>
#include <string>

namespace graze::python {

namespace py = pybind11;

/// The exception that the call will raise, if any, is read and written with the interpreter's lock held, but for the
/// word that there is one.
struct RunningCall {
  PyObject *type = nullptr, *value = nullptr, *traceback = nullptr;
  std::atomic<bool> raises{false};
};

namespace {

/// The call that this thread runs or works for.
thread_local RunningCall* running = nullptr;

/// The C function behind every function that pybind11 makes.
PyCFunctionWithKeywords dispatcher = nullptr;

PyObject* call(PyObject* self, PyObject* arguments, PyObject* named) {
  RunningCall own;
  PyObject* answer = nullptr;
  {
    const WorkingFor working(&own);
    answer = dispatcher(self, arguments, named);
  }
  if (own.type == nullptr) return answer;
  Py_XDECREF(answer);
  PyErr_Restore(own.type, own.value, own.traceback);
  return nullptr;
}

PyCFunction plain(PyCFunctionWithKeywords function) {
  return reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(function));
}

bool starts_with(const py::handle& text, const std::string& start) {
  return py::isinstance<py::str>(text) && text.cast<std::string>().compare(0, start.size(), start) == 0;
}

/// Makes `thing`, or what is inside it, call its functions by `call`, where it is of the package of that name.
void adopt(const py::handle& thing, const std::string& package) {
  PyObject* object = thing.ptr();
  if (PyCFunction_Check(object)) {
    PyMethodDef& definition = *reinterpret_cast<PyCFunctionObject*>(object)->m_ml;
    if (definition.ml_meth == plain(dispatcher)) definition.ml_meth = plain(&call);
  } else if (PyInstanceMethod_Check(object)) {
    adopt(PyInstanceMethod_Function(object), package);
  } else if (PyObject_TypeCheck(object, &PyProperty_Type)) {
    for (const char* part : {"fget", "fset"}) adopt(thing.attr(part), package);
  } else if (PyObject_TypeCheck(object, &PyStaticMethod_Type)) {
    adopt(thing.attr("__func__"), package);
  } else if ((PyType_Check(object) && starts_with(thing.attr("__module__"), package)) ||
             (PyModule_Check(object) && starts_with(thing.attr("__name__"), package))) {
    for (const auto& [name, member] : py::dict(thing.attr("__dict__"))) adopt(member, package);
  }
}

}  // namespace

RunningCall* running_call() { return running; }

WorkingFor::WorkingFor(RunningCall* call) : before_(running) { running = call; }
WorkingFor::~WorkingFor() { running = before_; }

bool raising() { return running != nullptr && running->raises.load(std::memory_order_relaxed); }

void keep_raised() {
  if (running == nullptr) {
    PyErr_WriteUnraisable(nullptr);
  } else if (running->type == nullptr) {
    PyErr_Fetch(&running->type, &running->value, &running->traceback);
    running->raises.store(true, std::memory_order_relaxed);
  } else {
    PyErr_Clear();
  }
}

void raise_after_calls(const py::module_& module) {
  const py::object known = module.attr("overlap");
  dispatcher = reinterpret_cast<PyCFunctionWithKeywords>(
      reinterpret_cast<void (*)()>(reinterpret_cast<PyCFunctionObject*>(known.ptr())->m_ml->ml_meth));
  const std::string name = module.attr("__name__").cast<std::string>();
  adopt(module, name.substr(0, name.find('.')));
}

}  // namespace graze::python
