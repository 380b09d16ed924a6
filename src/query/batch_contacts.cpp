#include <algorithm>

#include "graze/batch.hpp"
#include "narrow/batch/half_space_batch.hpp"
#include "narrow/batch/sphere_capsule_batch.hpp"
#include "narrow/batch/triangle_batch.hpp"
#include "query/batch_rows.hpp"

namespace graze {

namespace {

/// The pairs in rows that are not answered for in their order.
template <class T>
struct OtherRows {
  std::uint8_t unknown[row_chunk], side_places[row_chunk];
  RoomFor<SegmentContact<T>, row_chunk> sides;
};

/// Writes what is found behind each other. The arrays are kept longer than that until all is done, so that a record can
/// be written before it is known whether it counts: of pairs half of which touch, at random, a jump would often be
/// guessed wrong, which costs more than the writing.
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

  /// Makes room for so many more; what is pointed to may move.
  void reserve(std::size_t manifolds, std::size_t points) {
    make_room(found_.manifolds, manifolds_ + manifolds);
    make_room(found_.points, points_ + points);
  }
  /// Pairs and, of each that touches in one, the point; how many lie or are unknown, which count as apart.
  std::size_t write(const std::size_t* places, const PointContact<T>* contacts, const Meeting* meetings,
                    std::size_t count) {
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
      others += meetings[k] >= Meeting::unknown;
      pairs[places[k]] = {static_cast<bool>(touches & overlap), first_manifold + touching, touches};
      manifolds[touching] = {contact.normal, 0, 0, first_point + touching, 1};
      points[touching] = contact.point;
      touching += touches;
    }
    manifolds_ += touching;
    points_ += touching;
    return others;
  }
  /// Pairs in rows from the `first`-th on: `ask(rows)` has a kernel write what it finds of them, with at most one point
  /// each, and tells how much that is.
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
    // Aside, as a vector is not made longer without all that is new being written for it.
    to.manifolds = manifolds_aside_.records;
    to.points = points_aside_.records;
    const RowCounts found = ask(to);
    append(found_.manifolds, manifolds_, to.manifolds, found.touching);
    append(found_.points, points_, to.points, found.touching);
    return found;
  }
  /// Where a kernel writes a block to: to where it stays, if there is room.
  void offer(PointBlock<T>& block) {
    constexpr std::size_t points = PointBlock<T>::room;
    const bool in_place =
        manifolds_ + block_pairs <= found_.manifolds.size() && points_ + points <= found_.points.size();
    block.manifolds = in_place ? found_.manifolds.data() + manifolds_ : manifolds_aside_.records;
    block.points = in_place ? found_.points.data() + points_ : points_aside_.records;
    block.first_point = static_cast<std::uint32_t>(points_);
  }
  /// What is found of pairs that the kernel does not know will stand among the others: these step aside.
  void settle(PointBlock<T>& block, std::size_t count) {
    if (block.manifold_count == count || block.points == points_aside_.records) return;
    block.manifolds =
        std::copy_n(block.manifolds, block.manifold_count, manifolds_aside_.records) - block.manifold_count;
    block.points = std::copy_n(block.points, block.point_count, points_aside_.records) - block.point_count;
  }
  /// Pairs that meet, the `k`-th of them number `place(k)`, with their points.
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
  /// A pair that does not touch, until manifolds follow.
  void begin(std::size_t pair, bool overlap) {
    found_.pairs[pair] = {overlap, static_cast<std::uint32_t>(manifolds_), 0};
  }
  /// A pair of convex shapes that touch; `points` appends its own.
  template <class Points>
  void touching(std::size_t pair, T distance, const Vec3<T>& normal, std::size_t most, const Points& points) {
    begin(pair, distance <= T(0));
    add(pair, normal, 0, 0, most, [&](auto& tail) { return points.append(tail); });
  }
  /// One more manifold of the pair that was begun last; `append(points)` writes at most `most` points behind those that
  /// are there, and returns how many.
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
  /// The points as a vector that ends where those end that count.
  struct Tail {
    std::vector<ContactPoint<T>>& points;
    std::size_t end;
    std::size_t size() const { return end; }
    ContactPoint<T>& operator[](std::size_t i) { return points[i]; }
    ContactPoint<T>& emplace_back() { return points[end++]; }
    void push_back(const ContactPoint<T>& p) { emplace_back() = p; }
  };

  /// Those that stand elsewhere.
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
  template <class Array>
  static void make_room(Array& array, std::size_t size) {
    if (array.size() >= size) return;
    // Memory for twice as many, but made as records only when they are near to be written: they are in the cache then.
    if (array.capacity() < size) array.reserve(std::max(size, 2 * array.capacity()));
    array.resize(size);
  }

  BatchContacts<T>& found_;
  std::size_t manifolds_ = 0, points_ = 0;
  RoomFor<typename BatchContacts<T>::Group, row_chunk> manifolds_aside_;
  RoomFor<ContactPoint<T>, std::max(row_chunk, PointBlock<T>::room)> points_aside_;
};

