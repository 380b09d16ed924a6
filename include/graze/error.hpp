// The one error type of the library.
//
// Guarantee: only builders (constructors of shapes, loaders, parsers) throw it, never a query; it names the value at
// fault as a path within the object that was being built, the expectation there, and the value found.
#pragma once

#include <stdexcept>
#include <string>

#include "graze/detail/standard.hpp"

namespace graze {

/// A refused value. `what()`: "path: expected expectation, got found", or "path: found" without an expectation.
class GRAZE_API InvalidValue : public std::invalid_argument {
 public:
  /// An error at `path`, where `expectation` was required and `found` was given.
  InvalidValue(const std::string& path, const std::string& expectation, const std::string& found);

  /// The path of the value at fault.
  const std::string& path() const noexcept { return path_; }
  /// The expectation at the path.
  const std::string& expectation() const noexcept { return expectation_; }
  /// The value that was found there.
  const std::string& found() const noexcept { return found_; }

  /// The error as seen from one level further out: the path becomes `outer.path` (or `outer[..]` before an index).
  InvalidValue below(const std::string& outer) const;

 private:
  std::string path_, expectation_, found_;
};

}  // namespace graze
