// Every lesson loads, its steps run to the end, permalinks and undo restore, and axe finds nothing.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { axe, bareColumns, frame, numbers, shown, small, test, visit } from "./harness.mjs";

const home = await visit("");
/** The addresses of all lessons. */
export const lessons = await home.$$eval(".lessons a", (list) => list.map((a) => a.getAttribute("href")));
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
      assert.deepEqual(await bareColumns(page), [], `step ${i + 1} has a column without a heading`);
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
    for (const choice of await page.$$eval(".choices fieldset:not(.bits) button", (list) => list.map((b) => b.textContent))) {
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
  // One page that goes from lesson to lesson: to load the library anew takes longer than to look.
  const page = await visit("", { viewport: { width: 360, height: 740 } });
  for (const hash of ["#/", ...lessons]) {
    await page.evaluate((to) => (location.hash = to), hash);
    await page.waitForFunction((to) => (to === "#/") === (document.querySelector("article.home") !== null) && location.hash.startsWith(to), hash);
    await frame(page);
    if (hash !== "#/") assert.equal(await page.evaluate(() => `#/lesson/${window.lab.lesson.id}`), hash);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(over <= 0, `${hash}: ${over} pixels`);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
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
