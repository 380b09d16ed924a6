#include "graze/mpi/world.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <tuple>

#include "graze/pairs.hpp"
#include "graze/world/bounds.hpp"
#include "mpi/body_record.hpp"
#include "mpi/keyed_events.hpp"
#include "mpi/partition.hpp"

namespace graze::mpi {

namespace {

/// What a pair of which contacts are looked for costs beside a body: some 100 ns beside 50.
constexpr float cost_of_pair = 2, cost_of_body = 1;
/// How much worse than after the last drawing the balance has to be, so that what cannot be shared out is left alone.
constexpr double worse = 1.02;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Counts the seconds since the last call.
class Clock {
 public:
  double lap() { return -std::exchange(since_, now()) + since_; }

 private:
  double since_ = now();
};

/// A point of both boxes, if they overlap.
template <class T>
Vec3<double> common_point(const Aabb<T>& a, const Aabb<T>& b) {
  return converted<double>(greatest(a.lower, b.lower));
}

}  // namespace

template <class T>
struct World<T>::Parts {
  Parts(MPI_Comm c, WorldSettings<T> s, Executor* e)
      : comm(c), settings(std::move(s)), executor(e ? e : &serial), partition(c) {}

  struct Owned {
    Body<T> body;  ///< as it was given: its rotation gets unit length where it stands, once, as in one world
    float weight = cost_of_body;
  };

  void check(Key key, bool there) const {
    if (owned.contains(key) != there)
      throw InvalidValue("key", there ? "that of a body that lives on this rank" : "one that no body has",
                         std::to_string(key));
  }
  void balance();
  void migrate();
  void lend();
  void find_pairs();
  void find_contacts();
  void find_bounds_here();
  void insert(const std::vector<BodyRecord<T>>& records, bool lent);
  std::vector<std::uint32_t> sort_local();

  MPI_Comm comm;
  WorldSettings<T> settings;
  SerialExecutor serial;
  Executor* executor;
  SharedShapes<T> shared;
  std::map<Key, Owned> owned;
  Partition partition;
  double drawn_imbalance = 1;

  // Of the last update: what stands here, lent or not, sorted by key.
  struct Local {
    Key key;
    Body<T> body;
    bool lent;
  };
  std::vector<Local> local;
  std::unique_ptr<BodyArrays<T>> arrays;
  std::vector<Aabb<T>> boxes;
  PairFinder<T> finder;
  std::vector<IdPair> candidates, mine;
  std::unique_ptr<ManifoldFinder<T>> manifolds;
  std::vector<KeyedPair> pairs;
  KeyedEvents events;
  WorldReport report;
};

/// Draws borders where there are none, or where the work is shared unevenly.
template <class T>
void World<T>::Parts::balance() {
  double sum = 0;
  for (const auto& [key, o] : owned) sum += static_cast<double>(o.weight);
  double most = 0, all = 0;
  MPI_Allreduce(&sum, &most, 1, MPI_DOUBLE, MPI_MAX, comm);
  MPI_Allreduce(&sum, &all, 1, MPI_DOUBLE, MPI_SUM, comm);
  report.imbalance = all > 0 ? most / all * size_of(comm) : 1;
  if (all == 0 || (partition.drawn() && report.imbalance <= std::max(settings.imbalance, drawn_imbalance * worse)))
    return;
  std::vector<Load> loads;
  loads.reserve(owned.size());
  for (const auto& [key, o] : owned)
    loads.push_back({converted<double>(o.body.pose.translation), static_cast<double>(o.weight)});
  partition.draw(loads);
  ++report.partitions;
  // What was reached.
  std::vector<double> by_rank(static_cast<std::size_t>(size_of(comm)), 0);
  for (const Load& load : loads) by_rank[static_cast<std::size_t>(partition.rank_of_point(load.place))] += load.weight;
  MPI_Allreduce(MPI_IN_PLACE, by_rank.data(), size_of(comm), MPI_DOUBLE, MPI_SUM, comm);
  drawn_imbalance = *std::max_element(by_rank.begin(), by_rank.end()) / all * size_of(comm);
}

/// Bodies go to live where their origins are.
template <class T>
void World<T>::Parts::migrate() {
  ByRank<BodyRecord<T>> to(static_cast<std::size_t>(size_of(comm)));
  if (partition.drawn())
    for (auto i = owned.begin(); i != owned.end();) {
      const int rank = partition.rank_of_point(converted<double>(i->second.body.pose.translation));
      if (rank == rank_of(comm)) {
        ++i;
        continue;
      }
      to[static_cast<std::size_t>(rank)].push_back(record_of(i->first, i->second.body, i->second.weight, shared));
      i = owned.erase(i);
      ++report.migrated;
    }
  for (const auto& some : exchanged(comm, to, report.bytes))
    for (const BodyRecord<T>& r : some) owned.insert_or_assign(r.key, Owned{body_of(r, shared), r.weight});
}

/// Appends what is not here yet.
template <class T>
void World<T>::Parts::insert(const std::vector<BodyRecord<T>>& records, bool lent) {
  for (const BodyRecord<T>& r : records) local.push_back({r.key, body_of(r, shared), lent});
}

/// Sorts what stands here; returns where each was put. Bodies that came twice stand here once.
template <class T>
std::vector<std::uint32_t> World<T>::Parts::sort_local() {
  std::vector<std::uint32_t> order(local.size()), place(local.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return local[i].key < local[j].key; });
  std::vector<Local> sorted;
  sorted.reserve(local.size());
  for (const std::uint32_t i : order) {
    if (sorted.empty() || sorted.back().key != local[i].key) sorted.push_back(std::move(local[i]));
    place[i] = static_cast<std::uint32_t>(sorted.size() - 1);
  }
  local = std::move(sorted);
  return place;
}

