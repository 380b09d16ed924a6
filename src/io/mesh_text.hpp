// STL files looked through before assimp reads them.
//
// Guarantee: what passes holds no count that the file does not pay for and no number that is not one; what does not is
// refused by line, value and expectation, of which assimp names none.
#pragma once

#include <string_view>

namespace graze::io {

/// The triangle count of a binary file, the vertices of a text. Throws `InvalidValue`.
void check_stl(std::string_view bytes);

}  // namespace graze::io
