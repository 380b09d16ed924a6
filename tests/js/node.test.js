// The package in Node: the checks that a browser runs as well, the page's programs, and what the garbage collector gives
// back. Run by `make npm`, with the package's directory in GRAZE_PACKAGE.

import { readFile, mkdtemp, writeFile, mkdir, symlink, rm } from "node:fs/promises";
import { execFile } from "node:child_process";
import { tmpdir } from "node:os";
import path from "node:path";
import test from "node:test";
import assert from "node:assert/strict";
import { pathToFileURL, fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { knowsUsing } from "./assert.js";
import { checks } from "./checks.js";
import { pairsOfProtocol } from "./protocol_page.js";

const here = path.dirname(fileURLToPath(import.meta.url));
const project = path.resolve(here, "../..");
const dist = path.resolve(process.env.GRAZE_PACKAGE ?? path.join(project, "bindings/js/dist"));
const module = (name) => import(pathToFileURL(path.join(dist, name)));
const run = promisify(execFile);

/** The names of the module's functions that the package looked up, of all modules. */
const lookedUp = new Set();
const { instantiate } = WebAssembly;
WebAssembly.instantiate = async (...given) => {
  const instance = await instantiate(...given);
  const exports = new Proxy(instance.exports, { get: (all, name) => (lookedUp.add(name), all[name]) });
  return { exports };
};

const [graze, double, queries] = await Promise.all(["index.js", "double.js", "queries.js"].map(module));

test("nothing works before init", () => {
  assert.throws(() => new graze.Sphere(1), { message: "graze: call init() and wait for it first" });
});

await graze.init();
await double.init(readFile(path.join(dist, "graze-double.wasm")));
await queries.init(await WebAssembly.compile(await readFile(path.join(dist, "graze-queries.wasm"))));
const longRunFile = process.env.GRAZE_LONG_RUN ?? path.join(project, "build/npm/long-run.wasm");
const longRunModule = await WebAssembly.compile(await readFile(longRunFile));
const nothing = new Proxy({}, { get: () => () => 0 });
const longRun = (await WebAssembly.instantiate(longRunModule, new Proxy({}, { get: () => nothing }))).exports;
longRun._initialize?.();

for (const [name, check] of checks) test(name, () => check({ graze, double, queries, longRun }));

// Older ones run what a compiler makes of using.js (package.test.js).
test("`using` gives handles back", { skip: !knowsUsing && "needs a Node that knows `using`" }, async (t) => {
  const { usingChecks } = await import("./using.js");
  for (const [name, check] of usingChecks) await t.test(name, () => check({ graze, double, queries }));
});

test("what was forgotten is given back", { skip: globalThis.gc === undefined && "needs --expose-gc" }, async () => {
  const collect = async (enough) => {
    for (let tries = 0; tries < 50 && graze.memoryInUse() > enough; ++tries) {
      globalThis.gc();
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
  };
  // What the tests before this one have forgotten goes first, or it would go with the boxes.
  await collect(0);
  const before = graze.memoryInUse();
  (() => {
    for (let i = 0; i < 1000; ++i) new graze.Box([1, 1, 1]);
  })();
  assert.ok(graze.memoryInUse() > before + 1000 * 16);
  await collect(before);
  assert.equal(graze.memoryInUse(), before);
});

const needsCollector = { skip: globalThis.gc === undefined && "needs --expose-gc" };
test("functions of a world that was refused, or has others now, are forgotten", needsCollector, async () => {
  // Functions by themselves, which hold nothing of where they are used.
  const decision = (answer) => () => answer;
  const refuse = (library) => {
    const allow = decision(true);
    assert.throws(() => new library.World({ allow, margin: -1 }), graze.InvalidValue);
    return new WeakRef(allow);
  };
  const replace = (world, allow) => {
    world.setAllow(decision(true));
    return new WeakRef(allow);
  };
  const worlds = [];
  const made = (library) => {
    const allow = decision(false);
    worlds.push(new library.World({ allow }));
    return replace(worlds.at(-1), allow);
  };
  const forgotten = [graze, graze.plane].flatMap((library) => [refuse(library), made(library)]);
  // A reference that was looked at holds its object until the present turn ends.
  const later = () => new Promise((resolve) => setTimeout(resolve, 10));
  for (let tries = 0; tries < 50 && forgotten.some((ref) => ref.deref() !== undefined); ++tries) {
    await later();
    globalThis.gc();
    await later();
  }
  assert.deepEqual(forgotten.map((ref) => ref.deref()), [undefined, undefined, undefined, undefined]);
  for (const world of worlds) world.dispose();
});

test("questions of the protocol's page have the answers of the page", async () => {
  const pairs = pairsOfProtocol(await readFile(path.join(project, "docs/protocol.md"), "utf8"));
  for (const [question, answer] of pairs) assert.equal(double.query(question), answer);
  assert.ok(pairs.length >= 12, `expected a dozen questions, got ${pairs.length}`);
});

test("compounds nest as deep as a line may", () => {
  const nested = (type, depth) => {
    let shape = `{"type":"${type}"}`;
    for (let i = 0; i < depth; ++i) shape = `{"type":"compound","compound":{"children":[{"shape":${shape}}]}}`;
    return shape;
  };
  const question = (query, depth) => `{"query":"${query}","a":{"shape":${nested("box", depth)}},
    "b":{"shape":${nested("sphere", depth)},"translation":[0,0.75,0]}}`.replaceAll("\n", "");
  for (const query of ["overlap", "distance", "contacts", "cast"])
    assert.equal(JSON.parse(double.query(question(query, 499))).error, undefined, query);
  assert.match(double.query(question("overlap", 500)), /nested at most 2000 deep/);
});

test("numbers are written as std::to_chars does", () => {
  const written = (x) => {
    const answer = JSON.parse(`{"id":0}`);
    assert.ok(answer);
    const question = { query: "closest", a: { shape: { type: "sphere", sphere: { radius: 0 } } }, point: [x, 0, 0] };
    return double.query(JSON.stringify(question)).match(/"distance":([^,]+)/)[1];
  };
  // The shorter of fixed and scientific, and fixed of equals.
  const expected = { 1: "1", 0.5: "0.5", 1e5: "1e+05", 123456: "123456", 0.001: "0.001", 1e-5: "1e-05", 0.1: "0.1",
                     12345678901234567000: "12345678901234567168" };
  for (const [x, text] of Object.entries(expected)) assert.equal(written(Number(x)), text);
});

/** The fenced blocks of a language on a page. */
const blocks = (page, language) => [...page.matchAll(new RegExp("```" + language + "\\n([\\s\\S]*?)```", "g"))].map((m) => m[1]);

/** Calls `use` with a directory in which the package is installed. */
async function installed(use) {
  const work = await mkdtemp(path.join(tmpdir(), "graze-js-"));
  try {
    await mkdir(path.join(work, "node_modules"));
    await symlink(dist, path.join(work, "node_modules/graze"));
    await writeFile(path.join(work, "package.json"), '{"type": "module"}');
    await use(work);
  } finally {
    await rm(work, { recursive: true });
  }
}

test("the page's programs print what the page says", async () => {
  const page = await readFile(path.join(project, "docs/javascript.md"), "utf8");
  const programs = blocks(page, "js");
  const outputs = blocks(page, "console");
  assert.ok(programs.length >= 3);
  assert.equal(programs.length, outputs.length, "an output for each program");
  await installed(async (work) => {
    for (const [i, program] of programs.entries()) {
      const file = path.join(work, `program${i}.js`);
      await writeFile(file, program);
      const { stdout } = await run(process.execPath, [file]);
      assert.equal(stdout, outputs[i]);
    }
  });
});

test("a strict TypeScript program of every name compiles and runs", async () => {
  const program = await readFile(path.join(here, "types.ts"), "utf8");
  const declarations = await readFile(path.join(dist, "index.d.ts"), "utf8");
  const kinds = "(?:declare )?(?:abstract )?(?:class|function|const|namespace|interface|type)";
  const names = (text, start) => [...text.matchAll(new RegExp(`^${start}${kinds} (\\w+)`, "gm"))].map((m) => m[1]);
  const ofPlane = declarations.slice(declarations.indexOf("export declare namespace plane"));
  const all = [...names(declarations, "export "), ...names(ofPlane, "  ").map((name) => `plane.${name}`)];
  assert.ok(all.length > 200, `expected some two hundred names, got ${all.length}`);
  assert.deepEqual(all.filter((name) => !new RegExp(`\\b${name}\\b`).test(program)), [], "names that types.ts does not use");
  await installed(async (work) => {
    await writeFile(path.join(work, "types.ts"), program);
    const options = [
      "--strict", "--noUncheckedIndexedAccess", "--target", "es2022", "--module", "node16", "--moduleResolution", "node16"];
    // Errors are written to the standard output.
    await run("tsc", [...options, "types.ts"], { cwd: work }).catch((error) => assert.fail(error.stdout || error.message));
    await run(process.execPath, ["types.js"], { cwd: work });
  });
});

// The stored capture is of a world: one of a simulation has the bits of the solver that wrote it, and is made anew below.
test("a capture of the plane is played again", async () => {
  const file = await readFile(new URL("../../fuzz/corpus/capture/whole-plane-world", import.meta.url));
  const seen = [];
  const report = double.replay(file, (world, frame, plane) => {
    seen.push([frame, plane, world.size, world.poses().length / 4]);
    const shape = world.shape(world.bodyAt(0));
    assert.equal(shape.kind, "halfPlane");
    shape.dispose();
    double.plane.draw.world(world, { size: 3 });
  });
  assert.deepEqual([report.simulation, report.plane, report.difference], [false, true, null]);
  assert.deepEqual(double.captureHead(file), { simulation: false, plane: true, scalar: "double" });
  assert.equal(seen.length, report.frames);
  assert.deepEqual(seen.at(-1), [3, true, 3, 3]);
});

test("memory may grow while a simulation steps", () => {
  // Steps need more as boxes land on each other, and states fill what the module has until one of them must ask for it.
  const simulation = new double.Simulation({ subSteps: 8 });
  const box = new double.Box([0.8, 0.8, 0.8]);
  const floor = new double.Box([60, 1, 60]);
  simulation.add({ shape: floor, translation: [0, -0.5, 0], fixed: true });
  const place = (i, ten) => (Math.floor(i / ten) % 10 - 4.5) * 1.05;
  for (let i = 0; i < 1000; i++)
    simulation.add({ shape: box, translation: [place(i, 1), 0.6 + Math.floor(i / 100) * 1.05, place(i, 10)] }, { density: 1 });
  const states = [];
  for (let i = 0; i < 40; i++) {
    states.push(simulation.save());
    simulation.step(1 / 60);
  }
  assert.ok(double.memoryInUse() > 20e6, `${double.memoryInUse()} bytes`);
  for (const handle of [...states, simulation, box, floor]) handle.dispose();
});

/** An element as a DOM has it. */
const element = (localName, attributes = {}, ...children) => ({
  localName, attributes: Object.entries(attributes).map(([name, value]) => ({ name, value })), children });

test("a drawing is read as a scene of the plane", () => {
  const drawing = element("svg", { "data-gravity": "0 10" },
    element("g", { class: "dynamic", transform: "translate(3 4)" }, element("circle", { id: "ball", r: "2" })),
    element("rect", { width: "4", height: "2", rx: "0.5", "data-systems": "ground" }));
  assert.deepEqual(double.planeScene(drawing), {
    dimension: 2, gravity: [0, -10], bodies: [
      { name: "ball", shape: { type: "circle", circle: { radius: 2 } }, translation: [3, -4], motion: "dynamic" },
      { name: "rect 1", shape: { type: "box", box: { size: [3, 1] }, margin: 0.5 }, translation: [2, -1], systems: ["ground"] }] });
  assert.throws(() => double.planeScene(element("svg", {}, element("rect", { id: "r", width: "-1" }))), {
    name: "InvalidValue", message: 'drawing: <rect id="r">.width: expected a number >= 0, got -1' });
  assert.throws(() => double.planeScene({ ...drawing, children: [{ ...element("circle", { r: "x" }), line: 7 }] }), {
    message: /^drawing: line 7: <circle>\.r: expected/ });
  assert.throws(() => double.planeScene(element("html")), { message: /expected an <svg> element as the root/ });
  let deep = element("g");
  for (let i = 0; i < 2000; i++) deep = element("g", {}, deep);
  assert.throws(() => double.planeScene(element("svg", {}, deep)), { name: "InvalidValue" });
});

/** The triangles of a mesh as their corners. */
const cornersOf = (shape) => {
  const { points, triangles } = double.protocolShape(shape).mesh;
  shape.dispose();
  return triangles.map((t) => t.map((i) => points[i]));
};

test("mesh files are read, whatever their polygons", () => {
  const bytes = (text) => new TextEncoder().encode(text);
  // An arrow's head: a fan from its first corner would lie over the notch.
  const places = [[0, 0, 0], [2, 2, 0], [0, 0.5, 0], [-2, 2, 0]];
  const obj = bytes(`${places.map((p) => `v ${p.join(" ")}`).join("\n")}\nf 2 3 4 1\n`);
  const ply = bytes(`ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n` +
    `element face 1\nproperty list uchar int vertex_indices\nend_header\n${places.map((p) => p.join(" ")).join("\n")}\n4 1 2 3 0\n`);
  const area = (triangles) => triangles.reduce((sum, [p, q, r]) =>
    sum + Math.abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2, 0);
  for (const [file, format] of [[obj, "obj"], [ply, "ply"]]) {
    const triangles = cornersOf(double.meshOfFile(file, format));
    assert.equal(triangles.length, 2);
    assert.equal(area(triangles), 1);
  }
  const stl = bytes("solid one\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid one\n");
  assert.deepEqual(cornersOf(double.meshOfFile(stl, "stl")), [[[0.1, 0, 0], [1, 0, 0], [0, 1, 0]]]);
  const refused = (file, format, message) => assert.throws(() => double.meshOfFile(file, format), { name: "InvalidValue", message });
  refused(bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3x\n"), "obj", /line 4/);
  refused(ply.slice(0, -4), "ply", /expected/);
  refused(bytes("# nothing"), "obj", /expected a mesh with triangles/);
  refused(obj, "gltf", 'format: expected "obj", "ply" or "stl", got "gltf"');
  refused("v 0 0 0", "obj", "bytes: expected a Uint8Array");
});

test("a run of JavaScript is captured", async () => {
  const plane = graze.plane;
  const ball = (library) => (library === plane ? new plane.Circle(0.5) : new graze.Sphere(0.5));
  const floor = (library) => (library === plane ? new plane.HalfPlane() : new graze.HalfSpace());
  for (const library of [graze, plane]) {
    const at = (y) => (library === plane ? [0, y] : [0, y, 0]);
    const parts = [];
    const shapes = [ball(library), floor(library)];
    const simulation = new library.Simulation({ capture: (bytes) => parts.push(bytes) });
    const body = simulation.add({ shape: shapes[0], translation: at(2) });
    simulation.add({ shape: shapes[1], fixed: true });
    simulation.setName(body, "ein Bällchen");
    assert.equal(simulation.world.name(body), ""); // names are of what is replayed
    assert.throws(() => simulation.setName(body, 7), { message: "name: expected a text, got 7" });
    const states = [];
    for (let i = 0; i < 60; i++) {
      if (i === 20) states.push(simulation.save());
      if (i === 40) simulation.restore(states[0]);
      simulation.step(1 / 60);
    }
    states[0].dispose();
    for (let i = 0; i < 16; i++) states[i] = simulation.save();
    assert.throws(() => simulation.save(), { message: /at most 16 states/ });
    const other = new library.Simulation();
    assert.throws(() => other.restore(states[0]), { message: /^state: expected one of this simulation/ });
    const end = simulation.pose(body).translation[1];
    for (const it of [...states, simulation, other]) it.dispose();
    const file = Buffer.concat(parts);
    assert.deepEqual(graze.captureHead(file), { simulation: true, plane: library === plane, scalar: "float" });
    let last;
    let kept;
    const names = new Set();
    const report = graze.replay(file, (world, frame, flat, played) => {
      kept = played;
      assert.equal(played.asleep(world.bodyAt(0)), false);
      assert.deepEqual(played.pose(world.bodyAt(0)), world.pose(world.bodyAt(0)));
      assert.deepEqual([played.joints(), played.world.size], [[], 2]);
      const { kineticEnergy, potentialEnergy } = played.report();
      if (frame === 10) assert.ok(kineticEnergy > 0 && potentialEnergy > 0, `${kineticEnergy} and ${potentialEnergy}`);
      (flat ? plane : graze).draw.simulation(played, { layers: ["joints"] });
      const { shape: whole, fixed, trigger, filter } = world.body(world.bodyAt(1));
      assert.deepEqual([whole.kind, fixed, trigger], [flat ? "halfPlane" : "halfSpace", true, false]);
      assert.deepEqual(filter, { category: 1n, mask: 0xffffffffffffffffn, group: 0 });
      whole.dispose();
      last = world.pose(world.bodyAt(0)).translation[1];
      names.add(`${world.name(world.bodyAt(0))}, ${world.name(world.bodyAt(1))}`);
    });
    assert.deepEqual([...names], ["ein Bällchen, "]);
    assert.deepEqual([report.frames, report.cut, report.difference], [61, false, null]); // with the saves behind the last step
    assert.equal(last, end);
    assert.throws(() => kept.report(), /until its function returns/);

    const calls = [];
    const world = new library.World({ capture: (bytes) => calls.push(bytes) });
    const moved = world.add({ shape: shapes[0], translation: at(0.4) });
    world.add({ shape: shapes[1], fixed: true });
    world.update();
    world.moveBatch([moved], library === plane ? [0, 0.3, 1, 0] : [0, 0.3, 0, 0, 0, 0, 1]);
    world.setFilter(moved, { group: 3 });
    world.setName(moved, "moved");
    world.update(0.1);
    assert.throws(() => world.reduce(1), { message: /not captured, got a captured one/ });
    world.dispose();
    const played = graze.replay(Buffer.concat(calls), (own, frame, flat, simulation) => assert.equal(simulation, null));
    assert.deepEqual([played.simulation, played.frames, played.calls, played.difference], [false, 2, 9, null]);
    for (const shape of shapes) shape.dispose();
  }
  let room = 1;
  const full = new graze.Simulation({ capture: () => { if (room-- <= -1) throw new Error("full"); } });
  assert.throws(() => full.step(0.01), /^Error: full$/);
  full.dispose();
  assert.throws(() => new queries.World({ capture() {} }), { message: /none in graze\/queries/ });
  assert.throws(() => new graze.World({ capture() {}, allow: () => true }), { message: /settings.allow/ });
});

test("a capture is played again", async () => {
  const file = await readFile(new URL("../../fuzz/corpus/capture/whole-file", import.meta.url));
  const seen = [];
  const kept = [];
  const kinds = [];
  const report = graze.replay(file, (world, frame) => {
    kept.push(world);
    seen.push([frame, world.size, world.poses().length / 7]);
    const shape = world.shape(world.bodyAt(1));
    kinds.push(shape.kind);
    shape.dispose();
    graze.draw.world(world, { size: 3 });
  });
  assert.deepEqual([report.simulation, report.plane, report.cut, report.difference], [false, false, false, null]);
  assert.deepEqual(seen.map(([frame]) => frame), Array.from({ length: report.frames }, (_, i) => i + 1));
  assert.deepEqual([kinds[0], kinds.at(-1)], ["capsule", "ellipsoid"]); // as the run has it
  assert.throws(() => kept[0].poses(), /until its function returns/);
  assert.deepEqual(graze.captureHead(file), { simulation: false, plane: false, scalar: "float" });
  assert.deepEqual(double.captureHead(file), graze.captureHead(file));
  assert.throws(() => graze.captureHead(new Uint8Array(30)), { name: "InvalidValue", message: /expected a capture/ });
  assert.equal(graze.replay(file.subarray(0, file.length - 1)).cut, true);
  assert.throws(() => double.replay(file), { message: "bytes: expected a capture of the function's scalar, got one in float" });
  assert.throws(() => graze.replay(new Uint8Array(3)), { name: "InvalidValue" });
  assert.throws(() => graze.replay(file, () => { throw new Error("enough"); }), /enough/);
});

test("every export is declared, and every declaration exported", async () => {
  const declarations = await readFile(path.join(dist, "index.d.ts"), "utf8");
  const names = [...declarations.matchAll(/^export (?:declare )?(?:abstract )?(?:class|function|const|namespace) (\w+)/gm)];
  const declared = [...new Set(names.map((m) => m[1]))].sort();
  assert.deepEqual(Object.keys(double).sort(), declared);
  const inPlane = [...declarations.matchAll(/^  (?:class|function|const) (\w+)/gm)].map((m) => m[1]);
  const plane = Object.keys(double.plane);
  assert.deepEqual(plane.sort(), [...new Set(inPlane)].sort());
  assert.deepEqual(Object.keys(graze).sort(), declared.filter((name) => !["query", "explain", "meshOfFile", "planeScene", "shapeOfProtocol"].includes(name)));
  const only = [
    "query", "explain", "meshOfFile", "planeScene", "hullLayers", "protocolShape", "shapeOfProtocol", "traced", "draw", "tessellate", "captureHead", "replay", "response", "applyImpulse",
    "passOn", "freeBody", "advance", "angularVelocity", "Simulation", "State", "plane"];
  assert.deepEqual(Object.keys(queries).sort(), declared.filter((name) => !only.includes(name)));
});

// Functions in whose place JavaScript has something else: poses and absent members instead of those that make them, points of
// a world whose impulses are written where they stand, traces as objects, convex shapes of one's own by a function of the
// package, shares and buffers that handles and frames hold.
const otherwise = [
  "pose_identity", "pose_at_place", "filter_default", "query_filter_default", "body_default", "plane_body_default",
  "world_settings_default", "bodies", "plane_bodies", "world_solver_points", "plane_world_solver_points", "version",
  "trace_span_draw", "shape_user", "plane_shape_user", "shape_retain", "plane_shape_retain", "buffer_destroy"];

test("every function of the C interface is called by the checks above, or had otherwise", async () => {
  const module = await WebAssembly.compile(await readFile(path.join(dist, "graze-double.wasm")));
  const plain = (names) => [...names].flatMap((name) => name.match(/^graze_(?!js_)(\w+?)(?:_[df])?$/)?.[1] ?? []);
  const all = plain(WebAssembly.Module.exports(module).map(({ name }) => name));
  const reached = new Set(plain(lookedUp));
  assert.ok(all.length > 300, `expected some hundreds of functions, got ${all.length}`);
  assert.deepEqual(all.filter((name) => !reached.has(name)).sort(), otherwise.sort());
});
