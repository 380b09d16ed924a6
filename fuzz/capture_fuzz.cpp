// Any bytes as a capture: played, or refused as `InvalidValue`. Most inputs are the calls of one frame, put into a file
// whose checksum fits, since no fuzzer would find that; the first byte says of what.
#include <cstdint>
#include <sstream>

#include "capture/frames.hpp"
#include "graze/capture.hpp"
#include "graze/error.hpp"

namespace {

template <class Settings>
void put_frames(std::ostringstream& stream, graze::capture::Kind kind, bool single, std::string_view calls) {
  const graze::CaptureSink out = graze::capture::sink_into(&stream);
  graze::capture::write_head(out, kind, single);
  graze::capture::Writing settings;
  settings(Settings{});
  graze::capture::write_frame(out, settings.bytes);
  graze::capture::write_frame(out, calls);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace graze;
  if (size == 0) return 0;
  const std::string_view calls(reinterpret_cast<const char*>(bytes + 1), size - 1);
  std::ostringstream out;
  switch (bytes[0]) {
  case 0: put_frames<WorldSettings<double>>(out, capture::Kind::world, false, calls); break;
  case 1: put_frames<WorldSettings<float>>(out, capture::Kind::world, true, calls); break;
  case 2: put_frames<SimulationSettings<double>>(out, capture::Kind::simulation, false, calls); break;
  case 3: put_frames<SimulationSettings<float>>(out, capture::Kind::simulation, true, calls); break;
  case 4: put_frames<WorldSettings<double>>(out, capture::Kind::plane_world, false, calls); break;
  case 5: put_frames<WorldSettings<float>>(out, capture::Kind::plane_world, true, calls); break;
  case 6: put_frames<plane::SimulationSettings<double>>(out, capture::Kind::plane_simulation, false, calls); break;
  case 7: put_frames<plane::SimulationSettings<float>>(out, capture::Kind::plane_simulation, true, calls); break;
  default: out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  }
  std::istringstream in(out.str());
  try {
    const ReplayReport report = replay(in, "fuzz");
    if (report.difference && report.difference->frame != report.frames + 1) __builtin_trap();
    std::size_t named = 0;
    for (const auto& [id, name] : report.names.all()) named += name.size();
    if (named > size) __builtin_trap();
  } catch (const InvalidValue&) {
  }
  return 0;
}
