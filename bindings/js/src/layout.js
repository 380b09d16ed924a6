// The layout of the structs of the C interface: WebAssembly's 32-bit C ABI, each member aligned to its size.

import { bits, InvalidValue, number, shown, whole } from "./core.js";

const named = (values, value, path) => {
  const place = values.indexOf(value);
  if (place < 0) throw new InvalidValue(`${path}: expected one of ${values.join(", ")}, got ${shown(value)}`);
  return place;
};

/** The length of an array in an error, and anything else as it is. */
const amount = (value) => (typeof value === "object" && value !== null ? value.length : undefined) ?? shown(value);

export function layouts(core) {
  /** A type of numbers that `checked` lets pass. */
  const plain = (size, get, set, checked) => ({
    size,
    align: size,
    read: (p) => core.data[get](p, true),
    write: (p, v, path) => core.data[set](p, checked(v, path), true),
  });
  const u8 = plain(1, "getUint8", "setUint8", (v, path) => whole(v, path, 255));
  const i32 = plain(4, "getInt32", "setInt32", (v, path) => whole(v, path, 2 ** 31 - 1, -(2 ** 31)));
  const u32 = plain(4, "getUint32", "setUint32", (v, path) => whole(v, path));
  const u64 = plain(8, "getBigUint64", "setBigUint64", bits);
  const real = plain(8, "getFloat64", "setFloat64", number);
  const num = core.scalar === "d" ? real : plain(4, "getFloat32", "setFloat32", number);
  const bool = { ...u8, read: (p) => u8.read(p) !== 0, write: (p, v) => u8.write(p, v ? 1 : 0) };
  const enumeration = (type, values) => ({
    ...type,
    read: (p) => values[type.read(p)],
    write: (p, v, path) => type.write(p, named(values, v, path)),
  });

  /** An array of `count` values of one type. */
  const several = (type, count) => ({
    size: type.size * count,
    align: type.align,
    read: (p) => Array.from({ length: count }, (_, i) => type.read(p + i * type.size)),
    write(p, v, path) {
      if (v === null || typeof v !== "object" || v.length !== count)
        throw new InvalidValue(`${path}: expected ${count} numbers, got ${amount(v)}`);
      for (let i = 0; i < count; ++i) type.write(p + i * type.size, v[i], `${path}[${i}]`);
    },
  });

  /** A struct of members in their order; a member that an object to be written lacks stays as it is. */
  const struct = (members) => {
    let end = 0;
    let align = 1;
    const offset = {};
    for (const [name, type] of Object.entries(members)) {
      end = Math.ceil(end / type.align) * type.align;
      offset[name] = end;
      end += type.size;
      align = Math.max(align, type.align);
    }
    const entries = Object.entries(members).map(([name, type]) => [name, type, offset[name]]);
    return {
      size: Math.ceil(end / align) * align,
      align,
      offset,
      members,
      read(p) {
        const answer = {};
        for (const [name, type, at] of entries) answer[name] = type.read(p + at);
        return answer;
      },
      write(p, value, path) {
        for (const [name, type, at] of entries)
          if (value[name] !== undefined) type.write(p + at, value[name], path ? `${path}.${name}` : name);
      },
    };
  };

  const certainty = enumeration(u8, ["converged", "bounded", "unbounded"]);
  const vec3 = several(num, 3);
  const vec2 = several(num, 2);
  const quat = several(num, 4);
  const mat3 = several(vec3, 3);
  const id = struct({ index: u32, generation: u32 });
  const filter = struct({ category: u64, mask: u64, group: i32 });
  const contacts = struct({
    overlap: bool, certainty, error: num, manifolds: u32, manifoldCount: u32, points: u32, pointCount: u32 });
  const support = struct({ a: several(real, 3), b: several(real, 3) });
  const space = enumeration(u8, ["linear", "angular"]);
  const sides = enumeration(i32, ["both", "front"]);
  const combine = enumeration(u8, ["unset", "average", "minimum", "maximum", "multiply"]);
  const realVector = several(real, 3);
  const pair = struct({ overlap: bool, firstManifold: u32, manifoldCount: u32 });

  /** The structs of a dimension: its vectors, its turnings and rotations, and the parts that differ otherwise. */
  const dimension = (vector, turning, rotation, { rayHitMembers, inertiaMembers, principalInertia, inertia }) => {
    const motion = struct({ linear: vector, angular: turning, center: vector });
    const inverseMass = struct({ mass: num, inertia });
    const pose = struct({ translation: vector, rotation });
    const distance = struct({ distance: num, normal: vector, a: vector, b: vector, certainty, error: num });
    const contactPoint = { a: vector, b: vector, distance: num, feature: u32, weight: num };
    const castHit = struct({ t: num, point: vector, normal: vector, depth: num, certainty, pieceA: u32, pieceB: u32 });
    const rayHit = struct({ t: num, point: vector, normal: vector, piece: u32, ...rayHitMembers });
    return {
      vector, turning, pose, distance, castHit, rayHit, motion, inverseMass,
      struckBody: struct({ motion, mass: inverseMass }),
      blow: struct({ a: u32, b: u32, normal: vector, restitution: num, firstPoint: u32, pointCount: u32 }),
      freeBody: struct({
        center: vector, rotation, linear: vector, angularMomentum: turning, inverseInertia: principalInertia }),
      contactPoint: struct(contactPoint),
      aabb: struct({ lower: vector, upper: vector }),
      child: struct({ shape: u32, pose }),
      closest: struct({ distance: num, point: vector, normal: vector, certainty, error: num }),
      manifold: struct({ normal: vector, pieceA: u32, pieceB: u32, firstPoint: u32, pointCount: u32 }),
      ray: struct({ origin: vector, direction: vector }),
      velocity: struct({ linear: vector, angular: turning }),
      moving: struct({ shape: u32, pose, linear: vector, angular: turning }),
      body: struct({
        shape: u32, pose, linear: vector, angular: turning, filter, fixed: bool, trigger: bool, fast: bool }),
      solverPoint: struct({ ...contactPoint, impulse: vector }),
      impact: struct({ a: id, b: id, trigger: bool, hit: castHit }),
      bodyDistance: struct({ body: id, distance }),
      pieceDistance: struct({ pieceA: u32, pieceB: u32, distance }),
      bodyRayHit: struct({ body: id, hit: rayHit }),
      bodyCastHit: struct({ body: id, hit: castHit }),
      simulationSettings: struct({
        gravity: vector, subSteps: i32, mostSubSteps: i32, sleep: bool, continuous: bool, warmStart: bool,
        longestStep: num }),
      dynamics: struct({
        hasMass: bool, hasCenterOfMass: bool, hasInertia: bool, mass: num, centerOfMass: vector, ...inertiaMembers,
        density: num, gravityFactor: num, linearDamping: num, angularDamping: num, kinematic: bool, maySleep: bool }),
      material: struct({
        staticFriction: num, dynamicFriction: num, restitution: num, rollingFriction: num, frictionCombine: combine,
        restitutionCombine: combine, surfaceVelocity: vector }),
      joint: struct({
        a: id, b: id, frameA: pose, frameB: pose, limits: u32, limitCount: u32, drives: u32, driveCount: u32,
        enableCollision: bool }),
      stepReport: struct({
        awake: u32, islands: u32, contacts: u32, colors: u32, mostSubSteps: i32, stopped: u32, deepest: num,
        meanDepth: num, residual: num, kineticEnergy: num, potentialEnergy: num, momentum: vector,
        angularMomentum: turning, collideMs: num, prepareMs: num, solveMs: num, continuousMs: num, wholeMs: num }),
    };
  };
  const ofSpace = dimension(vec3, vec3, quat, {
    rayHitMembers: {}, inertiaMembers: { inertiaDiagonal: vec3, inertiaOrientation: quat }, principalInertia: vec3,
    inertia: mat3 });

  return {
    u8, i32, u32, u64, num, real, bool, vec3, vec2, quat, mat3, id, filter, contacts, support, pair,
    several, struct, realVector,
    ...ofSpace,
    plane: {
      ...dimension(vec2, num, vec2, {
        rayHitMembers: { certainty }, inertiaMembers: { inertia: num }, principalInertia: num, inertia: num }),
      massProperties: struct({ area: num, center: vec2, inertia: num }),
      shapeMeasures: struct({
        size: vec2, radii: vec2, height: num, radius: num, radiusTop: num, children: u32, convex: bool, closed: bool, sides }),
    },
    broadPhasePart: struct({ box: ofSpace.aabb, depth: u32 }),
    hullLayer: struct({ vertices: u32, vertexCount: u32, edges: u32, edgeCount: u32 }),
    supportLayer: struct({ vertices: u32, lookedAt: u32, along: u32, lookedAtCount: u32, winner: u32 }),
    supportTrace: struct({ layers: u32, layerCount: u32, scanned: bool, vertex: u32, products: u32 }),
    massProperties: struct({ volume: num, center: vec3, inertia: mat3 }),
    shapeMeasures: struct({
      size: vec3, radii: vec3, center: vec3, height: num, radius: num, radiusTop: num, spacing: vec2, tolerance: num,
      columns: u32, rows: u32, children: u32, convex: bool, closed: bool, solid: bool, sides }),
    batchContacts: struct({
      pairs: u32, pairCount: u32, manifolds: u32, manifoldCount: u32, points: u32, pointCount: u32 }),
    compactContacts: struct({ manifolds: u32, manifoldCount: u32, points: u32, pointCount: u32 }),
    compactManifold: struct({ normal: vec3, pair: u32, firstPoint: u32, pointCount: u32 }),
    compactPoint: struct({ position: vec3, distance: num }),
    bodies: struct({
      shapes: u32, shapeStride: u32, shapeCount: u32, translations: u32, translationStride: u32, rotations: u32,
      rotationStride: u32, poseCount: u32 }),
    worldSettings: struct({ hasMargin: bool, margin: num, allow: u32, user: u32, pointsPerPair: u32 }),
    queryFilter: struct({ filter, triggers: bool, accept: u32, user: u32 }),
    worldPair: struct({ a: u32, b: u32, overlap: bool, firstManifold: u32, manifoldCount: u32 }),
    worldContacts: struct({
      pairs: u32, pairCount: u32, manifolds: u32, manifoldCount: u32, points: u32, pointCount: u32 }),
    contactEvent: struct({
      kind: enumeration(u8, ["begin", "stay", "end"]), trigger: bool, a: id, b: id, pair: i32 }),
    jointLimit: struct({
      space, axes: several(bool, 3), min: num, max: num, stiffness: num, damping: num }),
    jointDrive: struct({
      space, mode: enumeration(u8, ["force", "acceleration"]), axis: enumeration(u8, ["x", "y", "z"]),
      positionTarget: num, velocityTarget: num, stiffness: num, damping: num, maxForce: num }),
    touching: struct({
      bodies: u32, bodyStride: u32, bodyCount: u32, blows: u32, blowStride: u32, blowCount: u32, points: u32,
      pointStride: u32, pointCount: u32, impulses: u32, impulseStride: u32 }),
    passedOn: struct({ struck: u32, approach: num }),
    findings: struct(
      Object.fromEntries([
        "triangles", "repeatedTriangles", "withoutArea", "slivers", "repeatedPoints", "flatEdges", "convexEdges",
        "concaveEdges", "openEdges", "irregularEdges", "tJunctions"].map((name) => [name, u32]))),
    struckContact: struct({ point: vec3, normal: vec3, restitution: num, friction: num }),
    response: struct({
      approach: vec3, approachAlongNormal: num, approachTangential: vec3,
      atFault: enumeration(i32, ["neither", "a", "b", "both"]), effectiveMass: num, normalImpulse: num, sliding: vec3,
      stoppingImpulse: vec3, frictionLimit: num, frictionImpulse: vec3, impulse: vec3, a: ofSpace.motion, b: ofSpace.motion }),
    captureHead: struct({ simulation: bool, plane: bool, single: bool }),
    replayReport: struct({
      simulation: bool, plane: bool, cut: bool, differs: bool, frame: u32, call: u32, what: several(u8, 128), frames: u32,
      calls: u32 }),
    polygons: struct({
      points: u32, pointCount: u32, corners: u32, ends: u32, loopCount: u32, smooth: bool, closed: bool }),
    debugDraw: struct({
      layers: u32, center: realVector, size: real, point: u32, line: u32, triangle: u32, text: u32, arrow: u32,
      user: u32 }),
    traceAxis: struct({
      name: u32, direction: realVector, aLower: real, aUpper: real, bLower: real, bUpper: real }),
    traceGjk: struct({
      simplex: u32, simplexCount: u32, direction: realVector, found: support, lower: real, upper: real, polygon: u32,
      polygonCount: u32 }),
    traceEpa: struct({
      normal: realVector, faceDepth: real, foundDepth: real, found: support, faces: u32, polygon: u32,
      polygonCount: u32 }),
    traceSpan: struct({ name: u32, normal: realVector, enter: real, leave: real }),
    traceStep: struct({ t: real, distance: real, normal: realVector }),
    traceCut: struct({ from: realVector, to: realVector, left: u32, leftCount: u32 }),
    traceTriangle: several(u32, 3),
    traceView: struct({
      method: u32, winner: u32, reason: u32, axes: u32, axisCount: u32, gjk: u32, gjkCount: u32, epa: u32,
      epaCount: u32, difference: u32, differenceCount: u32, rounding: real, polytope: u32, polytopeCount: u32,
      triangles: u32, triangleCount: u32, spans: u32, spanCount: u32, steps: u32, stepCount: u32, nodes: u32,
      pieces: u32, faceA: u32, faceB: u32, faceACount: u32, faceBCount: u32, cuts: u32, cutCount: u32 }),
    /** Structs one behind the other, as objects. */
    readAll: (type, pointer, count) => Array.from({ length: count }, (_, i) => type.read(pointer + i * type.size)),
  };
}

/** The place of a word in a list of words. */
export { named };
