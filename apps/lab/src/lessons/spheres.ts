import { ask, weightedPoint } from "../graze.ts";
import { drawDistance } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing, Handle } from "../parts/drawing.ts";
import { add, dot, length, mix, scale, sub, unit } from "../parts/vec.ts";
import { outlines } from "../parts/outline.ts";
import { circle, radiusOf, sphere, withBody, type Body, type Question, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, numberOf, type Lesson, type Step, type Which } from "./lesson.ts";

const situation = (ra: number, rb: number, b: Vec): State => ({
  q: { query: "contacts", dimension: 2, a: { shape: circle(ra), translation: [0, 0] }, b: { shape: circle(rb), translation: b } },
});
const sizer = (q: Question, which: Which): Handle => {
  const { translation, shape } = q[which]!;
  return { id: `radius-${which}`, label: `Radius of ${which.toUpperCase()}`, kind: "size", meaning: which, at: add(translation!, [0, radiusOf(shape)]) };
};

const inSpace = (s: State): boolean => s.choice?.view === "space";
/** The distance of a centre before the plane of the screen, which balls moved in space have. */
const depthOf = (s: State, which: Which): number => numberOf(s, `${which}z`, 0);
/** The balls in space; or the circles in which a plane cuts them that holds both centres and the vertical: as far from
 *  each other as the balls are, whatever their depths. */
function present(s: State): Question {
  const [a, b] = [s.q.a.translation!, s.q.b!.translation!], ball = (which: Which, translation: Vec): Body =>
    inSpace(s) ? { shape: sphere(radiusOf(s.q[which]!.shape)), translation } : { shape: s.q[which]!.shape, translation };
  if (inSpace(s)) return { query: s.q.query, a: ball("a", [...a, depthOf(s, "a")]), b: ball("b", [...b, depthOf(s, "b")]) };
  const aside = b[0] - a[0], depth = depthOf(s, "b") - depthOf(s, "a");
  const turned = depth === 0 ? b : [a[0] + (aside < 0 ? -1 : 1) * length([aside, depth]), b[1]];
  return { query: s.q.query, dimension: 2, a: ball("a", a), b: ball("b", turned) };
}
/** The balls of a question that `present` made, with the choices that there were. */
function stateOf({ choice }: State, q: Question): State {
  const flat = q.dimension === 2, [a, b] = [q.a, q.b!];
  const cut = ({ shape, translation }: Body): Body => ({ shape: circle(radiusOf(shape)), translation: translation!.slice(0, 2) });
  return { q: { query: q.query, dimension: 2, a: cut(a), b: cut(b) },
    choice: { ...choice, az: flat ? 0 : a.translation![2], bz: flat ? 0 : b.translation![2] } };
}
/** The balls, the plane through their centres, and the circles in which it cuts them. */
function drawBalls(draw: Drawing, q: Question): void {
  const [a, b] = [q.a.translation!, q.b!.translation!], along = [b[0] - a[0], 0, b[2] - a[2]];
  const side = length(along) > 0 ? unit(along[0] < 0 ? scale(along, -1) : along) : [1, 0, 0], low = Math.min(a[1], b[1]);
  const at = (center: Vec, u: number, v: number): Vec => add(add(center, scale(side, u)), [0, v, 0]);
  const corner = (u: number, v: number): Vec => at([a[0], low, a[2]], u, v);
  draw.polygon([corner(-2.6, -2.6), corner(4.4, -2.6), corner(4.4, 3), corner(-2.6, 3)], "ink", { ghost: true });
  for (const which of ["a", "b"] as const) {
    const { shape, translation } = q[which]!;
    draw.shape(q[which]!, which);
    for (const { points } of outlines({ shape: circle(radiusOf(shape)) }, 8))
      points.forEach(([u, v], i) => draw.line(at(translation!, u, v), at(translation!, ...(points[(i + 1) % points.length] as [number, number])), which, { wide: true }));
  }
}

function dragged(s: State, id: string, to: Vec): State {
  const now = { ...s, q: present(s) };
  if (!id.startsWith("radius")) return stateOf(s, dragBody(now, id, to).q);
  return stateOf(s, withBody(now, id.slice(-1) as Which, (body) => { body.shape = circle(Math.max(0.05, length(sub(to, body.translation!)))); }).q);
}

