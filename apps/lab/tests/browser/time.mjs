// A run of the viewer: repeated from its address, gone through, undone, saved, and its events.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { press, scene } from "./scene-page.mjs";
import { frame, graze, shown, small, test, visit } from "./harness.mjs";

const address = (page) => page.evaluate(() => location.hash);
/** Moves the slider of time, as somebody does who lets it go there. */
const scrub = (page, step) => page.evaluate((to) => {
  const slider = document.querySelector("[data-fold=time] input[type=range]");
  slider.value = String(to);
  for (const name of ["input", "change"]) slider.dispatchEvent(new Event(name));
}, step);
const set = async (page, field, value) => {
  await page.fill(field, String(value));
  await page.dispatchEvent(field, "change");
};
/** A scene of the list at a moment. */
const at = (name, moment) => visit(`#/scene?scene=${name}&at=${encodeURIComponent(JSON.stringify(moment))}`, small);
const momentOf = async (page) => JSON.parse(new URLSearchParams((await address(page)).split("?")[1]).get("at"));
const restitution = '[data-material] label:has-text("Restitution") input';

test("time: the address of a run repeats it with everything that was done, to the same bits", async () => {
  const page = await scene("heavy");
  await page.selectOption('[data-body="0"]', { label: "light" });
  await set(page, restitution, 0.5);
  await press(page, "[data-step]", 12);
  await set(page, restitution, 0.9);
  await set(page, '[aria-label^="Gravity along X"]', 3);
  await press(page, "[data-step]", 6);
  // A place for a body while time stands, and a pull while it goes on.
  await page.evaluate(() => {
    const { play, stage } = window.lab;
    const { at } = stage.last.handles.find(({ id }) => id === "Y");
    window.lab.drag("Y", [at[0], at[1] + 0.5, at[2]], true);
    play.toggle();
    window.lab.drag("Y", [at[0], at[1] + 2, at[2]], false);
    for (let i = 0; i < 8; i++) play.forward();
    window.lab.drag("Y", [at[0], at[1] + 2, at[2]], true);
    for (let i = 0; i < 4; i++) play.forward();
    document.querySelector("[data-play]").click();
  });
  await page.waitForFunction(() => /pull/.test(location.hash));
  const there = await shown(page);
  assert.ok(there.frames >= 30, `${there.frames}`);
  const other = await visit(await address(page), small);
  await other.waitForFunction((steps) => window.lab.shown.frames === steps, there.frames);
  assert.deepEqual((await shown(other)).poses, there.poses);
  assert.equal(await other.inputValue(restitution), "0.9");
  assert.equal(await other.inputValue('[aria-label^="Gravity along X"]'), "3");
  // Without what was done it comes elsewhere.
  const plain = await scene("heavy");
  await press(plain, "[data-step]", there.frames);
  assert.notDeepEqual((await shown(plain)).poses, there.poses);
  for (const one of [page, other, plain]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: while a run is repeated the address, undo and a look at something else keep the whole of it", async () => {
  const inputs = [20, 380].map((step) => ({ kind: "gravity", gravity: [step / 100, -9.81, 0], step })), page = await at("pyramid", { steps: 400, inputs });
  const early = await shown(page);
  assert.ok(early.frames < 400, "the run was there before anybody looked");
  for (const body of ["box 19.0", "box 0.0"]) await page.selectOption('[data-body="0"]', { label: body });
  const looked = await momentOf(page);
  await page.click("[data-undo]");
  const undone = await momentOf(page);
  assert.ok((await shown(page)).frames < 400);
  await page.waitForFunction(() => window.lab.shown.frames === 400 && !window.lab.play.running);
  for (const moment of [looked, undone, await momentOf(page)]) assert.deepEqual([moment.steps, moment.inputs], [400, inputs]);
  // Somebody who stops it stays there.
  const other = await at("pyramid", { steps: 400, inputs });
  await other.click("[data-play]");
  const { frames } = await shown(other);
  assert.ok(frames > 0 && frames < 400);
  await other.waitForFunction((steps) => new RegExp(`steps%22%3A${steps}%`).test(location.hash), frames);
  assert.deepEqual((await momentOf(other)).inputs, inputs.slice(0, 1));
  for (const one of [page, other]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: what is done before the first step is in the address, in undo and in a capture", async () => {
  const page = await scene("heavy");
  await press(page, "[data-step]", 3);
  await scrub(page, 0);
  await page.selectOption('[data-body="0"]', { label: "light" });
  await set(page, restitution, 0.5);
  await set(page, '[aria-label^="Gravity along X"]', 3);
  await page.evaluate(() => {
    const { at } = window.lab.stage.last.handles.find(({ id }) => id === "Y");
    window.lab.drag("Y", [at[0], at[1] + 0.25, at[2]], true);
  });
  const { poses, frames } = await shown(page);
  assert.equal(frames, 0);
  const same = async (one) => {
    assert.deepEqual((await shown(one)).poses, poses);
    assert.deepEqual(await Promise.all([restitution, '[aria-label^="Gravity along X"]'].map((field) => one.inputValue(field))), ["0.5", "3"]);
  };
  const other = await visit(await address(page), small);
  await same(other);
  await page.click('button:text-is("Start again")');
  assert.notDeepEqual((await shown(page)).poses, poses);
  await page.click("[data-undo]");
  await same(page);
  for (const one of [page, other]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: 'Start again' is taken back, stops a scene that plays, and ends what was to come", async () => {
  const page = await scene("heavy");
  await press(page, "[data-step]", 5);
  const { poses } = await shown(page);
  await press(page, "[data-back]", 5);
  await page.click("[data-play]");
  await page.waitForFunction(() => window.lab.shown.frames > 0);
  await page.click('button:text-is("Start again")');
  const begun = await page.evaluate(() => [window.lab.play.running, window.lab.play.steps, window.lab.play.last]);
  assert.deepEqual(begun, [false, 0, 0]);
  await page.click("[data-undo]");
  assert.ok((await shown(page)).frames > 0);
  await page.click("[data-redo]");
  assert.equal((await shown(page)).frames, 0);
  await press(page, "[data-step]", 5);
  assert.deepEqual((await shown(page)).poses, poses);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: undo while a scene plays comes back to where it was before, and redo to where it stopped", async () => {
  const page = await scene("heavy");
  await press(page, "[data-step]", 5);
  await page.click("[data-play]");
  await page.waitForFunction(() => window.lab.shown.frames > 8);
  await page.keyboard.press("Control+z");
  assert.deepEqual(await page.evaluate(() => [window.lab.play.running, window.lab.play.steps]), [false, 5]);
  await page.click("[data-redo]");
  assert.ok((await shown(page)).frames > 8);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: without warm starts a stack sinks, and the address, undo and a capture keep that", async () => {
  const page = await scene("tower"), field = 'label:has-text("Warm start") input';
  await press(page, "[data-step]", 60);
  const warm = await shown(page);
  assert.ok(await page.isChecked(field));
  await page.uncheck(field);
  assert.equal((await shown(page)).frames, 0, "it begins anew");
  await press(page, "[data-step]", 60);
  const cold = await shown(page);
  assert.ok(cold.deepest > 4 * warm.deepest, `${cold.deepest} m deep without warm starts, ${warm.deepest} m with them`);
  await page.waitForFunction(() => /steps%22%3A60%/.test(location.hash));
  const other = await visit(await address(page), small);
  await other.waitForFunction(() => window.lab.shown.frames === 60);
  assert.deepEqual((await shown(other)).poses, cold.poses);
  assert.ok(!(await other.isChecked(field)));
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("[data-save]")]);
  let last = [];
  const report = graze.replay(readFileSync(await download.path()), (world) => (last = Array.from(world.poses())));
  assert.equal(report.difference, null);
  assert.deepEqual(last, cold.poses);
  for (let i = 0; i < 61; i++) await page.keyboard.press("Control+z");
  assert.ok(await page.isChecked(field));
  assert.deepEqual((await shown(page)).poses, warm.poses);
  const broken = await at("tower", { warmStart: "no" });
  assert.ok(await broken.isChecked(field));
  for (const one of [page, other, broken]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: gravity is shown as it was at each step; one that is refused changes nothing", async () => {
  const page = await scene("heavy"), along = '[aria-label^="Gravity along X"]';
  await press(page, "[data-step]", 4);
  await set(page, along, 3);
  await press(page, "[data-step]", 4);
  await scrub(page, 2);
  assert.equal(await page.inputValue(along), "0");
  await scrub(page, 6);
  assert.equal(await page.inputValue(along), "3");
  await page.evaluate(() => window.lab.set({ gravity: [NaN, 0, 0] }));
  assert.match(await page.textContent(".trouble:not([hidden])"), /gravity/);
  assert.deepEqual(await page.evaluate(() => [window.lab.play.last, window.lab.play.gravity]), [8, [3, -9.81, 0]]);
  assert.equal(await page.inputValue(along), "3");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: nothing of an address that a scene has not makes the page blank, and nothing goes over to another scene", async () => {
  const inputs = [{ step: 0, kind: "pull", pull: { body: 99, to: [0, 0, 0] } }, { step: 1, kind: "material", body: 99, material: {} }, { step: 2, kind: "gravity", gravity: [1, -9.81, 0] }];
  const page = await at("heavy", { steps: 5, inputs });
  assert.equal((await shown(page)).frames, 5);
  await page.selectOption('[data-body="0"]', { label: "light" });
  assert.deepEqual((await momentOf(page)).inputs, inputs.slice(2));
  assert.ok(!(await page.isVisible(".trouble")));
  const elsewhere = [];
  for (const what of ["q=%7B", "q=%7B%7D", "s=%7B%7D", "scene=nothing"]) {
    const other = await visit(`#/scene?${what}&at=${encodeURIComponent(JSON.stringify({ steps: 5, selected: [1] }))}`, small);
    await other.waitForFunction(() => window.lab.shown.bodies > 1);
    assert.equal((await shown(other)).frames, 0, what);
    assert.equal(await other.textContent(".words h2"), "Select a body", what);
    elsewhere.push(other);
  }
  for (const one of [page, ...elsewhere]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: the address leaves out what it cannot hold, and says so", async () => {
  const page = await scene("heavy");
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  const copied = async () => {
    // The words of the last copy would be taken for those of this one.
    await page.evaluate(() => (document.querySelector(".counter[aria-live]").textContent = ""));
    await page.click("[data-permalink]");
    await page.waitForFunction(() => /Copied/.test(document.querySelector(".counter[aria-live]").textContent));
    return page.textContent(".counter[aria-live]");
  };
  await page.selectOption('[data-body="0"]', { label: "light" });
  await press(page, "[data-step]", 3);
  assert.equal(await copied(), "Copied.");
  assert.equal((await momentOf(page)).steps, 3);
  // Ten minutes and a step: nobody waits for it here.
  await page.evaluate(() => (window.lab.play.steps = 36001));
  assert.match(await copied(), /the run is too long/);
  assert.deepEqual([(await momentOf(page)).steps, (await momentOf(page)).selected], [0, [1]]);
  await page.evaluate(() => {
    window.lab.play.steps = 3;
    window.lab.play.inputs.list = Array.from({ length: 3000 }, (_, step) => ({ kind: "gravity", gravity: [0, 0, 0], step: step / 1000 }));
  });
  assert.match(await copied(), /the run is too long/);
  assert.deepEqual((await momentOf(page)).inputs, []);
  await page.evaluate(() => window.lab.opened({ name: "many", bodies: Array.from({ length: 60 }, (_, i) => (
    { name: `ball ${i}`, shape: { type: "sphere", sphere: { radius: 0.5 } }, translation: [2 * i, 0, 0], rotation: [0, 0, 0, 1], moves: true })) }));
  assert.match(await copied(), /the scene is too long/);
  assert.equal(await address(page), "#/scene");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: the address says whether somebody aimed or selected last", async () => {
  const page = await scene("heavy");
  await page.click('button:text-is("Shoot a ray")');
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.mouse.click(picture.x + picture.width * 0.57, picture.y + picture.height / 2);
  const ray = await page.textContent(".words h2");
  assert.match(ray, /^The ray hits/);
  await page.selectOption('[data-body="0"]', { label: "light" });
  assert.equal(await page.textContent(".words h2"), "light");
  const other = await visit(await address(page), small);
  assert.equal(await other.textContent(".words h2"), "light");
  await page.click("[data-undo]");
  assert.equal(await page.textContent(".words h2"), ray);
  await page.click("[data-redo]");
  assert.equal(await page.textContent(".words h2"), "light");
  for (const one of [page, other]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: the steps of a trace end with their room", async () => {
  const page = await at("heavy", { selected: [1, 2] });
  await page.click('.trace-steps [aria-label="Play"]');
  await page.evaluate(() => (location.hash = "#/"));
  await page.waitForSelector("article.home");
  await page.waitForTimeout(2000);
  assert.equal(await address(page), "#/");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: a scene without gravity of its own falls once gravity is switched on", async () => {
  const page = await scene("book"), along = '[aria-label^="Gravity along Y"]';
  for (const [on, y] of [[true, "-9.81"], [false, "0"]]) {
    await page.setChecked(".gravity input[type=checkbox]", on);
    assert.equal(await page.inputValue(along), y);
    assert.equal(await page.isChecked(".gravity input[type=checkbox]"), on);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: undo and redo take back steps, materials, shots and measures, by buttons too", async () => {
  const page = await scene("heavy"), states = [];
  const state = async () => [(await shown(page)).poses, (await shown(page)).frames, await page.textContent(".words h2"), await page.$$eval("[data-material] input", (list) => list.map((x) => x.value))];
  const note = async () => states.push(await state());
  assert.ok(await page.isDisabled("[data-undo]"));
  await note();
  await page.selectOption('[data-body="0"]', { label: "light" });
  await note();
  await set(page, restitution, 0.5);
  await note();
  await page.click("[data-step]");
  await note();
  await page.click('button:text-is("Shoot a ray")');
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.mouse.click(picture.x + picture.width * 0.57, picture.y + picture.height / 2);
  await note();
  assert.match(states.at(-1)[2], /^The ray hits/);
  const shot = await visit(await address(page), small);
  assert.equal(await shot.textContent(".words"), await page.textContent(".words"));
  for (let i = states.length - 2; i >= 0; i--) {
    await page.click("[data-undo]");
    assert.deepEqual(await state(), states[i], `undone to ${i}`);
  }
  for (let i = 1; i < states.length; i++) {
    await page.click("[data-redo]");
    assert.deepEqual(await state(), states[i], `redone to ${i}`);
  }
  assert.ok(await page.isDisabled("[data-redo]"));
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.click("[data-permalink]");
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await page.evaluate(() => location.href));
  for (const one of [page, shot]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("time: a run is gone through by a slider, back and forward to the same bits, and goes on from anywhere", async () => {
  const page = await scene("domino"), poses = [];
  for (let i = 0; i < 40; i++) {
    await press(page, "[data-step]", 1);
    if (i % 10 === 9) poses.push((await shown(page)).poses);
  }
  assert.equal(await page.textContent("[data-fold=time] .where"), "40 / 40");
  assert.equal(await page.$("[data-fold=time] output"), null, "a screen reader says every step of a run");
  for (const k of [0, 2, 1, 3, 0]) {
    await scrub(page, 10 * (k + 1));
    const now = await shown(page);
    assert.equal(now.frames, 10 * (k + 1));
    assert.deepEqual(now.poses, poses[k], `step ${now.frames}`);
  }
  assert.equal(await page.textContent("[data-fold=time] .where"), "10 / 40");
  await press(page, "[data-step]", 30);
  assert.deepEqual((await shown(page)).poses, poses[3]);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "time-slider.png"), fullPage: true });
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: a run is saved as a capture, which comes to the same bits", async () => {
  const page = await scene("heavy");
  await page.click("[data-save]");
  assert.match(await page.textContent(".counter[aria-live]"), /Nothing was played yet/);
  await press(page, "[data-step]", 10);
  await set(page, '[aria-label^="Gravity along X"]', 3);
  await press(page, "[data-step]", 10);
  const { poses } = await shown(page), [download] = await Promise.all([page.waitForEvent("download"), page.click("[data-save]")]);
  assert.equal(download.suggestedFilename(), "heavy.capture");
  const bytes = readFileSync(await download.path());
  let last = [], names = [];
  const report = graze.replay(bytes, (world) => {
    last = Array.from(world.poses());
    names = [0, 1, 2].map((i) => world.name(world.bodyAt(i)));
  });
  assert.deepEqual([report.difference, report.cut, report.simulation], [null, false, true]);
  assert.deepEqual(names, ["floor", "light", "heavy"]);
  assert.deepEqual(last, poses);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: events are listed by the names of their bodies, and sleeping bodies are seen", async () => {
  const page = await scene("bounce");
  const events = () => page.textContent(".events"), asleep = () => page.evaluate(() => [...window.lab.stage.crowd.special].filter(([, meaning]) => meaning === "asleep").map(([body]) => body));
  await press(page, "[data-step]", 60);
  await page.waitForFunction(() => /floor × e = 0: begins/.test(document.querySelector(".events").textContent));
  assert.match(await events(), /step 54: floor × e = 1: ends.*step 53: floor × e = 0: begins/s);
  const late = await events();
  await scrub(page, 10);
  assert.doesNotMatch(await events(), /begins/);
  await scrub(page, 60);
  assert.equal(await events(), late);
  assert.deepEqual(await asleep(), []);
  await press(page, "[data-step]", 90);
  assert.ok((await asleep()).includes(1), "the ball without restitution does not sleep");
  assert.ok((await page.$$eval(".labels span", (list) => list.map((x) => x.textContent))).includes("z"));
  await page.selectOption('[data-body="0"]', { label: "e = 0" });
  assert.match(await page.textContent(".side"), /sleeps\s*yes/);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "time-asleep.png"), fullPage: true });
  await page.click(".legend > summary");
  await page.uncheck("[data-layer=sleep]");
  assert.deepEqual(await asleep(), []);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: ten seconds of a large scene can be gone back", async () => {
  const page = await scene("thousand");
  const first = await page.evaluate(() => {
    const { play } = window.lab;
    for (let i = 0; i < 130; i++) play.forward(i < 129);
    return play.first;
  });
  assert.equal(first, 0);
  const near = (await shown(page)).poses;
  const kept = () => page.evaluate(() => [...window.lab.play.kept.states.keys()].sort((i, j) => i - j)), before = await kept();
  assert.equal(before.length, 8 + 60); // of each tenth up to 70, and of the last second
  await scrub(page, 35);
  assert.equal((await shown(page)).frames, 35);
  assert.deepEqual(await kept(), before);
  await scrub(page, 130);
  assert.deepEqual((await shown(page)).poses, near);
  await frame(page);
  // Balls that fall beside each other: eleven seconds of them are soon made.
  await page.evaluate(() => {
    const { play } = window.lab, ball = { type: "sphere", sphere: { radius: 0.1 } };
    window.lab.opened({ name: "balls", bodies: Array.from({ length: 301 }, (_, i) => ({ name: `ball ${i}`, shape: ball, translation: [i, 0, 0], rotation: [0, 0, 0, 1], moves: true })) });
    for (let i = 0; i < 655; i++) play.forward(i < 654);
  });
  assert.deepEqual(await page.evaluate(() => [window.lab.play.first, window.lab.play.last]), [60, 655]);
  const late = (await shown(page)).poses;
  await scrub(page, 60);
  assert.equal((await shown(page)).frames, 60);
  await scrub(page, 655);
  assert.deepEqual((await shown(page)).poses, late);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("time: filters, triggers and bodies that stand are named where bodies overlap and are no pair", async () => {
  const ball = { type: "sphere", sphere: { radius: 1 } }, turned = [0, 0, 0, 1];
  const of = (name, x, more) => ({ name, shape: ball, translation: [x, 0, 0], rotation: turned, moves: true, ...more });
  const bodies = [of("one", 0, { filter: { category: 1, mask: 2 } }), of("other", 0.5, { filter: { category: 4, mask: 1, group: 3 } }), of("free", 1),
    of("watch", 0.7, { trigger: true, moves: false }), of("wall", 0.2, { moves: false }), of("post", 0.1, { moves: false })];
  const told = async (a, b) => {
    const at = JSON.stringify({ selected: [a, b] }), page = await visit(`#/scene?s=${encodeURIComponent(JSON.stringify({ name: "filters", bodies }))}&at=${encodeURIComponent(at)}`, small);
    const said = await page.textContent(".words"), found = await page.evaluate(([i, j]) => window.lab.found.some((p) => [p.a, p.b].includes(i) && [p.a, p.b].includes(j)), [a, b]);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
    return [said, found];
  };
  for (const [a, b, words, pair] of [[0, 1, /They overlap.*filter excludes this pair.*category 0x1, mask 0x2; B has category 0x4, mask 0x1, group 3/, false],
    [1, 2, /They touch/, true], [2, 3, /They overlap.*watch is a trigger/, true], [4, 5, /They overlap.*Both stand/, false]]) {
    const [said, found] = await told(a, b);
    assert.match(said, words);
    assert.equal(found, pair, said);
  }
});
