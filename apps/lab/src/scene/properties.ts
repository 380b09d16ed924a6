// What is known of one body, as rows beside the drawing.

import { vector } from "../parts/dom.ts";
import type { Numbers } from "../parts/table.ts";
import type { SceneBody } from "./model.ts";
import type { Pair, Run } from "./run.ts";

const bits = (filter: number): string => `0x${filter.toString(16)}`;
const kind = ({ moves, trigger, dynamics }: SceneBody): string =>
  trigger ? "trigger" : dynamics?.kinematic ? "kinematic" : moves ? "moves" : "fixed";

/** Shape, place, box, filter, and what moves it; `pairs` are all that touch. */
export function propertiesOf(run: Run, body: SceneBody, number: number, pairs: Pair[]): Numbers {
  const { translation, rotation } = run.place(number), motion = run.motion(number);
  const box = body.shape.type === "plane" ? null : run.bounds(number, true);
  const touching = pairs.filter((p) => p.a === number || p.b === number);
  const rows: [string, string | number][] = [
    ["shape", body.shape.margin ? `${body.shape.type}, rounded by ${body.shape.margin}` : body.shape.type],
    ["kind", kind(body)], ["place", vector(translation, 5)], ["turned", vector(rotation, 4)],
    ...(box ? [["box from", vector(box.lower, 5)], ["box to", vector(box.upper, 5)]] as [string, string][] : []),
    ...(body.captured ? [] : [["category", bits(body.filter?.category ?? 1)], ["mask", body.filter ? bits(body.filter.mask) : "all"]] as [string, string][]),
    ...(motion ? [["mass", motion.mass], ["velocity", vector(motion.linear, 4)]] as [string, string | number][] : []),
    ["pairs in contact", touching.length],
  ];
  return { caption: body.name, columns: ["", "value"], rows: rows.map((cells) => ({ cells })) };
}
