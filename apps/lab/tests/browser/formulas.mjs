// Formulas have the numbers of the present question put in, and the appendix answers every pair of it.

import assert from "node:assert/strict";
import { example, step } from "./lesson-page.mjs";
import { drag, frame, query, shown, small, test, traced, visit } from "./harness.mjs";

const number = (text) => Number(text.replaceAll("−", "-"));
/** The numbers of each formula of the step, of fractions the numerator's first. */
const formulas = (page) => page.$$eval(".words math", (list) => list.map((math) => {
  const text = (of) => [...of.childNodes].map((x) => (x.nodeType === 3 ? x.data : ` ${text(x)} `)).join("");
  return text(math).replaceAll(/−\s*(?=[\d.])/g, "-").replaceAll(/\s+/g, " ");
}));
const numbersOf = (text) => [...text.matchAll(/-?\d+(?:\.\d+)?(?:e[-−]?\d+)?/g)].map(([x]) => number(x));
const near = (x, y, digits = 1e-3) => assert.ok(Math.abs(x - y) <= digits * Math.max(1, Math.abs(y)), `${x} instead of ${y}`);
const cells = (page) => page.$$eval(".numbers tbody tr", (list) => Object.fromEntries(list.map((row) =>
  [row.querySelector("th").textContent, row.querySelector("td[title]")?.title ?? row.cells[2].textContent])));

const sub = (p, q) => p.map((x, i) => x - q[i]), dot = (p, q) => p.reduce((s, x, i) => s + x * q[i], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d], unit = (v) => v.map((x) => x / Math.hypot(...v));
const line = ({ shape: { convex: { points: [p, q] } } }) => ({ p, u: unit(sub(q, p)) });
const normal = ({ rotation: [x, y, z, w] = [0, 0, 0, 1] }) => unit([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)]);
/** The answers of pairs without ends, by the formulas of a book. */
const unbounded = {
  "point, line": ({ a, point }) => ({ distance: Math.hypot(...cross(sub(point, line(a).p), line(a).u)), t: dot(sub(point, line(a).p), line(a).u) }),
  "line, line": ({ a, b }) => ({ distance: Math.abs(dot(sub(line(b).p, line(a).p), unit(cross(line(a).u, line(b).u)))) }),
  "line, plane": ({ a, b }) => ({ t: dot(sub(a.translation ?? [0, 0, 0], line(b).p), normal(a)) / dot(normal(a), line(b).u) }),
  "plane, plane": () => ({ "its distance from A": 0, "its distance from B": 0 }),
  "line, triangle": ({ a: { shape: { triangle: { points: [p, q, r] } } }, b }) => {
    const n = cross(sub(q, p), sub(r, p));
    return { t: dot(sub(p, line(b).p), n) / dot(n, line(b).u) };
  },
  "plane, triangle": ({ a, b }) => Object.fromEntries(b.shape.triangle.points.map((x, i) => [`before it: ${"abc"[i]}`, dot(sub(x, a.translation ?? [0, 0, 0]), normal(a))])),
};

