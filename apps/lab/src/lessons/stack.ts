import { graze } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import { box, plane, type Body, type State, type Vec } from "../question.ts";
import type { Lesson, Step } from "./lesson.ts";

const boxes = 10, rate = 60, every = 6, frames = 10;
const size: Vec = [1, 1, 1];
/** The numbers of sub-steps of a step, or "auto", the library's default: four, and up to sixteen where one contact
 *  bears much, more only where bodies stand high on each other. */
const efforts = ["1", "2", "4", "8", "16", "auto"] as const;
type Effort = (typeof efforts)[number];
const masses = [1, 10, 100, 1000];
const named: Record<Effort, string> = { 1: "1", 2: "2", 4: "4", 8: "8", 16: "16", auto: "4 and more, by load" };
const settings = (effort: Effort): graze.SimulationSettings =>
  effort === "auto" ? { sleep: false } : { sleep: false, subSteps: Number(effort), mostSubSteps: Number(effort) };

interface Frame { poses: { translation: Vec; rotation: Vec }[]; deepest: number; mean: number; residual: number; contacts: number; subSteps: number }
interface Run { start: Frame["poses"]; frames: Frame[] }
const kept = new Map<string, Run>();
/** Ten boxes on a floor, each a little beside the one below, for a second: the solver's report, and their places. */
function run(effort: Effort, mass: number, friction: number): Run {
  const key = `${effort} ${mass} ${friction}`;
  const known = kept.get(key);
  if (known) return known;
  const simulation = new graze.Simulation(settings(effort)), shape = new graze.Box(size), floor = new graze.HalfSpace();
  const material = { staticFriction: friction, dynamicFriction: friction };
  simulation.add({ shape: floor, fixed: true }, {}, material);
  const ids = Array.from({ length: boxes }, (_, i) =>
    simulation.add({ shape, translation: [i % 2 === 0 ? 0.04 : -0.04, 0.5 + i, 0] }, { mass: i === boxes - 1 ? mass : 1 }, material));
  const poses = (): Frame["poses"] => ids.map((id) => simulation.pose(id));
  const made: Run = { start: poses(), frames: [] };
  for (let i = 1; i <= frames * every; i++) {
    simulation.step(1 / rate);
    if (i % every !== 0) continue;
    const { deepest, meanDepth, residual, contacts, mostSubSteps } = simulation.report();
    made.frames.push({ poses: poses(), deepest, mean: meanDepth, residual, contacts, subSteps: mostSubSteps });
  }
  for (const handle of [simulation, shape, floor]) handle.dispose();
  kept.set(key, made);
  return made;
}
const situation = (effort: Effort, mass: number, friction = 0.6): State => ({
  q: { query: "contacts", a: { shape: plane() }, b: { shape: box(...size), translation: [0.04, 0.5, 0] }, margin: 0.05 }, choice: { effort, mass, friction } });
const chosen = (state: State): { effort: Effort; mass: number; friction: number } => ({
  effort: efforts.find((e) => e === state.choice?.effort) ?? "auto",
  mass: masses.find((m) => m === state.choice?.mass) ?? 1,
  friction: Number(state.choice?.friction ?? 0.6),
});
const top = (poses: Frame["poses"]): Vec => poses[boxes - 1].translation;
/** The way of a place from another along X, Y and Z. */
const moved = (from: Vec, to: Vec): Vec => to.map((x, i) => x - from[i]);

