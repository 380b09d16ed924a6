// A world on many ranks: ghosts, bytes and memory a body, balance, and what an update costs beside that of one world.
//
//   mpirun -n RANKS bench_mpi_world [--bodies N] [--frames N] [--corner] [--unlike] [--beside] [--float] [--blocks]
//                                   [--moving N] [--threads N]
//
// Balls and boxes stand in a cube of a lattice, a little turned and out of place, so that each touches about three
// others; from frame to frame every body moves by about 1e-3 of its size, or with --moving N one body in N. Of ghosts
// and bytes the mean of the frames is printed. With --corner all bodies fall into one corner over the frames and lie
// there for 24 more, and the balance of each frame is printed, as the costs of the one before say.
//
// With --unlike half of the cube is hulls of 300 corners, whose pairs cost many times as much; printed is the busiest
// rank's processor time over the mean, too.
//
// With --beside rank 0 also holds one `World` of all bodies with as many threads as there are ranks, and the two take
// turns frame by frame: printed are the medians of the clock and of their ratio, frame by frame, because other work of
// the machine is about the same in two updates that follow each other; and of processor time, which other work
// lengthens less and waiting not at all. The others sleep while one world works. Start it with --bind-to none then:
// mpirun would else give rank 0, and so one world with all its threads, a single core.
//
// With --blocks contacts are handed over block by block and nobody remembers who touched, as for granular matter of
// tens of millions of bodies, in single precision with --float.
#include <mpi.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "command_line.hpp"
#include "graze/mpi/world.hpp"
#include "graze/world.hpp"
#include "random.hpp"
#include "threads.hpp"

namespace graze::bench {

namespace {

struct Options {
  std::size_t bodies = 100000, frames = 9, moving = 1, threads = 1;  // threads of each rank
  bool corner = false, unlike = false, beside = false, in_float = false, blocks = false;
};

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Seconds of processors that this process had.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The bodies of the lattice by number: the same on every rank, and in every frame from themselves alone.
template <class T>
class Lattice {
 public:
  explicit Lattice(const Options& options)
      : options_(options),
        side_(static_cast<std::uint64_t>(std::ceil(std::cbrt(static_cast<double>(options.bodies))))) {}

  graze::Body<T> body(std::uint64_t number, std::size_t frame) const {
    return {options_.unlike && number % side_ < side_ / 2 ? hull_
            : number % 2 == 0                             ? ball_
                                                          : box_,
            pose(number, frame)};
  }
  /// The one shape with data of its own.
  const Shape<T>& hull() const { return hull_; }
  Pose<T> pose(std::uint64_t number, std::size_t frame) const {
    Random still(number);
    const Vec3d away = still.in_cube(0.05);
    const Quatd turn = still.rotation();
    Random now(number * 1000003 + frame);
    Vec3d at{static_cast<double>(number % side_), static_cast<double>(number / side_ % side_),
             static_cast<double>(number / side_ / side_)};
    // Bodies that fall come to lie on a heap in the corner, less than a third as wide and denser towards the corner.
    if (options_.corner) {
      const double part = std::min(1.0, static_cast<double>(frame) / static_cast<double>(options_.frames - 1));
      const double reach = static_cast<double>(side_);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double fallen = 0.6 * reach * (at[axis] / reach) * (at[axis] / reach);
        at[axis] += part * (fallen - at[axis]);
      }
    }
    return {converted<T>(at + away + now.in_cube(1e-3)), converted<T>(turn)};
  }
  bool moves(std::uint64_t number, std::size_t frame) const { return (number + frame) % options_.moving == 0; }
  std::uint64_t side() const { return side_; }

 private:
  /// Corners on a sphere, along a spiral.
  static Shape<T> make_hull() {
    constexpr int corners = 300;
    std::vector<Vec3<T>> points;
    for (int i = 0; i < corners; ++i) {
      const double height = 1 - (2 * i + 1.0) / corners, away = std::sqrt(1 - height * height);
      points.push_back(converted<T>(0.54 * Vec3d{away * std::cos(2.4 * i), height, away * std::sin(2.4 * i)}));
    }
    return ConvexHull<T>(points);
  }

