import { ask, type graze } from "../graze.ts";
import { drawDistance, drawRay } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Handle } from "../parts/drawing.ts";
import { add, scale } from "../parts/vec.ts";
import { convex, copy, plane, pointsOf, triangle, type Question, type State, type Vec } from "../question.ts";
import { drawBodies, type Lesson, type Step } from "./lesson.ts";

interface Pair {
  value: string;
  label: string;
  q: Question;
  text: string;
  formula: string[];
}
const flat: Vec[] = [[-1, 0, -0.8], [1.4, 0, -0.6], [0.1, 0.2, 1.2]];
const pairs: Pair[] = [
  { value: "point-line", label: "point, segment", q: { query: "closest", a: { shape: convex([[-1.4, 0.2, 0], [1.5, 0.6, 0.4]]) }, point: [0.4, 1.7, 0.6] },
    text: "Project the point on the line, and clamp the parameter to the ends of the segment.", formula: ["t = frac((x - p)*u, u*u)", "0 <= t <= 1", "d = |x - p - t u|"] },
  { value: "point-plane", label: "point, plane", q: { query: "closest", a: { shape: plane() }, point: [0.5, 1.2, 0.3] },
    text: "Put the point into the plane's equation: the signed distance. Go back by it along the normal and you are on the plane.", formula: ["d = n*x - w", "x' = x - d n"] },
  { value: "point-triangle", label: "point, triangle", q: { query: "closest", a: { shape: triangle(...flat) }, point: [1.2, 1.2, 0.8] },
    text: "Seven regions: three corners, three edges, the face. Which one the point is over is decided by scalar products with the edges, without a projection.", formula: ["x = u a + v b + w c", "u + v + w = 1"] },
  { value: "line-line", label: "segment, segment", q: { query: "distance", a: { shape: convex([[-1.4, 0.2, 0], [1.5, 0.6, 0.4]]) }, b: { shape: convex([[0.2, 1.2, -1.2], [0.6, 1.5, 1.2]]) } },
    text: "The shortest connection is perpendicular to both lines: two equations for two parameters. Where one leaves its segment it is clamped and the other follows.", formula: ["(p - q + s u - t v)*u = 0", "(p - q + s u - t v)*v = 0"] },
  { value: "ray-plane", label: "ray, plane", q: { query: "raycast", a: { shape: plane() }, ray: { origin: [-1.2, 1.6, 0.4], direction: [1, -0.8, 0] } },
    text: "Put the ray's point into the plane's equation and solve for t. A ray along the plane never hits: the denominator is zero.", formula: ["t = frac(w - n*o, n*u)"] },
  { value: "ray-triangle", label: "ray, triangle", q: { query: "raycast", a: { shape: triangle(...flat) }, ray: { origin: [0.3, 2, 0.3], direction: [0, -1, -0.1] } },
    text: "First the plane of the triangle, then three signs: on which side of each edge does the ray pass? Signs from the ray's own view are the same for both neighbours of an edge, so nothing slips through between them.", formula: ["t = frac(n*(a - o), n*u)", "u*((b - o) × (a - o)) >= 0"] },
  { value: "ray-sphere", label: "ray, ball", q: { query: "raycast", a: { shape: { type: "sphere", sphere: { radius: 0.9 } } }, ray: { origin: [-2, 1.2, 0.4], direction: [1, -0.45, 0] } },
    text: "A quadratic equation. Its discriminant says whether there is a hit, its smaller root is the entry.", formula: ["(o + t u)*(o + t u) = r^2"] },
  { value: "triangle-triangle", label: "triangle, triangle", q: { query: "distance", a: { shape: triangle(...flat) }, b: { shape: triangle([-0.4, 0.6, 0.4], [1.2, 1.4, 0.2], [0.2, 1.6, -0.9]) } },
    text: "Apart, the nearest points are a corner and a face or two edges: nine and six pairs. Overlapping, an edge of one passes through the other.", formula: ["d = min |b - a|"] },
];
const stateOf = (pair: Pair, q: Question = pair.q): State => ({ q: copy(q), choice: { pair: pair.value } });
/** A choice of another pair brings that pair's question. */
function present(state: State): { pair: Pair; q: Question } {
  const pair = pairs.find((p) => p.value === state.choice?.pair) ?? pairs[0];
  const same = state.q.query === pair.q.query && state.q.a.shape.type === pair.q.a.shape.type && state.q.b?.shape.type === pair.q.b?.shape.type
    && (state.q.a.shape.type !== "convex" || Boolean(state.q.b) === Boolean(pair.q.b));
  return { pair, q: same ? state.q : pair.q };
}

