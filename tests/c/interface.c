// The C interface from C99: lifetimes, errors that name the value, strides, worlds, simulation and the plane.
#include <graze/graze.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void expect(bool holds, const char* what, int line) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "line %d: expected %s (last error: %s)\n", line, what, graze_last_error());
}
#define EXPECT(condition) expect(condition, #condition, __LINE__)
#define OK(call) expect((call) == GRAZE_OK, #call, __LINE__)

// The call is refused, with that message.
static void expect_refused(GrazeStatus status, const char* message, int line) {
  if (status == GRAZE_INVALID_VALUE && strcmp(graze_last_error(), message) == 0) return;
  ++failures;
  fprintf(stderr, "line %d: expected \"%s\", got status %d, \"%s\"\n", line, message, (int)status, graze_last_error());
}
#define REFUSED(call, message) expect_refused(call, message, __LINE__)

static bool is_near(double a, double b) { return fabs(a - b) <= 1e-9; }

// Bytes that the library wrote.
typedef struct Bytes {
  char kept[8192];
  size_t size;
} Bytes;
static bool keep_bytes(void* user, const void* bytes, size_t size) {
  Bytes* to = user;
  if (size > sizeof to->kept) return false;
  memcpy(to->kept, bytes, size);
  to->size = size;
  return true;
}

static void test_version(void) {
  EXPECT(graze_version() == GRAZE_VERSION);
  EXPECT(strcmp(graze_version_string(), GRAZE_VERSION_STRING) == 0);
}

// Ids and settings by name, so that the macros need no compound literals with commas.
static const GrazeVec3d origin = {0, 0, 0}, unit_size = {1, 1, 1};
static const GrazeBodyId nobody = {7, 3};
static const GrazePosed zero_pose = {{0, 0, 0}, {0, 0, 0, 0}};

static void test_errors(void) {
  GrazeShaped *shape = NULL, *ball = NULL;
  REFUSED(graze_shape_sphere_d(-1, origin, &shape), "radius: expected a finite number >= 0, got -1");
  EXPECT(shape == NULL);
  REFUSED(graze_shape_sphere_d(1, origin, NULL), "shape: expected a pointer, got null");
  OK(graze_shape_sphere_d(1, origin, &ball));
  EXPECT(graze_last_error()[0] != '\0');  // what went before is still told

  const GrazePosed here = graze_pose_identity_d();
  GrazePosed far_off = graze_pose_at_place_d(3, 0, 0);
  GrazeDistanced d;
  memset(&d, 17, sizeof d);
  const GrazeDistanced before = d;
  REFUSED(graze_distance_d(ball, &here, NULL, &far_off, &d), "b: expected a pointer, got null");
  REFUSED(graze_distance_d(ball, &zero_pose, ball, &far_off, &d),
          "pose_a.rotation: expected a quaternion of unit length, got [0, 0, 0, 0]");
  // Poses are returned as they are: what they cannot hold is refused by the call that takes them.
  const double no_angles[3] = {NAN, INFINITY, -INFINITY};
  for (int i = 0; i < 3; ++i) {
    const GrazePosed turned = graze_pose_turned_d(origin, unit_size, no_angles[i]);
    REFUSED(graze_distance_d(ball, &here, ball, &turned, &d),
            "pose_b.rotation: expected a quaternion of unit length, got [nan, nan, nan, nan]");
    const GrazePose2d beside = graze_plane_pose_d(3, 0, 0), in_plane = graze_plane_pose_d(0, 0, no_angles[i]);
    GrazePlaneShaped* disk = NULL;
    GrazePlaneDistanced apart;
    OK(graze_plane_shape_circle_d(1, &disk));
    REFUSED(graze_plane_distance_d(disk, &beside, disk, &in_plane, &apart),
            "pose_b.rotation: expected a unit vector of cosine and sine, got [nan, nan]");
    graze_plane_shape_release_d(disk);
  }
  far_off.translation.y = NAN;
  REFUSED(graze_distance_d(ball, &here, ball, &far_off, &d),
          "pose_b.translation[1]: expected a finite number, got nan");
  EXPECT(memcmp(&d, &before, sizeof d) == 0);  // a call that fails leaves the answer alone
  const GrazeRayd no_direction = {{0, 0, 0}, {1, NAN, 0}},
                  no_origin[2] = {{{5, 0, 0}, {-1, 0, 0}}, {{0, 0, NAN}, {1, 0, 0}}};
  GrazeRayHitd ray_hit[2];
  bool ray_found = false;
  uint8_t rays_found[2] = {7, 7};
  REFUSED(graze_raycast_d(ball, &here, &no_direction, 9, GRAZE_BACK_FACES_HIT, &ray_found, ray_hit),
          "ray.direction[1]: expected a finite number, got nan");
  REFUSED(graze_raycast_batch_d(ball, &here, no_origin, 0, 2, 9, GRAZE_BACK_FACES_HIT, rays_found, 0, ray_hit, 0),
          "rays[1].origin[2]: expected a finite number, got nan");
  EXPECT(rays_found[0] == 7);

  // A handle of another kind, as from a language whose pointers have no type.
  GrazeShapef* small = NULL;
  const GrazeVec3f small_origin = {0, 0, 0};
  OK(graze_shape_sphere_f(1, small_origin, &small));
  const void* any = small;
  REFUSED(graze_distance_d(ball, &here, (const GrazeShaped*)any, &here, &d),
          "b: expected a shape of the function's scalar, got a handle of another kind");
  graze_shape_release_f(small);

  REFUSED(graze_shape_mesh_d(NULL, 0, 3, NULL, 0, 0, GRAZE_SIDES_BOTH, false, &shape),
          "points: expected a pointer, got null");
  REFUSED(graze_shape_height_field_d(NULL, 0, SIZE_MAX, 2, NULL, 1, 1, GRAZE_SIDES_BOTH, &shape),
          "rows: expected a number of heights that fits in memory, got 2");
  bool found;
  GrazeRayHitd hit;
  const GrazeRayd ray = {{-5, 0, 0}, {1, 0, 0}};
  REFUSED(graze_raycast_d(ball, &here, &ray, 9, (GrazeBackFaces)2, &found, &hit),
          "back: expected an enumerator from 0 to 1, got 2");
  REFUSED(graze_raycast_d(ball, &here, &ray, -1, GRAZE_BACK_FACES_HIT, &found, &hit),
          "length: expected a number >= 0, got -1");
  GrazeWorldd* world;
  OK(graze_world_create_d(NULL, NULL, &world));
  EXPECT(graze_world_remove_d(world, nobody) == GRAZE_INVALID_VALUE);
  EXPECT(graze_world_update_d(world, -1) == GRAZE_INVALID_VALUE);
  graze_world_destroy_d(world);
  graze_shape_release_d(ball);
  // Nothing to release is no mistake.
  graze_shape_release_d(NULL), graze_buffer_destroy_d(NULL), graze_world_destroy_d(NULL);
  graze_simulation_destroy_d(NULL), graze_state_destroy_d(NULL), graze_plane_shape_release_d(NULL);
}

