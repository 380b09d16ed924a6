// The stages: what is below the pointer lights up with its row, axes and scale bar, and the camera by keyboard.

import assert from "node:assert/strict";
import { step } from "./lesson-page.mjs";
import { frame, shown, small, test, visit } from "./harness.mjs";

/** Brings the pointer to a pixel of the stage. */
async function pointAt(page, [x, y]) {
  const stage = await (await page.$(".stage")).boundingBox();
  await page.mouse.move(stage.x + x, stage.y + y);
  await frame(page);
}
const lit = (page) => page.$$eval(".numbers tr.lit", (list) => list.map((row) => row.dataset.key));

test("space: rows light up with the point, the line and the body below the pointer, and the other way round", async () => {
  const page = await visit("#/lesson/contact-set", small);
  await step(page, /^Point 2/);
  const points = await page.evaluate(() => window.lab.stage.pointsSeen);
  await pointAt(page, points[1]);
  assert.deepEqual(await lit(page), ["point-1"]);
  await pointAt(page, [3, 3]);
  assert.deepEqual(await lit(page), []);
  await pointAt(page, points[0]);
  assert.deepEqual(await lit(page), ["point-0"]);
  await page.mouse.move(2, 2);
  await frame(page);
  assert.deepEqual(await lit(page), [], "what the pointer has left stays lit");

  const axes = await visit("#/lesson/fifteen-axes", small);
  await step(axes, /^Axis A1/);
  const line = await axes.evaluate(() => window.lab.stage.linesSeen.find(({ key }) => key === "A1"));
  await pointAt(axes, line.at);
  assert.deepEqual(await lit(axes), ["A1"]);

  const filters = await visit("#/lesson/filters", small);
  await filters.click("[data-next]");
  const picture = await filters.$(".stage3 canvas"), before = await picture.screenshot();
  await filters.evaluate(() => window.lab.light("body-0"));
  await frame(filters);
  assert.notDeepEqual(await picture.screenshot(), before, "a body does not light up with its row");
  await filters.evaluate(() => window.lab.light(null));
  const body = await filters.evaluate(() => {
    const { stage, shown: { state: { choice: c } } } = window.lab;
    return stage.pixel([c.x0, c.y0 + 0.4, 0.5]);
  });
  await pointAt(filters, body);
  assert.equal(await filters.evaluate(() => window.lab.stage.lit), "body-0");
  for (const p of [page, axes, filters]) {
    assert.deepEqual(p.trouble, []);
    await p.context().close();
  }
});

test("space: the axes are named and turn with the camera, and the bar is as long as it says", async () => {
  const page = await visit("#/lesson/fifteen-axes", small);
  const arms = () => page.$$eval(".axes line", (list) => Object.fromEntries(list.map((line) =>
    [line.dataset.axis, ["x1", "y1", "x2", "y2"].map((k) => Number(line.getAttribute(k)))])));
  const before = await arms();
  assert.deepEqual(Object.keys(before).sort(), ["x", "y", "z"]);
  const seen = await page.evaluate(() => {
    const { stage } = window.lab, { target } = stage.controls, at = (p) => stage.pixel(p);
    const [o, ...ends] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((by) => at(target.toArray().map((x, i) => x + 0.001 * by[i])));
    // A length across the line of sight, at the depth of what is looked at.
    const across = target.clone().set(1, 0, 0).applyQuaternion(stage.eye.quaternion).add(target);
    return { ends: ends.map(([x, y]) => [x - o[0], y - o[1]]), unit: Math.hypot(...at(across.toArray()).map((x, i) => x - o[i])) };
  });
  for (const [i, name] of ["x", "y", "z"].entries()) {
    const [x1, y1, x2, y2] = before[name], [x, y] = seen.ends[i];
    const cosine = ((x2 - x1) * x + (y2 - y1) * y) / (Math.hypot(x2 - x1, y2 - y1) * Math.hypot(x, y));
    assert.ok(cosine > 0.999, `${name} points elsewhere: ${cosine}`);
  }
  const [length, said] = await page.$eval(".axes", (axes) => [axes.querySelector(".bar").getBBox().width, Number([...axes.querySelectorAll("text")].at(-1).textContent)]);
  assert.ok(Math.abs(length - said * seen.unit) < 0.01 * length, `${said} is ${said * seen.unit} pixels, the bar ${length}`);
  await page.focus(".stage3 canvas");
  await page.keyboard.press("ArrowLeft");
  await frame(page);
  assert.notDeepEqual(await arms(), before);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("plane: the keyboard moves the camera, which the address keeps", async () => {
  const page = await visit("#/lesson/gjk", small);
  await page.focus(".stage2 > svg");
  const middle = () => page.evaluate(() => window.lab.stage.view), before = await middle();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("+");
  await frame(page);
  const after = await middle();
  assert.ok(after.center[0] > before.center[0] && after.center[1] > before.center[1] && after.reach < before.reach);
  await page.waitForFunction(() => location.hash.includes("view="));
  const other = await visit(await page.evaluate(() => location.hash), small);
  assert.deepEqual((await other.evaluate(() => window.lab.stage.camera)).map((x) => x.toPrecision(3)), (await page.evaluate(() => window.lab.stage.camera)).map((x) => x.toPrecision(3)));
  assert.equal((await shown(page)).step, 0);
  for (const p of [page, other]) {
    assert.deepEqual(p.trouble, []);
    await p.context().close();
  }
});

test("stages: the camera in an address comes back to the last digit", async () => {
  const page = await visit("#/scene?scene=shapes", small), camera = (of) => of.evaluate(() => window.lab.stage.camera);
  await page.focus(".stage3 canvas");
  for (const key of ["ArrowLeft", "ArrowUp", "+", "ArrowLeft"]) await page.keyboard.press(key);
  await page.waitForFunction(() => location.hash.includes("view="));
  await page.waitForTimeout(400); // the address is written once the camera stays
  const hash = await page.evaluate(() => location.hash), other = await visit(hash, small);
  assert.deepEqual(await camera(other), await camera(page));
  await other.click("[data-step]");
  await other.waitForFunction(() => location.hash.includes("steps"));
  const view = (text) => new URLSearchParams(text.split("?")[1]).get("view");
  assert.equal(view(await other.evaluate(() => location.hash)), view(hash));
  for (const one of [page, other]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});
