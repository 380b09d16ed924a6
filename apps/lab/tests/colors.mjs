// The lab's colours are told apart with any colour vision: every two meanings, in both themes, as people without long,
// middle or short cones see them.
//
// Simulated by the matrices of Machado, Oliveira, Fernandes: A physiologically-based model for simulation of color
// vision deficiency, IEEE Transactions on Visualization and Computer Graphics 15 (2009), severity 1, on linear sRGB.
// Compared by CIEDE2000 (Sharma, Wu, Dalal: Color Research and Application 30, 2005), where 1 is what one just notices
// side by side.
//
//   node tests/colors.mjs

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** Ten times the least difference that is noticed side by side: small marks lie apart, and also differ by sign and
 *  letter. */
const least = 10;
/** The meanings of parts/drawing.ts. */
const meanings = ["a", "b", "touch", "axis", "out", "made", "trigger", "asleep", "ink"];

const visions = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const times = (matrix, v) => matrix.map((row) => row.reduce((sum, x, i) => sum + x * v[i], 0));

/** A colour like "#1f6feb" in linear sRGB (IEC 61966-2-1). */
function linear(hex) {
  const parts = [1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16) / 255);
  return parts.map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
}
/** A colour in CIELAB for the white of D65. */
function lab(rgb) {
  const shown = rgb.map((c) => Math.min(1, Math.max(0, c)));
  const xyz = times([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.072175], [0.0193339, 0.119192, 0.9503041]], shown);
  const [x, y, z] = xyz.map((v, i) => v / [0.95047, 1, 1.08883][i]).map((t) => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const radians = (degrees) => (degrees * Math.PI) / 180;
const hue = (a, b) => (a === 0 && b === 0 ? 0 : ((Math.atan2(b, a) * 180) / Math.PI + 360) % 360);
/** The difference CIEDE2000, in the order of Sharma, Wu and Dalal. */
function difference([l1, a1, b1], [l2, a2, b2]) {
  const seventh = (c) => Math.sqrt(c ** 7 / (c ** 7 + 25 ** 7));
  const stretch = 1.5 - 0.5 * seventh((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2);
  const [c1, c2] = [Math.hypot(stretch * a1, b1), Math.hypot(stretch * a2, b2)], [h1, h2] = [hue(stretch * a1, b1), hue(stretch * a2, b2)];
  const grey = c1 * c2 === 0, apart = h2 - h1;
  const turn = grey ? 0 : apart > 180 ? apart - 360 : apart < -180 ? apart + 360 : apart;
  const dl = l2 - l1, dc = c2 - c1, dh = 2 * Math.sqrt(c1 * c2) * Math.sin(radians(turn / 2));
  const l = (l1 + l2) / 2, c = (c1 + c2) / 2;
  const h = grey ? h1 + h2 : Math.abs(apart) <= 180 ? (h1 + h2) / 2 : (h1 + h2 + (h1 + h2 < 360 ? 360 : -360)) / 2;
  const t = 1 - 0.17 * Math.cos(radians(h - 30)) + 0.24 * Math.cos(radians(2 * h)) + 0.32 * Math.cos(radians(3 * h + 6)) - 0.2 * Math.cos(radians(4 * h - 63));
  const ofL = 1 + (0.015 * (l - 50) ** 2) / Math.sqrt(20 + (l - 50) ** 2), ofC = 1 + 0.045 * c, ofH = 1 + 0.015 * c * t;
  const rotation = -2 * seventh(c) * Math.sin(radians(60 * Math.exp(-(((h - 275) / 25) ** 2))));
  return Math.sqrt((dl / ofL) ** 2 + (dc / ofC) ** 2 + (dh / ofH) ** 2 + rotation * (dc / ofC) * (dh / ofH));
}

// Pairs 1, 7, 9, 17 and 25 of the paper's table.
for (const [one, other, expected] of [
  [[50, 2.6772, -79.7751], [50, 0, -82.7485], 2.0425], [[50, 0, 0], [50, -1, 2], 2.3669], [[50, 2.49, -0.001], [50, -2.49, 0.0009], 7.1792],
  [[50, 2.5, 0], [73, 25, -18], 27.1492], [[60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644]])
  assert.ok(Math.abs(difference(one, other) - expected) < 1e-4, `${one} and ${other}: ${difference(one, other)}, not ${expected}`);

const style = readFileSync(fileURLToPath(new URL("../src/style.css", import.meta.url)), "utf8");
const themes = { light: /:root \{(.*?)\}/s, dark: /:root\[data-theme="dark"\] \{(.*?)\}/s };
let closest = { far: Infinity };
for (const [theme, rule] of Object.entries(themes)) {
  const values = Object.fromEntries([...rule.exec(style)[1].matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name, value]) => [name, value]));
  for (const [vision, matrix] of Object.entries(visions)) {
    const seen = meanings.map((meaning) => lab(times(matrix, linear(values[meaning]))));
    for (let i = 0; i < meanings.length; i++)
      for (let j = 0; j < i; j++) {
        const far = difference(seen[i], seen[j]);
        if (far < closest.far) closest = { far, theme, vision, pair: `${meanings[j]} and ${meanings[i]}` };
        assert.ok(far >= least, `${theme}, ${vision}: ${meanings[j]} and ${meanings[i]} differ by ${far.toFixed(1)}, at least ${least} is wanted`);
      }
  }
}
console.log(`colours: the closest two differ by ${closest.far.toFixed(1)} (${closest.pair}, ${closest.theme}, ${closest.vision})`);
