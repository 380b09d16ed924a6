// Blows that are passed on and free motion, in space and in the plane.

import { arrayOf, InvalidValue, membersOf, shown, whole } from "./core.js";

/** The members of a body that a blow meets, and those of a blow. */
export const struckMembers = ["mass", "inertia", "shape", "translation", "rotation", "linear", "angular"];
const blowMembers = ["a", "b", "normal", "points", "restitution"];
const freeMembers = ["inertia", "linear", "angular"];

/** A body as a blow meets it, in the module's memory; `inverseMass` has the parts that differ between dimensions. */
const bodyWriter = (types, { inverseMass }) => (p, given, path) => {
  const body = membersOf(given, path, struckMembers);
  const { linear, angular, translation } = body;
  const motion = { linear, angular, center: translation };
  types.struckBody.write(p, { motion, mass: inverseMass(body, path) }, path);
};

/** Queries of single bodies, and `passOn`. */
export function passing(core, layout, dimension) {
  const { types, args, ask } = dimension;
  const { written, answered } = args;
  const write = bodyWriter(types, dimension);
  /** Writes `values` one behind the other. */
  const list = (type, values, path, writeOne) => {
    const first = core.room(Math.max(1, values.length) * type.size);
    values.forEach((value, i) => writeOne(first + i * type.size, value, `${path}[${i}]`));
    return first;
  };
  return {
    applyImpulse(body, impulse, point) {
      const at = core.room(types.struckBody.size);
      write(at, body, "body");
      const push = written(types.vector, impulse, "impulse");
      return answered(types.motion, (p) => ask.call("apply_impulse", at, push, written(types.vector, point, "point"), p));
    },
    passOn(bodies, blows, options) {
      const { restingSpeed = 0, most = 1000 } = membersOf(options, "options", ["restingSpeed", "most"]);
      arrayOf(bodies, "bodies");
      const points = [];
      const all = Array.from(arrayOf(blows, "blows"), (given, i) => {
        const { points: own, ...blow } = membersOf(given, `blows[${i}]`, blowMembers);
        for (const name of ["a", "b", "normal"])
          if (blow[name] === undefined) throw new InvalidValue(`blows[${i}].${name}: expected a value, got undefined`);
        const firstPoint = points.length;
        points.push(...arrayOf(own, `blows[${i}].points`));
        return { restitution: 0, ...blow, firstPoint, pointCount: own.length };
      });
      const writeAs = (type) => (p, value, path) => type.write(p, value, path);
      const bodiesAt = list(types.struckBody, bodies, "bodies", write);
      const impulsesAt = core.room(Math.max(1, points.length) * core.numberSize);
      const touching = written(layout.touching, {
        bodies: bodiesAt, bodyCount: bodies.length, blows: list(types.blow, all, "blows", writeAs(types.blow)),
        blowCount: all.length, points: list(types.vector, points, "points", writeAs(types.vector)),
        pointCount: points.length, impulses: impulsesAt }, "touching");
      const passed = answered(layout.passedOn, (p) => ask.call("pass_on", touching, restingSpeed, whole(most, "most"), p));
      const impulses = core.numbers(impulsesAt, points.length);
      return {
        ...passed,
        bodies: layout.readAll(types.struckBody, bodiesAt, bodies.length).map((body) => body.motion),
        impulses: all.map(({ firstPoint, pointCount }) => Array.from(impulses.subarray(firstPoint, firstPoint + pointCount))),
      };
    },
  };
}

/** Bodies that nothing touches, as plain objects. */
export function freeMotion(core, layout, dimension) {
  const { types, args, ask, pose, turnOf, inverseInertiaOf } = dimension;
  const { written, answered } = args;
  const at = (body) => written(types.freeBody, body, "body");
  /** A turning as an argument: vectors are passed by pointer, numbers as they are. */
  const turning = (value) => (types.turning === layout.num ? value : written(types.turning, value, "angular"));
  return {
    freeBody(given) {
      const names = ["translation", "rotation", ...freeMembers];
      const { inertia, linear, angular, ...place } = membersOf(given, "body", names);
      if (inertia === undefined) throw new InvalidValue(`body.inertia: expected a value, got ${shown(inertia)}`);
      const { translation, rotation } = types.pose.read(pose(place, "body"));
      const p = at({ center: translation, rotation, linear, inverseInertia: inverseInertiaOf(inertia) });
      ask.call("free_set_angular_velocity", p, turning(turnOf(angular)));
      return types.freeBody.read(p);
    },
    advance(body, duration, acceleration = undefined) {
      const p = at(body);
      const pull = core.room(types.vector.size);
      if (acceleration !== undefined) types.vector.write(pull, acceleration, "acceleration");
      ask.call("free_advance", p, pull, duration);
      return types.freeBody.read(p);
    },
    angularVelocity: (body) => answered(types.turning, (p) => ask.call("free_angular_velocity", at(body), p)),
  };
}
