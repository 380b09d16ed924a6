// The work of the library for an answer about the selected bodies, or about what was shot, a step at a time: its own
// drawing of the trace upon the scene. Which question is explained is chosen.

import { ask, bodyAt, type Answer, type Trace } from "../graze.ts";
import { drawDistance, drawRay, drawTrace, endOf } from "../parts/answers.ts";
import { digits, h, vector } from "../parts/dom.ts";
import type { Drawing, Meaning } from "../parts/drawing.ts";
import { Timeline } from "../parts/timeline.ts";
import { add, scale } from "../parts/vec.ts";
import type { Body, Question, Vec } from "../question.ts";
import { drawMotions, drawWays } from "./asked.ts";
import { firstShown, type Explained, type Shown } from "./moment.ts";
import type { AskedPair } from "./pair.ts";
import type { Aim, Shot } from "./shots.ts";

type ShownTrace = Pick<Shown, "explained" | "traceStep">;
/** The questions about a pair, in the order in which they are listed. */
const ofPairs = ["overlap", "distance", "contacts"] as const;
const labels: Record<Explained, string> = {
  overlap: "Do they overlap?", distance: "How far apart?", contacts: "Where do they touch?", cast: "When does it touch?", raycast: "Where does the ray enter?",
  closest: "Where is its surface nearest?", response: "How do they go on?" };

/** The questions that can be explained about a pair and what was aimed at, and a key of what they are about. */
export function explained(pair: AskedPair | null, aim: Aim | null, shot: Shot | null, selected: number[]): [Question[], string] {
  const { margin, ...bare } = pair?.question ?? ({} as Question), shots = shot?.question && aim?.kind !== "measure" ? [shot.question] : [];
  const about = pair ? ofPairs.map((query): Question => ({ ...bare, query, ...(query === "contacts" ? { margin } : {}) })) : [];
  return [[...about, ...shots], JSON.stringify([selected, aim])];
}

/** A step in words, and what is drawn for it. */
interface TraceStep {
  words: string;
  draw(d: Drawing, size: number): void;
}
const inSpace = ([x, y, z = 0]: Vec): Vec => [x, y, z];
/** A normal of a trace, which has three numbers, for the drawing of a ray of either dimension. */
const asLongAs = (normal: Vec, { origin }: { origin: Vec }): Vec => normal.slice(0, origin.length);
const placeOf = ({ translation }: Body): Vec => inSpace(translation ?? [0, 0, 0]);

/** The axes, iterations, expansions and cuts of a trace, in the order in which the library counts them. */
function searched({ a, b }: Question, trace: Trace): TraceStep[] {
  const { axes, gjk, epa, cuts = [] } = trace, from = placeOf(a), middle = scale(add(from, b ? placeOf(b) : from), 0.5);
  const words = [
    ...axes.map(({ name, overlap }) => `Axis ${name}: ${overlap >= 0 ? "overlap" : "gap"} ${digits(Math.abs(overlap), 5)}`),
    ...gjk.map(({ lower, upper }, i) => `GJK, iteration ${i + 1}: distance of the cores from ${digits(lower, 5)} to ${digits(upper, 5)}`),
    ...epa.map(({ faceDepth, foundDepth }, i) => `EPA, expansion ${i + 1}: depth from ${digits(faceDepth, 5)} to ${digits(foundDepth, 5)}`),
    ...cuts.map(({ left }, i) => `Cut ${i + 1} of the face: ${left.length} corners are left`)];
  return words.map((said, step) => ({ words: said, draw(d, size) {
    const found = (gjk[step - axes.length] ?? epa[step - axes.length - gjk.length])?.found;
    // The difference lies about A's place, so that it is seen beside the bodies.
    const by = step >= axes.length && step < axes.length + gjk.length + epa.length ? from : undefined;
    drawTrace(d, trace, { size, center: middle, by, look: { wide: true }, as: { a: "made", ruledOut: "out" } }, step);
    if (!by || !found) return;
    d.point(inSpace(found.a), "made", { wide: true });
    d.point(inSpace(found.b), "b", { wide: true });
  } }));
}
/** Where a ray is in the parts of a shape, one condition after the other. */
function entered({ ray, a }: Question, { spans = [] }: Trace): TraceStep[] {
  return spans.map(({ name, normal, span }) => {
    const [enter, leave] = span.map(endOf), misses = enter > leave;
    return { words: `${name}: ${misses ? "never inside" : `inside from ${digits(span[0], 5)} to ${digits(span[1], 5)}`}`, draw(d, size) {
      if (misses || !Number.isFinite(enter)) return drawRay(d, ray as never, null, { size, center: placeOf(a), look: { wide: true } });
      const along = scale(ray!.direction, 1 / Math.hypot(...ray!.direction));
      drawRay(d, ray as never, { t: enter, point: add(ray!.origin, scale(along, enter)), normal: asLongAs(normal, ray!) } as never, { size, look: { wide: true }, label: name });
    } };
  });
}
/** A moving body where it is at time t, for a question about bodies that stand. */
function stillAt(body: Body, t: number, flat: boolean): Body {
  const { linear: _, angular: __, ...there } = bodyAt(body, t, flat);
  return there;
}
/** A body, or the head of a ray, as far as it may go without touching. */
function advanced(question: Question, { steps = [] }: Trace): TraceStep[] {
  const { a, b, ray } = question, flat = question.dimension === 2;
  return steps.map(({ t, distance, normal }, i) => ({
    words: `Advancement ${i + 1}: ${ray ? "after" : "at"} ${digits(t, 6)} the distance is ${digits(distance, 5)}`, draw(d, size) {
      const look = { wide: true };
      if (ray) {
        const point = add(ray.origin, scale(ray.direction, t / Math.hypot(...ray.direction)));
        return drawRay(d, ray as never, { t, point, normal: asLongAs(normal, ray) } as never, { size, look });
      }
      drawWays(d, question, t, { look });
      const apart = ask({ query: "distance", ...(flat ? { dimension: 2 } : {}), a: stillAt(a, t, flat), b: stillAt(b!, t, flat) });
      if (apart.distance! > 0) drawDistance(d, apart, { look });
    } }));
}
/** What a blow does: how fast the bodies meet at the point, what stops that, and how they go on. */
function struck(question: Question, answer: Answer): TraceStep[] {
  const { relativeVelocity: meets, friction, effectiveMass } = answer.trace, { point, normal } = question.contact!;
  if (!meets) return [];
  const arrow = (d: Drawing, by: Vec, meaning: Meaning, label: string): void => d.arrow(point, add(point, by), meaning, { wide: true, label });
  const before = (d: Drawing): void => drawMotions(d, question, answer, false);
  const along = answer.normalImpulse!;
  return [
    { words: `At the point they meet with ${vector(meets.whole, 4)}: ${digits(meets.normal, 5)} along the normal`, draw: (d) => (before(d), arrow(d, meets.whole, "made", "v")) },
    { words: `The normal impulse is ${digits(along, 5)}: they resist with ${digits(effectiveMass, 5)}`, draw: (d) => (before(d), arrow(d, scale(normal, along), "touch", "j")) },
    ...(friction ? [{ words: `Friction gives at most ${digits(friction.limit, 5)}: it ${friction.holds ? "holds" : "slips"}`,
      draw: (d: Drawing) => (before(d), arrow(d, friction.impulse, "touch", "friction")) }] : []),
    { words: `The whole impulse on B is ${vector(answer.impulse, 4)}`, draw: (d) => (drawMotions(d, question, answer), arrow(d, answer.impulse!, "touch", "impulse")) }];
}
function stepsOf(question: Question, answer: Answer): TraceStep[] {
  const { trace } = answer;
  if (answer.error) return [];
  if (question.query === "response") return struck(question, answer);
  return [...entered(question, trace), ...advanced(question, trace), ...(question.query === "cast" || question.query === "raycast" ? [] : searched(question, trace))];
}

