// The layers of a convex hull, and what its support queries look at.

export function hullLayering(core, layout, args, shapes) {
  const { of } = shapes;
  /** Where what the function answers begins, and how many there are of it. */
  const asked = (name, ...parameters) => {
    const [first, count] = [core.room(4), core.room(4)];
    core.check(core.exports[`graze_js_hull_${name}_${core.scalar}`](...parameters, first, count));
    return [core.data.getUint32(first, true), core.data.getUint32(count, true)];
  };
  /** A reader of numbers that belong to the module until the next question. */
  const numbers = ([first, count]) => {
    const all = new Uint32Array(core.data.buffer, first, count);
    let at = 0;
    return { more: () => at < count, next: () => all[at++], take: (n) => all.slice(at, (at += n)) };
  };
  return {
    hullLayers: (shape) =>
      core.frame(() => {
        const vertices = layout.readAll(layout.vec3, ...asked("vertices", of(shape)));
        const from = numbers(asked("layers", of(shape)));
        const layers = [];
        while (from.more()) {
          const [count, edges] = [from.next(), from.next()];
          layers.push({ vertices: from.take(count), edges: from.take(2 * edges) });
        }
        return { vertices, layers };
      }),
    tracedSupport: (shape, direction) => {
      const answer = shape.support(direction);
      return core.frame(() => {
        const from = numbers(asked("support", of(shape), args.vec3(direction, "direction")));
        const trace = { vertex: from.next(), scanned: from.next() !== 0, products: from.next(), layers: [] };
        const along = new Float64Array(core.data.buffer, ...asked("products"));
        for (let looked = 0; from.more(); ) {
          const [vertices, winner, count] = [from.next(), from.next(), from.next()];
          trace.layers.push({ vertices, winner, lookedAt: from.take(count), along: along.slice(looked, (looked += count)) });
        }
        return { answer, trace };
      });
    },
  };
}
