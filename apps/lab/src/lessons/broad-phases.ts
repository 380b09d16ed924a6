import { graze } from "../graze.ts";
import { drawBounds } from "../parts/answers.ts";
import { digits } from "../parts/dom.ts";
import type { Drawing, Meaning } from "../parts/drawing.ts";
import { box, type State, type Vec } from "../question.ts";
import { dragTo, numberOf, type Lesson, type Step } from "./lesson.ts";
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
/** The parts that are drawn of each structure; sorted ends have none in space. */
const drawn: Record<Kind, string> = {
  dynamicTree: "The lines are the bounds of its nodes: up to eight boxes or nodes are in each, and they may overlap.",
  sortAndSweep: "It has no boxes of its own that could be drawn: a list of ends is all there is.",
  sweepAndPrune: "It has no boxes of its own that could be drawn: three lists of ends and the pairs found so far are all there is.",
  hashedGrid: "The lines are the cells that hold something. Empty ones take no memory, wherever they are.",
  looseOctree: "The lines are the cells that hold something, as they are halved; a box may stick out of its cell by half.",
  bsp: "The lines are the bounds of its nodes. What a plane cuts stays with the node that has the plane.",
};
const count = 100, frames = 12;

/** The bodies of a scene, the same on every machine: a linear congruential generator (Numerical Recipes). */
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
interface Bounds { lower: Vec; upper: Vec }
type Part = Bounds & { depth: number };
interface Frame { boxes: Bounds[]; pairs: Uint32Array; parts: Part[]; tests: number; memory: number }
interface Run { frames: Frame[]; /** Of a frame: browsers' clocks are too coarse for a single one. */ micros: number }
const kept = new Map<string, Run>();

/** The boxes of a frame: bodies that move there and back between walls, or are somewhere else altogether in each. */
function boxesAt(scene: string, at: number): Bounds[] {
  return bodies(scene).map(({ center, half, velocity }, i) => {
    const place = center.map((c, k) => {
      const x = scene === "teleport" ? ((Math.imul(i * 3 + k + 1, 2654435761 + at * 40503) >>> 0) / 2 ** 32 - 0.5) * 6 : c + velocity[k] * at;
      return ((x + 9) % 12 + 12) % 12 < 6 ? ((x + 9) % 6 + 6) % 6 - 3 : 3 - (((x + 9) % 6 + 6) % 6);
    });
    return { lower: place.map((x, k) => x - half[k]), upper: place.map((x, k) => x + half[k]) };
  });
}
function filled(kind: Kind, boxes: Bounds[]): graze.BroadPhase {
  const phase = new graze.BroadPhase(kind);
  boxes.forEach(({ lower, upper }, id) => phase.insert(id, lower, upper));
  return phase;
}

/** All frames of a scene with one structure. */
function run(kind: Kind, scene: string): Run {
  const key = `${kind} ${scene}`;
  const known = kept.get(key);
  if (known) return known;
  const phase = new graze.BroadPhase(kind), made: Frame[] = [];
  let spent = 0;
  for (let at = 0; at < frames; at++) {
    const boxes = boxesAt(scene, at), start = performance.now();
    boxes.forEach(({ lower, upper }, id) => (at === 0 ? phase.insert(id, lower, upper) : phase.move(id, lower, upper)));
    const pairs = phase.pairs();
    spent += performance.now() - start;
    const { tests, memory } = phase.counts();
    made.push({ boxes, pairs, parts: phase.parts(), tests, memory });
  }
  phase.dispose();
  const result = { frames: made, micros: (spent * 1000) / frames };
  kept.set(key, result);
  return result;
}

/** A structure over the boxes of the first frame, which is queried and never changed. */
interface Standing { phase: graze.BroadPhase; parts: Part[]; /** The parts as boxes that can be asked for themselves. */ around: graze.BroadPhase }
const standing = new Map<string, Standing>();
function stand(kind: Kind, scene: string): Standing {
  const key = `${kind} ${scene}`;
  let made = standing.get(key);
  if (!made) {
    const phase = filled(kind, boxesAt(scene, 0)), parts = phase.parts();
    made = { phase, parts, around: filled("dynamicTree", parts) };
    standing.set(key, made);
  }
  return made;
}
interface Update { box: Bounds; partners: Set<number>; tests: number; parts: Part[] }
const updates = new Map<string, Update[]>();
const shifts = [0.05, 1.5];
/** The first body moves a little, then far, and nothing else does: its pairs, and the comparisons made. */
function update(kind: Kind, scene: string): Update[] {
  const key = `${kind} ${scene}`, known = updates.get(key);
  if (known) return known;
  const [first, ...others] = boxesAt(scene, 0), phase = filled(kind, [first, ...others]);
  phase.pairs();
  const made = shifts.map((shift): Update => {
    const to = (v: Vec): Vec => [v[0] + (first.lower[0] > 0 ? -shift : shift), v[1], v[2]];
    const at = { lower: to(first.lower), upper: to(first.upper) };
    phase.move(0, at.lower, at.upper);
    const partners = new Set([...phase.movedPairs()].filter((id) => id !== 0));
    return { box: at, partners, tests: phase.counts().tests, parts: phase.parts() };
  });
  phase.dispose();
  updates.set(key, made);
  return made;
}

