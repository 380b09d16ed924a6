// Angular impulses that resist rolling, carried over from step to step by the features of contacts, as the world
// carries the impulses of points: of a composite's several points of one feature by their order.
//
// Guarantee: a manifold that shares a feature with one of the last step begins with its impulse. Manifolds without an
// impulse cost nothing but a look at them, and nothing at all where no body resists rolling.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "graze/world/manifolds.hpp"

namespace graze {

/// The impulse of a manifold, kept at the feature of each of its points.
template <class Turning>
struct RollingImpulse {
  IdPair pair;
  std::uint32_t feature;
  Turning impulse;  ///< on the second body
};

template <class T, class Space>
class RollingImpulses {
 public:
  using Turning = typename Space::Turning;

  /// Takes the impulses over to the manifolds. `resisted`: whether any body resists rolling.
  template <class Parts>
  void carry_over(const Parts& parts, bool resisted) {
    resisted_ = resisted;
    of_manifolds_.clear();
    if (!resisted) return kept_.clear();
    of_manifolds_.resize(parts.surface_count());
    std::size_t first = 0;
    for (const ContactPair<T>& pair : parts.world.contacts().pairs) {
      if (first == kept_.size()) break;
      const IdPair ids{pair.a, pair.b};
      while (first != kept_.size() && kept_[first].pair < ids) ++first;
      std::size_t end = first;
      while (end != kept_.size() && kept_[end].pair == ids) ++end;
      if (first != end) carry_over(parts, pair, {kept_.data() + first, end - first});
      first = end;
    }
  }
  /// The impulse of a manifold, by its number (`SimulationParts::each_surface`), behind which those of its neighbours
  /// stand.
  Turning* of(std::size_t manifold) { return &of_manifolds_[manifold]; }
  /// Keeps the impulses of the manifolds for the next step.
  template <class Parts>
  void keep(const Parts& parts) {
    kept_.clear();
    if (!resisted_) return;
    for (const ContactPair<T>& pair : parts.world.contacts().pairs)
      each_manifold(parts, pair, [&](const ContactManifold<T, Space>& m, Turning& impulse) {
        if (impulse == Turning{}) return;
        for (const SolverPoint<T, Space>& p : parts.world.contacts().points_of(m))
          kept_.push_back({{pair.a, pair.b}, p.feature, impulse});
      });
  }
  /// Drops the impulses of a body that is gone.
  void drop(std::uint32_t body) {
    std::erase_if(kept_, [&](const auto& kept) { return kept.pair.a == body || kept.pair.b == body; });
  }

  /// The impulses of the last step, by pair.
  const std::vector<RollingImpulse<Turning>>& kept() const { return kept_; }
  void set_kept(const std::vector<RollingImpulse<Turning>>& kept) { kept_ = kept; }

 private:
  /// Calls `f` with the manifolds of a pair and their impulses.
  template <class Parts, class F>
  void each_manifold(const Parts& parts, const ContactPair<T>& pair, const F& f) {
    parts.each_surface(pair, [&](auto manifolds, const auto&, std::size_t first) {
      for (std::size_t i = 0; i < manifolds.size(); ++i) f(manifolds[i], of_manifolds_[first + i]);
    });
  }
  /// Takes the impulses of one pair over.
  template <class Parts>
  void carry_over(const Parts& parts, const ContactPair<T>& pair, std::span<const RollingImpulse<Turning>> last) {
    std::size_t at = 0;
    each_manifold(parts, pair, [&](const ContactManifold<T, Space>& m, Turning& impulse) {
      const auto points = parts.world.contacts().points_of(m);
      const auto shared = [&](const RollingImpulse<Turning>& kept) {
        return std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.feature == kept.feature; });
      };
      for (std::size_t tried = 0; tried < last.size(); ++tried) {
        const RollingImpulse<Turning>& kept = last[at];
        if (++at == last.size()) at = 0;
        if (!shared(kept)) continue;
        impulse = kept.impulse;
        break;
      }
    });
  }

  std::vector<RollingImpulse<Turning>> kept_;
  std::vector<Turning> of_manifolds_;  ///< empty where no body resists rolling
  bool resisted_ = false;
};

}  // namespace graze
