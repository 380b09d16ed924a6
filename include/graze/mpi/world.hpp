// A distributed world: each body lives on one rank, and contacts are found among all of them.
//
// Guarantee: the answers are those of one `World` with bodies of the same order, bit for bit: pairs, manifolds, points,
// features and events, whatever the number of ranks and wherever the borders run. Every touching pair is found by
// exactly one rank. Ranks send each other the bodies at their borders and nothing else: no rank holds the whole.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "graze/world/bodies.hpp"
#include "graze/world/events.hpp"
#include "graze/world/manifolds.hpp"

namespace graze::mpi {

/// The key of a body, unique among all bodies of all ranks for all time. In a pair the body with the smaller key is A.
using Key = std::uint64_t;

/// Settings of a world.
template <class T>
struct WorldSettings {
  std::optional<T> margin;                     ///< as in `graze::WorldSettings`; the same on all ranks
  std::function<bool(Key, Key)> allow;         ///< final decision on a pair; the same on all ranks
  std::optional<std::size_t> points_per_pair;  ///< as in `graze::WorldSettings`
  /// Ratio of the largest work of a rank to the mean above which the borders are drawn anew. Work counts bodies and
  /// candidate pairs, each pair by the cost of its kind.
  double imbalance = 1.1;
  /// Whether the cost of each kind of pair is measured, now and then. Without, all pairs count alike, and the same
  /// calls draw the same borders in every run; answers are the same bits either way.
  bool measured = true;
  /// Whether touching pairs are remembered, for `events`. Without, there are no events, and less memory is held.
  bool events = true;
  /// About the number of bodies that an update in blocks processes together, each taking a kilobyte or two meanwhile;
  /// and the number of bodies that leave a rank in one message.
  std::size_t bodies_per_block = 65536;
};

/// Two bodies within the margin of each other, by key.
struct KeyedPair {
  Key a, b;      ///< the two bodies
  bool overlap;  ///< true for overlap, false for a gap within the margin
  bool trigger;  ///< whether one of them is a trigger
  std::uint32_t first_manifold, manifold_count;
};

/// Contacts that an update in blocks found among bodies that lie close together.
template <class T>
struct ContactBlock {
  std::span<const KeyedPair> pairs;  ///< in the order of keys
  const ContactArrays<T>& contacts;  ///< manifolds and points of `pairs`
};

/// Receiver of blocks of contacts; a block is gone when it has returned.
template <class T>
using ContactVisitor = std::function<void(const ContactBlock<T>&)>;

/// An event of a pair, with the caller's keys.
struct KeyedEvent {
  Key a, b;        ///< the two bodies
  EventKind kind;  ///< begin, stay or end
  bool trigger;    ///< whether one of the two is a trigger

