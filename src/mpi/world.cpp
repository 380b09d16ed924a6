#include "graze/mpi/world.hpp"

#include <algorithm>
#include <tuple>

#include "mpi/words.hpp"
#include "mpi/world_parts.hpp"

namespace graze::mpi {

namespace {

/// Settings that have to be the same on all ranks, as words.
template <class T>
std::string kind_of(const WorldSettings<T>& settings) {
  std::string kind = "graze " GRAZE_VERSION ", " + std::string(sizeof(T) == sizeof(float) ? "float" : "double");
  if (settings.margin) kind += ", margin " + digits(static_cast<double>(*settings.margin));
  if (!settings.events) kind += ", no events";
  if (!settings.measured) kind += ", costs not measured";
  if (settings.points_per_pair) kind += ", points of a pair " + std::to_string(*settings.points_per_pair);
  return kind + ", imbalance " + digits(settings.imbalance) + (settings.allow ? ", a last word on pairs" : "");
}

}  // namespace

template <class T>
World<T>::World(MPI_Comm comm, WorldSettings<T> settings, Executor* executor) {
  Together together(comm);
  together.alone([&] {
    if (!(settings.imbalance >= 1))
      throw InvalidValue("imbalance", "a number >= 1", std::to_string(settings.imbalance));
    if (settings.bodies_per_block == 0) throw InvalidValue("bodies_per_block", "a number >= 1", "0");
    static_cast<void>(BodyArrays<T>(settings.margin));
  });
  together.meet();
  agree_on(comm, "the world", kind_of(settings));
  parts_ = std::make_unique<Parts>(comm, std::move(settings), executor);
}

template <class T>
World<T>::~World() = default;

template <class T>
void World<T>::share(const Shape<T>& shape) {
  Parts& p = *parts_;
  agree_on(p.comm, "shared shape " + std::to_string(p.shared.added()), words_of(shape));
  p.shared.add(shape);
}

template <class T>
void World<T>::share_from(std::function<Shape<T>(std::uint64_t)> source) {
  parts_->shared.set_source(std::move(source));
}

template <class T>
const Shape<T>& World<T>::shared(std::uint64_t number) {
  return parts_->shared[number];
}

template <class T>
void World<T>::add(Key key, const Body<T>& body) {
  parts_->check(key, false);
  Space<T>::check(body.linear, body.angular);
  record_of(key, body, 0.0F, parts_->shared);
  Body<T> placed = body;
  placed.pose = Space<T>::checked(body.pose);
  parts_->owned.add(key, std::move(placed), 0.0F, true);
}

template <class T>
bool World<T>::contains(Key key) const {
  return parts_->owned.contains(key);
}

template <class T>
void World<T>::remove(Key key) {
  parts_->check(key, true);
  parts_->owned.remove(key);
}

template <class T>
void World<T>::move(Key key, const Pose<T>& pose) {
  auto& entry = parts_->entry(key);
  const Pose<T> to = Space<T>::checked(pose);
  if (to == entry.body.pose) return;
  entry.body.pose = to;
  if (BodyArrays<T>* const arrays = parts_->arrays_of(entry)) arrays->move(arrays->id(entry.place), to);
}

template <class T>
void World<T>::set_filter(Key key, const Filter& filter) {
  auto& entry = parts_->entry(key);
  entry.body.filter = filter;
  if (BodyArrays<T>* const arrays = parts_->arrays_of(entry)) arrays->set_filter(arrays->id(entry.place), filter);
}

template <class T>
void World<T>::set_shape(Key key, const Shape<T>& shape) {
  auto& entry = parts_->entry(key);
  Body<T> changed = entry.body;
  changed.shape = shape;
  record_of(key, changed, 0.0F, parts_->shared);
  entry.body = std::move(changed);
  entry.reshaped = true;
  if (BodyArrays<T>* const arrays = parts_->arrays_of(entry)) arrays->set_shape(arrays->id(entry.place), shape);
}

template <class T>
Body<T> World<T>::body(Key key) const {
  return parts_->entry(key).body;
}

template <class T>
std::vector<Key> World<T>::keys() const {
  return parts_->owned.keys();
}

template <class T>
std::span<const KeyedPair> World<T>::pairs() const {
  return parts_->pairs;
}

template <class T>
const ContactArrays<T>& World<T>::contacts() const {
  return parts_->manifolds.contacts();
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
const Aabb<double>& World<T>::region() const {
  return parts_->partition.region();
}

template <class T>
std::size_t World<T>::memory() const {
  const Parts& p = *parts_;
  return p.owned.memory() + p.keys.capacity() * sizeof(Key) + p.standing.capacity() + p.before.capacity() +
         (p.arrays ? p.arrays->memory() : 0) + p.boxes.capacity() * sizeof(p.boxes[0]) +
         (p.finder ? p.finder->memory() : 0) + p.mine.capacity() * sizeof(IdPair) + p.manifolds.memory() +
         p.pairs.capacity() * sizeof(KeyedPair) + p.events.memory();
}

template <class T>
Gathered<T> World<T>::gather(int root) const {
  const Parts& p = *parts_;
  const auto ranks = static_cast<std::size_t>(size_of(p.comm)), to = static_cast<std::size_t>(root);
  if (to >= ranks) throw InvalidValue("root", "a rank below " + std::to_string(ranks), std::to_string(root));
  Together together(p.comm);
  const auto gathered = [&]<class E>(std::span<const E> some) {
    ByRank<E> all(ranks);
    together.alone([&] { all[to].assign(some.begin(), some.end()); });
    return together.exchange(all);
  };
  const ContactArrays<T>& found = p.manifolds.contacts();
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
