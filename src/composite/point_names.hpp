// Feature numbers of points whose manifold is of several pieces.
//
// The pieces of a composite number their features each by itself, so that points of several of them may have one
// number. A solver that carries impulses from frame to frame by these numbers would mix the points up.
//
// Guarantee: no number repeats within a manifold. A number is that of the point's own pieces; where several points have
// it, the one of the lowest pieces keeps it, and the others have one that follows from it and from their own pieces
// alone: the same from frame to frame, and mirrored where A and B are swapped. Two that follow to the same number, one
// pair in 16,384 or fewer, are told apart in the order of their pieces. Costs memory for each point that is held;
// numbers of up to 64 points of a manifold are told apart without an allocation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "composite/leaf_pairs.hpp"
#include "graze/contact.hpp"
#include "graze/small_vector.hpp"
#include "narrow/manifold/features.hpp"

namespace graze {

/// The numbers of points with the pieces that these are of, while the points are joined and left out.
class PointNames {
 public:
  /// Takes the numbers of a manifold's points, which are of these pieces. Each point has its place in the list of names
  /// instead, until `give`.
  template <class T>
  void take(Manifold<T>& manifold, const LeafPair& leaves) {
    for (ContactPoint<T>& p : manifold.points) hold({p.feature, leaves}, p);
  }

  /// Moves the name of a point over to a list that begins anew.
  template <class T>
  void move_to(PointNames& other, ContactPoint<T>& point) const {
    other.hold(names_[point.feature], point);
  }

  /// Names a point for the lower pieces of its own and of those of another at its place.
  template <class T>
  void share(ContactPoint<T>& point, const ContactPoint<T>& other) const {
    if (names_[other.feature].key() < names_[point.feature].key()) point.feature = other.feature;
  }

  /// Gives the points their numbers, each of which is single in the manifold.
  template <class T>
  void give(Manifold<T>& manifold) const {
    List<Named> repeated;
    if (repeats(manifold)) repeated = in_order(manifold);
    for (ContactPoint<T>& p : manifold.points) p.feature = names_[p.feature].feature;
    if (!repeated.empty()) tell_apart(repeated, manifold);
  }

 private:
  /// Room for the points of nearly all manifolds.
  template <class Element>
  using List = SmallVector<Element, 64>;
  /// A number and the pieces that it is of.
  struct Name {
    std::uint32_t feature;
    LeafPair leaves;
    auto key() const { return std::tie(leaves.a, leaves.b, feature); }
  };
  struct Named {
    Name name;
    std::uint32_t point;
    std::uint32_t number = 0;  ///< another one, if it is to have one
    auto key() const { return std::tie(name.feature, name.leaves.a, name.leaves.b, point); }
  };

  template <class T>
  void hold(const Name& name, ContactPoint<T>& point) {
    names_.push_back(name);
    point.feature = static_cast<std::uint32_t>(names_.size() - 1);
  }

  template <class T>
  bool repeats(const Manifold<T>& manifold) const {
    constexpr std::size_t few = 16;  // are compared with each other
    const auto number = [&](const ContactPoint<T>& p) { return names_[p.feature].feature; };
    const auto& points = manifold.points;
    if (points.size() > few) {
      List<std::uint32_t> numbers;
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
  List<Named> in_order(const Manifold<T>& manifold) const {
    List<Named> named;
    for (const ContactPoint<T>& p : manifold.points)
      named.push_back({names_[p.feature], static_cast<std::uint32_t>(named.size())});
    std::sort(named.begin(), named.end(), [](const Named& n, const Named& m) { return n.key() < m.key(); });
    return named;
  }

  /// Gives all but the first of each number, in order, another one that nobody has. Several that try one number have it
  /// in the order of their pieces: the first, and the others try again.
  template <class T>
  static void tell_apart(const List<Named>& in_order, Manifold<T>& manifold) {
    List<std::uint32_t> taken;
    List<Named> waiting;
    for (const Named& n : in_order)
      if (taken.empty() || taken.back() != n.name.feature)
        taken.push_back(n.name.feature);
      else
        waiting.push_back(n);
    for (std::uint32_t tries = 0; !waiting.empty(); ++tries) {
      for (Named& n : waiting) n.number = other_number(n.name, tries);
      std::sort(waiting.begin(), waiting.end(), [](const Named& n, const Named& m) {
        return n.number != m.number ? n.number < m.number : n.key() < m.key();
      });
      const std::size_t taken_before = taken.size();
      std::size_t left = 0;
      for (const Named& n : waiting) {
        const bool had = std::binary_search(taken.begin(), taken.begin() + taken_before, n.number) ||
                         (taken.size() > taken_before && taken.back() == n.number);
        if (had) {
          waiting[left++] = n;
          continue;
        }
        taken.push_back(n.number);
        manifold.points[n.point].feature = n.number;
      }
      waiting.truncate(left);
      if (left > 0) std::sort(taken.begin(), taken.end());
    }
  }

  /// Half of a number for a feature of a piece. It is of no kind, since the manifold's piece is another one.
  static std::uint32_t half_of_piece(std::uint32_t half, std::uint32_t leaf, std::uint32_t tries) {
    // A multiplication by the golden ratio spreads neighbouring pieces over the range: Knuth 1973, "The art of computer
    // programming", volume 3, section 6.4.
    const std::uint32_t spread = (half + (leaf << 16) + (leaf >> 16) + tries * 0x10001u) * 2654435769u;
    return detail::feature_of_kind(0, spread >> (32 - detail::feature_number_bits));
  }

  /// Another number for a point, from its own pieces. The half of a shape in one piece stays; in further tries both
  /// change, as those that have one half in common may be more than a half can tell apart.
  static std::uint32_t other_number(const Name& name, std::uint32_t tries) {
    const auto half = [tries](std::uint32_t own, std::uint32_t leaf) {
      return leaf == 0 && tries == 0 ? own : half_of_piece(own, leaf, tries);
    };
    return feature_id(half(name.feature >> 16, name.leaves.a), half(name.feature & 0xffff, name.leaves.b));
  }

  SmallVector<Name, 32> names_;  ///< room for those of most pairs
};

}  // namespace graze
