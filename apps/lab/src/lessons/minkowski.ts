import { ask, type Support } from "../graze.ts";
import { drawDistance, drawTrace } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing, Handle } from "../parts/drawing.ts";
import { row } from "../parts/math.ts";
import { corners } from "../parts/outline.ts";
import { add, dot, length, mix, scale, sub, unit } from "../parts/vec.ts";
import { box, convex, copy, type Body, type Question, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, turnHandle, numberOf, type Lesson, type Step } from "./lesson.ts";

/** The place at which the origin of the difference is drawn, so that it lies beside the shapes. */
const home: Vec = [1, -4.6];
const arms = { a: [1.5, 0], b: [1.5, 0] };
const situation = (translation: Vec, rotation: number, direction: Vec = [0.8, 0.6]): State => ({
  q: { query: "distance", dimension: 2,
    a: { shape: convex([[-1.1, -0.8], [0.9, -0.9], [1.2, 0.4], [-0.2, 1.1]]) }, b: { shape: box(1.6, 1.2), translation, rotation } },
  choice: { what: "difference", x: direction[0], y: direction[1] },
});

/** The body with all points a of it mirrored to −a, so that the difference with B is the sum. */
function mirrored(body: Body): Body {
  return { shape: convex(corners(body, 9).map((p) => scale(p, -1))) };
}
const asked = (state: State): Question =>
  state.choice?.what === "sum" ? { ...copy(state.q), a: mirrored(state.q.a) } : state.q;

/** A point of A furthest along `direction`: the nearest to a far half-plane that faces A. */
function support(body: Body, direction: Vec): Vec {
  const u = unit(direction);
  const answer = ask({ query: "distance", dimension: 2, a: body,
    b: { shape: { type: "plane" }, translation: add(body.translation ?? [0, 0], scale(u, 50)), rotation: Math.atan2(-u[1], -u[0]) - Math.PI / 2 } });
  return answer.a as unknown as Vec;
}

const flat = (p: Vec): Vec => [p[0], p[1]];
/** The place at which a point of the difference B − A is drawn. */
export const place = (s: Support): Vec => add(home, flat(sub(s.b, s.a)));
export { home };

/** The place on an outline of the point nearest to another: the number of a corner and the part of the way to the
 *  next. */
function nearestOn(outline: Vec[], to: Vec): number {
  let best = 0, least = Infinity;
  outline.forEach((p, k) => {
    const side = sub(outline[(k + 1) % outline.length], p), t = Math.max(0, Math.min(0.9999, dot(sub(to, p), side) / dot(side, side)));
    const away = length(sub(to, add(p, scale(side, t))));
    if (away < least) [best, least] = [k + t, away];
  });
  return best;
}
/** The point at a place of the outline, made of a part of A and one of B. */
function pointAt(corners: Support[], at: number): Support {
  const n = corners.length, k = ((Math.floor(at) % n) + n) % n, next = corners[(k + 1) % corners.length];
  return { a: mix(corners[k].a, next.a, at - Math.floor(at)), b: mix(corners[k].b, next.b, at - Math.floor(at)) };
}
/** The direction of the support step. */
const directionOf = (state: State): Vec => unit([numberOf(state, "x", 1), numberOf(state, "y", 0)]);
const slideOf = (state: State): number => numberOf(state, "slide", 0.4);

export function drawOrigin(d: Drawing, at: Vec = home): void {
  d.line(add(at, [-0.18, 0]), add(at, [0.18, 0]), "ink", { wide: true });
  d.line(add(at, [0, -0.18]), add(at, [0, 0.18]), "ink", { wide: true });
  d.text(at, "O", "ink");
}

