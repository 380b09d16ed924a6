// Animations of glTF files in the viewer.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { files, scene } from "./scene-page.mjs";
import { accessible, frame, graze, small, test, visit } from "./harness.mjs";

const moving = readFileSync(join(files, "moving.gltf"));
const file = JSON.parse(moving), bytes = Buffer.from(file.buffers[0].uri.split(",")[1], "base64");
/** The numbers of an accessor of floats. */
function floats(number) {
  const { bufferView, byteOffset = 0, count, type } = file.accessors[number], view = file.bufferViews[bufferView];
  return Array.from({ length: count * { SCALAR: 1, VEC3: 3, VEC4: 4 }[type] }, (_, i) => bytes.readFloatLE((view.byteOffset ?? 0) + byteOffset + 4 * i));
}
const numbers = (animation, channel) => {
  const { input, output } = file.animations[animation].samplers[file.animations[animation].channels[channel].sampler];
  return [floats(input), floats(output)];
};
const near = (found, wanted, what) => wanted.forEach((x, i) => assert.ok(Math.abs(found[i] - x) < 1e-6 * Math.max(1, Math.abs(x)), `${what}: ${found}, expected ${wanted}`));
/** Puts the slider of the animation to a sixtieth of a second. */
const slide = async (page, step) => {
  await page.evaluate((value) => {
    const slider = document.querySelector('[aria-label="Which moment of the animation"]');
    slider.value = String(value);
    for (const kind of ["input", "change"]) slider.dispatchEvent(new Event(kind));
  }, step);
  await frame(page);
};
const bodies = (page) => page.evaluate(() => Object.fromEntries(window.lab.play.scene.bodies.map(({ name, translation, rotation, shape }) => [name, { translation, rotation, shape }])));
const opened = async (page) => {
  await page.setInputFiles("input[type=file]", { name: "moving.gltf", mimeType: "model/gltf+json", buffer: moving });
  await page.waitForSelector("[data-animate]:visible");
};

