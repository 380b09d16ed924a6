// Filters of bodies: as the names of collision systems, which scene files have, as the bits that the library takes, and
// in words.

import type { graze } from "../graze.ts";

/** Bits as a number, or as hexadecimal digits behind 0x where a number of JavaScript would round them. */
export type Bits = number | string;
/** The bits of a body; what is left out is the library's default. */
export interface BodyFilter {
  category?: Bits;
  mask?: Bits;
  group?: number;
}
/** A filter in the library's answers. */
export interface AnsweredFilter {
  category: bigint;
  mask: bigint;
  group: number;
}
const all = 0xffff_ffff_ffff_ffffn;
const bitsOf = (value: bigint): Bits => (value <= Number.MAX_SAFE_INTEGER ? Number(value) : hexadecimal(value));
/** A filter that the library answered, which in JSON keeps its bits; nothing for the default. */
export function filterWritten({ category, mask, group }: AnsweredFilter): BodyFilter | undefined {
  if (category === 1n && mask === all && group === 0) return undefined;
  return { category: bitsOf(category), ...(mask === all ? {} : { mask: bitsOf(mask) }), ...(group ? { group } : {}) };
}
/** A filter as the library takes it. */
export function filterTaken({ category, mask, ...rest }: BodyFilter): graze.Filter {
  const taken = (bits: Bits): number | bigint => (typeof bits === "string" ? BigInt(bits) : bits);
  return { ...rest, ...(category === undefined ? {} : { category: taken(category) }), ...(mask === undefined ? {} : { mask: taken(mask) }) };
}

export interface NamedFilter {
  systems?: string[];
  collideWith?: string[];
  notCollideWith?: string[];
}
/** The bits of a number of JavaScript: the first is that of bodies that belong to no system. */
const mostSystems = 30;

/** A function from a file's filters to those of bodies; `filters` are all of the file. */
export function filtersOf(filters: NamedFilter[]): (filter: NamedFilter) => BodyFilter | undefined {
  const names = [...new Set(filters.flatMap((f) => [...(f.systems ?? []), ...(f.collideWith ?? []), ...(f.notCollideWith ?? [])]))].slice(0, mostSystems);
  const whole = 2 ** (names.length + 1) - 1;
  const bits = (list: string[]): number => list.reduce((sum, s) => (names.includes(s) ? sum + 2 ** (names.indexOf(s) + 1) : sum), 0);
  return ({ systems, collideWith, notCollideWith }) => {
    if (!systems && !collideWith && !notCollideWith) return undefined;
    return { category: bits(systems ?? []) || 1, mask: collideWith ? bits(collideWith) : whole - bits(notCollideWith ?? []) };
  };
}

const hexadecimal = (value: number | bigint): string => `0x${value.toString(16)}`;
const shown = (bits: Bits): string => (typeof bits === "string" ? bits : hexadecimal(bits));
/** The parts of a filter in words. A body without one is of the first category, and meets all. */
export const filterParts = (filter?: BodyFilter): [name: string, value: string][] => [
  ["category", shown(filter?.category ?? 1)], ["mask", filter?.mask === undefined ? "all" : shown(filter.mask)], ["group", filter?.group ? String(filter.group) : "none"]];
