import { graze } from "../graze.ts";
import { digits } from "../parts/dom.ts";
import { box, type State, type Vec } from "../question.ts";
import type { Lesson, Step } from "./lesson.ts";
import { broadPhasePrograms } from "./programs.ts";

const kinds = ["dynamicTree", "sortAndSweep", "sweepAndPrune", "hashedGrid", "looseOctree", "bsp"] as const;
type Kind = (typeof kinds)[number];
const labels: Record<Kind, string> = { dynamicTree: "tree", sortAndSweep: "sort and sweep", sweepAndPrune: "sweep and prune", hashedGrid: "grid", looseOctree: "loose octree", bsp: "BSP" };
const how: Record<Kind, string> = {
  dynamicTree: "A tree of boxes around boxes. A body moves a little within a fattened box without touching the tree; a query goes down only where boxes overlap.",
  sortAndSweep: "All ends along one axis are sorted anew; what overlaps there is compared with what is open.",
  sweepAndPrune: "The sorted ends of all three axes are kept from frame to frame. Bodies that move a little exchange few places.",
  hashedGrid: "Space is cut into cells of one size, found by a hash of their place. Bodies in the same cell are compared.",
  looseOctree: "Cells halve again and again, each twice as large as it has to be, so that every body has one cell by its size and centre.",
  bsp: "Planes along the axes cut space into two, again and again: a k-d tree over the boxes.",
};
const count = 100, frames = 20;

/** The same bodies for everybody: a linear congruential generator (Numerical Recipes). */
function bodies(scene: string): { center: Vec; half: Vec; velocity: Vec }[] {
  let seed = 7;
  const random = (): number => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const spread = scene === "heap" ? 1 : 6;
  return Array.from({ length: count }, (_, i) => ({
    center: [1, 1, 1].map(() => (random() - 0.5) * spread),
    half: scene === "giant" && i === 0 ? [2.6, 2.6, 2.6] : [1, 1, 1].map(() => 0.12 + random() * 0.2),
    velocity: [1, 1, 1].map(() => (random() - 0.5) * 0.12),
  }));
}
interface Frame { boxes: { lower: Vec; upper: Vec }[]; pairs: Uint32Array; tests: number; memory: number }
interface Run { frames: Frame[]; /** Of a frame: browsers' clocks are too coarse for a single one. */ micros: number }
const kept = new Map<string, Run>();

/** All frames of a scene with one structure. */
function run(kind: Kind, scene: string): Run {
  const key = `${kind} ${scene}`;
  const known = kept.get(key);
  if (known) return known;
  const list = bodies(scene), phase = new graze.BroadPhase(kind), made: Frame[] = [];
  let spent = 0;
  const bounds = (at: number): Frame["boxes"] => list.map(({ center, half, velocity }, i) => {
    const place = center.map((c, k) => {
      // There and back between walls; or somewhere else altogether in each frame.
      const x = scene === "teleport" ? ((Math.imul(i * 3 + k + 1, 2654435761 + at * 40503) >>> 0) / 2 ** 32 - 0.5) * 6 : c + velocity[k] * at;
      return ((x + 9) % 12 + 12) % 12 < 6 ? ((x + 9) % 6 + 6) % 6 - 3 : 3 - (((x + 9) % 6 + 6) % 6);
    });
    return { lower: place.map((x, k) => x - half[k]), upper: place.map((x, k) => x + half[k]) };
  });
  for (let at = 0; at < frames; at++) {
    const boxes = bounds(at), start = performance.now();
    boxes.forEach(({ lower, upper }, id) => (at === 0 ? phase.insert(id, lower, upper) : phase.move(id, lower, upper)));
    const pairs = phase.pairs();
    spent += performance.now() - start;
    const { tests, memory } = phase.counts();
    made.push({ boxes, pairs, tests, memory });
  }
  phase.dispose();
  const result = { frames: made, micros: (spent * 1000) / frames };
  kept.set(key, result);
  return result;
}
const chosen = (state: State): { kind: Kind; scene: string } => ({
  kind: kinds.find((k) => k === state.choice?.kind) ?? "dynamicTree",
  scene: scenes.find((s) => s.value === state.choice?.scene)?.value ?? "crowd",
});
const situation = (scene: string, kind: Kind = "dynamicTree"): State => ({
  q: { query: "overlap", a: { shape: box(1, 1, 1) }, b: { shape: box(1, 1, 1) } }, choice: { kind, scene } });
