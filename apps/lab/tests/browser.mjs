// The lab in a real browser: every lesson loads, its steps run to the end, a drag changes the numbers to what the
// library says, permalinks restore, nothing is written to the console, and axe finds nothing.
//
//   node tests/browser.mjs            the built lab in dist/
//   LAB_URL=http://...                a server that runs already
//   GRAZE=build/release/bin/graze     the native program answers the questions, else the npm package in Node
//   SCREENSHOTS=folder                pictures of every lesson, light, dark and as a phone shows it

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = fileURLToPath(new URL("..", import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml" };

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

async function library() {
  if (process.env.GRAZE)
    return (line) => spawnSync(process.env.GRAZE, ["query"], { input: `${line}\n`, encoding: "utf8" }).stdout.trim();
  const graze = await import(new URL("../../../bindings/js/dist/double.js", import.meta.url));
  await graze.init();
  return graze.query;
}

const server = process.env.LAB_URL ? { address: process.env.LAB_URL, close() {} } : await serve();
const query = await library();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const axe = readFileSync(join(here, "node_modules/axe-core/axe.min.js"), "utf8");
let failed = 0;

async function visit(hash, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, bypassCSP: options.bypassCSP ?? false, ...options });
  const page = await context.newPage();
  page.trouble = [];
  page.on("console", (m) => m.type() === "error" && page.trouble.push(m.text()));
  page.on("pageerror", (e) => page.trouble.push(e.message));
  page.on("request", (r) => {
    if (!r.url().startsWith(server.address) && !/^(data|blob):/.test(r.url())) page.trouble.push(`asks for ${r.url()}`);
  });
  await page.goto(server.address + hash);
  await page.waitForSelector("h1");
  return page;
}
async function test(name, body) {
  const start = performance.now();
  try {
    await body();
    console.log(`ok    ${name} (${Math.round(performance.now() - start)} ms)`);
  } catch (error) {
    failed++;
    console.log(`FAIL  ${name}\n      ${String(error.message).split("\n").join("\n      ")}`);
  }
}
const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const shown = (page) => page.evaluate(() => window.lab.shown);

const home = await visit("");
const lessons = await home.$$eval(".lessons a", (list) => list.map((a) => a.getAttribute("href")));
await home.context().close();
await test("the list has every lecture", () => assert.ok(lessons.length >= 14, `${lessons.length} lessons`));

