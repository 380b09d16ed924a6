#include "rays/height_field_traversal.hpp"

#include "rays/ray_stream_lanes.hpp"

namespace graze::GRAZE_ISA {

using namespace ray_streams;

namespace {

constexpr int row_lanes = 4;
typedef std::int32_t Places __attribute__((vector_size(16)));
static_assert(FieldPyramid<float>::side == row_lanes);

/// Four adjacent blocks or cells.
template <class T>
struct Row {
  Wide<T, row_lanes> low, high;
  Places some;  ///< mask without blocks that are all holes
};

template <class T>
[[gnu::always_inline]] inline Quad single_of(const Wide<T, row_lanes>& numbers) {
  return Quad::of(__builtin_convertvector(numbers.v, Quad::Vector));
}

/// For the children of a block, four rows of four: the same in each row, each row's own number, and each row's four.
[[gnu::always_inline]] inline auto joined(const auto& one, const auto& other) {
  if constexpr (part_lanes == 8)
    return __builtin_shufflevector(one, other, 0, 1, 2, 3, 4, 5, 6, 7);
  else
    return one;
}
constexpr int rows_of_part = part_lanes / row_lanes;

/// The blocks of a height field. Corners have exactly the coordinates of `HeightFieldData`.
template <class T>
struct FieldHierarchy {
  using Scalar = T;
  using Fours = Wide<T, row_lanes>;
  using FieldKeys = KeysOf<16>;
  /// A block of a level; level 0 are the cells.
  struct Ref {
    std::uint32_t column, row, level;
  };
  struct Leaf {
    std::uint32_t column, row;
  };
  static constexpr int children = 16;
  static constexpr std::uint32_t side = FieldPyramid<T>::side;

  const FieldPyramid<T>& field;

  [[gnu::always_inline]] Ref root() const { return {0, 0, field.levels}; }

  [[gnu::always_inline]] bool go(Ref& at, Leaf& leaf, std::uint32_t place) const {
    at = {at.column * side + place % side, at.row * side + place / side, at.level - 1};
    leaf = {at.column, at.row};
    fetch(at);
    return at.level > 0;
  }

  [[gnu::always_inline]] FieldKeys open(const BvhRay<T>& bvh_ray, const Ref& at, float limit) const {
    const std::uint32_t level = at.level - 1, column = at.column * side, row = at.row * side;
    const std::uint32_t columns = level == 0 ? field.columns - 1 : field.level[level - 1].columns,
                        rows = level == 0 ? field.rows - 1 : field.level[level - 1].rows;
    const Slab x = slab(bvh_ray, 0, column, columns, field.columns - 1, level, field.spacing_x),
               z = slab(bvh_ray, 2, row, rows, field.rows - 1, level, field.spacing_z);
    const Places inside = static_cast<std::int32_t>(column) + Places{0, 1, 2, 3} < static_cast<std::int32_t>(columns);
    Row<T> row_of[side];
    level == 0 ? read_cells(column, row, row_of) : read_blocks(level, column, row, row_of);
    Quad in[side], out[side];
    Places met[side];
    const Fours inverse(bvh_ray.inverse[1]), first(bvh_ray.first[1]), last(bvh_ray.last[1]);
    const bool back = bvh_ray.inverse[1] < T(0);
    for (std::uint32_t r = 0; r < side; ++r) {
      const Fours &near = back ? row_of[r].high : row_of[r].low, &far = back ? row_of[r].low : row_of[r].high;
      in[r] = larger(larger(x.in, Quad(z.in[static_cast<int>(r)])), single_of<T>(near * inverse - first));
      out[r] = lesser(lesser(x.out, Quad(z.out[static_cast<int>(r)])), single_of<T>(far * inverse - last));
      met[r] = row_of[r].some & inside & -static_cast<std::int32_t>(row + r < rows);
    }
    FieldKeys keys;
    for (int k = 0; k < FieldKeys::parts; ++k) {
      const int one = k * rows_of_part, other = one + rows_of_part - 1;
      const ChildLanes enter = larger(ChildLanes::of(joined(in[one].v, in[other].v)), ChildLanes(bvh_ray.begin)),
                       leave = lesser(ChildLanes::of(joined(out[one].v, out[other].v)), ChildLanes(limit));
      keys.set(k, enter, (enter <= leave).bits & joined(met[one], met[other]));
    }
    return keys;
  }

