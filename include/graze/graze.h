// The C interface of Graze, for programs in C99 and for all languages that can call C: the library but for what the
// page docs/c.md names at its end, which C++ alone has.
//
// Guarantee: answers are those of the C++ interface, bit for bit, and so are their guarantees, which are in the C++
// headers named below. No exception leaves a function. A function that can fail returns a GrazeStatus and, where that
// is not GRAZE_OK, has changed nothing: neither its object nor the variables that its result pointers point to.
// `graze_last_error` then returns the value at fault, the expectation there and the value found. A null pointer is
// refused that way unless a comment says "or null"; so are a pose whose rotation is not of unit length (a pose of
// zeros, say), numbers that are not finite, and handles of another kind. Released handles, and pointers to less memory
// than given, cannot be detected: they are the caller's responsibility.
//
// Everything exists twice: names that end in d are for double, those that end in f for float. The comments of one hold
// for the other, whose declarations follow at the end.
//
// Lengths, masses and times are in the caller's units, angles in radians. Normals are unit vectors that point from A to
// B; distances are signed: positive between separated shapes, negative when they overlap.
//
// Arrays are read in place. With each comes its stride: the number of bytes between the beginnings of two elements, or
// 0 for contiguous elements. So the positions in a caller's own structs can be queried without a copy.
//
// Threads: queries on shapes may be called from any thread, also on the same shapes. A function that changes a world, a
// simulation or a buffer needs exclusive access to it. The last error is each thread's own.
#ifndef GRAZE_GRAZE_H
#define GRAZE_GRAZE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) && !defined(_WIN32)
#define GRAZE_C_API __attribute__((visibility("default")))
#else
#define GRAZE_C_API
#endif

// An enumeration is an int for C++, so that a number that is no enumerator is a value like any other, and refused.
#ifdef __cplusplus
#define GRAZE_AS_INT : int32_t
#else
#define GRAZE_AS_INT
#endif

// The version of this header; that of the library is `graze_version`.
#define GRAZE_VERSION_MAJOR 0
#define GRAZE_VERSION_MINOR 1
#define GRAZE_VERSION_PATCH 0
#define GRAZE_VERSION_STRING "0.1.0"
#define GRAZE_VERSION (GRAZE_VERSION_MAJOR * 1000000 + GRAZE_VERSION_MINOR * 1000 + GRAZE_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------------------------------
// Errors and version
// ---------------------------------------------------------------------------------------------------------------------

typedef enum GrazeStatus GRAZE_AS_INT {
  GRAZE_OK = 0,
  GRAZE_INVALID_VALUE = 1,  // a value was refused: the message names it
  GRAZE_OUT_OF_MEMORY = 2,
  GRAZE_FAILED = 3  // a callback threw, or the library has a defect
} GrazeStatus;

// The message of the last failed call in this thread: "path: expected this, got that". Never null; stays valid until
// the next failure in this thread.
GRAZE_C_API const char *graze_last_error(void);

// The version of the library that is linked, as GRAZE_VERSION and as GRAZE_VERSION_STRING.
GRAZE_C_API uint32_t graze_version(void);
GRAZE_C_API const char *graze_version_string(void);

// ---------------------------------------------------------------------------------------------------------------------
// Common to float and double
// ---------------------------------------------------------------------------------------------------------------------

// Certainty of an answer (graze/result.hpp).
typedef enum GrazeCertainty GRAZE_AS_INT {
  GRAZE_CONVERGED = 0,  // right within the tolerance
  GRAZE_BOUNDED = 1,    // right within the answer's `error`
  GRAZE_UNBOUNDED = 2   // two half-spaces that are not opposite: they overlap without a finite depth
} GrazeCertainty;

typedef enum GrazeShapeKind GRAZE_AS_INT {
  GRAZE_SPHERE = 0,
  GRAZE_CAPSULE = 1,
  GRAZE_BOX = 2,
  GRAZE_RECTANGLE = 3,
  GRAZE_CYLINDER = 4,
  GRAZE_ELLIPSOID = 5,
  GRAZE_SEGMENT = 6,
  GRAZE_TRIANGLE = 7,
  GRAZE_CONVEX_HULL = 8,
  GRAZE_USER_CONVEX = 9,
  GRAZE_HALF_SPACE = 10,
  GRAZE_MESH = 11,
  GRAZE_HEIGHT_FIELD = 12,
  GRAZE_COMPOUND = 13
} GrazeShapeKind;

typedef enum GrazePlaneShapeKind GRAZE_AS_INT {
  GRAZE_PLANE_CIRCLE = 0,
  GRAZE_PLANE_CAPSULE = 1,
  GRAZE_PLANE_BOX = 2,
  GRAZE_PLANE_SEGMENT = 3,
  GRAZE_PLANE_CONVEX = 4,
  GRAZE_PLANE_ELLIPSE = 5,
  GRAZE_PLANE_USER_CONVEX = 6,
  GRAZE_PLANE_HALF_PLANE = 7,
  GRAZE_PLANE_POLYGON = 8,
  GRAZE_PLANE_CHAIN = 9,
  GRAZE_PLANE_COMPOUND = 10
} GrazePlaneShapeKind;

// Sides of a surface without thickness that push (graze/shape/sides.hpp); for a chain in the plane, front is the right
// one.
typedef enum GrazeSides GRAZE_AS_INT { GRAZE_SIDES_BOTH = 0, GRAZE_SIDES_FRONT = 1 } GrazeSides;

// Treatment of rays that meet a triangle from behind.
typedef enum GrazeBackFaces GRAZE_AS_INT { GRAZE_BACK_FACES_HIT = 0, GRAZE_BACK_FACES_IGNORED = 1 } GrazeBackFaces;

// Treatment of shapes that touch or overlap at the start of a cast and do not approach (graze/motion.hpp).
typedef enum GrazeSeparating GRAZE_AS_INT { GRAZE_SEPARATING_HIT = 0, GRAZE_SEPARATING_IGNORED = 1 } GrazeSeparating;

// Indices into two arrays of bodies.
typedef struct GrazeIdPair {
  uint32_t a, b;
} GrazeIdPair;

// Diagnosis of a mesh (graze/shape/mesh_findings.hpp): counts, none of which is an error. Each edge is in one class.
typedef struct GrazeMeshFindings {
  size_t triangles;
  size_t repeated_triangles;  // triangles with the corners of an earlier one in the same turn
  size_t without_area;
  size_t slivers;          // triangles lower than 1/1000 of their longest side
  size_t repeated_points;  // points at the position of an earlier one
  size_t flat_edges, convex_edges, concave_edges;
  size_t open_edges;       // edges of one triangle only: rims, and seams that do not meet
  size_t irregular_edges;  // edges of more than two triangles, or run through twice in one direction
  size_t t_junctions;      // open edges with the corner of another triangle in their interior
} GrazeMeshFindings;

// Broad phases (graze/broad_phase.hpp names the uses of each); all find the same pairs.
typedef enum GrazeBroadPhaseKind GRAZE_AS_INT {
  GRAZE_DYNAMIC_TREE = 0,  // the default choice
  GRAZE_SORT_AND_SWEEP = 1,
  GRAZE_SWEEP_AND_PRUNE = 2,
  GRAZE_HASHED_GRID = 3,
  GRAZE_LOOSE_OCTREE = 4,
  GRAZE_BSP = 5
} GrazeBroadPhaseKind;

// One layer of a convex hull's hierarchy (graze/shape/support_trace.hpp): the hull of some of its vertices, or all of
// it.
typedef struct GrazeHullLayer {
  const uint32_t *vertices;  // indices of the hull's vertices
  size_t vertex_count;
  const uint32_t *edges;  // two ends each, by indices of the hull's vertices
  size_t edge_count;
} GrazeHullLayer;

// One layer of a support query's descent.
typedef struct GrazeSupportLayer {
  size_t vertices;            // number of the layer's vertices
  const uint32_t *looked_at;  // vertices whose product with the direction was taken, in that order
  const double *along;        // products of these vertices
  size_t looked_at_count;
  uint32_t winner;  // furthest vertex of the layer
} GrazeSupportLayer;

// The steps of one support query.
typedef struct GrazeSupportTrace {
  const GrazeSupportLayer *layers;  // the coarsest first, the hull itself last
  size_t layer_count;
  bool scanned;     // whether every vertex was visited: hulls of up to 64 vertices, and flat ones
  uint32_t vertex;  // the answer
  size_t products;  // number in all layers
} GrazeSupportTrace;

// A body of a world: the index in all of its arrays, and how often the index was given away before.
typedef struct GrazeBodyId {
  uint32_t index, generation;
} GrazeBodyId;

typedef struct GrazeJointId {
  uint32_t index, generation;
} GrazeJointId;

// The category of a body and the categories that it collides with (graze/filter.hpp).
typedef struct GrazeFilter {
  uint64_t category;  // the bits that this body belongs to
  uint64_t mask;      // the bits that it collides with
  int32_t group;      // bodies of equal groups collide always if positive, never if negative; 0 is no group
} GrazeFilter;

// Category 1, all bits of the mask, no group.
GRAZE_C_API GrazeFilter graze_filter_default(void);

// The bodies that a query on a world considers.
typedef struct GrazeQueryFilter {
  GrazeFilter filter;  // filter of the query: it finds bodies that it may collide with
  bool triggers;       // finds triggers too
  bool (*accept)(void *user, GrazeBodyId body);  // final decision on a body, or null
  void *user;
} GrazeQueryFilter;

GRAZE_C_API GrazeQueryFilter graze_query_filter_default(void);

// Executors: threads that come from the caller (graze/executor.hpp), a job system behind two functions. Must outlive
// its users.
typedef struct GrazeExecutor {
  size_t (*concurrency)(void *user);  // number of tasks that run at a time: at least 1
  // Calls task(context, i) once for each i < count, in any order and from any threads, and returns when all have
  // returned.
  void (*run)(void *user, size_t count, void (*task)(void *context, size_t i), void *context);
  void *user;
} GrazeExecutor;

typedef enum GrazeEventKind GRAZE_AS_INT {
  GRAZE_EVENT_BEGIN = 0,
  GRAZE_EVENT_STAY = 1,
  GRAZE_EVENT_END = 2
} GrazeEventKind;

#define GRAZE_NO_PAIR UINT32_MAX

// Two bodies and the change of their contact (graze/world/events.hpp).
typedef struct GrazeContactEvent {
  uint8_t kind;      // a GrazeEventKind
  bool trigger;      // one of them is a trigger
  GrazeBodyId a, b;  // a.index < b.index; at the end they may have been removed
  uint32_t pair;     // index among the pairs of the update; GRAZE_NO_PAIR at an end
} GrazeContactEvent;

// The overlap of the i-th pair of a batch, and the range of its manifolds.
typedef struct GrazePairContacts {
  bool overlap;  // distance <= 0, whatever the margin
  uint32_t first_manifold, manifold_count;
} GrazePairContacts;

// Two bodies of a world within the margin of each other, and the range of their manifolds.
typedef struct GrazeWorldPair {
  uint32_t a, b;  // indices of bodies, a < b; normals point from a to b
  bool overlap;   // distance <= 0
  uint32_t first_manifold, manifold_count;
} GrazeWorldPair;

// Rules for combining a number of two materials (graze/material.hpp).
typedef enum GrazeCombine GRAZE_AS_INT {
  GRAZE_COMBINE_UNSET = 0,
  GRAZE_COMBINE_AVERAGE = 1,
  GRAZE_COMBINE_MINIMUM = 2,
  GRAZE_COMBINE_MAXIMUM = 3,
  GRAZE_COMBINE_MULTIPLY = 4
} GrazeCombine;

// The quantity of a limit or a drive of a joint (graze/joint.hpp).
typedef enum GrazeJointSpace GRAZE_AS_INT { GRAZE_JOINT_LINEAR = 0, GRAZE_JOINT_ANGULAR = 1 } GrazeJointSpace;

// Whether a drive's stiffness and damping are forces, or accelerations that mass and inertia do not change.
typedef enum GrazeDriveMode GRAZE_AS_INT { GRAZE_DRIVE_FORCE = 0, GRAZE_DRIVE_ACCELERATION = 1 } GrazeDriveMode;

// Named joints; each consists of limits, which the caller may change.
typedef enum GrazeJointKind GRAZE_AS_INT {
  GRAZE_JOINT_FIXED = 0,  // keeps the frames coincident
  GRAZE_JOINT_BALL = 1,   // keeps the origins of the frames coincident
  GRAZE_JOINT_HINGE = 2,  // leaves the rotation about the x axis free; in the plane, about z
  GRAZE_JOINT_SLIDER = 3  // leaves the translation along the x axis free
} GrazeJointKind;

// The bodies that move into the other one at a contact (graze/contact_motion.hpp).
typedef enum GrazeAtFault GRAZE_AS_INT {
  GRAZE_AT_FAULT_NEITHER = 0,
  GRAZE_AT_FAULT_A = 1,
  GRAZE_AT_FAULT_B = 2,
  GRAZE_AT_FAULT_BOTH = 3
} GrazeAtFault;

// Traces: the steps of a query (graze/trace.hpp). A trace is filled by the functions that end in `_explained`, after
// the answer, whose bits it does not change. Its numbers are doubles for either scalar; vectors are in the world, and
// in the plane their third number is 0.

// A point of the Minkowski difference B - A and the support points that it is made of.
typedef struct GrazeTraceSupport {
  double a[3], b[3];
} GrazeTraceSupport;

// A separating axis: the intervals that the projections of both shapes cover on it.
typedef struct GrazeTraceAxis {
  const char *name;
  double direction[3];  // unit, from A to B
  double a_lower, a_upper, b_lower, b_upper;
} GrazeTraceAxis;

// One iteration of GJK: the simplex, the search direction, the support point found, and the bounds of the distance.
typedef struct GrazeTraceGjk {
  const GrazeTraceSupport *simplex;  // at the beginning of the iteration
  size_t simplex_count;
  double direction[3];
  GrazeTraceSupport found;
  double lower, upper;
  const GrazeTraceSupport *polygon;  // in the plane: all vertices, counter-clockwise
  size_t polygon_count;
} GrazeTraceGjk;

// One expansion of EPA's polytope.
typedef struct GrazeTraceEpa {
  double normal[3];  // unit normal of the face nearest to the origin
  double face_depth, found_depth;
  GrazeTraceSupport found;
  size_t faces;                      // after the expansion
  const GrazeTraceSupport *polygon;  // in the plane: the polytope before the expansion, counter-clockwise
  size_t polygon_count;
} GrazeTraceEpa;

// One condition on the points of a shape, and the part of the ray that meets it: none where enter > leave.
typedef struct GrazeTraceSpan {
  const char *name;
  double normal[3];
  double enter, leave;
} GrazeTraceSpan;

// One step of conservative advancement.
typedef struct GrazeTraceStep {
  double t, distance;
  double normal[3];
} GrazeTraceStep;

// One cut of a face by the plane through a side of the other.
typedef struct GrazeTraceCut {
  double from[3], to[3];  // a side of the cutting face
  const double *left;     // remainder of the face, as corners of three numbers
  size_t left_count;
} GrazeTraceCut;

typedef struct GrazeTraceTriangle {
  size_t corner[3];
} GrazeTraceTriangle;

// The contents of a trace. Strings and arrays belong to the trace, until it is filled again or destroyed.
typedef struct GrazeTraceView {
  const char *method, *winner, *reason;  // empty where there is none
  const GrazeTraceAxis *axes;
  size_t axis_count;
  const GrazeTraceGjk *gjk;
  size_t gjk_count;
  const GrazeTraceEpa *epa;
  size_t epa_count;
  const GrazeTraceSupport *difference;  // in the plane: the outline of the difference of the cores
  size_t difference_count;
  double rounding;                    // rounding radius of both cores together
  const GrazeTraceSupport *polytope;  // vertices and triangles of EPA's final polytope
  size_t polytope_count;
  const GrazeTraceTriangle *triangles;
  size_t triangle_count;
  const GrazeTraceSpan *spans;
  size_t span_count;
  const GrazeTraceStep *steps;
  size_t step_count;
  size_t nodes, pieces;  // of a composite's tree, visited by a ray
  // The faces from which contacts were clipped, as corners of three numbers, and the cuts of the clipping.
  const double *face_a, *face_b;
  size_t face_a_count, face_b_count;
  const GrazeTraceCut *cuts;
  size_t cut_count;
} GrazeTraceView;

typedef struct GrazeTrace GrazeTrace;

