// A large world in which everything moves: one update, and what each of its stages takes.
//
//   bench_world [--bodies N] [--frames N] [--largest-threads N]
//
// Half of the bodies are boxes and half spheres, 0.5 to 1.5 wide, at random places with about one body in each cube of
// twice the mean width, so that they make heaps here and there; each drifts by up to a hundredth of its size a frame
// and the boxes turn as much. Everything is in single precision and nothing sleeps. Told are medians by the clock: of
// giving all poses, of `World::update`, and of each stage run alone on arrays of its own. Threads are oneTBB's, where
// that is installed.
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "command_line.hpp"
#include "graze/world.hpp"
#include "measure.hpp"
#include "random.hpp"
#include "stages.hpp"
#include "table.hpp"
#include "threads.hpp"

namespace graze::bench {

namespace {

struct Moving {
  Shape<float> shape;
  Posef pose;
  Vec3f drift;
  Quatf turn;

  void step() {
    pose.translation += drift;
    pose.rotation = normalized(turn * pose.rotation);
  }
};

std::vector<Moving> make_bodies(std::size_t count) {
  constexpr double spacing = 2, motion = 0.01;
  Random random(19);
  const double half = spacing / 2 * std::cbrt(static_cast<double>(count));
  std::vector<Moving> bodies;
  bodies.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d size{random.number(0.5, 1.5), random.number(0.5, 1.5), random.number(0.5, 1.5)};
    const bool ball = i % 2 == 0;
    const Vec3d v = random.in_cube(motion / 2);
    bodies.push_back({ball ? Shape<float>(Sphere<float>(static_cast<float>(size.x / 2)))
                           : Shape<float>(Box<float>(converted<float>(size))),
                      converted<float>(Posed{random.in_cube(half), random.rotation()}),
                      converted<float>(random.in_cube(motion)),
                      ball ? Quatf{} : converted<float>(Posed{{}, normalized(Quatd{v.x, v.y, v.z, 1})}).rotation});
  }
  return bodies;
}

double milliseconds(const std::function<void()>& work) {
  const double begin = clock_seconds();
  work();
  return 1e3 * (clock_seconds() - begin);
}

/// A world and its stages on so many threads, and how long they took.
struct Run {
  explicit Run(std::size_t thread_count, std::unique_ptr<Executor> threads_of)
      : threads(thread_count),
        executor(std::move(threads_of)),
        world({}, executor.get()),
        stages(*executor, clock_seconds) {}

  void frame(const std::vector<Moving>& bodies, bool counts) {
    const double place = milliseconds([&] {
      for (std::size_t i = 0; i < ids.size(); ++i) world.move(ids[i], bodies[i].pose);
    });
    const double whole = milliseconds([&] { world.update(); });
    for (std::size_t i = 0; i < ids.size(); ++i) stages.move(ids[i], bodies[i].pose);
    const auto each = stages.update();
    if (!counts) return;
    placing.push_back(place);
    updating.push_back(whole);
    for (std::size_t s = 0; s < each.size(); ++s) of_stage[s].push_back(each[s]);
  }

  std::size_t threads;
  std::unique_ptr<Executor> executor;
  World<float> world;
  Stages<float> stages;
  std::vector<BodyId> ids;  ///< the same in both, which are filled alike
  std::vector<double> placing, updating, of_stage[Stages<float>::count];
};

void print(const std::vector<std::unique_ptr<Run>>& runs, std::size_t bodies) {
  std::vector<std::string> head{std::to_string(bodies) + " bodies"};
  for (const auto& run : runs) {
    head.push_back("ms, " + std::to_string(run->threads) + (run->threads == 1 ? " thread" : " threads"));
    head.push_back("ns each");
  }
  Table table(head);
  const auto line = [&](const std::string& name, const auto& times_of) {
    std::vector<std::string> cells{name};
    for (const auto& run : runs) {
      const double ms = quantile(times_of(*run), 0.5);
      cells.push_back(printed("%.1f", ms));
      cells.push_back(nanoseconds(1e6 * ms / static_cast<double>(bodies)));
    }
    table.add(cells);
  };
  line("poses given", [](const Run& run) { return run.placing; });
  line("World::update", [](const Run& run) { return run.updating; });
  for (std::size_t s = 0; s < Stages<float>::count; ++s)
    line("stage: " + std::string(Stages<float>::names[s]), [s](const Run& run) { return run.of_stage[s]; });
  std::fputs(table.text().c_str(), stdout);
}

int run(int argc, char** argv) {
  std::size_t count = 1'000'000, frames = 9, most_threads = 2;
  CommandLine("A large world in which everything moves: one update, and what each of its stages takes.")
      .number("--bodies", count, "boxes and spheres")
      .number("--frames", frames, "of which the median is taken")
      .number("--largest-threads", most_threads, "threads at most")
      .read(argc, argv);
  std::vector<Moving> bodies = make_bodies(count);
  std::vector<std::unique_ptr<Run>> runs;
  for (std::size_t threads = 1; threads <= most_threads; threads *= 2)
    if (auto executor = make_executor(threads)) runs.push_back(std::make_unique<Run>(threads, std::move(executor)));
  for (const Moving& body : bodies)
    for (const auto& run : runs) {
      run->ids.push_back(run->world.add({.shape = body.shape, .pose = body.pose}));
      run->stages.add({.shape = body.shape, .pose = body.pose});
    }
  constexpr std::size_t warm = 2;  // the first allocates, the second is the first that remembers one
  for (std::size_t frame = 0; frame < frames + warm; ++frame) {
    progress(frame, frames + warm, "frames");
    for (Moving& body : bodies) body.step();
    for (const auto& run : runs) run->frame(bodies, frame >= warm);
  }
  progress(1, 1, "");
  print(runs, count);
  const World<float>& world = runs[0]->world;
  const auto& contacts = world.contacts();
  std::printf("%zu candidate pairs, %zu of them in contact with %zu points, %zu events; %zu bytes a body;\n"
              "medians of %zu frames.\n",
              runs[0]->stages.pairs(), contacts.pairs.size(), contacts.points.size(), world.events().size(),
              world.memory() / count, frames);
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
