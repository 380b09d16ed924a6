import { ask } from "../graze.ts";
import { drawDistance } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing, Handle } from "../parts/drawing.ts";
import { row, term } from "../parts/math.ts";
import { add, cross, length, quatAbout, quatBetween, rotate, scale, sub, toWorld, unit } from "../parts/vec.ts";
import { box, copy, plane, sizeOf, type Body, type State, type Vec } from "../question.ts";
import { along, dragBody, drawBodies, moveHandle, radiusWorked, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [0, 1.4, 0], b: [1.7, 0, 0] };
const situation = (translation: Vec, rotation: Vec, planeRotation: Vec = quatAbout([0, 0, 1], 0.15)): State => ({
  q: { query: "distance", a: { shape: plane(), rotation: planeRotation }, b: { shape: box(2, 1, 1.4), translation, rotation } },
});
function corners(body: Body): Vec[] {
  const h = scale(sizeOf(body.shape), 0.5);
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => toWorld(body, [i & 1 ? h[0] : -h[0], i & 2 ? h[1] : -h[1], i & 4 ? h[2] : -h[2]]));
}

// --- The plane by a point, by its distance, by three points ---

const names = ["p", "q", "r"];
const normalOf = (s: State): Vec => rotate(s.q.a.rotation, [0, 1, 0]);
const distanceOf = (s: State): number => along(normalOf(s), s.q.a.translation ?? [0, 0, 0]);
/** The three points: as they were dragged, or three of the plane. */
function threePoints(s: State): Vec[] {
  return names.map((name, i) => {
    const kept = [0, 1, 2].map((k) => s.choice?.[`${name}${k}`]);
    return kept.every((x) => typeof x === "number") ? kept as Vec : toWorld(s.q.a, [[-1.5, 0, 1], [1.5, 0, 1], [0.2, 0, -1.5]][i]);
  });
}
/** The sine of the angle between two sides below which points are on a line: the product's digits are then rounding. */
const flat = 1e-9;
function onALine([p, q, r]: Vec[]): boolean {
  const u = sub(q, p), v = sub(r, p);
  return !(length(cross(u, v)) > flat * length(u) * length(v));
}
function withPoints(state: State, points: Vec[]): State {
  const next = copy(state), [p, q, r] = points;
  next.choice = { ...next.choice, by: "points", ...Object.fromEntries(points.flatMap((x, i) => x.map((v, k) => [`${names[i]}${k}`, Number(v.toPrecision(12))]))) };
  if (!onALine(points)) {
    next.q.a.translation = p;
    next.q.a.rotation = quatBetween([0, 1, 0], unit(cross(sub(q, p), sub(r, p))));
  }
  return next;
}
/** Forgets the three points of a plane that has been moved otherwise. */
function forgetPoints(state: State): State {
  const next = copy(state);
  for (const name of names) for (const k of [0, 1, 2]) delete next.choice?.[`${name}${k}`];
  return next;
}
function planeHandles(s: State): Handle[] {
  const n = normalOf(s), foot = scale(n, distanceOf(s));
  if (s.choice?.by === "points") return threePoints(s).map((at, i) => ({ id: `point-${i}`, label: `Point ${names[i]}`, kind: "move", meaning: "axis", at }));
  if (s.choice?.by === "distance") return [
    { id: "foot", label: "Distance of the plane from the origin", kind: "size", meaning: "axis", at: foot },
    { id: "normal", label: "Turn the plane's normal about the origin", kind: "turn", meaning: "axis", at: add(foot, scale(n, 1.4)) }];
  return [{ ...moveHandle(s, "a"), label: "A point of the plane" }, { ...turnHandle(s, "a", arms.a), label: "Turn the plane's normal" }];
}
function dragPlane(state: State, id: string, to: Vec): State {
  if (id.startsWith("point-")) return withPoints(state, threePoints(state).map((p, i) => (i === Number(id.slice(6)) ? to : p)));
  const next = forgetPoints(state), n = id === "normal" ? unit(to) : normalOf(state), w = id === "foot" ? along(n, to) : distanceOf(state);
  if (id === "normal") next.q.a.rotation = quatBetween([0, 1, 0], n);
  next.q.a.translation = scale(n, Number(w.toPrecision(12)));
  return next;
}

