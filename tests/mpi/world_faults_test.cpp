// A world of many ranks where one of them is at fault, or where bodies stand as no one wants them.
//
//   mpirun -n RANKS mpi_world_faults_test              all cases, one after the other
//   mpirun -n RANKS mpi_world_faults_test forever      updates until it is killed; "running" when it runs
//
// Every error has to come on every rank: a rank that waits would hang the test, which has a time limit.
#include <mpi.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "graze/detail/validate.hpp"
#include "graze/mpi/world.hpp"
#include "graze/world.hpp"
#include "mpi/exchange.hpp"

namespace {

using namespace graze;

int rank = 0, ranks = 1;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "FAILED on rank %d of %d: %s\n", rank, ranks, what.c_str());
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::abort();
}

/// That `f` ends on every rank with the same error, which has these words in it.
template <class F>
void expect_common_error(const std::string& words, F&& f) {
  try {
    f();
  } catch (const mpi::CommonError& e) {
    if (std::string(e.what()).find(words) == std::string::npos) fail("\"" + words + "\" is not in: " + e.what());
    MPI_Barrier(MPI_COMM_WORLD);
    return;
  }
  fail("no error: " + words);
}

bool last() { return rank == ranks - 1; }
std::string of_last(const std::string& words) { return "rank " + std::to_string(ranks - 1) + ": " + words; }

Body<double> ball(const Vec3d& at) { return {Sphere<double>(0.5), {at, {}}}; }

/// A row of balls that touch, each on some rank.
void add_row(mpi::World<double>& world, mpi::Key count) {
  for (mpi::Key k = 0; k < count; ++k)
    if (static_cast<int>(k) % ranks == rank) world.add(k, ball({0.9 * static_cast<double>(k), 0, 0}));
}

void ranks_that_differ() {
  if (ranks > 1) {
    expect_common_error("float", [] {
      if (last())
        mpi::World<float> world(MPI_COMM_WORLD);
      else
        mpi::World<double> world(MPI_COMM_WORLD);
    });
    expect_common_error(of_last("the world: expected what rank 0 has"), [] {
      mpi::World<double> world(MPI_COMM_WORLD,
                               {.margin = last() ? 0.1 : 0.1 + 1e-15, .allow = {}, .points_per_pair = {}});
    });
    expect_common_error("shared shape 1: expected what rank 0 has, box", [] {
      mpi::World<double> world(MPI_COMM_WORLD);
      world.share(Sphere<double>(1));
      world.share(Box<double>({1, 1, last() ? 2.0 : 1.0}));
    });
  }
  expect_common_error(of_last("imbalance: expected a number >= 1"), [] {
    mpi::WorldSettings<double> settings;
    if (last()) settings.imbalance = std::numeric_limits<double>::quiet_NaN();
    mpi::World<double> world(MPI_COMM_WORLD, settings);
  });
  expect_common_error(of_last("bodies_per_block: expected a number >= 1"), [] {
    mpi::WorldSettings<double> settings;
    if (last()) settings.bodies_per_block = 0;
    mpi::World<double> world(MPI_COMM_WORLD, settings);
  });
}

void user_code_that_throws() {
  mpi::WorldSettings<double> settings;
  bool armed = false;
  settings.allow = [&](mpi::Key, mpi::Key) -> bool {
    if (armed && last()) throw std::runtime_error("no word on this pair");
    return true;
  };
  mpi::World<double> world(MPI_COMM_WORLD, settings);
  add_row(world, 50);
  world.update();
  armed = true;
  expect_common_error(of_last("no word on this pair"), [&] { world.update(); });
}

void two_bodies_of_one_key() {
  if (ranks == 1) return;
  mpi::World<double> world(MPI_COMM_WORLD);
  add_row(world, 50);
  if (last()) world.add((ranks - 1) == 7 ? 8 : 7 % ranks == ranks - 1 ? 6 : 7, ball({1, 0, 0}));
  expect_common_error("key: expected one that no body has", [&] { world.update(); });
}

