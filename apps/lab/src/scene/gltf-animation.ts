// The animations of a glTF file, for the bodies that their nodes carry.

import { properties, widthOf, type Animation, type Channel, type Link } from "./animation.ts";
import { numbersOf, type Gltf } from "./gltf-data.ts";
import { expectedOf, type Keys } from "./keyframes.ts";
import { Unreadable } from "./meshes.ts";

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
      found.set(node, [...known, { property, keys: this.keys(samplers[sampler], widthOf(property), where) }]);
    }
    return found;
  }
  private keys({ input, output, interpolation = "LINEAR" }: { input: number; output: number; interpolation?: string }, width: number, where: string): Keys {
    const read = (number: number): number[][] => numbersOf(this.gltf, this.data, number);
    const keys = { interpolation: interpolation as Keys["interpolation"], times: read(input).flat(), values: read(output) }, expected = expectedOf(keys, width);
    if (expected) throw new Unreadable(`${where}: expected ${expected}`);
    return keys;
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
