#include <algorithm>
#include <iterator>
#include <utility>

#include "mpi/world_parts.hpp"

namespace graze::mpi {

namespace {

/// The most loads of a rank by which borders are drawn, since Zoltan holds 200 to 400 bytes a load: of more bodies
/// every second, third and so on stands for those after it, by which the balance is off by some thousandths.
constexpr std::size_t most_loads = std::size_t{1} << 18;

}  // namespace

/// Charges the pairs of the last update to its bodies, by costs that all ranks agree on.
template <class T>
void World<T>::Parts::charge_pairs(Together& together) {
  const std::span<const IdPair> last(mine);
  together.alone([&] {
    if (arrays) pair_costs.measure(*arrays, last);
  });
  pair_costs.share(together);
  together.alone([&] {
    if (!arrays) return;
    std::vector<float> costs(keys.size(), cost_of_body);
    pair_costs.charge(*arrays, last, [&](const IdPair& p, float cost) {
      charge_pair(cost, standing[p.a] == lives, standing[p.b] == lives, costs[p.a], costs[p.b]);
    });
    // The mean with the cost before: under new borders others are charged, and borders by that alone would go to and
    // fro.
    for (auto& o : owned.settled())
      if (o.place != nowhere) o.cost = o.cost > 0 ? (2 * o.cost + costs[o.place]) / 3 : costs[o.place];
  });
}

/// Gives bodies that are new the mean cost of the others; returns the cost of all bodies of this rank.
template <class T>
double World<T>::Parts::expected_cost(Together& together) {
  double known[2] = {0, 0};  // cost, and how many
  together.alone([&] {
    for (const auto& o : owned.settled()) {
      known[0] += static_cast<double>(o.cost);
      known[1] += o.cost > 0 ? 1 : 0;
    }
  });
  MPI_Allreduce(MPI_IN_PLACE, known, 2, MPI_DOUBLE, MPI_SUM, comm);
  const auto mean = known[1] > 0 ? static_cast<float>(known[0] / known[1]) : cost_of_body;
  double sum = 0;
  together.alone([&] {
    for (auto& o : owned.settled()) {
      if (!(o.cost > 0)) o.cost = mean;
      sum += static_cast<double>(o.cost);
    }
  });
  return sum;
}

/// Draws borders where there are none, or where the work is shared unevenly.
template <class T>
void World<T>::Parts::balance(Together& together) {
  owned.settle();
  charge_pairs(together);
  const double sum = expected_cost(together);
  double most = 0;
  MPI_Allreduce(&sum, &most, 1, MPI_DOUBLE, MPI_MAX, comm);
  double of_all[] = {sum, static_cast<double>(owned.size()), static_cast<double>(candidates_before)};
  MPI_Allreduce(MPI_IN_PLACE, of_all, 3, MPI_DOUBLE, MPI_SUM, comm);
  const double all = of_all[0], work = of_all[1] + of_all[2];
  report.imbalance = all > 0 ? most / all * size_of(comm) : 1;
  const bool is_due = redrawing.is_due(report.imbalance, work);
  if (all == 0 || (partition.drawn() && !is_due)) return;
  std::vector<Load> loads;
  together.alone([&] {
    const auto& bodies = owned.settled();
    const std::size_t step = bodies.size() / most_loads + 1;
    loads.reserve(bodies.size() / step + 1);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (i % step == 0) loads.push_back({converted<double>(bodies[i].body.pose.translation), 0});
      loads.back().weight += static_cast<double>(bodies[i].cost);
    }
  });
  together.meet();
  partition.draw(loads);
  redrawing.drawn();
  ++report.partitions;
}

/// Finds bodies that leave, some at a time from this key on; returns the key from which on to go on, or nothing.
template <class T>
std::optional<Key> World<T>::Parts::find_who_leaves(Key first, ByRank<BodyRecord<T>>& to) {
  if (!partition.drawn() || to.size() == 1) return {};
  const int here = rank_of(comm);
  std::size_t found = 0;
  for (auto o = owned.from(first); o != owned.settled().end(); ++o) {
    if (o->gone) continue;
    if (found == settings.bodies_per_block) {
      report.migrated += found;
      return o->key;
    }
    const int rank = partition.rank_of_point(converted<double>(o->body.pose.translation));
    if (rank == here) continue;
    auto& record = to[static_cast<std::size_t>(rank)].emplace_back(record_of(o->key, o->body, o->cost, shared));
    record.reshaped = o->reshaped ? 1 : 0;
    owned.remove(*o);
    ++found;
  }
  report.migrated += found;
  return {};
}

