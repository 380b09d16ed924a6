// Lessons of axes, contacts and polygons: a page shows the numbers of the library.

import assert from "node:assert/strict";
import { axisRows, example, step } from "./lesson-page.mjs";
import { drag, frame, graze, numbers, query, short, shown, test, traced, visit } from "./harness.mjs";

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

for (const id of ["spheres", "separating-axes-plane", "gjk", "epa"])
  test(`${id}: a drag changes picture, words and numbers where they stand, to those of a page that is opened there`, async () => {
    const page = await visit(`#/lesson/${id}`);
    await page.click("[data-next]");
    const kept = await page.evaluate(() => (window.kept = [".stage2 .shape", ".words p", ".numbers td"].map((part) => document.querySelector(part))).map(Boolean));
    for (const [dx, dy] of [[37, -23], [-60, 12]]) {
      await drag(page, "move-b", dx, dy);
      assert.deepEqual(await page.evaluate(() => window.kept.map((part) => part === null || part.isConnected)), kept.map(() => true));
    }
    for (let i = 0; i < 3; i++) if (await page.isEnabled("[data-next]")) await page.click("[data-next]");
    await page.click('button[aria-label^="Previous"]');
    await page.mouse.move(1, 1);
    const other = await visit(await page.evaluate(() => location.hash));
    const parts = (one) => one.evaluate(() => [".stage2 > svg", ".words", ".numbers"].map((part) => document.querySelector(part).outerHTML.replaceAll(/<span class="changed">(.*?)<\/span>/g, "$1")));
    const [now, fresh] = await Promise.all([page, other].map(parts));
    const differ = await page.evaluate(([ours, theirs]) => ours.filter((html, i) => {
      const [p, q] = [html, theirs[i]].map((text) => Object.assign(document.createElement("div"), { innerHTML: text }));
      for (const one of [p, q]) one.querySelectorAll("math").forEach((math) => math.removeAttribute("style"));
      return !p.isEqualNode(q);
    }), [now, fresh]);
    assert.deepEqual(differ, []);
    for (const one of [page, other]) {
      assert.deepEqual(one.trouble, []);
      await one.context().close();
    }
  });

