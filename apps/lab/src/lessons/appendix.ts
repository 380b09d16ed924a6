import { answered, type graze, type Span } from "../graze.ts";
import { drawDistance, drawRay, endOf } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Handle } from "../parts/drawing.ts";
import { add, scale } from "../parts/vec.ts";
import { copy, pointsOf, type Question, type State, type Vec } from "../question.ts";
import { pairs as bounded, segment, type Pair } from "./appendix-pairs.ts";
import { dragBody, drawBodies, moveHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";
import { unboundedPairs } from "./unbounded-pairs.ts";

const pairs: Pair[] = [...bounded, ...unboundedPairs];
const isNever = ({ span: [from, to] }: Span): boolean => endOf(from) > endOf(to);
const arms = { a: [0.3, 0.9, 0], b: [0, 1.1, 0] };
const named = (value: string): Pair => pairs.find((p) => p.value === value)!;
const stateOf = (pair: Pair, q: Question = pair.q): State => ({ q: copy(q), choice: { pair: pair.value } });
/** A choice of another pair brings that pair's question. */
function present(state: State): { pair: Pair; q: Question } {
  const pair = pairs.find((p) => p.value === state.choice?.pair) ?? pairs[0];
  const same = state.q.query === pair.q.query && state.q.a.shape.type === pair.q.a.shape.type && state.q.b?.shape.type === pair.q.b?.shape.type
    && (state.q.a.shape.type !== "convex" || Boolean(state.q.b) === Boolean(pair.q.b));
  return { pair, q: same ? state.q : pair.q };
}
const example = (value: string, changed: Partial<Question>): State => stateOf(named(value), { ...named(value).q, ...changed });

export const appendix: Lesson = {
  id: "appendix", number: 14, title: "Points, lines, planes, rays, triangles", question: "How far, and where do they meet?",
  intro: "The small questions that everything else is made of. Choose a pair, drag its points.",
  dimension: 3, view: { center: [0.1, 0.7, 0], reach: 1.8 }, start: stateOf(pairs[0]),
  choices: [{ key: "pair", label: "Pair", options: pairs.map(({ value, label }) => ({ value, label })) }],
  handles(state): Handle[] {
    const { pair, q } = present(state), made: Handle[] = [];
    const planes = (["a", "b"] as const).filter((which) => pair.solve && q[which]?.shape.type === "plane");
    for (const which of planes) made.push(moveHandle({ q }, which), turnHandle({ q }, which, arms[which]));
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
    else if (/^(move|turn)-/.test(id)) return stateOf(pair, dragBody({ q }, id, to, arms).q);
    else pointsOf(q[id[0] as "a" | "b"]!.shape)[Number(id.slice(2))].splice(0, 3, ...to);
    return stateOf(pair, q);
  },
  asks(state) {
    const { pair, q } = present(state);
    return pair.solve?.(q).question ?? q;
  },
  steps(state) {
    const { pair, q } = present(state);
    const base: Step["draw"] = (d) => {
      drawBodies(d, q);
      if (q.point) d.point(q.point, "made", { wide: true, label: "x" });
      if (!q.ray) return;
      drawRay(d, q.ray as graze.Ray, null, { center: q.ray.origin, size: 3 });
      d.text(q.ray.origin, "ray", "made");
    };
    const title = `${pair.label[0].toUpperCase()}${pair.label.slice(1)}`;
    if (pair.solve) {
      const { title: found, text, formula, rows, says, extend, draw } = pair.solve(q);
      const whole: Step["draw"] = (d) => {
        base(d);
        extend?.(d);
      };
      return [{ title, text: pair.text, formula: pair.formula, says: `The pair ${pair.label}.`, draw: whole }, {
        title: found, text, formula, numbers: { caption: "Answer (units of length)", columns: ["quantity", "value"], rows }, says,
        draw(d) {
          whole(d);
          draw(d);
        },
      }];
    }
    const answer = answered(q), worked = pair.worked?.(q, answer) ?? [];
    const missed = answer.hit === false, spans = answer.trace.spans ?? [];
    const rows = q.query === "raycast"
      ? missed ? [{ cells: ["hit", "no"] }] : [{ cells: ["t", answer.t!], mark: "winner" as const }, { cells: ["point", vector(answer.point, 4)], key: "b" }, { cells: ["normal", vector(answer.normal, 4)] }]
      : [{ cells: ["distance", answer.distance!], mark: "winner" as const, key: "d" }, { cells: ["normal", vector(answer.normal, 4)], key: "n" },
        ...(answer.point ? [{ cells: ["nearest", vector(answer.point, 4)], key: "b" }]
          : [{ cells: ["on A", vector(answer.a as unknown as Vec, 4)], key: "a" }, { cells: ["on B", vector(answer.b as unknown as Vec, 4)], key: "b" }])];
    const steps: Step[] = [
      { title, text: pair.text, formula: [...pair.formula, ...worked], says: `The pair ${pair.label}.`, draw: base },
    ];
    spans.forEach((s, i) => steps.push({
      title: `Part of the shape: ${s.name}`,
      text: "The ray is inside of this half-space, or inside of this curved part, for the parameters of the span. It is inside the whole shape where it is inside all of them.",
      numbers: { caption: "Spans of the ray (units of length)", columns: ["part", "from", "to"], rows: spans.slice(0, i + 1).map((x, k) => ({ cells: [x.name, ...(isNever(x) ? ["never", ""] : x.span)], mark: k === i ? "now" as const : undefined })) },
      says: isNever(s) ? `${s.name}: never inside.` : `${s.name}: from ${digits(s.span[0], 4)} to ${digits(s.span[1], 4)}.`, draw: base,
    }));
    steps.push({
      title: missed ? "No hit" : "The answer",
      formula: worked,
      text: missed ? "No parameter of the ray lies in all spans." : `Found by ${answer.trace.method.replace(/gjk|epa/, (name) => name.toUpperCase())}.`,
      numbers: { caption: "Answer (units of length)", columns: ["quantity", "value"], rows },
      says: missed ? "The ray misses." : q.query === "raycast" ? `Hit after ${digits(answer.t, 5)}.` : `Distance ${digits(answer.distance, 5)}.`,
      draw(d) {
        base(d);
        if (missed) return;
        const { t, point, normal } = answer, to = point ?? (answer.b as unknown as Vec), look = { wide: true };
        if (q.ray) return drawRay(d, q.ray as graze.Ray, { t, point, normal } as graze.RayHit, { look, size: 7, points: () => ({ wide: true, key: "b" }) });
        drawDistance(d, { a: q.point ?? answer.a, b: to }, { look: { ...look, key: "d" }, points: (i) => ({ wide: true, key: "ab"[i] }) });
        if (normal) d.arrow(to, add(to, scale(normal, 0.6)), "axis", { label: "n", key: "n" });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Beyond the end", note: "The nearest point of the segment is its end.", state: example("point-segment", { point: [1.7, 1.5, 0.2] }) },
    { label: "The same without ends", note: "The line goes on, and so does t.", state: example("point-line", { point: [1.7, 1.5, 0.2] }) },
    { label: "A miss", note: "The ray passes beside the triangle.", state: example("ray-triangle", { ray: { origin: [1.6, 2, 0.9], direction: [0, -1, 0] } }) },
  ],
  wrong: [
    { label: "Parallel segments", note: "The two equations become one: many pairs of points are nearest. The answer is one of them, and the distance is right.", state: example("segment-segment", { b: segment([-1.3, 1.2, 0], [1.6, 1.6, 0.4]) }) },
    { label: "Parallel lines", note: "The product of the directions is zero, and dividing by its length gives not-a-number.", state: example("line-line", { b: segment([-1.3, 1.2, 0], [1.6, 1.6, 0.4]) }) },
    { label: "A ray in the plane", note: "The denominator is zero: the ray lies in the surface, starts in contact, and the answer is t = 0.", state: example("ray-plane", { ray: { origin: [-1.2, 0, 0], direction: [1, 0, 0] } }) },
    { label: "A point on an edge", note: "Distance zero: the direction to the nearest point does not exist, and the normal is that of the triangle.", state: example("point-triangle", { point: [0.2, 0, -0.7] }) },
  ],
  sources: ["C. Ericson: Real-Time Collision Detection (2005), sections 5.1 (nearest points) and 5.3 (lines and rays), 5.4.4 (two planes)", "S. Woop, C. Benthin, I. Wald: Watertight ray/triangle intersection, Journal of Computer Graphics Techniques 2 (2013)"],
};
