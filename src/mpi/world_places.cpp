// The places of bodies in the arrays of a rank, from update to update.
//
// Guarantee: places are in the order of keys, and a body keeps its place for as long as no body comes that never stood
// here: those that are lent again and again have kept theirs. So an update costs in proportion to its changes, as in
// one world, and where places are given anew, as much as an update in which everything moves.
#include <algorithm>
#include <limits>
#include <utility>

#include "graze/world/bounds.hpp"
#include "mpi/world_parts.hpp"

namespace graze::mpi {

namespace {

/// The share of places of bodies that are away, one in so many, above which places are given anew.
constexpr std::size_t places_per_away = 8;

/// A body nearer to a region than this share of its own size gets a place there before it is lent: bodies that drift
/// then come with places for some updates on end, and the records of borders are an eighth more.
constexpr double near = 1.0 / 16;

template <class T>
Aabb<T> with_room(const Aabb<T>& box) {
  const Vec3<T> room = box.extent() * T(near);
  return {box.lower - room, box.upper + room};
}

template <class T>
Aabb<double> in_double(const Aabb<T>& box) {
  return {converted<double>(box.lower), converted<double>(box.upper)};
}

}  // namespace

template <class T>
std::uint32_t World<T>::Parts::place_of(Key key) const {
  const auto found = std::lower_bound(keys.begin(), keys.end(), key);
  return found != keys.end() && *found == key ? static_cast<std::uint32_t>(found - keys.begin()) : nowhere;
}

template <class T>
Aabb<T> World<T>::Parts::bounds_of(const Body<T>& body) const {
  return bounds_with_margin<T>(body.shape, body.pose, BodyArrays<T>::margin_of(body.shape, settings.margin));
}

/// Whether a box stays away from all borders.
template <class T>
bool World<T>::Parts::is_inside(const Aabb<T>& box) const {
  const Aabb<double>& region = partition.region();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(region.lower[axis] < static_cast<double>(box.lower[axis]) &&
          static_cast<double>(box.upper[axis]) < region.upper[axis]))
      return false;
  return true;
}

template <class T>
void World<T>::Parts::find_bounds_of(std::span<const std::uint32_t> places) {
  find_bounds<T>(arrays->shapes(), arrays->poses(), arrays->margins(), places, boxes, *executor);
}

/// Brings a body that has a place up to date there. Its shape is the same if it stood here in the last update and has
/// got no other one since.
template <class T>
void World<T>::Parts::bring_up(std::uint32_t place, const Body<T>& body, bool reshaped) {
  const BodyId id = arrays->id(place);
  if (reshaped || before[place] == away) arrays->set_shape(id, body.shape);
  arrays->move(id, body.pose);
  if (arrays->filters()[place] != body.filter) arrays->set_filter(id, body.filter);
}

/// Finds the bounds of bodies that live here and have a place; looks up the place of bodies that came since. Returns
/// whether all have one.
template <class T>
bool World<T>::Parts::place_own() {
  before.assign(keys.size(), away);
  standing.swap(before);
  bool all_placed = true;
  for (auto& o : owned.settled()) {
    if (o.place == nowhere) {
      o.place = place_of(o.key);
      if (o.place == nowhere) {
        all_placed = false;
        continue;
      }
      bring_up(o.place, o.body, o.reshaped);
    }
    standing[o.place] = lives;
  }
  if (arrays) find_bounds_of(arrays->changes());
  return all_placed;
}

template <class T>
void World<T>::Parts::find_who_is_lent(ByRank<BodyRecord<T>>& to) {
  std::vector<int> ranks, ranks_near;
  for (auto& o : owned.settled()) {
    const bool reshaped = std::exchange(o.reshaped, false);
    if (to.size() == 1) continue;
    const Aabb<T> box = o.place == nowhere ? bounds_of(o.body) : boxes[o.place], wide = with_room(box);
    if (is_inside(wide)) continue;
    ranks.clear();
    ranks_near.clear();
    partition.ranks_of_box(in_double(wide), ranks_near);
    if (!is_inside(box)) partition.ranks_of_box(in_double(box), ranks);
    for (const int r : ranks_near) {
      if (r == rank_of(comm)) continue;
      BodyRecord<T>& record = to[static_cast<std::size_t>(r)].emplace_back(record_of(o.key, o.body, 0.0F, shared));
      record.reshaped = reshaped ? 1 : 0;
      record.near = std::find(ranks.begin(), ranks.end(), r) == ranks.end() ? 1 : 0;
    }
  }
}

/// Lends bodies that reach into other regions to their ranks.
template <class T>
void World<T>::Parts::lend(Together& together) {
  ByRank<BodyRecord<T>> to = together.nothing<BodyRecord<T>>();
  bool all_placed = false;
  together.alone([&] {
    all_placed = place_own();
    find_who_is_lent(to);
  });
  const ByRank<BodyRecord<T>> from = together.exchange(to);
  together.alone([&] { place_guests(from, all_placed); });
}

