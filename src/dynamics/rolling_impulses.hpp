// Angular impulses that resist rolling, carried over from step to step by the features of contacts, as the world carries
// the impulses of points: of a composite's several points of one feature by their order.
//
// Guarantee: a manifold that shares a feature with one of the last step begins with its impulse. Manifolds without an
// impulse cost nothing but a look at them, and nothing at all where no body resists rolling.
#pragma once

#include <algorithm>
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
  void carry_over(const ContactArrays<T, Space>& contacts, bool resisted) {
    resisted_ = resisted;
    of_manifolds_.clear();
    if (!resisted) return kept_.clear();
    of_manifolds_.resize(contacts.manifolds.size());
    auto first = kept_.begin();
    for (const ContactPair<T>& pair : contacts.pairs) {
      if (first == kept_.end()) break;
      const IdPair ids{pair.a, pair.b};
      while (first != kept_.end() && first->pair < ids) ++first;
      auto end = first;
      while (end != kept_.end() && end->pair == ids) ++end;
      carry_over(contacts, pair, {first, end});
      first = end;
    }
  }
  /// The impulse of a manifold, by its index, behind which those of its pair's others stand.
  Turning* of(std::uint32_t manifold) { return &of_manifolds_[manifold]; }
  /// Keeps the impulses of the manifolds for the next step.
  void keep(const ContactArrays<T, Space>& contacts) {
    kept_.clear();
    if (!resisted_) return;
    for (const ContactPair<T>& pair : contacts.pairs)
      for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair)) {
        const Turning& impulse = of_manifolds_[index_of(contacts, m)];
        if (impulse == Turning{}) continue;
        for (const SolverPoint<T, Space>& p : contacts.points_of(m))
          kept_.push_back({{pair.a, pair.b}, p.feature, impulse});
      }
  }
  /// Drops the impulses of a body that is gone.
  void drop(std::uint32_t body) {
    std::erase_if(kept_, [&](const auto& kept) { return kept.pair.a == body || kept.pair.b == body; });
  }

  /// The impulses of the last step, by pair.
  const std::vector<RollingImpulse<Turning>>& kept() const { return kept_; }
  void set_kept(const std::vector<RollingImpulse<Turning>>& kept) { kept_ = kept; }

 private:
  static std::size_t index_of(const ContactArrays<T, Space>& contacts, const ContactManifold<T, Space>& m) {
    return static_cast<std::size_t>(&m - contacts.manifolds.data());
  }
  /// Takes the impulses of one pair over.
  void carry_over(const ContactArrays<T, Space>& contacts, const ContactPair<T>& pair,
                  std::span<const RollingImpulse<Turning>> last) {
    if (last.empty()) return;
    std::size_t at = 0;
    for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair)) {
      const auto points = contacts.points_of(m);
      const auto shared = [&](const RollingImpulse<Turning>& kept) {
        return std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.feature == kept.feature; });
      };
      for (std::size_t tried = 0; tried < last.size(); ++tried) {
        const RollingImpulse<Turning>& kept = last[at];
        if (++at == last.size()) at = 0;
        if (!shared(kept)) continue;
        of_manifolds_[index_of(contacts, m)] = kept.impulse;
        break;
      }
    }
  }

  std::vector<RollingImpulse<Turning>> kept_;
  std::vector<Turning> of_manifolds_;  ///< empty where no body resists rolling
  bool resisted_ = false;
};

}  // namespace graze
