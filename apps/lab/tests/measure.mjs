// What the lab's pages take in headless Chromium, with the processor as it is and slowed fourfold: the first drawing, a
// drag in the third lesson, and a thousand boxes that are played. It prints a table and judges nothing: on a machine with
// other work, or with a processor in place of a graphics card, times say little by themselves, their ratios more.
//
//   node tests/measure.mjs            ONLY=text, LAB_URL and CHROMIUM as in browser/harness.mjs

import { close, drag, server, small, visit } from "./browser/harness.mjs";

const phone = { viewport: { width: 390, height: 844 } };
const lesson = "#/lesson/separating-axes-plane";
const rates = [1, 4];
const wanted = (name) => !process.env.ONLY || name.includes(process.env.ONLY);
const sorted = (list) => [...list].sort((a, b) => a - b);
const part = (list, share) => sorted(list)[Math.min(list.length - 1, Math.floor(list.length * share))];
const ms = (x) => `${x < 10 ? x.toFixed(1) : Math.round(x)} ms`;
const spread = (list) => `${ms(part(list, 0.5))} (of twenty nineteen within ${ms(part(list, 0.95))})`;
const slowed = (rate) => (rate === 1 ? "" : `, slowed ${rate}-fold`);

async function slow(page, rate) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" }); // time in which others had the processor does not count
  await session.send("Emulation.setCPUThrottlingRate", { rate });
  return session;
}
/** The time that a page's thread has spent so far, in seconds, by what it did. */
const spent = async (session) => Object.fromEntries((await session.send("Performance.getMetrics")).metrics.map(({ name, value }) => [name, value]));

/** The time from the beginning of a visit to the first picture of `selector`, in milliseconds. */
async function firstDrawing(hash, selector, rate) {
  const page = await visit("", phone), session = await slow(page, rate);
  await session.send("Network.setCacheDisabled", { cacheDisabled: true });
  await page.addInitScript((wanted) => {
    const look = () => {
      if (!document.querySelector(wanted)) return requestAnimationFrame(look);
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => (window.firstDrawn = performance.now());
      port2.postMessage(0);
    };
    requestAnimationFrame(look);
  }, selector);
  await page.goto("about:blank");
  await page.goto(server.address + hash);
  const time = await (await page.waitForFunction(() => window.firstDrawn)).jsonValue();
  await page.context().close();
  return time;
}

/** A drag of B in the third lesson: from a move of the pointer to the end of the frame that shows it, and the work of
 *  that frame; and how many frames a second show a move. */
async function dragged(step, rate) {
  const page = await visit(lesson, phone);
  await drag(page, "move-b", 5, 5);
  for (let i = 0; i < step; i++) await page.click("[data-next]");
  await page.evaluate(() => document.querySelector(".board").scrollIntoView());
  const session = await slow(page, rate);
  await page.evaluate(() => {
    window.moves = [];
    let waits = false;
    addEventListener("pointermove", ({ timeStamp }) => {
      if (waits) return;
      waits = true;
      requestAnimationFrame(() => {
        const begun = performance.now(), { port1, port2 } = new MessageChannel();
        port1.onmessage = () => {
          const done = performance.now();
          waits = false;
          window.moves.push({ whole: done - timeStamp, work: done - begun, done });
        };
        port2.postMessage(0);
      });
    }, true);
  });
  const box = await (await page.$('[data-handle="move-b"]')).boundingBox(), at = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...at);
  await page.mouse.down();
  const send = (i) => session.send("Input.dispatchMouseEvent", { type: "mouseMoved", button: "left", buttons: 1, x: at[0] + 30 * Math.sin(i / 9), y: at[1] + 20 * Math.cos(i / 13) });
  for (let i = 0; i < 20; i++) await send(i);
  await page.evaluate(() => (window.moves.length = 0));
  const before = await spent(session), count = 150;
  for (let i = 20; i < 20 + count; i++) await send(i);
  const after = await spent(session), moves = await page.evaluate(() => window.moves), seconds = (moves.at(-1).done - moves[0].done) / 1000;
  await page.mouse.up();
  const each = (name) => ((after[name] - before[name]) * 1000) / moves.length;
  await page.context().close();
  return { whole: moves.map((m) => m.whole), work: moves.map((m) => m.work), rate: (moves.length - 1) / seconds,
    parts: { script: each("ScriptDuration"), style: each("RecalcStyleDuration"), layout: each("LayoutDuration"), all: each("TaskDuration") } };
}

/** Frames of a thousand boxes that are played from their beginning. */
async function played(name, seconds, rate) {
  const page = await visit(`#/scene?scene=${name}`, small), session = await slow(page, rate);
  await page.click("[data-play]");
  await page.waitForFunction(() => window.lab.play.steps > 5);
  const before = await spent(session);
  const frames = await page.evaluate((until) => new Promise((done) => {
    const list = [], start = performance.now();
    let last = start;
    const each = (now) => {
      const { play, drawTime } = window.lab;
      list.push({ between: now - last, step: play.stepTime, draw: drawTime, ...play.stages });
      last = now;
      if (performance.now() - start < until) requestAnimationFrame(each);
      else done(list.slice(1));
    };
    requestAnimationFrame(each);
  }), seconds * 1000);
  const after = await spent(session), each = (key) => ((after[key] - before[key]) * 1000) / frames.length;
  await page.context().close();
  return { of: (key) => part(frames.map((f) => f[key]), 0.5), count: frames.length, parts: { script: each("ScriptDuration"), layout: each("LayoutDuration") + each("RecalcStyleDuration"), all: each("TaskDuration") } };
}

for (const [name, hash, selector] of [["the list of lessons", "", "article.home"], ["the third lesson", lesson, ".stage2 .shape"], ["the playground", "#/scene", ".stage3 canvas"]])
  for (const rate of rates) {
    if (!wanted(`first drawing of ${name}`)) continue;
    const times = [];
    for (let i = 0; i < 7; i++) times.push(await firstDrawing(hash, selector, rate));
    console.log(`first drawing of ${name}${slowed(rate)}: median ${ms(part(times, 0.5))}, ${ms(Math.min(...times))} to ${ms(Math.max(...times))}`);
  }
for (const step of [0, 4, 15])
  for (const rate of rates) {
    if (!wanted(`drag in the third lesson`)) continue;
    const { whole, work, rate: shown, parts } = await dragged(step, rate);
    console.log(`drag in the third lesson, step ${step + 1}${slowed(rate)}: ${spread(whole)} from a move to its frame's end, ${spread(work)} of work; ${shown.toFixed(0)} frames a second`);
    console.log(`  of a frame: script ${ms(parts.script)}, style ${ms(parts.style)}, layout ${ms(parts.layout)}, all tasks ${ms(parts.all)}`);
  }
for (const rate of rates) {
  if (!wanted("a thousand boxes")) continue;
  const { of, count, parts } = await played("thousand", 10, rate);
  console.log(`a thousand boxes${slowed(rate)}: ${count} frames, median ${ms(of("between"))} each: step ${ms(of("step"))} (collide ${ms(of("collideMs"))}, prepare ${ms(of("prepareMs"))}, solve ${ms(of("solveMs"))}), script that draws ${ms(of("draw"))}`);
  console.log(`  of a frame, mean: script ${ms(parts.script)}, style and layout ${ms(parts.layout)}, all tasks ${ms(parts.all)}`);
}
await close();
