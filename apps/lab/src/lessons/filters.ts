import { graze, shapeOf } from "../graze.ts";
import { dragTo, numberOf, type Lesson, type Step } from "./lesson.ts";
import { filterPrograms } from "./programs.ts";
import { sphere, type State, type Vec } from "../question.ts";

const names = ["player", "enemy", "shot", "coin"];
const bits = ["P", "E", "S", "C"];
/** Category, mask and group of each body, as numbers in the state. */
type Bits = { category: number; mask: number; group: number };
const usual: Bits[] = [
  { category: 1, mask: 0b1010, group: 0 }, { category: 2, mask: 0b0111, group: 0 }, { category: 4, mask: 0b0010, group: 0 }, { category: 8, mask: 0b0001, group: 0 },
];
const places: Vec[] = [[-0.45, 0.4, 0], [0.45, 0.4, 0], [0.4, -0.4, 0], [-0.4, -0.4, 0]];

function situation(filters: Bits[] = usual, at: Vec[] = places): State {
  const choice: Record<string, number> = {};
  filters.forEach((f, i) => { choice[`c${i}`] = f.category; choice[`m${i}`] = f.mask; choice[`g${i}`] = f.group; });
  at.forEach((p, i) => { choice[`x${i}`] = p[0]; choice[`y${i}`] = p[1]; });
  return { q: { query: "overlap", a: { shape: sphere(0.7) }, b: { shape: sphere(0.7) } }, choice };
}
const bitsOf = (s: State, i: number): Bits => ({
  category: Number(s.choice?.[`c${i}`] ?? 1) >>> 0, mask: Number(s.choice?.[`m${i}`] ?? 15) >>> 0, group: Number(s.choice?.[`g${i}`] ?? 0) | 0 });
const placeOf = (s: State, i: number): Vec => [numberOf(s, `x${i}`, 0), numberOf(s, `y${i}`, 0), 0];
const binary = (x: number): string => x.toString(2).padStart(4, "0");

/** The pairs that a world of the library reports. */
function pairs(state: State): Set<string> {
  const world = new graze.World(), shape = shapeOf(sphere(0.7)), found = new Set<string>();
  names.forEach((_, i) => world.add({ shape, translation: placeOf(state, i), filter: bitsOf(state, i) }));
  world.update();
  for (const pair of world.contacts()) if (pair.overlap) found.add(`${pair.a} ${pair.b}`);
  world.dispose();
  shape.dispose();
  return found;
}