  friend bool operator==(const KeyedEvent&, const KeyedEvent&) = default;
};

/// Contacts and events of all ranks, sorted by key.
template <class T>
struct Gathered {
  std::vector<KeyedPair> pairs;               ///< the pairs that touch
  std::vector<ContactManifold<T>> manifolds;  ///< manifolds of a pair are contiguous
  std::vector<SolverPoint<T>> points;         ///< points of a manifold are contiguous
  std::vector<KeyedEvent> events;             ///< events of the last update
};

/// The work of an update on this rank.
struct WorldReport {
  std::uint64_t bodies = 0;      ///< bodies that live here
  std::uint64_t ghosts = 0;      ///< bodies lent by other ranks
  std::uint64_t pairs = 0;       ///< pairs within their margin that were found here
  std::uint64_t candidates = 0;  ///< pairs whose contacts were looked for here
  std::uint64_t bytes = 0;       ///< bytes sent to other ranks
  std::uint64_t migrated = 0;    ///< bodies that moved to another rank
  std::uint64_t partitions = 0;  ///< number of times borders were drawn, since the beginning
  double imbalance = 1;          ///< largest work over mean, at the update before this one
  double partition = 0, exchange = 0, broad = 0, contacts = 0, events = 0;  ///< seconds, by stage
  double work = 0;  ///< processor seconds of the rank's own part, without waiting for others
};

/// A world on all ranks of a communicator, which construct it and call `share`, `update` and `gather` together; bodies
/// are added by any rank, moved and removed by the one on which they live. Serial on each rank unless given an
/// executor.
template <class T>
class GRAZE_API World {
 public:
  /// Throws `CommonError` on every rank for settings that `graze::World` refuses on any, an imbalance below 1 or blocks
  /// of no bodies, and when ranks have libraries of other versions, another precision or other settings.
  explicit World(MPI_Comm comm, WorldSettings<T> settings = {}, Executor* executor = nullptr);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Registers a shape with large data or a user's code: a hull, a mesh, a height field, a compound, a shape with a
  /// support function of one's own. All ranks call it with the same shapes in the same order; bodies that move to
  /// another rank take the shape's number along instead of its data. The numbers count from 0. Throws `CommonError` on
  /// every rank when one has a shape of another kind or size.
  void share(const Shape<T>& shape);
  /// Registers a source of shapes that not every rank holds: `source` gives the shape of a number, the same on every
  /// rank, and is called once on each rank that needs it, for bodies that live there or are lent. Added bodies have
  /// shapes as `shared` gives them. Numbers begin after those of `share`.
  void share_from(std::function<Shape<T>(std::uint64_t)> source);
  /// The registered shape of a number. Throws `InvalidValue` for a number without one, and whatever the source throws.
  const Shape<T>& shared(std::uint64_t number);

  /// Adds a body. Throws `InvalidValue` for what `graze::World::add` refuses, for a shape that has to be shared and is
  /// not, and for a key that lives here already. The body may live elsewhere after the next update.
  void add(Key key, const Body<T>& body);
  /// Whether a body lives on this rank. The functions below throw `InvalidValue` for one that does not.
  bool contains(Key key) const;
  void remove(Key key);                            ///< as in `graze::World`, by the caller's key
  void move(Key key, const Pose<T>& pose);         ///< as in `graze::World`, by the caller's key
  void set_filter(Key key, const Filter& filter);  ///< as in `graze::World`, by the caller's key
  void set_shape(Key key, const Shape<T>& shape);  ///< as in `graze::World`, by the caller's key
  Body<T> body(Key key) const;                     ///< the body as it is now
  /// The bodies that live here, sorted.
  std::vector<Key> keys() const;

  /// Moves bodies to the ranks where they live, lends bodies at borders, and finds contacts. All ranks. Throws
  /// `CommonError` on every rank when one fails: out of memory, by a message that does not fit into it, by an exception
  /// of `allow` or of the source of shapes, by a key that two bodies have. The world can then only be destroyed.
  void update();
  /// An `update` that keeps no contacts: it hands them to `visit` block by block, each touching pair of this rank in
  /// one block, once, with the same bits; `pairs`, `contacts` and `gather` are empty then. Between two such updates a
  /// world holds its bodies and, unless the settings say otherwise, the touching pairs, and during one the needs of a
  /// block besides. Takes longer, since nothing is left from the update before. An exception of `visit` is an error on
  /// every rank too.
  void update(const ContactVisitor<T>& visit);

  /// Pairs that this rank found, in the order of keys; valid until the next update.
  std::span<const KeyedPair> pairs() const;
  const ContactArrays<T>& contacts() const;    ///< manifolds and points of `pairs`
  std::span<const KeyedEvent> events() const;  ///< events of the last update
  const WorldReport& report() const;           ///< statistics of the last update
  /// The part of space whose bodies live here; all of it before the first update.
  const Aabb<double>& region() const;
  /// Bytes that are held, without shared shapes' own data.
  std::size_t memory() const;

  /// All contacts and events, on one rank; empty on the others. All ranks. Throws as `update` does.
  Gathered<T> gather(int root = 0) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace graze::mpi