test("appendix: every pair has its numbers from the library, before a drag and after it", async () => {
  const page = await visit("#/lesson/appendix", small);
  const labels = await page.$$eval(".choices button", (list) => list.map((b) => b.textContent));
  assert.deepEqual(labels.slice(8), Object.keys(unbounded));
  for (const label of labels) {
    await page.click('button[aria-label^="First"]');
    await page.click(`.choices button:text-is("${label}")`);
    await frame(page);
    const letters = await formulas(page);
    assert.ok(letters.length > 0, label);
    let before;
    for (const moved of [false, true]) {
      if (moved) {
        const handles = await page.$$eval(".handle", (list) => list.map((x) => x.dataset.handle));
        for (const handle of [handles[0], handles.at(-1)]) await drag(page, handle, 12, -17);
      }
      await page.click('button[aria-label^="Last"]');
      assert.notDeepEqual(await formulas(page), letters, `${label}: no numbers in the formulas`);
      const { state, question } = await shown(page), told = await cells(page), q = state.q;
      assert.notDeepEqual(told, before, `${label}: a drag changes nothing`);
      before = told;
      const answer = JSON.parse(query(JSON.stringify(question)));
      assert.equal(answer.error, undefined, label);
      if (answer.hit === false) assert.equal(told.hit, "no", `${label} ${moved} ${JSON.stringify(told)}`);
      else if (!unbounded[label]) {
        const name = "t" in answer ? "t" : "distance";
        assert.equal(Number(told[name]), answer[name], label);
        const last = (await formulas(page)).flatMap(numbersOf);
        assert.ok(last.some((x) => Math.abs(x - answer[name]) <= 1e-4 * Math.abs(x)), `${label}: ${last} without ${answer[name]}`);
      } else if (moved) // before, the state has the bodies of another pair
        for (const [name, value] of Object.entries(unbounded[label](q))) near(Number(told[name]), value, 1e-12);
    }
  }
  await example(page, "Parallel lines");
  await page.click('button[aria-label^="Last"]');
  assert.equal(await page.textContent(".words h2"), "Parallel lines");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("appendix: a plane with all corners of a triangle above it has the distance of the lowest, and so has one with all below", async () => {
  const page = await visit("#/lesson/appendix", small);
  const triangle = { type: "triangle", triangle: { points: [[-1, 0, -0.6], [1.3, 0.1, 0], [0.2, 0.4, 0.3]] } };
  for (const [y, title, text, distance] of [[-0.5, "All corners are above the plane", /distance of the lowest/, 0.5], [1, "No corner is above the plane", /how far the triangle has to go/, -1]]) {
    const q = { query: "distance", a: { shape: { type: "plane" }, translation: [0, y, 0] }, b: { shape: triangle } };
    await page.evaluate((state) => window.lab.change(state, true), { choice: { pair: "plane-triangle" }, q });
    await frame(page);
    await page.click('button[aria-label^="Last"]');
    assert.equal(await page.textContent(".words h2"), title);
    assert.match(await page.textContent(".words p"), text);
    assert.equal(Number((await cells(page)).distance), distance);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("formulas: faces and cuts of the contact set, half shadows, impulses and motions have their numbers", async () => {
  const page = await visit("#/lesson/contact-set", small);
  await step(page, /^Reference and incident/);
  const facing = (await formulas(page)).slice(2).map(numbersOf);
  assert.equal(facing.length, 2);
  for (const [n0, n1, n2, m0, m1, m2, k] of facing) near(k, Math.abs(n0 * m0 + n1 * m1 + n2 * m2), 2e-3);
  const { cuts } = (await traced(page)).trace;
  let crossed = 0;
  for (const [i, { left }] of cuts.entries()) {
    await page.click("[data-next]");
    assert.equal(await page.textContent(".words h2"), `Cut ${i + 1} of ${cuts.length}`);
    const [, , ratio, made] = (await formulas(page)).map(numbersOf);
    if (!made) continue;
    crossed++;
    // The ends lie on either side: a minus before the second may be that of the difference.
    const [d1, , d2, t] = ratio.map(Math.abs);
    near(t, d1 / (d1 + d2));
    assert.ok(left.some((p) => Math.hypot(...sub(p, made)) < 1e-2), `${made} is no corner`);
  }
  assert.ok(crossed > 0);

  for (const [id, title, from, rows] of [["planes-boxes", /^The projected radius/, 1, 1], ["fifteen-axes", /^Axis B1/, 1, 2]]) {
    await page.goto(`${page.url().split("#")[0]}#/lesson/${id}`);
    await page.waitForFunction((name) => window.lab.lesson?.id === name, id);
    await step(page, title);
    const worked = (await formulas(page)).slice(from, from + rows).map((x) => numbersOf(x).slice(-7));
    assert.equal(worked.length, rows);
    for (const [h0, e0, h1, e1, h2, e2, r] of worked) near(r, h0 * e0 + h1 * e1 + h2 * e2, 2e-3);
  }

  await page.goto(`${page.url().split("#")[0]}#/lesson/resolution`);
  await page.waitForFunction(() => window.lab.lesson?.id === "resolution");
  await example(page, "Off centre");
  await drag(page, "velocity-b", 25, -15);
  const answer = await traced(page), { question: { a, b } } = await shown(page);
  const [, v] = (await formulas(page)).map(numbersOf);
  for (const i of [0, 1, 2]) near(v[6 + i], v[i] - v[3 + i], 2e-3);
  await step(page, /^The normal impulse/);
  const [, zero, m, one, e, vn, j] = [NaN, ...numbersOf((await formulas(page))[2])];
  assert.equal(zero, 0);
  assert.equal(one, 1);
  near(j, Math.max(0, -Math.abs(m) * (1 + e) * vn));
  near(j, answer.normalImpulse, 1e-4);
  await page.click('button[aria-label^="Last"]');
  for (const [formula, body, sign, after] of [[2, b, 1, answer.b], [3, a, -1, answer.a]]) {
    const told = numbersOf((await formulas(page))[formula]), mass = told[6];
    assert.equal(mass, body.mass);
    for (const i of [0, 1, 2]) {
      near(told[7 + i], told[i] + (sign * told[3 + i]) / mass, 5e-3);
      near(told[7 + i], after.linear[i], 1e-2);
    }
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
