// A question of the protocol that is pasted into the viewer is answered there, whatever it asks.

import assert from "node:assert/strict";
import { join } from "node:path";
import { drawn } from "./scene-page.mjs";
import { drag, query, short, shown, small, test, visit } from "./harness.mjs";

const ball = { type: "sphere", sphere: { radius: 0.5 } }, box = { type: "box", box: { size: [1, 2, 3] } };
const disc = { type: "circle", circle: { radius: 0.5 } };
const near = (p, q) => Math.hypot(...p.map((x, i) => x - (q[i] ?? 0))) < 1e-5;

/** The questions, the words that the answer has to be told with, and places that the drawing has to have points or ends
 *  of lines at. */
const questions = [
  [{ query: "raycast", a: { shape: box, rotation: [0, 0, 1, 1] }, ray: { origin: [-5, 0.25, 0.5], direction: [2, 0, 0] } },
    (x) => ["The ray hits A", `after ${short(x.t, 6)}`], (x) => [[-5, 0.25, 0.5], x.point]],
  [{ query: "raycast", a: { shape: ball }, ray: { origin: [-5, 0, 0], direction: [1, 0, 0], length: 3 } }, () => ["The ray hits nothing"], () => [[-5, 0, 0], [-2, 0, 0]]],
  [{ query: "raycast", dimension: 2, a: { shape: disc, translation: [1, 0] }, ray: { origin: [-3, 0.1], direction: [1, 0] } },
    (x) => ["The ray hits A", `after ${short(x.t, 6)}`], (x) => [[-3, 0.1], x.point]],
  [{ query: "closest", a: { shape: box, translation: [0, 1, 0] }, point: [3, 0.5, 0] }, (x) => [`${short(x.distance, 6)} from A's surface`], (x) => [[3, 0.5, 0], x.point]],
  [{ query: "cast", a: { shape: box, linear: [0.5, 0, 0] }, b: { shape: ball, translation: [5, 0, 0], linear: [-2, 0, 0] }, duration: 3 },
    (x) => ["A meets B on its way", `at ${short(x.t, 6)}`], (x) => [x.point, [5 - 2 * x.t, 0, 0]]],
  [{ query: "cast", a: { shape: box }, b: { shape: ball, translation: [5, 0, 0], linear: [-2, 0, 0] }, duration: 1 }, () => ["A meets B nowhere on its way"], () => [[3, 0, 0]]],
  [{ query: "response", a: { mass: "infinity" }, b: { mass: 2, shape: ball, translation: [0, 0.5, 0], linear: [1, -4, 0] }, contact: { point: [0, 0, 0], normal: [0, 1, 0] }, restitution: 0.5 },
    (x) => ["After the blow", `${short(x.normalImpulse, 5)} along the normal`], () => [[0, 0, 0]]],
  [{ query: "contacts", a: { shape: box }, b: { shape: box, translation: [1.3, 0, 0] }, margin: 0.5 }, () => ["They are apart"], (x) => x.manifolds[0].points.map((p) => p.a)],
];
const asked = (page) => page.inputValue("textarea").then(JSON.parse);

test("questions: each is answered in the viewer with the same bits, and drawn; the address holds it", async () => {
  for (const [i, [question, words, places]] of questions.entries()) {
    const page = await visit(`#/scene?q=${encodeURIComponent(JSON.stringify(question))}`, small), answer = JSON.parse(query(JSON.stringify(question)));
    const said = await page.textContent(".words");
    for (const one of words(answer)) assert.ok(said.includes(one), `${question.query}: "${said}" without "${one}"`);
    // Of a pair the places are written out; of everything else the line is the one that was pasted.
    if (question.b && question.query === "contacts") assert.equal((await asked(page)).margin, question.margin);
    else assert.deepEqual(await asked(page), question);
    assert.equal(await page.inputValue("[data-explained]"), question.query);
    const { lines, points } = await drawn(page), ends = [...points, ...lines.flat()];
    if (question.query !== "contacts")
      for (const place of places(answer)) assert.ok(ends.some((end) => near(place, end)), `${question.query}: nothing at ${place}`);
    else assert.ok((await page.$$(".numbers tbody tr")).length >= places(answer).length);
    const { trace } = JSON.parse(query(JSON.stringify({ ...question, explain: true }))), of = (...lists) => lists.reduce((sum, list) => sum + (trace[list] ?? []).length, 0);
    const count = question.query === "response" ? 3 + (trace.friction ? 1 : 0) : of("spans", "steps", ...(/cast/.test(question.query) ? [] : ["axes", "gjk", "epa", "cuts"]));
    const told = () => page.textContent(".trace-steps output");
    assert.match(await told(), count > 0 ? new RegExp(`^${count} steps$`) : /^[^,]+, no steps$/, `${question.query}: ${await told()}`);
    for (let k = 0; k < count; k++) await page.click("[data-trace-next]");
    if (count > 0) assert.ok((await told()).startsWith(`${count} / ${count}. `), await told());
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `question-${i}-${question.query}.png`) });
    await page.selectOption(".speed", "0.5"); // writes the address
    const again = await visit(await page.evaluate(() => location.hash), small);
    assert.equal(await again.textContent(".words"), said);
    for (const one of [page, again]) {
      assert.deepEqual(one.trouble, []);
      await one.context().close();
    }
  }
});

