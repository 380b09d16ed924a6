import { graze } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import { add, scale, sub, unit } from "../parts/vec.ts";
import { convex, plane, type Question, type State, type Vec } from "../question.ts";
import type { Lesson, Step } from "./lesson.ts";
import { supportPrograms } from "./programs.ts";

/** `count` points on an ellipsoid in a golden spiral: all of them are vertices of their hull. */
function points(count: number, radii: Vec): Vec[] {
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count, r = Math.sqrt(1 - y * y), angle = i * Math.PI * (3 - Math.sqrt(5));
    return [radii[0] * r * Math.cos(angle), radii[1] * y, radii[2] * r * Math.sin(angle)];
  });
}
const counts = [20, 100, 1000, 10000];
const shapes: Record<string, Vec> = { egg: [1.3, 0.9, 0.9], needle: [2, 0.02, 0.02] };

interface Built { hull: graze.ConvexHull; points: Vec[]; micros: number; built: number }
const kept = new Map<string, Built>();
/** The hull, and how long one of its support queries takes on this machine. */
function built(count: number, form: string): Built {
  const key = `${count} ${form}`;
  let made = kept.get(key);
  if (!made) {
    const list = points(count, shapes[form]);
    const start = performance.now();
    const hull = new graze.ConvexHull(list);
    const done = performance.now(), rounds = 4000;
    const directions = points(rounds, [1, 1, 1]);
    for (const d of directions) hull.support(d); // once to warm up
    const again = performance.now();
    for (const d of directions) hull.support(d);
    made = { hull, points: list, built: done - start, micros: ((performance.now() - again) * 1000) / rounds };
    kept.set(key, made);
  }
  return made;
}
const situation = (count: number, form: string, direction: Vec): State => ({
  q: { query: "distance", a: { shape: convex(points(20, shapes.egg)) }, b: { shape: plane() } },
  choice: { count, form, x: direction[0], y: direction[1], z: direction[2] },
});
const chosen = (state: State): { count: number; form: string; u: Vec } => {
  const c = state.choice ?? {}, count = Number(c.count), form = String(c.form);
  return { count: counts.includes(count) ? count : 1000, form: shapes[form] ? form : "egg", u: unit([Number(c.x ?? 1), Number(c.y ?? 0), Number(c.z ?? 0)]) };
};

