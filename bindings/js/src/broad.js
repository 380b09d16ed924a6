// The broad phases, each by itself: boxes and their numbers in, pairs out.

import { whole } from "./core.js";
import { named } from "./layout.js";

const kinds = ["dynamicTree", "sortAndSweep", "sweepAndPrune", "hashedGrid", "looseOctree", "bsp"];

export function broadPhases(core, layout, args, ask, Handle) {
  const { written } = args;
  const box = (lower, upper) => written(layout.aabb, { lower, upper }, "box");

  /** What holds boxes: an object of the functions whose names begin with `prefix`, which errors call `path`. */
  class Boxes extends Handle {
    #prefix;
    #path;
    constructor(prefix, path, kind) {
      super(
        core.frame(() => {
          const result = core.room(4);
          core.call(`${prefix}_create`, named(kinds, kind, `${path}.kind`), result);
          return core.data.getUint32(result, true);
        }),
        (p) => core.exports[`graze_${prefix}_destroy_${core.scalar}`](p),
      );
      this.#prefix = prefix;
      this.#path = path;
      this.kind = kind;
    }
    insert(id, lower, upper) {
      core.frame(() => this.#change("insert", whole(id, "id"), box(lower, upper)));
    }
    move(id, lower, upper) {
      core.frame(() => this.#change("move", whole(id, "id"), box(lower, upper)));
    }
    remove(id) {
      core.frame(() => this.#change("remove", whole(id, "id")));
    }
    #change(name, ...parameters) {
      core.call(`${this.#prefix}_${name}`, Handle.changed(this, this.#path, Boxes), ...parameters);
    }
  }

  const call = (name, ...parameters) => core.call(`broad_phase_${name}`, ...parameters);
  class BroadPhase extends Boxes {
    #boxes = 0;
    #pairs = 0;
    constructor(kind = "dynamicTree") {
      super("broad_phase", "broadPhase", kind);
    }
    insert(id, lower, upper) {
      super.insert(id, lower, upper);
      this.#boxes += 1;
    }
    remove(id) {
      super.remove(id);
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

  class PairChanges extends Boxes {
    constructor(kind = "dynamicTree") {
      super("pair_changes", "pairChanges", kind);
    }
    find() {
      return core.frame(() => {
        const to = core.room(16);
        const places = [0, 4, 8, 12].map((offset) => to + offset);
        core.call("pair_changes_find", Handle.changed(this, "pairChanges", PairChanges), ask.room(), ...places);
        const [begun, begunCount, ended, endedCount] = places.map((p) => core.data.getUint32(p, true));
        const copied = (first, count) => new Uint32Array(core.data.buffer, first, 2 * count).slice();
        return { begun: copied(begun, begunCount), ended: copied(ended, endedCount) };
      });
    }
  }
  return { BroadPhase, PairChanges };
}
