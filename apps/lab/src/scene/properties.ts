// The properties of one body, as rows beside the drawing.

import { digits, vector } from "../parts/dom.ts";
import type { Numbers } from "../parts/table.ts";
import { add, scale } from "../parts/vec.ts";
import { filterParts } from "./filters.ts";
import type { SceneBody } from "./model.ts";
import { keyOf } from "./pairs.ts";
import type { Pair, Run } from "./run.ts";

const kind = ({ moves, trigger, dynamics }: SceneBody): string =>
  trigger ? "trigger" : dynamics?.kinematic ? "kinematic" : moves ? "moves" : "fixed";

/** The pairs of a body with the names of the others, each of which is a row that lights up with its points. */
export interface Partner {
  name: string;
  pair: Pair;
}
/** The rows of a partner: one for itself, and one for each point. */
function touching({ name, pair }: Partner): Numbers["rows"] {
  const key = keyOf(pair), points = pair.manifolds.flatMap((m) => m.points);
  return [{ cells: ["touches", points.length > 0 ? name : `${name}, without a point`], key },
    ...points.map(({ a, b, distance }, k) => ({ cells: [`point ${k + 1}`, `${vector(scale(add(a, b), 0.5), 4)}, ${distance > 0 ? "apart" : "deep"} ${digits(Math.abs(distance), 3)}`], key }))];
}
/** The rows: shape, place, box, margin, filter, motion, and the bodies that it touches with their points. `when` says
 *  at which poses those were found, `asleep` which bodies sleep. */
export function propertiesOf(run: Run, body: SceneBody, number: number, partners: Partner[], when: string, asleep: ReadonlySet<number> | null): Numbers {
  const { translation, rotation } = run.place(number), motion = run.motion(number);
  const box = body.shape.type === "plane" ? null : run.bounds(number, true);
  const rows: [string, string | number][] = [
    ["shape", body.shape.margin ? `${body.shape.type}, rounded by ${body.shape.margin}` : body.shape.type],
    ["kind", kind(body)], ["place", vector(translation, 5)], ["turned", vector(rotation, 4)],
    ...(box ? [["box from", vector(box.lower, 5)], ["box to", vector(box.upper, 5)]] as [string, string][] : []),
    ...filterParts(body.filter), ...(asleep ? [["sleeps", asleep.has(number) ? "yes" : "no"]] as [string, string][] : []),
    ...(motion ? [["mass", motion.mass], ["velocity", vector(motion.linear, 4)]] as [string, string | number][] : []),
    ["contact margin", run.margin(number, number)], ["contacts found", when], ...(partners.length === 0 ? [["touches", "nothing"]] as [string, string][] : []),
  ];
  return { caption: body.name, columns: ["quantity", "value"], rows: [...rows.map((cells) => ({ cells })), ...partners.flatMap(touching)] };
}
