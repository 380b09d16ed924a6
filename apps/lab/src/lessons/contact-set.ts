import { ask, fewest, type Answer, type Axis, type ContactPoint, type Cut } from "../graze.ts";
import { drawDistance, drawTrace } from "../parts/answers.ts";
import { digits, sentence } from "../parts/dom.ts";
import { featureWords } from "../parts/features.ts";
import { row, term } from "../parts/math.ts";
import { add, cross, inverse, length, quatAbout, rotate, scale, sub, toWorld } from "../parts/vec.ts";
import { box, convex, sizeOf, type Body, type State, type Vec } from "../question.ts";
import { along, dragBody, drawBodies, drawContacts, later, moveHandle, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";
import { before, planeAcross } from "./lines.ts";

const arms = { a: [2.1, 0, 0], b: [1.5, 0, 0] };
const situation = (translation: Vec, rotation: Vec): State => ({
  q: { query: "contacts", margin: 0.02, a: { shape: box(3, 1, 2.4), translation: [0, -0.5, 0] },
    b: { shape: box(1.8, 1.2, 1.6), translation, rotation } },
});

const told = (before: number, after: number): string =>
  before === after ? "The number of corners stays." : after === 0 ? "Nothing is left." : `Of ${before} corners it makes ${after}.`;
/** The ends of a box's edge by the half of a feature id that names one: low · 127 + high of two corners. */
function edgeOf(body: Body, bits: number): [Vec, Vec] {
  const half = scale(sizeOf(body.shape), 0.5), edge = bits & 0x3fff;
  const corner = (i: number): Vec => toWorld(body, half.map((x, k) => (i & (1 << k) ? x : -x)));
  return [corner(Math.floor(edge / 127)), corner(edge % 127)];
}
/** The two edges that make a point. */
function crossing(q: State["q"], feature: string): { a: [Vec, Vec]; b: [Vec, Vec] } | null {
  const id = Number.parseInt(feature, 16), [a, b] = [Math.floor(id / 65536), id & 0xffff];
  return a >> 14 === 2 && b >> 14 === 2 ? { a: edgeOf(q.a, a), b: edgeOf(q.b!, b) } : null;
}
/** The product of edges that overlaps least of all axes, and where these edges come nearest to each other; none where a
 *  face's axis has the least, or the trace has no axes. */
function leastByEdges({ a, b }: State["q"], axes: Axis[]): { name: string; overlap: number; edges: Record<"a" | "b", [Vec, Vec]>; at: Record<"a" | "b", Vec> } | null {
  const tried = axes.filter((x) => x.name !== "normal"), least = tried.reduce((best, x) => (x.overlap < best.overlap ? x : best), tried[0]);
  const named = least && /^A(\d)×B(\d)$/.exec(least.name);
  if (!named) return null;
  const toB = sub(b!.translation!, a.translation!), outward = least.direction.reduce((sum, x, k) => sum + x * toB[k], 0) < 0 ? -1 : 1;
  /** The edge along an axis of the box that lies furthest along a direction. */
  const edge = (body: Body, along: number, sign: number): [Vec, Vec] => {
    const half = scale(sizeOf(body.shape), 0.5), u = rotate(inverse(body.rotation), scale(least.direction, sign));
    const end = (x: number): Vec => toWorld(body, half.map((h, k) => (k === along ? x * h : u[k] < 0 ? -h : h)));
    return [end(-1), end(1)];
  };
  const edges = { a: edge(a, Number(named[1]), outward), b: edge(b!, Number(named[2]), -outward) };
  const nearest = ask({ query: "distance", a: { shape: convex(edges.a) }, b: { shape: convex(edges.b) } });
  return { name: least.name, overlap: least.overlap, edges, at: { a: nearest.a as unknown as Vec, b: nearest.b as unknown as Vec } };
}
/** The points that would be left if the least overlap alone decided. */
function withoutPreference(q: State["q"], { trace, manifolds }: Answer): Step {
  const least = leastByEdges(q, trace.axes), points = manifolds?.[0]?.points ?? [];
  const goes = least !== null && points.length > 1;
  return {
    title: goes ? `${points.length} points go, one is left` : "The points stay",
    text: (least ? `The least overlap is that of ${least.name}, a product of two edges: without the preference for faces the contact would be where these edges come nearest to each other, a single point. ` +
      (goes ? "On it no box stands: it tips, a face has the least overlap in the next frame, and so on. The library therefore takes an edge only where its overlap is less than that of the best face by more than 1/200 of the smaller box." : "The library takes the edges here, too: no face is nearly as good.")
      : "The least overlap is that of a face, which is taken with the preference and without it. Try \"An edge wins by a hair\".") +
      " The preference is a constant of the library's routines, none of its settings: this is worked out from the trace.",
    numbers: { caption: "Points of contact (units of length)", columns: ["by", "points", "least overlap"], rows: [
      { cells: [`the library: ${trace.winner ?? ""}`, points.length, trace.axes.find((x) => x.name === trace.winner)?.overlap ?? ""], mark: "winner" },
      ...(least ? [{ cells: [`least overlap alone: ${least.name}`, 1, least.overlap], mark: "out" as const }] : [])] },
    says: least ? `By the least overlap alone one point is left of ${points.length}.` : "A face has the least overlap.",
    draw(d) {
      drawBodies(d, q, true);
      points.forEach((p) => d.point(p.a, goes ? "out" : "touch", { wide: true }));
      if (!least) return;
      d.line(...least.edges.a, "a", { wide: true });
      d.line(...least.edges.b, "b", { wide: true });
      d.point(least.at.a, "a", { wide: true, label: "a" });
      d.point(least.at.b, "b", { wide: true, label: "b" });
    },
  };
}
/** How far the face of a box that looks most along the normal does so: its faces come in pairs, so the sign is that of
 *  the better one. */
function facing(axes: Axis[], n: Vec, which: "A" | "B"): string[] {
  const own = axes.filter((x) => new RegExp(`^${which}\\d$`).test(x.name)).map(({ direction }) => ({ direction, along: along(direction, n) }));
  if (own.length === 0) return [];
  const best = own.reduce((most, x) => (Math.abs(x.along) > Math.abs(most.along) ? x : most)), outward = which === "A" ? 1 : -1;
  const face = scale(best.direction, best.along * outward < 0 ? -1 : 1);
  return [`k_${which} = ${outward < 0 ? "-" : ""}${row(n)} * ${row(face)} = ${digits(Math.abs(best.along), 6)}`];
}
/** The numbers of the first edge that a cut crosses: how far its ends are from the plane of the cut, and the new
 *  corner; none where the cut made no corner, as only rounding put an edge's ends on both sides. */
function crossed(corners: Vec[], cut: Cut, n: Vec): string[] {
  const side = planeAcross(cut.from, cross(sub(cut.to, cut.from), n)), ahead = corners.map((p) => before(side, p));
  const size = Math.max(...corners.map((p) => length(sub(p, corners[0])))), rounding = 1e-9 * size;
  const fresh = cut.left.filter((p) => corners.every((x) => length(sub(x, p)) > rounding));
  for (const [i, from] of fresh.length > 0 ? corners.entries() : []) {
    const k = (i + 1) % corners.length, to = corners[k], [first, second] = [ahead[i], ahead[k]];
    if (Math.abs(first) <= rounding || Math.abs(second) <= rounding || first * second > 0) continue;
    const edge = length(sub(to, from)), off = (p: Vec): number => Math.abs(length(sub(p, from)) + length(sub(to, p)) - edge);
    const made = fresh.reduce((best, p) => (off(p) < off(best) ? p : best));
    return [`t = frac(${digits(first, 4)}, ${digits(first, 4)} - ${term(second)}) = ${digits(length(sub(made, from)) / edge, 5)}`, `p = ${row(made)}`];
  }
  return ['"no edge is crossed"'];
}
const table = (points: ContactPoint[], now: number): Step["numbers"] => ({
  caption: "Points of contact (units of length)", columns: ["point", "distance", "features"],
  rows: points.map((p, i) => ({ cells: [`${i + 1}`, p.distance, featureWords(p.feature)], key: `point-${i}`, mark: i === now ? "now" as const : undefined })),
});

/** The least overlap is that of two edges, and a face is nearly as good. */
const hair = situation([0.2, 0.58, 0.1], quatAbout([0.2, 1, 0.1], 0.5).map((x, i) => (i === 0 ? 0.002 : i === 2 ? 0.003 : x)));

export const contactSet: Lesson = {
  id: "contact-set", number: 5, title: "The contact set", question: "Where do two boxes touch?",
  intro: "A normal and a depth are not enough to stand on. A solver wants the whole area of contact, as points whose names stay the same from frame to frame.",
  dimension: 3, view: { center: [0.1, 0.2, 0], reach: 2.4, from: [0.5, 0.45, 1] }, start: situation([0.7, 0.585, 0.5], quatAbout([0, 1, 0], 0.45)),
  choices: [{ key: "faces", label: "Faces", options: [{ value: "preferred", label: "preferred" }, { value: "least", label: "least overlap alone" }] }],
  handles: (s) => [moveHandle(s, "a"), moveHandle(s, "b"), turnHandle(s, "b", arms.b), sizeHandle(s, "b")],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state, answer = ask(q), manifold = answer.manifolds?.[0];
    const steps: Step[] = [{
      title: "An axis for the contacts",
      text: manifold ? `${sentence(answer.trace.reason ?? answer.trace.winner ?? "")} The axis that decides whether boxes overlap and the axis on which contacts stand are two questions: a face that is nearly as good as an edge is taken, because a box at rest leans by thousandths and would flicker between them.`
        : "They are further apart than the margin: there is no contact. Move B down.",
      numbers: { caption: "Shadows on the axes (units of length)", columns: ["axis", "overlap", "gap"], rows: answer.trace.axes.filter((x) => x.name !== "normal").map((x) => ({ cells: [x.name, x.overlap < 0 ? "" : x.overlap, x.overlap < 0 ? -x.overlap : ""], key: x.name, mark: x.name === answer.trace.winner ? "winner" as const : undefined })) },
      says: manifold ? `Contacts stand on ${answer.trace.winner}.` : "No contact.",
      draw(d) {
        drawBodies(d, q);
        if (manifold) drawContacts(d, [manifold]);
      },
    }];
    if (!manifold) return steps;
    if (state.choice?.faces === "least") return [...steps, withoutPreference(q, answer)];
    // One point of two edges on the axis of their product: the nearest points of the edges, whatever clipping would
    // find.
    const edges = manifold.points.length === 1 && answer.trace.winner?.includes("×") ? crossing(q, manifold.points[0].feature) : null;
    const faces = edges ? undefined : answer.trace.faces, cuts = edges ? [] : (answer.trace.cuts ?? []);
    const near = (face: Vec[], p: Vec): number => Math.min(...face.map((x) => length(sub(x, p))));
    const byB = !faces || !cuts[0] || near(faces.b, cuts[0].from) <= near(faces.a, cuts[0].from);
    const [reference, incident] = byB ? ["b", "a"] as const : ["a", "b"] as const;
    if (edges) steps.push({
      title: "Two edges cross",
      text: `The axis ${answer.trace.winner} is a product of two edges, and the contact is where these cross: the point of A's edge and the point of B's edge that are nearest to each other ` +
        "as seen along n. There is one point, and the boxes can turn about it. " + (answer.trace.faces
          ? "The faces beside the edges lean away from each other: cutting them finds this point and no other within the margin, and is left out here."
          : "Cutting the faces beside the edges finds nothing as deep."),
      formula: ["n*(b - a) = d", `d = ${digits(manifold.points[0].distance, 6)}`],
      numbers: table(manifold.points, 0),
      says: "An edge of A and an edge of B cross in one point.",
      draw(d) {
        drawBodies(d, q, true);
        d.line(...edges.a, "a", { wide: true });
        d.line(...edges.b, "b", { wide: true });
        drawDistance(d, manifold.points[0], { look: { wide: true } });
        drawContacts(d, [manifold]);
      },
    });
    if (faces) steps.push({
      title: "Reference and incident face",
      text: `On each box the face that looks most along the normal. One of them is the reference face, here ${reference.toUpperCase()}'s, the other the incident face, here ${incident.toUpperCase()}'s, which is cut by the planes through the sides of the reference face, side by side. What is left in both and no further apart than the margin is the area of contact.`,
      formula: ["k_A = max_i n*n_i", "k_B = max_i -n*n_i", ...(["A", "B"] as const).flatMap((which) => facing(answer.trace.axes, manifold.normal, which))],
      says: "The two faces that meet.",
      draw(d) {
        drawBodies(d, q, true);
        d.polygon(faces.a, "a", { ghost: true });
        d.polygon(faces.b, "b", { ghost: true });
        drawTrace(d, { faces }, { look: { wide: true } });
      },
    });
    cuts.forEach((cut, i) => steps.push(later(() => ({
      title: `Cut ${i + 1} of ${cuts.length}`,
      text: `The plane through ${i === 0 ? "one side" : "the next side"} of the reference face. Of the incident face what lies beyond it goes: a corner that is inside stays, and where an edge crosses the plane a new corner comes. ` + told(i === 0 ? faces![incident].length : cuts[i - 1].left.length, cut.left.length),
      formula: ["t = frac(d_1, d_1 - d_2)", "p = p_1 + t (p_2 - p_1)", ...crossed(i === 0 ? faces![incident] : cuts[i - 1].left, cut, manifold.normal)],
      numbers: { caption: "Corners that are left", columns: ["cut", "corners"], rows: cuts.slice(0, i + 1).map((c, k) => ({ cells: [`${k + 1}`, `${c.left.length}`], key: `cut-${k}`, mark: k === i ? "now" as const : undefined })) },
      says: `After cut ${i + 1} the incident face has ${cut.left.length} corners.`,
      draw(d) {
        drawBodies(d, q, true);
        d.polygon(faces![reference], reference, { ghost: true });
        d.polygon(i === 0 ? faces![incident] : cuts[i - 1].left, incident, { ghost: true });
        drawTrace(d, { cuts: [cut] }, { look: { wide: true, key: `cut-${i}` }, points: () => ({}), contact: () => "axis", as: { normal: reference, contact: incident } }, 0);
      },
    }))));
    manifold.points.forEach((p, i) => steps.push({
      title: `Point ${i + 1}: ${featureWords(p.feature)}`,
      text: `The name of a point says which feature of A and which of B it lies on. As long as these touch, the name stays and the solver starts with the impulse of the frame before. ` +
        (p.distance > 0 ? "Its distance is positive: within the margin, kept so that it does not come and go." : `Here B is ${digits(-p.distance, 4)} deep.`),
      formula: ["b - a = d n", `d = ${digits(p.distance, 6)}`],
      numbers: table(manifold.points.slice(0, i + 1), i),
      says: `Point ${i + 1}: ${featureWords(p.feature)}, distance ${digits(p.distance, 4)}.`,
      draw(d) {
        drawBodies(d, q, true);
        if (faces) {
          d.polygon(faces.a, "a", { ghost: true });
          d.polygon(faces.b, "b", { ghost: true });
        }
        manifold.points.slice(0, i + 1).forEach((x, k) => d.point(x.a, k === i ? "touch" : "axis", { wide: k === i, key: `point-${k}` }));
      },
    }));
    const four = fewest(q, 4);
    steps.push({
      title: "Reduction",
      text: manifold.points.length > 4 ? `${manifold.points.length} points span the area. Four that span nearly as much of it do for most solvers: ${four.length} are kept (red), the rest is redundant. All of them are there for who wants them.`
        : edges ? "A single point needs no reduction." : "Four points or fewer need no reduction. Turn B about the vertical until the area has more corners.",
      numbers: table(manifold.points, -1),
      says: `${manifold.points.length} points, reduced to ${four.length}.`,
      draw(d) {
        drawBodies(d, q, true);
        d.polygon(manifold.points.map((p) => p.a), "made", {});
        manifold.points.forEach((p, k) => d.point(p.a, "axis", { key: `point-${k}` }));
        four.forEach((p) => d.point(p, "touch", { wide: true }));
        d.arrow(manifold.points[0].a, add(manifold.points[0].a, scale(manifold.normal, 0.8)), "axis", { label: "n" });
      },
    }, {
      title: "When faces say too little",
      text: "Erleben's rules: if corners of one box lie inside the other, they are the contacts. If none does, two edges cross, and the nearest points of these edges are the contact" + (edges ? ", as here" : "") + ". Only where cutting finds nothing as deep as the axis says does the library fall back to those nearest points.",
      numbers: table(manifold.points, -1),
      says: "The whole contact set.",
      draw(d) {
        drawBodies(d, q);
        drawContacts(d, [manifold]);
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Flat on it", note: "Four corners of B inside the face of A.", state: situation([0, 0.59, 0], [0, 0, 0, 1]) },
    { label: "Eight corners", note: "Two squares turned by 45°: an octagon.", state: { q: { ...situation([0, 0.59, 0], quatAbout([0, 1, 0], 0.785398)).q, a: { shape: box(2, 1, 2), translation: [0, -0.5, 0] }, b: { shape: box(2, 1.2, 2), translation: [0, 0.59, 0], rotation: quatAbout([0, 1, 0], 0.785398) } } } },
    { label: "Edge on edge", note: "No corner inside: one point.", state: { q: { query: "contacts", margin: 0.02, a: { shape: box(3, 1.4, 1.4), translation: [0, -0.97, 0], rotation: quatAbout([1, 0, 0], 0.785398) }, b: { shape: box(1.2, 1.2, 3), translation: [0, 0.84, 0], rotation: quatAbout([0, 0, 1], 0.785398) } } } },
  ],
  wrong: [
    { label: "Tilted by a milliradian", note: "One side is up by a millimetre or two. Without a margin half of the points would go, and the box would rock from side to side. The points stay.", state: situation([0, 0.5995, 0], quatAbout([0, 0, 1], 0.001)) },
    { label: "An edge wins by a hair", note: "The least overlap is that of two edges, and still the face is taken: read the reason.", state: hair },
    { label: "The same without the preference", note: "What the least overlap alone would make of it: the last step.", state: { ...hair, choice: { faces: "least" } } },
  ],
  sources: ["I. Sutherland, G. Hodgman: Reentrant polygon clipping, Communications of the ACM 17 (1974)", "K. Erleben: Methodology for assessing mesh-based contact point methods, ACM Transactions on Graphics 37 (2018)", "D. Gregorius: Robust contact creation for physics simulations, Game Developers Conference 2015"],
};
