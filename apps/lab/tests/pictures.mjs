// The pictures of the lab that the pages of docs/ show, made anew from the built lab.
//
//   node tests/pictures.mjs           ONLY=text: those whose names contain it

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { join } from "node:path";
import { close, frame, here, visit } from "./browser/harness.mjs";

/** Nothing is larger: whoever clones the project gets them all. */
const mostBytes = 200_000;
const docs = join(here, "../../docs");
const wide = { viewport: { width: 1180, height: 760 } };
const to = async (page, step) => {
  for (let i = 1; i < step; i++) await page.click("[data-next]");
};
/** Presses a button of time so many times. */
const press = (page, button, times) => page.evaluate(([selector, count]) => {
  for (let i = 0; i < count; i++) document.querySelector(selector).click();
}, [button, times]);

/** By the names of the files: the page, the window, and what is done before the picture is taken. */
const pictures = {
  // Two boxes that overlap, and the axis that decides.
  "lab": ["#/lesson/separating-axes-plane", wide, (page) => to(page, 16)],
  // A pair of a scene, why it touches, and each point of contact.
  "lab-viewer": [`#/scene?scene=heavy&at=${encodeURIComponent(JSON.stringify({ selected: [1, 2], explained: "contacts", traceStep: 15 }))}`, wide, () => {}],
  // A run that goes on, with its energy and its depth.
  "lab-playground": ["#/scene?scene=domino", { viewport: { width: 1180, height: 800 } }, async (page) => {
    await press(page, "[data-step]", 90);
    await page.click("[data-play]");
    await page.waitForFunction(() => window.lab.play.steps >= 100);
  }],
  "lab-phone": ["#/lesson/gjk", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, (page) => to(page, 4)],
  "lab-dark": ["#/lesson/contact-set", { ...wide, colorScheme: "dark" }, (page) => to(page, 5)],
};

for (const [name, [hash, options, act]] of Object.entries(pictures)) {
  if (process.env.ONLY && !name.includes(process.env.ONLY)) continue;
  const page = await visit(hash, { reducedMotion: "reduce", ...options }), path = join(docs, `${name}.png`);
  await act(page);
  await page.evaluate(() => scrollTo(0, 0));
  await frame(page);
  await page.screenshot({ path });
  assert.deepEqual(page.trouble, []);
  const { size } = statSync(path);
  assert.ok(size < mostBytes, `${name}.png has ${size} bytes, at most ${mostBytes} are kept`);
  console.log(`docs/${name}.png: ${Math.round(size / 1000)} kB`);
  await page.context().close();
}
await close();
