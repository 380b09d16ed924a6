// The parts of the C interface that both scalars share: the last error, the version, default
// filters, heads of captures.
#include <cstring>

#include "c/arguments.hpp"
#include "c/capture.hpp"
#include "c/error.hpp"

namespace graze::c {

namespace {

constexpr std::size_t longest_message = 1024;
thread_local char last_message[longest_message] = "";

}  // namespace

GrazeStatus failed(GrazeStatus status, const char* message) noexcept {
  const std::size_t length = std::strlen(message);
  const std::size_t kept = length < longest_message ? length : longest_message - 1;
  std::memcpy(last_message, message, kept);
  last_message[kept] = '\0';
  return status;
}

}  // namespace graze::c

extern "C" {

const char* graze_last_error(void) { return graze::c::last_message; }

std::uint32_t graze_version(void) { return GRAZE_VERSION; }

const char* graze_version_string(void) { return GRAZE_VERSION_STRING; }

GrazeFilter graze_filter_default(void) { return {1, ~std::uint64_t{0}, 0}; }

GrazeQueryFilter graze_query_filter_default(void) { return {graze_filter_default(), false, nullptr, nullptr}; }

GrazeStatus graze_capture_head(const void* bytes, std::size_t size, GrazeCaptureHead* head) {
  return graze::c::guarded([&] {
    graze::c::given(head, "head");
    const auto from = graze::c::frames_of(bytes, size).head();
    *head = {graze::capture::is_simulation(from.kind), graze::capture::is_of_plane(from.kind), from.single};
  });
}

}  // extern "C"
