// The layers of a convex hull, and the vertices that its support queries look at.

export function hullLayering(core, layout, args, ask, shapes) {
  const { of } = shapes;
  const call = (name, ...parameters) => core.call(`hull_${name}`, ...parameters);
  /** A copy of numbers that belong to the buffer until the next question. */
  const copied = (Numbers, first, count) => new Numbers(core.data.buffer, first, count).slice();

  const vertices = (shape) => {
    const [first, count] = [core.room(4), core.room(4)];
    call("vertices", of(shape), first, count);
    return layout.readAll(layout.vec3, core.data.getUint32(first, true), core.data.getUint32(count, true));
  };
  const layer = ({ vertices: first, vertexCount, edges, edgeCount }) => ({
    vertices: copied(Uint32Array, first, vertexCount),
    edges: copied(Uint32Array, edges, 2 * edgeCount),
  });
  const step = ({ vertices: size, lookedAt, along, lookedAtCount, winner }) => ({
    vertices: size,
    winner,
    lookedAt: copied(Uint32Array, lookedAt, lookedAtCount),
    along: copied(Float64Array, along, lookedAtCount),
  });
  return {
    hullLayers: (shape) =>
      core.frame(() => ({
        vertices: vertices(shape),
        layers: ask.listed(layout.hullLayer, (...to) => call("layers", of(shape), ...to)).map(layer),
      })),
    tracedSupport: (shape, direction) => {
      const answer = shape.support(direction);
      return core.frame(() => {
        const steps = args.answered(layout.supportTrace, (p) =>
          call("support", of(shape), args.vec3(direction, "direction"), ask.room(), p));
        const { vertex, scanned, products, layers, layerCount } = steps;
        return {
          answer, trace: { vertex, scanned, products, layers: layout.readAll(layout.supportLayer, layers, layerCount).map(step) } };
      });
    },
  };
}
