// The world on many machines against one world: random scenes in which bodies come, go, move, and jump, with filters,
// triggers, fixed ground that joins, a mesh, a half-space and a large floor. Every rank plays the same script; rank 0
// also plays it in one world. Two updates of eight hand their contacts over in blocks of a few bodies. Run by mpirun
// with any number of ranks; exit code 0 when all answers have the same bits.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>

#include "graze/mpi/world.hpp"
#include "graze/world.hpp"
#include "mpi/exchange.hpp"
#include "mpi/pair_costs.hpp"
#include "mpi/redrawing.hpp"

namespace {

using namespace graze;

int rank = 0, ranks = 1;

[[noreturn]] void fail(const char* what, int seed, int step) {
  std::fprintf(stderr, "FAILED on %d ranks, seed %d, update %d: %s\n", ranks, seed, step, what);
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::abort();
}

template <class E>
bool same_bits(const E& a, const E& b) {
  return std::memcmp(&a, &b, sizeof(E)) == 0;
}
template <class T>
bool same(const Vec3<T>& a, const Vec3<T>& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

template <class T>
struct Play {
  Play(int s, bool with_events)
      : seed(s), events(with_events), random(static_cast<unsigned>(s)), many(MPI_COMM_WORLD, settings(with_events)) {
    const auto allow = [](BodyId a, BodyId b) { return (key_of(a) * 31 + key_of(b)) % 17 != 0; };
    one = std::make_unique<World<T>>(WorldSettings<T>{.margin = {}, .allow = allow, .points_per_pair = {}});
    make_shared_shapes();
  }

  static mpi::WorldSettings<T> settings(bool with_events) {
    mpi::WorldSettings<T> settings;
    settings.events = with_events;
    settings.bodies_per_block = 24;
    settings.allow = [](mpi::Key a, mpi::Key b) { return (a * 31 + b) % 17 != 0; };
    return settings;
  }
  /// Ordered as `World` orders bodies.
  static mpi::Key key_of(BodyId id) { return mpi::Key{id.index} << 20 | id.generation; }

  T number(double from, double to) {
    return static_cast<T>(from + (to - from) * static_cast<double>(random() % 100000) / 100000);
  }
  Pose<T> somewhere(double reach) {
    const Quat<T> turn{number(-1, 1), number(-1, 1), number(-1, 1), number(0.1, 1)};
    return {{number(-reach, reach), number(-1, 3), number(-reach, reach)}, normalized(turn)};
  }

  void make_shared_shapes() {
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 20; ++i) points.push_back({number(-0.6, 0.6), number(-0.6, 0.6), number(-0.6, 0.6)});
    shared.emplace_back(ConvexHull<T>(std::span<const Vec3<T>>(points)));
    // Ground of triangles that spans all ranks.
    std::vector<Vec3<T>> corners;
    std::vector<typename Mesh<T>::Index> triangles;
    constexpr std::uint32_t n = 12;
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        corners.push_back(
            {static_cast<T>(i) * T(1.7) - T(10), number(-0.2, 0.2) - T(1), static_cast<T>(j) * T(1.7) - T(10)});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t c = i * (n + 1) + j;
        triangles.push_back({c, c + 1, c + n + 2});
        triangles.push_back({c, c + n + 2, c + n + 1});
      }
    shared.emplace_back(Mesh<T>(corners, triangles));
    shared.emplace_back(Compound<T>(
        std::vector<Placed<T>>{{Box<T>({T(1), T(0.4), T(0.4)}), {}}, {Sphere<T>(T(0.4)), {{T(0.6), 0, 0}, {}}}}));
    for (const Shape<T>& shape : shared) many.share(shape);
  }

  Shape<T> some_shape() {
    switch (random() % 8) {
    case 0: return Sphere<T>(number(0.1, 0.6));
    case 1: return Capsule<T>(number(0.1, 0.8), number(0.1, 0.4), number(0.1, 0.4));
    case 2: return shared[0];
    case 3: return shared[2];
    case 4: return Shape<T>(Box<T>({number(0.2, 1), number(0.2, 1), number(0.2, 1)}), T(0.05));
    case 5: return Cylinder<T>(number(0.2, 1), number(0.1, 0.5), number(0.1, 0.5));
    default: return Box<T>({number(0.2, 1), number(0.2, 1), number(0.2, 1)});
    }
  }