/// Address space left to this process, in bytes, while it lives.
class Little {
 public:
  explicit Little(std::size_t bytes) {
    ::getrlimit(RLIMIT_AS, &had_);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit less = had_;
    less.rlim_cur = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + bytes;
    ::setrlimit(RLIMIT_AS, &less);
  }
  ~Little() { ::setrlimit(RLIMIT_AS, &had_); }
  Little(const Little&) = delete;
  Little& operator=(const Little&) = delete;

 private:
  rlimit had_{};
};

void message_that_does_not_fit() {
  if (ranks == 1) return;
  constexpr std::size_t large = std::size_t{1} << 28;
  mpi::Together together(MPI_COMM_WORLD);
  mpi::ByRank<char> to = together.nothing<char>();
  if (rank == 0) to.back().resize(large);
  std::optional<Little> little;
  if (last()) little.emplace(large / 4);
  expect_common_error(of_last("messages of " + std::to_string(large) + " bytes do not fit into memory"),
                      [&] { together.exchange(to); });
}

/// MPI counts in int: what is longer goes in pieces, and none is lost between them.
void message_longer_than_an_int() {
  constexpr std::size_t bytes = (std::size_t{1} << 33) + 17;
  std::size_t next = 0;
  mpi::each_piece(bytes, [&](std::size_t at, int count) {
    if (at != next || count <= 0) fail("a piece that does not follow the one before");
    next = at + static_cast<std::size_t>(count);
  });
  if (next != bytes) fail("pieces that are not the whole");
}

/// A body thrown to where there are no numbers is refused where it lives, and all goes on.
void bodies_thrown_to_infinity() {
  mpi::World<double> world(MPI_COMM_WORLD);
  add_row(world, 50);
  world.update();
  const std::size_t before = world.gather().pairs.size();
  for (const double far : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300})
    for (const mpi::Key key : world.keys()) {
      bool refused = false;
      try {
        world.move(key, {{0, far, 0}, {}});
      } catch (const InvalidValue&) {
        refused = true;
      }
      if (!refused) fail("a body that is nowhere");
    }
  world.update();
  const mpi::Gathered<double> found = world.gather();
  if (rank == 0 && (found.pairs.size() != before || before != 49)) fail("other pairs after what was refused");
}

template <class T>
struct Both {
  void add(const Body<T>& body) {
    const BodyId id = one.add(body);
    if (static_cast<int>(id.index) % ranks == rank) many.add(id.index, body);
  }
  /// Compares what touches, by the bits of the points.
  void compare(const char* what) {
    one.update();
    many.update();
    const mpi::Gathered<T> found = many.gather();
    if (rank != 0) return;
    const auto& wanted = one.contacts();
    if (found.pairs.size() != wanted.pairs.size() || found.points.size() != wanted.points.size())
      fail(std::string("other pairs: ") + what);
    for (std::size_t i = 0; i < found.pairs.size(); ++i) {
      if (found.pairs[i].a != wanted.pairs[i].a || found.pairs[i].b != wanted.pairs[i].b)
        fail(std::string("another pair: ") + what);
      for (std::uint32_t k = 0; k < found.pairs[i].manifold_count; ++k) {
        const auto& m = found.manifolds[found.pairs[i].first_manifold + k];
        const auto& n = wanted.manifolds[wanted.pairs[i].first_manifold + k];
        for (std::uint32_t j = 0; j < n.point_count; ++j)
          if (found.points[m.first_point + j].distance != wanted.points[n.first_point + j].distance ||
              found.points[m.first_point + j].a != wanted.points[n.first_point + j].a)
            fail(std::string("another point: ") + what);
      }
    }
  }

  World<T> one;
  mpi::World<T> many{MPI_COMM_WORLD};
};