  [[gnu::always_inline]] T x(std::uint32_t column) const {
    return (T(column) - T(field.columns - 1) / T(2)) * field.spacing_x;
  }
  [[gnu::always_inline]] T z(std::uint32_t row) const { return (T(row) - T(field.rows - 1) / T(2)) * field.spacing_z; }

 private:
  struct Slab {
    Quad in, out;
  };

  /// The keys at which the ray enters and leaves four consecutive blocks along an axis, of which there are `blocks`.
  [[gnu::always_inline]] Slab slab(const BvhRay<T>& bvh_ray, int axis, std::uint32_t from, std::uint32_t blocks,
                                   std::uint32_t end, std::uint32_t level, T spacing) const {
    const std::int32_t back = bvh_ray.inverse[axis] < T(0), begin = static_cast<std::int32_t>(from);
    const auto at = [&](std::int32_t offset) __attribute__((always_inline)) {
      const auto lesser_of = [](const Places& places, std::uint32_t most) __attribute__((always_inline)) {
        const Places all = Places{} + static_cast<std::int32_t>(most);
        return places < all ? places : all;
      };
      const Places line = lesser_of(begin + offset + Places{0, 1, 2, 3}, blocks) << static_cast<int>(2 * level);
      const Fours number = Fours::of(__builtin_convertvector(lesser_of(line, end), typename Fours::Vector));
      return (number - Fours(T(end) / T(2))) * Fours(spacing) * Fours(bvh_ray.inverse[axis]);
    };
    return {single_of<T>(at(back) - Fours(bvh_ray.first[axis])),
            single_of<T>(at(1 - back) - Fours(bvh_ray.last[axis]))};
  }

  [[gnu::always_inline]] static Places chosen(const typename Fours::Mask& mask) {
    return __builtin_convertvector(mask.bits, Places);
  }

  [[gnu::always_inline]] void read_blocks(std::uint32_t level, std::uint32_t column, std::uint32_t row,
                                          Row<T> (&to)[side]) const {
    const auto& of = field.level[level - 1];
    for (std::uint32_t r = 0; r < side; ++r) {
      const std::uint32_t at = row + r < of.rows ? row + r : of.rows - 1;
      const T* spans = of.spans + 2 * (std::size_t{at} * of.columns + column);
      const Fours one = Fours::load(spans), other = Fours::load(spans + 4);
      to[r].low = Fours::of(__builtin_shufflevector(one.v, other.v, 0, 2, 4, 6));
      to[r].high = Fours::of(__builtin_shufflevector(one.v, other.v, 1, 3, 5, 7));
      to[r].some = chosen(to[r].low <= to[r].high);
    }
  }

  [[gnu::always_inline]] void read_cells(std::uint32_t column, std::uint32_t row, Row<T> (&to)[side]) const {
    Row<T> line[side + 1];
    for (std::uint32_t r = 0; r <= side; ++r) {
      const std::uint32_t at = row + r < field.rows ? row + r : field.rows - 1;
      const std::size_t first = std::size_t{at} * field.columns + column;
      const T* from = field.heights + first;
      T last[side + 1];
      if (first + side + 1 > field.count) [[unlikely]] {
        for (std::size_t i = 0; i <= side; ++i)
          last[i] = field.heights[first + i < field.count ? first + i : field.count - 1];
        from = last;
      }
      const Fours left = Fours::load(from), right = Fours::load(from + 1);
      line[r] = {least(left, right), greatest(left, right), chosen((left == left) & (right == right))};
    }
    for (std::uint32_t r = 0; r < side; ++r)
      to[r] = {least(line[r].low, line[r + 1].low), greatest(line[r].high, line[r + 1].high),
               line[r].some & line[r + 1].some};
  }

