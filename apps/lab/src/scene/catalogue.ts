// The list of scenes: those of the lab, and the conformance scenes, which are fetched when the list is there.

import { h } from "../parts/dom.ts";
import type { Scene } from "./model.ts";
import { scenes } from "./scenes.ts";

const conformance = (): Promise<typeof import("./conformance.ts")> => import("./conformance.ts");

export class Catalogue {
  readonly element: HTMLSelectElement;
  private shown = "";
  private wanted = "";
  private readonly onScene: (scene: Scene, key: string) => void;

  /** `onChoose`: called when another scene was chosen, which comes later. */
  constructor(onScene: (scene: Scene, key: string) => void, onChoose: () => void) {
    this.onScene = onScene;
    this.element = h("select", { "aria-label": "Scene", onchange: () => {
      onChoose();
      this.open(this.element.value);
    } }, ...Object.entries(scenes).map(([key, { name }]) => h("option", { value: key }, name))) as HTMLSelectElement;
    void this.fill();
  }
  /** Opens the scene of a key, or the first one if there is no such key. */
  open(key: string): void {
    this.wanted = key;
    if (scenes[key]) this.onScene(scenes[key].make(), key);
    else void this.fetch(key);
  }
  /** Shows in the list the scene of a key, or another one by its name. */
  show(key: string | null, name: string): void {
    this.shown = this.wanted = key ?? "";
    this.element.querySelector("[data-file]")?.remove();
    if (!key) this.element.append(h("option", { value: "", "data-file": true }, name));
    this.element.value = this.shown;
  }
  private async fill(): Promise<void> {
    const { conformanceScenes } = await conformance();
    this.element.append(h("optgroup", { label: "Conformance scenes" }, ...conformanceScenes.map(({ key, name }) => h("option", { value: key }, name))));
    this.element.value = this.shown;
  }
  private async fetch(key: string): Promise<void> {
    const scene = await (await conformance()).conformanceScene(key);
    if (this.wanted !== key) return; // another one was chosen meanwhile
    if (scene) this.onScene(scene, key);
    else this.open("shapes");
  }
}
