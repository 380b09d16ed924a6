#include "graze/compact_contacts.hpp"

#include "graze/batch.hpp"
#include "query/batch_parts.hpp"
#include "query/contact_writing.hpp"

namespace graze {

namespace {

/// Writes compact contacts. Kernels write to a buffer that stays in the cache, and the needed part of that is kept.
template <class T>
class CompactWriter : public BlockRoom<T> {
  using Group = typename CompactContacts<T>::Group;
  using Point = typename CompactContacts<T>::Point;

 public:
  explicit CompactWriter(CompactContacts<T>& found) : found_(found) {}
  ~CompactWriter() {
    found_.manifolds.resize(manifolds_);
    found_.points.resize(points_);
  }
  CompactWriter(const CompactWriter&) = delete;
  CompactWriter& operator=(const CompactWriter&) = delete;

  void begin(std::size_t, bool) {}
  template <class Append>
  void add(std::size_t pair, const Vec3<T>& normal, std::uint32_t, std::uint32_t, std::size_t, const Append& append) {
    some_.clear();
    append(some_);
    reserve(1, some_.size());
    put(pair, normal, some_.data(), some_.size());
  }
  template <class Points>
  void touching(std::size_t pair, T, const Vec3<T>& normal, std::size_t most, const Points& points) {
    add(pair, normal, 0, 0, most, [&](auto& some) { return points.append(some); });
  }
  template <class Place>
  std::size_t write(const Place& place, const PointContact<T>* contacts, const Meeting* meetings, std::size_t count) {
    reserve(count, count);
    std::size_t others = 0;
    for (std::size_t k = 0; k < count; ++k) {
      put_one(place(k), contacts[k].normal, contacts[k].point, meetings[k] == Meeting::touching);
      others += is_elsewhere(meetings[k]);
    }
    return others;
  }
  template <class Place>
  void write(const MetPairs<T>& met, bool turned, const Place& place) {
    reserve(met.count, met.point_count);
    const ContactPoint<T>* point = met.points;
    for (std::size_t k = 0; k < met.count; ++k) {
      const std::uint32_t count = met.points_of(k);
      if (turned) {
        some_.clear();
        for (std::uint32_t i = 0; i < count; ++i) some_.push_back(mirrored(point[i]));
        put(place(k), -met.normal(k), some_.data(), count);
      } else {
        put(place(k), met.normal(k), point, count);
      }
      point += count;
    }
  }
  /// Writes boxes directly if no two points of a pair have the same features, which only full contacts distinguish.
  template <class Single>
  bool write_boxes(const MetBoxes<T>& met, std::size_t size, Single& single) {
    reserve(block_pairs, CompactBlock<T>::room);
    CompactBlock<T> block;
    block.manifolds = found_.manifolds.data() + manifolds_;
    block.points = found_.points.data() + points_;
    block.first_point = static_cast<std::uint32_t>(points_);
    block.pairs = met.place + met.first;
    GRAZE_KERNEL(chosen_isa(), box_compact_points<T>)(met, size, block);
    if (block.any_twice) return false;
    manifolds_ += block.manifold_count;
    points_ += block.point_count;
    for (std::size_t k = 0; block.manifold_count < size && k < size; ++k)
      if ((block.known >> k & 1) == 0) single(block.pairs[k]);
    return true;
  }
  template <class Ask>
  RowCounts write_rows(std::size_t first, OtherRows<T>& others, const Ask& ask) {
    const RowCounts found = ask(ContactRows<T>{pairs_aside_, manifolds_aside_.records, points_aside_.records,
                                               others.unknown, others.side_places, others.sides.records, 0, 0});
    reserve(found.touching, found.touching);
    for (std::size_t k = 0, pair = first; k < found.touching; ++k, ++pair) {
      while (pairs_aside_[pair - first].manifold_count == 0) ++pair;
      put(pair, manifolds_aside_.records[k].normal, points_aside_.records + k, 1);
    }
    return found;
  }

 private:
  void reserve(std::size_t manifolds, std::size_t points) {
    make_room(found_.manifolds, manifolds_ + manifolds + 1);
    make_room(found_.points, points_ + points + 1);
  }
  static Point compact(const ContactPoint<T>& point) { return {point.position(), point.distance}; }
  void put(std::size_t pair, const Vec3<T>& normal, const ContactPoint<T>* points, std::size_t count) {
    found_.manifolds[manifolds_++] = {normal, static_cast<std::uint32_t>(pair), static_cast<std::uint32_t>(points_),
                                      static_cast<std::uint32_t>(count)};
    for (std::size_t i = 0; i < count; ++i) found_.points[points_++] = compact(points[i]);
  }
  /// Written either way and kept if it `counts`: a branch would often be mispredicted.
  void put_one(std::size_t pair, const Vec3<T>& normal, const ContactPoint<T>& point, bool counts) {
    found_.manifolds[manifolds_] = {normal, static_cast<std::uint32_t>(pair), static_cast<std::uint32_t>(points_), 1};
    found_.points[points_] = compact(point);
    manifolds_ += counts;
    points_ += counts;
  }

  CompactContacts<T>& found_;
  std::size_t manifolds_ = 0, points_ = 0;
  std::vector<ContactPoint<T>> some_;
  typename BatchContacts<T>::Pair pairs_aside_[row_chunk];
  RoomFor<typename BatchContacts<T>::Group, row_chunk> manifolds_aside_;
  RoomFor<ContactPoint<T>, row_chunk> points_aside_;
};

}  // namespace

template <class T>
void contacts(const Batch<T>& batch, T margin, CompactContacts<T>& found, Executor* executor) {
  const auto find = [margin](const Batch<T>& some, CompactContacts<T>& of_some) {
    CompactWriter<T> writer(of_some);
    write_contacts(some, margin, writer);
  };
  if (executor == nullptr) return find(batch, found);
  found.manifolds.clear(), found.points.clear();
  find_in_parts<CompactContacts<T>>(
      *executor, batch, find, [&](const CompactContacts<T>& some, std::size_t first) { found.append(some, first); });
}

template void contacts(const Batch<float>&, float, CompactContacts<float>&, Executor*);
template void contacts(const Batch<double>&, double, CompactContacts<double>&, Executor*);

}  // namespace graze
