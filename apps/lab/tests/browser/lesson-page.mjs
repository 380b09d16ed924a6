// Actions of tests on the page of a lesson.

import { frame } from "./harness.mjs";

/** Goes to the step with this title. */
export async function step(page, title) {
  await page.click('button[aria-label^="First"]');
  while (!title.test(await page.textContent(".words h2"))) await page.click("[data-next]");
}
export const example = async (page, label) => {
  await page.click(`.example:text-is("${label}")`);
  await frame(page);
};
/** The axes beside the picture; a gap is a negative overlap. */
export const axisRows = (page) =>
  page.$$eval(".numbers tbody tr", (list) => list.map((r) => {
    const [overlap, gap] = [...r.cells].slice(-2).map((c) => c.getAttribute("title"));
    return { name: r.querySelector("th").textContent, overlap: overlap === null ? -Number(gap) : Number(overlap), wins: r.classList.contains("is-winner") };
  }));
