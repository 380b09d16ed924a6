#include "narrow/pairs/triangle_triangle.hpp"

namespace graze {

TriangleDistance<double> distance_of_triangles(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b,
                                               double enough) {
  return triangle_distance(a, b, enough);
}

}  // namespace graze
