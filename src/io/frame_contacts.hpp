// The contacts of bodies in a step, of space or of the plane.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "graze/io/recording.hpp"
#include "graze/world/manifolds.hpp"

namespace graze::io {

/// The contacts of each two bodies, all parts together, in the order in which they first meet. `body_of[i]`: the
/// scene's body of which the body of index i is a part.
template <class T, class Space>
std::vector<ContactState> frame_contacts(const ContactArrays<T, Space>& contacts,
                                         const std::vector<std::uint32_t>& body_of) {
  std::vector<ContactState> out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
  for (const ContactPair<T>& pair : contacts.pairs) {
    ContactState found{body_of[pair.a], body_of[pair.b], 0, 0, 0};
    for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair))
      for (const SolverPoint<T, Space>& p : contacts.points_of(m)) {
        const auto impulse = static_cast<double>(dot(p.impulse, m.normal));
        if (!(impulse > 0) && p.distance > T(0)) continue;  // near, and not touched
        ++found.points;
        found.impulse += impulse;
        found.depth = std::max(found.depth, -static_cast<double>(p.distance));
      }
    if (found.points == 0) continue;
    const auto [at, first] = known.insert({{found.a, found.b}, out.size()});
    if (first) {
      out.push_back(found);
      continue;
    }
    ContactState& all = out[at->second];
    all.points += found.points;
    all.impulse += found.impulse;
    all.depth = std::max(all.depth, found.depth);
  }
  return out;
}

}  // namespace graze::io
