// The viewer opens files of space and of the plane, and names the fault of broken ones.

import assert from "node:assert/strict";
import { join } from "node:path";
import { drawn, files, lightsUp, looks, press, scene } from "./scene-page.mjs";
import { drag, frame, graze, query, shown, test, visit } from "./harness.mjs";

test("viewer: meshes of files have the triangles that the library reads", async () => {
  const page = await scene("shapes");
  const corners = [[0, 0, 0], [2, 2, 0], [0, 0.5, 0], [-2, 2, 0], [0, 1, 1]];
  const head = (kind) => `ply\nformat ${kind} 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n`;
  // A notched quadrilateral and a triangle, as text and as bytes; three triangles in all.
  const text = Buffer.from(`${head("ascii")}${corners.map((p) => p.join(" ")).join("\n")}\n4 1 2 3 0\n3 0 1 4\n`);
  const bytes = Buffer.alloc(5 * 24 + 17 + 13);
  corners.flat().forEach((x, i) => bytes.writeDoubleLE(x, 8 * i));
  let at = 5 * 24;
  for (const face of [[1, 2, 3, 0], [0, 1, 4]]) {
    at = bytes.writeUInt8(face.length, at);
    for (const i of face) at = bytes.writeInt32LE(i, at);
  }
  const stl = Buffer.alloc(84 + 50);
  stl.writeUInt32LE(1, 80);
  [0.1, 0, 0, 1, 0, 0, 0, 1, 0].forEach((x, i) => stl.writeFloatLE(x, 84 + 12 + 4 * i));
  for (const [name, buffer] of [["text.ply", text], ["bytes.ply", Buffer.concat([Buffer.from(head("binary_little_endian")), bytes])], ["one.stl", stl],
    ["two.obj", Buffer.from("o one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no two\nv 0 0 0.1\nf 1 2 4\n")]]) {
    await page.setInputFiles("input[type=file]", { name, mimeType: "application/octet-stream", buffer });
    await page.waitForFunction((title) => window.lab.play.scene.name === title, name);
    const mesh = graze.meshOfFile(buffer, name.slice(-3)), { shape } = await page.evaluate(() => window.lab.play.scene.bodies[0]);
    assert.deepEqual(shape, graze.protocolShape(mesh), name);
    mesh.dispose();
  }
  for (const [name, buffer, fault] of [["cut.ply", text.subarray(0, -4), /cut.ply: /], ["word.obj", Buffer.from("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3x\n"), /word.obj: line 4/]]) {
    await page.setInputFiles("input[type=file]", { name, mimeType: "application/octet-stream", buffer });
    await page.waitForFunction((title) => document.querySelector(".trouble:not([hidden])")?.textContent.includes(title), name);
    assert.match(await page.textContent(".trouble"), fault);
  }
  await page.context().close();
});

