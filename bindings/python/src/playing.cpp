// Scenes that are played, of space and of the plane, as the program graze does it, and the animations of scenes.
#include "playing.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>

#include "capture.hpp"
#include "graze/io/collide_frames.hpp"
#include "graze/io/plane_simulate.hpp"
#include "plane_convert.hpp"
#include "scene_text.hpp"
#include "threads.hpp"
#include "whole.hpp"

namespace graze::python {

namespace {

using File = std::optional<std::filesystem::path>;

/// Settings of a scene that is played, from its arguments.
struct Playing {
  double seconds, rate;
  Whole sub_steps;
  ThreadsArgument threads;
  File out, source, capture;
};

py::dict object_of(const io::SimulateSummary& summary) {
  py::list triggers;
  for (const io::TriggerEvent& t : summary.triggers)
    triggers.append(py::make_tuple(t.time, t.begins ? "begin" : "end", t.trigger, t.body));
  py::dict out;
  out["bodies"] = summary.bodies;
  out["joints"] = summary.joints;
  out["steps"] = summary.steps;
  out["awake"] = summary.awake;
  out["most_sub_steps"] = summary.most_sub_steps;
  out["deepest"] = summary.deepest;
  out["deepest_time"] = summary.deepest_time;
  out["first_energy"] = summary.first_energy;
  out["kinetic_energy"] = summary.kinetic_energy;
  out["potential_energy"] = summary.potential_energy;
  out["milliseconds"] = summary.whole_ms;
  out["slowest_milliseconds"] = summary.slowest_ms;
  out["triggers"] = triggers;
  out["notices"] = summary.notices;
  return out;
}

/// A row of numbers for each of `states`, by `fill(state, row)`.
template <class States, class Fill>
py::array_t<double> rows_of_states(const States& states, py::ssize_t columns, const Fill& fill) {
  py::array_t<double> out({static_cast<py::ssize_t>(states.size()), columns});
  double* row = out.mutable_data();
  for (const auto& state : states) {
    fill(state, row);
    row += columns;
  }
  return out;
}

/// The parts of a frame that space and the plane have alike.
template <class Frame>
py::dict object_of_frame(const Frame& frame) {
  py::dict out;
  out["time"] = frame.time;
  py::array_t<bool> asleep(static_cast<py::ssize_t>(frame.bodies.size()));
  bool* to = asleep.mutable_data();
  for (const auto& body : frame.bodies) *to++ = body.asleep;
  out["asleep"] = asleep;
  py::list contacts;
  for (const io::ContactState& c : frame.contacts)
    contacts.append(py::make_tuple(c.a, c.b, c.points, c.impulse, c.depth));
  out["contacts"] = contacts;
  out["kinetic_energy"] = frame.kinetic_energy;
  out["potential_energy"] = frame.potential_energy;
  return out;
}

void fill(const Vec3d& v, double* row) {
  for (std::size_t i = 0; i < 3; ++i) row[i] = v[i];
}

py::dict object_of(const io::SimulationFrame& frame) {
  py::dict out = object_of_frame(frame);
  out["poses"] = rows_of_states(frame.bodies, 7, [](const io::BodyState& body, double* row) {
    fill(body.pose.translation, row);
    const Quatd& q = body.pose.rotation;
    row[3] = q.x, row[4] = q.y, row[5] = q.z, row[6] = q.w;
  });
  out["linear"] = rows_of_states(frame.bodies, 3, [](const auto& body, double* row) { fill(body.linear, row); });
  out["angular"] = rows_of_states(frame.bodies, 3, [](const auto& body, double* row) { fill(body.angular, row); });
  return out;
}

py::dict object_of(const io::PlaneSimulationFrame& frame) {
  py::dict out = object_of_frame(frame);
  out["poses"] = rows_of_states(frame.bodies, 3, [](const io::PlaneBodyState& body, double* row) {
    row[0] = body.translation.x, row[1] = body.translation.y, row[2] = body.rotation;
  });
  out["linear"] = rows_of_states(frame.bodies, 2, [](const io::PlaneBodyState& body, double* row) {
    row[0] = body.linear.x, row[1] = body.linear.y;
  });
  py::array_t<double> angular(static_cast<py::ssize_t>(frame.bodies.size()));
  double* to = angular.mutable_data();
  for (const io::PlaneBodyState& body : frame.bodies) *to++ = body.angular;
  out["angular"] = angular;
  return out;
}

/// Plays a scene, calls `each` for every frame and writes the files. `record(file, source)` begins a recording.
template <class Frame, class Scene, class Record>
py::dict played(const Scene& scene, const py::object& each, const Playing& how, const Vec3d& gravity,
                const Record& record) {
  io::SimulateOptions options;
  options.seconds = how.seconds;
  options.rate = how.rate;
  options.gravity = validate::point(gravity, "gravity");
  options.sub_steps = how.sub_steps.as<int>("sub_steps");
  io::frame_count(options);  // refused before a file is written
  const auto threads = how.threads.of_call();
  options.executor = threads.get();
  std::optional<CaptureFile> capture;
  if (how.capture) options.capture = &capture.emplace(*how.capture).stream();
  decltype(record(std::filesystem::path(), std::filesystem::path())) recording;
  if (how.out) recording = record(*how.out, how.source.value_or(std::filesystem::path()));
  io::SimulateSummary summary;
  {
    const py::gil_scoped_release free;
    summary = io::simulate(scene, options, [&](const Frame& frame) {
      if (recording) recording->add(frame);
      if (each.is_none()) return;
      const py::gil_scoped_acquire lock;
      each(object_of(frame));
    });
    if (recording) recording->close();
  }
  if constexpr (requires { recording->notices(); })
    if (recording)
      for (std::string& text : recording->notices()) summary.notices.push_back(std::move(text));
  return object_of(summary);
}

constexpr const char* simulate_doc = R"(

each: called with every frame, the first at time 0: a dictionary of `time`, `poses`, `linear`, `angular`
and `asleep` of the `moving_bodies` of the scene, a row each, `contacts` as tuples (body, body, points,
impulse, depth), `kinetic_energy` and `potential_energy`. rate: steps, and frames, a second. sub_steps:
of a step, a power of two. threads: how many, or a graze.Threads; the bits are the same.)";
constexpr const char* summary_doc = R"(
capture: a file of all calls, for `graze.replay`.

Returns a dictionary: numbers of bodies, joints and steps; the bodies `awake` at the end; the largest
number of sub-steps; the deepest penetration and its time; energies; milliseconds a step; `triggers`,
what came into triggers and left: (time, 'begin' or 'end', collider, body); and `notices`. Raises
ValueError for a scene that cannot be played, naming the body, for numbers out of range, and for files
that cannot be written; and what `each` raises.)";

