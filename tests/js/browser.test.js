// The package in headless Chromium, from a plain <script type="module">: a page runs the checks and posts what came of
// them.

import path from "node:path";
import test from "node:test";
import assert from "node:assert/strict";
import { fileURLToPath } from "node:url";
import { checks } from "./checks.js";
import { postedByPage } from "./chromium.js";

const here = path.dirname(fileURLToPath(import.meta.url));
const project = path.resolve(here, "../..");
const dist = path.resolve(process.env.GRAZE_PACKAGE ?? path.join(project, "bindings/js/dist"));
const longRun = process.env.GRAZE_LONG_RUN ?? path.join(project, "build/npm/long-run.wasm");

/** The file behind an address, or null. */
function fileOf(address) {
  if (address === "/") return path.join(here, "browser.html");
  if (address === "/long-run.wasm") return longRun;
  const [, folder, name, ...rest] = address.split("/");
  if (rest.length > 0 || !/^[\w-]+\.\w+$/.test(name ?? "")) return null;
  return { package: path.join(dist, name), tests: path.join(here, name) }[folder] ?? null;
}

test("the checks in headless Chromium", async (t) => {
  const { results, knowsUsing } = await postedByPage(fileOf, 240);
  assert.deepEqual(results.filter(({ error }) => error !== undefined), []);
  if (!knowsUsing) t.diagnostic("the browser does not know `using`: its checks were left out");
  assert.equal(results.filter(({ group }) => group === "checks").length, checks.length);
  assert.equal(results.some(({ group }) => group === "using"), knowsUsing);
});