/** B in touch with A at a point of the outline: the outline as far as it grew, and the places of B at its corners. */
function sliding(state: State, corners: Support[]): Step {
  const at = slideOf(state), sum = state.choice?.what === "sum", shape = corners.map(place), b = state.q.b!, made = pointAt(corners, at);
  const passed = shape.slice(0, Math.floor(at) + 1);
  /** B where it makes a point of the outline. In the sum A's point carries it instead, beside O. */
  const moved = (s: Support): Body => ({ ...b, translation: add(b.translation!, sum ? sub(home, flat(s.a)) : sub(flat(s.a), flat(s.b))) });
  const apart = sum ? null : ask({ ...state.q, b: moved(made) }).distance!;
  return {
    title: sum ? "A carries B round" : "B slides round A",
    text: sum ? "Drag the point on the outline. B's origin goes round A, and what B reaches on its way is the sum: the outline follows a side of A while the same corner of B leads, and a side of B at each corner of A."
      : "Drag the point on the outline. B slides round A without turning and without leaving it; what is drawn is how far B has to go from there to where it stands. Where B's corner slides along a side of A, the outline has that side; where A's corner slides along a side of B, that one.",
    formula: [sum ? "p = a + b" : "p = b - a", `p = ${row(flat(sub(made.b, made.a)), 4)}`],
    numbers: { caption: "There (units of length)", columns: ["quantity", "value"], rows: [
      { cells: ["of A", vector(sum ? scale(flat(made.a), -1) : flat(made.a), 4)] }, { cells: ["of B", vector(flat(made.b), 4)] },
      { cells: ["p", vector(flat(sub(made.b, made.a)), 4)], mark: "winner" },
      ...(apart === null ? [] : [{ cells: ["distance of A and the moved B", Math.abs(apart) < 1e-12 ? 0 : apart] }])] },
    handles: ["slide"],
    says: `The point ${vector(flat(sub(made.b, made.a)), 3)} of the outline, after ${passed.length} of ${shape.length} corners.`,
    draw(d) {
      drawBodies(d, state.q);
      corners.slice(0, passed.length).forEach((corner) => d.shape(moved(corner), "b", { ghost: true }));
      d.shape(moved(made), "b");
      [...passed, place(made)].forEach((p, i, all) => i > 0 && d.line(all[i - 1], p, "made", { wide: true }));
      drawTrace(d, { difference: corners }, { by: home, look: { ghost: true }, as: { ruledOut: "made" } });
      d.point(place(made), "made", { wide: true, label: "p" });
      if (!sum) d.point(flat(made.a), "touch", { wide: true });
      drawOrigin(d);
    },
  };
}

