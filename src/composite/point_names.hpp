// Feature numbers of points whose manifold is of several pieces.
//
// The pieces of a composite number their features each by itself, so that points of several of them may have one number.
// A solver that carries impulses from frame to frame by these numbers would mix the points up.
//
// Guarantee: no number repeats within a manifold. A number is that of the point's own pieces; where several points have
// it, the one of the lowest pieces keeps it, and the others have one that follows from it and from their pieces: the
// same from frame to frame, and mirrored where A and B are swapped. Costs memory for each point that is held.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include "graze/contact.hpp"
#include "graze/small_vector.hpp"
#include "narrow/manifold/features.hpp"

namespace graze {

/// The numbers of points with the pieces that these are of, while the points are joined and left out.
class PointNames {
 public:
  /// Takes the numbers of a manifold's points. Each point has its place in the list of names instead, until `give`.
  template <class T>
  void take(Manifold<T>& manifold) {
    for (ContactPoint<T>& p : manifold.points) {
      names_.push_back({p.feature, manifold.piece_a, manifold.piece_b});
      p.feature = static_cast<std::uint32_t>(names_.size() - 1);
    }
  }

  /// Moves the name of a point over to a list that begins anew.
  template <class T>
  void move_to(PointNames& other, ContactPoint<T>& point) const {
    other.names_.push_back(names_[point.feature]);
    point.feature = static_cast<std::uint32_t>(other.names_.size() - 1);
  }

  /// Gives the points their numbers, each of which is single in the manifold.
  template <class T>
  void give(Manifold<T>& manifold) const {
    std::vector<Named> repeated;
    if (repeats(manifold)) repeated = in_order(manifold);
    for (ContactPoint<T>& p : manifold.points) p.feature = names_[p.feature].feature;
    if (repeated.empty()) return;
    std::set<std::uint32_t> taken;
    for (const Named& named : repeated) taken.insert(named.name.feature);
    const Name* keeper = nullptr;
    for (const Named& named : repeated) {
      if (!keeper || keeper->feature != named.name.feature) {
        keeper = &named.name;
        continue;
      }
      std::uint32_t tries = 0, number = other_number(named.name, *keeper, tries);
      while (!taken.insert(number).second) number = other_number(named.name, *keeper, ++tries);
      manifold.points[named.point].feature = number;
    }
  }

 private:
  /// A number and the pieces that it is of.
  struct Name {
    std::uint32_t feature, piece_a, piece_b;
  };
  struct Named {
    Name name;
    std::size_t point;
  };

  template <class T>
  bool repeats(const Manifold<T>& manifold) const {
    constexpr std::size_t few = 16;  // are compared with each other
    const auto number = [&](const ContactPoint<T>& p) { return names_[p.feature].feature; };
    const auto& points = manifold.points;
    if (points.size() > few) {
      std::vector<std::uint32_t> numbers;
      numbers.reserve(points.size());
      for (const ContactPoint<T>& p : points) numbers.push_back(number(p));
      std::sort(numbers.begin(), numbers.end());
      return std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end();
    }
    for (std::size_t i = 1; i < points.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (number(points[i]) == number(points[k])) return true;
    return false;
  }

  /// The points' names by number, of one number by pieces.
  template <class T>
  std::vector<Named> in_order(const Manifold<T>& manifold) const {
    std::vector<Named> named;
    named.reserve(manifold.points.size());
    for (std::size_t i = 0; i < manifold.points.size(); ++i) named.push_back({names_[manifold.points[i].feature], i});
    const auto key = [](const Named& n) { return std::tie(n.name.feature, n.name.piece_a, n.name.piece_b, n.point); };
    std::sort(named.begin(), named.end(), [&](const Named& n, const Named& m) { return key(n) < key(m); });
    return named;
  }

  /// Half of a number for a feature of a piece. It is of no kind: whose corners it has, the manifold's piece cannot tell.
  static std::uint32_t half_of_piece(std::uint32_t half, std::uint32_t piece, std::uint32_t tries) {
    // A multiplication by the golden ratio spreads neighbouring pieces over the range: Knuth 1973, "The art of computer
    // programming", volume 3, section 6.4.
    const std::uint32_t spread = (half + (piece << 16) + (piece >> 16) + tries * 0x10001u) * 2654435769u;
    return detail::feature_of_kind(0, spread >> (32 - detail::feature_number_bits));
  }

  /// Another number for a point than the one that `keeper` has too: the halves of pieces that differ change; both where
  /// none does, and in further tries, as those that have one half in common may be more than a half can tell apart.
  static std::uint32_t other_number(const Name& name, const Name& keeper, std::uint32_t tries) {
    const bool differs_a = name.piece_a != keeper.piece_a, differs_b = name.piece_b != keeper.piece_b,
               both = tries > 0 || (!differs_a && !differs_b);
    const std::uint32_t a = name.feature >> 16, b = name.feature & 0xffff;
    return feature_id(both || differs_a ? half_of_piece(a, name.piece_a, tries) : a,
                      both || differs_b ? half_of_piece(b, name.piece_b, tries) : b);
  }

  SmallVector<Name, 32> names_;  ///< room for those of most pairs
};

}  // namespace graze
