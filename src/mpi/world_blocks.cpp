// An update that hands contacts over block by block.
//
// Guarantee: the pairs, manifolds and points that `update` keeps, with the same bits, each pair in one block. The
// blocks of a rank share their pairs as ranks do, but by other rules, since all of them are at hand: two bodies that
// move are found where the one of the smaller size class, or of the smaller key, is at home, and a body that moves on
// fixed ground where it is at home itself, with all the ground that it may touch.
#include <algorithm>
#include <utility>

#include "mpi/blocks.hpp"
#include "mpi/world_parts.hpp"

namespace graze::mpi {

template <class T>
class World<T>::Parts::InBlocks {
 public:
  explicit InBlocks(Parts& parts)
      : p_(parts), manifolds_(parts.settings.points_per_pair.value_or(ManifoldFinder<T>::all_points)) {}

  void lend(Together& together);
  void fetch_ground(Together& together);
  void find(const ContactVisitor<T>& visit);
  std::size_t guests() const { return guests_.size(); }

 private:
  // Bodies by place: those that live here and then those that are lent, either in the order of their keys.
  std::size_t own() const { return p_.owned.settled().size(); }
  std::size_t size() const { return own() + guests_.size(); }
  bool is_lent(std::uint32_t i) const { return i >= own(); }
  Key key(std::uint32_t i) const { return is_lent(i) ? guests_[i - own()].key : p_.owned.settled()[i].key; }
  const Body<T>& body(std::uint32_t i) const {
    return is_lent(i) ? guests_[i - own()].body : p_.owned.settled()[i].body;
  }
  Aabb<T> bounds_of(const Body<T>& body) const { return p_.bounds_of(body); }

  void take_in(const ByRank<BodyRecord<T>>& from);
  bool may_meet(std::uint32_t i, std::uint32_t j) const;
  bool is_found_here(std::uint32_t i, std::uint32_t j) const;
  bool is_of_block(const IdPair& pair) const;
  void find_block(std::span<const std::uint32_t> home, std::span<const std::uint32_t> beside,
                  const ContactVisitor<T>& visit);
  BodyArrays<T> fill(std::span<const std::uint32_t> home, std::span<const std::uint32_t> beside);

  Parts& p_;
  std::vector<Guest> guests_;
  std::vector<Aabb<T>> boxes_;  ///< of all, by place

  // Members of the block at hand.
  std::vector<std::uint32_t> places_;  ///< of its bodies, in the order of keys
  std::vector<std::uint8_t> is_home_;  ///< by place
  std::vector<Aabb<T>> block_boxes_;
  PairFinder<T> finder_;
  std::vector<IdPair> candidates_;
  ManifoldFinder<T> manifolds_;
  std::vector<KeyedPair> pairs_;
};

/// Lends bodies that reach into other regions to their ranks.
template <class T>
void World<T>::Parts::InBlocks::lend(Together& together) {
  ByRank<BodyRecord<T>> to = together.nothing<BodyRecord<T>>();
  together.alone([&] {
    boxes_.resize(own());
    constexpr std::size_t bodies_per_task = 512;
    for_each_chunk(*p_.executor, own(), bodies_per_task, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) boxes_[i] = bounds_of(p_.owned.settled()[i].body);
    });
    if (to.size() == 1) return;
    std::vector<int> ranks;
    for (std::uint32_t i = 0; i < own(); ++i) {
      if (p_.is_inside(boxes_[i])) continue;
      ranks.clear();
      p_.partition.ranks_of_box({converted<double>(boxes_[i].lower), converted<double>(boxes_[i].upper)}, ranks);
      for (const int r : ranks)
        if (r != rank_of(p_.comm))
          to[static_cast<std::size_t>(r)].push_back(record_of(key(i), body(i), 0.0F, p_.shared));
    }
  });
  const ByRank<BodyRecord<T>> from = together.exchange(to);
  together.alone([&] {
    for (const auto& some : from)
      for (const BodyRecord<T>& r : some) p_.check(r.key, false);
    take_in(from);
  });
}