/// Puts what stands here into arrays and finds their bounds.
template <class T>
void World<T>::Parts::find_bounds_here() {
  arrays = std::make_unique<BodyArrays<T>>(settings.margin);
  for (const Local& l : local) arrays->add(l.body);
  boxes.resize(local.size());
  find_bounds<T>(arrays->shapes(), arrays->poses(), arrays->margins(), arrays->changes(), boxes, *executor);
}

/// What reaches into other regions is lent to their ranks.
template <class T>
void World<T>::Parts::lend() {
  local.clear();
  for (const auto& [key, o] : owned) local.push_back({key, o.body, false});
  if (size_of(comm) == 1) return find_bounds_here();
  find_bounds_here();
  ByRank<BodyRecord<T>> to(static_cast<std::size_t>(size_of(comm)));
  std::vector<int> ranks;
  for (std::size_t i = 0; i < local.size() && partition.drawn(); ++i) {
    const Aabb<double> box{converted<double>(boxes[i].lower), converted<double>(boxes[i].upper)};
    const Aabb<double>& region = partition.region();
    const auto inside = [](const Vec3<double>& a, const Vec3<double>& b) {
      return a.x < b.x && a.y < b.y && a.z < b.z;
    };
    if (inside(region.lower, box.lower) && inside(box.upper, region.upper)) continue;
    ranks.clear();
    partition.ranks_of_box(box, ranks);
    for (const int r : ranks)
      if (r != rank_of(comm))
        to[static_cast<std::size_t>(r)].push_back(record_of(local[i].key, local[i].body, 0.0F, shared));
  }
  for (const auto& some : exchanged(comm, to, report.bytes)) insert(some, true);
  sort_local();
  find_bounds_here();
}

