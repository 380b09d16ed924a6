// Actions of tests in the viewer.

import assert from "node:assert/strict";
import { join } from "node:path";
import { frame, here, small, visit } from "./harness.mjs";

export const scene = (name) => visit(`#/scene?scene=${name}`, small);
/** Presses a button so many times, without a look at the page in between. */
export const press = (page, button, times) =>
  page.evaluate(([selector, count]) => {
    for (let i = 0; i < count; i++) document.querySelector(selector).click();
  }, [button, times]);
export const files = join(here, "../../examples/scenes");

/** Checks that contacts light up with their row: another picture than without. The window has room for both: to show one
 *  by scrolling would take the mouse off the other. */
export async function lightsUp(page) {
  await page.setViewportSize({ width: small.viewport.width, height: 1400 });
  await frame(page);
  const picture = await page.$(".stage3 canvas"), plain = await picture.screenshot();
  await page.hover(".numbers tbody tr:first-child");
  for (let waits = 0; (await picture.screenshot()).equals(plain); waits++) {
    assert.ok(waits < 50, "the picture is as without");
    await page.waitForTimeout(100);
  }
}

/** Lines and points of the picture, as they were handed to the graphics card: their ends, their places. */
export const drawn = (page) =>
  page.evaluate(() => {
    const { children } = window.lab.stage.drawn, lines = [];
    for (const { geometry } of children.filter((x) => x.isLineSegments2)) {
      const ends = geometry.attributes.instanceStart.data.array;
      for (let i = 0; i < ends.length; i += 6) lines.push([[...ends.slice(i, i + 3)], [...ends.slice(i + 3, i + 6)]]);
    }
    const places = children.filter((x) => x.isPoints).flatMap(({ geometry }) => [...geometry.attributes.position.array]);
    return { lines, points: Array.from({ length: places.length / 3 }, (_, i) => places.slice(3 * i, 3 * i + 3)) };
  });
/** What one picture has beyond another. */
export function beyond(more, less) {
  const added = (list, others) => {
    const left = others.map(String);
    return list.filter((x) => !left.includes(String(x)) || (left.splice(left.indexOf(String(x)), 1), false));
  };
  return { lines: added(more.lines, less.lines), points: added(more.points, less.points) };
}
const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);
/** Positions have 24 bits in a graphics card. */
const within = 1e-5;
const same = (p, q) => p.every((x, i) => Math.abs(x - q[i]) < within);
/** Checks that lines are those of an axis: the intervals of A and B along it, beside each other, and between them the
 *  overlap or the gap, from where A ends to where B begins. */
export function showsAxis(lines, { name, direction, a, b, overlap }) {
  const along = (line) => line.map((end) => dot(end, direction)), between = [a[1], b[0]].sort((x, y) => x - y);
  assert.equal(lines.length, 3, `${name}: ${lines.length} lines`);
  for (const [from, to] of lines) {
    const length = Math.hypot(...to.map((x, i) => x - from[i]));
    assert.ok(Math.abs(Math.abs(dot(to, direction) - dot(from, direction)) - length) < within, `${name}: a line leaves the axis`);
  }
  for (const interval of [a, b, between]) assert.ok(lines.some((line) => same(along(line).sort((x, y) => x - y), interval)), `${name}: no line from ${interval[0]} to ${interval[1]}, but ${lines.map(along)}`);
  assert.ok(Math.abs(between[1] - between[0] - Math.abs(overlap)) < within);
}
/** Checks that a picture has the last cut of a trace: the line along which it goes, the polygon that is left with its
 *  corners, and both faces. */
export function showsCut({ lines, points }, { cuts, faces }) {
  const { from, to, left } = cuts.at(-1), sides = (polygon) => polygon.map((corner, i) => [corner, polygon[(i + 1) % polygon.length]]);
  const edges = [[from, to], ...sides(left), ...sides(faces.a), ...sides(faces.b)];
  assert.deepEqual([lines.length, points.length], [edges.length, left.length]);
  for (const edge of edges) assert.ok(lines.some((line) => edge.every((end, i) => same(end, line[i]))), `no line ${edge}`);
  for (const corner of left) assert.ok(points.some((point) => same(corner, point)), `no point ${corner}`);
}
/** The colours of the bodies, by what they mean, and the numbers of those with an outline. */
export const looks = (page) =>
  page.evaluate(() => {
    const style = getComputedStyle(document.documentElement), linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const meanings = ["a", "b", "made", "out", "trigger", "touch", "asleep"].map((name) => {
      const hex = parseInt(style.getPropertyValue(`--${name}`).trim().slice(1), 16);
      return { name, rgb: [16, 8, 0].map((shift) => linear(((hex >> shift) & 255) / 255)) };
    });
    const colors = [], outlined = [], part = ({ array }, i, size) => [...array.slice(i * size, (i + 1) * size)];
    for (const { mesh, rim, bodies } of window.lab.stage.crowd.batches) {
      const around = rim.visible ? Array.from({ length: rim.count }, (_, i) => String(part(rim.instanceMatrix, i, 16))) : [];
      bodies.forEach((body, i) => {
        const shade = part(mesh.instanceColor, i, 3);
        colors[body] = meanings.find(({ rgb }) => rgb.every((c, k) => Math.abs(c - shade[k]) < 1e-4))?.name;
        if (around.includes(String(part(mesh.instanceMatrix, i, 16)))) outlined.push(body);
      });
    }
    return { colors, outlined: outlined.sort((i, j) => i - j) };
  });
