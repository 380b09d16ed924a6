// Debug draw: the library's objects and answers, drawn by a renderer of the caller's.

import { arrayOf, callback, InvalidValue, membersOf, shown, whole } from "./core.js";
import { named } from "./layout.js";

const layers = ["shapes", "bounds", "tree", "contacts", "distances", "rays", "casts", "trace", "joints"];
const meanings = [
  "a", "b", "fixed", "touched", "moving", "touching", "asleep", "trigger", "contact", "normal", "gap", "ruledOut",
  "bounds", "path", "ghost", "joint"];
const methods = ["point", "line", "triangle"];
const stepMembers = ["step"];

/** The functions that the module calls while it draws. */
export function drawImports(core) {
  const onto = (key, name, layer, meaning, values) =>
    core.called(key, undefined, (renderer) => renderer[name]?.(...values(), layers[layer], meanings[meaning]));
  const place = (pointer) => Array.from(new Float64Array(core.memory().buffer, pointer, 3));
  return {
    draw: (key, places, count, layer, meaning) =>
      onto(key, methods[count - 1], layer, meaning, () =>
        Array.from({ length: count }, (_, i) => place(places + i * 24))),
    arrow: (key, from, direction, layer, meaning) =>
      onto(key, "arrow", layer, meaning, () => [place(from), place(direction)]),
    text: (key, at, words, layer, meaning) => onto(key, "text", layer, meaning, () => [place(at), core.string(words)]),
  };
}

/** The renderer in the form of the C interface, for as long as `body` takes. */
function drawnOn(core, layout, renderer, body) {
  if (renderer === null || (typeof renderer !== "object" && typeof renderer !== "function"))
    throw new InvalidValue(`renderer: expected an object with methods that draw, got ${shown(renderer)}`);
  for (const name of [...methods, "arrow", "text"]) callback(renderer[name], `renderer.${name}`);
  const on = core.room(layout.debugDraw.size);
  core.exports.graze_debug_draw_default(on);
  const { center, size } = renderer;
  const wanted =
    renderer.layers === undefined
      ? undefined
      : Array.from(arrayOf(renderer.layers, "renderer.layers")).reduce(
          (bits, name) => bits | (1 << named(layers, name, "renderer.layers")), 0);
  layout.debugDraw.write(on, { layers: wanted, center, size }, "renderer");
  const key = core.keep(renderer);
  core.exports.graze_js_debug_draw(on, key, typeof renderer.arrow === "function" ? 1 : 0);
  try {
    return body(on);
  } finally {
    core.callbacks.delete(key);
  }
}