/// An animation by its index or its name. Throws `InvalidValue` where the scene has none such.
std::size_t animation_of(const io::Scene& scene, const py::object& given) {
  if (py::isinstance<py::str>(given)) return io::find_animation(scene, given.cast<std::string>());
  return io::find_animation(scene, std::to_string(given.cast<Whole>().at_least<std::size_t>(0, "animation")));
}

void add_animations(py::module_& m) {
  m.def(
      "animated_colliders",
      [](const io::Scene& scene, const py::object& animation) {
        return io::animated_colliders(scene, animation_of(scene, animation));
      },
      py::arg("scene"), py::arg("animation") = 0,
      "The indices of the colliders that an animation, by index or name, moves. Raises ValueError where there is "
      "none.");
  m.def(
      "collide_frames",
      [](const io::Scene& scene, const py::object& animation, double fps, std::optional<double> duration,
         std::optional<double> margin) {
        io::FrameOptions options;
        options.animation = animation_of(scene, animation);
        options.fps = fps;
        options.duration = duration;
        options.margin = margin;
        struct Event {
          double time;
          io::FrameEvent what;
        };
        std::vector<Event> events;
        {
          const py::gil_scoped_release free;
          io::collide_frames(scene, options, [&](const io::Frame& frame) {
            for (const io::FrameEvent& event : frame.events) events.push_back({frame.time, event});
          });
        }
        py::list out;
        for (const auto& [time, e] : events)
          out.append(py::make_tuple(time, e.begin ? "begin" : "end", e.a, e.b, e.trigger, e.depth));
        return out;
      },
      py::arg("scene"), py::arg("animation") = 0, py::arg("fps") = 30.0, py::arg("duration") = py::none(),
      py::arg("margin") = py::none(),
      R"(What touches while an animation is played: (time, 'begin' or 'end', collider, collider, trigger, depth).

scene: loaded with `animations=True`. animation: by index or name. fps: frames a second, each of which
is tested by itself. duration: in seconds, by default the animation's. margin: the gap up to which
colliders that have touched stay in touch, by default about a hundredth of their size. depth: of a
beginning between solids, else None. Raises ValueError for a scene without such an animation.)");
}

}  // namespace