  void add(const Body<T>& body) {
    const BodyId id = one->add(body);
    const mpi::Key key = key_of(id);
    // Anywhere: it finds its rank by itself.
    if (static_cast<int>(key % static_cast<unsigned>(ranks)) == rank) many.add(key, body);
    alive[key] = id;
  }
  void add_some() {
    Body<T> body{some_shape(), somewhere(9)};
    body.fixed = random() % 6 == 0;
    body.trigger = random() % 9 == 0;
    if (random() % 5 == 0) body.filter = {std::uint64_t{1} << random() % 3, 0x5, random() % 4 == 0 ? -1 : 0};
    add(body);
  }
  BodyId any() { return std::next(alive.begin(), static_cast<long>(random() % alive.size()))->second; }
  void move(BodyId id, const Pose<T>& pose) {
    one->move(id, pose);
    if (many.contains(key_of(id))) many.move(key_of(id), pose);
  }

  void begin() {
    Body<T> ground{shared[1], {}};
    ground.fixed = true;
    add(ground);
    Body<T> floor{Box<T>({T(30), T(0.2), T(30)}), {{0, T(-1.4), 0}, {}}};
    floor.fixed = true;
    add(floor);
    Body<T> below{HalfSpace<T>(), {{0, T(-1.5), 0}, {}}};
    below.fixed = true;
    add(below);
    // Boxes side by side, over which others slide as over one.
    for (int i = 0; i < 8; ++i) {
      Body<T> tile{Box<T>({T(2), T(1), T(2)}), {{static_cast<T>(2 * i - 8), T(-1), T(3)}, {}}};
      tile.fixed = true;
      add(tile);
    }
    for (int i = 0; i < 150; ++i) add_some();
  }

  void step() {
    for (int i = 0; i < 3; ++i)
      if (random() % 2 == 0) add_some();
    if (random() % 2 == 0) {
      const BodyId id = any();
      one->remove(id);
      if (many.contains(key_of(id))) many.remove(key_of(id));
      alive.erase(key_of(id));
    }
    const std::size_t moving = random() % 3 == 0 ? 3 : 60;
    for (std::size_t i = 0; i < moving; ++i) {
      const BodyId id = any();
      Pose<T> pose = one->bodies().body(id).pose;
      pose.translation = pose.translation + Vec3<T>{number(-0.2, 0.2), number(-0.2, 0.2), number(-0.2, 0.2)};
      move(id, pose);
    }
    if (random() % 3 == 0) move(any(), somewhere(9));
    if (random() % 5 == 0) {
      const BodyId id = any();
      const Filter filter{std::uint64_t{1} << random() % 3, 0x7, 0};
      one->set_filter(id, filter);
      if (many.contains(key_of(id))) many.set_filter(key_of(id), filter);
    }
    if (random() % 5 == 0) {
      const BodyId id = any();
      const Shape<T> shape = some_shape();
      one->set_shape(id, shape);
      if (many.contains(key_of(id))) many.set_shape(key_of(id), shape);
    }
    // Once in a while everything falls into one corner.
    if (random() % 25 == 0)
      for (int i = 0; i < 60; ++i) {
        Pose<T> pose = somewhere(2);
        pose.translation = pose.translation + Vec3<T>{T(7), 0, T(7)};
        move(any(), pose);
      }
  }

  /// Contacts that an update in blocks hands over on this rank, as one that keeps them has them.
  void update_in_blocks(int number, mpi::Gathered<T>& mine) {
    many.update([&](const mpi::ContactBlock<T>& block) {
      ++blocks;
      for (const mpi::KeyedPair& p : block.pairs) {
        if (&p != block.pairs.data() && std::pair((&p)[-1].a, (&p)[-1].b) >= std::pair(p.a, p.b))
          fail("a block that is not sorted", seed, number);
        mpi::KeyedPair& pair = mine.pairs.emplace_back(p);
        pair.first_manifold = static_cast<std::uint32_t>(mine.manifolds.size());
        for (std::uint32_t k = 0; k < p.manifold_count; ++k) {
          ContactManifold<T>& m = mine.manifolds.emplace_back(block.contacts.manifolds[p.first_manifold + k]);
          const auto points = block.contacts.points_of(m);
          m.first_point = static_cast<std::uint32_t>(mine.points.size());
          mine.points.insert(mine.points.end(), points.begin(), points.end());
        }
      }
    });
    if (!many.pairs().empty() || !many.contacts().pairs.empty()) fail("contacts are kept", seed, number);
  }

  /// All of that on the first rank, in the order of keys.
  mpi::Gathered<T> gather_blocks(const mpi::Gathered<T>& mine) {
    mpi::Together together(MPI_COMM_WORLD);
    const auto gathered = [&]<class E>(const std::vector<E>& some) {
      mpi::ByRank<E> all = together.nothing<E>();
      all[0] = some;
      return together.exchange(all);
    };
    const auto pairs = gathered(mine.pairs);
    const auto manifolds = gathered(mine.manifolds);
    const auto points = gathered(mine.points);
    mpi::Gathered<T> all;
    for (std::size_t r = 0; r < pairs.size(); ++r) {
      for (mpi::KeyedPair p : pairs[r]) {
        p.first_manifold += static_cast<std::uint32_t>(all.manifolds.size());
        all.pairs.push_back(p);
      }
      for (ContactManifold<T> m : manifolds[r]) {
        m.first_point += static_cast<std::uint32_t>(all.points.size());
        all.manifolds.push_back(m);
      }
      all.points.insert(all.points.end(), points[r].begin(), points[r].end());
    }
    std::sort(all.pairs.begin(), all.pairs.end(), [](const mpi::KeyedPair& p, const mpi::KeyedPair& q) {
      return std::pair(p.a, p.b) < std::pair(q.a, q.b);
    });
    all.events = many.gather().events;
    return all;
  }

