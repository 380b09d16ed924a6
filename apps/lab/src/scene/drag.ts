// A body that is dragged by one of its handles: freely, along an axis, or round its centre.

import { add, dot, quatBetween, quatMultiply, rotate, scale, sub, unit } from "../parts/vec.ts";
import type { Handle } from "../parts/drawing.ts";
import type { Vec } from "../question.ts";
import type { Play } from "./play.ts";
import type { Place } from "./run.ts";

/** The directions in which the handles of a body move it, by their names. */
export const axes: Record<string, Vec> = { X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1] };

/** Moves or turns a body by a handle that was dragged to a place; while the scene is played a spring pulls one that
 *  moves, until the drag is `done`. Returns whether the body was put somewhere. */
export function dragBody(play: Play, number: number, { id, at }: Handle, to: Vec, done: boolean): boolean {
  const { run, scene } = play, body = scene.bodies[number], place = run.place(number);
  const by = sub(run.flat ? [to[0], to[1], 0] : to, at), along = axes[id];
  const aimed = add(play.pull?.to ?? place.translation, along ? scale(along, dot(by, along)) : by);
  if ((play.running || play.pull) && body.moves) {
    play.act({ kind: "pull", pull: done ? null : { body: number, to: aimed } });
    return false;
  }
  const turn = (): Vec => unit(quatMultiply(quatBetween(rotate(place.rotation, [1, 0, 0]), sub(add(at, by), place.translation)), place.rotation));
  const next: Place = id === "turn" ? { ...place, rotation: turn() } : { ...place, translation: aimed };
  if (run.played) play.act({ kind: "put", body: number, place: next });
  else {
    Object.assign(body, next);
    run.put(number, next);
  }
  return true;
}
