// The lab in a real browser: every lesson loads, its steps run to the end, a drag changes the numbers to what the
// library says, permalinks restore, nothing is written to the console, and axe finds nothing.
//
//   node tests/browser.mjs            the built lab in dist/
//   LAB_URL=http://...                a server that runs already
//   GRAZE=build/release/bin/graze     the native program answers the questions, else the npm package in Node
//   ONLY=text                         the tests whose names contain it
//   JOBS=number                       how many run at once
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

const graze = await import(new URL("../../../bindings/js/dist/double.js", import.meta.url));
await graze.init();
const query = process.env.GRAZE
  ? (line) => spawnSync(process.env.GRAZE, ["query"], { input: `${line}\n`, encoding: "utf8" }).stdout.trim()
  : graze.query;

/** Fifteen boxes that fall into a heap: two seconds, as a program captures them. */
function capturedHeap() {
  const frames = [];
  const simulation = new graze.Simulation({ capture: (bytes) => frames.push(bytes) });
  const box = new graze.Box([1, 1, 1]);
  const floor = new graze.HalfSpace();
  simulation.add({ shape: floor, fixed: true });
  for (let i = 0; i < 15; i++)
    simulation.add({ shape: box, translation: [(i % 3) * 0.9 - 0.9, 1 + Math.floor(i / 3) * 1.2, (i % 2) * 0.3] }, { density: 1 });
  for (let i = 0; i < 120; i++) simulation.step(1 / 60);
  for (const made of [simulation, box, floor]) made.dispose();
  return Buffer.concat(frames);
}

