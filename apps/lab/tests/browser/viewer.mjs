// The viewer: what is selected, dragged and shot, and the address.

import assert from "node:assert/strict";
import { join } from "node:path";
import { beyond, drawn, files, lightsUp, press, scene, showsAxis, showsCut } from "./scene-page.mjs";
import { accessible, drag, frame, query, short, shown, small, test, visit } from "./harness.mjs";

test("viewer: contacts are live while a body is dragged, and the pair is explained", async () => {
  const page = await scene("heavy");
  await page.selectOption('[data-body="0"]', { label: "light" });
  assert.equal(await page.textContent(".words h2"), "light");
  const before = await shown(page);
  assert.ok(before.pairs >= 1);
  await page.selectOption('[data-body="1"]', { label: "heavy" });
  assert.match(await page.textContent(".numbers tbody th"), /(vertex|edge|face) .* of A × (vertex|edge|face) .* of B/);
  await lightsUp(page);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-features.png") });
  await page.selectOption('[data-body="1"]', "");
  await drag(page, "move", 200, 0);
  const after = await shown(page);
  assert.ok(after.poses[7] > before.poses[7] + 0.5, `${before.poses[7]} to ${after.poses[7]}`);
  await page.selectOption('[data-body="1"]', { label: "heavy" });
  assert.match(await page.textContent(".words h2"), /light and heavy/);
  const asked = await page.inputValue("textarea");
  const answer = JSON.parse(query(JSON.stringify({ ...JSON.parse(asked), query: "distance", margin: undefined })));
  const said = await page.textContent(".words");
  assert.ok(said.includes(String(Number(answer.distance.toPrecision(6))).replaceAll("-", "−")), said);
  await page.click('a:text-is("Step through its axes")');
  await page.waitForSelector("[data-next]");
  assert.equal(await page.textContent(".words h2"), "Fifteen candidates");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: a body is moved along one axis alone, by the mouse and by keys, and pulled along it while the scene is played", async () => {
  const page = await scene("heavy");
  await page.selectOption('[data-body="0"]', { label: "light" });
  const place = async () => (await shown(page)).poses.slice(7, 10);
  for (const [k, axis] of ["X", "Y", "Z"].entries()) {
    const from = await place();
    await drag(page, axis, 40, -50);
    await page.focus(`[data-handle="${axis}"]`);
    await page.keyboard.press(["ArrowRight", "ArrowUp", "PageDown"][k]);
    await frame(page);
    const to = await place();
    assert.ok(Math.abs(to[k] - from[k]) > 0.02, `${axis}: ${from} to ${to}`);
    assert.deepEqual(to.filter((_, i) => i !== k), from.filter((_, i) => i !== k), axis);
  }
  const pull = await page.evaluate(() => {
    const { play, stage } = window.lab, from = play.run.place(1).translation;
    play.toggle();
    window.lab.show();
    const { at } = stage.last.handles.find(({ id }) => id === "Y");
    window.lab.drag("Y", [at[0] + 3, at[1] + 1, at[2] - 2], false);
    const { to } = play.pull;
    play.stop();
    return to.map((x, i) => x - from[i]);
  });
  assert.ok(Math.abs(pull[0]) + Math.abs(pull[2]) < 1e-12 && Math.abs(pull[1] - 1) < 1e-12, String(pull));
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: its address holds bodies, selection and settings; undo and redo take them back and forth", async () => {
  const page = await scene("heavy");
  const start = await shown(page);
  await page.selectOption('[data-body="0"]', { label: "light" });
  await drag(page, "move", 150, -60);
  const moved = await shown(page);
  assert.notDeepEqual(moved.poses, start.poses);
  await page.selectOption('[data-body="1"]', { label: "heavy" });
  await page.selectOption('label:has-text("Sub-steps") select', "4");
  const other = await visit(await page.evaluate(() => location.hash));
  assert.deepEqual((await shown(other)).poses, moved.poses);
  assert.equal(await other.textContent(".words h2"), "light and heavy");
  assert.equal(await other.inputValue('label:has-text("Sub-steps") select'), "4");
  const { draws } = await shown(page);
  for (let i = 0; i < 4; i++) await page.keyboard.press("Control+z");
  assert.deepEqual((await shown(page)).poses, start.poses);
  assert.equal((await shown(page)).draws, draws + 4, "each is drawn once");
  assert.equal(await page.evaluate(() => location.hash), "#/scene?scene=heavy", "the address follows");
  for (let i = 0; i < 4; i++) await page.keyboard.press("Control+Shift+z");
  assert.deepEqual((await shown(page)).poses, moved.poses);
  // A file that is short enough is in the address as a whole.
  await page.setInputFiles("input[type=file]", { name: "two.json", mimeType: "text/plain",
    buffer: Buffer.from('{"dimension":2,"bodies":[{"shape":{"type":"plane"}},{"name":"disc","motion":"dynamic","translation":[0,3],"shape":{"type":"circle","circle":{"radius":1}}}]}') });
  await page.waitForTimeout(300);
  await page.selectOption('[data-body="0"]', { label: "disc" });
  assert.match(await page.textContent(".numbers"), /shape\s*circle.*kind\s*moves/s);
  const third = await visit(await page.evaluate(() => location.hash));
  assert.equal((await shown(third)).bodies, 2);
  assert.equal(await third.textContent(".words h2"), "disc");
  const broken = await visit('#/scene?scene=heavy&at={"places":{"1":3}}');
  assert.deepEqual((await shown(broken)).poses, start.poses);
  for (const one of [page, other, third, broken]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("viewer: what is said of a pair is in whole sentences", async () => {
  const page = await scene("shapes");
  await page.selectOption('[data-body="0"]', { label: "capsule" });
  for (const other of ["floor", "sphere", "convex"]) {
    await page.selectOption('[data-body="1"]', { label: other });
    const said = await page.textContent(".words p");
    assert.match(said, /\. [A-Z][^.]*\.$/, other);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: a pair is selected by its row and by its point, a body by the list of all", async () => {
  const page = await scene("heavy");
  await page.click('.numbers button.choose:text-is("light × heavy")');
  assert.equal(await page.textContent(".words h2"), "light and heavy");
  await page.click('[data-fold=bodies] button:text-is("light")');
  assert.equal(await page.textContent(".words h2"), "heavy");
  await page.click('[data-fold=bodies] button:text-is("heavy")');
  assert.equal(await page.textContent(".words h2"), "Select a body");
  // A corner of the light box on the floor: the point that is seen lowest.
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  const points = await page.evaluate(() => window.lab.stage.pointsSeen);
  const [x, y] = points.reduce((best, p) => (p[1] > best[1] ? p : best));
  await page.mouse.click(picture.x + x, picture.y + y);
  assert.equal(await page.textContent(".words h2"), "floor and light");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: what is shot can be asked again", async () => {
  const page = await scene("heavy");
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.click('button:text-is("Shoot a ray")');
  await page.mouse.click(picture.x + picture.width / 2, picture.y + picture.height / 2);
  const words = await page.textContent(".words"), asked = JSON.parse(await page.inputValue("textarea"));
  assert.equal(asked.query, "raycast");
  const { t } = JSON.parse(query(JSON.stringify(asked)));
  assert.ok(words.includes(`after ${String(Number(t.toPrecision(6)))}`), `${words}, not ${t}`);
  await page.context().close();
});

test("viewer: the trace of the selected pair is drawn step by step, forward and back", async () => {
  const page = await scene("heavy");
  await page.click('.numbers button.choose:text-is("light × heavy")');
  const labels = () => page.$$eval(".labels span", (list) => list.map((x) => x.textContent)), plain = await labels();
  const asked = JSON.parse(await page.inputValue("textarea"));
  const { trace } = JSON.parse(query(JSON.stringify({ ...asked, query: "distance", margin: undefined, explain: true })));
  const said = () => page.textContent(".trace-steps output");
  assert.equal(await said(), `${trace.axes.length} steps`);
  for (const [i, { name, overlap }] of trace.axes.entries()) {
    await page.click("[data-trace-next]");
    assert.equal(await said(), `${i + 1} / ${trace.axes.length}. Axis ${name}: ${overlap >= 0 ? "overlap" : "gap"} ${short(Math.abs(overlap), 5)}`);
    assert.deepEqual((await labels()).sort(), [...plain, name].sort());
  }
  assert.ok(await page.isDisabled("[data-trace-next]"), "there is a step after the last");
  for (let i = 0; i < trace.axes.length; i++) await page.click("[data-trace-back]");
  assert.ok(await page.isDisabled("[data-trace-back]"));
  assert.deepEqual(await labels(), plain);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: the question whose answer is explained is chosen, and the address holds it with its step", async () => {
  const page = await scene("heavy");
  await page.click('.numbers button.choose:text-is("light × heavy")');
  const asked = JSON.parse(await page.inputValue("textarea"));
  const listed = () => page.$$eval("[data-explained] option", (list) => list.map((x) => x.value));
  assert.deepEqual(await listed(), ["overlap", "distance", "contacts"]);
  assert.equal(await page.inputValue("[data-explained]"), "distance");
  const plain = await drawn(page);
  for (const name of ["overlap", "distance", "contacts"]) {
    await page.selectOption("[data-explained]", name);
    const margin = name === "contacts" ? asked.margin : undefined;
    const { trace } = JSON.parse(query(JSON.stringify({ ...asked, query: name, margin, explain: true })));
    const { axes, gjk, epa, cuts = [] } = trace, count = axes.length + gjk.length + epa.length + cuts.length;
    assert.equal(await page.textContent(".trace-steps output"), `${count} steps`, name);
    if (name === "contacts") assert.ok(cuts.length > 0, "no face is cut");
    await press(page, "[data-trace-next]", count);
    const last = cuts.length ? `Cut ${cuts.length} of the face: ${cuts.at(-1).left.length} corners are left` : `Axis ${axes.at(-1).name}: `;
    assert.ok((await page.textContent(".trace-steps output")).startsWith(`${count} / ${count}. ${last}`), await page.textContent(".trace-steps output"));
    assert.ok(await page.isDisabled("[data-trace-next]"));
    const added = beyond(await drawn(page), plain);
    if (cuts.length) showsCut(added, trace);
    else showsAxis(added.lines, axes.at(-1));
    await press(page, "[data-trace-back]", count - 1);
    showsAxis(beyond(await drawn(page), plain).lines, axes[0]);
    await press(page, "[data-trace-next]", count - 1);
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `viewer-explains-${name}.png`) });
  }
  const said = await page.textContent(".trace-steps output");
  const other = await visit(await page.evaluate(() => location.hash), small);
  assert.equal(await other.inputValue("[data-explained]"), "contacts");
  assert.equal(await other.textContent(".trace-steps output"), said);
  const [there, here] = [await drawn(other), await drawn(page)];
  for (const part of ["lines", "points"]) assert.deepEqual(there[part].map(String).sort(), here[part].map(String).sort(), "another picture");
  for (const one of [page, other]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("viewer: a pair leads to the lesson that goes through it, and to none that has nothing to show", async () => {
  const sphere = { type: "sphere", sphere: { radius: 1 } }, box = { type: "box", box: { size: [1, 1, 1] } };
  const capsule = { type: "capsule", capsule: { height: 1, radiusBottom: 0.5, radiusTop: 0.5 } };
  const pairs = [
    [sphere, sphere, ["its balls"]], [box, { type: "plane" }, ["its corners"]],
    [sphere, capsule, []], [box, { type: "ellipsoid", ellipsoid: { radii: [1, 0.5, 1] } }, ["GJK"]]];
  for (const [a, b, lessons] of pairs) {
    const q = { query: "distance", a: { shape: a, translation: [0, 3, 0] }, b: { shape: b, translation: [2.5, 0.2, 0.5] } };
    const page = await visit(`#/scene?q=${encodeURIComponent(JSON.stringify(q))}&at=${encodeURIComponent('{"selected":[0,1]}')}`, small);
    await page.waitForFunction(() => window.lab.shown.bodies === 2);
    const links = await page.$$eval(".words a", (list) => list.map((x) => x.textContent.replace("Step through ", "")));
    assert.deepEqual(links, lessons, `${a.type} and ${b.type}`);
    if (links.length) {
      await page.click(".words a");
      await page.waitForSelector("[data-next]");
      const { question } = await shown(page);
      assert.deepEqual([question.a.shape.type, question.b.shape.type].sort(), [a.type, b.type].sort());
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

test("viewer: what is shot is explained too", async () => {
  const page = await scene("heavy");
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  const aim = async (button) => {
    await page.click(`button:text-is("${button}")`);
    await page.mouse.click(picture.x + picture.width / 2, picture.y + picture.height / 2);
  };
  /** Goes through the steps of what was shot. */
  const walked = async () => {
    const { trace } = JSON.parse(query(JSON.stringify({ ...JSON.parse(await page.inputValue("textarea")), explain: true })));
    const count = (trace.spans ?? []).length + (trace.steps ?? []).length;
    assert.ok(count > 0, trace.method);
    assert.equal(await page.textContent(".trace-steps output"), `${count} steps`);
    for (let i = 0; i < count; i++) {
      await page.click("[data-trace-next]");
      assert.ok((await page.textContent(".trace-steps output")).startsWith(`${i + 1} / ${count}. `));
    }
    return page.textContent(".trace-steps output");
  };
  await aim("Shoot a ray");
  assert.equal(await page.inputValue("[data-explained]"), "raycast");
  assert.match(await walked(), /^3 \/ 3\. slab z: inside from /);
  await page.selectOption('[data-body="0"]', { label: "light" });
  await page.click('button:text-is("Cast the body")');
  await page.mouse.click(picture.x + picture.width / 2, picture.y + picture.height * 0.3);
  assert.equal(JSON.parse(await page.inputValue("textarea")).query, "cast");
  assert.match(await walked(), /Advancement \d+: at .* the distance is /);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-explains-cast.png") });
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: two places are measured, and asked again", async () => {
  const page = await scene("heavy");
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  const click = (x, y) => page.mouse.click(picture.x + x * picture.width, picture.y + y * picture.height);
  await page.click('button:text-is("Measure")');
  await click(0.05, 0.02);
  assert.equal(await page.textContent(".words p"), "There is nothing: click on a body.");
  await click(0.5, 0.5);
  await click(0.3, 0.9);
  const asked = JSON.parse(await page.inputValue("textarea")), { distance } = JSON.parse(query(JSON.stringify(asked)));
  assert.deepEqual([asked.query, asked.a.shape.type, asked.b.shape.type], ["distance", "sphere", "sphere"]);
  const [x, y, z] = asked.a.translation.map((from, i) => asked.b.translation[i] - from);
  assert.ok(Math.abs(distance - Math.hypot(x, y, z)) < 1e-12 && distance > 0.5, `${distance}`);
  assert.equal(await page.textContent(".words h2"), `${short(distance, 6)} apart`);
  await page.click('button:text-is("Start again")');
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: bodies to the left, properties to the right, time below; what is folded stays folded", async () => {
  const page = await visit("#/scene?scene=heavy", { viewport: { width: 1280, height: 900 } });
  const at = (selector) => page.$eval(selector, (x) => x.getBoundingClientRect().toJSON());
  const [bodies, stage, properties, time] = await Promise.all(["[data-fold=bodies]", ".stage3", "[data-fold=properties]", "[data-fold=time]"].map(at));
  assert.ok(bodies.right < stage.left && stage.right < properties.left && stage.bottom < time.top, "not beside the drawing");
  const open = () => page.$$eval("[data-fold]", (list) => list.filter((x) => x.open).map((x) => x.dataset.fold));
  assert.deepEqual(await open(), ["bodies", "time", "properties", "graphs", "pairs", "events"]);
  await page.click("[data-fold=pairs] > summary");
  await page.click("[data-fold=time] > summary");
  assert.equal(await page.isVisible("[data-play]"), false);
  await page.waitForFunction(() => localStorage.getItem("folded")?.includes("time"));
  await page.reload();
  await page.waitForSelector(".stage3");
  assert.deepEqual(await open(), ["bodies", "properties", "graphs", "events"]);
  await page.click("[data-fold=time] > summary");
  assert.ok(await page.isVisible("[data-play]"));
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer has no finding of axe, and fits a phone", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await visit("#/scene?scene=tower", { axe: true, colorScheme, viewport: { width: 390, height: 844 } });
    await page.click("[data-step]");
    await page.click("[data-step]");
    assert.equal(await page.isVisible("#drawer"), false, "the drawing is not alone on a phone");
    await page.click(".drawer-handle");
    assert.ok(await page.isVisible("#drawer") && (await page.getAttribute(".drawer-handle", "aria-expanded")) === "true");
    await accessible(page, colorScheme);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    await page.context().close();
  }
});

test("the list of lessons has no finding of axe", async () => {
  for (const colorScheme of ["light", "dark"]) {
    for (const viewport of [{ width: 1280, height: 900 }, { width: 390, height: 844 }]) {
      const page = await visit("", { axe: true, colorScheme, viewport });
      await accessible(page, colorScheme);
      assert.deepEqual(page.trouble, []);
      await page.context().close();
    }
  }
});

test("viewer: layers are switched off and on, the address holds them, the speed and the camera", async () => {
  const page = await scene("heavy");
  await page.click('.numbers button.choose:text-is("light × heavy")');
  const points = () => page.evaluate(() => window.lab.stage.pointsSeen.length);
  const picture = () => page.$(".stage3 canvas").then((canvas) => canvas.screenshot());
  /** The number of things that the scene is drawn with, and whether bodies are among them. */
  const drawn = () => page.evaluate(() => window.lab.stage.drawn.children.length + Number(window.lab.stage.crowd.group.visible));
  const some = await points(), plain = await picture();
  assert.ok(some > 0);
  await page.click(".legend > summary");
  for (const layer of ["contacts", "normals", "pair", "grid", "bodies"]) {
    const before = await drawn();
    await page.uncheck(`[data-layer=${layer}]`);
    assert.ok((await drawn()) < before, layer);
  }
  assert.equal(await points(), 0);
  for (const layer of ["contacts", "normals", "pair", "grid"]) await page.check(`[data-layer=${layer}]`);
  assert.equal(await points(), some);
  await page.selectOption(".speed", "0.25");
  await page.focus(".stage3 canvas");
  for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => location.hash.includes("view="));
  assert.notDeepEqual(await picture(), plain);
  const other = await visit(await page.evaluate(() => location.hash), small);
  assert.equal(await other.isChecked("[data-layer=bodies]"), false);
  assert.equal(await other.isChecked("[data-layer=contacts]"), true);
  assert.equal(await other.inputValue(".speed"), "0.25");
  const seen = (p) => p.evaluate(() => window.lab.stage.pointsSeen);
  for (const [i, [x, y]] of (await seen(other)).entries()) {
    const [px, py] = (await seen(page))[i];
    assert.ok(Math.hypot(px - x, py - y) < 1, `${[x, y]}, not ${[px, py]}: another camera`);
  }
  // A quarter as fast: at most one step for four pictures.
  const steps = await other.evaluate(() => new Promise((done) => {
    document.querySelector("[data-play]").click();
    let pictures = 0;
    const tick = () => (++pictures < 24 ? requestAnimationFrame(tick) : done([window.lab.shown.frames, pictures]));
    requestAnimationFrame(tick);
  }));
  assert.ok(steps[0] >= 4 && steps[0] <= 7, `${steps[0]} steps in ${steps[1]} pictures`);
  const lesson = await visit("#/lesson/gjk");
  await lesson.mouse.move(300, 500);
  const box = await (await lesson.$(".stage2 > svg")).boundingBox();
  await lesson.mouse.move(box.x + 20, box.y + 20);
  await lesson.mouse.down();
  await lesson.mouse.move(box.x + 90, box.y + 60, { steps: 4 });
  await lesson.mouse.up();
  await lesson.selectOption(".speed", "2");
  await lesson.waitForFunction(() => location.hash.includes("view="));
  const again = await visit(await lesson.evaluate(() => location.hash));
  const where = (p) => p.$eval(".stage2 .shape", (x) => [x.getBoundingClientRect().x, x.getBoundingClientRect().y].map(Math.round));
  assert.deepEqual(await where(again), await where(lesson));
  assert.equal(await again.inputValue(".speed"), "2");
  for (const one of [page, other, lesson, again]) {
    assert.deepEqual(one.trouble, []);
    await one.context().close();
  }
});

test("viewer: bodies have the colours of another theme at once", async () => {
  const page = await visit("#/scene?scene=heavy", { viewport: { width: 1000, height: 600 }, colorScheme: "light" });
  const picture = () => page.$(".stage3 canvas").then((canvas) => canvas.screenshot());
  await page.click("button.theme");
  await frame(page);
  const dark = await picture();
  await page.selectOption('[data-body="0"]', { label: "light" });
  await page.selectOption('[data-body="0"]', "");
  await frame(page);
  assert.deepEqual(await picture(), dark);
  await page.context().close();
});

test("viewer: what is wrong with a file is seen at once, and nothing is explained without a selection", async () => {
  for (const viewport of [{ width: 1280, height: 800 }, { width: 390, height: 844 }]) {
    const page = await visit("#/scene?scene=heavy", { viewport });
    if (viewport.width < 600) await page.click(".drawer-handle");
    assert.equal(await page.isVisible(".trace-steps"), false);
    assert.equal(await page.textContent(".trace-steps output"), "");
    await page.setInputFiles("input[type=file]", { name: "broken.gltf", mimeType: "model/gltf+json", buffer: Buffer.from("{") });
    await page.waitForSelector(".trouble:not([hidden])");
    const { top, bottom } = await page.$eval(".trouble", (x) => x.getBoundingClientRect().toJSON());
    assert.ok(top >= 0 && bottom <= viewport.height, `from ${top} to ${bottom} of ${viewport.height} pixels`);
    await page.context().close();
  }
});

test("viewer: a narrow picture shows the whole scene", async () => {
  const page = await visit("#/scene", { viewport: { width: 390, height: 844 } });
  await page.setInputFiles("input[type=file]", join(files, "demo.gltf"));
  await page.waitForFunction(() => window.lab.shown.bodies === 17);
  await frame(page);
  const outside = await page.evaluate(() => {
    const { stage, play: { run, scene } } = window.lab, { width, height } = document.querySelector(".stage3 canvas").getBoundingClientRect();
    if (width >= height) throw new Error("the picture is not narrow");
    const corners = ({ lower, upper }) => [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((i) => ((k >> i) & 1 ? upper[i] : lower[i])));
    const seen = ([x, y]) => x >= 0 && x <= width && y >= 0 && y <= height;
    return scene.bodies.filter((_, i) => !corners(run.bounds(i, true)).every((corner) => seen(stage.pixel(corner)))).map(({ name }) => name);
  });
  assert.deepEqual(outside, []);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