static int released = 0;
static void count_release(void* user) { released += *(int*)user; }
static GrazeVec3d ball_support(const void* user, GrazeVec3d direction) {
  const double length = sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
  (void)user;
  direction.x /= length, direction.y /= length, direction.z /= length;
  return direction;
}

static void test_shapes(void) {
  int one = 1;
  GrazeShaped *own, *compound, *rounded;
  OK(graze_shape_user_d(ball_support, count_release, &one, &own));
  GrazeChildd children[2] = {{NULL, graze_pose_at_place_d(-2, 0, 0)}, {NULL, graze_pose_at_place_d(2, 0, 0)}};
  EXPECT(graze_shape_compound_d(children, 0, 2, &compound) == GRAZE_INVALID_VALUE);
  EXPECT(strcmp(graze_last_error(), "children[0].shape: expected a pointer, got null") == 0);
  children[0].shape = children[1].shape = own;
  OK(graze_shape_compound_d(children, 0, 2, &compound));
  graze_shape_retain_d(own);
  graze_shape_release_d(own), graze_shape_release_d(own);
  EXPECT(released == 0);  // the compound has its own share

  const GrazePosed here = graze_pose_identity_d(), above = graze_pose_at_place_d(0, 3, 0);
  GrazeDistanced d;
  OK(graze_distance_d(compound, &here, compound, &above, &d));
  EXPECT(fabs(d.distance - 1) < 1e-6);
  GrazeShapeKind kind;
  OK(graze_shape_kind_d(compound, &kind));
  EXPECT(kind == GRAZE_COMPOUND);
  EXPECT(graze_shape_rounded_d(compound, 1, &rounded) == GRAZE_INVALID_VALUE);
  graze_shape_release_d(compound);
  EXPECT(released == 1);

  GrazeShaped* box;
  OK(graze_shape_box_d(unit_size, &box));
  OK(graze_shape_rounded_d(box, 0.25, &rounded));
  graze_shape_release_d(box);
  double rounding;
  OK(graze_shape_rounding_d(rounded, &rounding));
  EXPECT(rounding == 0.25);
  GrazeAabbd bounds;
  OK(graze_shape_bounds_d(rounded, &here, &bounds));
  EXPECT(is_near(bounds.upper.x, 0.75));
  GrazeMassPropertiesd mass;
  OK(graze_shape_mass_properties_d(rounded, &mass));
  EXPECT(mass.volume > 1 && mass.volume < 3.375);
  graze_shape_release_d(rounded);
}

// A caller's own struct, in which positions, turns and shapes stand among other things.
typedef struct Thing {
  char name[3];
  GrazeVec3d place;
  int health;
  GrazeQuatd turn;
  const GrazeShaped* shape;
  uint8_t touches;
  GrazeDistanced apart;
} Thing;

static void test_strides(void) {
  enum { count = 3000 };  // more than are gathered at a time
  GrazeShaped* shapes[2];
  OK(graze_shape_box_d(unit_size, &shapes[0]));
  OK(graze_shape_sphere_d(0.5, origin, &shapes[1]));
  Thing* things = calloc(count, sizeof *things);
  for (int i = 0; i < count; ++i) {
    const GrazePosed p = graze_pose_turned_d(origin, (GrazeVec3d){0, 0, 1}, 0.01 * i);
    things[i].place.x = 0.001 * i;
    things[i].turn = p.rotation;
    things[i].shape = shapes[i % 2];
  }
  const GrazePosed here = graze_pose_at_place_d(1.2, 0.7, 0.1);
  const GrazeShaped* box = shapes[0];
  GrazeBatchd batch;
  memset(&batch, 0, sizeof batch);
  batch.a = graze_bodies_d(&box, 1, &here, 1);
  batch.b.shapes = (const GrazeShaped* const*)&things[0].shape;
  batch.b.shape_count = batch.b.pose_count = count;
  batch.b.translations = &things[0].place;
  batch.b.rotations = &things[0].turn;
  batch.b.shape_stride = batch.b.translation_stride = batch.b.rotation_stride = sizeof(Thing);
  size_t size;
  OK(graze_batch_size_d(&batch, &size));
  EXPECT(size == count);
  OK(graze_overlap_batch_d(&batch, &things[0].touches, sizeof(Thing), NULL));
  OK(graze_distance_batch_d(&batch, &things[0].apart, sizeof(Thing), NULL));
  int touching = 0;
  for (int i = 0; i < count; ++i) {
    const GrazePosed p = {things[i].place, things[i].turn};
    bool touch;
    GrazeDistanced d;
    OK(graze_overlap_d(box, &here, things[i].shape, &p, &touch));
    OK(graze_distance_d(box, &here, things[i].shape, &p, &d));
    EXPECT(touch == things[i].touches);
    EXPECT(d.distance == things[i].apart.distance && d.normal.y == things[i].apart.normal.y);
    touching += touch;
  }
  EXPECT(touching > 100 && touching < count - 100);

  // A body that is not there, a rotation that is none: refused by its place, and nothing is written.
  things[2000].turn.w = 5;
  things[0].apart.distance = 77;
  EXPECT(graze_distance_batch_d(&batch, &things[0].apart, sizeof(Thing), NULL) == GRAZE_INVALID_VALUE);
  EXPECT(strncmp(graze_last_error(), "batch.b.poses[2000].rotation: expected", 38) == 0);
  EXPECT(things[0].apart.distance == 77);
  free(things);
  graze_shape_release_d(shapes[0]), graze_shape_release_d(shapes[1]);
}

