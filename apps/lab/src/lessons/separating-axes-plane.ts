import { ask, type Axis } from "../graze.ts";
import type { Drawing } from "../parts/drawing.ts";
import { digits, vector } from "../parts/dom.ts";
import { add, dot, scale } from "../parts/vec.ts";
import { corners } from "../parts/outline.ts";
import { box, convex, type Body, type State } from "../question.ts";
import { dragBody, drawBodies, drawContacts, moveHandle, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [2.1, 0], b: [1.7, 0] };
const situation = (translation: number[], rotation: number, a: Body["shape"] = box(3, 2), b = box(2, 2)): State => ({
  q: { query: "contacts", dimension: 2, a: { shape: a }, b: { shape: b, translation, rotation } },
});

/** The axis as a ruler beside the shapes, with what A and B cover of it. */
function ruler(d: Drawing, axis: Axis, bodies: Body[], reach: number, result: boolean): void {
  const u = axis.direction.slice(0, 2), n = [-u[1], u[0]];
  const beyond = Math.max(...bodies.flatMap((body) => corners(body, 9).map((p) => -dot(p, n)))) + 0.5;
  const at = (t: number, side = 0): number[] => add(scale(u, t), scale(n, -(beyond + side)));
  const ends = [...axis.a, ...axis.b].map(Number);
  const from = Math.min(...ends) - 0.4, to = Math.max(...ends) + 0.4;
  d.arrow(at(from), at(to), "axis", { label: axis.name, key: axis.name });
  const [a, b] = [axis.a.map(Number), axis.b.map(Number)];
  d.line(at(a[0], 0.12), at(a[1], 0.12), "a", { wide: true });
  d.line(at(b[0], 0.26), at(b[1], 0.26), "b", { wide: true });
  bodies.forEach((body, i) => {
    for (const p of corners(body, 9)) {
      const side = i === 0 ? 0.12 : 0.26;
      d.line(p, at(dot(p, u), side), i === 0 ? "a" : "b", { ghost: true, dashed: true });
    }
  });
  if (!result || reach <= 0) return;
  const shared = [Math.max(a[0], b[0]), Math.min(a[1], b[1])];
  d.line(at(shared[0], 0.19), at(shared[1], 0.19), axis.overlap > 0 ? "touch" : "out", { wide: true });
}

const covers = (ends: Axis["a"]): string => `${digits(ends[0], 4)} … ${digits(ends[1], 4)}`;
const table = (axes: Axis[], now: string, winner?: string): Step["numbers"] => ({
  caption: "Overlap along each axis (units of length)",
  columns: ["axis", "A covers", "B covers", "overlap"],
  rows: axes.map((x) => ({
    cells: [x.name, covers(x.a), covers(x.b), x.overlap],
    key: x.name,
    mark: x.overlap < 0 ? "out" : x.name === winner ? "winner" : x.name === now ? "now" : undefined,
  })),
});

