#include <optional>
#include <type_traits>

#include "graze/cast.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "graze_shape.hpp"
#include "peer.hpp"

namespace graze::bench {

namespace {

template <class T>
class Graze {
 public:
  static constexpr bool single_precision = std::is_same_v<T, float>;
  static constexpr const char* name = single_precision ? "graze float" : "graze double";
  static std::string version() { return "this tree"; }

  bool prepare(std::span<const Pair> pairs) {
    placed_.reserve(2 * pairs.size());
    OncePerCorners<std::optional<Shape<T>>> shared;
    for (const Pair& pair : pairs) {
      for (const Body* body : {&pair.a, &pair.b})
        placed_.push_back({*shared.of(*body, [](const Body& b) { return std::optional(graze_shape<T>(b)); }),
                           graze::converted<T>(body->pose)});
      if (max_abs(pair.motion) > 0)
        ways_.push_back({graze::converted<T>(pair.motion), static_cast<T>(length(pair.motion))});
    }
    return true;
  }
  bool overlap(std::size_t i) {
    const Placed<T>&a = placed_[2 * i], &b = placed_[2 * i + 1];
    return graze::overlap(a.shape, a.pose, b.shape, b.pose);
  }
  double distance(std::size_t i) {
    const Placed<T>&a = placed_[2 * i], &b = placed_[2 * i + 1];
    return static_cast<double>(graze::distance(a.shape, a.pose, b.shape, b.pose).distance);
  }
  Contacts contacts(std::size_t i) { return contacts_within(i, T(0)); }
  double raycast(std::size_t i) {
    const Placed<T>&a = placed_[2 * i], &b = placed_[2 * i + 1];
    const auto hit = graze::raycast(a.shape, a.pose, {b.pose.translation, ways_[i].motion}, ways_[i].length);
    return hit ? static_cast<double>(hit->t / ways_[i].length) : never;
  }
  double cast(std::size_t i) {
    const Placed<T>&a = placed_[2 * i], &b = placed_[2 * i + 1];
    const auto hit = graze::cast<T>(a.shape, a.pose, {ways_[i].motion, {}}, b.shape, b.pose, {}, T(1));
    return hit ? static_cast<double>(hit->t) : never;
  }
  /// Hulls' own data apart, which pairs share; contacts with four points, as of two faces.
  std::size_t touched(Query query) const {
    constexpr std::size_t both = 2 * sizeof(Placed<T>);
    switch (query) {
    case Query::overlap: break;
    case Query::distance: return both + sizeof(Distance<T>);
    case Query::contacts: return both + sizeof(Manifold<T>::normal) + 4 * sizeof(ContactPoint<T>);
    case Query::raycast: return sizeof(Placed<T>) + sizeof(Vec3<T>) + sizeof(Way) + sizeof(RayHit<T>);
    case Query::cast: return both + sizeof(Way) + sizeof(CastHit<T>);
    }
    return both;
  }
  Contacts resting_contacts(std::size_t i) {
    return contacts_within(i, contact_margin(placed_[2 * i].shape, placed_[2 * i + 1].shape));
  }

 private:
  Contacts contacts_within(std::size_t i, T margin) {
    const Placed<T>&a = placed_[2 * i], &b = placed_[2 * i + 1];
    manifolds_.clear();
    graze::contacts(a.shape, a.pose, b.shape, b.pose, margin, manifolds_);
    Contacts found;
    for (const Manifold<T>& manifold : manifolds_) {
      found.normal = graze::converted<double>(manifold.normal);
      for (const ContactPoint<T>& point : manifold.points) {
        ++found.count;
        found.deepest = std::min(found.deepest, static_cast<double>(point.distance));
      }
    }
    return found;
  }

  struct Way {
    Vec3<T> motion;
    T length;
  };

  std::vector<Placed<T>> placed_;
  std::vector<Way> ways_;
  Manifolds<T> manifolds_;
};

const Registered<Graze<double>> in_double;
const Registered<Graze<float>> in_float;

}  // namespace

}  // namespace graze::bench