test("separating axes: each picture of a drag shows the body where it is, and touches no element that looks as before", async () => {
  const page = await visit("#/lesson/separating-axes-plane");
  await step(page, /^(They are apart|The least overlap wins)/);
  await page.evaluate(() => {
    window.lab.telling.next = performance.now() + 60_000; // the words wait until the drag ends
    window.changes = [];
    new MutationObserver((list) => window.changes.push(...list)).observe(document.querySelector(".stage"), { attributes: true, childList: true, subtree: true });
  });
  const box = await (await page.$('[data-handle="move-b"]')).boundingBox(), [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  const words = await numbers(page);
  for (const by of [7, 19, 31]) {
    await page.mouse.move(x + by, y - by / 2);
    await frame(page);
    const { q } = (await shown(page)).state, shape = graze.plane.shapeOfProtocol(q.b.shape);
    const { points } = graze.plane.tessellate(shape, { translation: q.b.translation, rotation: q.b.rotation });
    shape.dispose();
    const seen = await page.$eval(".stage2 .shape.of-b", (polygon) => [...polygon.points].map(({ x, y }) => window.lab.stage.world(x, y)));
    assert.equal(seen.length, points.length);
    seen.forEach((p, i) => assert.ok(Math.hypot(p[0] - points[i][0], p[1] - points[i][1]) < 1e-3, `${p} for ${points[i]}`));
    assert.equal(await numbers(page), words);
  }
  const touched = await page.evaluate(() => window.changes.filter(({ target, type, attributeName }) =>
    type === "childList" || attributeName === "class" || target.matches('.shape.of-a, [data-handle$="-a"], .grid *, defs *')).map(({ target }) => target.outerHTML));
  assert.deepEqual(touched, []);
  await page.mouse.up();
  await page.waitForFunction((before) => document.querySelector(".numbers").textContent !== before, words);
  const { axes } = (await traced(page)).trace;
  for (const { name, overlap } of await axisRows(page)) assert.equal(overlap, axes.find((axis) => axis.name === name).overlap);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("separating axes: where words take long they follow a drag later than the picture, and are there when it ends", async () => {
  const page = await visit("#/lesson/separating-axes-plane");
  await step(page, /^(They are apart|The least overlap wins)/);
  const box = await (await page.$('[data-handle="move-b"]')).boundingBox(), [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const seen = () => page.evaluate(() => [document.querySelector(".stage2 .shape.of-b").getAttribute("points"), document.querySelector(".numbers").textContent]);
  /** As if they had taken so long that they may not be shown again before so many milliseconds. */
  const slow = (until) => page.evaluate((ms) => (window.lab.telling.next = performance.now() + ms), until);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const [shape, words] = await seen();
  await slow(60_000);
  await page.mouse.move(x + 20, y + 10);
  await page.waitForFunction((before) => document.querySelector(".stage2 .shape.of-b").getAttribute("points") !== before, shape);
  assert.equal((await seen())[1], words);
  await page.mouse.up();
  await page.waitForFunction((before) => document.querySelector(".numbers").textContent !== before, words);
  const [, later] = await seen();
  await page.mouse.down();
  await slow(0);
  await page.mouse.move(x + 40, y + 20);
  await page.waitForFunction((before) => document.querySelector(".numbers").textContent !== before, later);
  await page.mouse.up();
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("separating axes: a row that comes below a pointer that stands still lights up, and the one that was there no more", async () => {
  const page = await visit("#/lesson/separating-axes-plane");
  await step(page, /^Axis A1/);
  const keys = () => page.$$eval(".numbers tr.lit", (list) => list.map((row) => row.dataset.key));
  await page.hover(".numbers tbody tr:nth-child(1)");
  const [first] = await keys();
  await page.keyboard.press("Tab");
  await page.focus('[data-handle="move-b"]');
  await page.keyboard.press("ArrowLeft");
  await frame(page);
  assert.deepEqual(await keys(), [first]);
  await page.evaluate(() => document.querySelector('button[aria-label^="First"]').click());
  await page.evaluate(() => document.querySelector("[data-next]").click());
  await frame(page);
  const under = await page.evaluate(() => document.querySelector(".numbers tbody tr:hover")?.dataset.key ?? null);
  assert.deepEqual(await keys(), under === null ? [] : [under]);
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

test("contact set: without the preference for faces one point is left, where two edges come nearest", async () => {
  const page = await visit("#/lesson/contact-set");
  await example(page, "An edge wins by a hair");
  const { trace, manifolds } = await traced(page);
  const least = trace.axes.filter((x) => x.name !== "normal").reduce((best, x) => (x.overlap < best.overlap ? x : best));
  assert.ok(/×/.test(least.name) && !/×/.test(trace.winner), `${least.name} against ${trace.winner}`);
  await page.click('.choices button:text-is("least overlap alone")');
  await page.click('button[aria-label^="Last"]');
  const { length } = manifolds[0].points;
  assert.equal(await page.textContent(".words h2"), `${length} points go, one is left`);
  const rows = await page.$$eval(".numbers tbody tr", (list) => list.map((r) => [...r.cells].slice(1).map((c) => c.title || c.textContent)));
  assert.deepEqual(rows[1], [`least overlap alone: ${least.name}`, "1", String(least.overlap)]);
  await example(page, "Flat on it");
  await page.click('.choices button:text-is("least overlap alone")');
  await page.click('button[aria-label^="Last"]');
  assert.equal(await page.textContent(".words h2"), "The points stay");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("spheres: in space the same numbers, and a drag there counts", async () => {
  const page = await visit("#/lesson/spheres", { viewport: { width: 1000, height: 600 } });
  await step(page, /^Signed distance/);
  const flat = await page.textContent(".numbers");
  const distance = () => page.$eval(".numbers tbody td[title]", (c) => Number(c.title)), begun = await distance();
  await page.click('.choices button:text-is("in space")');
  await page.waitForSelector(".stage3 canvas");
  assert.equal(await distance(), begun);
  for (const [handle, dx] of [["radius-b", 0], ["move-b", 60]]) {
    await drag(page, handle, dx, -25);
    const { question } = await shown(page), after = JSON.parse(query(JSON.stringify({ ...question, query: "distance" }))).distance;
    assert.notEqual(await page.textContent(".numbers"), flat);
    assert.equal(await distance(), after);
  }
  const { question: { b } } = await shown(page), apart = await distance();
  assert.ok(b.shape.type === "sphere" && Math.abs(b.translation[2]) > 0.05, `a drag leaves the plane: ${b.translation}`);
  await page.click('.choices button:text-is("section")');
  await page.waitForSelector(".stage2 svg");
  assert.ok(Math.abs(await distance() - apart) < 1e-12, "the section holds both centres");
  assert.equal((await shown(page)).question.b.translation.length, 2);
  assert.equal(await page.$(".stage3"), null);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("Minkowski: B slides round A in touch with it, and the outline grows", async () => {
  const page = await visit("#/lesson/minkowski");
  await page.click("[data-next]");
  assert.equal(await page.textContent(".words h2"), "B slides round A");
  const grown = () => page.$$eval(".stage2 line.of-made.wide", (list) => list.length);
  const handle = await (await page.$('[data-handle="slide"]')).boundingBox(), first = await grown();
  // To the other side of the difference, whose middle is seen by its corners.
  const [x, y] = await page.$$eval(".stage2 line.of-made", (list) => {
    const ends = list.map((l) => l.getBoundingClientRect());
    return [Math.min(...ends.map((r) => r.x)) + Math.max(...ends.map((r) => r.right)), Math.min(...ends.map((r) => r.y)) + Math.max(...ends.map((r) => r.bottom))].map((s) => s / 2);
  });
  await drag(page, "slide", 2 * (x - handle.x), 2 * (y - handle.y));
  assert.notEqual(await grown(), first);
  const told = await page.$$eval(".numbers td[title]", (list) => list.map((c) => Number(c.title)));
  assert.ok(told.length === 1 && Math.abs(told[0]) < 1e-9, `${told}: B does not touch A`);
  await page.click('.choices button:text-is("sum A ⊕ B")');
  await page.click('button[aria-label^="First"]');
  await page.click("[data-next]");
  assert.equal(await page.textContent(".words h2"), "A carries B round");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("filters: bits are switched one by one, and the pairs are those of a world", async () => {
  const page = await visit("#/lesson/filters", { viewport: { width: 1000, height: 600 } });
  await page.click("[data-bit=m0-2]"); // the player now collides with shots
  await page.click("[data-bit=m2-0]"); // and shots with players
  await page.click("[data-bit=c3-1]"); // a coin is an enemy too
  const { state } = await shown(page), c = state.choice;
  assert.deepEqual([c.m0, c.m2, c.c3], [0b1110, 0b0011, 0b1010]);
  const world = new graze.World(), ball = new graze.Sphere(0.7);
  for (let i = 0; i < 4; i++) world.add({ shape: ball, translation: [c[`x${i}`], c[`y${i}`], 0], filter: { category: c[`c${i}`], mask: c[`m${i}`], group: c[`g${i}`] } });
  world.update();
  const reported = world.contacts().filter((p) => p.overlap).length;
  assert.match(await page.textContent(".words p"), new RegExp(`the world reports ${reported} of them`));
  assert.equal(await page.getAttribute("[data-bit=m0-2]", "aria-pressed"), "true");
  await page.keyboard.press("Control+z");
  await frame(page);
  assert.equal((await shown(page)).state.choice.c3, 0b1000);
  for (const made of [world, ball]) made.dispose();
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
