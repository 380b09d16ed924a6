import { ask, type Axis } from "../graze.ts";
import { drawDistance, drawTrace, type Marks } from "../parts/answers.ts";
import type { Drawing } from "../parts/drawing.ts";
import { digits, vector } from "../parts/dom.ts";
import { row, term } from "../parts/math.ts";
import { add, dot, mix, rotate, scale, sub } from "../parts/vec.ts";
import { corners } from "../parts/outline.ts";
import { box, convex, sizeOf, type Body, type State, type Vec } from "../question.ts";
import { along, dragBody, drawBodies, drawContacts, later, moveHandle, radiusWorked, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [2.1, 0], b: [1.7, 0] };
const situation = (translation: number[], rotation: number, a: Body["shape"] = box(3, 2), b = box(2, 2)): State => ({
  q: { query: "contacts", dimension: 2, a: { shape: a }, b: { shape: b, translation, rotation } },
});

const flat = (v: Vec): Vec => [v[0], v[1]];
const isBox = (body: Body): boolean => body.shape.type === "box";

/** The parts of the shadows that are drawn: so many corners of each body, else all; the overlap, or the gap. */
interface Shown {
  corners?: [number, number];
  verdict?: boolean;
}
/** The shadows on an axis side by side, and what they share or leave free, as the library draws them. */
export const drawAxis = (d: Drawing, axis: Axis, marks: Marks): void =>
  drawTrace(d, { winner: axis.name, axes: [axis] }, { ...marks, look: { wide: true }, as: { gap: "out", normal: null, ...marks.as } });
/** The axis as a ruler beside the shapes, with the shadows of A and B on it. */
function ruler(d: Drawing, axis: Axis, bodies: Body[], shown: Shown = {}): void {
  const u = flat(axis.direction), n = [-u[1], u[0]];
  const lists = bodies.map((body) => corners(body, 9)), across = lists.flat().map((p) => -dot(p, n));
  const beyond = Math.max(...across) + 0.5;
  const at = (t: number, side = 0): Vec => add(scale(u, t), scale(n, -(beyond + side)));
  const ends = [...axis.a, ...axis.b].map(Number);
  d.arrow(at(Math.min(...ends) - 0.4), at(Math.max(...ends) + 0.4), "axis", { label: axis.name, key: axis.name });
  // What none of the corners is shown of has no shadow yet.
  const spans: [Axis["a"], Axis["b"]] = [["infinity", "-infinity"], ["infinity", "-infinity"]];
  lists.forEach((all, i) => {
    const meaning = i === 0 ? "a" : "b", side = i === 0 ? 0.12 : 0.26;
    const list = all.slice(0, shown.corners?.[i] ?? Infinity), feet = list.map((p) => dot(p, u));
    list.forEach((p, k) => {
      d.line(p, at(feet[k], side), meaning, { ghost: true, dashed: true });
      if (shown.corners) d.point(at(feet[k], side), meaning);
    });
    if (list.length) spans[i] = [Math.min(...feet), Math.max(...feet)];
  });
  drawAxis(d, shown.verdict ? axis : { ...axis, a: spans[0], b: spans[1] }, { center: at(0, 0.19), size: 4.2, as: shown.verdict ? {} : { contact: null, gap: null } });
  if (!shown.verdict || axis.overlap >= 0) return;
  const [from, to] = [Number(axis.b[0]), Number(axis.a[1])];
  const middle = (from + to) / 2, far = add(scale(u, middle), scale(n, -Math.min(...across) + 0.5));
  d.line(at(middle, 0.4), far, "ink", { dashed: true, label: "separates" });
}

const shadow = (ends: Axis["a"]): string => `${digits(ends[0], 3)} … ${digits(ends[1], 3)}`;
/** The axes with their shadows. */
export const axisTable = (axes: Axis[], now: string, winner?: string): Step["numbers"] => ({
  caption: "Shadows on each axis (units of length)",
  columns: ["axis", "of A", "of B", "overlap", "gap"],
  rows: axes.map((x) => ({
    cells: [x.name, shadow(x.a), shadow(x.b), x.overlap < 0 ? "" : x.overlap, x.overlap < 0 ? -x.overlap : ""],
    key: x.name,
    mark: x.name === winner ? "winner" : x.overlap < 0 ? "out" : x.name === now ? "now" : undefined,
  })),
});
/** The overlap or gap in words: "overlap 0.6" or "gap 0.2". */
export const verdict = (axis: Axis, significant = 4): string =>
  `${axis.overlap < 0 ? "gap" : "overlap"} ${digits(Math.abs(axis.overlap), significant)}`;