test("viewer: opens the project's scenes, and says what is wrong with a broken file", async () => {
  const page = await scene("shapes");
  const open = async (file) => {
    await page.setInputFiles("input[type=file]", file);
    await page.waitForTimeout(300);
  };
  await open(join(files, "demo.gltf"));
  assert.ok((await shown(page)).bodies > 10, `${(await shown(page)).bodies} bodies`);
  assert.ok(!(await page.isVisible(".trouble")));
  const text = (name, content) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content) });
  await open(text("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
  assert.equal((await shown(page)).bodies, 1);
  await open(text("q.jsonl", '{"query":"overlap","a":{"shape":{"type":"sphere"}},"b":{"shape":{"type":"box"},"translation":[0.7,0,0]}}\n'));
  assert.equal((await shown(page)).bodies, 2);
  assert.equal((await shown(page)).pairs, 1);
  // A triangle whose numbers lie in a file of their own.
  const split = { asset: { version: "2.0" }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: "VEC3" }], bufferViews: [{ buffer: 0, byteLength: 36 }], buffers: [{ byteLength: 36, uri: "parts/a%20b.bin" }] };
  const numbersBeside = { name: "a b.bin", mimeType: "application/octet-stream", buffer: Buffer.from(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer) };
  await open([numbersBeside, text("split.gltf", JSON.stringify(split))]);
  assert.equal((await shown(page)).bodies, 1);
  await open(text("split.gltf", JSON.stringify(split)));
  assert.match(await page.textContent(".trouble:not([hidden])"), /buffers\[0\]: lies in a b.bin: open it together/);
  for (const [name, content] of [["cut.gltf", "{"], ["empty.gltf", "{}"], ["bad.glb", "glTF"], ["nothing.obj", "# nothing"], ["x.stl", "solid"], ["picture.png", "x"],
    ["deep.gltf", '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]}'],
    ["far.gltf", '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":99,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":4}],"buffers":[{"byteLength":3,"uri":"data:;base64,AAAA"}]}'],
    ["nan.jsonl", '{"query":"overlap","a":{"shape":{"type":"sphere","sphere":{"radius":-1}}},"b":{"shape":{"type":"box"}}}']]) {
    await open(text(name, content));
    assert.ok((await page.textContent(".trouble:not([hidden])")).includes(name.replace("nan.jsonl", "question")), name);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("files are dropped on any page, or chosen: on a lesson, which the way back leads to, on a capture, and on a scene", async () => {
  const page = await visit("#/lesson/gjk");
  /** Drops a file on the head of the page, as a browser does that would open it otherwise. */
  const drop = (name, bytes) => page.evaluate(([name, bytes]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([Uint8Array.from(bytes)], name));
    const event = new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true });
    document.querySelector("header.top").dispatchEvent(event);
    return event.defaultPrevented;
  }, [name, [...bytes]]);
  const triangle = Buffer.from("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  assert.ok(await drop("one.obj", triangle));
  await page.waitForFunction(() => window.lab.shown?.bodies === 1);
  assert.equal(await page.textContent("[aria-current]:not(.brand)"), "Viewer");
  await page.goBack();
  await page.waitForFunction(() => window.lab.lesson?.id === "gjk");
  const frames = [], world = new graze.World({ capture: (part) => frames.push(part) });
  const shape = new graze.Sphere(1);
  world.add({ shape });
  world.update();
  world.dispose();
  shape.dispose();
  assert.ok(await drop("one.capture", Buffer.concat(frames)));
  await page.waitForFunction(() => window.lab.shown?.frames === 1);
  await page.setInputFiles("[aria-label='Open another file'][type=file]", { name: "one.obj", mimeType: "", buffer: triangle });
  await page.waitForFunction(() => window.lab.shown?.bodies === 1 && window.lab.play);
  assert.ok(await drop("bad.obj", Buffer.from("v x\n")));
  await page.waitForSelector(".trouble:not([hidden])");
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: what touches keeps its colour and has an outline, points and normals; the selected pair alone is painted", async () => {
  const page = await scene("shapes");
  for (const [file, moving] of [["demo.gltf", 14], ["plane.svg", 9]]) {
    await page.setInputFiles("input[type=file]", join(files, file));
    await page.waitForFunction((name) => document.querySelector("[data-file]")?.textContent === name, file);
    await frame(page);
    const { colors, outlined } = await looks(page);
    assert.equal(colors.filter((color) => color === "a").length, moving, file);
    assert.ok(!colors.includes("touch") && !colors.includes("made") && !colors.includes("b"), `${file}: ${colors}`);
    const { deep, manifolds, points } = await page.evaluate(() => {
      const { found, play, stage } = window.lab, deep = new Set(), all = found.flatMap((pair) => pair.manifolds);
      for (const { a, b, manifolds } of found)
        if (manifolds.some((m) => m.points.some((p) => p.distance < -stage.seen / 4000))) for (const i of [a, b]) if (play.scene.bodies[i].moves) deep.add(i);
      return { deep: [...deep].sort((i, j) => i - j), manifolds: all.length, points: all.flatMap((m) => m.points).length };
    });
    assert.ok(deep.length > 3);
    assert.deepEqual(outlined, deep, file);
    const picture = await drawn(page);
    assert.deepEqual([picture.points.length, picture.lines.length], [points, manifolds], file);
    const [a, b] = deep;
    await page.evaluate((pair) => window.lab.select(pair), [a, b]);
    const now = await looks(page);
    assert.deepEqual(now.colors, colors.map((color, i) => (i === a ? "made" : i === b ? "b" : color)), file);
    assert.deepEqual(now.outlined, deep, file);
    const contacts = (on) => page.evaluate(() => (document.querySelector(".legend").open = true)).then(() => page.setChecked('[data-layer="contacts"]', on));
    await contacts(false);
    assert.deepEqual((await looks(page)).outlined, [], "outlines without contacts");
    await contacts(true);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: a drawing of the plane is opened, dragged, shot at, and played", async () => {
  const page = await scene("shapes");
  const open = async (file) => {
    await page.setInputFiles("input[type=file]", file);
    await page.waitForTimeout(300);
  };
  await open(join(files, "plane.svg"));
  assert.ok(!(await page.isVisible(".trouble")), await page.textContent(".trouble"));
  const first = await shown(page);
  assert.equal(first.bodies, 12); // the hammer's two shapes are one
  assert.ok(first.pairs > 3, `${first.pairs} pairs`);
  await page.selectOption('[data-body="0"]', { label: "ball" });
  await page.selectOption('[data-body="1"]', { label: "wedge" });
  const asked = JSON.parse(await page.inputValue("textarea"));
  assert.equal(asked.dimension, 2);
  const answer = JSON.parse(query(JSON.stringify({ ...asked, query: "distance", margin: undefined })));
  assert.ok((await page.textContent(".words")).includes(String(Number(answer.distance.toPrecision(6))).replaceAll("-", "−")));
  const before = await shown(page);
  await drag(page, "move", 60, -40);
  const after = await shown(page), moved = after.poses.findIndex((x, i) => x !== before.poses[i]);
  assert.ok(after.poses[moved] > before.poses[moved] && after.poses[moved + 1] > before.poses[moved + 1], "right and up");
  assert.ok(after.poses.every((x, i) => ![2, 3, 4].includes(i % 7) || x === 0), "a body left the plane");
  await page.click(".legend > summary");
  await page.check("[data-layer=broad]");
  await page.click('button:text-is("Shoot a ray")');
  const picture = await (await page.$(".stage3 canvas")).boundingBox();
  await page.mouse.click(picture.x + picture.width * 0.3, picture.y + 20);
  await page.mouse.click(picture.x + picture.width * 0.31, picture.y + picture.height - 20);
  assert.match(await page.textContent(".words h2"), /^The ray hits (?!nothing)/);
  await page.click('button:text-is("Cast the body")');
  await page.mouse.click(picture.x + picture.width * 0.6, picture.y + picture.height - 20);
  assert.match(await page.textContent(".words h2"), /^ball meets (?!nothing)/);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-plane.png") });
  await press(page, "[data-step]", 30);
  const later = await shown(page);
  assert.equal(later.frames, 30);
  assert.ok(later.poses.every(Number.isFinite));
  await press(page, "[data-back]", 29);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-plane-played.png") });
  const text = (name, content) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content) });
  await open(text("flat.json", '{"dimension":2,"bodies":[{"shape":{"type":"plane"}},{"name":"disc","motion":"dynamic","translation":[0,3],"shape":{"type":"circle","circle":{"radius":1}}}]}'));
  assert.equal((await shown(page)).bodies, 2);
  await open(text("stack.json", '{"dimension":2,"bodies":[{"name":"floor","shape":{"type":"box","box":{"size":[4,1]}}},{"name":"crate","motion":"dynamic","translation":[0.3,0.999],"shape":{"type":"box","box":{"size":[1,1]}}}]}'));
  await page.selectOption('[data-body="0"]', { label: "floor" });
  await page.selectOption('[data-body="1"]', { label: "crate" });
  assert.match(await page.textContent(".numbers tbody th"), /^vertex [23] of A × vertex [01] of B$/);
  await lightsUp(page);
  if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, "viewer-plane-features.png") });
  await open(text("q.jsonl", '{"query":"distance","dimension":2,"a":{"shape":{"type":"box","box":{"size":[1,1]}}},"b":{"shape":{"type":"circle","circle":{"radius":1}},"translation":[1.2,0.4],"rotation":0.3}}\n'));
  assert.equal((await shown(page)).pairs, 1);
  for (const [name, content, words] of [["cut.svg", "<svg", /cut.svg: expected an XML document/], ["other.svg", "<html/>", /other.svg: .*<svg> element as the root/],
    ["bad.svg", '<svg xmlns="http://www.w3.org/2000/svg"><circle id="c" r="-1"/></svg>', /bad.svg: drawing: line 1: <circle id="c">.r: expected a number >= 0/], ["deep.svg", `${"<g>".repeat(5000)}${"</g>".repeat(5000)}`, /nested at most 100 deep/]]) {
    await open(text(name, content));
    assert.match(await page.textContent(".trouble:not([hidden])"), words);
  }
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test("viewer: a glTF's bodies of several colliders move as one, and its joints hold", async () => {
  const page = await scene("shapes");
  const collider = (shape, more = {}) => ({ ...more, extensions: { KHR_physics_rigid_bodies: { collider: { geometry: { shape } } } } });
  const half = Math.SQRT1_2;
  const gltf = {
    asset: { version: "2.0" }, extensionsUsed: ["KHR_implicit_shapes", "KHR_physics_rigid_bodies"],
    extensions: {
      KHR_implicit_shapes: { shapes: [{ type: "box", box: { size: [1, 1, 1] } }, { type: "sphere", sphere: { radius: 0.5 } }, { type: "cylinder" }] },
      KHR_physics_rigid_bodies: { physicsJoints: [{ limits: [{ linearAxes: [0, 1, 2], min: 0, max: 0 }, { angularAxes: [1, 2], min: 0, max: 0 }] }] },
    },
    scenes: [{ nodes: [0, 3, 6, 7] }],
    nodes: [
      // A dumbbell of two balls that turns as it flies, far from the rest.
      { name: "dumbbell", translation: [0, 50, 0], children: [1, 2], extensions: { KHR_physics_rigid_bodies: { motion: { mass: 2, angularVelocity: [0, 1, 0], gravityFactor: 0 } } } },
      collider(1, { translation: [-1, 0, 0] }), collider(1, { translation: [1, 0, 0] }),
      // A pendulum that hangs from the world by a hinge about Z: its arm points along X at first.
      { name: "pendulum", translation: [11, 5, 0], children: [4, 5], extensions: { KHR_physics_rigid_bodies: { motion: { mass: 1 } } } },
      collider(0),
      { translation: [-1, 0, 0], rotation: [0, -half, 0, half], extensions: { KHR_physics_rigid_bodies: { joint: { connectedNode: 6, joint: 0 } } } },
      { translation: [10, 5, 0], rotation: [0, -half, 0, half] },
      // Scaled unevenly: no cylinder any more.
      collider(2, { name: "oval", translation: [-9, 0, 0], scale: [2, 1, 1] }),
    ],
  };
  await page.setInputFiles("input[type=file]", { name: "joined.gltf", mimeType: "model/gltf+json", buffer: Buffer.from(JSON.stringify(gltf)) });
  await page.waitForTimeout(300);
  assert.ok(!(await page.isVisible(".trouble")), await page.textContent(".trouble"));
  assert.deepEqual(await page.$$eval('[data-body="0"] option', (list) => list.map((o) => o.textContent)), ["no body", "dumbbell", "pendulum", "oval"]);
  await press(page, "[data-step]", 30);
  const { poses } = await shown(page), at = (i) => poses.slice(7 * i, 7 * i + 3);
  // A second of half a second at one radian each: the first ball, whose frame the body has, has turned about the middle.
  const [x, y, z] = at(0), angle = 30 / 60;
  assert.ok(Math.hypot(x + Math.cos(angle), y - 50, z - Math.sin(angle)) < 1e-3, `${[x, y, z]}`);
  const [px, py, pz] = at(1);
  assert.ok(Math.abs(Math.hypot(px - 10, py - 5) - 1) < 1e-3 && Math.abs(pz) < 1e-3, `${[px, py, pz]} is not on the circle about the hinge`);
  assert.ok(py < 4.5, `it hangs at ${py}`);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
