// Actions of tests in the viewer.

import assert from "node:assert/strict";
import { join } from "node:path";
import { here, small, visit } from "./harness.mjs";

export const scene = (name) => visit(`#/scene?scene=${name}`, small);
/** Presses a button so many times, without a look at the page in between. */
export const press = (page, button, times) =>
  page.evaluate(([selector, count]) => {
    for (let i = 0; i < count; i++) document.querySelector(selector).click();
  }, [button, times]);
export const files = join(here, "../../examples/scenes");

/** Checks that contacts light up with their row: another picture than without. */
export async function lightsUp(page) {
  const picture = await page.$(".stage3 canvas"), plain = await picture.screenshot();
  await page.hover(".numbers tbody tr:first-child");
  await page.waitForTimeout(200);
  assert.notDeepEqual(await picture.screenshot(), plain);
}