/** The structure, deeper parts paler; those with the numbers in `lit` strong. */
function drawParts(d: Drawing, parts: Part[], lit?: ReadonlySet<number>): void {
  parts.forEach((part, i) => {
    if (lit?.has(i)) drawBounds(d, part, "axis", { key: `depth-${part.depth}` });
    else drawBounds(d, part, part.depth % 2 === 0 ? "made" : "trigger", { ghost: lit !== undefined || parts.length > 12 && part.depth !== 1, key: `depth-${part.depth}` });
  });
}
function drawBodies(d: Drawing, boxes: Bounds[], meaning: (id: number) => Meaning): void {
  boxes.forEach(({ lower, upper }, id) => {
    const size = upper.map((x, k) => x - lower[k]), as = meaning(id);
    d.shape({ shape: box(...size), translation: upper.map((x, k) => (x + lower[k]) / 2) }, as, { ghost: as === "out" });
  });
}
const situation = (scene: string, kind: Kind = "dynamicTree", at: Vec = [-0.9, 1.2, -0.1]): State => ({
  q: { query: "overlap", a: { shape: box(1, 1, 1) }, b: { shape: box(1, 1, 1) } }, choice: { kind, scene, x: at[0], y: at[1], z: at[2] } });
/** The box of the query. */
const asking = (state: State): { at: Vec; lower: Vec; upper: Vec } => {
  const at = ["x", "y", "z"].map((k) => numberOf(state, k, 0));
  return { at, lower: at.map((x) => x - 0.75), upper: at.map((x) => x + 0.75) };
};
const chosen = (state: State): { kind: Kind; scene: string } => ({
  kind: kinds.find((k) => k === state.choice?.kind) ?? "dynamicTree",
  scene: scenes.find((s) => s.value === state.choice?.scene)?.value ?? "crowd",
});
const scenes = [{ value: "crowd", label: "a crowd" }, { value: "heap", label: "one heap" }, { value: "giant", label: "one giant" }, { value: "teleport", label: "all teleport" }];
const all = (count * (count - 1)) / 2;

