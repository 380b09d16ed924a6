// Every lesson loads, its steps run to the end, permalinks and undo restore, and axe finds nothing.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { accessible, bareColumns, frame, goTo, unseen, numbers, onLesson, shown, small, test, visit } from "./harness.mjs";

const home = await visit("");
/** The addresses of all lessons. */
export const lessons = await home.$$eval(".lessons a", (list) => list.map((a) => a.getAttribute("href")));
await home.context().close();

test("the list has every lecture", () => assert.ok(lessons.length >= 14, `${lessons.length} lessons`));

/** Goes through the steps from the first to the last. */
async function walk(page) {
  const { steps } = await shown(page);
  assert.ok(steps >= 2, `${steps} steps`);
  const titles = new Set();
  for (let i = 0; i < steps; i++) {
    titles.add(`${i} ${await page.textContent(".words h2")}`);
    const words = (await page.textContent(".words p")).split(/\s+/).length;
    assert.ok(words <= 120, `step ${i + 1} has ${words} words`);
    assert.deepEqual(await bareColumns(page), [], `step ${i + 1} has a column without a heading`);
    assert.deepEqual(await unseen(page), [], `step ${i + 1} has labels or handles that are not seen`);
    if (i + 1 < steps) await page.click("[data-next]");
  }
  assert.equal(titles.size, steps);
  assert.equal((await shown(page)).step, steps - 1);
  assert.ok(await page.isDisabled("[data-next]"), "there is a step after the last");
}
/** Goes to the last step of what was chosen. */
async function toTheEnd(page, chosen) {
  await frame(page);
  assert.ok(!(await page.isVisible(".trouble")), chosen);
  await page.click('button[aria-label^="Last"]');
  assert.deepEqual(await unseen(page), [], `${chosen}: labels or handles are not seen`);
}

for (const lesson of lessons) {
  test(`${lesson} runs to its end without a finding of axe, and its examples too`, () => onLesson(lesson, async (page) => {
    await walk(page);
    await accessible(page);
    await page.emulateMedia({ colorScheme: "dark" });
    await frame(page);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
    await accessible(page, "dark");
    await page.emulateMedia({ colorScheme: "light" });
    for (const button of await page.$$(".example")) {
      await button.click();
      await toTheEnd(page, await button.textContent());
      await page.click('button[aria-label^="First"]');
    }
    for (const choice of await page.$$eval(".choices fieldset:not(.bits) button", (list) => list.map((b) => b.textContent))) {
      await page.click(`.choices button:text-is("${choice}")`);
      await toTheEnd(page, choice);
    }
  }));

  test(`${lesson} is restored by its permalink, and by undo`, () => onLesson(lesson, async (page) => {
    const before = JSON.stringify((await shown(page)).state);
    const example = await page.$(".example");
    await example.click();
    await frame(page);
    await page.click("[data-next]");
    const state = await shown(page), address = await page.evaluate(() => location.hash);
    assert.notEqual(JSON.stringify(state.state), before);
    const words = await page.textContent(".words"), beside = await numbers(page);
    const other = await visit(address, small);
    assert.deepEqual(await shown(other), state);
    assert.equal(await other.textContent(".words"), words);
    assert.equal(await numbers(other), beside);
    assert.deepEqual(other.trouble, []);
    await page.click('button:text-is("Undo")');
    await frame(page);
    assert.equal(JSON.stringify((await shown(page)).state), before);
    await other.context().close();
  }));

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

test("a phone shows a page in its width, the next step's button at once, labels, handles, and drawing and title of a step together", async () => {
  const page = await visit("", { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const over = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  const boxes = () => page.evaluate(() => ["[data-next]", ".stage", ".words h2", ".timeline"].map((x) => {
    const { left, top, right, bottom } = document.querySelector(x).getBoundingClientRect();
    return { top, bottom, onTop: document.elementFromPoint((left + right) / 2, (top + bottom) / 2)?.matches(x) };
  }));
  assert.ok((await over()) <= 0, `the list of all: ${await over()} pixels`);
  for (const lesson of lessons) {
    await goTo(page, lesson);
    const [next] = await boxes();
    assert.ok(next.bottom <= 740 && next.onTop && (await page.evaluate(() => scrollY)) === 0, `${lesson}: the button reaches down to ${next.bottom} of 740 pixels`);
    await page.tap("[data-next]");
    const [, stage, title, bar] = await boxes();
    assert.ok(stage.top >= 0 && stage.bottom <= title.top && title.bottom <= bar.top && bar.bottom <= 740.5,
      `${lesson}: drawing ${stage.top} to ${stage.bottom}, title ${title.top} to ${title.bottom}, controls ${bar.top} to ${bar.bottom}`);
    for (const end of ["First", "Last"]) {
      await page.click(`button[aria-label^="${end}"]`);
      assert.ok((await over()) <= 0, `${lesson}: ${await over()} pixels`);
      assert.deepEqual(await unseen(page), [], lesson);
    }
  }
  // Whoever reads on keeps the place; an example far below leads back to the drawing.
  await goTo(page, "#/lesson/fifteen-axes");
  await page.tap('button[aria-label^="Last"]');
  const reading = await page.evaluate(() => (scrollBy(0, document.querySelector(".numbers").getBoundingClientRect().top - 400), scrollY));
  await page.tap('button[aria-label^="Previous"]');
  assert.equal(await page.evaluate(() => scrollY), reading);
  await page.tap(".example");
  const [, stage, title, bar] = await boxes();
  assert.ok(stage.top >= 0 && stage.bottom <= title.top && title.bottom <= bar.top, "an example is not seen");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("the button of the next step is seen without scrolling, and only controls show the focus", async () => {
  const page = await visit("", { viewport: { width: 1280, height: 800 } });
  for (const lesson of lessons) {
    await goTo(page, lesson);
    const [bottom, height] = await page.evaluate(() => [".timeline", ".stage"].map((x) => document.querySelector(x).getBoundingClientRect()).map((box, i) => (i ? box.height : box.bottom)));
    assert.ok(bottom <= 800 && height >= 300, `${lesson}: down to ${bottom} of 800 pixels, the drawing ${height} high`);
    const focus = () => page.evaluate(() => [document.activeElement.tagName, getComputedStyle(document.activeElement).outlineStyle]);
    assert.deepEqual(await focus(), ["MAIN", "none"]);
    await page.keyboard.press("Tab");
    assert.equal((await focus())[1], "solid");
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("a choice keeps the focus, and its row the place to which it was pushed", async () => {
  const page = await visit("#/lesson/broad-phases", { viewport: { width: 390, height: 844 } });
  await page.focus('.choices button:text-is("BSP")');
  await page.keyboard.press("Enter");
  await frame(page);
  assert.equal(await page.$eval('.choices button:text-is("BSP")', (button) => button === document.activeElement && button.getAttribute("aria-pressed")), "true");
  const seen = (of) => of.evaluate(() => (({ left, right }) => left >= 0 && right <= innerWidth)([...document.querySelectorAll(".choices button")].find((x) => x.textContent === "BSP").getBoundingClientRect()));
  assert.ok(await seen(page));
  const other = await visit(await page.evaluate(() => location.hash), { viewport: { width: 390, height: 844 } });
  assert.ok(await seen(other), "a choice of the address is not seen");
  await page.context().close();
  await other.context().close();
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
