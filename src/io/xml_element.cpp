#include "io/xml_element.hpp"

#include <tinyxml2.h>

#include "graze/error.hpp"

namespace graze::io {

namespace {

std::string local(const char* qualified) {
  const std::string_view name = qualified;
  const std::size_t colon = name.find(':');
  return std::string(colon == std::string_view::npos ? name : name.substr(colon + 1));
}

/// An element with all those inside it, which are no deeper than the parser goes.
XmlElement element_of(const tinyxml2::XMLElement& from) {
  XmlElement made{local(from.Name()), static_cast<std::size_t>(from.GetLineNum()), {}, {}};
  for (const tinyxml2::XMLAttribute* a = from.FirstAttribute(); a; a = a->Next())
    made.attributes.emplace_back(a->Name(), a->Value());
  for (const tinyxml2::XMLElement* child = from.FirstChildElement(); child; child = child->NextSiblingElement())
    made.children.push_back(element_of(*child));
  return made;
}

}  // namespace

XmlElement read_xml(const std::string& bytes) {
  static_assert(TINYXML2_MAX_ELEMENT_DEPTH <= most_xml_depth);
  tinyxml2::XMLDocument document;
  if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS)
    throw InvalidValue("line " + std::to_string(document.ErrorLineNum()), "an XML document",
                       tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()));
  const tinyxml2::XMLElement* root = document.RootElement();
  return root ? element_of(*root) : XmlElement{};
}

}  // namespace graze::io