static size_t two_threads(void* user) {
  (void)user;
  return 2;
}
static void run_in_turn(void* user, size_t count, void (*task)(void* context, size_t i), void* context) {
  *(size_t*)user += count;
  for (size_t i = count; i-- > 0;) task(context, i);
}
static bool never(void* user, GrazeBodyId a, GrazeBodyId b) {
  (void)user, (void)a, (void)b;
  return false;
}

static void test_world(void) {
  size_t tasks = 0;
  const GrazeExecutor executor = {two_threads, run_in_turn, &tasks};
  GrazeWorldd* world;
  GrazeBufferd* buffer;
  GrazeShaped* box;
  OK(graze_world_create_d(NULL, &executor, &world));
  OK(graze_buffer_create_d(&buffer));
  OK(graze_shape_box_d(unit_size, &box));
  GrazeBodyId ids[10];
  for (int i = 0; i < 10; ++i) {
    GrazeBodyd body = graze_body_default_d(box);
    body.pose = graze_pose_at_place_d(0.95 * i, 0, 0);
    OK(graze_world_add_d(world, &body, &ids[i]));
  }
  OK(graze_world_update_d(world, 0));
  EXPECT(tasks > 0);
  GrazeWorldContactsd contacts;
  OK(graze_world_contacts_d(world, &contacts));
  EXPECT(contacts.pair_count == 9 && contacts.manifold_count == 9 && contacts.point_count == 36);
  EXPECT(contacts.pairs[0].a == 0 && contacts.pairs[0].b == 1 && contacts.pairs[0].overlap);
  EXPECT(is_near(contacts.points[0].distance, -0.05) && contacts.points[0].weight == 0.5);
  GrazeSolverPointd* points;
  size_t count;
  OK(graze_world_solver_points_d(world, &points, &count));
  EXPECT(count == 36 && points == contacts.points);
  points[0].impulse.x = 4;
  OK(graze_world_update_d(world, 0));
  OK(graze_world_contacts_d(world, &contacts));
  EXPECT(contacts.points[0].impulse.x == 4);
  const GrazeContactEvent* events;
  OK(graze_world_events_d(world, &events, &count));
  EXPECT(count == 9 && events[0].kind == GRAZE_EVENT_STAY && events[8].pair == 8);

  const GrazeBodyId* bodies;
  const GrazePosed here = graze_pose_at_place_d(4, 0, 0);
  OK(graze_world_overlapping_d(world, box, &here, NULL, buffer, &bodies, &count));
  EXPECT(count == 2 && bodies[0].index == 4 && bodies[1].index == 5);
  const GrazeRayd ray = {{-5, 0.1, 0}, {1, 0, 0}};
  bool found;
  GrazeBodyRayHitd hit;
  OK(graze_world_raycast_d(world, &ray, INFINITY, NULL, GRAZE_BACK_FACES_HIT, &found, &hit));
  EXPECT(found && hit.body.index == 0 && is_near(hit.hit.t, 4.5));
  const GrazeBodyDistanced* distances;
  OK(graze_world_nearest_d(world, box, &here, 3, INFINITY, NULL, buffer, &distances, &count));
  EXPECT(count == 3);

  GrazeBodyd body;
  OK(graze_world_body_d(world, ids[3], &body));
  EXPECT(is_near(body.pose.translation.x, 2.85) && body.filter.category == 1);
  graze_shape_release_d(body.shape);

  GrazePosed poses[10];
  for (int i = 0; i < 10; ++i) poses[i] = graze_pose_at_place_d(2.0 * i, 0, 0);
  OK(graze_world_move_batch_d(world, ids, 0, poses, 0, NULL, 0, 10));
  OK(graze_world_update_d(world, 0));
  OK(graze_world_events_d(world, &events, &count));
  EXPECT(count == 9 && events[0].kind == GRAZE_EVENT_END && events[0].pair == GRAZE_NO_PAIR);

  // Velocities come along, here between others; one that is refused moves nothing.
  GrazeVelocityd velocities[20];
  for (int i = 0; i < 20; ++i) velocities[i] = (GrazeVelocityd){{i, 0, 1}, {0, i, 0}};
  OK(graze_world_move_batch_d(world, ids, 0, poses, 0, velocities, 2 * sizeof *velocities, 10));
  OK(graze_world_body_d(world, ids[3], &body));
  EXPECT(body.linear.x == 6 && body.linear.z == 1 && body.angular.y == 6);
  graze_shape_release_d(body.shape);
  GrazePosed elsewhere[2] = {graze_pose_at_place_d(1, 1, 1), graze_pose_at_place_d(2, 2, 2)};
  velocities[1].angular.z = INFINITY;
  REFUSED(graze_world_move_batch_d(world, ids, 0, elsewhere, 0, velocities, 0, 2),
          "velocities[1].angular[2]: expected a finite number, got inf");
  OK(graze_world_body_d(world, ids[0], &body));
  EXPECT(body.pose.translation.x == 0 && body.linear.x == 0);
  graze_shape_release_d(body.shape);

  OK(graze_world_set_allow_d(world, never, NULL));
  OK(graze_world_move_d(world, ids[1], &poses[0], NULL));
  OK(graze_world_update_d(world, 0));
  OK(graze_world_contacts_d(world, &contacts));
  EXPECT(contacts.pair_count == 0);

  OK(graze_world_remove_d(world, ids[2]));
  bool contains;
  OK(graze_world_contains_d(world, ids[2], &contains));
  EXPECT(!contains);
  EXPECT(graze_world_move_batch_d(world, ids, 0, poses, 0, NULL, 0, 10) == GRAZE_INVALID_VALUE);
  EXPECT(strcmp(graze_last_error(), "ids[2]: expected a body of the world, got 2 of generation 0, which is not there") == 0);
  size_t indices;
  OK(graze_world_counts_d(world, &count, &indices));
  EXPECT(count == 9 && indices == 10);
  graze_shape_release_d(box);
  graze_world_destroy_d(world), graze_buffer_destroy_d(buffer);
}