template <class T>
void bodies_at_the_ends_of_space() {
  Both<T> both;
  const T far = largest_magnitude<T>;
  for (const T x : {-far, T(0), far})
    for (const T y : {-far, far})
      for (int i = 0; i < 2; ++i) both.add({Sphere<T>(T(1)), {{x, y, 0}, {}}});
  for (int i = 0; i < 40; ++i) both.add({Sphere<T>(T(1)), {{static_cast<T>(i), 0, 0}, {}}});
  both.add({Sphere<T>(far), {{0, far, 0}, {}}});
  for (int i = 0; i < 3; ++i) both.compare("at the ends of space");
}

template <class T>
void bodies_in_one_point() {
  Both<T> both;
  for (int i = 0; i < 120; ++i) both.add({Box<T>({T(1), T(1), T(1)}), {}});
  for (int i = 0; i < 5; ++i) both.compare("all in one point");
  const std::uint64_t drawn = both.many.report().partitions;
  for (int i = 0; i < 5; ++i) both.compare("all in one point");
  if (both.many.report().partitions > drawn) fail("borders drawn again and again where nothing can be shared out");
}

Shape<double> hull_of(std::uint64_t number) {
  std::vector<Vec3d> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({(i & 1) - 0.5, (i & 2) / 2 - 0.5 + 0.01 * static_cast<double>(number), (i & 4) / 4 - 0.5});
  return ConvexHull<double>(std::span<const Vec3d>(points));
}

/// Hulls that each rank makes where it needs them, and no others.
void shapes_from_a_source() {
  constexpr std::uint64_t count = 64;
  Both<double> both;
  std::uint64_t made = 0;
  const auto source = [&](std::uint64_t number) {
    if (number >= count) throw std::runtime_error("no shape " + std::to_string(number));
    ++made;
    return hull_of(number);
  };
  both.many.share_from(source);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Posed at{{0.9 * static_cast<double>(i), 0, 0}, {}};
    both.one.add({hull_of(i), at});
    if (static_cast<int>(i * static_cast<std::uint64_t>(ranks) / count) == rank)
      both.many.add(i, {both.many.shared(i), at});
  }
  for (int i = 0; i < 2; ++i) both.compare("shapes from a source");
  if (made > count / static_cast<std::uint64_t>(ranks) + 24 || (ranks < 3) != (made >= count / 2))
    fail(std::to_string(made) + " shapes made");
  bool refused = false;
  try {
    both.many.shared(count);
  } catch (const std::runtime_error&) {
    refused = true;
  }
  if (!refused) fail("a shape that is none");
}

/// A source that fails where a body is lent.
void source_that_fails() {
  if (ranks == 1) return;
  mpi::World<double> world(MPI_COMM_WORLD);
  world.share_from([](std::uint64_t number) -> Shape<double> {
    if (last()) throw std::runtime_error("shape " + std::to_string(number) + " cannot be read");
    return hull_of(number);
  });
  if (rank == 0)
    for (std::uint64_t i = 0; i < 40; ++i) world.add(i, {world.shared(i), {{static_cast<double>(i), 0, 0}, {}}});
  expect_common_error(of_last("shape "), [&] { world.update(); });
}

void forever() {
  mpi::World<double> world(MPI_COMM_WORLD);
  add_row(world, 500);
  for (int i = 0;; ++i) {
    world.update();
    if (i == 3 && rank == 0) std::puts("running"), std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (argc > 1 && std::string(argv[1]) == "forever") forever();
  ranks_that_differ();
  user_code_that_throws();
  two_bodies_of_one_key();
  message_that_does_not_fit();
  message_longer_than_an_int();
  bodies_thrown_to_infinity();
  bodies_at_the_ends_of_space<double>();
  bodies_at_the_ends_of_space<float>();
  bodies_in_one_point<double>();
  bodies_in_one_point<float>();
  shapes_from_a_source();
  source_that_fails();
  if (rank == 0) std::printf("%d ranks: every fault is known to all\n", ranks);
  MPI_Finalize();
}
