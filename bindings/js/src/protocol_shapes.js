// Shapes in the words of the query protocol.

const decoder = new TextDecoder();

/** A function that writes shapes; `name` is that of the module's, `of` the shape's pointer. */
export const protocolShapes = (core, name, of) => (shape) =>
  core.frame(() => {
    const [first, count] = [core.room(4), core.room(4)];
    core.check(core.exports[`graze_js_${name}_${core.scalar}`](of(shape), first, count));
    const bytes = new Uint8Array(core.data.buffer, core.data.getUint32(first, true), core.data.getUint32(count, true));
    return JSON.parse(decoder.decode(bytes));
  });

/** A function that reads shapes, as `Shape`s. */
export const shapesOfProtocol = (core, name, Shape) => (words) => {
  const pointer = core.frame(() => {
    const shape = core.room(4);
    core.check(core.exports[`graze_js_${name}_${core.scalar}`](core.written(JSON.stringify(words) ?? "", "shape"), shape));
    return core.data.getUint32(shape, true);
  });
  return new Shape(pointer);
};
