#include "graze/world.hpp"

namespace graze {

template <class T>
void World<T>::update() {
  const std::span<const std::uint32_t> changes = bodies_.changes();
  boxes_.resize(bodies_.size());
  find_bounds<T>(bodies_.shapes(), bodies_.poses(), bodies_.margins(), changes, boxes_, *executor_);
  filter(candidates_.find(boxes_, bodies_.alive(), changes));
  manifolds_.find(bodies_, allowed_, *executor_);
  tracker_.update<T>(
      manifolds_.contacts().pairs, [&](std::uint32_t i) { return bodies_.id(i); },
      [&](std::uint32_t i) { return bodies_.triggers()[i] != 0; }, events_);
  bodies_.settle();
}

/// The third stage: fixed bodies are no pair, then the filters, then the caller.
template <class T>
void World<T>::filter(std::span<const IdPair> candidates) {
  allowed_.assign(candidates.begin(), candidates.end());
  const auto fixed = bodies_.fixed();
  keep_allowed(allowed_, bodies_.filters(), [&](std::uint32_t a, std::uint32_t b) {
    if (fixed[a] != 0 && fixed[b] != 0) return false;
    return !settings_.allow || settings_.allow(bodies_.id(a), bodies_.id(b));
  });
}

template <class T>
std::size_t World<T>::memory() const {
  return bodies_.memory() + boxes_.capacity() * sizeof(Aabb<T>) + candidates_.memory() +
         allowed_.capacity() * sizeof(IdPair) + manifolds_.memory() + tracker_.memory() +
         events_.capacity() * sizeof(ContactEvent);
}

template class World<float>;
template class World<double>;

}  // namespace graze
