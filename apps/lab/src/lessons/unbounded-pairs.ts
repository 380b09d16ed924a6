// The pairs of the appendix with lines and planes that have no end.

import { answered } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing, Meaning } from "../parts/drawing.ts";
import { row, term } from "../parts/math.ts";
import { add, cross, quatAbout, scale, sub, unit } from "../parts/vec.ts";
import { plane, pointsOf, triangle, type Question, type Vec } from "../question.ts";
import { meets, normal, segment, type Pair, type Solved } from "./appendix-pairs.ts";
import { along } from "./lesson.ts";
import { across, alongLine, asksBefore, before, between, foot, meeting, normalOf, planeAcross, type Meeting } from "./lines.ts";

/** How far a line is drawn to both sides. */
const far = 10;
const drawLine = (d: Drawing, p: Vec, u: Vec, meaning: Meaning): void => d.line(add(p, scale(u, -far)), add(p, scale(u, far)), meaning);
const drawWay = (d: Drawing, from: Vec, to: Vec): void => {
  d.line(from, to, "touch", { wide: true, key: "d" });
  d.point(from, "a", { wide: true, key: "a" });
  d.point(to, "b", { wide: true, key: "b" });
};
const drawPoint = (d: Drawing, x: Vec): void => d.point(x, "touch", { wide: true, label: "x", key: "x" });
/** A line through two points: one of them, and its direction of length one. */
function lineOf(body: Question["a"]): { p: Vec; u: Vec } {
  const [p, q] = pointsOf(body.shape);
  return { p, u: unit(sub(q, p)) };
}
const corners: Vec[] = [[-1, 0, -0.8], [1.4, 0, -0.6], [0.1, 0.4, 1.2]];
const [low, high] = [segment([-1.4, 0.2, 0], [1.5, 0.6, 0.4]), segment([0.2, 1.2, -1.2], [0.6, 1.5, 1.2])];
const leaning = { shape: plane(), translation: [0.3, 0.5, 0], rotation: quatAbout([0, 0, 1], 0.5) };
const placeOf = (body: Question["a"]): Vec => body.translation ?? [0, 0, 0];

function pointLine(q: Question): Solved {
  const { p, u } = lineOf(q.a), x = q.point!, { t, point } = foot(p, u, x), d = between(point, x);
  return {
    question: asksBefore(planeAcross(p, u), x), title: "The foot on the line",
    text: "The plane through p across the line says how far along the line the point is: its signed distance is t. No end clamps it.",
    says: `Distance ${digits(d, 5)}.`,
    formula: [`t = ${row(sub(x, p))} * ${row(u)} = ${digits(t, 5)}`, `x' = ${row(p)} + ${term(t)} ${row(u)} = ${row(point)}`, `d = |x - x'| = ${digits(d, 5)}`],
    rows: [{ cells: ["distance", d], mark: "winner", key: "d" }, { cells: ["t", t] }, { cells: ["x'", vector(point, 4)], key: "a" }],
    extend: (on) => drawLine(on, p, u, "a"),
    draw(on) {
      drawWay(on, point, x);
    },
  };
}

function lineLine(q: Question): Solved {
  const [a, b] = [lineOf(q.a), lineOf(q.b!)], n = across(a.u, b.u), cut = n && meeting(planeAcross(a.p, cross(a.u, n)), b.p, b.u);
  const to = cut ? cut.point : b.p, { point: from, t } = foot(a.p, a.u, to), d = between(from, to);
  return {
    question: cut?.question ?? asksBefore(planeAcross(a.p, a.u), to), title: n ? "One connection is perpendicular to both" : "Parallel lines",
    text: n ? "The plane through the first line along n holds all ways from that line along n. Where it cuts the second line the two are nearest."
      : "The product of the directions vanishes: there is no n. All ways across are equally long, and any point of either line will do.",
    says: `Distance ${digits(d, 5)}.`,
    formula: n ? [`n = ${row(n)}`, `d = |(q - p)*n| = |${row(sub(b.p, a.p))} * ${row(n)}| = ${digits(d, 5)}`] : ["u × v = 0", `d = ${digits(d, 5)}`],
    rows: [{ cells: ["distance", d], mark: "winner", key: "d" }, { cells: ["s, on the first", t], key: "a" }, { cells: ["t, on the second", cut?.t ?? 0], key: "b" },
      { cells: ["on the first", vector(from, 4)], key: "a" }, { cells: ["on the second", vector(to, 4)], key: "b" }],
    extend(on) {
      drawLine(on, a.p, a.u, "a");
      drawLine(on, b.p, b.u, "b");
    },
    draw(on) {
      drawWay(on, from, to);
    },
  };
}

