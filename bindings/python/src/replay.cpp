// Captures played again.
#include <pybind11/stl/filesystem.h>

#include "answers.hpp"
#include "capture.hpp"

namespace graze::python {

namespace {

/// The poses of all bodies as rows of as many numbers as a pose has.
template <class Pose>
py::array_t<double> rows_of(std::span<const Pose> poses) {
  using Number = std::remove_cvref_t<decltype(poses[0].translation.x)>;
  constexpr std::size_t columns = sizeof(Pose) / sizeof(Number);
  py::array_t<double> out({poses.size(), columns});
  const auto* from = reinterpret_cast<const Number*>(poses.data());
  std::copy(from, from + poses.size() * columns, out.mutable_data());
  return out;
}

template <class T, class Space>
py::array_t<double> poses_of(const World<T, Space>& world) {
  return rows_of(std::span<const typename Space::Pose>(world.bodies().poses()));
}
template <class T, class Space>
py::array_t<double> poses_of(const Simulation<T, Space>& simulation) {
  return rows_of(simulation.poses());
}

py::dict object_of(const ReplayReport& report) {
  py::dict out;
  out["simulation"] = report.simulation;
  out["plane"] = report.plane;
  out["single"] = report.single;
  out["frames"] = report.frames;
  out["calls"] = report.calls;
  out["cut"] = report.cut;
  py::dict names;
  for (const auto& [id, name] : report.names.all())
    names[py::int_(id.index)] = py::reinterpret_steal<py::str>(
        PyUnicode_DecodeUTF8(name.data(), static_cast<py::ssize_t>(name.size()), "replace"));
  out["names"] = names;
  const auto& d = report.difference;
  out["difference"] = d ? py::object(py::make_tuple(d->frame, d->call, d->what)) : py::none();
  return out;
}

}  // namespace

void add_replay(py::module_& m) {
  m.def(
      "replay",
      [](const std::filesystem::path& file, const py::object& each) {
        std::ifstream in(file, std::ios::binary);
        if (!in) throw InvalidValue("file", "one that can be read", file.string());
        const auto show = [&each](std::size_t frame, const Replayed& played, const BodyNames&) {
          std::visit([&](const auto* thing) { each(frame, poses_of(*thing)); }, played);
        };
        if (!each.is_none()) return object_of(graze::replay(in, file.string(), show));
        const auto report = [&] {
          const py::gil_scoped_release free;
          return graze::replay(in, file.string());
        }();
        return object_of(report);
      },
      py::arg("file"), py::arg("each") = py::none(),
      R"(Plays a capture, to its end or to the first difference, and says what came of it.

each: called after every frame with its number and the poses of all bodies, as World and Simulation
have them. Returns a dictionary: whether it was a simulation, in the plane, in float ('single'); its
frames and calls; 'cut' where the file ends within a frame; 'names' of the bodies that were given one,
by index; and 'difference', None where all came out to the same bits, else (frame, call, what). Raises
ValueError for a file that is no capture or damaged, with the frame, and what `each` raises.

>>> import graze, os, tempfile
>>> file = os.path.join(tempfile.mkdtemp(), "drop.capture")
>>> simulation = graze.CapturedSimulation(file)
>>> ball = simulation.add(graze.Sphere(1), (0, 9, 0))
>>> for _ in range(3):
...     simulation.step(1 / 60)
>>> report = graze.replay(file, lambda frame, poses: print(frame, poses[0, 1].round(4)))
1 8.9986
2 8.9945
3 8.9877
>>> report["frames"], report["difference"]
(3, None)
)");
}

}  // namespace graze::python
