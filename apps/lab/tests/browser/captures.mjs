// The viewer opens captures.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { beyond, drawn, files, looks, press, scene, showsAxis } from "./scene-page.mjs";
import { accessible, graze, here, query, short, shown, small, test, visit } from "./harness.mjs";

/** Fifteen boxes that fall into a heap: two seconds, as a program captures them, which names the floor; and how many
 *  pairs overlap then. */
function capturedHeap(steps = 120) {
  const frames = [];
  const simulation = new graze.Simulation({ capture: (bytes) => frames.push(bytes) });
  const box = new graze.Box([1, 1, 1]);
  const floor = new graze.HalfSpace();
  const bodies = [[floor, simulation.add({ shape: floor, fixed: true })]];
  simulation.setName(bodies[0][1], "the floor");
  for (let i = 0; i < 15; i++) {
    const translation = [(i % 3) * 0.9 - 0.9, 1 + Math.floor(i / 3) * 1.2, (i % 2) * 0.3];
    bodies.push([box, simulation.add({ shape: box, translation }, { density: 1 })]);
  }
  for (let i = 0; i < steps; i++) simulation.step(1 / 60);
  const placed = bodies.map(([shape, id]) => [shape, simulation.pose(id)]);
  const overlapping = placed.flatMap((a, i) => placed.slice(i + 1).filter((b) => graze.overlap(...a, ...b))).length;
  for (const made of [simulation, box, floor]) made.dispose();
  return { bytes: Buffer.concat(frames), overlapping };
}