function linePlane(q: Question): Solved {
  const { p, u } = lineOf(q.b!), n = normalOf(q.a), hit = meeting(q.a, p, u), d = before(q.a, p);
  return {
    question: hit?.question ?? asksBefore(q.a, p), title: hit ? "The line meets the plane" : "The line is parallel to the plane",
    text: hit ? "A ray has to be sent both ways: t is negative where the plane lies behind p." : "n·u is zero. Every point of the line is as far from the plane as p is.",
    says: hit ? `They meet at ${vector(hit.point, 3)}.` : `Parallel, ${digits(d, 4)} apart.`,
    formula: [meets(n, along(n, placeOf(q.a)), p, u, hit?.t), ...(hit ? [`x = ${row(p)} + ${term(hit.t)} ${row(u)} = ${row(hit.point)}`] : [`d = ${digits(d, 5)}`])],
    rows: hit ? [{ cells: ["t", hit.t], mark: "winner" }, { cells: ["x", vector(hit.point, 4)], key: "x" }] : [{ cells: ["distance", d], mark: "winner" }],
    extend: (on) => drawLine(on, p, u, "b"),
    draw(on) {
      if (hit) drawPoint(on, hit.point);
    },
  };
}

function planePlane(q: Question): Solved {
  const [a, b] = [q.a, q.b!], u = across(normalOf(a), normalOf(b)), hit = u && meeting(b, placeOf(a), cross(u, normalOf(a)));
  const d = before(a, placeOf(b));
  return {
    question: hit?.question ?? asksBefore(a, placeOf(b)), title: hit ? "They meet in a line" : "Parallel planes",
    text: hit ? "Its direction lies in both planes, across both normals. A point of it: from a point of the first plane, within that plane and across the line, on to the second plane."
      : "The product of the normals vanishes: there is no direction. Every point of the one is as far from the other.",
    says: hit ? `They meet in a line through ${vector(hit.point, 3)}.` : `Parallel, ${digits(d, 4)} apart.`,
    formula: hit ? [`n_A × n_B = ${row(cross(normalOf(a), normalOf(b)))}`, `u = ${row(u!)}`, `x = ${row(hit.point)} + t u`] : ["n_A × n_B = 0", `d = ${digits(d, 5)}`],
    rows: hit ? [{ cells: ["direction", vector(u!, 4)], key: "u" }, { cells: ["a point", vector(hit.point, 4)], mark: "winner", key: "x" },
      { cells: ["its distance from A", before(a, hit.point)] }, { cells: ["its distance from B", before(b, hit.point)] }] : [{ cells: ["distance", d], mark: "winner" }],
    draw(on) {
      if (!hit) return;
      on.line(add(hit.point, scale(u!, -far)), add(hit.point, scale(u!, far)), "touch", { key: "u" });
      drawPoint(on, hit.point);
    },
  };
}

function lineTriangle(q: Question): Solved {
  const { p, u } = lineOf(q.b!), hit = alongLine(q.a, p, u), points = pointsOf(q.a.shape), n = normal(points);
  return {
    question: hit?.question ?? { query: "raycast", a: q.a, ray: { origin: p, direction: u } }, title: hit ? "The line goes through" : "No hit",
    text: hit ? "One ray along u or one against it meets the triangle; the line itself has no beginning." : "Neither the ray along u nor the one against it meets the triangle.",
    says: hit ? `The line goes through at ${vector(hit.point, 3)}.` : "The line misses the triangle.",
    formula: [meets(n, along(n, points[0]), p, u, hit?.t), ...(hit ? [`x = ${row(p)} + ${term(hit.t)} ${row(u)} = ${row(hit.point)}`] : [])],
    rows: hit ? [{ cells: ["t", hit.t], mark: "winner" }, { cells: ["x", vector(hit.point, 4)], key: "x" }] : [{ cells: ["hit", "no"] }],
    extend: (on) => drawLine(on, p, u, "b"),
    draw(on) {
      if (hit) drawPoint(on, hit.point);
    },
  };
}