test("animations: bodies follow their nodes, as the file's keys say, and touch what they meet", async () => {
  const page = await scene("shapes");
  await opened(page);
  assert.deepEqual(await page.$$eval("[data-animation] option", (list) => list.map((one) => one.textContent)), ["swing and throw", "grow"]);
  // Between two keys of the spline, by Hermite's polynomials.
  const [times, values] = numbers(0, 1), t = 0.5 * (times[0] + times[1]), step = Math.round(60 * t), s = (step / 60 - times[0]) / (times[1] - times[0]);
  const key = (i) => values.slice(3 * i, 3 * i + 3), seconds = times[1] - times[0];
  const [from, away, towards, to] = [1, 2, 3, 4].map(key), wanted = from.map((x, k) =>
    x * (1 + 2 * s) * (1 - s) ** 2 + seconds * away[k] * s * (1 - s) ** 2 + to[k] * s * s * (3 - 2 * s) + seconds * towards[k] * s * s * (s - 1));
  await slide(page, step);
  near((await bodies(page))["thrown ball"].translation, wanted, "the thrown ball");
  // The pendulum turns about its node: its arm hangs a metre below, along the turned axis.
  const [turnTimes, turns] = numbers(0, 0), at = turnTimes[1], turn = turns.slice(4, 8);
  await slide(page, Math.round(60 * at));
  const { translation, rotation } = (await bodies(page)).pendulum, sine = 2 * turn[2] * turn[3], cosine = 1 - 2 * turn[2] ** 2;
  near(rotation, turn, "the pendulum's turn");
  near(translation, [3 + sine, 3 - cosine, 0], "the pendulum's place");
  // Contacts are those of the world with the bodies there.
  const met = new Set();
  for (let i = 0; i <= 240; i += 6) {
    await slide(page, i);
    for (const pair of await page.evaluate(() => window.lab.play.run.contacts().map(({ a, b }) => [a, b].map((k) => window.lab.play.scene.bodies[k].name).join(" × ")))) met.add(pair);
  }
  assert.ok(met.has("thrown ball × gate") && [...met].some((pair) => /pendulum/.test(pair)), [...met].join());
  // A scale makes the shape grow.
  await page.selectOption("[data-animation]", "1");
  const [growthTimes, scales] = numbers(1, 0), largest = Math.floor(scales.indexOf(Math.max(...scales)) / 3), rest = (await bodies(page)).crate.shape;
  await slide(page, Math.round(60 * growthTimes[largest]));
  near((await bodies(page)).crate.shape.box.size, rest.box.size.map((x, k) => x * scales[3 * largest + k]), "the crate");
  // The address, once it is written, leads back, undo to the moment before. What only the first animation moved is at
  // rest in the second.
  await page.waitForFunction((time) => {
    const { animated } = JSON.parse(new URLSearchParams(location.hash.split("?")[1]).get("at") ?? "{}");
    return animated?.number === 1 && Math.abs(animated.time - time) < 1e-9;
  }, Math.round(60 * growthTimes[largest]) / 60);
  near((await bodies(page)).pendulum.translation, [3, 2, 0], "the pendulum at rest");
  const there = await page.evaluate(() => window.lab.shown.poses), other = await visit(await page.evaluate(() => location.hash), small);
  await other.waitForFunction(() => window.lab.shown.bodies > 0);
  if (/[?&]s=/.test(other.url())) assert.deepEqual((await other.evaluate(() => window.lab.shown)).poses, there);
  await page.click("[data-undo]");
  assert.notDeepEqual((await bodies(page)).crate.shape, (await bodies(other)).crate?.shape ?? {});
  for (const one of [page, other]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("animations: kinematic bodies follow while the scene is played, and a capture has what they do", async () => {
  const page = await scene("shapes");
  await opened(page);
  const start = await bodies(page);
  await slide(page, 30);
  const at = (await bodies(page))["thrown ball"].translation;
  await slide(page, 0);
  near((await bodies(page))["thrown ball"].translation, start["thrown ball"].translation, "the ball at the beginning");
  for (let i = 0; i < 30; i++) await page.evaluate(() => window.lab.play.step());
  const place = await page.evaluate(() => window.lab.play.run.place(window.lab.play.scene.bodies.findIndex(({ name }) => name === "thrown ball")).translation);
  near(place, at, "the ball after half a second");
  const download = page.waitForEvent("download");
  await page.click("[data-save]");
  const bytes = readFileSync(await (await download).path());
  const said = await page.$$eval(".counter", (list) => list.map((one) => one.textContent)), size = `${(bytes.length / 1000).toPrecision(3)} kB`;
  assert.ok(said.includes(`scene.capture: 30 steps, 0.5 s, ${size}.`), `${said}, ${size}`);
  let last;
  assert.equal(graze.replay(bytes, (world) => (last = world.pose(world.bodyAt(2)).translation)).difference, null);
  near(last, at, "the ball in the capture");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("animations: the controls have no finding of axe, fit a phone, and a faulty file is named", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await visit("#/scene?scene=shapes", { axe: true, colorScheme, viewport: { width: 390, height: 844 } });
    await opened(page);
    await page.click("[data-animate]");
    await page.waitForFunction(() => window.lab.animated?.time > 0.1);
    await page.click("[data-animate]");
    await accessible(page, colorScheme);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `animation-phone-${colorScheme}.png`), fullPage: true });
    const broken = structuredClone(file);
    broken.animations[0].samplers[0].interpolation = "QUADRATIC";
    await page.setInputFiles("input[type=file]", { name: "broken.gltf", mimeType: "model/gltf+json", buffer: Buffer.from(JSON.stringify(broken)) });
    await page.waitForSelector(".trouble:not([hidden])");
    assert.match(await page.textContent(".trouble"), /broken.gltf: animations\[0\].channels\[0\]: expected one of STEP, LINEAR, CUBICSPLINE/);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("animations: an address with keys that cannot be sampled is no scene", async () => {
  const still = { name: "one", bodies: [{ name: "ball", shape: { type: "sphere", sphere: { radius: 1 } }, translation: [0, 0, 0], rotation: [0, 0, 0, 1], moves: true, dynamics: { kinematic: true } }] };
  const link = { translation: [0, 0, 0], rotation: [0, 0, 0, 1], scale: [1, 1, 1] }, keys = { interpolation: "LINEAR", times: [0, 1], values: [[0, 0, 0], [2, 0, 0]] };
  const one = (changed = {}, more = {}) => ({ ...still, animations: [{ name: "way", duration: 1, moves: [{ body: 0, chain: [{ ...link, channels: [{ property: "translation", keys: { ...keys, ...changed } }] }], ...more }] }] });
  const page = await scene("shapes");
  const open = async (of, at = {}) => {
    await page.evaluate((hash) => (location.hash = hash), `#/scene?${new URLSearchParams({ s: JSON.stringify(of), at: JSON.stringify(at) })}`);
    await page.waitForTimeout(100);
    await frame(page);
    return page.evaluate(() => window.lab.play.scene.name);
  };
  assert.equal(await open(one(), { animated: { number: 0, time: 0.25 } }), "one");
  near((await bodies(page)).ball.translation, [0.5, 0, 0], "the ball of the address");
  for (const hostile of [one({ times: [1, 0] }), one({ values: [[0, 0, 0]] }), one({ values: null }), one({}, { body: 7 }), one({}, { chain: 3 }), { ...still, animations: 5 }, { ...still, animations: [null] }])
    assert.notEqual(await open(hostile), "one", JSON.stringify(hostile.animations));
  assert.equal(await open(one(), { animated: { number: 9, time: 1e300 } }), "one");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