export const separatingAxesPlane: Lesson = {
  id: "separating-axes-plane",
  number: 3,
  title: "Separating axes in the plane",
  question: "Do these two boxes touch?",
  intro:
    "Two convex shapes are apart exactly when there is a direction along which their shadows are apart. For polygons only " +
    "the normals of their sides have to be tried. Drag the boxes and watch the shadows.",
  dimension: 2,
  view: { center: [1, 0], reach: 4.2 },
  start: situation([1.9, 1.1], 0.5),
  handles: (s) => [
    moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b),
    ...(["a", "b"] as const).filter((w) => s.q[w]!.shape.type === "box").map((w) => sizeHandle(s, w)),
  ],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state;
    const answer = ask(q);
    const axes = answer.trace.axes.filter((x) => x.name !== "normal");
    const winner = answer.trace.winner;
    const bodies = [q.a, q.b!];
    const steps: Step[] = [{
      title: "Two shapes, one question",
      text:
        `Is there a line with A on one side and B on the other? A line that separates is perpendicular to some direction, and ` +
        `the candidates are the normals of the sides: ${axes.length} of them here. Parallel sides of a box share one.`,
      says: `A and B in the plane; ${axes.length} axes to try.`,
      draw(d) {
        drawBodies(d, q);
        for (const x of axes) d.arrow([0, 0], x.direction.slice(0, 2), "axis", { label: x.name, ghost: true, key: x.name });
      },
    }];
    const seen: Axis[] = [];
    for (const axis of axes) {
      seen.push(axis);
      const known = [...seen];
      const gap = axis.overlap < 0;
      const side = axis.name.startsWith("A") ? "A" : "B";
      steps.push({
        title: `Axis ${axis.name}`,
        text:
          `Every corner is projected on ${axis.name}, a normal of ${side}: its scalar product with the direction ` +
          `${vector(axis.direction.slice(0, 2), 3)}. The smallest and the largest are the ends of the shadow. ` +
          `A box needs no corners: to both sides of its centre its shadow reaches the sum of its half sizes, each weighted by how far ` +
          `its own axis points along this one. ` +
          (gap ? "The shadows are apart: this axis separates the shapes, and the search may stop." : "The shadows overlap: this axis does not separate."),
        formula: [
          "o = min(max_A, max_B) - max(min_A, min_B)",
          `o = min(${digits(axis.a[1], 5)}, ${digits(axis.b[1], 5)}) - max(${digits(axis.a[0], 5)}, ${digits(axis.b[0], 5)}) = ${digits(axis.overlap, 5)}`,
          "r = h_x |n*e_x| + h_y |n*e_y|",
        ],
        numbers: table(known, axis.name),
        says: `${axis.name}: A from ${digits(axis.a[0], 4)} to ${digits(axis.a[1], 4)}, B from ${digits(axis.b[0], 4)} to ` +
          `${digits(axis.b[1], 4)}, ${gap ? "gap" : "overlap"} ${digits(Math.abs(axis.overlap), 4)}.`,
        draw(d) {
          drawBodies(d, q);
          ruler(d, axis, bodies, 4, true);
        },
      });
    }
    const apart = !answer.overlap;
    const best = axes.find((x) => x.name === winner) ?? axes[0];
    const normal = answer.manifolds?.[0]?.normal ?? best.direction.slice(0, 2);
    const points = answer.manifolds?.[0]?.points ?? [];
    steps.push({
      title: apart ? "They are apart" : "They overlap, and this is the way out",
      text: apart
        ? `${best.name} shows a gap of ${digits(-best.overlap, 4)}. One gap is enough. It is a lower bound of the distance, and not always ` +
          `the distance itself: where two corners are nearest, no side is perpendicular to the line between them.`
        : `All axes overlap, so the shapes do. Along ${best.name} they do so least: pushing B by ${digits(best.overlap, 5)} along it ` +
          `is the shortest way to part them. That is the depth, and the axis, turned so that it points from A to B, is the normal.`,
      formula: apart ? [`o_{${best.name}} = ${digits(best.overlap, 5)} < 0`]
        : ["d = min o_i", `d = ${digits(best.overlap, 5)}`, `n = [${normal.map((x) => digits(x, 4)).join(", ")}]`],
      numbers: table(axes, "", winner),
      says: apart ? `Apart: gap of ${digits(-best.overlap, 4)} along ${best.name}.`
        : `Overlap: depth ${digits(best.overlap, 4)} along ${best.name}, ${points.length} contact points.`,
      draw(d) {
        drawBodies(d, q);
        ruler(d, best, bodies, 4, true);
        drawContacts(d, answer.manifolds ?? []);
        if (!apart && points[0]) d.arrow(points[0].a, add(points[0].a, normal), "axis", { label: "n", wide: true });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Corner to corner", note: "The widest gap is smaller than the distance between the corners.", state: situation([3.1, 2.5], 0.1) },
    { label: "A gap on the last axis", note: "Three axes overlap, the fourth does not.", state: situation([2.35, 1.95], 0.7853981633974483) },
    { label: "Polygons", note: "Five sides and three: eight axes.", state: situation([1.8, 1.2], 0.4,
      convex([[-1.4, -0.9], [0.6, -1.2], [1.5, 0.1], [0.4, 1.2], [-1.1, 0.9]]), convex([[-1, -0.8], [1.1, -0.5], [0, 1.1]])) },
  ],
  wrong: [
    { label: "Nearly parallel", note: "A0 and B0 are almost the same axis and overlap almost alike. Rounding alone decides between them, and the normal flickers unless ties are broken the same way each time.", state: situation([2.3, 0.3], 1e-9) },
    { label: "Equal on two axes", note: "A0 and A1 overlap by the same amount. Move B a hair: the normal jumps by 90°.", state: situation([2, 1.5], 0) },
  ],
  sources: [
    "H. Minkowski: separating hyperplanes of convex sets, Geometrie der Zahlen (1896)",
    "S. Gottschalk, M. Lin, D. Manocha: OBBTree, SIGGRAPH 1996, section 5",
    "C. Ericson: Real-Time Collision Detection (2005), sections 4.4.1 and 5.2.1",
  ],
};
