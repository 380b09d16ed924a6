#include <algorithm>
#include <limits>
#include <utility>

#include "graze/query.hpp"
#include "graze/world/bounds.hpp"
#include "mpi/world_parts.hpp"

namespace graze::mpi {

namespace {

/// How much worse than after the last drawing the balance has to be, so that what cannot be shared out is left alone.
constexpr double worse = 1.02;

}  // namespace

/// Draws borders where there are none, or where the work is shared unevenly.
template <class T>
void World<T>::Parts::balance(Together& together) {
  owned.settle();
  double sum = 0;
  for (const auto& o : owned.settled()) sum += static_cast<double>(o.weight);
  double most = 0, all = 0;
  MPI_Allreduce(&sum, &most, 1, MPI_DOUBLE, MPI_MAX, comm);
  MPI_Allreduce(&sum, &all, 1, MPI_DOUBLE, MPI_SUM, comm);
  report.imbalance = all > 0 ? most / all * size_of(comm) : 1;
  if (all == 0 || (partition.drawn() && report.imbalance <= std::max(settings.imbalance, drawn_imbalance * worse)))
    return;
  std::vector<Load> loads;
  together.alone([&] {
    loads.reserve(owned.size());
    for (const auto& o : owned.settled())
      loads.push_back({converted<double>(o.body.pose.translation), static_cast<double>(o.weight)});
  });
  together.meet();
  partition.draw(loads);
  ++report.partitions;
  // What was reached.
  std::vector<double> by_rank(static_cast<std::size_t>(size_of(comm)), 0);
  for (const Load& load : loads) by_rank[static_cast<std::size_t>(partition.rank_of_point(load.place))] += load.weight;
  MPI_Allreduce(MPI_IN_PLACE, by_rank.data(), size_of(comm), MPI_DOUBLE, MPI_SUM, comm);
  drawn_imbalance = *std::max_element(by_rank.begin(), by_rank.end()) / all * size_of(comm);
}

template <class T>
void World<T>::Parts::find_who_leaves(ByRank<BodyRecord<T>>& to) {
  if (!partition.drawn()) return;
  const int here = rank_of(comm);
  for (auto& o : owned.settled()) {
    const int rank = partition.rank_of_point(converted<double>(o.body.pose.translation));
    if (rank == here) continue;
    to[static_cast<std::size_t>(rank)].push_back(record_of(o.key, o.body, o.weight, shared));
    owned.remove(o);
    ++report.migrated;
  }
}

/// Bodies go to live where their origins are.
template <class T>
void World<T>::Parts::migrate(Together& together) {
  ByRank<BodyRecord<T>> to = together.nothing<BodyRecord<T>>();
  together.alone([&] { find_who_leaves(to); });
  const ByRank<BodyRecord<T>> from = together.exchange(to);
  together.alone([&] {
    for (const auto& some : from)
      for (const BodyRecord<T>& r : some) {
        check(r.key, false);
        owned.add(r.key, body_of(r, shared), r.weight);
      }
    owned.settle();
  });
}

/// Sorts what stands here; returns where each was put. Bodies that came again stand here once.
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

template <class T>
std::uint32_t World<T>::Parts::place_of(Key key) const {
  const auto found = std::lower_bound(local.begin(), local.end(), key, [](const Local& l, Key k) { return l.key < k; });
  return static_cast<std::uint32_t>(found - local.begin());
}

template <class T>
void World<T>::Parts::take_in(const BodyRecord<T>& record) {
  local.push_back({record.key, &guests.emplace_back(body_of(record, shared)), true});
}

/// Puts what stands here into arrays and finds its bounds.
template <class T>
void World<T>::Parts::find_bounds_here() {
  arrays = std::make_unique<BodyArrays<T>>(settings.margin);
  for (const Local& l : local) arrays->add(*l.body);
  boxes.resize(local.size());
  find_bounds<T>(arrays->shapes(), arrays->poses(), arrays->margins(), arrays->changes(), boxes, *executor);
}

/// Whether a ball about a body's origin, which holds its bounds, is inside the region: that of most is, and spares the
/// search for their bounds before all are here.
template <class T>
bool World<T>::Parts::is_far_from_borders(typename OwnedBodies<T>::Entry& o) const {
  const Body<T>& body = o.body;
  if (o.reach == OwnedBodies<T>::unknown) {
    const Aabb<T> box = bounds(body.shape, Pose<T>{});
    const T margin = settings.margin.value_or(contact_margin(body.shape, body.shape));
    o.reach = length(converted<double>(greatest(-box.lower, box.upper))) + static_cast<double>(margin);
  }
  const Vec3<double> at = converted<double>(body.pose.translation);
  // Bounds are rounded outward in T: by some units in the last place of where they are and of how large they are.
  constexpr double rounding = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
  const double reach = o.reach + rounding * (max_abs(at) + o.reach);
  const Aabb<double>& region = partition.region();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(region.lower[axis] < at[axis] - reach && at[axis] + reach < region.upper[axis])) return false;
  return true;
}

template <class T>
void World<T>::Parts::find_who_is_lent(ByRank<BodyRecord<T>>& to) {
  guests.clear();
  local.clear();
  if (to.size() > 1 && partition.drawn()) {
    for (auto& o : owned.settled())
      if (!is_far_from_borders(o)) local.push_back({o.key, &o.body, false});
    find_bounds_here();
    std::vector<int> ranks;
    for (std::size_t i = 0; i < local.size(); ++i) {
      ranks.clear();
      partition.ranks_of_box({converted<double>(boxes[i].lower), converted<double>(boxes[i].upper)}, ranks);
      for (const int r : ranks)
        if (r != rank_of(comm))
          to[static_cast<std::size_t>(r)].push_back(record_of(local[i].key, *local[i].body, 0.0F, shared));
    }
    local.clear();
  }
  for (const auto& o : owned.settled()) local.push_back({o.key, &o.body, false});
}

