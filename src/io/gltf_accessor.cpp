#include "io/gltf_accessor.hpp"

#include <tiny_gltf.h>

#include <cstring>
#include <limits>

namespace graze::io {

namespace {

/// `count` elements of `size` bytes each, from `offset` on in a buffer view.
struct Range {
  std::size_t offset, count, size;
};

struct Strided {
  const unsigned char* begin;
  std::size_t stride;
};

/// The place of a range; `view_path` and `count_path` are named when it does not fit.
Strided located(const tinygltf::Model& model, std::size_t view_index, const Range& range, const std::string& view_path,
                const std::string& count_path) {
  if (view_index >= model.bufferViews.size())
    throw InvalidValue(view_path, "an index below " + std::to_string(model.bufferViews.size()),
                       std::to_string(view_index));
  const tinygltf::BufferView& view = model.bufferViews[view_index];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
    throw InvalidValue(view_path + ".buffer", "an index below " + std::to_string(model.buffers.size()),
                       std::to_string(view.buffer));
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    throw InvalidValue(view_path, "a range within the " + std::to_string(data.size()) + " bytes of its buffer",
                       std::to_string(view.byteOffset) + " + " + std::to_string(view.byteLength));
  if (view.byteStride != 0 && view.byteStride < range.size)
    throw InvalidValue("bufferViews[" + std::to_string(view_index) + "].byteStride",
                       "at least the " + std::to_string(range.size) + " bytes of an element",
                       std::to_string(view.byteStride));
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : range.size;
  // `count` elements end at offset + (count - 1) stride + size; by division, since the product may overflow.
  const std::size_t room = view.byteLength;
  const bool fits = range.count == 0 || (range.offset <= room && range.size <= room - range.offset &&
                                         (range.count - 1) <= (room - range.offset - range.size) / stride);
  if (!fits) throw InvalidValue(count_path, "as many elements as its buffer view holds", std::to_string(range.count));
  // Without elements the offset was not checked, and an address beyond the data must not even be formed.
  return {range.count == 0 ? data.data() : data.data() + view.byteOffset + range.offset, stride};
}

std::uint32_t whole_at(const unsigned char* at, std::size_t size) {
  std::uint16_t half = 0;
  std::uint32_t full = 0;
  if (size == 1) return *at;
  if (size == 2) return std::memcpy(&half, at, 2), half;
  return std::memcpy(&full, at, 4), full;
}

/// The number of components of an element, and the name of its type.
std::size_t width_of(int type) { return type == TINYGLTF_TYPE_VEC4 ? 4 : type == TINYGLTF_TYPE_VEC3 ? 3 : 1; }
const char* name_of(int type) {
  return type == TINYGLTF_TYPE_VEC4 ? "\"VEC4\"" : type == TINYGLTF_TYPE_VEC3 ? "\"VEC3\"" : "\"SCALAR\"";
}

template <class C>
float fraction_at(const unsigned char* at) {
  C value{};
  std::memcpy(&value, at, sizeof value);
  return greatest(static_cast<float>(value) / static_cast<float>(std::numeric_limits<C>::max()), -1.0F);
}

/// The size of the indices of a sparse accessor.
std::size_t index_size(const JsonValue& component) {
  switch (component.whole_number()) {
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return 4;
  default: component.fail("5121, 5123 or 5125 (unsigned byte, short or int)");
  }
}

/// The indices or the values of a sparse accessor: these lie without gaps.
const unsigned char* packed(const tinygltf::Model& model, const JsonValue& part, const JsonValue& count,
                            std::size_t size) {
  const JsonValue view = part.at("bufferView");
  const auto offset = part.find("byteOffset");
  const Range range{offset ? offset->whole_number() : 0, count.whole_number(), size};
  const Strided place = located(model, view.whole_number(), range, view.path(), count.path());
  if (model.bufferViews[view.whole_number()].byteStride != 0)
    view.fail("a buffer view without byteStride, for a sparse accessor");
  return place.begin;
}

}  // namespace

Elements::Elements(const AccessorSource& source, int index, int wanted_type, const std::string& path) {
  const tinygltf::Model& model = source.model;
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
    throw InvalidValue(path, "an index below " + std::to_string(model.accessors.size()), std::to_string(index));
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const std::string name = "accessors[" + std::to_string(index) + "]";
  if (accessor.type != wanted_type) throw InvalidValue(name + ".type", name_of(wanted_type), "another");
  component_ = accessor.componentType;
  normalized_ = accessor.normalized;
  count_ = accessor.count;
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_));
  if (size <= 0) throw InvalidValue(name + ".componentType", "a component type of glTF", std::to_string(component_));
  element_ = static_cast<std::size_t>(size) * width_of(wanted_type);
  if (accessor.sparse.isSparse) {
    read_sparse(source, {source.json.at("accessors").at(static_cast<std::size_t>(index)), name});
    return;
  }
  const std::string view_path = name + ".bufferView";
  if (accessor.bufferView < 0) throw InvalidValue(view_path, "a value, of an accessor that is not sparse", "nothing");
  const Strided place = located(model, static_cast<std::size_t>(accessor.bufferView),
                                {accessor.byteOffset, count_, element_}, view_path, name + ".count");
  begin_ = place.begin;
  stride_ = place.stride;
}