/** The parts of a trace that are drawn, as the C interface has them; the places of the plane may have two numbers. */
function viewOf(core, layout, trace) {
  const { winner = "", axes = [], gjk = [], epa = [], difference = [], polytope = [], triangles = [] } = trace;
  const { spans = [], faceA = [], faceB = [], cuts = [] } = trace;
  const inSpace = (v, path) => (v?.length === 2 ? [v[0], v[1], 0] : given(v, path));
  const given = (value, path) => {
    if (value === undefined || value === null) throw new InvalidValue(`${path}: expected numbers, got ${shown(value)}`);
    return value;
  };
  const all = (type, list, path, of) => {
    const first = core.room(Math.max(1, list.length) * type.size);
    list.forEach((one, i) => type.write(first + i * type.size, of(one, `${path}[${i}]`), `${path}[${i}]`));
    return first;
  };
  const support = ({ a, b }, path) => ({ a: inSpace(a, `${path}.a`), b: inSpace(b, `${path}.b`) });
  const supports = (list, path) => all(layout.support, list, path, support);
  const corners = (list, path) => all(layout.realVector, list, path, inSpace);
  const none = { a: [0, 0, 0], b: [0, 0, 0] };
  const view = core.room(layout.traceView.size);
  layout.traceView.write(view, {
    winner: core.written(winner, "winner"),
    axes: all(layout.traceAxis, axes, "axes", ({ name, direction, a, b }, path) => ({
      name: core.written(name, `${path}.name`), direction: inSpace(direction, `${path}.direction`),
      aLower: given(a, `${path}.a`)[0], aUpper: a[1], bLower: given(b, `${path}.b`)[0], bUpper: b[1] })),
    gjk: all(layout.traceGjk, gjk, "gjk", ({ simplex, direction, found = none, polygon = [] }, path) => ({
      simplex: supports(simplex, `${path}.simplex`), simplexCount: simplex.length,
      direction: inSpace(direction, `${path}.direction`), found: support(found, `${path}.found`),
      polygon: supports(polygon, `${path}.polygon`), polygonCount: polygon.length })),
    epa: all(layout.traceEpa, epa, "epa", ({ normal, faceDepth, found = none, polygon = [] }, path) => ({
      normal: inSpace(normal, `${path}.normal`), faceDepth, found: support(found, `${path}.found`),
      polygon: supports(polygon, `${path}.polygon`), polygonCount: polygon.length })),
    difference: supports(difference, "difference"), differenceCount: difference.length,
    polytope: supports(polytope, "polytope"), polytopeCount: polytope.length,
    triangles: all(layout.traceTriangle, triangles, "triangles", (t) => t), triangleCount: triangles.length,
    faceA: corners(faceA, "faceA"), faceACount: faceA.length, faceB: corners(faceB, "faceB"), faceBCount: faceB.length,
    cuts: all(layout.traceCut, cuts, "cuts", ({ from, to, left }, path) => ({
      from: inSpace(from, `${path}.from`), to: inSpace(to, `${path}.to`),
      left: corners(left, `${path}.left`), leftCount: left.length })),
    spans: all(layout.traceSpan, spans, "spans", ({ name, normal, enter, leave }, path) => ({
      name: core.written(name, `${path}.name`), normal: inSpace(normal, `${path}.normal`),
      enter: given(enter, `${path}.enter`), leave: given(leave, `${path}.leave`) })),
    axisCount: axes.length, gjkCount: gjk.length, epaCount: epa.length, spanCount: spans.length, cutCount: cuts.length,
  }, "trace");
  return view;
}

/** Drawing of a dimension's shapes, answers and explanations. */
export function drawings(core, layout, { prefix, types, args, of, pose, ask }) {
  const { written } = args;
  const drawn = (renderer, body) => drawnOn(core, layout, renderer, body);
  const draw = (name, renderer, ...what) => drawn(renderer, (on) => core.call(`${prefix}${name}_draw`, ...what, on));
  const hitAt = (type, hit) => (hit === null ? 0 : written(type, hit, "hit"));
  return {
    distance: (distance, renderer) => draw("distance", renderer, written(types.distance, distance, "distance")),
    contacts({ normal, points }, renderer) {
      const { size } = types.contactPoint;
      const first = core.room(Math.max(1, points.length) * size);
      points.forEach(({ a, b, weight = 0.5 }, i) =>
        types.contactPoint.write(first + i * size, { a, b, weight, distance: 0, feature: 0 }, `points[${i}]`));
      draw("contacts", renderer, written(types.vector, normal, "normal"), first, points.length);
    },
    ray: (ray, hit, renderer) => draw("ray", renderer, ask.ray(ray), ask.length(ray), hitAt(types.rayHit, hit)),
    cast(moving, hit, renderer, options) {
      const { duration = 1 } = membersOf(options, "options", ["duration"]);
      draw("cast", renderer, ask.moving(moving, "moving"), duration, hitAt(types.castHit, hit));
    },
    shape(shape, at, renderer, meaning = "a") {
      const means = named(meanings, meaning, "meaning");
      drawn(renderer, (on) => core.call(`${prefix}shape_draw`, of(shape), pose(at, "pose"), means, on));
    },
    trace(trace, renderer, options) {
      const { step } = membersOf(options, "options", stepMembers);
      const { graze_trace_view_draw: all, graze_trace_view_step_draw: one } = core.exports;
      const view = viewOf(core, layout, trace);
      drawn(renderer, (on) => core.check(step === undefined ? all(view, on) : one(view, step, on)));
    },
    span(trace, span, ray, renderer) {
      const view = viewOf(core, layout, trace);
      const { origin, direction } = ask.rayParts(ray);
      const inSpace = (v) => (v?.length === 2 ? [v[0], v[1], 0] : v);
      const at = written(layout.ray, { origin: inSpace(origin), direction: inSpace(direction) }, "ray");
      drawn(renderer, (on) => core.call("trace_view_span_draw", view, whole(span, "span"), at, on));
    },
    explained(renderer, options) {
      const { step } = membersOf(options, "options", stepMembers);
      return ask.explaining((answer, trace) => {
        const { graze_trace_draw: all, graze_trace_step_draw: one } = core.exports;
        drawn(renderer, (on) => core.check(step === undefined ? all(trace, on) : one(trace, step, on)));
        return answer;
      });
    },
  };
}

