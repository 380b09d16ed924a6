// Questions about many pairs at a time, over arrays in the module's memory.

import { InvalidValue, shown } from "./core.js";

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
      if (!(Number.isInteger(i) && i >= 0 && i < this.length))
        throw new InvalidValue(`i: expected an integer >= 0 and < ${this.length}, got ${shown(i)}`);
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

export function batches(core, layout, args, shapes, ask, Rows, Handle) {
  const { of, numbersOf } = shapes;
  const { call } = ask;

  /** Memory that answers stand in until they are disposed of. */
  class Store extends Handle {
    constructor(size) {
      const pointer = core.allocate(Math.max(1, size));
      super(pointer, (p) => core.exports.free(p));
      new Uint8Array(core.memory().buffer, pointer, size).fill(0);
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
  /** Answers that `fill` writes; where it throws their memory is given back. */
  const filled = (type, length, fill) => {
    const store = new Store(length * type.size);
    try {
      fill(store.pointer);
    } catch (error) {
      store.dispose();
      throw error;
    }
    return new Batch(type, store, length);
  };

  /** Where bodies' poses stand: seven numbers each, or translations and rotations by themselves. */
  const posesAt = (value, path) => {
    const number = core.numberSize;
    if (value.poses !== undefined) {
      const { pointer, count } = numbersOf(value.poses, 7, `${path}.poses`);
      return {
        translations: pointer, translationStride: 7 * number, rotations: pointer + 3 * number,
        rotationStride: 7 * number, poseCount: count };
    }
    const moved = numbersOf(value.translations, 3, `${path}.translations`);
    const at = { translations: moved.pointer, translationStride: 3 * number, poseCount: moved.count };
    if (value.rotations === undefined) return at;
    const turned = numbersOf(value.rotations, 4, `${path}.rotations`);
    if (turned.count !== moved.count)
      throw new InvalidValue(`${path}.rotations: expected ${moved.count} of them, got ${turned.count}`);
    return { ...at, rotations: turned.pointer, rotationStride: 4 * number };
  };
  const writeBodies = (value, place, path) => {
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
  const bytes = (pointer, length) => new Uint8Array(core.memory().buffer, pointer, length).slice();

  return ask.framed({
    overlapBatch(a, b, places) {
      const { pointer, length } = batch(a, b, places);
      const touch = core.room(Math.max(1, length));
      call("overlap_batch", pointer, touch, 0);
      return bytes(touch, length);
    },
    distanceBatch(a, b, places) {
      const { pointer, length } = batch(a, b, places);
      return filled(layout.distance, length, (p) => call("distance_batch", pointer, p, 0));
    },
    contactsBatch(a, b, margin = 0, places = undefined) {
      const { pointer } = batch(a, b, places);
      const p = core.room(layout.batchContacts.size);
      call("contacts_batch", pointer, margin, ask.room(), p);
      const all = layout.batchContacts.read(p);
      return layout.readAll(layout.pair, all.pairs, all.pairCount).map((pair) => ({
        overlap: pair.overlap,
        manifolds: ask.manifolds(all, pair.firstManifold, pair.manifoldCount),
      }));
    },
    closestBatch(shape, at, points) {
      const { pointer, count } = numbersOf(points, 3, "points");
      return filled(layout.closest, count, (p) =>
        call("closest_batch", of(shape), args.pose(at, "pose"), pointer, 0, count, p, 0));
    },
    raycastBatch(shape, at, rays, options) {
      const { pointer, count } = numbersOf(rays, 6, "rays");
      const found = core.room(Math.max(1, count));
      const question = [of(shape), args.pose(at, "pose"), pointer, 0, count, options?.length ?? Infinity, ask.back(options)];
      const hits = filled(layout.rayHit, count, (p) => call("raycast_batch", ...question, found, 0, p, 0));
      return Object.assign(hits, { found: bytes(found, count) });
    },
  });
}
