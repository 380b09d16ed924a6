import { graze } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import { box, plane, type Body, type State, type Vec } from "../question.ts";
import { dragTo, later, numberOf, type Lesson, type Step } from "./lesson.ts";
import { stackPrograms, type Stack } from "./programs.ts";

const boxes = 10, rate = 60, every = 6, frames = 10;
/** The place of the top box where nobody has dragged it. */
const usualTop: Vec = [-0.04, 9.5, 0];
/** The number of runs that are kept: a drag of the top box asks for hundreds, a page for as many as there are
 *  efforts. */
const most = 24;
const size: Vec = [1, 1, 1];
/** The numbers of sub-steps of a step, or "auto", the library's default: four, and up to sixteen where one contact
 *  bears much, more only where bodies stand high on each other. */
const efforts = ["1", "2", "4", "8", "16", "auto"] as const;
type Effort = (typeof efforts)[number];
const masses = [1, 10, 100, 1000], frictions = [0.6, 0];
const named: Record<Effort, string> = { 1: "1", 2: "2", 4: "4", 8: "8", 16: "16", auto: "4 and more, by load" };
/** Everything that is simulated. */
const stackOf = ({ effort, warm, mass, friction, top }: Setup): Stack =>
  ({ boxes, rate, steps: frames * every, subSteps: effort === "auto" ? null : Number(effort), warm, mass, friction, top });

interface Setup { effort: Effort; warm: boolean; mass: number; friction: number; top: Vec }
interface Frame { poses: { translation: Vec; rotation: Vec }[]; deepest: number; mean: number; residual: number; contacts: number; subSteps: number }
const kept = new Map<string, Frame[]>();
/** The places of the boxes at the beginning, the lowest first. */
const startOf = ({ top }: Setup): Frame["poses"] => Array.from({ length: boxes }, (_, i) => ({
  translation: i === boxes - 1 ? top : [i % 2 === 0 ? 0.04 : -0.04, 0.5 + i, 0], rotation: [0, 0, 0, 1] }));
/** Ten boxes on a floor, each a little beside the one below, for a second: the solver's report, and their places. */
function run(setup: Setup): Frame[] {
  const key = JSON.stringify(setup), known = kept.get(key);
  if (known) return known;
  if (kept.size >= most) kept.clear();
  const { subSteps, warm, mass, friction } = stackOf(setup);
  const settings: graze.SimulationSettings = { sleep: false, warmStart: warm, ...(subSteps === null ? {} : { subSteps, mostSubSteps: subSteps }) };
  const simulation = new graze.Simulation(settings), shape = new graze.Box(size), floor = new graze.HalfSpace();
  const material = { staticFriction: friction, dynamicFriction: friction };
  const made: Frame[] = [];
  try {
    simulation.add({ shape: floor, fixed: true }, {}, material);
    const ids = startOf(setup).map(({ translation }, i) =>
      simulation.add({ shape, translation }, { mass: i === boxes - 1 ? mass : 1 }, material));
    for (let i = 1; i <= frames * every; i++) {
      simulation.step(1 / rate);
      if (i % every !== 0) continue;
      const { deepest, meanDepth, residual, contacts, mostSubSteps } = simulation.report();
      const poses = ids.map((id) => simulation.pose(id));
      made.push({ poses, deepest, mean: meanDepth, residual, contacts, subSteps: mostSubSteps });
    }
  } finally {
    for (const handle of [simulation, shape, floor]) handle.dispose();
  }
  kept.set(key, made);
  return made;
}
const situation = (effort: Effort, mass: number, friction = frictions[0], [x, y, z] = usualTop, warm = true): State => ({
  q: { query: "contacts", a: { shape: plane() }, b: { shape: box(...size), translation: [0.04, 0.5, 0] }, margin: 0.05 }, choice: { effort, warm, mass, friction, x, y, z } });
const chosen = (state: State): Setup => ({
  effort: efforts.find((e) => e === state.choice?.effort) ?? "auto",
  warm: state.choice?.warm !== false,
  mass: masses.find((m) => m === state.choice?.mass) ?? 1,
  friction: frictions.find((f) => f === state.choice?.friction) ?? frictions[0],
  top: ["x", "y", "z"].map((k, i) => numberOf(state, k, usualTop[i])),
});
const top = (poses: Frame["poses"]): Vec => poses[boxes - 1].translation;
/** The way of a place from another along X, Y and Z. */
const moved = (from: Vec, to: Vec): Vec => to.map((x, i) => x - from[i]);

