// The package as a stranger gets it: packed by npm, installed from that file into an empty project, and there run in Node,
// bundled by Vite, and seen by TypeScript. Vite and TypeScript are those of the lab; nothing is fetched.

import { copyFile, mkdtemp, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { execFile } from "node:child_process";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { fileURLToPath, pathToFileURL } from "node:url";
import { promisify } from "node:util";
import { postedByPage } from "./chromium.js";
import { pairsOfProtocol } from "./protocol_page.js";

const here = path.dirname(fileURLToPath(import.meta.url));
const project = path.resolve(here, "../..");
const dist = path.resolve(process.env.GRAZE_PACKAGE ?? path.join(project, "bindings/js/dist"));
const lab = path.join(project, "apps/lab/package.json");
const run = promisify(execFile);

let work;
let lines;
/** Runs a program in the project; what it wrote, on whichever output, is the message where it fails. */
const inProject = (program, args) =>
  run(program, args, { cwd: work, env: { ...process.env, npm_config_cache: path.join(work, ".npm"), npm_config_offline: "true" } })
    .catch((error) => assert.fail(`${path.basename(program)}: ${error.stdout}${error.stderr}`));

before(async () => {
  work = await mkdtemp(path.join(tmpdir(), "graze-package-"));
  await writeFile(path.join(work, "package.json"), JSON.stringify({ name: "empty", private: true, type: "module" }));
  const { stdout } = await inProject("npm", ["pack", "--ignore-scripts", "--json", dist]);
  const [{ filename }] = JSON.parse(stdout);
  await inProject("npm", ["install", "--no-audit", "--no-fund", "--ignore-scripts", `./${filename}`]);
  const files = await readdir(path.join(here, "project"));
  await Promise.all(files.map((file) => copyFile(path.join(here, "project", file), path.join(work, file))));
  for (const file of ["assert.js", "types.ts", "using.js"]) await copyFile(path.join(here, file), path.join(work, file));
  lines = pairsOfProtocol(await readFile(path.join(project, "docs/protocol.md"), "utf8"));
  await writeFile(path.join(work, "lines.json"), JSON.stringify(lines.map(([question]) => question)));
});
after(() => rm(work, { recursive: true, force: true }));

/** The answers that the native program gives, which the protocol's page shows. */
const assertNative = (answered) =>
  assert.deepEqual(answered, { distances: [0.5, 0.5, 0.5], lines: lines.map(([, answer]) => answer) });

test("what is packed is what was built", async () => {
  const [packed, built] = await Promise.all([path.join(work, "node_modules/graze"), dist].map((folder) => readdir(folder)));
  assert.deepEqual(packed.sort(), built.sort());
  const { exports, types, version } = JSON.parse(await readFile(path.join(work, "node_modules/graze/package.json"), "utf8"));
  const named = [types, ...Object.values(exports).flatMap((entry) => (typeof entry === "string" ? entry : Object.values(entry)))];
  for (const file of named) assert.ok(file.includes("*") || packed.includes(path.basename(file)), file);
  assert.match(version, /^\d+\.\d+\.\d+$/);
});

test("it runs in Node", async () => {
  await writeFile(path.join(work, "run.js"), `import { answers } from "./answers.js";
    import { readFileSync } from "node:fs";
    console.log(JSON.stringify(await answers(JSON.parse(readFileSync("lines.json", "utf8")))));`);
  assertNative(JSON.parse((await inProject(process.execPath, ["run.js"])).stdout));
});

/** The folder of a page's bundle, which is for browsers of the year 2022. */
async function bundled(page) {
  const { build } = await import(pathToFileURL(createRequire(lab).resolve("vite")));
  const outDir = path.join(work, "bundles", page);
  await build({
    root: work, configFile: false, logLevel: "warn", cacheDir: path.join(work, ".vite"),
    build: { target: "es2022", outDir, rollupOptions: { input: path.join(work, `${page}.html`) } } });
  return outDir;
}
const posted = (folder, page) =>
  postedByPage((address) => path.join(folder, address === "/" ? `${page}.html` : path.normalize(address)), 60);
const modulesIn = async (folder) => (await readdir(path.join(folder, "assets"))).filter((file) => file.endsWith(".wasm"));

test("a page that Vite bundles has the native answers in Chromium", async () => {
  const folder = await bundled("answers");
  assert.equal((await modulesIn(folder)).length, 3);
  assertNative(await posted(folder, "answers"));
});

test("a bundle has the modules of the entries it imports alone", async () => {
  const folder = await bundled("small");
  const modules = await modulesIn(folder);
  assert.equal(modules.length, 1, modules.join());
  assert.match(modules[0], /^graze-queries\b/);
  assert.equal(await posted(folder, "small"), true);
});

test("`using` that Vite lowered gives handles back in Chromium", async () => {
  const folder = await bundled("using");
  for (const file of await readdir(path.join(folder, "assets")))
    if (file.endsWith(".js")) assert.doesNotMatch(await readFile(path.join(folder, "assets", file), "utf8"), /\busing [a-z]\w*=/i);
  const { checked, failed } = await posted(folder, "using");
  assert.deepEqual(failed, []);
  assert.ok(checked > 0);
});

const tsc = (...args) => inProject(path.join(path.dirname(lab), "node_modules/.bin/tsc"), args);

test("`using` that TypeScript lowered gives handles back in Node", async () => {
  const output = ["--outDir", "lowered", "--allowJs", "--checkJs", "false"];
  await tsc("--target", "es2022", "--lib", "esnext,dom", "--module", "esnext", "--moduleResolution", "bundler", ...output, "using-run.js");
  assert.doesNotMatch(await readFile(path.join(work, "lowered/using.js"), "utf8"), /^\s*using /m);
  const { checked, failed } = JSON.parse((await inProject(process.execPath, ["lowered/using-run.js"])).stdout);
  assert.deepEqual(failed, []);
  assert.ok(checked > 0);
});

// A library without `using` first: the types declare what they need of it.
for (const [resolution, module, lib, ...programs] of [
  ["bundler", "esnext", "es2022,dom", "types.ts"],
  ["bundler", "esnext", "esnext,dom", "types.ts", "program.ts"],
  ["node16", "node16", "esnext,dom", "types.ts", "program.ts"]])
  test(`TypeScript takes the types: moduleResolution ${resolution}, lib ${lib}`, async () => {
    const strict = ["--strict", "--noUncheckedIndexedAccess", "--exactOptionalPropertyTypes", "--verbatimModuleSyntax"];
    const options = ["--target", "es2022", "--lib", lib, "--module", module, "--moduleResolution", resolution];
    await tsc("--noEmit", ...strict, ...options, ...programs);
  });
