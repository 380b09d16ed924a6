// Contacts put in the place of the last ones, where few pairs changed and have as many points as they had.
//
// Guarantee: each pair has the contacts that finding all of them anew would give it. Pairs and kinds are the same, so
// that a pair with as many manifolds and points as before may stand where it stood; where any pair has not, nothing is
// put in place and everything is found anew. So few bodies that move among many at rest cost what they do themselves,
// and a look at each pair.
#include <algorithm>
#include <utility>

#include "composite/composite.hpp"
#include "graze/plane/space.hpp"
#include "graze/world/manifolds.hpp"
#include "world/waiting.hpp"

namespace graze {

namespace {

/// The share of pairs, one in so many, up to which contacts are mended: of more that changed one is likely to have
/// other points, and copying those of the rest costs little beside finding these.
constexpr std::size_t pairs_per_asked = 8;

}  // namespace

/// Finds the changed pairs anew, where they are few; returns whether all of them found their place. The last arrays
/// stand in `last_`, and the new ones in `now_` when they have.
template <class T, class Space>
bool ManifoldFinder<T, Space>::mend(const BodyArrays<T, Space>& bodies) {
  if (!list_asked()) return false;
  find_asked(bodies);
  const bool all_fit = std::all_of(asked_.begin(), asked_.end(), [&](const Asked& a) { return fits(a); });
  for (const Asked& asked : asked_) {
    if (all_fit) put_in_place(asked);
    contact_[asked.place] = asked.contact;
  }
  if (all_fit) std::swap(last_, now_);
  return all_fit;
}

/// Lists the pairs that changed, kind by kind; false where they are too many.
template <class T, class Space>
bool ManifoldFinder<T, Space>::list_asked() {
  asked_places_.clear();
  const std::size_t most = pairs_.size() / pairs_per_asked;
  for (const std::uint32_t place : bins_.order) {
    const int either = seen_[pairs_[place].a].traits | seen_[pairs_[place].b].traits;
    if ((either & changed) == 0 && !(ground_changed_ && (either & fixed) != 0)) continue;
    if ((either & fresh) != 0 || asked_places_.size() == most) return false;
    asked_places_.push_back(place);
  }
  return true;
}

/// Finds these pairs anew in tasks of one kind each. The results are in `touches_` and `contact_`, as within a task.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_asked(const BodyArrays<T, Space>& bodies) {
  constexpr std::size_t own = 1;  // the first one has the room of the arrays
  if (found_.size() <= own) found_.resize(own + 1);
  Found& found = found_[own];
  found.manifolds.clear();
  found.points.clear();
  asked_.clear();
  const auto kind = [&](std::uint32_t place) {
    return std::pair(bins_.types[pairs_[place].a], bins_.types[pairs_[place].b]);
  };
  Waiting<T, Space> waiting;
  Task task{.found = own};
  for (std::size_t begin = 0, end = 0; begin < asked_places_.size(); begin = end, ++task.number) {
    const auto [type_a, type_b] = kind(asked_places_[begin]);
    task.first_manifold = found.manifolds.size();
    task.first_point = found.points.size();
    task.contacts = 0;
    while (end < asked_places_.size() && end - begin < pairs_per_task &&
           kind(asked_places_[end]) == std::pair(type_a, type_b)) {
      const std::uint32_t place = asked_places_[end++];
      asked_.push_back({place, contact_[place], task.first_manifold});
    }
    if (touches_.size() < (task.number + 1) * pairs_per_task) touches_.resize((task.number + 1) * pairs_per_task);
    waiting.lanes = PairContacts<T, Space>::lanes(type_a, type_b);
    find_of_a_kind(bodies, std::span<const std::uint32_t>(asked_places_).subspan(begin, end - begin), waiting, task);
  }
}

/// Whether a pair has as many manifolds, each of as many points, as after the last call.
template <class T, class Space>
bool ManifoldFinder<T, Space>::fits(const Asked& asked) const {
  const std::uint32_t now = contact_[asked.place];
  if (now >= apart || asked.contact >= apart) return now == asked.contact;
  const Touch& touch = touches_[now];
  const auto before = last_.manifolds_of(last_.pairs[asked.contact]);
  const auto after =
      found_[1].manifolds.filled().subspan(asked.first_manifold + touch.first_manifold, touch.manifold_count);
  return std::equal(before.begin(), before.end(), after.begin(), after.end(),
                    [](const auto& m, const auto& n) { return m.point_count == n.point_count; });
}

template <class T, class Space>
void ManifoldFinder<T, Space>::put_in_place(const Asked& asked) {
  if (asked.contact >= apart) return;
  const Touch& touch = touches_[contact_[asked.place]];
  const Found& found = found_[1];
  ContactPair<T>& pair = last_.pairs[asked.contact];
  pair.overlap = touch.overlap;
  for (std::uint32_t i = 0; i < pair.manifold_count; ++i) {
    ContactManifold<T, Space>& to = last_.manifolds[pair.first_manifold + i];
    const ContactManifold<T, Space>& from = found.manifolds.filled()[asked.first_manifold + touch.first_manifold + i];
    std::copy_n(found.points.filled().data() + from.first_point, from.point_count,
                last_.points.data() + to.first_point);
    to = {from.normal, from.piece_a, from.piece_b, to.first_point, to.point_count};
  }
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;
template class ManifoldFinder<float, plane::Space<float>>;
template class ManifoldFinder<double, plane::Space<double>>;

}  // namespace graze
