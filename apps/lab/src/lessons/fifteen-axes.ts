import { ask, type Axis } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, cross, dot, mix, quatAbout, scale, unit } from "../parts/vec.ts";
import { box, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, drawContacts, moveHandle, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [1.6, 0, 0], b: [1.5, 0, 0] };
const situation = (translation: Vec, rotation: Vec, rotationA: Vec = [0, 0, 0, 1]): State => ({
  q: { query: "contacts", a: { shape: box(2, 1.4, 1.8), rotation: rotationA },
    b: { shape: box(1.8, 1.6, 1.4), translation, rotation } },
});

/** The axis as a line above both boxes, with the intervals of A and B on it. */
function ruler(d: Drawing, axis: Axis, state: State): void {
  const u = axis.direction, ends = [...axis.a, ...axis.b].map(Number);
  const center = mix(state.q.a.translation ?? [0, 0, 0], state.q.b!.translation!, 0.5);
  const up = Math.abs(u[1]) > 0.8 ? [1, 0, 0] : [0, 1, 0];
  const side = unit(cross(cross(u, up), u));
  const base = add(center, scale(side, 1.9));
  const at = (t: number, beside = 0): Vec => add(add(base, scale(u, t - dot(base, u))), scale(side, beside));
  d.arrow(at(Math.min(...ends) - 0.4), at(Math.max(...ends) + 0.4), "axis", { label: axis.name, key: axis.name });
  d.line(at(Number(axis.a[0]), 0.1), at(Number(axis.a[1]), 0.1), "a", { wide: true });
  d.line(at(Number(axis.b[0]), 0.2), at(Number(axis.b[1]), 0.2), "b", { wide: true });
  const shared = [Math.max(Number(axis.a[0]), Number(axis.b[0])), Math.min(Number(axis.a[1]), Number(axis.b[1]))];
  d.line(at(shared[0], 0.15), at(shared[1], 0.15), axis.overlap > 0 ? "touch" : "out", { wide: true });
}

const covers = (ends: Axis["a"]): string => `${digits(ends[0], 3)} … ${digits(ends[1], 3)}`;
const table = (axes: Axis[], now: string, winner?: string): Step["numbers"] => ({
  caption: "Intervals along each axis (units of length)",
  columns: ["axis", "A covers", "B covers", "overlap"],
  rows: axes.map((x) => ({
    cells: [x.name, covers(x.a), covers(x.b), x.overlap], key: x.name,
    mark: x.overlap < 0 ? "out" : x.name === winner ? "winner" : x.name === now ? "now" : undefined,
  })),
});

const names = ["A0", "A1", "A2", "B0", "B1", "B2",
  ...[0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => `A${i}×B${j}`))];

