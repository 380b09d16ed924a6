// A world on many machines: bodies that live on one rank each, and what touches among all of them.
//
// Guarantee: the answers are those of one `World` with bodies of the same order, bit for bit: pairs, manifolds, points,
// features and events, whatever the number of ranks and wherever the borders run. Every touching pair is found by
// exactly one rank. Ranks send each other what stands at their borders and nothing else: no rank holds the whole.
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

/// The name of a body among all ranks: no two bodies have the same one, ever. Of a pair the body with the smaller key
/// is A.
using Key = std::uint64_t;

/// Settings of a world.
template <class T>
struct WorldSettings {
  std::optional<T> margin;                     ///< as of `graze::WorldSettings`; the same on all ranks
  std::function<bool(Key, Key)> allow;         ///< a last word on a pair: the same on all ranks
  std::optional<std::size_t> points_per_pair;  ///< as of `graze::WorldSettings`
  /// The largest work of a rank over the mean from which on the borders are drawn anew. Work is bodies and the pairs
  /// whose contacts are looked for, each pair by the cost of its kind.
  double imbalance = 1.1;
  /// Whether it is measured, now and then, what a pair of each kind costs. Without, all pairs count alike, and the same
  /// calls draw the same borders in every run; answers are the same bits either way.
  bool measured = true;
  /// Whether it is remembered who touches, for `events`. Without, there are none, and less is held.
  bool events = true;
  /// About how many bodies an update in blocks looks at together, each with a kilobyte or two meanwhile; and how many
  /// leave a rank in one message.
  std::size_t bodies_per_block = 65536;
};

/// Two bodies within the margin of each other, by key.
struct KeyedPair {
  Key a, b;      ///< the two bodies
  bool overlap;  ///< whether they overlap, and are not only near
  bool trigger;  ///< whether one of them is a trigger
  std::uint32_t first_manifold, manifold_count;
};

/// Contacts that an update in blocks found of bodies that stand close together.
template <class T>
struct ContactBlock {
  std::span<const KeyedPair> pairs;  ///< in the order of keys
  const ContactArrays<T>& contacts;  ///< manifolds and points of `pairs`
};

/// Takes blocks of contacts; none is there any more when it has returned.
template <class T>
using ContactVisitor = std::function<void(const ContactBlock<T>&)>;

/// An event of a pair, with the caller's keys.
struct KeyedEvent {
  Key a, b;        ///< the two bodies
  EventKind kind;  ///< what became of the pair
  bool trigger;    ///< whether it only tells of overlaps

  friend bool operator==(const KeyedEvent&, const KeyedEvent&) = default;
};

/// Contacts and events of all ranks, sorted by key.
template <class T>
struct Gathered {
  std::vector<KeyedPair> pairs;               ///< the pairs that touch
  std::vector<ContactManifold<T>> manifolds;  ///< those of a pair one behind the other
  std::vector<SolverPoint<T>> points;         ///< of all manifolds, one behind the other
  std::vector<KeyedEvent> events;             ///< what began and ended
};

/// The work of an update on this rank.
struct WorldReport {
  std::uint64_t bodies = 0;      ///< that live here
  std::uint64_t ghosts = 0;      ///< lent by others
  std::uint64_t pairs = 0;       ///< that are within their margin and were found here
  std::uint64_t candidates = 0;  ///< whose contacts were looked for here
  std::uint64_t bytes = 0;       ///< sent to other ranks
  std::uint64_t migrated = 0;    ///< bodies that went to live elsewhere
  std::uint64_t partitions = 0;  ///< how often borders were drawn, since the beginning
  double imbalance = 1;          ///< largest work over mean, as the update before this one found it
  double partition = 0, exchange = 0, broad = 0, contacts = 0, events = 0;  ///< seconds, by stage
  double work = 0;  ///< seconds of processors that the rank's own part took, without waiting for others
};

/// All ranks of the communicator make one together and call `share`, `update` and `gather` together; bodies are added
/// by any rank, moved and removed by the one on which they live. Serial on each rank unless given an executor.
template <class T>
class GRAZE_API World {
 public:
  /// Throws `CommonError` on every rank for what `graze::World` refuses, an imbalance below 1 or blocks of no bodies on
  /// any, and when ranks have libraries of other versions, another precision or other settings.
  explicit World(MPI_Comm comm, WorldSettings<T> settings = {}, Executor* executor = nullptr);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Makes a shape known whose data is large or is a user's code: a hull, a mesh, a height field, a compound, a shape
  /// with a support function of one's own. All ranks call it with the same shapes in the same order, and bodies that go
  /// elsewhere take its number along and not its data. The numbers count from 0. Throws `CommonError` on every rank
  /// when one has a shape of another kind or size.
  void share(const Shape<T>& shape);
  /// Says where shapes come from that not every rank holds: `source` gives the shape of a number, the same on every
  /// rank, and is called once on each where it is needed, which is for bodies that live there or are lent. Bodies that
  /// are added have shapes as `shared` gives them. Numbers begin after those of `share`.
  void share_from(std::function<Shape<T>(std::uint64_t)> source);
  /// The shape of a number. Throws `InvalidValue` where it is nobody's, and what the source throws.
  const Shape<T>& shared(std::uint64_t number);

  /// Throws `InvalidValue` for what `graze::World::add` refuses, for a shape that would have to be shared and is not,
  /// and for a key that lives here already. The body may live elsewhere after the next update.
  void add(Key key, const Body<T>& body);
  /// Whether a body lives on this rank. These throw `InvalidValue` for one that does not.
  bool contains(Key key) const;
  void remove(Key key);                            ///< as of `graze::World`, by the caller's key
  void move(Key key, const Pose<T>& pose);         ///< as of `graze::World`, by the caller's key
  void set_filter(Key key, const Filter& filter);  ///< as of `graze::World`, by the caller's key
  void set_shape(Key key, const Shape<T>& shape);  ///< as of `graze::World`, by the caller's key
  Body<T> body(Key key) const;                     ///< as of `graze::World`, by the caller's key
  /// The bodies that live here, sorted.
  std::vector<Key> keys() const;

  /// Brings bodies to where they live, lends what stands at borders, and finds what touches. All ranks. Throws
  /// `CommonError` on every rank when one fails: out of memory, by a message that does not fit into it, by what `allow`
  /// or the source of shapes threw, by a key that two bodies have. The world is then good for nothing but its end.
  void update();
  /// An `update` that keeps no contacts: it hands them over block by block, each touching pair of this rank in one
  /// block, once, with the same bits; `pairs`, `contacts` and `gather` have none then. Between two such updates a world
  /// holds its bodies and, unless the settings say otherwise, who touches whom, and during one what a block needs
  /// besides. Takes longer, since nothing is left from the update before. What `visit` throws is an error on every rank
  /// too.
  void update(const ContactVisitor<T>& visit);

  /// Pairs that this rank found, in the order of keys; valid until the next update.
  std::span<const KeyedPair> pairs() const;
  const ContactArrays<T>& contacts() const;    ///< manifolds and points of `pairs`
  std::span<const KeyedEvent> events() const;  ///< those of the last update
  const WorldReport& report() const;           ///< what the last update did
  /// The part of space whose bodies live here; all of it before the first update.
  const Aabb<double>& region() const;
  /// Bytes that are held, shared shapes' own data apart.
  std::size_t memory() const;

  /// All that was found, on one rank; empty on the others. All ranks. Throws as `update`.
  Gathered<T> gather(int root = 0) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace graze::mpi
