// Collision systems by their names, as scene files have them, and as the bits of filters.

import type { SceneBody } from "./model.ts";

export interface NamedFilter {
  systems?: string[];
  collideWith?: string[];
  notCollideWith?: string[];
}
/** The bits of a number of JavaScript: the first is that of bodies that belong to no system. */
const mostSystems = 30;

/** A function from a file's filters to those of bodies. `all` is every filter of the file. */
export function filtersOf(all: NamedFilter[]): (filter: NamedFilter) => SceneBody["filter"] {
  const names = [...new Set(all.flatMap((f) => [...(f.systems ?? []), ...(f.collideWith ?? []), ...(f.notCollideWith ?? [])]))].slice(0, mostSystems);
  const whole = 2 ** (names.length + 1) - 1;
  const bits = (list: string[]): number => list.reduce((sum, s) => (names.includes(s) ? sum + 2 ** (names.indexOf(s) + 1) : sum), 0);
  return ({ systems, collideWith, notCollideWith }) => {
    if (!systems && !collideWith && !notCollideWith) return undefined;
    return { category: bits(systems ?? []) || 1, mask: collideWith ? bits(collideWith) : whole - bits(notCollideWith ?? []) };
  };
}

const hexadecimal = (value: number): string => `0x${value.toString(16)}`;
/** The parts of a filter in words. A body without one is of the first category, and meets all. */
export const filterParts = (filter: SceneBody["filter"]): [name: string, value: string][] => [
  ["category", hexadecimal(filter?.category ?? 1)], ["mask", filter ? hexadecimal(filter.mask) : "all"], ["group", filter?.group ? String(filter.group) : "none"]];
