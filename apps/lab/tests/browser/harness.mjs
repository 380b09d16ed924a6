// The lab in headless Chromium, and the functions that all of its tests use.
//
//   LAB_URL=http://...                a server that runs already, in place of the built lab in dist/
//   GRAZE=build/release/bin/graze     the native program answers the questions, else the npm package in Node
//   CHROMIUM=path                     another browser of this kind
//   ONLY=text                         the tests whose names contain it
//   JOBS=number                       how many run at once
//   QUICK=1                           the half that goes through every lesson and the viewer
//   SCREENSHOTS=folder                pictures of every lesson, light, dark and as a phone shows it

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const here = fileURLToPath(new URL("../..", import.meta.url));
export const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml" };

/** Serves dist/ on a free port of the loopback address. */
async function serve() {
  const dist = join(here, "dist");
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    try {
      const file = join(dist, path === "/" ? "index.html" : path);
      const bytes = readFileSync(file);
      response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export const graze = await import(new URL("../../../../bindings/js/dist/double.js", import.meta.url));
await graze.init();
export const query = process.env.GRAZE
  ? (line) => spawnSync(process.env.GRAZE, ["query"], { input: `${line}\n`, encoding: "utf8" }).stdout.trim()
  : graze.query;
export const server = process.env.LAB_URL ? { address: process.env.LAB_URL, close() {} } : await serve();
// The browser without a window: the one with windows loads its own address bar, some 320 files, with each page. Where a
// processor draws in place of a graphics card, it puts a page together faster without imitating one.
export const launch = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium-headless-shell",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing"],
  });
const browser = await launch();
const axe = readFileSync(join(here, "node_modules/axe-core/axe.min.js"), "utf8");
/** Checks that axe finds nothing on a page that was visited with `axe`. */
export async function accessible(page, look = "light") {
  const { violations } = await page.evaluate(() => window.axe.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"] }));
  assert.deepEqual(violations.map((v) => `${look} ${v.id}: ${v.nodes.map((n) => n.target.join(" ")).slice(0, 3)}`), []);
}

/** Opens a page of the lab, with axe in it if `axe` says so; `files` lie beside it, by their names, as `graze view` serves
 *  them: bytes, or a function for the answer to each request. */
export async function visit(hash, { files = {}, ...options } = {}) {
  // axe would look at what fades from one theme to the other halfway.
  const still = options.axe ? { reducedMotion: "reduce" } : {};
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...still, ...options });
  context.setDefaultTimeout(120_000); // on a machine whose processors have ten times as much to do, a page takes half a minute
  const page = await context.newPage();
  if (options.axe) await page.addInitScript(axe);
  page.trouble = [];
  page.on("console", (m) => m.type() === "error" && page.trouble.push(m.text()));
  page.on("pageerror", (e) => page.trouble.push(e.message));
  page.on("request", (r) => {
    if (!r.url().startsWith(server.address) && !/^(data|blob):/.test(r.url())) page.trouble.push(`asks for ${r.url()}`);
  });
  for (const [name, body] of Object.entries(files)) await page.route(server.address + name, (route) => route.fulfill(typeof body === "function" ? body(route.request()) : { body }));
  await page.goto(server.address + hash);
  await page.waitForSelector("h1");
  await frame(page);
  return page;
}
const idle = [];
/** Runs a test on a page that went through other tests before: to load the library and its shaders anew takes two seconds
 *  of a processor. The page enters a lesson as a reader does who comes from the list of all. A page on which a test failed
 *  is not used again. */
export async function onLesson(hash, look) {
  const page = idle.pop() ?? (await visit("", { ...small, axe: true }));
  await goTo(page, hash);
  await look(page);
  assert.deepEqual(page.trouble, []);
  idle.push(page);
}
/** Goes to a lesson from the list of all, so that it starts anew. */
export async function goTo(page, hash) {
  for (const [address, there] of [["#/", () => document.querySelector("article.home") !== null], [hash, (id) => window.lab.lesson?.id === id]]) {
    await page.evaluate((to) => (location.hash = to), address);
    await page.waitForFunction(there, hash.split("/").at(-1));
  }
  await frame(page);
}