/** The ways to give the plane, with its numbers. */
function given(state: State, base: (d: Drawing) => void): Step {
  const n = normalOf(state), w = distanceOf(state), by = state.choice?.by ?? "point";
  if (by === "points") {
    const [p, q, r] = threePoints(state), line = onALine([p, q, r]), c = cross(sub(q, p), sub(r, p));
    return {
      title: line ? "Three points on a line: no plane" : "By three points",
      text: line ? "p, q and r lie on a line, and every plane through that line has all three in it. The cross product of two sides is zero: it has no direction and cannot be made a unit. " +
          "Close to such a position rounding alone turns the plane. The length of the product says so, before anybody divides by it. Drag a point off the line."
        : "Two sides of the triangle lie in the plane, and their cross product is perpendicular to both: divided by its length it is n. The order of the points says which side is above. Drag them.",
      formula: ["c = (q - p) × (r - p)", `c = ${row(c)}`, ...(line ? [] : ["n = frac(c, |c|)", `n = ${row(n)}`])],
      numbers: { caption: "Points (units of length)", columns: ["point", "place"], rows: [p, q, r].map((x, i) => ({ cells: [names[i], vector(x, 4)], key: `given-${i}` })) },
      says: line ? "Three points on a line." : `A plane through three points, with normal ${vector(n, 3)}, and a box.`,
      draw(d) {
        if (line) d.shape(state.q.b!, "b", { ghost: true });
        else base(d);
        d.line(p, q, line ? "touch" : "axis", { wide: true });
        d.line(p, r, line ? "touch" : "axis", { wide: true });
        [p, q, r].forEach((x, i) => d.point(x, line ? "touch" : "axis", { wide: true, label: names[i], key: `given-${i}` }));
      },
    };
  }
  return {
    title: by === "point" ? "By a normal and a point" : "By a normal and a distance",
    text: (by === "point" ? "Every point x of the plane has the same scalar product with n as the given point p has: that product is w. Drag the point and the normal. "
      : "w says how far the plane is from the origin O, along n. Drag the foot of the way to change w, and the normal to turn the plane about O. ") +
      "Three points say the same: see the buttons beside the picture. Whatever it was given by, the plane is n and w from here on.",
    formula: by === "point" ? ["w = n*p", `w = ${row(n)} * ${row(state.q.a.translation ?? [0, 0, 0])} = ${digits(w, 4)}`] : ["n*x = w", `n = ${row(n)}`, `w = ${digits(w, 4)}`],
    says: `A plane with normal ${vector(n, 3)}, ${digits(w, 4)} from the origin, and a box.`,
    draw(d) {
      base(d);
      if (by === "point") return;
      d.point([0, 0, 0], "ink", { wide: true, label: "O" });
      d.line([0, 0, 0], scale(n, w), "axis", { wide: true, label: "w" });
    },
  };
}