/// What reaches into other regions is lent to their ranks.
template <class T>
void World<T>::Parts::lend(Together& together) {
  ByRank<BodyRecord<T>> to = together.nothing<BodyRecord<T>>();
  together.alone([&] { find_who_is_lent(to); });
  const ByRank<BodyRecord<T>> from = together.exchange(to);
  together.alone([&] {
    for (const auto& some : from)
      for (const BodyRecord<T>& r : some) {
        check(r.key, false);
        take_in(r);
      }
    const auto by_key = [](const Local& a, const Local& b) { return a.key < b.key; };
    const auto own = local.begin() + static_cast<std::ptrdiff_t>(owned.size());
    std::sort(own, local.end(), by_key);
    std::inplace_merge(local.begin(), own, local.end(), by_key);
    find_bounds_here();
  });
}

template <class T>
void World<T>::Parts::find_own_pairs(ByRank<Sent>& to) {
  finder.find(boxes, candidates, *executor);
  const auto fixed = arrays->fixed();
  const auto is_pair = [&](std::uint32_t a, std::uint32_t b) {
    return (fixed[a] & fixed[b]) == 0 && (!settings.allow || settings.allow(local[a].key, local[b].key));
  };
  keep_allowed(candidates, arrays->filters(), is_pair);
  mine.clear();
  const auto found_here = [&](const IdPair& p) {
    return to.size() == 1 || partition.rank_of_point(common_point(boxes[p.a], boxes[p.b])) == rank_of(comm);
  };
  for (const IdPair& p : candidates) {
    if ((fixed[p.a] | fixed[p.b]) == 0) {
      if (found_here(p)) mine.push_back(p);
      continue;
    }
    const Local &moving = local[fixed[p.a] != 0 ? p.b : p.a], &standing = local[fixed[p.a] != 0 ? p.a : p.b];
    if (!moving.lent) {
      mine.push_back(p);
    } else if (found_here(p)) {
      const int home = partition.rank_of_point(converted<double>(moving.body->pose.translation));
      to[static_cast<std::size_t>(home)].push_back({record_of(standing.key, *standing.body, 0.0F, shared), moving.key});
    }
  }
}

/// Adds the pairs that other ranks found for bodies that live here, with the fixed bodies that are not here yet.
template <class T>
void World<T>::Parts::take_pairs(const ByRank<Sent>& from) {
  const std::size_t before = local.size();
  for (const auto& some : from)
    for (const Sent& s : some) take_in(s.standing);
  if (local.size() == before) return;
  const std::vector<std::uint32_t> place = sort_local();
  for (IdPair& p : mine) p = {place[p.a], place[p.b]};
  for (const auto& some : from)
    for (const Sent& s : some) {
      const std::uint32_t i = place_of(s.standing.key), j = place_of(s.moving);
      mine.push_back({std::min(i, j), std::max(i, j)});
    }
  std::sort(mine.begin(), mine.end());
  mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
  find_bounds_here();
}

/// The pairs whose contacts are this rank's to find. Two that move are found where a common point of their bounds lies.
/// What moves and what stands still are found where the former lives, with all else that stands beside: the latter is
/// lent there, too, by the rank of their common point.
template <class T>
void World<T>::Parts::find_pairs(Together& together) {
  ByRank<Sent> to = together.nothing<Sent>();
  together.alone([&] { find_own_pairs(to); });
  const ByRank<Sent> from = together.exchange(to);
  together.alone([&] { take_pairs(from); });
}

template <class T>
void World<T>::Parts::find_contacts() {
  manifolds.find(*arrays, mine, *executor);
  pairs.clear();
  for (const ContactPair<T>& p : manifolds.contacts().pairs)
    pairs.push_back({local[p.a].key, local[p.b].key, p.overlap,
                     (arrays->triggers()[p.a] | arrays->triggers()[p.b]) != 0, p.first_manifold, p.manifold_count});
  // What each body cost is what its rank is charged for next time.
  std::vector<float> costs(local.size(), cost_of_body);
  for (const IdPair& p : mine) {
    costs[p.a] += cost_of_pair / 2;
    costs[p.b] += cost_of_pair / 2;
  }
  auto o = owned.settled().begin();
  for (std::size_t i = 0; i < local.size(); ++i)
    if (!local[i].lent) (o++)->weight = costs[i];
}

template <class T>
void World<T>::Parts::find_events(Together& together) {
  if (settings.events) events.update(together, pairs);
  together.meet();
}

template <class T>
void World<T>::update() {
  Parts& p = *parts_;
  p.report = {.partitions = p.report.partitions};
  Together together(p.comm);
  Clock clock;
  p.balance(together);
  p.migrate(together);
  p.report.partition = clock.lap();
  p.lend(together);
  p.report.exchange = clock.lap();
  p.find_pairs(together);
  p.report.broad = clock.lap();
  together.alone([&] { p.find_contacts(); });
  p.report.contacts = clock.lap();
  p.find_events(together);
  p.report.events = clock.lap();
  p.report.bodies = p.owned.size();
  p.report.ghosts = p.local.size() - p.owned.size();
  p.report.candidates = p.mine.size();
  p.report.pairs = p.pairs.size();
  p.report.bytes = together.bytes();
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void World<T>::Parts::balance(Together&);                                                                   \
  template void World<T>::Parts::migrate(Together&);                                                                   \
  template void World<T>::Parts::find_events(Together&);                                                               \
  template void World<T>::update();
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::mpi
