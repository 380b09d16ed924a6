import { ask, type EpaStep, type Support, type Trace } from "../graze.ts";
import { drawDistance, drawTrace } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, cross, dot, quatAbout, scale, sub, unit } from "../parts/vec.ts";
import { box, convex, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";
import { drawOrigin, home, place } from "./minkowski.ts";

const arms = { a: [1.9, 0], b: [1.8, 0] };
const situation = (translation: Vec, rotation: number, a = convex([[-1.3, -0.9], [0.9, -0.9], [1.4, 0.3], [0.2, 1.2], [-1, 0.8]]), b = convex([[-1.1, -0.5], [0.2, -0.9], [1, 0.1], [0.3, 0.9], [-0.8, 0.6]])): State => ({
  q: { query: "distance", dimension: 2, a: { shape: a }, b: { shape: b, translation, rotation } },
});

const bounds = (list: EpaStep[], at: number): Step["graph"] => ({
  caption: "bounds of the depth", at,
  series: [{ name: "at least", meaning: "made", values: list.map((s) => s.faceDepth) }, { name: "at most", meaning: "touch", values: list.map((s) => s.foundDepth) }],
});

/** The proof of a step. The way out of B ⊖ A goes against the normal, which points from A to B. */
function explain(s: EpaStep, last: boolean, flat: boolean): string {
  const [face, wall] = flat ? ["side", "line"] : ["triangle", "plane"];
  return `The ${face} nearest to O is ${digits(s.faceDepth, 5)} away. The polytope lies within the difference, so no way out is shorter. ` +
    `Across that ${face}, away from O, the difference reaches as far as s: none of it lies beyond the ${wall} there, ${digits(s.foundDepth, 5)} from O, so one way out is that long. ` +
    (last ? `Both agree: the ${face} lies on the boundary of the difference, and this is the depth.`
      : flat ? "s is not on the side: it becomes a corner, and two sides take the place of this one."
        : "s becomes a corner: every triangle that s sees from outside goes, and new ones from the rim of the hole to s close it.");
}

export const epaPlane: Lesson = {
  id: "epa", number: 8, title: "EPA", question: "They overlap: how deep, and which way out?",
  intro: "The expanding polytope algorithm starts with GJK's last simplex, which holds the origin, and lets it grow to the boundary of the difference, " +
    "always where that is nearest.",
  dimension: 2, view: { center: [1.2, -1.8], reach: 5.6 }, start: situation([1.2, 0.7], 0.4),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b)],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state, answer = ask(q), list = answer.trace.epa;
    const difference = (answer.trace.difference ?? []).map(place);
    const apart = answer.distance! > 0;
    const steps: Step[] = [{
      title: "The way out of the difference",
      text: apart ? "The shapes are apart: GJK answers and there is nothing to do for EPA. Move B into A."
        : "The origin is inside. The depth is the distance from the origin to the boundary of the difference, which nobody has built. Its sides come up one after another.",
      says: apart ? "Apart." : "The origin lies inside the difference.",
      draw(d) {
        drawBodies(d, q);
        d.polygon(difference, "made", { fill: true, ghost: true });
        drawOrigin(d);
      },
    }];
    list.forEach((s, i) => {
      const last = i === list.length - 1, polygon = (s.polygon ?? []).map(place);
      steps.push({
        title: `Step ${i + 1}: ${polygon.length} sides`,
        text: explain(s, last, true),
        formula: ['"to the side" <= "depth" <= "to s"', `${digits(s.faceDepth, 6)} <= "depth" <= ${digits(s.foundDepth, 6)}`],
        numbers: { caption: "The polytope (units of length)", columns: ["step", "sides", "at least", "at most"],
          rows: list.slice(0, i + 1).map((t, k) => ({ cells: [String(k + 1), (t.polygon ?? []).length, t.faceDepth, t.foundDepth], mark: k === i ? "now" as const : undefined })) },
        graph: bounds(list, i),
        says: `Step ${i + 1}: the depth is between ${digits(s.faceDepth, 4)} and ${digits(s.foundDepth, 4)}.`,
        draw(d) {
          drawBodies(d, q);
          d.polygon(difference, "made", { fill: true, ghost: true });
          const out = scale(s.normal.slice(0, 2), -1), at = (t: number): Vec => add(home, scale(out, t)), side = [-out[1], out[0]];
          const off = (k: number): number => Math.abs(dot(sub(polygon[k % polygon.length], home), out) - s.faceDepth);
          const nearest = polygon.map((_, k) => k).reduce((best, k) => (off(k) + off(k + 1) < off(best) + off(best + 1) ? k : best), 0);
          d.line(polygon[nearest], polygon[(nearest + 1) % polygon.length], "axis", { wide: true });
          polygon.forEach((p) => d.point(p, "axis"));
          d.line(at(s.faceDepth), at(s.foundDepth), "touch", { dashed: true });
          d.line(add(at(s.foundDepth), scale(side, 2)), add(at(s.foundDepth), scale(side, -2)), "touch", { dashed: true });
          const joined = (list[i + 1]?.polygon ?? []).map(place).find((p) => !polygon.some((w) => w[0] === p[0] && w[1] === p[1]));
          drawTrace(d, { epa: [s] }, { by: home, points: (k) => ({ wide: true, label: k === 1 ? "s" : undefined }),
            as: { b: "axis", gap: "made", normal: "ink", contact: joined ? "touch" : null } });
        },
      });
    });
    if (!apart) steps.push({
      title: "Depth and normal",
      text: `${list.length} steps. O's way out to the nearest side is the depth; n points the other way, from A to B, and B moved by the depth along n touches A (dashed). The deepest points are those of the side's two corners, weighted as the foot of the way is.`,
      formula: [`d = ${digits(answer.distance, 8)}`, `n = [${answer.normal!.map((x) => digits(x, 5)).join(", ")}]`],
      graph: bounds(list, Math.max(0, list.length - 1)),
      says: `Depth ${digits(-answer.distance!, 6)}.`,
      draw(d) {
        drawBodies(d, q);
        d.polygon(difference, "made", { fill: true });
        drawTrace(d, { difference: list.at(-1)?.polygon ?? [] }, { by: home, as: { ruledOut: "axis" } });
        d.arrow(home, add(home, scale(answer.normal!, answer.distance!)), "touch", { wide: true, label: "d·n" });
        d.shape({ ...q.b!, translation: sub(q.b!.translation!, scale(answer.normal!, answer.distance!)) }, "b", { ghost: true, dashed: true });
        drawDistance(d, answer, { look: { wide: true } });
        drawOrigin(d);
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Barely touching", note: "The origin is close to the boundary: few steps.", state: situation([2.2, 0.7], 0.4) },
    { label: "Deep", note: "Centre in centre: many sides are almost equally near.", state: situation([0.1, 0.05], 0.4) },
  ],
  wrong: [{ label: "A flat start", note: "The origin lies on an edge of the first simplex: a polytope that starts flat has no inside and no outward normal. It has to be given volume first.", state: situation([0.5, 0.5], 0, box(2, 2), box(2, 2)) }],
  sources: ["G. van den Bergen: Proximity queries and penetration depth computation on 3D game objects, Game Developers Conference 2001",
    "S. Cameron: Enhancing GJK: computing minimum and penetration distances between convex polyhedra, ICRA 1997"],
};

const armsSpace = { a: [1.5, 0, 0], b: [0, 1.2, 0] }, homeSpace: Vec = [0, -2.6, 0];
const spaceState = (translation: Vec, rotation: Vec): State => ({
  q: { query: "distance", a: { shape: { type: "ellipsoid", ellipsoid: { radii: [1.1, 0.7, 0.8] } } },
    b: { shape: { type: "cylinder", cylinder: { height: 1.2, radiusBottom: 0.6, radiusTop: 0.6 } }, translation, rotation } },
});

const at = (p: Support): Vec => add(homeSpace, sub(p.b, p.a));
/** The number of corners with which the polytope began: the trace lists them in the order in which they came, one for
 *  each step after those, but for a last step that found a corner which was there. Nothing when they do not reach as
 *  far as the steps say. */
function beginning({ epa, polytope }: Trace): number | null {
  const points = polytope?.points ?? [];
  const fits = (s: EpaStep, p: Support): boolean => Math.abs(dot(sub(p.b, p.a), scale(s.normal, -1)) - s.foundDepth) <= 1e-9 * Math.max(s.foundDepth, s.faceDepth);
  for (const found of [epa.length, epa.length - 1]) {
    const first = points.length - found;
    if (first > 3 && epa.slice(0, found).every((s, i) => fits(s, points[first + i]))) return first;
  }
  return null;
}
/** The hull of corners, as the library builds and draws it. */
function drawHull(d: Drawing, corners: Support[], ghost = false): void {
  d.shape({ shape: convex(corners.map((p) => sub(p.b, p.a))), translation: homeSpace }, "made", { ghost });
}
function drawFace(d: Drawing, s: EpaStep, corners: Support[]): void {
  const out = scale(s.normal, -1), reach = (t: number): Vec => add(homeSpace, scale(out, t));
  const face = corners.filter((p) => Math.abs(dot(sub(p.b, p.a), out) - s.faceDepth) <= 1e-9 * s.foundDepth);
  if (face.length === 3) d.polygon(face.map(at), "axis", { wide: true });
  d.line(reach(s.faceDepth), reach(s.foundDepth), "touch", { wide: true });
  const one = unit(cross(out, Math.abs(out[1]) < 0.8 ? [0, 1, 0] : [1, 0, 0])), other = cross(out, one);
  d.polygon([[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => add(reach(s.foundDepth), add(scale(one, 0.6 * x), scale(other, 0.6 * y)))), "touch", { ghost: true });
}

export const epaSpace: Lesson = {
  id: "epa-space", number: 8, title: "EPA in space", question: "How does a polytope find a curved boundary?",
  intro: "In space the polygon becomes a polytope of triangles. On curved shapes it never arrives, but each step brings the two bounds closer.",
  dimension: 3, view: { center: [0.6, -1.1, 0], reach: 3.3, from: [0.3, 0.35, 1] }, start: spaceState([0.8, 0.5, 0.3], quatAbout([0.3, 0.2, 1], 0.7)),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", armsSpace.a), moveHandle(s, "b"), turnHandle(s, "b", armsSpace.b)],
  drag: (s, id, to) => dragBody(s, id, to, armsSpace),
  steps(state) {
    const { q } = state, answer = ask(q), list = answer.trace.epa, points = answer.trace.polytope?.points ?? [];
    const first = beginning(answer.trace);
    const paint = (d: Drawing): void => drawBodies(d, q);
    const origin = (d: Drawing): void => d.point(homeSpace, "ink", { wide: true, label: "O" });
    const steps: Step[] = [{
      title: "The tetrahedron around the origin",
      text: list.length ? `GJK ends with a simplex that holds O. Grown to a tetrahedron where it is flat, it is the polytope that EPA begins with: below, in the place of the difference, which nobody builds. ${list.length} steps follow.` +
        (first === null ? " The picture has the polytope as it is at the end, and of each step its direction." : "")
        : "The shapes are apart, or so shallow that another routine answers: move B deeper into A.",
      says: "Two curved shapes and the polytope within their difference.",
      draw(d) {
        paint(d);
        origin(d);
        if (points.length) drawHull(d, points.slice(0, first ?? points.length));
      },
    }];
    list.forEach((s, i) => steps.push({
      title: `Step ${i + 1}: on to ${s.faces} triangles`, text: explain(s, i === list.length - 1, false),
      formula: ['"to the triangle" <= "depth" <= "to s"', `${digits(s.faceDepth, 8)} <= "depth" <= ${digits(s.foundDepth, 8)}`, `"difference" = ${digits(s.foundDepth - s.faceDepth, 3)}`],
      graph: bounds(list, i),
      numbers: { caption: "Bounds of the depth (units of length)", columns: ["step", "faces", "at least", "at most"], rows: list.slice(Math.max(0, i - 9), i + 1).map((t, k, l) => ({ cells: [String(Math.max(0, i - 9) + k + 1), t.faces, t.faceDepth, t.foundDepth], mark: k === l.length - 1 ? "now" as const : undefined })) },
      says: `Step ${i + 1}: depth between ${digits(s.faceDepth, 5)} and ${digits(s.foundDepth, 5)}; normal ${vector(s.normal, 3)}.`,
      draw(d) {
        paint(d);
        const before = points.slice(0, first === null ? points.length : first + i);
        drawHull(d, before);
        drawFace(d, s, before);
        const found = first === null ? null : points[first + i] ?? null;
        drawTrace(d, { epa: [{ ...s, found: found ?? undefined }] }, { by: homeSpace, look: { wide: true },
          points: (k) => ({ wide: true, label: k === 1 ? "s" : undefined }), as: { gap: "made", normal: "ink", contact: found ? "touch" : null } });
        if (!found) return;
        d.point(found.a, "a", { wide: true });
        d.point(found.b, "b", { wide: true });
      },
    }));
    if (list.length && answer.distance! <= 0) steps.push({
      title: "Depth and normal",
      text: `${list.length} steps, ${points.length} corners, most of them where the boundary is nearest to O. That way out, turned round, is the normal n, from A to B. B moved by the depth along it touches A. ` +
        "On curved shapes the bounds never meet; what is left between them is below the tolerance.",
      formula: [`d = ${digits(answer.distance, 8)}`, `n = [${answer.normal!.map((x) => digits(x, 4)).join(", ")}]`],
      graph: bounds(list, list.length - 1),
      numbers: { caption: "Answer (units of length)", columns: ["quantity", "value"], rows: [{ cells: ["distance", answer.distance!], mark: "winner" }, { cells: ["normal", vector(answer.normal, 4)] },
        { cells: ["on A", vector(answer.a as unknown as Vec, 4)] }, { cells: ["on B", vector(answer.b as unknown as Vec, 4)] }] },
      says: `Depth ${digits(-answer.distance!, 6)}, normal ${vector(answer.normal, 3)}.`,
      draw(d) {
        paint(d);
        origin(d);
        drawHull(d, points);
        d.arrow(homeSpace, add(homeSpace, scale(answer.normal!, answer.distance!)), "touch", { wide: true, label: "d·n" });
        d.shape({ ...q.b!, translation: sub(q.b!.translation!, scale(answer.normal!, answer.distance!)) }, "b", { ghost: true });
        drawDistance(d, answer, { look: { wide: true } });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Barely touching", note: "The origin is close to the boundary: fewer steps than deep inside.", state: spaceState([1.15, 0.75, 0.3], quatAbout([0.3, 0.2, 1], 0.7)) },
    { label: "Flat on flat", note: "All faces of the difference are flat: after a few steps the bounds meet exactly, and the last finds no new corner.", state: { q: { query: "distance",
      a: { shape: box(1.8, 1.2, 1.4) }, b: { shape: convex([[-0.8, -0.6, -0.7], [0.8, -0.6, -0.7], [0, 0.9, 0], [-0.8, -0.6, 0.7], [0.8, -0.6, 0.7]]), translation: [0.9, 0.7, 0.2], rotation: quatAbout([0.2, 1, 0.4], 0.5) } } } },
    { label: "Deeper", note: "More faces are nearly as near as the nearest.", state: spaceState([0.2, 0.1, 0.1], quatAbout([0.3, 0.2, 1], 0.7)) },
  ],
  wrong: [{ label: "Same centre, same axis", note: "All directions round the axis are equally good: the polytope grows everywhere before it may stop.", state: spaceState([0, 0, 0], [0, 0, 0, 1]) }],
  sources: epaPlane.sources,
};
