#include "broad/row_kernels.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

static_assert(lanes_of<float> <= static_cast<int>(row_padding) && chosen_room <= static_cast<int>(row_padding));

/// One box in all lanes.
template <class T>
struct Spread {
  Lanes<T> lower_x, upper_x, lower_y, upper_y, lower_z, upper_z;
};

/// A copy of a sink in registers: nothing that is stored elsewhere can change it.
class Output {
 public:
  [[gnu::always_inline]] explicit Output(PairSink& sink) : sink_(sink) { fetch(); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  [[gnu::always_inline]] ~Output() { sink_.count = count_; }

  /// Whether more is to be found at all.
  [[gnu::always_inline]] bool is_full() const { return is_full_; }

  /// Adds the pairs of `place` with those of `others` whose bits are set.
  [[gnu::always_inline]] void add(std::uint32_t place, const std::uint32_t* others, std::uint32_t bits) {
    if (count_ + row_padding > capacity_) [[unlikely]] {
      grow(sink_, count_);
      fetch();
    }
    for (int i = 0; i < chosen_room; ++i) first_[count_ + static_cast<std::size_t>(i)] = place;
    store_chosen(second_ + count_, others, bits);
    count_ += static_cast<std::size_t>(count_bits(bits));
  }

 private:
  [[gnu::always_inline]] void fetch() {
    is_full_ = sink_.is_full;
    first_ = sink_.first, second_ = sink_.second, count_ = sink_.count, capacity_ = sink_.capacity;
  }
  [[gnu::noinline]] static void grow(PairSink& sink, std::size_t count) {
    sink.count = count;
    sink.grow(sink);
  }

  PairSink& sink_;
  std::uint32_t *first_, *second_;
  std::size_t count_, capacity_;
  bool is_full_;
};

/// The destination of pairs that are written two places each, and for which there is room.
class InOrder {
 public:
  [[gnu::always_inline]] explicit InOrder(std::uint32_t* to) : to_(to) {}

  [[gnu::always_inline]] void add(std::uint32_t place, const std::uint32_t* others, std::uint32_t bits) {
    store_chosen_pairs(to_, place, others, bits);
    to_ += 2 * count_bits(bits);
  }
  [[gnu::always_inline]] void add(const std::uint32_t* pair) {
    to_[0] = pair[0], to_[1] = pair[1];
    to_ += 2;
  }
  [[gnu::always_inline]] std::uint32_t* end() const { return to_; }

 private:
  std::uint32_t* to_;
};

/// The columns that a scan looks at. In a sweep boxes ascend along X, and those that begin after the box has ended
/// end it; a box behind another in the same row begins after it, too.
enum class Scan { own_row, row, unordered };

/// Tests one box against those from `k` on; in rows, only where `began` has no bit in common with them. A
/// branch on whether a pair overlaps would be mispredicted often, so every step writes all of its lanes and
/// only the count depends on it.
template <Scan kind, class T, class Out>
[[gnu::always_inline]] inline void scan(const Rows<T>& r, const Spread<T>& box, typename Lanes<T>::Bits began,
                                        std::uint32_t place, std::uint32_t k, std::uint32_t end, Out& output) {
  constexpr std::uint32_t lanes = lanes_of<T>;
  const auto at = [&](const T* column) { return Lanes<T>::load(column + k); };
  using C = Chosen<T>;
  while (k < end) {
    const C begun = C::at_most(at(r.lower_x), box.upper_x);
    C hit = (C::at_most(at(r.lower_y), box.upper_y) & C::at_most(box.lower_y, at(r.upper_y))) &
            (C::at_most(at(r.lower_z), box.upper_z) & C::at_most(box.lower_z, at(r.upper_z)));
    if (kind != Scan::own_row) hit = hit & C::at_most(box.lower_x, at(r.upper_x));
    if (kind != Scan::unordered) hit = hit & C::disjoint(r.began + k, began);
    const std::uint32_t left = end - k;
    const std::uint32_t inside = left < lanes ? (std::uint32_t{1} << left) - 1 : C::all;
    const std::uint32_t begun_bits = begun.bits();
    output.add(place, r.place + k, hit.bits() & begun_bits & inside);
    if (kind != Scan::unordered && begun_bits != C::all) return;
    k += lanes;
  }
}

/// The first of the rows from `from` to `end` whose index is not below `index`.
[[gnu::always_inline]] inline std::uint32_t first_not_below(const Row* rows, std::uint32_t from, std::uint32_t end,
                                                            std::uint32_t index) {
  for (std::uint32_t size = end - from; size > 0;) {
    const std::uint32_t half = size / 2;
    const bool below = rows[from + half].index < index;
    from = below ? from + half + 1 : from;
    size = below ? size - half - 1 : half;
  }
  return from;
}

}  // namespace

