// The module's memory: loading, scratch room for arguments, errors, and objects that live in it.
//
// A module is loaded once for each entry of the package. Arguments are written into a scratch arena, which is empty
// again after each call; arguments that do not fit are allocated and freed with it.

export class InvalidValue extends RangeError {
  name = "InvalidValue";
}

const arenaSize = 1 << 16;
const text = new TextDecoder();
const bytesOf = new TextEncoder();

/** The few functions that the C++ runtime, not the library, needs of its host. Memory may have grown since JavaScript
 * last looked at it. */
function hostImports(core) {
  const unsupported = () => 52; // WASI's ENOSYS
  const system = {
    proc_exit(code) {
      throw new Error(`graze: the module ended with ${code}`);
    },
    clock_time_get(_clock, _precision, result) {
      core.memory().setBigUint64(result, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    // Sizes of nothing: two numbers, both zero.
    environ_sizes_get(count, size) {
      core.memory().setUint32(count, 0, true);
      core.memory().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
  };
  const named = {
    wasi_snapshot_preview1: system,
    env: { emscripten_notify_memory_growth: () => {} },
    graze: core.callbackImports,
  };
  return (imports) => {
    const answer = {};
    for (const { module, name } of imports) {
      const given = named[module]?.[name] ?? (module.startsWith("wasi_") ? unsupported : undefined);
      if (given === undefined) throw new Error(`graze: the module asks for ${module}.${name}, which nobody has`);
      (answer[module] ??= {})[name] = given;
    }
    return answer;
  };
}

async function compiled(source) {
  const given = await source;
  if (given instanceof WebAssembly.Module) return given;
  if (given instanceof ArrayBuffer || ArrayBuffer.isView(given)) return WebAssembly.compile(given);
  if (typeof Response !== "undefined" && given instanceof Response)
    return WebAssembly.compile(await given.arrayBuffer());
  const url = new URL(given, globalThis.location?.href);
  if (url.protocol === "file:") {
    // A name that bundlers for browsers do not follow.
    const files = "node:fs/promises";
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files);
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`graze: ${url}: ${response.status} ${response.statusText}`);
  // A server that does not know the type of the file is no reason to fail.
  if (response.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

export class Core {
  /** `scalar` is "f" or "d", the end of names of the C interface; `address` is that of the module. */
  constructor(scalar, address) {
    this.scalar = scalar;
    this.address = address;
    this.Numbers = scalar === "d" ? Float64Array : Float32Array;
    this.numberSize = this.Numbers.BYTES_PER_ELEMENT;
    this.callbacks = new Map();
    /** The uses that the open frames make of objects; they end with their frames. */
    this.uses = [];
    this.framed = false;
    /** The number of callbacks that run, one inside the other. */
    this.depth = 0;
    this.lastCallback = 0;
    this.thrown = null;
    this.callbackImports = {};
    this.finalizers = new FinalizationRegistry(({ release, pointer }) => release(pointer));
  }

  async init(source) {
    this.loading ??= this.load(source ?? this.address()).catch((error) => {
      this.loading = undefined;
      throw error;
    });
    return this.loading;
  }

  async load(source) {
    const module = await compiled(source);
    const imports = hostImports(this)(WebAssembly.Module.imports(module));
    const instance = await WebAssembly.instantiate(module, imports);
    this.exports = instance.exports;
    this.data = new DataView(this.exports.memory.buffer);
    this.exports._initialize?.();
    this.arena = this.exports.malloc(arenaSize);
    this.used = this.arena;
  }

  get loaded() {
    return this.exports !== undefined;
  }

  /** A view of the memory, which has another buffer after it grew. */
  memory() {
    if (!this.loaded) throw new Error("graze: call init() and wait for it first");
    if (this.data.buffer !== this.exports.memory.buffer) this.data = new DataView(this.exports.memory.buffer);
    return this.data;
  }

  numbers(pointer, length) {
    return new this.Numbers(this.memory().buffer, pointer, length);
  }

  string(pointer) {
    if (pointer === 0) return "";
    const bytes = new Uint8Array(this.memory().buffer, pointer);
    return text.decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** Writes the UTF-8 of a text, with a zero behind it, and returns its place. */
  written(value, path) {
    if (typeof value !== "string" || value.includes("\0")) throw new InvalidValue(`${path}: expected a text, got ${shown(value)}`);
    const bytes = bytesOf.encode(value);
    const place = this.room(bytes.length + 1);
    const memory = new Uint8Array(this.memory().buffer);
    memory.set(bytes, place);
    memory[place + bytes.length] = 0;
    return place;
  }

  /** Runs `body`, after which its scratch room is given back and its uses of objects end. Frames may be nested, as a
   * callback does. */
  frame(body) {
    this.memory();
    const { used, framed, large: outer } = this;
    const first = this.uses.length;
    this.large = null;
    this.framed = true;
    try {
      return body();
    } finally {
      this.used = used;
      this.framed = framed;
      while (this.uses.length > first) this.uses.pop().end();
      for (const pointer of this.large ?? []) this.exports.free(pointer);
      this.large = outer;
    }
  }

  copy(from, to, size) {
    new Uint8Array(this.memory().buffer).copyWithin(to, from, from + size);
  }

  /** Scratch room until the frame ends, filled with zeros. */
  room(size) {
    const place = (this.used + 15) & ~15;
    let pointer = place;
    if (place + size <= this.arena + arenaSize) {
      this.used = place + size;
    } else {
      pointer = this.allocate(size);
      (this.large ??= []).push(pointer);
    }
    new Uint8Array(this.memory().buffer, pointer, size).fill(0);
    return pointer;
  }

  allocate(size) {
    // A size that 32 bits do not hold would be cut off on the way into the module.
    const pointer = size < 2 ** 32 ? this.exports.malloc(size) : 0;
    if (pointer === 0) throw new RangeError(`graze: no memory for ${size} bytes`);
    return pointer;
  }

  /** Calls a function of the C interface by its name without beginning and scalar; throws its errors. WebAssembly would
   * take null for 0 and words for numbers. */
  call(name, ...args) {
    for (const value of args) if (typeof value !== "number") number(value, name);
    this.check(this.exports[`graze_${name}_${this.scalar}`](...args));
  }

  check(status) {
    this.memory();
    if (this.thrown !== null) {
      const { error } = this.thrown;
      this.thrown = null;
      throw error;
    }
    if (status === 0) return;
    const message = this.string(this.exports.graze_last_error());
    throw status === 1 ? new InvalidValue(message) : new Error(message);
  }

  /** Keeps a function of JavaScript and returns the number by which the module names it. */
  keep(callback) {
    this.lastCallback += 1;
    this.callbacks.set(this.lastCallback, callback);
    return this.lastCallback;
  }

  /** A callback's result; the first exception of a call's callbacks is thrown when the module returns from the call. */
  called(key, otherwise, body) {
    const { thrown, framed } = this;
    this.thrown = null;
    this.framed = false;
    this.depth += 1;
    try {
      return body(this.callbacks.get(key));
    } catch (error) {
      this.thrown = { error };
      return otherwise;
    } finally {
      this.thrown = thrown ?? this.thrown;
      this.framed = framed;
      this.depth -= 1;
    }
  }
}

/**
 * The calls that use an object at this moment. Callbacks run in the middle of a call: where it changes an object,
 * nobody else may use that one until it returns, and where it reads one, nobody may change it.
 */
class Uses {
  #reading = 0;
  #changing = false;
  read(path) {
    if (this.#changing) throw new Error(`${path}: in use: another call changes it at this moment`);
    this.#reading += 1;
  }
  change(path) {
    this.checkIdle(path);
    this.#changing = true;
  }
  checkIdle(path) {
    if (this.#changing) throw new Error(`${path}: in use: another call changes it at this moment`);
    if (this.#reading > 0) throw new Error(`${path}: in use: another call reads it at this moment`);
  }
  /** Ends one use: an object that is changed has no other. */
  end() {
    if (this.#changing) this.#changing = false;
    else this.#reading -= 1;
  }
}

/** The base of the `Handle`s of all entries. */
export class AnyHandle {}

/** The base of all objects that lie in the module's memory. */
export function handleClass(core) {
  return class Handle extends AnyHandle {
    #pointer;
    #release;
    #uses = new Uses();
    /** `release` gives the object behind `pointer` back. */
    constructor(pointer, release) {
      super();
      this.#pointer = pointer;
      this.#release = release;
      core.finalizers.register(this, { release, pointer }, this);
    }
    get disposed() {
      return this.#pointer === 0;
    }
    dispose() {
      if (this.#pointer === 0) return;
      this.#uses.checkIdle("dispose");
      const pointer = this.#pointer;
      this.#pointer = 0;
      core.finalizers.unregister(this);
      this.#release(pointer);
    }
    [Symbol.dispose ?? Symbol.for("Symbol.dispose")]() {
      this.dispose();
    }
    static #live(value, path, kind, use) {
      if (!(value instanceof kind)) throw new InvalidValue(`${path}: expected ${article(kind.name)}, got ${shown(value)}`);
      if (value.#pointer === 0) throw new InvalidValue(`${path}: expected a live object, got a disposed one`);
      if (core.framed) {
        value.#uses[use](path);
        core.uses.push(value.#uses);
      }
      return value.#pointer;
    }
    /** The pointer of a live object of the class `kind`, named `path` in errors, which the call of the frame reads. */
    static pointer(value, path, kind) {
      return Handle.#live(value, path, kind, "read");
    }
    /** The pointer of one that the call of the frame changes. */
    static changed(value, path, kind) {
      return Handle.#live(value, path, kind, "change");
    }
  };
}

/** `value`, where it is a number; nothing else becomes one. */
export function number(value, path) {
  if (typeof value !== "number") throw new InvalidValue(`${path}: expected a number, got ${shown(value)}`);
  return value;
}

/** `value`, where it is a finite number. */
export function finite(value, path) {
  if (!Number.isFinite(value)) throw new InvalidValue(`${path}: expected a finite number, got ${shown(value)}`);
  return value;
}

/** `value`, where it is a whole number from `least` to `most`: those of the module would wrap around or be cut off. */
export function whole(value, path, most = 2 ** 32 - 1, least = 0) {
  if (!(Number.isInteger(value) && value >= least && value <= most))
    throw new InvalidValue(`${path}: expected an integer from ${least} to ${most}, got ${shown(value)}`);
  return value;
}

/** `value`, where it is an object with no other members than `names`; absent: an empty one. What is not understood is
 * refused, for it would be passed over in silence. */
export function membersOf(value, path, names, kind) {
  if (value === undefined) return {};
  if (value === null || typeof value !== "object" || Array.isArray(value) || ArrayBuffer.isView(value))
    throw new InvalidValue(`${path}: expected ${kind ?? `an object with ${listed(names)}`}, got ${shown(value)}`);
  for (const name in value)
    if (!names.includes(name)) throw new InvalidValue(`${path}: expected ${listed(names)}, got ${name}`);
  return value;
}

const listed = (names) => names.join(", ") || "no members";

/** `value`, where it is an array or a list like one. */
export function arrayOf(value, path) {
  if (value === null || typeof value !== "object" || !Number.isInteger(value.length))
    throw new InvalidValue(`${path}: expected an array, got ${shown(value)}`);
  return value;
}

/** `value`, where it is a function; absent: undefined. */
export function callback(value, path) {
  if (value !== undefined && typeof value !== "function")
    throw new InvalidValue(`${path}: expected a function, got ${shown(value)}`);
  return value;
}

/** `value` as a bigint, where it is a whole number of 64 bits. */
export function bits(value, path) {
  const given = typeof value === "bigint" || Number.isSafeInteger(value) ? BigInt(value) : -1n;
  if (given < 0n || given >= 2n ** 64n)
    throw new InvalidValue(`${path}: expected an integer or a bigint from 0 to 2^64 - 1, got ${shown(value)}`);
  return given;
}

const article = (name) => `${/^[AEIOU]/.test(name) ? "an" : "a"} ${name}`;

export function shown(value) {
  if (value === null || value === undefined) return String(value);
  if (typeof value === "object" || typeof value === "function") return value.constructor?.name ?? "an object";
  return typeof value === "string" ? JSON.stringify(value) : String(value);
}
