// The programs of "In code", of every lesson with every example and choice: all of them run, and print the answer of
// the query protocol to the same question, or the numbers that the lesson computes where its question is none of it.
//
//   node tests/snippets.mjs               JavaScript runs with the npm package of bindings/js/dist; C++ is compiled
//   LIBGRAZE=build/release/src/libgraze.a C++ is linked with it, and runs
//   PYTHONPATH=build/release/python       Python runs where the package is found; else it is left out
//   GRAZE=build/release/bin/graze         the native program answers for C++ and Python, else the npm package
//   CXX=c++ PYTHON=/usr/bin/python3       the compiler, and the interpreter
//   KEEP=folder                           the programs stay there

import assert from "node:assert/strict";
import { execFile, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { format } from "node:util";
import { build } from "vite";

const start = performance.now();
const lab = fileURLToPath(new URL("..", import.meta.url)), top = join(lab, "../..");
const folder = mkdtempSync(join(tmpdir(), "graze-snippets-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
// Programs in `folder` find the npm package under its name.
mkdirSync(join(folder, "node_modules"));
symlinkSync(join(top, "bindings/js/dist"), join(folder, "node_modules/graze"));

// --- The programs ---

await build({
  root: lab, configFile: false, logLevel: "error",
  build: {
    ssr: true, target: "es2022", outDir: join(folder, "lab"), emptyOutDir: true, copyPublicDir: false,
    rolldownOptions: {
      input: { lessons: join(lab, "src/lessons/index.ts"), code: join(lab, "src/parts/code.ts") },
      external: ["graze/double"], output: { entryFileNames: "[name].mjs", chunkFileNames: "[name].mjs" },
    },
  },
});
const imported = (path) => import(pathToFileURL(join(folder, path)).href);
const graze = await import(new URL("../../../bindings/js/dist/double.js", import.meta.url));
await graze.init();
const { lessons } = await imported("lab/lessons.mjs"), { codeOf } = await imported("lab/code.mjs");

/** The states to which the buttons of the lesson lead from its start. */
function statesOf(lesson) {
  const chosen = (lesson.choices ?? []).flatMap(({ key, label, options }) => options.map((option) => ({
    label: `${label}: ${option.label}`, state: { ...lesson.start, choice: { ...lesson.start.choice, [key]: option.value } } })));
  return [{ label: "start", state: lesson.start }, ...lesson.tryThis, ...lesson.wrong, ...chosen];
}
const native = (line) => spawnSync(process.env.GRAZE, ["query"], { input: `${line}\n`, encoding: "utf8", maxBuffer: 1 << 28 }).stdout;
const answers = new Map();
function answer(question, language) {
  const from = language !== "JavaScript" && process.env.GRAZE ? native : graze.query, key = JSON.stringify(question);
  const place = `${from === native} ${key}`;
  if (!answers.has(place)) answers.set(place, JSON.parse(from(key)));
  return answers.get(place);
}
/** The numbers that a program prints, in its order. */
function printed(question, language) {
  const told = answer(question, language);
  assert.ok(!told.error, told.error);
  switch (question.query) {
    case "overlap": return [told.overlap];
    case "distance": return [told.distance, ...told.normal, ...told.a, ...told.b];
    case "closest": return [told.distance, ...told.point, ...told.normal];
    case "raycast":
    case "cast": return told.hit ? [told.t, ...told.point, ...told.normal] : [];
    case "response":
      return [told.normalImpulse, ...told.impulse, ...["a", "b"].flatMap((w) => [...told[w].linear, ...told[w].angular])];
    default: // contacts
      return [language === "Python" ? told.manifolds.length : told.overlap,
        ...told.manifolds.flatMap((m) => [...m.normal, ...m.points.flatMap((p) => [...p.a, ...p.b, p.distance])])];
  }
}
/** Each text once, with all the places where it is shown. */
const programs = { "C++": new Map(), Python: new Map(), JavaScript: new Map() };
for (const lesson of lessons)
  for (const { label, state } of statesOf(lesson)) {
    const question = lesson.asks ? lesson.asks(state) : state.q, own = lesson.code?.(state);
    const texts = own?.programs ?? codeOf(question), name = `lesson ${lesson.number} (${lesson.id}), ${label}`;
    // Broad phases are no part of the Python package.
    const expected = lesson.id === "broad-phases" ? ["C++", "JavaScript"] : ["C++", "Python", "JavaScript"];
    assert.deepEqual(Object.keys(texts).sort(), [...expected].sort(), name);
    for (const [language, text] of Object.entries(texts)) {
      const prints = own ? own.prints() : printed(question, language), known = programs[language].get(text);
      if (known) assert.deepEqual(known.prints, prints, `${name} has the program of ${known.name}, and another answer`);
      else programs[language].set(text, { name, text, prints });
    }
  }
const all = Object.fromEntries(Object.entries(programs).map(([language, map]) => [language, [...map.values()]]));
for (const [language, list] of Object.entries(all)) for (const [i, program] of list.entries()) {
  assert.ok(program.text.split("\n").every((x) => x.length <= 120), `${program.name}: a line of ${language} is too long`);
  if (process.env.KEEP) {
    mkdirSync(process.env.KEEP, { recursive: true });
    writeFileSync(join(process.env.KEEP, `${i}.${{ "C++": "cpp", Python: "py", JavaScript: "mjs" }[language]}`),
      `${program.text}\n`);
  }
}

// --- Their output ---

let failed = 0;
const troubled = new Set();
function fail(language, name, why) {
  failed++;
  troubled.add(language);
  console.log(`FAIL  ${language}, ${name}\n      ${String(why).split("\n").join("\n      ")}`);
}
/** C++ prints nine digits; a pose made by another standard library's sine differs in the last of sixteen. */
const near = (x, y) => typeof x === "boolean" || typeof y === "boolean" ? x === y : Math.abs(x - y) <= 1e-8 * Math.max(1, Math.abs(y));
function compare(language, { name, prints }, output) {
  const found = [...output.matchAll(/true|false|[-+]?\b\d+(?:\.\d*)?(?:e[-+]?\d+)?|nan|inf/gi)].map(([word]) =>
    (/^(true|false)$/i.test(word) ? word.toLowerCase() === "true" : Number(word)));
  if (found.length !== prints.length || !found.every((x, i) => near(x, prints[i])))
    fail(language, name, `prints   ${found.join(" ")}\nexpected ${prints.join(" ")}`);
}
const finished = (language, what, since) =>
  console.log(`${troubled.has(language) ? "FAIL" : "ok  "}  ${all[language].length} programs in ${language} ${what} (${Math.round(performance.now() - since)} ms)`);
const run = (file, args, options = {}) => new Promise((done) =>
  execFile(file, args, { cwd: folder, maxBuffer: 1 << 28, ...options }, (error, stdout, stderr) => done({ error, stdout, stderr })));
const mark = "--- next program ---";
const parts = (output) => output.split(`${mark}\n`).slice(1);

// --- JavaScript: modules as they stand ---

async function javascript() {
  const since = performance.now(), { log } = console;
  for (const [i, program] of all.JavaScript.entries()) {
    writeFileSync(join(folder, `${i}.mjs`), program.text);
    let output = "", trouble;
    console.log = (...values) => { output += `${format(...values)}\n`; };
    try {
      await imported(`${i}.mjs`);
    } catch (error) {
      trouble = error;
    } finally {
      console.log = log;
    }
    if (trouble) fail("JavaScript", program.name, `${trouble.stack}\n${program.text}`);
    else compare("JavaScript", program, output);
  }
  finished("JavaScript", "run", since);
}

// --- Python: scripts as they stand, in one interpreter ---

async function python() {
  const since = performance.now(), interpreter = process.env.PYTHON ?? "/usr/bin/python3";
  const env = { ...process.env, PYTHONPATH: process.env.PYTHONPATH ?? "" };
  if ((await run(interpreter, ["-c", "import graze"], { env })).error) {
    console.log("skip  Python: the package graze is not found");
    return;
  }
  all.Python.forEach(({ text }, i) => writeFileSync(join(folder, `${i}.py`), text));
  writeFileSync(join(folder, "all.py"), `import runpy, traceback
for i in range(${all.Python.length}):
    print("${mark}")
    try:
        runpy.run_path(f"{i}.py")
    except Exception:
        traceback.print_exc(file=__import__("sys").stdout)
`);
  const { error, stdout, stderr } = await run(interpreter, ["all.py"], { env });
  if (error) return fail("Python", "all", stderr);
  parts(stdout).forEach((output, i) => (output.includes("Traceback")
    ? fail("Python", all.Python[i].name, `${output}${all.Python[i].text}`) : compare("Python", all.Python[i], output)));
  finished("Python", "run", since);
}

// --- C++: all in few files, each in a namespace; and one of each set of headers as it stands ---

const includesOf = (text) => text.match(/^#include .*$/gm);

async function cpp() {
  const since = performance.now(), compiler = process.env.CXX ?? "c++", library = process.env.LIBGRAZE;
  const flags = ["-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", `-I${join(top, "include")}`];
  const list = all["C++"], atOnce = Math.min(availableParallelism(), 8), chunks = Array.from({ length: atOnce }, () => []);
  list.forEach((program, i) => chunks[i % atOnce].push({ ...program, i }));
  const jobs = chunks.filter((chunk) => chunk.length).map((chunk, number) => async () => {
    const includes = new Set(chunk.flatMap(({ text }) => includesOf(text)));
    const bodies = chunk.map(({ name, text, i }) =>
      `// ${name}\nnamespace program_${i} {\n${text.replace(/^#include .*$/gm, "").replace("int main() {", "void run() {")}\n}\n`);
    const file = join(folder, `part_${number}.cpp`);
    writeFileSync(file, `${[...includes].join("\n")}\n${bodies.join("\n")}`);
    const { error, stderr } = await run(compiler, [...flags, ...(library ? ["-c"] : ["-fsyntax-only"]), file]);
    if (error) fail("C++", `part ${number}`, stderr.slice(0, 4000));
  });
  const wholes = new Map(list.map((program) => [String(includesOf(program.text)), program]));
  for (const [number, program] of [...wholes.values()].entries())
    jobs.push(async () => {
      const file = join(folder, `whole_${number}.cpp`), out = join(folder, `whole_${number}`);
      writeFileSync(file, program.text);
      const made = await run(compiler, [...flags, file, ...(library ? [library, "-pthread", "-o", out] : ["-fsyntax-only"])]);
      if (made.error) return fail("C++", program.name, made.stderr.slice(0, 4000));
      if (library) compare("C++", program, (await run(out, [])).stdout);
    });
  const workers = Array.from({ length: atOnce }, async () => {
    for (let job = jobs.shift(); job; job = jobs.shift()) await job();
  });
  await Promise.all(workers);
  if (!library || troubled.has("C++")) return finished("C++", "compiled", since);
  writeFileSync(join(folder, "all.cpp"), `#include <cstdio>
${list.map((_, i) => `namespace program_${i} { void run(); }`).join("\n")}
int main() {
${list.map((_, i) => `  std::puts("${mark}");\n  program_${i}::run();`).join("\n")}
}
`);
  const objects = chunks.flatMap((chunk, number) => (chunk.length ? [`part_${number}.o`] : []));
  const linked = await run(compiler, [...flags, "all.cpp", ...objects, library, "-pthread", "-o", join(folder, "all")]);
  if (linked.error) return fail("C++", "linking", linked.stderr.slice(0, 4000));
  const { error, stdout, stderr } = await run(join(folder, "all"), []);
  if (error) return fail("C++", "running", stderr);
  parts(stdout).forEach((output, i) => compare("C++", list[i], output));
  finished("C++", `compiled and run, ${wholes.size} of them by themselves as well`, since);
}

await javascript();
await python();
await cpp();
console.log(failed ? `${failed} failed` : `all passed (${Math.round((performance.now() - start) / 1000)} s)`);
process.exit(failed ? 1 : 0);
