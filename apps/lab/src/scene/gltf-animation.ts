// The animations of a glTF file, for the bodies that their nodes carry.

import type { Animation, Channel, Link } from "./animation.ts";
import { numbersOf, type Gltf } from "./gltf-data.ts";
import type { Keys } from "./keyframes.ts";
import { Unreadable } from "./meshes.ts";

const properties = ["translation", "rotation", "scale"] as const;

class AnimationReader {
  private readonly gltf: Gltf;
  private readonly data: ArrayBuffer[];
  /** The nodes from the root to each body. */
  private readonly chains: number[][];

  constructor(gltf: Gltf, data: ArrayBuffer[], chains: number[][]) {
    this.gltf = gltf;
    this.data = data;
    this.chains = chains;
  }
  read(number: number): Animation {
    const { name = `animation ${number}` } = this.gltf.animations![number], channels = this.channels(number);
    const ends = [...channels.values()].flatMap((list) => list.map(({ keys }) => keys.times.at(-1)!));
    const moves = this.chains.flatMap((nodes, body) => (nodes.some((node) => channels.has(node)) ? [{ body, chain: nodes.map((node) => this.link(node, channels.get(node))) }] : []));
    return { name, duration: Math.max(0, ...ends), moves };
  }

  /** The channels by their nodes; those of other properties are left out. */
  private channels(number: number): Map<number, Channel[]> {
    const { channels, samplers } = this.gltf.animations![number], found = new Map<number, Channel[]>();
    for (const [i, { sampler, target: { node, path } }] of channels.entries()) {
      const property = properties.find((one) => one === path), where = `animations[${number}].channels[${i}]`, known = found.get(node!) ?? [];
      if (node === undefined || !property) continue; // for an extension, or weights
      if (!this.gltf.nodes?.[node] || !samplers[sampler]) throw new Unreadable(`${where}: there is no such node or sampler`);
      if (this.gltf.nodes[node].matrix) throw new Unreadable(`${where}: expected a node without a matrix, which no channel can move`);
      if (known.some((one) => one.property === property)) throw new Unreadable(`${where}: expected a property of its node that no other channel moves`);
      found.set(node, [...known, { property, keys: this.keys(samplers[sampler], property === "rotation" ? 4 : 3, where) }]);
    }
    return found;
  }
  private keys({ input, output, interpolation = "LINEAR" }: { input: number; output: number; interpolation?: string }, width: number, where: string): Keys {
    if (interpolation !== "LINEAR" && interpolation !== "STEP" && interpolation !== "CUBICSPLINE") throw new Unreadable(`${where}: expected one of STEP, LINEAR, CUBICSPLINE`);
    const times = numbersOf(this.gltf, this.data, input).flat(), values = numbersOf(this.gltf, this.data, output), spline = interpolation === "CUBICSPLINE";
    if (times.length < (spline ? 2 : 1) || !(times[0] >= 0) || times.some((t, i) => i > 0 && !(t > times[i - 1])) || !times.every(Number.isFinite))
      throw new Unreadable(`${where}: expected times that rise, from 0 or later`);
    if (values.length !== times.length * (spline ? 3 : 1) || !values.every((value) => value.length === width && value.every(Number.isFinite)))
      throw new Unreadable(`${where}: expected ${spline ? "three values" : "a value"} of ${width} finite numbers for each time`);
    if (width === 4 && values.some((value, i) => (!spline || i % 3 === 1) && value.every((x) => x === 0))) throw new Unreadable(`${where}: expected a quaternion that is not zero`);
    return { interpolation, times, values };
  }
  private link(number: number, channels: Channel[] = []): Link {
    const { matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] } = this.gltf.nodes![number];
    return { ...(matrix ? { matrix } : {}), translation, rotation, scale, channels };
  }
}

/** All animations that move a body. `chains`: the nodes from the root to each body. */
export function readAnimations(gltf: Gltf, data: ArrayBuffer[], chains: number[][]): Animation[] {
  const reader = new AnimationReader(gltf, data, chains);
  return (gltf.animations ?? []).map((_, i) => reader.read(i)).filter(({ moves }) => moves.length > 0);
}
