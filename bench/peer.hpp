// A library in the comparison.
//
// To add one, write one file `peer_<name>.cpp` with a class as below and a `Registered` of it; `example/` has one to
// start from. Where it needs a package, name that in the list of bench/CMakeLists.txt and put the file between
// `#ifdef GRAZE_BENCH_<NAME>` and `#endif`.
//
//   class Mine {
//    public:
//     static constexpr const char* name = "mine";
//     static constexpr bool single_precision = false;   // it is compared with the Graze of the same precision
//     static std::string version();
//     bool prepare(std::span<const Pair> pairs);        // builds its shapes, untimed; false: it lacks one of them;
//                                                       // called once, for other pairs there is another object
//     // What it has of these. One that throws has no answer for the pair.
//     bool overlap(std::size_t i);
//     double distance(std::size_t i);                   // signed; NaN: no answer
//     Contacts contacts(std::size_t i);
//     double raycast(std::size_t i);                    // the part of `motion` at which the ray meets A; `never`
//     double cast(std::size_t i);                       // the part of `motion` at which A meets B; `never`
//     // All of these are optional.
//     bool has(Query) const;                            // what it answers for the pairs it was given
//     Contacts resting_contacts(std::size_t i);         // as it means a body at rest to be asked about
//     double run(Query, std::size_t count);             // answers pairs 0 to count - 1 at once, for the functions
//                                                       // above to tell; the sum of the answers, or anything like it
//     std::size_t touched(Query) const;                 // bytes that are read and written for a pair, by `sizeof`
//   };
//   const Registered<Mine> registered;
#pragma once

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "pairs.hpp"

namespace graze::bench {

enum class Query { overlap, distance, contacts, raycast, cast };
inline constexpr const char* query_names[] = {"overlap", "distance", "contacts", "raycast", "cast"};

/// When what does not meet does.
inline constexpr double never = std::numeric_limits<double>::infinity();

/// How many points of contact, the signed distance of the deepest, and the normal, either way round.
struct Contacts {
  std::size_t count = 0;
  double deepest = 0;
  Vec3d normal{};
};

/// What a library says of a pair.
struct Answer {
  bool failed = false;  ///< it threw, or said that it has none
  bool overlap = false;
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< signed; NaN where it does not tell
  std::size_t points = 0;
  Vec3d normal{};
  double time = never;  ///< of rays and casts: the part of the motion; `overlap` then tells that there is a hit
};

class Peer {
 public:
  virtual ~Peer() = default;
  virtual std::string name() const = 0;
  virtual std::string version() const = 0;
  virtual bool single_precision() const = 0;
  virtual bool prepare(std::span<const Pair> pairs) = 0;
  /// Frees what it has prepared.
  virtual void forget() = 0;
  virtual bool has(Query query) const = 0;
  virtual Answer answer(Query query, std::size_t i) = 0;
  /// Contacts of a body at rest.
  virtual Answer resting(std::size_t i) = 0;
  /// Asks about every pair in turn. The whole loop is behind one virtual call, so that none is in the time of a pair.
  /// The sum of the answers keeps the compiler from leaving any out. One that answers many pairs at once is run before
  /// it is asked for answers.
  virtual double run(Query query, std::size_t count) = 0;
  virtual bool answers_at_once() const = 0;
  /// Bytes read and written for a pair; 0 where it is not known.
  virtual std::size_t touched(Query query) const = 0;
};

/// The libraries there are.
std::vector<std::unique_ptr<Peer>>& peers();

template <class Library>
class PeerOf final : public Peer {
 public:
  std::string name() const override { return Library::name; }
  std::string version() const override { return Library::version(); }
  bool single_precision() const override { return Library::single_precision; }
  bool prepare(std::span<const Pair> pairs) override {
    library_.emplace();
    return library_->prepare(pairs);
  }
  void forget() override { library_.reset(); }

  bool has(Query query) const override {
    if constexpr (requires { library_->has(query); })
      if (!library_->has(query)) return false;
    switch (query) {
    case Query::overlap: return has_overlap;
    case Query::distance: return has_distance;
    case Query::contacts: return has_contacts;
    case Query::raycast: return has_raycast;
    case Query::cast: break;
    }
    return has_cast;
  }

