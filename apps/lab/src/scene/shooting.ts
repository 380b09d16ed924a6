// Rays and casts by clicks: the purpose of the next click, and the result of the last.

import { button, digits, vector } from "../parts/dom.ts";
import { add, length, scale, sub } from "../parts/vec.ts";
import type { Vec } from "../question.ts";
import type { Scene } from "./model.ts";
import type { Run } from "./run.ts";
import { castBody, measure, shootRay, type Shot } from "./shots.ts";

export type Kind = Shot["kind"];
/** A line of sight through the pointer. */
export interface Sight {
  origin: Vec;
  direction: Vec;
}

export const shootingButtons = (take: (kind: Kind) => void): HTMLElement[] =>
  [button("Shoot a ray", () => take("ray")), button("Cast the body", () => take("cast")), button("Measure", () => take("measure"))];

export class Shooting {
  shot: Shot | null = null;
  /** The shot to come. A measure has a click for its first place, and in the plane a ray one for its origin. */
  private aim: { kind: Kind; from?: Vec } | null = null;
  private readonly tell: (title: string, words: string) => void;

  constructor(tell: (title: string, words: string) => void) {
    this.tell = tell;
  }
  get waits(): boolean {
    return this.aim !== null;
  }
  forget(): void {
    this.aim = this.shot = null;
  }
  takeAim(kind: Kind, run: Run, body: number | undefined): void {
    const blind = kind === "cast" && body === undefined;
    this.aim = blind ? null : { kind };
    if (kind === "measure") return this.tell("Measure", "Click two places, each on a body.");
    this.tell(kind === "ray" ? "Shoot a ray" : "Cast a body",
      blind ? "Select the body first." : kind === "ray" && run.flat ? "Click where it begins, then where it shall go." : "Click where it shall go.");
  }
  /** Takes the click that a ray or a cast of `body` waits for: a place in the plane, a line of sight in space. Returns
   *  whether a shot came of it. */
  click(sight: Sight, run: Run, scene: Scene, body: number | undefined): boolean {
    const { aim } = this;
    if (!aim) return false;
    if (aim.kind === "cast" && body === undefined) {
      this.takeAim("cast", run, body);
      return false;
    }
    const place = run.flat ? add(sight.origin, scale(sight.direction, -sight.origin[2] / sight.direction[2])) : null;
    if (aim.kind === "measure") return this.measured(aim.from, place ?? run.raycast(sight)?.point, run, scene);
    if (aim.kind === "ray" && place && !aim.from) {
      this.aim = { ...aim, from: place };
      return false;
    }
    this.aim = null;
    const target = place ?? run.raycast(sight)?.point ?? add(sight.origin, scale(sight.direction, length(sight.origin)));
    // In space a ray comes from beneath the eye: from the eye itself it would be seen as a point.
    const from = aim.from ?? add(sight.origin, [0, -length(sub(target, sight.origin)) / 4, 0]);
    this.shot = aim.kind === "ray" ? shootRay(run, { origin: from, direction: sub(target, from) }) : castBody(run, body!, target);
    this.tellShot(this.shot, scene);
    return true;
  }
  /** Takes a place of a measure, the second of which ends it. Beside all bodies there is none in space. */
  private measured(from: Vec | undefined, place: Vec | undefined, run: Run, scene: Scene): boolean {
    if (!place) {
      this.tell("Measure", "There is nothing: click on a body.");
      return false;
    }
    if (!from) {
      this.aim = { kind: "measure", from: place };
      this.tell("Measure", `From ${vector(place, 4)}: click the second place.`);
      return false;
    }
    this.aim = null;
    this.shot = measure(run, from, place);
    this.tellShot(this.shot, scene);
    return true;
  }
  private tellShot(shot: Shot, scene: Scene): void {
    if (shot.distance !== undefined)
      return this.tell(`${digits(shot.distance, 6)} apart`, `From ${vector(shot.from, 4)} to ${vector(shot.to, 4)}.`);
    this.tellHit(shot, scene);
  }
  private tellHit({ kind, hit, body }: Shot, scene: Scene): void {
    const met = hit ? scene.bodies[hit.body].name : "nothing";
    this.tell(kind === "ray" ? `The ray hits ${met}` : `${scene.bodies[body!].name} meets ${met} on its way`,
      hit ? `${kind === "ray" ? "after" : "at"} ${digits(hit.t, 6)}, at ${vector(hit.point, 4)}, normal ${vector(hit.normal, 3)}` : "");
  }
}