export const stack: Lesson = {
  id: "stack", number: 13, title: "A stack", question: "Ten boxes stand on each other: what does the solver make of it?",
  intro: "One contact has an answer in closed form. In a stack each impulse changes all the others, and a solver goes over them again and again. What it leaves is seen as sinking and as drift. Drag the top box: aside, or up, so that it falls.",
  dimension: 3, view: { center: [0, 5, 0], reach: 6, from: [0.25, 0.12, 1] }, start: situation("auto", 1),
  choices: [
    { key: "effort", label: "Sub-steps", options: [{ value: "auto", label: "as needed" }, ...efforts.slice(0, 5).map((value) => ({ value, label: value }))] },
    { key: "warm", label: "Warm start", options: [{ value: true, label: "from the last impulses" }, { value: false, label: "from none" }] },
    { key: "mass", label: "Mass of the top box", options: masses.map((value) => ({ value, label: `${value} kg` })) },
    { key: "friction", label: "Friction", options: frictions.map((value) => ({ value, label: value === 0 ? "none" : String(value) })) },
  ],
  handles: (s) => [{ id: "top", label: "Put the top box elsewhere", kind: "move", meaning: "b", named: true, at: chosen(s).top }],
  drag: (s, _id, [x, y, z]) => ({ ...s, choice: { ...s.choice, x: dragTo(x), y: dragTo(Math.max(usualTop[1], y)), z: dragTo(z) } }),
  asks: () => undefined,
  code(state) {
    const setup = chosen(state);
    return {
      programs: stackPrograms(stackOf(setup)),
      prints() {
        const { deepest, poses } = run(setup)[frames - 1];
        return [deepest, ...top(poses)];
      },
    };
  },
  steps(state) {
    const setup = chosen(state), { effort, warm, mass, friction } = setup;
    const draw = (poses: Frame["poses"]): Step["draw"] => (d) => {
      d.shape({ shape: plane() }, "ink", { ghost: true });
      poses.forEach((pose, i) => {
        const body: Body = { shape: box(...size), ...pose };
        d.shape(body, i === boxes - 1 ? "b" : "a");
      });
      const from = setup.top, to = top(poses);
      d.line([from[0], 0, from[2]], [from[0], from[1] + 1, from[2]], "axis", { dashed: true });
      d.point(from, "axis");
      d.point(to, "touch", { wide: true, label: "top" });
    };
    const drift = (f: Frame): Vec => moved(setup.top, top(f.poses));
    const aside = setup.top.every((x, i) => x === usualTop[i]) ? "each stands 8 cm beside the one below" : "each stands 8 cm beside the one below, but for the top one, which was put elsewhere";
    const steps: Step[] = [{
      title: "Ten boxes",
      text: `A box of one metre and one kilogram on another, nine of them, and one of ${mass} kg on top; ${aside}. The lowest contact has to carry ${8 + 1 + mass} kg. A step of 1/${rate} s is divided into sub-steps. In each the solver goes once over all contacts, and starts from ${warm ? "the impulses that it found last: a warm start" : "no impulses: each sub-step has to find anew what carries the stack"}.`,
      numbers: { caption: "What is simulated", columns: ["quantity", "value"], rows: [{ cells: ["boxes", boxes] }, { cells: ["mass of the top box, kg", mass] }, { cells: ["friction", friction] }, { cells: ["sub-steps of a step", named[effort]] }, { cells: ["begins with", warm ? "the last impulses" : "no impulses"] }] },
      handles: ["top"],
      says: `Ten boxes on each other, the top one of ${mass} kilograms.`,
      draw: draw(startOf(setup)),
    }];
    for (let i = 0; i < frames; i++) steps.push(later(() => {
      const list = run(setup), frame = list[i], deepest = list.map((f) => f.deepest);
      const by = drift(frame), seconds = (i + 1) / frames;
      return {
        title: `After ${seconds.toFixed(1)} s`,
        text: `The deepest contact overlaps by ${digits(frame.deepest * 1000, 4)} mm. The top box is ${digits(Math.abs(by[1]) * 1000, 4)} mm ${by[1] < 0 ? "lower" : "higher"} than it was put, and ${digits(Math.abs(by[0]) * 1000, 4)} mm to the ${by[0] < 0 ? "left" : "right"}. ${frame.subSteps} sub-steps were taken. The fastest approach that the solver left at a touching point is ${digits(frame.residual * 1000, 4)} mm/s.`,
        numbers: { caption: "What the library reports of the step", columns: ["quantity", "value"], rows: [
          { cells: ["points of contact", frame.contacts] }, { cells: ["deepest, m", frame.deepest], mark: "now" }, { cells: ["mean depth, m", frame.mean] },
          { cells: ["residual, m/s", frame.residual] }, { cells: ["sub-steps", frame.subSteps] }, { cells: ["top moved by, m", vector(by, 3)] }] },
        graph: { caption: "depth in mm", at: i, series: [{ name: "deepest", meaning: "touch", values: deepest.map((x) => x * 1000) }, { name: "mean", meaning: "made", values: list.map((f) => f.mean * 1000) }] },
        says: `After ${seconds.toFixed(1)} seconds the deepest contact is ${digits(frame.deepest * 1000, 3)} millimetres deep.`,
        draw: draw(frame.poses),
      };
    }));
    steps.push(later(() => {
      const all = efforts.map((e) => ({ e, end: run({ ...setup, effort: e })[frames - 1] }));
      return {
        title: "One second, with every effort",
        text: "The contacts are soft: a spring pushes what overlaps apart, as stiff as the sub-step allows. Shorter sub-steps are stiffer and bring an impulse from the floor further up, so that half the sub-step sinks about a quarter as deep. More mass on top sinks deeper, and far too much is not held at all. Left to itself the library takes more sub-steps where a contact bears so much that it would visibly sink.",
        formula: ['"depth" ~ h^2'],
        numbers: { caption: "After one second, in mm: the deepest contact, the top box down and aside", columns: ["sub-steps", "deepest", "down", "aside", "taken"], rows: all.map(({ e, end: f }) => ({ cells: [e === "auto" ? "needed" : named[e], f.deepest * 1000, -drift(f)[1] * 1000, drift(f)[0] * 1000, f.subSteps], mark: e === effort ? "now" as const : undefined })) },
        graph: { caption: "deepest in mm for 1, 2, 4, 8, 16 sub-steps, as needed", at: efforts.indexOf(effort), series: [{ name: "deepest", meaning: "touch", values: all.map(({ end: f }) => f.deepest * 1000) }] },
        says: `With every effort: deepest from ${digits(Math.min(...all.map(({ end: f }) => f.deepest)) * 1000, 3)} to ${digits(Math.max(...all.map(({ end: f }) => f.deepest)) * 1000, 3)} millimetres.`,
        draw: draw(run(setup)[frames - 1].poses),
      };
    }));
    return steps;
  },
  tryThis: [
    { label: "A box that falls", note: "The top box falls a metre onto the other nine: see how deep it goes in, and where it comes to rest.", state: situation("auto", 1, 0.6, [0, 10.5, 0]) },
    { label: "Over the edge", note: "Its centre of mass stands beyond the edge of the box below: it tips over and falls, and the nine stay.", state: situation("auto", 1, 0.6, [0.7, 9.5, 0]) },
    { label: "One sub-step", note: "The whole step at once: softer contacts, a deeper stack.", state: situation("1", 1) },
    { label: "A hundred to one", note: "As much as ten stacks on the lowest box. As many sub-steps as it takes.", state: situation("auto", 100) },
  ],
  wrong: [
    { label: "A thousand to one", note: "The light boxes are pressed into each other and thrown out, and the heavy one comes down by metres, whatever the sub-steps: impulses from the floor do not get up there in time.", state: situation("auto", 1000) },
    { label: "No warm start", note: "One sub-step that begins with no impulses and goes over the contacts once: the floor's push does not get up to where the weight is, and the stack sinks by a metre in a second. Every further sub-step brings it further up.", state: situation("1", 1, frictions[0], usualTop, false) },
    { label: "No friction", note: "A contact that cannot hold sideways turns what leans into drift, and ten times the load on one sub-step shows it.", state: situation("1", 10, 0) },
  ],
  sources: ["E. Catto: Solver2D, 2024 (soft contacts in sub-steps)", "M. Macklin and others: Small steps in physics simulation, Symposium on Computer Animation 2019", "E. Catto: Iterative dynamics with temporal coherence, 2005 (warm starts)"],
};