static void test_simulation(void) {
  GrazeSimulationSettingsd settings = graze_simulation_settings_default_d();
  EXPECT(settings.gravity.y == -9.81 && settings.sub_steps == 4);
  settings.sub_steps = 3;
  GrazeSimulationd* simulation;
  REFUSED(graze_simulation_create_d(&settings, NULL, &simulation),
          "sub_steps: expected a power of two from 1 to 1024, got 3");
  OK(graze_simulation_create_d(NULL, NULL, &simulation));
  GrazeShaped* ball;
  OK(graze_shape_sphere_d(0.5, origin, &ball));
  GrazeBodyd body = graze_body_default_d(ball);
  GrazeDynamicsd dynamics = graze_dynamics_default_d();
  dynamics.has_mass = true;
  dynamics.mass = -1;
  GrazeBodyId id, other;
  EXPECT(graze_simulation_add_d(simulation, &body, &dynamics, NULL, &id) == GRAZE_INVALID_VALUE);
  dynamics.mass = 2;
  OK(graze_simulation_add_d(simulation, &body, &dynamics, NULL, &id));
  body.pose = graze_pose_at_place_d(2, 0, 0);
  OK(graze_simulation_add_d(simulation, &body, NULL, NULL, &other));
  double mass;
  OK(graze_simulation_mass_d(simulation, id, &mass));
  EXPECT(mass == 2);

  GrazeStated* state;
  OK(graze_simulation_save_d(simulation, &state));
  GrazePosed first, again;
  for (int i = 0; i < 30; ++i) OK(graze_simulation_step_d(simulation, 1.0 / 60));
  OK(graze_simulation_pose_d(simulation, id, &first));
  EXPECT(fabs(first.translation.y + 0.5 * 9.81 * 0.25) < 0.1);
  OK(graze_simulation_restore_d(simulation, state));
  for (int i = 0; i < 30; ++i) OK(graze_simulation_step_d(simulation, 1.0 / 60));
  OK(graze_simulation_pose_d(simulation, id, &again));
  EXPECT(memcmp(&first, &again, sizeof first) == 0);

  static Bytes bytes;
  GrazeStated* read;
  OK(graze_state_bytes_d(state, keep_bytes, &bytes));
  graze_state_destroy_d(state);
  OK(graze_state_read_d(bytes.kept, bytes.size, &read));
  OK(graze_simulation_restore_d(simulation, read));
  graze_state_destroy_d(read);
  for (int i = 0; i < 30; ++i) OK(graze_simulation_step_d(simulation, 1.0 / 60));
  OK(graze_simulation_pose_d(simulation, id, &again));
  EXPECT(memcmp(&first, &again, sizeof first) == 0);
  EXPECT(graze_state_read_d(bytes.kept, bytes.size - 1, &read) == GRAZE_INVALID_VALUE);
  EXPECT(graze_state_read_d(NULL, 3, &read) == GRAZE_INVALID_VALUE);

  const GrazeWorldd* world;
  const GrazeSimulationd* whose;
  OK(graze_simulation_world_d(simulation, &world));
  OK(graze_world_simulation_d(world, &whose));
  EXPECT(whose == simulation);
  size_t count, indices;
  OK(graze_world_counts_d(world, &count, &indices));
  EXPECT(count == 2);
  EXPECT(graze_world_remove_d((GrazeWorldd*)world, id) == GRAZE_INVALID_VALUE);  // it belongs to the simulation
  graze_world_destroy_d((GrazeWorldd*)world);

  GrazeJointd joint;
  GrazeJointId joint_id;
  const GrazePosed here = graze_pose_identity_d();
  OK(graze_joint_of_kind_d(GRAZE_JOINT_BALL, id, &here, other, &here, &joint));
  GrazeJointLimitd limit = joint.limits[0];
  limit.max = 2;  // a rope
  joint.limits = &limit;
  OK(graze_simulation_add_joint_d(simulation, &joint, &joint_id));
  OK(graze_simulation_step_d(simulation, 1.0 / 60));
  const double* impulses;
  OK(graze_simulation_joint_impulses_d(simulation, joint_id, &impulses, &count));
  EXPECT(count > 0);
  limit.space = 9;
  EXPECT(graze_simulation_add_joint_d(simulation, &joint, &joint_id) == GRAZE_INVALID_VALUE);
  EXPECT(strcmp(graze_last_error(), "joint.limits[0].space: expected an enumerator from 0 to 1, got 9") == 0);
  OK(graze_simulation_remove_joint_d(simulation, joint_id));
  GrazeStepReportd report;
  OK(graze_simulation_report_d(simulation, &report));
  EXPECT(report.awake == 2);
  graze_shape_release_d(ball);
  graze_simulation_destroy_d(simulation);
}

