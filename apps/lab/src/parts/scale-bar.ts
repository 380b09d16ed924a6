// The scale bar of a picture: a round length, as long as it is seen there.

import { svg } from "./dom.ts";

/** A round number that fits about five times into `span`. */
export function roundStep(span: number): number {
  const rough = span / 5, power = 10 ** Math.floor(Math.log10(rough));
  const lead = rough / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

/** A bar for the length `step`, which is `pixels` long, with its left end at (12, y). */
export const scaleBar = (step: number, pixels: number, y: number): SVGElement[] => [
  svg("path", { class: "bar", d: `M12 ${y - 5}v5h${pixels}v-5` }),
  svg("text", { x: 16, y: y - 4 }, String(Number(step.toPrecision(3))))];
