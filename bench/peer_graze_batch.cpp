// Graze asked about all pairs at once, in single precision, of arrays of shapes of one kind. Like the others it goes
// through the answers once: their sum is taken.
#ifdef GRAZE_BENCH_BATCH

#include <numeric>
#include <variant>

#include "graze/batch.hpp"
#include "graze_shape.hpp"
#include "peer.hpp"

namespace graze::bench {

namespace {

/// One side of all pairs: shapes of a kind and their poses.
class Side {
 public:
  void reserve(std::size_t count) { poses_.reserve(count); }
  void add(const Shape<float>& shape, const Posef& pose) {
    shape.visit([&]<class C>(const C& concrete) {
      if constexpr (std::is_constructible_v<Shapes, std::vector<C>>) {
        if (!std::holds_alternative<std::vector<C>>(shapes_)) {
          shapes_.emplace<std::vector<C>>();
          std::get<std::vector<C>>(shapes_).reserve(poses_.capacity());
        }
        std::get<std::vector<C>>(shapes_).push_back(concrete);
      }
    });
    poses_.push_back(pose);
  }
  Bodies<float> first(std::size_t count) const {
    return std::visit(
        [&]<class C>(const std::vector<C>& shapes) {
          return Bodies<float>(std::span(shapes).first(count), std::span(poses_).first(count));
        },
        shapes_);
  }
  std::size_t bytes() const {
    return sizeof(Posef) + std::visit([]<class C>(const std::vector<C>&) { return sizeof(C); }, shapes_);
  }

 private:
  using Shapes = std::variant<std::vector<Sphere<float>>, std::vector<Capsule<float>>, std::vector<Box<float>>,
                              std::vector<Cylinder<float>>, std::vector<Ellipsoid<float>>, std::vector<Triangle<float>>,
                              std::vector<ConvexHull<float>>, std::vector<HalfSpace<float>>, std::vector<Mesh<float>>>;
  Shapes shapes_;
  std::vector<Posef> poses_;
};

class GrazeBatch {
 public:
  static constexpr const char* name = "graze float batch";
  static constexpr bool single_precision = true;
  static std::string version() { return "this tree"; }

  bool prepare(std::span<const Pair> pairs) {
    OncePerCorners<std::optional<Shape<float>>> shared;
    const auto shape = [&](const Body& body) {
      return *shared.of(body, [](const Body& b) { return std::optional(graze_shape<float>(b)); });
    };
    a_.reserve(pairs.size());
    b_.reserve(pairs.size());
    for (const Pair& pair : pairs) {
      a_.add(shape(pair.a), converted<float>(pair.a.pose));
      b_.add(shape(pair.b), converted<float>(pair.b.pose));
    }
    return true;
  }

  double run(Query query, std::size_t count) {
    const Batch<float> batch(a_.first(count), b_.first(count));
    double sum = 0;
    if (query == Query::overlap) {
      graze::overlap(batch, touch_);
      sum = std::accumulate(touch_.begin(), touch_.end(), 0.0);
    } else if (query == Query::distance) {
      graze::distance(batch, distances_);
      for (const Distance<float>& d : distances_) sum += static_cast<double>(d.distance);
    } else {
      graze::contacts(batch, 0.0f, found_);
      for (std::size_t i = 0; i < count; ++i) sum += contacts(i).deepest;
    }
    return sum;
  }
  bool overlap(std::size_t i) { return touch_[i] != 0; }
  double distance(std::size_t i) { return static_cast<double>(distances_[i].distance); }
  Contacts contacts(std::size_t i) {
    Contacts contacts;
    for (const auto& manifold : found_.manifolds_of(i)) {
      contacts.normal = converted<double>(manifold.normal);
      for (const ContactPoint<float>& point : found_.points_of(manifold)) {
        ++contacts.count;
        contacts.deepest = std::min(contacts.deepest, static_cast<double>(point.distance));
      }
    }
    return contacts;
  }

  /// Hulls' own data apart; contacts with four points, as of two faces.
  std::size_t touched(Query query) const {
    const std::size_t both = a_.bytes() + b_.bytes();
    switch (query) {
    case Query::overlap: return both + sizeof(std::uint8_t);
    case Query::distance: return both + sizeof(Distance<float>);
    case Query::contacts:
      return both + sizeof(BatchContacts<float>::Pair) + sizeof(BatchContacts<float>::Group) +
             4 * sizeof(ContactPoint<float>);
    case Query::raycast:
    case Query::cast: break;
    }
    return 0;
  }

 private:
  Side a_, b_;
  std::vector<std::uint8_t> touch_;
  std::vector<Distance<float>> distances_;
  BatchContacts<float> found_;
};

const Registered<GrazeBatch> registered;

}  // namespace

}  // namespace graze::bench

#endif
