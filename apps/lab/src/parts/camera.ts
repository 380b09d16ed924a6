// Cameras of which numbers can tell the picture. An address may hold any other, and whoever comes ever nearer gets
// there.

import type { Vec } from "../question.ts";

/** The part of half a picture that has to be more than the rounding of its place: less than a pixel. */
const finest = 1e-4;
/** How many times as large as a picture something may be that is drawn, before numbers overflow. */
const largest = 1e6;

/** Whether the places of a picture about `center`, as far as `reach` to all sides, differ as numbers and are finite. */
export const isSeen = (center: Vec, reach: number): boolean =>
  reach > 0 && Number.isFinite(reach * largest) && Number.isFinite(largest / reach)
  && center.every((x) => Math.abs(x) * Number.EPSILON <= reach * finest);