export const hulls: Lesson = {
  id: "hulls", number: 9, title: "Large hulls", question: "Which of ten thousand points is furthest?",
  intro: "GJK asks a hull for its furthest point along a direction, again and again. Looking at every point takes ten thousand products. " +
    "A hierarchy of ever simpler hulls inside each other needs a few dozen. Turn the direction.",
  dimension: 3, view: { center: [0.2, 0, 0], reach: 2 }, start: situation(1000, "egg", [0.8, 0.5, 0.35]),
  choices: [
    { key: "count", label: "Points", options: [1000, 20, 100, 10000].map((value) => ({ value, label: value.toLocaleString("en") })) },
    { key: "form", label: "Shape", options: [{ value: "egg", label: "egg" }, { value: "needle", label: "needle" }] },
  ],
  handles: (s) => [{ id: "direction", label: "Turn the direction", kind: "turn", meaning: "axis", at: scale(chosen(s).u, 1.9) }],
  drag(s, _id, to) {
    const [x, y, z] = unit(to);
    return { ...s, choice: { ...s.choice, x, y, z } };
  },
  asks(state): Question | undefined {
    const { count, form, u } = chosen(state);
    // Ten thousand points make a line of half a megabyte.
    if (count > 1000) return undefined;
    return { query: "distance", a: { shape: convex(points(count, shapes[form])) },
      b: { shape: plane(), translation: scale(u, 10), rotation: turnedDown(u) } };
  },
  code(state) {
    const { count, form, u } = chosen(state);
    return {
      programs: supportPrograms(count, shapes[form], u),
      prints() {
        const p = built(count, form).hull.support(u);
        return [...p, p[0] * u[0] + p[1] * u[1] + p[2] * u[2]];
      },
    };
  },
  steps(state) {
    const { count, form, u } = chosen(state), hull = built(count, form), found = hull.hull.support(u) as Vec;
    const layers = Math.max(1, Math.ceil(Math.log(count / 4) / Math.log(4 / 3)));
    const draw: Step["draw"] = (d) => {
      if (count <= 1000) d.shape({ shape: convex(hull.points) }, "a");
      else d.shape({ shape: { type: "ellipsoid", ellipsoid: { radii: shapes[form] } } }, "a");
      const shown = hull.points.filter((_, i) => i % Math.ceil(count / 400) === 0);
      if (count <= 100) for (const p of shown) d.point(p, "a");
      d.arrow([0, 0, 0], scale(u, 1.8), "axis", { label: "d" });
    };
    const reach = found[0] * u[0] + found[1] * u[1] + found[2] * u[2];
    const steps: Step[] = [{
      title: `${count.toLocaleString("en")} points`,
      text: "The support point is the one with the largest scalar product with d. Without further thought that is one product for every point.",
      formula: ["s(d) = max_i p_i*d", `s(d) = ${digits(reach, 5)}`],
      numbers: { caption: "Support", columns: ["", "value"], rows: [{ cells: ["direction", vector(u, 4)] }, { cells: ["furthest point", vector(found, 5)], mark: "winner" }, { cells: ["reach", reach] }] },
      says: `The furthest point is ${vector(found, 3)}.`,
      draw(d) {
        draw(d);
        d.point(found, "touch", { wide: true, label: "s(d)" });
        const side = unit(Math.abs(u[1]) < 0.9 ? [u[2], 0, -u[0]] : [1, 0, 0]);
        d.line(add(found, scale(side, 0.7)), sub(found, scale(side, 0.7)), "touch", { dashed: true });
      },
    }, {
      title: "Hulls inside hulls",
      text: "Dobkin and Kirkpatrick take away, again and again, points no two of which are neighbours and none of which has many neighbours. Each layer loses at least a fixed share, so there are few layers. The answer of a layer is a neighbour of the answer of the next simpler one, or that answer itself: going down, a handful of points a layer.",
      formula: ["n -> c n -> c^2 n -> ... -> 4", '"products" = O(log n)'],
      numbers: { caption: "Points to look at", columns: ["", "value"], rows: [{ cells: ["all of them", count] }, { cells: ["layers, if a quarter goes each time", layers] }] },
      says: "Layers of a hierarchy.", draw,
    }];
    const measured = counts.map((c) => ({ c, ...built(c, form) }));
    steps.push({
      title: "Measured here and now",
      text: "4,000 support queries by the library in your browser, for hulls of four sizes. Five hundred times the points do not cost five hundred times the time. Each number has the call from JavaScript in it, which is most of it for the small ones.",
      numbers: { caption: "One support query (microseconds), and building the hull (milliseconds)", columns: ["points", "query", "build"], rows: measured.map((m) => ({ cells: [m.c.toLocaleString("en"), Number(m.micros.toPrecision(3)), Number(m.built.toPrecision(3))], mark: m.c === count ? "now" as const : undefined })) },
      graph: { caption: "microseconds for 20, 100, 1,000, 10,000 points", at: counts.indexOf(count), series: [{ name: "a query", meaning: "made", values: measured.map((m) => m.micros) }] },
      says: `A support query takes ${digits(hull.micros, 3)} microseconds.`,
      draw(d) {
        draw(d);
        d.point(found, "touch", { wide: true });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Ten thousand points", note: "The time of a query grows with the logarithm.", state: situation(10000, "egg", [0.8, 0.5, 0.35]) },
    { label: "Twenty points", note: "So small that looking at all of them is the best there is.", state: situation(20, "egg", [0.1, 1, 0.2]) },
  ],
  wrong: [{ label: "A needle", note: "Nearly all points lie nearly on a line: neighbours differ by less than rounding in their products, and a walk from neighbour to neighbour that stops when it gets no better can stop too early.", state: situation(1000, "needle", [0.02, 1, 0.1]) }],
  sources: ["D. Dobkin, D. Kirkpatrick: Determining the separation of preprocessed polyhedra, a unified approach, ICALP 1990", "J. O'Rourke: Computational Geometry in C (1998), section 7.10"],
};

/** The rotation that turns +Y to −u: a half-space that faces the hull. */
function turnedDown(u: Vec): Vec {
  const w = 1 - u[1];
  if (w < 1e-9) return [1, 0, 0, 0];
  return unit([-u[2], 0, u[0], w]);
}
