// XML as a tree of elements, as a reader of drawings needs it, whatever parser made it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace graze::io {

/// The deepest nesting of elements, so that functions may call themselves for those inside.
inline constexpr int most_xml_depth = 100;

struct XmlElement {
  std::string name;      ///< without the prefix of its namespace
  std::size_t line = 0;  ///< of its beginning, counted from 1; 0 where it is not known
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;

  /// The value of an attribute, or null.
  const std::string* attribute(std::string_view of) const {
    for (const auto& [key, value] : attributes)
      if (key == of) return &value;
    return nullptr;
  }
};

/// The root element of a document. Throws `InvalidValue` with the line for a text that is no XML, or nested too deep.
/// Expands no entities but the five of XML itself.
XmlElement read_xml(const std::string& bytes);

}  // namespace graze::io
