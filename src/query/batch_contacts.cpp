#include <algorithm>

#include "graze/batch.hpp"
#include "query/batch_parts.hpp"
#include "query/contact_writing.hpp"

namespace graze {

namespace {

/// Writes contacts one behind the other. The arrays are kept longer than that until the end, so that a record can be
/// written before it is known whether it counts: for pairs of which a random half touches, a branch would often be
/// mispredicted, which costs more than the writing.
template <class T>
class Writer {
 public:
  explicit Writer(BatchContacts<T>& found, std::size_t pairs) : found_(found) { found_.pairs.resize(pairs); }
  ~Writer() {
    found_.manifolds.resize(manifolds_);
    found_.points.resize(points_);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Makes room for this many more records; pointers to records may become invalid.
  void reserve(std::size_t manifolds, std::size_t points) {
    make_room(found_.manifolds, manifolds_ + manifolds);
    make_room(found_.points, points_ + points);
  }
  /// Writes pairs and, for each that touches in one point, the point; returns how many are on their sides or unknown,
  /// which count as apart.
  template <class Place>
  std::size_t write(const Place& place, const PointContact<T>* contacts, const Meeting* meetings, std::size_t count) {
    reserve(count, count);
    typename BatchContacts<T>::Pair* const pairs = found_.pairs.data();
    typename BatchContacts<T>::Group* const manifolds = found_.manifolds.data() + manifolds_;
    ContactPoint<T>* const points = found_.points.data() + points_;
    const auto first_manifold = static_cast<std::uint32_t>(manifolds_),
               first_point = static_cast<std::uint32_t>(points_);
    std::uint32_t touching = 0;
    std::size_t others = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const PointContact<T>& contact = contacts[k];
      const bool touches = meetings[k] == Meeting::touching, overlap = contact.point.distance <= T(0);
      others += is_elsewhere(meetings[k]);
      pairs[place(k)] = {static_cast<bool>(touches & overlap), first_manifold + touching, touches};
      manifolds[touching] = {contact.normal, 0, 0, first_point + touching, 1};
      points[touching] = contact.point;
      touching += touches;
    }
    manifolds_ += touching;
    points_ += touching;
    return others;
  }
  /// Writes pairs in rows from the `first`-th on: `ask(rows)` lets a kernel write their contacts, with at most one
  /// point each, and returns the numbers of these.
  template <class Ask>
  RowCounts write_rows(std::size_t first, OtherRows<T>& others, const Ask& ask) {
    ContactRows<T> to{found_.pairs.data() + first,
                      found_.manifolds.data() + manifolds_,
                      found_.points.data() + points_,
                      others.unknown,
                      others.side_places,
                      others.sides.records,
                      static_cast<std::uint32_t>(manifolds_),
                      static_cast<std::uint32_t>(points_)};
    if (manifolds_ + row_chunk <= found_.manifolds.size() && points_ + row_chunk <= found_.points.size()) {
      const RowCounts found = ask(to);
      manifolds_ += found.touching;
      points_ += found.touching;
      return found;
    }
    // Written aside, because a vector grows only by initialising all new elements.
    to.manifolds = manifolds_aside_.records;
    to.points = points_aside_.records;
    const RowCounts found = ask(to);
    append(found_.manifolds, manifolds_, to.manifolds, found.touching);
    append(found_.points, points_, to.points, found.touching);
    return found;
  }
  /// Storage of a kernel's block: in place, if there is room.
  void offer(PointBlock<T>& block) {
    constexpr std::size_t points = PointBlock<T>::room;
    const bool in_place =
        manifolds_ + block_pairs <= found_.manifolds.size() && points_ + points <= found_.points.size();
    block.manifolds = in_place ? found_.manifolds.data() + manifolds_ : manifolds_aside_.records;
    block.points = in_place ? found_.points.data() + points_ : points_aside_.records;
    block.first_point = static_cast<std::uint32_t>(points_);
  }
  /// Moves a block aside if some of its pairs are unknown, since the contacts of these will come in between.
  void settle(PointBlock<T>& block, std::size_t count) {
    if (block.manifold_count == count || block.points == points_aside_.records) return;
    block.manifolds =
        std::copy_n(block.manifolds, block.manifold_count, manifolds_aside_.records) - block.manifold_count;
    block.points = std::copy_n(block.points, block.point_count, points_aside_.records) - block.point_count;
  }
  /// Writes pairs that meet, the `k`-th of them number `place(k)`, with their points.
  template <class Place>
  void write(const MetPairs<T>& met, bool turned, const Place& place) {
    if (met.points != found_.points.data() + points_) append(met, turned);
    const auto first_manifold = static_cast<std::uint32_t>(manifolds_);
    for (std::size_t k = 0; k < met.count; ++k)
      found_.pairs[place(k)] = {met.distance(k) <= T(0), first_manifold + static_cast<std::uint32_t>(k), 1};
    manifolds_ += met.count;
    points_ += met.point_count;
    fetch_for_writing(found_.manifolds.data() + manifolds_, met.count);
  }
  /// Writes a pair that does not touch, unless manifolds follow.
  void begin(std::size_t pair, bool overlap) {
    found_.pairs[pair] = {overlap, static_cast<std::uint32_t>(manifolds_), 0};
  }
  /// Writes a pair of convex shapes that touch; `points` appends its own.
  template <class Points>
  void touching(std::size_t pair, T distance, const Vec3<T>& normal, std::size_t most, const Points& points) {
    begin(pair, distance <= T(0));
    add(pair, normal, 0, 0, most, [&](auto& tail) { return points.append(tail); });
  }
  /// Writes one more manifold of the pair begun last; `append(points)` appends at most `most` points, and returns their
  /// number.
  template <class Append>
  void add(std::size_t pair, const Vec3<T>& normal, std::uint32_t piece_a, std::uint32_t piece_b, std::size_t most,
           const Append& append) {
    reserve(1, most);
    Tail tail{found_.points, points_};
    const auto first = static_cast<std::uint32_t>(points_);
    found_.manifolds[manifolds_++] = {normal, piece_a, piece_b, first, static_cast<std::uint32_t>(append(tail))};
    points_ = tail.end;
    ++found_.pairs[pair].manifold_count;
  }

