#include "capture/frames.hpp"

#include <algorithm>
#include <array>
#include <ostream>

#include "graze/error.hpp"

namespace graze::capture {

namespace {

/// The first bytes of a capture. They hold the end of a line in two forms: a transfer that changes these
/// has changed the rest too.
constexpr std::string_view magic{"graze capture\r\n\n", 16};

void put(const CaptureSink& sink, std::string_view bytes) {
  if (!sink(bytes)) throw InvalidValue("capture", "", "the stream takes no more bytes");
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t value = 0xcbf29ce484222325u;
  for (const char byte : bytes) value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return value;
}

const char* name_of(Call call) {
  constexpr std::array<const char*, call_count()> names{"shape",
                                                        "add",
                                                        "remove",
                                                        "add",
                                                        "remove",
                                                        "apply_impulse",
                                                        "apply_angular_impulse",
                                                        "apply_force",
                                                        "apply_torque",
                                                        "set_velocity",
                                                        "set_pose",
                                                        "move_to",
                                                        "set_material",
                                                        "wake",
                                                        "set_gravity",
                                                        "save",
                                                        "restore",
                                                        "step",
                                                        "move",
                                                        "move",
                                                        "set_shape",
                                                        "set_filter",
                                                        "set_fast",
                                                        "update",
                                                        "find_impacts",
                                                        "set_name",
                                                        "set_materials",
                                                        "set_joint"};
  return names[static_cast<std::size_t>(call)];
}

template <class T, class Space>
Outcome outcome_of(const World<T, Space>& world) {
  const BodyArrays<T, Space>& bodies = world.bodies();
  BitHash poses, velocities, contacts, impulses, events, impacts;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.alive()[i]) continue;
    poses.add(bodies.poses()[i]);
    velocities.add(bodies.linear()[i]);
    velocities.add(bodies.angular()[i]);
  }
  const ContactArrays<T, Space>& found = world.contacts();
  for (const ContactPair<T>& pair : found.pairs) {
    contacts.add((std::uint64_t{pair.a} << 32) | pair.b);
    contacts.add(pair.overlap);
    for (const auto& manifold : found.manifolds_of(pair)) {
      contacts.add(manifold.normal);
      for (const auto& point : found.points_of(manifold)) {
        contacts.add(point.a);
        contacts.add(point.b);
        contacts.add(point.distance);
        contacts.add(point.feature);
        impulses.add(point.impulse);
      }
    }
  }
  for (const ContactEvent& e : world.events()) {
    events.add((std::uint64_t{e.a.index} << 32) | e.b.index);
    events.add(static_cast<std::uint32_t>(e.kind));
  }
  for (const Impact<T, Space>& impact : world.impacts()) {
    impacts.add((std::uint64_t{impact.a.index} << 32) | impact.b.index);
    impacts.add(impact.hit.t);
    impacts.add(impact.hit.normal);
  }
  return {poses.value(), velocities.value(), contacts.value(), impulses.value(), events.value(), impacts.value()};
}
template Outcome outcome_of(const World<float>&);
template Outcome outcome_of(const World<double>&);
template Outcome outcome_of(const plane::World<float>&);
template Outcome outcome_of(const plane::World<double>&);

const char* difference(const Outcome& then, const Outcome& now) {
  if (then.contacts != now.contacts) return "other contacts";
  if (then.events != now.events) return "other events";
  if (then.poses != now.poses) return "other poses";
  if (then.velocities != now.velocities) return "other velocities";
  if (then.impulses != now.impulses) return "other impulses";
  if (then.impacts != now.impacts) return "other impacts";
  return nullptr;
}

CaptureSink sink_into(std::ostream* out) {
  if (!out) return {};
  return [out](std::string_view bytes) {
    out->write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return out->good();
  };
}

void write_head(const CaptureSink& sink, Kind kind, bool single) {
  Writing head;
  head(version, kind, single);
  put(sink, std::string(magic) + head.bytes);
}

void write_frame(const CaptureSink& sink, std::string_view bytes) {
  Writing frame;
  frame(std::uint64_t{bytes.size()}, checksum(bytes));
  frame.bytes += bytes;
  put(sink, frame.bytes);
}

std::string FrameReader::take(std::uint64_t count) {
  constexpr std::uint64_t step = 1 << 20;
  std::string bytes;
  while (bytes.size() < count) {
    const std::size_t before = bytes.size(), wanted = static_cast<std::size_t>(std::min(step, count - before));
    bytes.resize(before + wanted);
    const std::size_t got = source_(bytes.data() + before, wanted);
    bytes.resize(before + got);
    if (got < wanted) break;
  }
  return bytes;
}

Head FrameReader::head() {
  const std::string begin = take(magic.size() + 4);
  if (begin.size() < magic.size() + 4 || !begin.starts_with(magic))
    throw InvalidValue(name_, "a capture", "something else");
  Reading io(std::string_view(begin).substr(magic.size()));
  std::uint16_t of = 0;
  std::uint8_t kind = 0, single = 0;
  io(of, kind, single);
  if (of < oldest_version || of > version)
    throw InvalidValue(name_,
                       "a capture of version " + std::to_string(oldest_version) + " to " + std::to_string(version),
                       "version " + std::to_string(of));
  if (kind > static_cast<std::uint8_t>(Kind::plane_simulation) || single > 1)
    throw InvalidValue(name_, "a capture of a world or a simulation", "something else");
  at_ = begin.size();
  return {static_cast<Kind>(kind), single == 1, of};
}

std::optional<std::string> FrameReader::next() {
  begin_ = at_;
  frame_ = read_++;
  std::string head = take(16);
  if (head.empty()) return std::nullopt;
  std::uint64_t length = 0, sum = 0;
  std::string bytes;
  cut_ = head.size() < 16;
  if (!cut_) {
    Reading io(head);
    io(length, sum);
    bytes = take(length);
    cut_ = bytes.size() < length;
  }
  if (cut_) return std::nullopt;
  at_ += 16 + length;
  if (checksum(bytes) != sum) fail("other bytes");
  return bytes;
}

void FrameReader::fail(const std::string& why) const {
  throw InvalidValue(name_ + ": frame " + std::to_string(frame_) + ", from byte " + std::to_string(begin_),
                     "a frame as it was written", why);
}

}  // namespace graze::capture
