// Shapes, poses and numbers in the module's memory: the arguments of every query.

import { AnyHandle, arrayOf, finite, InvalidValue, membersOf, number, shown, whole } from "./core.js";
import { named } from "./layout.js";
import { addMethods, spaceMeasures } from "./measures.js";

const kinds = [
  "sphere", "capsule", "box", "rectangle", "cylinder", "ellipsoid", "segment", "triangle", "convexHull", "userConvex",
  "halfSpace", "mesh", "heightField", "compound"];
const noTurn = [0, 0, 0, 1];
const origin = [0, 0, 0];
export const sides = ["both", "front"];
/** The arrays whose elements are numbers, whatever they hold. */
const plainNumbers = new Set([
  Float32Array, Float64Array, Int8Array, Uint8Array, Uint8ClampedArray, Int16Array, Uint16Array, Int32Array, Uint32Array]);

/** The members that a body that moves has besides those of its pose, and a body of a world. */
export const movingMembers = ["shape", "linear", "angular"];
export const bodyMembers = [...movingMembers, "filter", "fixed", "trigger", "fast"];

/** The members of a pose, absent ones by `origin` and `rest`. An object of another kind, or with a member that is
 * neither a pose's nor one of `besides`, is refused: a pose that is not understood would stand at the origin. */
export function placed(value = {}, path, besides, origin, rest) {
  const names = ["translation", "rotation", ...besides];
  const { translation = origin, rotation = rest } =
    membersOf(value, path, names, "an object with a translation and a rotation");
  return { translation, rotation };
}

/** Arguments of the C interface in scratch room, and its answers. Used inside a frame. */
export function argumentsOf(core, layout) {
  const written = (type, value, path) => {
    const p = core.room(type.size);
    type.write(p, value, path);
    return p;
  };
  /** A pose, in an object that may have the members `besides`. */
  const pose = (value, path, besides = []) =>
    written(layout.pose, placed(value, path, besides, origin, noTurn), path);
  /** Writes `values`, numbers or arrays of `width` numbers, one behind the other; returns their place and number. */
  const rows = (values, width, path, View = core.Numbers) => {
    if (values instanceof AnyHandle)
      throw new InvalidValue(`${path}: expected an array, or Numbers of this entry, got ${shown(values)}`);
    arrayOf(values, path);
    const nested = values.length > 0 && typeof values[0] === "object" && values[0] !== null;
    const length = nested ? values.length * width : values.length;
    if (length % width !== 0)
      throw new InvalidValue(`${path}: expected a multiple of ${width} numbers, got ${length}`);
    const p = core.room(Math.max(1, length) * View.BYTES_PER_ELEMENT);
    const to = new View(core.memory().buffer, p, length);
    const checked = View === Uint32Array ? whole : number;
    const set = (from, at, name) => {
      if (!(from instanceof View || (checked === number && plainNumbers.has(from.constructor))))
        for (let i = 0; i < from.length; ++i) checked(from[i], `${name}[${i}]`);
      to.set(from, at);
    };
    if (!nested) set(values, 0, path);
    else
      // By places, so that those where nothing stands are met as well.
      for (let i = 0; i < values.length; ++i) {
        const row = values[i];
        if (row?.length !== width)
          throw new InvalidValue(`${path}[${i}]: expected ${width} numbers, got ${row?.length ?? shown(row)}`);
        set(row, i * width, `${path}[${i}]`);
      }
    return { pointer: p, count: length / width };
  };
  /** Calls a function with a place for one answer, and reads it. */
  const answered = (type, call) => {
    const p = core.room(type.size);
    call(p);
    return type.read(p);
  };
  return { written, pose, rows, answered, vec3: (v, path) => written(layout.vec3, v, path) };
}

/** The values of an object, numbers that are named below `path`. */
export const numbers = (path, values) =>
  Object.entries(values).map(([name, value]) => number(value, `${path}.${name}`));

/** The pointer that `make` writes to its argument. Where it throws, as it does for an exception of a callback, a shape
 * that was made by then is given back. */
export function newShape(core, release, make) {
  return core.frame(() => {
    const result = core.room(4);
    try {
      make(result);
    } catch (error) {
      const pointer = core.memory().getUint32(result, true);
      if (pointer !== 0) release(pointer);
      throw error;
    }
    return core.data.getUint32(result, true);
  });
}

