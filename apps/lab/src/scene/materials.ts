// The friction and the restitution of a body, as fields that change them.

import type { graze } from "../graze.ts";
import { h } from "../parts/dom.ts";
import type { SceneBody } from "./model.ts";

/** The fields of a body; `set` takes the whole material. */
export function materialFields(body: SceneBody, set: (material: graze.Material) => void): Node[] {
  const { staticFriction = 0.6, dynamicFriction = staticFriction, restitution = 0 } = body.material ?? {};
  const field = (label: string, value: number, most: number, made: (x: number) => graze.Material): HTMLElement =>
    h("label", {}, `${label} `, h("input", { type: "number", min: 0, max: most, step: 0.05, value,
      onchange: (event: Event) => set({ ...body.material as graze.Material, ...made(Number((event.target as HTMLInputElement).value)) }) }));
  return [field("Friction", dynamicFriction, 10, (x) => ({ staticFriction: x, dynamicFriction: x })), field("Restitution", restitution, 1, (x) => ({ restitution: x }))];
}