/// Takes in guests. Those that are here already stay as they are. All are few, and sorted anew each time.
template <class T>
void World<T>::Parts::InBlocks::take_in(const ByRank<BodyRecord<T>>& from) {
  const std::size_t before = guests_.size();
  for (const auto& some : from)
    for (const BodyRecord<T>& r : some)
      if (!p_.owned.contains(r.key)) guests_.push_back({r.key, body_of(r, p_.shared)});
  if (guests_.size() == before) return;
  std::stable_sort(guests_.begin(), guests_.end(), [](const Guest& a, const Guest& b) { return a.key < b.key; });
  const auto same = [](const Guest& a, const Guest& b) { return a.key == b.key; };
  guests_.erase(std::unique(guests_.begin(), guests_.end(), same), guests_.end());
  boxes_.resize(own());
  boxes_.reserve(size());
  for (const Guest& guest : guests_) boxes_.push_back(bounds_of(guest.body));
}

template <class T>
bool World<T>::Parts::InBlocks::may_meet(std::uint32_t i, std::uint32_t j) const {
  const Body<T>&a = body(i), &b = body(j);
  return !(a.fixed && b.fixed) && may_collide(a.filter, b.filter) &&
         (!p_.settings.allow || p_.settings.allow(std::min(key(i), key(j)), std::max(key(i), key(j))));
}

/// Whether this rank finds a pair: two whose boxes overlap are found by the rank of their common point.
template <class T>
bool World<T>::Parts::InBlocks::is_found_here(std::uint32_t i, std::uint32_t j) const {
  return size_of(p_.comm) == 1 || p_.partition.rank_of_point(common_point(boxes_[i], boxes_[j])) == rank_of(p_.comm);
}

/// Lends fixed bodies that stand here to the ranks where bodies live that move on them.
template <class T>
void World<T>::Parts::InBlocks::fetch_ground(Together& together) {
  ByRank<BodyRecord<T>> to = together.nothing<BodyRecord<T>>();
  together.alone([&] {
    std::vector<std::uint32_t> some, moving;
    for (std::uint32_t i = 0; i < size(); ++i) {
      if (body(i).fixed) some.push_back(i);
      if (!body(i).fixed && is_lent(i)) moving.push_back(i);
    }
    if (some.empty() || moving.empty()) return;
    const std::size_t fixed = some.size();
    some.insert(some.end(), moving.begin(), moving.end());
    block_boxes_.clear();
    for (const std::uint32_t i : some) block_boxes_.push_back(boxes_[i]);
    finder_.find(block_boxes_, candidates_, *p_.executor);
    for (const IdPair& pair : candidates_) {
      const std::uint32_t i = some[pair.a], j = some[pair.b];
      if (pair.a >= fixed || pair.b < fixed || !may_meet(i, j) || !is_found_here(i, j)) continue;
      const int home = p_.partition.rank_of_point(converted<double>(body(j).pose.translation));
      to[static_cast<std::size_t>(home)].push_back(record_of(key(i), body(i), 0.0F, p_.shared));
    }
  });
  const ByRank<BodyRecord<T>> from = together.exchange(to);
  together.alone([&] { take_in(from); });
}

