// Addresses that nobody would write who means well: the page shows what it can, and stays as quick as ever.

import assert from "node:assert/strict";
import { drag, frame, goTo, numbers, query, shown, small, test, visit } from "./harness.mjs";

const asValues = (values) => `?${new URLSearchParams(Object.entries(values).map(([key, value]) => [key, typeof value === "string" ? value : JSON.stringify(value)]))}`;

test("hostile addresses: a camera whose picture numbers cannot tell is refused, in the plane and in space", async () => {
  const hostile = { gjk: ["1e20,0,1", "1,1,1e-17", "0,0,1e308", "0,0,5e-324", "0,0,-1", "1,2"],
    "gjk-space": ["1e20,0,0,1e20,0,1", "1,1,1,1,1,1", "1e200,0,0,0,0,0", "1,1,1,1,1,1.00000000000001", "1,2,3"] };
  for (const [id, [first, ...others]] of Object.entries(hostile)) {
    const page = await visit(`#/lesson/${id}${asValues({ view: first })}`, small);
    const camera = () => page.evaluate(() => window.lab.stage.camera);
    assert.equal(await camera(), null, `${id} ${first}`);
    for (const view of others) {
      await page.evaluate((numbers) => (window.lab.stage.camera = numbers), view.split(",").map(Number));
      assert.equal(await camera(), null, `${id} ${view}`);
    }
    assert.ok((await shown(page)).steps > 2);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
  const page = await visit(`#/lesson/gjk${asValues({ view: "1000000.5,2,7" })}`, small);
  assert.deepEqual(await page.evaluate(() => window.lab.stage.camera), [1000000.5, 2, 7]);
  await page.context().close();
});

test("hostile addresses: whoever comes ever nearer stops before the picture is rounding", async () => {
  const page = await visit("#/lesson/gjk", small);
  await page.evaluate(() => {
    const picture = document.querySelector(".stage2 > svg");
    for (let i = 0; i < 500; i++) picture.dispatchEvent(new KeyboardEvent("keydown", { key: "+" }));
  });
  const [x, y, reach] = await page.evaluate(() => window.lab.stage.camera);
  assert.ok(reach < 1e-10 && reach > 1e-14 * Math.hypot(x, y), `${reach}`);
  assert.ok(await page.$$eval(".stage2 .grid line", (list) => list.length) > 4, "no grid is left");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

/** The names of the geometries that the stage keeps, and the corners of the largest of them. */
const solids = (page) => page.evaluate(() => [...window.lab.stage.solids].map(([key, { faces }]) => ({ key, corners: faces.getAttribute("position").count })));

test("hostile addresses: the difference of two ellipsoids is left out, and a move makes no other geometry", async () => {
  const page = await visit("#/lesson/gjk-space", small);
  const before = await solids(page);
  assert.equal(before.filter(({ key }) => key.startsWith("difference of")).length, 1);
  await drag(page, "move-b", 22, -13);
  assert.deepEqual(await solids(page), before, "a move makes the difference anew");

  const ellipsoid = { type: "ellipsoid", ellipsoid: { radii: [1, 0.7, 0.5] } };
  const q = { query: "distance", a: { shape: ellipsoid, translation: [-1, 0, 0] }, b: { shape: ellipsoid, translation: [2, 0.5, 0] } };
  const other = await visit(`#/lesson/gjk-space${asValues({ s: { q } })}`, small);
  assert.ok(!(await other.isVisible(".trouble")));
  assert.match(await other.getAttribute("canvas[role=img]", "aria-label"), /without their difference/);
  await drag(other, "move-b", 22, -13);
  await frame(other);
  const kept = await solids(other);
  assert.deepEqual(kept.map(({ key }) => key), [JSON.stringify(ellipsoid)]);
  assert.ok(kept.every(({ key }) => key.length < 1000));
  for (const p of [page, other]) {
    assert.deepEqual(p.trouble, []);
    await p.context().close();
  }
});

test("hostile addresses: choices that are no numbers are the usual ones", async () => {
  const bad = { text: "abc", none: null, list: [1, 2], flag: true };
  const hostile = {
    stack: { effort: "9", warm: bad.text, mass: bad.text, friction: bad.text, x: bad.text, y: bad.list, z: bad.flag },
    "broad-phases": { kind: "none", x: bad.text, y: bad.none, z: bad.list },
    filters: { x0: bad.text, y0: bad.none, x1: bad.list },
    hulls: { count: bad.text, form: "constructor", x: bad.text, y: bad.none, z: bad.list },
    minkowski: { what: "nothing", x: bad.text, y: bad.list, slide: bad.text },
    resolution: { restitution: bad.text, friction: bad.list, mass: bad.text },
    spheres: { az: bad.text, bz: bad.list } };
  const page = await visit("", small);
  for (const [id, choice] of Object.entries(hostile)) {
    await goTo(page, `#/lesson/${id}`);
    const { q } = (await shown(page)).state;
    await page.evaluate((state) => window.lab.change(state, true), { q, choice });
    await frame(page);
    assert.ok(!(await page.isVisible(".trouble")), `${id}: ${await page.textContent(".trouble")}`);
    for (let i = 0; i < 2; i++) await page.click("[data-next]");
    await page.click('button[aria-label^="Last"]');
    assert.ok(!/NaN|undefined/.test((await numbers(page)) + (await page.textContent(".words")) + (await page.textContent(".code"))), id);
    assert.deepEqual(page.trouble, [], id);
  }
  await page.context().close();
});

/** The words that a lesson has for its trouble with a state; none where it shows it. */
async function troubleWith(page, state) {
  await page.evaluate((next) => window.lab.change(next, true), state);
  await frame(page);
  return (await page.isVisible(".trouble")) ? page.textContent(".trouble") : "";
}

test("hostile addresses: boxes so far away that only rounding crosses their edges have all steps", async () => {
  const page = await visit("", small);
  await goTo(page, "#/lesson/contact-set");
  const rotation = [-0.4930595611957566, 0.28751624926851466, 0.3217895623577613, 0.7554324278700337], shape = { type: "box", box: { size: [1, 1, 1] } };
  const q = { query: "contacts", margin: 0.02, a: { shape, rotation, translation: [482027947.7889937, 233337121.49171662, 349200599.42402434] },
    b: { shape, rotation, translation: [482027947.026985, 233337121.79533723, 349200598.8697165] } };
  assert.equal(await troubleWith(page, { q }), "");
  const { steps } = await shown(page);
  assert.ok(steps > 6, `${steps} steps`);
  for (let i = 1; i < steps; i++) await page.click("[data-next]");
  assert.equal((await shown(page)).step, steps - 1);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("hostile addresses: a triangle that is none is refused in the words of the library", async () => {
  const page = await visit("", small);
  await goTo(page, "#/lesson/appendix");
  const q = { query: "distance", a: { shape: { type: "plane" } }, b: { shape: { type: "triangle", triangle: { points: [[0, 1, 0], [0, 1], [1, 1, 0]] } } } };
  const { error } = JSON.parse(query(JSON.stringify(q)));
  assert.ok(error);
  assert.equal(await troubleWith(page, { choice: { pair: "plane-triangle" }, q }), `This situation cannot be shown: ${error}`);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
