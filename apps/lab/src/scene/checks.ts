// Checks of values that an address holds: it can hold anything.

import type { Vec } from "../question.ts";
import type { Place } from "./run.ts";

/** Whether a value is a list of so many finite numbers. */
export const isNumbers = (value: unknown, count: number): value is Vec =>
  Array.isArray(value) && value.length === count && value.every((x) => typeof x === "number" && Number.isFinite(x));
/** Whether a value is a vector of space. */
export const isVector = (value: unknown): value is Vec => isNumbers(value, 3);
export const isPlace = (value: unknown): value is Place =>
  isVector((value as Place | null)?.translation) && isNumbers((value as Place).rotation, 4);