  Answer answer(Query query, std::size_t i) override {
    Answer answer;
    try {
      if (query == Query::overlap) {
        if constexpr (has_overlap) answer.overlap = library_->overlap(i);
      } else if (query == Query::distance) {
        if constexpr (has_distance) answer.distance = library_->distance(i);
        answer.overlap = answer.distance <= 0;
        answer.failed = std::isnan(answer.distance);
      } else if (query == Query::contacts) {
        if constexpr (has_contacts) answer = answer_of(library_->contacts(i));
      } else {
        if constexpr (has_raycast)
          if (query == Query::raycast) answer.time = library_->raycast(i);
        if constexpr (has_cast)
          if (query == Query::cast) answer.time = library_->cast(i);
        answer.overlap = answer.time < never;
        answer.failed = std::isnan(answer.time);
      }
    } catch (const std::exception&) {
      answer = {};
      answer.failed = true;
    }
    return answer;
  }

  Answer resting(std::size_t i) override {
    if constexpr (requires { library_->resting_contacts(i); })
      return answer_of(library_->resting_contacts(i));
    else
      return answer(Query::contacts, i);
  }

  double run(Query query, std::size_t count) override {
    if constexpr (at_once) return library_->run(query, count);
    double sum = 0;
    if (query == Query::overlap) {
      if constexpr (has_overlap) sum = each(count, [&](std::size_t i) { return library_->overlap(i) ? 1.0 : 0.0; });
    } else if (query == Query::distance) {
      if constexpr (has_distance) sum = each(count, [&](std::size_t i) { return library_->distance(i); });
    } else if (query == Query::contacts) {
      if constexpr (has_contacts) sum = each(count, [&](std::size_t i) { return library_->contacts(i).deepest; });
    } else if (query == Query::raycast) {
      if constexpr (has_raycast) sum = each(count, [&](std::size_t i) { return library_->raycast(i); });
    } else {
      if constexpr (has_cast) sum = each(count, [&](std::size_t i) { return library_->cast(i); });
    }
    return sum;
  }
  bool answers_at_once() const override { return at_once; }

  std::size_t touched(Query query) const override {
    if constexpr (requires { library_->touched(query); }) return library_->touched(query);
    return 0;
  }

 private:
  static constexpr bool has_overlap = requires(Library l) { l.overlap(std::size_t{}); };
  static constexpr bool has_distance = requires(Library l) { l.distance(std::size_t{}); };
  static constexpr bool has_contacts = requires(Library l) { l.contacts(std::size_t{}); };
  static constexpr bool has_raycast = requires(Library l) { l.raycast(std::size_t{}); };
  static constexpr bool has_cast = requires(Library l) { l.cast(std::size_t{}); };
  static constexpr bool at_once = requires(Library l) { l.run(Query{}, std::size_t{}); };

  static Answer answer_of(const Contacts& found) {
    Answer answer;
    answer.points = found.count;
    answer.normal = found.normal;
    answer.overlap = found.count > 0;
    if (answer.overlap) answer.distance = found.deepest;
    return answer;
  }

  template <class Ask>
  static double each(std::size_t count, Ask ask) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      try {
        sum += ask(i);
      } catch (const std::exception&) {
        sum += 1;  // part of the library's time: its user has to catch it too
      }
    }
    return sum;
  }

  std::optional<Library> library_;
};

/// Adds a library when the program starts.
template <class Library>
struct Registered {
  Registered() { peers().push_back(std::make_unique<PeerOf<Library>>()); }
};

/// What a library makes of a body's corners, made once for all bodies that share them.
template <class Made>
class OncePerCorners {
 public:
  template <class Make>
  Made of(const Body& body, const Make& make) {
    if (!body.corners) return make(body);
    const auto [at, is_new] = made_.try_emplace(body.corners.get());
    if (is_new) at->second = make(body);
    return at->second;
  }

 private:
  std::unordered_map<const Corners*, Made> made_;
};

/// `body`'s rotation for a library whose capsules, cylinders and cones stand along Z: those are turned there from Y.
inline Quatd rotation_from_z(const Body& body) {
  const bool upright = body.kind == Kind::capsule || body.kind == Kind::cylinder || body.kind == Kind::cone;
  const double h = std::sqrt(0.5);
  return upright ? body.pose.rotation * Quatd{-h, 0, 0, h} : body.pose.rotation;
}

}  // namespace graze::bench
