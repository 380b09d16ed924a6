// A picture of who owns what of a scene, put together from what each owner draws by itself, as SVG.
//
// Guarantee: any scene gives a picture, however large it is: what would be smaller than a few pixels, and in a scene of
// many bodies all that is not large, is a square, and of squares in one place the nearest to the viewer stays.
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
  /// A picture of what stands within `whole`, as seen against `direction` (towards the viewer; not zero), orthographic,
  /// Y up, of so many bodies in all. All owners say the same. Throws `InvalidValue` for a direction that is none.
  OwnersPicture(const Aabbd& whole, const Vec3d& direction, std::uint64_t bodies);

  /// Draws a shape in the colour of its owner, paler where it does not move.
  void add(const Shaped& shape, const Posed& pose, bool fixed, std::uint32_t owner);

  /// What was drawn here, as bytes for another process.
  std::string packed() const;
  /// Adds what another process has drawn. Throws `InvalidValue` for bytes that are none of `packed`.
  void add_packed(std::string_view bytes);

  /// Whose share is how large, in words, and where its region of space ends.
  struct Owner {
    std::string words;  ///< its line in the legend
    Aabbd region;       ///< its part of space, drawn as a frame
  };
  /// The picture of all that was drawn and added, with a title and a legend of its owners, as SVG.
  std::string svg(const std::string& title, const std::vector<Owner>& owners) const;

 private:
  struct Face {
    double depth = 0;
    bool background = false;
    std::string text;
  };
  using Place = std::array<std::int32_t, 3>;  ///< of a square: binary logarithm of its side, column and row
  void add_square(const Place& place, Face face);

  Aabbd whole_;
  Vec3d direction_;
  double smallest_;  ///< pixels below which a body is a square
  std::vector<Face> faces_;
  std::map<Place, Face> squares_;
};

}  // namespace graze::io
