import { ask, type GjkStep } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, quatAbout, scale, sub } from "../parts/vec.ts";
import { box, convex, type Question, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";
import { drawOrigin, home, place } from "./minkowski.ts";

const region = (step: GjkStep, last: boolean, inside: boolean): string => {
  if (last && inside) return "the origin lies inside the simplex";
  return ["", "nearest is the corner itself", "nearest lies on the edge between two corners", "nearest lies within the triangle", "the origin is inside the tetrahedron"][step.simplex.length];
};

/** Steps of the trace, whatever the dimension: `paint` draws the situation, `spot` says where a support point is drawn. */
function walk(q: Question, paint: (d: Drawing) => void, spot: (s: GjkStep["found"]) => Vec, zero: Vec): Step[] {
  const answer = ask(q), list = answer.trace.gjk;
  const cut = (p: Vec): string => vector(p.slice(0, q.dimension ?? 3), 3);
  const inside = answer.distance! <= 0;
  const bounds = (at: number): Step["graph"] => ({
    caption: "bounds of the distance", at,
    series: [{ name: "at most", meaning: "touch", values: list.map((s) => s.upper) }, { name: "at least", meaning: "made", values: list.map((s) => s.lower) }],
  });
  const steps: Step[] = [{
    title: "One question to the origin",
    text: "How far is the difference B ⊖ A from the origin? GJK never builds it. It asks for support points, keeps at most " +
      `${q.dimension === 2 ? "three" : "four"} of them, a simplex, and each time looks from the simplex's nearest point towards the origin.`,
    says: "The two shapes and their difference.",
    draw: paint,
  }];
  list.forEach((s, i) => {
    const last = i === list.length - 1;
    const corners = s.simplex.map(spot);
    const foot = add(zero, scale(s.direction, s.upper));
    const done = last && (inside ? s.upper === 0 : true);
    steps.push({
      title: `Iteration ${i + 1}: ${["", "a point", "an edge", "a triangle", "a tetrahedron"][s.simplex.length]}`,
      text: `The simplex has ${s.simplex.length} corner${s.simplex.length > 1 ? "s" : ""}; ${region(s, done, inside)}. ` +
        (done && inside && s.upper === 0 ? "So the shapes overlap, and GJK is done: depth is a task for EPA."
          : `The search goes against n, towards the origin, and finds s. The plane through s bounds the distance from below, the nearest point from above. ` +
            (last ? (inside ? "The simplex now encloses the origin as soon as the new point is added." : "Both bounds agree: no point of the difference is nearer, and this is the distance.")
              : "They still differ: s joins the simplex.")),
      formula: [`"lower" = s*n <= d <= |v| = "upper"`, `${digits(s.lower, 6)} <= d <= ${digits(s.upper, 6)}`],
      numbers: {
        caption: "Corners of the simplex, and what was found", columns: ["", "of A", "of B", "b − a"],
        rows: [
          ...s.simplex.map((p, k) => ({ cells: [`w${k + 1}`, cut(p.a), cut(p.b), cut(sub(p.b, p.a))], key: `w${k}` })),
          { cells: ["s", cut(s.found.a), cut(s.found.b), cut(sub(s.found.b, s.found.a))], key: "s", mark: "now" as const },
        ],
      },
      graph: bounds(i),
      says: `Iteration ${i + 1}: the distance is between ${digits(s.lower, 4)} and ${digits(s.upper, 4)}.`,
      draw(d) {
        paint(d);
        if (corners.length > 2) d.polygon(corners.slice(0, 3), "axis", { wide: true });
        for (let k = 0; k < corners.length; k++)
          for (let l = k + 1; l < corners.length; l++) d.line(corners[k], corners[l], "axis", { wide: true });
        corners.forEach((p, k) => d.point(p, "axis", { wide: true, label: `w${k + 1}`, key: `w${k}` }));
        s.simplex.forEach((p, k) => {
          d.point(p.a, "a", { key: `w${k}` });
          d.point(p.b, "b", { key: `w${k}` });
        });
        if (s.upper === 0) return;
        d.arrow(foot, zero, "touch", { label: "v" });
        d.point(spot(s.found), "made", { wide: true, label: "s", key: "s" });
        d.point(s.found.a, "a", { wide: true, key: "s" });
        d.point(s.found.b, "b", { wide: true, key: "s" });
      },
    });
  });
  steps.push({
    title: inside ? "They overlap" : "The distance",
    text: inside ? `${list.length} iterations. The simplex that holds the origin is where EPA starts; the signed distance it finds is ${digits(answer.distance, 6)}.`
      : `${list.length} iterations. The nearest points of A and B are the corners' points weighted as the nearest point of the simplex is; their distance is ${digits(answer.distance, 8)}.`,
    formula: [inside ? "O in B ⊖ A" : "d = |b - a|", `d = ${digits(answer.distance, 8)}`],
    numbers: { caption: "Answer", columns: ["", "value"], rows: [
      { cells: ["distance", answer.distance!], mark: "winner" }, { cells: ["normal", vector(answer.normal, 5)] },
      { cells: ["on A", vector(answer.a as unknown as Vec, 5)] }, { cells: ["on B", vector(answer.b as unknown as Vec, 5)] }] },
    graph: bounds(list.length - 1),
    says: `Signed distance ${digits(answer.distance, 6)}.`,
    draw(d) {
      paint(d);
      d.line(answer.a as unknown as Vec, answer.b as unknown as Vec, "touch", { wide: true });
      d.point(answer.a as unknown as Vec, "touch");
      d.point(answer.b as unknown as Vec, "touch");
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

export const gjkPlane: Lesson = {
  id: "gjk", number: 7, title: "GJK in the plane", question: "How far apart are they, and why may we stop?",
  intro: "The algorithm of Gilbert, Johnson and Keerthi walks through the difference towards the origin. It works for everything that can name its " +
    "furthest point along a direction.",
  dimension: 2, view: { center: [1.2, -2], reach: 5.2 }, start: planeState([3.4, 1.1], 0.4),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b)],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps: (state) => walk(state.q, (d) => {
    drawBodies(d, state.q);
    d.polygon((ask(state.q).trace.difference ?? []).map(place), "made", { fill: true, ghost: true });
    drawOrigin(d);
  }, place, home),
  tryThis: [
    { label: "Origin inside", note: "The shapes overlap: the simplex encloses O.", state: planeState([0.9, 0.6], 0.4) },
    { label: "Parallel sides", note: "Every point of a side is nearest; GJK takes one.", state: planeState([3.2, 0], 0, box(2, 2), box(2, 2)) },
    { label: "Thin shapes", note: "Two needles, one corner each.", state: planeState([1.2, 2.2], 0.9, box(3.4, 0.04), box(3.4, 0.04)) },
  ],
  wrong: [
    { label: "Origin on an edge", note: "The shapes touch: upper and lower bound are zero or nearly so. A test against an absolute epsilon decides this differently at another scale; the library's tolerance follows from the shapes' sizes.", state: planeState([2, 0.3], 0, box(2, 2), box(2, 2)) },
    { label: "Very far away", note: "At a distance of a million the numbers of A and B have six digits less to describe the shapes. Work in a frame of the pair loses none.", state: { q: { ...planeState([1000003.2, 0.4], 0.3, box(2, 2), box(2, 2)).q, a: { shape: box(2, 2), translation: [1000000, 0] } } } },
  ],
  sources,
};

const spaceState = (translation: Vec, rotation: Vec): State => ({
  q: { query: "distance",
    a: { shape: convex([[-1, -0.7, -0.6], [1, -0.7, -0.6], [0, -0.6, 1.1], [0.1, 1, 0]]), translation: [-0.6, 0.7, 0] },
    b: { shape: { type: "cylinder", cylinder: { height: 1.4, radiusBottom: 0.6, radiusTop: 0.25 } }, translation, rotation } },
});
const armsSpace = { a: [1.5, 0, 0], b: [0, 1.2, 0] };
/** Where the origin of the difference is drawn in space. */
const homeSpace: Vec = [0.4, -2.6, 0];

export const gjkSpace: Lesson = {
  id: "gjk-space", number: 7, title: "GJK in space", question: "What changes in space?",
  intro: "Nothing but the size of the simplex: four corners instead of three. Curved shapes need no triangles; they only have to name a furthest point.",
  dimension: 3, view: { center: [0.8, -0.7, 0], reach: 3.2 }, start: spaceState([1.9, 1, 0.2], quatAbout([0.3, 0.2, 1], 0.7)),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", armsSpace.a), moveHandle(s, "b"), turnHandle(s, "b", armsSpace.b)],
  drag: (s, id, to) => dragBody(s, id, to, armsSpace),
  steps: (state) => walk(state.q, (d) => {
    drawBodies(d, state.q);
    for (const axis of [[0.25, 0, 0], [0, 0.25, 0], [0, 0, 0.25]]) d.line(sub(homeSpace, axis), add(homeSpace, axis), "ink", { wide: true });
    d.text(homeSpace, "O", "ink");
  }, (s) => add(homeSpace, sub(s.b, s.a)), homeSpace),
  tryThis: [
    { label: "They overlap", note: "The simplex becomes a tetrahedron around O.", state: spaceState([0.1, 0.9, 0.1], quatAbout([0.3, 0.2, 1], 0.7)) },
    { label: "A long way", note: "The rim is curved: the bounds close step by step.", state: spaceState([1.6, 1.9, 1.2], quatAbout([1, 0.2, 0.4], 1.3)) },
  ],
  wrong: [{ label: "Barely apart", note: "Close to touching the direction is a difference of nearly equal numbers. Watch how many iterations the last digits cost.", state: spaceState([0.85, 0.75, 0.05], quatAbout([0.3, 0.2, 1], 0.7)) }],
  sources: [...sources, "C. Ericson: Real-Time Collision Detection (2005), section 9.5"],
};
