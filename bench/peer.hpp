// A library in the comparison.
//
// To add one, write one file `peer_<name>.cpp` with a class as below and a `Registered` of it. Where it needs a package,
// name that in the list of bench/CMakeLists.txt and put the file between `#ifdef GRAZE_BENCH_<NAME>` and `#endif`.
//
//   class Mine {
//    public:
//     static constexpr const char* name = "mine";
//     static constexpr bool single_precision = false;   // it is compared with the Graze of the same precision
//     static std::string version();
//     bool prepare(std::span<const Pair> pairs);        // builds its shapes, untimed; false: it lacks one of them
//     // What it has of these. One that throws has no answer for the pair.
//     bool overlap(std::size_t i);
//     double distance(std::size_t i);                   // signed; NaN: no answer
//     Contacts contacts(std::size_t i);
//     bool has(Query) const;                            // optional: what it answers for the pairs it was given
//     Contacts resting_contacts(std::size_t i);         // optional: as it means a body at rest to be asked about
//   };
//   const Registered<Mine> registered;
#pragma once

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pairs.hpp"

namespace graze::bench {

enum class Query { overlap, distance, contacts };
inline constexpr Query queries[] = {Query::overlap, Query::distance, Query::contacts};
inline constexpr const char* query_names[] = {"overlap", "distance", "contacts"};

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
};

class Peer {
 public:
  virtual ~Peer() = default;
  virtual std::string name() const = 0;
  virtual std::string version() const = 0;
  virtual bool single_precision() const = 0;
  virtual bool prepare(std::span<const Pair> pairs) = 0;
  virtual bool has(Query query) const = 0;
  virtual Answer answer(Query query, std::size_t i) = 0;
  /// Contacts of a body at rest.
  virtual Answer resting(std::size_t i) = 0;
  /// Asks about every pair in turn. The whole loop is behind one virtual call, so that none is in the time of a pair.
  /// The sum of the answers keeps the compiler from leaving any out.
  virtual double run(Query query, std::size_t count) = 0;
};

/// The libraries there are.
std::vector<std::unique_ptr<Peer>>& peers();

template <class Library>
class PeerOf final : public Peer {
 public:
  std::string name() const override { return Library::name; }
  std::string version() const override { return Library::version(); }
  bool single_precision() const override { return Library::single_precision; }
  bool prepare(std::span<const Pair> pairs) override { return library_.prepare(pairs); }

  bool has(Query query) const override {
    if constexpr (requires { library_.has(query); })
      if (!library_.has(query)) return false;
    return query == Query::overlap ? has_overlap : query == Query::distance ? has_distance : has_contacts;
  }

  Answer answer(Query query, std::size_t i) override {
    Answer answer;
    try {
      if (query == Query::overlap) {
        if constexpr (has_overlap) answer.overlap = library_.overlap(i);
      } else if (query == Query::distance) {
        if constexpr (has_distance) answer.distance = library_.distance(i);
        answer.overlap = answer.distance <= 0;
        answer.failed = std::isnan(answer.distance);
      } else if constexpr (has_contacts) {
        answer = answer_of(library_.contacts(i));
      }
    } catch (const std::exception&) {
      answer = {};
      answer.failed = true;
    }
    return answer;
  }

  Answer resting(std::size_t i) override {
    if constexpr (requires { library_.resting_contacts(i); })
      return answer_of(library_.resting_contacts(i));
    else
      return answer(Query::contacts, i);
  }

  double run(Query query, std::size_t count) override {
    double sum = 0;
    if (query == Query::overlap) {
      if constexpr (has_overlap) sum = each(count, [&](std::size_t i) { return library_.overlap(i) ? 1.0 : 0.0; });
    } else if (query == Query::distance) {
      if constexpr (has_distance) sum = each(count, [&](std::size_t i) { return library_.distance(i); });
    } else if constexpr (has_contacts) {
      sum = each(count, [&](std::size_t i) { return library_.contacts(i).deepest; });
    }
    return sum;
  }

 private:
  static constexpr bool has_overlap = requires(Library l) { l.overlap(std::size_t{}); };
  static constexpr bool has_distance = requires(Library l) { l.distance(std::size_t{}); };
  static constexpr bool has_contacts = requires(Library l) { l.contacts(std::size_t{}); };

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

  Library library_;
};

/// Adds a library when the program starts.
template <class Library>
struct Registered {
  Registered() { peers().push_back(std::make_unique<PeerOf<Library>>()); }
};

/// `body`'s rotation for a library whose capsules, cylinders and cones stand along Z: those are turned there from Y.
inline Quatd rotation_from_z(const Body& body) {
  const bool upright = body.kind == Kind::capsule || body.kind == Kind::cylinder || body.kind == Kind::cone;
  const double h = std::sqrt(0.5);
  return upright ? body.pose.rotation * Quatd{-h, 0, 0, h} : body.pose.rotation;
}

}  // namespace graze::bench
