// Rays, casts and measures by clicks: the purpose of the next click, and what was aimed at last.

import { button, vector } from "../parts/dom.ts";
import { add, length, scale, sub, three } from "../parts/vec.ts";
import type { Vec } from "../question.ts";
import type { Scene } from "./model.ts";
import type { Run } from "./run.ts";
import { shotOf, type Aim, type Shot } from "./shots.ts";

export type Kind = Exclude<Aim["kind"], "question">;
/** A line of sight through the pointer. */
export interface Sight {
  origin: Vec;
  direction: Vec;
}

export const shootingButtons = (take: (kind: Kind) => void): HTMLElement[] =>
  [button("Shoot a ray", () => take("ray")), button("Cast the body", () => take("cast")), button("Measure", () => take("measure"))];

export class Shooting {
  /** What was aimed at last. */
  aim: Aim | null = null;
  /** The shot to come. A measure has a click for its first place, and in the plane a ray one for its origin. */
  private next: { kind: Kind; from?: Vec } | null = null;
  private readonly tell: (title: string, words: string) => void;

  constructor(tell: (title: string, words: string) => void) {
    this.tell = tell;
  }
  get waits(): boolean {
    return this.next !== null;
  }
  forget(): void {
    this.next = this.aim = null;
  }
  /** The answer to the last aim as the scene is now. */
  shot(run: Run, scene: Scene): Shot | null {
    return this.aim && shotOf(this.aim, run, scene);
  }
  takeAim(kind: Kind, run: Run, body: number | undefined): void {
    const blind = kind === "cast" && body === undefined;
    this.next = blind ? null : { kind };
    if (kind === "measure") return this.tell("Measure", "Click two places, each on a body.");
    this.tell(kind === "ray" ? "Shoot a ray" : "Cast a body",
      blind ? "Select the body first." : kind === "ray" && run.flat ? "Click where it begins, then where it shall go." : "Click where it shall go.");
  }
  /** Takes the click that a ray or a cast of `body` waits for: a place in the plane, a line of sight in space. Returns
   *  whether an aim came of it. Throws where the library refuses it, and nothing is aimed at then. */
  click(sight: Sight, run: Run, scene: Scene, body: number | undefined): boolean {
    const aimed = this.aimed(sight, run, body);
    if (!aimed) return false;
    this.next = this.aim = null;
    shotOf(aimed, run, scene);
    this.aim = aimed;
    return true;
  }
  private aimed(sight: Sight, run: Run, body: number | undefined): Aim | null {
    const { next } = this;
    if (!next) return null;
    if (next.kind === "cast" && body === undefined) {
      this.takeAim("cast", run, body);
      return null;
    }
    const place = run.flat ? add(sight.origin, scale(sight.direction, -sight.origin[2] / sight.direction[2])) : null;
    if (next.kind === "measure") return this.measured(next.from, place ?? run.raycast(sight)?.point);
    if (next.kind === "ray" && place && !next.from) {
      this.next = { ...next, from: place };
      return null;
    }
    const target = place ?? run.raycast(sight)?.point ?? add(sight.origin, scale(sight.direction, length(sight.origin)));
    // A body goes to twice the distance of the place.
    if (next.kind === "cast") return { kind: "cast", body: body!, motion: scale(sub(target, run.place(body!).translation), 2) };
    // In space a ray comes from beneath the eye: from the eye itself it would be seen as a point.
    const origin = next.from ?? add(sight.origin, [0, -length(sub(target, sight.origin)) / 4, 0]);
    return { kind: "ray", origin, direction: sub(target, origin) };
  }
  /** Takes a place of a measure, the second of which ends it. Beside all bodies there is none in space. */
  private measured(from: Vec | undefined, place: Vec | undefined): Aim | null {
    if (!place) {
      this.tell("Measure", "There is nothing: click on a body.");
      return null;
    }
    if (from) return { kind: "measure", from: three(from), to: three(place) };
    this.next = { kind: "measure", from: place };
    this.tell("Measure", `From ${vector(place, 4)}: click the second place.`);
    return null;
  }
}
