// Shapes that the query protocol describes, for JavaScript, in the manner of the C interface.
#include <atomic>

#include "c/arguments.hpp"
#include "io/plane_question.hpp"
#include "io/question.hpp"
#include "scalar.hpp"

#include "c/plane_shape_handle.inc"
#include "c/shape_handle.inc"

namespace {

/// Makes a handle by `read`, a shape of a JSON text that ends with a zero.
template <class Handle, class Read>
GrazeStatus made(const char* text, Handle** shape, const Read& read) {
  return graze::c::guarded([&] {
    const graze::io::Json json = graze::io::parse_json(text);
    *shape = new Handle(read(graze::io::JsonValue(json, "shape")));
  });
}

}  // namespace

extern "C" {

EXPORTED("shape_of_text")
GrazeStatus graze_js_shape_of_text(const char* text, TYPE(Shape) * *shape) {
  return made(text, shape, graze::io::read_shape<T>);
}

EXPORTED("plane_shape_of_text")
GrazeStatus graze_js_plane_shape_of_text(const char* text, TYPE(PlaneShape) * *shape) {
  return made(text, shape, graze::io::read_plane_shape<T>);
}

}  // extern "C"