static void test_plane(void) {
  GrazePlaneShaped *box, *chain, *circle;
  GrazeBufferd* buffer;
  OK(graze_buffer_create_d(&buffer));
  const GrazeVec2d size = {2, 2}, corners[3] = {{-5, 0}, {0, 0}, {5, 1}};
  OK(graze_plane_shape_box_d(size, &box));
  OK(graze_plane_shape_chain_d(corners, 0, 3, false, GRAZE_SIDES_BOTH, &chain));
  OK(graze_plane_shape_circle_d(0.5, &circle));
  const GrazePose2d here = graze_plane_pose_d(0, 0, 0), there = graze_plane_pose_d(1.4, 0, 0.3);
  GrazePlaneDistanced d;
  OK(graze_plane_distance_d(box, &here, circle, &there, &d));
  EXPECT(is_near(d.distance, -0.1) && is_near(d.normal.x, 1));
  GrazePlaneContactsd contacts;
  const GrazePose2d above = graze_plane_pose_d(-2.5, 0.99, 0);
  OK(graze_plane_contacts_d(chain, &here, box, &above, 0, buffer, &contacts));
  EXPECT(contacts.overlap && contacts.point_count == 2);
  OK(graze_plane_contacts_reduced_d(chain, &here, box, &above, 0, 1, buffer, &contacts));
  EXPECT(contacts.overlap && contacts.manifold_count == 1 && contacts.point_count == 1);
  REFUSED(graze_plane_contacts_reduced_d(chain, &here, box, &above, 0, 0, buffer, &contacts),
          "most: expected a number >= 1, got 0");
  const GrazePlaneShaped* shapes[2];
  shapes[0] = box, shapes[1] = circle;
  const GrazePose2d poses[2] = {graze_plane_pose_d(3, 0, 0), graze_plane_pose_d(1.2, 0, 0)};
  GrazePlaneBatchd batch;
  memset(&batch, 0, sizeof batch);
  batch.a = graze_plane_bodies_d(shapes, 1, &here, 1);
  batch.b = graze_plane_bodies_d(shapes, 2, poses, 2);
  uint8_t touch[2];
  OK(graze_plane_overlap_batch_d(&batch, touch, 0, NULL));
  EXPECT(touch[0] == 0 && touch[1] == 1);
  const GrazeIdPair places[1] = {{0, 2}};
  batch.places = places;
  batch.place_count = 1;
  REFUSED(graze_plane_overlap_batch_d(&batch, touch, 0, NULL), "batch.places[0].b: expected a place in batch.b, got 2");
  const GrazePose2d none = {{0, 0}, {0, 0}};
  REFUSED(graze_plane_distance_d(box, &none, circle, &there, &d),
          "pose_a.rotation: expected a unit vector of cosine and sine, got [0, 0]");
  graze_plane_shape_release_d(box), graze_plane_shape_release_d(chain), graze_plane_shape_release_d(circle);
  graze_buffer_destroy_d(buffer);
}

