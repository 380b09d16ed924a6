// The subjects of KHR_physics_rigid_bodies' conformance scenes, as the library's tests make and judge them.

import type { Gltf } from "./gltf-data.ts";
import type { Scene } from "./model.ts";
import { readGltf } from "./open-gltf.ts";

const texts = import.meta.glob<string>("../../../../examples/scenes/conformance/*.gltf", { eager: true, query: "?raw", import: "default" });
const byKey = new Map(Object.entries(texts).map(([path, text]) => [path.split("/").pop()!.replace(".gltf", ""), text]));

const title = (key: string): string => key.charAt(0).toUpperCase() + key.slice(1).replaceAll("-", " ");

/** The scenes by the keys in an address, with their names in the list. */
export const conformanceScenes: { key: string; name: string }[] = [...byKey.keys()].sort().map((key) => ({ key, name: title(key) }));

/** The scene of a key, or null. */
export async function conformanceScene(key: string): Promise<Scene | null> {
  const text = byKey.get(key);
  if (text === undefined) return null;
  const gltf = JSON.parse(text) as Gltf & { asset: { extras?: { says?: string } } };
  return { ...(await readGltf(gltf, null, title(key), [])), note: `${title(key)}: ${gltf.asset.extras?.says ?? ""}.` };
}
