// The one error type of the library.
//
// Guarantee: only builders (constructors of shapes, loaders, parsers) throw it, never a query; it names the value at
// fault as a path below the thing that was being built, what was expected there, and what was found.
#pragma once

#include <stdexcept>
#include <string>

#include "graze/standard.hpp"

namespace graze {

/// A value that is refused. `what()`: "path: expected expectation, got found", or "path: found" without an expectation.
class GRAZE_API InvalidValue : public std::invalid_argument {
 public:
  /// What was expected there.
  InvalidValue(const std::string& path, const std::string& expectation, const std::string& found);

  /// Which value is at fault.
  const std::string& path() const noexcept { return path_; }
  /// What was expected there.
  const std::string& expectation() const noexcept { return expectation_; }
  /// What was found instead.
  const std::string& found() const noexcept { return found_; }

  /// The same error seen from one level further out: the path becomes `outer.path` (or `outer[..]` before an index).
  InvalidValue below(const std::string& outer) const;

 private:
  std::string path_, expectation_, found_;
};

}  // namespace graze
