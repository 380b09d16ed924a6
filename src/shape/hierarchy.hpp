// The search of every hierarchy of bounds: nearest first, with a limit that may shrink on the way.
//
// Guarantee: every piece whose bounds the question does not rule out is visited, the same ones in the same order for
// the same input; nothing is allocated unless a hierarchy is deeper than any good one is; no recursion.
//
// A hierarchy (`WideTree`, `HeightPyramid`) has a root, the children of each node with their boxes, and the
// pieces of each leaf. A question (`BoxQuestion`, `PlaneQuestion`, `RayQuestion`) gives each box a key, a lower
// bound of the answer for everything inside: boxes whose key exceeds the limit are left out, and the one with the
// least key is visited first.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "graze/aabb.hpp"

namespace graze {

/// The boxes of a node's children, a lane each. Lanes from `count` on hold numbers without meaning.
template <class T, class Ref, std::size_t N>
struct ChildBoxes {
  T lower[3][N], upper[3][N];
  Ref ref[N];
  std::size_t count;

  Aabb<T> box(std::size_t i) const {
    return {{lower[0][i], lower[1][i], lower[2][i]}, {upper[0][i], upper[1][i], upper[2][i]}};
  }
};

/// A stack, on the heap only beyond the depth that hierarchies of tens of millions of pieces need.
template <class Entry>
class TraversalStack {
 public:
  bool empty() const { return size_ == 0; }
  void push(const Entry& entry) {
    if (size_ < inside)
      entries_[size_++] = entry;
    else
      more_.push_back(entry);
  }
  Entry pop() {
    if (more_.empty()) return entries_[--size_];
    const Entry entry = more_.back();
    more_.pop_back();
    return entry;
  }

 private:
  static constexpr std::size_t inside = 96;
  Entry entries_[inside];
  std::size_t size_ = 0;
  std::vector<Entry> more_;
};

/// The square of a distance with its sign: as monotone as the distance, and without a root.
template <class T>
constexpr T signed_square(const T& distance) {
  return distance < T(0) ? -(distance * distance) : distance * distance;
}

/// The question how near a box is to a region. The key is a lower bound of the signed distance, squared with
/// its sign: of boxes that overlap, minus the least translation along an axis that parts them, since that
/// also parts what they hold.
template <class T>
struct BoxQuestion {
  using Key = T;
  Aabb<T> region;

  T operator()(const Aabb<T>& box) const {
    const Vec3<T> apart = greatest(box.lower - region.upper, region.lower - box.upper);
    const Vec3<T> gap = greatest(apart, Vec3<T>{});
    const T most = greatest(apart.x, greatest(apart.y, apart.z));
    return most > T(0) ? length_squared(gap) : -(most * most);
  }
  /// The keys of all children of a node, in loops over lanes that compilers make vectors of.
  template <class Ref, std::size_t N>
  void operator()(const ChildBoxes<T, Ref, N>& children, T (&keys)[N]) const {
    T most[N], squared[N];
    for (std::size_t i = 0; i < N; ++i) most[i] = -std::numeric_limits<T>::infinity(), squared[i] = T(0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < N; ++i) {
        const T apart =
            greatest(children.lower[axis][i] - region.upper[axis], region.lower[axis] - children.upper[axis][i]);
        const T gap = greatest(apart, T(0));
        most[i] = greatest(most[i], apart);
        squared[i] += gap * gap;
      }
    for (std::size_t i = 0; i < N; ++i) keys[i] = most[i] > T(0) ? squared[i] : -(most[i] * most[i]);
  }
  T key(const T& limit) const { return signed_square(limit); }
};

/// The question how low a box reaches along a unit vector, from the plane of points at `offset` along it.
template <class T>
struct PlaneQuestion {
  using Key = T;
  Vec3<T> normal;
  T offset;

  T operator()(const Aabb<T>& box) const {
    const Vec3<T> low = scaled(normal, box.lower), high = scaled(normal, box.upper), lowest = least(low, high);
    return lowest.x + lowest.y + lowest.z - offset;
  }
  T key(const T& limit) const { return limit; }
};

/// The question where a ray enters a box. Boxes grow by `slack` on all sides; where the ray misses, the key
/// is infinite. The scalar may be wider than the boxes'. `inverse` is 1 / direction, infinite along axes that
/// the ray does not move on.
template <class S>
struct RayQuestion {
  using Key = S;
  Vec3<S> origin, inverse;
  S begin, end, slack;

