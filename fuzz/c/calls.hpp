// Calls of the C interface that are made of the fuzzer's input, and the handles that they use.
#pragma once

#include <string>
#include <vector>

#include "c/bytes.hpp"

/// A handle of those there are, or none, or one of another kind.
template <class H>
const H* some(Bytes& in, const std::vector<H*>& handles, const void* other) {
  const std::uint8_t b = in.byte();
  if (b == 0) return nullptr;
  if (b == 1) return static_cast<const H*>(other);
  return handles.empty() ? nullptr : handles[b % handles.size()];
}

/// Keeps what a capture hands over.
inline bool keep_bytes(void* user, const void* bytes, std::size_t size) {
  static_cast<std::string*>(user)->append(static_cast<const char*>(bytes), size);
  return true;
}

/// The handles that there are, and calls that make, change and use them.
struct Calls {
  static constexpr std::size_t most_handles = 12;

  Bytes in;
  const bool captured;
  std::string files[4];  ///< the captures of the two worlds and the two simulations
  std::vector<GrazeShaped*> shapes;
  std::vector<GrazePlaneShaped*> plane_shapes;
  GrazeShapef* small = nullptr;
  GrazeBufferd* buffer = nullptr;
  GrazeTrace* trace = nullptr;
  GrazeBroadPhased* broad = nullptr;
  GrazePairChangesd* changes = nullptr;
  GrazeWorldd* world = nullptr;
  GrazePlaneWorldd* plane_world = nullptr;
  GrazeSimulationd* simulation = nullptr;
  GrazeStated* state = nullptr;
  GrazePlaneSimulationd* plane_simulation = nullptr;
  GrazePlaneStated* plane_state = nullptr;
  std::vector<GrazeBodyId> bodies, plane_bodies, simulated, plane_simulated;
  std::vector<GrazeJointId> joints, plane_joints;
  int masses = 0;  ///< how often those of a shape were asked for

  explicit Calls(Bytes bytes) : in(bytes), captured(in.byte() % 2 == 1) {
    require(graze_buffer_create_d(&buffer) == GRAZE_OK);
    require(graze_trace_create(&trace) == GRAZE_OK);
    require((captured ? graze_world_create_captured_d(nullptr, nullptr, &keep_bytes, &files[0], &world)
                      : graze_world_create_d(nullptr, nullptr, &world)) == GRAZE_OK);
    require((captured ? graze_plane_world_create_captured_d(nullptr, nullptr, &keep_bytes, &files[1], &plane_world)
                      : graze_plane_world_create_d(nullptr, nullptr, &plane_world)) == GRAZE_OK);
    require((captured ? graze_simulation_create_captured_d(nullptr, nullptr, &keep_bytes, &files[2], &simulation)
                      : graze_simulation_create_d(nullptr, nullptr, &simulation)) == GRAZE_OK);
    require((captured
                 ? graze_plane_simulation_create_captured_d(nullptr, nullptr, &keep_bytes, &files[3], &plane_simulation)
                 : graze_plane_simulation_create_d(nullptr, nullptr, &plane_simulation)) == GRAZE_OK);
    require(graze_shape_sphere_f(1, {0, 0, 0}, &small) == GRAZE_OK);
  }
  ~Calls() {
    for (const auto* s : shapes) graze_shape_release_d(s);
    for (const auto* s : plane_shapes) graze_plane_shape_release_d(s);
    graze_shape_release_f(small);
    graze_state_destroy_d(state);
    graze_simulation_destroy_d(simulation);
    graze_plane_state_destroy_d(plane_state);
    graze_plane_simulation_destroy_d(plane_simulation);
    graze_world_destroy_d(world);
    graze_plane_world_destroy_d(plane_world);
    graze_buffer_destroy_d(buffer);
    graze_broad_phase_destroy_d(broad);
    graze_pair_changes_destroy_d(changes);
    graze_trace_destroy(trace);
    if (!captured) return;
    for (const std::string& file : files) {
      GrazeReplayReport report;
      require(graze_replay_d(file.data(), file.size(), nullptr, nullptr, &report, nullptr) == GRAZE_OK &&
              !report.differs);
    }
  }
  Calls(const Calls&) = delete;
  Calls& operator=(const Calls&) = delete;

  /// A call's status: refused with a message, or not.
  bool told(GrazeStatus status) {
    require(status != GRAZE_FAILED);
    require(status == GRAZE_OK || graze_last_error()[0] != '\0');
    return status == GRAZE_OK;
  }

  const GrazeShaped* shape() { return some(in, shapes, small); }
  const GrazePlaneShaped* plane_shape() { return some(in, plane_shapes, world); }
  GrazeBodyId body(const std::vector<GrazeBodyId>& of) {
    if (of.empty() || in.byte() < 8) return {in.byte(), in.byte()};
    return of[in.byte() % of.size()];
  }

  void keep(GrazeShaped* made) {
    if (shapes.size() < most_handles) return shapes.push_back(made);
    GrazeShaped*& place = shapes[in.byte() % most_handles];
    graze_shape_release_d(place);
    place = made;
  }
  void keep(GrazePlaneShaped* made) {
    if (plane_shapes.size() < most_handles) return plane_shapes.push_back(made);
    GrazePlaneShaped*& place = plane_shapes[in.byte() % most_handles];
    graze_plane_shape_release_d(place);
    place = made;
  }

  /// Makes up to forty calls.
  void run();

  // Shapes and hulls.
  void make_shape();
  void ask_shape();
  void ask_hull();

  // Broad phases.
  GrazeAabbd box();
  void ask_broad_phase();
  void ask_changes();

  // Queries of one pair, one ray and many pairs.
  void ask_pair();
  void ask_ray();
  void ask_cast();
  void ask_batch();

  // Blows, free motion, worlds and simulations.
  void ask_blow();
  void pass_on(const GrazeStruckBodyd& ground, const GrazeStruckBodyd& body);
  void fall();
  GrazeBodyd new_body();
  void change_world();
  void change_simulation();

  // The plane.
  void plane();
  void ask_plane_batch();
  void change_plane_world();
  void ask_plane_world(const GrazePose2d& pose);
  void change_plane_simulation();
};
