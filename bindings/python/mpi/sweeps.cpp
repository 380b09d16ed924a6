// The Python module `graze._graze_mpi`: sweeps of configurations by all ranks; graze/mpi.py shows them as graze's own.
//
// Guarantee: the interpreter's lock is released while ranks answer, and the scene cannot be changed meanwhile. Shapes
// and worlds are those of `graze._graze`, which has to be imported before.
#include <pybind11/stl.h>

#include <iostream>

#include "../src/world.hpp"
#include "graze/mpi/configurations.hpp"

namespace graze::python {

namespace {

// The layout of the NumPy type `nearest` of graze/mpi.py.
static_assert(offsetof(mpi::NearestOfChain, link) == 8 && offsetof(mpi::NearestOfChain, other) == 12 &&
              sizeof(mpi::NearestOfChain) == 16);

py::dict object_of(const mpi::SweepReport& report) {
  py::dict told;
  told["configurations"] = report.lines;
  told["errors"] = report.errors;
  told["chunks"] = report.chunks;
  told["remembered"] = report.remembered;
  told["by_rank"] = report.by_rank;
  told["busy"] = report.busy;
  return told;
}

py::dict sweep_configurations(int comm, const std::string& poses, const std::string& out, const std::string& journal,
                              const std::string& name, const std::vector<Shaped>& links,
                              const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs,
                              const WorldView<SpaceWords>& scene, double limit) {
  if (out.empty()) validate::fail("out", "the name of a file", "none");
  const auto world = scene.read();
  mpi::SweepSettings settings;
  settings.questions = poses;
  settings.out = out;
  settings.journal = journal;
  settings.kind = "graze " GRAZE_VERSION_TEXT " from Python, " + name;
  mpi::SweepReport report;
  {
    const py::gil_scoped_release free;
    report = mpi::sweep_configurations<double>(MPI_Comm_f2c(comm), settings, {links, pairs}, *world, std::cout, limit);
  }
  return object_of(report);
}

}  // namespace

}  // namespace graze::python

PYBIND11_MODULE(_graze_mpi, m) {
  namespace py = pybind11;
  using namespace graze;
  py::register_exception<mpi::CommonError>(m, "CommonError", PyExc_RuntimeError);
  m.def("sweep_configurations", &python::sweep_configurations);
}
