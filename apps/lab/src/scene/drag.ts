// A body that is dragged by one of its handles.

import { quatBetween, quatMultiply, rotate, sub, unit } from "../parts/vec.ts";
import type { Vec } from "../question.ts";
import type { Play } from "./play.ts";
import type { Place } from "./run.ts";

/** Moves or turns a body; while the scene is played a spring pulls one that moves, until the drag is `done`. Returns
 *  whether the body was put somewhere. */
export function dragBody(play: Play, number: number, id: string, to: Vec, done: boolean): boolean {
  const { run, scene } = play, body = scene.bodies[number], aimed = run.flat ? [to[0], to[1], 0] : to;
  if (play.running && body.moves) {
    play.pull = done ? null : { body: number, to: aimed };
    return false;
  }
  const place = run.place(number);
  const turn = (): Vec => unit(quatMultiply(quatBetween(rotate(place.rotation, [1, 0, 0]), sub(aimed, place.translation)), place.rotation));
  const next: Place = id === "move" ? { ...place, translation: aimed } : { ...place, rotation: turn() };
  if (!run.played) Object.assign(body, next);
  run.put(number, next);
  return true;
}