GRAZE_C_API GrazeStatus graze_trace_create(GrazeTrace **trace);
GRAZE_C_API void graze_trace_destroy(GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_trace_view(GrazeTrace *trace, GrazeTraceView *view);

// Debug draw (graze/draw.hpp): shapes, contacts and traces on a renderer of the caller's. Positions are doubles for
// either scalar, in the world; in the plane their third number is 0.

// Layers that a reader switches on and off.
typedef enum GrazeDrawLayer GRAZE_AS_INT {
  GRAZE_DRAW_SHAPES = 0,
  GRAZE_DRAW_BOUNDS = 1,
  GRAZE_DRAW_TREE = 2,
  GRAZE_DRAW_CONTACTS = 3,
  GRAZE_DRAW_DISTANCES = 4,
  GRAZE_DRAW_RAYS = 5,
  GRAZE_DRAW_CASTS = 6,
  GRAZE_DRAW_TRACE = 7,
  GRAZE_DRAW_JOINTS = 8
} GrazeDrawLayer;

// Meanings of colours.
typedef enum GrazeDrawMeaning GRAZE_AS_INT {
  GRAZE_MEANS_A = 0,  // the first of two shapes, and what belongs to it
  GRAZE_MEANS_B = 1,
  GRAZE_MEANS_FIXED = 2,     // a body that never moves
  GRAZE_MEANS_TOUCHED = 3,   // a fixed body that is touched
  GRAZE_MEANS_MOVING = 4,    // a body that moves
  GRAZE_MEANS_TOUCHING = 5,  // a moving body with contacts
  GRAZE_MEANS_ASLEEP = 6,
  GRAZE_MEANS_TRIGGER = 7,
  GRAZE_MEANS_CONTACT = 8,
  GRAZE_MEANS_NORMAL = 9,
  GRAZE_MEANS_GAP = 10,
  GRAZE_MEANS_RULED_OUT = 11,  // a trial that decided nothing
  GRAZE_MEANS_BOUNDS = 12,
  GRAZE_MEANS_PATH = 13,
  GRAZE_MEANS_GHOST = 14,  // a position along a path
  GRAZE_MEANS_JOINT = 15
} GrazeDrawMeaning;

typedef struct GrazeDebugDraw {
  uint32_t layers;   // 1 << GrazeDrawLayer for each visible one
  double center[3];  // of the region of interest; unbounded things are drawn about it,
  double size;       // > 0, as far as this; arrows are a twelfth of it
  // Functions, each of which may be null: its kind is then not drawn, except that arrows become lines.
  void (*point)(void *user, const double at[3], GrazeDrawLayer layer, GrazeDrawMeaning meaning);
  void (*line)(void *user, const double from[3], const double to[3], GrazeDrawLayer layer, GrazeDrawMeaning meaning);
  // A triangle, counter-clockwise seen from outside.
  void (*triangle)(void *user, const double a[3], const double b[3], const double c[3], GrazeDrawLayer layer,
                   GrazeDrawMeaning meaning);
  // `words` at a point; the text is valid until the function returns.
  void (*text)(void *user, const double at[3], const char *words, GrazeDrawLayer layer, GrazeDrawMeaning meaning);
  // A unit vector at a place.
  void (*arrow)(void *user, const double from[3], const double direction[3], GrazeDrawLayer layer,
                GrazeDrawMeaning meaning);
  void *user;
} GrazeDebugDraw;

// All layers about the origin, size 1, and no functions.
GRAZE_C_API GrazeDebugDraw graze_debug_draw_default(void);

// The colour of a meaning in the project's own pictures: red, green and blue, 0 to 255.
GRAZE_C_API GrazeStatus graze_draw_color(GrazeDrawMeaning meaning, uint8_t rgb[3]);

// The faces of a shape as loops of points (graze/tessellate.hpp).
typedef struct GrazePolygons {
  const double *points;  // in the world, three numbers each; of the plane's shapes the third is 0
  size_t point_count;
  const uint32_t *corners;  // indices of points: the loops, contiguous, counter-clockwise seen from outside
  const size_t *ends;       // of each loop among the corners
  size_t loop_count;
  bool smooth;  // edges come from the sampling, not from the shape
  bool closed;  // there is an inside, so that faces seen from behind are hidden
} GrazePolygons;

// Draws the steps of a query: separating axes through the centre, the Minkowski difference B - A about the origin.
GRAZE_C_API GrazeStatus graze_trace_draw(const GrazeTrace *trace, const GrazeDebugDraw *on);
// Draws one step: an axis, an iteration of GJK, an expansion of EPA or a cut of a face, counted from 0 in this order.
GRAZE_C_API GrazeStatus graze_trace_step_draw(const GrazeTrace *trace, size_t step, const GrazeDebugDraw *on);
// Draws a trace, whole or one step, from a view of its numbers, wherever they come from; parts with a count of 0 are
// left out.
GRAZE_C_API GrazeStatus graze_trace_view_draw(const GrazeTraceView *view, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_trace_view_step_draw(const GrazeTraceView *view, size_t step, const GrazeDebugDraw *on);

// The kind of a capture (graze/capture.hpp, docs/capture.md).
typedef struct GrazeCaptureHead {
  bool simulation;  // false for a world
  bool plane;       // false for space
  bool single;      // true for float, false for double
} GrazeCaptureHead;

// The kind of a capture, which decides which of the functions below plays it. Any bytes may be given:
// GRAZE_INVALID_VALUE unless they begin as a capture does; only the head is read.
GRAZE_C_API GrazeStatus graze_capture_head(const void *bytes, size_t size, GrazeCaptureHead *head);

// The report of a replay of a capture.
typedef struct GrazeReplayReport {
  bool simulation;  // false for a world
  bool plane;       // false for space
  bool cut;         // the bytes end within a frame, which was left out
  bool differs;     // whether some result differs from the captured run:
  size_t frame, call;  // number of the frame and of the call, counted from 1, and
  char what[128];      // the difference: "step: other poses"
  size_t frames, calls;  // numbers of frames and calls with equal results
} GrazeReplayReport;

// Receiver of a capture's bytes, a frame at a call; returns whether it could take them.
typedef bool (*GrazeWriteFunction)(void *user, const void *bytes, size_t size);

// ---------------------------------------------------------------------------------------------------------------------
// Double
// ---------------------------------------------------------------------------------------------------------------------
// <double>

typedef struct GrazeVec3d {
  double x, y, z;
} GrazeVec3d;

// x i + y j + z k + w; a rotation when of unit length. The identity is {0, 0, 0, 1}.
typedef struct GrazeQuatd {
  double x, y, z, w;
} GrazeQuatd;

// Pose of a body, a rigid transform from its frame to the world: p -> translation + rotation p.
typedef struct GrazePosed {
  GrazeVec3d translation;
  GrazeQuatd rotation;
} GrazePosed;

// A 3 by 3 matrix by rows.
typedef struct GrazeMat3d {
  GrazeVec3d row[3];
} GrazeMat3d;

typedef struct GrazeAabbd {
  GrazeVec3d lower, upper;
} GrazeAabbd;

// The identity pose; the pose at a place without rotation; the pose at a place with a rotation by `angle` about the
// unit vector `axis`. A rotation by an angle that is not finite is made of NaN, so that the call that takes the pose
// refuses it; so it is in the plane.
GRAZE_C_API GrazePosed graze_pose_identity_d(void);
GRAZE_C_API GrazePosed graze_pose_at_place_d(double x, double y, double z);
GRAZE_C_API GrazePosed graze_pose_turned_d(GrazeVec3d translation, GrazeVec3d axis, double angle);

// Shapes --------------------------------------------------------------------------------------------------------------
//
// A shape is a counted handle to something that never changes: whoever makes or retains one releases it. Worlds,
// simulations and compounds keep shares of their own. Constructors are those of the headers in graze/shape/ and refuse
// what these refuse: sizes that are negative, not finite or too large.

typedef struct GrazeShaped GrazeShaped;

GRAZE_C_API GrazeStatus graze_shape_sphere_d(double radius, GrazeVec3d center, GrazeShaped **shape);
// A capsule with `height` between the centres of the balls, which lie on the Y axis about the origin.
GRAZE_C_API GrazeStatus graze_shape_capsule_d(double height, double radius_bottom, double radius_top,
                                              GrazeShaped **shape);
// A box by its full edge lengths.
GRAZE_C_API GrazeStatus graze_shape_box_d(GrazeVec3d size, GrazeShaped **shape);
// A rectangle in the XZ plane, without thickness, its normal +Y.
GRAZE_C_API GrazeStatus graze_shape_rectangle_d(double size_x, double size_z, GrazeShaped **shape);
// A cylinder along the Y axis about the origin; a radius of 0 makes a cone, two that differ a truncated one.
GRAZE_C_API GrazeStatus graze_shape_cylinder_d(double height, double radius_bottom, double radius_top,
                                               GrazeShaped **shape);
GRAZE_C_API GrazeStatus graze_shape_ellipsoid_d(GrazeVec3d radii, GrazeShaped **shape);
GRAZE_C_API GrazeStatus graze_shape_segment_d(GrazeVec3d a, GrazeVec3d b, GrazeShaped **shape);
// A triangle, counter-clockwise seen from its front.
GRAZE_C_API GrazeStatus graze_shape_triangle_d(GrazeVec3d a, GrazeVec3d b, GrazeVec3d c, GrazeShaped **shape);
// The half-space of all points with y <= 0.
GRAZE_C_API GrazeStatus graze_shape_half_space_d(GrazeShaped **shape);
// The convex hull of at least one point.
GRAZE_C_API GrazeStatus graze_shape_convex_hull_d(const GrazeVec3d *points, size_t stride, size_t count,
                                                  GrazeShaped **shape);
// A mesh with three indices of points for each triangle, counter-clockwise seen from outside; `triangle_stride` is from
// one triple to the next. A `solid` mesh has to be closed, and its inside counts.
GRAZE_C_API GrazeStatus graze_shape_mesh_d(const GrazeVec3d *points, size_t point_stride, size_t point_count,
                                           const uint32_t *triangles, size_t triangle_stride, size_t triangle_count,
                                           GrazeSides sides, bool solid, GrazeShaped **shape);
// A height field: heights[r * columns + c] over x and z about the origin (graze/shape/height_field.hpp); NaN makes a
// hole, and so does a flag in `holes` (as many contiguous bytes, or null) that is not 0.
GRAZE_C_API GrazeStatus graze_shape_height_field_d(const double *heights, size_t stride, size_t columns, size_t rows,
                                                   const uint8_t *holes, double spacing_x, double spacing_z,
                                                   GrazeSides sides, GrazeShaped **shape);

typedef struct GrazeChildd {
  const GrazeShaped *shape;
  GrazePosed pose;
} GrazeChildd;

// A compound: several shapes that move as one. It keeps shares of its children.
GRAZE_C_API GrazeStatus graze_shape_compound_d(const GrazeChildd *children, size_t stride, size_t count,
                                               GrazeShaped **shape);

// A convex shape of the caller's own. `support` returns a point of the shape that lies furthest along `direction`,
// which is not zero and need not be unit; the same one for equal directions, from any thread. `release` (or null) is
// called with `user` once, when the last share of the shape is gone, and not where this function fails.
GRAZE_C_API GrazeStatus graze_shape_user_d(GrazeVec3d (*support)(const void *user, GrazeVec3d direction),
                                           void (*release)(void *user), void *user, GrazeShaped **shape);
// The shape with a ball of radius `rounding` added (its Minkowski sum), in addition to its present rounding; for convex
// shapes only.
GRAZE_C_API GrazeStatus graze_shape_rounded_d(const GrazeShaped *shape, double rounding, GrazeShaped **rounded);
// The volume that a bounded convex shape, standing at `pose`, sweeps while it moves by `motion` without turning
// (graze/swept.hpp).
GRAZE_C_API GrazeStatus graze_shape_swept_d(const GrazeShaped *shape, const GrazePosed *pose, GrazeVec3d motion,
                                            GrazeShaped **swept);

// Adds a share of a shape, and gives one back; null is ignored.
GRAZE_C_API void graze_shape_retain_d(const GrazeShaped *shape);
GRAZE_C_API void graze_shape_release_d(const GrazeShaped *shape);

GRAZE_C_API GrazeStatus graze_shape_kind_d(const GrazeShaped *shape, GrazeShapeKind *kind);
GRAZE_C_API GrazeStatus graze_shape_rounding_d(const GrazeShaped *shape, double *rounding);
// The bounds of the shape under a pose; a half-space's reach to infinity.
GRAZE_C_API GrazeStatus graze_shape_bounds_d(const GrazeShaped *shape, const GrazePosed *pose, GrazeAabbd *bounds);
// The point of a bounded convex shape furthest along `direction`, in the shape's frame.
GRAZE_C_API GrazeStatus graze_shape_support_d(const GrazeShaped *shape, GrazeVec3d direction, GrazeVec3d *point);

// The measures that a shape was made of, without its rounding; 0 and false where its kind has no such measure.
typedef struct GrazeShapeMeasuresd {
  GrazeVec3d size;              // full edge lengths of a box or a rectangle, whose y is 0
  GrazeVec3d radii;             // half axes of an ellipsoid
  GrazeVec3d center;            // centre of a ball, in the shape's frame
  double height;                // between the centres of a capsule's balls; the full height of a cylinder
  double radius, radius_top;    // radius of a ball; radii of a capsule or a cylinder at -Y and at +Y
  double spacing_x, spacing_z;  // distances between the columns and the rows of a height field
  double tolerance;             // of a convex hull: no point that it was made of lies further outside
  size_t columns, rows;         // of a height field
  size_t children;              // number of a compound's children
  bool convex;                  // a half-space is; meshes, height fields and compounds are not
  bool closed;                  // every edge of a mesh is in two triangles that run through it in opposite directions
  bool solid;                   // the inside of a mesh counts
  GrazeSides sides;             // the sides of a mesh or a height field that push
} GrazeShapeMeasuresd;

// The measures of a shape of any kind, in constant time.
GRAZE_C_API GrazeStatus graze_shape_measures_d(const GrazeShaped *shape, GrazeShapeMeasuresd *measures);
// The vertices of a convex hull or a mesh, the corners of a triangle, the ends of a segment; other kinds are refused.
// The points belong to the shape; constant time, as the two that follow.
GRAZE_C_API GrazeStatus graze_shape_points_d(const GrazeShaped *shape, const GrazeVec3d **points, size_t *count);
// The `count` triangles of a mesh, three indices of points each; other kinds are refused. They belong to the shape.
GRAZE_C_API GrazeStatus graze_shape_triangles_d(const GrazeShaped *mesh, const uint32_t **triangles, size_t *count);
// The heights of a height field as it was given them, row by row, with NaN for holes; other kinds are refused. They
// belong to the shape.
GRAZE_C_API GrazeStatus graze_shape_heights_d(const GrazeShaped *field, const double **heights, size_t *count);
// The child of a compound by its index, counted from 0; other kinds are refused. Its shape is one more share, for the
// caller to release.
GRAZE_C_API GrazeStatus graze_shape_child_d(const GrazeShaped *compound, size_t index, GrazeChildd *child);

// Properties of a body of density one; the inertia is about `center`, in the shape's frame. Volume 0 for shapes
// without.
typedef struct GrazeMassPropertiesd {
  double volume;
  GrazeVec3d center;
  GrazeMat3d inertia;
} GrazeMassPropertiesd;

GRAZE_C_API GrazeStatus graze_shape_mass_properties_d(const GrazeShaped *shape, GrazeMassPropertiesd *properties);
// The findings for a mesh; other shapes are refused.
GRAZE_C_API GrazeStatus graze_shape_findings_d(const GrazeShaped *mesh, GrazeMeshFindings *findings);

// Storage for answers of variable size, which grows as needed and is reused by the next query. Results in a buffer are
// valid until that is used again or destroyed.
typedef struct GrazeBufferd GrazeBufferd;

GRAZE_C_API GrazeStatus graze_buffer_create_d(GrazeBufferd **buffer);
GRAZE_C_API void graze_buffer_destroy_d(GrazeBufferd *buffer);

// Convex hulls only (graze/shape/support_trace.hpp). The vertices belong to the shape; the layers of its hierarchy, the
// coarsest first, and the steps of a support query along `direction`, to the buffer.
GRAZE_C_API GrazeStatus graze_hull_vertices_d(const GrazeShaped *shape, const GrazeVec3d **vertices, size_t *count);
GRAZE_C_API GrazeStatus graze_hull_layers_d(const GrazeShaped *shape, GrazeBufferd *buffer,
                                            const GrazeHullLayer **layers, size_t *count);
GRAZE_C_API GrazeStatus graze_hull_support_d(const GrazeShaped *shape, GrazeVec3d direction, GrazeBufferd *buffer,
                                             GrazeSupportTrace *trace);

// Results -------------------------------------------------------------------------------------------------------------

typedef struct GrazeDistanced {
  double distance;
  GrazeVec3d normal;  // unit, from A to B; moving B by -distance * normal makes the shapes touch
  GrazeVec3d a, b;    // on the surfaces: b - a = distance * normal
  uint8_t certainty;  // a GrazeCertainty
  double error;       // a bound of |distance - truth| where the certainty is GRAZE_BOUNDED
} GrazeDistanced;

typedef struct GrazeClosestd {
  double distance;    // negative inside a solid
  GrazeVec3d point;   // on the surface
  GrazeVec3d normal;  // unit, outward: the queried point - point = distance * normal
  uint8_t certainty;
  double error;
} GrazeClosestd;

// Two convex pieces and their distance: the triangle of a mesh or the child of the outermost compound, else 0.
typedef struct GrazePieceDistanced {
  uint32_t piece_a, piece_b;
  GrazeDistanced distance;
} GrazePieceDistanced;

typedef struct GrazeContactPointd {
  GrazeVec3d a, b;   // on the surface of A, and of B
  double distance;   // negative is penetration
  uint32_t feature;  // identifies the features that touch: the same while they do
  double weight;     // the contact position for a solver is a + (b - a) * weight
} GrazeContactPointd;

typedef struct GrazeManifoldd {
  GrazeVec3d normal;  // unit, from A to B
  uint32_t piece_a, piece_b;
  uint32_t first_point, point_count;
} GrazeManifoldd;

// Contacts of one pair: manifolds and their points, which belong to the buffer.
typedef struct GrazeContactsd {
  bool overlap;       // distance <= 0, whatever the margin
  uint8_t certainty;  // GRAZE_BOUNDED where any manifold is
  double error;       // largest error of the manifolds
  const GrazeManifoldd *manifolds;
  size_t manifold_count;
  const GrazeContactPointd *points;
  size_t point_count;
} GrazeContactsd;

// Contacts of many pairs, which belong to the buffer.
typedef struct GrazeBatchContactsd {
  const GrazePairContacts *pairs;  // one for each pair, in the order of the batch
  size_t pair_count;
  const GrazeManifoldd *manifolds;
  size_t manifold_count;
  const GrazeContactPointd *points;
  size_t point_count;
} GrazeBatchContactsd;

// Compact contacts of many pairs (graze/compact_contacts.hpp), which belong to the buffer: normals, positions and
// distances only. Pairs without contacts take no memory; the manifolds of a pair are contiguous, and pairs may come in
// another order than in the batch.
typedef struct GrazeCompactManifoldd {
  GrazeVec3d normal;  // unit, from A to B
  uint32_t pair;      // index in the batch
  uint32_t first_point, point_count;
} GrazeCompactManifoldd;

typedef struct GrazeCompactPointd {
  GrazeVec3d position;  // the contact position for a solver
  double distance;      // negative is penetration
} GrazeCompactPointd;

typedef struct GrazeCompactContactsd {
  const GrazeCompactManifoldd *manifolds;
  size_t manifold_count;
  const GrazeCompactPointd *points;
  size_t point_count;
} GrazeCompactContactsd;

typedef struct GrazeRayd {
  GrazeVec3d origin, direction;  // the direction need not be unit
} GrazeRayd;

typedef struct GrazeRayHitd {
  double t;           // distance along the ray, in units of length
  GrazeVec3d point;   // on the surface; the ray's origin when that lies inside a solid
  GrazeVec3d normal;  // unit, against the ray
  uint32_t piece;
} GrazeRayHitd;

typedef struct GrazeVelocityd {
  GrazeVec3d linear;
  GrazeVec3d angular;  // about the pose's origin, in world axes; its length is the rate
} GrazeVelocityd;

typedef struct GrazeCastHitd {
  double t;
  GrazeVec3d point;   // in the world at time t
  GrazeVec3d normal;  // unit, from A to B, at time t
  double depth;       // depth at the start, of shapes that overlap there
  uint8_t certainty;
  uint32_t piece_a, piece_b;
} GrazeCastHitd;

// Queries on two shapes (graze/query.hpp, graze/cast.hpp) -------------------------------------------------------------

GRAZE_C_API GrazeStatus graze_overlap_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                        const GrazePosed *pose_b, bool *overlap);
// A preliminary test, cheaper and conservative: false only where the shapes do not touch.
GRAZE_C_API GrazeStatus graze_may_overlap_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                            const GrazePosed *pose_b, bool *may_overlap);
GRAZE_C_API GrazeStatus graze_distance_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                         const GrazePosed *pose_b, GrazeDistanced *distance);
// The distance of shapes no further apart than `limit` >= 0: `found` is true if they are; else `distance` is unchanged.
GRAZE_C_API GrazeStatus graze_distance_up_to_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                               const GrazePosed *pose_b, double limit, bool *found,
                                               GrazeDistanced *distance);
GRAZE_C_API GrazeStatus graze_within_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                       const GrazePosed *pose_b, double limit, bool *within);
// All pairs of convex pieces no further apart than `margin` >= 0.
GRAZE_C_API GrazeStatus graze_near_pieces_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                            const GrazePosed *pose_b, double margin, GrazeBufferd *buffer,
                                            const GrazePieceDistanced **pieces, size_t *count);
// All points of contact up to `margin` >= 0 apart.
GRAZE_C_API GrazeStatus graze_contacts_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                         const GrazePosed *pose_b, double margin, GrazeBufferd *buffer,
                                         GrazeContactsd *contacts);
// The contacts, reduced to at most `most` >= 1 points: those of largest area (graze/world/reduce.hpp).
GRAZE_C_API GrazeStatus graze_contacts_reduced_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                                 const GrazePosed *pose_b, double margin, size_t most,
                                                 GrazeBufferd *buffer, GrazeContactsd *contacts);
// A margin with which a body at rest keeps its points from frame to frame.
GRAZE_C_API GrazeStatus graze_contact_margin_d(const GrazeShaped *a, const GrazeShaped *b, double *margin);
// The corners of a feature in the shape's frame (graze/feature_corners.hpp): one for a vertex, two for an edge, those
// of a face in order; none for round features. `feature` is the upper half of a contact point's for A, the lower half
// for B, and `piece` is the manifold's. The corners belong to the buffer.
GRAZE_C_API GrazeStatus graze_feature_corners_d(const GrazeShaped *shape, uint32_t piece, uint16_t feature,
                                                GrazeBufferd *buffer, const GrazeVec3d **corners, size_t *count);
// The point of the shape's surface nearest to a point of the world.
GRAZE_C_API GrazeStatus graze_closest_d(const GrazeShaped *shape, const GrazePosed *pose, GrazeVec3d point,
                                        GrazeClosestd *closest);

// The first hit with 0 <= t <= `length` (INFINITY for no end): `found` is true if there is one; else `hit` is
// unchanged.
GRAZE_C_API GrazeStatus graze_raycast_d(const GrazeShaped *shape, const GrazePosed *pose, const GrazeRayd *ray,
                                        double length, GrazeBackFaces back, bool *found, GrazeRayHitd *hit);
GRAZE_C_API GrazeStatus graze_raycast_any_d(const GrazeShaped *shape, const GrazePosed *pose, const GrazeRayd *ray,
                                            double length, GrazeBackFaces back, bool *found);
// All entries of the ray into pieces, in the order of the ray.
GRAZE_C_API GrazeStatus graze_raycast_all_d(const GrazeShaped *shape, const GrazePosed *pose, const GrazeRayd *ray,
                                            double length, GrazeBackFaces back, GrazeBufferd *buffer,
                                            const GrazeRayHitd **hits, size_t *count);

// A moving body: constant linear velocity, and rotation about its origin at a constant rate.
typedef struct GrazeMovingd {
  const GrazeShaped *shape;
  GrazePosed pose;
  GrazeVelocityd velocity;
} GrazeMovingd;

// The first contact at a time in [0, duration]: `found` is true if there is one; else `hit` is unchanged.
GRAZE_C_API GrazeStatus graze_cast_d(const GrazeMovingd *a, const GrazeMovingd *b, double duration,
                                     GrazeSeparating separating, bool *found, GrazeCastHitd *hit);
// The first contacts of all pairs of pieces, in the order of time.
GRAZE_C_API GrazeStatus graze_cast_all_d(const GrazeMovingd *a, const GrazeMovingd *b, double duration,
                                         GrazeSeparating separating, GrazeBufferd *buffer, const GrazeCastHitd **hits,
                                         size_t *count);
