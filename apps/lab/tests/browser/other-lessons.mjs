// Lessons of planes and of resolution, and their programs.

import assert from "node:assert/strict";
import { example } from "./lesson-page.mjs";
import { drag, frame, query, shown, test, traced, visit } from "./harness.mjs";

test("planes: three points, a distance and a normal give the same plane, and a line gives none", async () => {
  const page = await visit("#/lesson/planes-boxes");
  const before = (await traced(page)).distance, rest = async () => Math.abs((await traced(page)).distance - before);
  await page.click('.choices button:text-is("three points")');
  await frame(page);
  assert.equal(await rest(), 0);
  await drag(page, "point-1", 0, -30);
  assert.ok(await rest() > 1e-3, "the plane follows its points");
  const { state } = await shown(page), n = (await traced(page)).normal;
  const at = (name) => [0, 1, 2].map((k) => state.choice[`${name}${k}`]);
  const along = (p) => p.reduce((sum, x, i) => sum + x * n[i], 0);
  for (const name of ["q", "r"]) assert.ok(Math.abs(along(at(name)) - along(at("p"))) < 1e-9, `${name} is not in the plane`);
  await page.click('.choices button:text-is("normal and distance")');
  await frame(page);
  const apart = (await traced(page)).distance;
  await drag(page, "foot", 0, -40);
  assert.ok((await traced(page)).distance < apart - 1e-3, "the plane comes nearer to the box above it");
  await example(page, "Three points on a line");
  assert.match(await page.textContent(".words h2"), /no plane/);
  await page.click('.choices button:text-is("three points")');
  await drag(page, "point-2", 0, 60);
  assert.equal(await page.textContent(".words h2"), "By three points");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("programs: a lesson without a question of the protocol offers none to copy", async () => {
  for (const [id, languages, asked] of [["spheres", 3, true], ["broad-phases", 2, false], ["filters", 3, false]]) {
    const page = await visit(`#/lesson/${id}`);
    assert.equal(await page.$$eval(".code details", (list) => list.length), languages + (asked ? 1 : 0), id);
    assert.equal(await page.isVisible('button:text-is("Copy as a question")'), asked, id);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("programs: those that were opened stay open, and have the numbers of a drag once it has ended", async () => {
  const page = await visit("#/lesson/gjk");
  await page.click('.code summary:text-is("C++")');
  await page.click('.code summary:text-is("JavaScript")');
  const open = () => page.$$eval(".code details[open]", (list) => list.map((x) => x.textContent)), before = await open();
  assert.equal(before.length, 1);
  assert.ok(before[0].startsWith("C++"));
  await page.evaluate(() => scrollTo(0, 0));
  await drag(page, "move-b", 30, 20);
  const after = await open();
  assert.equal(after.length, 1);
  assert.ok(after[0].startsWith("C++") && after[0] !== before[0], "the program has the old numbers");
  const during = await page.evaluate(() => {
    const { q } = window.lab.state;
    window.lab.change({ ...window.lab.state, q: { ...q, b: { ...q.b, translation: [3, 2] } } }, false);
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(document.querySelector(".code details[open]").textContent))));
  });
  assert.equal(during, after[0], "the programs are written anew in every frame of a drag");
  await page.context().close();
});

test("resolution: impulse and approach are the library's to the last digit", async () => {
  const page = await visit("#/lesson/resolution");
  for (const example of [null, ...(await page.$$(".example"))]) {
    if (example) await example.click();
    await page.click('button[aria-label^="First"]');
    await frame(page);
    const { question } = await shown(page), { trace, normalImpulse } = JSON.parse(query(JSON.stringify({ ...question, explain: true })));
    const title = (row) => page.$eval(`.numbers tbody tr:nth-child(${row}) td:not(.mark)`, (cell) => Number(cell.getAttribute("title")));
    await page.click("[data-next]");
    assert.equal(await title(1), trace.relativeVelocity.normal);
    await page.click("[data-next]");
    assert.equal(await title(1), trace.effectiveMass);
    assert.equal(await title(2), normalImpulse);
  }
  await page.context().close();
});

test("a label lies beyond the arrow that it names, and no line of the ground is drawn through a body", async () => {
  const page = await visit("#/lesson/epa");
  await page.click('button[aria-label^="Last"]');
  const beyond = await page.evaluate(() => {
    const { stage } = window.lab, { at, from, text } = stage.texts.find((label) => label.from);
    const label = [...document.querySelectorAll(".stage2 text")].find((x) => x.textContent === text).getBoundingClientRect(), { left, top } = stage.element.getBoundingClientRect();
    const [tip, end] = [stage.pixel(at), stage.pixel(from)];
    return ((label.left + label.right) / 2 - left - tip[0]) * (tip[0] - end[0]) + ((label.top + label.bottom) / 2 - top - tip[1]) * (tip[1] - end[1]);
  });
  assert.ok(beyond > 0, `${beyond}`);
  await page.evaluate(() => (location.hash = "#/lesson/hulls"));
  await page.waitForFunction(() => window.lab.lesson?.id === "hulls");
  // Through both sides of the translucent hull a fifth is seen of what lies behind it, and no more of what crosses it.
  const through = await page.evaluate(() => {
    const { stage } = window.lab, pen = document.createElement("canvas").getContext("2d"), { width, height } = stage.canvas;
    const middle = () => {
      stage.renderer.render(stage.scene, stage.eye);
      pen.clearRect(0, 0, 300, 150);
      pen.drawImage(stage.canvas, width / 2 - 100, height / 2 - 40, 200, 100, 0, 0, 200, 100);
      return pen.getImageData(0, 0, 200, 100).data;
    };
    const withGround = middle();
    stage.hasGrid = false;
    window.lab.paint();
    return middle().reduce((most, value, i) => Math.max(most, Math.abs(value - withGround[i])), 0);
  });
  assert.ok(through < 60, `the ground's lines differ from the hull by ${through} of 255`);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
