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
