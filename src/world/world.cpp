#include "graze/world.hpp"

#include "graze/plane/world.hpp"

namespace graze {

template <class T, class Space>
void World<T, Space>::update(T duration) {
  validate::extent(duration, "duration");
  const std::span<const std::uint32_t> changes = bodies_.changes();
  boxes_.resize(bodies_.size());
  find_bounds<T, Space>(bodies_.shapes(), bodies_.poses(), bodies_.margins(), changes, boxes_, *executor_);
  const std::span<const IdPair> candidates =
      candidates_.find(boxes_, bodies_.alive(), bodies_.fixed(), changes, *executor_);
  manifolds_.find(bodies_, filter(candidates), *executor_,
                  [&] { tracker_.template update<T, Space>(bodies_, manifolds_.contacts().pairs); });
  bodies_.settle();
  tree_revision_ = no_revision;  // it may lack changes for which pairs were found without it
  impacts_.clear();
  if (duration > T(0)) find_impacts(duration);
}

template <class T, class Space>
void World<T, Space>::find_impacts(T duration) {
  validate::extent(duration, "duration");
  graze::find_impacts<T, Space>(
      bodies_, tree(), duration,
      [&](std::uint32_t a, std::uint32_t b) {
        return may_collide(bodies_.filters()[a], bodies_.filters()[b]) && is_pair(a, b);
      },
      *executor_, impacts_);
}

/// Whether two bodies whose filters agree are a pair: fixed bodies are none, and then the caller decides.
template <class T, class Space>
bool World<T, Space>::is_pair(std::uint32_t a, std::uint32_t b) const {
  if (bodies_.fixed()[a] != 0 && bodies_.fixed()[b] != 0) return false;
  return !settings_.allow || settings_.allow(bodies_.id(a), bodies_.id(b));
}

/// The third stage: the candidates that filters keep, or all of them where no filter can drop a pair.
template <class T, class Space>
std::span<const IdPair> World<T, Space>::filter(std::span<const IdPair> candidates) {
  if (!bodies_.filtered() && !settings_.allow) return candidates;
  allowed_.assign(candidates.begin(), candidates.end());
  keep_allowed(allowed_, bodies_.filters(), [&](std::uint32_t a, std::uint32_t b) { return is_pair(a, b); });
  return allowed_;
}

template <class T, class Space>
std::size_t World<T, Space>::memory() const {
  return bodies_.memory() + boxes_.capacity() * sizeof(Aabb<T>) + candidates_.memory() +
         allowed_.capacity() * sizeof(IdPair) + manifolds_.memory() + tracker_.memory();
}

template class World<float>;
template class World<double>;
template class World<float, plane::Space<float>>;
template class World<double, plane::Space<double>>;

}  // namespace graze