/** The verdict of an axis by its shadows, with letters and with numbers. Axes of a trace point from A towards B. */
export const verdictFormula = (x: Axis): string[] => x.overlap < 0
  ? ['"gap" = "min"_B - "max"_A', `"gap" = ${digits(x.b[0], 5)} - ${term(x.a[1], 5)} = ${digits(-x.overlap, 5)}`]
  : ['"overlap" = "max"_A - "min"_B', `"overlap" = ${digits(x.a[1], 5)} - ${term(x.b[0], 5)} = ${digits(x.overlap, 5)}`];
/** The axis whose overlap is least, or whose gap is widest. */
export const leastOf = (axes: Axis[]): Axis => axes.reduce((best, x) => (x.overlap < best.overlap ? x : best));

/** An edge in words: "the normal of B's side 2" for "B edge 2"; the two axes of a box are those of two sides each. */
function inWords(name: string): string {
  const [whose, , side] = name.split(" ");
  return side === undefined ? `the normal of two sides of ${name[0]}` : `the normal of ${whose}'s side ${side}`;
}

/** The steps of the first axis: corner by corner, then, for boxes, without corners. */
function slowly(axis: Axis, bodies: Body[], paint: (d: Drawing) => void): Step[] {
  const u = flat(axis.direction), steps: Step[] = [], lists = bodies.map((body) => corners(body, 9));
  const whose = ["A", "B"];
  lists.forEach((list, which) => list.forEach((p, k) => steps.push(later(() => {
    const feet = list.slice(0, k + 1).map((x) => along(u, x)), t = feet[k], before = feet.slice(0, k), name = whose[which];
    const rows = [...(which === 1 ? lists[0].map((x, i) => ({ cells: [`A ${i + 1}`, vector(x, 3), along(u, x)], key: `A${i}` })) : []),
      ...feet.map((x, i) => ({ cells: [`${name} ${i + 1}`, vector(list[i], 3), x], key: `${name}${i}`, mark: i === k ? "now" as const : undefined }))];
    const change = k === 0 ? `It is where the shadow of ${name} begins to grow.` : t < Math.min(...before) || t > Math.max(...before)
      ? "It lies outside what the shadow was: the shadow grows." : "It lies inside the shadow, which stays as it is.";
    return {
      title: `Axis ${axis.name}, corner ${k + 1} of ${name}`,
      text: (which === 0 && k === 0 ? `The first axis, ${axis.name}, is ${inWords(axis.name)}. How far a corner lies along it is the scalar product of axis and corner. ` : "") +
        change + (k === list.length - 1 ? ` All corners of ${name} are in: its shadow reaches from ${digits(Math.min(...feet), 4)} to ${digits(Math.max(...feet), 4)}.` : ""),
      formula: ["t = n*p", `t = ${row(u, 4)} * ${row(p, 4)} = ${digits(t, 5)}`],
      numbers: { caption: `Corners along ${axis.name}`, columns: ["corner", "p", "t"], rows },
      says: `Corner ${k + 1} of ${name} lies at ${digits(t, 4)} along ${axis.name}.`,
      draw(d) {
        paint(d);
        ruler(d, axis, bodies, { corners: which === 0 ? [k + 1, 0] : [Infinity, k + 1] });
        d.point(p, which === 0 ? "a" : "b", { wide: true, key: `${name}${k}` });
      },
    };
  }))));
  const boxes = bodies.map((body, i) => ({ body, name: i === 0 ? "A" : "B", ends: i === 0 ? axis.a : axis.b })).filter((x) => isBox(x.body));
  if (boxes.length) steps.push(later(() => ({
    title: `Axis ${axis.name} without corners`,
    text: "A box needs no corners. Its shadow has its centre's place in the middle, and reaches to both sides by r: the sum of its half sizes, " +
      "each times how far its own axis points along n. The same shadows come out, with a fraction of the work.",
    formula: ["r = h_x |n*e_x| + h_y |n*e_y|", ...boxes.map(({ body, name, ends }) => radiusWorked(`r_${name}`, body, u, (Number(ends[1]) - Number(ends[0])) / 2))],
    numbers: { caption: `Shadows on ${axis.name}`, columns: ["of", "centre", "r", "shadow"], rows: boxes.map(({ body, name, ends }) => ({
      cells: [name, along(u, body.translation ?? [0, 0]), (Number(ends[1]) - Number(ends[0])) / 2, shadow(ends)] })) },
    says: `The shadows of ${boxes.map((x) => x.name).join(" and ")} from centre and half sizes.`,
    draw(d) {
      paint(d);
      ruler(d, axis, bodies);
      for (const { body, name } of boxes) {
        const center = body.translation ?? [0, 0], half = scale(sizeOf(body.shape), 0.5), meaning = name === "A" ? "a" : "b";
        d.arrow(center, add(center, rotate(body.rotation, [half[0], 0])), meaning, { label: "hₓ" });
        d.arrow(center, add(center, rotate(body.rotation, [0, half[1]])), meaning, { label: "hᵧ" });
        d.point(center, meaning, { wide: true });
      }
    },
  })));
  return steps;
}