 private:
  /// The points as a vector that ends at the last one that counts.
  struct Tail {
    std::vector<ContactPoint<T>>& points;
    std::size_t end;
    std::size_t size() const { return end; }
    ContactPoint<T>& operator[](std::size_t i) { return points[i]; }
    ContactPoint<T>& emplace_back() { return points[end++]; }
    void push_back(const ContactPoint<T>& p) { emplace_back() = p; }
  };

  /// Appends contacts that were written aside.
  void append(const MetPairs<T>& met, bool turned) {
    reserve(met.count, met.point_count);
    ContactPoint<T>* const points = found_.points.data() + points_;
    if (turned)
      std::transform(met.points, met.points + met.point_count, points,
                     [](const ContactPoint<T>& p) { return mirrored(p); });
    else
      std::copy_n(met.points, met.point_count, points);
    fetch_for_writing(points + met.point_count, met.point_count);
    const std::uint32_t before = static_cast<std::uint32_t>(points_) - met.manifolds->first_point;
    typename BatchContacts<T>::Group* to = found_.manifolds.data() + manifolds_;
    for (std::size_t k = 0; k < met.count; ++k, ++to) {
      *to = met.manifolds[k];
      to->first_point += before;
      if (turned) to->normal = -to->normal;
    }
  }
  template <class Record>
  static void append(std::vector<Record>& array, std::size_t& used, const Record* records, std::size_t count) {
    const std::size_t over = std::min(count, array.size() - used);
    std::copy_n(records, over, array.begin() + static_cast<std::ptrdiff_t>(used));
    array.insert(array.end(), records + over, records + count);
    used += count;
  }

  BatchContacts<T>& found_;
  std::size_t manifolds_ = 0, points_ = 0;
  RoomFor<typename BatchContacts<T>::Group, row_chunk> manifolds_aside_;
  RoomFor<ContactPoint<T>, std::max(row_chunk, PointBlock<T>::room)> points_aside_;
};

}  // namespace

template <class T>
void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found, Executor* executor) {
  const auto find = [margin](const Batch<T>& some, BatchContacts<T>& of_some) {
    Writer<T> writer(of_some, some.size());
    write_contacts(some, margin, writer);
  };
  if (executor == nullptr) return find(batch, found);
  found.pairs.clear(), found.manifolds.clear(), found.points.clear();
  found.pairs.reserve(batch.size());
  find_in_parts<BatchContacts<T>>(*executor, batch, find,
                                  [&](const BatchContacts<T>& some, std::size_t) { found.append(some); });
}

template void contacts(const Batch<float>&, float, BatchContacts<float>&, Executor*);
template void contacts(const Batch<double>&, double, BatchContacts<double>&, Executor*);

}  // namespace graze