const server = process.env.LAB_URL ? { address: process.env.LAB_URL, close() {} } : await serve();
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
  await frame(page);
  return page;
}
/** Tests wait for frames most of the time: several pages at once take a fraction of it. */
const atOnce = Number(process.env.JOBS ?? 4);
const tests = [];
function test(name, body) {
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
const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const shown = (page) => page.evaluate(() => window.lab.shown);
/** The numbers beside the picture, but for times, which are never twice the same. */
const numbers = (page) =>
  page.evaluate(() => {
    const copy = document.querySelector(".numbers").cloneNode(true);
    for (const table of copy.querySelectorAll("table"))
      for (const timed of [...table.rows[0].cells].filter((cell) => cell.textContent.includes("µs")))
        for (const row of [...table.rows].slice(1)) row.cells[timed.cellIndex].remove();
    return copy.textContent;
  });

const home = await visit("");
/** Here a processor draws in place of a graphics card: fewer pixels, less time. */
const small = { viewport: { width: 1000, height: 600 } };
const lessons = await home.$$eval(".lessons a", (list) => list.map((a) => a.getAttribute("href")));
await home.context().close();
test("the list has every lecture", () => assert.ok(lessons.length >= 14, `${lessons.length} lessons`));

for (const lesson of lessons) {
  test(`${lesson} runs to its end, and its examples too`, async () => {
    const page = await visit(lesson, small);
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
      await page.click('button[aria-label^="Last"]');
      await page.click('button[aria-label^="First"]');
    }
    for (const choice of await page.$$eval(".choices button", (list) => list.map((b) => b.textContent))) {
      await page.click(`.choices button:text-is("${choice}")`);
      await frame(page);
      assert.ok(!(await page.isVisible(".trouble")), choice);
      await page.click('button[aria-label^="Last"]');
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

  test(`${lesson} is restored by its permalink, and by undo`, async () => {
    const page = await visit(lesson);
    const before = JSON.stringify((await shown(page)).state);
    const example = await page.$(".example");
    await example.click();
    await frame(page);
    await page.click("[data-next]");
    const state = await shown(page), address = await page.evaluate(() => location.hash);
    assert.notEqual(JSON.stringify(state.state), before);
    const words = await page.textContent(".words"), beside = await numbers(page);
    const other = await visit(address);
    assert.deepEqual(await shown(other), state);
    assert.equal(await other.textContent(".words"), words);
    assert.equal(await numbers(other), beside);
    await page.click('button:text-is("Undo")');
    await frame(page);
    assert.equal(JSON.stringify((await shown(page)).state), before);
    await page.context().close();
    await other.context().close();
  });

  test(`${lesson} has no finding of axe`, async () => {
    // Colours are the same for all: a third of the lessons is enough for the dark ones.
    for (const colorScheme of lessons.indexOf(lesson) % 3 === 0 ? ["light", "dark"] : ["light"]) {
      const page = await visit(lesson, { ...small, bypassCSP: true, colorScheme });
      await page.click('button[aria-label^="Last"]');
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
/** Goes to the step whose title is this. */
async function step(page, title) {
  await page.click('button[aria-label^="First"]');
  while (!title.test(await page.textContent(".words h2"))) await page.click("[data-next]");
}
const example = async (page, label) => {
  await page.click(`.example:text-is("${label}")`);
  await frame(page);
};
/** The axes beside the picture; a gap is a negative overlap. */
const axisRows = (page) =>
  page.$$eval(".numbers tbody tr", (list) => list.map((r) => {
    const [overlap, gap] = [...r.cells].slice(-2).map((c) => c.getAttribute("title"));
    return { name: r.querySelector("th").textContent, overlap: overlap === null ? -Number(gap) : Number(overlap), wins: r.classList.contains("is-winner") };
  }));
const traced = async (page) => JSON.parse(query(JSON.stringify({ ...(await shown(page)).question, explain: true })));
const short = (x, digits = 4) => String(Number(x.toPrecision(digits))).replaceAll("-", "−");

for (const id of ["separating-axes-plane", "fifteen-axes"])
  test(`${id}: after a drag every overlap is the library's to the last digit`, async () => {
    const page = await visit(`#/lesson/${id}`);
    await page.click('button[aria-label^="Last"]');
    const before = await page.textContent(".numbers");
    await drag(page, "move-b", 37, -23);
    await drag(page, "turn-b", -20, 31);
    assert.notEqual(await page.textContent(".numbers"), before);
    const { state } = await shown(page);
    const { trace } = JSON.parse(query(JSON.stringify({ ...state.q, explain: true })));
    const axes = trace.axes.filter((x) => x.name !== "normal");
    await step(page, /^(They are apart|The least overlap wins|A gap: )/);
    const rows = await axisRows(page);
    assert.deepEqual(rows.map((r) => [r.name, r.overlap]), axes.map((x) => [x.name, x.overlap]));
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

test("separating axes: what is said of a gap is true, whatever is nearest", async () => {
  const page = await visit("#/lesson/separating-axes-plane");
  await example(page, "Corner to corner");
  const { state } = await shown(page), { trace } = await traced(page);
  assert.equal(trace.winner, "normal");
  const axes = trace.axes.filter((x) => x.name !== "normal");
  const widest = axes.reduce((best, x) => (x.overlap < best.overlap ? x : best));
  await step(page, /^They are apart/);
  assert.ok((await page.textContent(".words")).includes(`${widest.name} shows the widest gap, ${short(-widest.overlap)}`));
  assert.match(await page.textContent(".words"), /It is not the distance/);
  assert.deepEqual((await axisRows(page)).filter((r) => r.wins).map((r) => r.name), [widest.name]);
  const { distance } = JSON.parse(query(JSON.stringify({ ...state.q, query: "distance" })));
  assert.ok(-widest.overlap < distance - 0.01);
  await page.click("[data-next]");
  assert.ok((await page.textContent(".words")).includes(`The true distance, ${short(distance)}`));
  assert.ok(await page.isDisabled("[data-next]"));
  await example(page, "A gap on the last axis");
  const last = (await traced(page)).trace.axes.filter((x) => x.name !== "normal");
  assert.deepEqual(last.map((x) => x.overlap < 0), [false, false, false, true]);
  await step(page, /^They are apart/);
  assert.match(await page.textContent(".words"), /B1 shows the widest gap.*It is the distance too/);
  // A0 overlaps, and the nearest are corners: nothing negative is called a gap.
  const mixed = await visit("#/lesson/separating-axes-plane?s=" + encodeURIComponent(JSON.stringify({ q: { ...state.q, b: { ...state.q.b, translation: [2.6, 2.6], rotation: 0.9 } } })));
  const far = (await traced(mixed)).trace;
  assert.ok(far.axes.some((x) => x.overlap > 0) && far.axes.some((x) => x.overlap < 0), JSON.stringify(far.axes));
  await mixed.click('button[aria-label^="Last"]');
  for (const row of await axisRows(mixed)) assert.equal(row.overlap, far.axes.find((x) => x.name === row.name.replace("a to b", "normal")).overlap);
  assert.doesNotMatch(await mixed.textContent(".words p"), /−/);
  assert.deepEqual([...page.trouble, ...mixed.trouble], []);
  await page.context().close();
  await mixed.context().close();
});

test("fifteen axes: the examples are what they are called, and gaps are bounds", async () => {
  const page = await visit("#/lesson/fifteen-axes");
  await example(page, "Edge on edge");
  assert.match((await traced(page)).trace.winner, /×/);
  await example(page, "What six axes miss");
  const { overlap, trace } = await traced(page);
  assert.equal(overlap, false);
  assert.ok(trace.axes.filter((x) => x.name !== "normal").every((x) => x.overlap >= 0 || x.name.includes("×")));
  await page.click('button[aria-label^="Last"]');
  assert.match(await page.textContent(".words p"), /wrong on the safe side/);
  await example(page, "Corner to corner");
  await page.click('button[aria-label^="Last"]');
  const { distance } = JSON.parse(query(JSON.stringify({ ...(await shown(page)).question, query: "distance" })));
  const [widest] = (await axisRows(page)).filter((r) => r.wins);
  assert.ok(-widest.overlap < distance - 0.01);
  assert.ok((await page.textContent(".words")).includes(`at least ${short(-widest.overlap)}`) && (await page.textContent(".words")).includes(`the distance is ${short(distance)}`));
  await page.context().close();
});

test("contact set: the reference face is the one whose sides cut, and edges are not cut", async () => {
  const page = await visit("#/lesson/contact-set");
  const { trace } = await traced(page);
  const near = (face, p) => Math.min(...face.map((x) => Math.hypot(...x.map((v, i) => v - p[i]))));
  const whose = near(trace.faces.b, trace.cuts[0].from) < 1e-9 ? "B" : "A";
  await step(page, /^Reference and incident/);
  assert.ok((await page.textContent(".words p")).includes(`the reference face, here ${whose}'s`));
  await example(page, "Edge on edge");
  assert.equal((await traced(page)).manifolds[0].points.length, 1);
  await step(page, /^Two edges cross$/);
  await page.click("[data-next]");
  assert.match(await page.textContent(".words h2"), /^Point 1: edge .* of A × edge .* of B$/);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("Minkowski sum: a corner is the sum that stands below it", async () => {
  const page = await visit("#/lesson/minkowski");
  await page.click('.choices button:text-is("sum A ⊕ B")');
  await step(page, /^Corner 2 of/);
  const formula = (await page.$$eval(".words math", (list) => list.map((m) => m.textContent)))[1].replaceAll("−", "-");
  const [ax, ay, bx, by, x, y] = formula.match(/-?[\d.]+(e-?\d+)?/g).map(Number);
  assert.ok(formula.includes(")+("), formula);
  assert.ok(Math.abs(ax + bx - x) < 2e-3 && Math.abs(ay + by - y) < 2e-3, formula);
  await page.context().close();
});

test("GJK: every iteration's bounds are those of the trace, by keyboard too", async () => {
  const page = await visit("#/lesson/gjk");
  await page.focus('[data-handle="move-b"]');
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowUp");
  await frame(page);
  const { state, steps } = await shown(page);
  const [x, y] = state.q.b.translation;
  assert.ok(Math.abs((3.4 - x) / (y - 1.1) - 50) < 1e-6, `five steps left and a tenth up, not one of them lost: ${x}, ${y}`);
  const { trace } = JSON.parse(query(JSON.stringify({ ...state.q, explain: true })));
  assert.equal(steps, trace.gjk.length + 2);
  for (const step of trace.gjk) {
    await page.click("[data-next]");
    const said = await page.getAttribute("svg[role=img]", "aria-label");
    assert.ok(said.includes(`between ${short(step.lower)} and ${short(step.upper)}`), said);
  }
  await page.context().close();
});

test("GJK: what ends the search is said as it is: inside, on an edge, far away, in space", async () => {
  const page = await visit("#/lesson/gjk");
  const lastIteration = async () => {
    const { trace } = await traced(page);
    await step(page, new RegExp(`^Iteration ${trace.gjk.length}:`));
    return trace;
  };
  await example(page, "Origin inside");
  await lastIteration();
  assert.match(await page.textContent(".words h2"), /O is inside the triangle/);
  assert.deepEqual(await page.$$eval(".numbers tbody th", (list) => list.map((c) => c.textContent)), ["w1", "w2", "w3"]);
  await example(page, "Origin on an edge");
  await lastIteration();
  assert.match(await page.textContent(".words"), /O lies on a side of a triangle.*the shapes touch/);
  assert.doesNotMatch(await page.textContent(".words"), /inside/);
  await example(page, "Very far away");
  const seen = await page.$$eval(".stage2 .shape", (list) => list.map((x) => x.getBoundingClientRect().toJSON()));
  const frame = await page.$eval(".stage2", (x) => x.getBoundingClientRect().toJSON());
  assert.equal(seen.length, 2);
  for (const shape of seen) assert.ok(shape.left > frame.left && shape.right < frame.right && shape.top > frame.top && shape.bottom < frame.bottom, JSON.stringify(shape));
  const { upper } = (await lastIteration()).gjk.at(-1), { distance } = await traced(page);
  assert.notEqual(upper.toPrecision(15), distance.toPrecision(15));
  await page.click('button[aria-label^="Last"]');
  for (const x of [upper, distance]) assert.ok((await page.textContent(".numbers")).includes(short(x, 15)));
  await page.click('button:text-is("Start again")');
  assert.ok((await page.$$eval(".stage2 .shape", (list) => list.length)) === 2);
  assert.deepEqual(page.trouble, []);
  await page.context().close();

  const space = await visit("#/lesson/gjk-space"), { trace } = await traced(space);
  for (const [i, { lower, upper }] of trace.gjk.entries()) {
    await space.click("[data-next]");
    const formulas = await space.$$eval(".words math", (list) => list.map((m) => m.textContent));
    const told = Number(formulas[2].split("=")[1].replaceAll("−", "-"));
    assert.ok(Math.abs(told - (upper - lower)) <= 0.06 * (upper - lower), `${i}: ${formulas} for ${upper - lower}`);
  }
  await space.context().close();
});

/** Of lessons whose steps are those of a trace: how many steps come before, and the numbers of each as the library has them. */
const walks = {
  epa: ({ trace }) => [1, trace.epa.map((s) => [s.polygon.length, s.faceDepth, s.foundDepth])],
  "time-of-impact": ({ trace }) => [2, (trace.steps ?? []).map((s) => [s.t, s.distance])],
  "contact-set": ({ trace, manifolds }) => [2 + trace.cuts.length, manifolds[0].points.map((p) => [p.distance])],
};
for (const [id, walk] of Object.entries(walks))
  test(`${id}: every step shows the trace's numbers to the last digit`, async () => {
    const page = await visit(`#/lesson/${id}`);
    for (const label of [null, await page.textContent(".example")]) {
      if (label) await example(page, label);
      await page.click('button[aria-label^="First"]');
      await frame(page);
      const { question } = await shown(page), answer = JSON.parse(query(JSON.stringify({ ...question, explain: true })));
      if (answer.distance > 0 || answer.hit === false || !answer.trace.method) continue; // nothing to walk through
      const [before, list] = walk(answer);
      for (let i = 1; i < before; i++) await page.click("[data-next]");
      for (const step of list) {
        await page.click("[data-next]");
        const told = await page.$eval(".numbers tbody tr:last-child", (row) => [...row.cells].map((c) => c.getAttribute("title")).filter(Boolean));
        assert.deepEqual(told.map(Number), step, JSON.stringify(question));
      }
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

test("large hulls: every layer's counts and the total are the library's", async () => {
  const page = await visit("#/lesson/hulls");
  await drag(page, "direction", -60, 40);
  const { state, steps } = await shown(page);
  const count = state.choice.count, u = ["x", "y", "z"].map((k) => state.choice[k]), length = Math.hypot(...u);
  const hull = new graze.ConvexHull(Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count, r = Math.sqrt(1 - y * y), angle = i * Math.PI * (3 - Math.sqrt(5));
    return [1.3 * r * Math.cos(angle), 0.9 * y, 0.9 * r * Math.sin(angle)];
  }));
  const { trace } = graze.traced.support(hull, u.map((x) => x / length));
  assert.equal(steps, trace.layers.length + 4);
  await page.click("[data-next]");
  for (const layer of trace.layers) {
    await page.click("[data-next]");
    const said = await page.getAttribute("canvas[role=img]", "aria-label");
    assert.ok(said.startsWith(`${layer.lookedAt.length} of ${layer.vertices.toLocaleString("en")} points`), said);
  }
  await page.click("[data-next]");
  assert.equal(await page.textContent(".words h2"), `${trace.products} instead of 1,000`);
  hull.dispose();
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("broad phases: the box that asks meets other bodies where it is dragged to", async () => {
  for (const kind of ["tree", "sort and sweep", "grid"]) {
    const page = await visit("#/lesson/broad-phases", small);
    await page.click(`.choices button:text-is("${kind}")`);
    await page.click("[data-next]");
    const said = () => page.getAttribute("canvas[role=img]", "aria-label");
    const before = await said();
    await drag(page, "ask", 90, -60);
    assert.notEqual(await said(), before);
    const [, hits, met, parts] = /(\d+) bodies .* (\d+) of (\d+) parts/.exec(await said()).map(Number);
    assert.ok(hits < 100 && met <= parts && (parts > 0) === (kind !== "sort and sweep"), await said());
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("a stack: the deepest contact after a second is the library's", async () => {
  const page = await visit("#/lesson/stack");
  await page.click('.choices button:text-is("4")');
  const simulation = new graze.Simulation({ sleep: false, subSteps: 4, mostSubSteps: 4 });
  const box = new graze.Box([1, 1, 1]), floor = new graze.HalfSpace(), rough = { staticFriction: 0.6, dynamicFriction: 0.6 };
  simulation.add({ shape: floor, fixed: true }, {}, rough);
  for (let i = 0; i < 10; i++) simulation.add({ shape: box, translation: [i % 2 === 0 ? 0.04 : -0.04, 0.5 + i, 0] }, { mass: 1 }, rough);
  for (let i = 0; i < 60; i++) simulation.step(1 / 60);
  await page.click('button[aria-label^="Last"]');
  const cells = await page.$$eval(".numbers tr.is-now td[title]", (list) => list.map((cell) => cell.title));
  assert.equal(Number(cells[0]), simulation.report().deepest * 1000);
  for (const made of [simulation, box, floor]) made.dispose();
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("EPA: the way out ends on the nearest side, in space the polytope grows, and both have a last word", async () => {
  const page = await visit("#/lesson/epa");
  const { trace, distance } = await traced(page);
  for (const _ of trace.epa) {
    await page.click("[data-next]");
    const off = await page.evaluate(() => {
      const line = (kind) => ["x1", "y1", "x2", "y2"].map((k) => Number(document.querySelector(`.stage2 line.of-${kind}.wide`).getAttribute(k)));
      const [x1, y1, x2, y2] = line("axis"), [, , x, y] = line("made");
      return Math.abs((x2 - x1) * (y - y1) - (y2 - y1) * (x - x1)) / Math.hypot(x2 - x1, y2 - y1);
    });
    assert.ok(off < 0.5, `the tip is ${off} pixels from the side`);
  }
  await page.click("[data-next]");
  assert.ok((await page.textContent(".words")).includes(short(distance, 8)));
  assert.ok(await page.isDisabled("[data-next]"));
  await page.context().close();

  const space = await visit("#/lesson/epa-space");
  for (const label of [null, "Same centre, same axis"]) {
    if (label) await example(space, label);
    await space.click('button[aria-label^="First"]');
    const answer = await traced(space), { epa, polytope } = answer.trace;
    assert.ok(!(await space.textContent(".words p")).includes("as it is at the end"), "the corners are not in the order of the steps");
    assert.equal((await shown(space)).steps, epa.length + 2);
    // A corner for each step beside those of the tetrahedron, and two triangles more.
    assert.equal(polytope.points.length, epa.length + 4);
    const picture = await space.$(".stage3 canvas"), before = await picture.screenshot();
    for (let i = 0; i < 3; i++) await space.click("[data-next]");
    await frame(space);
    assert.notDeepEqual(await picture.screenshot(), before);
    await space.click('button[aria-label^="Last"]');
    assert.equal(await space.textContent(".words h2"), "Depth and normal");
    assert.ok((await space.textContent(".words")).includes(short(answer.distance, 8)));
  }
  assert.deepEqual(space.trouble, []);
  await space.context().close();
});

test("time of impact: frames miss what the cast finds, hulls answer whether, and a thousand turns how long it takes", async () => {
  const page = await visit("#/lesson/time-of-impact");
  for (const label of [null, "Ball and thin wall"]) {
    if (label) await example(page, label);
    await step(page, /^Frame by frame$/);
    assert.match(await page.textContent(".words p"), /In none of them .* A tunnels/);
    assert.equal((await traced(page)).hit, true);
  }
  await step(page, /^All that A sweeps$/);
  assert.match(await page.textContent(".words p"), /whether they meet at all: yes/);
  await example(page, "Turning on the spot");
  const { t, trace } = await traced(page);
  assert.ok(t > 0 && trace.steps.length > 1);
  await example(page, "A thousand turns");
  const turned = await traced(page);
  assert.ok(turned.hit && turned.bounded === undefined && turned.trace.steps.length < 30, `${turned.trace.steps.length} steps`);
  const moves = turned.trace.steps;
  await step(page, /^The start/);
  for (let i = 0; i + 1 < moves.length; i++) {
    const told = (await page.$$eval(".words math", (list) => list.map((m) => m.textContent)))[1];
    assert.ok(told.endsWith(`=${short(moves[i + 1].t, 8)}`), told);
    await page.click("[data-next]");
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("planes: three points, a distance and a normal give the same plane, and a line gives none", async () => {
  const page = await visit("#/lesson/planes-boxes");
  const before = (await traced(page)).distance, rest = async () => Math.abs((await traced(page)).distance - before);
  await page.click('.choices button:text-is("three points")');
  await frame(page);
  assert.equal(await rest(), 0);
  await drag(page, "point-1", 0, -30);
  assert.ok(await rest() > 1e-3, "the plane follows its points");
  const { state } = await shown(page), n = (await traced(page)).normal;
  const at = (name) => [0, 1, 2].map((k) => state.choice[`${name}${k}`]);
  const along = (p) => p.reduce((sum, x, i) => sum + x * n[i], 0);
  for (const name of ["q", "r"]) assert.ok(Math.abs(along(at(name)) - along(at("p"))) < 1e-9, `${name} is not in the plane`);
  await page.click('.choices button:text-is("normal and distance")');
  await frame(page);
  const apart = (await traced(page)).distance;
  await drag(page, "foot", 0, -40);
  assert.ok((await traced(page)).distance < apart - 1e-3, "the plane comes nearer to the box above it");
  await example(page, "Three points on a line");
  assert.match(await page.textContent(".words h2"), /no plane/);
  await page.click('.choices button:text-is("three points")');
  await drag(page, "point-2", 0, 60);
  assert.equal(await page.textContent(".words h2"), "By three points");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("programs: a lesson without a question of the protocol offers none to copy", async () => {
  for (const [id, languages, asked] of [["spheres", 3, true], ["broad-phases", 2, false], ["filters", 3, false]]) {
    const page = await visit(`#/lesson/${id}`);
    assert.equal(await page.$$eval(".code details", (list) => list.length), languages + (asked ? 1 : 0), id);
    assert.equal(await page.isVisible('button:text-is("Copy as a question")'), asked, id);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("resolution: impulse and approach are the library's to the last digit", async () => {
  const page = await visit("#/lesson/resolution");
  for (const example of [null, ...(await page.$$(".example"))]) {
    if (example) await example.click();
    await page.click('button[aria-label^="First"]');
    await frame(page);
    const { question } = await shown(page), { trace, normalImpulse } = JSON.parse(query(JSON.stringify({ ...question, explain: true })));
    const title = (row) => page.$eval(`.numbers tbody tr:nth-child(${row}) td:not(.mark)`, (cell) => Number(cell.getAttribute("title")));
    await page.click("[data-next]");
    assert.equal(await title(1), trace.relativeVelocity.normal);
    await page.click("[data-next]");
    assert.equal(await title(1), trace.effectiveMass);
    assert.equal(await title(2), normalImpulse);
  }
  await page.context().close();
});

test("touch: a finger drags a body", async () => {
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

test("a page is no wider than a phone", async () => {
  for (const hash of ["", ...lessons]) {
    const page = await visit(hash, { viewport: { width: 360, height: 740 } });
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(over <= 0, `${hash}: ${over} pixels`);
    await page.context().close();
  }
});

test("an address that makes no sense shows the lesson as it starts", async () => {
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

const scene = (name) => visit(`#/scene?scene=${name}`);
const files = join(here, "../../examples/scenes");

for (const name of ["shapes", "pyramid", "heavy", "cradle", "bridge"])
  test(`scene ${name}: steps forward, back, and forward again`, async () => {
    const page = await scene(name);
    const before = await shown(page);
    await page.click("[data-step]");
    const first = await shown(page);
    for (let i = 0; i < 10; i++) await page.click("[data-step]");
    const after = await shown(page);
    assert.equal(after.frames, 11);
    assert.notDeepEqual(after.poses, before.poses);
    assert.ok(after.poses.every(Number.isFinite));
    assert.ok(after.deepest < 0.1, `${after.deepest} deep`);
    for (let i = 0; i < 10; i++) await page.click("[data-back]");
    // To the last digits but few: a restored pose is made unit anew.
    const near = (x, y) => assert.ok(x.every((v, i) => Math.abs(v - y[i]) <= 1e-9), "the poses differ");
    near((await shown(page)).poses, first.poses);
    for (let i = 0; i < 10; i++) await page.click("[data-step]");
    near((await shown(page)).poses, after.poses);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

/** What touches lights up with its row: another picture than without. */
async function lightsUp(page) {
  const picture = await page.$(".stage3 canvas"), plain = await picture.screenshot();
  await page.hover(".numbers tbody tr:first-child");
  await page.waitForTimeout(200);
  assert.notDeepEqual(await picture.screenshot(), plain);
}

test("every other scene goes on from step to step", async () => {
  for (const name of ["tower", "domino", "slope", "cards", "arch", "bounce", "book", "chain", "bullets", "far"]) {
    const page = await visit(`#/scene?scene=${name}`, small), before = await shown(page);
    for (let i = 0; i < 3; i++) await page.click("[data-step]");
    const after = await shown(page);
    assert.equal(after.frames, 3, name);
    assert.notDeepEqual(after.poses, before.poses, name);
    assert.ok(after.poses.every(Number.isFinite) && after.deepest < 0.1, name);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("viewer: contacts are live while a body is dragged, and the pair is explained", async () => {
  const page = await scene("heavy");
  await page.selectOption('[data-body="0"]', { label: "light" });
  assert.equal(await page.textContent(".words h2"), "light");
  const before = await shown(page);
  assert.ok(before.pairs >= 1);
  await page.selectOption('[data-body="1"]', { label: "heavy" });
  assert.match(await page.textContent(".numbers tbody th"), /(vertex|edge|face) .* of A × (vertex|edge|face) .* of B/);
  await lightsUp(page);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-features.png") });
  await page.selectOption('[data-body="1"]', "");
  await drag(page, "move", 200, 0);
  const after = await shown(page);
  assert.ok(after.poses[7] > before.poses[7] + 0.5, `${before.poses[7]} to ${after.poses[7]}`);
  await page.selectOption('[data-body="1"]', { label: "heavy" });
  assert.match(await page.textContent(".words h2"), /light and heavy/);
  const asked = await page.inputValue("textarea");
  const answer = JSON.parse(query(JSON.stringify({ ...JSON.parse(asked), query: "distance", margin: undefined })));
  const said = await page.textContent(".words");
  assert.ok(said.includes(String(Number(answer.distance.toPrecision(6))).replaceAll("-", "−")), said);
  await page.click('a:text-is("Step through its axes")');
  await page.waitForSelector("[data-next]");
  assert.equal(await page.textContent(".words h2"), "Fifteen candidates");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: its address holds bodies, selection and settings; undo and redo take them back and forth", async () => {
  const page = await scene("heavy");
  const start = await shown(page);
  await page.selectOption('[data-body="0"]', { label: "light" });
  await drag(page, "move", 150, -60);
  const moved = await shown(page);
  assert.notDeepEqual(moved.poses, start.poses);
  await page.selectOption('[data-body="1"]', { label: "heavy" });
  await page.selectOption('label:has-text("Sub-steps") select', "4");
  const other = await visit(await page.evaluate(() => location.hash));
  assert.deepEqual((await shown(other)).poses, moved.poses);
  assert.equal(await other.textContent(".words h2"), "light and heavy");
  assert.equal(await other.inputValue('label:has-text("Sub-steps") select'), "4");
  for (let i = 0; i < 4; i++) await page.keyboard.press("Control+z");
  assert.deepEqual((await shown(page)).poses, start.poses);
  for (let i = 0; i < 4; i++) await page.keyboard.press("Control+Shift+z");
  assert.deepEqual((await shown(page)).poses, moved.poses);
  // A file that is short enough is in the address as a whole.
  await page.setInputFiles("input[type=file]", { name: "two.json", mimeType: "text/plain",
    buffer: Buffer.from('{"dimension":2,"bodies":[{"shape":{"type":"plane"}},{"name":"disc","motion":"dynamic","translation":[0,3],"shape":{"type":"circle","circle":{"radius":1}}}]}') });
  await page.waitForTimeout(300);
  await page.selectOption('[data-body="0"]', { label: "disc" });
  assert.match(await page.textContent(".numbers"), /shape\s*circle.*kind\s*moves/s);
  const third = await visit(await page.evaluate(() => location.hash));
  assert.equal((await shown(third)).bodies, 2);
  assert.equal(await third.textContent(".words h2"), "disc");
  const broken = await visit('#/scene?scene=heavy&at={"places":{"1":3}}');
  assert.deepEqual((await shown(broken)).poses, start.poses);
  for (const one of [page, other, third, broken]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("viewer: what is shot can be asked again", async () => {
  const page = await scene("heavy");
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.click('button:text-is("Shoot a ray")');
  await page.mouse.click(picture.x + picture.width / 2, picture.y + picture.height / 2);
  const words = await page.textContent(".words"), asked = JSON.parse(await page.inputValue("textarea"));
  assert.equal(asked.query, "raycast");
  const { t } = JSON.parse(query(JSON.stringify(asked)));
  assert.ok(words.includes(`after ${String(Number(t.toPrecision(6)))}`), `${words}, not ${t}`);
  await page.context().close();
});

test("viewer: a body's material counts from the next step on", async () => {
  const slid = async (friction) => {
    const page = await scene("slope");
    await page.selectOption('[data-body="0"]', { label: "μ = 0.2" });
    if (friction !== undefined) {
      await page.fill('[data-material] label:has-text("Friction") input', String(friction));
      await page.dispatchEvent('[data-material] label:has-text("Friction") input', "change");
    }
    const before = (await shown(page)).poses.slice(-7);
    for (let i = 0; i < 15; i++) await page.click("[data-step]");
    const after = (await shown(page)).poses.slice(-7);
    assert.deepEqual(page.trouble, []);
    if (friction === undefined) {
      await page.fill('[data-material] label:has-text("Restitution") input', "2");
      await page.dispatchEvent('[data-material] label:has-text("Restitution") input', "change");
      assert.match(await page.textContent(".trouble:not([hidden])"), /restitution: expected a number from 0 to 1, got 2/);
    }
    await page.context().close();
    return Math.hypot(...[0, 1, 2].map((k) => after[k] - before[k]));
  };
  const smooth = await slid(undefined), rough = await slid(1);
  assert.ok(smooth > rough + 0.03, `${smooth} m, and ${rough} m where it is rough`); // both fall a little at first
});

test("viewer: opens the project's scenes, and says what is wrong with a broken file", async () => {
  const page = await scene("shapes");
  const open = async (file) => {
    await page.setInputFiles("input[type=file]", file);
    await page.waitForTimeout(300);
  };
  await open(join(files, "demo.gltf"));
  assert.ok((await shown(page)).bodies > 10, `${(await shown(page)).bodies} bodies`);
  assert.ok(!(await page.isVisible(".trouble")));
  const text = (name, content) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content) });
  await open(text("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
  assert.equal((await shown(page)).bodies, 1);
  await open(text("q.jsonl", '{"query":"overlap","a":{"shape":{"type":"sphere"}},"b":{"shape":{"type":"box"},"translation":[0.7,0,0]}}\n'));
  assert.equal((await shown(page)).bodies, 2);
  assert.equal((await shown(page)).pairs, 1);
  // A triangle whose numbers lie in a file of their own.
  const split = { asset: { version: "2.0" }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3" }], bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ byteLength: 36, uri: "parts/a%20b.bin" }] };
  const numbersBeside = { name: "a b.bin", mimeType: "application/octet-stream", buffer: Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer) };
  await open([numbersBeside, text("split.gltf", JSON.stringify(split))]);
  assert.equal((await shown(page)).bodies, 1);
  await open(text("split.gltf", JSON.stringify(split)));
  assert.match(await page.textContent(".trouble:not([hidden])"), /buffers\[0\]: lies in a b.bin: open it together/);
  for (const [name, content] of [["cut.gltf", "{"], ["empty.gltf", "{}"], ["bad.glb", "glTF"], ["nothing.obj", "# nothing"], ["x.stl", "solid"], ["picture.png", "x"],
    ["deep.gltf", '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]}'],
    ["far.gltf", '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":99,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":4}],"buffers":[{"byteLength":3,"uri":"data:;base64,AAAA"}]}'],
    ["nan.jsonl", '{"query":"overlap","a":{"shape":{"type":"sphere","sphere":{"radius":-1}}},"b":{"shape":{"type":"box"}}}']]) {
    await open(text(name, content));
    assert.ok((await page.textContent(".trouble:not([hidden])")).includes(name.replace("nan.jsonl", "question")), name);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: opens a capture, and scrubs through it", async () => {
  const page = await scene("shapes");
  const bytes = capturedHeap();
  await page.setInputFiles("input[type=file]", { name: "heap.capture", mimeType: "application/octet-stream", buffer: bytes });
  await page.waitForSelector("[data-next]");
  assert.ok((await page.textContent(".intro")).includes("A simulation in double: 120 frames, played again. It comes to the same bits."));
  const first = await shown(page);
  assert.deepEqual([first.frame, first.frames, first.bodies], [0, 120, 16]);
  await page.click("[data-next]");
  assert.equal((await shown(page)).frame, 1);
  await page.evaluate(() => {
    const scrub = document.querySelector("input[type=range]");
    scrub.value = "90";
    scrub.dispatchEvent(new Event("input"));
  });
  const later = await shown(page);
  assert.equal(later.frame, 90);
  assert.ok(later.pairs > 10, `${later.pairs} pairs`);
  assert.ok((await page.textContent(".counter")).startsWith(`16 bodies · ${later.pairs} pairs`));
  await page.click('[aria-label="Last frame"]');
  assert.ok(await page.isDisabled("[data-next]"), "there is a frame after the last");
  await page.click('nav a:text-is("Lessons")');
  await page.click('nav a:text-is("Viewer")');
  await page.waitForSelector("input[type=file]", { state: "attached" });
  bytes[5000] ^= 1;
  await page.setInputFiles("input[type=file]", { name: "damaged.capture", mimeType: "application/octet-stream", buffer: bytes });
  await page.waitForSelector(".trouble:not([hidden])");
  assert.match(await page.textContent(".trouble"), /frame \d+, from byte \d+: expected a frame as it was written, got other bytes/);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: opens captures of the plane, and in float", async () => {
  const page = await scene("shapes");
  const captures = [
    ["whole-plane-simulation", "A simulation of the plane in double: 90 frames", 4], ["whole-plane-world", "A world of the plane in double: 3 frames", 3],
    ["whole-file", "A world in float: ", 0]];
  for (const [name, words, bodies] of captures) {
    await page.click('nav a:text-is("Lessons")');
    await page.click('nav a:text-is("Viewer")');
    await page.waitForSelector("input[type=file]", { state: "attached" });
    const buffer = readFileSync(join(here, "../../fuzz/corpus/capture", name));
    await page.setInputFiles("input[type=file]", { name: `${name}.capture`, mimeType: "application/octet-stream", buffer });
    await page.waitForSelector("[data-next]");
    const said = await page.textContent(".intro");
    assert.ok(said.includes(words) && said.includes("It comes to the same bits."), said);
    await page.click('[aria-label="Last frame"]');
    const last = await shown(page);
    assert.equal(last.frame, last.frames - 1);
    if (bodies) assert.equal(last.bodies, bodies);
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name}.png`) });
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: a drawing of the plane is opened, dragged, shot at, and played", async () => {
  const page = await scene("shapes");
  const open = async (file) => {
    await page.setInputFiles("input[type=file]", file);
    await page.waitForTimeout(300);
  };
  await open(join(files, "plane.svg"));
  assert.ok(!(await page.isVisible(".trouble")), await page.textContent(".trouble"));
  const first = await shown(page);
  assert.equal(first.bodies, 12); // the hammer's two shapes are one
  assert.ok(first.pairs > 3, `${first.pairs} pairs`);
  await page.selectOption('[data-body="0"]', { label: "ball" });
  await page.selectOption('[data-body="1"]', { label: "wedge" });
  const asked = JSON.parse(await page.inputValue("textarea"));
  assert.equal(asked.dimension, 2);
  const answer = JSON.parse(query(JSON.stringify({ ...asked, query: "distance", margin: undefined })));
  assert.ok((await page.textContent(".words")).includes(String(Number(answer.distance.toPrecision(6))).replaceAll("-", "−")));
  const before = await shown(page);
  await drag(page, "move", 60, -40);
  const after = await shown(page), moved = after.poses.findIndex((x, i) => x !== before.poses[i]);
  assert.ok(after.poses[moved] > before.poses[moved] && after.poses[moved + 1] > before.poses[moved + 1], "right and up");
  assert.ok(after.poses.every((x, i) => ![2, 3, 4].includes(i % 7) || x === 0), "a body left the plane");
  await page.check("[data-broad-phase]");
  await page.click('button:text-is("Shoot a ray")');
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.mouse.click(picture.x + picture.width * 0.3, picture.y + 20);
  await page.mouse.click(picture.x + picture.width * 0.31, picture.y + picture.height - 20);
  assert.match(await page.textContent(".words h2"), /^The ray hits (?!nothing)/);
  await page.click('button:text-is("Cast the body")');
  await page.mouse.click(picture.x + picture.width * 0.6, picture.y + picture.height - 20);
  assert.match(await page.textContent(".words h2"), /^ball meets (?!nothing)/);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-plane.png") });
  for (let i = 0; i < 30; i++) await page.click("[data-step]");
  const later = await shown(page);
  assert.equal(later.frames, 30);
  assert.ok(later.poses.every(Number.isFinite));
  for (let i = 0; i < 29; i++) await page.click("[data-back]");
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-plane-played.png") });
  const text = (name, content) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content) });
  await open(text("flat.json", '{"dimension":2,"bodies":[{"shape":{"type":"plane"}},{"name":"disc","motion":"dynamic","translation":[0,3],"shape":{"type":"circle","circle":{"radius":1}}}]}'));
  assert.equal((await shown(page)).bodies, 2);
  await open(text("stack.json", '{"dimension":2,"bodies":[{"name":"floor","shape":{"type":"box","box":{"size":[4,1]}}},{"name":"crate","motion":"dynamic","translation":[0.3,0.999],"shape":{"type":"box","box":{"size":[1,1]}}}]}'));
  await page.selectOption('[data-body="0"]', { label: "floor" });
  await page.selectOption('[data-body="1"]', { label: "crate" });
  assert.match(await page.textContent(".numbers tbody th"), /^vertex [23] of A × vertex [01] of B$/);
  await lightsUp(page);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-plane-features.png") });
  await open(text("q.jsonl", '{"query":"distance","dimension":2,"a":{"shape":{"type":"box","box":{"size":[1,1]}}},"b":{"shape":{"type":"circle","circle":{"radius":1}},"translation":[1.2,0.4],"rotation":0.3}}\n'));
  assert.equal((await shown(page)).pairs, 1);
  for (const [name, content, words] of [["cut.svg", "<svg", /cut.svg: expected an XML document/], ["other.svg", "<html/>", /other.svg: .*<svg> element as the root/],
    ["bad.svg", '<svg xmlns="http://www.w3.org/2000/svg"><circle id="c" r="-1"/></svg>', /bad.svg: drawing: line 1: <circle id="c">.r: expected a number >= 0/], ["deep.svg", `${"<g>".repeat(5000)}${"</g>".repeat(5000)}`, /nested at most 100 deep/]]) {
    await open(text(name, content));
    assert.match(await page.textContent(".trouble:not([hidden])"), words);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: a glTF's bodies of several colliders move as one, and its joints hold", async () => {
  const page = await scene("shapes");
  const collider = (shape, more = {}) => ({ ...more, extensions: { KHR_physics_rigid_bodies: { collider: { geometry: { shape } } } } });
  const half = Math.SQRT1_2;
  const gltf = {
    asset: { version: "2.0" }, extensionsUsed: ["KHR_implicit_shapes", "KHR_physics_rigid_bodies"],
    extensions: {
      KHR_implicit_shapes: { shapes: [{ type: "box", box: { size: [1, 1, 1] } }, { type: "sphere", sphere: { radius: 0.5 } }, { type: "cylinder" }] },
      KHR_physics_rigid_bodies: { physicsJoints: [{ limits: [{ linearAxes: [0, 1, 2], min: 0, max: 0 }, { angularAxes: [1, 2], min: 0, max: 0 }] }] },
    },
    scenes: [{ nodes: [0, 3, 6, 7] }],
    nodes: [
      // A dumbbell of two balls that turns as it flies, far from the rest.
      { name: "dumbbell", translation: [0, 50, 0], children: [1, 2], extensions: { KHR_physics_rigid_bodies: { motion: { mass: 2, angularVelocity: [0, 1, 0], gravityFactor: 0 } } } },
      collider(1, { translation: [-1, 0, 0] }), collider(1, { translation: [1, 0, 0] }),
      // A pendulum that hangs from the world by a hinge about Z: its arm points along X at first.
      { name: "pendulum", translation: [11, 5, 0], children: [4, 5], extensions: { KHR_physics_rigid_bodies: { motion: { mass: 1 } } } },
      collider(0),
      { translation: [-1, 0, 0], rotation: [0, -half, 0, half], extensions: { KHR_physics_rigid_bodies: { joint: { connectedNode: 6, joint: 0 } } } },
      { translation: [10, 5, 0], rotation: [0, -half, 0, half] },
      // Scaled unevenly: no cylinder any more.
      collider(2, { name: "oval", translation: [-9, 0, 0], scale: [2, 1, 1] }),
    ],
  };
  await page.setInputFiles("input[type=file]", { name: "joined.gltf", mimeType: "model/gltf+json", buffer: Buffer.from(JSON.stringify(gltf)) });
  await page.waitForTimeout(300);
  assert.ok(!(await page.isVisible(".trouble")), await page.textContent(".trouble"));
  assert.deepEqual(await page.$$eval('[data-body="0"] option', (list) => list.map((o) => o.textContent)), ["no body", "dumbbell", "pendulum", "oval"]);
  for (let i = 0; i < 30; i++) await page.click("[data-step]");
  const { poses } = await shown(page), at = (i) => poses.slice(7 * i, 7 * i + 3);
  // A second of half a second at one radian each: the first ball, whose frame the body has, has turned about the middle.
  const [x, y, z] = at(0), angle = 30 / 60;
  assert.ok(Math.hypot(x + Math.cos(angle), y - 50, z - Math.sin(angle)) < 1e-3, `${[x, y, z]}`);
  const [px, py, pz] = at(1);
  assert.ok(Math.abs(Math.hypot(px - 10, py - 5) - 1) < 1e-3 && Math.abs(pz) < 1e-3, `${[px, py, pz]} is not on the circle about the hinge`);
  assert.ok(py < 4.5, `it hangs at ${py}`);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer has no finding of axe, and fits a phone", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await visit("#/scene?scene=tower", { bypassCSP: true, colorScheme, viewport: { width: 390, height: 844 } });
    await page.click("[data-step]");
    await page.click("[data-step]");
    await page.evaluate(axe);
    const found = await page.evaluate(() => window.axe.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21aa", "best-practice"] }));
    assert.deepEqual(found.violations.map((v) => `${colorScheme} ${v.id}: ${v.nodes.map((n) => n.target.join(" ")).slice(0, 3)}`), []);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    await page.context().close();
  }
});

test("a still page draws nothing, and uses no other address", async () => {
  const page = await scene("tower");
  await page.waitForTimeout(500);
  const frames = await page.evaluate(() => new Promise((done) => {
    let asked = 0;
    const real = window.requestAnimationFrame;
    window.requestAnimationFrame = (f) => (asked++, real(f));
    setTimeout(() => done(asked), 500);
  }));
  assert.equal(frames, 0);
  await page.context().close();
});

await Promise.all(Array.from({ length: atOnce }, runTests));
await browser.close();
server.close();
console.log(failed ? `${failed} failed` : "all passed");
process.exit(failed ? 1 : 0);
