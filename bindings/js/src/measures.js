// Measures, points and children of shapes, as they were made of them.

const ends = ({ height, radius, radiusTop }) => ({ height, radiusBottom: radius, radiusTop });
const sized = ({ size }) => ({ size });
const round = ({ radii }) => ({ radii });
const counted = ({ children }) => ({ children });

/** The measures that a kind has, of those of all kinds; kinds without any are not listed. */
const ofSpace = {
  sphere: ({ radius, center }) => ({ radius, center }),
  capsule: ends,
  cylinder: ends,
  box: sized,
  rectangle: ({ size: [sizeX, , sizeZ] }) => ({ sizeX, sizeZ }),
  ellipsoid: round,
  convexHull: ({ tolerance }) => ({ tolerance }),
  mesh: ({ closed, solid, sides }) => ({ closed, solid, sides }),
  heightField: ({ columns, rows, spacing, sides }) => ({ columns, rows, spacing, sides }),
  compound: counted,
};
const ofPlane = {
  circle: ({ radius }) => ({ radius }),
  capsule: ends,
  box: sized,
  ellipse: round,
  chain: ({ closed, sides }) => ({ closed, sides }),
  compound: counted,
};

/** Methods of shapes of a dimension, whose functions' names begin with `prefix`; each takes a shape and its pointer. */
function readers(core, layout, types, { prefix, kinds, measures, shown, made }) {
  const call = (name, ...parameters) => core.call(`${prefix}shape_${name}`, ...parameters);
  const read = (type, name, ...parameters) => {
    const p = core.room(type.size);
    call(name, ...parameters, p);
    return type.read(p);
  };
  const all = (pointer) => read(measures, "measures", pointer);
  return {
    measures(shape, pointer) {
      const { convex, ...every } = all(pointer);
      return { kind: shape.kind, convex, ...kinds[shape.kind]?.(every) };
    },
    children(shape, pointer) {
      // A shape that is no compound is refused by the library, in its words.
      const count = shape.kind === "compound" ? all(pointer).children : 1;
      return Array.from({ length: count }, (_, i) => {
        const { shape: child, pose } = read(types.child, "child", pointer, i);
        return { shape: made(child), ...shown(pose) };
      });
    },
    /** A copy of an array of numbers whose place and length `call` gives, `width` for each. */
    copied(name, Numbers, width, ...parameters) {
      const [first, count] = [core.room(4), core.room(4)];
      call(name, ...parameters, first, count);
      const length = width * core.data.getUint32(count, true);
      return new Numbers(core.memory().buffer, core.data.getUint32(first, true), length).slice();
    },
  };
}

export function spaceMeasures(core, layout, made) {
  const { copied, ...both } = readers(core, layout, layout, {
    prefix: "", kinds: ofSpace, measures: layout.shapeMeasures, shown: (pose) => pose, made });
  return {
    ...both,
    points: (_, pointer) => copied("points", core.Numbers, 3, pointer),
    triangles: (_, pointer) => copied("triangles", Uint32Array, 3, pointer),
    heights: (_, pointer) => copied("heights", core.Numbers, 1, pointer),
  };
}

/** Those of the plane; `room` returns a buffer for points. */
export function planeMeasures(core, layout, { shown, room, made }) {
  const { copied, ...both } = readers(core, layout, layout.plane, {
    prefix: "plane_", kinds: ofPlane, measures: layout.plane.shapeMeasures, shown, made });
  return { ...both, points: (_, pointer) => copied("points", core.Numbers, 2, pointer, room()) };
}

/** Gives a class of shapes those methods; `of` returns a shape's pointer. */
export function addMethods(core, Shape, methods, of) {
  for (const [name, method] of Object.entries(methods))
    Object.defineProperty(Shape.prototype, name, {
      value() {
        return core.frame(() => method(this, of(this)));
      },
    });
}
