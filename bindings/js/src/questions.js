// Queries of two shapes, in space and in the plane.

import { InvalidValue, membersOf, shown, whole } from "./core.js";
import { named } from "./layout.js";
import { poses } from "./poses.js";
import { movingMembers } from "./shapes.js";
import { traceReader } from "./trace.js";

const backFaces = ["hit", "ignored"];
const separations = ["hit", "ignored"];
const rayMembers = ["origin", "direction", "length"];
/** The members that the options of a cast have. */
export const castOptions = ["duration", "separating"];

/** The queries of a dimension, by the beginning of its functions' names, its structs, shapes and poses. */
export function questions(core, layout, { prefix, types, args, of, pose }) {
  const { written, answered } = args;
  const vectorSize = types.vector.size / core.numberSize;
  const call = (name, ...parameters) => core.call(`${prefix}${name}`, ...parameters);
  const two = (a, poseA, b, poseB) => [of(a, "a"), pose(poseA, "poseA"), of(b, "b"), pose(poseB, "poseB")];
  const yes = (name, ...parameters) => answered(layout.bool, (p) => call(name, ...parameters, p));
  /** An answer that may be absent: the function writes first whether it is there. */
  const found = (type, body) => {
    const there = core.room(1);
    const p = core.room(type.size);
    body(there, p);
    return core.data.getUint8(there) === 0 ? null : type.read(p);
  };

  /** Room for answers of no fixed number: one for all queries of a dimension, and one for those of callbacks at each
   * depth, since a query that waits for its callback fills its own. */
  const buffers = [];
  const room = () => {
    if (buffers[core.depth] !== undefined) return buffers[core.depth];
    const p = core.room(4);
    core.call("buffer_create", p);
    buffers[core.depth] = core.data.getUint32(p, true);
    return buffers[core.depth];
  };
  /** The place of an array that belongs to the buffer, and its length. */
  const place = (body) => {
    const first = core.room(4);
    const count = core.room(4);
    body(room(), first, count);
    return [core.data.getUint32(first, true), core.data.getUint32(count, true)];
  };
  /** The elements of such an array. */
  const listed = (type, body) => layout.readAll(type, ...place(body));

  const pointsOf = (all, m) =>
    layout.readAll(types.contactPoint, all.points + m.firstPoint * types.contactPoint.size, m.pointCount);
  const manifolds = (all, first, count) =>
    layout.readAll(types.manifold, all.manifolds + first * types.manifold.size, count).map((m) => ({
      normal: m.normal,
      pieceA: m.pieceA,
      pieceB: m.pieceB,
      points: pointsOf(all, m),
    }));
  const contactsAt = (p) => {
    const all = layout.contacts.read(p);
    const { overlap, certainty, error, manifoldCount } = all;
    return { overlap, certainty, error, manifolds: manifolds(all, 0, manifoldCount) };
  };

  const rayParts = (value) => {
    const { origin, direction } = membersOf(value, "ray", rayMembers);
    for (const [name, part] of Object.entries({ origin, direction }))
      if (part === undefined) throw new InvalidValue(`ray.${name}: expected ${vectorSize} numbers, got ${shown(part)}`);
    return { origin, direction };
  };
  const ray = (value) => written(types.ray, rayParts(value), "ray");
  const length = (value) => value.length ?? Infinity;
  const writeMoving = (p, body = {}, path) => {
    const at = pose(body, path, movingMembers);
    const { linear, angular } = body;
    types.moving.write(p, { shape: of(body.shape, `${path}.shape`), linear, angular }, path);
    core.copy(at, p + types.moving.offset.pose, types.moving.members.pose.size);
  };
  const moving = (body, path) => {
    const p = core.room(types.moving.size);
    writeMoving(p, body, path);
    return p;
  };
  const separating = (options) => named(separations, options.separating ?? "hit", "separating");
  const back = (options) => named(backFaces, options.backFaces ?? "hit", "backFaces");
  /** The argument for back faces, which the plane does not have. */
  const backs = (options) => (prefix === "" ? [back(options)] : []);
  /** The members that options of a ray may have, and those of a cast. */
  const rayOptions = prefix === "" ? ["backFaces"] : [];

  const rayAt = (shape, at, value, given) => {
    const options = membersOf(given, "options", rayOptions);
    return [of(shape), pose(at, "pose"), ray(value), length(value), ...backs(options)];
  };
  const moved = (a, b, given) => {
    const options = membersOf(given, "options", castOptions);
    return [moving(a, "a"), moving(b, "b"), options.duration ?? 1, separating(options)];
  };

  /** Each query by the functions whose names end so, and which take `trace`, or nothing more, after the answer. */
  const asked = (ending, ...trace) => ({
    overlap: (a, poseA, b, poseB) =>
      answered(layout.bool, (p) => call(`overlap${ending}`, ...two(a, poseA, b, poseB), p, ...trace)),
    distance: (a, poseA, b, poseB) =>
      answered(types.distance, (p) => call(`distance${ending}`, ...two(a, poseA, b, poseB), p, ...trace)),
    contacts(a, poseA, b, poseB, margin = 0) {
      const p = core.room(layout.contacts.size);
      call(`contacts${ending}`, ...two(a, poseA, b, poseB), margin, room(), p, ...trace);
      return contactsAt(p);
    },
    closest(shape, at, point) {
      const question = [of(shape), pose(at, "pose"), written(types.vector, point, "point")];
      return answered(types.closest, (p) => call(`closest${ending}`, ...question, p, ...trace));
    },
    raycast: (...question) =>
      found(types.rayHit, (there, p) => call(`raycast${ending}`, ...rayAt(...question), there, p, ...trace)),
    cast: (...question) =>
      found(types.castHit, (there, p) => call(`cast${ending}`, ...moved(...question), there, p, ...trace)),
  });

  const plainly = asked("");
  /** Queries of shapes and their contacts that have no trace. */
  const untraced = {
    contacts(a, poseA, b, poseB, margin = 0, most = undefined) {
      if (most === undefined) return plainly.contacts(a, poseA, b, poseB, margin);
      const p = core.room(layout.contacts.size);
      call("contacts_reduced", ...two(a, poseA, b, poseB), margin, whole(most, "most"), room(), p);
      return contactsAt(p);
    },
    within: (a, poseA, b, poseB, limit) => yes("within", ...two(a, poseA, b, poseB), limit),
    distanceUpTo: (a, poseA, b, poseB, limit) =>
      found(types.distance, (there, p) => call("distance_up_to", ...two(a, poseA, b, poseB), limit, there, p)),
    nearPieces: (a, poseA, b, poseB, margin) =>
      listed(types.pieceDistance, (...to) => call("near_pieces", ...two(a, poseA, b, poseB), margin, ...to)),
    contactMargin: (a, b) => answered(layout.num, (p) => call("contact_margin", of(a, "a"), of(b, "b"), p)),
    featureCorners(shape, feature, piece = 0) {
      const names = [whole(piece, "piece"), whole(feature, "feature", 0xffff)];
      return listed(types.vector, (...to) => call("feature_corners", of(shape), ...names, ...to));
    },
    raycastAny: (...question) => yes("raycast_any", ...rayAt(...question)),
    raycastAll: (...question) => listed(types.rayHit, (...to) => call("raycast_all", ...rayAt(...question), ...to)),
    castAll: (...question) => listed(types.castHit, (...to) => call("cast_all", ...moved(...question), ...to)),
  };

  /** Functions that run in a frame of scratch room each. */
  const framed = (functions) =>
    Object.fromEntries(
      Object.entries(functions).map(([name, f]) => [name, (...parameters) => core.frame(() => f(...parameters))]));

  /** Each query with a trace, which lives in the module as long as it takes: `use` makes the result of both. */
  const explaining = (use) => {
    const explained = (name) => (...parameters) => {
      const place = core.room(4);
      core.check(core.exports.graze_trace_create(place));
      const trace = core.data.getUint32(place, true);
      try {
        return use(asked("_explained", trace)[name](...parameters), trace);
      } finally {
        core.exports.graze_trace_destroy(trace);
      }
    };
    return framed(Object.fromEntries(Object.keys(plainly).map((name) => [name, explained(name)])));
  };
  /** Each query with its trace, as plain objects. */
  const traced = () => {
    const read = traceReader(core, layout);
    return explaining((answer, trace) => ({ answer, trace: read(trace) }));
  };

  return {
    asked: plainly, untraced, framed, explaining, traced, call, two, yes, found, room, place, listed, manifolds, contactsAt, rayParts,
    ray, length, moving, writeMoving, separating, back, backs, rayOptions };
}

/** The queries that only space has, on top of those of both dimensions. */
export function spaceQuestions(core, layout, args, shapes) {
  const { of } = shapes;
  const { written, answered, pose, rows, vec3 } = args;
  const ask = questions(core, layout, { prefix: "", types: layout, args, of, pose });
  const { call, two, yes } = ask;

  const plain = ask.framed({
    ...ask.asked,
    ...ask.untraced,
    ...poses(core, layout, args),
    mayOverlap: (a, poseA, b, poseB) => yes("may_overlap", ...two(a, poseA, b, poseB)),
    alongPlanes(motion, normals) {
      const { pointer, count } = rows(normals, 3, "normals");
      return answered(layout.vec3, (p) => call("along_planes", vec3(motion, "motion"), pointer, 0, count, p));
    },
    poseAt(body = {}, t) {
      const { linear, angular } = body;
      const velocity = written(layout.velocity, { linear, angular }, "velocity");
      return answered(layout.pose, (p) => call("pose_at", pose(body, "pose", movingMembers), velocity, t, p));
    },
  });
  return { ask, plain };
}
