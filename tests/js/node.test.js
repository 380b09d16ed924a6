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
import { checks } from "./checks.js";

const here = path.dirname(fileURLToPath(import.meta.url));
const project = path.resolve(here, "../..");
const dist = path.resolve(process.env.GRAZE_PACKAGE ?? path.join(project, "bindings/js/dist"));
const module = (name) => import(pathToFileURL(path.join(dist, name)));
const run = promisify(execFile);

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

test("questions of the protocol's page have the answers of the page", async () => {
  const lines = (await readFile(path.join(project, "docs/protocol.md"), "utf8")).split("\n");
  let asked = 0;
  lines.forEach((line, i) => {
    if (!line.startsWith("{") || !line.includes('"query"') || !lines[i + 1]?.startsWith("{")) return;
    assert.equal(double.query(line), lines[i + 1]);
    ++asked;
  });
  assert.ok(asked >= 12, `expected a dozen questions, got ${asked}`);
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

test("the page's programs print what the page says", async () => {
  const page = await readFile(path.join(project, "docs/javascript.md"), "utf8");
  const programs = blocks(page, "js");
  const outputs = blocks(page, "console");
  assert.ok(programs.length >= 3);
  assert.equal(programs.length, outputs.length, "an output for each program");
  const work = await mkdtemp(path.join(tmpdir(), "graze-js-"));
  try {
    await mkdir(path.join(work, "node_modules"));
    await symlink(dist, path.join(work, "node_modules/graze"));
    await writeFile(path.join(work, "package.json"), '{"type": "module"}');
    for (const [i, program] of programs.entries()) {
      const file = path.join(work, `program${i}.js`);
      await writeFile(file, program);
      const { stdout } = await run(process.execPath, [file]);
      assert.equal(stdout, outputs[i]);
    }
  } finally {
    await rm(work, { recursive: true });
  }
});

test("captures of the plane are played again", async () => {
  for (const of of ["world", "simulation"]) {
    const file = await readFile(new URL(`../../fuzz/corpus/capture/whole-plane-${of}`, import.meta.url));
    const seen = [];
    const report = double.replay(file, (world, frame, plane) => {
      seen.push([frame, plane, world.size, world.poses().length / 4]);
      const shape = world.shape(world.bodyAt(0));
      assert.equal(shape.kind, "halfPlane");
      shape.dispose();
      double.plane.draw.world(world, { size: 3 });
    });
    assert.deepEqual([report.simulation, report.plane, report.difference], [of === "simulation", true, null]);
    assert.deepEqual(double.captureHead(file), { simulation: of === "simulation", plane: true, scalar: "double" });
    assert.equal(seen.length, report.frames);
    assert.deepEqual(seen.at(-1), of === "world" ? [3, true, 3, 3] : [90, true, 4, 4]);
  }
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
  assert.deepEqual(Object.keys(graze).sort(), declared.filter((name) => !["query", "explain"].includes(name)));
  const only = [
    "query", "explain", "traced", "draw", "captureHead", "replay", "response", "applyImpulse", "Simulation", "State", "plane"];
  assert.deepEqual(Object.keys(queries).sort(), declared.filter((name) => !only.includes(name)));
});
