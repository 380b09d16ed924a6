import { ask, mayOverlap, type Axis } from "../graze.ts";
import { drawDistance } from "../parts/answers.ts";
import { digits, sentence } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { row } from "../parts/math.ts";
import { add, cross, dot, mix, quatAbout, scale, unit } from "../parts/vec.ts";
import { box, type State, type Vec } from "../question.ts";
import { along, dragBody, drawBodies, drawContacts, later, moveHandle, radiusWorked, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";
import { axisTable, drawAxis, leastOf, verdict, verdictFormula } from "./separating-axes-plane.ts";

const arms = { a: [1.6, 0, 0], b: [1.5, 0, 0] };
const situation = (translation: Vec, rotation: Vec, rotationA: Vec = [0, 0, 0, 1]): State => ({
  q: { query: "contacts", a: { shape: box(2, 1.4, 1.8), rotation: rotationA },
    b: { shape: box(1.8, 1.6, 1.4), translation, rotation } },
});

/** The axis as a line above both boxes, with the shadows of A and B on it. */
function ruler(d: Drawing, axis: Axis, state: State): void {
  const u = axis.direction, ends = [...axis.a, ...axis.b].map(Number);
  const center = mix(state.q.a.translation ?? [0, 0, 0], state.q.b!.translation!, 0.5);
  const up = Math.abs(u[1]) > 0.8 ? [1, 0, 0] : [0, 1, 0];
  const side = unit(cross(cross(u, up), u));
  const base = add(center, scale(side, 1.9));
  const at = (t: number, beside = 0): Vec => add(add(base, scale(u, t - dot(base, u))), scale(side, beside));
  d.arrow(at(Math.min(...ends) - 0.4), at(Math.max(...ends) + 0.4), "axis", { label: axis.name, key: axis.name });
  // Side by side as seen from the front, A nearest to the boxes.
  drawAxis(d, axis, { by: (p, meaning) => at(dot(p, u), meaning === "a" ? 0.1 : meaning === "b" ? 0.2 : 0.15) });
  const [from, to] = [Number(axis.b[0]), Number(axis.a[1])];
  if (axis.overlap >= 0) return;
  // A plane across the axis, through the gap.
  const middle = at((from + to) / 2, -1.9), up2 = cross(side, u);
  d.polygon([[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => add(middle, add(scale(side, 1.9 * x), scale(up2, 1.5 * y)))), "out", { ghost: true });
}

const names = ["A0", "A1", "A2", "B0", "B1", "B2",
  ...[0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => `A${i}×B${j}`))];

function explain(axis: Axis, index: number, firstGap: number): string {
  const gap = axis.overlap < 0
    ? "The shadows are apart: a plane across this axis has A on one side and B on the other. " : "The shadows overlap: the boxes may touch. ";
  const early = firstGap < 0 || index < firstGap ? "" : index === firstGap
    ? "Whoever asks for overlap alone stops here; the page goes on to show what the other axes would have said. "
    : `After the gap on ${names[firstGap]} this is for show. `;
  if (index < 3)
    return `${axis.name} is the normal of two faces of A. Seen from A it is a coordinate axis, and one row of B's rotation is enough. ` + gap + early;
  if (index < 6)
    return `${axis.name} is the normal of two faces of B, a column of its rotation. ` + gap + early;
  return `${axis.name} is the product of an edge of A and an edge of B. Two edges can cross without any corner being inside, and no face's normal ` +
    `sees that. Its length is the sine of the angle between the edges, and overlaps are divided by it. ` + gap + early;
}

/** The half shadows of both boxes, from their half sizes. */
const radiiOf = (axis: Axis, { q }: State): string[] => (["a", "b"] as const).map((which) =>
  radiusWorked(`r_${which.toUpperCase()}`, q[which]!, axis.direction, (Number(axis[which][1]) - Number(axis[which][0])) / 2));

/** The matrix that all axes but the first three need. */
function rotationStep(axes: Axis[], paint: (d: Drawing) => void): Step {
  const seen = (i: number, j: number): number => along(axes[i].direction, axes[3 + j].direction);
  const tidy = (x: number): string => digits(Math.abs(x) < 1e-15 ? 0 : x, 4);
  return {
    title: "B's rotation, as A sees it",
    text: "For the first three axes a row of this matrix each was enough, and a gap there ends the search. Only now is the whole of it needed, and so made: " +
      "row i, column j says how far B's axis j points along A's axis i, both turned as they are drawn. Half sizes are weighted by these numbers without their signs; the products' lengths come from them too.",
    formula: ["R_ij = a_i * b_j", "r_B = h_0 |R_i0| + h_1 |R_i1| + h_2 |R_i2|"],
    numbers: { caption: "R", columns: ["axis of A", "b0", "b1", "b2"], rows: [0, 1, 2].map((i) => ({ cells: [`a${i}`, ...[0, 1, 2].map((j) => tidy(seen(i, j)))], key: `A${i}` })) },
    says: "The rotation of B seen from A, as a matrix of three rows.",
    draw: paint,
  };
}

export const fifteenAxes: Lesson = {
  id: "fifteen-axes",
  number: 4,
  title: "Fifteen axes",
  question: "Do these two boxes in space touch?",
  intro:
    "Three face normals of A, three of B, and the nine products of their edges: if none of the fifteen separates, nothing does. " +
    "Drag the letters to move the boxes and the round arrows to turn them; drag beside them to look around.",
  dimension: 3,
  view: { center: [0.7, 1, 0], reach: 3.1, from: [0.9, 0.5, 1] },
  start: situation([1.35, 1.05, 0.35], quatAbout([0.4, 0.5, 0.8], 0.9)),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b), sizeHandle(s, "b")],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state;
    const answer = ask(q);
    const axes = answer.trace.axes.filter((x) => x.name !== "normal");
    const { winner, reason } = answer.trace;
    const paint = (d: Drawing): void => {
      drawBodies(d, q);
      axes.slice(0, 6).forEach((x, i) => {
        const from = (i < 3 ? q.a.translation : q.b!.translation) ?? [0, 0, 0];
        d.arrow(from, add(from, scale(x.direction, 1.3)), i < 3 ? "a" : "b", { label: x.name, key: x.name });
      });
    };
    const gapAt = axes.findIndex((x) => x.overlap < 0);
    const firstGap = gapAt < 0 ? -1 : names.indexOf(axes[gapAt].name);
    const missing = names.filter((n) => !axes.some((x) => x.name === n));
    const steps: Step[] = [{
      title: "Fifteen candidates",
      text: "A plane that separates two boxes can be turned until it lies on a face of one of them, or along an edge of each. So fifteen " +
        "directions, the axes, are enough. On each, both boxes cast shadows. They are tried in the order of their cost, all of them as seen from A.",
      says: "Two boxes in space.",
      draw: paint,
    }];
    axes.forEach((axis, i) => {
      const index = names.indexOf(axis.name), product = index > 5;
      if (i === 3) steps.push(later(() => rotationStep(axes, paint)));
      steps.push(later(() => ({
        title: `Axis ${axis.name}: ${axis.overlap < 0 ? "a gap" : "overlap"}`,
        text: explain(axis, index, firstGap),
        formula: product
          ? [`n = frac(a_${Math.floor((index - 6) / 3)} × b_${(index - 6) % 3}, |a_${Math.floor((index - 6) / 3)} × b_${(index - 6) % 3}|)`,
            `n = ${row(axis.direction)}`, ...verdictFormula(axis)]
          : ["r = h_0 |n*e_0| + h_1 |n*e_1| + h_2 |n*e_2|", ...radiiOf(axis, state), ...verdictFormula(axis)],
        numbers: axisTable(axes.slice(0, i + 1), axis.name),
        says: `${axis.name}: A from ${digits(axis.a[0], 3)} to ${digits(axis.a[1], 3)}, B from ${digits(axis.b[0], 3)} to ${digits(axis.b[1], 3)}, ${verdict(axis, 3)}.`,
        draw(d) {
          drawBodies(d, q);
          ruler(d, axis, state);
        },
      })));
    });
    const fast = mayOverlap(q);
    const best = axes.find((x) => x.name === winner) ?? leastOf(axes);
    const normal = answer.manifolds?.[0]?.normal;
    const parallel = missing.length ? ` ${missing.join(", ")} ${missing.length > 1 ? "are" : "is"} missing: those edges are parallel and their product vanishes. The normals of the faces answer for them.` : "";
    steps.push(later(() => {
      const measured = answer.overlap ? null : ask({ ...q, query: "distance" });
      const widest = leastOf(axes);
      const exact = measured && Math.abs(measured.distance! + widest.overlap) <= 1e-9 * (Number(widest.a[1]) - Number(widest.a[0]));
      const mode = `The fast mode tries the six normals of faces only. It says: ${fast ? "they may touch" : "apart"}` +
        (fast && !answer.overlap ? ", and is wrong on the safe side here: only a product of edges separates them." : ".");
      return answer.overlap ? {
        title: "The least overlap wins",
        text: `${sentence(reason ?? "")} Along it B is parted from A on the shortest way: depth and normal are known. ${mode}${parallel}`,
        formula: ["d = min o_i", `d = ${digits(best.overlap, 6)}`, ...(normal ? [`n = [${normal.map((x) => digits(x, 3)).join(", ")}]`] : [])],
        numbers: axisTable(axes, "", best.name),
        says: `Overlap: ${best.name} wins with ${digits(best.overlap, 4)}.`,
        draw(d) {
          drawBodies(d, q);
          ruler(d, best, state);
          drawContacts(d, answer.manifolds ?? []);
        },
      } : {
        title: `A gap: the boxes are apart, by ${exact ? "" : "at least "}${digits(-widest.overlap, 4)}`,
        text: `${widest.name} shows the widest gap, ${digits(-widest.overlap, 4)}; for "apart" any gap suffices. ` +
          (exact ? "It is the distance too. " : `It is a lower bound: the distance is ${digits(measured!.distance, 4)}, along the way between the two nearest points, which is none of the fifteen axes. `) + mode + parallel,
        formula: [`"gap" = ${digits(-widest.overlap, 5)}`, `d = ${digits(measured!.distance, 5)}`],
        numbers: axisTable(axes, "", widest.name),
        says: `Apart: ${widest.name} shows a gap of ${digits(-widest.overlap, 4)}, the distance is ${digits(measured!.distance, 4)}.`,
        draw(d) {
          drawBodies(d, q);
          ruler(d, widest, state);
          const [from, to] = [measured!.a as unknown as Vec, measured!.b as unknown as Vec];
          drawDistance(d, measured!, { look: { wide: true } });
          d.text(mix(from, to, 0.5), "d", "touch");
        },
      };
    }));
    return steps;
  },
  tryThis: [
    { label: "Edge on edge", note: "No corner of either is inside the other; an edge product wins.", state: situation([2.2, 0.05, 0.05], quatAbout([0, 1, 0], 0.785398), quatAbout([0, 0, 1], 0.785398)) },
    { label: "Parallel edges", note: "Turned about one axis: some products vanish and their rows are gone.", state: situation([1.5, 1.1, 0.2], quatAbout([0, 1, 0], 0.6)) },
    { label: "Corner to corner", note: "The widest gap of the fifteen is less than the distance.", state: situation([2.5, 2, 1.9], quatAbout([0.4, 0.5, 0.8], 0.2)) },
    { label: "Apart at once", note: "A0 shows a gap: one axis of fifteen was needed.", state: situation([2.4, 0.5, 0], quatAbout([0, 0, 1], 0.4)) },
  ],
  wrong: [
    { label: "What six axes miss", note: "Every face normal overlaps, and yet an edge product separates: the fast mode says they may touch.", state: situation([2.42, 0.05, 0.05], quatAbout([0, 1, 0], 0.785398), quatAbout([0, 0, 1], 0.785398)) },
    { label: "Nearly parallel", note: "Turned by a millionth: the product's length is about 1e−6, and dividing by it would magnify rounding errors a million times.", state: situation([1.5, 1.1, 0.2], quatAbout([0.3, 1, 0.2], 1e-6)) },
  ],
  sources: [
    "S. Gottschalk, M. Lin, D. Manocha: OBBTree, SIGGRAPH 1996, section 5",
    "S. Gottschalk: Collision queries using oriented bounding boxes, thesis, Chapel Hill 2000",
    "G. van den Bergen: Collision Detection in Interactive 3D Environments (2003), section 5.2 (six axes alone)",
  ],
};
