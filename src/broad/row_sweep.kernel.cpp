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

/// One box against those from `k` on, all of one row: those that begin, along X, before it ends. Whether a pair overlaps
/// is hard to foresee, so every step writes all of its lanes and only the count depends on the answer.
template <class T>
[[gnu::always_inline]] inline void scan(const Rows<T>& r, const Spread<T>& box, std::uint32_t place, std::uint32_t k,
                                        std::uint32_t end, PairSink& sink) {
  constexpr std::uint32_t lanes = lanes_of<T>;
  const auto at = [&](const T* column) { return Lanes<T>::load(column + k); };
  using C = Chosen<T>;
  while (k < end) {
    if (sink.count + row_padding > sink.capacity) sink.grow(sink);
    const C begun = C::at_most(at(r.lower_x), box.upper_x);
    const C hit = (begun & C::at_most(box.lower_x, at(r.upper_x))) &
                  (C::at_most(at(r.lower_y), box.upper_y) & C::at_most(box.lower_y, at(r.upper_y))) &
                  (C::at_most(at(r.lower_z), box.upper_z) & C::at_most(box.lower_z, at(r.upper_z)));
    const std::uint32_t left = end - k;
    const std::uint32_t inside = left < lanes ? (std::uint32_t{1} << left) - 1 : C::all;
    const std::uint32_t bits = hit.bits() & inside;
    for (int i = 0; i < chosen_room; ++i) sink.first[sink.count + static_cast<std::size_t>(i)] = place;
    store_chosen(sink.second + sink.count, r.place + k, bits);
    sink.count += static_cast<std::size_t>(count_bits(bits));
    if (begun.bits() != C::all) return;
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
void sweep_rows(const Rows<T>& r, PairSink& result) {
  PairSink sink = result;  // a copy that no store to the arrays can alias
  std::size_t above = 0;   // the first row of the next Y that is not behind (y + 1, z - 1)
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
      scan(r, box, place, b + 1, row.end, sink);
      for (int n = 0; n < count; ++n) {
        beside[n].from = skip_past(r, beside[n].from, beside[n].end, box.lower_x);
        scan(r, box, place, beside[n].from, beside[n].end, sink);
      }
    }
  }
  result = sink;
}

template <class T>
void sweep_over(const Rows<T>& r, const std::uint32_t* strips, const SweptOver<T>* boxes, std::size_t count,
                PairSink& result) {
  PairSink sink = result;
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
        scan(r, box, b->place, k, end, sink);
      }
    }
  }
  result = sink;
}

template void sweep_rows(const Rows<float>&, PairSink&);
template void sweep_rows(const Rows<double>&, PairSink&);
template void sweep_over(const Rows<float>&, const std::uint32_t*, const SweptOver<float>*, std::size_t, PairSink&);
template void sweep_over(const Rows<double>&, const std::uint32_t*, const SweptOver<double>*, std::size_t, PairSink&);

}  // namespace graze::GRAZE_ISA
