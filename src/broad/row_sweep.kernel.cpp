#include "broad/row_kernels.hpp"
#include "lanes/lanes.hpp"

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

  /// The pairs of `place` with those of `others` whose bits are set.
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
    first_ = sink_.first, second_ = sink_.second, count_ = sink_.count, capacity_ = sink_.capacity;
  }
  [[gnu::noinline]] static void grow(PairSink& sink, std::size_t count) {
    sink.count = count;
    sink.grow(sink);
  }

  PairSink& sink_;
  std::uint32_t *first_, *second_;
  std::size_t count_, capacity_;
};

enum class Order { along_x, none };

/// One box against those from `k` on. Where they ascend along X it looks at those that begin before the box ends.
/// Whether a pair overlaps is hard to foresee, so every step writes all of its lanes and only the count depends on it.
template <Order order, class T>
[[gnu::always_inline]] inline void scan(const Rows<T>& r, const Spread<T>& box, std::uint32_t place, std::uint32_t k,
                                        std::uint32_t end, Output& output) {
  constexpr std::uint32_t lanes = lanes_of<T>;
  const auto at = [&](const T* column) { return Lanes<T>::load(column + k); };
  using C = Chosen<T>;
  while (k < end) {
    const C begun = C::at_most(at(r.lower_x), box.upper_x);
    const C hit = (begun & C::at_most(box.lower_x, at(r.upper_x))) &
                  (C::at_most(at(r.lower_y), box.upper_y) & C::at_most(box.lower_y, at(r.upper_y))) &
                  (C::at_most(at(r.lower_z), box.upper_z) & C::at_most(box.lower_z, at(r.upper_z)));
    const std::uint32_t left = end - k;
    const std::uint32_t inside = left < lanes ? (std::uint32_t{1} << left) - 1 : C::all;
    output.add(place, r.place + k, hit.bits() & inside);
    if (order == Order::along_x && begun.bits() != C::all) return;
    k += lanes;
  }
}

/// From `k` on the first box that is not past: none from the beginning of the row up to it ends before `x`.
template <class T>
[[gnu::always_inline]] inline std::uint32_t skip_past(const Rows<T>& r, std::uint32_t k, std::uint32_t end,
                                                      const Lanes<T>& x) {
  constexpr std::uint32_t lanes = lanes_of<T>;
  for (;;) {
    // `reach_x` ascends within the row, so the lanes that are not past yet are the last ones; what comes after the end
    // does not matter, since `k` is cut off there.
    const std::uint32_t ahead = Chosen<T>::at_most(x, Lanes<T>::load(r.reach_x + k)).bits();
    const auto past = static_cast<std::uint32_t>(__builtin_ctz(ahead | (Chosen<T>::all + 1)));
    k += past;
    if (k >= end) return end;
    if (past < lanes) return k;
  }
}

/// A row that is swept along with another.
struct Beside {
  std::uint32_t from, end;
};

}  // namespace

template <class T>
void sweep_rows(const Rows<T>& r, PairSink& sink) {
  Output output(sink);
  std::size_t above = 0;  // the first row of the next Y that is not behind (y + 1, z - 1)
  for (std::size_t i = 0; i < r.count; ++i) {
    const Row row = r.rows[i];
    const std::uint32_t z = row.index % r.along_z, low = row.index + r.along_z - (z > 0 ? 1 : 0),
                        high = row.index + r.along_z + (z + 1 < r.along_z ? 1 : 0);
    Beside beside[4];
    int count = 0;
    if (r.rows[i + 1].index == row.index + 1 && z + 1 < r.along_z)
      beside[count++] = {r.rows[i + 1].begin, r.rows[i + 1].end};
    while (r.rows[above].index < low) ++above;
    for (std::size_t k = above; r.rows[k].index <= high; ++k) beside[count++] = {r.rows[k].begin, r.rows[k].end};

    for (std::uint32_t b = row.begin; b < row.end; ++b) {
      const Spread<T> box{r.lower_x[b], r.upper_x[b], r.lower_y[b], r.upper_y[b], r.lower_z[b], r.upper_z[b]};
      const std::uint32_t place = r.place[b];
      scan<Order::along_x>(r, box, place, b + 1, row.end, output);
      for (int n = 0; n < count; ++n) {
        beside[n].from = skip_past(r, beside[n].from, beside[n].end, box.lower_x);
        scan<Order::along_x>(r, box, place, beside[n].from, beside[n].end, output);
      }
    }
  }
}

template <class T>
void sweep_over(const Rows<T>& r, const std::uint32_t* strips, const SweptOver<T>* boxes, std::size_t count,
                PairSink& sink) {
  Output output(sink);
  for (const SweptOver<T>* b = boxes; b != boxes + count; ++b) {
    const Spread<T> box{b->bounds[0], b->bounds[1], b->bounds[2], b->bounds[3], b->bounds[4], b->bounds[5]};
    for (std::uint32_t y = b->low_y; y <= b->high_y; ++y) {
      const std::uint32_t low = y * r.along_z + b->low_z, high = y * r.along_z + b->high_z;
      std::uint32_t from = strips[y];
      for (std::uint32_t size = strips[y + 1] - from; size > 0;) {  // the first row that is not below `low`
        const std::uint32_t half = size / 2;
        const bool below = r.rows[from + half].index < low;
        from = below ? from + half + 1 : from;
        size = below ? size - half - 1 : half;
      }
      for (; from < strips[y + 1] && r.rows[from].index <= high; ++from) {
        std::uint32_t k = r.rows[from].begin;
        const std::uint32_t end = r.rows[from].end;
        for (std::uint32_t size = end - k; size > static_cast<std::uint32_t>(lanes_of<T>);) {
          const std::uint32_t half = size / 2;
          const bool past = r.reach_x[k + half] < b->bounds[0];
          k = past ? k + half + 1 : k;
          size = past ? size - half - 1 : half;
        }
        scan<Order::along_x>(r, box, b->place, k, end, output);
      }
    }
  }
}

template <class T>
void test_all(const Rows<T>& r, std::size_t from, std::size_t end, const SweptOver<T>& b, PairSink& sink) {
  Output output(sink);
  const Spread<T> box{b.bounds[0], b.bounds[1], b.bounds[2], b.bounds[3], b.bounds[4], b.bounds[5]};
  scan<Order::none>(r, box, b.place, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(end), output);
}

template void test_all(const Rows<float>&, std::size_t, std::size_t, const SweptOver<float>&, PairSink&);
template void test_all(const Rows<double>&, std::size_t, std::size_t, const SweptOver<double>&, PairSink&);
template void sweep_rows(const Rows<float>&, PairSink&);
template void sweep_rows(const Rows<double>&, PairSink&);
template void sweep_over(const Rows<float>&, const std::uint32_t*, const SweptOver<float>*, std::size_t, PairSink&);
template void sweep_over(const Rows<double>&, const std::uint32_t*, const SweptOver<double>*, std::size_t, PairSink&);

}  // namespace graze::GRAZE_ISA
