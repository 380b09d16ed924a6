#include <type_traits>

#include "graze/query.hpp"
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
    placed_.clear();
    for (const Pair& pair : pairs)
      for (const Body* body : {&pair.a, &pair.b}) placed_.push_back({graze_shape<T>(*body), cast<T>(body->pose)});
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
      found.normal = cast<double>(manifold.normal);
      for (const ContactPoint<T>& point : manifold.points) {
        ++found.count;
        found.deepest = std::min(found.deepest, static_cast<double>(point.distance));
      }
    }
    return found;
  }

  std::vector<Placed<T>> placed_;
  Manifolds<T> manifolds_;
};

const Registered<Graze<double>> in_double;
const Registered<Graze<float>> in_float;

}  // namespace

}  // namespace graze::bench
