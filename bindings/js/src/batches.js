// Queries of many pairs at a time, over arrays in the module's memory.

import { arrayOf, InvalidValue, membersOf, shown, whole } from "./core.js";
import { castOptions } from "./questions.js";

const bodiesMembers = ["shapes", "poses", "translations", "rotations"];

/** Structs in the module's memory: a copy of one as an object, or all of them as they stand. */
export function rowsClass(core) {
  return class Rows {
    #type;
    #pointer;
    constructor(type, pointer, length) {
      this.#type = type;
      this.#pointer = pointer;
      this.length = length;
      this.stride = type.size / core.numberSize;
      this.offset = Object.fromEntries(Object.entries(type.offset).map(([name, at]) => [name, at / core.numberSize]));
    }
    at(i) {
      whole(i, "i", this.length - 1);
      core.memory();
      return this.#type.read(this.#pointer() + i * this.#type.size);
    }
    get view() {
      return core.numbers(this.#pointer(), this.length * this.stride);
    }
    *[Symbol.iterator]() {
      for (let i = 0; i < this.length; ++i) yield this.at(i);
    }
  };
}

/** The queries of a dimension for many at a time. */
export function batches(core, layout, dimension, Rows, Handle) {
  const { types, args, of, pose, numbersOf, ask } = dimension;
  const { call } = ask;
  const [vectorSize, turnSize] = ["translation", "rotation"].map((part) => types.pose.members[part].size / core.numberSize);
  const poseSize = vectorSize + turnSize;

  /** Memory in which answers stand until they are disposed of. */
  class Store extends Handle {
    constructor(pointer) {
      super(pointer, (p) => core.exports.free(p));
    }
    get pointer() {
      return Handle.pointer(this, "batch", Store);
    }
  }
  class Batch extends Rows {
    #store;
    constructor(type, store, length) {
      super(type, () => store.pointer, length);
      this.#store = store;
    }
    dispose() {
      this.#store.dispose();
    }
    [Symbol.dispose ?? Symbol.for("Symbol.dispose")]() {
      this.dispose();
    }
  }
  /** Answers that `fill` writes; where it throws, their memory is given back. */
  const filled = (type, length, fill) => {
    const size = length * type.size;
    const pointer = core.allocate(Math.max(1, size));
    try {
      new Uint8Array(core.memory().buffer, pointer, size).fill(0);
      fill(pointer);
    } catch (error) {
      core.exports.free(pointer);
      throw error;
    }
    return new Batch(type, new Store(pointer), length);
  };

  /** The place of bodies' poses: one behind the other, or translations and rotations by themselves. */
  const posesAt = (value, path) => {
    const number = core.numberSize;
    if (value.poses !== undefined) {
      for (const name of ["translations", "rotations"])
        if (value[name] !== undefined) throw new InvalidValue(`${path}.${name}: expected none beside poses, got ${shown(value[name])}`);
      const { pointer, count } = numbersOf(value.poses, poseSize, `${path}.poses`);
      return {
        translations: pointer, translationStride: poseSize * number, rotations: pointer + vectorSize * number,
        rotationStride: poseSize * number, poseCount: count };
    }
    const moved = numbersOf(value.translations, vectorSize, `${path}.translations`);
    const at = { translations: moved.pointer, translationStride: vectorSize * number, poseCount: moved.count };
    if (value.rotations === undefined) return at;
    const turned = numbersOf(value.rotations, turnSize, `${path}.rotations`);
    if (turned.count !== moved.count)
      throw new InvalidValue(`${path}.rotations: expected ${moved.count} of them, got ${turned.count}`);
    return { ...at, rotations: turned.pointer, rotationStride: turnSize * number };
  };
  const writeBodies = (given, place, path) => {
    const value = membersOf(given, path, bodiesMembers);
    const list = Array.isArray(value.shapes) ? value.shapes : [value.shapes];
    const handles = core.room(Math.max(1, list.length) * 4);
    list.forEach((shape, i) => core.data.setUint32(handles + 4 * i, of(shape, `${path}.shapes[${i}]`), true));
    const shapesAt = { shapes: handles, shapeStride: 4, shapeCount: list.length };
    layout.bodies.write(place, { ...shapesAt, ...posesAt(value, path) }, path);
  };
  const batch = (a, b, places) => {
    const { size } = layout.bodies;
    const p = core.room(2 * size + 12);
    writeBodies(a, p, "a");
    writeBodies(b, p + size, "b");
    if (places !== undefined) {
      const { pointer, count } = args.rows(places, 2, "places", Uint32Array);
      [pointer, 8, count].forEach((v, i) => core.data.setUint32(p + 2 * size + 4 * i, v, true));
    }
    const length = core.room(4);
    call("batch_size", p, length);
    return { pointer: p, length: core.data.getUint32(length, true) };
  };
  /** Parts of a list, by where each ends. */
  const splitAt = (all, ends, count) =>
    Array.from({ length: count }, (_, i) => {
      const end = (at) => (at < 0 ? 0 : core.data.getUint32(ends + 4 * at, true));
      return all.slice(end(i - 1), end(i));
    });
  const bytes = (pointer, length) => new Uint8Array(core.memory().buffer, pointer, length).slice();

  /** Writes moving bodies one behind the other and returns where they begin. */
  const moving = (bodies, path) => {
    const first = core.room(Math.max(1, bodies.length) * types.moving.size);
    bodies.forEach((body, i) => ask.writeMoving(first + i * types.moving.size, body, `${path}[${i}]`));
    return first;
  };
  /** Answers that not every element has: `found` is 1 where there is one. */
  const foundOf = (type, count, fill) => {
    const found = core.room(Math.max(1, count));
    const hits = filled(type, count, (p) => fill(found, p));
    return Object.assign(hits, { found: bytes(found, count) });
  };

  return {
    overlapBatch(a, b, places) {
      const { pointer, length } = batch(a, b, places);
      const touch = core.room(Math.max(1, length));
      call("overlap_batch", pointer, touch, 0);
      return bytes(touch, length);
    },
    distanceBatch(a, b, places) {
      const { pointer, length } = batch(a, b, places);
      return filled(types.distance, length, (p) => call("distance_batch", pointer, p, 0));
    },
    contactsBatch(a, b, margin = 0, places = undefined, most = undefined) {
      const { pointer } = batch(a, b, places);
      const p = core.room(layout.batchContacts.size);
      if (most === undefined) call("contacts_batch", pointer, margin, ask.room(), p);
      else call("contacts_batch_reduced", pointer, margin, whole(most, "most"), ask.room(), p);
      const all = layout.batchContacts.read(p);
      return layout.readAll(layout.pair, all.pairs, all.pairCount).map((pair) => ({
        overlap: pair.overlap,
        manifolds: ask.manifolds(all, pair.firstManifold, pair.manifoldCount),
      }));
    },
    closestBatch(shape, at, points) {
      const { pointer, count } = numbersOf(points, vectorSize, "points");
      return filled(types.closest, count, (p) =>
        call("closest_batch", of(shape), pose(at, "pose"), pointer, 0, count, p, 0));
    },
    raycastBatch(shape, at, rays, given) {
      const options = membersOf(given, "options", ["length", ...ask.rayOptions]);
      const { pointer, count } = numbersOf(rays, 2 * vectorSize, "rays");
      const question = [of(shape), pose(at, "pose"), pointer, 0, count, options.length ?? Infinity, ...ask.backs(options)];
      return foundOf(types.rayHit, count, (found, p) => call("raycast_batch", ...question, found, 0, p, 0));
    },
    castBatch(a, b, given) {
      const options = membersOf(given, "options", castOptions);
      if (arrayOf(a, "a").length !== arrayOf(b, "b").length)
        throw new InvalidValue(`b: expected ${a.length} moving bodies, as many as in a, got ${b.length}`);
      const question = [moving(a, "a"), 0, moving(b, "b"), 0, a.length, options.duration ?? 1, ask.separating(options)];
      return foundOf(types.castHit, a.length, (found, p) => call("cast_batch", ...question, found, 0, p, 0));
    },
    compactContactsBatch(a, b, margin = 0, places = undefined) {
      const { pointer } = batch(a, b, places);
      const { manifolds, manifoldCount, points, pointCount } = args.answered(layout.compactContacts, (p) =>
        call("compact_contacts_batch", pointer, margin, ask.room(), p));
      return {
        manifolds: new Rows(layout.compactManifold, () => manifolds, manifoldCount),
        points: new Rows(layout.compactPoint, () => points, pointCount) };
    },
    nearPiecesBatch(a, b, margin, places) {
      const { pointer, length } = batch(a, b, places);
      const ends = core.room(4);
      const all = ask.listed(types.pieceDistance, (buffer, first, count) =>
        call("near_pieces_batch", pointer, margin, buffer, first, ends, count));
      // Ends are as many as pairs, and counted in pieces.
      return splitAt(all, core.data.getUint32(ends, true), length);
    },
  };
}
