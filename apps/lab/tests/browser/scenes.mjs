// The playground: scenes in time.

import assert from "node:assert/strict";
import { press, scene } from "./scene-page.mjs";
import { shown, small, test, visit } from "./harness.mjs";

for (const name of ["shapes", "pyramid", "heavy", "cradle", "bridge"])
  test(`scene ${name}: steps forward, back, and forward again`, async () => {
    const page = await scene(name);
    const before = await shown(page);
    await page.click("[data-step]");
    const first = await shown(page);
    for (let i = 0; i < 10; i++) await page.click("[data-step]");
    const after = await shown(page);
    assert.equal(after.frames, 11);
    assert.notDeepEqual(after.poses, before.poses);
    assert.ok(after.poses.every(Number.isFinite));
    assert.ok(after.deepest < 0.1, `${after.deepest} deep`);
    for (let i = 0; i < 10; i++) await page.click("[data-back]");
    assert.deepEqual((await shown(page)).poses, first.poses);
    for (let i = 0; i < 10; i++) await page.click("[data-step]");
    assert.deepEqual((await shown(page)).poses, after.poses);
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });

test("every other scene goes on from step to step", async () => {
  const page = await scene("shapes");
  for (const name of ["tower", "forty", "crooked", "ten", "thousandfold", "five", "domino", "slope", "cards", "arch", "bounce", "flat", "cylinders", "bowl", "book", "chain",
    "bullets", "rod", "moving", "sizes", "far", "hundred", "sixty", "struck", "incline", "stop", "fall", "post"]) {
    await page.selectOption('select[aria-label="Scene"]', name);
    const before = await shown(page);
    assert.equal(before.frames, 0, name);
    for (let i = 0; i < 3; i++) await page.click("[data-step]");
    const after = await shown(page);
    assert.equal(after.frames, 3, name);
    assert.notDeepEqual(after.poses, before.poses, name);
    assert.ok(after.poses.every(Number.isFinite) && after.deepest < 0.1, name);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("scenes: a flat fall comes back to its height, the bowl holds its balls, rod and bullets pass nothing", async () => {
  const page = await scene("shapes");
  const after = async (name, steps) => {
    await page.selectOption('select[aria-label="Scene"]', name);
    await press(page, "[data-step]", steps);
    const { poses } = await shown(page);
    return Object.fromEntries(await page.evaluate(() => window.lab.play.scene.bodies.map(({ name }, i) => [name, i])).then((list) => list.map(([body, i]) => [body, poses.slice(7 * i, 7 * i + 7)])));
  };
  const high = Math.max(...(await Promise.all([after("flat", 88)])).map(({ box }) => box[1])); // up again after twice the time to fall
  assert.ok(Math.abs(high - 3) < 0.05, `${high}`);
  const balls = Object.entries(await after("bowl", 120)).filter(([name]) => name.startsWith("ball"));
  for (const [name, [x, y, z]] of balls) assert.ok(Math.hypot(x, y - 3, z) < 3 && y > 0, `${name} at ${[x, y, z]}`);
  const { wall, ...bullets } = await after("moving", 10);
  for (const [name, [x]] of Object.entries(bullets)) assert.ok(x < wall[0], `${name} at ${x}, the wall at ${wall[0]}`);
  const pairs = await page.evaluate(() => {
    window.lab.catalogue.open("rod");
    let met = 0;
    for (let i = 0; i < 10; i++) (window.lab.play.forward(), (met += window.lab.play.run.contacts().length));
    return met;
  });
  assert.ok(pairs > 0, "the rod never met the post");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("scenes: what falls, slides and is struck comes where the formulas say", async () => {
  const page = await scene("shapes");
  const after = async (name, steps) => {
    await page.selectOption('select[aria-label="Scene"]', name);
    const before = (await shown(page)).poses;
    await press(page, "[data-step]", steps);
    const { poses } = await shown(page);
    return Object.fromEntries(await page.evaluate(() => window.lab.play.scene.bodies.map(({ name }, i) => [name, i]))
      .then((list) => list.map(([body, i]) => [body, [0, 1, 2].map((k) => poses[7 * i + k] - before[7 * i + k])])));
  };
  const near = (is, wanted, within, what) => assert.ok(Math.abs(is - wanted) <= within, `${what}: ${is}, not ${wanted}`);
  near((await after("fall", 60)).box[1], -5, 1e-9, "a second of free fall");
  near((await after("stop", 150)).plate[0], 10, 0.01, "v²/2μg");
  const slid = await after("incline", 120);
  for (const kind of ["cube", "plate"]) {
    near(slid[`${kind}, 1.02`][0], 0, 1e-3, `${kind} held`);
    near(slid[`${kind}, 0.5`][0], 5, 0.05, `${kind} slides`);
  }
  near(slid["plate, 0.98"][0], 0.2, 0.002, "a plate creeps");
  const struck = await after("struck", 60); // four of them never move, and the first gives all that it has
  for (const i of [2, 3, 4, 5]) near(struck[`ball ${i}`][0], 0, 0.01, `ball ${i}`);
  near(struck["ball 1"][0] + struck["ball 6"][0], 5, 0.05, "5 m/s is passed on");
  await page.selectOption('select[aria-label="Scene"]', "post");
  const met = await page.evaluate(() => {
    let pairs = 0;
    for (let i = 0; i < 5; i++) (window.lab.play.forward(), (pairs += window.lab.play.run.contacts().length));
    return pairs;
  });
  assert.ok(met > 0, "the rod never met the post");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("scenes: five thousand boxes fall into a bin as in the benchmark, and the walls are seen through", async () => {
  const page = await scene("bin");
  const { bodies, poses } = await shown(page);
  assert.equal(bodies, 5005);
  // The first box and the last, as bench/resolution_pile.cpp puts and turns them.
  for (const [box, wanted] of [[0, [-9.2636549657942844, 1.0200293513592902, -9.2137025317453372, 0.075217906021405698, -0.036134592814932677, 0.096781909532141247, 0.99180130056537352]],
    [4999, [-0.61262636873006282, 25.671852960862374, 0.65149203120267596, 0.012854200517010701, 0.019850227573064844, 0.088155039159395862, 0.9958260024046226]]])
    poses.slice(7 * (5 + box), 7 * (6 + box)).forEach((x, k) => assert.ok(Math.abs(x - wanted[k]) < 1e-12, `box ${box}: ${x}, not ${wanted[k]}`));
  const clear = await page.evaluate(() => window.lab.stage.crowd.batches.filter(({ mesh }) => mesh.material.transparent).flatMap(({ bodies }) => bodies).sort((i, j) => i - j));
  assert.deepEqual(clear, [0, 1, 2, 3, 4]);
  await press(page, "[data-step]", 2);
  const after = await shown(page);
  assert.ok(after.frames === 2 && after.poses.every(Number.isFinite) && after.deepest < 0.1);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("conformance scenes: each kind is chosen from the list and plays, and what is to be seen is seen", async () => {
  const page = await scene("shapes");
  await page.waitForSelector("optgroup option", { state: "attached" });
  const keys = await page.$$eval("optgroup option", (list) => list.map((o) => o.value));
  assert.ok(keys.length >= 56, `${keys.length} scenes`);
  // One of the matrix, filters of compounds, a material, a motion, and the joints that need most of the file's words.
  const some = ["collider-type-matrix-35", "collision-filter-02", "materials-02", "motion-properties-07", "joint-07-distance", "joint-10-linear-drive"];
  assert.deepEqual(some.filter((key) => !keys.includes(key)), []);
  for (const key of some) {
    await page.selectOption('select[aria-label="Scene"]', key);
    await page.waitForFunction((wanted) => location.hash.includes(`scene=${wanted}`), key);
    for (let i = 0; i < 2; i++) await page.click("[data-step]");
    const { frames, poses } = await shown(page);
    assert.ok(frames === 2 && poses.every(Number.isFinite), key);
    assert.ok(!(await page.isVisible(".trouble")), `${key}: ${await page.textContent(".trouble")}`);
  }
  // An address leads to a slider that goes to its stop two metres down, in four seconds.
  const slider = await visit("#/scene?scene=joint-05-slider", small);
  await slider.waitForFunction(() => /Joint 05 slider/.test(document.querySelector(".intro").textContent));
  await press(slider, "[data-step]", 240);
  const [x, y] = (await shown(slider)).poses.slice(7, 14);
  assert.ok(Math.abs(Math.hypot(x, y) - 2) < 1e-3 && x < 0 && y < 0, `${[x, y]}`);
  for (const one of [page, slider]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("viewer: a body's material counts from the next step on", async () => {
  const slid = async (friction) => {
    const page = await scene("slope");
    await page.selectOption('[data-body="0"]', { label: "μ = 0.2" });
    if (friction !== undefined) {
      await page.fill('[data-material] label:has-text("Friction") input', String(friction));
      await page.dispatchEvent('[data-material] label:has-text("Friction") input', "change");
    }
    const before = (await shown(page)).poses.slice(-7);
    await press(page, "[data-step]", 15);
    const after = (await shown(page)).poses.slice(-7);
    assert.deepEqual(page.trouble, []);
    if (friction === undefined) {
      await page.fill('[data-material] label:has-text("Restitution") input', "2");
      await page.dispatchEvent('[data-material] label:has-text("Restitution") input', "change");
      assert.match(await page.textContent(".trouble:not([hidden])"), /restitution: expected a number from 0 to 1, got 2/);
    }
    await page.context().close();
    return Math.hypot(...[0, 1, 2].map((k) => after[k] - before[k]));
  };
  const smooth = await slid(undefined), rough = await slid(1);
  assert.ok(smooth > rough + 0.03, `${smooth} m, and ${rough} m where it is rough`); // both fall a little at first
});

test("a still page draws nothing, and uses no other address", async () => {
  const page = await scene("tower");
  await page.waitForTimeout(500);
  const frames = await page.evaluate(() => new Promise((done) => {
    let asked = 0;
    const real = window.requestAnimationFrame;
    window.requestAnimationFrame = (f) => (asked++, real(f));
    setTimeout(() => done(asked), 500);
  }));
  assert.equal(frames, 0);
  await page.context().close();
});