/** Shapes as loops of points. */
export function tessellations(core, layout, { prefix, types, args, of, pose, ask }) {
  const origin = new Array(types.vector.size / core.numberSize).fill(0);
  return {
    tessellate(shape, at, options) {
      const { center = origin, size = 1 } = membersOf(options, "options", ["center", "size"]);
      const about = args.written(types.vector, center, "center");
      const { points, pointCount, corners, ends, loopCount, smooth, closed } = args.answered(layout.polygons, (p) =>
        core.call(`${prefix}shape_tessellate`, of(shape), pose(at, "pose"), about, size, ask.room(), p));
      const last = layout.readAll(layout.u32, ends, loopCount);
      const all = layout.readAll(layout.u32, corners, last.at(-1) ?? 0);
      return {
        points: layout.readAll(layout.realVector, points, pointCount),
        loops: last.map((end, i) => all.slice(i === 0 ? 0 : last[i - 1], end)), smooth, closed };
    },
  };
}

/** Drawing of a dimension's worlds and simulations. */
export function worldDrawings(core, layout, { prefix, types, pose }, worlds, simulations) {
  const drawn = (renderer, body) => drawnOn(core, layout, renderer, body);
  return {
    joint: ({ frameA, frameB }, poseA, poseB, renderer) =>
      drawn(renderer, (on) => {
        const p = core.room(types.joint.size);
        types.joint.write(p, {}, "joint");
        for (const [name, frame] of Object.entries({ frameA, frameB }))
          core.copy(pose(frame, `joint.${name}`), p + types.joint.offset[name], types.pose.size);
        core.call(`${prefix}joint_draw`, p, pose(poseA, "poseA"), pose(poseB, "poseB"), on);
      }),
    world: (world, renderer) =>
      drawn(renderer, (on) => core.call(`${prefix}world_draw`, worlds.pointerOf(world), on)),
    simulation: (simulation, renderer) =>
      drawn(renderer, (on) => core.call(`${prefix}simulation_draw`, simulations.pointerOf(simulation), on)),
    body(owner, id, renderer) {
      const [name, pointer] = simulations.isOne(owner)
        ? ["simulation", simulations.pointerOf(owner)]
        : ["world", worlds.pointerOf(owner)];
      const body = worlds.idAt(id, "body");
      drawn(renderer, (on) => core.call(`${prefix}${name}_draw_body`, pointer, body, on));
    },
    area(world) {
      const on = core.room(layout.debugDraw.size);
      core.exports.graze_debug_draw_default(on);
      core.call(`${prefix}world_draw_area`, worlds.pointerOf(world), on);
      const { center, size } = layout.debugDraw.read(on);
      return { center, size };
    },
  };
}

/** Drawing that only space has, on top of that of both dimensions. */
export function spaceDrawings(core, layout, args) {
  return {
    bounds: (box, renderer) =>
      drawnOn(core, layout, renderer, (on) => core.call("aabb_draw", args.written(layout.aabb, box, "box"), on)),
    tree(boxes, renderer) {
      const { size } = layout.aabb;
      const first = core.room(Math.max(1, boxes.length) * size);
      boxes.forEach((box, i) => layout.aabb.write(first + i * size, box, `boxes[${i}]`));
      drawnOn(core, layout, renderer, (on) => core.call("tree_draw", first, boxes.length, on));
    },
    color(meaning) {
      const rgb = core.room(3);
      core.check(core.exports.graze_draw_color(named(meanings, meaning, "meaning"), rgb));
      return [0, 1, 2].map((i) => core.data.getUint8(rgb + i));
    },
  };
}