export const filters: Lesson = {
  id: "filters", number: 11, title: "Filters", question: "Which types may collide with which?",
  intro: "Switch the bits: each is a type, PESC from the right. Shots pass through shots, coins through enemies. Each body has a category, one bit or several, and a mask of the categories that it collides with. Two ANDs decide, before anything is computed.",
  dimension: 3, view: { center: [0, 0, 0], reach: 1.9, from: [0, 0.15, 1] }, start: situation(),
  bits: names.flatMap((name, i) => [{ key: `c${i}`, label: `${name}: category`, names }, { key: `m${i}`, label: `${name}: mask`, names }]),
  handles: (s) => names.map((name, i) => ({ id: `body-${i}`, label: `Move ${name}`, kind: "move", meaning: "ink", sign: bits[i], at: placeOf(s, i) })),
  drag(s, id, to) {
    const i = id.slice(-1);
    return { ...s, choice: { ...s.choice, [`x${i}`]: dragTo(to[0]), [`y${i}`]: dragTo(to[1]) } };
  },
  asks: () => undefined,
  code: (state) => ({
    programs: filterPrograms(0.7, names.map((name, i) => ({ name, ...bitsOf(state, i), at: placeOf(state, i) }))),
    prints() {
      const reported = pairs(state);
      return names.flatMap((_, i) => names.slice(i + 1).map((_, k) => reported.has(`${i} ${i + 1 + k}`)));
    },
  }),
  steps(state) {
    const reported = pairs(state), steps: Step[] = [];
    const open = pairs({ ...state, choice: { ...state.choice, ...Object.fromEntries(names.flatMap((_, i) => [[`m${i}`, 15], [`g${i}`, 0], [`c${i}`, 1 << i]])) } });
    const rows = names.map((name, i) => ({ cells: [name, binary(bitsOf(state, i).category), binary(bitsOf(state, i).mask), String(bitsOf(state, i).group)], key: `body-${i}` }));
    const draw = (now?: [number, number]): Step["draw"] => (d) => {
      for (const [i, name] of names.entries()) {
        const [x, y] = placeOf(state, i), meaning = !now?.includes(i) ? "out" : i === now[0] ? "a" : "b";
        d.shape({ shape: sphere(0.7), translation: [x, y, 0] }, meaning, { ghost: now && meaning === "out", key: `body-${i}` });
        d.text([x, y < 0 ? y - 0.45 : y + 0.45, 0], name, meaning); // the sign of the handle is in the middle
      }
      for (const pair of open) {
        const [i, j] = pair.split(" ").map(Number);
        if (now && !(now[0] === i && now[1] === j)) continue;
        d.line(placeOf(state, i), placeOf(state, j), reported.has(pair) ? "touch" : "out", { wide: true, dashed: !reported.has(pair) });
      }
    };
    steps.push({
      title: "Four types, four bits", text: `The bits are ${names.map((n, i) => `${binary(1 << i)} ${n}`).join(", ")}. ${open.size} pairs overlap here; the world reports ${reported.size} of them (solid lines). The rest is filtered (dashed).`,
      formula: ["(c_A & m_B) != 0 and (c_B & m_A) != 0"],
      numbers: { caption: "Filters (bits)", columns: ["body", "category", "mask", "group"], rows }, says: `${reported.size} of ${open.size} overlapping pairs are reported.`, draw: draw(),
    });
    for (let i = 0; i < 4; i++)
      for (let j = i + 1; j < 4; j++) {
        const a = bitsOf(state, i), b = bitsOf(state, j), key = `${i} ${j}`;
        const told = reported.has(key), touch = open.has(key);
        const group = a.group !== 0 && a.group === b.group;
        steps.push({
          title: `${names[i]} and ${names[j]}: ${!touch ? "do not overlap" : told ? "reported" : "filtered"}`,
          text: (group ? `Both are in group ${a.group}, and a group that both share decides alone: a positive one always collides, a negative one never. ` : "Does the category of each appear in the mask of the other? Both have to agree. ") +
            (!touch ? "They do not overlap where they stand." : told ? "They do, and the world reports the contact." : "One does not: no contact, no event, no time spent."),
          formula: [`${binary(a.category)} & ${binary(b.mask)} = ${binary(a.category & b.mask)}`, `${binary(b.category)} & ${binary(a.mask)} = ${binary(b.category & a.mask)}`],
          numbers: { caption: "Filters (bits)", columns: ["body", "category", "mask", "group"], rows: rows.map((r, k) => ({ ...r, mark: k === i || k === j ? "now" as const : undefined })) },
          says: `${names[i]} and ${names[j]} ${told ? "collide" : "do not collide"}.`, draw: draw([i, j]),
        });
      }
    return steps;
  },
  tryThis: [
    { label: "Everything with everything", note: "All masks 1111: the filters say nothing.", state: situation(usual.map((f) => ({ ...f, mask: 15 }))) },
    { label: "A ghost", note: "The player's mask is 0000: nothing collides with it.", state: situation(usual.map((f, i) => (i === 0 ? { ...f, mask: 0 } : f))) },
    { label: "A group of friends", note: "Player and enemy share group −1 and never collide.", state: situation(usual.map((f, i) => (i < 2 ? { ...f, group: -1 } : f))) },
  ],
  wrong: [{ label: "One-sided masks", note: "The shot wants the player, the player does not want shots. With one AND it would depend on who is asked first; with two, nobody collides.", state: situation(usual.map((f, i) => (i === 2 ? { ...f, mask: 0b0011 } : f))) }],
  sources: ["E. Catto: Box2D manual, section on filtering", "C. Ericson: Real-Time Collision Detection (2005), section 7.1"],
};
