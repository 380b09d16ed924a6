// The friction and the restitution of a body, as fields that change them.

import type { graze } from "../graze.ts";
import { h } from "../parts/dom.ts";
import type { Run } from "./run.ts";
import type { SceneBody } from "./model.ts";

/** The fields. `onSet` gets the message of a refused value, or null. */
export function materialFields(run: Run, number: number, body: SceneBody, onSet: (refused: string | null) => void): Node[] {
  const { staticFriction = 0.6, dynamicFriction = staticFriction, restitution = 0 } = body.material ?? {};
  const field = (label: string, value: number, most: number, made: (x: number) => graze.Material): HTMLElement =>
    h("label", {}, `${label} `, h("input", { type: "number", min: 0, max: most, step: 0.05, value,
      onchange: (event: Event) => {
        try {
          run.setMaterial(number, { ...body.material, ...made(Number((event.target as HTMLInputElement).value)) });
          onSet(null);
        } catch (error) {
          onSet((error as Error).message);
        }
      } }));
  return [field("Friction", dynamicFriction, 10, (x) => ({ staticFriction: x, dynamicFriction: x })), field("Restitution", restitution, 1, (x) => ({ restitution: x }))];
}