test("viewer: opens a capture, and scrubs through it", async () => {
  const page = await scene("shapes");
  const { bytes } = capturedHeap();
  await page.setInputFiles("input[type=file]", { name: "heap.capture", mimeType: "application/octet-stream", buffer: bytes });
  await page.waitForSelector("[data-next]");
  assert.ok((await page.textContent(".intro")).includes("A simulation in double: 120 frames, played again. It comes to the same bits."));
  const first = await shown(page);
  assert.deepEqual([first.frame, first.frames, first.bodies], [0, 120, 16]);
  await page.click("[data-next]");
  assert.equal((await shown(page)).frame, 1);
  await page.evaluate(() => {
    const scrub = document.querySelector("input[type=range]");
    scrub.value = "90";
    scrub.dispatchEvent(new Event("input"));
  });
  const later = await shown(page);
  assert.equal(later.frame, 90);
  assert.ok(later.pairs > 10, `${later.pairs} pairs`);
  assert.ok((await page.textContent(".counter")).startsWith(`16 bodies · ${later.pairs} pairs`));
  // Where boxes fall into each other they have outlines, and all keep their colours.
  const deep = await page.evaluate(() => {
    const { captured, stage } = window.lab, depths = captured.frames.map((frame) => frame.deepest);
    window.lab.go(depths.indexOf(Math.max(...depths)));
    const reach = (pair) => pair.manifolds.some((m) => m.points.some((p) => p.distance < -stage.seen / 4000));
    return [...new Set(window.lab.now.pairs.filter(reach).flatMap(({ a, b }) => [a, b]))].filter((i) => captured.bodies[i].moves).sort((i, j) => i - j);
  });
  assert.ok(deep.length > 0, "no box is seen to reach into another");
  assert.deepEqual(await looks(page), { colors: ["out", ...Array(15).fill("a")], outlined: deep });
  await page.click('[aria-label="Last frame"]');
  assert.ok(await page.isDisabled("[data-next]"), "there is a frame after the last");
  await page.click('nav a:text-is("Lessons")');
  await page.click('nav a:text-is("Viewer")');
  await page.waitForSelector("input[type=file]", { state: "attached" });
  bytes[5000] ^= 1;
  await page.setInputFiles("input[type=file]", { name: "damaged.capture", mimeType: "application/octet-stream", buffer: bytes });
  await page.waitForSelector(".trouble:not([hidden])");
  assert.match(await page.textContent(".trouble"), /frame \d+, from byte \d+: expected a frame as it was written, got other bytes/);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: opens captures of the plane, and in float", async () => {
  const page = await scene("shapes");
  // These are captures of worlds: a stored simulation has the bits of the solver that wrote it.
  const captures = [["whole-plane-world", "A world of the plane in double: 3 frames", 3], ["whole-file", "A world in float: ", 0]];
  for (const [name, words, bodies] of captures) {
    await page.click('nav a:text-is("Lessons")');
    await page.click('nav a:text-is("Viewer")');
    await page.waitForSelector("input[type=file]", { state: "attached" });
    const buffer = readFileSync(join(here, "../../fuzz/corpus/capture", name));
    await page.setInputFiles("input[type=file]", { name: `${name}.capture`, mimeType: "application/octet-stream", buffer });
    await page.waitForSelector("[data-next]");
    const said = await page.textContent(".intro");
    assert.ok(said.includes(words) && said.includes("It comes to the same bits."), said);
    await page.click('[aria-label="Last frame"]');
    const last = await shown(page);
    assert.equal(last.frame, last.frames - 1);
    if (bodies) assert.equal(last.bodies, bodies);
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name}.png`) });
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: opens a capture of a simulation of the plane, made by the program where it is built", async () => {
  const page = await scene("shapes"), { plane } = graze, frames = [];
  const simulation = new plane.Simulation({ capture: (bytes) => frames.push(bytes) });
  simulation.add({ shape: new plane.HalfPlane(), fixed: true });
  for (let i = 0; i < 4; i++) simulation.add({ shape: new plane.Box([1, 1]), translation: [0.1 * i, 0.6 + 1.2 * i] }, { density: 1 });
  for (let i = 0; i < 60; i++) simulation.step(1 / 60);
  simulation.dispose();
  const captures = [Buffer.concat(frames)], program = process.env.GRAZE ?? join(here, "../../build/release/bin/graze");
  if (existsSync(program)) {
    const folder = mkdtempSync(join(tmpdir(), "capture-")), file = join(folder, "plane.capture");
    const { status, stderr } = spawnSync(program, ["capture", join(files, "plane.svg"), "--seconds", "1", "--out", file, "--quiet"], { encoding: "utf8" });
    assert.equal(status, 0, stderr);
    captures.push(readFileSync(file));
    rmSync(folder, { recursive: true });
  }
  for (const buffer of captures) {
    await page.click('nav a:text-is("Lessons")');
    await page.click('nav a:text-is("Viewer")');
    await page.waitForSelector("input[type=file]", { state: "attached" });
    await page.setInputFiles("input[type=file]", { name: "plane.capture", mimeType: "application/octet-stream", buffer });
    await page.waitForSelector("[data-next]");
    assert.match(await page.textContent(".intro"), /A simulation of the plane in double: \d+ frames, played again. It comes to the same bits./);
    await page.click('[aria-label="Last frame"]');
    const last = await shown(page);
    assert.ok(last.frame === last.frames - 1 && last.pairs > 0, JSON.stringify(last));
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: events are listed by names, and the page has no finding of axe and fits a phone", async () => {
  const { bytes } = capturedHeap(), begun = [];
  graze.replay(bytes, (world, number) => {
    for (const { kind, a, b } of world.events()) if (kind === "begin") begun.push([number, a.index, b.index]);
  });
  for (const colorScheme of ["light", "dark"]) {
    const page = await visit("#/scene", { axe: true, colorScheme, viewport: { width: 390, height: 844 } });
    await page.setInputFiles("input[type=file]", { name: "heap.capture", mimeType: "application/octet-stream", buffer: bytes });
    await page.waitForSelector("[data-next]");
    await page.click('[aria-label="Last frame"]');
    await page.click(".drawer-handle");
    const [last] = begun.slice(-1), listed = await page.$$eval(".events li", (list) => list.map((x) => x.textContent));
    assert.ok(listed.some((line) => line.startsWith(`frame ${last[0]}: `) && line.includes(`box ${last[2]}: begins`)), `${last}: ${listed}`);
    await accessible(page, colorScheme);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `capture-phone-${colorScheme}.png`), fullPage: true });
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("captures: a frame is asked as a scene is", async () => {
  const page = await scene("shapes"), { bytes, overlapping } = capturedHeap();
  await page.setInputFiles("input[type=file]", { name: "heap.capture", mimeType: "application/octet-stream", buffer: bytes });
  await page.waitForSelector("[data-next]");
  await page.click('[aria-label="Last frame"]');
  // A pair, by its row.
  const row = page.locator(".numbers button.choose", { hasText: /box \d+ × box/ }).first();
  const pair = (await row.textContent()).split(" × ");
  await row.click();
  assert.equal(await page.textContent(".words h2"), pair.join(" and "));
  const said = await page.textContent(".words"), asked = JSON.parse(await page.inputValue("textarea"));
  const { distance } = JSON.parse(query(JSON.stringify({ ...asked, query: "distance", margin: undefined })));
  assert.ok(said.includes(`signed distance ${short(distance, 6)}`), said);
  const captions = await page.$$eval(".numbers caption", (list) => list.map((c) => c.textContent));
  assert.ok(captions.includes(`Found by the run, A is ${pair[0]}`), `${captions}`);
  const found = await page.$$eval(".numbers table", (list) => [...list[0].tBodies[0].rows].map((r) => r.textContent));
  for (const line of found) assert.match(line, /(vertex|edge|face) .* of A × (vertex|edge|face) .* of B.*\(/);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "capture-pair.png"), fullPage: true });
  // A body, by its name in the list of all.
  await page.click('[data-fold=bodies] button:text-is("the floor")');
  assert.deepEqual((await shown(page)).selected.at(-1), 0);
  await page.selectOption('[data-body="1"]', "");
  await page.click('[data-fold=bodies] button[aria-pressed="true"]');
  await page.click('[data-fold=bodies] button:text-is("box 3")');
  assert.equal(await page.textContent(".words h2"), "box 3");
  assert.match(await page.textContent(".side"), /shape\s*box.*kind\s*moves/s);
  assert.match(await page.textContent(".side"), /category\s*0x1\s*mask\s*all\s*group\s*none/);
  // A click in the drawing selects the body in its middle, and nothing at its edge.
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.mouse.click(picture.x + 3, picture.y + 3);
  assert.deepEqual((await shown(page)).selected, []);
  await page.mouse.click(picture.x + picture.width / 2, picture.y + picture.height / 2);
  assert.ok((await shown(page)).selected.length > 0);
  await page.click('button:text-is("Open this frame as a scene")');
  await page.waitForSelector("[data-play]");
  const opened = await shown(page);
  assert.equal(opened.bodies, 16);
  // Fewer than the frame has, which holds those within the margin too, from before the bodies were moved.
  assert.equal(opened.pairs, overlapping);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: the trace of the selected pair is drawn step by step, and stays while frames are scrubbed", async () => {
  const page = await scene("shapes");
  await page.setInputFiles("input[type=file]", { name: "heap.capture", mimeType: "application/octet-stream", buffer: capturedHeap().bytes });
  await page.waitForSelector("[data-next]");
  await page.click('[aria-label="Last frame"]');
  await page.locator(".numbers button.choose", { hasText: /box \d+ × box/ }).first().click();
  const asked = JSON.parse(await page.inputValue("textarea")), said = () => page.textContent(".trace-steps output");
  const plain = await drawn(page);
  const { trace } = JSON.parse(query(JSON.stringify({ ...asked, explain: true })));
  await page.selectOption("[data-explained]", "contacts");
  const count = trace.axes.length + trace.gjk.length + trace.epa.length + (trace.cuts ?? []).length;
  assert.equal(await said(), `${count} steps`);
  await page.click("[data-trace-next]");
  assert.equal(await said(), `1 / ${count}. Axis ${trace.axes[0].name}: ${trace.axes[0].overlap >= 0 ? "overlap" : "gap"} ${short(Math.abs(trace.axes[0].overlap), 5)}`);
  showsAxis(beyond(await drawn(page), plain).lines, trace.axes[0]);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "capture-trace.png"), fullPage: true });
  await page.click('[aria-label="Previous frame"]');
  assert.match(await said(), /^1 \/ \d+\. Axis A0: /);
  // The picture of the same step is that of the pair where it stands in this frame.
  const earlier = JSON.parse(query(JSON.stringify({ ...JSON.parse(await page.inputValue("textarea")), explain: true }))).trace, stepped = await drawn(page);
  assert.notDeepEqual(earlier.axes[0], trace.axes[0]);
  await page.click("[data-trace-back]");
  showsAxis(beyond(stepped, await drawn(page)).lines, earlier.axes[0]);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: rays, casts and measures work in a frame, and end with it", async () => {
  const page = await scene("shapes");
  await page.setInputFiles("input[type=file]", { name: "heap.capture", mimeType: "application/octet-stream", buffer: capturedHeap().bytes });
  await page.waitForSelector("[data-next]");
  await page.click('[aria-label="Last frame"]');
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  const click = (x, y) => page.mouse.click(picture.x + x * picture.width, picture.y + y * picture.height);
  const answered = async () => {
    const asked = JSON.parse(await page.inputValue("textarea"));
    return [asked, JSON.parse(query(JSON.stringify(asked)))];
  };
  await page.click('button:text-is("Measure")');
  await click(0.5, 0.5);
  await click(0.45, 0.9);
  const [asked, { distance }] = await answered();
  assert.deepEqual([asked.query, asked.a.shape.type, asked.b.shape.type], ["distance", "sphere", "sphere"]);
  assert.ok(distance > 0.1, `${distance}`);
  assert.equal(await page.textContent(".words h2"), `${short(distance, 6)} apart`);
  assert.ok((await page.$$eval(".labels span", (list) => list.map((x) => x.textContent))).includes(short(distance, 5)), "not drawn");
  await page.click('button:text-is("Shoot a ray")');
  await click(0.5, 0.5);
  const [ray, { t }] = await answered();
  assert.equal(ray.query, "raycast");
  assert.ok((await page.textContent(".words")).includes(`after ${short(t, 6)}`));
  assert.equal(await page.inputValue("[data-explained]"), "raycast");
  await page.click('button:text-is("Cast the body")');
  assert.match(await page.textContent(".words"), /Select the body first/);
  await page.click('[data-fold=bodies] button:text-is("box 15")');
  await page.click('button:text-is("Cast the body")');
  await click(0.45, 0.9);
  const [cast, hit] = await answered();
  assert.equal(cast.query, "cast");
  assert.ok((await page.textContent(".words")).includes(`at ${short(hit.t, 6)}`));
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "capture-cast.png"), fullPage: true });
  await page.click('[aria-label="Previous frame"]');
  assert.equal(await page.textContent(".words h2"), "box 15", "the shot is of another frame");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: energy, joints, filters, triggers and sleep are those of the run", async () => {
  const frames = [], simulation = new graze.Simulation({ capture: (bytes) => frames.push(bytes) });
  const floor = new graze.HalfSpace(), box = new graze.Box([1, 1, 1]), ball = new graze.Sphere(0.3);
  simulation.add({ shape: floor, fixed: true });
  const resting = simulation.add({ shape: box, translation: [0, 0.5, 0] }, { density: 1 });
  const beam = simulation.add({ shape: box, translation: [4, 4, 0], fixed: true });
  const filter = { category: 2n ** 60n, mask: 2n, group: 0 };
  const hung = simulation.add({ shape: ball, translation: [6, 4, 0], filter }, { density: 1 });
  const ghost = simulation.add({ shape: box, translation: [-3, 1, 0], fixed: true, trigger: true });
  simulation.addJoint({ a: beam, b: hung, kind: "ball", frameB: { translation: [-2, 0, 0] } });
  for (const [id, name] of [[resting, "resting"], [beam, "beam"], [hung, "hung"], [ghost, "ghost"]]) simulation.setName(id, name);
  const energy = [], asleep = [];
  for (let i = 0; i < 120; i++) {
    simulation.step(1 / 60);
    const { kineticEnergy, potentialEnergy } = simulation.report();
    energy.push(kineticEnergy + potentialEnergy);
    asleep.push([resting, hung].filter((id) => simulation.asleep(id)).map(({ index }) => index));
  }
  const gaps = [];
  graze.draw.simulation(simulation, { layers: ["joints"], line: (...ends) => gaps.push(ends.slice(0, 2).map((end) => end.map(Math.fround))) });
  for (const made of [simulation, floor, box, ball]) made.dispose();
  assert.deepEqual(asleep.at(-1), [resting.index]);
  const page = await scene("shapes");
  await page.setInputFiles("input[type=file]", { name: "run.capture", mimeType: "application/octet-stream", buffer: Buffer.concat(frames) });
  await page.waitForSelector("[data-next]");
  const graph = () => page.$$eval(".plot svg", (list) => list.map((one) => one.getAttribute("aria-label")));
  assert.equal((await graph())[0], `energy: ${short(energy[0])} ${short(energy[0])}`);
  const signs = () => page.$$eval(".labels span", (list) => list.map((x) => x.textContent));
  assert.deepEqual((await signs()).filter((sign) => sign === "z"), []);
  await page.click('[aria-label="Last frame"]');
  assert.equal((await graph())[0], `energy: ${short(energy[119])} ${short(energy[119])}`);
  assert.deepEqual((await signs()).filter((sign) => sign === "z"), ["z"]);
  assert.deepEqual((await looks(page)).colors, ["out", "asleep", "out", "a", "trigger"]);
  const joints = (await drawn(page)).lines.map((line) => JSON.stringify(line));
  for (const line of gaps) assert.ok(joints.includes(JSON.stringify(line)), `${line} is not drawn`);
  await page.click('[data-fold=bodies] button:text-is("resting")');
  assert.match(await page.textContent(".side"), /sleeps\s*yes/);
  await page.click('[data-fold=bodies] button:text-is("hung")');
  assert.match(await page.textContent(".words"), /The filter excludes this pair.*B has category 0x1000000000000000, mask 0x2\./);
  await page.click('[data-fold=bodies] button:text-is("beam")'); // in place of the first one that was chosen
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "capture-motion.png"), fullPage: true });
  await page.click(".legend > summary");
  await page.uncheck("[data-layer=sleep]");
  await page.uncheck("[data-layer=joints]");
  assert.deepEqual((await signs()).filter((sign) => sign === "z"), []);
  const others = (await drawn(page)).lines.map((line) => JSON.stringify(line));
  for (const line of gaps) assert.ok(!others.includes(JSON.stringify(line)), `${line} is still drawn`);
  // A scene that is made of it keeps filters and triggers.
  await page.click('button:text-is("Open this frame as a scene")');
  await page.waitForSelector("[data-play]");
  const { bodies } = await page.evaluate(() => window.lab.play.scene);
  assert.deepEqual(bodies.map((one) => [one.filter ?? null, one.trigger ?? false]), [[null, false], [null, false], [null, false],
    [{ category: "0x1000000000000000", mask: 2 }, false], [null, true]]);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: more than 200 pairs, and runs of more than 200 bodies, show every point of contact", async () => {
  const frames = [], simulation = new graze.Simulation({ capture: (bytes) => frames.push(bytes) }), floor = new graze.HalfSpace(), box = new graze.Box([1, 1, 1]);
  simulation.add({ shape: floor, fixed: true });
  for (let i = 0; i < 225; i++) simulation.add({ shape: box, translation: [1.5 * (i % 15), 0.4999, 1.5 * Math.floor(i / 15)] }, { density: 1 });
  simulation.step(1 / 60);
  const places = [...simulation.world.points()].map(({ a, b, weight }) => a.map((x, k) => Math.fround(x + (b[k] - x) * weight)).join()).sort();
  for (const made of [simulation, floor, box]) made.dispose();
  assert.equal(places.length, 900);
  const page = await scene("shapes"), points = async () => (await drawn(page)).points.map(String).sort();
  await page.setInputFiles("input[type=file]", { name: "field.capture", mimeType: "application/octet-stream", buffer: Buffer.concat(frames) });
  await page.waitForFunction(() => window.lab.captured);
  assert.match(await page.textContent(".counter"), /^226 bodies · 225 pairs · 900 contacts/);
  assert.deepEqual(await points(), places);
  await page.click('button:text-is("Open this frame as a scene")');
  await page.waitForSelector("[data-play]");
  const found = await page.evaluate(() => window.lab.play.run.contacts().reduce((sum, pair) => sum + pair.manifolds.reduce((n, m) => n + m.points.length, 0), 0));
  assert.ok(found >= 900, `${found}`);
  assert.equal((await points()).length, found);
  await page.click(".legend > summary");
  await page.uncheck("[data-layer=contacts]");
  assert.equal((await points()).length, 0);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: an event of a body that is gone is not one of the body that has its number now", async () => {
  const frames = [], simulation = new graze.Simulation({ capture: (bytes) => frames.push(bytes) }), floor = new graze.HalfSpace(), ball = new graze.Sphere(0.5);
  simulation.add({ shape: floor, fixed: true });
  const first = simulation.add({ shape: ball, translation: [0, 0.5, 0] }, { density: 1 });
  simulation.setName(first, "first");
  for (let i = 0; i < 3; i++) simulation.step(1 / 60);
  simulation.remove(first);
  const second = simulation.add({ shape: ball, translation: [5, 9, 0] }, { density: 1 });
  simulation.setName(second, "second");
  assert.equal(second.index, first.index);
  for (let i = 0; i < 2; i++) simulation.step(1 / 60);
  for (const made of [simulation, floor, ball]) made.dispose();
  const page = await scene("shapes");
  await page.setInputFiles("input[type=file]", { name: "gone.capture", mimeType: "application/octet-stream", buffer: Buffer.concat(frames) });
  await page.waitForSelector("[data-next]");
  assert.match(await page.textContent(".events"), /× first: begins|first × .*: begins/);
  await press(page, "[data-next]", 4);
  assert.doesNotMatch(await page.textContent(".events"), /second/);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("captures: the address of one that is served holds frame, selection, layers and camera; of a scene what was done", async () => {
  // The file grows as a program writes it: two seconds once somebody has looked at the first one.
  let written = 60;
  const heap = (request) => {
    const etag = `"${written}"`;
    return request.headers()["if-none-match"] === etag ? { status: 304 } : { headers: { etag }, body: capturedHeap(written).bytes };
  };
  const served = { ...small, files: { "heap.capture": heap, "two.json": Buffer.from(JSON.stringify({ dimension: 2, bodies: [
    { shape: { type: "plane" } }, { name: "disc", motion: "dynamic", translation: [0, 3], shape: { type: "circle", circle: { radius: 1 } } }] })) } };
  const page = await visit("#/scene?file=heap.capture", served);
  await page.waitForSelector("[data-next]");
  await press(page, "[data-next]", 30);
  await page.click(".numbers button.choose");
  await page.click(".legend > summary");
  await page.uncheck("[data-layer=grid]");
  await page.selectOption(".speed", "0.5");
  await page.focus(".stage3 canvas");
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => /frame%22%3A30.*grid.*view=/.test(location.hash));
  const before = await shown(page);
  assert.equal(before.frames, 60);
  written = 120;
  await page.waitForFunction(() => window.lab.shown.frames === 120);
  assert.deepEqual(await shown(page), { ...before, frames: 120 });
  assert.match(await page.textContent(".intro"), /: 120 frames, played again/);
  const other = await visit(await page.evaluate(() => location.hash), served);
  await other.waitForSelector("[data-next]");
  assert.deepEqual(await shown(other), await shown(page));
  assert.equal((await shown(other)).selected.length, 2);
  assert.equal(await other.isChecked("[data-layer=grid]"), false);
  assert.equal(await other.inputValue(".speed"), "0.5");
  const file = await visit(`#/scene?file=two.json&at=${encodeURIComponent('{"selected":[1],"places":{"1":{"translation":[2,4,0],"rotation":[0,0,0,1]}}}')}`, served);
  await file.waitForFunction(() => window.lab.shown.bodies === 2);
  assert.equal(await file.textContent(".words h2"), "disc");
  assert.deepEqual((await shown(file)).poses.slice(7, 9), [2, 4]);
  for (const one of [page, other, file]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});
