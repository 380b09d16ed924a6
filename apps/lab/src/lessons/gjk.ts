import { ask, tessellated, type GjkStep, type Support } from "../graze.ts";
import { drawDistance, drawTrace } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, cross, dot, length, quatAbout, scale, sub, unit } from "../parts/vec.ts";
import { box, convex, type Question, type State, type Vec } from "../question.ts";
import { along, dragBody, drawBodies, later, moveHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";
import { drawOrigin, home } from "./minkowski.ts";
import { region } from "./region.ts";

const kinds = ["", "a point", "an edge", "a triangle", "a tetrahedron"];
const listed = (names: string[]): string => names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;

/** The support points of a trace in the order in which they were found: w1, w2, ... */
function namesOf(list: GjkStep[]): (p: Support) => string {
  const names = new Map<string, string>(), key = (p: Support): string => JSON.stringify([p.a, p.b]);
  for (const s of list)
    for (const p of [...s.simplex, s.found]) if (!names.has(key(p))) names.set(key(p), `w${names.size + 1}`);
  return (p) => names.get(key(p))!;
}

/** Support points without those that are named alike. */
const distinct = (points: Support[], name: (p: Support) => string): Support[] =>
  points.filter((p, i) => points.findIndex((x) => name(x) === name(p)) === i);

/** The bounds of a step as a picture: the line (in space a square) through s across n, that through v, and the strip
 *  between. */
function drawBounds(d: Drawing, zero: Vec, n: Vec, beyond: number, lower: number, upper: number, s: Vec): void {
  const at = (t: number): Vec => add(zero, scale(n, t)), from = Math.max(0, lower);
  if (zero.length === 2) {
    const side = scale([-n[1], n[0]], 3);
    const across = (t: number): [Vec, Vec] => [add(at(t), side), sub(at(t), side)];
    if (upper > from) d.polygon([...across(from), ...across(upper).reverse()], "made", { ghost: true, fill: true });
    d.line(...across(upper), "touch", { dashed: true });
    d.line(...across(beyond), "made", { wide: true });
    if (from > beyond && from > 0) d.line(...across(from), "made", { dashed: true });
    return;
  }
  const one = unit(cross(n, Math.abs(n[1]) < 0.8 ? [0, 1, 0] : [1, 0, 0])), other = cross(n, one);
  const off = sub(s, at(beyond)), wide = Math.max(0.7, Math.abs(dot(off, one)), Math.abs(dot(off, other)));
  const square = (t: number): Vec[] => [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => add(at(t), add(scale(one, x * wide), scale(other, y * wide))));
  d.polygon(square(beyond), "made", { ghost: true });
  if (upper > from) d.line(at(from), at(upper), "touch", { wide: true });
}

interface Situation {
  q: Question;
  paint: (d: Drawing) => void;
  /** Whether `paint` draws the difference; by default it does. */
  whole?: boolean;
  origin: (d: Drawing) => void;
  /** The place at which the origin of the difference is drawn. */
  zero: Vec;
  /** Further digits, for places that are far away. */
  more?: number;
}

/** Steps of the trace, whatever the dimension. */
function walk({ q, paint, whole = true, origin, zero, more = 0 }: Situation): Step[] {
  const answer = ask(q), list = answer.trace.gjk, flat = q.dimension === 2;
  const cut = (p: Vec): Vec => p.slice(0, flat ? 2 : 3);
  const difference = (p: Support): Vec => sub(cut(p.b), cut(p.a));
  const spot = (p: Support): Vec => add(zero, difference(p));
  const name = namesOf(list), wall = flat ? "line" : "plane";
  const inside = answer.distance! <= 0, touching = Math.abs(answer.distance!) <= 1e-10 * (list[0]?.upper ?? 1);
  const ends = flat ? "10⁻¹⁰ of the shapes' size" : "rounding of the shapes' size";
  const bounds = (at: number): Step["graph"] => ({
    caption: "bounds of the distance", at,
    series: [{ name: "at most", meaning: "touch", values: list.map((s) => s.upper) }, { name: "at least", meaning: "made", values: list.map((s) => s.lower) }],
  });
  /** An iteration as the library draws it, with the letters of its points, which are seen on the shapes too. */
  const drawIteration = (d: Drawing, s: Pick<GjkStep, "simplex" | "direction" | "found">): void => {
    if (s.simplex.length > 2) d.polygon(s.simplex.slice(0, 3).map(spot), "axis", { wide: true });
    const letters = [...s.simplex.map(name), undefined, "s"];
    drawTrace(d, { gjk: [{ ...s, lower: 0, upper: 0 }] }, { by: zero, look: { wide: true }, label: "n",
      points: (i) => ({ wide: true, label: letters[i], key: letters[i] }), as: { b: "axis", contact: "made", ruledOut: null } });
    for (const p of s.simplex) {
      d.point(cut(p.a), "a", { key: name(p) });
      d.point(cut(p.b), "b", { key: name(p) });
    }
  };
  /** The simplex before v was sought, and of it the part in whose region O lies. */
  const drawRegion = (d: Drawing, before: Support[], simplex: Support[]): void => {
    const corners = before.map(spot), kept = simplex.map((p) => corners[before.findIndex((x) => name(x) === name(p))]);
    corners.forEach((p, k) => corners.slice(k + 1).forEach((q) => d.line(p, q, "axis", { ghost: true })));
    if (flat && before.length > 1) d.polygon(region(corners, kept, 20), "axis", { fill: true, dashed: true });
  };
  const cells = (label: string, p: Support): string[] => [label, vector(cut(p.a), 3 + more), vector(cut(p.b), 3 + more), vector(difference(p), 3)];
  const steps: Step[] = [{
    title: "One question to the origin",
    text: "How far is the difference B ⊖ A from the origin O? That is the distance of the shapes. GJK never builds the difference. It keeps at most " +
      `${flat ? "three" : "four"} of its points, a simplex, and calls v the point of the simplex nearest to O, n the direction of length one from O to v, ` +
      "and s the point of the difference that lies furthest against n: B's furthest point against n minus A's furthest along it." +
      (whole ? "" : " With so many points it is not drawn here."),
    says: whole ? "The two shapes and their difference." : "The two shapes, without their difference, which has too many points.",
    draw(d) {
      paint(d);
      origin(d);
    },
  }];
  list.forEach((s, i) => {
    const last = i === list.length - 1, names = s.simplex.map(name);
    const before = i > 0 ? distinct([...list[i - 1].simplex, list[i - 1].found], name) : [];
    const dropped = before.map(name).filter((w) => !names.includes(w));
    const where = before.length > 1 ? `O lies in the region of ${listed(names)}${flat ? " (shaded)" : ""}. ` : "";
    const rows = s.simplex.map((p) => ({ cells: cells(name(p), p), key: name(p) }));
    const columns = { caption: "Corners of the simplex, and what was found (units of length)", columns: ["point", "of A", "of B", "b − a"] };
    const joined = i > 0 ? `The last s has joined as ${name(list[i - 1].found)}. ` : `It begins with any point of the difference, ${names[0]}. `;
    if (s.direction.every((x) => x === 0)) {
      steps.push({
        title: touching ? `Iteration ${i + 1}: O lies on the simplex` : `Iteration ${i + 1}: O is inside ${kinds[names.length].replace("a ", "the ")}`,
        text: joined + (touching
          ? `O lies on a side of ${kinds[names.length]}, as exactly as numbers can say: the difference reaches O and no further, the shapes touch, and touching counts as overlap. d is zero.`
          : `O lies inside, so it is a point of the difference: some point of A is one of B, the shapes overlap. There is no v, no n and nothing left to ask; how deep they overlap is a question for EPA.`),
        formula: [touching ? "d = 0" : "d < 0"], numbers: { ...columns, rows }, graph: bounds(i),
        says: `Iteration ${i + 1}: the distance is between 0 and 0.`,
        draw(d) {
          paint(d);
          drawRegion(d, before, s.simplex);
          drawIteration(d, s);
        },
      });
      return;
    }
    steps.push(later(() => {
      const n = cut(s.direction), beyond = along(n, difference(s.found)), gap = s.upper - s.lower;
      const counts = Math.abs(beyond - s.lower) <= 1e-9 * s.upper;
      const bound = counts ? "s*n" : flat && s.lower === 0 ? "0" : '"earlier bound"';
      const open = digits(Math.max(0, gap), 4);
      return {
        title: `Iteration ${i + 1}: ${kinds[names.length]}`,
        text: joined + where + (dropped.length ? `v needs ${listed(names)} alone: ${listed(dropped)} ${dropped.length > 1 ? "are" : "is"} dropped. ` : "") +
          `v ${names.length === 1 ? `is ${names[0]} itself` : `lies on the ${names.length === 2 ? "edge" : "triangle"} of ${listed(names)}`}. ` +
          (beyond > 0 ? `Everything of the difference lies beyond the ${wall} through s across n, so nothing of it is nearer to O than that ${wall}. ` +
            (counts ? "" : `An earlier ${wall} lay further out; its bound stays. `)
            : `Everything of the difference lies on one side of the ${wall} through s across n, but so does O: that proves nothing yet. `) +
          "v belongs to the difference: d is at most |v|. " +
          (!last ? (flat ? "The strip between is still open. " : "The way between plane and v is still open. ") : inside ? (touching ? "v is O but for rounding: they touch." : "Once s joins, the simplex encloses O.")
            : `What is left between is within ${ends}: the search ends.`),
        formula: [`${bound} <= d <= |v|`, `${digits(s.lower, 6)} <= d <= ${digits(s.upper, 6)}`, `|v| - ${bound} = ${open}`],
        numbers: { ...columns, rows: [...rows, { cells: cells("s", s.found), key: "s", mark: "now" as const }] },
        graph: bounds(i),
        says: `Iteration ${i + 1}: the distance is between ${digits(s.lower, 4)} and ${digits(s.upper, 4)}.`,
        draw(d) {
          paint(d);
          drawRegion(d, before, s.simplex);
          drawBounds(d, zero, n, beyond, s.lower, s.upper, spot(s.found));
          drawIteration(d, s);
          d.line(zero, add(zero, scale(n, s.upper)), "touch", { dashed: true });
          d.point(add(zero, scale(n, s.upper)), "touch", { label: "v" });
          d.point(cut(s.found.a), "a", { wide: true, key: "s" });
          d.point(cut(s.found.b), "b", { wide: true, key: "s" });
        },
      };
    }));
  });
  const end = list.at(-1), [a, b] = [answer.a as unknown as Vec, answer.b as unknown as Vec];
  const around = end && inside && !touching ? (end.direction.some((x) => x !== 0) ? [...end.simplex, end.found] : end.simplex) : [];
  steps.push({
    title: touching ? "They touch" : inside ? "They overlap" : "The distance",
    text: `${list.length} iterations. ` + (more
      ? `The steps are told in numbers of the world, where ${digits(Math.abs(a[0]), 7)} takes up most of the digits. The library answers in the frame of A, where the numbers are small: compare the last digits.`
      : inside ? `${touching ? "O lies on the boundary of the difference" : `The simplex of ${around.length} corners holds O, and EPA starts from it`}; the signed distance is ${digits(answer.distance, 6)}.`
        : "v is a mean of the simplex's corners with weights λ. The same weights applied to the corners' points of A give the point of A that is nearest to B, and those of B the point of B: their difference is v, their distance |v|."),
    formula: inside ? ["O in B ⊖ A", `d = ${digits(answer.distance, 8)}`]
      : ["v = λ_1 w_1 + λ_2 w_2 + ...", "a = λ_1 a_1 + λ_2 a_2 + ...", "b = λ_1 b_1 + λ_2 b_2 + ...", `d = |v| = ${digits(answer.distance, 8)}`],
    numbers: { caption: "Answer (units of length)", columns: ["quantity", "value"], rows: [
      ...(more && end ? [{ cells: ["d, in A's frame", digits(answer.distance, 15)], mark: "winner" as const }, { cells: ["|v|, in the world", digits(end.upper, 15)], mark: "out" as const }]
        : [{ cells: ["distance", answer.distance!], mark: "winner" as const }]),
      { cells: ["normal", vector(answer.normal, 5)] }, { cells: ["on A", vector(a, 5 + more)] }, { cells: ["on B", vector(b, 5 + more)] }] },
    graph: bounds(list.length - 1),
    says: `Signed distance ${digits(answer.distance, 6)}.`,
    draw(d) {
      paint(d);
      if (around.length) drawIteration(d, { simplex: around, direction: [0, 0, 0], found: around[0] });
      else origin(d);
      drawDistance(d, answer, { look: { wide: true } });
      d.arrow(zero, add(zero, scale(answer.normal!, answer.distance!)), "touch", { wide: true, label: "d·n" });
    },
  });
  return steps;
}

const sources = [
  "E. Gilbert, D. Johnson, S. Keerthi: A fast procedure for computing the distance between complex objects in three-dimensional space, IEEE Journal of Robotics and Automation 4 (1988)",
  "G. van den Bergen: A fast and robust GJK implementation, Journal of Graphics Tools 4 (1999)",
];

const arms = { a: [1.9, 0], b: [1.8, 0] };
const planeState = (translation: Vec, rotation: number, b = convex([[-1.1, -0.5], [0.2, -0.9], [1, 0.1], [0.3, 0.9], [-0.8, 0.6]]), a = convex([[-1.3, -0.9], [0.9, -0.7], [1.3, 0.5], [-0.3, 1.1]])): State => ({
  q: { query: "distance", dimension: 2, a: { shape: a }, b: { shape: b, translation, rotation } },
});

/** The way by which the picture follows A, when it is far from the origin. */
const away = (q: Question): Vec => {
  const at = q.a.translation ?? [0, 0];
  return length(at) > 100 ? at.map((x) => 10 * Math.round(x / 10)) : [0, 0];
};

export const gjkPlane: Lesson = {
  id: "gjk", number: 7, title: "GJK in the plane", question: "How far apart are they, and why may we stop?",
  intro: "The algorithm of Gilbert, Johnson and Keerthi walks through the difference towards the origin. It works for everything that can name its " +
    "furthest point along a direction.",
  dimension: 2, view: (s) => ({ center: add([1.6, -2.2], away(s.q)), reach: 5.9 }), start: planeState([3.4, 1.1], 0.4),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b)],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps({ q }) {
    const zero = add(home, away(q)), far = length(away(q));
    return walk({ q, zero, more: far > 0 ? Math.floor(Math.log10(far)) : 0, origin: (d) => drawOrigin(d, zero), paint(d) {
      drawBodies(d, q);
      d.polygon((ask(q).trace.difference ?? []).map((p) => add(zero, sub(p.b, p.a).slice(0, 2))), "made", { fill: true, ghost: true });
    } });
  },
  tryThis: [
    { label: "Origin inside", note: "The shapes overlap: the simplex encloses O.", state: planeState([0.9, 0.6], 0.4) },
    { label: "Parallel sides", note: "Every point of a side is nearest; GJK takes one.", state: planeState([3.2, 0], 0, box(2, 2), box(2, 2)) },
    { label: "Thin shapes", note: "Two needles, one corner each.", state: planeState([3.5, 1], 0.6, box(3.4, 0.04), box(3.4, 0.04)) },
  ],
  wrong: [
    { label: "Origin on an edge", note: "The shapes touch: O lies on a side of the difference. A test against an absolute epsilon decides this differently at another scale; the library's tolerance follows from the shapes' sizes.", state: planeState([2, 0.3], 0, box(2, 2), box(2, 2)) },
    { label: "Very far away", note: "A million away from the origin. Numbers of the world have six digits less left for the shapes, and the steps, which use them, get the last digits wrong; in the frame of A none is lost.", state: { q: { ...planeState([1000003.2, 0.4], 0.3, box(2, 2), box(2, 2)).q, a: { shape: box(2, 2), translation: [1000000, 0] } } } },
  ],
  sources,
};