void Elements::read_sparse(const AccessorSource& source, const JsonValue& accessor) {
  const JsonValue sparse = accessor.at("sparse"), count = sparse.at("count");
  const std::size_t replacements = count.whole_number();
  if (replacements < 1 || replacements > count_)
    count.fail("a whole number from 1 to the " + std::to_string(count_) + " of " + accessor.path());
  const JsonValue indices = sparse.at("indices"), values = sparse.at("values");
  const std::size_t width = index_size(indices.at("componentType"));
  const unsigned char* index = packed(source.model, indices, count, width);
  const unsigned char* value = packed(source.model, values, count, element_);

  if (const auto view = accessor.find("bufferView")) {
    const auto offset = accessor.find("byteOffset");
    const Range range{offset ? offset->whole_number() : 0, count_, element_};
    const Strided base = located(source.model, view->whole_number(), range, view->path(), accessor.path() + ".count");
    replaced_.resize(count_ * element_);
    for (std::size_t i = 0; i < count_; ++i)
      std::memcpy(replaced_.data() + i * element_, base.begin + i * base.stride, element_);
  } else {
    if (count_ > source.zeros_left)
      throw InvalidValue(accessor.path() + ".count",
                         "at most " + std::to_string(source.zeros_left) + " without a buffer view (of " +
                             std::to_string(max_zero_elements) + " in a file)",
                         std::to_string(count_));
    source.zeros_left -= count_;
    replaced_.resize(count_ * element_);
  }

  std::size_t next = 0;  // one more than the index before
  for (std::size_t i = 0; i < replacements; ++i) {
    const std::size_t at = whole_at(index + i * width, width);
    const std::string path = indices.path() + "[" + std::to_string(i) + "]";
    if (at >= count_) throw InvalidValue(path, "an index below " + std::to_string(count_), std::to_string(at));
    if (at < next)
      throw InvalidValue(path, "an index above the one before, " + std::to_string(next - 1), std::to_string(at));
    std::memcpy(replaced_.data() + at * element_, value + i * element_, element_);
    next = at + 1;
  }
  begin_ = replaced_.data();
  stride_ = element_;
}

Vec3d Elements::vector(std::size_t i) const {
  float v[3];
  std::memcpy(v, begin_ + i * stride_, sizeof v);
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

std::uint32_t Elements::whole(std::size_t i) const { return whole_at(begin_ + i * stride_, element_); }

bool Elements::is_float() const { return component_ == TINYGLTF_COMPONENT_TYPE_FLOAT; }

bool Elements::fractional() const {
  if (is_float()) return true;
  return normalized_ && component_ >= TINYGLTF_COMPONENT_TYPE_BYTE &&
         component_ <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
}

/// A component by glTF 2.0, section 3.6.2.2: integers over their greatest; the least of the signed ones counts as -1.
float Elements::number(std::size_t i, std::size_t k) const {
  const unsigned char* element = begin_ + i * stride_;
  switch (component_) {
  case TINYGLTF_COMPONENT_TYPE_BYTE: return fraction_at<std::int8_t>(element + k);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return fraction_at<std::uint8_t>(element + k);
  case TINYGLTF_COMPONENT_TYPE_SHORT: return fraction_at<std::int16_t>(element + 2 * k);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return fraction_at<std::uint16_t>(element + 2 * k);
  default: break;
  }
  float value = 0;
  std::memcpy(&value, element + 4 * k, sizeof value);
  return value;
}

}  // namespace graze::io