static void test_plane_world(void) {
  size_t tasks = 0;
  const GrazeExecutor executor = {two_threads, run_in_turn, &tasks};
  GrazePlaneWorldd* world;
  GrazeBufferd* buffer;
  GrazePlaneShaped *box, *ground;
  OK(graze_plane_world_create_d(NULL, &executor, &world));
  OK(graze_buffer_create_d(&buffer));
  const GrazeVec2d size = {1, 1};
  OK(graze_plane_shape_box_d(size, &box));
  OK(graze_plane_shape_half_plane_d(&ground));
  GrazePlaneBodyd body = graze_plane_body_default_d(ground);
  GrazeBodyId floor_id, ids[10];
  body.fixed = true;
  OK(graze_plane_world_add_d(world, &body, &floor_id));
  graze_plane_shape_release_d(ground);  // the world keeps a share of its own
  for (int i = 0; i < 10; ++i) {
    body = graze_plane_body_default_d(box);
    body.pose = graze_plane_pose_d(2.0 * i, 0.49, 0);
    OK(graze_plane_world_add_d(world, &body, &ids[i]));
  }
  OK(graze_plane_world_update_d(world, 0));
  EXPECT(tasks > 0);
  GrazePlaneWorldContactsd contacts;
  OK(graze_plane_world_contacts_d(world, &contacts));
  EXPECT(contacts.pair_count == 10 && contacts.manifold_count == 10 && contacts.point_count == 20);
  EXPECT(contacts.pairs[0].a == 0 && contacts.pairs[0].b == 1 && contacts.pairs[0].overlap);
  EXPECT(is_near(contacts.points[0].distance, -0.01) && is_near(contacts.manifolds[0].normal.y, 1));
  GrazePlaneSolverPointd* points;
  size_t count, indices;
  OK(graze_plane_world_solver_points_d(world, &points, &count));
  EXPECT(count == 20 && points == contacts.points);
  points[0].impulse.y = 4;
  OK(graze_plane_world_update_d(world, 0));
  OK(graze_plane_world_contacts_d(world, &contacts));
  EXPECT(contacts.points[0].impulse.y == 4);
  const GrazeContactEvent* events;
  OK(graze_plane_world_events_d(world, &events, &count));
  EXPECT(count == 10 && events[0].kind == GRAZE_EVENT_STAY && events[9].pair == 9);
  OK(graze_plane_world_reduce_d(world, 1));
  OK(graze_plane_world_contacts_d(world, &contacts));
  EXPECT(contacts.point_count == 10);

  const GrazePlaneRayd ray = {{4, 9}, {0, -2}};
  bool found;
  GrazePlaneBodyRayHitd hit;
  OK(graze_plane_world_raycast_d(world, &ray, INFINITY, NULL, &found, &hit));
  EXPECT(found && hit.body.index == ids[2].index && is_near(hit.hit.t, 8.01));
  const GrazeBodyId* bodies;
  const GrazePose2d here = graze_plane_pose_d(1, 3, 0);
  OK(graze_plane_world_overlapping_d(world, box, &here, NULL, buffer, &bodies, &count));
  EXPECT(count == 0);
  const GrazePlaneBodyDistanced* distances;
  OK(graze_plane_world_nearest_d(world, box, &here, 3, 2, NULL, buffer, &distances, &count));
  EXPECT(count == 2 && is_near(distances[0].distance.distance, hypot(0, 3 - 1.49)));
  const GrazePlaneMovingd falling = {box, here, {{0.5, -4}, 0}};
  GrazePlaneBodyCastHitd cast;
  OK(graze_plane_world_cast_d(world, &falling, 2, NULL, GRAZE_SEPARATING_HIT, &found, &cast));
  EXPECT(found && fabs(cast.hit.t - 1.51 / 4) < 1e-6 && is_near(cast.hit.normal.y, -1));

  // What is refused names the value and changes nothing.
  const GrazePose2d poses[2] = {graze_plane_pose_d(0, 5, 0), {{0, 7}, {0, 0}}};
  REFUSED(graze_plane_world_move_batch_d(world, ids, 0, poses, 0, NULL, 0, 2),
          "poses[1].rotation: expected a unit vector of cosine and sine, got [0, 0]");
  OK(graze_plane_world_body_d(world, ids[0], &body));
  EXPECT(is_near(body.pose.translation.y, 0.49) && body.filter.category == 1 && !body.fixed);
  graze_plane_shape_release_d(body.shape);
  const GrazePlaneVelocityd spin = {{0, 0}, NAN};
  REFUSED(graze_plane_world_move_d(world, ids[0], &here, &spin), "velocity.angular: expected a finite number, got nan");
  const void* any = buffer;
  REFUSED(graze_plane_world_update_d((GrazePlaneWorldd*)any, 0),
          "world: expected a plane's world of the function's scalar, got a handle of another kind");
  REFUSED(graze_plane_world_reduce_d(world, 0), "most: expected a number >= 1, got 0");

  const GrazePlaneVelocityd velocity = {{0, 3}, 0.5};
  OK(graze_plane_world_move_d(world, ids[0], &here, &velocity));
  OK(graze_plane_world_set_fast_d(world, ids[0], true));
  const GrazePose2d above = graze_plane_pose_d(1, 6, 0);
  OK(graze_plane_world_move_d(world, ids[1], &above, NULL));
  OK(graze_plane_world_update_d(world, 1));
  const GrazePlaneImpactd* impacts;
  OK(graze_plane_world_impacts_d(world, &impacts, &count));
  EXPECT(count == 1 && impacts[0].a.index == ids[0].index && impacts[0].hit.t > 0.5 && impacts[0].hit.t < 2.0 / 3);
  OK(graze_plane_world_set_allow_d(world, never, NULL));
  OK(graze_plane_world_remove_d(world, ids[2]));
  OK(graze_plane_world_contains_d(world, ids[2], &found));
  EXPECT(!found);
  OK(graze_plane_world_counts_d(world, &count, &indices));
  EXPECT(count == 10 && indices == 11);
  graze_plane_shape_release_d(box);
  graze_plane_world_destroy_d(world), graze_plane_world_destroy_d(NULL), graze_buffer_destroy_d(buffer);
}

static void test_plane_simulation(void) {
  GrazePlaneSimulationSettingsd settings = graze_plane_simulation_settings_default_d();
  EXPECT(settings.gravity.y == -9.81 && settings.sub_steps == 4);
  settings.longest_step = -1;
  GrazePlaneSimulationd* simulation;
  REFUSED(graze_plane_simulation_create_d(&settings, NULL, &simulation),
          "longest_step: expected a finite number > 0, got -1");
  OK(graze_plane_simulation_create_d(NULL, NULL, &simulation));
  GrazePlaneShaped *ball, *ground;
  OK(graze_plane_shape_circle_d(0.5, &ball));
  OK(graze_plane_shape_box_d((GrazeVec2d){20, 1}, &ground));
  GrazePlaneBodyd body = graze_plane_body_default_d(ground);
  body.fixed = true;
  body.pose = graze_plane_pose_d(0, -0.5, 0);
  GrazeBodyId floor, id;
  OK(graze_plane_simulation_add_d(simulation, &body, NULL, NULL, &floor));
  body = graze_plane_body_default_d(ball);
  body.pose = graze_plane_pose_d(0, 1.5, 0);
  GrazePlaneDynamicsd dynamics = graze_plane_dynamics_default_d();
  dynamics.has_inertia = true;
  dynamics.inertia = -1;
  EXPECT(graze_plane_simulation_add_d(simulation, &body, &dynamics, NULL, &id) == GRAZE_INVALID_VALUE);
  dynamics.has_mass = true;
  dynamics.mass = 2;
  dynamics.inertia = 0.25;
  OK(graze_plane_simulation_add_d(simulation, &body, &dynamics, NULL, &id));
  for (int i = 0; i < 120; ++i) OK(graze_plane_simulation_step_d(simulation, 1.0 / 60));
  GrazePose2d pose;
  OK(graze_plane_simulation_pose_d(simulation, id, &pose));
  EXPECT(fabs(pose.translation.y - 0.5) < 0.01);
  bool asleep;
  OK(graze_plane_simulation_asleep_d(simulation, id, &asleep));
  EXPECT(asleep);
  OK(graze_plane_simulation_apply_angular_impulse_d(simulation, id, 0.5));
  double momentum;
  OK(graze_plane_simulation_angular_momentum_d(simulation, id, &momentum));
  EXPECT(fabs(momentum - 0.5) < 1e-6);

  const GrazePose2d here = graze_plane_pose_d(0, 0, 0);
  GrazePlaneJointd joint;
  REFUSED(graze_plane_joint_of_kind_d((GrazeJointKind)9, floor, &here, id, &here, &joint),
          "kind: expected an enumerator from 0 to 3, got 9");
  OK(graze_plane_joint_of_kind_d(GRAZE_JOINT_HINGE, floor, &here, id, &here, &joint));
  const GrazeJointLimitd about_x = {GRAZE_JOINT_ANGULAR, {true, false, false}, 0, 0, 0, 0};
  joint.limits = &about_x;
  GrazeJointId joint_id;
  EXPECT(graze_plane_simulation_add_joint_d(simulation, &joint, &joint_id) == GRAZE_INVALID_VALUE);

  const GrazePlaneWorldd* world;
  const GrazePlaneSimulationd* whose;
  OK(graze_plane_simulation_world_d(simulation, &world));
  OK(graze_plane_world_simulation_d(world, &whose));
  EXPECT(whose == simulation);
  EXPECT(graze_plane_world_remove_d((GrazePlaneWorldd*)world, id) == GRAZE_INVALID_VALUE);  // the simulation's
  graze_plane_world_destroy_d((GrazePlaneWorldd*)world);
  OK(graze_plane_simulation_remove_d(simulation, id));
  REFUSED(graze_plane_simulation_pose_d(simulation, id, &pose),
          "id: expected a body of the simulation, got 1 of generation 0, which is not there");
  graze_plane_shape_release_d(ball), graze_plane_shape_release_d(ground);
  graze_plane_simulation_destroy_d(simulation);
  graze_plane_simulation_destroy_d(NULL), graze_plane_state_destroy_d(NULL);
}

