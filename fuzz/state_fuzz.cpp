// Any bytes as a saved state: those of a small simulation with others written over them, whose checksum fits, since no
// fuzzer would find that. The first byte says of which scalar and space; then come places and bytes to write there.
// What is read and fits the simulation is gone back to and gone on from.
#include <cstdint>
#include <cstring>

#include "capture/frames.hpp"
#include "graze/error.hpp"
#include "graze/state_bytes.hpp"

namespace {

/// A floor, and two joined bodies that fall on it.
template <class T, class Space, class Ground, class Fallen>
struct Scene {
  graze::Simulation<T, Space> simulation;
  std::string bytes;

  Scene() {
    graze::Body<T, Space> ground{Ground()}, first{Fallen(T(0.5))}, second{Fallen(T(0.4))};
    ground.fixed = true;
    first.pose.translation.y = T(0.6);
    second.pose.translation.y = T(1.6);
    simulation.add(ground);
    graze::Joint<T, Space> joint;
    joint.a = simulation.add(first);
    joint.b = simulation.add(second);
    joint.limits.push_back({graze::JointSpace::linear, {true, true, false}});
    simulation.add(joint);
    for (int i = 0; i < 20; ++i) simulation.step(T(1) / T(60));
    bytes = graze::state_bytes(simulation.save());
  }
  void tried(std::string_view changes) {
    constexpr std::size_t sum_at = 18, body_at = sum_at + 8, change = 4;
    std::string forged = bytes;
    for (; changes.size() >= change; changes.remove_prefix(change)) {
      std::uint16_t place = 0;
      std::memcpy(&place, changes.data(), 2);
      std::memcpy(forged.data() + body_at + place % (forged.size() - body_at - 1), changes.data() + 2, 2);
    }
    const std::uint64_t sum = graze::capture::checksum(std::string_view(forged).substr(body_at));
    std::memcpy(forged.data() + sum_at, &sum, sizeof(sum));
    try {
      simulation.restore(graze::read_state<T, Space>(forged));
      simulation.step(T(1) / T(60));
    } catch (const graze::InvalidValue&) {
    }
    simulation.restore(graze::read_state<T, Space>(bytes));
    if (graze::state_bytes(simulation.save()) != bytes) __builtin_trap();
  }
};

template <class T>
using InSpace = Scene<T, graze::Space<T>, graze::HalfSpace<T>, graze::Sphere<T>>;
template <class T>
using InPlane = Scene<T, graze::plane::Space<T>, graze::plane::HalfPlane<T>, graze::plane::Circle<T>>;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  static InSpace<double> space_double;
  static InSpace<float> space_float;
  static InPlane<double> plane_double;
  static InPlane<float> plane_float;
  const std::string_view changes(reinterpret_cast<const char*>(bytes + 1), size - 1);
  switch (bytes[0] % 4) {
  case 0: space_double.tried(changes); break;
  case 1: space_float.tried(changes); break;
  case 2: plane_double.tried(changes); break;
  default: plane_float.tried(changes);
  }
  return 0;
}
