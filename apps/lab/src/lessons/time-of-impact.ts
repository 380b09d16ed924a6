import { ask, bodyAt } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Handle } from "../parts/drawing.ts";
import { add, scale, sub } from "../parts/vec.ts";
import { box, circle, withBody, type Shape, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [1.6, 0], b: [1.6, 0] };
const situation = (a: Shape, from: Vec, linear: Vec, angular: number, b: Shape = box(0.12, 3), rotation = 0.2): State => ({
  q: { query: "cast", dimension: 2, duration: 1, a: { shape: a, translation: from, rotation: 0, linear, angular },
    b: { shape: b, translation: [1.6, 0], rotation } },
});
const frames = 4;

export const timeOfImpact: Lesson = {
  id: "time-of-impact", number: 12, title: "Tunnelling and time of impact", question: "When do they first touch, and did nobody notice?",
  intro: "A test at every frame sees still pictures. What is fast and thin is on one side in one of them and on the other in the next. A cast finds " +
    "the first moment of contact in between. Drag the arrow's end to change the velocity.",
  dimension: 2, view: { center: [0.4, 0], reach: 4 }, start: situation(box(1.6, 0.25), [-2.6, 0.3], [7, -0.6], 5),
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
      for (let k = 1; k <= 12; k++) if ((T * k) / 12 <= upTo) d.shape(bodyAt(a0, (T * k) / 12), "a", { ghost: true });
      d.arrow(a0.translation!, add(a0.translation!, scale(a0.linear!, T)), "axis", { dashed: true, label: "v" });
    };
    const hits = seen.filter((s) => s.overlap).length;
    const steps: Step[] = [{
      title: "Frame by frame",
      text: `${frames + 1} still pictures of the motion. ` + (hits ? `In ${hits} of them A and B overlap: noticed, but late and deep.` : answer.hit
        ? "In none of them do A and B overlap: A tunnels. And yet they meet." : "In none of them do A and B overlap, and indeed they never meet."),
      numbers: { caption: "Overlap at the frames", columns: ["frame", "time", "overlap"], rows: seen.map((s, k) => ({ cells: [String(k), s.t, s.overlap ? "yes" : "no"], mark: s.overlap ? "winner" as const : undefined })) },
      says: `${frames + 1} frames, ${hits} with overlap.`,
      draw(d) {
        for (const s of seen) d.shape(bodyAt(a0, s.t), s.overlap ? "touch" : "a", { ghost: s.t > 0, label: `t=${digits(s.t, 3)}` });
        d.shape(q.b!, "b");
        d.arrow(a0.translation!, add(a0.translation!, scale(a0.linear!, T)), "axis", { dashed: true });
      },
    }, {
      title: "All that A sweeps",
      text: "Everything between the first and the last picture counts. If A does not turn, what it sweeps is the convex hull of its two ends, and one overlap test answers whether they meet at all; when they meet is another question.",
      formula: ["x_A(t) = x_A + t v_A", "R_A(t) = exp(t omega_A) R_A"],
      says: "The path of A.",
      draw(d) {
        drawBodies(d, q);
        path(d);
      },
    }];
    const travelled = (at: number): Step["graph"] => ({ caption: "distance at each step", at, series: [{ name: "distance", meaning: "made", values: list.map((s) => s.distance) }] });
    list.forEach((s, i) => {
      const last = i === list.length - 1;
      const wait = last ? 0 : list[i + 1].t - s.t;
      steps.push({
        title: `Advance to t = ${digits(s.t, 6)}`,
        text: `Here they are ${digits(s.distance, 5)} apart along n. ` + (last
          ? "That is within the tolerance: this is the time of impact, and it was approached from before."
          : `However A moves and turns, no point of it comes nearer along n than its speed bound allows, so for ${digits(wait, 4)} nothing can touch: advance by that and measure again.`),
        formula: ["t_{i+1} = t_i + frac(d_i, v*n + |omega| r)", `t_${i + 1} = ${digits(s.t, 8)}`, `d_${i + 1} = ${digits(s.distance, 5)}`],
        numbers: { caption: "Conservative advancement", columns: ["step", "time", "distance"],
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
          d.line(pair.a as unknown as Vec, pair.b as unknown as Vec, "touch", { wide: true });
          d.arrow(pair.a as unknown as Vec, add(pair.a as unknown as Vec, s.normal), "axis", { label: "n" });
        },
      });
    });
    steps.push({
      title: answer.hit ? `They touch at t = ${digits(answer.t, 8)}` : "They never touch",
      text: answer.hit ? (list.length ? `${list.length} steps. ` : `A moves without turning: the path of B's difference past the origin is a ray, and one question (${answer.trace.method}) gives the time. `) +
        "Position, normal and point are those of this moment; a solver can stop A here instead of finding it on the other side."
        : "The answer is proven: at no time of the whole motion is their distance zero.",
      formula: answer.hit ? [`t = ${digits(answer.t, 10)}`, `n = [${answer.normal!.map((x) => digits(x, 4)).join(", ")}]`] : [],
      numbers: answer.hit ? { caption: "Answer", columns: ["", "value"], rows: [{ cells: ["time", answer.t!], mark: "winner" }, { cells: ["point", vector(answer.point, 5)] }, { cells: ["normal", vector(answer.normal, 5)] }, { cells: ["method", answer.trace.method] }] } : undefined,
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
    { label: "Ball and thin wall", note: "No turning: one ray against the difference answers.", state: situation(circle(0.3), [-2.8, 0.2], [8, 0], 0) },
    { label: "A miss", note: "The rod turns out of the way in time.", state: situation(box(1.6, 0.25), [-2.6, 2.4], [7, 1.5], 5) },
    { label: "Turning on the spot", note: "Only the tip comes near.", state: situation(box(3.6, 0.2), [-0.1, 0], [0, 0], 2.2) },
  ],
  wrong: [
    { label: "Grazing", note: "A passes so closely that the distance gets small without ever being zero: steps get small too. A tolerance ends the walk, and the answer says within which bound it is right.", state: situation(circle(0.3), [-2.8, 1.72], [8, 0], 0.001, box(0.12, 3), 0) },
    { label: "A hundred turns", note: "The speed bound counts |ω|·r for every point, so a quickly turning rod advances in small steps.", state: situation(box(1.6, 0.25), [-2.6, 0.3], [7, -0.6], 600) },
  ],
  sources: ["B. Mirtich: Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, Berkeley 1996 (conservative advancement)", "G. van den Bergen: Ray casting against general convex objects, 2004", "E. Catto: Continuous collision, Game Developers Conference 2013"],
};
