import { answered, ask } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing, Handle } from "../parts/drawing.ts";
import { row, term } from "../parts/math.ts";
import { add, cross, length, scale, sub, unit } from "../parts/vec.ts";
import { box, sphere, withBody, type Body, type Question, type Shape, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, turnHandle, numberOf, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [1.2, 0, 0], b: [1.3, 0, 0] };
const situation = (va: Vec, vb: Vec, mass = 1, b: Shape = box(1.2, 1.2, 1.2), at: Vec = [1.25, 0.35, 0], extra: Record<string, number> = {}): State => ({
  q: { query: "response", restitution: 0, friction: 0.6,
    a: { shape: sphere(0.7), translation: [0, 0, 0], linear: va, mass: 1 }, b: { shape: b, translation: at, linear: vb, mass } },
  choice: { restitution: 0, friction: 0.6, mass, ...extra },
});

/** The response to the deepest point of contact of the two shapes where they stand. */
function response(state: State): Question {
  const { a, b } = state.q;
  const still = { a: { shape: a.shape, translation: a.translation, rotation: a.rotation }, b: { shape: b!.shape, translation: b!.translation, rotation: b!.rotation } };
  const near = ask({ query: "distance", ...still });
  const pa = near.a as unknown as Vec, pb = near.b as unknown as Vec;
  return {
    query: "response", restitution: numberOf(state, "restitution", 0), friction: numberOf(state, "friction", 0.6),
    a: { ...a, mass: 1 }, b: { ...b!, mass: numberOf(state, "mass", 1) },
    contact: { point: scale(add(pa, pb), 0.5), normal: near.normal! },
  };
}

const turns = ({ angular }: Body): boolean => Array.isArray(angular) && length(angular) > 0;
/** The velocity of a body's material at a point, as text of a formula. */
const velocityAt = (body: Body, point: Vec): string =>
  row(body.linear ?? [0, 0, 0]) + (turns(body) ? ` + ${row(body.angular as Vec)} × ${row(sub(point, body.translation ?? [0, 0, 0]))}` : "");