export const appendix: Lesson = {
  id: "appendix", number: 14, title: "Points, lines, planes, rays, triangles", question: "How far, and where do they meet?",
  intro: "The small questions that everything else is made of. Choose a pair, drag its points.",
  dimension: 3, view: { center: [0.1, 0.7, 0], reach: 1.8 }, start: stateOf(pairs[0]),
  choices: [{ key: "pair", label: "Pair", options: pairs.map(({ value, label }) => ({ value, label })) }],
  handles(state): Handle[] {
    const { q } = present(state), made: Handle[] = [];
    for (const which of ["a", "b"] as const)
      if (q[which] && ["convex", "triangle"].includes(q[which]!.shape.type))
        pointsOf(q[which]!.shape).forEach((at, i) => made.push({ id: `${which}-${i}`, label: `Point ${i + 1} of ${which.toUpperCase()}`, kind: "size", meaning: which, at }));
    if (q.point) made.push({ id: "point", label: "The point", kind: "size", meaning: "made", at: q.point });
    if (q.ray) made.push({ id: "origin", label: "Origin of the ray", kind: "size", meaning: "made", at: q.ray.origin },
      { id: "direction", label: "Direction of the ray", kind: "turn", meaning: "made", at: add(q.ray.origin, q.ray.direction) });
    return made;
  },
  drag(state, id, to) {
    const { pair, q: now } = present(state), q = copy(now);
    if (id === "point") q.point = to;
    else if (id === "origin") q.ray!.origin = to;
    else if (id === "direction") q.ray!.direction = to.map((x, i) => x - q.ray!.origin[i]);
    else pointsOf(q[id[0] as "a" | "b"]!.shape)[Number(id.slice(2))].splice(0, 3, ...to);
    return stateOf(pair, q);
  },
  asks: (state) => present(state).q,
  steps(state) {
    const { pair, q } = present(state), answer = ask(q);
    if (answer.error) throw new Error(answer.error);
    const base: Step["draw"] = (d) => {
      drawBodies(d, q);
      if (q.point) d.point(q.point, "made", { wide: true, label: "x" });
      if (!q.ray) return;
      drawRay(d, q.ray as graze.Ray, null, { center: q.ray.origin, size: 3 });
      d.text(q.ray.origin, "ray", "made");
    };
    const missed = answer.hit === false, spans = answer.trace.spans ?? [];
    const rows = q.query === "raycast"
      ? missed ? [{ cells: ["hit", "no"] }] : [{ cells: ["t", answer.t!], mark: "winner" as const }, { cells: ["point", vector(answer.point, 4)] }, { cells: ["normal", vector(answer.normal, 4)] }]
      : [{ cells: ["distance", answer.distance!], mark: "winner" as const }, { cells: ["normal", vector(answer.normal, 4)] },
        ...(answer.point ? [{ cells: ["nearest", vector(answer.point, 4)] }] : [{ cells: ["on A", vector(answer.a as unknown as Vec, 4)] }, { cells: ["on B", vector(answer.b as unknown as Vec, 4)] }])];
    const steps: Step[] = [
      { title: `${pair.label[0].toUpperCase()}${pair.label.slice(1)}`, text: pair.text, formula: pair.formula, says: `The pair ${pair.label}.`, draw: base },
    ];
    spans.forEach((s, i) => steps.push({
      title: `Part of the shape: ${s.name}`,
      text: "The ray is inside of this half-space, or inside of this curved part, for the parameters of the span. It is inside the whole shape where it is inside all of them.",
      numbers: { caption: "Spans of the ray", columns: ["part", "from", "to"], rows: spans.slice(0, i + 1).map((x, k) => ({ cells: [x.name, x.span[0], x.span[1]], mark: k === i ? "now" as const : undefined })) },
      says: `${s.name}: from ${digits(s.span[0], 4)} to ${digits(s.span[1], 4)}.`, draw: base,
    }));
    steps.push({
      title: missed ? "No hit" : "The answer",
      text: missed ? "No parameter of the ray lies in all spans." : `Found by ${answer.trace.method.replace(/gjk|epa/, (name) => name.toUpperCase())}.`,
      numbers: { caption: "Answer", columns: ["quantity", "value"], rows },
      says: missed ? "The ray misses." : q.query === "raycast" ? `Hit after ${digits(answer.t, 5)}.` : `Distance ${digits(answer.distance, 5)}.`,
      draw(d) {
        base(d);
        if (missed) return;
        const { t, point, normal } = answer, to = point ?? (answer.b as unknown as Vec), look = { wide: true };
        if (q.ray) return drawRay(d, q.ray as graze.Ray, { t, point, normal } as graze.RayHit, { look, size: 7 });
        drawDistance(d, { a: q.point ?? answer.a, b: to }, { look });
        if (normal) d.arrow(to, add(to, scale(normal, 0.6)), "axis", { label: "n" });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Beyond the end", note: "The nearest point of the segment is its end.", state: stateOf(pairs[0], { ...pairs[0].q, point: [1.7, 1.5, 0.2] }) },
    { label: "A miss", note: "The ray passes beside the triangle.", state: stateOf(pairs[5], { ...pairs[5].q, ray: { origin: [1.6, 2, 0.9], direction: [0, -1, 0] } }) },
  ],
  wrong: [
    { label: "Parallel lines", note: "The two equations become one: many pairs of points are nearest. The answer is one of them, and the distance is right.", state: stateOf(pairs[3], { ...pairs[3].q, b: { shape: convex([[-1.3, 1.2, 0], [1.6, 1.6, 0.4]]) } }) },
    { label: "A ray in the plane", note: "The denominator is zero: the ray lies in the surface, starts in contact, and the answer is t = 0.", state: stateOf(pairs[4], { ...pairs[4].q, ray: { origin: [-1.2, 0, 0], direction: [1, 0, 0] } }) },
    { label: "A point on an edge", note: "Distance zero: the direction to the nearest point does not exist, and the normal is that of the triangle.", state: stateOf(pairs[2], { ...pairs[2].q, point: [0.2, 0, -0.7] }) },
  ],
  sources: ["C. Ericson: Real-Time Collision Detection (2005), chapter 5", "S. Woop, C. Benthin, I. Wald: Watertight ray/triangle intersection, Journal of Computer Graphics Techniques 2 (2013)"],
};