  mpi::Gathered<T> update(int number) {
    if (number % 8 < 6) {
      many.update();
      return many.gather();
    }
    mpi::Gathered<T> mine;
    update_in_blocks(number, mine);
    return gather_blocks(mine);
  }

  void compare(int number) {
    one->update();
    const mpi::Gathered<T> found = update(number);
    const std::uint64_t mine = many.report().bodies;
    std::uint64_t all = 0;
    MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    if (all != alive.size()) fail("bodies that live nowhere or twice", seed, number);
    if (rank != 0) return;
    const ContactArrays<T>& wanted = one->contacts();
    const auto key = [&](std::uint32_t i) { return key_of(one->bodies().id(i)); };
    if (found.pairs.size() != wanted.pairs.size()) fail("another number of pairs", seed, number);
    for (std::size_t i = 0; i < found.pairs.size(); ++i) {
      const mpi::KeyedPair& f = found.pairs[i];
      const ContactPair<T>& w = wanted.pairs[i];
      const auto triggers = one->bodies().triggers();
      if (f.a != key(w.a) || f.b != key(w.b) || f.overlap != w.overlap || f.manifold_count != w.manifold_count ||
          f.trigger != ((triggers[w.a] | triggers[w.b]) != 0))
        fail("another pair", seed, number);
      for (std::uint32_t k = 0; k < w.manifold_count; ++k) {
        const ContactManifold<T>&m = found.manifolds[f.first_manifold + k], &n = wanted.manifolds[w.first_manifold + k];
        if (!same(m.normal, n.normal) || m.piece_a != n.piece_a || m.piece_b != n.piece_b ||
            m.point_count != n.point_count)
          fail("another manifold", seed, number);
        for (std::uint32_t j = 0; j < m.point_count; ++j) {
          const SolverPoint<T>&p = found.points[m.first_point + j], &q = wanted.points[n.first_point + j];
          if (!same(p.a, q.a) || !same(p.b, q.b) || !same_bits(p.distance, q.distance) || p.feature != q.feature)
            fail("another point", seed, number);
        }
      }
      contacts += w.manifold_count;
    }
    std::vector<mpi::KeyedEvent> wanted_events;
    for (const ContactEvent& e : one->events()) wanted_events.push_back({key_of(e.a), key_of(e.b), e.kind, e.trigger});
    std::sort(wanted_events.begin(), wanted_events.end(), [](const mpi::KeyedEvent& e, const mpi::KeyedEvent& f) {
      return std::pair(e.a, e.b) < std::pair(f.a, f.b);
    });
    for (const mpi::KeyedEvent& e : wanted_events) ends += e.kind == EventKind::end;
    if (!events) wanted_events.clear();
    if (found.events != wanted_events) fail("other events", seed, number);
  }

  int seed;
  bool events;
  std::mt19937 random;
  mpi::World<T> many;
  std::unique_ptr<World<T>> one;
  std::vector<Shape<T>> shared;
  std::map<mpi::Key, BodyId> alive;
  std::size_t contacts = 0, ends = 0, blocks = 0;
};