  Options options_;
  std::uint64_t side_;
  Shape<T> ball_ = Sphere<T>(T(0.54)), box_ = Box<T>({T(0.94), T(0.94), T(0.94)}), hull_ = make_hull();
};

/// Waits for all without a processor.
void meet_asleep() {
  MPI_Request all = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &all);
  for (int there = 0; there == 0;) {
    MPI_Test(&all, &there, MPI_STATUS_IGNORE);
    if (there == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

struct Sums {
  double bodies = 0, ghosts = 0, pairs = 0, bytes = 0, memory = 0, most_bodies = 0, partition = 0, exchange = 0,
         broad = 0, contacts = 0, events = 0, most_held = 0, work = 0, all_work = 0;
};

/// The most memory that this process ever had.
double held() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

template <class T>
Sums sums_of(const mpi::World<T>& world) {
  const mpi::WorldReport& r = world.report();
  const auto d = [](std::uint64_t n) { return static_cast<double>(n); };
  const double mine[] = {d(r.bodies), d(r.ghosts), d(r.pairs), d(r.bytes), d(world.memory())};
  const double most[] = {d(r.bodies), r.partition, r.exchange, r.broad, r.contacts, r.events, held(), r.work};
  Sums s;
  MPI_Allreduce(mine, &s.bodies, 5, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  MPI_Allreduce(most, &s.most_bodies, 8, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  MPI_Allreduce(&r.work, &s.all_work, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return s;
}

/// One world of all bodies, on rank 0.
template <class T>
struct One {
  explicit One(std::size_t threads) : executor(make_executor(threads)), world({}, executor.get()) {}
  std::unique_ptr<Executor> executor;
  World<T> world;
  std::vector<BodyId> ids;
};

template <class T>
void run(const Options& options) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const Lattice<T> lattice(options);
  mpi::WorldSettings<T> settings;
  settings.events = !options.blocks;
  const std::unique_ptr<Executor> executor = make_executor(options.threads);
  mpi::World<T> many(MPI_COMM_WORLD, settings, executor.get());
  if (options.unlike) many.share(lattice.hull());
  std::uint64_t points = 0;
  const mpi::ContactVisitor<T> count = [&](const mpi::ContactBlock<T>& block) {
    points += block.contacts.points.size();
  };
  // In slabs, as a program would read them.
  const std::uint64_t begin = options.bodies * static_cast<std::uint64_t>(rank) / static_cast<std::uint64_t>(ranks),
                      end = options.bodies * static_cast<std::uint64_t>(rank + 1) / static_cast<std::uint64_t>(ranks);
  for (std::uint64_t i = begin; i < end; ++i) many.add(i, lattice.body(i, 0));
  std::unique_ptr<One<T>> one;
  if (options.beside && rank == 0) {
    one = std::make_unique<One<T>>(static_cast<std::size_t>(ranks) * options.threads);
    for (std::uint64_t i = 0; i < options.bodies; ++i) one->ids.push_back(one->world.add(lattice.body(i, 0)));
  }
  std::vector<double> clocks, clocks_of_one, ratios, works, works_of_one, work_ratios, imbalances;
  Sums last;
  double ghosts = 0, bytes = 0;
  // Frames to find the borders, which are not counted; and 24 after the fall, in which all lies still.
  const std::size_t first = options.corner ? 0 : options.unlike ? 8 : 2, after = options.corner ? 24 : 0;
  for (std::size_t frame = 0; frame < options.frames + first + after; ++frame) {
    for (const mpi::Key key : many.keys())
      if (lattice.moves(key, frame)) many.move(key, lattice.pose(key, frame));
    MPI_Barrier(MPI_COMM_WORLD);
    const double before = seconds();
    options.blocks ? many.update(count) : many.update();
    MPI_Barrier(MPI_COMM_WORLD);
    const double clock = seconds() - before;
    double clock_of_one = 0, work_of_one = 0;
    if (one) {
      for (std::uint64_t i = 0; i < options.bodies; ++i)
        if (lattice.moves(i, frame)) one->world.move(one->ids[i], lattice.pose(i, frame));
      const double then = seconds(), work_then = processor_seconds();
      one->world.update();
      clock_of_one = seconds() - then;
      work_of_one = (processor_seconds() - work_then) / ranks;
    }
    meet_asleep();
    last = sums_of(many);
    if (options.corner && rank == 0)
      std::printf("frame %zu: work %.3f, borders drawn %llu times, %llu migrated\n", frame, many.report().imbalance,
                  static_cast<unsigned long long>(many.report().partitions),
                  static_cast<unsigned long long>(many.report().migrated));
    if (frame < first) continue;
    clocks.push_back(clock);
    clocks_of_one.push_back(clock_of_one);
    ratios.push_back(clock / std::max(clock_of_one, 1e-9));
    works.push_back(last.work);
    imbalances.push_back(last.work / last.all_work * ranks);
    works_of_one.push_back(work_of_one);
    work_ratios.push_back(last.work / std::max(work_of_one, 1e-9));
    ghosts += last.ghosts / static_cast<double>(options.frames + after);
    bytes += last.bytes / static_cast<double>(options.frames + after);
  }
  if (rank != 0) return;
  const double n = static_cast<double>(options.bodies);
  std::printf(
      "%2d ranks, %zu bodies: pairs %.0f, ghosts %.0f (%.4f a body), bytes %.1f a body, memory %.0f a body, at most "
      "%.0f MB a rank, update %.1f ms (partition %.1f, exchange %.1f, pairs %.1f, contacts %.1f, events %.1f)\n",
      ranks, options.bodies, last.pairs, ghosts, ghosts / n, bytes / n, last.memory / n, last.most_held / 1e6,
      1e3 * median(clocks), 1e3 * last.partition, 1e3 * last.exchange, 1e3 * last.broad, 1e3 * last.contacts,
      1e3 * last.events);
  if (options.unlike)
    std::printf(
        "processor time of the busiest rank over the mean %.3f, work reckoned %.3f, at most %.0f bodies a rank\n",
        median(imbalances), many.report().imbalance, last.most_bodies);
  if (one)
    std::printf(
        "one world, %zu threads: update %.1f ms, memory %.0f a body; many over one: %.2f\n"
        "processor time of the busiest rank %.1f ms, of one world by its threads %.1f ms; many over one: %.2f\n",
        static_cast<std::size_t>(ranks) * options.threads, 1e3 * median(clocks_of_one),
        static_cast<double>(one->world.memory()) / n, median(ratios), 1e3 * median(works), 1e3 * median(works_of_one),
        median(work_ratios));
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) {
  graze::bench::Options options;
  graze::bench::CommandLine("Ghosts, bytes, memory and time of a world on many ranks; start it by mpirun")
      .number("--bodies", options.bodies, "Bodies in all")
      .number("--frames", options.frames, "Updates that are counted")
      .flag("--corner", options.corner, "All bodies fall into one corner")
      .flag("--unlike", options.unlike, "Half of the bodies are hulls of many corners")
      .flag("--beside", options.beside, "One world of as many threads beside it")
      .flag("--float", options.in_float, "In single precision")
      .flag("--blocks", options.blocks, "Contacts are handed over block by block, and none are kept")
      .number("--moving", options.moving, "One body in so many moves in a frame")
      .number("--threads", options.threads, "Threads of each rank")
      .read(argc, argv);
  MPI_Init(&argc, &argv);
  options.in_float ? graze::bench::run<float>(options) : graze::bench::run<double>(options);
  MPI_Finalize();
}
