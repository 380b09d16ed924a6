#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"
#include "shape/placed_bounds.hpp"

namespace graze {

namespace {

/// Triangles are numbered in 32 bits, two a cell.
constexpr std::size_t most_heights = std::size_t{1} << 31;

template <class T>
void check(std::size_t columns, std::size_t rows, const std::vector<T>& heights) {
  if (columns < 2) throw InvalidValue("columns", "a whole number >= 2", std::to_string(columns));
  if (rows < 2) throw InvalidValue("rows", "a whole number >= 2", std::to_string(rows));
  // Checked by division, so that huge counts cannot overflow into a match.
  if (heights.size() / columns != rows || heights.size() % columns != 0)
    throw InvalidValue("heights",
                       "columns x rows = " + std::to_string(columns) + " x " + std::to_string(rows) + " values",
                       std::to_string(heights.size()));
  if (heights.size() > most_heights)
    throw InvalidValue("heights", "at most 2147483648 values", std::to_string(heights.size()));
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::isnan(heights[i])) continue;
    const char* const expectation =
        std::isinf(heights[i]) ? "a finite number or a hole" : validate::fault_of_coordinate(heights[i]);
    if (expectation) validate::fail("heights[" + std::to_string(i) + "]", expectation, static_cast<double>(heights[i]));
  }
}

/// The level of blocks above one of `columns` times `rows` blocks, each with its `span_of(column, row)`.
template <class T, class SpanOf>
typename HeightFieldData<T>::Level level_above(std::uint32_t columns, std::uint32_t rows, const SpanOf& span_of) {
  constexpr std::uint32_t side = HeightFieldData<T>::side;
  typename HeightFieldData<T>::Level level{(columns + side - 1) / side, (rows + side - 1) / side, {}};
  level.spans.resize(std::size_t{level.columns} * level.rows + 3);
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const auto span = span_of(c, r);
      auto& into = level.spans[std::size_t{r / side} * level.columns + c / side];
      into.low = least(into.low, span.low);
      into.high = greatest(into.high, span.high);
    }
  return level;
}

template <class T>
void build_pyramid(HeightFieldData<T>& data) {
  data.levels.push_back(level_above<T>(data.columns - 1, data.rows - 1,
                                       [&](std::uint32_t c, std::uint32_t r) { return data.cell(c, r); }));
  while (data.levels.back().columns > 1 || data.levels.back().rows > 1) {
    const auto& below = data.levels.back();
    auto above = level_above<T>(below.columns, below.rows, [&](std::uint32_t c, std::uint32_t r) {
      return below.spans[std::size_t{r} * below.columns + c];
    });
    data.levels.push_back(std::move(above));
  }
}

/// The pyramid of the data, which it points into: none of the data may move any more.
template <class T>
FieldPyramid<T> pyramid_of(const HeightFieldData<T>& data) {
  FieldPyramid<T> pyramid{
      data.heights.data(), data.heights.size(), data.columns, data.rows, data.spacing_x, data.spacing_z, 0, {}};
  static_assert(sizeof data.levels[0].spans[0] == 2 * sizeof(T));
  for (const auto& level : data.levels)
    pyramid.level[pyramid.levels++] = {&level.spans[0].low, level.columns, level.rows};
  return pyramid;
}

template <class T>
std::vector<T> with_holes(std::vector<T> heights, std::span<const std::uint8_t> holes) {
  if (holes.size() != heights.size())
    throw InvalidValue("holes", "as many flags as heights, " + std::to_string(heights.size()),
                       std::to_string(holes.size()));
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (holes[i] != 0) heights[i] = std::numeric_limits<T>::quiet_NaN();
  return heights;
}

}  // namespace

template <class T>
HeightField<T>::HeightField(std::size_t columns, std::size_t rows, std::vector<T> heights, T spacing_x, T spacing_z,
                            Sides sides) {
  check(columns, rows, heights);
  spacing_x = validate::size(spacing_x, "spacing[0]");
  spacing_z = validate::size(spacing_z, "spacing[1]");
  for (T& height : heights) height = validate::resolved(height);
  auto data = std::make_shared<HeightFieldData<T>>();
  data->columns = static_cast<std::uint32_t>(columns);
  data->rows = static_cast<std::uint32_t>(rows);
  data->sides = sides;
  data->spacing_x = spacing_x;
  data->spacing_z = spacing_z;
  data->heights = std::move(heights);
  // Corners are coordinates like any others.
  const std::string most =
      "a field that reaches at most " + validate::number(static_cast<double>(largest_magnitude<T>));
  if (!(data->x(data->columns - 1) <= largest_magnitude<T>))
    validate::fail("spacing[0]", most, static_cast<double>(spacing_x));
  if (!(data->z(data->rows - 1) <= largest_magnitude<T>))
    validate::fail("spacing[1]", most, static_cast<double>(spacing_z));
  build_pyramid(*data);
  const auto& top = data->levels.back().spans[0];
  if (top.low > top.high) throw InvalidValue("heights", "at least one cell without a hole", "none");
  data->all = data->box(data->root());
  // The furthest corner of the bounds, which a corner of the field need not reach.
  data->extent = length(greatest(abs(data->all.lower), abs(data->all.upper)));
  data->radius = ball_radius(data->all);
  data->pyramid = pyramid_of(*data);
  data_ = std::move(data);
}

template <class T>
HeightField<T>::HeightField(std::size_t columns, std::size_t rows, std::vector<T> heights,
                            std::span<const std::uint8_t> holes, T spacing_x, T spacing_z, Sides sides)
    : HeightField(columns, rows, with_holes(std::move(heights), holes), spacing_x, spacing_z, sides) {}

template <class T>
std::size_t HeightField<T>::columns() const {
  return data_->columns;
}
template <class T>
std::size_t HeightField<T>::rows() const {
  return data_->rows;
}
template <class T>
T HeightField<T>::spacing_x() const {
  return data_->spacing_x;
}
template <class T>
T HeightField<T>::spacing_z() const {
  return data_->spacing_z;
}
template <class T>
Sides HeightField<T>::sides() const {
  return data_->sides;
}
template <class T>
std::span<const T> HeightField<T>::heights() const {
  return data_->heights;
}
template <class T>
bool HeightField<T>::hole(std::size_t column, std::size_t row) const {
  return std::isnan(data_->heights[row * data_->columns + column]);
}
template <class T>
std::uint32_t HeightField<T>::triangle_numbers() const {
  return 2 * (data_->columns - 1) * (data_->rows - 1);
}
template <class T>
bool HeightField<T>::has_triangle(std::uint32_t number) const {
  const std::uint32_t at = number / 2, across = data_->columns - 1;
  if (at / across >= data_->rows - 1) return false;
  const auto span = data_->cell(at % across, at / across);
  return span.low <= span.high;
}
template <class T>
std::array<Vec3<T>, 3> HeightField<T>::triangle(std::uint32_t number) const {
  return data_->triangle(number);
}
template <class T>
T HeightField<T>::core_extent() const {
  return data_->extent;
}
template <class T>
Aabb<T> HeightField<T>::core_bounds(const Pose<T>& pose) const {
  return placed_bounds(*data_, pose, [&](std::uint32_t i) {
    std::array<Vec3<T>, 3> corners = data_->triangle(i);
    for (Vec3<T>& p : corners) p = transform(pose, p);
    return bounds_of(corners);
  });
}

template class HeightField<float>;
template class HeightField<double>;

}  // namespace graze