/* What a renderer was told, by layers. */
typedef struct Drawn {
  int points[9], lines[9], triangles[9], texts;
  double lowest;
} Drawn;

static void draw_point(void* user, const double at[3], GrazeDrawLayer layer, GrazeDrawMeaning meaning) {
  (void)at, (void)meaning;
  ++((Drawn*)user)->points[layer];
}
static void draw_line(void* user, const double from[3], const double to[3], GrazeDrawLayer layer,
                      GrazeDrawMeaning meaning) {
  (void)from, (void)to, (void)meaning;
  ++((Drawn*)user)->lines[layer];
}
static void draw_triangle(void* user, const double a[3], const double b[3], const double c[3], GrazeDrawLayer layer,
                          GrazeDrawMeaning meaning) {
  Drawn* drawn = user;
  (void)meaning;
  ++drawn->triangles[layer];
  drawn->lowest = fmin(drawn->lowest, fmin(a[1], fmin(b[1], c[1])));
}
static void draw_text(void* user, const double at[3], const char* words, GrazeDrawLayer layer,
                      GrazeDrawMeaning meaning) {
  (void)at, (void)layer, (void)meaning;
  if (words[0] != '\0') ++((Drawn*)user)->texts;
}

static void test_draw(void) {
  GrazeShaped* box;
  OK(graze_shape_box_d((GrazeVec3d){1, 1, 1}, &box));
  GrazeWorldd* world;
  OK(graze_world_create_d(NULL, NULL, &world));
  GrazeBodyd body = graze_body_default_d(box);
  GrazeBodyId id;
  OK(graze_world_add_d(world, &body, &id));
  body.pose = graze_pose_at_place_d(0, 0.99, 0);
  OK(graze_world_add_d(world, &body, &id));
  OK(graze_world_update_d(world, 0));

  Drawn drawn = {{0}, {0}, {0}, 0, 1};
  GrazeDebugDraw on = graze_debug_draw_default();
  OK(graze_world_draw_d(world, &on)); /* nothing to draw with draws nothing */
  on.point = draw_point, on.line = draw_line, on.triangle = draw_triangle, on.text = draw_text, on.user = &drawn;
  OK(graze_world_draw_area_d(world, &on));
  EXPECT(is_near(on.center[1], 0.495) && on.size > 1.98);
  OK(graze_world_draw_d(world, &on));
  EXPECT(drawn.triangles[GRAZE_DRAW_SHAPES] == 24 && drawn.points[GRAZE_DRAW_CONTACTS] == 4 &&
         drawn.lines[GRAZE_DRAW_BOUNDS] == 24 && is_near(drawn.lowest, -0.5));
  EXPECT(drawn.lines[GRAZE_DRAW_TREE] >= 24);
  on.layers = 1u << GRAZE_DRAW_CONTACTS;
  OK(graze_world_draw_d(world, &on));
  EXPECT(drawn.triangles[GRAZE_DRAW_SHAPES] == 24 && drawn.points[GRAZE_DRAW_CONTACTS] == 8);

  on.layers = ~0u;
  GrazeTrace* trace;
  REFUSED(graze_trace_create(NULL), "trace: expected a pointer, got null");
  OK(graze_trace_create(&trace));
  const GrazePosed here = graze_pose_identity_d();
  bool touch;
  OK(graze_overlap_explained_d(box, &here, box, &body.pose, &touch, trace));
  OK(graze_trace_draw(trace, &on));
  EXPECT(touch && drawn.texts == 1 && drawn.lines[GRAZE_DRAW_TRACE] > 3);
  GrazeTraceView view;
  OK(graze_trace_view(trace, &view));
  const int before = drawn.lines[GRAZE_DRAW_TRACE];
  OK(graze_trace_step_draw(trace, view.axis_count - 1, &on)); /* two intervals, their overlap, and the name */
  EXPECT(drawn.texts == 2 && drawn.lines[GRAZE_DRAW_TRACE] == before + 3);
  EXPECT(graze_trace_step_draw(trace, 1000, &on) == GRAZE_INVALID_VALUE);
  const int texts = drawn.texts, lines = drawn.lines[GRAZE_DRAW_TRACE];
  OK(graze_trace_view_draw(&view, &on)); /* what the trace itself drew */
  EXPECT(drawn.texts == texts + 1 && drawn.lines[GRAZE_DRAW_TRACE] == lines + before);
  OK(graze_trace_view_step_draw(&view, view.axis_count - 1, &on));
  EXPECT(drawn.texts == texts + 2 && drawn.lines[GRAZE_DRAW_TRACE] == lines + before + 3);
  view.gjk_count = 1, view.gjk = NULL;
  EXPECT(graze_trace_view_draw(&view, &on) == GRAZE_INVALID_VALUE);
  uint8_t rgb[3];
  OK(graze_draw_color(GRAZE_MEANS_CONTACT, rgb));
  EXPECT(rgb[0] > rgb[1]);
  OK(graze_shape_draw_d(box, &here, GRAZE_MEANS_B, &on));
  EXPECT(drawn.triangles[GRAZE_DRAW_SHAPES] == 36);

  GrazeJointd joint;
  OK(graze_joint_of_kind_d(GRAZE_JOINT_BALL, id, &body.pose, id, &here, &joint));
  OK(graze_joint_draw_d(&joint, &here, &here, &on));
  EXPECT(drawn.lines[GRAZE_DRAW_JOINTS] == 3 && drawn.points[GRAZE_DRAW_JOINTS] == 2);
  const GrazePose2d there = graze_plane_pose_d(0, 0, 0);
  GrazePlaneJointd flat = {0};
  flat.frame_a = there, flat.frame_b = there;
  OK(graze_plane_joint_draw_d(&flat, &there, &there, &on));
  EXPECT(drawn.lines[GRAZE_DRAW_JOINTS] == 6 && drawn.points[GRAZE_DRAW_JOINTS] == 4);
  REFUSED(graze_joint_draw_d(NULL, &here, &here, &on), "joint: expected a pointer, got null");
  const GrazeAabbd boxes[2] = {{{0, 0, 0}, {1, 2, 3}}, {{0, 0, 0}, {1, 1, 0}}};
  const int of_world = drawn.lines[GRAZE_DRAW_TREE];
  OK(graze_tree_draw_d(boxes, 2, &on));
  EXPECT(drawn.lines[GRAZE_DRAW_TREE] == of_world + 12 + 4);
  OK(graze_tree_draw_d(NULL, 0, &on));
  REFUSED(graze_tree_draw_d(NULL, 1, &on), "boxes: expected a pointer, got null");

  REFUSED(graze_world_draw_d(world, NULL), "on: expected a pointer, got null");
  on.size = 0;
  REFUSED(graze_world_draw_d(world, &on), "on.size: expected a size > 0, got 0");
  on.size = 1;
  REFUSED(graze_shape_draw_d(box, &here, (GrazeDrawMeaning)99, &on),
          "meaning: expected an enumerator from 0 to 15, got 99");
  graze_trace_destroy(trace), graze_world_destroy_d(world), graze_shape_release_d(box);
}

