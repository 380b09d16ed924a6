// The reasons for which two bodies that overlap are no pair that is pushed apart: filters, triggers, joints, and that
// neither moves.

import { graze } from "../graze.ts";
import { filterParts, filterTaken, type BodyFilter } from "./filters.ts";
import type { SceneBody, Tie } from "./model.ts";

type Filter = BodyFilter | undefined;
const known = new Map<string, boolean>();

/** Whether a world of the library takes two bodies with these filters for a pair. */
function allowed(a: Filter, b: Filter): boolean {
  const key = JSON.stringify([a, b]), before = known.get(key);
  if (before !== undefined) return before;
  const world = new graze.World(), ball = new graze.Sphere(1);
  try {
    for (const filter of [a, b]) world.add({ shape: ball, ...(filter ? { filter: filterTaken(filter) } : {}) });
    world.update();
    const met = world.contacts().length > 0;
    known.set(key, met);
    return met;
  } finally {
    world.dispose();
    ball.dispose();
  }
}
/** A filter in words: "category 0x1, mask 0x3". */
const filterWords = (filter: Filter): string =>
  filterParts(filter).filter(([, value]) => value !== "none").map((part) => part.join(" ")).join(", ");

/** A sentence about two bodies that do not push each other, whatever their distance; null about others. `played`:
 *  whether joints hold. */
export function unmet({ bodies, joints = [] }: { bodies: SceneBody[]; joints?: Tie[] }, i: number, j: number, played: boolean): string | null {
  const [a, b] = [bodies[i], bodies[j]];
  if (!allowed(a.filter, b.filter))
    return `The filter excludes this pair: no contact is reported, and nothing is pushed. A has ${filterWords(a.filter)}; B has ${filterWords(b.filter)}.`;
  if (!a.moves && !b.moves) return "Both stand: no contact of theirs is looked for.";
  const trigger = [a, b].find((body) => body.trigger);
  if (trigger) return `${trigger.name} is a trigger: that they touch is only reported, and nothing is pushed.`;
  const tied = joints.some((joint) => !joint.enableCollision && [joint.a, joint.b].includes(i) && [joint.a, joint.b].includes(j));
  return tied && played ? "A joint ties them, which takes them out of each other's way." : null;
}