// The queries above with their traces; a null trace is not filled.
GRAZE_C_API GrazeStatus graze_overlap_explained_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                                  const GrazePosed *pose_b, bool *overlap, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_distance_explained_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                                   const GrazePosed *pose_b, GrazeDistanced *distance,
                                                   GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_contacts_explained_d(const GrazeShaped *a, const GrazePosed *pose_a, const GrazeShaped *b,
                                                   const GrazePosed *pose_b, double margin, GrazeBufferd *buffer,
                                                   GrazeContactsd *contacts, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_closest_explained_d(const GrazeShaped *shape, const GrazePosed *pose, GrazeVec3d point,
                                                  GrazeClosestd *closest, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_raycast_explained_d(const GrazeShaped *shape, const GrazePosed *pose, const GrazeRayd *ray,
                                                  double length, GrazeBackFaces back, bool *found, GrazeRayHitd *hit,
                                                  GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_cast_explained_d(const GrazeMovingd *a, const GrazeMovingd *b, double duration,
                                               GrazeSeparating separating, bool *found, GrazeCastHitd *hit,
                                               GrazeTrace *trace);

// The pose of a body at time t.
GRAZE_C_API GrazeStatus graze_pose_at_d(const GrazePosed *pose, const GrazeVelocityd *velocity, double t,
                                        GrazePosed *result);

// Collision response (graze/impulse.hpp) ------------------------------------------------------------------------------

// The motion of a rigid body: the velocity of its centre of mass, and its rotation about that.
typedef struct GrazeMotiond {
  GrazeVec3d linear, angular;
  GrazeVec3d center;  // centre of mass
} GrazeMotiond;

// The inverse of a mass, and of its inertia about the centre of mass in the world's axes; zeros for an immovable body.
typedef struct GrazeInverseMassd {
  double mass;
  GrazeMat3d inertia;
} GrazeInverseMassd;

typedef struct GrazeStruckBodyd {
  GrazeMotiond motion;
  GrazeInverseMassd mass;
} GrazeStruckBodyd;

typedef struct GrazeStruckContactd {
  GrazeVec3d point;
  GrazeVec3d normal;             // unit, from A to B
  double restitution, friction;  // >= 0
} GrazeStruckContactd;

// The response of two bodies, and the quantities that lead to it in the order in which they are computed.
typedef struct GrazeResponsed {
  GrazeVec3d approach;             // velocity of B's point relative to A's, before the impact
  double approach_along_normal;    // < 0 while the bodies approach
  GrazeVec3d approach_tangential;  // tangential part
  GrazeAtFault at_fault;           // bodies that move into the other
  double effective_mass;           // inertia along the normal
  double normal_impulse;
  GrazeVec3d sliding;           // the tangential velocity that the normal impulse leaves
  GrazeVec3d stopping_impulse;  // would end the sliding
  double friction_limit;
  GrazeVec3d friction_impulse;  // the stopping impulse, no longer than the limit
  GrazeVec3d impulse;           // on B; that on A is its opposite
  GrazeMotiond a, b;            // motions after the impact
} GrazeResponsed;

// The inverse mass. `mass` > 0, or INFINITY for an immovable body; `inertia` is the diagonal in the frame `rotation`:
// of three finite moments none is larger than the sum of the others.
GRAZE_C_API GrazeStatus graze_inverse_mass_d(double mass, GrazeVec3d inertia, GrazeQuatd rotation,
                                             GrazeInverseMassd *inverse);
// The inverse mass of a body with an inertia tensor in the frame `rotation`: symmetric and positive definite,
// no principal moment larger than the sum of the others.
GRAZE_C_API GrazeStatus graze_inverse_mass_of_tensor_d(double mass, const GrazeMat3d *inertia, GrazeQuatd rotation,
                                                       GrazeInverseMassd *inverse);
// The inverse mass of a shape with `mass` spread evenly, about its centre of mass.
GRAZE_C_API GrazeStatus graze_inverse_mass_of_shape_d(const GrazeShaped *shape, double mass, GrazeQuatd rotation,
                                                      GrazeInverseMassd *inverse);
GRAZE_C_API GrazeStatus graze_response_d(const GrazeStruckContactd *contact, const GrazeStruckBodyd *a,
                                         const GrazeStruckBodyd *b, GrazeResponsed *response);
// The motion of a body after `impulse` at `point`.
GRAZE_C_API GrazeStatus graze_apply_impulse_d(const GrazeStruckBodyd *body, GrazeVec3d impulse, GrazeVec3d point,
                                              GrazeMotiond *motion);

// Propagation of impacts (graze/blows.hpp): the motions of bodies in mutual contact after one of them is struck.

// The points of two bodies that share a normal, struck together.
typedef struct GrazeBlowd {
  uint32_t a, b;       // indices of the bodies
  GrazeVec3d normal;   // unit, from a to b
  double restitution;  // fraction of the approach speed that comes back, 0 to 1
  uint32_t first_point, point_count;
} GrazeBlowd;

// Bodies that touch. Their motions are changed, and the impulse of each point is added to its entry of `impulses`.
typedef struct GrazeTouchingd {
  GrazeStruckBodyd *bodies;
  size_t body_stride, body_count;
  const GrazeBlowd *blows;
  size_t blow_stride, blow_count;
  const GrazeVec3d *points;  // in the world
  size_t point_stride, point_count;
  double *impulses;  // one for each point
  size_t impulse_stride;
} GrazeTouchingd;

typedef struct GrazePassedOnd {
  size_t struck;    // number of blows that were struck
  double approach;  // the fastest approach left
} GrazePassedOnd;

// Strikes the blow that approaches fastest until none does by more than `resting_speed` >= 0, or `most` were struck.
GRAZE_C_API GrazeStatus graze_pass_on_d(const GrazeTouchingd *touching, double resting_speed, size_t most,
                                        GrazePassedOnd *passed);

// Free motion (graze/free_motion.hpp): a body that nothing touches, about its centre of mass.
typedef struct GrazeFreeBodyd {
  GrazeVec3d center;
  GrazeQuatd rotation;  // orientation of the principal axes
  GrazeVec3d linear;
  GrazeVec3d angular_momentum;  // in the world
  GrazeVec3d inverse_inertia;   // about the principal axes; zero where the body does not turn
} GrazeFreeBodyd;

GRAZE_C_API GrazeStatus graze_free_angular_velocity_d(const GrazeFreeBodyd *body, GrazeVec3d *angular);
// Sets the angular momentum; rotation about an axis of zero inverse inertia is left out.
GRAZE_C_API GrazeStatus graze_free_set_angular_velocity_d(GrazeFreeBodyd *body, GrazeVec3d angular);
// Moves the body by `duration`, of either sign, under a constant acceleration.
GRAZE_C_API GrazeStatus graze_free_advance_d(GrazeFreeBodyd *body, GrazeVec3d acceleration, double duration);

// Queries on many pairs (graze/batch.hpp) -----------------------------------------------------------------------------
//
// The bits are those of each pair alone.

// Shapes and their poses. There are as many shapes as poses, or one shape for all poses, or one pose for all shapes.
// Every pointer goes through an array of its own stride.
typedef struct GrazeBodiesd {
  const GrazeShaped *const *shapes;
  size_t shape_stride, shape_count;
  const GrazeVec3d *translations;
  size_t translation_stride;
  const GrazeQuatd *rotations;  // or null: no rotations
  size_t rotation_stride;
  size_t pose_count;
} GrazeBodiesd;

// Bodies of contiguous shapes and contiguous poses.
GRAZE_C_API GrazeBodiesd graze_bodies_d(const GrazeShaped *const *shapes, size_t shape_count, const GrazePosed *poses,
                                        size_t pose_count);

// Two sides of bodies and their pairs: `places` holds indices into a and b. With a null pointer, and a count of 0, the
// i-th of A with the i-th of B; a side with a single body pairs it with all of the other.
typedef struct GrazeBatchd {
  GrazeBodiesd a, b;
  const GrazeIdPair *places;
  size_t place_stride, place_count;
} GrazeBatchd;

// The number of pairs of a batch, and so of the answers to its queries.
GRAZE_C_API GrazeStatus graze_batch_size_d(const GrazeBatchd *batch, size_t *size);

// Overlap of each pair: 1 or 0; the distance of each pair. `executor` may be null: the calling thread. The answers are
// the same, but manifolds and points of contacts come in another order with one than without, whatever its number of
// threads; functions that a shape calls back are called from them.
GRAZE_C_API GrazeStatus graze_overlap_batch_d(const GrazeBatchd *batch, uint8_t *touch, size_t stride,
                                              const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_distance_batch_d(const GrazeBatchd *batch, GrazeDistanced *distances, size_t stride,
                                               const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_contacts_batch_d(const GrazeBatchd *batch, double margin, GrazeBufferd *buffer,
                                               GrazeBatchContactsd *contacts, const GrazeExecutor *executor);
// The contacts, reduced to at most `most` >= 1 points a pair, as those of `graze_contacts_reduced_d`.
GRAZE_C_API GrazeStatus graze_contacts_batch_reduced_d(const GrazeBatchd *batch, double margin, size_t most,
                                                       GrazeBufferd *buffer, GrazeBatchContactsd *contacts,
                                                       const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_compact_contacts_batch_d(const GrazeBatchd *batch, double margin, GrazeBufferd *buffer,
                                                       GrazeCompactContactsd *contacts, const GrazeExecutor *executor);
// The pieces of all pairs, on the calling thread, those of a pair contiguous; `ends[i]`, one for each pair, is the end
// of the i-th pair's.
GRAZE_C_API GrazeStatus graze_near_pieces_batch_d(const GrazeBatchd *batch, double margin, GrazeBufferd *buffer,
                                                  const GrazePieceDistanced **pieces, const size_t **ends,
                                                  size_t *count);
// The nearest points of one shape to many points.
GRAZE_C_API GrazeStatus graze_closest_batch_d(const GrazeShaped *shape, const GrazePosed *pose,
                                              const GrazeVec3d *points, size_t point_stride, size_t count,
                                              GrazeClosestd *closest, size_t closest_stride);
// The hits of many rays at one shape (graze/batch_raycast.hpp). A ray that misses leaves its entry of `hits` unchanged
// and writes 0 to `found`, else 1. `hits` may be null: then only `found` is computed.
GRAZE_C_API GrazeStatus graze_raycast_batch_d(const GrazeShaped *shape, const GrazePosed *pose, const GrazeRayd *rays,
                                              size_t ray_stride, size_t count, double length, GrazeBackFaces back,
                                              uint8_t *found, size_t found_stride, GrazeRayHitd *hits,
                                              size_t hit_stride);
// Casts in order: the i-th of A with the i-th of B.
GRAZE_C_API GrazeStatus graze_cast_batch_d(const GrazeMovingd *a, size_t a_stride, const GrazeMovingd *b,
                                           size_t b_stride, size_t count, double duration, GrazeSeparating separating,
                                           uint8_t *found, size_t found_stride, GrazeCastHitd *hits, size_t hit_stride);

// Broad phases (graze/broad_phase.hpp) --------------------------------------------------------------------------------
//
// The pairs of overlapping boxes among many, found by one of several structures: boxes under ids of the caller's own,
// and no shapes. Ids close together cost least. Answers are sorted, belong to the buffer, and are the same for every
// structure.

typedef struct GrazeBroadPhased GrazeBroadPhased;

// A part of the structure: the bounds of a node, or a cell, and its depth below the root (0).
typedef struct GrazeBroadPhasePartd {
  GrazeAabbd box;  // the bounds, or the cell
  uint32_t depth;  // of a node below the root; 0 for a cell of a grid
} GrazeBroadPhasePartd;

GRAZE_C_API GrazeStatus graze_broad_phase_create_d(GrazeBroadPhaseKind kind, GrazeBroadPhased **broad);
GRAZE_C_API void graze_broad_phase_destroy_d(GrazeBroadPhased *broad);

// Adds a box under an id that is not in use; sides may be infinite.
GRAZE_C_API GrazeStatus graze_broad_phase_insert_d(GrazeBroadPhased *broad, uint32_t id, const GrazeAabbd *box);
GRAZE_C_API GrazeStatus graze_broad_phase_move_d(GrazeBroadPhased *broad, uint32_t id, const GrazeAabbd *box);
GRAZE_C_API GrazeStatus graze_broad_phase_remove_d(GrazeBroadPhased *broad, uint32_t id);

// All pairs that overlap, the smaller id first; then only those of which one was inserted or moved since the last call
// of either.
GRAZE_C_API GrazeStatus graze_broad_phase_pairs_d(GrazeBroadPhased *broad, GrazeBufferd *buffer,
                                                  const GrazeIdPair **pairs, size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_moved_pairs_d(GrazeBroadPhased *broad, GrazeBufferd *buffer,
                                                        const GrazeIdPair **pairs, size_t *count);
// The boxes that overlap `box`, and those that it touches while it moves by `motion`; a point as `box` makes it a ray.
GRAZE_C_API GrazeStatus graze_broad_phase_query_d(const GrazeBroadPhased *broad, const GrazeAabbd *box,
                                                  GrazeBufferd *buffer, const uint32_t **ids, size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_sweep_d(const GrazeBroadPhased *broad, const GrazeAabbd *box,
                                                  GrazeVec3d motion, GrazeBufferd *buffer, const uint32_t **ids,
                                                  size_t *count);
// The parts of the structure as it is now, parents before their children, for drawing; sorted axes have no parts.
GRAZE_C_API GrazeStatus graze_broad_phase_parts_d(const GrazeBroadPhased *broad, GrazeBufferd *buffer,
                                                  const GrazeBroadPhasePartd **parts, size_t *count);
// Measures for comparing structures: number of boxes that the last call for pairs compared with another, and bytes
// held.
GRAZE_C_API GrazeStatus graze_broad_phase_counts_d(const GrazeBroadPhased *broad, uint64_t *tests, size_t *bytes);

// Changes of overlapping pairs from call to call (graze/pair_changes.hpp), for callers who keep data for each pair.
// Boxes are inserted, moved and removed as in a broad phase, and an instance has one of its own.
typedef struct GrazePairChangesd GrazePairChangesd;

GRAZE_C_API GrazeStatus graze_pair_changes_create_d(GrazeBroadPhaseKind kind, GrazePairChangesd **changes);
GRAZE_C_API void graze_pair_changes_destroy_d(GrazePairChangesd *changes);
GRAZE_C_API GrazeStatus graze_pair_changes_insert_d(GrazePairChangesd *changes, uint32_t id, const GrazeAabbd *box);
GRAZE_C_API GrazeStatus graze_pair_changes_move_d(GrazePairChangesd *changes, uint32_t id, const GrazeAabbd *box);
GRAZE_C_API GrazeStatus graze_pair_changes_remove_d(GrazePairChangesd *changes, uint32_t id);
// The pairs that overlap and did not at the last call, and those that did and do not any more.
GRAZE_C_API GrazeStatus graze_pair_changes_find_d(GrazePairChangesd *changes, GrazeBufferd *buffer,
                                                  const GrazeIdPair **begun, size_t *begun_count,
                                                  const GrazeIdPair **ended, size_t *ended_count);

// Worlds (graze/world.hpp) --------------------------------------------------------------------------------------------

typedef struct GrazeWorldd GrazeWorldd;

typedef struct GrazeWorldSettingsd {
  bool has_margin;
  double margin;  // distance up to which contacts are reported; without it graze_contact_margin of the two
  bool (*allow)(void *user, GrazeBodyId a, GrazeBodyId b);  // final decision on a pair that its filters allow, or null
  void *user;
  size_t points_per_pair;  // largest number of points of a pair; 0: all
} GrazeWorldSettingsd;

GRAZE_C_API GrazeWorldSettingsd graze_world_settings_default_d(void);

typedef struct GrazeBodyd {
  const GrazeShaped *shape;
  GrazePosed pose;
  GrazeVec3d linear, angular;  // velocity of the pose's origin, and angular velocity about it, in world axes
  GrazeFilter filter;
  bool fixed;    // never moves by itself: two fixed bodies are no pair
  bool trigger;  // only reports overlaps; has no contact points
  bool fast;     // is tested for what it would pass through before the next update
} GrazeBodyd;

// A body at the origin that may move and collides with everything.
GRAZE_C_API GrazeBodyd graze_body_default_d(const GrazeShaped *shape);

// Creates a world. `settings` and `executor` may be null: the defaults, and the calling thread. The executor is copied,
// the target of its `user` is not.
GRAZE_C_API GrazeStatus graze_world_create_d(const GrazeWorldSettingsd *settings, const GrazeExecutor *executor,
                                             GrazeWorldd **world);
// Creates a world that hands every changing call to `write`, to be played by graze_replay_d (docs/capture.md). Refuses
// what a file cannot hold: the caller's functions (`allow`, shapes of the caller's own), and changes of contacts.
GRAZE_C_API GrazeStatus graze_world_create_captured_d(const GrazeWorldSettingsd *settings,
                                                      const GrazeExecutor *executor, GrazeWriteFunction write,
                                                      void *user, GrazeWorldd **world);
GRAZE_C_API void graze_world_destroy_d(GrazeWorldd *world);

// The world of a simulation may be queried, but not changed, by the functions that follow.
GRAZE_C_API GrazeStatus graze_world_add_d(GrazeWorldd *world, const GrazeBodyd *body, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_world_remove_d(GrazeWorldd *world, GrazeBodyId id);
// Puts a body elsewhere, with a new velocity unless `velocity` is null.
GRAZE_C_API GrazeStatus graze_world_move_d(GrazeWorldd *world, GrazeBodyId id, const GrazePosed *pose,
                                           const GrazeVelocityd *velocity);
// Puts many bodies elsewhere, with new velocities unless `velocities` is null. Where one of the bodies, poses or
// velocities is refused none is moved.
GRAZE_C_API GrazeStatus graze_world_move_batch_d(GrazeWorldd *world, const GrazeBodyId *ids, size_t id_stride,
                                                 const GrazePosed *poses, size_t pose_stride,
                                                 const GrazeVelocityd *velocities, size_t velocity_stride,
                                                 size_t count);
GRAZE_C_API GrazeStatus graze_world_set_shape_d(GrazeWorldd *world, GrazeBodyId id, const GrazeShaped *shape);
GRAZE_C_API GrazeStatus graze_world_set_filter_d(GrazeWorldd *world, GrazeBodyId id, GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_world_set_fast_d(GrazeWorldd *world, GrazeBodyId id, bool fast);
// The name by which a replay calls a body, in UTF-8; a world that is not captured keeps none. It is valid in a replay
// until the replay's function returns; elsewhere, and without a name, it is empty.
GRAZE_C_API GrazeStatus graze_world_set_name_d(GrazeWorldd *world, GrazeBodyId id, const char *name);
GRAZE_C_API GrazeStatus graze_world_name_d(const GrazeWorldd *world, GrazeBodyId id, const char **name);
// Replaces the final decision on pairs of the settings; null allows all.
GRAZE_C_API GrazeStatus graze_world_set_allow_d(GrazeWorldd *world,
                                                bool (*allow)(void *user, GrazeBodyId a, GrazeBodyId b), void *user);

// The number of bodies, and that of indices: those of bodies are smaller.
GRAZE_C_API GrazeStatus graze_world_counts_d(const GrazeWorldd *world, size_t *bodies, size_t *indices);
GRAZE_C_API GrazeStatus graze_world_contains_d(const GrazeWorldd *world, GrazeBodyId id, bool *contains);
// The handle of the body that has the index now; `found` is true if there is one.
GRAZE_C_API GrazeStatus graze_world_body_at_d(const GrazeWorldd *world, uint32_t index, bool *found, GrazeBodyId *id);
// The description of a body. Its shape is one more share, for the caller to release.
GRAZE_C_API GrazeStatus graze_world_body_d(const GrazeWorldd *world, GrazeBodyId id, GrazeBodyd *body);
// All poses by index, valid until a body is added or moved; at an index without a body any pose.
GRAZE_C_API GrazeStatus graze_world_poses_d(const GrazeWorldd *world, const GrazePosed **poses, size_t *count);

// Finds the contacts of the present poses; and, given the time to the next update (or 0), the bodies that fast ones
// would pass through until then.
GRAZE_C_API GrazeStatus graze_world_update_d(GrazeWorldd *world, double duration);
// Recomputes the impacts only, by the velocities that bodies have now.
GRAZE_C_API GrazeStatus graze_world_find_impacts_d(GrazeWorldd *world, double duration);

typedef struct GrazeSolverPointd {
  GrazeVec3d a, b;
  double distance;
  uint32_t feature;
  double weight;
  GrazeVec3d impulse;  // the solver's: carried over to the same point of the next update, zero at a new one
} GrazeSolverPointd;

// Contacts of the last update, which belong to the world until the next.
typedef struct GrazeWorldContactsd {
  const GrazeWorldPair *pairs;  // sorted
  size_t pair_count;
  const GrazeManifoldd *manifolds;
  size_t manifold_count;
  const GrazeSolverPointd *points;
  size_t point_count;
} GrazeWorldContactsd;

GRAZE_C_API GrazeStatus graze_world_contacts_d(const GrazeWorldd *world, GrazeWorldContactsd *contacts);
// The contact points for a solver, which writes their impulses and nothing else.
GRAZE_C_API GrazeStatus graze_world_solver_points_d(GrazeWorldd *world, GrazeSolverPointd **points, size_t *count);
// Reduces every pair to at most `most` >= 1 points.
GRAZE_C_API GrazeStatus graze_world_reduce_d(GrazeWorldd *world, size_t most);
GRAZE_C_API GrazeStatus graze_world_events_d(const GrazeWorldd *world, const GrazeContactEvent **events, size_t *count);

// Two bodies and the time of their first contact: a.index < b.index, the normal of the hit from a to b.
typedef struct GrazeImpactd {
  GrazeBodyId a, b;
  bool trigger;
  GrazeCastHitd hit;
} GrazeImpactd;

// Impacts of fast bodies, in the order of time.
GRAZE_C_API GrazeStatus graze_world_impacts_d(const GrazeWorldd *world, const GrazeImpactd **impacts, size_t *count);

// A body and its distance from the query's shape, which is A.
typedef struct GrazeBodyDistanced {
  GrazeBodyId body;
  GrazeDistanced distance;
} GrazeBodyDistanced;

typedef struct GrazeBodyRayHitd {
  GrazeBodyId body;
  GrazeRayHitd hit;
} GrazeBodyRayHitd;

typedef struct GrazeBodyCastHitd {
  GrazeBodyId body;
  GrazeCastHitd hit;
} GrazeBodyCastHitd;

// Queries on bodies where they were last put. `filter` may be null: that of graze_query_filter_default.
GRAZE_C_API GrazeStatus graze_world_overlapping_d(const GrazeWorldd *world, const GrazeShaped *shape,
                                                  const GrazePosed *pose, const GrazeQueryFilter *filter,
                                                  GrazeBufferd *buffer, const GrazeBodyId **bodies, size_t *count);
GRAZE_C_API GrazeStatus graze_world_overlaps_any_d(const GrazeWorldd *world, const GrazeShaped *shape,
                                                   const GrazePosed *pose, const GrazeQueryFilter *filter, bool *any);
// The `most` bodies nearest to the shape, of those no further than `limit` (INFINITY for all), the nearest first.
GRAZE_C_API GrazeStatus graze_world_nearest_d(const GrazeWorldd *world, const GrazeShaped *shape,
                                              const GrazePosed *pose, size_t most, double limit,
                                              const GrazeQueryFilter *filter, GrazeBufferd *buffer,
                                              const GrazeBodyDistanced **bodies, size_t *count);
GRAZE_C_API GrazeStatus graze_world_raycast_d(const GrazeWorldd *world, const GrazeRayd *ray, double length,
                                              const GrazeQueryFilter *filter, GrazeBackFaces back, bool *found,
                                              GrazeBodyRayHitd *hit);
GRAZE_C_API GrazeStatus graze_world_raycast_any_d(const GrazeWorldd *world, const GrazeRayd *ray, double length,
                                                  const GrazeQueryFilter *filter, GrazeBackFaces back, bool *found);
GRAZE_C_API GrazeStatus graze_world_raycast_all_d(const GrazeWorldd *world, const GrazeRayd *ray, double length,
                                                  const GrazeQueryFilter *filter, GrazeBackFaces back,
                                                  GrazeBufferd *buffer, const GrazeBodyRayHitd **hits, size_t *count);
// The bodies that a shape meets while it moves for `duration` and the bodies stand still.
GRAZE_C_API GrazeStatus graze_world_cast_d(const GrazeWorldd *world, const GrazeMovingd *moving, double duration,
                                           const GrazeQueryFilter *filter, GrazeSeparating separating, bool *found,
                                           GrazeBodyCastHitd *hit);
GRAZE_C_API GrazeStatus graze_world_cast_all_d(const GrazeWorldd *world, const GrazeMovingd *moving, double duration,
                                               const GrazeQueryFilter *filter, GrazeSeparating separating,
                                               GrazeBufferd *buffer, const GrazeBodyCastHitd **hits, size_t *count);
// Moves a shape by `motion` until it touches, then along the surface, and so on, by at most `casts` casts
// (graze/slide.hpp): the pose at the end, the rest of the motion, and the obstacles.
GRAZE_C_API GrazeStatus graze_world_slide_d(const GrazeWorldd *world, const GrazeShaped *shape, const GrazePosed *pose,
                                            GrazeVec3d motion, int casts, const GrazeQueryFilter *filter,
                                            GrazeBufferd *buffer, GrazePosed *end, GrazeVec3d *left,
                                            const GrazeBodyCastHitd **touched, size_t *count);
// The part of a motion that planes leave: the nearest motion that leads into none of them. Their `normals` are unit and
// point away from the obstacles. The cost grows as the cube of their number.
GRAZE_C_API GrazeStatus graze_along_planes_d(GrazeVec3d motion, const GrazeVec3d *normals, size_t stride, size_t count,
                                             GrazeVec3d *left);
// Bytes that are held, without the shapes' own data.
GRAZE_C_API GrazeStatus graze_world_memory_d(const GrazeWorldd *world, size_t *bytes);

// Simulation (graze/simulation.hpp) -----------------------------------------------------------------------------------

typedef struct GrazeSimulationd GrazeSimulationd;

typedef struct GrazeSimulationSettingsd {
  GrazeVec3d gravity;
  int32_t sub_steps;       // least number of sub-steps of a step; a power of two
  int32_t most_sub_steps;  // largest number of sub-steps, for an island under load; a power of two
  bool sleep;              // islands at rest cost nothing and do not move
  bool continuous;         // fast bodies do not pass through others
  bool warm_start;         // sub-steps begin with the impulses of the last one; without it stacks sink and lean
  double longest_step;     // longer steps are refused
} GrazeSimulationSettingsd;

GRAZE_C_API GrazeSimulationSettingsd graze_simulation_settings_default_d(void);

// Dynamics of a body (graze/dynamics.hpp). Omitted values follow from the shape and the density.
typedef struct GrazeDynamicsd {
  bool has_mass, has_center_of_mass, has_inertia;
  double mass;  // > 0; INFINITY for a body that impulses do not change
  GrazeVec3d center_of_mass;
  GrazeVec3d inertia_diagonal;
  GrazeQuatd inertia_orientation;
  double density;
  double gravity_factor;
  double linear_damping, angular_damping;
  bool kinematic;  // keeps its given velocity: pushes other bodies and is not pushed
  bool may_sleep;
} GrazeDynamicsd;

GRAZE_C_API GrazeDynamicsd graze_dynamics_default_d(void);

typedef struct GrazeMateriald {
  double static_friction, dynamic_friction;
  double restitution;       // 0 to 1
  double rolling_friction;  // a length
  uint8_t friction_combine, restitution_combine;  // a GrazeCombine
  GrazeVec3d surface_velocity;  // velocity of a conveyor's surface, in the body's frame
} GrazeMateriald;

GRAZE_C_API GrazeMateriald graze_material_default_d(void);

// Bounds on axes of frame A: on one, or on two or three together.
typedef struct GrazeJointLimitd {
  uint8_t space;  // a GrazeJointSpace
  bool axes[3];
  double min, max;   // min <= max, either may be infinite; equal to hold an axis
  double stiffness;  // 0: hard; else force per length or torque per radian beyond the bounds
  double damping;    // damping of the soft limit
} GrazeJointLimitd;

// A motor on one axis of frame A: stiffness (position_target - position) + damping (velocity_target - velocity).
typedef struct GrazeJointDrived {
  uint8_t space;  // a GrazeJointSpace
  uint8_t mode;   // a GrazeDriveMode
  uint8_t axis;   // 0, 1, 2
  double position_target, velocity_target;
  double stiffness, damping;
  double max_force;
} GrazeJointDrived;

typedef struct GrazeJointd {
  GrazeBodyId a, b;             // a fixed body ties the other to the world
  GrazePosed frame_a, frame_b;  // each in its body's frame
  const GrazeJointLimitd *limits;
  size_t limit_count;
  const GrazeJointDrived *drives;
  size_t drive_count;
  bool enable_collision;  // whether the two bodies may touch each other
} GrazeJointd;

// A joint of a named kind without drives. Its limits are constants of the library.
GRAZE_C_API GrazeStatus graze_joint_of_kind_d(GrazeJointKind kind, GrazeBodyId a, const GrazePosed *frame_a,
                                              GrazeBodyId b, const GrazePosed *frame_b, GrazeJointd *joint);
// A slider whose translation along the x axis of frame A keeps from `min` to `max`, lengths of which either may be
// infinite. The limits belong to the buffer; bounds that no joint can have are refused when the joint is added.
GRAZE_C_API GrazeStatus graze_joint_slider_d(GrazeBodyId a, const GrazePosed *frame_a, GrazeBodyId b,
                                             const GrazePosed *frame_b, double min, double max, GrazeBufferd *buffer,
                                             GrazeJointd *joint);
// A joint that keeps the origins of the frames from `min` to `max` apart. The limit belongs to the buffer; bounds that
// no joint can have are refused when the joint is added.
GRAZE_C_API GrazeStatus graze_joint_distance_d(GrazeBodyId a, const GrazePosed *frame_a, GrazeBodyId b,
                                               const GrazePosed *frame_b, double min, double max, GrazeBufferd *buffer,
                                               GrazeJointd *joint);

// Statistics of a step (graze/simulation.hpp); times by the clock in milliseconds.
typedef struct GrazeStepReportd {
  size_t awake, islands, contacts, colors;
  int32_t most_sub_steps;
  size_t stopped;
  double deepest, mean_depth, residual;
  double kinetic_energy, potential_energy;
  GrazeVec3d momentum, angular_momentum;
  double collide_ms, prepare_ms, solve_ms, continuous_ms, whole_ms;
} GrazeStepReportd;

// A saved state of a simulation.
typedef struct GrazeStated GrazeStated;

// Creates a simulation. `settings` and `executor` may be null, as for a world.
GRAZE_C_API GrazeStatus graze_simulation_create_d(const GrazeSimulationSettingsd *settings,
                                                  const GrazeExecutor *executor, GrazeSimulationd **simulation);
// Creates a simulation that hands every changing call to `write`, as for a world. At most 16 of its states at a time.
GRAZE_C_API GrazeStatus graze_simulation_create_captured_d(const GrazeSimulationSettingsd *settings,
                                                           const GrazeExecutor *executor, GrazeWriteFunction write,
                                                           void *user, GrazeSimulationd **simulation);
GRAZE_C_API void graze_simulation_destroy_d(GrazeSimulationd *simulation);

// Adds a body. `dynamics` and `material` may be null: the defaults. A trigger is pushed by nothing that it touches: it
// keeps its velocity, or moves by gravity, forces and joints where its dynamics have a mass.
GRAZE_C_API GrazeStatus graze_simulation_add_d(GrazeSimulationd *simulation, const GrazeBodyd *body,
                                               const GrazeDynamicsd *dynamics, const GrazeMateriald *material,
                                               GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_simulation_remove_d(GrazeSimulationd *simulation, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_simulation_add_joint_d(GrazeSimulationd *simulation, const GrazeJointd *joint,
                                                     GrazeJointId *id);
// Replaces the frames, limits and drives of a joint of the same bodies from the next step on, as of a motor that gets
// another target. Its bodies wake.
GRAZE_C_API GrazeStatus graze_simulation_set_joint_d(GrazeSimulationd *simulation, GrazeJointId id,
                                                     const GrazeJointd *joint);
GRAZE_C_API GrazeStatus graze_simulation_remove_joint_d(GrazeSimulationd *simulation, GrazeJointId id);

// Advances the simulation by `dt` > 0.
GRAZE_C_API GrazeStatus graze_simulation_step_d(GrazeSimulationd *simulation, double dt);

GRAZE_C_API GrazeStatus graze_simulation_apply_impulse_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                         GrazeVec3d impulse, GrazeVec3d point);
GRAZE_C_API GrazeStatus graze_simulation_apply_angular_impulse_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                                 GrazeVec3d impulse);
// Applies a force on the centre of mass, or a torque, throughout the next step.
GRAZE_C_API GrazeStatus graze_simulation_apply_force_d(GrazeSimulationd *simulation, GrazeBodyId id, GrazeVec3d force);
GRAZE_C_API GrazeStatus graze_simulation_apply_torque_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                        GrazeVec3d torque);
GRAZE_C_API GrazeStatus graze_simulation_set_velocity_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                        const GrazeVelocityd *velocity);
GRAZE_C_API GrazeStatus graze_simulation_set_pose_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                    const GrazePosed *pose);
// Gives a kinematic body the velocity that takes it to `pose` in a step of `dt`.
GRAZE_C_API GrazeStatus graze_simulation_move_to_d(GrazeSimulationd *simulation, GrazeBodyId id, const GrazePosed *pose,
                                                   double dt);
// Replaces the filter of a body from the next step on. What it touches wakes.
GRAZE_C_API GrazeStatus graze_simulation_set_filter_d(GrazeSimulationd *simulation, GrazeBodyId id, GrazeFilter filter);
// Replaces the material of a body, of all of its pieces, from now on.
GRAZE_C_API GrazeStatus graze_simulation_set_material_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                        const GrazeMateriald *material);
// Gives the pieces of a body's shape materials of their own from now on: of_piece[i] is the place among the materials
// of that of piece i: children of a compound, triangles of a mesh or a height field (two for each cell, holes
// included), in the plane children of a compound and segments of a chain. A point of contact has the material of the
// piece whose surface is nearest to it. Refuses other shapes, a piece_count that is not that of the shape, places that
// are none, and invalid materials. Costs a search of the pieces in each step for each point of contact of the body.
GRAZE_C_API GrazeStatus graze_simulation_set_materials_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                         const GrazeMateriald *materials, size_t material_count,
                                                         const uint32_t *of_piece, size_t piece_count);
GRAZE_C_API GrazeStatus graze_simulation_set_gravity_d(GrazeSimulationd *simulation, GrazeVec3d gravity);
GRAZE_C_API GrazeStatus graze_simulation_wake_d(GrazeSimulationd *simulation, GrazeBodyId id);
// Names a body for a replay, as in a world.
GRAZE_C_API GrazeStatus graze_simulation_set_name_d(GrazeSimulationd *simulation, GrazeBodyId id,
                                                    const char *name);

GRAZE_C_API GrazeStatus graze_simulation_pose_d(const GrazeSimulationd *simulation, GrazeBodyId id, GrazePosed *pose);
// All poses by index, valid until the simulation changes; at an index without a body any pose.
GRAZE_C_API GrazeStatus graze_simulation_poses_d(const GrazeSimulationd *simulation, const GrazePosed **poses,
                                                 size_t *count);
// The velocity of the centre of mass and the rotation about it, and the position of that centre in the world.
GRAZE_C_API GrazeStatus graze_simulation_motion_d(const GrazeSimulationd *simulation, GrazeBodyId id,
                                                  GrazeVelocityd *velocity, GrazeVec3d *center_of_mass);
GRAZE_C_API GrazeStatus graze_simulation_angular_momentum_d(const GrazeSimulationd *simulation, GrazeBodyId id,
                                                            GrazeVec3d *momentum);
// The mass; infinite for fixed and kinematic bodies.
GRAZE_C_API GrazeStatus graze_simulation_mass_d(const GrazeSimulationd *simulation, GrazeBodyId id, double *mass);
GRAZE_C_API GrazeStatus graze_simulation_asleep_d(const GrazeSimulationd *simulation, GrazeBodyId id, bool *asleep);
// The sub-steps of the body's island in the last step; 0 before its first.
GRAZE_C_API GrazeStatus graze_simulation_sub_steps_d(const GrazeSimulationd *simulation, GrazeBodyId id,
                                                     int32_t *sub_steps);
// All joints, by index, and one as it was added, whose limits and drives belong to the buffer.
GRAZE_C_API GrazeStatus graze_simulation_joints_d(const GrazeSimulationd *simulation, GrazeBufferd *buffer,
                                                  const GrazeJointId **joints, size_t *count);
GRAZE_C_API GrazeStatus graze_simulation_joint_d(const GrazeSimulationd *simulation, GrazeJointId id,
                                                 GrazeBufferd *buffer, GrazeJointd *joint);
// The impulses of the last step, a number for each row of the joint, valid until the next step.
GRAZE_C_API GrazeStatus graze_simulation_joint_impulses_d(const GrazeSimulationd *simulation, GrazeJointId id,
                                                          const double **impulses, size_t *count);
GRAZE_C_API GrazeStatus graze_simulation_report_d(const GrazeSimulationd *simulation, GrazeStepReportd *report);
// The settings as they are now.
GRAZE_C_API GrazeStatus graze_simulation_settings_d(const GrazeSimulationd *simulation,
                                                    GrazeSimulationSettingsd *settings);
// The world of the simulation, which belongs to it: contacts, events and all queries.
GRAZE_C_API GrazeStatus graze_simulation_world_d(const GrazeSimulationd *simulation, const GrazeWorldd **world);
// The simulation whose world it is, for questions alone: also in a replay, which refuses changes to it. Null for a
// world of its own.
GRAZE_C_API GrazeStatus graze_world_simulation_d(const GrazeWorldd *world, const GrazeSimulationd **simulation);

// A hash of all bits that the next step depends on. Equal runs have equal hashes, also after a restore.
GRAZE_C_API GrazeStatus graze_simulation_state_hash_d(const GrazeSimulationd *simulation, uint64_t *hash);
GRAZE_C_API GrazeStatus graze_simulation_save_d(const GrazeSimulationd *simulation, GrazeStated **state);
// Goes back to a state of this simulation, or on from one of another with the same bodies and joints, added and removed
// in the same order; an error where there are others now.
GRAZE_C_API GrazeStatus graze_simulation_restore_d(GrazeSimulationd *simulation, const GrazeStated *state);
// Hands the bytes of a state to `write` at one call, for a file or another computer. An error for a state of a captured
// simulation, and where `write` returns false.
GRAZE_C_API GrazeStatus graze_state_bytes_d(const GrazeStated *state, GrazeWriteFunction write, void *user);
// The state whose bytes these are, in a handle of its own. An error for bytes that are no state of this scalar, or were
// changed.
GRAZE_C_API GrazeStatus graze_state_read_d(const void *bytes, size_t size, GrazeStated **state);
GRAZE_C_API void graze_state_destroy_d(GrazeStated *state);

// The plane (graze/plane/) --------------------------------------------------------------------------------------------
//
// Types and functions of two dimensions, with the meaning of those above.

typedef struct GrazeVec2d {
  double x, y;
} GrazeVec2d;

// A rotation: the unit vector to which it turns the X axis; the identity is {1, 0}.
typedef struct GrazeRot2d {
  double cosine, sine;
} GrazeRot2d;

typedef struct GrazePose2d {
  GrazeVec2d translation;
  GrazeRot2d rotation;
} GrazePose2d;

typedef struct GrazeAabb2d {
  GrazeVec2d lower, upper;
} GrazeAabb2d;

GRAZE_C_API GrazePose2d graze_plane_pose_d(double x, double y, double angle);

typedef struct GrazePlaneShaped GrazePlaneShaped;

GRAZE_C_API GrazeStatus graze_plane_shape_circle_d(double radius, GrazePlaneShaped **shape);
// A capsule with `height` between the centres of the discs, which lie on the Y axis about the origin.
GRAZE_C_API GrazeStatus graze_plane_shape_capsule_d(double height, double radius_bottom, double radius_top,
                                                    GrazePlaneShaped **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_box_d(GrazeVec2d size, GrazePlaneShaped **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_segment_d(GrazeVec2d a, GrazeVec2d b, GrazePlaneShaped **shape);
// The convex hull of at least one point.
GRAZE_C_API GrazeStatus graze_plane_shape_convex_d(const GrazeVec2d *points, size_t stride, size_t count,
                                                   GrazePlaneShaped **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_ellipse_d(GrazeVec2d radii, GrazePlaneShaped **shape);
// The half-plane of all points with y <= 0.
GRAZE_C_API GrazeStatus graze_plane_shape_half_plane_d(GrazePlaneShaped **shape);
// A solid polygon, convex or not: at least three points around it, either way, without crossings.
GRAZE_C_API GrazeStatus graze_plane_shape_polygon_d(const GrazeVec2d *points, size_t stride, size_t count,
                                                    GrazePlaneShaped **shape);
// A chain: segments joined end to end; a `closed` one goes on from the last point to the first.
GRAZE_C_API GrazeStatus graze_plane_shape_chain_d(const GrazeVec2d *points, size_t stride, size_t count, bool closed,
                                                  GrazeSides sides, GrazePlaneShaped **shape);

typedef struct GrazePlaneChildd {
  const GrazePlaneShaped *shape;
  GrazePose2d pose;
} GrazePlaneChildd;

GRAZE_C_API GrazeStatus graze_plane_shape_compound_d(const GrazePlaneChildd *children, size_t stride, size_t count,
                                                     GrazePlaneShaped **shape);
// A convex shape of the caller's own, with the functions of graze_shape_user_d.
GRAZE_C_API GrazeStatus graze_plane_shape_user_d(GrazeVec2d (*support)(const void *user, GrazeVec2d direction),
                                                 void (*release)(void *user), void *user, GrazePlaneShaped **shape);
// The shape with a disc of radius `rounding` added, in addition to its present rounding; of a compound each child grows
// by it.
GRAZE_C_API GrazeStatus graze_plane_shape_rounded_d(const GrazePlaneShaped *shape, double rounding,
                                                    GrazePlaneShaped **rounded);
// The region that a bounded convex shape, standing at `pose`, sweeps while it moves by `motion` without turning
// (graze/plane/swept.hpp).
GRAZE_C_API GrazeStatus graze_plane_shape_swept_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                  GrazeVec2d motion, GrazePlaneShaped **swept);
GRAZE_C_API void graze_plane_shape_retain_d(const GrazePlaneShaped *shape);
GRAZE_C_API void graze_plane_shape_release_d(const GrazePlaneShaped *shape);
GRAZE_C_API GrazeStatus graze_plane_shape_kind_d(const GrazePlaneShaped *shape, GrazePlaneShapeKind *kind);
GRAZE_C_API GrazeStatus graze_plane_shape_rounding_d(const GrazePlaneShaped *shape, double *rounding);
GRAZE_C_API GrazeStatus graze_plane_shape_bounds_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                   GrazeAabb2d *bounds);
// The point of a bounded convex shape furthest along `direction`, in the shape's frame (graze/plane/support.hpp).
GRAZE_C_API GrazeStatus graze_plane_shape_support_d(const GrazePlaneShaped *shape, GrazeVec2d direction,
                                                    GrazeVec2d *point);

// The measures that a shape was made of, without its rounding; 0 and false where its kind has no such measure.
typedef struct GrazePlaneShapeMeasuresd {
  GrazeVec2d size;            // full edge lengths of a box
  GrazeVec2d radii;           // half axes of an ellipse
  double height;              // between the centres of a capsule's discs
  double radius, radius_top;  // radius of a circle; radii of a capsule at -Y and at +Y
  size_t children;            // number of a compound's children
  bool convex;                // a half-plane is; polygons, chains and compounds are not, whatever their corners
  bool closed;                // a chain goes on from its last point to the first
  GrazeSides sides;           // the sides of a chain that push
} GrazePlaneShapeMeasuresd;

// The measures of a shape of any kind, in constant time.
GRAZE_C_API GrazeStatus graze_plane_shape_measures_d(const GrazePlaneShaped *shape, GrazePlaneShapeMeasuresd *measures);
// The vertices of a convex polygon, the corners of a polygon or a chain without those on straight lines, the ends of a
// segment; other kinds are refused. The points belong to the buffer; the time grows with their number.
GRAZE_C_API GrazeStatus graze_plane_shape_points_d(const GrazePlaneShaped *shape, GrazeBufferd *buffer,
                                                   const GrazeVec2d **points, size_t *count);
// The child of a compound by its index, as in space.
GRAZE_C_API GrazeStatus graze_plane_shape_child_d(const GrazePlaneShaped *compound, size_t index,
                                                  GrazePlaneChildd *child);

// Properties of a body of density one; the inertia is about `center`, in the shape's frame. Area 0 for shapes without.
typedef struct GrazePlaneMassPropertiesd {
  double area;
  GrazeVec2d center;  // centre of the area
  double inertia;
} GrazePlaneMassPropertiesd;

GRAZE_C_API GrazeStatus graze_plane_shape_mass_properties_d(const GrazePlaneShaped *shape,
                                                            GrazePlaneMassPropertiesd *properties);

typedef struct GrazePlaneDistanced {
  double distance;
  GrazeVec2d normal, a, b;
  uint8_t certainty;
  double error;
} GrazePlaneDistanced;

typedef struct GrazePlaneClosestd {
  double distance;
  GrazeVec2d point, normal;
  uint8_t certainty;
  double error;
} GrazePlaneClosestd;

// Two convex pieces and their distance: the child of the outermost compound, the piece of a polygon or the segment of a
// chain, else 0.
typedef struct GrazePlanePieceDistanced {
  uint32_t piece_a, piece_b;
  GrazePlaneDistanced distance;
} GrazePlanePieceDistanced;

typedef struct GrazePlaneContactPointd {
  GrazeVec2d a, b;
  double distance;
  uint32_t feature;
  double weight;
} GrazePlaneContactPointd;

typedef struct GrazePlaneManifoldd {
  GrazeVec2d normal;
  uint32_t piece_a, piece_b;
  uint32_t first_point, point_count;
} GrazePlaneManifoldd;

typedef struct GrazePlaneContactsd {
  bool overlap;
  uint8_t certainty;
  double error;
  const GrazePlaneManifoldd *manifolds;
  size_t manifold_count;
  const GrazePlaneContactPointd *points;
  size_t point_count;
} GrazePlaneContactsd;

typedef struct GrazePlaneBatchContactsd {
  const GrazePairContacts *pairs;
  size_t pair_count;
  const GrazePlaneManifoldd *manifolds;
  size_t manifold_count;
  const GrazePlaneContactPointd *points;
  size_t point_count;
} GrazePlaneBatchContactsd;

typedef struct GrazePlaneRayd {
  GrazeVec2d origin, direction;
} GrazePlaneRayd;

typedef struct GrazePlaneRayHitd {
  double t;
  GrazeVec2d point, normal;
  uint32_t piece;
  uint8_t certainty;
} GrazePlaneRayHitd;

typedef struct GrazePlaneVelocityd {
  GrazeVec2d linear;
  double angular;  // counter-clockwise
} GrazePlaneVelocityd;

typedef struct GrazePlaneCastHitd {
  double t;
  GrazeVec2d point, normal;
  double depth;
  uint8_t certainty;
  uint32_t piece_a, piece_b;
} GrazePlaneCastHitd;

typedef struct GrazePlaneMovingd {
  const GrazePlaneShaped *shape;
  GrazePose2d pose;
  GrazePlaneVelocityd velocity;
} GrazePlaneMovingd;

GRAZE_C_API GrazeStatus graze_plane_overlap_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                              const GrazePlaneShaped *b, const GrazePose2d *pose_b, bool *overlap);
GRAZE_C_API GrazeStatus graze_plane_distance_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                               const GrazePlaneShaped *b, const GrazePose2d *pose_b,
                                               GrazePlaneDistanced *distance);
// Shapes no further apart than a limit, as in space (graze/plane/proximity.hpp).
GRAZE_C_API GrazeStatus graze_plane_distance_up_to_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                                     const GrazePlaneShaped *b, const GrazePose2d *pose_b, double limit,
                                                     bool *found, GrazePlaneDistanced *distance);
GRAZE_C_API GrazeStatus graze_plane_within_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                             const GrazePlaneShaped *b, const GrazePose2d *pose_b, double limit,
                                             bool *within);
GRAZE_C_API GrazeStatus graze_plane_near_pieces_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                                  const GrazePlaneShaped *b, const GrazePose2d *pose_b, double margin,
                                                  GrazeBufferd *buffer, const GrazePlanePieceDistanced **pieces,
                                                  size_t *count);
GRAZE_C_API GrazeStatus graze_plane_contacts_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                               const GrazePlaneShaped *b, const GrazePose2d *pose_b, double margin,
                                               GrazeBufferd *buffer, GrazePlaneContactsd *contacts);