for (const lesson of lessons) {
  await test(`${lesson} runs to its end, and its examples too`, async () => {
    const page = await visit(lesson);
    const { steps } = await shown(page);
    assert.ok(steps >= 2, `${steps} steps`);
    const titles = new Set();
    for (let i = 0; i < steps; i++) {
      titles.add(`${i} ${await page.textContent(".words h2")}`);
      const words = (await page.textContent(".words p")).split(/\s+/).length;
      assert.ok(words <= 120, `step ${i + 1} has ${words} words`);
      if (i + 1 < steps) await page.click("[data-next]");
    }
    assert.equal(titles.size, steps);
    assert.equal((await shown(page)).step, steps - 1);
    assert.ok(await page.isDisabled("[data-next]"), "there is a step after the last");
    for (const button of await page.$$(".example")) {
      await button.click();
      await frame(page);
      assert.ok(!(await page.isVisible(".trouble")), await button.textContent());
      await page.click('[aria-label^="Last"]');
      await page.click('[aria-label^="First"]');
    }
    for (const choice of await page.$$eval(".choices button", (list) => list.map((b) => b.textContent))) {
      await page.click(`.choices button:text-is("${choice}")`);
      await frame(page);
      assert.ok(!(await page.isVisible(".trouble")), choice);
      await page.click('[aria-label^="Last"]');
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

  await test(`${lesson} is restored by its permalink, and by undo`, async () => {
    const page = await visit(lesson);
    const before = JSON.stringify((await shown(page)).state);
    const example = await page.$(".example");
    await example.click();
    await frame(page);
    await page.click("[data-next]");
    const state = await shown(page), address = await page.evaluate(() => location.hash);
    assert.notEqual(JSON.stringify(state.state), before);
    const words = await page.textContent(".words"), numbers = await page.textContent(".numbers");
    const other = await visit(address);
    assert.deepEqual(await shown(other), state);
    assert.equal(await other.textContent(".words"), words);
    assert.equal(await other.textContent(".numbers"), numbers);
    await page.click('button:text-is("Undo")');
    await frame(page);
    assert.equal(JSON.stringify((await shown(page)).state), before);
    await page.context().close();
    await other.context().close();
  });

  await test(`${lesson} has no finding of axe`, async () => {
    for (const colorScheme of ["light", "dark"]) {
      const page = await visit(lesson, { bypassCSP: true, colorScheme });
      await page.click('[aria-label^="Last"]');
      await page.evaluate(axe);
      const found = await page.evaluate(() => window.axe.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21aa", "best-practice"] }));
      assert.deepEqual(found.violations.map((v) => `${colorScheme} ${v.id}: ${v.nodes.map((n) => n.target.join(" ")).slice(0, 3)}`), []);
      await page.context().close();
    }
  });

  if (process.env.SCREENSHOTS) {
    mkdirSync(process.env.SCREENSHOTS, { recursive: true });
    const name = lesson.split("/").at(-1);
    for (const [look, options] of Object.entries({
      light: { colorScheme: "light" }, dark: { colorScheme: "dark" },
      phone: { colorScheme: "light", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
    })) {
      const page = await visit(lesson, options);
      await page.click("[data-next]");
      await page.click("[data-next]", { timeout: 500 }).catch(() => {});
      await page.waitForTimeout(200);
      await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name}-${look}.png`) });
      await page.context().close();
    }
  }
}

/** Drags a handle by the mouse. */
async function drag(page, id, dx, dy) {
  const box = await (await page.$(`[data-handle="${id}"]`)).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 4 });
  await page.mouse.move(x + dx, y + dy, { steps: 4 });
  await page.mouse.up();
  await frame(page);
}
const number = (text) => Number(text.replaceAll("−", "-"));

for (const id of ["separating-axes-plane", "fifteen-axes"])
  await test(`${id}: after a drag every overlap is the library's to the last digit`, async () => {
    const page = await visit(`#/lesson/${id}`);
    await page.click('[aria-label^="Last"]');
    const before = await page.textContent(".numbers");
    await drag(page, "move-b", 37, -23);
    await drag(page, "turn-b", -20, 31);
    assert.notEqual(await page.textContent(".numbers"), before);
    await page.click('[aria-label^="Last"]');
    const { state } = await shown(page);
    const { trace } = JSON.parse(query(JSON.stringify({ ...state.q, explain: true })));
    const axes = trace.axes.filter((x) => x.name !== "normal");
    const rows = await page.$$eval(".numbers tbody tr", (list) =>
      list.map((r) => ({ name: r.querySelector("th").textContent, overlap: r.lastElementChild.getAttribute("title") })));
    assert.deepEqual(rows.map((r) => [r.name, number(r.overlap)]), axes.map((x) => [x.name, x.overlap]));
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

await test("GJK: every iteration's bounds are those of the trace, by keyboard too", async () => {
  const page = await visit("#/lesson/gjk");
  await page.focus('[data-handle="move-b"]');
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowUp");
  await frame(page);
  const { state, steps } = await shown(page);
  assert.ok(state.q.b.translation[0] < 3.4);
  const { trace } = JSON.parse(query(JSON.stringify({ ...state.q, explain: true })));
  assert.equal(steps, trace.gjk.length + 2);
  for (const step of trace.gjk) {
    await page.click("[data-next]");
    const said = await page.getAttribute("svg[role=img]", "aria-label");
    const short = (x) => String(Number(x.toPrecision(4))).replaceAll("-", "−");
    assert.ok(said.includes(`between ${short(step.lower)} and ${short(step.upper)}`), said);
  }
  await page.context().close();
});

await test("touch: a finger drags a body", async () => {
  const page = await visit("#/lesson/spheres", { hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });
  const before = (await shown(page)).state.q.b.translation;
  const session = await page.context().newCDPSession(page);
  const box = await (await page.$('[data-handle="move-b"]')).boundingBox();
  const at = (k) => ({ touchPoints: [{ x: box.x + box.width / 2 + k, y: box.y + box.height / 2 + k }] });
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", ...at(0) });
  for (const k of [5, 15, 30]) await session.send("Input.dispatchTouchEvent", { type: "touchMove", ...at(k) });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await frame(page);
  const after = (await shown(page)).state.q.b.translation;
  assert.ok(after[0] > before[0] + 0.05 && after[1] < before[1] - 0.05, `${before} to ${after}`);
  await page.context().close();
});

await test("a page is no wider than a phone", async () => {
  for (const hash of ["", ...lessons]) {
    const page = await visit(hash, { viewport: { width: 360, height: 740 } });
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(over <= 0, `${hash}: ${over} pixels`);
    await page.context().close();
  }
});

await test("an address that makes no sense shows the lesson as it starts", async () => {
  const start = await visit("#/lesson/gjk");
  for (const bad of ["#/lesson/gjk?s=nonsense", "#/lesson/gjk?s=[1]&step=-4", "#/lesson/gjk?step=1e99&s=%7B%22q%22%3A3%7D"]) {
    const page = await visit(bad);
    assert.equal(await page.textContent(".words h2") === "", false);
    assert.deepEqual((await shown(page)).state, (await shown(start)).state);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
  const broken = await visit("#/lesson/gjk?s=" + encodeURIComponent('{"q":{"query":"distance","dimension":2,"a":{"shape":{"type":"box","box":{"size":[1,-2]}}},"b":{"shape":{"type":"box","box":{"size":[1,1]}}}}}'));
  assert.match(await broken.textContent(".trouble"), /size\[1\]/);
  assert.deepEqual(broken.trouble, []);
});

await browser.close();
server.close();
console.log(failed ? `${failed} failed` : "all passed");
process.exit(failed ? 1 : 0);
