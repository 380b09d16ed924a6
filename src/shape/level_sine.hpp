// The angle up to which triangles of a surface lie level.
#pragma once

namespace graze {

/// The sine of the angle between normals below which triangles lie level: an eighth of that below which a contact's
/// normal counts as that of a face, so that any other is none of the surface's.
template <class T>
inline constexpr T level_sine = T(2.5e-5);

}  // namespace graze
