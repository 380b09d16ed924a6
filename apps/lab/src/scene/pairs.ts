// The pairs that touch: the bodies that are marked, and a table whose rows select their two bodies.

import type { Meaning } from "../parts/drawing.ts";
import type { Numbers } from "../parts/table.ts";
import type { Partner } from "./properties.ts";
import type { Pair } from "./run.ts";

const mostListed = 30;
/** The depth from which on an overlap is seen, as a part of half of the height that is seen. */
const visible = 1 / 4000;

export const pointsOf = (pair: Pair): number => pair.manifolds.reduce((n, m) => n + m.points.length, 0);
export const deepest = (pair: Pair): number => Math.min(...pair.manifolds.flatMap((m) => m.points.map((x) => x.distance)));
/** The bodies that reach visibly into others, as far as they move. */
export const overlapping = (pairs: Pair[], moves: (body: number) => boolean, seen: number): Set<number> =>
  new Set(pairs.filter((pair) => deepest(pair) < -visible * seen).flatMap(({ a, b }) => [a, b]).filter(moves));
/** The colours of the bodies that sleep and of the selected ones, which all others keep theirs beside. */
export const colored = (selected: number[], asleep: ReadonlySet<number> = new Set()): Map<number, Meaning> =>
  new Map([...[...asleep].map((body): [number, Meaning] => [body, "asleep"]), ...selected.map((body, i): [number, Meaning] => [body, i ? "b" : "made"])]);
/** The key by which a pair in the drawing lights up with its row. */
export const keyOf = (pair: { a: number; b: number }): string => `${pair.a} ${pair.b}`;
/** The bodies of such a key; none for another one. */
export const bodiesOf = (key: string | null): number[] => (key && /^\d+ \d+$/.test(key) ? key.split(" ").map(Number) : []);
/** The counts in words: "16 bodies · 12 pairs · 48 contacts". */
export const counted = (bodies: number, { pairs, points }: Counts): string => `${bodies} bodies · ${pairs} pairs · ${points} contacts`;
export interface Counts {
  pairs: number;
  points: number;
}
export const countsOf = (pairs: Pair[]): Counts => ({ pairs: pairs.length, points: pairs.reduce((sum, p) => sum + pointsOf(p), 0) });

/** The pairs of a body, with the name of the other. */
export const partnersOf = (body: number, pairs: Pair[], name: (body: number) => string): Partner[] =>
  pairs.filter((p) => p.a === body || p.b === body).map((pair) => ({ pair, name: name(pair.a === body ? pair.b : pair.a) }));

export function pairRows(pairs: Pair[], caption: string, name: (body: number) => string, selected: number[], select: (bodies: number[]) => void): Numbers {
  return {
    caption: pairs.length > mostListed ? `The first ${mostListed} of ${pairs.length} pairs` : caption, columns: ["pair", "points", "deepest"],
    rows: pairs.slice(0, mostListed).map((p) => ({
      cells: [`${name(p.a)} × ${name(p.b)}`, pointsOf(p), pointsOf(p) > 0 ? deepest(p) : "inside"], key: keyOf(p), choose: () => select([p.a, p.b]),
      mark: selected.includes(p.a) && selected.includes(p.b) ? "winner" as const : undefined })),
  };
}