/// Asks about one pair after the other.
template <class T>
class OneByOne {
 public:
  OneByOne(const Batch<T>& batch, T margin, Writer<T>& writer) : batch_(batch), margin_(margin), writer_(writer) {}

  void operator()(std::size_t i) {
    const IdPair p = batch_[i];
    manifolds_.clear();
    const bool overlap = batch_.a().visit(p.a, [&](const Shape<T>& a) {
      return batch_.b().visit(p.b, [&](const Shape<T>& b) {
        return contacts(a, batch_.a().pose(p.a), b, batch_.b().pose(p.b), margin_, manifolds_);
      });
    });
    writer_.begin(i, overlap);
    for (const Manifold<T>& m : manifolds_)
      writer_.add(i, m.normal, m.piece_a, m.piece_b, m.points.size(), [&](auto& points) {
        for (const ContactPoint<T>& point : m.points) points.push_back(point);
        return m.points.size();
      });
  }

 private:
  const Batch<T>& batch_;
  T margin_;
  Writer<T>& writer_;
  Manifolds<T> manifolds_;
};

/// Writes the pairs of a capsule that lies.
template <class T>
auto side_writer(Writer<T>& writer) {
  return [&writer](std::size_t pair, T distance, const Vec3<T>& normal, const SegmentPoints<T>& points) {
    writer.touching(pair, distance, normal, 2, points);
  };
}

/// Asks the kernels about pairs put together for them.
template <class T>
class Together {
 public:
  Together(Writer<T>& writer, OneByOne<T>& single) : writer_(writer), single_(single) {}

  void operator()(Route route, bool turned, const Queue<T>& queue) {
    if (route == Route::box_box)
      boxes(queue);
    else if (is_rest(route))
      with_resting_kind<T>(route, [&]<class A>() { half_space_slots<A>(turned, queue); });
    else if (route == Route::box_triangle)
      triangles(turned, queue);
    else if (route == Route::triangle_triangle)
      triangle_pairs(queue);
    else
      round(route, turned, queue);
  }

 private:
  void boxes(const Queue<T>& queue) {
    visit_box_contacts(
        queue.pairs.data(), queue.count, [&](std::size_t k) { writer_.begin(queue.places[k], false); },
        [&](const MetPairs<T>& met) { write(met, false, queue); }, [&](std::size_t k) { single_(queue.places[k]); },
        writer_);
  }
  template <class A>
  void half_space_slots(bool turned, const Queue<T>& queue) {
    visit_half_space_contacts<A>(
        queue.pairs.data(), queue.count, turned, [&](std::size_t k) { writer_.begin(queue.places[k], false); },
        [&](std::size_t k, T distance, const HalfSpacePoints<T>& points) {
          touching(queue.places[k], distance, points.normal(), points);
        });
  }
  void triangles(bool turned, const Queue<T>& queue) {
    visit_triangle_contacts(
        queue.pairs.data(), queue.count, [&](std::size_t k) { writer_.begin(queue.places[k], false); },
        [&](const MetPairs<T>& met) { write(met, turned, queue); }, [&](std::size_t k) { single_(queue.places[k]); });
  }
  void triangle_pairs(const Queue<T>& queue) {
    visit_triangle_pair_contacts(
        queue.pairs.data(), queue.count, [&](std::size_t k) { writer_.begin(queue.places[k], false); },
        [&](const MetPairs<T>& met) { write(met, false, queue); }, [&](std::size_t k) { single_(queue.places[k]); });
  }
  void write(const MetPairs<T>& met, bool turned, const Queue<T>& queue) {
    writer_.write(met, turned, [&](std::size_t k) { return queue.places[met.place(k)]; });
  }
  template <class Points>
  void touching(std::size_t pair, T distance, const Vec3<T>& normal, const Points& points) {
    writer_.touching(pair, distance, normal, most_contact_slots, points);
  }
  void round(Route route, bool turned, const Queue<T>& queue) {
    with_sphere_capsule_kinds<T>(route, [&]<class A, class B>() {
      ask_sphere_capsule_kernel<A, B>(queue.pairs.data(), queue.count, contacts_, meetings_, sides_.records);
      if (turned)
        for (std::size_t k = 0; k < queue.count; ++k) contacts_[k] = mirrored(contacts_[k]);
      std::size_t others = writer_.write(queue.places.data(), contacts_, meetings_, queue.count);
      const SegmentContact<T>* side = sides_.records;
      for (std::size_t k = 0; others > 0; ++k) {
        if (meetings_[k] < Meeting::unknown) continue;
        --others;
        if (meetings_[k] == Meeting::unknown)
          single_(queue.places[k]);
        else
          visit_side<A, B>(*side++, turned, queue.places[k], side_writer(writer_), single_);
      }
    });
  }

