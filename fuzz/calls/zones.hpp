// Memory for the arguments of one call: each array in a zone of its own size, so that a sanitizer sees who leaves it.
#pragma once

#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "graze/graze.h"

/// What a result's memory holds before the call: no value that anybody could take for an answer.
inline constexpr int untouched = 0xa5;

class Zones {
 public:
  /// Room for `count` elements that begin `pitch` bytes apart, all of them untouched.
  template <class T>
  T* room(std::size_t count, std::size_t pitch = sizeof(T)) {
    const std::size_t size = pitch * (count - 1) + sizeof(T);
    zones_.push_back({std::unique_ptr<char, Freed>(static_cast<char*>(std::malloc(size))), std::string(size, '\0')});
    std::memset(zones_.back().memory.get(), untouched, size);
    return reinterpret_cast<T*>(zones_.back().memory.get());
  }
  /// Remembers all zones as they are.
  void remember() {
    for (Zone& zone : zones_) std::memcpy(zone.before.data(), zone.memory.get(), zone.before.size());
  }
  /// Whether all zones are as they were remembered.
  bool same() const {
    for (const Zone& zone : zones_)
      if (std::memcmp(zone.before.data(), zone.memory.get(), zone.before.size()) != 0) return false;
    return true;
  }
  void clear() { zones_.clear(); }

 private:
  struct Freed {
    void operator()(char* memory) const { std::free(memory); }
  };
  struct Zone {
    std::unique_ptr<char, Freed> memory;
    std::string before;
  };
  std::vector<Zone> zones_;
};

/// Handles of one kind, a few at a time.
template <class H>
class Pool {
 public:
  explicit Pool(void (*destroy)(H*)) : destroy_(destroy) {}
  ~Pool() {
    for (H* handle : handles_) destroy_(handle);
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  H* pick(std::uint8_t which) const { return handles_.empty() ? nullptr : handles_[which % handles_.size()]; }
  /// Keeps a handle, in place of one of the others where there are `most`.
  void keep(H* handle, std::uint8_t which, std::size_t most) {
    if (handles_.size() < most) return handles_.push_back(handle);
    H*& place = handles_[which % most];
    destroy_(place);
    place = handle;
  }

 private:
  void (*destroy_)(H*);
  std::vector<H*> handles_;
};

/// A type as an argument.
template <class T>
struct Tag {};