/** Tests wait for frames most of the time: several pages at once take a fraction of it. */
const atOnce = Number(process.env.JOBS ?? 4);
const tests = [];
let failed = 0;
export function test(name, body) {
  if (!process.env.ONLY || name.includes(process.env.ONLY)) tests.push({ name, body });
}
async function runTests() {
  for (let next = tests.shift(); next; next = tests.shift()) {
    const start = performance.now();
    try {
      await next.body();
      console.log(`ok    ${next.name} (${Math.round(performance.now() - start)} ms)`);
    } catch (error) {
      failed++;
      console.log(`FAIL  ${next.name}\n      ${String(error.message).split("\n").join("\n      ")}`);
    }
  }
}
export const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
export const shown = (page) => page.evaluate(() => window.lab.shown);
/** The numbers beside the picture, but for times, which are never twice the same. */
export const numbers = (page) =>
  page.evaluate(() => {
    const copy = document.querySelector(".numbers").cloneNode(true);
    for (const table of copy.querySelectorAll("table"))
      for (const timed of [...table.rows[0].cells].filter((cell) => cell.textContent.includes("µs")))
        for (const row of [...table.rows].slice(1)) row.cells[timed.cellIndex].remove();
    return copy.textContent;
  });

/** Cells of a table's head that say nothing to whoever hears them. */
export const bareColumns = (page) =>
  page.$$eval("thead tr > *", (list) => list.filter((cell) => cell.tagName !== "TH" || !cell.textContent.trim()).map((cell) => cell.closest("table").caption.textContent));

/** Labels of the drawing that are cut, lie on another one, on a wide line, or below a handle; and handles outside of
 *  it. */
export async function unseen(page) {
  await frame(page);
  return page.evaluate(() => {
    const frameOf = (element) => element.getBoundingClientRect(), stage = frameOf(document.querySelector(".stage"));
    const inside = ({ left, top, right, bottom }) => left >= stage.left - 1 && right <= stage.right + 1 && top >= stage.top - 1 && bottom <= stage.bottom + 1;
    const outside = ({ left, top, right, bottom }) => right < stage.left || left > stage.right || bottom < stage.top || top > stage.bottom;
    const labels = [...document.querySelectorAll(".stage2 > svg > g:not(.grid) text, .labels span")].filter((label) => !outside(frameOf(label)));
    const others = [...labels, ...document.querySelectorAll(".handle")];
    /** A line of a font is higher than its letters: two pixels of it may overlap, and a little of a letter's width. */
    const meet = (p, q) => Math.min(p.right, q.right) - Math.max(p.left, q.left) > 2 && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 4;
    const name = (element) => element.dataset.handle ?? element.textContent;
    const lost = [...document.querySelectorAll(".handle")].filter((handle) => {
      const { left, top, right, bottom } = frameOf(handle), [x, y] = [(left + right) / 2, (top + bottom) / 2];
      return x < stage.left || x > stage.right || y < stage.top || y > stage.bottom;
    });
    /** Whether a line goes through the letters, of which the font's line leaves some pixels free. */
    const crosses = (line, { left, top, right, bottom }) => {
      const [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map((end) => line[end].baseVal.value);
      return Array.from({ length: 101 }, (_, i) => [stage.left + x1 + ((x2 - x1) * i) / 100, stage.top + y1 + ((y2 - y1) * i) / 100])
        .some(([x, y]) => x > left + 2 && x < right - 2 && y > top + 5 && y < bottom - 5);
    };
    const crossed = labels.filter((label) => [...document.querySelectorAll(".stage2 line.wide")].some((line) => crosses(line, frameOf(label))));
    return lost.map((handle) => `${name(handle)} is outside`).concat(crossed.map((label) => `${name(label)} lies on a line`), labels.flatMap((label, i) => [
      ...(inside(frameOf(label)) ? [] : [`${name(label)} is cut`]),
      ...others.slice(i + 1).filter((other) => meet(frameOf(label), frameOf(other))).map((other) => `${name(label)} and ${name(other)}`)]));
  });
}

/** Here a processor draws in place of a graphics card: fewer pixels, less time. */
export const small = { viewport: { width: 1000, height: 600 } };

/** Drags a handle by the mouse. */
export async function drag(page, id, dx, dy) {
  const box = await (await page.$(`[data-handle="${id}"]`)).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 4 });
  await page.mouse.move(x + dx, y + dy, { steps: 4 });
  await page.mouse.up();
  await frame(page);
}
export const traced = async (page) => JSON.parse(query(JSON.stringify({ ...(await shown(page)).question, explain: true })));
export const short = (x, digits = 4) => String(Number(x.toPrecision(digits))).replaceAll("-", "−");

/** Ends what a page needs. */
export async function close() {
  await browser.close();
  server.close();
}
/** Runs the chosen tests, and ends the process. */
export async function runAll() {
  await Promise.all(Array.from({ length: atOnce }, runTests));
  await close();
  console.log(failed ? `${failed} failed` : "all passed");
  process.exit(failed ? 1 : 0);
}