template <class T>
void sweep_rows(const Rows<T>& r, PairSink& sink) {
  Output output(sink);
  for (std::size_t i = 0; i < r.count && !output.is_full(); ++i) {
    const Row row = r.rows[i];
    for (std::uint32_t b = row.begin; b + 1 < row.end; ++b) {
      const Spread<T> box{r.lower_x[b], r.upper_x[b], r.lower_y[b], r.upper_y[b], r.lower_z[b], r.upper_z[b]};
      scan<Scan::own_row>(r, box, r.began[b], r.place[b], b + 1, row.end, output);
    }
  }
}

template <class T>
void sweep_over(const Rows<T>& r, const std::uint32_t* strips, const SweptOver<T>* boxes, std::size_t count,
                PairSink& sink) {
  Output output(sink);
  for (const SweptOver<T>* b = boxes; b != boxes + count && !output.is_full(); ++b) {
    const Spread<T> box{b->bounds[0], b->bounds[1], b->bounds[2], b->bounds[3], b->bounds[4], b->bounds[5]};
    for (std::uint32_t y = b->low_y; y <= b->high_y; ++y) {
      const std::uint32_t low = y * r.along_z + b->low_z, high = y * r.along_z + b->high_z;
      std::uint32_t from = strips[y];
      // The row is at its place in a full grid unless rows of this Y are empty.
      if (b->low_z < strips[y + 1] - from && r.rows[from + b->low_z].index == low)
        from += b->low_z;
      else
        from = first_not_below(r.rows, from, strips[y + 1], low);
      for (; from < strips[y + 1] && r.rows[from].index <= high; ++from) {
        std::uint32_t k = r.rows[from].begin;
        const std::uint32_t end = r.rows[from].end;
        for (std::uint32_t size = end - k; size > static_cast<std::uint32_t>(lanes_of<T>);) {
          const std::uint32_t half = size / 2;
          const bool past = r.reach_x[k + half] < b->bounds[0];
          k = past ? k + half + 1 : k;
          size = past ? size - half - 1 : half;
        }
        const int began =
            (y > b->low_y ? began_before_y : 0) | (r.rows[from].index % r.along_z > b->low_z ? began_before_z : 0);
        scan<Scan::row>(r, box, began, b->place, k, end, output);
      }
    }
  }
}

template <class T>
std::uint32_t* test_all(const Rows<T>& r, std::uint32_t from, std::uint32_t end, const SweptOver<T>& b,
                        const KnownPairs& known, std::uint32_t* to) {
  InOrder output(to);
  const Spread<T> box{b.bounds[0], b.bounds[1], b.bounds[2], b.bounds[3], b.bounds[4], b.bounds[5]};
  for (const std::uint32_t* pair = known.pairs; pair != known.pairs + 2 * known.count; pair += 2) {
    const std::uint32_t next = known.ranks[pair[1]];
    scan<Scan::unordered>(r, box, 0, b.place, from, next, output);
    output.add(pair);
    from = next;
  }
  scan<Scan::unordered>(r, box, 0, b.place, from, end, output);
  return output.end();
}

template std::uint32_t* test_all(const Rows<float>&, std::uint32_t, std::uint32_t, const SweptOver<float>&,
                                 const KnownPairs&, std::uint32_t*);
template std::uint32_t* test_all(const Rows<double>&, std::uint32_t, std::uint32_t, const SweptOver<double>&,
                                 const KnownPairs&, std::uint32_t*);
template void sweep_rows(const Rows<float>&, PairSink&);
template void sweep_rows(const Rows<double>&, PairSink&);
template void sweep_over(const Rows<float>&, const std::uint32_t*, const SweptOver<float>*, std::size_t, PairSink&);
template void sweep_over(const Rows<double>&, const std::uint32_t*, const SweptOver<double>*, std::size_t, PairSink&);

}  // namespace graze::GRAZE_ISA
