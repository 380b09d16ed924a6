// The pairs of pieces that come near each other, of two hierarchies of bounds under a relative pose.
//
// Guarantee: every pair of pieces whose boxes come within the limit is visited, in the same order for the same input;
// nearer pairs of nodes first, so that a limit that shrinks prunes the rest. The cost follows from what is near, not
// from the product of the sizes.
#pragma once

#include "graze/pose.hpp"
#include "shape/hierarchy.hpp"

namespace graze {

/// Boxes of one frame seen from another: their bounds there, not less than the true ones.
template <class T>
class TurnedBoxes {
 public:
  /// Turns boxes within `all` of the frame that stands at `pose`.
  TurnedBoxes(const Pose<T>& pose, const Aabb<T>& all)
      : rotation_(rotation_matrix(pose.rotation)), translation_(pose.translation) {
    for (std::size_t i = 0; i < 3; ++i) absolute_.row[i] = abs(rotation_.row[i]);
    // Some sixteen roundings of the largest number involved, and the distance that counts as touching for pairs.
    const T reach = max_abs(translation_) + T(3) * greatest(max_abs(all.lower), max_abs(all.upper));
    slack_ = T(64) * std::numeric_limits<T>::epsilon() * reach;
  }

  Aabb<T> operator()(const Aabb<T>& box) const {
    const Vec3<T> center = box.lower * T(0.5) + box.upper * T(0.5), half = box.upper * T(0.5) - box.lower * T(0.5);
    const Vec3<T> at = rotation_ * center + translation_, reach = absolute_ * half + Vec3<T>{slack_, slack_, slack_};
    return {at - reach, at + reach};
  }

 private:
  Mat3<T> rotation_, absolute_;
  Vec3<T> translation_;
  T slack_;
};

/// Calls `f(piece_a, piece_b)` for the pieces of all pairs of leaves that come within `limit()` of each other. `f` may
/// return false to end the visit; returns whether it went to the end.
template <class A, class B, class T, class Limit, class F>
bool visit_pairs(const A& a, const B& b, const Pose<T>& b_in_a, const Limit& limit, F&& f) {
  struct Entry {
    typename A::Ref a;
    typename B::Ref b;
    T key;
  };
  if (a.empty() || b.empty()) return true;
  const TurnedBoxes<T> from_b(b_in_a, b.bounds()), from_a(inverse(b_in_a), a.bounds());
  const auto size = [](const Aabb<T>& box) {
    const Vec3<T> e = box.extent();
    return e.x + e.y + e.z;
  };
  TraversalStack<Entry> stack;
  stack.push({a.root(), b.root(), BoxQuestion<T>{from_b(b.bounds())}(a.bounds())});
  // Opens one node of the pair: its children against the other's box, all in the frame of the one that is opened.
  const auto open = [&](const auto& tree, const auto& ref, const Aabb<T>& other, T most, const auto& entry_of) {
    using Tree = std::decay_t<decltype(tree)>;
    typename Tree::Children children;
    tree.children(ref, children);
    const BoxQuestion<T> question{other};
    T keys[Tree::width];
    for (std::size_t i = 0; i < Tree::width; ++i) keys[i] = question(children.box(i));
    detail::push_nearest_last(stack, keys, children.count, most,
                              [&](std::size_t i) { return entry_of(children.ref[i], keys[i]); });
  };
  while (!stack.empty()) {
    const Entry entry = stack.pop();
    const T most = signed_square(static_cast<T>(limit()));
    if (entry.key > most) continue;
    const bool leaf_a = a.leaf(entry.a), leaf_b = b.leaf(entry.b);
    if (leaf_a && leaf_b) {
      auto with_a = [&](std::uint32_t piece_a) {
        auto with_b = [&](std::uint32_t piece_b) { return go_on(f, piece_a, piece_b); };
        return b.each_piece(entry.b, with_b);
      };
      if (!a.each_piece(entry.a, with_a)) return false;
      continue;
    }
    const Aabb<T> box_a = a.box(entry.a), box_b = b.box(entry.b);
    if (leaf_b || (!leaf_a && size(box_a) >= size(box_b)))
      open(a, entry.a, from_b(box_b), most, [&](const typename A::Ref& child, T key) {
        return Entry{child, entry.b, key};
      });
    else
      open(b, entry.b, from_a(box_a), most, [&](const typename B::Ref& child, T key) {
        return Entry{entry.a, child, key};
      });
  }
  return true;
}

}  // namespace graze
