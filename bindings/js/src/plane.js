// The functions and classes of the package in two dimensions.

import { batches } from "./batches.js";
import { arrayOf, finite, InvalidValue, membersOf, number, shown } from "./core.js";
import { drawings, tessellations, worldDrawings } from "./draw.js";
import { named } from "./layout.js";
import { addMethods, planeMeasures } from "./measures.js";
import { freeMotion, passing } from "./motion.js";
import { planePoses } from "./poses.js";
import { protocolShapes } from "./protocol_shapes.js";
import { questions } from "./questions.js";
import { movingMembers, newShape, numbers, placed, sides, userConvex } from "./shapes.js";
import { simulationClasses } from "./simulation.js";
import { worldClasses } from "./world.js";

const kinds = [
  "circle", "capsule", "box", "segment", "convex", "ellipse", "userConvex", "halfPlane", "polygon", "chain", "compound"];
const origin = [0, 0];

export function plane(core, layout, args, numbersOf, Rows, Handle) {
  const { written, rows, answered } = args;
  const types = layout.plane;
  const release = (pointer) => core.exports[`graze_plane_shape_release_${core.scalar}`](pointer);
  const made = (name, parameters) =>
    newShape(core, release, (result) => core.call(`plane_shape_${name}`, ...parameters(), result));
  const vec2 = (v, path) => written(layout.vec2, v, path);
  /** A pose of the C interface, whose rotation is the turned X axis, by the library's own sine and cosine. */
  const pose = (value, path, besides = []) => {
    const { translation, rotation } = placed(value, path, besides, origin, 0);
    const p = core.room(types.pose.size);
    core.exports[`graze_plane_pose_${core.scalar}`](p, 0, 0, finite(rotation, `${path}.rotation`));
    layout.vec2.write(p, translation, `${path}.translation`);
    return p;
  };

  class Shape extends Handle {
    constructor(pointer) {
      if (typeof pointer !== "number") throw new TypeError("graze: a Shape is made by one of its classes");
      super(pointer, release);
    }
    get kind() {
      return core.frame(() => kinds[answered(layout.i32, (p) => core.call("plane_shape_kind", of(this), p))]);
    }
    get rounding() {
      return core.frame(() => answered(layout.num, (p) => core.call("plane_shape_rounding", of(this), p)));
    }
    bounds(at) {
      return core.frame(() =>
        answered(types.aabb, (p) => core.call("plane_shape_bounds", of(this), pose(at, "pose"), p)));
    }
    support(direction) {
      return core.frame(() =>
        answered(layout.vec2, (p) => core.call("plane_shape_support", of(this), vec2(direction, "direction"), p)));
    }
    massProperties() {
      return core.frame(() =>
        answered(types.massProperties, (p) => core.call("plane_shape_mass_properties", of(this), p)));
    }
    rounded(rounding) {
      return new Shape(made("rounded", () => [of(this), number(rounding, "rounding")]));
    }
    swept(at, motion) {
      return new Shape(made("swept", () => [of(this), pose(at, "pose"), vec2(motion, "motion")]));
    }
  }
  const of = (shape, path = "shape") => Handle.pointer(shape, path, Shape);
  /** An outline as arguments: the place of its points, and their number. */
  const outline = (points, path) => {
    const { pointer, count } = rows(points, 2, path);
    return [pointer, 0, count];
  };

  class Circle extends Shape {
    constructor(radius) {
      super(made("circle", () => numbers("circle", { radius })));
    }
  }
  class Capsule extends Shape {
    constructor(height, radiusBottom, radiusTop = radiusBottom) {
      super(made("capsule", () => numbers("capsule", { height, radiusBottom, radiusTop })));
    }
  }
  class Box extends Shape {
    constructor(size) {
      super(made("box", () => [vec2(size, "box.size")]));
    }
  }
  class Segment extends Shape {
    constructor(a, b) {
      super(made("segment", () => [vec2(a, "segment.a"), vec2(b, "segment.b")]));
    }
  }
  class Convex extends Shape {
    constructor(points) {
      super(made("convex", () => outline(points, "convex.points")));
    }
  }
  class Ellipse extends Shape {
    constructor(radii) {
      super(made("ellipse", () => [vec2(radii, "ellipse.radii")]));
    }
  }
  class UserConvex extends Shape {
    constructor(support) {
      super(userConvex(core, release, "plane_user_convex", support));
    }
  }
  class HalfPlane extends Shape {
    constructor() {
      super(made("half_plane", () => []));
    }
  }
  class Polygon extends Shape {
    constructor(points) {
      super(made("polygon", () => outline(points, "polygon.points")));
    }
  }
  class Chain extends Shape {
    constructor(points, given) {
      super(
        made("chain", () => {
          const options = membersOf(given, "chain.options", ["sides", "closed"]);
          const seen = named(sides, options.sides ?? "both", "chain.sides");
          return [...outline(points, "chain.points"), options.closed ? 1 : 0, seen];
        }),
      );
    }
  }
  class Compound extends Shape {
    constructor(children) {
      super(
        made("compound", () => {
          const { size, offset } = types.child;
          const first = core.room(Math.max(1, arrayOf(children, "compound.children").length) * size);
          children.forEach((child, i) => {
            const path = `compound.children[${i}]`;
            const at = pose(child, path, ["shape"]);
            types.child.write(first + i * size, { shape: of(child.shape, `${path}.shape`) });
            core.copy(at, first + i * size + offset.pose, types.pose.size);
          });
          return [first, 0, children.length];
        }),
      );
    }
  }

  const ask = questions(core, layout, { prefix: "plane_", types, args, of, pose });
  const angle = ({ translation, rotation }) => ({ translation, rotation: Math.atan2(rotation[1], rotation[0]) });
  const dimension = {
    prefix: "plane_", types, args, of, Shape, pose, shown: angle, turning: (value) => value, numbersOf, ask };
  const measures = { shown: angle, room: ask.room, made: (pointer) => new Shape(pointer) };
  addMethods(core, Shape, planeMeasures(core, layout, measures), of);
  const worlds = worldClasses(core, layout, dimension, Rows, Handle);
  const simulations = simulationClasses(core, layout, dimension, worlds, Handle);

  // The first is of space alone.
  const { compactContactsBatch, ...batched } = batches(core, layout, dimension, Rows, Handle);
  const inverseMass = (body, path) => {
    const { mass, inertia, shape } = body;
    if (!(mass > 0)) throw new InvalidValue(`${path}.mass: expected a number > 0, got ${shown(mass)}`);
    const whole = inertia ?? (shape === undefined ? Infinity : inertiaOf(shape, mass, path));
    if (!(whole > 0)) throw new InvalidValue(`${path}.inertia: expected a number > 0, got ${shown(whole)}`);
    return { mass: 1 / mass, inertia: 1 / whole };
  };
  const inertiaOf = (shape, mass, path) => {
    const { area, inertia } = answered(types.massProperties, (p) =>
      core.call("plane_shape_mass_properties", of(shape, `${path}.shape`), p));
    return mass === Infinity ? mass : (mass * inertia) / area;
  };
  const motion = { ...dimension, inverseMass, turnOf: (turn) => turn ?? 0, inverseInertiaOf: (inertia) => 1 / inertia };

  const names = {
    World: worlds.World, ...simulations.names,
    Shape, Circle, Capsule, Box, Segment, Convex, Ellipse, UserConvex, HalfPlane, Polygon, Chain, Compound,
    ...ask.framed({
      ...ask.asked,
      ...ask.untraced,
      ...batched,
      ...passing(core, layout, motion),
      ...freeMotion(core, layout, motion),
      ...tessellations(core, layout, dimension),
      ...planePoses(core, dimension),
      alongLines(motion, normals) {
        const question = [vec2(motion, "motion"), ...outline(normals, "normals")];
        return answered(layout.vec2, (p) => ask.call("along_lines", ...question, p));
      },
      poseAt(body = {}, t) {
        const { linear, angular } = body;
        const velocity = written(types.velocity, { linear, angular }, "velocity");
        return angle(answered(types.pose, (p) => ask.call("pose_at", pose(body, "pose", movingMembers), velocity, t, p)));
      },
    }),
    protocolShape: protocolShapes(core, "plane_shape_text", of),
    traced: ask.traced(),
    draw: ask.framed({
      ...drawings(core, layout, dimension), ...worldDrawings(core, layout, dimension, worlds, simulations) }),
  };
  return { names, worlds, simulations };
}