export const planesBoxes: Lesson = {
  id: "planes-boxes", number: 2, title: "Planes and boxes", question: "Is the box above the plane?",
  intro: "A plane is a unit normal n and a distance w. Put a point into it and out comes the point's signed distance. A box has eight corners, and yet needs none of them.",
  dimension: 3, view: { center: [0.2, 0.7, 0], reach: 2.4, from: [0.25, 0.22, 1] }, start: situation([0.3, 1.3, 0.1], quatAbout([0.3, 0.2, 1], 0.7)),
  choices: [{ key: "by", label: "The plane by", options: [{ value: "point", label: "normal and point" }, { value: "distance", label: "normal and distance" }, { value: "points", label: "three points" }] }],
  handles: (s) => [...planeHandles(s), moveHandle(s, "b"), turnHandle(s, "b", arms.b), sizeHandle(s, "b")],
  drag: (s, id, to) => /^(point-|foot|normal)/.test(id) ? dragPlane(s, id, to) : dragBody(id.endsWith("-a") ? forgetPoints(s) : s, id, to, arms),
  steps(state) {
    const { q } = state, answer = ask(q), b = q.b!;
    const n = normalOf(state), w = distanceOf(state);
    const points = corners(b), measured = points.map((p) => ask({ query: "closest", a: q.a, point: p }));
    const axis = answer.trace.axes.find((x) => x.name === "normal");
    const [low, high] = [Number(axis?.b[0]), Number(axis?.b[1])], top = Number(axis?.a[1]);
    const base = (d: Drawing): void => {
      drawBodies(d, q);
      d.arrow(q.a.translation ?? [0, 0, 0], add(q.a.translation ?? [0, 0, 0], n), "axis", { wide: true, label: "n" });
    };
    const best = measured.reduce((m, x, i) => (x.distance! < measured[m].distance! ? i : m), 0);
    const steps: Step[] = [given(state, base)];
    if (state.choice?.by === "points" && onALine(threePoints(state))) return steps;
    points.forEach((p, i) => steps.push({
      title: `Corner ${i + 1}`,
      text: "Its signed distance from the plane: positive above, negative below. The smallest of the eight is the box's." + (i === 7 ? ` It is that of corner ${best + 1}.` : ""),
      formula: ["d = n*x - w", `d_${i + 1} = ${row(n)} * ${row(p)} - ${term(w, 3)} = ${digits(measured[i].distance, 5)}`],
      numbers: { caption: "Corners (units of length)", columns: ["corner", "point", "distance"], rows: points.slice(0, i + 1).map((x, k) => ({ cells: [String(k + 1), vector(x, 3), measured[k].distance!], key: `corner-${k}`, mark: i === 7 && k === best ? "winner" as const : k === i ? "now" as const : undefined })) },
      says: `Corner ${i + 1}: ${digits(measured[i].distance, 4)}.`,
      draw(d) {
        base(d);
        points.slice(0, i + 1).forEach((x, k) => d.point(x, measured[k].distance! <= 0 ? "touch" : "b", { key: `corner-${k}`, wide: k === i }));
        d.line(p, measured[i].point!, "made", { wide: true });
      },
    }));
    const center = (low + high) / 2 - top, radius = (high - low) / 2;
    steps.push({
      title: "The projected radius",
      text: "No corner is needed. Seen along the normal, the box reaches to both sides of its centre by the sum of its half sizes, each weighted by how far its edge points along the normal. The centre's distance minus that radius is the same number.",
      formula: ["r = h_x |n*e_x| + h_y |n*e_y| + h_z |n*e_z|", radiusWorked("r", b, n, radius), `d = ${digits(center, 5)} - ${digits(radius, 5)} = ${digits(answer.distance, 5)}`],
      numbers: { caption: "Both ways (units of length)", columns: ["quantity", "distance"], rows: [{ cells: ["centre", center] }, { cells: ["radius", radius] }, { cells: ["centre − radius", answer.distance!], mark: "winner" }, { cells: ["smallest corner", measured[best].distance!], mark: "winner" }] },
      says: `Distance ${digits(answer.distance, 5)}: centre ${digits(center, 4)} minus radius ${digits(radius, 4)}.`,
      draw(d) {
        base(d);
        const c = b.translation!;
        d.line(c, sub(c, scale(n, radius)), "b", { wide: true, label: "r" });
        d.line(sub(c, scale(n, radius)), sub(c, scale(n, center)), "touch", { wide: true, label: "d" });
        drawDistance(d, answer, { look: { wide: true } });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Flat above it", note: "Four corners are equally near.", state: situation([0, 0.8, 0], [0, 0, 0, 1], [0, 0, 0, 1]) },
    { label: "Through it", note: "Some corners below: the distance is negative, and is the depth.", state: situation([0.3, 0.4, 0.1], quatAbout([0.3, 0.2, 1], 0.7)) },
  ],
  wrong: [
    { label: "Three points on a line", note: "They are in many planes at once. The cross product vanishes, and dividing by its length gives not-a-number.",
      state: withPoints(situation([0.3, 1.3, 0.1], quatAbout([0.3, 0.2, 1], 0.7)), [[-1.6, -0.4, 0.8], [0, 0, 0.3], [1.6, 0.4, -0.2]]) },
    { label: "Just a corner", note: "The plane passes through a corner: the distance is zero up to rounding, and zero counts as touching. Nobody may depend on its sign.", state: situation([0, Math.SQRT2 / 2 * 1.5, 0], quatAbout([0, 0, 1], Math.PI / 4), [0, 0, 0, 1]) },
  ],
  sources: ["C. Ericson: Real-Time Collision Detection (2005), section 5.2.3", "L. O. Hesse: Vorlesungen über analytische Geometrie (1861)"],
};