function planeTriangle(q: Question): Solved {
  const answer = answered(q), points = pointsOf(q.b!.shape), heights = points.map((x) => before(q.a, x));
  const cuts = points.flatMap((from, i): { edge: string; at: Meeting }[] => {
    const next = (i + 1) % 3, at = (heights[i] > 0) !== (heights[next] > 0) ? meeting(q.a, from, sub(points[next], from)) : null;
    return at ? [{ edge: `${"abc"[i]}${"abc"[next]}`, at }] : [];
  });
  const side = heights.every((x) => x > 0) ? { title: "All corners are above the plane", text: "the distance of the lowest is that of the triangle." }
    : { title: "No corner is above the plane", text: "the lowest of them says how far the triangle has to go along the normal to be above the plane." };
  return {
    question: q, title: cuts.length ? "The plane cuts the triangle" : side.title,
    text: cuts.length ? "Two edges have a corner on either side. Each is cut where the signed distance passes through zero, and the triangle between these two points."
      : `All three corners are on one side, and with them the whole triangle: ${side.text}`,
    says: cuts.length ? `Cut from ${vector(cuts[0].at.point, 3)} to ${vector(cuts.at(-1)!.at.point, 3)}.` : `Signed distance ${digits(answer.distance, 4)}.`,
    formula: [heights.map((x, i) => `d_${"abc"[i]} = ${digits(x, 4)}`).join(", "), ...cuts.map(({ edge: [i, j], at }) => {
      const [from, to] = [i, j].map((name) => heights["abc".indexOf(name)]), start = points["abc".indexOf(i)];
      return `${row(start)} + frac(${digits(from, 3)}, ${digits(from, 3)} - ${term(to, 3)}) (${j} - ${i}) = ${row(at.point)}`;
    })],
    rows: [{ cells: ["distance", answer.distance!], mark: cuts.length ? undefined : "winner" }, ...heights.map((x, i) => ({ cells: [`before it: ${"abc"[i]}`, x], key: `corner-${i}` })),
      ...cuts.map(({ edge, at }) => ({ cells: [`on ${edge}`, vector(at.point, 4)], mark: "winner" as const, key: edge }))],
    draw(on) {
      points.forEach((x, i) => on.point(x, "b", { key: `corner-${i}`, label: "abc"[i] }));
      if (cuts.length > 1) on.line(cuts[0].at.point, cuts[1].at.point, "touch", { wide: true });
      for (const { edge, at } of cuts) on.point(at.point, "touch", { wide: true, key: edge });
    },
  };
}

const unclamped = "The line has no ends: nothing is clamped.";
export const unboundedPairs: Pair[] = [
  { value: "point-line", label: "point, line", q: { query: "closest", a: low, point: [0.4, 1.7, 0.6] }, solve: pointLine,
    text: `Two points give the line: p, and the direction u of length one. The scalar product with u says how far along it the point is. ${unclamped}`, formula: ["t = (x - p)*u", "x' = p + t u", "d = |x - x'|"] },
  { value: "line-line", label: "line, line", q: { query: "distance", a: low, b: high }, solve: lineLine,
    text: `The shortest way between two lines is across both: along n, the product of their directions. ${unclamped}`, formula: ["n = frac(u × v, |u × v|)", "d = |(q - p)*n|"] },
  { value: "line-plane", label: "line, plane", q: { query: "distance", a: { shape: plane() }, b: segment([-0.8, 1.3, 0.4], [0.1, 0.7, 0.1]) }, solve: linePlane,
    text: "Put the line's point into the plane's equation and solve for t, which may have either sign. A line along the plane has no such t: the denominator is zero.", formula: ["n*(p + t u) = w", "t = frac(w - n*p, n*u)"] },
  { value: "plane-plane", label: "plane, plane", q: { query: "distance", a: { shape: plane() }, b: leaning }, solve: planePlane,
    text: "Two planes meet in a line, unless their normals are parallel. The line lies in both planes: its direction is the product of the normals.", formula: ["u = frac(n_A × n_B, |n_A × n_B|)", "n_A*x = w_A, n_B*x = w_B"] },
  { value: "line-triangle", label: "line, triangle", q: { query: "distance", a: { shape: triangle(...corners) }, b: segment([0.1, 1.5, 0.2], [0.2, 1, 0.1]) }, solve: lineTriangle,
    text: "The line's point in the plane of the triangle, and three signs as for a ray; but t may be negative.", formula: ["t = frac(n*a - n*p, n*u)", '"three signs as for a ray"'] },
  { value: "plane-triangle", label: "plane, triangle", q: { query: "distance", a: { shape: plane(), translation: [0, 0.6, 0] }, b: { shape: triangle([-1, 0.2, -0.6], [1.3, 0.3, 0], [0.2, 1.5, 0.3]) } }, solve: planeTriangle,
    text: "The signed distance of each corner. If all three have the same sign the plane misses the triangle; else two edges change sides, and are cut.", formula: ["d_i = n*x_i - w", "x = a + frac(d_a, d_a - d_b) (b - a)"] },
];
