// Lessons that iterate or search: every step shows the trace's numbers, and the text about the end is true.

import assert from "node:assert/strict";
import { example, step } from "./lesson-page.mjs";
import { drag, frame, graze, query, shown, short, small, test, traced, visit } from "./harness.mjs";

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

test("GJK: the origin lies in the region that is drawn, in each iteration after the first", async () => {
  const page = await visit("#/lesson/gjk", small);
  for (const label of [null, "Origin inside", "Thin shapes"]) {
    if (label) await example(page, label);
    const { trace } = await traced(page);
    for (let i = 1; i < trace.gjk.length; i++) {
      await step(page, new RegExp(`^Iteration ${i + 1}:`));
      const inside = await page.$$eval(".stage2 polygon.area.dashed", (list) => list.map((area) => {
        const place = area.ownerSVGElement.createSVGPoint();
        [place.x, place.y] = window.lab.stage.pixel([1, -4.6]);
        return area.isPointInFill(place);
      }));
      assert.deepEqual(inside, [true], `${label}, iteration ${i + 1}`);
    }
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

/** Lessons whose steps are those of an answer: the number of steps before, and the library's numbers of each. */
const walks = {
  spheres: (_, question) => {
    const found = JSON.parse(query(JSON.stringify({ ...question, query: "distance" })));
    return [2, [[found.distance, String(found.a), String(found.b)]]];
  },
  "planes-boxes": (_, { a, b }) => {
    const [x, y, z, w] = b.rotation.map((v) => v / Math.hypot(...b.rotation)), half = b.shape.box.size.map((v) => v / 2);
    const turn = (v) => {
      const [i, j, k] = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
      return [v[0] + w * i + y * k - z * j, v[1] + w * j + z * i - x * k, v[2] + w * k + x * j - y * i];
    };
    return [1, Array.from({ length: 8 }, (_, i) => {
      const point = turn(half.map((h, k) => (i & (1 << k) ? h : -h))).map((v, k) => v + b.translation[k]);
      return [JSON.parse(query(JSON.stringify({ query: "closest", a, point }))).distance];
    })];
  },
  minkowski: ({ trace }) => [2, trace.difference.map(({ a, b }) => [a.slice(0, 2), b.slice(0, 2), [b[0] - a[0], b[1] - a[1]]].map(String))],
  epa: ({ trace }) => [1, trace.epa.map((s) => [s.polygon.length, s.faceDepth, s.foundDepth])],
  "epa-space": ({ trace }) => [1, trace.epa.map((s) => [s.faces, s.faceDepth, s.foundDepth])],
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
      if (/^epa/.test(id) && answer.distance > 0 || answer.hit === false || !answer.trace.method) continue; // nothing to walk through
      const [before, list] = walk(answer, question);
      for (let i = 1; i < before; i++) await page.click("[data-next]");
      for (const step of list) {
        await page.click("[data-next]");
        const told = await page.$$eval(".numbers tbody tr", (rows, now) => (now ? rows : rows.slice(-1))
          .flatMap((row) => [...row.cells].map((c) => c.getAttribute("title")).filter(Boolean)), id === "spheres");
        assert.deepEqual(told.map((x) => (x.includes(",") ? x : Number(x))), step, JSON.stringify(question));
      }
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

for (const id of ["gjk", "gjk-space"])
  test(`${id}: the bounds of every iteration are the trace's to the last digit, after a drag too`, async () => {
    const page = await visit(`#/lesson/${id}`, small);
    for (const moved of [false, true]) {
      if (moved) await drag(page, "move-b", 22, -13);
      const { trace } = await traced(page), { steps } = await shown(page);
      assert.equal(steps, trace.gjk.length + 2);
      const told = await page.evaluate(() => window.lab.steps.slice(1, -1).map((step) => Object.fromEntries(step.graph.series.map(({ name, values }) => [name, values[step.graph.at]]))));
      assert.deepEqual(told, trace.gjk.map(({ lower, upper }) => ({ "at most": upper, "at least": lower })));
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

/** What is dragged in a lesson, and the number of the answer that its last step has. */
const drags = { "contact-set": ["move-b", ({ manifolds }) => manifolds[0]?.points[0].distance], "gjk-space": ["move-b", ({ distance }) => distance],
  epa: ["move-b", ({ distance }) => distance], "epa-space": ["turn-b", ({ distance }) => distance], "time-of-impact": ["velocity", ({ t }) => t],
  resolution: ["velocity-b", ({ b }) => b.linear[0]] };
for (const [id, [handle, number]] of Object.entries(drags))
  test(`${id}: a drag changes the numbers to those of the library`, async () => {
    const page = await visit(`#/lesson/${id}`, small), words = () => page.textContent(".side");
    await page.click('button[aria-label^="Last"]');
    const before = await words(), was = number(await traced(page));
    await drag(page, handle, 9, 4);
    await page.click('button[aria-label^="Last"]');
    const is = number(await traced(page)), after = await words();
    assert.notEqual(is, was);
    assert.notEqual(after, before);
    const told = after.replaceAll("−", "-").match(/-?\d+(\.\d+)?(e-?\d+)?/g).map(Number);
    assert.ok(told.some((x) => Math.abs(x - is) <= 1e-3 * Math.abs(is)), `${after} without ${is}`);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

test("a stack: the top box begins where it was dragged to, and nothing is simulated before it is asked for", async () => {
  const page = await visit("#/lesson/stack", small);
  await drag(page, "top", 30, -20);
  const { state: { choice: { x, y, z } } } = await shown(page);
  assert.ok(x > 0.1 && y > 9.7, `${x}, ${y}`);
  assert.ok((await page.textContent(".code details:first-child")).includes(`${x}, ${y}, ${z}`), "the program has another place");
  await page.click("[data-next]");
  const simulation = new graze.Simulation({ sleep: false }), box = new graze.Box([1, 1, 1]), floor = new graze.HalfSpace();
  simulation.add({ shape: floor, fixed: true });
  for (let i = 0; i < 10; i++) simulation.add({ shape: box, translation: i === 9 ? [x, y, z] : [i % 2 === 0 ? 0.04 : -0.04, 0.5 + i, 0] }, { mass: 1 });
  for (let i = 0; i < 6; i++) simulation.step(1 / 60);
  assert.equal(Number(await page.$eval(".numbers tr.is-now td[title]", (cell) => cell.title)), simulation.report().deepest);
  for (const made of [simulation, box, floor]) made.dispose();
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

/** The deepest contact of the lesson's stack after a second of four sub-steps a step, in metres. */
function deepestOfStack(warmStart) {
  const simulation = new graze.Simulation({ sleep: false, subSteps: 4, mostSubSteps: 4, warmStart });
  const box = new graze.Box([1, 1, 1]), floor = new graze.HalfSpace(), rough = { staticFriction: 0.6, dynamicFriction: 0.6 };
  simulation.add({ shape: floor, fixed: true }, {}, rough);
  for (let i = 0; i < 10; i++) simulation.add({ shape: box, translation: [i % 2 === 0 ? 0.04 : -0.04, 0.5 + i, 0] }, { mass: 1 }, rough);
  for (let i = 0; i < 60; i++) simulation.step(1 / 60);
  const { deepest } = simulation.report();
  for (const made of [simulation, box, floor]) made.dispose();
  return deepest;
}
test("a stack: the deepest contact after a second is the library's, and without a warm start much deeper", async () => {
  const page = await visit("#/lesson/stack");
  const told = async () => Number((await page.$$eval(".numbers tr.is-now td[title]", (list) => list.map((cell) => cell.title)))[0]);
  await page.click('.choices button:text-is("4")');
  await page.click('button[aria-label^="Last"]');
  const warm = deepestOfStack(true), cold = deepestOfStack(false);
  assert.equal(await told(), warm * 1000);
  await page.click('.choices button:text-is("from none")');
  await page.click('button[aria-label^="Last"]');
  assert.equal(await told(), cold * 1000);
  assert.ok(cold > 2 * warm, `${cold} m and ${warm} m`);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("EPA: the way out ends on the nearest side, in space the polytope grows, and both have a last word", async () => {
  const page = await visit("#/lesson/epa");
  const { trace, distance } = await traced(page);
  for (const _ of trace.epa) {
    await page.click("[data-next]");
    const off = await page.evaluate(() => {
      const line = (lines) => ["x1", "y1", "x2", "y2"].map((k) => Number([...document.querySelectorAll(`.stage2 line.${lines}`)].at(-1).getAttribute(k)));
      const [x1, y1, x2, y2] = line("of-axis.wide"), [, , x, y] = line("of-made");
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
