// The frames of a capture: blocks of bytes with their length and a checksum, and the results compared at each end.
//
// Guarantee: a block that was read is the one that was written, or is reported as damaged or cut.
#pragma once

#include <functional>
#include <iosfwd>

#include "capture/bytes.hpp"
#include "dynamics/bit_hash.hpp"
#include "graze/capture.hpp"

namespace graze::capture {

/// The version of the format. A reader takes its own version and those before it from the oldest on: 3 has names of
/// bodies, which 2 has not, 4 has materials of pieces, which 3 has not, 5 has whether a simulation is warm started,
/// which 4 has not, and 6 has joints and filters of simulations that are set; they are the same otherwise.
inline constexpr std::uint16_t version = 6, oldest_version = 2, warm_start_version = 5;

enum class Kind : std::uint8_t { world, simulation, plane_world, plane_simulation };

constexpr bool is_simulation(Kind kind) { return kind == Kind::simulation || kind == Kind::plane_simulation; }
constexpr bool is_of_plane(Kind kind) { return kind >= Kind::plane_world; }
template <class T, class Space>
constexpr Kind kind_of(bool simulation) {
  if (std::is_same_v<Space, plane::Space<T>>) return simulation ? Kind::plane_simulation : Kind::plane_world;
  return simulation ? Kind::simulation : Kind::world;
}

/// The calls in a frame, in the order of their numbers in the file.
enum class Call : std::uint8_t {
  shape,  ///< the next number for a shape
  add_body,
  remove_body,
  // Calls of a simulation.
  add_joint,
  remove_joint,
  apply_impulse,
  apply_angular_impulse,
  apply_force,
  apply_torque,
  set_velocity,
  set_pose,
  move_to,
  set_material,
  wake,
  set_gravity,
  save,
  restore,
  step,  ///< ends a frame
  // Calls of a world.
  move,
  move_with_velocity,
  set_shape,
  set_filter,
  set_fast,
  update,        ///< ends a frame
  find_impacts,  ///< ends a frame
  // Calls of either.
  set_name,  ///< since version 3
  // Calls of simulations, in later versions.
  set_materials,  ///< since version 4
  set_joint       ///< since version 6, as `set_filter` of a simulation
};
/// The number of different calls in a version of the format.
constexpr std::size_t call_count(std::uint16_t of = version) { return of == 2 ? 25 : of == 3 ? 26 : of <= 5 ? 27 : 28; }
/// The name of the method: "add", "step".
const char* name_of(Call call);

/// The results of a frame, part by part, so that a difference has a name.
struct Outcome {
  std::uint64_t poses = 0, velocities = 0, contacts = 0, impulses = 0, events = 0, impacts = 0;
};
template <class Io>
void fields(Io& io, Outcome& o) {
  io(o.poses, o.velocities, o.contacts, o.impulses, o.events, o.impacts);
}
template <class T, class Space>
Outcome outcome_of(const World<T, Space>& world);
/// The first part that differs, as "other poses"; null for equal ones.
const char* difference(const Outcome& then, const Outcome& now);

/// FNV-1a of the bytes: by it a changed block is told from the one that was written.
std::uint64_t checksum(std::string_view bytes);

/// A sink that writes each frame to the stream and flushes it; none for no stream.
CaptureSink sink_into(std::ostream* out);
/// Write the head before all frames, and a frame. Throw `InvalidValue` when the sink takes no more.
void write_head(const CaptureSink& sink, Kind kind, bool single);
void write_frame(const CaptureSink& sink, std::string_view bytes);

struct Head {
  Kind kind;
  bool single;
  std::uint16_t version;
};

/// Reads a stream frame by frame.
class FrameReader {
 public:
  /// Writes up to `count` bytes to a place, and returns how many: fewer at the end alone.
  using Source = std::function<std::size_t(char* to, std::size_t count)>;

  FrameReader(Source source, std::string name) : source_(std::move(source)), name_(std::move(name)) {}

  /// Reads the head. Throws `InvalidValue` for a stream that is no capture, or of another version.
  Head head();
  /// The next frame; none at the end. Throws `InvalidValue` for one that is damaged.
  std::optional<std::string> next();
  /// Whether the end came within a frame.
  bool cut() const { return cut_; }
  /// Throws `InvalidValue` about the frame that was read last.
  [[noreturn]] void fail(const std::string& why) const;

 private:
  /// The next `count` bytes, or fewer at the end. Memory grows with the bytes that are there, whatever the count is.
  std::string take(std::uint64_t count);

  Source source_;
  std::string name_;
  std::uint64_t at_ = 0, begin_ = 0;
  std::size_t frame_ = 0, read_ = 0;  ///< the settings are number 0
  bool cut_ = false;
};

}  // namespace graze::capture
