// A height field and the lowest and highest heights of its blocks, as plain data for kernels.
//
// Guarantee: behind each level's spans there is room for three more, so that four of a row may be read from any place.
#pragma once

#include <cstddef>
#include <cstdint>

namespace graze {

template <class T>
struct FieldPyramid {
  static constexpr std::uint32_t side = 4;      ///< a block has that many times that many of the level below
  static constexpr std::uint32_t deepest = 16;  ///< columns are fewer than four to that power
  struct Level {
    const T* spans;  ///< low and high of a block, row by row; low > high when all its cells are holes
    std::uint32_t columns, rows;
  };

  const T* heights;
  std::size_t count;
  std::uint32_t columns, rows;  ///< of heights
  T spacing_x, spacing_z;
  std::uint32_t levels;
  Level level[deepest];  ///< above the cells; the last is one block
};

}  // namespace graze
