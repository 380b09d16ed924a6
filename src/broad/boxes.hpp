// The boxes of a broad phase by id, with marks of those that moved.
//
// Guarantee: refuses what the interface refuses; insertion, removal and look-up in constant time.
#pragma once

#include <algorithm>
#include <string>
#include <unordered_map>

#include "graze/broad_phase.hpp"
#include "graze/detail/validate.hpp"

namespace graze {

constexpr IdPair ordered(std::uint32_t a, std::uint32_t b) { return a < b ? IdPair{a, b} : IdPair{b, a}; }

template <class T>
void check(const Aabb<T>& box) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box.lower[i] <= box.upper[i]))
      throw InvalidValue("box", "lower <= upper on every axis",
                         validate::number(static_cast<double>(box.lower[i])) + " and " +
                             validate::number(static_cast<double>(box.upper[i])));
}

/// Boxes in one array without holes. A place in it stays until something is removed: then the last box takes the hole.
template <class T>
class BoxTable {
 public:
  struct Entry {
    Aabb<T> box;
    std::uint32_t id;
    bool moved;  ///< inserted or moved since the last `settle`
  };

  /// Inserts a box and returns its place.
  std::uint32_t insert(std::uint32_t id, const Aabb<T>& box) {
    check(box);
    const auto place = static_cast<std::uint32_t>(entries_.size());
    if (!place_.emplace(id, place).second) throw InvalidValue("id", "an id that is not in use", std::to_string(id));
    entries_.push_back({box, id, true});
    return place;
  }
  /// Removes a box and returns the place that it left; the last box of the array is there now, unless it was that one.
  std::uint32_t remove(std::uint32_t id) {
    const std::uint32_t hole = place(id);
    place_.erase(id);
    if (hole + 1 != entries_.size()) {
      entries_[hole] = entries_.back();
      place_[entries_[hole].id] = hole;
    }
    entries_.pop_back();
    return hole;
  }
  std::uint32_t move(std::uint32_t id, const Aabb<T>& box) {
    check(box);
    const std::uint32_t at = place(id);
    entries_[at].box = box;
    entries_[at].moved = true;
    return at;
  }
  void settle() {
    for (Entry& e : entries_) e.moved = false;
  }

  std::size_t size() const { return entries_.size(); }
  const Entry& operator[](std::size_t place) const { return entries_[place]; }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }
  std::uint32_t place(std::uint32_t id) const {
    const auto found = place_.find(id);
    if (found == place_.end()) throw InvalidValue("id", "an id that was inserted", std::to_string(id));
    return found->second;
  }

  /// The sorted ids of all boxes for which `accept(box)` holds.
  template <class Accept>
  void collect(std::vector<std::uint32_t>& out, const Accept& accept) const {
    out.clear();
    for (const Entry& e : entries_)
      if (accept(e.box)) out.push_back(e.id);
    std::sort(out.begin(), out.end());
  }

  /// The comparison of boxes in a search for pairs, which counts how often it is made.
  class PairTest {
   public:
    PairTest(const BoxTable& table, bool moved_only, std::vector<IdPair>& out)
        : table_(table), moved_only_(moved_only), out_(out) {}

    /// Tests two boxes of the table, by their places.
    void operator()(std::uint32_t i, std::uint32_t j) {
      const Entry &a = table_[i], &b = table_[j];
      if ((!moved_only_ || a.moved || b.moved) && overlapping(a.box, b.box)) out_.push_back(ordered(a.id, b.id));
    }
    /// Whether two boxes overlap of which at least one bounds several.
    bool overlapping(const Aabb<T>& a, const Aabb<T>& b) {
      ++count_;
      return overlap(a, b);
    }
    std::uint64_t count() const { return count_; }

   private:
    const BoxTable& table_;
    bool moved_only_;
    std::vector<IdPair>& out_;
    std::uint64_t count_ = 0;
  };

  /// The pairs that overlap, sorted, of those for which `each_pair(test)` calls `test(place, place)`; `moved_only`: of
  /// which at least one moved. Boxes that moved count as still from then on. Returns the number of comparisons.
  template <class EachPair>
  std::uint64_t collect_pairs(std::vector<IdPair>& out, bool moved_only, const EachPair& each_pair) {
    out.clear();
    PairTest test(*this, moved_only, out);
    each_pair(test);
    std::sort(out.begin(), out.end());
    settle();
    return test.count();
  }

  std::size_t memory() const {
    return entries_.capacity() * sizeof(Entry) + place_.size() * 2 * sizeof(std::uint32_t[4]) +
           place_.bucket_count() * sizeof(void*);
  }

 private:
  std::vector<Entry> entries_;
  std::unordered_map<std::uint32_t, std::uint32_t> place_;
};

/// The test whether a box that moves along a straight line touches another: slabs (Kay, Kajiya 1986, "Ray tracing
/// complex scenes") of the other grown by this one's half extents. Conservative by the rounding of its operations.
template <class T>
class SweptBox {
 public:
  SweptBox(const Aabb<T>& box, const Vec3<T>& motion) : box_(box), motion_(motion) {}

  bool operator()(const Aabb<T>& other) const {
    T enter(0), leave(1);
    for (std::size_t i = 0; i < 3; ++i) {
      const T v = motion_[i];
      if (v == T(0)) {
        if (other.lower[i] > box_.upper[i] || other.upper[i] < box_.lower[i]) return false;
        continue;
      }
      // The interval of times at which the boxes overlap along this axis, wider by what rounding may take off it.
      const T noise = greatest(noise_of(box_.lower[i]), noise_of(box_.upper[i]));
      const T low = other.lower[i] - box_.upper[i] - noise_of(other.lower[i]) - noise;
      const T high = other.upper[i] - box_.lower[i] + noise_of(other.upper[i]) + noise;
      const T first = (v > T(0) ? low : high) / v, last = (v > T(0) ? high : low) / v;
      enter = greatest(enter, first - noise_of(first));
      leave = least(leave, last + noise_of(last));
    }
    return enter <= leave;
  }
  /// The bounds of the box on its whole way.
  Aabb<T> bounds() const { return merged(box_, Aabb<T>{box_.lower + motion_, box_.upper + motion_}); }

 private:
  /// A bound for the rounding of a number by the few operations that made it. The infinite ends of boxes are exact.
  static T noise_of(T v) {
    const T size = std::abs(v);
    return size <= std::numeric_limits<T>::max() ? T(4) * std::numeric_limits<T>::epsilon() * size : T(0);
  }

  Aabb<T> box_;
  Vec3<T> motion_;
};

/// A box that is wider than another that moves by more than the sum of the roundings that `SweptBox` allows for.
template <class T>
Aabb<T> widened_for_sweep(const Aabb<T>& box, const Vec3<T>& motion) {
  const T reach = greatest(greatest(max_abs(box.lower), max_abs(box.upper)), max_abs(motion));
  return inflated(box, T(32) * std::numeric_limits<T>::epsilon() * reach);
}

template <class T>
bool has_finite_ends(const Aabb<T>& box) {
  return greatest(max_abs(box.lower), max_abs(box.upper)) <= std::numeric_limits<T>::max();
}

}  // namespace graze