// At most `most` >= 1 points, as those of space.
GRAZE_C_API GrazeStatus graze_plane_contacts_reduced_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                                       const GrazePlaneShaped *b, const GrazePose2d *pose_b,
                                                       double margin, size_t most, GrazeBufferd *buffer,
                                                       GrazePlaneContactsd *contacts);
GRAZE_C_API GrazeStatus graze_plane_contact_margin_d(const GrazePlaneShaped *a, const GrazePlaneShaped *b,
                                                     double *margin);
// The corners of a feature (graze/plane/feature_corners.hpp), as in space: one for a vertex, two for an edge.
GRAZE_C_API GrazeStatus graze_plane_feature_corners_d(const GrazePlaneShaped *shape, uint32_t piece, uint16_t feature,
                                                      GrazeBufferd *buffer, const GrazeVec2d **corners, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_closest_d(const GrazePlaneShaped *shape, const GrazePose2d *pose, GrazeVec2d point,
                                              GrazePlaneClosestd *closest);
GRAZE_C_API GrazeStatus graze_plane_raycast_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                              const GrazePlaneRayd *ray, double length, bool *found,
                                              GrazePlaneRayHitd *hit);
GRAZE_C_API GrazeStatus graze_plane_raycast_any_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                  const GrazePlaneRayd *ray, double length, bool *found);
GRAZE_C_API GrazeStatus graze_plane_raycast_all_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                  const GrazePlaneRayd *ray, double length, GrazeBufferd *buffer,
                                                  const GrazePlaneRayHitd **hits, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_cast_d(const GrazePlaneMovingd *a, const GrazePlaneMovingd *b, double duration,
                                           GrazeSeparating separating, bool *found, GrazePlaneCastHitd *hit);
GRAZE_C_API GrazeStatus graze_plane_cast_all_d(const GrazePlaneMovingd *a, const GrazePlaneMovingd *b, double duration,
                                               GrazeSeparating separating, GrazeBufferd *buffer,
                                               const GrazePlaneCastHitd **hits, size_t *count);
