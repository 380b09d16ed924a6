// A table from a caller's id to the place of the thing with that id.
//
// Guarantee: constant time. Ids that lie close together, the usual case, are an array's indices and cost one load; any
// others are hashed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace graze {

class IdTable {
 public:
  static constexpr std::uint32_t none = ~0u;

  /// The place of an id; `none` for one that is not in use.
  std::uint32_t find(std::uint32_t id) const {
    if (id < near_.size()) return near_[id];
    if (far_.empty()) return none;
    const auto found = far_.find(id);
    return found == far_.end() ? none : found->second;
  }
  /// Adds an id that is not in use.
  void insert(std::uint32_t id, std::uint32_t place) {
    ++size_;
    if (id >= near_.size() && id / spread < size_ + few) extend(id);
    if (id < near_.size())
      near_[id] = place;
    else
      far_.emplace(id, place);
  }
  /// Removes an id that is in use.
  void erase(std::uint32_t id) {
    --size_;
    if (id < near_.size())
      near_[id] = none;
    else
      far_.erase(id);
  }

  std::size_t size() const { return size_; }
  /// The bytes of the array, and of each hashed id with its place, the pointer to the next one, and the bucket.
  std::size_t memory() const {
    return near_.capacity() * sizeof(std::uint32_t) + far_.size() * 2 * sizeof(void*) +
           far_.bucket_count() * sizeof(void*);
  }

 private:
  /// The places that the array may have for each id: up to here it takes no more memory than a hash table.
  static constexpr std::size_t spread = 4, few = 64;

  void extend(std::uint32_t id) {
    near_.resize(std::max<std::size_t>(std::size_t{id} + 1, near_.size() * 2), none);
    std::erase_if(far_, [&](const auto& entry) {
      if (entry.first >= near_.size()) return false;
      near_[entry.first] = entry.second;
      return true;
    });
  }

  std::vector<std::uint32_t> near_;
  std::unordered_map<std::uint32_t, std::uint32_t> far_;
  std::size_t size_ = 0;
};

}  // namespace graze
