// The pairs of the appendix that have ends, and their formulas with the numbers of the present question put in.

import type { Answer } from "../graze.ts";
import { digits } from "../parts/dom.ts";
import { row, term } from "../parts/math.ts";
import type { Row } from "../parts/table.ts";
import type { Drawing } from "../parts/drawing.ts";
import { cross, length, sub, unit } from "../parts/vec.ts";
import { convex, plane, pointsOf, radiusOf, triangle, type Question, type Vec } from "../question.ts";
import { along } from "./lesson.ts";
import { before, planeAcross } from "./lines.ts";

export interface Pair {
  value: string;
  label: string;
  q: Question;
  text: string;
  /** The formulas with letters. */
  formula: string[];
  /** The formulas with numbers, where the question that the bodies make is all that it takes. */
  worked?(q: Question, answer: Answer): string[];
  /** The answer where it takes more than the question that the bodies make. */
  solve?(q: Question): Solved;
}
/** What several questions to the library say of a pair. */
export interface Solved {
  /** The question that decides. */
  question: Question;
  title: string;
  text: string;
  says: string;
  formula: string[];
  rows: Row[];
  /** Draws lines beyond the points that give them. */
  extend?(d: Drawing): void;
  draw(d: Drawing): void;
}

const flat: Vec[] = [[-1, 0, -0.8], [1.4, 0, -0.6], [0.1, 0.2, 1.2]];
export const segment = (p: Vec, q: Vec): Question["a"] => ({ shape: convex([p, q]) });
const pointOf = (answer: Answer, which: "a" | "b"): Vec => answer[which] as unknown as Vec;
/** The direction between two points, of length one. */
const towards = (p: Vec, q: Vec): Vec => unit(sub(q, p));
/** The unit normal of a triangle. */
export const normal = ([a, b, c]: Vec[]): Vec => unit(cross(sub(b, a), sub(c, a)));
/** The weight of a triangle's corner in a point of it: how far both lie before the opposite side. */
function weight(corners: Vec[], i: number, x: Vec): number {
  const [b, c] = [corners[(i + 1) % 3], corners[(i + 2) % 3]], side = planeAcross(b, cross(sub(c, b), normal(corners)));
  return before(side, x) / before(side, corners[i]);
}
/** The numbers of the formula t = (w − n·o) / n·u; without a result where nothing is hit, or something from the
 *  start. */
export const meets = (n: Vec, w: number, o: Vec, u: Vec, t = 0): string =>
  `t = frac(${digits(w, 4)} - ${term(along(n, o))}, ${digits(along(n, u), 4)})${t === 0 ? "" : ` = ${digits(t, 5)}`}`;

