// The broad phases, each by itself: boxes and their numbers in, pairs out.

import { whole } from "./core.js";
import { named } from "./layout.js";

const kinds = ["dynamicTree", "sortAndSweep", "sweepAndPrune", "hashedGrid", "looseOctree", "bsp"];

export function broadPhases(core, layout, args, ask, Handle) {
  const { written } = args;
  const call = (name, ...parameters) => core.call(`broad_phase_${name}`, ...parameters);
  const box = (lower, upper) => written(layout.aabb, { lower, upper }, "box");

  class BroadPhase extends Handle {
    #boxes = 0;
    #pairs = 0;
    constructor(kind = "dynamicTree") {
      super(
        core.frame(() => {
          const result = core.room(4);
          call("create", named(kinds, kind, "broadPhase.kind"), result);
          return core.data.getUint32(result, true);
        }),
        (p) => core.exports[`graze_broad_phase_destroy_${core.scalar}`](p),
      );
      this.kind = kind;
    }
    insert(id, lower, upper) {
      core.frame(() => call("insert", changed(this), whole(id, "id"), box(lower, upper)));
      this.#boxes += 1;
    }
    move(id, lower, upper) {
      core.frame(() => call("move", changed(this), whole(id, "id"), box(lower, upper)));
    }
    remove(id) {
      core.frame(() => call("remove", changed(this), whole(id, "id")));
      this.#boxes -= 1;
    }
    pairs() {
      return this.#found("pairs");
    }
    movedPairs() {
      return this.#found("moved_pairs");
    }
    query(lower, upper) {
      return core.frame(() => ids(1, (...to) => call("query", at(this), box(lower, upper), ...to)));
    }
    sweep(lower, upper, motion) {
      return core.frame(() =>
        ids(1, (...to) => call("sweep", at(this), box(lower, upper), args.vec3(motion, "motion"), ...to)));
    }
    parts() {
      return core.frame(() => {
        const all = ask.listed(layout.broadPhasePart, (...to) => call("parts", at(this), ...to));
        return all.map(({ box: bounds, depth }) => ({ ...bounds, depth }));
      });
    }
    counts() {
      return core.frame(() => {
        const [tests, bytes] = [core.room(8), core.room(4)];
        call("counts", at(this), tests, bytes);
        return {
          boxes: this.#boxes, pairs: this.#pairs, tests: Number(core.data.getBigUint64(tests, true)),
          memory: core.data.getUint32(bytes, true) };
      });
    }
    #found(name) {
      const found = core.frame(() => ids(2, (...to) => call(name, at(this), ...to)));
      this.#pairs = found.length / 2;
      return found;
    }
  }
  /** A copy of numbers that belong to the buffer until the next query: `each` of them for an answer. */
  const ids = (each, body) => {
    const [first, count] = ask.place(body);
    return new Uint32Array(core.data.buffer, first, each * count).slice();
  };
  const at = (broad) => Handle.pointer(broad, "broadPhase", BroadPhase);
  const changed = (broad) => Handle.changed(broad, "broadPhase", BroadPhase);
  return { BroadPhase };
}