function explain(axis: Axis, index: number, firstGap: number): string {
  const gap = axis.overlap < 0
    ? "The intervals are apart: this axis separates the boxes. " : "The intervals overlap: the boxes may touch. ";
  const early = firstGap >= 0 && index > firstGap
    ? `A question for overlap alone would have stopped at ${names[firstGap] ?? "the first gap"}; the rest is shown to explain. ` : "";
  if (index < 3)
    return `${axis.name} is a face normal of A. Seen from A it is a coordinate axis, and one row of B's rotation is enough. ` + gap + early;
  if (index < 6)
    return `${axis.name} is a face normal of B. From here on the absolute values of the whole rotation matrix are needed; they are made only now. ` + gap + early;
  return `${axis.name} is the product of an edge of A and an edge of B. Two edges can cross without any corner being inside, and no face normal ` +
    `sees that. Its length is the sine of the angle between the edges, and overlaps are divided by it. ` + gap + early;
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
  view: { center: [0.7, 1, 0], reach: 3.1 },
  start: situation([1.35, 1.05, 0.35], quatAbout([0.4, 0.5, 0.8], 0.9)),
  handles: (s) => [moveHandle(s, "a"), turnHandle(s, "a", arms.a), moveHandle(s, "b"), turnHandle(s, "b", arms.b), sizeHandle(s, "b")],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state;
    const answer = ask(q);
    const axes = answer.trace.axes.filter((x) => x.name !== "normal");
    const { winner, reason } = answer.trace;
    const gapAt = axes.findIndex((x) => x.overlap < 0);
    const firstGap = gapAt < 0 ? -1 : names.indexOf(axes[gapAt].name);
    const missing = names.filter((n) => !axes.some((x) => x.name === n));
    const steps: Step[] = [{
      title: "Fifteen candidates",
      text: "A plane that separates two boxes can be turned until it lies on a face of one of them, or along an edge of each. So fifteen " +
        "directions are enough. They are tried in the order of their cost, all of them as seen from A.",
      says: "Two boxes in space.",
      draw(d) {
        drawBodies(d, q);
        axes.slice(0, 6).forEach((x, i) => {
          const from = (i < 3 ? q.a.translation : q.b!.translation) ?? [0, 0, 0];
          d.arrow(from, add(from, scale(x.direction, 1.3)), i < 3 ? "a" : "b", { label: x.name, key: x.name });
        });
      },
    }];
    axes.forEach((axis, i) => {
      const index = names.indexOf(axis.name), product = index > 5;
      steps.push({
        title: `Axis ${axis.name}: ${axis.overlap < 0 ? "a gap" : "overlap"}`,
        text: explain(axis, index, firstGap),
        formula: product
          ? [`n = frac(a_${Math.floor((index - 6) / 3)} × b_${(index - 6) % 3}, |a_${Math.floor((index - 6) / 3)} × b_${(index - 6) % 3}|)`,
            `n = ${vector(axis.direction, 3).replace("(", "[").replace(")", "]")}`, `o = ${digits(axis.overlap, 5)}`]
          : ["|c*n| > r_A + r_B", "r = h_0 |n*e_0| + h_1 |n*e_1| + h_2 |n*e_2|", `o = ${digits(axis.overlap, 5)}`],
        numbers: table(axes.slice(0, i + 1), axis.name),
        says: `${axis.name}: A from ${digits(axis.a[0], 3)} to ${digits(axis.a[1], 3)}, B from ${digits(axis.b[0], 3)} to ${digits(axis.b[1], 3)}, overlap ${digits(axis.overlap, 3)}.`,
        draw(d) {
          drawBodies(d, q);
          ruler(d, axis, state);
        },
      });
    });
    const faces = axes.filter((x) => !x.name.includes("×"));
    const fast = faces.every((x) => x.overlap >= 0);
    const best = axes.find((x) => x.name === winner) ?? axes[0];
    const normal = answer.manifolds?.[0]?.normal;
    const parallel = missing.length ? ` ${missing.join(", ")}: the edges are parallel and the product vanishes. Such an axis is left out, not divided by its length; the face normals answer.` : "";
    steps.push({
      title: answer.overlap ? "The least overlap wins" : "A gap: the boxes are apart",
      text: `${reason ?? ""}. The fast mode tries the six face normals only. It says: ` +
        (fast ? "they may touch" : "apart") + (fast && !answer.overlap ? ", and is wrong on the safe side here: only an edge product separates them." : ".") + parallel,
      formula: answer.overlap && normal ? ["d = min o_i", `d = ${digits(best.overlap, 6)}`, `n = [${normal.map((x) => digits(x, 3)).join(", ")}]`] : [`o_{"${best.name}"} = ${digits(best.overlap, 5)} < 0`],
      numbers: table(axes, "", winner),
      says: answer.overlap ? `Overlap: ${winner} wins with ${digits(best.overlap, 4)}.` : `Apart: ${winner} shows a gap of ${digits(-best.overlap, 4)}.`,
      draw(d) {
        drawBodies(d, q);
        ruler(d, best, state);
        drawContacts(d, answer.manifolds ?? []);
        const point = answer.manifolds?.[0]?.points[0];
        if (point && normal) d.arrow(point.a, add(point.a, normal), "axis", { label: "n", wide: true });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Edge on edge", note: "No corner of either is inside the other; an edge product wins.", state: situation([1.55, 1.35, 0], quatAbout([0.2, 1, 0], 0.9), quatAbout([0, 0, 1], 0.785398)) },
    { label: "Parallel edges", note: "Turned about one axis: some products vanish and their rows are gone.", state: situation([1.5, 1.1, 0.2], quatAbout([0, 1, 0], 0.6)) },
    { label: "Apart at once", note: "A0 shows a gap: one axis of fifteen was needed.", state: situation([2.4, 0.5, 0], quatAbout([0, 0, 1], 0.4)) },
  ],
  wrong: [
    { label: "What six axes miss", note: "Every face normal overlaps, and yet an edge product separates: the fast mode says they may touch.", state: situation([1.72, 1.5, 0], quatAbout([0.2, 1, 0], 0.9), quatAbout([0, 0, 1], 0.785398)) },
    { label: "Nearly parallel", note: "Turned by a millionth: the product's length is about 1e−6, and dividing by it would magnify rounding errors a million times.", state: situation([1.5, 1.1, 0.2], quatAbout([0.3, 1, 0.2], 1e-6)) },
  ],
  sources: [
    "S. Gottschalk, M. Lin, D. Manocha: OBBTree, SIGGRAPH 1996, section 5",
    "S. Gottschalk: Collision queries using oriented bounding boxes, thesis, Chapel Hill 2000",
    "G. van den Bergen: Collision Detection in Interactive 3D Environments (2003), section 5.2 (six axes alone)",
  ],
};
