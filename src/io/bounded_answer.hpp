// The member of an answer that is not proven within the library's tolerance.
#pragma once

#include <vector>

#include "graze/result.hpp"
#include "io/json_writer.hpp"

namespace graze::io {

/// Writes the error that an answer may have that is not proven.
template <class T>
void write_bounded(bool proven, T error, JsonWriter& out) {
  if (!proven) out.key("bounded").number(error);
}

/// Writes the error of manifolds, which are as sure as the least sure of them.
template <class Manifold>
void write_bounded_of(const std::vector<Manifold>& manifolds, JsonWriter& out) {
  bool proven = true;
  decltype(Manifold::error) error{};
  for (const Manifold& manifold : manifolds) {
    if (manifold.status == Status::converged) continue;
    proven = false;
    if (manifold.error > error) error = manifold.error;
  }
  write_bounded(proven, error, out);
}

}  // namespace graze::io