/** A convex shape whose support function is the caller's, made by the module's function of that name. */
export function userConvex(core, release, name, support) {
  if (typeof support !== "function")
    throw new InvalidValue(`userConvex.support: expected a function, got ${shown(support)}`);
  const key = core.keep(support);
  try {
    const make = core.exports[`graze_js_${name}_${core.scalar}`];
    return newShape(core, release, (result) => core.check(make(key, result)));
  } catch (error) {
    core.callbacks.delete(key); // the shape that would have released it is not there
    throw error;
  }
}

export function shapeClasses(core, layout, args, Handle) {
  const { vec3, pose, rows, answered, written } = args;
  const release = (pointer) => core.exports[`graze_shape_release_${core.scalar}`](pointer);
  /** A new shape by the constructor of that name; the others are its arguments. */
  const made = (name, parameters) =>
    newShape(core, release, (result) => core.call(`shape_${name}`, ...parameters(), result));

  class Shape extends Handle {
    constructor(pointer) {
      if (typeof pointer !== "number") throw new TypeError("graze: a Shape is made by one of its classes");
      super(pointer, release);
    }
    get kind() {
      return core.frame(() => kinds[answered(layout.i32, (p) => core.call("shape_kind", of(this), p))]);
    }
    get rounding() {
      return core.frame(() => answered(layout.num, (p) => core.call("shape_rounding", of(this), p)));
    }
    bounds(at) {
      return core.frame(() => answered(layout.aabb, (p) => core.call("shape_bounds", of(this), pose(at, "pose"), p)));
    }
    support(direction) {
      return core.frame(() =>
        answered(layout.vec3, (p) => core.call("shape_support", of(this), vec3(direction, "direction"), p)));
    }
    massProperties() {
      return core.frame(() =>
        answered(layout.massProperties, (p) => core.call("shape_mass_properties", of(this), p)));
    }
    rounded(rounding) {
      return new Shape(made("rounded", () => [of(this), number(rounding, "rounding")]));
    }
    swept(at, motion) {
      return new Shape(made("swept", () => [of(this), pose(at, "pose"), vec3(motion, "motion")]));
    }
  }
  const of = (shape, path = "shape") => Handle.pointer(shape, path, Shape);
  addMethods(core, Shape, spaceMeasures(core, layout, (pointer) => new Shape(pointer)), of);

  class Sphere extends Shape {
    constructor(radius, center = origin) {
      super(made("sphere", () => [number(radius, "sphere.radius"), vec3(center, "sphere.center")]));
    }
  }
  class Capsule extends Shape {
    constructor(height, radiusBottom, radiusTop = radiusBottom) {
      super(made("capsule", () => numbers("capsule", { height, radiusBottom, radiusTop })));
    }
  }
  class Box extends Shape {
    constructor(size) {
      super(made("box", () => [vec3(size, "box.size")]));
    }
  }
  class Rectangle extends Shape {
    constructor(sizeX, sizeZ) {
      super(made("rectangle", () => numbers("rectangle", { sizeX, sizeZ })));
    }
  }
  class Cylinder extends Shape {
    constructor(height, radiusBottom, radiusTop = radiusBottom) {
      super(made("cylinder", () => numbers("cylinder", { height, radiusBottom, radiusTop })));
    }
  }
  class Ellipsoid extends Shape {
    constructor(radii) {
      super(made("ellipsoid", () => [vec3(radii, "ellipsoid.radii")]));
    }
  }
  class Segment extends Shape {
    constructor(a, b) {
      super(made("segment", () => [vec3(a, "segment.a"), vec3(b, "segment.b")]));
    }
  }
  class Triangle extends Shape {
    constructor(a, b, c) {
      super(made("triangle", () => [vec3(a, "triangle.a"), vec3(b, "triangle.b"), vec3(c, "triangle.c")]));
    }
  }
  class HalfSpace extends Shape {
    constructor() {
      super(made("half_space", () => []));
    }
  }
  class ConvexHull extends Shape {
    constructor(points) {
      super(
        made("convex_hull", () => {
          const { pointer, count } = rows(points, 3, "convexHull.points");
          return [pointer, 0, count];
        }),
      );
    }
  }
  class UserConvex extends Shape {
    constructor(support) {
      super(userConvex(core, release, "user_convex", support));
    }
  }
  class Mesh extends Shape {
    constructor(points, triangles, given) {
      super(
        made("mesh", () => {
          const options = membersOf(given, "mesh.options", ["sides", "solid"]);
          const corners = rows(points, 3, "mesh.points");
          const faces = rows(triangles, 3, "mesh.triangles", Uint32Array);
          const seen = named(sides, options.sides ?? "both", "mesh.sides");
          return [corners.pointer, 0, corners.count, faces.pointer, 0, faces.count, seen, options.solid ? 1 : 0];
        }),
      );
    }
    findings() {
      return core.frame(() => answered(layout.findings, (p) => core.call("shape_findings", of(this), p)));
    }
  }
  class HeightField extends Shape {
    constructor(heights, columns, rowCount, given) {
      super(
        made("height_field", () => {
          const options = membersOf(given, "heightField.options", ["spacing", "sides"]);
          whole(columns, "heightField.columns");
          whole(rowCount, "heightField.rowCount");
          if (heights?.length !== columns * rowCount)
            throw new InvalidValue(
              `heightField.heights: expected ${columns} * ${rowCount} numbers, got ${heights?.length ?? shown(heights)}`);
          // A value that is no number is a hole, and null would become 0.
          const values = Array.isArray(heights) ? heights.map((h) => h ?? NaN) : heights;
          const [sizeX, sizeZ] = options.spacing ?? [1, 1];
          const spacing = [number(sizeX, "heightField.spacing[0]"), number(sizeZ, "heightField.spacing[1]")];
          const seen = named(sides, options.sides ?? "both", "heightField.sides");
          const { pointer } = rows(values, 1, "heightField.heights");
          return [pointer, 0, columns, rowCount, 0, ...spacing, seen];
        }),
      );
    }
  }
  class Compound extends Shape {
    constructor(children) {
      super(
        made("compound", () => {
          const size = layout.child.size;
          const first = core.room(Math.max(1, arrayOf(children, "compound.children").length) * size);
          children.forEach((child, i) => {
            const path = `compound.children[${i}]`;
            const at = pose(child, path, ["shape"]);
            layout.child.write(first + i * size, { shape: of(child.shape, `${path}.shape`) }, path);
            core.copy(at, first + i * size + layout.child.offset.pose, layout.pose.size);
          });
          return [first, 0, children.length];
        }),
      );
    }
  }

  /** Numbers in the module's memory. */
  class Numbers extends Handle {
    constructor(length) {
      whole(length, "numbers.length");
      core.memory();
      const pointer = core.allocate(Math.max(1, length) * core.numberSize);
      super(pointer, (p) => core.exports.free(p));
      this.length = length;
      this.array.fill(0);
    }
    get array() {
      return core.numbers(Handle.pointer(this, "numbers", Numbers), this.length);
    }
  }
  /** The place of the numbers of a `Numbers`, or of those of an array once they are copied in. */
  const numbersOf = (values, width, path) => {
    if (!(values instanceof Numbers)) return rows(values, width, path);
    if (values.length % width !== 0)
      throw new InvalidValue(`${path}: expected a multiple of ${width} numbers, got ${values.length}`);
    return { pointer: Handle.pointer(values, path, Numbers), count: values.length / width };
  };

  const turned = (translation, axis, angle) => {
    finite(angle, "angle");
    const length = Math.hypot(...Array.from(arrayOf(axis, "axis")));
    if (!(length > 0 && length < Infinity))
      throw new InvalidValue(`axis: expected a finite vector that is not zero, got [${Array.from(axis).join(", ")}]`);
    return core.frame(() => {
      const unit = Array.from(axis, (x) => x / length);
      const turn = core.exports[`graze_pose_turned_${core.scalar}`];
      return answered(layout.pose, (p) => turn(p, vec3(translation, "translation"), vec3(unit, "axis"), angle));
    });
  };

  return {
    classes: {
      Shape, Sphere, Capsule, Box, Rectangle, Cylinder, Ellipsoid, Segment, Triangle, HalfSpace, ConvexHull, UserConvex,
      Mesh, HeightField, Compound, Numbers, turned },
    of,
    numbersOf,
    written,
  };
}
