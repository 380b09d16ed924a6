// The elements of a glTF accessor: a range of a buffer view, or zeros, some replaced by a sparse accessor.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graze/vec3.hpp"
#include "io/json_value.hpp"

namespace tinygltf {
class Model;
}

namespace graze::io {

/// The most elements that may be read from a file's sparse accessors without a buffer view, all together and as often
/// as they are read. Such elements are zeros for which the file has no bytes: without a limit a kilobyte would become
/// gigabytes, in one accessor or in many meshes of one. A million takes some 200 MB to load, and is more than any mesh
/// can need: all of its points but those that are replaced lie in the origin.
inline constexpr std::size_t max_zero_elements = std::size_t{1} << 20;

/// The file from which accessors are read.
struct AccessorSource {
  const tinygltf::Model& model;
  const Json& json;         ///< of the same file: says what is absent, and holds numbers that `model` narrows to an int
  std::size_t& zeros_left;  ///< of `max_zero_elements`
};

/// The elements of an accessor, every bound checked.
class Elements {
 public:
  /// `wanted_type`: TINYGLTF_TYPE_SCALAR, _VEC3 or _VEC4; `path`: of the index, for errors. Throws `InvalidValue`.
  Elements(const AccessorSource& source, int index, int wanted_type, const std::string& path);
  Elements(const Elements&) = delete;
  Elements& operator=(const Elements&) = delete;

  std::size_t count() const { return count_; }
  int component() const { return component_; }

  Vec3d vector(std::size_t i) const;
  std::uint32_t whole(std::size_t i) const;
  /// Whether `number` means something: the components are floats, or integers that stand for 0 to 1 or -1 to 1.
  bool fractional() const;
  bool is_float() const;
  /// The component `k` of an element.
  float number(std::size_t i, std::size_t k) const;

 private:
  void read_sparse(const AccessorSource& source, const JsonValue& accessor);

  const unsigned char* begin_ = nullptr;
  std::size_t count_ = 0, stride_ = 0, element_ = 0;
  int component_ = 0;
  bool normalized_ = false;
  std::vector<unsigned char> replaced_;  ///< the elements of a sparse accessor, which `begin_` points to
};

}  // namespace graze::io
