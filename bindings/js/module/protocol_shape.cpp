// Shapes as JSON of the query protocol, for JavaScript, in the manner of the C interface.
#include <atomic>
#include <string>

#include "c/arguments.hpp"
#include "io/shape_writer.hpp"
#include "scalar.hpp"

#include "c/plane_shape_handle.inc"
#include "c/shape_handle.inc"

namespace {

std::string text;  ///< the last one

/// Gives the beginning of the shape's text, and its number of bytes.
template <class Handle>
GrazeStatus written(const Handle* shape, const char** first, std::size_t* count) {
  return graze::c::guarded([&] {
    graze::io::JsonWriter out;
    graze::io::write_shape(out, graze::c::opened(shape, "shape").value);
    text = out.take();
    *first = text.data();
    *count = text.size();
  });
}

}  // namespace

extern "C" {

EXPORTED("shape_text")
GrazeStatus graze_js_shape_text(const TYPE(Shape) * shape, const char** first, std::size_t* count) {
  return written(shape, first, count);
}

EXPORTED("plane_shape_text")
GrazeStatus graze_js_plane_shape_text(const TYPE(PlaneShape) * shape, const char** first, std::size_t* count) {
  return written(shape, first, count);
}

}  // extern "C"