test("questions: the answer follows a body that is moved, and one that is pasted is asked as an opened one", async () => {
  const page = await visit("#/scene?scene=heavy", small), [question] = questions[0];
  await page.click('summary:text-is("As a question")');
  await page.fill("textarea", JSON.stringify(question));
  await page.click('button:text-is("Ask it")');
  assert.deepEqual(await asked(page), question);
  await page.selectOption('[data-body="0"]', { label: "A" });
  await drag(page, "X", 60, 0);
  const [x] = (await shown(page)).poses;
  assert.ok(x > 0.1, `${x}`);
  await page.selectOption('[data-body="0"]', "");
  const moved = await asked(page);
  assert.ok(Math.abs(moved.a.translation[0] - x) < 1e-12);
  assert.deepEqual(moved.ray, question.ray);
  assert.ok((await page.textContent(".words")).includes(`after ${short(JSON.parse(query(JSON.stringify(moved))).t, 6)}`));
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("questions: of bodies that turn on their way the gap is drawn where they are, and both", async () => {
  const a = { shape: box, linear: [0.5, 0, 0], angular: [0, 0, 2] }, b = { shape: ball, translation: [5, 0.2, 0], linear: [-1, 0, 0] };
  const flat = { a: { shape: { type: "box", box: { size: [1, 2] } }, linear: [0.5, 0], angular: 2 }, b: { shape: disc, translation: [5, 0.2], linear: [-1, 0] } };
  for (const question of [{ query: "cast", a, b, duration: 4 }, { query: "cast", dimension: 2, ...flat, duration: 4 }]) {
    const page = await visit(`#/scene?q=${encodeURIComponent(JSON.stringify(question))}`, small);
    const { trace } = JSON.parse(query(JSON.stringify({ ...question, explain: true })));
    // The layer of shots has the same ways up to the hit.
    await page.click(".legend > summary");
    await page.uncheck("[data-layer=shots]");
    for (const { t, distance } of trace.steps.slice(0, 6)) {
      await page.click("[data-trace-next]");
      const { lines } = await drawn(page), size = ([p, q]) => Math.hypot(...p.map((x, i) => x - q[i]));
      assert.ok(lines.some((line) => Math.abs(size(line) - distance) < 1e-5), `no gap of ${distance} at ${t}`);
      if (t > 0) assert.ok(lines.some((line) => near([5, 0.2, 0], line[0]) && near([5 - t, 0.2, 0], line[1])), `B has no way at ${t}`);
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("questions: an address with a broken one says what is wrong", async () => {
  const broken = [{ query: "raycast", a: { shape: ball } }, { query: "closest", a: { shape: ball }, point: [1] }, { query: "response", a: {}, b: {} },
    { query: "cast", a: { shape: ball }, b: { shape: ball, linear: [1] } }, { query: "nothing", a: { shape: ball } }];
  for (const question of broken) {
    const page = await visit(`#/scene?q=${encodeURIComponent(JSON.stringify(question))}`, small);
    await page.waitForSelector(".stage3");
    const said = `${await page.textContent(".words")}${await page.textContent(".trouble")}`;
    assert.match(said, /expected|There is no answer/, said);
    assert.deepEqual(page.trouble, [], JSON.stringify(question));
    await page.context().close();
  }
});
