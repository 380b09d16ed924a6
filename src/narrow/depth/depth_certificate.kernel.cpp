#include "narrow/depth/depth_certificate.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

#include "simd/lanes.hpp"

// The directions are divided into cells, a sector of tangents and an interval of s each, a cell a lane; each term is
// bounded by its least value in the cell. A cell left in doubt is cut, both ways into four or, where its interval has
// no end, its tangents into two (branch and bound).

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;

/// Number of cells tested at once, equal at every level, so that each comes to the same doubts.
constexpr std::size_t cells_at_once = 8;
constexpr auto step = static_cast<std::size_t>(S::lanes);
/// Largest number of cuts of a cell: to sectors of a fifth of a degree. A direction still in doubt then has about as
/// little overlap as the one found.
constexpr int cuts = 8;
/// Most proofs take four to ten bundles of cells; one with this many takes twice as long as EPA.
constexpr int most_bundles = 400;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Values of s beyond which directions are treated as one, up to the opposite of n; below it in these intervals.
constexpr double far_away = 8;
constexpr double ends[] = {0, 0.5, 2, far_away};

class Cells {
 public:
  /// Capacity. The last cells are cut first, so that of each size at most those of one cut bundle are left.
  static constexpr std::size_t room = 3 * cells_at_once + cuts * 4 * cells_at_once;

  bool empty() const { return count_ == 0; }

  /// Adds all tangents, in eight sectors.
  [[gnu::always_inline]] void add_around(double from, double to) {
    constexpr double h = 0.70710678118654752440;
    constexpr double cosines[] = {1, h, 0, -h, -1, -h, 0, h};
    const auto tangent = [&](std::size_t i) -> PolarTangent { return {cosines[i % 8], cosines[(i + 6) % 8]}; };
    for (std::size_t i = 0; i < cells_at_once; ++i) add(tangent(i), tangent(i + 1), from, to, 0);
  }

  /// Takes the last cells, up to `cells_at_once`; they stay readable until others are added.
  [[gnu::always_inline]] std::size_t take() {
    const std::size_t taken = count_ < cells_at_once ? count_ : cells_at_once;
    count_ -= taken;
    return taken;
  }
  std::size_t begin() const { return count_; }

  /// The numbers of a register of cells from the `first` on.
  struct Bundle {
    S u0, v0, u1, v1, from, to;
  };
  [[gnu::always_inline]] Bundle bundle(std::size_t first) const {
    return {S::load(u0_ + first), S::load(v0_ + first),   S::load(u1_ + first),
            S::load(v1_ + first), S::load(from_ + first), S::load(to_ + first)};
  }

  struct Cell {
    PolarTangent first, last;
    double from, to;
    int cuts;
  };
  [[gnu::always_inline]] Cell cell(std::size_t i) const {
    return {{u0_[i], v0_[i]}, {u1_[i], v1_[i]}, from_[i], to_[i], cuts_[i]};
  }

  [[gnu::always_inline]] void add(const PolarTangent& first, const PolarTangent& last, double from, double to,
                                  int cut) {
    u0_[count_] = first.u;
    v0_[count_] = first.v;
    u1_[count_] = last.u;
    v1_[count_] = last.v;
    from_[count_] = from;
    to_[count_] = to;
    cuts_[count_++] = static_cast<std::int8_t>(cut);
  }

 private:
  std::size_t count_ = 0;
  alignas(64) double u0_[room], v0_[room], u1_[room], v1_[room], from_[room], to_[room];
  std::int8_t cuts_[room];
};

/// The tangents between two, in the triangle of both and of the intersection of their tangent lines, which bounds
/// linear terms.
struct Sector {
  S u0, v0, u1, v1;
  S meet;  ///< intersection of the tangent lines, as a multiple of the sum of both tangents

  [[gnu::always_inline]] Sector(const S& a_u, const S& a_v, const S& b_u, const S& b_v)
      : u0(a_u), v0(a_v), u1(b_u), v1(b_v), meet(S(1) / (S(1) + a_u * b_u + a_v * b_v)) {}

  [[gnu::always_inline]] S highest(const PolarTangent& x) const {
    const S a = S(x.u) * u0 + S(x.v) * v0, b = S(x.u) * u1 + S(x.v) * v1;
    return greatest(greatest(a, b), (a + b) * meet);
  }
  [[gnu::always_inline]] S lowest(const PolarTangent& x) const { return -highest({-x.u, -x.v}); }
  /// The least slope over a crease.
  [[gnu::always_inline]] S slope_over(const PolarTerms::Crease& c) const {
    const S a = S(c.axis.u) * u0 + S(c.axis.v) * v0, b = S(c.axis.u) * u1 + S(c.axis.v) * v1, zero(0);
    const S up = least(a, b) * S(c.up), down = -greatest(a, b) * S(c.down);
    return select((a > zero) & (b > zero), up, select((a < zero) & (b < zero), down, zero));
  }
};

/// The sector of the doubled angles, in which forms are linear.
[[gnu::always_inline]] inline Sector twice(const Sector& s) {
  return {s.u0 * s.u0 - s.v0 * s.v0, S(2) * s.u0 * s.v0, s.u1 * s.u1 - s.v1 * s.v1, S(2) * s.u1 * s.v1};
}

