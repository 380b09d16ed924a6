// The broad phases, each by itself: boxes and their numbers in, pairs out.

import { named } from "./layout.js";

const kinds = ["dynamicTree", "sortAndSweep", "sweepAndPrune", "hashedGrid", "looseOctree", "bsp"];

export function broadPhases(core, layout, args, Handle) {
  const { written } = args;
  const call = (name, ...parameters) => core.check(core.exports[`graze_js_broad_phase_${name}_${core.scalar}`](...parameters));
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
        (p) => call("destroy", p),
      );
      this.kind = kind;
    }
    insert(id, lower, upper) {
      core.frame(() => call("insert", at(this), id, box(lower, upper)));
      this.#boxes += 1;
    }
    move(id, lower, upper) {
      core.frame(() => call("move", at(this), id, box(lower, upper)));
    }
    remove(id) {
      core.frame(() => call("remove", at(this), id));
      this.#boxes -= 1;
    }
    pairs() {
      return this.#found("pairs", 0);
    }
    movedPairs() {
      return this.#found("pairs", 1);
    }
    query(lower, upper) {
      return core.frame(() => ids((first, count) => call("query", at(this), box(lower, upper), first, count)));
    }
    sweep(lower, upper, motion) {
      return core.frame(() =>
        ids((first, count) => call("sweep", at(this), box(lower, upper), args.vec3(motion, "motion"), first, count)));
    }
    parts() {
      return core.frame(() => {
        const [first, count] = [core.room(4), core.room(4)];
        call("parts", at(this), first, count);
        const all = layout.readAll(layout.broadPhasePart, core.data.getUint32(first, true), core.data.getUint32(count, true));
        return all.map(({ box: bounds, depth }) => ({ ...bounds, depth }));
      });
    }
    counts() {
      return core.frame(() => {
        const [tests, bytes] = [core.room(4), core.room(4)];
        call("counts", at(this), tests, bytes);
        const memory = core.data.getUint32(bytes, true);
        return { boxes: this.#boxes, pairs: this.#pairs, tests: core.data.getUint32(tests, true), memory };
      });
    }
    #found(name, moved) {
      const found = core.frame(() => ids((first, count) => call(name, at(this), moved, first, count)));
      this.#pairs = found.length / 2;
      return found;
    }
  }
  /** A copy of numbers that belong to the broad phase until it is asked again. */
  const ids = (ask) => {
    const first = core.room(4);
    const count = core.room(4);
    ask(first, count);
    return new Uint32Array(core.data.buffer, core.data.getUint32(first, true), core.data.getUint32(count, true)).slice();
  };
  const at = (broad) => Handle.pointer(broad, "broadPhase", BroadPhase);
  return { BroadPhase };
}