  /// Prefetches the data for opening a block.
  [[gnu::always_inline]] void fetch(const Ref& at) const {
    if (at.level == 0) return;
    const bool cells = at.level == 1;
    const auto& of = field.level[cells ? 0 : at.level - 2];
    const T* from = cells ? field.heights : of.spans;
    const std::size_t stride = cells ? field.columns : 2 * std::size_t{of.columns};
    from += at.row * side * stride + at.column * side * (cells ? 1 : 2);
    for (std::size_t r = 0; r < side; ++r) __builtin_prefetch(from + r * stride);
  }
};

/// The surface for `RayStream`.
template <class T>
struct FieldSurface : FieldHierarchy<T> {
  using Leaf = typename FieldHierarchy<T>::Leaf;
  struct Piece {
    Leaf cell;
    std::uint32_t half;  ///< the first or the second triangle of the cell
  };
  static constexpr std::size_t most = 2, deep = 9;

  const rays::BlockField<T>& question;

  template <class Ref, class Add>
  [[gnu::always_inline]] void each(const BvhRay<T>&, const Ref&, const Leaf& cell, const Add& add) const {
    add({cell, 0}, true);
    add({cell, 1}, true);
  }
  /// The heights were prefetched with the cell.
  [[gnu::always_inline]] void prefetch(const Piece&) const {}

  /// A triangle with the corners of `HeightFieldData`.
  struct Triangle {
    T corners[3][3];
    [[gnu::always_inline]] T operator()(std::size_t corner, std::size_t axis) const { return corners[corner][axis]; }
  };
  [[gnu::always_inline]] Triangle triangle(const Piece& piece) const {
    const Leaf& cell = piece.cell;
    const T* heights = this->field.heights + std::size_t{cell.row} * this->field.columns + cell.column;
    const T x[2] = {this->x(cell.column), this->x(cell.column + 1)}, z[2] = {this->z(cell.row), this->z(cell.row + 1)};
    const auto put = [&](T(&to)[3], std::size_t column, std::size_t row) __attribute__((always_inline)) {
      to[0] = x[column];
      to[1] = heights[row * this->field.columns + column];
      to[2] = z[row];
    };
    Triangle t;
    put(t.corners[0], 0, 0);
    put(t.corners[1], 1 - piece.half, 1);
    put(t.corners[2], 1, piece.half);
    return t;
  }
  [[gnu::always_inline]] std::uint32_t number(const Piece& piece) const {
    return 2 * (piece.cell.row * (this->field.columns - 1) + piece.cell.column) + piece.half;
  }
};

}  // namespace

template <class T>
void traverse_field(const FieldQuestion<T>& question) {
  using Hierarchy = FieldHierarchy<T>;
  using FieldKeys = typename Hierarchy::FieldKeys;
  struct alignas(32) Entry {
    float keys[Hierarchy::children];
    typename Hierarchy::Ref at;
  };
  Entry stack[FieldPyramid<T>::deepest + 1];
  std::size_t waiting = 0;
  const Hierarchy field{*question.field};
  const BvhRay<T> bvh_ray(question);
  float limit = bvh_ray.key(question.end);
  auto at = field.root();
  FieldKeys keys = field.open(bvh_ray, at, limit);
  for (;;) {
    const std::int32_t key = keys.least();
    if (key > (number_bits(limit) | FieldKeys::place_bits)) {
      if (waiting == 0) return;
      const Entry& entry = stack[--waiting];
      at = entry.at;
      keys.load(entry.keys);
      continue;
    }
    keys.remove(key);
    auto next = at;
    typename Hierarchy::Leaf cell;
    if (field.go(next, cell, static_cast<std::uint32_t>(key & FieldKeys::place_bits))) {
      keys.store(stack[waiting].keys);
      stack[waiting].at = at;
      waiting += keys.least() != absent;
      at = next;
      keys = field.open(bvh_ray, at, limit);
      continue;
    }
    limit = bvh_ray.key(question.found(question.owner, cell.column, cell.row));
    if (!(limit > 0)) return;
  }
}

template <class T>
[[gnu::flatten]] void block_at_field(rays::RayBlock& block, std::size_t count, const rays::BlockField<T>& field,
                                     std::uint32_t* pieces) {
  cast_block(block, count, FieldSurface<T>{{*field.field}, field}, pieces);
}

template void traverse_field(const FieldQuestion<float>&);
template void traverse_field(const FieldQuestion<double>&);
template void block_at_field(rays::RayBlock&, std::size_t, const rays::BlockField<float>&, std::uint32_t*);
template void block_at_field(rays::RayBlock&, std::size_t, const rays::BlockField<double>&, std::uint32_t*);

}  // namespace graze::GRAZE_ISA