/// The pairs whose contacts are this rank's to find. Two that move are found where a common point of their bounds lies.
/// What moves and what stands still are found where the former lives, with all else that stands beside: the latter is
/// lent there, too, by the rank of their common point.
template <class T>
void World<T>::Parts::find_pairs() {
  finder.find(boxes, candidates, *executor);
  const auto fixed = arrays->fixed();
  const auto is_pair = [&](std::uint32_t a, std::uint32_t b) {
    return (fixed[a] & fixed[b]) == 0 && (!settings.allow || settings.allow(local[a].key, local[b].key));
  };
  keep_allowed(candidates, arrays->filters(), is_pair);
  mine.clear();
  struct Sent {
    BodyRecord<T> standing;
    Key moving;
  };
  ByRank<Sent> to(static_cast<std::size_t>(size_of(comm)));
  for (const IdPair& p : candidates) {
    const bool ground = (fixed[p.a] | fixed[p.b]) != 0;
    const std::uint32_t moving = fixed[p.a] != 0 ? p.b : p.a, standing = fixed[p.a] != 0 ? p.a : p.b;
    if (ground) {
      if (!local[moving].lent) {
        mine.push_back(p);
        continue;
      }
    } else if (!local[p.a].lent && !local[p.b].lent && size_of(comm) == 1) {
      mine.push_back(p);
      continue;
    }
    if (partition.rank_of_point(common_point(boxes[p.a], boxes[p.b])) != rank_of(comm)) continue;
    if (!ground) {
      mine.push_back(p);
      continue;
    }
    const int owner = partition.rank_of_point(converted<double>(local[moving].body.pose.translation));
    to[static_cast<std::size_t>(owner)].push_back(
        {record_of(local[standing].key, local[standing].body, 0.0F, shared), local[moving].key});
  }
  const ByRank<Sent> from = exchanged(comm, to, report.bytes);
  std::vector<std::pair<Key, Key>> more;
  const auto place_of = [&](Key key) {
    return static_cast<std::uint32_t>(
        std::lower_bound(local.begin(), local.end(), key, [](const Local& l, Key k) { return l.key < k; }) -
        local.begin());
  };
  const std::size_t before = local.size();
  for (const auto& some : from)
    for (const Sent& s : some) {
      more.emplace_back(s.standing.key, s.moving);
      const std::uint32_t at = place_of(s.standing.key);
      if (at == before || local[at].key != s.standing.key) more.back().first = s.standing.key;
    }
  if (more.empty()) return;
  for (const auto& some : from)
    for (const Sent& s : some) local.push_back({s.standing.key, body_of(s.standing, shared), true});
  const std::vector<std::uint32_t> place = sort_local();
  for (IdPair& p : mine) p = {place[p.a], place[p.b]};
  for (const auto& [standing, moving] : more) {
    const std::uint32_t i = place_of(standing), j = place_of(moving);
    mine.push_back({std::min(i, j), std::max(i, j)});
  }
  std::sort(mine.begin(), mine.end());
  mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
  find_bounds_here();
}

template <class T>
void World<T>::Parts::find_contacts() {
  manifolds = std::make_unique<ManifoldFinder<T>>(settings.points_per_pair.value_or(ManifoldFinder<T>::all_points));
  manifolds->find(*arrays, mine, *executor);
  pairs.clear();
  for (const ContactPair<T>& p : manifolds->contacts().pairs)
    pairs.push_back({local[p.a].key, local[p.b].key, p.overlap, p.first_manifold, p.manifold_count});
  // What each body cost is what its rank is charged for next time.
  for (auto& [key, o] : owned) o.weight = cost_of_body;
  for (const IdPair& p : mine)
    for (const std::uint32_t i : {p.a, p.b})
      if (const auto o = local[i].lent ? owned.end() : owned.find(local[i].key); o != owned.end())
        o->second.weight += cost_of_pair / 2;
}

template <class T>
World<T>::World(MPI_Comm comm, WorldSettings<T> settings, Executor* executor) {
  if (!(settings.imbalance >= 1)) throw InvalidValue("imbalance", "a number >= 1", std::to_string(settings.imbalance));
  static_cast<void>(BodyArrays<T>(settings.margin));
  parts_ = std::make_unique<Parts>(comm, std::move(settings), executor);
}

template <class T>
World<T>::~World() = default;

template <class T>
void World<T>::share(const Shape<T>& shape) {
  parts_->shared.add(shape);
}

template <class T>
void World<T>::add(Key key, const Body<T>& body) {
  parts_->check(key, false);
  Space<T>::checked(body.pose);
  Space<T>::check(body.linear, body.angular);
  record_of(key, body, 0.0F, parts_->shared);
  parts_->owned.emplace(key, typename Parts::Owned{body});
}

template <class T>
bool World<T>::contains(Key key) const {
  return parts_->owned.contains(key);
}

template <class T>
void World<T>::remove(Key key) {
  parts_->check(key, true);
  parts_->owned.erase(key);
}

template <class T>
void World<T>::move(Key key, const Pose<T>& pose) {
  parts_->check(key, true);
  Space<T>::checked(pose);
  parts_->owned.at(key).body.pose = pose;
}

template <class T>
void World<T>::set_filter(Key key, const Filter& filter) {
  parts_->check(key, true);
  parts_->owned.at(key).body.filter = filter;
}

template <class T>
void World<T>::set_shape(Key key, const Shape<T>& shape) {
  parts_->check(key, true);
  Body<T> changed = parts_->owned.at(key).body;
  changed.shape = shape;
  record_of(key, changed, 0.0F, parts_->shared);
  parts_->owned.at(key).body = std::move(changed);
}

template <class T>
Body<T> World<T>::body(Key key) const {
  parts_->check(key, true);
  Body<T> body = parts_->owned.at(key).body;
  body.pose = Space<T>::checked(body.pose);
  return body;
}