template <class T>
void play(int seed, int updates, bool events) {
  Play<T> play(seed, events);
  play.begin();
  std::uint64_t migrated = 0, ghosts = 0;
  for (int i = 0; i < updates; ++i) {
    play.compare(i);
    migrated += play.many.report().migrated;
    ghosts += play.many.report().ghosts;
    play.step();
  }
  std::uint64_t sums[3] = {migrated, ghosts, play.blocks}, all[3] = {};
  MPI_Allreduce(sums, all, 3, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  if (rank != 0) return;
  std::printf("%d ranks, seed %d: %zu manifolds, %zu ends, %zu migrations, %zu ghosts, %zu partitions: the same bits\n",
              ranks, seed, play.contacts, play.ends, all[0], all[1], play.many.report().partitions);
  // A test that saw none of these saw nothing.
  const auto n = static_cast<std::size_t>(updates);
  if (play.contacts < 20 * n || play.ends < n || (ranks > 1 && (all[0] < n || all[1] < 5 * n)) || all[2] < n)
    fail("a scene in which too little happened", seed, updates);
}

/// Borders that go to and fro without gain are left at last, and drawn again when something has moved.
void expect_drawings_to_end() {
  mpi::Redrawing redrawing(1.1);
  int drawings = 0;
  for (int update = 0; update < 100; ++update)
    if (redrawing.is_due(update % 2 == 0 ? 1.4 : 1.2, 1000)) {
      redrawing.drawn();
      ++drawings;
    }
  if (drawings == 0 || drawings > 20) fail("borders that are drawn for ever", 0, drawings);
  if (redrawing.is_due(1.2, 1000)) fail("borders that are drawn where nothing moved", 0, 0);
  if (!redrawing.is_due(1.2, 1001)) fail("borders that are not drawn where something moved", 0, 0);
  if (redrawing.is_due(1.05, 1002)) fail("borders that are drawn for a good balance", 0, 0);
}

/// A heap that lies still, so dense that a body touches some twenty others: borders come to rest. Costs are counted, so
/// that every run is the same.
void expect_borders_to_rest() {
  mpi::WorldSettings<double> counted;
  counted.measured = false;
  mpi::World<double> world(MPI_COMM_WORLD, counted);
  if (rank == 0)
    for (int i = 0; i < 1000; ++i) {
      // A little out of place, so that a border may cut through a layer.
      const Vec3d away = 0.01 * Vec3d{i * 7 % 11 * 1.0, i * 5 % 13 * 1.0, i * 3 % 17 * 1.0};
      const Vec3d place = 0.7 * Vec3d{i % 10 * 1.0, i / 10 % 10 * 1.0, i / 100 * 1.0} + away;
      world.add(static_cast<mpi::Key>(i), {Sphere<double>(0.6), {place, {}}});
    }
  std::uint64_t drawings = 0;
  for (int update = 0; update < 80; ++update) {
    world.update();
    if (update == 70) drawings = world.report().partitions;
  }
  if (drawings == 0 || world.report().partitions != drawings) fail("borders that do not rest", 0, ranks);
  // 125 bodies a rank at 8 ranks, nearly all of them at a border.
  if (world.report().imbalance > 1.4) fail("a heap shared out unevenly", 0, ranks);
}

/// Costs that ranks measured apart are one for all: the median.
void expect_costs_to_be_shared() {
  mpi::PairCosts costs(true);
  const float before = costs.of(3, 40);
  costs.note(40, 3, 1e-6 * (rank + 1));
  mpi::Together together(MPI_COMM_WORLD);
  costs.share(together);
  const double median = 1e-6 * ((ranks + 1) / 2);
  if (costs.of(3, 40) == before || costs.of(3, 40) != costs.of(40, 3)) fail("a cost that was not taken", 0, ranks);
  const auto times_usual = static_cast<double>(costs.of(3, 40) / costs.of(1, 1));
  if (std::abs(times_usual - median / 1e-7) > 1e-3 * ranks) fail("another cost", 0, ranks);
  costs.share(together);
  if (costs.of(3, 40) == before) fail("a cost that was forgotten", 0, ranks);
}

/// Hulls of many corners on one side and as many balls on the other: the pairs of the former cost many times as much,
/// so that who has them has fewer bodies.
void expect_dear_bodies_to_be_spread() {
  mpi::World<double> world(MPI_COMM_WORLD);
  std::vector<Vec3d> corners;
  for (int i = 0; i < 300; ++i) {
    const double height = 1 - (2 * i + 1) / 300.0, away = std::sqrt(1 - height * height);
    corners.push_back(0.6 * Vec3d{away * std::cos(2.4 * i), height, away * std::sin(2.4 * i)});
  }
  world.share(ConvexHull<double>(corners));
  if (rank == 0)
    for (int i = 0; i < 512; ++i) {
      // A little out of place, so that a border may cut through a layer.
      const Vec3d place{i % 8 + 0.01 * (i / 8 % 10), static_cast<double>(i / 8 % 8), static_cast<double>(i / 64)};
      const Shape<double> shape = place.x < 3.5 ? world.shared(0) : Shape<double>(Sphere<double>(0.6));
      world.add(static_cast<mpi::Key>(i), {shape, {place, {}}});
    }
  for (int update = 0; update < 12; ++update) world.update();
  std::uint64_t least = world.report().bodies, most = least;
  MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  if (ranks > 1 && 2 * most < 3 * least)
    fail("dear bodies that were shared out as cheap ones", static_cast<int>(least), static_cast<int>(most));
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int updates = argc > 1 ? std::atoi(argv[1]) : 200;
  expect_drawings_to_end();
  expect_borders_to_rest();
  expect_costs_to_be_shared();
  expect_dear_bodies_to_be_spread();
  play<double>(1, updates, true);
  play<float>(2, updates, true);
  play<double>(3, updates, false);
  MPI_Finalize();
}
