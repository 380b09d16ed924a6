// How much a test tries may be asked for in the environment.
#pragma once

#include <cstdlib>

namespace graze::testing {

/// The number that an environment variable holds, or another where there is none.
inline int asked_number(const char* variable, int otherwise) {
  const char* asked = std::getenv(variable);
  return asked ? std::atoi(asked) : otherwise;
}

}  // namespace graze::testing
