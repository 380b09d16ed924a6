// Random numbers that are the same everywhere, by which a scene has the bodies of the benchmark of the same name.

import { length } from "../parts/vec.ts";
import type { Vec } from "../question.ts";

const word = (x: bigint): bigint => BigInt.asUintN(64, x);

/** SplitMix64 (Steele, Lea, Flood 2014), with the numbers that `Random` of bench/random.hpp has for the same seed. */
export class Random {
  private state: bigint;

  constructor(seed: number) {
    this.state = BigInt(seed);
  }
  number(low: number, high: number): number {
    let z = (this.state = word(this.state + 0x9e3779b97f4a7c15n));
    z = word((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
    z = word((z ^ (z >> 27n)) * 0x94d049bb133111ebn);
    return low + (high - low) * Number((z ^ (z >> 31n)) >> 11n) * 2 ** -53;
  }
  inCube(reach: number): Vec {
    return [0, 1, 2].map(() => this.number(-reach, reach));
  }
  /** Uniform, by throwing away what falls outside the ball. */
  direction(): Vec {
    for (;;) {
      const v = this.inCube(1), l = length(v);
      if (l > 0.1 && l <= 1) return v.map((x) => x / l);
    }
  }
}