export const stack: Lesson = {
  id: "stack", number: 13, title: "A stack", question: "Ten boxes stand on each other: what does the solver make of it?",
  intro: "One contact has an answer in closed form. In a stack each impulse changes all the others, and a solver goes over them again and again. What it leaves is seen as sinking and as drift.",
  dimension: 3, view: { center: [0, 5, 0], reach: 6, from: [0.25, 0.12, 1] }, start: situation("auto", 1),
  choices: [
    { key: "effort", label: "Sub-steps", options: [{ value: "auto", label: "as needed" }, ...efforts.slice(0, 5).map((value) => ({ value, label: value }))] },
    { key: "mass", label: "Mass of the top box", options: masses.map((value) => ({ value, label: `${value} kg` })) },
    { key: "friction", label: "Friction", options: [{ value: 0.6, label: "0.6" }, { value: 0, label: "none" }] },
  ],
  handles: () => [], drag: (s) => s,
  steps(state) {
    const { effort, mass, friction } = chosen(state), { start, frames: list } = run(effort, mass, friction);
    const draw = (poses: Frame["poses"]): Step["draw"] => (d) => {
      d.shape({ shape: plane() }, "ink", { ghost: true });
      poses.forEach((pose, i) => {
        const body: Body = { shape: box(...size), ...pose };
        d.shape(body, i === boxes - 1 ? "b" : "a");
      });
      const from = top(start), to = top(poses);
      d.line([from[0], 0, from[2]], [from[0], from[1] + 1, from[2]], "axis", { dashed: true });
      d.point(from, "axis");
      d.point(to, "touch", { wide: true, label: "top" });
    };
    const deepest = list.map((f) => f.deepest), drift = (f: Frame): Vec => moved(top(start), top(f.poses));
    const steps: Step[] = [{
      title: "Ten boxes",
      text: `A box of one metre and one kilogram on another, nine of them, and one of ${mass} kg on top; each stands 8 cm beside the one below. The lowest contact has to carry ${8 + 1 + mass} kg. A step of 1/${rate} s is divided into sub-steps. In each the solver goes once over all contacts, and starts from the impulses that it found last: a warm start. The library offers no solver without it, so there is no switch for that here.`,
      numbers: { caption: "What is simulated", columns: ["quantity", "value"], rows: [{ cells: ["boxes", boxes] }, { cells: ["mass of the top box, kg", mass] }, { cells: ["friction", friction] }, { cells: ["sub-steps of a step", named[effort]] }] },
      says: `Ten boxes on each other, the top one of ${mass} kilograms.`,
      draw: draw(start),
    }];
    list.forEach((frame, i) => {
      const by = drift(frame), seconds = (i + 1) / frames;
      steps.push({
        title: `After ${seconds.toFixed(1)} s`,
        text: `The deepest contact overlaps by ${digits(frame.deepest * 1000, 4)} mm. The top box is ${digits(Math.abs(by[1]) * 1000, 4)} mm ${by[1] < 0 ? "lower" : "higher"} than it was put, and ${digits(Math.abs(by[0]) * 1000, 4)} mm to the ${by[0] < 0 ? "left" : "right"}. ${frame.subSteps} sub-steps were taken. The fastest approach that the solver left at a touching point is ${digits(frame.residual * 1000, 4)} mm/s.`,
        numbers: { caption: "What the library reports of the step", columns: ["quantity", "value"], rows: [
          { cells: ["points of contact", frame.contacts] }, { cells: ["deepest, m", frame.deepest], mark: "now" }, { cells: ["mean depth, m", frame.mean] },
          { cells: ["residual, m/s", frame.residual] }, { cells: ["sub-steps", frame.subSteps] }, { cells: ["top moved by, m", vector(by, 3)] }] },
        graph: { caption: "depth in mm", at: i, series: [{ name: "deepest", meaning: "touch", values: deepest.map((x) => x * 1000) }, { name: "mean", meaning: "made", values: list.map((f) => f.mean * 1000) }] },
        says: `After ${seconds.toFixed(1)} seconds the deepest contact is ${digits(frame.deepest * 1000, 3)} millimetres deep.`,
        draw: draw(frame.poses),
      });
    });
    const all = efforts.map((e) => ({ e, end: run(e, mass, friction).frames[frames - 1] }));
    const end = list[frames - 1];
    steps.push({
      title: "One second, with every effort",
      text: "The contacts are soft: a spring pushes what overlaps apart, as stiff as the sub-step allows. Shorter sub-steps are stiffer and bring an impulse from the floor further up, so that half the sub-step sinks about a quarter as deep. More mass on top sinks deeper, and far too much is not held at all. Left to itself the library takes more sub-steps where a contact bears so much that it would visibly sink.",
      formula: ['"depth" ~ h^2'],
      numbers: { caption: "After one second, in mm: the deepest contact, the top box down and aside", columns: ["sub-steps", "deepest", "down", "aside", "taken"], rows: all.map(({ e, end: f }) => ({ cells: [e === "auto" ? "needed" : named[e], f.deepest * 1000, -drift(f)[1] * 1000, drift(f)[0] * 1000, f.subSteps], mark: e === effort ? "now" as const : undefined })) },
      graph: { caption: "deepest in mm for 1, 2, 4, 8, 16 sub-steps, as needed", at: efforts.indexOf(effort), series: [{ name: "deepest", meaning: "touch", values: all.map(({ end: f }) => f.deepest * 1000) }] },
      says: `With every effort: deepest from ${digits(Math.min(...all.map(({ end: f }) => f.deepest)) * 1000, 3)} to ${digits(Math.max(...all.map(({ end: f }) => f.deepest)) * 1000, 3)} millimetres.`,
      draw: draw(end.poses),
    });
    return steps;
  },
  tryThis: [
    { label: "One sub-step", note: "The whole step at once: softer contacts, a deeper stack.", state: situation("1", 1) },
    { label: "A hundred to one", note: "As much as ten stacks on the lowest box. As many sub-steps as it takes.", state: situation("auto", 100) },
  ],
  wrong: [
    { label: "A thousand to one", note: "The light boxes are pressed into each other and thrown out, and the heavy one comes down by metres, whatever the sub-steps: impulses from the floor do not get up there in time.", state: situation("auto", 1000) },
    { label: "No friction", note: "A contact that cannot hold sideways turns what leans into drift, and ten times the load on one sub-step shows it.", state: situation("1", 10, 0) },
  ],
  sources: ["E. Catto: Solver2D, 2024 (soft contacts in sub-steps)", "M. Macklin and others: Small steps in physics simulation, Symposium on Computer Animation 2019", "E. Catto: Iterative dynamics with temporal coherence, 2005 (warm starts)"],
};
