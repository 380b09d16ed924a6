// Drawings as scenes of the plane, from their elements.
#pragma once

#include <string>

#include "graze/io/plane_scene.hpp"
#include "io/xml_element.hpp"

namespace graze::io {

/// The scene that an `<svg>` element draws. Throws `InvalidValue` that names the source, and element and attribute.
PlaneScene read_svg(const XmlElement& root, const std::string& source_name);

}  // namespace graze::io