static void test_broad_phase(void) {
  GrazeBroadPhased* broad = NULL;
  GrazeBufferd* buffer;
  OK(graze_buffer_create_d(&buffer));
  REFUSED(graze_broad_phase_create_d((GrazeBroadPhaseKind)6, &broad),
          "kind: expected an enumerator from 0 to 5, got 6");
  OK(graze_broad_phase_create_d(GRAZE_HASHED_GRID, &broad));
  const GrazeAabbd unit = {{0, 0, 0}, {1, 1, 1}}, shifted = {{0.5, 0, 0}, {1.5, 1, 1}}, turned = {{1, 0, 0}, {0, 1, 1}};
  const GrazeAabbd nowhere = {{0, NAN, 0}, {1, 1, 1}};
  OK(graze_broad_phase_insert_d(broad, 4, &unit));
  OK(graze_broad_phase_insert_d(broad, 2, &shifted));
  REFUSED(graze_broad_phase_insert_d(broad, 2, &unit), "id: expected an id that is not in use, got 2");
  REFUSED(graze_broad_phase_move_d(broad, 3, &unit), "id: expected an id that was inserted, got 3");
  REFUSED(graze_broad_phase_insert_d(broad, 5, &turned), "box: expected lower <= upper on every axis, got 1 and 0");
  const GrazeIdPair* pairs;
  const uint32_t* ids;
  size_t count;
  OK(graze_broad_phase_pairs_d(broad, buffer, &pairs, &count));
  EXPECT(count == 1 && pairs[0].a == 2 && pairs[0].b == 4);
  REFUSED(graze_broad_phase_query_d(broad, &nowhere, buffer, &ids, &count),
          "box: expected lower <= upper on every axis, got nan and 1");
  REFUSED(graze_broad_phase_query_d(broad, NULL, buffer, &ids, &count), "box: expected a pointer, got null");
  REFUSED(graze_broad_phase_sweep_d(broad, &unit, nowhere.lower, buffer, &ids, &count),
          "motion[1]: expected a finite number, got nan");
  OK(graze_broad_phase_remove_d(broad, 4));
  OK(graze_broad_phase_query_d(broad, &unit, buffer, &ids, &count));
  EXPECT(count == 1 && ids[0] == 2);
  graze_broad_phase_destroy_d(broad), graze_broad_phase_destroy_d(NULL);

  GrazeShaped* box;
  const GrazeHullLayer* layers;
  OK(graze_shape_box_d(unit_size, &box));
  REFUSED(graze_hull_layers_d(box, buffer, &layers, &count), "shape: expected a convex hull, got box");
  graze_shape_release_d(box), graze_buffer_destroy_d(buffer);
}

int main(void) {
  test_broad_phase();
  test_version();
  test_errors();
  test_shapes();
  test_strides();
  test_world();
  test_simulation();
  test_plane();
  test_plane_world();
  test_plane_simulation();
  test_draw();
  if (failures > 0) fprintf(stderr, "%d expectations failed\n", failures);
  return failures > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
