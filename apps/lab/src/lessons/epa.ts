import { ask, type EpaStep } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import { add, quatAbout, scale, sub } from "../parts/vec.ts";
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

function explain(s: EpaStep, last: boolean): string {
  return `The side nearest to the origin is ${digits(s.faceDepth, 5)} away. Along its normal the difference reaches to ${digits(s.foundDepth, 5)}. ` +
    (last ? "Both agree: the side lies on the boundary of the difference, and this is the depth."
      : "The difference reaches further, so the side is not on its boundary: the new point opens it into two.");
}

export const epaPlane: Lesson = {
  id: "epa", number: 8, title: "EPA", question: "They overlap: how deep, and which way out?",
  intro: "The expanding polytope algorithm starts with GJK's last simplex, which holds the origin, and lets it grow to the boundary of the difference, " +
    "always where that is nearest.",
  dimension: 2, view: { center: [1.2, -2], reach: 5.2 }, start: situation([1.2, 0.7], 0.4),
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
        text: explain(s, last),
        formula: ['"face" <= d <= "found"', `${digits(s.faceDepth, 6)} <= d <= ${digits(s.foundDepth, 6)}`],
        numbers: { caption: "The polytope", columns: ["step", "sides", "nearest side", "found"],
          rows: list.slice(0, i + 1).map((t, k) => ({ cells: [String(k + 1), (t.polygon ?? []).length, t.faceDepth, t.foundDepth], mark: k === i ? "now" as const : undefined })) },
        graph: bounds(list, i),
        says: `Step ${i + 1}: the depth is between ${digits(s.faceDepth, 4)} and ${digits(s.foundDepth, 4)}.`,
        draw(d) {
          drawBodies(d, q);
          d.polygon(difference, "made", { fill: true, ghost: true });
          d.polygon(polygon, "axis", {});
          polygon.forEach((p) => d.point(p, "axis"));
          d.arrow(home, add(home, scale(s.normal, s.faceDepth)), "made", { wide: true });
          d.line(add(home, scale(s.normal, s.faceDepth)), add(home, scale(s.normal, s.foundDepth)), "touch", { dashed: true });
          const side = [-s.normal[1], s.normal[0]], reach = add(home, scale(s.normal, s.foundDepth));
          d.line(add(reach, scale(side, 1)), add(reach, scale(side, -1)), "touch", { dashed: true });
          drawOrigin(d);
        },
      });
    });
    if (!apart) steps.push({
      title: "Depth and normal",
      text: `${list.length} steps. Moving B by the depth along the normal parts the shapes; the deepest pair of points follows from the side's two corners.`,
      formula: [`d = ${digits(answer.distance, 8)}`, `n = [${answer.normal!.map((x) => digits(x, 5)).join(", ")}]`],
      graph: bounds(list, Math.max(0, list.length - 1)),
      says: `Depth ${digits(-answer.distance!, 6)}.`,
      draw(d) {
        drawBodies(d, q);
        d.polygon(difference, "made", { fill: true });
        d.arrow(home, add(home, scale(answer.normal!, answer.distance!)), "touch", { wide: true, label: "d·n" });
        d.shape({ ...q.b!, translation: sub(q.b!.translation!, scale(answer.normal!, answer.distance!)) }, "b", { ghost: true, dashed: true });
        d.line(answer.a as unknown as Vec, answer.b as unknown as Vec, "touch", { wide: true });
        drawOrigin(d);
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Barely touching", note: "The origin is close to the boundary: few steps.", state: situation([2.2, 0.7], 0.4) },
    { label: "Deep", note: "Centre in centre: many sides are almost equally near.", state: situation([0.1, 0.05], 0.4) },
  ],
  wrong: [{ label: "A flat start", note: "The origin lies on an edge of the first simplex: a polytope that starts flat has no inside and no outward normal. It has to be given volume first.", state: situation([1, 0], 0, box(2, 2), box(2, 2)) }],
  sources: ["G. van den Bergen: Proximity queries and penetration depth computation on 3D game objects, Game Developers Conference 2001",
    "S. Cameron: Enhancing GJK: computing minimum and penetration distances between convex polyhedra, ICRA 1997"],
};

const armsSpace = { a: [1.5, 0, 0], b: [0, 1.2, 0] }, homeSpace: Vec = [3.4, 0.4, 0];
const spaceState = (translation: Vec, rotation: Vec): State => ({
  q: { query: "distance", a: { shape: { type: "ellipsoid", ellipsoid: { radii: [1.1, 0.7, 0.8] } } },
    b: { shape: { type: "cylinder", cylinder: { height: 1.2, radiusBottom: 0.6, radiusTop: 0.6 } }, translation, rotation } },
});

export const epaSpace: Lesson = {
  id: "epa-space", number: 8, title: "EPA in space", question: "How does a polytope find a curved boundary?",
  intro: "In space the polygon becomes a polytope of triangles. On curved shapes it never arrives, but each step brings the two bounds closer.",
  dimension: 3, view: { center: [1.7, 0.3, 0], reach: 2.6 }, start: spaceState([0.8, 0.5, 0.3], quatAbout([0.3, 0.2, 1], 0.7)),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", armsSpace.a), moveHandle(s, "b"), turnHandle(s, "b", armsSpace.b)],
  drag: (s, id, to) => dragBody(s, id, to, armsSpace),
  steps(state) {
    const { q } = state, answer = ask(q), list = answer.trace.epa, polytope = answer.trace.polytope;
    const at = (p: { a: Vec; b: Vec }): Vec => add(homeSpace, sub(p.b, p.a));
    const steps: Step[] = [{
      title: "Polytope and origin", text: list.length ? `${list.length} steps to come. On the right the polytope at the end: ${polytope?.triangles.length} triangles, most of them small, and all small ones where the origin is nearest.` : "The shapes are apart, or so shallow that another routine answers: move B deeper into A.",
      says: "Two curved shapes and the polytope of their difference.",
      draw(d) {
        drawBodies(d, q);
        for (const t of polytope?.triangles ?? []) {
          const [p, r, s] = t.map((i) => at(polytope!.points[i]));
          d.line(p, r, "made"); d.line(r, s, "made"); d.line(s, p, "made");
        }
        d.point(homeSpace, "ink", { wide: true, label: "O" });
      },
    }];
    list.forEach((s, i) => steps.push({
      title: `Step ${i + 1}: ${s.faces} faces`, text: explain(s, i === list.length - 1),
      formula: [`${digits(s.faceDepth, 8)} <= d <= ${digits(s.foundDepth, 8)}`, `"gap" = ${digits(s.foundDepth - s.faceDepth, 3)}`],
      graph: bounds(list, i),
      numbers: { caption: "Bounds of the depth", columns: ["step", "faces", "face", "found"], rows: list.slice(Math.max(0, i - 9), i + 1).map((t, k, l) => ({ cells: [String(Math.max(0, i - 9) + k + 1), t.faces, t.faceDepth, t.foundDepth], mark: k === l.length - 1 ? "now" as const : undefined })) },
      says: `Step ${i + 1}: depth between ${digits(s.faceDepth, 5)} and ${digits(s.foundDepth, 5)}; normal ${vector(s.normal, 3)}.`,
      draw(d) {
        steps[0].draw(d);
        d.arrow(homeSpace, add(homeSpace, scale(s.normal, s.foundDepth)), "touch", { wide: true, label: "n" });
      },
    }));
    return steps;
  },
  tryThis: [{ label: "Deeper", note: "More faces are nearly as near as the nearest.", state: spaceState([0.2, 0.1, 0.1], quatAbout([0.3, 0.2, 1], 0.7)) }],
  wrong: [{ label: "Same centre, same axis", note: "All directions round the axis are equally good: the polytope grows everywhere before it may stop.", state: spaceState([0, 0, 0], [0, 0, 0, 1]) }],
  sources: epaPlane.sources,
};
