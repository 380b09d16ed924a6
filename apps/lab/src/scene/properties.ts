// The properties of one body, as rows beside the drawing.

import { vector } from "../parts/dom.ts";
import type { Numbers } from "../parts/table.ts";
import type { SceneBody } from "./model.ts";
import type { Run } from "./run.ts";

const bits = (filter: number): string => `0x${filter.toString(16)}`;
const kind = ({ moves, trigger, dynamics }: SceneBody): string =>
  trigger ? "trigger" : dynamics?.kinematic ? "kinematic" : moves ? "moves" : "fixed";

/** The number of partners above which the rest is counted. */
const mostNamed = 4;
/** Names in words: "floor, box 1 and 3 more". */
function listed(partners: string[]): string {
  const rest = partners.length - mostNamed;
  return partners.length === 0 ? "nothing" : partners.slice(0, mostNamed).join(", ") + (rest > 0 ? ` and ${rest} more` : "");
}
/** The rows: shape, place, box, margin, filter, motion, and the bodies that it touches. */
export function propertiesOf(run: Run, body: SceneBody, number: number, partners: string[]): Numbers {
  const { translation, rotation } = run.place(number), motion = run.motion(number);
  const box = body.shape.type === "plane" ? null : run.bounds(number, true);
  const rows: [string, string | number][] = [
    ["shape", body.shape.margin ? `${body.shape.type}, rounded by ${body.shape.margin}` : body.shape.type],
    ["kind", kind(body)], ["place", vector(translation, 5)], ["turned", vector(rotation, 4)],
    ...(box ? [["box from", vector(box.lower, 5)], ["box to", vector(box.upper, 5)]] as [string, string][] : []),
    ...(body.captured ? [] : [["category", bits(body.filter?.category ?? 1)], ["mask", body.filter ? bits(body.filter.mask) : "all"]] as [string, string][]),
    ...(motion ? [["mass", motion.mass], ["velocity", vector(motion.linear, 4)]] as [string, string | number][] : []),
    ["contact margin", run.margin(number, number)], ["touches", listed(partners)],
  ];
  return { caption: body.name, columns: ["quantity", "value"], rows: rows.map((cells) => ({ cells })) };
}