const scenes = [{ value: "crowd", label: "a crowd" }, { value: "heap", label: "one heap" }, { value: "giant", label: "one giant" }, { value: "teleport", label: "all teleport" }];
const all = (count * (count - 1)) / 2;

export const broadPhases: Lesson = {
  id: "broad-phases", number: 10, title: "Broad phases", question: "Which of a hundred bodies may touch at all?",
  intro: "A hundred bodies make 4,950 pairs, and hardly any of them touch. A broad phase knows only boxes along the axes, and finds the pairs that are worth a closer look. All of them find the same pairs.",
  dimension: 3, view: { center: [0, 0, 0], reach: 4 }, start: situation("crowd"),
  choices: [{ key: "kind", label: "Structure", options: kinds.map((value) => ({ value, label: labels[value] })) }, { key: "scene", label: "Scene", options: scenes }],
  handles: () => [], drag: (s) => s,
  asks: () => undefined,
  code(state) {
    const { kind, scene } = chosen(state);
    return {
      programs: broadPhasePrograms({
        kind, count, frames, spread: scene === "heap" ? 1 : 6, giant: scene === "giant" ? 2.6 : undefined,
        teleport: scene === "teleport" }),
      prints: () => run(kind, scene).frames.map((frame) => frame.pairs.length / 2),
    };
  },
  steps(state) {
    const { kind, scene } = chosen(state);
    const list = run(kind, scene).frames;
    const times = kinds.map((k) => ({ k, ...run(k, scene) }));
    return list.map((frame, i): Step => {
      const found = frame.pairs.length / 2, inVain = Math.max(0, frame.tests - found);
      const touched = new Set(frame.pairs);
      return {
        title: `${labels[kind]}, frame ${i + 1}`,
        text: `${how[kind]} ${found} of ${all.toLocaleString("en")} pairs overlap in this frame. Boxes were compared ${frame.tests.toLocaleString("en")} times, ${inVain.toLocaleString("en")} of them in vain, bounds of many boxes among them; every other pair was ruled out without a look. Times are means over all frames in this browser, with the calls from JavaScript.`,
        numbers: { caption: "This frame", columns: ["structure", "pairs", "tests", "in vain", "µs", "kB"], rows: times.map(({ k, frames: f, micros }) => ({ cells: [labels[k], f[i].pairs.length / 2, f[i].tests, Math.max(0, f[i].tests - f[i].pairs.length / 2), Math.round(micros), Math.round(f[i].memory / 1024)], mark: k === kind ? "now" as const : undefined })) },
        graph: { caption: "pairs and tests in each frame", at: i, series: [{ name: "pairs", meaning: "touch", values: list.map((f) => f.pairs.length / 2) }, { name: "tests", meaning: "axis", values: list.map((f) => f.tests) }] },
        says: `Frame ${i + 1}: ${digits(found)} pairs of ${all}, found by ${digits(frame.tests)} tests.`,
        draw(d) {
          frame.boxes.forEach(({ lower, upper }, id) => {
            const size = upper.map((x, k) => x - lower[k]);
            d.shape({ shape: box(...size), translation: upper.map((x, k) => (x + lower[k]) / 2) }, touched.has(id) ? "touch" : "out", { ghost: !touched.has(id) });
          });
          for (let p = 0; p < frame.pairs.length; p += 2) {
            const [a, b] = [frame.boxes[frame.pairs[p]], frame.boxes[frame.pairs[p + 1]]];
            d.line(a.upper.map((x, k) => (x + a.lower[k]) / 2), b.upper.map((x, k) => (x + b.lower[k]) / 2), "axis", {});
          }
        },
      };
    });
  },
  tryThis: [
    { label: "All in one heap", note: "Everything overlaps everything nearby: no structure can rule out what is there.", state: situation("heap") },
    { label: "Grid", note: "Cells of one size suit bodies of one size.", state: situation("crowd", "hashedGrid") },
  ],
  wrong: [
    { label: "One giant in a grid", note: "A body that covers hundreds of cells is in all of their lists.", state: situation("giant", "hashedGrid") },
    { label: "All teleport", note: "What lives on coherence, the kept order of sweep and prune, has to sort everything anew.", state: situation("teleport", "sweepAndPrune") },
  ],
  sources: ["D. Baraff: Dynamic Simulation of Non-penetrating Rigid Bodies, thesis, Cornell 1992 (sweep and prune)", "T. Ulrich: Loose octrees, Game Programming Gems (2000)", "J. Bentley: Multidimensional binary search trees, Communications of the ACM 18 (1975)", "E. Catto: Dynamic bounding volume hierarchies, Game Developers Conference 2019"],
};