  Writer<T>& writer_;
  OneByOne<T>& single_;
  PointContact<T> contacts_[bundled(batch_chunk)];
  Meeting meetings_[bundled(batch_chunk)];
  RoomFor<SegmentContact<T>, batch_chunk> sides_;
};

/// Whether there is a kernel for the contacts of pairs in rows.
constexpr bool has_rows(Route route) { return route < Route::box_box && route != Route::capsule_box; }

template <class A, class B, class T>
auto row_kernel() {
  if constexpr (is_sphere_capsule_pair<A, B>)
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_row_contacts<A, B, T>);
  else
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_contacts<A, T>);
}

template <class T>
void contacts_of_rows(const Batch<T>& batch, std::uint8_t queue, T margin, Writer<T>& writer, OneByOne<T>& single) {
  with_sphere_capsule_kinds<T>(route_of(queue), [&]<class A, class B>() {
    if constexpr (is_sphere_capsule_pair<A, B> || is_sphere_capsule_and_triangle<A, B>) {
      const auto kernel = row_kernel<A, B, T>();
      const bool turned = is_turned(queue);
      visit_rows<A, B>(batch, turned, [&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
        OtherRows<T> others;
        const RowCounts found = writer.write_rows(first, others, [&](const ContactRows<T>& to) {
          RowCounts all{};
          kernel(rows, count, margin, turned, to, all);
          return all;
        });
        for (std::size_t k = 0; k < found.sides; ++k)
          visit_side<A, B>(others.sides.records[k], turned, first + others.side_places[k], side_writer(writer), single);
        for (std::size_t k = 0; k < found.unknown; ++k) single(first + others.unknown[k]);
      });
    }
  });
}

template <class T>
void contacts_of_box_rows(const Batch<T>& batch, T margin, Writer<T>& writer, OneByOne<T>& single) {
  const auto apart = [&](std::size_t i) { writer.begin(i, false); };
  const auto met = [&](const MetPairs<T>& some) {
    writer.write(some, false, [&](std::size_t k) { return some.place(k); });
  };
  const auto unknown = [&](std::size_t i) { single(i); };
  MetBoxes<T> boxes;
  visit_rows<Box<T>, Box<T>>(batch, false, [&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
    visit_box_contacts(rows, count, margin, static_cast<std::uint32_t>(first), boxes, apart, met, unknown, writer);
  });
  visit_met_boxes(boxes, true, writer, met, unknown);
}

}  // namespace

template <class T>
void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found) {
  Writer<T> writer(found, batch.size());
  OneByOne<T> single(batch, margin, writer);
  const std::uint8_t queue = even_queue(batch);
  if (has_rows(route_of(queue))) return contacts_of_rows(batch, queue, margin, writer, single);
  if (route_of(queue) == Route::box_box) return contacts_of_box_rows(batch, margin, writer, single);
  Together<T> together(writer, single);
  visit_batch(
      batch, margin, [](Route) { return true; }, [](Route route) { return route == Route::box_box; }, together, single);
}

template void contacts(const Batch<float>&, float, BatchContacts<float>&);
template void contacts(const Batch<double>&, double, BatchContacts<double>&);

}  // namespace graze
