// Labels beside points of a picture, none upon another.
#pragma once

#include <string>
#include <vector>

namespace graze::io {

/// Finds a place for each label near its point, where it covers no other label and no point.
class Labels {
 public:
  /// A point that is to stay visible, before any label is placed.
  void keep_clear(double x, double y, double radius);

  /// The label as SVG: beside its point, or further away with a line to it where all is taken nearby.
  std::string at(double x, double y, const std::string& words);

 private:
  struct Rectangle {
    double x0, y0, x1, y1;
  };
  bool free(const Rectangle& wanted) const;

  std::vector<Rectangle> taken_;
};

}  // namespace graze::io
