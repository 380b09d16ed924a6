#include "io/frame_lines.hpp"

#include "io/json_value.hpp"
#include "io/json_writer.hpp"

namespace graze::io {

namespace {

template <class T>
void write_number(JsonWriter& out, double value) {
  out.number(static_cast<T>(value));
}

template <class T>
void write_vector(JsonWriter& out, const char* key, const Vec3d& v) {
  out.key(key).vector(converted<T>(v));
}

template <class T>
void write_body(JsonWriter& out, const std::string& name, const BodyState& body) {
  const Quat<T> q = converted<T>(body.pose.rotation);
  out.open('{').key("body").raw(json_quoted(name));
  write_vector<T>(out, "translation", body.pose.translation);
  out.key("rotation").open('[').number(q.x).number(q.y).number(q.z).number(q.w).close(']');
  write_vector<T>(out, "linear", body.linear);
  write_vector<T>(out, "angular", body.angular);
  out.key("asleep").value(body.asleep).close('}');
}

template <class T>
void write_vector(JsonWriter& out, const char* key, const plane::Vec2d& v) {
  out.key(key).open('[').number(static_cast<T>(v.x)).number(static_cast<T>(v.y)).close(']');
}

template <class T>
void write_body(JsonWriter& out, const std::string& name, const PlaneBodyState& body) {
  out.open('{').key("body").raw(json_quoted(name));
  write_vector<T>(out, "translation", body.translation);
  out.key("rotation").number(static_cast<T>(body.rotation));
  write_vector<T>(out, "linear", body.linear);
  out.key("angular").number(static_cast<T>(body.angular));
  out.key("asleep").value(body.asleep).close('}');
}

template <class T, class AnyScene, class AnyFrame>
std::string line_in(const AnyScene& scene, const std::vector<std::uint32_t>& moving, const AnyFrame& frame) {
  JsonWriter out;
  // Frames come more often than floats have digits for seconds.
  out.open('{').key("time").number(frame.time).key("bodies").open('[');
  for (std::size_t i = 0; i < moving.size(); ++i) write_body<T>(out, scene.bodies[moving[i]].name, frame.bodies[i]);
  out.close(']').key("contacts").open('[');
  for (const ContactState& c : frame.contacts) {
    out.open('{').key("a").raw(json_quoted(scene.bodies[c.a].name)).key("b").raw(json_quoted(scene.bodies[c.b].name));
    out.key("points").number(static_cast<double>(c.points)).key("impulse");
    write_number<T>(out, c.impulse);
    out.key("depth");
    write_number<T>(out, c.depth);
    out.close('}');
  }
  out.close(']').key("energy").open('{').key("kinetic");
  write_number<T>(out, frame.kinetic_energy);
  out.key("potential");
  write_number<T>(out, frame.potential_energy);
  return out.close('}').close('}').take() + "\n";
}

}  // namespace

bool takes_lines(const std::filesystem::path& file) {
  std::error_code failed;
  if (std::filesystem::exists(file, failed) && std::filesystem::is_other(file, failed)) return true;
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".jsonl";
}

std::string frame_line(const Scene& scene, const std::vector<std::uint32_t>& moving, const SimulationFrame& frame,
                       Precision precision) {
  return precision == Precision::double_precision ? line_in<double>(scene, moving, frame)
                                                  : line_in<float>(scene, moving, frame);
}

std::string frame_line(const PlaneScene& scene, const std::vector<std::uint32_t>& moving,
                       const PlaneSimulationFrame& frame, Precision precision) {
  return precision == Precision::double_precision ? line_in<double>(scene, moving, frame)
                                                  : line_in<float>(scene, moving, frame);
}

}  // namespace graze::io
