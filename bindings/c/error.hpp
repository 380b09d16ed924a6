// The end of exceptions: each function of the C interface does its work inside `guarded`.
//
// Guarantee: nothing is thrown, whatever the work throws; the message of the last failure is the thread's own and takes
// no memory that could be missing.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "graze/error.hpp"
#include "graze/graze.h"

namespace graze::c {

/// Keeps `message` (or as much as there is room for) as the thread's last error; returns `status`.
GrazeStatus failed(GrazeStatus status, const char* message) noexcept;

/// The status of `work`: GRAZE_OK, or that of the exception that it threw. Where the library is compiled without
/// exceptions, a value that is refused ends the program, as it does for C++.
template <class F>
GrazeStatus guarded(const F& work) noexcept {
#ifdef __cpp_exceptions
  try {
    work();
    return GRAZE_OK;
  } catch (const InvalidValue& error) {
    return failed(GRAZE_INVALID_VALUE, error.what());
  } catch (const std::bad_alloc&) {
    return failed(GRAZE_OUT_OF_MEMORY, "memory: there is not enough");
  } catch (const std::length_error&) {
    return failed(GRAZE_OUT_OF_MEMORY, "memory: there is not enough for that many elements");
  } catch (const std::exception& error) {
    return failed(GRAZE_FAILED, error.what());
  } catch (...) {
    return failed(GRAZE_FAILED, "a callback threw something that is no std::exception");
  }
#else
  work();
  return GRAZE_OK;
#endif
}

}  // namespace graze::c
