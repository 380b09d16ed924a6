// The lab without a network, and as a file of the disk.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { here, launch, test, types } from "./harness.mjs";

const dist = join(here, "dist");
/** The built lab in memory, and a server of it that can be taken from the network. */
async function network() {
  const files = new Map(readdirSync(dist, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => join(parentPath, name)).map((path) => [path.slice(dist.length).replaceAll("\\", "/"), readFileSync(path)]));
  const state = { files, gone: false, asked: [] };
  const server = createServer((request, response) => {
    const path = new URL(request.url, "http://x").pathname, name = path === "/" ? "/index.html" : path, bytes = files.get(name);
    if (state.gone) return void request.socket.destroy();
    state.asked.push(name);
    response.writeHead(bytes ? 200 : 404, { "content-type": types[extname(name)] ?? "text/javascript" }).end(bytes);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { ...state, state, port: server.address().port, close: () => (server.closeAllConnections(), server.close()) };
}
const caches = (page) => page.evaluate(() => window.caches.keys());

test("offline: the lab is kept, works without a network, and gives way to a new version", async () => {
  const { state, files, port, close } = await network(), address = `http://lab.localhost:${port}/`; // a name of this machine that the lab does not take for it
  const browser = await launch();
  const context = await browser.newContext({ viewport: { width: 1000, height: 600 } }), trouble = [];
  context.setDefaultTimeout(120_000);
  const open = async (hash = "") => {
    const page = await context.newPage();
    page.on("pageerror", (error) => trouble.push(error.message));
    page.on("console", (message) => /Content Security Policy/.test(message.text()) && trouble.push(message.text()));
    await page.goto(address + hash);
    await page.waitForSelector("h1");
    return page;
  };
  const first = await open();
  await first.evaluate(() => navigator.serviceWorker.ready.then(({ active }) => active.state === "activated" || new Promise((done) => active.addEventListener("statechange", done))));
  const [version] = await caches(first);
  assert.match(version, /^graze-lab [0-9a-f]{16}$/);
  for (const name of files.keys()) assert.ok(name === "/service-worker.js" || (await first.evaluate((file) => window.caches.match(`.${file}`).then(Boolean), name)), `${name} is not kept`);
  await first.close();

  // No network: a lesson, and a scene that plays, with the part of the lab that is fetched late.
  state.gone = true;
  await context.setOffline(true);
  const lesson = await open("#/lesson/spheres");
  assert.match(await lesson.textContent("h1"), /Do two balls touch/);
  await lesson.close();
  const scene = await open("#/scene?scene=materials-02");
  await scene.waitForFunction(() => window.lab.shown.bodies > 1);
  await scene.click("[data-step]");
  assert.equal(await scene.evaluate(() => window.lab.shown.frames), 1);
  await scene.close();

  // A new version is shown as soon as there is a network, and the old one is deleted once nobody has it open.
  state.gone = false;
  await context.setOffline(false);
  files.set("/index.html", Buffer.from(String(files.get("/index.html")).replace("<title>", "<title>New: ")));
  files.set("/service-worker.js", Buffer.from(String(files.get("/service-worker.js")).replace(/const version = "[^"]*"/, 'const version = "next"')));
  const next = await open();
  assert.match(await next.evaluate(() => fetch("./index.html", { cache: "reload" }).then((answer) => answer.text())), /Graze lab/);
  await next.evaluate(() => navigator.serviceWorker.getRegistration().then((one) => one.update()));
  await next.waitForFunction(() => navigator.serviceWorker.getRegistration().then((one) => one.waiting?.state === "installed"));
  assert.deepEqual((await caches(next)).sort(), [version, "graze-lab next"].sort());
  await next.close();
  const last = await open();
  await last.waitForFunction(() => window.caches.keys().then((names) => String(names) === "graze-lab next"));
  assert.deepEqual(trouble, []);
  await browser.close();
  close();
});

test("offline: a page of this machine keeps nothing, and one that was opened from the disk says what is missing", async () => {
  const { port, close } = await network(), browser = await launch(), page = await browser.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto(`http://127.0.0.1:${port}/`);
  await page.waitForSelector("h1");
  assert.deepEqual(await page.evaluate(() => navigator.serviceWorker.getRegistrations().then((all) => all.length)), 0);
  await page.goto(pathToFileURL(join(dist, "index.html")).href);
  assert.match(await page.textContent('#app [role="alert"]'), /opened as a file of the disk.*graze view/);
  await browser.close();
  close();
});