/// Moves bodies to the ranks of their origins: in rounds, so that messages stay small where borders were drawn anew.
template <class T>
void World<T>::Parts::migrate(Together& together) {
  std::optional<Key> first = 0;
  for (int more = 1; more != 0;) {
    ByRank<BodyRecord<T>> to = together.nothing<BodyRecord<T>>();
    together.alone([&] {
      if (first) first = find_who_leaves(*first, to);
    });
    const ByRank<BodyRecord<T>> from = together.exchange(to);
    together.alone([&] {
      for (const auto& some : from)
        for (const BodyRecord<T>& r : some) {
          check(r.key, false);
          owned.add(r.key, body_of(r, shared), r.cost, r.reshaped != 0);
        }
    });
    more = first ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &more, 1, MPI_INT, MPI_MAX, comm);
  }
  together.alone([&] { owned.settle(); });
}

template <class T>
void World<T>::Parts::find_own_pairs(ByRank<Sent>& to) {
  std::vector<std::uint32_t> changes;
  const std::span<const std::uint32_t> now = arrays->changes();
  std::set_union(now.begin(), now.end(), late.begin(), late.end(), std::back_inserter(changes));
  late.clear();
  const auto fixed = arrays->fixed();
  const std::span<const IdPair> candidates = finder->find(boxes, arrays->alive(), fixed, changes, *executor);
  const bool all_may = !arrays->filtered() && !settings.allow, one_rank = to.size() == 1;
  const auto may_meet = [&](const IdPair& p) {
    return all_may || (may_collide(arrays->filters()[p.a], arrays->filters()[p.b]) &&
                       (!settings.allow || settings.allow(keys[p.a], keys[p.b])));
  };
  const auto found_here = [&](const IdPair& p) {
    return one_rank || partition.rank_of_point(common_point(boxes[p.a], boxes[p.b])) == rank_of(comm);
  };
  mine.clear();
  for (const IdPair& p : candidates) {
    if (standing[p.a] == away || standing[p.b] == away || !may_meet(p)) continue;
    if ((fixed[p.a] | fixed[p.b]) == 0) {
      if (found_here(p)) mine.push_back(p);
      continue;
    }
    const std::uint32_t moving = fixed[p.a] != 0 ? p.b : p.a, still = fixed[p.a] != 0 ? p.a : p.b;
    if (standing[moving] == lives) {
      mine.push_back(p);
    } else if (found_here(p)) {
      const int home = partition.rank_of_point(converted<double>(arrays->poses()[moving].translation));
      const Body<T> ground = arrays->body(arrays->id(still));
      to[static_cast<std::size_t>(home)].push_back({record_of(keys[still], ground, 0.0F, shared), keys[moving]});
    }
  }
}

/// Adds the pairs that other ranks found for bodies that live here, with the fixed bodies that are not here yet.
template <class T>
void World<T>::Parts::take_pairs(const ByRank<Sent>& from) {
  std::vector<BodyRecord<T>> ground;
  for (const auto& some : from)
    for (const Sent& s : some) ground.push_back(s.standing);
  if (ground.empty()) return;
  take_ground(ground);
  const auto own = static_cast<std::ptrdiff_t>(mine.size());
  for (const auto& some : from)
    for (const Sent& s : some) {
      const std::uint32_t i = place_of(s.standing.key), j = place_of(s.moving);
      mine.push_back({std::min(i, j), std::max(i, j)});
    }
  std::sort(mine.begin() + own, mine.end());
  std::inplace_merge(mine.begin(), mine.begin() + own, mine.end());
  mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
}

/// Finds the pairs whose contacts this rank has to find. Two that move are found where a common point of their bounds
/// lies. One that moves and one that is fixed are found where the former lives, with all else that stands beside: the
/// latter is lent there, too, by the rank of their common point.
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
    pairs.push_back({keys[p.a], keys[p.b], p.overlap, (arrays->triggers()[p.a] | arrays->triggers()[p.b]) != 0,
                     p.first_manifold, p.manifold_count});
  arrays->settle();
}

template <class T>
void World<T>::Parts::find_events(Together& together) {
  if (settings.events) events.update(together, pairs);
  together.meet();
}

template <class T>
void World<T>::update() {
  Parts& p = *parts_;
  p.candidates_before = p.report.candidates;
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
  p.report.ghosts = static_cast<std::uint64_t>(std::count(p.standing.begin(), p.standing.end(), Parts::lent));
  p.report.candidates = p.mine.size();
  p.report.pairs = p.pairs.size();
  p.report.bytes = together.bytes();
  p.report.work = together.work();
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void World<T>::Parts::charge_pairs(Together&);                                                              \
  template double World<T>::Parts::expected_cost(Together&);                                                           \
  template void World<T>::Parts::balance(Together&);                                                                   \
  template void World<T>::Parts::migrate(Together&);                                                                   \
  template void World<T>::Parts::find_events(Together&);                                                               \
  template void World<T>::update();
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::mpi