export const spheres: Lesson = {
  id: "spheres", number: 1, title: "Spheres", question: "Do two balls touch, without a square root?",
  intro: "The simplest pair of all, drawn in a plane through both centres, and in space. Its answer already has everything: a distance, a normal, and the question which single point to call the contact.",
  dimension: (s) => (inSpace(s) ? 3 : 2), view: (s) => (inSpace(s) ? { center: [0.9, 0.2, 0], reach: 2.7, from: [0.55, 0.45, 1] } : { center: [0.9, 0.2], reach: 3.2 }),
  start: situation(1.4, 0.8, [1.7, 0.8]),
  choices: [{ key: "view", label: "Seen", options: [{ value: "section", label: "section" }, { value: "space", label: "in space" }] }],
  handles(s) {
    const q = present(s), now = { ...s, q };
    return [moveHandle(now, "a"), moveHandle(now, "b"), sizer(q, "a"), sizer(q, "b")];
  },
  drag: dragged,
  asks: present,
  steps(state) {
    const q = present(state), answer = ask({ ...q, query: "distance" }), overlap = ask({ ...q, query: "overlap" }).overlap!;
    const ca = q.a.translation!, cb = q.b!.translation!, ra = radiusOf(q.a.shape), rb = radiusOf(q.b!.shape);
    const c = sub(cb, ca), n = answer.normal!, d = answer.distance!;
    const pa = answer.a as unknown as Vec, pb = answer.b as unknown as Vec;
    const weighted = weightedPoint(q, d), middle = mix(pa, pb, 0.5);
    const centers = (draw: Parameters<Step["draw"]>[0]): void => {
      if (inSpace(state)) drawBalls(draw, q);
      else drawBodies(draw, q);
      draw.line(ca, cb, "axis", { dashed: true, label: "c" });
    };
    return [
      {
        title: "Squared against squared",
        text: "Balls touch when the distance of their centres is at most the sum of their radii. Both sides may be squared, because neither is negative: so no square root is needed to say yes or no. " + (overlap ? "Yes." : "No."),
        formula: ["c*c <= (r_A + r_B)^2", `${digits(dot(c, c), 5)} ${overlap ? "<=" : ">"} ${digits((ra + rb) ** 2, 5)}`],
        numbers: { caption: "The two sides", columns: ["quantity", "value"], rows: [{ cells: ["c · c", dot(c, c)] }, { cells: ["(rA + rB)²", (ra + rb) ** 2] }, { cells: ["overlap", String(overlap)], mark: "winner" }] },
        says: `The balls ${overlap ? "touch" : "do not touch"}.`,
        draw: centers,
      },
      {
        title: "The normal",
        text: "From the centre of A to that of B: one square root to make it a unit. With the same centre there is no such direction, and any unit vector is as good as another; the library takes one always the same way.",
        formula: ["n = frac(c, |c|)", `n = [${n.map((x) => digits(x, 5)).join(", ")}]`],
        numbers: { caption: "Normal", columns: ["quantity", "value"], rows: [{ cells: ["n", n], mark: "winner" }, { cells: ["|c|", length(c)] }] },
        says: `Normal ${vector(n, 3)}.`,
        draw(draw) { centers(draw); draw.arrow(ca, add(ca, n), "axis", { wide: true, label: "n" }); },
      },
      {
        title: "Signed distance",
        text: "What is left between the surfaces: positive apart, negative overlapping, and then its magnitude is the depth. The points nearest to the other ball, or deepest in it, lie on the line of the centres.",
        formula: ["d = |c| - r_A - r_B", `d = ${digits(d, 6)}`],
        numbers: { caption: "Answer (units of length)", columns: ["quantity", "value"], rows: [{ cells: ["distance", d], mark: "winner" }, { cells: ["on A", pa] }, { cells: ["on B", pb] }] },
        says: `Signed distance ${digits(d, 5)}.`,
        draw(draw) {
          centers(draw);
          drawDistance(draw, answer, { look: { wide: true } });
          draw.text(pa, "a", "a");
          draw.text(pb, "b", "b");
        },
      },
      {
        title: "The weighted point",
        text: "Which single point is the contact? Not the middle of the overlap: a small ball deep in a big one would be pushed from the wrong place. P divides the overlap as the radii do, so its distances to the centres are as the radii are.",
        formula: ["frac(|P - c_A|, |P - c_B|) = frac(r_A, r_B)", `frac(${digits(length(sub(weighted, ca)), 4)}, ${digits(length(sub(weighted, cb)), 4)}) = frac(${digits(ra, 4)}, ${digits(rb, 4)})`],
        numbers: { caption: "Points", columns: ["quantity", "value"], rows: [{ cells: ["P", weighted], mark: "winner", key: "p" }, { cells: ["middle", middle], mark: "out", key: "m" }] },
        says: `The weighted point is ${vector(weighted, 3)}.`,
        draw(draw) {
          centers(draw);
          drawDistance(draw, answer, { look: { wide: true }, as: { a: null, b: null } });
          draw.point(middle, "out", { wide: true, key: "m" });
          draw.point(weighted, "touch", { wide: true, label: "P", key: "p" });
        },
      },
    ];
  },
  tryThis: [
    { label: "Touch exactly", note: "3–4–5: the distance is zero, and touching counts as overlap.", state: situation(3 / 2, 1, [2, 1.5]) },
    { label: "One inside the other", note: "The depth is more than the small ball's diameter.", state: situation(2, 0.4, [0.6, 0.2]) },
    { label: "A point against a ball", note: "A radius of nearly nothing is allowed.", state: situation(1.4, 0.05, [1.2, 0.9]) },
  ],
  wrong: [
    { label: "Same centre", note: "c is zero: dividing by its length would give not-a-number, and one such number spoils a whole simulation.", state: situation(1.4, 0.8, [0, 0]) },
    { label: "Middle or weighted", note: "Compare P with the grey middle: the bigger the difference of radii, the further apart they are.", state: situation(2, 0.3, [1.7, 0.6]) },
  ],
  sources: ["C. Ericson: Real-Time Collision Detection (2005), section 4.3.1"],
};
