#include <algorithm>
#include <array>

#include "broad/rebuilt.hpp"

namespace graze {

namespace {

/// The length of a cell, in lengths of the median box, which then lies in (1 + 1/2)^3 = 3.4 cells on average.
constexpr double cell_per_box = 2;
/// The most cells of a box in the grid; one in more is held apart and tested against all. Four along each axis, so that
/// boxes of up to six times the median are in the grid.
constexpr double max_cells_per_box = 64;
/// The distance from the origin, in cells, beyond which all cells are one: neighbouring doubles are more than a cell
/// apart there.
constexpr double farthest_cell = 0x1p52;

using Cell = std::array<std::int64_t, 3>;

/// The cells from `low` to `high`, both included.
struct CellRange {
  Cell low, high;

  double count() const {
    double product = 1;
    for (std::size_t i = 0; i < 3; ++i) product *= static_cast<double>(high[i] - low[i]) + 1;
    return product;
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) visit(Cell{x, y, z});
  }
};

/// The cell in which a pair is reported: the one of the lower corner of the intersection. Rounding to cells is
/// monotonic, so that it is the greater of the two lower cells on each axis.
Cell first_common(const Cell& a, const Cell& b) {
  return {std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2])};
}

/// The hash of a cell. Any mixing will do, since cells are compared after their hashes: the products with large primes
/// of Teschner and others (2003), then Fibonacci hashing, which takes the upper bits (Knuth, "The art of computer
/// programming", volume 3, section 6.4).
std::uint64_t hash(const Cell& cell) {
  const auto bits = [&](std::size_t i) { return static_cast<std::uint64_t>(cell[i]); };
  return ((bits(0) * 73856093u) ^ (bits(1) * 19349663u) ^ (bits(2) * 83492791u)) * 0x9E3779B97F4A7C15u;
}

/// The boxes of a table by cell. The items of a bucket stand together.
template <class T>
class Grid {
 public:
  struct Item {
    Cell cell;
    std::uint32_t place;
  };

  void build(const BoxTable<T>& boxes) {
    choose_cell(boxes);
    ranges_.clear();
    is_large_.clear();
    large_.clear();
    std::size_t count = 0;
    for (std::uint32_t place = 0; place < boxes.size(); ++place) {
      ranges_.push_back(range(boxes[place].box));
      const double cells = ranges_.back().count();
      is_large_.push_back(cells > max_cells_per_box);
      if (is_large_.back())
        large_.push_back(place);
      else
        count += static_cast<std::size_t>(cells);
    }
    fill(count);
  }

  CellRange range(const Aabb<T>& box) const {
    CellRange result{};
    for (std::size_t i = 0; i < 3; ++i) {
      result.low[i] = coordinate(box.lower[i]);
      result.high[i] = coordinate(box.upper[i]);
    }
    return result;
  }
  bool is_large(std::uint32_t place) const { return is_large_[place]; }
  const std::vector<std::uint32_t>& large() const { return large_; }
  const Cell& lowest_cell(std::uint32_t place) const { return ranges_[place].low; }
  double cell_size() const { return cell_; }
  double size() const { return static_cast<double>(items_.size()); }

  /// Calls `visit(place)` for all boxes in the cell.
  template <class Visit>
  void for_each_in(const Cell& cell, const Visit& visit) const {
    const std::size_t b = bucket(cell);
    for (std::size_t i = start_[b]; i < start_[b + 1]; ++i)
      if (items_[i].cell == cell) visit(items_[i].place);
  }

  /// Calls `test(place, place)` for all pairs that may overlap. Several cells may be in one bucket.
  template <class Test>
  void for_each_pair(const BoxTable<T>& boxes, Test& test) const {
    for (std::size_t b = 0; b + 1 < start_.size(); ++b) {
      const Item* const end = items_.data() + start_[b + 1];
      for (const Item* i = items_.data() + start_[b]; i < end; ++i)
        for (const Item* j = i + 1; j < end; ++j)
          if (i->cell == j->cell && first_common(lowest_cell(i->place), lowest_cell(j->place)) == i->cell)
            test(i->place, j->place);
    }
    for (const std::uint32_t i : large())
      for (std::uint32_t j = 0; j < boxes.size(); ++j)
        if (j < i || !is_large(j)) test(i, j);
  }

  /// The cells with something in them, in the order of their coordinates.
  void parts(std::vector<BroadPhasePart<T>>& out) const {
    std::vector<Cell> cells;
    cells.reserve(items_.size());
    for (const Item& item : items_) cells.push_back(item.cell);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    for (const Cell& cell : cells) {
      Aabb<T> box;
      for (std::size_t i = 0; i < 3; ++i) {
        box.lower[i] = static_cast<T>(static_cast<double>(cell[i]) * cell_);
        box.upper[i] = static_cast<T>((static_cast<double>(cell[i]) + 1) * cell_);
      }
      out.push_back({box, 0});
    }
  }

