import { ask, bodyAt } from "../graze.ts";
import { drawCast, drawDistance } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Handle } from "../parts/drawing.ts";
import { corners } from "../parts/outline.ts";
import { add, scale, sub } from "../parts/vec.ts";
import { box, circle, convex, radiusOf, withBody, type Body, type Shape, type State, type Vec } from "../question.ts";
import { along, dragBody, drawBodies, later, moveHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [1.6, 0], b: [1.6, 0] };
const situation = (a: Shape, from: Vec, linear: Vec, angular: number, b: Shape = box(0.12, 3), rotation = 0.2, rotationA = 0): State => ({
  q: { query: "cast", dimension: 2, duration: 1, a: { shape: a, translation: from, rotation: rotationA, linear, angular },
    b: { shape: b, translation: [1.6, 0], rotation } },
});
const frames = 4;

/** The space that an unturned body sweeps: the hull of its two ends; for a circle, that of its centres, rounded. */
function swept(from: Body, to: Body): Body {
  if (from.shape.type === "circle") return { shape: { ...convex([from.translation!, to.translation!]), margin: radiusOf(from.shape) } };
  return { shape: convex([...corners(from, 9), ...corners(to, 9)]) };
}

export const timeOfImpact: Lesson = {
  id: "time-of-impact", number: 12, title: "Tunnelling and time of impact", question: "When do they first touch, and did nobody notice?",
  intro: "A test at every frame sees still pictures. What is fast and thin is on one side in one of them and on the other in the next. A cast finds " +
    "the first moment of contact in between. Drag the arrow's end to change the velocity.",
  dimension: 2, view: { center: [2.4, 0], reach: 5.6 }, start: situation(box(1.6, 0.25), [-1.9, 0.3], [9, -0.6], 5),
  handles: (s): Handle[] => [
    moveHandle(s, "a"), moveHandle(s, "b"), turnHandle(s, "b", arms.b),
    { id: "velocity", label: "Velocity of A", kind: "size", meaning: "axis", at: add(s.q.a.translation!, s.q.a.linear!) },
  ],
  drag: (s, id, to) => id === "velocity" ? withBody(s, "a", (a) => { a.linear = sub(to, a.translation!); }) : dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state, answer = ask(q), list = answer.trace.steps ?? [];
    const a0 = q.a, T = q.duration ?? 1;
    const seen = Array.from({ length: frames + 1 }, (_, k) => {
      const t = (T * k) / frames;
      const still = bodyAt(a0, t);
      return { t, overlap: ask({ query: "overlap", dimension: 2, a: { shape: still.shape, translation: still.translation, rotation: still.rotation }, b: { shape: q.b!.shape, translation: q.b!.translation, rotation: q.b!.rotation } }).overlap! };
    });
    const path = (d: Parameters<Step["draw"]>[0], upTo = T): void => {
      drawCast(d, q, upTo, { as: { path: "out", ghost: "a", moving: null } });
      d.arrow(a0.translation!, add(a0.translation!, scale(a0.linear!, T)), "axis", { dashed: true, label: "v" });
    };
    const hits = seen.filter((s) => s.overlap).length;
    const hull = Number(a0.angular ?? 0) === 0 ? swept(bodyAt(a0, 0), bodyAt(a0, T)) : null;
    const meets = hull && ask({ query: "overlap", dimension: 2, a: hull, b: { shape: q.b!.shape, translation: q.b!.translation, rotation: q.b!.rotation } }).overlap!;
    const steps: Step[] = [{
      title: "Frame by frame",
      text: `${frames + 1} still pictures of the motion. ` + (hits ? `In ${hits} of them A and B overlap: noticed, but late and deep.` : answer.hit
        ? "In none of them do A and B overlap: A tunnels. And yet they meet." : "In none of them do A and B overlap, and indeed they never meet."),
      numbers: { caption: "Overlap at the frames (units of time)", columns: ["frame", "time", "overlap"], rows: seen.map((s, k) => ({ cells: [String(k), s.t, s.overlap ? "yes" : "no"], mark: s.overlap ? "winner" as const : undefined })) },
      says: `${frames + 1} frames, ${hits} with overlap.`,
      draw(d) {
        for (const s of seen) d.shape(bodyAt(a0, s.t), s.overlap ? "touch" : "a", { ghost: s.t > 0, label: `t=${digits(s.t, 3)}` });
        d.shape(q.b!, "b");
        d.arrow(a0.translation!, add(a0.translation!, scale(a0.linear!, T)), "axis", { dashed: true });
      },
    }, {
      title: "All that A sweeps",
      text: "Everything between the first and the last picture counts. " + (hull
        ? `A does not turn: what it sweeps is the convex hull of its two ends, and one overlap test with that answers whether they meet at all: ${meets ? "yes" : "no"}. When they meet is another question.`
        : "A turns: what it sweeps has no simple shape, and the hull of its ends would miss what swings out between them. Some of the positions in between are drawn; the library needs none of them."),
      formula: hull ? ['S = conv( A_0 "," A_1 )'] : ["x_A(t) = x_A + t v_A", "R_A(t) = exp(t omega_A) R_A"],
      says: hull ? `The hull of A's ends ${meets ? "overlaps B" : "does not touch B"}.` : "Positions of A along its path.",
      draw(d) {
        if (hull) d.shape(hull, meets ? "touch" : "a", { ghost: true });
        drawBodies(d, q);
        if (hull) {
          d.shape(bodyAt(a0, T), "a");
          d.arrow(a0.translation!, add(a0.translation!, scale(a0.linear!, T)), "axis", { dashed: true, label: "v" });
        } else path(d);
      },
    }];
    const travelled = (at: number): Step["graph"] => ({ caption: "distance at each step", at, series: [{ name: "distance", meaning: "made", values: list.map((s) => s.distance) }] });
    list.forEach((s, i) => {
      steps.push(later(() => {
        const last = i === list.length - 1;
        const wait = last ? 0 : list[i + 1].t - s.t, speed = along(s.normal.slice(0, 2), sub(a0.linear!, q.b!.linear ?? [0, 0]));
        return {
          title: i === 0 ? `The start, t = ${digits(s.t, 6)}` : `Advance to t = ${digits(s.t, 6)}`,
          text: `Here they are ${digits(s.distance, 5)} apart along n. ` + (last
            ? (answer.hit ? "That is within the tolerance: this is the time of impact, and it was approached from before."
            : "However fast they close from here, the motion is over before they can touch: there is no impact.")
            : (i === 0 ? `A moves along n at v·n = ${digits(speed, 4)}. Turning adds at most |ω| times a point's lever, and in all no more than brings A out to the circle round its centre that it never leaves. ` : `v·n is ${digits(speed, 4)}. `) +
              `They close at no more than u = ${digits(s.distance / wait, 5)} on average, with what turning adds or takes away: for ${digits(wait, 4)} nothing can touch. Advance by that and measure again.`),
          formula: last ? [`t_${i + 1} = ${digits(s.t, 8)}`, `d_${i + 1} = ${digits(s.distance, 5)}`]
            : [`t_${i + 2} = t_${i + 1} + frac(d_${i + 1}, u)`, `t_${i + 2} = ${digits(s.t, 6)} + frac(${digits(s.distance, 5)}, ${digits(s.distance / wait, 5)}) = ${digits(list[i + 1].t, 8)}`],
          numbers: { caption: "Conservative advancement (units of time and of length)", columns: ["step", "time", "distance"],
            rows: list.slice(Math.max(0, i - 11), i + 1).map((x, k, l) => ({ cells: [String(Math.max(0, i - 11) + k + 1), x.t, x.distance], mark: k === l.length - 1 ? "now" as const : undefined })) },
          graph: travelled(i),
          says: `At time ${digits(s.t, 5)} the distance is ${digits(s.distance, 4)}.`,
          draw(d) {
            d.shape(a0, "a", { ghost: true });
            path(d, s.t);
            const now = bodyAt(a0, s.t), b = bodyAt(q.b!, s.t);
            d.shape(now, "a");
            d.shape(b, "b");
            const pair = ask({ query: "distance", dimension: 2, a: { shape: now.shape, translation: now.translation, rotation: now.rotation }, b: { shape: b.shape, translation: b.translation, rotation: b.rotation } });
            drawDistance(d, pair, { look: { wide: true } });
            d.arrow(pair.a as unknown as Vec, add(pair.a as unknown as Vec, s.normal), "axis", { label: "n" });
          },
        };
      }));
    });
    steps.push({
      title: answer.hit ? `They touch at t = ${digits(answer.t, 8)}` : "They never touch",
      text: answer.hit ? (list.length ? `${list.length} steps. ` : answer.t === 0 ? "They touch from the start. " : `A moves without turning: the path of B's difference past the origin is a ray, and one question (${answer.trace.method}) gives the time. `) +
        "Position, normal and point are those of this moment; a solver can stop A here instead of finding it on the other side."
        : "The answer is proven: at no time of the whole motion is their distance zero.",
      formula: answer.hit ? [`t = ${digits(answer.t, 10)}`, `n = [${answer.normal!.map((x) => digits(x, 4)).join(", ")}]`] : [],
      numbers: answer.hit ? { caption: "Answer (units of time and of length)", columns: ["quantity", "value"], rows: [{ cells: ["time", answer.t!], mark: "winner" }, { cells: ["point", vector(answer.point, 5)] }, { cells: ["normal", vector(answer.normal, 5)] }, { cells: ["method", answer.trace.method] }] } : undefined,
      says: answer.hit ? `First contact at time ${digits(answer.t, 6)}.` : "No contact.",
      draw(d) {
        path(d, answer.hit ? answer.t : T);
        d.shape(bodyAt(a0, answer.hit ? answer.t! : T), "a");
        d.shape(q.b!, "b");
        if (answer.hit) {
          d.point(answer.point!, "touch", { wide: true });
          d.arrow(answer.point!, add(answer.point!, answer.normal!), "axis", { label: "n", wide: true });
        }
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Ball and thin wall", note: "No turning: one ray against the difference answers.", state: situation(circle(0.3), [-1.9, 0.2], [8, 0], 0) },
    { label: "A miss", note: "The rod turns out of the way in time.", state: situation(box(1.6, 0.25), [-2.6, 2.4], [7, 1.5], 5) },
    { label: "Turning on the spot", note: "Only the tip comes near.", state: situation(box(3.6, 0.2), [-0.1, 0], [0, 0], 2.2, box(0.12, 3), 0.2, -1.4) },
  ],
  wrong: [
    { label: "Grazing", note: "A passes so closely that the distance gets small without ever being zero: steps get small too. A tolerance ends the walk, and the answer is right within it.", state: situation(circle(0.3), [-2.8, 1.72], [8, 0], 0.001, box(0.12, 3), 0) },
    { label: "A thousand turns", note: "A thousand turns in the time of one flight. A bound of |ω|·r alone would advance in thousands of small steps; the circle that the rod never leaves takes it up to the wall in one, and only the rest is walked.", state: situation(box(1.6, 0.25), [-2.6, 0.3], [7, -0.6], 6283.18530718) },
  ],
  sources: ["B. Mirtich: Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, Berkeley 1996 (conservative advancement)", "G. van den Bergen: Ray casting against general convex objects, 2004", "E. Catto: Continuous collision, Game Developers Conference 2013"],
};
