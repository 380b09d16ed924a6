// Captures: written while a world or a simulation is changed, and played again.

import { InvalidValue, shown } from "./core.js";

/** The functions that the module calls with the bytes of each frame, and after each frame that is played. */
export function captureImports(core) {
  return {
    write: (key, bytes, size) =>
      core.called(key, 0, (capture) => {
        capture(new Uint8Array(core.memory().buffer, bytes >>> 0, size >>> 0).slice());
        return 1;
      }),
    frame: (key, frame, world, planeWorld) =>
      core.called(key, undefined, (each) => each(frame >>> 0, world >>> 0, planeWorld >>> 0)),
  };
}

/** A function that gives a world or a simulation back, and holds no more than it needs for that: not the settings. */
const releasing = (core, name, key) => (pointer) => {
  core.exports[`graze_${name}_destroy_${core.scalar}`](pointer);
  core.callbacks.delete(key);
  core.thrown = null; // no caller is there to catch it
};

/**
 * The pointer of a new world or simulation, and the function that gives it back; `name` is that of its functions,
 * `settings` writes its settings. A captured one where `capture` is a function.
 */
export function created(core, name, settings, capture) {
  const key = capture === undefined ? null : core.keep(capture);
  const make = () => {
    const result = core.room(4);
    if (key === null) core.call(`${name}_create`, settings(), 0, result);
    else core.call(`${name}_create_captured`, settings(), 0, core.exports.graze_js_write(), key, result);
    return core.data.getUint32(result, true);
  };
  try {
    if (key !== null && core.exports[`graze_${name}_create_captured_${core.scalar}`] === undefined)
      throw new InvalidValue("capture: expected none in graze/queries, got a function");
    return [core.frame(make), releasing(core, name, key)];
  } catch (error) {
    core.callbacks.delete(key);
    throw error;
  }
}

/** The place of a copy of the caller's bytes in the module's memory, and their number. */
export function copied(core, bytes) {
  if (!Number.isInteger(bytes?.byteLength))
    throw new InvalidValue(`bytes: expected an ArrayBuffer or a view of one, got ${shown(bytes)}`);
  const from = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, bytes.byteLength);
  const place = core.room(Math.max(1, from.length));
  new Uint8Array(core.memory().buffer).set(from, place);
  return [place, from.length];
}

/** The bytes that the module writes while `write(function, key)` calls it with these two. */
export function bytesWritten(core, write) {
  let all = null;
  const key = core.keep((bytes) => (all = bytes));
  try {
    write(core.exports.graze_js_write(), key);
  } finally {
    core.callbacks.delete(key);
  }
  return all;
}

/** The function that plays captures, of the worlds and simulations of either dimension. */
export function replays(core, layout, ofSpace, ofPlane) {
  /** A frame's world and simulation in a dimension, by the pointer of the present world. */
  const shownIn = ({ worlds, simulations }, there) => ({
    world: worlds.questionable({}, there),
    simulation: simulations.questionable({}, () => simulations.ofWorld(there())),
    isPlayed: () => core.frame(() => simulations.ofWorld(there())) !== 0,
  });
  return {
    captureHead: (bytes) =>
      core.frame(() => {
        const head = core.room(layout.captureHead.size);
        core.check(core.exports.graze_capture_head(...copied(core, bytes), head));
        const { simulation, plane, single } = layout.captureHead.read(head);
        return { simulation, plane, scalar: single ? "float" : "double" };
      }),
    replay: (bytes, each) =>
      core.frame(() => {
        const from = copied(core, bytes);
        let pointer = 0;
        const there = () => {
          if (pointer === 0) throw new Error("graze: the world of a replay is there until its function returns");
          return pointer;
        };
        const space = shownIn(ofSpace, there);
        const plane = shownIn(ofPlane, there);
        const key = core.keep((frame, worldOfSpace, worldOfPlane) => {
          const flat = worldOfSpace === 0;
          const { world, simulation, isPlayed } = flat ? plane : space;
          pointer = flat ? worldOfPlane : worldOfSpace;
          try {
            each?.(world, frame, flat, isPlayed() ? simulation : null);
          } finally {
            pointer = 0;
          }
        });
        const p = core.room(layout.replayReport.size);
        try {
          core.call("replay", ...from, core.exports.graze_js_frame(), key, p, 0); // on one thread
        } finally {
          core.callbacks.delete(key);
        }
        const { simulation, plane: flat, cut, differs, frame, call, frames, calls } = layout.replayReport.read(p);
        const what = core.string(p + layout.replayReport.offset.what);
        return { simulation, plane: flat, cut, frames, calls, difference: differs ? { frame, call, what } : null };
      }),
  };
}
