// Any bytes as calls of the C interface, half of the time captured and then played again to the same bits: wrong and
// missing handles, removed bodies, sizes, strides, enumerators and numbers of all kinds, nulls wherever a pointer is
// taken. Every call ends with a status, and one that is refused leaves a message.
//
// Handles that were released and memory that is not there are the caller's mistakes, which nobody can tell.
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "graze/graze.h"

namespace {

void require(bool holds) {
  if (!holds) __builtin_trap();
}

/// The input, read from its front; zeros where it has ended.
class Bytes {
 public:
  Bytes(const std::uint8_t* bytes, std::size_t size) : at_(bytes), left_(size) {}
  bool empty() const { return left_ == 0; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }
  /// Mostly small lengths, now and then what a program gets wrong.
  double number() {
    const std::uint8_t kind = byte();
    const double small = (byte() - 128) / 32.0;
    switch (kind) {
    case 0: return std::numeric_limits<double>::quiet_NaN();
    case 1: return std::numeric_limits<double>::infinity();
    case 2: return -std::numeric_limits<double>::infinity();
    case 3: return 1e300;
    case 4: return 1e-310;
    case 5: return 0;
    case 6: return small * 1e9;
    case 7: return small * 1e-9;
    default: return kind < 128 ? (small < 0 ? -small : small) : small;
    }
  }
  double length() {
    const double v = number();
    return byte() < 8 ? v : v < 0 ? -v : v;
  }
  GrazeVec3d vector() { return {number(), number(), number()}; }
  GrazeVec2d vector2() { return {number(), number()}; }
  GrazePosed pose() {
    GrazePosed p = graze_pose_turned_d(vector(), {0.6, 0, 0.8}, number());
    if (byte() < 4) p.rotation = {number(), number(), number(), number()};
    return p;
  }
  GrazePose2d pose2() {
    GrazePose2d p = graze_plane_pose_d(number(), number(), number());
    if (byte() < 4) p.rotation = {number(), number()};
    return p;
  }
  /// An enumerator that is nearly always one.
  template <class E>
  E choice(unsigned count) {
    const unsigned b = byte();
    const unsigned value = b > 250 ? b : b % count;
    E chosen;
    static_assert(sizeof chosen == sizeof value);
    std::memcpy(&chosen, &value, sizeof value);
    return chosen;
  }
  /// The pointer, or now and then none.
  template <class P>
  P* maybe(P* pointer) {
    return byte() < 5 ? nullptr : pointer;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

constexpr std::size_t most_handles = 12;

/// A handle of those there are, or none, or one of another kind.
template <class H>
const H* some(Bytes& in, const std::vector<H*>& handles, const void* other) {
  const std::uint8_t b = in.byte();
  if (b == 0) return nullptr;
  if (b == 1) return static_cast<const H*>(other);
  return handles.empty() ? nullptr : handles[b % handles.size()];
}

/// Keeps what a capture hands over.
bool keep_bytes(void* user, const void* bytes, std::size_t size) {
  static_cast<std::string*>(user)->append(static_cast<const char*>(bytes), size);
  return true;
}

struct Calls {
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
      require(graze_replay_d(file.data(), file.size(), nullptr, nullptr, &report) == GRAZE_OK && !report.differs);
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

  static GrazeVec3d corner_support(const void*, GrazeVec3d d) {
    return {d.x < 0 ? -1.0 : 1.0, d.y < 0 ? -0.5 : 0.5, d.z < 0 ? -1.0 : 1.0};
  }

  void make_shape() {
    GrazeShaped* made = nullptr;
    GrazeShaped** const out = in.maybe(&made);
    GrazeStatus status = GRAZE_OK;
    std::vector<GrazeVec3d> points;
    std::vector<std::uint32_t> indices;
    switch (in.byte() % 15) {
    case 0: status = graze_shape_sphere_d(in.length(), in.vector(), out); break;
    case 1: status = graze_shape_capsule_d(in.length(), in.length(), in.length(), out); break;
    case 2: status = graze_shape_box_d({in.length(), in.length(), in.length()}, out); break;
    case 3: status = graze_shape_rectangle_d(in.length(), in.length(), out); break;
    case 4: status = graze_shape_cylinder_d(in.length(), in.length(), in.length(), out); break;
    case 5: status = graze_shape_ellipsoid_d({in.length(), in.length(), in.length()}, out); break;
    case 6: status = graze_shape_segment_d(in.vector(), in.vector(), out); break;
    case 7: status = graze_shape_triangle_d(in.vector(), in.vector(), in.vector(), out); break;
    case 8: status = graze_shape_half_space_d(out); break;
    case 9:
      points.resize(in.byte() % 12);
      for (auto& p : points) p = in.vector();
      status = graze_shape_convex_hull_d(in.maybe(points.data()), 0, points.size(), out);
      break;
    case 10:
      points.resize(in.byte() % 8);
      for (auto& p : points) p = in.vector();
      indices.resize(std::size_t{3} * (in.byte() % 8));
      for (auto& i : indices) i = in.byte() % 9;
      status = graze_shape_mesh_d(in.maybe(points.data()), 0, points.size(), in.maybe(indices.data()), 0,
                                  indices.size() / 3, in.choice<GrazeSides>(2), in.byte() < 32, out);
      break;
    case 11: {
      const std::size_t columns = in.byte() % 5, rows = in.byte() % 5;
      std::vector<double> heights(columns * rows);
      for (double& h : heights) h = in.number();
      status = graze_shape_height_field_d(in.maybe(heights.data()), 0, columns, in.byte() == 9 ? SIZE_MAX : rows,
                                          nullptr, in.length(), in.length(), in.choice<GrazeSides>(2), out);
      if (in.byte() == 9) told(graze_shape_height_field_d(nullptr, 0, 1, 1, nullptr, 1, 1, GRAZE_SIDES_BOTH, out));
      break;
    }
    case 12: {
      std::vector<GrazeChildd> children(in.byte() % 4);
      for (auto& child : children) child = {shape(), in.pose()};
      status = graze_shape_compound_d(in.maybe(children.data()), 0, children.size(), out);
      break;
    }
    case 13: status = graze_shape_rounded_d(shape(), in.length(), out); break;
    default:
      if (in.byte() < 128) {
        status = graze_shape_user_d(in.byte() < 8 ? nullptr : corner_support, nullptr, nullptr, out);
      } else {
        const GrazePosed pose = in.pose();
        status = graze_shape_swept_d(shape(), in.maybe(&pose), in.vector(), out);
      }
    }
    const bool made_it = told(status);
    require(made_it == (made != nullptr));
    if (made_it) keep(made);
  }

  void ask_shape() {
    const GrazeShaped* s = shape();
    const GrazePosed pose = in.pose();
    GrazeAabbd bounds;
    GrazeVec3d point;
    GrazeMassPropertiesd mass;
    GrazeShapeKind kind;
    GrazeClosestd closest;
    told(graze_shape_bounds_d(s, in.maybe(&pose), in.maybe(&bounds)));
    told(graze_shape_support_d(s, in.vector(), in.maybe(&point)));
    GrazePolygons polygons;
    if (told(graze_shape_tessellate_d(s, in.maybe(&pose), in.vector(), in.length(), in.maybe(buffer), &polygons)))
      require(polygons.loop_count == 0 || polygons.corners[polygons.ends[0] - 1] < polygons.point_count);
    // Of a shape known by its support alone they cost the hull of 20,000 points.
    if (masses < 1 && in.byte() < 64) ++masses, told(graze_shape_mass_properties_d(s, in.maybe(&mass)));
    told(graze_shape_kind_d(s, in.maybe(&kind)));
    if (told(graze_closest_d(s, &pose, in.vector(), &closest))) require(closest.certainty <= GRAZE_UNBOUNDED);
  }

  void ask_hull() {
    const GrazeShaped* s = shape();
    const GrazeVec3d* vertices;
    const GrazeHullLayer* layers;
    GrazeSupportTrace steps;
    std::size_t count = 0;
    if (told(graze_hull_vertices_d(s, in.maybe(&vertices), &count))) require(count > 0);
    if (told(graze_hull_layers_d(s, in.maybe(buffer), in.maybe(&layers), &count))) require(count > 0);
    if (told(graze_hull_support_d(s, in.vector(), in.maybe(buffer), in.maybe(&steps))))
      require(steps.layers[steps.layer_count - 1].winner == steps.vertex);
  }

  GrazeAabbd box() {
    const GrazeVec3d lower = in.vector();
    return {lower, {lower.x + in.length(), lower.y + in.length(), lower.z + in.length()}};
  }

  void ask_broad_phase() {
    if (broad == nullptr) told(graze_broad_phase_create_d(in.choice<GrazeBroadPhaseKind>(6), in.maybe(&broad)));
    const GrazeAabbd around = box();
    const std::uint32_t id = in.byte() % 16;
    const GrazeIdPair* pairs;
    const std::uint32_t* ids;
    const GrazeBroadPhasePartd* parts;
    std::size_t count = 0;
    switch (in.byte() % 8) {
    case 0: ask_changes(); break;
    case 1: told(graze_broad_phase_insert_d(broad, id, in.maybe(&around))); break;
    case 2: told(graze_broad_phase_move_d(broad, id, in.maybe(&around))); break;
    case 3: told(graze_broad_phase_remove_d(broad, id)); break;
    case 4:
      if (told(graze_broad_phase_moved_pairs_d(broad, buffer, in.maybe(&pairs), &count)))
        for (std::size_t i = 0; i < count; ++i) require(pairs[i].a < pairs[i].b);
      break;
    case 5:
      told(graze_broad_phase_sweep_d(broad, in.maybe(&around), in.vector(), buffer, &ids, in.maybe(&count)));
      break;
    case 6: told(graze_broad_phase_parts_d(broad, in.maybe(buffer), in.maybe(&parts), &count)); break;
    default:
      told(graze_broad_phase_pairs_d(broad, in.maybe(buffer), &pairs, &count));
      if (told(graze_broad_phase_query_d(broad, in.maybe(&around), buffer, &ids, &count)) && count > 0)
        require(graze_broad_phase_insert_d(broad, ids[0], &around) == GRAZE_INVALID_VALUE);
    }
  }

  void ask_changes() {
    if (changes == nullptr) told(graze_pair_changes_create_d(in.choice<GrazeBroadPhaseKind>(6), in.maybe(&changes)));
    const GrazeAabbd around = box();
    const std::uint32_t id = in.byte() % 16;
    const GrazeIdPair *begun, *ended;
    std::size_t count = 0, ended_count = 0;
    switch (in.byte() % 4) {
    case 0: told(graze_pair_changes_insert_d(changes, id, in.maybe(&around))); break;
    case 1: told(graze_pair_changes_move_d(changes, id, in.maybe(&around))); break;
    case 2: told(graze_pair_changes_remove_d(changes, id)); break;
    default:
      if (told(graze_pair_changes_find_d(changes, in.maybe(buffer), &begun, &count, in.maybe(&ended), &ended_count)))
        for (std::size_t i = 0; i < count; ++i) require(begun[i].a < begun[i].b);
    }
  }

  void ask_pair() {
    const GrazeShaped *a = shape(), *b = shape();
    const GrazePosed pose_a = in.pose(), pose_b = in.pose();
    const GrazePosed *pa = in.maybe(&pose_a), *pb = in.maybe(&pose_b);
    bool yes = false;
    GrazeDistanced d{};
    told(graze_overlap_d(a, pa, b, pb, in.maybe(&yes)));
    told(graze_may_overlap_d(a, pa, b, pb, in.maybe(&yes)));
    if (told(graze_distance_d(a, pa, b, pb, in.maybe(&d)))) require(d.certainty <= GRAZE_UNBOUNDED && d.error >= 0);
    told(graze_distance_up_to_d(a, pa, b, pb, in.length(), in.maybe(&yes), in.maybe(&d)));
    told(graze_within_d(a, pa, b, pb, in.length(), in.maybe(&yes)));
    const GrazePieceDistanced* pieces;
    std::size_t count = 0;
    told(graze_near_pieces_d(a, pa, b, pb, in.length(), in.maybe(buffer), in.maybe(&pieces), in.maybe(&count)));
    const GrazeVec3d* corners;
    const auto feature = static_cast<std::uint16_t>(in.byte() << 8 | in.byte());
    told(graze_feature_corners_d(a, in.byte(), feature, in.maybe(buffer), in.maybe(&corners), in.maybe(&count)));
    GrazeContactsd contacts;
    if (told(graze_contacts_reduced_d(a, pa, b, pb, in.length(), in.byte(), in.maybe(buffer), &contacts)))
      for (std::size_t i = 0; i < contacts.manifold_count; ++i)
        require(contacts.manifolds[i].first_point + contacts.manifolds[i].point_count <= contacts.point_count);
    GrazeDistanced explained{};
    GrazeTraceView view;
    if (graze_distance_d(a, &pose_a, b, &pose_b, &d) == GRAZE_OK &&
        told(graze_distance_explained_d(a, &pose_a, b, &pose_b, &explained, in.maybe(trace))))
      require(explained.distance == d.distance);
    if (told(graze_trace_view(in.maybe(trace), in.maybe(&view))) && view.axis_count > 0)
      require(view.axes[0].name != nullptr);
  }

  void ask_blow() {
    GrazeInverseMassd inverse{};
    GrazeResponsed response;
    GrazeMotiond after;
    told(graze_inverse_mass_d(in.length(), in.vector(), in.pose().rotation, in.maybe(&inverse)));
    const GrazeMat3d tensor{{in.vector(), in.vector(), in.vector()}};
    if (in.byte() < 32) told(graze_inverse_mass_of_tensor_d(in.length(), in.maybe(&tensor), {0, 0, 0, 1}, &inverse));
    if (in.byte() < 64) told(graze_inverse_mass_of_shape_d(shape(), in.length(), in.pose().rotation, &inverse));
    const GrazeStruckBodyd ground{}, body{{in.vector(), in.vector(), in.vector()}, inverse};
    const GrazeStruckContactd contact{in.vector(), in.vector(), in.length(), in.length()};
    if (told(graze_response_d(&contact, in.maybe(&ground), in.maybe(&body), in.maybe(&response))))
      require(!(response.normal_impulse < 0));
    told(graze_apply_impulse_d(in.maybe(&body), in.vector(), in.vector(), in.maybe(&after)));
    pass_on(ground, body);
    fall();
  }

  void pass_on(const GrazeStruckBodyd& ground, const GrazeStruckBodyd& body) {
    GrazeStruckBodyd struck[] = {ground, body};
    const GrazePlaneStruckBodyd flat_body{{{in.number(), in.number()}, in.number(), {0, 0}},
                                          {in.length(), in.length()}};
    GrazePlaneStruckBodyd flat_struck[] = {{}, flat_body};
    const GrazeVec3d points[] = {in.vector(), in.vector()};
    const GrazeVec2d flat_points[] = {{points[0].x, points[0].y}, {points[1].x, points[1].y}};
    const std::uint32_t a = in.byte() % 3, b = in.byte() % 3, first = in.byte() % 4, count = in.byte() % 4;
    const GrazeBlowd blow{a, b, {0, in.byte() < 8 ? in.number() : 1, 0}, in.length(), first, count};
    const GrazePlaneBlowd flat{a, b, {0, blow.normal.y}, blow.restitution, first, count};
    double impulses[2] = {};
    GrazePassedOnd passed{};
    const GrazeTouchingd touching{in.maybe(struck), 0, 2, in.maybe(&blow),    0, 1,
                                  in.maybe(points), 0, 2, in.maybe(impulses), 0};
    if (told(graze_pass_on_d(in.maybe(&touching), in.length(), in.byte(), in.maybe(&passed))))
      require(first + count <= 2 && a != b && passed.struck < 256);
    const GrazePlaneTouchingd touching_flat{flat_struck, 0, 2, &flat, 0, 1, flat_points, 0, 2, impulses, 0};
    told(graze_plane_pass_on_d(in.maybe(&touching_flat), in.length(), in.byte(), in.maybe(&passed)));
    GrazePlaneMotiond after;
    told(graze_plane_apply_impulse_d(in.maybe(&flat_body), flat_points[0], flat_points[1], in.maybe(&after)));
  }

  void fall() {
    GrazeFreeBodyd free{in.vector(), in.pose().rotation, in.vector(), in.vector(), in.vector()};
    GrazePlaneFreeBodyd flat{{in.number(), in.number()}, in.pose2().rotation, {0, 1}, in.number(), in.length()};
    GrazeVec3d angular;
    double turning;
    told(graze_free_set_angular_velocity_d(in.maybe(&free), in.vector()));
    told(graze_free_advance_d(in.maybe(&free), in.vector(), in.number()));
    told(graze_free_angular_velocity_d(in.maybe(&free), in.maybe(&angular)));
    told(graze_plane_free_set_angular_velocity_d(in.maybe(&flat), in.number()));
    told(graze_plane_free_advance_d(in.maybe(&flat), {in.number(), in.number()}, in.number()));
    told(graze_plane_free_angular_velocity_d(in.maybe(&flat), in.maybe(&turning)));
    GrazeMeshFindings found;
    if (told(graze_shape_findings_d(shape(), in.maybe(&found)))) require(found.triangles > 0);
  }

  void ask_ray() {
    const GrazeShaped* s = shape();
    const GrazePosed pose = in.pose();
    const GrazeRayd ray = {in.vector(), in.vector()};
    bool found = false;
    GrazeRayHitd hit;
    const GrazeRayHitd* hits;
    std::size_t count = 0;
    const auto back = in.choice<GrazeBackFaces>(2);
    told(graze_raycast_d(s, in.maybe(&pose), in.maybe(&ray), in.length(), back, in.maybe(&found), in.maybe(&hit)));
    told(graze_raycast_any_d(s, &pose, in.maybe(&ray), in.length(), back, in.maybe(&found)));
    told(graze_raycast_all_d(s, &pose, &ray, in.length(), back, in.maybe(buffer), &hits, in.maybe(&count)));
    const GrazeBodyRayHitd* body_hits;
    told(graze_world_raycast_all_d(world, &ray, in.length(), nullptr, back, buffer, in.maybe(&body_hits), &count));
  }

  void ask_cast() {
    // What turns while it lies deep in its like takes seconds: most of these begin apart and meet.
    const auto moving = [&] {
      GrazeMovingd m{shape(), graze_pose_at_place_d((in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, 0), {}};
      m.velocity.linear = {(in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, 0};
      m.velocity.angular.z = (in.byte() - 128) / 128.0;
      if (in.byte() < 4) m.velocity.angular.x = in.number() * 0;  // not a number, at times
      return m;
    };
    const GrazeMovingd a = moving();
    GrazeMovingd b = moving();
    b.pose.translation.x += 16;
    b.velocity.linear.x -= 12;
    bool found = false;
    GrazeCastHitd hit;
    const double duration = in.byte() < 8 ? in.number() * 1e-9 : in.byte() / 128.0;
    if (!(duration < 4)) return;
    told(graze_cast_d(in.maybe(&a), &b, duration, in.choice<GrazeSeparating>(2), in.maybe(&found), in.maybe(&hit)));
  }

  void ask_batch() {
    const std::size_t count = in.byte() % 20;
    std::vector<const GrazeShaped*> handles(in.byte() < 128 ? 1 : count);
    for (auto& h : handles) h = shape();
    std::vector<GrazePosed> poses(in.byte() < 32 ? 1 : count);
    for (auto& p : poses) p = in.pose();
    std::vector<GrazeIdPair> places(in.byte() % 8);
    for (auto& p : places) p = {in.byte() % 21u, in.byte() % 3u};
    GrazeBatchd batch{};
    batch.a = graze_bodies_d(in.maybe(handles.data()), handles.size(), in.maybe(poses.data()), poses.size());
    batch.b = graze_bodies_d(handles.data(), handles.empty() ? 0 : 1, poses.data(), poses.empty() ? 0 : 1);
    if (in.byte() < 64) batch.b.rotations = nullptr;
    if (!places.empty()) batch.places = places.data(), batch.place_count = places.size();
    std::size_t size = 0;
    if (!told(graze_batch_size_d(in.maybe(&batch), in.maybe(&size)))) return;
    std::vector<std::uint8_t> touch(size);
    std::vector<GrazeDistanced> distances(size);
    told(graze_overlap_batch_d(&batch, in.maybe(touch.data()), 0));
    told(graze_distance_batch_d(&batch, in.maybe(distances.data()), 0));
    GrazeBatchContactsd contacts;
    GrazeCompactContactsd compact;
    if (told(graze_compact_contacts_batch_d(&batch, in.length(), in.maybe(buffer), in.maybe(&compact))))
      for (std::size_t i = 0; i < compact.manifold_count; ++i)
        require(compact.manifolds[i].first_point + compact.manifolds[i].point_count <= compact.point_count);
    const std::size_t most = in.byte();
    if (told(graze_contacts_batch_reduced_d(&batch, in.length(), most, in.maybe(buffer), &contacts)))
      require(contacts.pair_count == size && contacts.point_count <= most * size);
    const GrazePieceDistanced* pieces;
    const std::size_t* ends;
    if (told(graze_near_pieces_batch_d(&batch, in.length(), in.maybe(buffer), &pieces, in.maybe(&ends), &size)))
      require(size == 0 || ends[touch.size() - 1] == size);
  }

  GrazeBodyd new_body() {
    GrazeBodyd b = graze_body_default_d(shape());
    if (in.byte() < 4) b = GrazeBodyd{b.shape, {}, {}, {}, {}, false, false, false};
    b.pose = in.pose();
    b.linear = in.vector();
    b.angular = {in.byte() / 64.0, 0, 0};
    b.fixed = in.byte() < 64;
    b.trigger = in.byte() < 32;
    return b;
  }

  void change_world() {
    const GrazeBodyd b = new_body();
    GrazeBodyId id;
    const GrazePosed pose = in.pose();
    switch (in.byte() % 6) {
    case 0:
    case 1:
      if (bodies.size() < 16 && told(graze_world_add_d(in.maybe(world), in.maybe(&b), in.maybe(&id))))
        bodies.push_back(id);
      break;
    case 2: told(graze_world_remove_d(world, body(bodies))); break;
    case 3: told(graze_world_move_d(world, body(bodies), in.maybe(&pose), nullptr)); break;
    case 4: told(graze_world_set_shape_d(world, body(bodies), shape())); break;
    default: told(graze_world_update_d(in.maybe(world), in.byte() < 8 ? -1 : 0));
    }
    GrazeWorldContactsd contacts;
    const GrazeContactEvent* events;
    const GrazeBodyId* found;
    const GrazeBodyDistanced* distances;
    std::size_t count = 0;
    if (told(graze_world_contacts_d(world, in.maybe(&contacts))) && contacts.pair_count > 0)
      require(contacts.pairs[0].a < contacts.pairs[0].b);
    told(graze_world_events_d(world, &events, in.maybe(&count)));
    told(graze_world_overlapping_d(world, shape(), &pose, nullptr, buffer, in.maybe(&found), &count));
    told(graze_world_nearest_d(world, shape(), &pose, in.byte(), in.length(), nullptr, buffer, &distances, &count));
    GrazePosed end;
    GrazeVec3d left;
    const GrazeBodyCastHitd* touched;
    told(graze_world_slide_d(world, shape(), in.maybe(&pose), in.vector(), in.byte() % 9, nullptr, buffer, &end, &left,
                             in.maybe(&touched), &count));
    const GrazeVec3d away[] = {in.vector(), in.vector(), in.vector()};
    told(graze_along_planes_d(in.vector(), in.maybe(away), 0, 3, in.maybe(&left)));
    GrazeBodyd known;
    if (told(graze_world_body_d(world, body(bodies), in.maybe(&known)))) graze_shape_release_d(known.shape);
  }

  void change_simulation() {
    GrazeBodyd b = new_body();
    b.pose = graze_pose_at_place_d((in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, 0);
    b.linear = {};
    GrazeDynamicsd dynamics = graze_dynamics_default_d();
    dynamics.has_mass = dynamics.has_inertia = dynamics.has_center_of_mass = in.byte() < 128 || ++masses > 2;
    dynamics.mass = in.length();
    dynamics.inertia_diagonal = {in.length(), in.length(), in.length()};
    GrazeMateriald material = graze_material_default_d();
    material.restitution = in.number();
    material.friction_combine = in.byte() % 6;
    GrazeBodyId id;
    GrazeJointd joint;
    GrazeJointId joint_id;
    const GrazePosed frame = graze_pose_at_place_d(in.byte() / 64.0, 0, 0);
    GrazePosed pose;
    switch (in.byte() % 8) {
    case 0:
    case 1:
      if (simulated.size() < 8 && told(graze_simulation_add_d(in.maybe(simulation), in.maybe(&b), in.maybe(&dynamics),
                                                              in.maybe(&material), in.maybe(&id))))
        simulated.push_back(id);
      break;
    case 2: told(graze_simulation_remove_d(simulation, body(simulated))); break;
    case 3:
      if (told(graze_joint_of_kind_d(in.choice<GrazeJointKind>(4), body(simulated), in.maybe(&frame), body(simulated),
                                     &frame, in.maybe(&joint))) &&
          joints.size() < 4 && told(graze_simulation_add_joint_d(simulation, in.maybe(&joint), &joint_id)))
        joints.push_back(joint_id);
      break;
    case 4:
      if (!joints.empty()) told(graze_simulation_remove_joint_d(simulation, joints[in.byte() % joints.size()]));
      break;
    case 5:
      if (state == nullptr)
        told(graze_simulation_save_d(simulation, in.maybe(&state)));
      else
        told(graze_simulation_restore_d(simulation, in.maybe(state)));
      break;
    case 6: told(graze_simulation_apply_impulse_d(simulation, body(simulated), in.vector(), in.vector())); break;
    default: told(graze_simulation_step_d(in.maybe(simulation), in.byte() < 8 ? in.number() : 1.0 / 60));
    }
    told(graze_simulation_pose_d(simulation, body(simulated), in.maybe(&pose)));
    const GrazeJointId* all;
    std::size_t count = 0;
    std::int32_t sub_steps = 0;
    std::uint64_t hash = 0;
    told(graze_simulation_sub_steps_d(simulation, body(simulated), in.maybe(&sub_steps)));
    told(graze_simulation_state_hash_d(simulation, in.maybe(&hash)));
    if (told(graze_simulation_joints_d(simulation, in.maybe(buffer), &all, &count)) && count > 0)
      told(graze_simulation_joint_d(simulation, all[0], buffer, in.maybe(&joint)));
    const GrazeWorldd* borrowed;
    if (told(graze_simulation_world_d(simulation, in.maybe(&borrowed))))
      require(graze_world_update_d(const_cast<GrazeWorldd*>(borrowed), 0) == GRAZE_INVALID_VALUE);
  }

  void plane() {
    GrazePlaneShaped* made = nullptr;
    std::vector<GrazeVec2d> points(in.byte() % 8);
    for (auto& p : points) p = {in.number(), in.number()};
    GrazeStatus status = GRAZE_OK;
    switch (in.byte() % 9) {
    case 0: status = graze_plane_shape_circle_d(in.length(), &made); break;
    case 1: status = graze_plane_shape_capsule_d(in.length(), in.length(), in.length(), &made); break;
    case 2: status = graze_plane_shape_box_d({in.length(), in.length()}, in.maybe(&made)); break;
    case 3: status = graze_plane_shape_convex_d(in.maybe(points.data()), 0, points.size(), &made); break;
    case 4: status = graze_plane_shape_polygon_d(in.maybe(points.data()), 0, points.size(), &made); break;
    case 5:
      status = graze_plane_shape_chain_d(in.maybe(points.data()), 0, points.size(), in.byte() < 128,
                                         in.choice<GrazeSides>(2), &made);
      break;
    case 6: status = graze_plane_shape_half_plane_d(&made); break;
    case 7: {
      const GrazePose2d pose = in.pose2();
      status = in.byte() < 128 ? graze_plane_shape_rounded_d(plane_shape(), in.length(), &made)
                               : graze_plane_shape_swept_d(plane_shape(), in.maybe(&pose), in.vector2(), &made);
      break;
    }
    default: {
      const GrazePlaneChildd children[2] = {{plane_shape(), in.pose2()}, {plane_shape(), in.pose2()}};
      status = graze_plane_shape_compound_d(children, 0, in.byte() % 3, &made);
    }
    }
    if (told(status)) keep(made);
    const GrazePlaneShaped *a = plane_shape(), *b = plane_shape();
    const GrazePose2d pose_a = in.pose2(), pose_b = in.pose2();
    bool yes = false;
    GrazePlaneDistanced d;
    GrazePlaneContactsd contacts;
    GrazePlaneClosestd closest;
    told(graze_plane_overlap_d(a, in.maybe(&pose_a), b, in.maybe(&pose_b), in.maybe(&yes)));
    if (told(graze_plane_distance_d(a, &pose_a, b, &pose_b, in.maybe(&d)))) require(d.certainty <= GRAZE_UNBOUNDED);
    told(graze_plane_distance_up_to_d(a, &pose_a, b, in.maybe(&pose_b), in.length(), in.maybe(&yes), in.maybe(&d)));
    told(graze_plane_within_d(a, in.maybe(&pose_a), b, &pose_b, in.length(), in.maybe(&yes)));
    const GrazePlanePieceDistanced* pieces;
    GrazeVec2d furthest;
    std::size_t count = 0;
    told(graze_plane_near_pieces_d(a, &pose_a, b, &pose_b, in.length(), in.maybe(buffer), in.maybe(&pieces), &count));
    told(graze_plane_shape_support_d(a, in.vector2(), in.maybe(&furthest)));
    const GrazeVec2d away[] = {in.vector2(), in.vector2()};
    told(graze_plane_along_lines_d(in.vector2(), in.maybe(away), 0, 2, in.maybe(&furthest)));
    GrazePolygons polygons;
    told(graze_plane_shape_tessellate_d(a, &pose_a, in.vector2(), in.length(), buffer, in.maybe(&polygons)));
    told(graze_plane_contacts_d(a, &pose_a, b, &pose_b, in.length(), in.maybe(buffer), in.maybe(&contacts)));
    const std::size_t most = in.byte();
    if (told(graze_plane_contacts_reduced_d(a, &pose_a, b, &pose_b, in.length(), most, in.maybe(buffer), &contacts)))
      require(contacts.point_count <= most);
    told(graze_plane_closest_d(a, &pose_a, {in.number(), in.number()}, in.maybe(&closest)));
    const GrazePlaneRayd ray = {{in.number(), in.number()}, {in.number(), in.number()}};
    GrazePlaneRayHitd hit;
    told(graze_plane_raycast_d(a, &pose_a, &ray, in.length(), in.maybe(&yes), &hit));
    const GrazePlaneRayHitd* hits;
    const GrazePlaneCastHitd* casts;
    GrazePlaneMassPropertiesd mass;
    told(graze_plane_shape_mass_properties_d(a, in.maybe(&mass)));
    told(graze_plane_raycast_any_d(b, in.maybe(&pose_b), &ray, in.length(), in.maybe(&yes)));
    told(graze_plane_raycast_all_d(b, &pose_b, in.maybe(&ray), in.length(), in.maybe(buffer), &hits, &count));
    const GrazePlaneMovingd fast = {a, pose_a, {{in.number(), 1}, 0}}, still = {b, pose_b, {{0, 0}, 0}};
    std::uint8_t met[2];
    GrazePlaneCastHitd met_at[2];
    GrazePlaneClosestd nearest[2];
    const GrazeVec2d asked[] = {ray.origin, ray.direction};
    const std::size_t stride = in.byte() < 8 ? sizeof ray : 0;
    told(graze_plane_closest_batch_d(a, &pose_a, in.maybe(asked), 0, 2, in.maybe(nearest), 0));
    told(graze_plane_raycast_batch_d(b, in.maybe(&pose_b), in.maybe(&ray), stride, 1, in.length(), in.maybe(met), 0,
                                     in.maybe(&hit), 0));
    told(graze_plane_cast_batch_d(in.maybe(&fast), 0, &still, 0, 1, in.length(), in.choice<GrazeSeparating>(2),
                                  in.maybe(met), 0, in.maybe(met_at), 0));
    told(graze_plane_cast_all_d(in.maybe(&fast), &still, 1, in.choice<GrazeSeparating>(2), in.maybe(buffer), &casts,
                                &count));
  }

  void change_plane_world() {
    GrazePlaneBodyd b = graze_plane_body_default_d(plane_shape());
    b.pose = in.pose2();
    b.linear = {in.number(), in.number()};
    b.angular = in.byte() < 4 ? in.number() : in.byte() / 64.0;
    b.fixed = in.byte() < 64;
    b.trigger = in.byte() < 32;
    GrazeBodyId id;
    const GrazePose2d pose = in.pose2();
    const GrazePlaneVelocityd velocity{{in.number(), in.number()}, in.number()};
    switch (in.byte() % 7) {
    case 0:
    case 1:
      if (plane_bodies.size() < 16 && told(graze_plane_world_add_d(in.maybe(plane_world), in.maybe(&b), in.maybe(&id))))
        plane_bodies.push_back(id);
      break;
    case 2: told(graze_plane_world_remove_d(plane_world, body(plane_bodies))); break;
    case 3:
      told(graze_plane_world_move_d(plane_world, body(plane_bodies), in.maybe(&pose),
                                    in.byte() < 128 ? nullptr : &velocity));
      break;
    case 4: told(graze_plane_world_set_shape_d(plane_world, body(plane_bodies), plane_shape())); break;
    case 5: told(graze_plane_world_reduce_d(plane_world, in.byte() % 4)); break;
    default: told(graze_plane_world_update_d(in.maybe(plane_world), in.byte() < 8 ? -1 : 0));
    }
    ask_plane_world(pose);
  }

  void ask_plane_world(const GrazePose2d& pose) {
    GrazePlaneWorldContactsd contacts;
    const GrazeContactEvent* events;
    const GrazeBodyId* found;
    const GrazePlaneBodyDistanced* distances;
    const GrazePlaneBodyRayHitd* hits;
    std::size_t count = 0;
    if (told(graze_plane_world_contacts_d(plane_world, in.maybe(&contacts))))
      for (std::size_t i = 0; i < contacts.manifold_count; ++i)
        require(contacts.manifolds[i].first_point + contacts.manifolds[i].point_count <= contacts.point_count);
    told(graze_plane_world_events_d(plane_world, &events, in.maybe(&count)));
    const GrazePlaneShaped* s = plane_shape();
    told(graze_plane_world_overlapping_d(plane_world, s, &pose, nullptr, buffer, in.maybe(&found), &count));
    told(graze_plane_world_nearest_d(plane_world, s, &pose, in.byte(), in.length(), nullptr, buffer, &distances,
                                     &count));
    const GrazePlaneRayd ray = {{in.number(), in.number()}, {in.number(), in.number()}};
    told(graze_plane_world_raycast_all_d(plane_world, in.maybe(&ray), in.length(), nullptr, in.maybe(buffer), &hits,
                                         &count));
    GrazePose2d end;
    GrazeVec2d left;
    const GrazePlaneBodyCastHitd* touched;
    told(graze_plane_world_slide_d(plane_world, s, &pose, in.vector2(), in.byte() % 9, nullptr, in.maybe(buffer), &end,
                                   in.maybe(&left), in.maybe(&touched), &count));
    GrazePlaneBodyd known;
    if (told(graze_plane_world_body_d(plane_world, body(plane_bodies), in.maybe(&known))))
      graze_plane_shape_release_d(known.shape);
  }

  void change_plane_simulation() {
    GrazePlaneBodyd b = graze_plane_body_default_d(plane_shape());
    b.pose = graze_plane_pose_d((in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, in.byte() / 16.0);
    b.fixed = in.byte() < 64;
    GrazePlaneDynamicsd dynamics = graze_plane_dynamics_default_d();
    dynamics.has_mass = dynamics.has_inertia = dynamics.has_center_of_mass = in.byte() < 128;
    dynamics.mass = in.length();
    dynamics.inertia = in.length();
    GrazePlaneMateriald material = graze_plane_material_default_d();
    material.restitution = in.number();
    material.friction_combine = in.byte() % 6;
    GrazeBodyId id;
    GrazePlaneJointd joint;
    GrazeJointId joint_id;
    const GrazePose2d frame = graze_plane_pose_d(in.byte() / 64.0, 0, 0);
    GrazePose2d pose;
    switch (in.byte() % 8) {
    case 0:
    case 1:
      if (plane_simulated.size() < 8 &&
          told(graze_plane_simulation_add_d(in.maybe(plane_simulation), in.maybe(&b), in.maybe(&dynamics),
                                            in.maybe(&material), in.maybe(&id))))
        plane_simulated.push_back(id);
      break;
    case 2: told(graze_plane_simulation_remove_d(plane_simulation, body(plane_simulated))); break;
    case 3:
      if (told(graze_plane_joint_of_kind_d(in.choice<GrazeJointKind>(4), body(plane_simulated), in.maybe(&frame),
                                           body(plane_simulated), &frame, in.maybe(&joint))) &&
          plane_joints.size() < 4 &&
          told(graze_plane_simulation_add_joint_d(plane_simulation, in.maybe(&joint), &joint_id)))
        plane_joints.push_back(joint_id);
      break;
    case 4:
      if (!plane_joints.empty())
        told(graze_plane_simulation_remove_joint_d(plane_simulation, plane_joints[in.byte() % plane_joints.size()]));
      break;
    case 5:
      if (plane_state == nullptr)
        told(graze_plane_simulation_save_d(plane_simulation, in.maybe(&plane_state)));
      else
        told(graze_plane_simulation_restore_d(plane_simulation, in.maybe(plane_state)));
      break;
    case 6:
      told(graze_plane_simulation_apply_impulse_d(plane_simulation, body(plane_simulated), {in.number(), in.number()},
                                                  {in.number(), in.number()}));
      break;
    default: told(graze_plane_simulation_step_d(in.maybe(plane_simulation), in.byte() < 8 ? in.number() : 1.0 / 60));
    }
    told(graze_plane_simulation_pose_d(plane_simulation, body(plane_simulated), in.maybe(&pose)));
    const GrazeJointId* all;
    std::size_t count = 0;
    std::int32_t sub_steps = 0;
    std::uint64_t hash = 0;
    told(graze_plane_simulation_sub_steps_d(plane_simulation, body(plane_simulated), in.maybe(&sub_steps)));
    told(graze_plane_simulation_state_hash_d(plane_simulation, in.maybe(&hash)));
    if (told(graze_plane_simulation_joints_d(plane_simulation, in.maybe(buffer), &all, &count)) && count > 0)
      told(graze_plane_simulation_joint_d(plane_simulation, all[0], buffer, in.maybe(&joint)));
    const GrazePlaneWorldd* borrowed;
    if (told(graze_plane_simulation_world_d(plane_simulation, in.maybe(&borrowed))))
      require(graze_plane_world_update_d(const_cast<GrazePlaneWorldd*>(borrowed), 0) == GRAZE_INVALID_VALUE);
  }

  void run() {
    for (int calls = 0; calls < 40 && !in.empty(); ++calls) switch (in.byte() % 16) {
      case 0:
      case 1:
      case 2: make_shape(); break;
      case 3: ask_shape(); break;
      case 4: ask_blow(); break;
      case 5: ask_pair(); break;
      case 6: ask_ray(); break;
      case 7: ask_cast(); break;
      case 8: ask_batch(); break;
      case 9: change_world(); break;
      case 10: change_simulation(); break;
      case 11: change_plane_world(); break;
      case 12: change_plane_simulation(); break;
      case 13: ask_hull(); break;
      case 14: ask_broad_phase(); break;
      default: plane();
      }
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Calls(Bytes(bytes, size)).run();
  return 0;
}