export const pairs: Pair[] = [
  { value: "point-segment", label: "point, segment", q: { query: "closest", a: segment([-1.4, 0.2, 0], [1.5, 0.6, 0.4]), point: [0.4, 1.7, 0.6] },
    text: "Project the point on the line, and clamp the parameter to the ends of the segment.", formula: ["t = frac((x - p)*(q - p), |q - p|^2)", "0 <= t <= 1", "d = |x - p - t (q - p)|"],
    worked(q, answer) {
      const [p, to] = pointsOf(q.a.shape), x = q.point!, u = sub(to, p), l = length(u);
      const t = before(planeAcross(p, u), x) / l, kept = length(sub(answer.point!, p)) / l;
      return [`t = frac(${row(sub(x, p))} * ${row(u)}, ${digits(l, 4)}^2) = ${digits(t, 5)}`,
        ...(t < 0 || t > 1 ? [`t -> ${digits(kept, 5)}`] : []),
        `d = |${row(sub(x, p))} - ${digits(kept, 4)} ${row(u)}| = ${digits(answer.distance, 5)}`];
    } },
  { value: "point-plane", label: "point, plane", q: { query: "closest", a: { shape: plane() }, point: [0.5, 1.2, 0.3] },
    text: "Put the point into the plane's equation: the signed distance. Go back by it along the normal and you are on the plane.", formula: ["d = n*x - w", "x' = x - d n"],
    worked: ({ point }, { distance, point: to, normal: n }) => [`d = ${row(n!)} * ${row(point!)} - 0 = ${digits(distance, 5)}`, `x' = ${row(point!)} - ${term(distance!)} ${row(n!)} = ${row(to!)}`] },
  { value: "point-triangle", label: "point, triangle", q: { query: "closest", a: { shape: triangle(...flat) }, point: [1.2, 1.2, 0.8] },
    text: "Seven regions: three corners, three edges, the face. Which one the point is over is decided by scalar products with the edges, without a projection.", formula: ["x' = u a + v b + w c", "u + v + w = 1", "d = |x - x'|"],
    worked(q, { distance, point }) {
      const corners = pointsOf(q.a.shape), weights = corners.map((_, i) => weight(corners, i, point!));
      return [`x' = ${corners.map((c, i) => `${term(Math.abs(weights[i]) < 1e-12 ? 0 : weights[i], 3)} ${row(c)}`).join(" + ")} = ${row(point!)}`,
        `d = |${row(q.point!)} - ${row(point!)}| = ${digits(distance, 5)}`];
    } },
  { value: "segment-segment", label: "segment, segment", q: { query: "distance", a: segment([-1.4, 0.2, 0], [1.5, 0.6, 0.4]), b: segment([0.2, 1.2, -1.2], [0.6, 1.5, 1.2]) },
    text: "The shortest connection is perpendicular to both lines: two equations for two parameters. Where one leaves its segment it is clamped and the other follows.", formula: ["a = p + s u, 0 <= s <= |u|", "b = q + t v, 0 <= t <= |v|", "(b - a)*u = 0, (b - a)*v = 0"],
    worked(q, answer) {
      const [a, b] = [pointOf(answer, "a"), pointOf(answer, "b")], ends = [pointsOf(q.a.shape), pointsOf(q.b!.shape)];
      return [a, b].map((x, i) => `${"ab"[i]} = ${row(ends[i][0])} + ${digits(length(sub(x, ends[i][0])), 4)} ${row(towards(...(ends[i] as [Vec, Vec])))} = ${row(x)}`)
        .concat(ends.map(([from, to], i) => {
          const u = towards(from, to), product = along(u, b) - along(u, a);
          return `(b - a)*${"uv"[i]} = ${digits(Math.abs(product) < 1e-12 ? 0 : product, 4)}`;
        }), `d = |b - a| = ${digits(answer.distance, 5)}`);
    } },
  { value: "ray-plane", label: "ray, plane", q: { query: "raycast", a: { shape: plane() }, ray: { origin: [-1.2, 1.6, 0.4], direction: [1, -0.8, 0] } },
    text: "Put the ray's point into the plane's equation and solve for t. A ray along the plane never hits: the denominator is zero.", formula: ["n*(o + t u) = w", "t = frac(w - n*o, n*u)"],
    worked: ({ ray }, { t }) => [`u = ${row(unit(ray!.direction))}`, meets([0, 1, 0], 0, ray!.origin, unit(ray!.direction), t)] },
  { value: "ray-triangle", label: "ray, triangle", q: { query: "raycast", a: { shape: triangle(...flat) }, ray: { origin: [0.3, 2, 0.3], direction: [0, -1, -0.1] } },
    text: "First the plane of the triangle, then three signs: on which side of each edge does the ray pass? Signs from the ray's own view are the same for both neighbours of an edge, so nothing slips through between them.", formula: ["t = frac(n*a - n*o, n*u)", "s_ab = u*((a - o) × (b - o))", '"the same sign three times"'],
    worked(q, { t }) {
      const corners = pointsOf(q.a.shape), n = normal(corners), { origin, direction } = q.ray!, u = unit(direction);
      const sides = corners.map((a, i) => {
        const c = cross(sub(a, origin), sub(corners[(i + 1) % 3], origin));
        return `s_${"abc"[i]}${"bca"[i]} = ${digits(length(c) * along(unit(c), u), 4)}`;
      });
      return [meets(n, along(n, corners[0]), origin, u, t), sides.join(", ")];
    } },
  { value: "ray-sphere", label: "ray, ball", q: { query: "raycast", a: { shape: { type: "sphere", sphere: { radius: 0.9 } } }, ray: { origin: [-2, 1.2, 0.4], direction: [1, -0.45, 0] } },
    text: "A quadratic equation. Its discriminant says whether there is a hit, its smaller root is the entry.", formula: ["|o + t u|^2 = r^2", "t = -o*u - sqrt((o*u)^2 - |o|^2 + r^2)"],
    worked(q, { hit, t, point }) {
      const { origin, direction } = q.ray!, u = unit(direction), r = digits(radiusOf(q.a.shape), 4), product = term(along(u, origin));
      return [`t = -${product} - sqrt(${product}^2 - ${digits(length(origin), 4)}^2 + ${r}^2)${t ? ` = ${digits(t, 5)}` : ""}`,
        ...(hit ? [`${row(origin)} + ${digits(t, 4)} ${row(u)} = ${row(point!)}`] : [])];
    } },
  { value: "triangle-triangle", label: "triangle, triangle", q: { query: "distance", a: { shape: triangle(...flat) }, b: { shape: triangle([-0.4, 0.6, 0.4], [1.2, 1.4, 0.2], [0.2, 1.6, -0.9]) } },
    text: "Apart, the nearest points are a corner and a face or two edges: nine and six pairs. Overlapping, an edge of one passes through the other.", formula: ["d = min |b - a|"],
    worked: (_, answer) => [answer.distance! > 0 ? `d = |${row(pointOf(answer, "b"))} - ${row(pointOf(answer, "a"))}| = ${digits(answer.distance, 5)}` : `d = ${digits(answer.distance, 5)}`] },
];
