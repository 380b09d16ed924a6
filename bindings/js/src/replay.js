// Captures played again.

/** What the module calls after each frame. */
export function replayImports(core) {
  return {
    frame: (key, frame, world, planeWorld) =>
      core.called(key, undefined, (each) => each(frame >>> 0, world >>> 0, planeWorld >>> 0)),
  };
}

export function replays(core, layout, worlds, planeWorlds) {
  /** Where a copy of the caller's bytes is, and how many. */
  const copied = (bytes) => {
    const from = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, bytes.byteLength);
    const place = core.room(Math.max(1, from.length));
    new Uint8Array(core.memory().buffer).set(from, place);
    return [place, from.length];
  };
  return {
    captureHead: (bytes) =>
      core.frame(() => {
        const head = core.room(layout.captureHead.size);
        core.check(core.exports.graze_capture_head(...copied(bytes), head));
        const { simulation, plane, single } = layout.captureHead.read(head);
        return { simulation, plane, scalar: single ? "float" : "double" };
      }),
    replay: (bytes, each) =>
      core.frame(() => {
        const from = copied(bytes);
        let pointer = 0;
        const there = () => {
          if (pointer === 0) throw new Error("graze: the world of a replay is there until its function returns");
          return pointer;
        };
        const world = worlds.questionable({}, there);
        const planeWorld = planeWorlds.questionable({}, there);
        const key = core.keep((frame, ofSpace, ofPlane) => {
          const flat = ofSpace === 0;
          pointer = flat ? ofPlane : ofSpace;
          try {
            each?.(flat ? planeWorld : world, frame, flat);
          } finally {
            pointer = 0;
          }
        });
        const p = core.room(layout.replayReport.size);
        try {
          core.call("replay", ...from, core.exports.graze_js_frame(), key, p);
        } finally {
          core.callbacks.delete(key);
        }
        const { simulation, plane, cut, differs, frame, call, frames, calls } = layout.replayReport.read(p);
        const what = core.string(p + layout.replayReport.offset.what);
        return { simulation, plane, cut, frames, calls, difference: differs ? { frame, call, what } : null };
      }),
  };
}