void add_playing(py::module_& m) {
  add_animations(m);
  m.def(
      "simulate",
      [](const io::Scene& scene, const py::object& each, double seconds, double rate, const Vector& gravity,
         const Whole& sub_steps, const ThreadsArgument& threads, const File& out, const File& source,
         const File& capture) {
        return played<io::SimulationFrame>(
            scene, each, {seconds, rate, sub_steps, threads, out, source, capture}, gravity.value,
            [&](const auto& file, const auto& from) { return io::record(file, scene, from); });
      },
      py::arg("scene"), py::arg("each") = py::none(), py::arg("seconds") = 10.0, py::arg("rate") = 60.0,
      py::arg("gravity") = Vector{{0, -9.81, 0}}, py::arg("sub_steps") = Whole(4), py::arg("threads") = py::none(),
      py::arg("out") = py::none(), py::arg("source") = py::none(), py::arg("capture") = py::none(),
      (std::string("Plays a scene, as `graze simulate` does: bodies fall, collide and are joined as its file says.\n"
                   "Nodes that its first animation moves follow it, where it was loaded with `animations=True`.") +
       simulate_doc + R"(
out: a file to write the motion to: .gltf or .glb, an animation, or .jsonl, a line a frame; `source` is
the glTF file of the scene, which then stays as it is with an animation more.)" +
       summary_doc)
          .c_str());
}

void add_plane_playing(py::module_& m) {
  m.def(
      "simulate",
      [](const io::PlaneScene& scene, const py::object& each, double seconds, double rate,
         const std::optional<Vector2>& gravity, const Whole& sub_steps, const ThreadsArgument& threads, const File& out,
         const File& capture) {
        const plane::Vec2d g = gravity ? gravity->value : scene.gravity.value_or(plane::Vec2d{0, -9.81});
        return played<io::PlaneSimulationFrame>(scene, each, {seconds, rate, sub_steps, threads, out, {}, capture},
                                                {g.x, g.y, 0},
                                                [&](const auto& file, const auto&) { return io::record(file, scene); });
      },
      py::arg("scene"), py::arg("each") = py::none(), py::arg("seconds") = 10.0, py::arg("rate") = 60.0,
      py::arg("gravity") = py::none(), py::arg("sub_steps") = Whole(4), py::arg("threads") = py::none(),
      py::arg("out") = py::none(), py::arg("capture") = py::none(),
      (std::string("Plays a scene of the plane, as `graze simulate` does: its bodies fall, collide, slide and rest.") +
       simulate_doc + R"(
gravity: by default the scene's own, or (0, -9.81). A row of `poses` is (x, y, angle).
out: a file to write the motion to: .svg, a picture that moves, or .jsonl, a line a frame.)" +
       summary_doc)
          .c_str());
}

}  // namespace graze::python
