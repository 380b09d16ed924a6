// A picture of the ownership of a scene's bodies, put together from the drawings of each owner, as SVG.
//
// Guarantee: any scene gives a picture, however large it is: bodies smaller than a few pixels, and in a scene of many
// bodies all but the large ones, are squares, and of squares in one place the nearest to the viewer stays.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/shape.hpp"

namespace graze::io {

/// A drawing that many processes make together: each draws its own bodies, one gathers and writes it.
class GRAZE_API OwnersPicture {
 public:
  /// A picture of the region `whole`, seen against `direction` (towards the viewer; not zero), orthographic, Y up, of
  /// so many bodies in all. All owners pass the same arguments. Throws `InvalidValue` for an invalid direction.
  OwnersPicture(const Aabbd& whole, const Vec3d& direction, std::uint64_t bodies);

  /// Draws a shape in the colour of its owner, paler if it is fixed.
  void add(const Shaped& shape, const Posed& pose, bool fixed, std::uint32_t owner);

  /// The drawing as bytes for another process.
  std::string packed() const;
  /// Adds the drawing of another process. Throws `InvalidValue` for bytes that `packed` did not make.
  void add_packed(std::string_view bytes);

  /// An owner: its share in words, and the bounds of its region.
  struct Owner {
    std::string words;  ///< its line in the legend
    Aabbd region;       ///< its part of space, drawn as a frame
  };
  /// The picture of everything drawn and added, with a title and a legend of its owners, as SVG.
  std::string svg(const std::string& title, const std::vector<Owner>& owners) const;

 private:
  struct Face {
    double depth = 0;
    bool background = false;
    std::string text;
  };
  using Place = std::array<std::int32_t, 3>;  ///< place of a square: binary logarithm of its side, column and row
  void add_square(const Place& place, Face face);

  Aabbd whole_;
  Vec3d direction_;
  double smallest_;  ///< pixels below which a body is a square
  std::vector<Face> faces_;
  std::map<Place, Face> squares_;
};

}  // namespace graze::io