template <class T>
std::vector<Key> World<T>::keys() const {
  std::vector<Key> keys;
  for (const auto& [key, o] : parts_->owned) keys.push_back(key);
  return keys;
}

template <class T>
void World<T>::update() {
  Parts& p = *parts_;
  p.report = {.partitions = p.report.partitions};
  Clock clock;
  p.balance();
  p.migrate();
  p.report.partition = clock.lap();
  p.lend();
  p.report.exchange = clock.lap();
  p.find_pairs();
  p.report.broad = clock.lap();
  p.find_contacts();
  p.report.contacts = clock.lap();
  std::vector<std::uint8_t> triggers;
  for (const ContactPair<T>& c : p.manifolds->contacts().pairs)
    triggers.push_back(p.arrays->triggers()[c.a] | p.arrays->triggers()[c.b]);
  p.events.update(p.comm, p.pairs, triggers, p.report.bytes);
  p.report.events = clock.lap();
  p.report.bodies = p.owned.size();
  p.report.ghosts = p.local.size() - p.owned.size();
  p.report.candidates = p.mine.size();
  p.report.pairs = p.pairs.size();
}

template <class T>
std::span<const KeyedPair> World<T>::pairs() const {
  return parts_->pairs;
}

template <class T>
const ContactArrays<T>& World<T>::contacts() const {
  return parts_->manifolds->contacts();
}

template <class T>
std::span<const KeyedEvent> World<T>::events() const {
  return parts_->events.events();
}

template <class T>
const WorldReport& World<T>::report() const {
  return parts_->report;
}

template <class T>
std::size_t World<T>::memory() const {
  const Parts& p = *parts_;
  return p.owned.size() * (sizeof(std::pair<Key, typename Parts::Owned>) + 4 * sizeof(void*)) +
         p.local.capacity() * sizeof(p.local[0]) + (p.arrays ? p.arrays->memory() : 0) +
         p.boxes.capacity() * sizeof(p.boxes[0]) + p.finder.memory() +
         (p.candidates.capacity() + p.mine.capacity()) * sizeof(IdPair) + (p.manifolds ? p.manifolds->memory() : 0) +
         p.pairs.capacity() * sizeof(KeyedPair) + p.events.memory();
}

template <class T>
Gathered<T> World<T>::gather(int root) const {
  const Parts& p = *parts_;
  const auto ranks = static_cast<std::size_t>(size_of(p.comm)), to = static_cast<std::size_t>(root);
  std::uint64_t bytes = 0;
  const auto gathered = [&]<class E>(std::span<const E> some) {
    ByRank<E> all(ranks);
    all[to].assign(some.begin(), some.end());
    return exchanged(p.comm, all, bytes);
  };
  const ContactArrays<T>& found = p.manifolds->contacts();
  const auto pairs = gathered(std::span<const KeyedPair>(p.pairs));
  const auto manifolds = gathered(std::span<const ContactManifold<T>>(found.manifolds));
  const auto points = gathered(std::span<const SolverPoint<T>>(found.points));
  const auto events = gathered(std::span<const KeyedEvent>(p.events.events()));
  Gathered<T> out;
  std::vector<std::tuple<Key, Key, std::size_t, std::size_t>> order;
  for (std::size_t r = 0; r < ranks; ++r)
    for (std::size_t i = 0; i < pairs[r].size(); ++i) order.emplace_back(pairs[r][i].a, pairs[r][i].b, r, i);
  std::sort(order.begin(), order.end());
  for (const auto& [a, b, r, i] : order) {
    KeyedPair pair = pairs[r][i];
    const std::size_t first = std::exchange(pair.first_manifold, static_cast<std::uint32_t>(out.manifolds.size()));
    for (std::size_t k = first; k < first + pair.manifold_count; ++k) {
      ContactManifold<T> m = manifolds[r][k];
      const std::size_t first_point = std::exchange(m.first_point, static_cast<std::uint32_t>(out.points.size()));
      for (std::size_t n = 0; n < m.point_count; ++n) out.points.push_back(points[r][first_point + n]);
      out.manifolds.push_back(m);
    }
    out.pairs.push_back(pair);
  }
  for (const auto& some : events) out.events.insert(out.events.end(), some.begin(), some.end());
  std::sort(out.events.begin(), out.events.end(),
            [](const KeyedEvent& e, const KeyedEvent& f) { return std::pair(e.a, e.b) < std::pair(f.a, f.b); });
  return out;
}

template class World<float>;
template class World<double>;

}  // namespace graze::mpi