  template <class T>
  S operator()(const Aabb<T>& box) const {
    // Slabs (Kay, Kajiya 1986). 0 * infinity is no number: the ray lies in the side of the box, which does not bound
    // it, and the comparisons below pass over it.
    S enter = begin, leave = end;
    for (std::size_t i = 0; i < 3; ++i) {
      const S low = static_cast<S>(box.lower[i]) - slack - origin[i],
              high = static_cast<S>(box.upper[i]) + slack - origin[i];
      const bool forward = inverse[i] >= S(0);
      const S first = (forward ? low : high) * inverse[i], last = (forward ? high : low) * inverse[i];
      enter = first > enter ? first : enter;
      leave = last < leave ? last : leave;
    }
    // The quotients' rounding must not part the two where the ray passes through a corner or a flat box (Ize 2013,
    // "Robust BVH ray traversal": three roundings on each side).
    constexpr S rounding = S(4) * std::numeric_limits<S>::epsilon();
    const S widest = leave + (leave < S(0) ? -leave : leave) * rounding;
    return enter <= widest ? enter : std::numeric_limits<S>::infinity();
  }
  /// The limit as a key: finite, so that boxes that the ray misses are left out.
  S key(const S& limit) const { return least(limit, std::numeric_limits<S>::max()); }
};

/// Calls `f` and returns whether to go on: it returned nothing or true.
template <class F, class... Arguments>
bool go_on(F& f, const Arguments&... arguments) {
  if constexpr (std::is_same_v<std::invoke_result_t<F&, const Arguments&...>, bool>) {
    return f(arguments...);
  } else {
    f(arguments...);
    return true;
  }
}

namespace detail {

/// Pushes the children whose keys, of `count`, the limit lets pass, the least last, so that it is popped first; of
/// equals, the first.
template <class Stack, class Key, std::size_t N, class Entry>
void push_nearest_last(Stack& stack, const Key (&keys)[N], std::size_t count, const Key& limit, const Entry& entry_of) {
  std::uint8_t sorted[N];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (keys[i] > limit) continue;
    std::size_t at = kept++;
    for (; at > 0 && keys[sorted[at - 1]] <= keys[i]; --at) sorted[at] = sorted[at - 1];
    sorted[at] = static_cast<std::uint8_t>(i);
  }
  for (std::size_t i = 0; i < kept; ++i) stack.push(entry_of(sorted[i]));
}

}  // namespace detail

/// Calls `f(piece)` for the pieces of all leaves that the question does not rule out. `limit()` is called again on the
/// way. `f` may return false to end the visit; returns whether it went to the end.
template <class Hierarchy, class Question, class Limit, class F>
bool visit(const Hierarchy& hierarchy, const Question& question, const Limit& limit, F&& f) {
  using Key = typename Question::Key;
  struct Entry {
    typename Hierarchy::Ref ref;
    Key key;
  };
  if (hierarchy.empty()) return true;
  constexpr std::size_t width = Hierarchy::width;
  TraversalStack<Entry> stack;
  stack.push({hierarchy.root(), question(hierarchy.bounds())});
  while (!stack.empty()) {
    const Entry entry = stack.pop();
    const Key most = question.key(static_cast<Key>(limit()));
    if (entry.key > most) continue;
    if (hierarchy.leaf(entry.ref)) {
      if (!hierarchy.each_piece(entry.ref, f)) return false;
      continue;
    }
    typename Hierarchy::Children children;
    hierarchy.children(entry.ref, children);
    Key keys[width];
    if constexpr (requires { question(children, keys); })
      question(children, keys);
    else
      for (std::size_t i = 0; i < width; ++i) keys[i] = question(children.box(i));
    detail::push_nearest_last(stack, keys, children.count, most, [&](std::size_t i) {
      return Entry{children.ref[i], keys[i]};
    });
  }
  return true;
}

/// Visits the pieces whose boxes come within `limit()` of a region in the hierarchy's frame, nearest first.
template <class Hierarchy, class T, class Limit, class F>
bool visit(const Hierarchy& hierarchy, const Aabb<T>& region, const Limit& limit, F&& f) {
  return visit(hierarchy, BoxQuestion<T>{region}, limit, f);
}

/// Visits the pieces whose boxes, grown by `slack`, a ray crosses with begin <= t <= limit(), in the order in which it
/// enters the leaves. `inverse` is 1 / direction component by component, and infinite where that is 0.
template <class Hierarchy, class S, class Limit, class F>
bool visit_ray(const Hierarchy& hierarchy, const Vec3<S>& origin, const Vec3<S>& inverse, const Limit& limit, F&& f,
               S begin = S(0), S slack = S(0)) {
  return visit(hierarchy, RayQuestion<S>{origin, inverse, begin, static_cast<S>(limit()), slack}, limit, f);
}

}  // namespace graze
