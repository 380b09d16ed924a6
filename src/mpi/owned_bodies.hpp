// The bodies that live on one rank, in the order of their keys.
//
// Guarantee: a body is found in logarithmic time; those that come and go between two calls of `settle` cost that, and
// one pass over all. References are good until the next `settle` or `add`.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "graze/mpi/world.hpp"

namespace graze::mpi {

template <class T>
class OwnedBodies {
 public:
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};
  struct Entry {
    Key key;
    Body<T> body;                   ///< its rotation of unit length, as `Space::checked` leaves it
    float cost;                     ///< of the last update, in units of a body's; 0 where that is not known
    std::uint32_t place = nowhere;  ///< in the arrays of this rank, where it has one
    bool gone = false;
    bool reshaped = false;  ///< since the last update
  };

  Entry* find(Key key) {
    const auto there = from(key);
    if (there != settled_.end() && there->key == key && !there->gone) return &*there;
    const auto came = came_.find(key);
    return came == came_.end() ? nullptr : &came->second;
  }
  const Entry* find(Key key) const { return const_cast<OwnedBodies*>(this)->find(key); }
  bool contains(Key key) const { return find(key) != nullptr; }

  /// Adds a body with a key that is not here. Bodies in ascending order take their places at once, and others wait for
  /// theirs only until they are many, because each holds more memory meanwhile.
  void add(Key key, Body<T> body, float cost, bool reshaped) {
    if (came_.empty() && (settled_.empty() || settled_.back().key < key)) {
      if (settled_.size() == settled_.capacity()) settled_.reserve(roomy(settled_.size()));
      settled_.push_back({key, std::move(body), cost, nowhere, false, reshaped});
      return;
    }
    came_.emplace(key, Entry{key, std::move(body), cost, nowhere, false, reshaped});
    if (came_.size() > roomy(settled_.size()) - settled_.size()) settle();
  }
  /// Removes the body of a key that is here.
  void remove(Key key) {
    if (came_.erase(key) == 0) remove(*find(key));
  }
  /// Removes one of `settled`.
  void remove(Entry& entry) {
    entry.gone = true;
    ++gone_;
  }

  /// Puts the bodies that came among the others, and takes out those that went.
  void settle() {
    if (gone_ > 0) std::erase_if(settled_, [](const Entry& e) { return e.gone; });
    gone_ = 0;
    if (came_.empty()) return;
    const auto middle = static_cast<std::ptrdiff_t>(settled_.size());
    if (settled_.size() + came_.size() > settled_.capacity()) settled_.reserve(roomy(settled_.size() + came_.size()));
    for (auto& [key, entry] : came_) settled_.push_back(std::move(entry));
    came_.clear();
    std::inplace_merge(settled_.begin(), settled_.begin() + middle, settled_.end(),
                       [](const Entry& a, const Entry& b) { return a.key < b.key; });
  }
  /// All bodies, where none came or went since `settle`.
  std::vector<Entry>& settled() { return settled_; }

  /// The first of `settled` that has this key or a larger one.
  typename std::vector<Entry>::iterator from(Key key) {
    return std::lower_bound(settled_.begin(), settled_.end(), key,
                            [](const Entry& e, Key wanted) { return e.key < wanted; });
  }

  std::size_t size() const { return settled_.size() - gone_ + came_.size(); }
  std::vector<Key> keys() const {
    std::vector<Key> keys;
    keys.reserve(size());
    for (const Entry& e : settled_)
      if (!e.gone) keys.push_back(e.key);
    const auto middle = static_cast<std::ptrdiff_t>(keys.size());
    for (const auto& [key, entry] : came_) keys.push_back(key);
    std::inplace_merge(keys.begin(), keys.begin() + middle, keys.end());
    return keys;
  }
  std::size_t memory() const { return settled_.capacity() * sizeof(Entry) + came_.size() * (sizeof(Entry) + 48); }

 private:
  /// Room for an eighth more, where a vector would take twice as much.
  static std::size_t roomy(std::size_t size) { return size + size / 8 + 1024; }

  std::vector<Entry> settled_;
  std::map<Key, Entry> came_;
  std::size_t gone_ = 0;
};

}  // namespace graze::mpi
