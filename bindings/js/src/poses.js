// Poses as plain objects: composed, inverted, and applied to points, with the bits that C++ has for them (pose.hpp,
// plane/pose2.hpp).

import { InvalidValue } from "./core.js";

/** The largest difference from 1 of the squared length of a rotation, as the C interface has it. */
const unitSlack = 1e-2;

/** A rotation, where it is of unit length. */
function unit(rotation, path) {
  const squared = rotation.reduce((sum, x) => sum + x * x, 0);
  if (!(Math.abs(squared - 1) <= unitSlack))
    throw new InvalidValue(`${path}.rotation: expected a quaternion of unit length, got [${rotation.join(", ")}]`);
  return rotation;
}

/** Arithmetic of vectors in which each operation is rounded to the entry's scalar, as the processor does for C++. */
const sums = (scalar) => {
  const r = scalar === "f" ? Math.fround : (x) => x;
  return {
    r,
    add: (a, b) => a.map((x, i) => r(x + b[i])),
    subtract: (a, b) => a.map((x, i) => r(x - b[i])),
    times: (a, s) => a.map((x) => r(x * s)),
    /** a b + c d, and a b - c d. */
    plus: (a, b, c, d) => r(r(a * b) + r(c * d)),
    minus: (a, b, c, d) => r(r(a * b) - r(c * d)),
  };
};

/** The functions of a dimension, by what turns its vectors; `read` has a pose as numbers of the entry, `point` a point, and
 * `shown` makes the caller's form of a pose. */
const posesBy = ({ add, subtract }, { rotate, product, conjugate }, { read, point, shown }) => {
  const transformed = (pose, p) => add(pose.translation, rotate(pose.rotation, p));
  const back = (pose, p) => rotate(conjugate(pose.rotation), subtract(p, pose.translation));
  return {
    transform: (pose, p) => transformed(read(pose, "pose"), point(p, "point")),
    inverseTransform: (pose, p) => back(read(pose, "pose"), point(p, "point")),
    compose(poseA, poseB) {
      const [a, b] = [read(poseA, "a"), read(poseB, "b")];
      return shown({ translation: transformed(a, b.translation), rotation: product(a.rotation, b.rotation) });
    },
    relative(poseA, poseB) {
      const [a, b] = [read(poseA, "a"), read(poseB, "b")];
      const rotation = product(conjugate(a.rotation), b.rotation);
      return shown({ translation: back(a, b.translation), rotation });
    },
    inverse(pose) {
      const { translation, rotation } = read(pose, "pose");
      const turned = conjugate(rotation);
      return shown({ translation: rotate(turned, translation.map((x) => -x)), rotation: turned });
    },
  };
};

/** The functions of space, whose rotations are quaternions. */
export function poses(core, layout, args) {
  const sum = sums(core.scalar);
  const { r, add, times, plus, minus } = sum;
  const cross = ([a, b, c], [x, y, z]) => [minus(b, z, c, y), minus(c, x, a, z), minus(a, y, b, x)];
  const rotate = (q, v) => {
    const u = q.slice(0, 3);
    const t = times(cross(u, v), 2);
    return add(add(v, times(t, q[3])), cross(u, t));
  };
  const product = (p, q) => {
    const [a, b] = [p.slice(0, 3), q.slice(0, 3)];
    const dot = r(plus(a[0], b[0], a[1], b[1]) + r(a[2] * b[2]));
    return [...add(add(times(b, p[3]), times(a, q[3])), cross(a, b)), r(r(p[3] * q[3]) - dot)];
  };
  const conjugate = ([x, y, z, w]) => [-x, -y, -z, w];
  const read = (value, path) => {
    const { translation, rotation } = layout.pose.read(args.pose(value, path));
    return { translation, rotation: unit(rotation, path) };
  };
  const point = (value, path) => layout.vec3.read(args.vec3(value, path));
  return posesBy(sum, { rotate, product, conjugate }, { read, point, shown: (pose) => pose });
}

/** Those of the plane, whose rotations are the cosine and the sine of an angle. */
export function planePoses(core, { types, args, pose, shown }) {
  const sum = sums(core.scalar);
  const { plus, minus } = sum;
  const rotate = ([cosine, sine], [x, y]) => [minus(cosine, x, sine, y), plus(sine, x, cosine, y)];
  const conjugate = ([cosine, sine]) => [cosine, -sine];
  const read = (value, path) => types.pose.read(pose(value, path));
  const point = (value, path) => types.vector.read(args.written(types.vector, value, path));
  return posesBy(sum, { rotate, product: rotate, conjugate }, { read, point, shown });
}