/** The bounds of the distance by the axes, and the distance. */
function farApart({ q }: State, axes: Axis[]): Step[] {
  const { winner } = ask(q).trace, best = leastOf(axes), bodies = [q.a, q.b!];
  const steps: Step[] = [{
    title: `They are apart: the widest gap is on ${best.name}`,
    text: `${best.name} shows the widest gap, ${digits(-best.overlap, 4)}: the shapes are at least that far apart. ` + (winner === "normal"
      ? "It is not the distance: two corners are nearest, and no side's normal points along the way between them. "
      : "It is the distance too: a side is nearest to a corner or to another side, and the shortest way is across it. ") +
      "To say that they are apart any gap is enough.",
    formula: verdictFormula(best),
    numbers: axisTable(axes, "", best.name),
    says: `Apart: widest gap ${digits(-best.overlap, 4)} along ${best.name}.`,
    draw(d) {
      drawBodies(d, q);
      ruler(d, best, bodies, { verdict: true });
    },
  }];
  steps.push(later(() => {
    const { distance, a, b, trace } = ask({ ...q, query: "distance" });
    const between = { ...trace.axes.find((x) => x.name === "normal")!, name: "a to b" };
    const [near, far] = [a as unknown as Vec, b as unknown as Vec];
    return {
      title: winner === "normal" ? "Corner to corner" : "The nearest points",
      text: winner === "normal"
        ? `The true distance, ${digits(distance, 4)}, is measured along the way between the two nearest corners. That is an axis too, a to b, with the widest gap of ` +
          "all; but it is known only once the corners are, and there are many pairs of those. Whoever wants to know overlap alone needs none of it."
        : `Their distance is the gap on ${best.name}: ${digits(distance, 4)}, from the point on A to that on B.`,
      formula: ["d = |b - a|", `d = ${digits(distance, 8)}`],
      numbers: axisTable(winner === "normal" ? [...axes, between] : axes, "", winner === "normal" ? between.name : best.name),
      says: `The distance is ${digits(distance, 4)}.`,
      draw(d) {
        drawBodies(d, q);
        ruler(d, winner === "normal" ? between : best, bodies, { verdict: true });
        drawDistance(d, { a, b }, { look: { wide: true } });
        d.text(mix(near, far, 0.5), "d", "touch");
      },
    };
  }));
  return steps;
}

/** The way out, its direction, and the contact. */
function deep({ q }: State, axes: Axis[]): Step[] {
  const answer = ask(q), best = axes.find((x) => x.name === answer.trace.winner) ?? leastOf(axes);
  const [{ normal, points }] = answer.manifolds!, bodies = [q.a, q.b!], centers = bodies.map((body) => body.translation ?? [0, 0]);
  const c = sub(centers[1], centers[0]), boxes = bodies.every(isBox);
  return [later(() => ({
    title: `The least overlap wins: ${best.name}`,
    text: `The shadows overlap on every axis, so the shapes do. Along ${best.name} it takes least to part them: ${digits(best.overlap, 5)}. That is the depth. ` +
      "Where B would be then is drawn dashed; no axis has a shorter way.",
    formula: ["d = min o_i", `d = ${digits(best.overlap, 5)}`],
    numbers: axisTable(axes, "", best.name),
    says: `Overlap: depth ${digits(best.overlap, 4)} along ${best.name}.`,
    draw(d) {
      drawBodies(d, q);
      ruler(d, best, bodies, { verdict: true });
      d.shape({ ...q.b!, translation: add(centers[1], scale(normal, best.overlap)) }, "b", { ghost: true, dashed: true });
    },
  })), later(() => ({
    title: "The normal points from A to B",
    text: boxes ? "A side's normal and its opposite are the same axis. The one that points from A's centre towards B's is the normal: c·n is not negative. Pushed along it, B moves away " +
        "from A; along the other it would go through A."
      : "Of a side of A the normal points out of A, of a side of B into B. So it points from A to B, and B pushed along it moves away from A.",
    formula: [boxes ? "c*n >= 0" : "n", ...(boxes ? [`c*n = ${row(c, 3)} * ${row(normal, 3)} = ${digits(along(normal, c), 4)}`] : []), `n = ${row(normal, 4)}`],
    says: `The normal is ${vector(normal, 3)}.`,
    draw(d) {
      drawBodies(d, q);
      if (boxes) {
        d.arrow(centers[0], centers[1], "ink", { dashed: true, label: "c" });
        d.point(centers[0], "a", { wide: true });
        d.point(centers[1], "b", { wide: true });
        d.arrow(centers[0], sub(centers[0], normal), "out", { dashed: true, label: "−n" });
      }
      d.arrow(boxes ? centers[0] : points[0].a, add(boxes ? centers[0] : points[0].a, normal), "axis", { label: "n", wide: true });
    },
  })), later(() => ({
    title: points.length > 1 ? "The points" : "The point",
    text: `Along n, ${points.length > 1 ? "these points of B are" : "this point of B is"} deepest in A, by the depth below the side of A or B that the axis belongs to. ` +
      "Normal, depth and points: a contact is complete.",
    formula: ["b - a = -d n", `d = ${digits(best.overlap, 5)}`],
    numbers: { caption: "Contact", columns: ["point", "on A", "on B", "depth"], rows: points.map((p, i) => ({
      cells: [String(i + 1), vector(p.a, 3), vector(p.b, 3), -p.distance], key: `point-${i}` })) },
    says: `${points.length} contact point${points.length > 1 ? "s" : ""}, depth ${digits(best.overlap, 4)}.`,
    draw(d) {
      drawBodies(d, q);
      drawContacts(d, answer.manifolds ?? []);
    },
  }))];
}