const spaceState = (translation: Vec, rotation: Vec): State => ({
  q: { query: "distance",
    a: { shape: convex([[-1, -0.7, -0.6], [1, -0.7, -0.6], [0, -0.6, 1.1], [0.1, 1, 0]]), translation: [-0.6, 0.7, 0] },
    b: { shape: { type: "cylinder", cylinder: { height: 1.4, radiusBottom: 0.6, radiusTop: 0.25 } }, translation, rotation } },
});
const armsSpace = { a: [1.5, 0, 0], b: [0, 1.2, 0] };
/** The place in space at which the origin of the difference is drawn. */
const homeSpace: Vec = [0.4, -2.6, 0];

/** The number of differences of points above which nobody waits for their hull in a drag. */
const mostDifferences = 2000;
interface Difference { of: string; points: Vec[] | null }
let sampled: Difference = { of: "", points: null };
/** Points of which the Minkowski difference of two bodies is the hull but for their translation, of curved ones as
 *  finely as the library draws them, and a text that names it; no points where they are too many. */
function differenceOf({ a, b }: Question): Difference {
  const [from, to] = [a, b!].map(({ shape, rotation }) => ({ shape, rotation })), of = JSON.stringify([from, to]);
  if (sampled.of !== of) {
    const [p, q] = [tessellated(from), tessellated(to)], few = p.length * q.length <= mostDifferences;
    sampled = { of, points: few ? q.flatMap((y) => p.map((x) => sub(y, x))) : null };
  }
  return sampled;
}
function drawDifference(d: Drawing, q: Question): void {
  const { of, points } = differenceOf(q), [from, to] = [q.a, q.b!].map(({ translation = [0, 0, 0] }) => translation);
  if (!points) return;
  const translation = add(homeSpace, sub(to, from));
  d.shape({ shape: convex(points), translation }, "made", { ghost: true, bare: true, made: `difference of ${of}` });
}

