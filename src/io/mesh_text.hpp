// OBJ and STL files looked through before assimp reads them.
//
// Guarantee: what passes holds no count that the file does not pay for, no number that is not one and no index of
// nothing; what does not is refused by line, value and expectation, of which assimp names none.
#pragma once

#include <string_view>

namespace graze::io {

/// Points (`v`), faces (`f`) and their indices. Throws `InvalidValue`.
void check_obj(std::string_view text);

/// The triangle count of a binary file, the vertices of a text. Throws `InvalidValue`.
void check_stl(std::string_view bytes);

}  // namespace graze::io