export const broadPhases: Lesson = {
  id: "broad-phases", number: 10, title: "Broad phases", question: "Which of a hundred bodies may touch at all?",
  intro: "A hundred bodies make 4,950 pairs, and hardly any of them touch. A broad phase knows only boxes along the axes, and finds the pairs that are worth a closer look. All of them find the same pairs.",
  dimension: 3, view: { center: [0, 0, 0], reach: 5.3 }, start: situation("crowd"),
  choices: [{ key: "kind", label: "Structure", options: kinds.map((value) => ({ value, label: labels[value] })) }, { key: "scene", label: "Scene", options: scenes }],
  handles: (s) => [{ id: "ask", label: "Move the box that asks", kind: "move", meaning: "axis", named: true, at: asking(s).at }],
  drag: (s, _id, to) => ({ ...s, choice: { ...s.choice, x: dragTo(to[0]), y: dragTo(to[1]), z: dragTo(to[2]) } }),
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
    const { phase, parts, around } = stand(kind, scene), asker = asking(state), { boxes } = list[0];
    const levels = [...new Set(parts.map((p) => p.depth))].sort((m, n) => m - n);
    const hits = new Set(phase.query(asker.lower, asker.upper)), met = new Set(around.query(asker.lower, asker.upper));
    const moves = kinds.map((k) => ({ k, both: update(k, scene) })), moved = update(kind, scene);
    const steps: Step[] = [{
      title: `The structure: ${labels[kind]}`,
      text: `${how[kind]} ${drawn[kind]}` + (parts.length > 0 ? " Drag the box: the parts that it meets are dark." : ""),
      handles: parts.length > 0 ? ["ask"] : [],
      numbers: parts.length > 0
        ? { caption: "Parts of the structure (numbers)", columns: ["part", "how many"], rows: levels.map((depth) => ({ cells: [kind === "hashedGrid" ? "cells" : depth === 0 ? "the root" : `depth ${depth}`, parts.filter((p) => p.depth === depth).length], key: `depth-${depth}` })) }
        : { caption: "Parts of the structure (numbers)", columns: ["part", "how many"], rows: [{ cells: ["boxes around boxes", 0] }] },
      says: parts.length > 0 ? `${parts.length} parts on ${levels.length} levels.` : "Sorted lists have no parts in space.",
      draw(d) {
        drawParts(d, parts, parts.length > 0 ? met : undefined);
        drawBodies(d, boxes, () => "out");
        if (parts.length > 0) drawBounds(d, asker, "ink", { wide: true });
      },
    }, {
      title: "One box asks",
      text: `A box that is none of the bodies: which of them does it overlap? Drag it. ${hits.size} of ${count} do. ` + (parts.length > 0
        ? `Of ${parts.length} parts ${met.size} meet the box` + (kind === "looseOctree" ? "; looked into are also those whose bodies stick out as far." : "; in the others nothing is looked at.")
        : "Sorted ends answer no question about a place but by a walk along them: the answer is the same, the way is longer."),
      numbers: { caption: "The question (numbers)", columns: ["quantity", "value"], rows: [
        { cells: ["bodies", count] }, { cells: ["parts", parts.length] }, { cells: ["parts that meet the box", met.size], mark: "now" }, { cells: ["bodies that do", hits.size], mark: "winner" }] },
      handles: ["ask"],
      says: `${hits.size} bodies overlap the box that asks; ${met.size} of ${parts.length} parts do.`,
      draw(d) {
        drawParts(d, parts, met);
        drawBodies(d, boxes, (id) => (hits.has(id) ? "touch" : "out"));
        drawBounds(d, asker, "ink", { wide: true });
      },
    }, {
      title: "One box moves",
      text: `The first body moves by ${shifts[0]}, then by ${shifts[1]}, and all others stand still. Asked for the pairs of what moved, a structure looks at little, or at everything once more. Pairs after the long way: ${moved[1].partners.size}.`,
      numbers: { caption: "Boxes compared for one that moved (numbers)", columns: ["structure", "a little", "far", "pairs"], rows: moves.map(({ k, both }) => ({ cells: [labels[k], both[0].tests, both[1].tests, both[1].partners.size], mark: k === kind ? "now" as const : undefined })) },
      says: `One box moved; ${moved[1].partners.size} pairs of it, found by ${moved[1].tests} tests.`,
      draw(d) {
        drawParts(d, moved[1].parts);
        drawBodies(d, boxes.map((b, id) => (id === 0 ? moved[1].box : b)), (id) => (id === 0 ? "b" : moved[1].partners.has(id) ? "touch" : "out"));
        drawBounds(d, boxes[0], "b", { dashed: true });
        drawBounds(d, moved[1].box, "b", { wide: true });
      },
    }];
    return steps.concat(list.map((frame, i): Step => {
      const found = frame.pairs.length / 2, inVain = Math.max(0, frame.tests - found);
      const touched = new Set(frame.pairs);
      return {
        title: `${labels[kind]}, frame ${i + 1}`,
        text: `${how[kind]} ${found} of ${all.toLocaleString("en")} pairs overlap in this frame. Boxes were compared ${frame.tests.toLocaleString("en")} times, ${inVain.toLocaleString("en")} of them in vain, bounds of many boxes among them; every other pair was ruled out without a look. Times are means over all frames in this browser, with the calls from JavaScript.`,
        numbers: { caption: "This frame (numbers, time and memory)", columns: ["structure", "pairs", "tests", "in vain", "µs", "kB"], rows: times.map(({ k, frames: f, micros }) => ({ cells: [labels[k], f[i].pairs.length / 2, f[i].tests, Math.max(0, f[i].tests - f[i].pairs.length / 2), Math.round(micros), Math.round(f[i].memory / 1024)], mark: k === kind ? "now" as const : undefined })) },
        graph: { caption: "pairs and tests in each frame", at: i, series: [{ name: "pairs", meaning: "touch", values: list.map((f) => f.pairs.length / 2) }, { name: "tests", meaning: "axis", values: list.map((f) => f.tests) }] },
        says: `Frame ${i + 1}: ${digits(found)} pairs of ${all}, found by ${digits(frame.tests)} tests.`,
        draw(d) {
          drawParts(d, frame.parts);
          drawBodies(d, frame.boxes, (id) => (touched.has(id) ? "touch" : "out"));
          for (let p = 0; p < frame.pairs.length; p += 2) {
            const [a, b] = [frame.boxes[frame.pairs[p]], frame.boxes[frame.pairs[p + 1]]];
            d.line(a.upper.map((x, k) => (x + a.lower[k]) / 2), b.upper.map((x, k) => (x + b.lower[k]) / 2), "axis", {});
          }
        },
      };
    }));
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