export const gjkSpace: Lesson = {
  id: "gjk-space", number: 7, title: "GJK in space", question: "What changes in space?",
  intro: "Nothing but the size of the simplex: four corners instead of three. Curved shapes need no triangles; they only have to name a furthest point.",
  dimension: 3, view: { center: [0.9, -0.95, 0], reach: 3.6 }, start: spaceState([1.9, 1, 0.2], quatAbout([0.3, 0.2, 1], 0.7)),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", armsSpace.a), moveHandle(s, "b"), turnHandle(s, "b", armsSpace.b)],
  drag: (s, id, to) => dragBody(s, id, to, armsSpace),
  steps: ({ q }) => walk({ q, zero: homeSpace, whole: differenceOf(q).points !== null, paint(d) {
    drawBodies(d, q);
    drawDifference(d, q);
  }, origin(d) {
    for (const axis of [[0.25, 0, 0], [0, 0.25, 0], [0, 0, 0.25]]) d.line(sub(homeSpace, axis), add(homeSpace, axis), "ink", { wide: true });
    d.text(homeSpace, "O", "ink");
  } }),
  tryThis: [
    { label: "They overlap", note: "The simplex becomes a tetrahedron around O.", state: spaceState([0.1, 0.9, 0.1], quatAbout([0.3, 0.2, 1], 0.7)) },
    { label: "A long way", note: "The rim is curved: the bounds close step by step.", state: spaceState([1.6, 1.9, 1.2], quatAbout([1, 0.2, 0.4], 1.3)) },
  ],
  wrong: [{ label: "Barely apart", note: "Close to touching the direction is a difference of nearly equal numbers. Watch how many iterations the last digits cost.", state: spaceState([0.85, 0.75, 0.05], quatAbout([0.3, 0.2, 1], 0.7)) }],
  sources: [...sources, "C. Ericson: Real-Time Collision Detection (2005), section 9.5"],
};