template <class T>
void World<T>::Parts::InBlocks::find(const ContactVisitor<T>& visit) {
  for (auto& o : p_.owned.settled()) {
    o.cost = cost_of_body;
    o.place = nowhere;
    o.reshaped = false;
  }
  std::vector<std::uint32_t> moving, standing;
  moving.reserve(size());
  for (std::uint32_t i = 0; i < size(); ++i) (body(i).fixed ? standing : moving).push_back(i);
  is_home_.assign(size(), 0);
  Blocks<T>(boxes_, p_.settings.bodies_per_block)
      .each(std::move(moving), standing,
            [&](std::span<const std::uint32_t> home, std::span<const std::uint32_t> beside) {
              find_block(home, beside, visit);
            });
  if (!p_.settings.events) return;
  std::sort(p_.pairs.begin(), p_.pairs.end(),
            [](const KeyedPair& p, const KeyedPair& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
}

/// The bodies of a block as arrays, in the order of their keys, and their boxes.
template <class T>
BodyArrays<T> World<T>::Parts::InBlocks::fill(std::span<const std::uint32_t> home,
                                              std::span<const std::uint32_t> beside) {
  places_.assign(home.begin(), home.end());
  places_.insert(places_.end(), beside.begin(), beside.end());
  std::sort(places_.begin(), places_.end());
  const auto lent = std::lower_bound(places_.begin(), places_.end(), own());
  std::inplace_merge(places_.begin(), lent, places_.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  BodyArrays<T> arrays(p_.settings.margin);
  arrays.reserve(places_.size());
  block_boxes_.clear();
  for (const std::uint32_t i : places_) {
    arrays.add(body(i));
    block_boxes_.push_back(boxes_[i]);
  }
  return arrays;
}

/// Whether the two meet in this block, and on this rank.
template <class T>
bool World<T>::Parts::InBlocks::is_of_block(const IdPair& pair) const {
  const std::uint32_t i = places_[pair.a], j = places_[pair.b];
  const bool fixed_i = body(i).fixed, fixed_j = body(j).fixed;
  if (fixed_i || fixed_j) {
    const std::uint32_t moving = fixed_i ? j : i;
    return is_home_[moving] != 0 && !is_lent(moving) && may_meet(i, j);
  }
  const int class_i = size_class(boxes_[i]), class_j = size_class(boxes_[j]);
  return is_home_[class_j < class_i ? j : i] != 0 && may_meet(i, j) && is_found_here(i, j);
}

template <class T>
void World<T>::Parts::InBlocks::find_block(std::span<const std::uint32_t> home, std::span<const std::uint32_t> beside,
                                           const ContactVisitor<T>& visit) {
  for (const std::uint32_t i : home) is_home_[i] = 1;
  const BodyArrays<T> arrays = fill(home, beside);
  finder_.find(block_boxes_, candidates_, *p_.executor);
  std::erase_if(candidates_, [&](const IdPair& pair) { return !is_of_block(pair); });
  for (const std::uint32_t i : home) is_home_[i] = 0;
  float of_guests = 0;
  const auto cost = [&](std::uint32_t i) -> float& { return is_lent(i) ? of_guests : p_.owned.settled()[i].cost; };
  const std::span<const IdPair> of_block(candidates_);
  p_.pair_costs.measure(arrays, of_block);
  p_.pair_costs.charge(arrays, of_block, [&](const IdPair& pair, float of_pair) {
    const std::uint32_t i = places_[pair.a], j = places_[pair.b];
    charge_pair(of_pair, !is_lent(i), !is_lent(j), cost(i), cost(j));
  });
  p_.report.candidates += candidates_.size();
  manifolds_.find(arrays, candidates_, *p_.executor);
  pairs_.clear();
  for (const ContactPair<T>& c : manifolds_.contacts().pairs)
    pairs_.push_back({key(places_[c.a]), key(places_[c.b]), c.overlap,
                      (arrays.triggers()[c.a] | arrays.triggers()[c.b]) != 0, c.first_manifold, c.manifold_count});
  p_.report.pairs += pairs_.size();
  visit({pairs_, manifolds_.contacts()});
  if (p_.settings.events) p_.pairs.insert(p_.pairs.end(), pairs_.begin(), pairs_.end());
}

/// Frees all that an update that keeps contacts has kept.
template <class T>
void World<T>::Parts::let_go_of_contacts() {
  keys = {};
  standing = {};
  before = {};
  arrays.reset();
  boxes = {};
  finder.reset();
  late = {};
  mine = {};
  manifolds = ManifoldFinder<T>(settings.points_per_pair.value_or(ManifoldFinder<T>::all_points));
  pairs = {};
}

template <class T>
void World<T>::update(const ContactVisitor<T>& visit) {
  Parts& p = *parts_;
  p.candidates_before = p.report.candidates;
  p.report = {.partitions = p.report.partitions};
  Together together(p.comm);
  Clock clock;
  p.let_go_of_contacts();
  p.balance(together);
  p.migrate(together);
  p.report.partition = clock.lap();
  {
    typename Parts::InBlocks blocks(p);
    blocks.lend(together);
    p.report.exchange = clock.lap();
    blocks.fetch_ground(together);
    p.report.broad = clock.lap();
    together.alone([&] { blocks.find(visit); });
    p.report.contacts = clock.lap();
    p.report.ghosts = blocks.guests();
  }
  p.find_events(together);
  p.pairs = {};
  p.report.events = clock.lap();
  p.report.bodies = p.owned.size();
  p.report.bytes = together.bytes();
  p.report.work = together.work();
}

template void World<float>::update(const ContactVisitor<float>&);
template void World<double>::update(const ContactVisitor<double>&);

}  // namespace graze::mpi