export const resolution: Lesson = {
  id: "resolution", number: 13, title: "From contact to motion", question: "They touch: who is at fault, and what happens next?",
  intro: "Contact information is a point, a normal and a depth. With masses and velocities it answers in what direction and how fast both go on. Drag the arrows' ends.",
  dimension: 3, view: { center: [0.6, 0.2, 0], reach: 2.1, from: [0.15, 0.25, 1] }, start: situation([0.5, 1.1, 0], [-0.5, -0.8, 0]),
  choices: [
    { key: "restitution", label: "Restitution", options: [0, 0.5, 1].map((value) => ({ value, label: String(value) })) },
    { key: "friction", label: "Friction", usual: 0.6, options: [0, 0.1, 0.6].map((value) => ({ value, label: String(value) })) },
    { key: "mass", label: "Mass of B", options: [1, 10, 100].map((value) => ({ value, label: String(value) })) },
  ],
  handles(s): Handle[] {
    const velocity = (which: "a" | "b"): Handle => ({ id: `velocity-${which}`, label: `Velocity of ${which.toUpperCase()}`, kind: "size", meaning: which, at: add(s.q[which]!.translation!, s.q[which]!.linear!) });
    return [moveHandle(s, "b"), turnHandle(s, "b", arms.b), velocity("a"), velocity("b")];
  },
  drag: (s, id, to) => id.startsWith("velocity") ? withBody(s, id.slice(-1) as "a" | "b", (body) => { body.linear = sub(to, body.translation!); }) : dragBody(s, id, to, arms),
  asks: response,
  steps(state) {
    const q = response(state), answer = answered(q), t = answer.trace;
    const { point, normal } = q.contact!;
    const approach = t.relativeVelocity!, friction = t.friction;
    const whole = (d: Drawing): void => {
      drawBodies(d, q);
      for (const w of ["a", "b"] as const) d.arrow(q[w]!.translation!, add(q[w]!.translation!, q[w]!.linear!), w, { wide: true });
      d.point(point, "touch", { wide: true, key: "point" });
    };
    const fault = { a: "A", b: "B", both: "both of them", neither: "neither" }[t.atFault ?? "neither"];
    const steps: Step[] = [
      {
        title: "The velocity at the point",
        text: "Not the velocity of the centres counts but that of the material at the point of contact: the linear velocity, and what turning adds to it. The difference, B's minus A's, is the relative velocity.",
        formula: ["v = v_B + omega_B × r_B - v_A - omega_A × r_A", `v = ${velocityAt(q.b!, point)} - ${turns(q.a) ? `(${velocityAt(q.a, point)})` : velocityAt(q.a, point)} = ${row(approach.whole)}`],
        numbers: { caption: "At the point of contact", columns: ["quantity", "value"], rows: [{ cells: ["point, m", vector(point, 4)], key: "point" }, { cells: ["normal", vector(normal, 4)], key: "n" }, { cells: ["v, m/s", vector(approach.whole, 4)], mark: "now", key: "v" }] },
        says: `Relative velocity ${vector(approach.whole, 3)}.`,
        draw(d) {
          whole(d);
          d.arrow(point, add(point, approach.whole), "made", { wide: true, label: "v", key: "v" });
          d.arrow(point, add(point, scale(normal, 0.7)), "axis", { label: "n", key: "n" });
        },
      },
      {
        title: `At fault: ${fault}`,
        text: "Only what moves towards the other is at fault: the part of the relative velocity along the normal says whether they approach. " + (approach.normal < 0 ? "It is negative: they do." : "It is not negative: they part, and nothing has to be done.") + " The rest is sliding.",
        formula: ["v_n = v*n", `v_n = ${row(approach.whole)} * ${row(normal)} = ${digits(approach.normal, 5)}`],
        numbers: { caption: "Approach", columns: ["quantity", "value"], rows: [{ cells: ["along n, m/s", approach.normal], mark: "now", key: "vn" }, { cells: ["tangential, m/s", vector(approach.tangential, 4)], key: "vt" }, { cells: ["at fault", fault], mark: "winner" }] },
        says: `Velocity along the normal ${digits(approach.normal, 4)}; at fault: ${fault}.`,
        draw(d) {
          whole(d);
          d.arrow(point, add(point, scale(normal, approach.normal)), "touch", { wide: true, label: "vn", key: "vn" });
          d.arrow(point, add(point, approach.tangential), "out", { wide: true, label: "vt", key: "vt" });
        },
      },
    ];
    steps.push({
      title: "The normal impulse",
      text: "How hard must they push each other so that they no longer approach? The effective mass says how much of both masses resists at this point: turning makes it lighter. Restitution asks for more, so that they part.",
      formula: ["j = max(0, -m (1 + e) v_n)", `m = frac(1, n*K n) = ${digits(t.effectiveMass, 5)}`,
        `j = max(0, -${digits(t.effectiveMass, 4)} * (1 + ${digits(q.restitution, 3)}) * ${term(approach.normal)}) = ${digits(answer.normalImpulse, 5)}`],
      numbers: { caption: "Impulse", columns: ["quantity", "value"], rows: [{ cells: ["effective mass, kg", t.effectiveMass ?? 0] }, { cells: ["normal impulse, N s", answer.normalImpulse ?? 0], mark: "winner", key: "j" }] },
      says: `Normal impulse ${digits(answer.normalImpulse, 4)}.`,
      draw(d) {
        whole(d);
        d.arrow(point, add(point, scale(normal, answer.normalImpulse!)), "touch", { wide: true, label: "j on B", key: "j" });
        d.arrow(point, add(point, scale(normal, -answer.normalImpulse!)), "touch", { wide: true, label: "−j on A", key: "j" });
      },
    });
    if (friction) steps.push({
      title: friction.holds ? "Friction holds" : "Friction slips",
      text: `The sliding that is left would be stopped by an impulse in the tangent plane. Friction gives at most μ times the normal impulse, a cone about the normal. ` + (friction.holds ? "Stopping needs less: they stick." : "Stopping needs more: it is shortened to the cone, and they go on sliding."),
      formula: ["|j_t| <= mu j", `${digits(length(friction.stopping), 4)} ${friction.holds ? "<=" : ">"} ${digits(friction.limit, 4)}`],
      numbers: { caption: "Friction", columns: ["quantity", "value"], rows: [{ cells: ["sliding, m/s", vector(friction.sliding, 4)] }, { cells: ["to stop, N s", vector(friction.stopping, 4)] }, { cells: ["limit, N s", friction.limit], key: "cone" }, { cells: ["given, N s", vector(friction.impulse, 4)], mark: "winner", key: "given" }] },
      says: friction.holds ? "Friction holds." : "Friction slips.",
      draw(d) {
        whole(d);
        const side = unit(Math.abs(normal[1]) < 0.9 ? cross(normal, [0, 1, 0]) : cross(normal, [1, 0, 0])), other = cross(normal, side);
        const rim = Array.from({ length: 24 }, (_, i) => add(add(point, scale(normal, answer.normalImpulse!)), add(scale(side, friction.limit * Math.cos(i * 0.2618)), scale(other, friction.limit * Math.sin(i * 0.2618)))));
        rim.forEach((p, i) => { d.line(p, rim[(i + 1) % 24], "made", { key: "cone" }); if (i % 3 === 0) d.line(point, p, "made", { ghost: true }); });
        d.arrow(point, add(point, answer.impulse!), "touch", { wide: true, label: "impulse", key: "given" });
      },
    });
    steps.push({
      title: "The motions after",
      text: "Each body gets the impulse, in opposite directions: its velocity changes by impulse over mass, its turning by the impulse's lever. Momentum is what it was before.",
      formula: ["v_B' = v_B + frac(J, m_B)", "v_A' = v_A - frac(J, m_A)", ...(["b", "a"] as const).map((w) =>
        `v_${w.toUpperCase()}' = ${row(q[w]!.linear!)} ${w === "b" ? "+" : "-"} frac(${row(answer.impulse!)}, ${digits(Number(q[w]!.mass), 4)}) = ${row(answer[w]!.linear)}`)],
      numbers: { caption: "After", columns: ["body", "linear, m/s", "angular, rad/s"], rows: (["a", "b"] as const).map((w) => ({ cells: [w.toUpperCase(), vector(answer[w]!.linear, 4), vector(answer[w]!.angular as Vec, 3)], key: `after-${w}` })) },
      says: `After: A ${vector(answer.a!.linear, 3)}, B ${vector(answer.b!.linear, 3)}.`,
      draw(d) {
        drawBodies(d, q);
        for (const w of ["a", "b"] as const) {
          d.arrow(q[w]!.translation!, add(q[w]!.translation!, q[w]!.linear!), "out", { dashed: true });
          d.arrow(q[w]!.translation!, add(q[w]!.translation!, answer[w]!.linear), w, { wide: true, key: `after-${w}` });
        }
        d.point(point, "touch", { wide: true });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Head on, restitution 1", note: "Equal balls swap their velocities.", state: situation([1, 0, 0], [0, 0, 0], 1, sphere(0.7), [1.38, 0, 0], { restitution: 1 }) },
    { label: "Off centre", note: "The impulse turns the box as well.", state: situation([1.2, 0, 0], [0, 0, 0], 1, box(1.2, 1.2, 1.2), [1.25, 0.5, 0]) },
    { label: "They part", note: "No impulse, whatever the restitution.", state: situation([-1, 0, 0], [0.5, 0, 0]) },
  ],
  wrong: [
    { label: "A hundred to one", note: "The light body takes nearly all of the change. In a pile solved contact by contact such ratios converge slowly: the heavy one sinks into the light one.", state: situation([0.2, 0, 0], [-1, 0, 0], 100) },
    { label: "Slipping", note: "Nearly tangential: friction reaches its limit, and the answer is on the cone.", state: situation([0.3, 1.6, 0], [0, 0, 0], 1, box(1.2, 1.2, 1.2), [1.25, 0.1, 0], { friction: 0.1 }) },
  ],
  sources: ["B. Mirtich, J. Canny: Impulse-based simulation of rigid bodies, 1995", "E. Catto: Iterative dynamics with temporal coherence, 2005", "C. de Coulomb: Théorie des machines simples, 1781"],
};