// The queries above with their traces, as in space.
GRAZE_C_API GrazeStatus graze_plane_overlap_explained_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                                        const GrazePlaneShaped *b, const GrazePose2d *pose_b,
                                                        bool *overlap, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_distance_explained_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                                         const GrazePlaneShaped *b, const GrazePose2d *pose_b,
                                                         GrazePlaneDistanced *distance, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_contacts_explained_d(const GrazePlaneShaped *a, const GrazePose2d *pose_a,
                                                         const GrazePlaneShaped *b, const GrazePose2d *pose_b,
                                                         double margin, GrazeBufferd *buffer,
                                                         GrazePlaneContactsd *contacts, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_closest_explained_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                        GrazeVec2d point, GrazePlaneClosestd *closest,
                                                        GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_raycast_explained_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                        const GrazePlaneRayd *ray, double length, bool *found,
                                                        GrazePlaneRayHitd *hit, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_cast_explained_d(const GrazePlaneMovingd *a, const GrazePlaneMovingd *b,
                                                     double duration, GrazeSeparating separating, bool *found,
                                                     GrazePlaneCastHitd *hit, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_pose_at_d(const GrazePose2d *pose, const GrazePlaneVelocityd *velocity, double t,
                                              GrazePose2d *result);

// Shapes and their poses, as GrazeBodiesd.
typedef struct GrazePlaneBodiesd {
  const GrazePlaneShaped *const *shapes;
  size_t shape_stride, shape_count;
  const GrazeVec2d *translations;
  size_t translation_stride;
  const GrazeRot2d *rotations;  // or null: no rotations
  size_t rotation_stride;
  size_t pose_count;
} GrazePlaneBodiesd;

GRAZE_C_API GrazePlaneBodiesd graze_plane_bodies_d(const GrazePlaneShaped *const *shapes, size_t shape_count,
                                                   const GrazePose2d *poses, size_t pose_count);

typedef struct GrazePlaneBatchd {
  GrazePlaneBodiesd a, b;
  const GrazeIdPair *places;
  size_t place_stride, place_count;
} GrazePlaneBatchd;

GRAZE_C_API GrazeStatus graze_plane_batch_size_d(const GrazePlaneBatchd *batch, size_t *size);
// `executor` may be null in all batches of the plane: the calling thread. The answers are the same, in the same order;
// functions that a shape calls back are called from its threads.
GRAZE_C_API GrazeStatus graze_plane_overlap_batch_d(const GrazePlaneBatchd *batch, uint8_t *touch, size_t stride,
                                                    const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_distance_batch_d(const GrazePlaneBatchd *batch, GrazePlaneDistanced *distances,
                                                     size_t stride, const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_contacts_batch_d(const GrazePlaneBatchd *batch, double margin,
                                                     GrazeBufferd *buffer, GrazePlaneBatchContactsd *contacts,
                                                     const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_contacts_batch_reduced_d(const GrazePlaneBatchd *batch, double margin, size_t most,
                                                             GrazeBufferd *buffer,
                                                             GrazePlaneBatchContactsd *contacts,
                                                             const GrazeExecutor *executor);
// The near pieces of all pairs, as graze_near_pieces_batch_d has them, on the calling thread.
GRAZE_C_API GrazeStatus graze_plane_near_pieces_batch_d(const GrazePlaneBatchd *batch, double margin,
                                                        GrazeBufferd *buffer, const GrazePlanePieceDistanced **pieces,
                                                        const size_t **ends, size_t *count);
// Batches of one shape and many points or rays, and of many moving pairs, as in space.
GRAZE_C_API GrazeStatus graze_plane_closest_batch_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                    const GrazeVec2d *points, size_t point_stride, size_t count,
                                                    GrazePlaneClosestd *closest, size_t closest_stride,
                                                    const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_raycast_batch_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                    const GrazePlaneRayd *rays, size_t ray_stride, size_t count,
                                                    double length, uint8_t *found, size_t found_stride,
                                                    GrazePlaneRayHitd *hits, size_t hit_stride);
GRAZE_C_API GrazeStatus graze_plane_cast_batch_d(const GrazePlaneMovingd *a, size_t a_stride,
                                                 const GrazePlaneMovingd *b, size_t b_stride, size_t count,
                                                 double duration, GrazeSeparating separating, uint8_t *found,
                                                 size_t found_stride, GrazePlaneCastHitd *hits, size_t hit_stride,
                                                 const GrazeExecutor *executor);

// Propagation of impacts and free motion in the plane (graze/plane/blows.hpp, graze/plane/free_motion.hpp), as in
// space.
typedef struct GrazePlaneMotiond {
  GrazeVec2d linear;
  double angular;     // counter-clockwise
  GrazeVec2d center;  // centre of mass
} GrazePlaneMotiond;

typedef struct GrazePlaneInverseMassd {
  double mass, inertia;  // inverse mass and inertia; zeros for an immovable body
} GrazePlaneInverseMassd;

typedef struct GrazePlaneStruckBodyd {
  GrazePlaneMotiond motion;
  GrazePlaneInverseMassd mass;
} GrazePlaneStruckBodyd;

typedef struct GrazePlaneBlowd {
  uint32_t a, b;
  GrazeVec2d normal;
  double restitution;
  uint32_t first_point, point_count;
} GrazePlaneBlowd;

typedef struct GrazePlaneTouchingd {
  GrazePlaneStruckBodyd *bodies;
  size_t body_stride, body_count;
  const GrazePlaneBlowd *blows;
  size_t blow_stride, blow_count;
  const GrazeVec2d *points;
  size_t point_stride, point_count;
  double *impulses;
  size_t impulse_stride;
} GrazePlaneTouchingd;

typedef struct GrazePlaneFreeBodyd {
  GrazeVec2d center;
  GrazeRot2d rotation;
  GrazeVec2d linear;
  double angular_momentum, inverse_inertia;
} GrazePlaneFreeBodyd;

GRAZE_C_API GrazeStatus graze_plane_apply_impulse_d(const GrazePlaneStruckBodyd *body, GrazeVec2d impulse,
                                                    GrazeVec2d point, GrazePlaneMotiond *motion);
GRAZE_C_API GrazeStatus graze_plane_pass_on_d(const GrazePlaneTouchingd *touching, double resting_speed, size_t most,
                                              GrazePassedOnd *passed);
GRAZE_C_API GrazeStatus graze_plane_free_angular_velocity_d(const GrazePlaneFreeBodyd *body, double *angular);
GRAZE_C_API GrazeStatus graze_plane_free_set_angular_velocity_d(GrazePlaneFreeBodyd *body, double angular);
GRAZE_C_API GrazeStatus graze_plane_free_advance_d(GrazePlaneFreeBodyd *body, GrazeVec2d acceleration,
                                                   double duration);

// Worlds of the plane (graze/plane/world.hpp): settings, executors and filters are those of worlds of space, and so are
// the functions, except for sliding.

typedef struct GrazePlaneWorldd GrazePlaneWorldd;

typedef struct GrazePlaneBodyd {
  const GrazePlaneShaped *shape;
  GrazePose2d pose;
  GrazeVec2d linear;  // velocity of the pose's origin
  double angular;     // angular velocity about it, counter-clockwise
  GrazeFilter filter;
  bool fixed;    // never moves by itself: two fixed bodies are no pair
  bool trigger;  // only reports overlaps; has no contact points
  bool fast;     // is tested for what it would pass through before the next update
} GrazePlaneBodyd;

// A body at the origin that may move and collides with everything.
GRAZE_C_API GrazePlaneBodyd graze_plane_body_default_d(const GrazePlaneShaped *shape);

// Creates a world. `settings` and `executor` may be null: the defaults, and the calling thread. The executor is copied,
// the target of its `user` is not.
GRAZE_C_API GrazeStatus graze_plane_world_create_d(const GrazeWorldSettingsd *settings, const GrazeExecutor *executor,
                                                   GrazePlaneWorldd **world);
GRAZE_C_API GrazeStatus graze_plane_world_create_captured_d(const GrazeWorldSettingsd *settings,
                                                            const GrazeExecutor *executor, GrazeWriteFunction write,
                                                            void *user, GrazePlaneWorldd **world);
GRAZE_C_API void graze_plane_world_destroy_d(GrazePlaneWorldd *world);

GRAZE_C_API GrazeStatus graze_plane_world_add_d(GrazePlaneWorldd *world, const GrazePlaneBodyd *body, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_plane_world_remove_d(GrazePlaneWorldd *world, GrazeBodyId id);
// Puts a body elsewhere, with a new velocity unless `velocity` is null.
GRAZE_C_API GrazeStatus graze_plane_world_move_d(GrazePlaneWorldd *world, GrazeBodyId id, const GrazePose2d *pose,
                                                 const GrazePlaneVelocityd *velocity);
// Puts many bodies elsewhere, with new velocities unless `velocities` is null. Where one of the bodies, poses or
// velocities is refused none is moved.
GRAZE_C_API GrazeStatus graze_plane_world_move_batch_d(GrazePlaneWorldd *world, const GrazeBodyId *ids,
                                                       size_t id_stride, const GrazePose2d *poses, size_t pose_stride,
                                                       const GrazePlaneVelocityd *velocities, size_t velocity_stride,
                                                       size_t count);
GRAZE_C_API GrazeStatus graze_plane_world_set_shape_d(GrazePlaneWorldd *world, GrazeBodyId id,
                                                      const GrazePlaneShaped *shape);
GRAZE_C_API GrazeStatus graze_plane_world_set_filter_d(GrazePlaneWorldd *world, GrazeBodyId id, GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_plane_world_set_fast_d(GrazePlaneWorldd *world, GrazeBodyId id, bool fast);
// Names in a capture, as in a world of space.
GRAZE_C_API GrazeStatus graze_plane_world_set_name_d(GrazePlaneWorldd *world, GrazeBodyId id, const char *name);
GRAZE_C_API GrazeStatus graze_plane_world_name_d(const GrazePlaneWorldd *world, GrazeBodyId id, const char **name);
// Replaces the final decision on pairs of the settings; null allows all.
GRAZE_C_API GrazeStatus graze_plane_world_set_allow_d(GrazePlaneWorldd *world,
                                                      bool (*allow)(void *user, GrazeBodyId a, GrazeBodyId b),
                                                      void *user);

// The number of bodies, and that of indices: those of bodies are smaller.
GRAZE_C_API GrazeStatus graze_plane_world_counts_d(const GrazePlaneWorldd *world, size_t *bodies, size_t *indices);
GRAZE_C_API GrazeStatus graze_plane_world_contains_d(const GrazePlaneWorldd *world, GrazeBodyId id, bool *contains);
// The handle of the body that has the index now; `found` is true if there is one.
GRAZE_C_API GrazeStatus graze_plane_world_body_at_d(const GrazePlaneWorldd *world, uint32_t index, bool *found,
                                                    GrazeBodyId *id);
// The description of a body. Its shape is one more share, for the caller to release.
GRAZE_C_API GrazeStatus graze_plane_world_body_d(const GrazePlaneWorldd *world, GrazeBodyId id, GrazePlaneBodyd *body);
// All poses by index, valid until a body is added or moved; at an index without a body any pose.
GRAZE_C_API GrazeStatus graze_plane_world_poses_d(const GrazePlaneWorldd *world, const GrazePose2d **poses,
                                                  size_t *count);

// Finds the contacts of the present poses; and, given the time to the next update (or 0), the bodies that fast ones
// would pass through until then.
GRAZE_C_API GrazeStatus graze_plane_world_update_d(GrazePlaneWorldd *world, double duration);
// Recomputes the impacts only, by the velocities that bodies have now.
GRAZE_C_API GrazeStatus graze_plane_world_find_impacts_d(GrazePlaneWorldd *world, double duration);

typedef struct GrazePlaneSolverPointd {
  GrazeVec2d a, b;
  double distance;
  uint32_t feature;
  double weight;
  GrazeVec2d impulse;  // the solver's: carried over to the same point of the next update, zero at a new one
} GrazePlaneSolverPointd;

// Contacts of the last update, which belong to the world until the next.
typedef struct GrazePlaneWorldContactsd {
  const GrazeWorldPair *pairs;  // sorted
  size_t pair_count;
  const GrazePlaneManifoldd *manifolds;
  size_t manifold_count;
  const GrazePlaneSolverPointd *points;
  size_t point_count;
} GrazePlaneWorldContactsd;

GRAZE_C_API GrazeStatus graze_plane_world_contacts_d(const GrazePlaneWorldd *world, GrazePlaneWorldContactsd *contacts);
// The contact points for a solver, which writes their impulses and nothing else.
GRAZE_C_API GrazeStatus graze_plane_world_solver_points_d(GrazePlaneWorldd *world, GrazePlaneSolverPointd **points,
                                                          size_t *count);
// Reduces every pair to at most `most` >= 1 points.
GRAZE_C_API GrazeStatus graze_plane_world_reduce_d(GrazePlaneWorldd *world, size_t most);
GRAZE_C_API GrazeStatus graze_plane_world_events_d(const GrazePlaneWorldd *world, const GrazeContactEvent **events,
                                                   size_t *count);

// Two bodies and the time of their first contact: a.index < b.index, the normal of the hit from a to b.
typedef struct GrazePlaneImpactd {
  GrazeBodyId a, b;
  bool trigger;
  GrazePlaneCastHitd hit;
} GrazePlaneImpactd;

// Impacts of fast bodies, in the order of time.
GRAZE_C_API GrazeStatus graze_plane_world_impacts_d(const GrazePlaneWorldd *world, const GrazePlaneImpactd **impacts,
                                                    size_t *count);

// A body and its distance from the query's shape, which is A.
typedef struct GrazePlaneBodyDistanced {
  GrazeBodyId body;
  GrazePlaneDistanced distance;
} GrazePlaneBodyDistanced;

typedef struct GrazePlaneBodyRayHitd {
  GrazeBodyId body;
  GrazePlaneRayHitd hit;
} GrazePlaneBodyRayHitd;

typedef struct GrazePlaneBodyCastHitd {
  GrazeBodyId body;
  GrazePlaneCastHitd hit;
} GrazePlaneBodyCastHitd;

// Queries on bodies where they were last put. `filter` may be null: that of graze_query_filter_default.
GRAZE_C_API GrazeStatus graze_plane_world_overlapping_d(const GrazePlaneWorldd *world, const GrazePlaneShaped *shape,
                                                        const GrazePose2d *pose, const GrazeQueryFilter *filter,
                                                        GrazeBufferd *buffer, const GrazeBodyId **bodies,
                                                        size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_overlaps_any_d(const GrazePlaneWorldd *world, const GrazePlaneShaped *shape,
                                                         const GrazePose2d *pose, const GrazeQueryFilter *filter,
                                                         bool *any);
// The `most` bodies nearest to the shape, of those no further than `limit` (INFINITY for all), the nearest first.
GRAZE_C_API GrazeStatus graze_plane_world_nearest_d(const GrazePlaneWorldd *world, const GrazePlaneShaped *shape,
                                                    const GrazePose2d *pose, size_t most, double limit,
                                                    const GrazeQueryFilter *filter, GrazeBufferd *buffer,
                                                    const GrazePlaneBodyDistanced **bodies, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_raycast_d(const GrazePlaneWorldd *world, const GrazePlaneRayd *ray,
                                                    double length, const GrazeQueryFilter *filter, bool *found,
                                                    GrazePlaneBodyRayHitd *hit);
GRAZE_C_API GrazeStatus graze_plane_world_raycast_any_d(const GrazePlaneWorldd *world, const GrazePlaneRayd *ray,
                                                        double length, const GrazeQueryFilter *filter, bool *found);
GRAZE_C_API GrazeStatus graze_plane_world_raycast_all_d(const GrazePlaneWorldd *world, const GrazePlaneRayd *ray,
                                                        double length, const GrazeQueryFilter *filter,
                                                        GrazeBufferd *buffer, const GrazePlaneBodyRayHitd **hits,
                                                        size_t *count);
// The bodies that a shape meets while it moves for `duration` and the bodies stand still.
GRAZE_C_API GrazeStatus graze_plane_world_cast_d(const GrazePlaneWorldd *world, const GrazePlaneMovingd *moving,
                                                 double duration, const GrazeQueryFilter *filter,
                                                 GrazeSeparating separating, bool *found, GrazePlaneBodyCastHitd *hit);
GRAZE_C_API GrazeStatus graze_plane_world_cast_all_d(const GrazePlaneWorldd *world, const GrazePlaneMovingd *moving,
                                                     double duration, const GrazeQueryFilter *filter,
                                                     GrazeSeparating separating, GrazeBufferd *buffer,
                                                     const GrazePlaneBodyCastHitd **hits, size_t *count);
// Moves a shape by `motion` as in space, along the outlines that it touches (graze/plane/slide.hpp).
GRAZE_C_API GrazeStatus graze_plane_world_slide_d(const GrazePlaneWorldd *world, const GrazePlaneShaped *shape,
                                                  const GrazePose2d *pose, GrazeVec2d motion, int casts,
                                                  const GrazeQueryFilter *filter, GrazeBufferd *buffer,
                                                  GrazePose2d *end, GrazeVec2d *left,
                                                  const GrazePlaneBodyCastHitd **touched, size_t *count);
// The part of a motion that lines leave, as graze_along_planes_d.
GRAZE_C_API GrazeStatus graze_plane_along_lines_d(GrazeVec2d motion, const GrazeVec2d *normals, size_t stride,
                                                  size_t count, GrazeVec2d *left);
// Bytes that are held, without the shapes' own data.
GRAZE_C_API GrazeStatus graze_plane_world_memory_d(const GrazePlaneWorldd *world, size_t *bytes);

// Simulations of the plane (graze/plane/simulation.hpp): functions as in space. Limits and drives of joints are the
// same; their axes are x and y to move along, and z to turn about.

typedef struct GrazePlaneSimulationd GrazePlaneSimulationd;

typedef struct GrazePlaneSimulationSettingsd {
  GrazeVec2d gravity;
  int32_t sub_steps;       // least number of sub-steps of a step; a power of two
  int32_t most_sub_steps;  // largest number of sub-steps, for an island under load; a power of two
  bool sleep;              // islands at rest cost nothing and do not move
  bool continuous;         // fast bodies do not pass through others
  bool warm_start;         // sub-steps begin with the impulses of the last one; without it stacks sink and lean
  double longest_step;     // longer steps are refused
} GrazePlaneSimulationSettingsd;

GRAZE_C_API GrazePlaneSimulationSettingsd graze_plane_simulation_settings_default_d(void);

// Dynamics of a body (graze/plane/dynamics.hpp). Omitted values follow from the shape and the density.
typedef struct GrazePlaneDynamicsd {
  bool has_mass, has_center_of_mass, has_inertia;
  double mass;  // > 0; INFINITY for a body that impulses do not change
  GrazeVec2d center_of_mass;
  double inertia;  // moment about the centre of mass
  double density;  // mass per area
  double gravity_factor;
  double linear_damping, angular_damping;
  bool kinematic;  // keeps its given velocity: pushes other bodies and is not pushed
  bool may_sleep;
} GrazePlaneDynamicsd;

GRAZE_C_API GrazePlaneDynamicsd graze_plane_dynamics_default_d(void);

typedef struct GrazePlaneMateriald {
  double static_friction, dynamic_friction;
  double restitution;       // 0 to 1
  double rolling_friction;  // a length
  uint8_t friction_combine, restitution_combine;  // a GrazeCombine
  GrazeVec2d surface_velocity;  // velocity of a conveyor's surface, in the body's frame
} GrazePlaneMateriald;

GRAZE_C_API GrazePlaneMateriald graze_plane_material_default_d(void);

typedef struct GrazePlaneJointd {
  GrazeBodyId a, b;              // a fixed body ties the other to the world
  GrazePose2d frame_a, frame_b;  // each in its body's frame
  const GrazeJointLimitd *limits;
  size_t limit_count;
  const GrazeJointDrived *drives;
  size_t drive_count;
  bool enable_collision;  // whether the two bodies may touch each other
} GrazePlaneJointd;

// A joint of a named kind without drives; a ball is a hinge. Its limits are constants of the library.
GRAZE_C_API GrazeStatus graze_plane_joint_of_kind_d(GrazeJointKind kind, GrazeBodyId a, const GrazePose2d *frame_a,
                                                    GrazeBodyId b, const GrazePose2d *frame_b, GrazePlaneJointd *joint);
// A slider with bounds, as in space.
GRAZE_C_API GrazeStatus graze_plane_joint_slider_d(GrazeBodyId a, const GrazePose2d *frame_a, GrazeBodyId b,
                                                   const GrazePose2d *frame_b, double min, double max,
                                                   GrazeBufferd *buffer, GrazePlaneJointd *joint);
// A joint that keeps the origins of the frames from `min` to `max` apart, as in space.
GRAZE_C_API GrazeStatus graze_plane_joint_distance_d(GrazeBodyId a, const GrazePose2d *frame_a, GrazeBodyId b,
                                                     const GrazePose2d *frame_b, double min, double max,
                                                     GrazeBufferd *buffer, GrazePlaneJointd *joint);

// Statistics of a step (graze/simulation.hpp); times by the clock in milliseconds.
typedef struct GrazePlaneStepReportd {
  size_t awake, islands, contacts, colors;
  int32_t most_sub_steps;
  size_t stopped;
  double deepest, mean_depth, residual;
  double kinetic_energy, potential_energy;
  GrazeVec2d momentum;
  double angular_momentum;
  double collide_ms, prepare_ms, solve_ms, continuous_ms, whole_ms;
} GrazePlaneStepReportd;

// A saved state of a simulation.
typedef struct GrazePlaneStated GrazePlaneStated;

// Creates a simulation. `settings` and `executor` may be null, as for a world.
GRAZE_C_API GrazeStatus graze_plane_simulation_create_d(const GrazePlaneSimulationSettingsd *settings,
                                                        const GrazeExecutor *executor,
                                                        GrazePlaneSimulationd **simulation);
GRAZE_C_API GrazeStatus graze_plane_simulation_create_captured_d(const GrazePlaneSimulationSettingsd *settings,
                                                                 const GrazeExecutor *executor, GrazeWriteFunction write,
                                                                 void *user, GrazePlaneSimulationd **simulation);
GRAZE_C_API void graze_plane_simulation_destroy_d(GrazePlaneSimulationd *simulation);

// Adds a body. `dynamics` and `material` may be null: the defaults. A trigger is pushed by nothing that it touches: it
// keeps its velocity, or moves by gravity, forces and joints where its dynamics have a mass.
GRAZE_C_API GrazeStatus graze_plane_simulation_add_d(GrazePlaneSimulationd *simulation, const GrazePlaneBodyd *body,
                                                     const GrazePlaneDynamicsd *dynamics,
                                                     const GrazePlaneMateriald *material, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_plane_simulation_remove_d(GrazePlaneSimulationd *simulation, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_plane_simulation_add_joint_d(GrazePlaneSimulationd *simulation,
                                                           const GrazePlaneJointd *joint, GrazeJointId *id);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_joint_d(GrazePlaneSimulationd *simulation, GrazeJointId id,
                                                           const GrazePlaneJointd *joint);
GRAZE_C_API GrazeStatus graze_plane_simulation_remove_joint_d(GrazePlaneSimulationd *simulation, GrazeJointId id);

// Advances the simulation by `dt` > 0.
GRAZE_C_API GrazeStatus graze_plane_simulation_step_d(GrazePlaneSimulationd *simulation, double dt);

GRAZE_C_API GrazeStatus graze_plane_simulation_apply_impulse_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                               GrazeVec2d impulse, GrazeVec2d point);
GRAZE_C_API GrazeStatus graze_plane_simulation_apply_angular_impulse_d(GrazePlaneSimulationd *simulation,
                                                                       GrazeBodyId id, double impulse);
// Applies a force on the centre of mass, or a torque, throughout the next step.
GRAZE_C_API GrazeStatus graze_plane_simulation_apply_force_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                             GrazeVec2d force);
GRAZE_C_API GrazeStatus graze_plane_simulation_apply_torque_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                              double torque);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_velocity_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                              const GrazePlaneVelocityd *velocity);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_pose_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                          const GrazePose2d *pose);
// Gives a kinematic body the velocity that takes it to `pose` in a step of `dt`.
GRAZE_C_API GrazeStatus graze_plane_simulation_move_to_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                         const GrazePose2d *pose, double dt);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_filter_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                            GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_material_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                              const GrazePlaneMateriald *material);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_materials_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                               const GrazePlaneMateriald *materials,
                                                               size_t material_count, const uint32_t *of_piece,
                                                               size_t piece_count);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_gravity_d(GrazePlaneSimulationd *simulation, GrazeVec2d gravity);
GRAZE_C_API GrazeStatus graze_plane_simulation_wake_d(GrazePlaneSimulationd *simulation, GrazeBodyId id);
// Names a body for a replay, as in a world.
GRAZE_C_API GrazeStatus graze_plane_simulation_set_name_d(GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                          const char *name);

GRAZE_C_API GrazeStatus graze_plane_simulation_pose_d(const GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                      GrazePose2d *pose);
// All poses by index, valid until the simulation changes; at an index without a body any pose.
GRAZE_C_API GrazeStatus graze_plane_simulation_poses_d(const GrazePlaneSimulationd *simulation,
                                                       const GrazePose2d **poses, size_t *count);
// The velocity of the centre of mass and the rotation about it, and the position of that centre in the world.
GRAZE_C_API GrazeStatus graze_plane_simulation_motion_d(const GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                        GrazePlaneVelocityd *velocity, GrazeVec2d *center_of_mass);
GRAZE_C_API GrazeStatus graze_plane_simulation_angular_momentum_d(const GrazePlaneSimulationd *simulation,
                                                                  GrazeBodyId id, double *momentum);
// The mass; infinite for fixed and kinematic bodies.
GRAZE_C_API GrazeStatus graze_plane_simulation_mass_d(const GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                      double *mass);
GRAZE_C_API GrazeStatus graze_plane_simulation_asleep_d(const GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                        bool *asleep);
GRAZE_C_API GrazeStatus graze_plane_simulation_sub_steps_d(const GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                           int32_t *sub_steps);
GRAZE_C_API GrazeStatus graze_plane_simulation_joints_d(const GrazePlaneSimulationd *simulation, GrazeBufferd *buffer,
                                                        const GrazeJointId **joints, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_simulation_joint_d(const GrazePlaneSimulationd *simulation, GrazeJointId id,
                                                       GrazeBufferd *buffer, GrazePlaneJointd *joint);
// The impulses of the last step, a number for each row of the joint, valid until the next step.
GRAZE_C_API GrazeStatus graze_plane_simulation_joint_impulses_d(const GrazePlaneSimulationd *simulation,
                                                                GrazeJointId id, const double **impulses,
                                                                size_t *count);
GRAZE_C_API GrazeStatus graze_plane_simulation_report_d(const GrazePlaneSimulationd *simulation,
                                                        GrazePlaneStepReportd *report);
// The settings as they are now.
GRAZE_C_API GrazeStatus graze_plane_simulation_settings_d(const GrazePlaneSimulationd *simulation,
                                                          GrazePlaneSimulationSettingsd *settings);
// The world of the simulation, which belongs to it: contacts, events and all queries.
GRAZE_C_API GrazeStatus graze_plane_simulation_world_d(const GrazePlaneSimulationd *simulation,
                                                       const GrazePlaneWorldd **world);
// The simulation whose world it is, as in space.
GRAZE_C_API GrazeStatus graze_plane_world_simulation_d(const GrazePlaneWorldd *world,
                                                       const GrazePlaneSimulationd **simulation);

GRAZE_C_API GrazeStatus graze_plane_simulation_state_hash_d(const GrazePlaneSimulationd *simulation, uint64_t *hash);
GRAZE_C_API GrazeStatus graze_plane_simulation_save_d(const GrazePlaneSimulationd *simulation,
                                                      GrazePlaneStated **state);
// Goes back to a state of this simulation, or on from one of another with the same bodies and joints, added and removed
// in the same order; an error where there are others now.
GRAZE_C_API GrazeStatus graze_plane_simulation_restore_d(GrazePlaneSimulationd *simulation,
                                                         const GrazePlaneStated *state);
// The bytes of a state and back, as in space.
GRAZE_C_API GrazeStatus graze_plane_state_bytes_d(const GrazePlaneStated *state, GrazeWriteFunction write, void *user);
GRAZE_C_API GrazeStatus graze_plane_state_read_d(const void *bytes, size_t size, GrazePlaneStated **state);
GRAZE_C_API void graze_plane_state_destroy_d(GrazePlaneStated *state);

// Debug draw (graze/draw.hpp) -----------------------------------------------------------------------------------------

// The faces of a shape, which belong to the buffer: curved ones sampled for the eye, a half-space as a square whose
// sides are twice `half_space_size`, about the foot of `center`; in the plane the outline.
GRAZE_C_API GrazeStatus graze_shape_tessellate_d(const GrazeShaped *shape, const GrazePosed *pose, GrazeVec3d center,
                                                 double half_space_size, GrazeBufferd *buffer,
                                                 GrazePolygons *polygons);
GRAZE_C_API GrazeStatus graze_plane_shape_tessellate_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                       GrazeVec2d center, double half_plane_size, GrazeBufferd *buffer,
                                                       GrazePolygons *polygons);
GRAZE_C_API GrazeStatus graze_shape_draw_d(const GrazeShaped *shape, const GrazePosed *pose, GrazeDrawMeaning meaning,
                                           const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_shape_draw_d(const GrazePlaneShaped *shape, const GrazePose2d *pose,
                                                 GrazeDrawMeaning meaning, const GrazeDebugDraw *on);
// Draws a box by its edges; the shortest segment between two shapes; points of contact with their normal, as one
// manifold; a ray or a moving shape, up to a hit; without one (null) as far as `length` or `duration` goes.
GRAZE_C_API GrazeStatus graze_aabb_draw_d(const GrazeAabbd *box, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_distance_draw_d(const GrazeDistanced *distance, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_distance_draw_d(const GrazePlaneDistanced *distance, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_contacts_draw_d(GrazeVec3d normal, const GrazeContactPointd *points, size_t count,
                                              const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_contacts_draw_d(GrazeVec2d normal, const GrazePlaneContactPointd *points,
                                                    size_t count, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_ray_draw_d(const GrazeRayd *ray, double length, const GrazeRayHitd *hit,
                                         const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_ray_draw_d(const GrazePlaneRayd *ray, double length, const GrazePlaneRayHitd *hit,
                                               const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_cast_draw_d(const GrazeMovingd *moving, double duration, const GrazeCastHitd *hit,
                                          const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_cast_draw_d(const GrazePlaneMovingd *moving, double duration,
                                                const GrazePlaneCastHitd *hit, const GrazeDebugDraw *on);
// Draws one span of a trace, counted from 0: the stretch of `ray` that meets this condition on the points of a convex
// shape, as far as the area of `on` where it has no end. `ray` is the one of the query, for a query of the plane with 0
// as the third number. The span that is the trace's winner is drawn with its name and its normal.
GRAZE_C_API GrazeStatus graze_trace_span_draw_d(const GrazeTrace *trace, size_t span, const GrazeRayd *ray,
                                                const GrazeDebugDraw *on);
// Draws one span of a view, which belongs to a trace or is the caller's own.
GRAZE_C_API GrazeStatus graze_trace_view_span_draw_d(const GrazeTraceView *view, size_t span, const GrazeRayd *ray,
                                                     const GrazeDebugDraw *on);
// Draws a joint of bodies at these poses, whichever bodies: from either origin to its anchor, and the gap between the
// anchors. Only the frames of the joint are read.
GRAZE_C_API GrazeStatus graze_joint_draw_d(const GrazeJointd *joint, const GrazePosed *pose_a, const GrazePosed *pose_b,
                                           const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_joint_draw_d(const GrazePlaneJointd *joint, const GrazePose2d *pose_a,
                                                 const GrazePose2d *pose_b, const GrazeDebugDraw *on);
// Draws the boxes of a tree, or of another structure, in the layer of trees.
GRAZE_C_API GrazeStatus graze_tree_draw_d(const GrazeAabbd *boxes, size_t count, const GrazeDebugDraw *on);
// Draws all bodies of a world, their bounds, the tree of these, and the contacts of its last update; for a simulation
// also its joints, with sleeping bodies marked. One of these alone is drawn where `on` has no other layer:
// 1 << GRAZE_DRAW_TREE for the tree.
GRAZE_C_API GrazeStatus graze_world_draw_d(const GrazeWorldd *world, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_simulation_draw_d(const GrazeSimulationd *simulation, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_simulation_draw_d(const GrazePlaneSimulationd *simulation,
                                                      const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_world_draw_d(const GrazePlaneWorldd *world, const GrazeDebugDraw *on);
// Draws one body as the drawing of the whole world or simulation does, with its bounds; a body that is not there is
// refused. The time grows with the pairs of the last update.
GRAZE_C_API GrazeStatus graze_world_draw_body_d(const GrazeWorldd *world, GrazeBodyId id, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_simulation_draw_body_d(const GrazeSimulationd *simulation, GrazeBodyId id,
                                                     const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_world_draw_body_d(const GrazePlaneWorldd *world, GrazeBodyId id,
                                                      const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_simulation_draw_body_d(const GrazePlaneSimulationd *simulation, GrazeBodyId id,
                                                           const GrazeDebugDraw *on);
// Writes the centre and the size of all bounded bodies to `on`.
GRAZE_C_API GrazeStatus graze_world_draw_area_d(const GrazeWorldd *world, GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_world_draw_area_d(const GrazePlaneWorldd *world, GrazeDebugDraw *on);

// Captures (graze/capture.hpp) ----------------------------------------------------------------------------------------

// Receiver of a replayed frame: the world, of space or of the plane, valid until the function returns; the other
// pointer is null. The world of a simulation leads to it by graze_world_simulation_d.
typedef void (*GrazeReplayFunctiond)(void *user, size_t frame, const GrazeWorldd *world,
                                     const GrazePlaneWorldd *plane_world);
// Plays a capture in this scalar again, to its end or to the first difference. `each` may be null. Any bytes may be
// given: GRAZE_INVALID_VALUE for bytes that are no capture or damaged, with the frame and where it begins. `executor`
// may be null: the calling thread. The bits are the same for any number of threads.
GRAZE_C_API GrazeStatus graze_replay_d(const void *bytes, size_t size, GrazeReplayFunctiond each, void *user,
                                       GrazeReplayReport *report, const GrazeExecutor *executor);

// </double>
// ---------------------------------------------------------------------------------------------------------------------
// Float: the same, written by bindings/c/write_float.sh from the part for double.
// ---------------------------------------------------------------------------------------------------------------------
// <float>

typedef struct GrazeVec3f {
  float x, y, z;
} GrazeVec3f;

typedef struct GrazeQuatf {
  float x, y, z, w;
} GrazeQuatf;

typedef struct GrazePosef {
  GrazeVec3f translation;
  GrazeQuatf rotation;
} GrazePosef;

typedef struct GrazeMat3f {
  GrazeVec3f row[3];
} GrazeMat3f;

typedef struct GrazeAabbf {
  GrazeVec3f lower, upper;
} GrazeAabbf;

GRAZE_C_API GrazePosef graze_pose_identity_f(void);
GRAZE_C_API GrazePosef graze_pose_at_place_f(float x, float y, float z);
GRAZE_C_API GrazePosef graze_pose_turned_f(GrazeVec3f translation, GrazeVec3f axis, float angle);

typedef struct GrazeShapef GrazeShapef;

GRAZE_C_API GrazeStatus graze_shape_sphere_f(float radius, GrazeVec3f center, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_capsule_f(float height, float radius_bottom, float radius_top,
                                              GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_box_f(GrazeVec3f size, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_rectangle_f(float size_x, float size_z, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_cylinder_f(float height, float radius_bottom, float radius_top,
                                               GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_ellipsoid_f(GrazeVec3f radii, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_segment_f(GrazeVec3f a, GrazeVec3f b, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_triangle_f(GrazeVec3f a, GrazeVec3f b, GrazeVec3f c, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_half_space_f(GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_convex_hull_f(const GrazeVec3f *points, size_t stride, size_t count,
                                                  GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_mesh_f(const GrazeVec3f *points, size_t point_stride, size_t point_count,
                                           const uint32_t *triangles, size_t triangle_stride, size_t triangle_count,
                                           GrazeSides sides, bool solid, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_height_field_f(const float *heights, size_t stride, size_t columns, size_t rows,
                                                   const uint8_t *holes, float spacing_x, float spacing_z,
                                                   GrazeSides sides, GrazeShapef **shape);

typedef struct GrazeChildf {
  const GrazeShapef *shape;
  GrazePosef pose;
} GrazeChildf;

GRAZE_C_API GrazeStatus graze_shape_compound_f(const GrazeChildf *children, size_t stride, size_t count,
                                               GrazeShapef **shape);

GRAZE_C_API GrazeStatus graze_shape_user_f(GrazeVec3f (*support)(const void *user, GrazeVec3f direction),
                                           void (*release)(void *user), void *user, GrazeShapef **shape);
GRAZE_C_API GrazeStatus graze_shape_rounded_f(const GrazeShapef *shape, float rounding, GrazeShapef **rounded);
GRAZE_C_API GrazeStatus graze_shape_swept_f(const GrazeShapef *shape, const GrazePosef *pose, GrazeVec3f motion,
                                            GrazeShapef **swept);

GRAZE_C_API void graze_shape_retain_f(const GrazeShapef *shape);
GRAZE_C_API void graze_shape_release_f(const GrazeShapef *shape);

GRAZE_C_API GrazeStatus graze_shape_kind_f(const GrazeShapef *shape, GrazeShapeKind *kind);
GRAZE_C_API GrazeStatus graze_shape_rounding_f(const GrazeShapef *shape, float *rounding);
GRAZE_C_API GrazeStatus graze_shape_bounds_f(const GrazeShapef *shape, const GrazePosef *pose, GrazeAabbf *bounds);
GRAZE_C_API GrazeStatus graze_shape_support_f(const GrazeShapef *shape, GrazeVec3f direction, GrazeVec3f *point);

typedef struct GrazeShapeMeasuresf {
  GrazeVec3f size;
  GrazeVec3f radii;
  GrazeVec3f center;
  float height;
  float radius, radius_top;
  float spacing_x, spacing_z;
  float tolerance;
  size_t columns, rows;
  size_t children;
  bool convex;
  bool closed;
  bool solid;
  GrazeSides sides;
} GrazeShapeMeasuresf;

GRAZE_C_API GrazeStatus graze_shape_measures_f(const GrazeShapef *shape, GrazeShapeMeasuresf *measures);
GRAZE_C_API GrazeStatus graze_shape_points_f(const GrazeShapef *shape, const GrazeVec3f **points, size_t *count);
GRAZE_C_API GrazeStatus graze_shape_triangles_f(const GrazeShapef *mesh, const uint32_t **triangles, size_t *count);
GRAZE_C_API GrazeStatus graze_shape_heights_f(const GrazeShapef *field, const float **heights, size_t *count);
GRAZE_C_API GrazeStatus graze_shape_child_f(const GrazeShapef *compound, size_t index, GrazeChildf *child);

typedef struct GrazeMassPropertiesf {
  float volume;
  GrazeVec3f center;
  GrazeMat3f inertia;
} GrazeMassPropertiesf;

GRAZE_C_API GrazeStatus graze_shape_mass_properties_f(const GrazeShapef *shape, GrazeMassPropertiesf *properties);
GRAZE_C_API GrazeStatus graze_shape_findings_f(const GrazeShapef *mesh, GrazeMeshFindings *findings);

typedef struct GrazeBufferf GrazeBufferf;

GRAZE_C_API GrazeStatus graze_buffer_create_f(GrazeBufferf **buffer);
GRAZE_C_API void graze_buffer_destroy_f(GrazeBufferf *buffer);

GRAZE_C_API GrazeStatus graze_hull_vertices_f(const GrazeShapef *shape, const GrazeVec3f **vertices, size_t *count);
GRAZE_C_API GrazeStatus graze_hull_layers_f(const GrazeShapef *shape, GrazeBufferf *buffer,
                                            const GrazeHullLayer **layers, size_t *count);
GRAZE_C_API GrazeStatus graze_hull_support_f(const GrazeShapef *shape, GrazeVec3f direction, GrazeBufferf *buffer,
                                             GrazeSupportTrace *trace);

typedef struct GrazeDistancef {
  float distance;
  GrazeVec3f normal;
  GrazeVec3f a, b;
  uint8_t certainty;
  float error;
} GrazeDistancef;

typedef struct GrazeClosestf {
  float distance;
  GrazeVec3f point;
  GrazeVec3f normal;
  uint8_t certainty;
  float error;
} GrazeClosestf;

typedef struct GrazePieceDistancef {
  uint32_t piece_a, piece_b;
  GrazeDistancef distance;
} GrazePieceDistancef;

typedef struct GrazeContactPointf {
  GrazeVec3f a, b;
  float distance;
  uint32_t feature;
  float weight;
} GrazeContactPointf;

typedef struct GrazeManifoldf {
  GrazeVec3f normal;
  uint32_t piece_a, piece_b;
  uint32_t first_point, point_count;
} GrazeManifoldf;

typedef struct GrazeContactsf {
  bool overlap;
  uint8_t certainty;
  float error;
  const GrazeManifoldf *manifolds;
  size_t manifold_count;
  const GrazeContactPointf *points;
  size_t point_count;
} GrazeContactsf;

typedef struct GrazeBatchContactsf {
  const GrazePairContacts *pairs;
  size_t pair_count;
  const GrazeManifoldf *manifolds;
  size_t manifold_count;
  const GrazeContactPointf *points;
  size_t point_count;
} GrazeBatchContactsf;

typedef struct GrazeCompactManifoldf {
  GrazeVec3f normal;
  uint32_t pair;
  uint32_t first_point, point_count;
} GrazeCompactManifoldf;

typedef struct GrazeCompactPointf {
  GrazeVec3f position;
  float distance;
} GrazeCompactPointf;

typedef struct GrazeCompactContactsf {
  const GrazeCompactManifoldf *manifolds;
  size_t manifold_count;
  const GrazeCompactPointf *points;
  size_t point_count;
} GrazeCompactContactsf;

typedef struct GrazeRayf {
  GrazeVec3f origin, direction;
} GrazeRayf;

typedef struct GrazeRayHitf {
  float t;
  GrazeVec3f point;
  GrazeVec3f normal;
  uint32_t piece;
} GrazeRayHitf;

typedef struct GrazeVelocityf {
  GrazeVec3f linear;
  GrazeVec3f angular;
} GrazeVelocityf;

typedef struct GrazeCastHitf {
  float t;
  GrazeVec3f point;
  GrazeVec3f normal;
  float depth;
  uint8_t certainty;
  uint32_t piece_a, piece_b;
} GrazeCastHitf;

GRAZE_C_API GrazeStatus graze_overlap_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                        const GrazePosef *pose_b, bool *overlap);
GRAZE_C_API GrazeStatus graze_may_overlap_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                            const GrazePosef *pose_b, bool *may_overlap);
GRAZE_C_API GrazeStatus graze_distance_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                         const GrazePosef *pose_b, GrazeDistancef *distance);
GRAZE_C_API GrazeStatus graze_distance_up_to_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                               const GrazePosef *pose_b, float limit, bool *found,
                                               GrazeDistancef *distance);
GRAZE_C_API GrazeStatus graze_within_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                       const GrazePosef *pose_b, float limit, bool *within);
GRAZE_C_API GrazeStatus graze_near_pieces_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                            const GrazePosef *pose_b, float margin, GrazeBufferf *buffer,
                                            const GrazePieceDistancef **pieces, size_t *count);
GRAZE_C_API GrazeStatus graze_contacts_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                         const GrazePosef *pose_b, float margin, GrazeBufferf *buffer,
                                         GrazeContactsf *contacts);
GRAZE_C_API GrazeStatus graze_contacts_reduced_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                                 const GrazePosef *pose_b, float margin, size_t most,
                                                 GrazeBufferf *buffer, GrazeContactsf *contacts);
GRAZE_C_API GrazeStatus graze_contact_margin_f(const GrazeShapef *a, const GrazeShapef *b, float *margin);
GRAZE_C_API GrazeStatus graze_feature_corners_f(const GrazeShapef *shape, uint32_t piece, uint16_t feature,
                                                GrazeBufferf *buffer, const GrazeVec3f **corners, size_t *count);
GRAZE_C_API GrazeStatus graze_closest_f(const GrazeShapef *shape, const GrazePosef *pose, GrazeVec3f point,
                                        GrazeClosestf *closest);

GRAZE_C_API GrazeStatus graze_raycast_f(const GrazeShapef *shape, const GrazePosef *pose, const GrazeRayf *ray,
                                        float length, GrazeBackFaces back, bool *found, GrazeRayHitf *hit);
GRAZE_C_API GrazeStatus graze_raycast_any_f(const GrazeShapef *shape, const GrazePosef *pose, const GrazeRayf *ray,
                                            float length, GrazeBackFaces back, bool *found);
GRAZE_C_API GrazeStatus graze_raycast_all_f(const GrazeShapef *shape, const GrazePosef *pose, const GrazeRayf *ray,
                                            float length, GrazeBackFaces back, GrazeBufferf *buffer,
                                            const GrazeRayHitf **hits, size_t *count);

typedef struct GrazeMovingf {
  const GrazeShapef *shape;
  GrazePosef pose;
  GrazeVelocityf velocity;
} GrazeMovingf;

GRAZE_C_API GrazeStatus graze_cast_f(const GrazeMovingf *a, const GrazeMovingf *b, float duration,
                                     GrazeSeparating separating, bool *found, GrazeCastHitf *hit);
GRAZE_C_API GrazeStatus graze_cast_all_f(const GrazeMovingf *a, const GrazeMovingf *b, float duration,
                                         GrazeSeparating separating, GrazeBufferf *buffer, const GrazeCastHitf **hits,
                                         size_t *count);
GRAZE_C_API GrazeStatus graze_overlap_explained_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                                  const GrazePosef *pose_b, bool *overlap, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_distance_explained_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                                   const GrazePosef *pose_b, GrazeDistancef *distance,
                                                   GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_contacts_explained_f(const GrazeShapef *a, const GrazePosef *pose_a, const GrazeShapef *b,
                                                   const GrazePosef *pose_b, float margin, GrazeBufferf *buffer,
                                                   GrazeContactsf *contacts, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_closest_explained_f(const GrazeShapef *shape, const GrazePosef *pose, GrazeVec3f point,
                                                  GrazeClosestf *closest, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_raycast_explained_f(const GrazeShapef *shape, const GrazePosef *pose, const GrazeRayf *ray,
                                                  float length, GrazeBackFaces back, bool *found, GrazeRayHitf *hit,
                                                  GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_cast_explained_f(const GrazeMovingf *a, const GrazeMovingf *b, float duration,
                                               GrazeSeparating separating, bool *found, GrazeCastHitf *hit,
                                               GrazeTrace *trace);

GRAZE_C_API GrazeStatus graze_pose_at_f(const GrazePosef *pose, const GrazeVelocityf *velocity, float t,
                                        GrazePosef *result);

typedef struct GrazeMotionf {
  GrazeVec3f linear, angular;
  GrazeVec3f center;
} GrazeMotionf;

typedef struct GrazeInverseMassf {
  float mass;
  GrazeMat3f inertia;
} GrazeInverseMassf;

typedef struct GrazeStruckBodyf {
  GrazeMotionf motion;
  GrazeInverseMassf mass;
} GrazeStruckBodyf;

typedef struct GrazeStruckContactf {
  GrazeVec3f point;
  GrazeVec3f normal;
  float restitution, friction;
} GrazeStruckContactf;

typedef struct GrazeResponsef {
  GrazeVec3f approach;
  float approach_along_normal;
  GrazeVec3f approach_tangential;
  GrazeAtFault at_fault;
  float effective_mass;
  float normal_impulse;
  GrazeVec3f sliding;
  GrazeVec3f stopping_impulse;
  float friction_limit;
  GrazeVec3f friction_impulse;
  GrazeVec3f impulse;
  GrazeMotionf a, b;
} GrazeResponsef;

GRAZE_C_API GrazeStatus graze_inverse_mass_f(float mass, GrazeVec3f inertia, GrazeQuatf rotation,
                                             GrazeInverseMassf *inverse);
GRAZE_C_API GrazeStatus graze_inverse_mass_of_tensor_f(float mass, const GrazeMat3f *inertia, GrazeQuatf rotation,
                                                       GrazeInverseMassf *inverse);
GRAZE_C_API GrazeStatus graze_inverse_mass_of_shape_f(const GrazeShapef *shape, float mass, GrazeQuatf rotation,
                                                      GrazeInverseMassf *inverse);
GRAZE_C_API GrazeStatus graze_response_f(const GrazeStruckContactf *contact, const GrazeStruckBodyf *a,
                                         const GrazeStruckBodyf *b, GrazeResponsef *response);
GRAZE_C_API GrazeStatus graze_apply_impulse_f(const GrazeStruckBodyf *body, GrazeVec3f impulse, GrazeVec3f point,
                                              GrazeMotionf *motion);

typedef struct GrazeBlowf {
  uint32_t a, b;
  GrazeVec3f normal;
  float restitution;
  uint32_t first_point, point_count;
} GrazeBlowf;

typedef struct GrazeTouchingf {
  GrazeStruckBodyf *bodies;
  size_t body_stride, body_count;
  const GrazeBlowf *blows;
  size_t blow_stride, blow_count;
  const GrazeVec3f *points;
  size_t point_stride, point_count;
  float *impulses;
  size_t impulse_stride;
} GrazeTouchingf;

typedef struct GrazePassedOnf {
  size_t struck;
  float approach;
} GrazePassedOnf;

GRAZE_C_API GrazeStatus graze_pass_on_f(const GrazeTouchingf *touching, float resting_speed, size_t most,
                                        GrazePassedOnf *passed);

typedef struct GrazeFreeBodyf {
  GrazeVec3f center;
  GrazeQuatf rotation;
  GrazeVec3f linear;
  GrazeVec3f angular_momentum;
  GrazeVec3f inverse_inertia;
} GrazeFreeBodyf;

GRAZE_C_API GrazeStatus graze_free_angular_velocity_f(const GrazeFreeBodyf *body, GrazeVec3f *angular);
GRAZE_C_API GrazeStatus graze_free_set_angular_velocity_f(GrazeFreeBodyf *body, GrazeVec3f angular);
GRAZE_C_API GrazeStatus graze_free_advance_f(GrazeFreeBodyf *body, GrazeVec3f acceleration, float duration);

typedef struct GrazeBodiesf {
  const GrazeShapef *const *shapes;
  size_t shape_stride, shape_count;
  const GrazeVec3f *translations;
  size_t translation_stride;
  const GrazeQuatf *rotations;
  size_t rotation_stride;
  size_t pose_count;
} GrazeBodiesf;

GRAZE_C_API GrazeBodiesf graze_bodies_f(const GrazeShapef *const *shapes, size_t shape_count, const GrazePosef *poses,
                                        size_t pose_count);

typedef struct GrazeBatchf {
  GrazeBodiesf a, b;
  const GrazeIdPair *places;
  size_t place_stride, place_count;
} GrazeBatchf;

GRAZE_C_API GrazeStatus graze_batch_size_f(const GrazeBatchf *batch, size_t *size);

GRAZE_C_API GrazeStatus graze_overlap_batch_f(const GrazeBatchf *batch, uint8_t *touch, size_t stride,
                                              const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_distance_batch_f(const GrazeBatchf *batch, GrazeDistancef *distances, size_t stride,
                                               const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_contacts_batch_f(const GrazeBatchf *batch, float margin, GrazeBufferf *buffer,
                                               GrazeBatchContactsf *contacts, const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_contacts_batch_reduced_f(const GrazeBatchf *batch, float margin, size_t most,
                                                       GrazeBufferf *buffer, GrazeBatchContactsf *contacts,
                                                       const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_compact_contacts_batch_f(const GrazeBatchf *batch, float margin, GrazeBufferf *buffer,
                                                       GrazeCompactContactsf *contacts, const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_near_pieces_batch_f(const GrazeBatchf *batch, float margin, GrazeBufferf *buffer,
                                                  const GrazePieceDistancef **pieces, const size_t **ends,
                                                  size_t *count);
GRAZE_C_API GrazeStatus graze_closest_batch_f(const GrazeShapef *shape, const GrazePosef *pose,
                                              const GrazeVec3f *points, size_t point_stride, size_t count,
                                              GrazeClosestf *closest, size_t closest_stride);
GRAZE_C_API GrazeStatus graze_raycast_batch_f(const GrazeShapef *shape, const GrazePosef *pose, const GrazeRayf *rays,
                                              size_t ray_stride, size_t count, float length, GrazeBackFaces back,
                                              uint8_t *found, size_t found_stride, GrazeRayHitf *hits,
                                              size_t hit_stride);
GRAZE_C_API GrazeStatus graze_cast_batch_f(const GrazeMovingf *a, size_t a_stride, const GrazeMovingf *b,
                                           size_t b_stride, size_t count, float duration, GrazeSeparating separating,
                                           uint8_t *found, size_t found_stride, GrazeCastHitf *hits, size_t hit_stride);

typedef struct GrazeBroadPhasef GrazeBroadPhasef;

typedef struct GrazeBroadPhasePartf {
  GrazeAabbf box;
  uint32_t depth;
} GrazeBroadPhasePartf;

GRAZE_C_API GrazeStatus graze_broad_phase_create_f(GrazeBroadPhaseKind kind, GrazeBroadPhasef **broad);
GRAZE_C_API void graze_broad_phase_destroy_f(GrazeBroadPhasef *broad);

GRAZE_C_API GrazeStatus graze_broad_phase_insert_f(GrazeBroadPhasef *broad, uint32_t id, const GrazeAabbf *box);
GRAZE_C_API GrazeStatus graze_broad_phase_move_f(GrazeBroadPhasef *broad, uint32_t id, const GrazeAabbf *box);
GRAZE_C_API GrazeStatus graze_broad_phase_remove_f(GrazeBroadPhasef *broad, uint32_t id);

GRAZE_C_API GrazeStatus graze_broad_phase_pairs_f(GrazeBroadPhasef *broad, GrazeBufferf *buffer,
                                                  const GrazeIdPair **pairs, size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_moved_pairs_f(GrazeBroadPhasef *broad, GrazeBufferf *buffer,
                                                        const GrazeIdPair **pairs, size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_query_f(const GrazeBroadPhasef *broad, const GrazeAabbf *box,
                                                  GrazeBufferf *buffer, const uint32_t **ids, size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_sweep_f(const GrazeBroadPhasef *broad, const GrazeAabbf *box,
                                                  GrazeVec3f motion, GrazeBufferf *buffer, const uint32_t **ids,
                                                  size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_parts_f(const GrazeBroadPhasef *broad, GrazeBufferf *buffer,
                                                  const GrazeBroadPhasePartf **parts, size_t *count);
GRAZE_C_API GrazeStatus graze_broad_phase_counts_f(const GrazeBroadPhasef *broad, uint64_t *tests, size_t *bytes);

typedef struct GrazePairChangesf GrazePairChangesf;

GRAZE_C_API GrazeStatus graze_pair_changes_create_f(GrazeBroadPhaseKind kind, GrazePairChangesf **changes);
GRAZE_C_API void graze_pair_changes_destroy_f(GrazePairChangesf *changes);
GRAZE_C_API GrazeStatus graze_pair_changes_insert_f(GrazePairChangesf *changes, uint32_t id, const GrazeAabbf *box);
GRAZE_C_API GrazeStatus graze_pair_changes_move_f(GrazePairChangesf *changes, uint32_t id, const GrazeAabbf *box);
GRAZE_C_API GrazeStatus graze_pair_changes_remove_f(GrazePairChangesf *changes, uint32_t id);
GRAZE_C_API GrazeStatus graze_pair_changes_find_f(GrazePairChangesf *changes, GrazeBufferf *buffer,
                                                  const GrazeIdPair **begun, size_t *begun_count,
                                                  const GrazeIdPair **ended, size_t *ended_count);

typedef struct GrazeWorldf GrazeWorldf;

typedef struct GrazeWorldSettingsf {
  bool has_margin;
  float margin;
  bool (*allow)(void *user, GrazeBodyId a, GrazeBodyId b);
  void *user;
  size_t points_per_pair;
} GrazeWorldSettingsf;

GRAZE_C_API GrazeWorldSettingsf graze_world_settings_default_f(void);

typedef struct GrazeBodyf {
  const GrazeShapef *shape;
  GrazePosef pose;
  GrazeVec3f linear, angular;
  GrazeFilter filter;
  bool fixed;
  bool trigger;
  bool fast;
} GrazeBodyf;

GRAZE_C_API GrazeBodyf graze_body_default_f(const GrazeShapef *shape);

GRAZE_C_API GrazeStatus graze_world_create_f(const GrazeWorldSettingsf *settings, const GrazeExecutor *executor,
                                             GrazeWorldf **world);
GRAZE_C_API GrazeStatus graze_world_create_captured_f(const GrazeWorldSettingsf *settings,
                                                      const GrazeExecutor *executor, GrazeWriteFunction write,
                                                      void *user, GrazeWorldf **world);
GRAZE_C_API void graze_world_destroy_f(GrazeWorldf *world);

GRAZE_C_API GrazeStatus graze_world_add_f(GrazeWorldf *world, const GrazeBodyf *body, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_world_remove_f(GrazeWorldf *world, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_world_move_f(GrazeWorldf *world, GrazeBodyId id, const GrazePosef *pose,
                                           const GrazeVelocityf *velocity);
GRAZE_C_API GrazeStatus graze_world_move_batch_f(GrazeWorldf *world, const GrazeBodyId *ids, size_t id_stride,
                                                 const GrazePosef *poses, size_t pose_stride,
                                                 const GrazeVelocityf *velocities, size_t velocity_stride,
                                                 size_t count);
GRAZE_C_API GrazeStatus graze_world_set_shape_f(GrazeWorldf *world, GrazeBodyId id, const GrazeShapef *shape);
GRAZE_C_API GrazeStatus graze_world_set_filter_f(GrazeWorldf *world, GrazeBodyId id, GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_world_set_fast_f(GrazeWorldf *world, GrazeBodyId id, bool fast);
GRAZE_C_API GrazeStatus graze_world_set_name_f(GrazeWorldf *world, GrazeBodyId id, const char *name);
GRAZE_C_API GrazeStatus graze_world_name_f(const GrazeWorldf *world, GrazeBodyId id, const char **name);
GRAZE_C_API GrazeStatus graze_world_set_allow_f(GrazeWorldf *world,
                                                bool (*allow)(void *user, GrazeBodyId a, GrazeBodyId b), void *user);

GRAZE_C_API GrazeStatus graze_world_counts_f(const GrazeWorldf *world, size_t *bodies, size_t *indices);
GRAZE_C_API GrazeStatus graze_world_contains_f(const GrazeWorldf *world, GrazeBodyId id, bool *contains);
GRAZE_C_API GrazeStatus graze_world_body_at_f(const GrazeWorldf *world, uint32_t index, bool *found, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_world_body_f(const GrazeWorldf *world, GrazeBodyId id, GrazeBodyf *body);
GRAZE_C_API GrazeStatus graze_world_poses_f(const GrazeWorldf *world, const GrazePosef **poses, size_t *count);

GRAZE_C_API GrazeStatus graze_world_update_f(GrazeWorldf *world, float duration);
GRAZE_C_API GrazeStatus graze_world_find_impacts_f(GrazeWorldf *world, float duration);

typedef struct GrazeSolverPointf {
  GrazeVec3f a, b;
  float distance;
  uint32_t feature;
  float weight;
  GrazeVec3f impulse;
} GrazeSolverPointf;

typedef struct GrazeWorldContactsf {
  const GrazeWorldPair *pairs;
  size_t pair_count;
  const GrazeManifoldf *manifolds;
  size_t manifold_count;
  const GrazeSolverPointf *points;
  size_t point_count;
} GrazeWorldContactsf;

GRAZE_C_API GrazeStatus graze_world_contacts_f(const GrazeWorldf *world, GrazeWorldContactsf *contacts);
GRAZE_C_API GrazeStatus graze_world_solver_points_f(GrazeWorldf *world, GrazeSolverPointf **points, size_t *count);
GRAZE_C_API GrazeStatus graze_world_reduce_f(GrazeWorldf *world, size_t most);
GRAZE_C_API GrazeStatus graze_world_events_f(const GrazeWorldf *world, const GrazeContactEvent **events, size_t *count);

typedef struct GrazeImpactf {
  GrazeBodyId a, b;
  bool trigger;
  GrazeCastHitf hit;
} GrazeImpactf;

GRAZE_C_API GrazeStatus graze_world_impacts_f(const GrazeWorldf *world, const GrazeImpactf **impacts, size_t *count);

typedef struct GrazeBodyDistancef {
  GrazeBodyId body;
  GrazeDistancef distance;
} GrazeBodyDistancef;

typedef struct GrazeBodyRayHitf {
  GrazeBodyId body;
  GrazeRayHitf hit;
} GrazeBodyRayHitf;

typedef struct GrazeBodyCastHitf {
  GrazeBodyId body;
  GrazeCastHitf hit;
} GrazeBodyCastHitf;

GRAZE_C_API GrazeStatus graze_world_overlapping_f(const GrazeWorldf *world, const GrazeShapef *shape,
                                                  const GrazePosef *pose, const GrazeQueryFilter *filter,
                                                  GrazeBufferf *buffer, const GrazeBodyId **bodies, size_t *count);
GRAZE_C_API GrazeStatus graze_world_overlaps_any_f(const GrazeWorldf *world, const GrazeShapef *shape,
                                                   const GrazePosef *pose, const GrazeQueryFilter *filter, bool *any);
GRAZE_C_API GrazeStatus graze_world_nearest_f(const GrazeWorldf *world, const GrazeShapef *shape,
                                              const GrazePosef *pose, size_t most, float limit,
                                              const GrazeQueryFilter *filter, GrazeBufferf *buffer,
                                              const GrazeBodyDistancef **bodies, size_t *count);
GRAZE_C_API GrazeStatus graze_world_raycast_f(const GrazeWorldf *world, const GrazeRayf *ray, float length,
                                              const GrazeQueryFilter *filter, GrazeBackFaces back, bool *found,
                                              GrazeBodyRayHitf *hit);
GRAZE_C_API GrazeStatus graze_world_raycast_any_f(const GrazeWorldf *world, const GrazeRayf *ray, float length,
                                                  const GrazeQueryFilter *filter, GrazeBackFaces back, bool *found);
GRAZE_C_API GrazeStatus graze_world_raycast_all_f(const GrazeWorldf *world, const GrazeRayf *ray, float length,
                                                  const GrazeQueryFilter *filter, GrazeBackFaces back,
                                                  GrazeBufferf *buffer, const GrazeBodyRayHitf **hits, size_t *count);
GRAZE_C_API GrazeStatus graze_world_cast_f(const GrazeWorldf *world, const GrazeMovingf *moving, float duration,
                                           const GrazeQueryFilter *filter, GrazeSeparating separating, bool *found,
                                           GrazeBodyCastHitf *hit);
GRAZE_C_API GrazeStatus graze_world_cast_all_f(const GrazeWorldf *world, const GrazeMovingf *moving, float duration,
                                               const GrazeQueryFilter *filter, GrazeSeparating separating,
                                               GrazeBufferf *buffer, const GrazeBodyCastHitf **hits, size_t *count);
GRAZE_C_API GrazeStatus graze_world_slide_f(const GrazeWorldf *world, const GrazeShapef *shape, const GrazePosef *pose,
                                            GrazeVec3f motion, int casts, const GrazeQueryFilter *filter,
                                            GrazeBufferf *buffer, GrazePosef *end, GrazeVec3f *left,
                                            const GrazeBodyCastHitf **touched, size_t *count);
GRAZE_C_API GrazeStatus graze_along_planes_f(GrazeVec3f motion, const GrazeVec3f *normals, size_t stride, size_t count,
                                             GrazeVec3f *left);
GRAZE_C_API GrazeStatus graze_world_memory_f(const GrazeWorldf *world, size_t *bytes);

typedef struct GrazeSimulationf GrazeSimulationf;

typedef struct GrazeSimulationSettingsf {
  GrazeVec3f gravity;
  int32_t sub_steps;
  int32_t most_sub_steps;
  bool sleep;
  bool continuous;
  bool warm_start;
  float longest_step;
} GrazeSimulationSettingsf;

GRAZE_C_API GrazeSimulationSettingsf graze_simulation_settings_default_f(void);

typedef struct GrazeDynamicsf {
  bool has_mass, has_center_of_mass, has_inertia;
  float mass;
  GrazeVec3f center_of_mass;
  GrazeVec3f inertia_diagonal;
  GrazeQuatf inertia_orientation;
  float density;
  float gravity_factor;
  float linear_damping, angular_damping;
  bool kinematic;
  bool may_sleep;
} GrazeDynamicsf;

GRAZE_C_API GrazeDynamicsf graze_dynamics_default_f(void);

typedef struct GrazeMaterialf {
  float static_friction, dynamic_friction;
  float restitution;
  float rolling_friction;
  uint8_t friction_combine, restitution_combine;
  GrazeVec3f surface_velocity;
} GrazeMaterialf;

GRAZE_C_API GrazeMaterialf graze_material_default_f(void);

typedef struct GrazeJointLimitf {
  uint8_t space;
  bool axes[3];
  float min, max;
  float stiffness;
  float damping;
} GrazeJointLimitf;

typedef struct GrazeJointDrivef {
  uint8_t space;
  uint8_t mode;
  uint8_t axis;
  float position_target, velocity_target;
  float stiffness, damping;
  float max_force;
} GrazeJointDrivef;

typedef struct GrazeJointf {
  GrazeBodyId a, b;
  GrazePosef frame_a, frame_b;
  const GrazeJointLimitf *limits;
  size_t limit_count;
  const GrazeJointDrivef *drives;
  size_t drive_count;
  bool enable_collision;
} GrazeJointf;

GRAZE_C_API GrazeStatus graze_joint_of_kind_f(GrazeJointKind kind, GrazeBodyId a, const GrazePosef *frame_a,
                                              GrazeBodyId b, const GrazePosef *frame_b, GrazeJointf *joint);
GRAZE_C_API GrazeStatus graze_joint_slider_f(GrazeBodyId a, const GrazePosef *frame_a, GrazeBodyId b,
                                             const GrazePosef *frame_b, float min, float max, GrazeBufferf *buffer,
                                             GrazeJointf *joint);
GRAZE_C_API GrazeStatus graze_joint_distance_f(GrazeBodyId a, const GrazePosef *frame_a, GrazeBodyId b,
                                               const GrazePosef *frame_b, float min, float max, GrazeBufferf *buffer,
                                               GrazeJointf *joint);

typedef struct GrazeStepReportf {
  size_t awake, islands, contacts, colors;
  int32_t most_sub_steps;
  size_t stopped;
  float deepest, mean_depth, residual;
  float kinetic_energy, potential_energy;
  GrazeVec3f momentum, angular_momentum;
  float collide_ms, prepare_ms, solve_ms, continuous_ms, whole_ms;
} GrazeStepReportf;

typedef struct GrazeStatef GrazeStatef;

GRAZE_C_API GrazeStatus graze_simulation_create_f(const GrazeSimulationSettingsf *settings,
                                                  const GrazeExecutor *executor, GrazeSimulationf **simulation);
GRAZE_C_API GrazeStatus graze_simulation_create_captured_f(const GrazeSimulationSettingsf *settings,
                                                           const GrazeExecutor *executor, GrazeWriteFunction write,
                                                           void *user, GrazeSimulationf **simulation);
GRAZE_C_API void graze_simulation_destroy_f(GrazeSimulationf *simulation);

GRAZE_C_API GrazeStatus graze_simulation_add_f(GrazeSimulationf *simulation, const GrazeBodyf *body,
                                               const GrazeDynamicsf *dynamics, const GrazeMaterialf *material,
                                               GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_simulation_remove_f(GrazeSimulationf *simulation, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_simulation_add_joint_f(GrazeSimulationf *simulation, const GrazeJointf *joint,
                                                     GrazeJointId *id);
GRAZE_C_API GrazeStatus graze_simulation_set_joint_f(GrazeSimulationf *simulation, GrazeJointId id,
                                                     const GrazeJointf *joint);
GRAZE_C_API GrazeStatus graze_simulation_remove_joint_f(GrazeSimulationf *simulation, GrazeJointId id);

GRAZE_C_API GrazeStatus graze_simulation_step_f(GrazeSimulationf *simulation, float dt);

GRAZE_C_API GrazeStatus graze_simulation_apply_impulse_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                         GrazeVec3f impulse, GrazeVec3f point);
GRAZE_C_API GrazeStatus graze_simulation_apply_angular_impulse_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                                 GrazeVec3f impulse);
GRAZE_C_API GrazeStatus graze_simulation_apply_force_f(GrazeSimulationf *simulation, GrazeBodyId id, GrazeVec3f force);
GRAZE_C_API GrazeStatus graze_simulation_apply_torque_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                        GrazeVec3f torque);
GRAZE_C_API GrazeStatus graze_simulation_set_velocity_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                        const GrazeVelocityf *velocity);
GRAZE_C_API GrazeStatus graze_simulation_set_pose_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                    const GrazePosef *pose);
GRAZE_C_API GrazeStatus graze_simulation_move_to_f(GrazeSimulationf *simulation, GrazeBodyId id, const GrazePosef *pose,
                                                   float dt);
GRAZE_C_API GrazeStatus graze_simulation_set_filter_f(GrazeSimulationf *simulation, GrazeBodyId id, GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_simulation_set_material_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                        const GrazeMaterialf *material);
GRAZE_C_API GrazeStatus graze_simulation_set_materials_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                         const GrazeMaterialf *materials, size_t material_count,
                                                         const uint32_t *of_piece, size_t piece_count);
GRAZE_C_API GrazeStatus graze_simulation_set_gravity_f(GrazeSimulationf *simulation, GrazeVec3f gravity);
GRAZE_C_API GrazeStatus graze_simulation_wake_f(GrazeSimulationf *simulation, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_simulation_set_name_f(GrazeSimulationf *simulation, GrazeBodyId id,
                                                    const char *name);

GRAZE_C_API GrazeStatus graze_simulation_pose_f(const GrazeSimulationf *simulation, GrazeBodyId id, GrazePosef *pose);
GRAZE_C_API GrazeStatus graze_simulation_poses_f(const GrazeSimulationf *simulation, const GrazePosef **poses,
                                                 size_t *count);
GRAZE_C_API GrazeStatus graze_simulation_motion_f(const GrazeSimulationf *simulation, GrazeBodyId id,
                                                  GrazeVelocityf *velocity, GrazeVec3f *center_of_mass);
GRAZE_C_API GrazeStatus graze_simulation_angular_momentum_f(const GrazeSimulationf *simulation, GrazeBodyId id,
                                                            GrazeVec3f *momentum);
GRAZE_C_API GrazeStatus graze_simulation_mass_f(const GrazeSimulationf *simulation, GrazeBodyId id, float *mass);
GRAZE_C_API GrazeStatus graze_simulation_asleep_f(const GrazeSimulationf *simulation, GrazeBodyId id, bool *asleep);
GRAZE_C_API GrazeStatus graze_simulation_sub_steps_f(const GrazeSimulationf *simulation, GrazeBodyId id,
                                                     int32_t *sub_steps);
GRAZE_C_API GrazeStatus graze_simulation_joints_f(const GrazeSimulationf *simulation, GrazeBufferf *buffer,
                                                  const GrazeJointId **joints, size_t *count);
GRAZE_C_API GrazeStatus graze_simulation_joint_f(const GrazeSimulationf *simulation, GrazeJointId id,
                                                 GrazeBufferf *buffer, GrazeJointf *joint);
GRAZE_C_API GrazeStatus graze_simulation_joint_impulses_f(const GrazeSimulationf *simulation, GrazeJointId id,
                                                          const float **impulses, size_t *count);
GRAZE_C_API GrazeStatus graze_simulation_report_f(const GrazeSimulationf *simulation, GrazeStepReportf *report);
GRAZE_C_API GrazeStatus graze_simulation_settings_f(const GrazeSimulationf *simulation,
                                                    GrazeSimulationSettingsf *settings);
GRAZE_C_API GrazeStatus graze_simulation_world_f(const GrazeSimulationf *simulation, const GrazeWorldf **world);
GRAZE_C_API GrazeStatus graze_world_simulation_f(const GrazeWorldf *world, const GrazeSimulationf **simulation);

GRAZE_C_API GrazeStatus graze_simulation_state_hash_f(const GrazeSimulationf *simulation, uint64_t *hash);
GRAZE_C_API GrazeStatus graze_simulation_save_f(const GrazeSimulationf *simulation, GrazeStatef **state);
GRAZE_C_API GrazeStatus graze_simulation_restore_f(GrazeSimulationf *simulation, const GrazeStatef *state);
GRAZE_C_API GrazeStatus graze_state_bytes_f(const GrazeStatef *state, GrazeWriteFunction write, void *user);
GRAZE_C_API GrazeStatus graze_state_read_f(const void *bytes, size_t size, GrazeStatef **state);
GRAZE_C_API void graze_state_destroy_f(GrazeStatef *state);

typedef struct GrazeVec2f {
  float x, y;
} GrazeVec2f;

typedef struct GrazeRot2f {
  float cosine, sine;
} GrazeRot2f;

typedef struct GrazePose2f {
  GrazeVec2f translation;
  GrazeRot2f rotation;
} GrazePose2f;

typedef struct GrazeAabb2f {
  GrazeVec2f lower, upper;
} GrazeAabb2f;

GRAZE_C_API GrazePose2f graze_plane_pose_f(float x, float y, float angle);

typedef struct GrazePlaneShapef GrazePlaneShapef;

GRAZE_C_API GrazeStatus graze_plane_shape_circle_f(float radius, GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_capsule_f(float height, float radius_bottom, float radius_top,
                                                    GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_box_f(GrazeVec2f size, GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_segment_f(GrazeVec2f a, GrazeVec2f b, GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_convex_f(const GrazeVec2f *points, size_t stride, size_t count,
                                                   GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_ellipse_f(GrazeVec2f radii, GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_half_plane_f(GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_polygon_f(const GrazeVec2f *points, size_t stride, size_t count,
                                                    GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_chain_f(const GrazeVec2f *points, size_t stride, size_t count, bool closed,
                                                  GrazeSides sides, GrazePlaneShapef **shape);

typedef struct GrazePlaneChildf {
  const GrazePlaneShapef *shape;
  GrazePose2f pose;
} GrazePlaneChildf;

GRAZE_C_API GrazeStatus graze_plane_shape_compound_f(const GrazePlaneChildf *children, size_t stride, size_t count,
                                                     GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_user_f(GrazeVec2f (*support)(const void *user, GrazeVec2f direction),
                                                 void (*release)(void *user), void *user, GrazePlaneShapef **shape);
GRAZE_C_API GrazeStatus graze_plane_shape_rounded_f(const GrazePlaneShapef *shape, float rounding,
                                                    GrazePlaneShapef **rounded);
GRAZE_C_API GrazeStatus graze_plane_shape_swept_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                  GrazeVec2f motion, GrazePlaneShapef **swept);
GRAZE_C_API void graze_plane_shape_retain_f(const GrazePlaneShapef *shape);
GRAZE_C_API void graze_plane_shape_release_f(const GrazePlaneShapef *shape);
GRAZE_C_API GrazeStatus graze_plane_shape_kind_f(const GrazePlaneShapef *shape, GrazePlaneShapeKind *kind);
GRAZE_C_API GrazeStatus graze_plane_shape_rounding_f(const GrazePlaneShapef *shape, float *rounding);
GRAZE_C_API GrazeStatus graze_plane_shape_bounds_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                   GrazeAabb2f *bounds);
GRAZE_C_API GrazeStatus graze_plane_shape_support_f(const GrazePlaneShapef *shape, GrazeVec2f direction,
                                                    GrazeVec2f *point);

typedef struct GrazePlaneShapeMeasuresf {
  GrazeVec2f size;
  GrazeVec2f radii;
  float height;
  float radius, radius_top;
  size_t children;
  bool convex;
  bool closed;
  GrazeSides sides;
} GrazePlaneShapeMeasuresf;

GRAZE_C_API GrazeStatus graze_plane_shape_measures_f(const GrazePlaneShapef *shape, GrazePlaneShapeMeasuresf *measures);
GRAZE_C_API GrazeStatus graze_plane_shape_points_f(const GrazePlaneShapef *shape, GrazeBufferf *buffer,
                                                   const GrazeVec2f **points, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_shape_child_f(const GrazePlaneShapef *compound, size_t index,
                                                  GrazePlaneChildf *child);

typedef struct GrazePlaneMassPropertiesf {
  float area;
  GrazeVec2f center;
  float inertia;
} GrazePlaneMassPropertiesf;

GRAZE_C_API GrazeStatus graze_plane_shape_mass_properties_f(const GrazePlaneShapef *shape,
                                                            GrazePlaneMassPropertiesf *properties);

typedef struct GrazePlaneDistancef {
  float distance;
  GrazeVec2f normal, a, b;
  uint8_t certainty;
  float error;
} GrazePlaneDistancef;

typedef struct GrazePlaneClosestf {
  float distance;
  GrazeVec2f point, normal;
  uint8_t certainty;
  float error;
} GrazePlaneClosestf;

typedef struct GrazePlanePieceDistancef {
  uint32_t piece_a, piece_b;
  GrazePlaneDistancef distance;
} GrazePlanePieceDistancef;

typedef struct GrazePlaneContactPointf {
  GrazeVec2f a, b;
  float distance;
  uint32_t feature;
  float weight;
} GrazePlaneContactPointf;

typedef struct GrazePlaneManifoldf {
  GrazeVec2f normal;
  uint32_t piece_a, piece_b;
  uint32_t first_point, point_count;
} GrazePlaneManifoldf;

typedef struct GrazePlaneContactsf {
  bool overlap;
  uint8_t certainty;
  float error;
  const GrazePlaneManifoldf *manifolds;
  size_t manifold_count;
  const GrazePlaneContactPointf *points;
  size_t point_count;
} GrazePlaneContactsf;

typedef struct GrazePlaneBatchContactsf {
  const GrazePairContacts *pairs;
  size_t pair_count;
  const GrazePlaneManifoldf *manifolds;
  size_t manifold_count;
  const GrazePlaneContactPointf *points;
  size_t point_count;
} GrazePlaneBatchContactsf;

typedef struct GrazePlaneRayf {
  GrazeVec2f origin, direction;
} GrazePlaneRayf;

typedef struct GrazePlaneRayHitf {
  float t;
  GrazeVec2f point, normal;
  uint32_t piece;
  uint8_t certainty;
} GrazePlaneRayHitf;

typedef struct GrazePlaneVelocityf {
  GrazeVec2f linear;
  float angular;
} GrazePlaneVelocityf;

typedef struct GrazePlaneCastHitf {
  float t;
  GrazeVec2f point, normal;
  float depth;
  uint8_t certainty;
  uint32_t piece_a, piece_b;
} GrazePlaneCastHitf;

typedef struct GrazePlaneMovingf {
  const GrazePlaneShapef *shape;
  GrazePose2f pose;
  GrazePlaneVelocityf velocity;
} GrazePlaneMovingf;

GRAZE_C_API GrazeStatus graze_plane_overlap_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                              const GrazePlaneShapef *b, const GrazePose2f *pose_b, bool *overlap);
GRAZE_C_API GrazeStatus graze_plane_distance_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                               const GrazePlaneShapef *b, const GrazePose2f *pose_b,
                                               GrazePlaneDistancef *distance);
GRAZE_C_API GrazeStatus graze_plane_distance_up_to_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                                     const GrazePlaneShapef *b, const GrazePose2f *pose_b, float limit,
                                                     bool *found, GrazePlaneDistancef *distance);
GRAZE_C_API GrazeStatus graze_plane_within_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                             const GrazePlaneShapef *b, const GrazePose2f *pose_b, float limit,
                                             bool *within);
GRAZE_C_API GrazeStatus graze_plane_near_pieces_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                                  const GrazePlaneShapef *b, const GrazePose2f *pose_b, float margin,
                                                  GrazeBufferf *buffer, const GrazePlanePieceDistancef **pieces,
                                                  size_t *count);
GRAZE_C_API GrazeStatus graze_plane_contacts_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                               const GrazePlaneShapef *b, const GrazePose2f *pose_b, float margin,
                                               GrazeBufferf *buffer, GrazePlaneContactsf *contacts);
GRAZE_C_API GrazeStatus graze_plane_contacts_reduced_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                                       const GrazePlaneShapef *b, const GrazePose2f *pose_b,
                                                       float margin, size_t most, GrazeBufferf *buffer,
                                                       GrazePlaneContactsf *contacts);
GRAZE_C_API GrazeStatus graze_plane_contact_margin_f(const GrazePlaneShapef *a, const GrazePlaneShapef *b,
                                                     float *margin);
GRAZE_C_API GrazeStatus graze_plane_feature_corners_f(const GrazePlaneShapef *shape, uint32_t piece, uint16_t feature,
                                                      GrazeBufferf *buffer, const GrazeVec2f **corners, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_closest_f(const GrazePlaneShapef *shape, const GrazePose2f *pose, GrazeVec2f point,
                                              GrazePlaneClosestf *closest);
GRAZE_C_API GrazeStatus graze_plane_raycast_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                              const GrazePlaneRayf *ray, float length, bool *found,
                                              GrazePlaneRayHitf *hit);
GRAZE_C_API GrazeStatus graze_plane_raycast_any_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                  const GrazePlaneRayf *ray, float length, bool *found);
GRAZE_C_API GrazeStatus graze_plane_raycast_all_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                  const GrazePlaneRayf *ray, float length, GrazeBufferf *buffer,
                                                  const GrazePlaneRayHitf **hits, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_cast_f(const GrazePlaneMovingf *a, const GrazePlaneMovingf *b, float duration,
                                           GrazeSeparating separating, bool *found, GrazePlaneCastHitf *hit);
GRAZE_C_API GrazeStatus graze_plane_cast_all_f(const GrazePlaneMovingf *a, const GrazePlaneMovingf *b, float duration,
                                               GrazeSeparating separating, GrazeBufferf *buffer,
                                               const GrazePlaneCastHitf **hits, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_overlap_explained_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                                        const GrazePlaneShapef *b, const GrazePose2f *pose_b,
                                                        bool *overlap, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_distance_explained_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                                         const GrazePlaneShapef *b, const GrazePose2f *pose_b,
                                                         GrazePlaneDistancef *distance, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_contacts_explained_f(const GrazePlaneShapef *a, const GrazePose2f *pose_a,
                                                         const GrazePlaneShapef *b, const GrazePose2f *pose_b,
                                                         float margin, GrazeBufferf *buffer,
                                                         GrazePlaneContactsf *contacts, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_closest_explained_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                        GrazeVec2f point, GrazePlaneClosestf *closest,
                                                        GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_raycast_explained_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                        const GrazePlaneRayf *ray, float length, bool *found,
                                                        GrazePlaneRayHitf *hit, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_cast_explained_f(const GrazePlaneMovingf *a, const GrazePlaneMovingf *b,
                                                     float duration, GrazeSeparating separating, bool *found,
                                                     GrazePlaneCastHitf *hit, GrazeTrace *trace);
GRAZE_C_API GrazeStatus graze_plane_pose_at_f(const GrazePose2f *pose, const GrazePlaneVelocityf *velocity, float t,
                                              GrazePose2f *result);

typedef struct GrazePlaneBodiesf {
  const GrazePlaneShapef *const *shapes;
  size_t shape_stride, shape_count;
  const GrazeVec2f *translations;
  size_t translation_stride;
  const GrazeRot2f *rotations;
  size_t rotation_stride;
  size_t pose_count;
} GrazePlaneBodiesf;

GRAZE_C_API GrazePlaneBodiesf graze_plane_bodies_f(const GrazePlaneShapef *const *shapes, size_t shape_count,
                                                   const GrazePose2f *poses, size_t pose_count);

typedef struct GrazePlaneBatchf {
  GrazePlaneBodiesf a, b;
  const GrazeIdPair *places;
  size_t place_stride, place_count;
} GrazePlaneBatchf;

GRAZE_C_API GrazeStatus graze_plane_batch_size_f(const GrazePlaneBatchf *batch, size_t *size);
GRAZE_C_API GrazeStatus graze_plane_overlap_batch_f(const GrazePlaneBatchf *batch, uint8_t *touch, size_t stride,
                                                    const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_distance_batch_f(const GrazePlaneBatchf *batch, GrazePlaneDistancef *distances,
                                                     size_t stride, const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_contacts_batch_f(const GrazePlaneBatchf *batch, float margin,
                                                     GrazeBufferf *buffer, GrazePlaneBatchContactsf *contacts,
                                                     const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_contacts_batch_reduced_f(const GrazePlaneBatchf *batch, float margin, size_t most,
                                                             GrazeBufferf *buffer,
                                                             GrazePlaneBatchContactsf *contacts,
                                                             const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_near_pieces_batch_f(const GrazePlaneBatchf *batch, float margin,
                                                        GrazeBufferf *buffer, const GrazePlanePieceDistancef **pieces,
                                                        const size_t **ends, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_closest_batch_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                    const GrazeVec2f *points, size_t point_stride, size_t count,
                                                    GrazePlaneClosestf *closest, size_t closest_stride,
                                                    const GrazeExecutor *executor);
GRAZE_C_API GrazeStatus graze_plane_raycast_batch_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                    const GrazePlaneRayf *rays, size_t ray_stride, size_t count,
                                                    float length, uint8_t *found, size_t found_stride,
                                                    GrazePlaneRayHitf *hits, size_t hit_stride);
GRAZE_C_API GrazeStatus graze_plane_cast_batch_f(const GrazePlaneMovingf *a, size_t a_stride,
                                                 const GrazePlaneMovingf *b, size_t b_stride, size_t count,
                                                 float duration, GrazeSeparating separating, uint8_t *found,
                                                 size_t found_stride, GrazePlaneCastHitf *hits, size_t hit_stride,
                                                 const GrazeExecutor *executor);

typedef struct GrazePlaneMotionf {
  GrazeVec2f linear;
  float angular;
  GrazeVec2f center;
} GrazePlaneMotionf;

typedef struct GrazePlaneInverseMassf {
  float mass, inertia;
} GrazePlaneInverseMassf;

typedef struct GrazePlaneStruckBodyf {
  GrazePlaneMotionf motion;
  GrazePlaneInverseMassf mass;
} GrazePlaneStruckBodyf;

typedef struct GrazePlaneBlowf {
  uint32_t a, b;
  GrazeVec2f normal;
  float restitution;
  uint32_t first_point, point_count;
} GrazePlaneBlowf;

typedef struct GrazePlaneTouchingf {
  GrazePlaneStruckBodyf *bodies;
  size_t body_stride, body_count;
  const GrazePlaneBlowf *blows;
  size_t blow_stride, blow_count;
  const GrazeVec2f *points;
  size_t point_stride, point_count;
  float *impulses;
  size_t impulse_stride;
} GrazePlaneTouchingf;

typedef struct GrazePlaneFreeBodyf {
  GrazeVec2f center;
  GrazeRot2f rotation;
  GrazeVec2f linear;
  float angular_momentum, inverse_inertia;
} GrazePlaneFreeBodyf;

GRAZE_C_API GrazeStatus graze_plane_apply_impulse_f(const GrazePlaneStruckBodyf *body, GrazeVec2f impulse,
                                                    GrazeVec2f point, GrazePlaneMotionf *motion);
GRAZE_C_API GrazeStatus graze_plane_pass_on_f(const GrazePlaneTouchingf *touching, float resting_speed, size_t most,
                                              GrazePassedOnf *passed);
GRAZE_C_API GrazeStatus graze_plane_free_angular_velocity_f(const GrazePlaneFreeBodyf *body, float *angular);
GRAZE_C_API GrazeStatus graze_plane_free_set_angular_velocity_f(GrazePlaneFreeBodyf *body, float angular);
GRAZE_C_API GrazeStatus graze_plane_free_advance_f(GrazePlaneFreeBodyf *body, GrazeVec2f acceleration,
                                                   float duration);

typedef struct GrazePlaneWorldf GrazePlaneWorldf;

typedef struct GrazePlaneBodyf {
  const GrazePlaneShapef *shape;
  GrazePose2f pose;
  GrazeVec2f linear;
  float angular;
  GrazeFilter filter;
  bool fixed;
  bool trigger;
  bool fast;
} GrazePlaneBodyf;

GRAZE_C_API GrazePlaneBodyf graze_plane_body_default_f(const GrazePlaneShapef *shape);

GRAZE_C_API GrazeStatus graze_plane_world_create_f(const GrazeWorldSettingsf *settings, const GrazeExecutor *executor,
                                                   GrazePlaneWorldf **world);
GRAZE_C_API GrazeStatus graze_plane_world_create_captured_f(const GrazeWorldSettingsf *settings,
                                                            const GrazeExecutor *executor, GrazeWriteFunction write,
                                                            void *user, GrazePlaneWorldf **world);
GRAZE_C_API void graze_plane_world_destroy_f(GrazePlaneWorldf *world);

GRAZE_C_API GrazeStatus graze_plane_world_add_f(GrazePlaneWorldf *world, const GrazePlaneBodyf *body, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_plane_world_remove_f(GrazePlaneWorldf *world, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_plane_world_move_f(GrazePlaneWorldf *world, GrazeBodyId id, const GrazePose2f *pose,
                                                 const GrazePlaneVelocityf *velocity);
GRAZE_C_API GrazeStatus graze_plane_world_move_batch_f(GrazePlaneWorldf *world, const GrazeBodyId *ids,
                                                       size_t id_stride, const GrazePose2f *poses, size_t pose_stride,
                                                       const GrazePlaneVelocityf *velocities, size_t velocity_stride,
                                                       size_t count);
GRAZE_C_API GrazeStatus graze_plane_world_set_shape_f(GrazePlaneWorldf *world, GrazeBodyId id,
                                                      const GrazePlaneShapef *shape);
GRAZE_C_API GrazeStatus graze_plane_world_set_filter_f(GrazePlaneWorldf *world, GrazeBodyId id, GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_plane_world_set_fast_f(GrazePlaneWorldf *world, GrazeBodyId id, bool fast);
GRAZE_C_API GrazeStatus graze_plane_world_set_name_f(GrazePlaneWorldf *world, GrazeBodyId id, const char *name);
GRAZE_C_API GrazeStatus graze_plane_world_name_f(const GrazePlaneWorldf *world, GrazeBodyId id, const char **name);
GRAZE_C_API GrazeStatus graze_plane_world_set_allow_f(GrazePlaneWorldf *world,
                                                      bool (*allow)(void *user, GrazeBodyId a, GrazeBodyId b),
                                                      void *user);

GRAZE_C_API GrazeStatus graze_plane_world_counts_f(const GrazePlaneWorldf *world, size_t *bodies, size_t *indices);
GRAZE_C_API GrazeStatus graze_plane_world_contains_f(const GrazePlaneWorldf *world, GrazeBodyId id, bool *contains);
GRAZE_C_API GrazeStatus graze_plane_world_body_at_f(const GrazePlaneWorldf *world, uint32_t index, bool *found,
                                                    GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_plane_world_body_f(const GrazePlaneWorldf *world, GrazeBodyId id, GrazePlaneBodyf *body);
GRAZE_C_API GrazeStatus graze_plane_world_poses_f(const GrazePlaneWorldf *world, const GrazePose2f **poses,
                                                  size_t *count);

GRAZE_C_API GrazeStatus graze_plane_world_update_f(GrazePlaneWorldf *world, float duration);
GRAZE_C_API GrazeStatus graze_plane_world_find_impacts_f(GrazePlaneWorldf *world, float duration);

typedef struct GrazePlaneSolverPointf {
  GrazeVec2f a, b;
  float distance;
  uint32_t feature;
  float weight;
  GrazeVec2f impulse;
} GrazePlaneSolverPointf;

typedef struct GrazePlaneWorldContactsf {
  const GrazeWorldPair *pairs;
  size_t pair_count;
  const GrazePlaneManifoldf *manifolds;
  size_t manifold_count;
  const GrazePlaneSolverPointf *points;
  size_t point_count;
} GrazePlaneWorldContactsf;

GRAZE_C_API GrazeStatus graze_plane_world_contacts_f(const GrazePlaneWorldf *world, GrazePlaneWorldContactsf *contacts);
GRAZE_C_API GrazeStatus graze_plane_world_solver_points_f(GrazePlaneWorldf *world, GrazePlaneSolverPointf **points,
                                                          size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_reduce_f(GrazePlaneWorldf *world, size_t most);
GRAZE_C_API GrazeStatus graze_plane_world_events_f(const GrazePlaneWorldf *world, const GrazeContactEvent **events,
                                                   size_t *count);

typedef struct GrazePlaneImpactf {
  GrazeBodyId a, b;
  bool trigger;
  GrazePlaneCastHitf hit;
} GrazePlaneImpactf;

GRAZE_C_API GrazeStatus graze_plane_world_impacts_f(const GrazePlaneWorldf *world, const GrazePlaneImpactf **impacts,
                                                    size_t *count);

typedef struct GrazePlaneBodyDistancef {
  GrazeBodyId body;
  GrazePlaneDistancef distance;
} GrazePlaneBodyDistancef;

typedef struct GrazePlaneBodyRayHitf {
  GrazeBodyId body;
  GrazePlaneRayHitf hit;
} GrazePlaneBodyRayHitf;

typedef struct GrazePlaneBodyCastHitf {
  GrazeBodyId body;
  GrazePlaneCastHitf hit;
} GrazePlaneBodyCastHitf;

GRAZE_C_API GrazeStatus graze_plane_world_overlapping_f(const GrazePlaneWorldf *world, const GrazePlaneShapef *shape,
                                                        const GrazePose2f *pose, const GrazeQueryFilter *filter,
                                                        GrazeBufferf *buffer, const GrazeBodyId **bodies,
                                                        size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_overlaps_any_f(const GrazePlaneWorldf *world, const GrazePlaneShapef *shape,
                                                         const GrazePose2f *pose, const GrazeQueryFilter *filter,
                                                         bool *any);
GRAZE_C_API GrazeStatus graze_plane_world_nearest_f(const GrazePlaneWorldf *world, const GrazePlaneShapef *shape,
                                                    const GrazePose2f *pose, size_t most, float limit,
                                                    const GrazeQueryFilter *filter, GrazeBufferf *buffer,
                                                    const GrazePlaneBodyDistancef **bodies, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_raycast_f(const GrazePlaneWorldf *world, const GrazePlaneRayf *ray,
                                                    float length, const GrazeQueryFilter *filter, bool *found,
                                                    GrazePlaneBodyRayHitf *hit);
GRAZE_C_API GrazeStatus graze_plane_world_raycast_any_f(const GrazePlaneWorldf *world, const GrazePlaneRayf *ray,
                                                        float length, const GrazeQueryFilter *filter, bool *found);
GRAZE_C_API GrazeStatus graze_plane_world_raycast_all_f(const GrazePlaneWorldf *world, const GrazePlaneRayf *ray,
                                                        float length, const GrazeQueryFilter *filter,
                                                        GrazeBufferf *buffer, const GrazePlaneBodyRayHitf **hits,
                                                        size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_cast_f(const GrazePlaneWorldf *world, const GrazePlaneMovingf *moving,
                                                 float duration, const GrazeQueryFilter *filter,
                                                 GrazeSeparating separating, bool *found, GrazePlaneBodyCastHitf *hit);
GRAZE_C_API GrazeStatus graze_plane_world_cast_all_f(const GrazePlaneWorldf *world, const GrazePlaneMovingf *moving,
                                                     float duration, const GrazeQueryFilter *filter,
                                                     GrazeSeparating separating, GrazeBufferf *buffer,
                                                     const GrazePlaneBodyCastHitf **hits, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_world_slide_f(const GrazePlaneWorldf *world, const GrazePlaneShapef *shape,
                                                  const GrazePose2f *pose, GrazeVec2f motion, int casts,
                                                  const GrazeQueryFilter *filter, GrazeBufferf *buffer,
                                                  GrazePose2f *end, GrazeVec2f *left,
                                                  const GrazePlaneBodyCastHitf **touched, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_along_lines_f(GrazeVec2f motion, const GrazeVec2f *normals, size_t stride,
                                                  size_t count, GrazeVec2f *left);
GRAZE_C_API GrazeStatus graze_plane_world_memory_f(const GrazePlaneWorldf *world, size_t *bytes);

typedef struct GrazePlaneSimulationf GrazePlaneSimulationf;

typedef struct GrazePlaneSimulationSettingsf {
  GrazeVec2f gravity;
  int32_t sub_steps;
  int32_t most_sub_steps;
  bool sleep;
  bool continuous;
  bool warm_start;
  float longest_step;
} GrazePlaneSimulationSettingsf;

GRAZE_C_API GrazePlaneSimulationSettingsf graze_plane_simulation_settings_default_f(void);

typedef struct GrazePlaneDynamicsf {
  bool has_mass, has_center_of_mass, has_inertia;
  float mass;
  GrazeVec2f center_of_mass;
  float inertia;
  float density;
  float gravity_factor;
  float linear_damping, angular_damping;
  bool kinematic;
  bool may_sleep;
} GrazePlaneDynamicsf;

GRAZE_C_API GrazePlaneDynamicsf graze_plane_dynamics_default_f(void);

typedef struct GrazePlaneMaterialf {
  float static_friction, dynamic_friction;
  float restitution;
  float rolling_friction;
  uint8_t friction_combine, restitution_combine;
  GrazeVec2f surface_velocity;
} GrazePlaneMaterialf;

GRAZE_C_API GrazePlaneMaterialf graze_plane_material_default_f(void);

typedef struct GrazePlaneJointf {
  GrazeBodyId a, b;
  GrazePose2f frame_a, frame_b;
  const GrazeJointLimitf *limits;
  size_t limit_count;
  const GrazeJointDrivef *drives;
  size_t drive_count;
  bool enable_collision;
} GrazePlaneJointf;

GRAZE_C_API GrazeStatus graze_plane_joint_of_kind_f(GrazeJointKind kind, GrazeBodyId a, const GrazePose2f *frame_a,
                                                    GrazeBodyId b, const GrazePose2f *frame_b, GrazePlaneJointf *joint);
GRAZE_C_API GrazeStatus graze_plane_joint_slider_f(GrazeBodyId a, const GrazePose2f *frame_a, GrazeBodyId b,
                                                   const GrazePose2f *frame_b, float min, float max,
                                                   GrazeBufferf *buffer, GrazePlaneJointf *joint);
GRAZE_C_API GrazeStatus graze_plane_joint_distance_f(GrazeBodyId a, const GrazePose2f *frame_a, GrazeBodyId b,
                                                     const GrazePose2f *frame_b, float min, float max,
                                                     GrazeBufferf *buffer, GrazePlaneJointf *joint);

typedef struct GrazePlaneStepReportf {
  size_t awake, islands, contacts, colors;
  int32_t most_sub_steps;
  size_t stopped;
  float deepest, mean_depth, residual;
  float kinetic_energy, potential_energy;
  GrazeVec2f momentum;
  float angular_momentum;
  float collide_ms, prepare_ms, solve_ms, continuous_ms, whole_ms;
} GrazePlaneStepReportf;

typedef struct GrazePlaneStatef GrazePlaneStatef;

GRAZE_C_API GrazeStatus graze_plane_simulation_create_f(const GrazePlaneSimulationSettingsf *settings,
                                                        const GrazeExecutor *executor,
                                                        GrazePlaneSimulationf **simulation);
GRAZE_C_API GrazeStatus graze_plane_simulation_create_captured_f(const GrazePlaneSimulationSettingsf *settings,
                                                                 const GrazeExecutor *executor, GrazeWriteFunction write,
                                                                 void *user, GrazePlaneSimulationf **simulation);
GRAZE_C_API void graze_plane_simulation_destroy_f(GrazePlaneSimulationf *simulation);

GRAZE_C_API GrazeStatus graze_plane_simulation_add_f(GrazePlaneSimulationf *simulation, const GrazePlaneBodyf *body,
                                                     const GrazePlaneDynamicsf *dynamics,
                                                     const GrazePlaneMaterialf *material, GrazeBodyId *id);
GRAZE_C_API GrazeStatus graze_plane_simulation_remove_f(GrazePlaneSimulationf *simulation, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_plane_simulation_add_joint_f(GrazePlaneSimulationf *simulation,
                                                           const GrazePlaneJointf *joint, GrazeJointId *id);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_joint_f(GrazePlaneSimulationf *simulation, GrazeJointId id,
                                                           const GrazePlaneJointf *joint);
GRAZE_C_API GrazeStatus graze_plane_simulation_remove_joint_f(GrazePlaneSimulationf *simulation, GrazeJointId id);

GRAZE_C_API GrazeStatus graze_plane_simulation_step_f(GrazePlaneSimulationf *simulation, float dt);

GRAZE_C_API GrazeStatus graze_plane_simulation_apply_impulse_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                               GrazeVec2f impulse, GrazeVec2f point);
GRAZE_C_API GrazeStatus graze_plane_simulation_apply_angular_impulse_f(GrazePlaneSimulationf *simulation,
                                                                       GrazeBodyId id, float impulse);
GRAZE_C_API GrazeStatus graze_plane_simulation_apply_force_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                             GrazeVec2f force);
GRAZE_C_API GrazeStatus graze_plane_simulation_apply_torque_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                              float torque);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_velocity_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                              const GrazePlaneVelocityf *velocity);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_pose_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                          const GrazePose2f *pose);
GRAZE_C_API GrazeStatus graze_plane_simulation_move_to_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                         const GrazePose2f *pose, float dt);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_filter_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                            GrazeFilter filter);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_material_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                              const GrazePlaneMaterialf *material);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_materials_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                               const GrazePlaneMaterialf *materials,
                                                               size_t material_count, const uint32_t *of_piece,
                                                               size_t piece_count);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_gravity_f(GrazePlaneSimulationf *simulation, GrazeVec2f gravity);
GRAZE_C_API GrazeStatus graze_plane_simulation_wake_f(GrazePlaneSimulationf *simulation, GrazeBodyId id);
GRAZE_C_API GrazeStatus graze_plane_simulation_set_name_f(GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                          const char *name);

GRAZE_C_API GrazeStatus graze_plane_simulation_pose_f(const GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                      GrazePose2f *pose);
GRAZE_C_API GrazeStatus graze_plane_simulation_poses_f(const GrazePlaneSimulationf *simulation,
                                                       const GrazePose2f **poses, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_simulation_motion_f(const GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                        GrazePlaneVelocityf *velocity, GrazeVec2f *center_of_mass);
GRAZE_C_API GrazeStatus graze_plane_simulation_angular_momentum_f(const GrazePlaneSimulationf *simulation,
                                                                  GrazeBodyId id, float *momentum);
GRAZE_C_API GrazeStatus graze_plane_simulation_mass_f(const GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                      float *mass);
GRAZE_C_API GrazeStatus graze_plane_simulation_asleep_f(const GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                        bool *asleep);
GRAZE_C_API GrazeStatus graze_plane_simulation_sub_steps_f(const GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                           int32_t *sub_steps);
GRAZE_C_API GrazeStatus graze_plane_simulation_joints_f(const GrazePlaneSimulationf *simulation, GrazeBufferf *buffer,
                                                        const GrazeJointId **joints, size_t *count);
GRAZE_C_API GrazeStatus graze_plane_simulation_joint_f(const GrazePlaneSimulationf *simulation, GrazeJointId id,
                                                       GrazeBufferf *buffer, GrazePlaneJointf *joint);
GRAZE_C_API GrazeStatus graze_plane_simulation_joint_impulses_f(const GrazePlaneSimulationf *simulation,
                                                                GrazeJointId id, const float **impulses,
                                                                size_t *count);
GRAZE_C_API GrazeStatus graze_plane_simulation_report_f(const GrazePlaneSimulationf *simulation,
                                                        GrazePlaneStepReportf *report);
GRAZE_C_API GrazeStatus graze_plane_simulation_settings_f(const GrazePlaneSimulationf *simulation,
                                                          GrazePlaneSimulationSettingsf *settings);
GRAZE_C_API GrazeStatus graze_plane_simulation_world_f(const GrazePlaneSimulationf *simulation,
                                                       const GrazePlaneWorldf **world);
GRAZE_C_API GrazeStatus graze_plane_world_simulation_f(const GrazePlaneWorldf *world,
                                                       const GrazePlaneSimulationf **simulation);

GRAZE_C_API GrazeStatus graze_plane_simulation_state_hash_f(const GrazePlaneSimulationf *simulation, uint64_t *hash);
GRAZE_C_API GrazeStatus graze_plane_simulation_save_f(const GrazePlaneSimulationf *simulation,
                                                      GrazePlaneStatef **state);
GRAZE_C_API GrazeStatus graze_plane_simulation_restore_f(GrazePlaneSimulationf *simulation,
                                                         const GrazePlaneStatef *state);
GRAZE_C_API GrazeStatus graze_plane_state_bytes_f(const GrazePlaneStatef *state, GrazeWriteFunction write, void *user);
GRAZE_C_API GrazeStatus graze_plane_state_read_f(const void *bytes, size_t size, GrazePlaneStatef **state);
GRAZE_C_API void graze_plane_state_destroy_f(GrazePlaneStatef *state);

GRAZE_C_API GrazeStatus graze_shape_tessellate_f(const GrazeShapef *shape, const GrazePosef *pose, GrazeVec3f center,
                                                 float half_space_size, GrazeBufferf *buffer,
                                                 GrazePolygons *polygons);
GRAZE_C_API GrazeStatus graze_plane_shape_tessellate_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                       GrazeVec2f center, float half_plane_size, GrazeBufferf *buffer,
                                                       GrazePolygons *polygons);
GRAZE_C_API GrazeStatus graze_shape_draw_f(const GrazeShapef *shape, const GrazePosef *pose, GrazeDrawMeaning meaning,
                                           const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_shape_draw_f(const GrazePlaneShapef *shape, const GrazePose2f *pose,
                                                 GrazeDrawMeaning meaning, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_aabb_draw_f(const GrazeAabbf *box, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_distance_draw_f(const GrazeDistancef *distance, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_distance_draw_f(const GrazePlaneDistancef *distance, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_contacts_draw_f(GrazeVec3f normal, const GrazeContactPointf *points, size_t count,
                                              const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_contacts_draw_f(GrazeVec2f normal, const GrazePlaneContactPointf *points,
                                                    size_t count, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_ray_draw_f(const GrazeRayf *ray, float length, const GrazeRayHitf *hit,
                                         const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_ray_draw_f(const GrazePlaneRayf *ray, float length, const GrazePlaneRayHitf *hit,
                                               const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_cast_draw_f(const GrazeMovingf *moving, float duration, const GrazeCastHitf *hit,
                                          const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_cast_draw_f(const GrazePlaneMovingf *moving, float duration,
                                                const GrazePlaneCastHitf *hit, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_trace_span_draw_f(const GrazeTrace *trace, size_t span, const GrazeRayf *ray,
                                                const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_trace_view_span_draw_f(const GrazeTraceView *view, size_t span, const GrazeRayf *ray,
                                                     const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_joint_draw_f(const GrazeJointf *joint, const GrazePosef *pose_a, const GrazePosef *pose_b,
                                           const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_joint_draw_f(const GrazePlaneJointf *joint, const GrazePose2f *pose_a,
                                                 const GrazePose2f *pose_b, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_tree_draw_f(const GrazeAabbf *boxes, size_t count, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_world_draw_f(const GrazeWorldf *world, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_simulation_draw_f(const GrazeSimulationf *simulation, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_simulation_draw_f(const GrazePlaneSimulationf *simulation,
                                                      const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_world_draw_f(const GrazePlaneWorldf *world, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_world_draw_body_f(const GrazeWorldf *world, GrazeBodyId id, const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_simulation_draw_body_f(const GrazeSimulationf *simulation, GrazeBodyId id,
                                                     const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_world_draw_body_f(const GrazePlaneWorldf *world, GrazeBodyId id,
                                                      const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_simulation_draw_body_f(const GrazePlaneSimulationf *simulation, GrazeBodyId id,
                                                           const GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_world_draw_area_f(const GrazeWorldf *world, GrazeDebugDraw *on);
GRAZE_C_API GrazeStatus graze_plane_world_draw_area_f(const GrazePlaneWorldf *world, GrazeDebugDraw *on);

typedef void (*GrazeReplayFunctionf)(void *user, size_t frame, const GrazeWorldf *world,
                                     const GrazePlaneWorldf *plane_world);
GRAZE_C_API GrazeStatus graze_replay_f(const void *bytes, size_t size, GrazeReplayFunctionf each, void *user,
                                       GrazeReplayReport *report, const GrazeExecutor *executor);

// </float>

#ifdef __cplusplus
}
#endif

#endif