export const minkowski: Lesson = {
  id: "minkowski",
  number: 6,
  title: "Minkowski sum and difference",
  question: "What single shape knows whether two shapes touch?",
  intro:
    "Take every point of B minus every point of A. The result is one convex shape, and it contains the origin exactly when A and B " +
    "have a point in common. Move B and watch the difference move with it.",
  dimension: 2,
  view: { center: [1.2, -1.75], reach: 6 },
  start: situation([2.9, 0.9], 0.5),
  choices: [{ key: "what", label: "Show", options: [{ value: "difference", label: "difference B ⊖ A" }, { value: "sum", label: "sum A ⊕ B" }] }],
  handles(s): Handle[] {
    const outline = ask(asked(s)).trace.difference ?? [];
    return [
      ...(outline.length > 0 ? [{ id: "slide", label: "Slide B round A", kind: "move" as const, meaning: "made" as const, named: true, at: place(pointAt(outline, slideOf(s))) }] : []),
      moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b),
      { id: "direction", label: "Turn the direction", kind: "turn", meaning: "axis", named: true, at: add(home, scale(directionOf(s), 2.3)) },
    ];
  },
  drag(s, id, to) {
    if (id === "slide") return { ...s, choice: { ...s.choice, slide: nearestOn((ask(asked(s)).trace.difference ?? []).map(place), to) } };
    if (id !== "direction") return dragBody(s, id, to, arms);
    const u = unit(sub(to, home));
    return { ...s, choice: { ...s.choice, x: u[0], y: u[1] } };
  },
  asks: asked,
  steps(state) {
    const q = asked(state), sum = state.choice?.what === "sum";
    const answer = ask(q);
    const corners = answer.trace.difference ?? [];
    const shape = corners.map(place);
    const word = sum ? "sum" : "difference", sign = sum ? "a + b" : "b - a";
    const ofA = (p: Vec): Vec => (sum ? scale(flat(p), -1) : flat(p));
    const steps: Step[] = [{
      title: sum ? "A ⊕ B: all sums" : "B ⊖ A: all differences",
      text: `The ${word} of two convex polygons is a convex polygon. Each of its ${corners.length} corners is made of one corner of A and one of B; each of its ` +
        `sides is a side of A or of B. ` + (sum ? "It is what B sweeps when its origin is moved all over A."
        : answer.distance! <= 0 ? "The origin O lies inside: the shapes overlap." : "The origin O lies outside: the shapes are apart."),
      formula: [sum ? 'A ⊕ B = { "{" a + b "|" a in A, b in B "}" }' : 'B ⊖ A = { "{" b - a "|" a in A, b in B "}" }'],
      says: `The ${word} has ${corners.length} corners.`,
      draw(d) {
        drawBodies(d, state.q);
        d.polygon(shape, "made", { fill: true });
        drawOrigin(d);
      },
    }];
    if (corners.length > 0) steps.push(sliding(state, corners));
    corners.forEach((corner, i) => {
      const next = corners[(i + 1) % corners.length];
      const fromB = length(sub(next.b, corner.b)) > length(sub(next.a, corner.a));
      steps.push({
        title: `Corner ${i + 1} of ${corners.length}`,
        text: `This corner is made of the two marked corners. On to the next one the outline follows a side of ${fromB ? "B" : "A"}: as one shape slides ` +
          `round the other, sides of both follow each other in the order of their directions.`,
        formula: [`c = ${sign}`, `${row(sum ? ofA(corner.a) : flat(corner.b), 4)} ${sum ? "+" : "-"} ${row(sum ? flat(corner.b) : flat(corner.a), 4)} = ${row(flat(sub(corner.b, corner.a)), 4)}`],
        numbers: {
          caption: `Corners of the ${word} (units of length)`, columns: ["corner", "of A", "of B", "made"],
          rows: corners.slice(0, i + 1).map((c, k) => ({
            cells: [String(k + 1), ofA(c.a), flat(c.b), flat(sub(c.b, c.a))], key: `corner-${k}`, mark: k === i ? "now" as const : undefined })),
        },
        says: `Corner ${i + 1} at ${vector(flat(sub(corner.b, corner.a)), 3)}.`,
        draw(d) {
          drawBodies(d, state.q);
          for (let k = 0; k <= i; k++) {
            d.line(shape[k], shape[(k + 1) % shape.length], "made", { wide: k === i });
            d.point(shape[k], "made", { key: `corner-${k}` });
          }
          d.point(ofA(corner.a), "a", { wide: true, label: "a" });
          d.point(flat(corner.b), "b", { wide: true, label: "b" });
          d.point(shape[i], "made", { wide: true, label: sign.replace("-", "−") });
          if (!sum) {
            // B moved so that its corner touches A's: the difference grows as one slides round the other.
            const b = state.q.b!;
            d.shape({ ...b, translation: add(b.translation!, sub(flat(corner.a), flat(corner.b))) }, "b", { ghost: true });
          }
          drawOrigin(d);
        },
      });
    });
    const u = directionOf(state);
    const a = support(state.q.a, sum ? u : scale(u, -1)), b = support(state.q.b!, u);
    const made = sum ? add(a, b) : sub(b, a);
    steps.push({
      title: "Support: furthest along a direction",
      text: `Nobody has to build the ${word}. Its point furthest along a direction d is made of B's point furthest along d and A's furthest along ` +
        `${sum ? "d" : "−d"}. Turn d with the handle. GJK asks for nothing else.`,
      formula: [sum ? "s(d) = s_A(d) + s_B(d)" : "s(d) = s_B(d) - s_A(-d)", `s = [${made.map((x) => digits(x, 4)).join(", ")}]`],
      numbers: { caption: "Support points (units of length)", columns: ["of", "point"], rows: [
        { cells: ["A", vector(a, 5)] }, { cells: ["B", vector(b, 5)] }, { cells: [word, vector(made, 5)], mark: "winner" }] },
      handles: ["direction"],
      says: `Furthest along ${vector(u, 2)}: ${vector(made, 3)}.`,
      draw(d) {
        drawBodies(d, state.q);
        d.polygon(shape, "made", { fill: true });
        drawOrigin(d);
        d.arrow(home, add(home, scale(u, 2)), "axis", { label: "d" });
        d.arrow(a, add(a, scale(u, sum ? 0.8 : -0.8)), "a");
        d.arrow(b, add(b, scale(u, 0.8)), "b");
        d.point(a, "a", { wide: true });
        d.point(b, "b", { wide: true });
        d.point(add(home, made), "touch", { wide: true, label: "s" });
      },
    });
    if (!sum) {
      const apart = answer.distance! > 0, near = add(home, scale(answer.normal!, answer.distance!));
      steps.push({
        title: apart ? "The distance is that of the origin" : "The depth is that of the origin",
        text: apart ? "The point of the difference nearest to the origin is the shortest vector from A to B: its length is the distance, its direction the normal."
          : "Inside, the way out of the difference is the way apart: the nearest point of its boundary gives depth and normal.",
        formula: [apart ? "d = min |b - a|" : "d = - min |p|", `d = ${digits(answer.distance, 6)}`],
        says: `Signed distance ${digits(answer.distance, 5)}.`,
        draw(d) {
          drawBodies(d, state.q);
          d.polygon(shape, "made", { fill: true });
          drawOrigin(d);
          d.arrow(home, near, "touch", { wide: true, label: "d·n" });
          drawDistance(d, answer, { look: { wide: true } });
        },
      });
    }
    return steps;
  },
  tryThis: [
    { label: "Touching", note: "The origin lies on the boundary.", state: situation([1.9, 0.2], 0) },
    { label: "Deep inside", note: "The origin is well within the difference.", state: situation([0.4, 0.3], 0.8) },
  ],
  wrong: [{ label: "Parallel sides", note: "A side of A and one of B point the same way. In the outline they merge into one long side, and every point of it is a support point: an algorithm has to take either without going in circles.", state: { ...situation([2.6, 0.2], 0), q: { ...situation([2.6, 0.2], 0).q, a: { shape: box(2, 1.6) } } } }],
  sources: ["H. Minkowski: Volumen und Oberfläche, Mathematische Annalen 57 (1903)", "T. Lozano-Pérez: Spatial planning: a configuration space approach, IEEE Transactions on Computers 32 (1983)"],
};