export const separatingAxesPlane: Lesson = {
  id: "separating-axes-plane",
  number: 3,
  title: "Separating axes in the plane",
  question: "Do these two boxes touch?",
  intro:
    "Two convex shapes are apart exactly when there is a direction on which their shadows are apart. Drag the boxes and watch the shadows.",
  dimension: 2,
  view: { center: [1.2, 0.1], reach: 4.9 },
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
    const bodies = [q.a, q.b!];
    const paint = (d: Drawing): void => drawBodies(d, q);
    const steps: Step[] = [{
      title: "Two shapes, one question",
      text:
        "An axis is a direction; each shape casts a shadow on it. If the shadows are apart, a line across the axis between them has A on one " +
        `side and B on the other: the shapes are apart. Only the normals of the sides have to be tried: ${axes.length} axes here` +
        `${bodies.every(isBox) ? ", as parallel sides of a box share one" : ""}. All point from A towards B.`,
      says: `A and B in the plane; ${axes.length} axes to try.`,
      draw(d) {
        paint(d);
        for (const x of axes) d.arrow([0, 0], flat(x.direction), "axis", { label: x.name, ghost: true, key: x.name });
      },
    }, ...slowly(axes[0], bodies, paint)];
    const firstGap = axes.findIndex((x) => x.overlap < 0);
    axes.forEach((axis, i) => {
      const gap = axis.overlap < 0;
      steps.push(later(() => ({
        title: `Axis ${axis.name}: ${gap ? "a gap" : "overlap"}`,
        text: (i === 0 ? "Both shadows beside each other. " : `${axis.name} is ${inWords(axis.name)}: the same for it. `) +
          (gap ? "A's shadow ends before B's begins. The dashed line across the axis separates the shapes: they are apart. "
            : "A's shadow ends beyond where B's begins: by that much B would have to go along the axis. This axis does not separate. ") +
          (i === firstGap ? "The search ends here: one gap is proof enough." + (i + 1 < axes.length ? " The page goes on to show what it would have found." : "")
            : firstGap >= 0 && i > firstGap ? `After the gap on ${axes[firstGap].name} nobody would have looked at it.` : ""),
        formula: verdictFormula(axis),
        numbers: axisTable(axes.slice(0, i + 1), axis.name),
        says: `${axis.name}: A from ${digits(axis.a[0], 4)} to ${digits(axis.a[1], 4)}, B from ${digits(axis.b[0], 4)} to ` +
          `${digits(axis.b[1], 4)}, ${verdict(axis)}.`,
        draw(d) {
          paint(d);
          ruler(d, axis, bodies, { verdict: true });
        },
      })));
    });
    const apart = !answer.overlap;
    steps.push(later(() => ({
      title: "Guess before you go on",
      text: apart ? "They are apart, that is proven. But how far? Look at the gaps in the table and at the picture: is one of them the distance? Which points are nearest?"
        : "No axis separates them, so they overlap. Which axis is the shortest way to part them, and which way has B to go? Look at the table, say it, then go on.",
      numbers: axisTable(axes, ""),
      says: apart ? "Apart. How far?" : "They overlap. Which way out?",
      draw: paint,
    })));
    return [...steps, ...(apart ? farApart(state, axes) : deep(state, axes))];
  },
  tryThis: [
    { label: "Corner to corner", note: "The widest gap of an axis is less than the distance of the corners: see the last two steps.", state: situation([3.1, 2.5], 0.1) },
    { label: "A gap on the last axis", note: "Three axes overlap, the fourth does not.", state: situation([2.35, -1.95], 0.7853981633974483) },
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