export class TraceSteps {
  readonly element = h("div", { class: "trace-steps", role: "group", "aria-label": "Steps of the answer", hidden: true });
  private readonly choice: HTMLSelectElement;
  /** Its first place is that before the first step. */
  private readonly timeline: Timeline;
  private questions: Question[] = [];
  private chosen = firstShown.explained;
  private key = "";
  /** None is drawn before the first. */
  private step = -1;
  private expected = -1;
  private steps: TraceStep[] = [];
  private answer: Answer | null = null;

  /** `onStep`: called when another step is to be drawn. */
  constructor(onStep: () => void) {
    const go = (step: number): void => {
      this.step = step;
      this.show();
      onStep();
    };
    this.timeline = new Timeline((at) => go(at - 1),
      { word: "step of the trace", next: "Next step of its trace", marks: ["data-trace-next", "data-trace-back"], where: () => this.words });
    this.choice = h("select", { "aria-label": "What is explained", "data-explained": true, onchange: () => {
      this.chosen = this.choice.value as Explained;
      go(-1);
    } }) as HTMLSelectElement;
    this.element.append(this.choice, this.timeline.element);
  }
  /** Which question is explained, and which step is drawn: -1 for none. */
  get shown(): ShownTrace {
    return { explained: this.chosen, traceStep: this.step };
  }
  /** For the bodies that come next. */
  set shown({ explained, traceStep }: ShownTrace) {
    this.chosen = explained;
    this.step = this.expected = traceStep;
  }
  stop(): void {
    this.timeline.stop();
  }
  /** What can be explained of the bodies with this key; question and step stay while it is the same. */
  take(questions: Question[], key: string): void {
    this.questions = questions;
    if (key !== this.key) this.step = this.expected;
    this.expected = -1;
    this.key = key;
    this.show();
  }
  draw(d: Drawing, size: number): void {
    this.steps[this.step]?.draw(d, size);
  }
  private get words(): string {
    const { steps, step, answer } = this, count = steps.length;
    if (step >= 0) return `${step + 1} / ${count}. ${steps[step].words}`;
    return count > 0 ? `${count} steps` : answer ? answer.error ?? `${answer.trace.method}, no steps` : "";
  }
  private show(): void {
    const { questions } = this, now = questions.find(({ query }) => query === this.chosen) ?? questions.find(({ query }) => query === firstShown.explained) ?? questions[0];
    this.element.hidden = !now;
    this.answer = now ? ask(now) : null;
    this.steps = this.answer ? stepsOf(now, this.answer) : [];
    this.step = Math.min(this.step, this.steps.length - 1);
    const listed = questions.map(({ query }) => query as Explained).join(" ");
    if (this.choice.dataset.listed !== listed) {
      this.choice.dataset.listed = listed;
      this.choice.replaceChildren(...questions.map(({ query }) => h("option", { value: query }, labels[query as Explained])));
    }
    if (now) this.choice.value = now.query;
    this.timeline.show(this.step + 1, this.steps.length + 1);
  }
}