/// Brings guests up to date where all of them have a place; else gives all places anew.
template <class T>
void World<T>::Parts::place_guests(const ByRank<BodyRecord<T>>& from, bool all_placed) {
  std::vector<Guest> guests;
  std::vector<std::uint32_t> places;
  std::vector<const BodyRecord<T>*> near_ones;
  for (const auto& some : from)
    for (const BodyRecord<T>& r : some) {
      check(r.key, false);
      if (r.near != 0) {
        near_ones.push_back(&r);
        continue;
      }
      const Guest& guest = guests.emplace_back(Guest{r.key, body_of(r, shared)});
      if (!all_placed) continue;
      const std::uint32_t place = place_of(r.key);
      all_placed = place != nowhere;
      if (!all_placed) continue;
      bring_up(place, guest.body, r.reshaped != 0);
      standing[place] = lent;
      places.push_back(place);
    }
  const std::size_t used = owned.size() + places.size() + near_ones.size();
  if (!arrays || !all_placed || keys.size() > used + used / places_per_away) {
    for (const BodyRecord<T>* r : near_ones) guests.push_back({r->key, body_of(*r, shared), true});
    return place_anew(std::move(guests));
  }
  std::sort(places.begin(), places.end());
  find_bounds_of(places);
}

/// Gives places to the bodies that live here and to these guests.
template <class T>
void World<T>::Parts::place_anew(std::vector<Guest> guests) {
  const auto by_key = [](const Guest& a, const Guest& b) { return a.key < b.key; };
  std::stable_sort(guests.begin(), guests.end(), by_key);
  const std::vector<Aabb<T>> last_boxes = std::exchange(boxes, {});
  const std::size_t count = owned.size() + guests.size();
  keys.clear();
  keys.reserve(count);
  standing.clear();
  standing.reserve(count);
  boxes.reserve(count);
  // The last arrays go first: room for both is not needed.
  arrays.reset();
  arrays = std::make_unique<BodyArrays<T>>(settings.margin);
  arrays->reserve(count);
  const auto place = [&](Key key, const Body<T>& body, const Aabb<T>& box, Standing how) {
    keys.push_back(key);
    standing.push_back(how);
    boxes.push_back(box);
    arrays->add(body);
  };
  const auto place_guest = [&](const Guest& g) { place(g.key, g.body, bounds_of(g.body), g.near ? away : lent); };
  auto guest = guests.cbegin();
  const auto place_guests_below = [&](Key key) {
    for (; guest != guests.cend() && guest->key < key; ++guest) place_guest(*guest);
  };
  for (auto& o : owned.settled()) {
    place_guests_below(o.key);
    const Aabb<T> box = o.place == nowhere ? bounds_of(o.body) : last_boxes[o.place];
    o.place = static_cast<std::uint32_t>(keys.size());
    place(o.key, o.body, box, lives);
  }
  place_guests_below(std::numeric_limits<Key>::max());
  for (; guest != guests.cend(); ++guest) place_guest(*guest);
  finder.reset();
  finder = std::make_unique<CandidateFinder<T>>();
  late.clear();
}

/// Takes in fixed bodies that are lent for the sake of others' pairs, after the candidates were found.
template <class T>
void World<T>::Parts::take_ground(const std::vector<BodyRecord<T>>& ground) {
  std::vector<Guest> missing;
  for (const BodyRecord<T>& r : ground) {
    const std::uint32_t place = place_of(r.key);
    if (place == nowhere) {
      const auto same = [&](const Guest& g) { return g.key == r.key; };
      if (std::none_of(missing.begin(), missing.end(), same)) missing.push_back({r.key, body_of(r, shared)});
    } else if (standing[place] == away) {
      // The sender does not know whether it stood here in the last update, nor its shape then.
      bring_up(place, body_of(r, shared), true);
      standing[place] = lent;
      late.push_back(place);
    }
  }
  std::sort(late.begin(), late.end());
  find_bounds_of(late);
  if (missing.empty()) return;
  for (std::uint32_t i = 0; i < keys.size(); ++i)
    if (standing[i] == lent) missing.push_back({keys[i], arrays->body(arrays->id(i))});
  const std::vector<Key> last_keys = keys;
  place_anew(std::move(missing));
  std::vector<std::uint32_t> to(last_keys.size(), nowhere);
  for (std::uint32_t i = 0, last = 0; i < keys.size(); ++i) {
    while (last < last_keys.size() && last_keys[last] < keys[i]) ++last;
    if (last < last_keys.size() && last_keys[last] == keys[i]) to[last] = i;
  }
  for (IdPair& p : mine) p = {to[p.a], to[p.b]};
  finder->find(boxes, arrays->alive(), arrays->fixed(), arrays->changes(), *executor);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::uint32_t World<T>::Parts::place_of(Key) const;                                                         \
  template Aabb<T> World<T>::Parts::bounds_of(const Body<T>&) const;                                                   \
  template bool World<T>::Parts::is_inside(const Aabb<T>&) const;                                                      \
  template void World<T>::Parts::lend(Together&);                                                                      \
  template void World<T>::Parts::take_ground(const std::vector<BodyRecord<T>>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::mpi