  std::size_t memory() const {
    return lengths_.capacity() * sizeof(double) + ranges_.capacity() * sizeof(CellRange) + is_large_.capacity() / 8 +
           items_.capacity() * sizeof(Item) + (start_.capacity() + large_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  /// Chooses the size of cells by the median of the boxes that have a length, which a few large boxes do not change.
  /// Points can only meet where they are equal, so that for points alone a small part of what they span will do.
  void choose_cell(const BoxTable<T>& boxes) {
    lengths_.clear();
    double farthest = 0;
    for (const auto& e : boxes) {
      const auto length = static_cast<double>(max_abs(e.box.extent()));
      const auto reach = static_cast<double>(max_abs(e.box.lower));
      if (length > 0 && length <= std::numeric_limits<double>::max()) lengths_.push_back(length);
      if (reach > farthest && reach <= std::numeric_limits<double>::max()) farthest = reach;
    }
    if (!lengths_.empty()) {
      const auto middle = lengths_.begin() + static_cast<std::ptrdiff_t>(lengths_.size() / 2);
      std::nth_element(lengths_.begin(), middle, lengths_.end());
      cell_ = cell_per_box * *middle;
    } else {
      cell_ = farthest / (static_cast<double>(boxes.size()) + 1);
    }
    cell_ = clamp(cell_, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
  }
  std::int64_t coordinate(T x) const {
    return static_cast<std::int64_t>(std::floor(clamp(static_cast<double>(x) / cell_, -farthest_cell, farthest_cell)));
  }

  /// Fills the buckets by counting sort; within one, items stand by place.
  void fill(std::size_t count) {
    bits_ = 1;
    while ((std::size_t(1) << bits_) < count) ++bits_;
    start_.assign((std::size_t(1) << bits_) + 1, 0);
    for_each_item([&](const Cell& cell, std::uint32_t) { ++start_[bucket(cell)]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start_) s = sum += s;
    items_.resize(count);
    for_each_item([&](const Cell& cell, std::uint32_t place) { items_[--start_[bucket(cell)]] = {cell, place}; });
  }
  template <class Visit>
  void for_each_item(const Visit& visit) const {
    for (std::uint32_t place = 0; place < ranges_.size(); ++place)
      if (!is_large(place)) ranges_[place].for_each([&](const Cell& cell) { visit(cell, place); });
  }
  std::size_t bucket(const Cell& cell) const { return static_cast<std::size_t>(hash(cell) >> (64 - bits_)); }

  double cell_ = 1;
  unsigned bits_ = 1;                 ///< the logarithm of the number of buckets
  std::vector<CellRange> ranges_;     ///< of all boxes
  std::vector<Item> items_;           ///< by bucket
  std::vector<std::uint32_t> start_;  ///< of each bucket among the items, and their end
  std::vector<bool> is_large_;        ///< likewise
  std::vector<std::uint32_t> large_;
  std::vector<double> lengths_;  ///< kept for its storage
};

template <class T>
class HashedGrid final : public Rebuilt<T, Grid<T>> {
 public:
  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override {
    const Grid<T>& grid = this->index();
    const BoxTable<T>& boxes = this->boxes();
    out.clear();
    const auto accept = [&](const Aabb<T>& other) { return overlap(other, box); };
    const CellRange cells = grid.range(box);
    if (!(cells.count() <= grid.size())) return boxes.collect(out, accept);
    collect_large(grid, out, accept);
    cells.for_each([&](const Cell& cell) {
      grid.for_each_in(cell, [&](std::uint32_t place) {
        if (first_common(cells.low, grid.lowest_cell(place)) == cell && accept(boxes[place].box))
          out.push_back(boxes[place].id);
      });
    });
    std::sort(out.begin(), out.end());
  }

  /// Sweeps in steps of about a cell, so that few cells are visited beside the way.
  void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const override {
    const Grid<T>& grid = this->index();
    const BoxTable<T>& boxes = this->boxes();
    out.clear();
    const SweptBox<T> accept(box, motion);
    const double steps = std::ceil(static_cast<double>(max_abs(motion)) / grid.cell_size()) + 1;
    double visits = steps;
    const Aabb<T> wide = widened_for_sweep(box, motion);
    if (!has_finite_ends(wide)) return boxes.collect(out, accept);
    if (visits <= grid.size())
      for_each_step(grid, wide, motion, steps, [&](const CellRange& c) { visits += c.count(); });
    if (!(visits <= grid.size())) return boxes.collect(out, accept);
    collect_large(grid, out, accept);
    for_each_step(grid, wide, motion, steps, [&](const CellRange& cells) {
      cells.for_each([&](const Cell& cell) {
        grid.for_each_in(cell, [&](std::uint32_t place) {
          if (accept(boxes[place].box)) out.push_back(boxes[place].id);
        });
      });
    });
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

  void parts(std::vector<BroadPhasePart<T>>& out) const override {
    out.clear();
    this->index().parts(out);
  }

 private:
  template <class Accept>
  void collect_large(const Grid<T>& grid, std::vector<std::uint32_t>& out, const Accept& accept) const {
    for (const std::uint32_t place : grid.large())
      if (accept(this->boxes()[place].box)) out.push_back(this->boxes()[place].id);
  }

  /// Calls `visit(cells)` with the cells that the box passes through in each of `steps` equal times.
  template <class Visit>
  static void for_each_step(const Grid<T>& grid, const Aabb<T>& box, const Vec3<T>& motion, double steps,
                            const Visit& visit) {
    for (double step = 0; step < steps; ++step) {
      const Vec3<T> begin = motion * static_cast<T>(step / steps), end = motion * static_cast<T>((step + 1) / steps);
      visit(
          grid.range(merged(Aabb<T>{box.lower + begin, box.upper + begin}, Aabb<T>{box.lower + end, box.upper + end})));
    }
  }
};

}  // namespace

template <class T>
std::unique_ptr<BroadPhase<T>> make_hashed_grid() {
  return std::make_unique<HashedGrid<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_hashed_grid();
template std::unique_ptr<BroadPhase<double>> make_hashed_grid();

}  // namespace graze
