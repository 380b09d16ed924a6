// Bodies, the pairs that touch, and queries of them.

import { created } from "./capture.js";
import { arrayOf, callback, InvalidValue, membersOf, shown, whole } from "./core.js";
import { castOptions } from "./questions.js";
import { bodyMembers } from "./shapes.js";

/** The casts of a slide, at most, as `SlideOptions` of C++ has them. */
const usualCasts = 6;
const filterMembers = ["category", "mask", "group"];
const queryMembers = [...filterMembers, "triggers", "accept"];

/** The worlds of a dimension, whose poses are written by `pose` and shown by `shown` once they are read. */
export function worldClasses(core, layout, dimension, Rows, Handle) {
  const { prefix, types, args, of, Shape, pose, shown: shownPose, numbersOf, ask } = dimension;
  const { written, answered } = args;
  const release = `graze_${prefix}shape_release_${core.scalar}`;
  /** The number of numbers that a pose in an array has. */
  const poseNumbers = types.pose.size / core.numberSize, velocityNumbers = types.velocity.size / core.numberSize;

  const idAt = (value, path) => {
    if (value?.index === undefined || value.generation === undefined)
      throw new InvalidValue(`${path}: expected a handle of a body or joint, got ${shown(value)}`);
    return written(layout.id, value, path);
  };
  const writeFilter = (place, filter, path) => {
    layout.filter.write(place, {
      category: filter.category ?? 1n, mask: filter.mask ?? 0xffffffffffffffffn, group: filter.group ?? 0 }, path);
  };
  const filterAt = (filter) => {
    const p = core.room(layout.filter.size);
    writeFilter(p, membersOf(filter, "filter", filterMembers), "filter");
    return p;
  };
  const bodyAt = (body = {}) => {
    const p = core.room(types.body.size);
    const at = pose(body, "body", bodyMembers);
    const { linear, angular, fixed = false, trigger = false, fast = false } = body;
    types.body.write(p, { shape: of(body.shape, "body.shape"), linear, angular, fixed, trigger, fast }, "body");
    core.copy(at, p + types.body.offset.pose, types.pose.size);
    writeFilter(p + types.body.offset.filter, membersOf(body.filter, "body.filter", filterMembers), "body.filter");
    return p;
  };
  const velocityAt = (velocity) =>
    written(types.velocity, membersOf(velocity, "velocity", Object.keys(types.velocity.members)), "velocity");
  /** A callback that decides last, as the two members of a struct; `key` is null where there is none. */
  const kept = (callback, pointer) => {
    if (callback === undefined) return { key: null, function: 0 };
    return { key: core.keep(callback), function: core.exports[pointer]() };
  };
  /** Runs a query with a filter that lives as long as the query, and with the options that were given for both; the
   * query's own have the names `besides`. */
  const filtered = (given, besides, body) => {
    const p = core.room(layout.queryFilter.size);
    const options = membersOf(given, "options", [...queryMembers, ...besides]);
    writeFilter(p + layout.queryFilter.offset.filter, options, "filter");
    const accept = kept(callback(options.accept, "accept"), "graze_js_accept");
    try {
      layout.queryFilter.write(p, { triggers: options.triggers ?? false, accept: accept.function, user: accept.key ?? 0 });
      return body(p, options);
    } finally {
      if (accept.key !== null) core.callbacks.delete(accept.key);
    }
  };
  const call = (name, ...parameters) => core.call(`${prefix}world_${name}`, ...parameters);
  const yes = (name, ...parameters) => answered(layout.bool, (p) => call(name, ...parameters, p));
  /** An array that belongs to the world. */
  const own = (type, name, world) => {
    const first = core.room(4);
    const count = core.room(4);
    call(name, world, first, count);
    return { first: core.data.getUint32(first, true), count: core.data.getUint32(count, true), type };
  };
  const read = ({ first, count, type }) => layout.readAll(type, first, count);
  const listed = (type, name, ...parameters) =>
    ask.listed(type, (buffer, first, count) => call(name, ...parameters, buffer, first, count));

  const rayed = (ray, f, options) => [ask.ray(ray), ask.length(ray), f, ...ask.backs(options)];
  const moved = (moving, f, options) =>
    [ask.moving(moving, "moving"), options.duration ?? 1, f, ask.separating(options)];

  /** The queries of a world, of its own or of a simulation's; `pointer` returns its pointer. */
  const asked = (pointer) => ({
    size() {
      const bodies = core.room(4);
      call("counts", pointer(), bodies, core.room(4));
      return core.data.getUint32(bodies, true);
    },
    contains: (id) => yes("contains", pointer(), idAt(id, "body")),
    bodyAt: (index) =>
      ask.found(layout.id, (there, p) => call("body_at", pointer(), whole(index, "index"), there, p)),
    pose(id) {
      const body = answered(types.body, (p) => call("body", pointer(), idAt(id, "body"), p));
      core.exports[release](body.shape); // one more share, which the call has added
      return shownPose(body.pose);
    },
    body(id) {
      const { shape, pose: at, ...rest } = answered(types.body, (p) => call("body", pointer(), idAt(id, "body"), p));
      return { shape: new Shape(shape), ...shownPose(at), ...rest };
    },
    shape: (id) => new Shape(answered(types.body, (p) => call("body", pointer(), idAt(id, "body"), p)).shape),
    poses() {
      const { first, count } = own(types.pose, "poses", pointer());
      return core.numbers(first, poseNumbers * count);
    },
    name: (id) => core.string(answered(layout.u32, (p) => call("name", pointer(), idAt(id, "body"), p))),
    contacts() {
      const p = core.room(layout.worldContacts.size);
      call("contacts", pointer(), p);
      const all = layout.worldContacts.read(p);
      const points = layout.readAll(types.solverPoint, all.points, all.pointCount);
      const manifolds = layout.readAll(types.manifold, all.manifolds, all.manifoldCount);
      return layout.readAll(layout.worldPair, all.pairs, all.pairCount).map((pair) => ({
        a: pair.a,
        b: pair.b,
        overlap: pair.overlap,
        manifolds: manifolds.slice(pair.firstManifold, pair.firstManifold + pair.manifoldCount).map((m) => ({
          normal: m.normal,
          pieceA: m.pieceA,
          pieceB: m.pieceB,
          points: points.slice(m.firstPoint, m.firstPoint + m.pointCount),
        })),
      }));
    },
    points() {
      const p = core.room(layout.worldContacts.size);
      call("contacts", pointer(), p);
      const { points, pointCount } = layout.worldContacts.read(p);
      return new Rows(types.solverPoint, () => points, pointCount);
    },
    events: () => read(own(layout.contactEvent, "events", pointer())),
    impacts: () => read(own(types.impact, "impacts", pointer())),
    overlapping: (shape, at, filter) =>
      filtered(filter, [], (f) => listed(layout.id, "overlapping", pointer(), of(shape), pose(at, "pose"), f)),
    overlapsAny: (shape, at, filter) =>
      filtered(filter, [], (f) => yes("overlaps_any", pointer(), of(shape), pose(at, "pose"), f)),
    nearest: (shape, at, most, given) =>
      filtered(given, ["limit"], (f, { limit = Infinity }) =>
        listed(types.bodyDistance, "nearest", pointer(), of(shape), pose(at, "pose"), whole(most, "most"), limit, f)),
    raycast: (ray, given) =>
      filtered(given, ask.rayOptions, (f, options) =>
        ask.found(types.bodyRayHit, (there, p) => call("raycast", pointer(), ...rayed(ray, f, options), there, p))),
    raycastAny: (ray, given) =>
      filtered(given, ask.rayOptions, (f, options) => yes("raycast_any", pointer(), ...rayed(ray, f, options))),
    raycastAll: (ray, given) =>
      filtered(given, ask.rayOptions, (f, options) =>
        listed(types.bodyRayHit, "raycast_all", pointer(), ...rayed(ray, f, options))),
    cast: (moving, given) =>
      filtered(given, castOptions, (f, options) =>
        ask.found(types.bodyCastHit, (there, p) => call("cast", pointer(), ...moved(moving, f, options), there, p))),
    castAll: (moving, given) =>
      filtered(given, castOptions, (f, options) =>
        listed(types.bodyCastHit, "cast_all", pointer(), ...moved(moving, f, options))),
    slide: (shape, at, motion, given) =>
      filtered(given, ["casts"], (f, { casts = usualCasts }) => {
        const end = core.room(types.pose.size);
        const left = core.room(types.vector.size);
        const way = written(types.vector, motion, "motion");
        const touched = ask.listed(types.bodyCastHit, (buffer, first, count) =>
          call(
            "slide", pointer(), of(shape), pose(at, "pose"), way, whole(casts, "casts"), f, buffer, end, left, first,
            count));
        return { end: shownPose(types.pose.read(end)), left: types.vector.read(left), touched };
      }),
    memory: () => answered(layout.u32, (p) => call("memory", pointer(), p)),
  });
  /** The function that returns the pointer of the world, for each object with those queries. */
  const pointers = new WeakMap();
  const pointerOf = (world) => {
    const pointer = pointers.get(world);
    if (pointer === undefined) throw new InvalidValue(`world: expected a World, got ${shown(world)}`);
    return pointer();
  };
  /** Gives `target` those queries as methods. */
  const questionable = (target, pointer) => {
    const { size, ...methods } = asked(pointer);
    const framed = ask.framed({ size, ...methods });
    for (const name of Object.keys(methods)) Object.defineProperty(target, name, { value: framed[name] });
    Object.defineProperty(target, "size", { get: framed.size });
    pointers.set(target, pointer);
    return target;
  };

  /** A function that gives a world back, and forgets the one that decides last, which may be another by then. */
  const releasing = (release, allow) => (pointer) => {
    release(pointer);
    core.callbacks.delete(allow.key);
  };
  /** A new world of those settings: its pointer, what gives it back, and the function that decides last. */
  const opened = (given) => {
    const settings = membersOf(given, "settings", ["margin", "pointsPerPair", "allow", "capture"]);
    const allow = kept(callback(settings.allow, "settings.allow"), "graze_js_allow");
    const begin = () => {
      const p = core.room(layout.worldSettings.size);
      const { margin, pointsPerPair } = settings;
      layout.worldSettings.write(p, {
        hasMargin: margin !== undefined, margin, pointsPerPair, allow: allow.function, user: allow.key ?? 0 }, "settings");
      return p;
    };
    try {
      const [pointer, release] = created(core, `${prefix}world`, begin, callback(settings.capture, "settings.capture"));
      return { pointer, release: releasing(release, allow), allow };
    } catch (error) {
      core.callbacks.delete(allow.key);
      throw error;
    }
  };

  class World extends Handle {
    #allow;
    constructor(given) {
      const { pointer, release, allow } = opened(given);
      super(pointer, release);
      this.#allow = allow;
      questionable(this, () => Handle.pointer(this, "world", World));
    }
    setAllow(given) {
      const next = kept(callback(given, "allow"), "graze_js_allow");
      try {
        core.frame(() => call("set_allow", changed(this), next.function, next.key ?? 0));
      } catch (error) {
        core.callbacks.delete(next.key);
        throw error;
      }
      core.callbacks.delete(this.#allow.key);
      Object.assign(this.#allow, next);
    }
    add(body) {
      return core.frame(() => answered(layout.id, (p) => call("add", changed(this), bodyAt(body), p)));
    }
    remove(id) {
      core.frame(() => call("remove", changed(this), idAt(id, "body")));
    }
    move(id, to, velocity) {
      core.frame(() => {
        const v = velocity === undefined ? 0 : velocityAt(velocity);
        call("move", changed(this), idAt(id, "body"), pose(to, "pose"), v);
      });
    }
    moveBatch(ids, poses, velocities) {
      core.frame(() => {
        const { pointer, count } = numbersOf(poses, poseNumbers, "poses");
        if (arrayOf(ids, "ids").length !== count) throw new InvalidValue(`poses: expected ${ids.length} of them, got ${count}`);
        const moved = velocities === undefined ? { pointer: 0, count } : numbersOf(velocities, velocityNumbers, "velocities");
        if (moved.count !== count) throw new InvalidValue(`velocities: expected ${count} of them, got ${moved.count}`);
        const size = layout.id.size;
        const first = core.room(Math.max(1, count) * size);
        for (let i = 0; i < count; ++i) core.copy(idAt(ids[i], `ids[${i}]`), first + i * size, size);
        call("move_batch", changed(this), first, 0, pointer, 0, moved.pointer, 0, count);
      });
    }
    setShape(id, shape) {
      core.frame(() => call("set_shape", changed(this), idAt(id, "body"), of(shape)));
    }
    setFilter(id, filter) {
      core.frame(() => call("set_filter", changed(this), idAt(id, "body"), filterAt(filter)));
    }
    setFast(id, fast) {
      core.frame(() => call("set_fast", changed(this), idAt(id, "body"), fast ? 1 : 0));
    }
    setName(id, name) {
      core.frame(() => call("set_name", changed(this), idAt(id, "body"), core.written(name, "name")));
    }
    update(duration = 0) {
      core.frame(() => call("update", changed(this), duration));
    }
    findImpacts(duration) {
      core.frame(() => call("find_impacts", changed(this), duration));
    }
    reduce(most) {
      core.frame(() => call("reduce", changed(this), whole(most, "most")));
    }
  }
  const changed = (world) => Handle.changed(world, "world", World);

  return { World, idAt, bodyAt, filterAt, velocityAt, questionable, pointerOf };
}