/// The cells in which j s - depth s^2 + sum of e, divided by s, is nowhere negative.
[[gnu::always_inline]] inline S::Mask holds_between(const PolarTerms& terms, const Cells::Bundle& cell) {
  const S zero(0);
  const Sector sector(cell.u0, cell.v0, cell.u1, cell.v1), doubled = twice(sector);
  S slope(0);
  if (terms.cap > 0) slope = greatest(zero, S(terms.cap) + sector.lowest(terms.cap_slope));
  for (const PolarTerms::Crease& c : terms.creases) slope += sector.slope_over(c);
  // A segment's term grows with s; close to s = 0 only one perpendicular to n has any.
  const S turned = cell.from - S(1) / greatest(cell.from, S(std::numeric_limits<double>::min()));
  for (const PolarTerms::Segment& s : terms.segments)
    slope += S(s.half) * greatest(zero, S(s.along) * turned - S(2) * sector.highest(s.axis));
  const auto by_least_bend = slope >= cell.to * S(terms.depth - terms.least_bend);
  S bend(0);
  for (const PolarTerms::Round& r : terms.rounds) {
    // A form is its mean and a linear term in the doubled angle.
    const TangentForm& f = r.across;
    const PolarTangent swing{(f.uu - f.vv) * 0.5, f.uv};
    const S mean((f.uu + f.vv) * 0.5), point = sector.highest(r.point);
    const S least_across = greatest(zero, mean + doubled.lowest(swing)), most_across = mean + doubled.highest(swing);
    // The maximum of X, which is concave in s.
    const S top = least(cell.to, greatest(cell.from, point / S(r.extent)));
    const S x = S(r.extent) * (S(1) - top * top) + S(2) * top * point, y = S(4) * cell.to * cell.to * most_across;
    const S root = sqrt(x * x + y), below = select(x > zero, root + x, y / (root - x));
    const S bends = select(below > zero, S(2) * least_across / below, zero);
    // Beyond the face of a disc, sqrt(X^2 + Y^2) - X is no less than -2 X.
    const auto over = -x > bends * cell.to * cell.to;
    slope = select(over, slope - x / cell.to, slope);
    bend = select(over, bend, bend + bends);
  }
  return by_least_bend | (slope >= cell.to * (S(terms.depth) - bend));
}

/// The cells in which it, divided by s^2, is nowhere negative from the start of the interval up to the opposite of n.
[[gnu::always_inline]] inline S::Mask holds_beyond(const PolarTerms& terms, const Cells::Bundle& cell) {
  const Sector sector(cell.u0, cell.v0, cell.u1, cell.v1);
  const S zero(0), turned = S(1) - S(1) / (cell.from * cell.from);
  S bend(0);
  for (const PolarTerms::Round& r : terms.rounds)
    bend += greatest(zero, S(r.extent) * turned - S(2) * greatest(zero, sector.highest(r.point)) / cell.from);
  for (const PolarTerms::Segment& s : terms.segments)
    bend += S(s.half) * greatest(zero, S(s.along) * turned - S(2) * greatest(zero, sector.highest(s.axis)) / cell.from);
  return bend >= S(terms.depth);
}

/// Cuts a cell; or sets its middle as the doubt and returns false.
[[gnu::always_inline]] inline bool cut(const Cells::Cell& c, Cells& cells, PolarDoubt& doubt) {
  const double scale = 1 / std::sqrt(2 + 2 * (c.first.u * c.last.u + c.first.v * c.last.v));
  const PolarTangent middle{(c.first.u + c.last.u) * scale, (c.first.v + c.last.v) * scale};
  const bool endless = c.to == infinity;
  const double half = endless ? 2 * c.from : (c.from + c.to) * 0.5;
  if (c.cuts == cuts) {
    doubt = {middle, half};
    return false;
  }
  for (int i = 0; i < (endless ? 1 : 2); ++i) {
    const double from = i == 0 ? c.from : half, to = i == 0 && !endless ? half : c.to;
    cells.add(c.first, middle, from, to, c.cuts + 1);
    cells.add(middle, c.last, from, to, c.cuts + 1);
  }
  return true;
}

/// Whether all cells hold, the last ones first; tests no more than `left` bundles, which it counts down.
template <class Holds>
[[gnu::always_inline]] inline bool all_hold(Cells& cells, const Holds& holds, int& left, PolarDoubt& doubt) {
  while (!cells.empty()) {
    if (left-- == 0) return false;
    const std::size_t taken = cells.take(), begin = cells.begin();
    std::uint32_t open = 0;
    for (std::size_t i = 0; i < taken; i += step) open |= bits_of(!holds(cells.bundle(begin + i))) << i;
    open &= (1u << taken) - 1;
    if (open == 0) continue;
    Cells::Cell doubtful[cells_at_once];
    std::size_t count = 0;
    for (std::size_t i = 0; i < taken; ++i)
      if (open >> i & 1) doubtful[count++] = cells.cell(begin + i);
    for (std::size_t i = 0; i < count; ++i)
      if (!cut(doubtful[i], cells, doubt)) return false;
  }
  return true;
}

}  // namespace

[[gnu::flatten]] bool no_less_around(const PolarTerms& terms, PolarDoubt& doubt) {
  doubt = {{0, 0}, 0};
  int left = most_bundles;
  Cells cells;
  cells.add_around(far_away, infinity);
  const auto beyond = [&](const Cells::Bundle& bundle) { return holds_beyond(terms, bundle); };
  if (!all_hold(cells, beyond, left, doubt)) return false;
  for (std::size_t i = 0; i + 1 < std::size(ends); ++i) cells.add_around(ends[i], ends[i + 1]);
  const auto between = [&](const Cells::Bundle& bundle) { return holds_between(terms, bundle); };
  return all_hold(cells, between, left, doubt);
}

}  // namespace graze::GRAZE_ISA
