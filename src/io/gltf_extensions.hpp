// The extensions of glTF that a file requires of its readers.
//
// Guarantee: a file whose required extensions would change what collides or moves is refused, or read as they say. What
// they change for the eye alone is left out.
#pragma once

#include <optional>

#include "io/json_value.hpp"

namespace graze::io {

/// Checks `extensionsRequired` of a file. Throws `InvalidValue` for one that is neither read nor without a meaning for
/// colliders and bodies. Those of `required_of_meshes` pass, as they do not matter to files whose meshes are not read.
void check_required_extensions(const JsonValue& root);

/// The first required extension that says how meshes are stored or repeated and is not read, or nothing.
std::optional<JsonValue> required_of_meshes(const JsonValue& root);

}  // namespace graze::io
