// Checks of `using`, in the manner of checks.js: where the engine does not know it, a compiler's output is run.

import { close, equal, ok, throws } from "./assert.js";

/** All kinds of handles of an entry or of its plane, each by a function that makes one. */
function made({ Numbers, Box, BroadPhase, PairChanges, World, Simulation, distanceBatch }, [size, apart, poses]) {
  const batch = () => {
    using box = new Box(size);
    return distanceBatch({ shapes: box, poses: poses[0] }, { shapes: box, poses: poses[1] });
  };
  const share = () => {
    using world = new World();
    using box = new Box(size);
    return world.shape(world.add({ shape: box }));
  };
  const rounded = () => {
    using box = new Box(size);
    return box.rounded(0.5);
  };
  const crowd = () => {
    const world = new World();
    using box = new Box(size);
    for (let i = 0; i < 20; ++i) world.add({ shape: box, translation: apart.map((x) => x * i) });
    world.update();
    return world;
  };
  const all = { box: () => new Box(size), rounded, share, batch, world: crowd };
  if (Numbers !== undefined) Object.assign(all, {
    numbers: () => new Numbers(100), broadPhase: () => new BroadPhase(), pairChanges: () => new PairChanges() });
  if (Simulation !== undefined) Object.assign(all, {
    simulation: () => new Simulation(),
    state: () => {
      using simulation = new Simulation();
      return simulation.save();
    } });
  return all;
}
const space = [[1, 1, 1], [0.5, 0, 0], [[0, 0, 0, 0, 0, 0, 1], [0, 2, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 1]]];
const flat = [[1, 1], [0.5, 0], [[0, 0, 1, 0], [0, 2, 1, 0, 0, 3, 1, 0]]];

/** Calls `body` with a way to make each handle of an entry. */
function eachHandle({ graze, double, queries }, body) {
  for (const entry of [graze, double, queries]) {
    for (const [name, make] of Object.entries(made(entry, space))) body(name, make, entry);
    if (entry.plane === undefined) continue;
    for (const [name, make] of Object.entries(made(entry.plane, flat))) body(`plane.${name}`, make, entry);
  }
}

export const usingChecks = [
  ["handles end with their block", (entries) => {
    eachHandle(entries, (name, make, { memoryInUse }) => {
      make().dispose(); // tables that the module keeps from its first calls
      const before = memoryInUse();
      let seen;
      {
        using held = make();
        seen = held;
        ok(held.disposed !== true && memoryInUse() > before, `${name}: that it holds memory`);
      }
      equal(memoryInUse(), before, `${name}: memory behind the block`);
      seen.dispose(); // again, which does nothing
      equal(memoryInUse(), before, `${name}: memory after a second time`);
    });
  }],

  ["handles end with a block that is left by an exception, a return, a break", (entries) => {
    eachHandle(entries, (name, make, { memoryInUse }) => {
      make().dispose();
      const before = memoryInUse();
      throws(() => {
        using held = make();
        throw new Error(`enough of ${typeof held}`);
      }, "enough of object");
      equal(memoryInUse(), before, `${name}: memory after an exception`);
      const returned = () => {
        using held = make();
        return held;
      };
      ok(returned() !== null, name);
      equal(memoryInUse(), before, `${name}: memory after a return`);
      for (;;) {
        using held = make();
        if (held !== null) break;
      }
      for (using held of [make(), make()]) ok(held !== null, name);
      equal(memoryInUse(), before, `${name}: memory after loops`);
    });
  }],

  ["what is used in a block can be asked there, and not behind it", ({ graze, double, queries }) => {
    for (const { Box, Sphere, World, distance, InvalidValue, memoryInUse } of [graze, double, queries]) {
      const before = memoryInUse();
      let left;
      {
        using box = new Box([2, 2, 2]), ball = new Sphere(0.5);
        close(distance(box, {}, ball, { translation: [2, 0, 0] }).distance, 0.5, 1e-6, "distance");
        left = box;
      }
      ok(left.disposed, "disposed");
      throws(() => distance(left, {}, left, {}), "a: expected a live object, got a disposed one", InvalidValue);
      // Refused in a constructor: what was made before it is given back.
      throws(() => {
        using box = new Box([1, 1, 1]);
        using bad = new Box([1, -1, box.rounding]);
        ok(bad === undefined, "a bad box");
      }, /^size\[1\]/, InvalidValue);
      // A world keeps its own share of a shape that ends before it.
      {
        using world = new World();
        {
          using box = new Box([1, 1, 1]);
          world.add({ shape: box });
        }
        world.update();
        equal(world.raycast({ origin: [-3, 0, 0], direction: [1, 0, 0] }).hit.t, 2.5, "the box is still there");
      }
      equal(memoryInUse(), before, "memory");
    }
  }],

  ["a handle that a call is using is not ended by `using`, and says so", ({ graze }) => {
    let world;
    let body;
    const allow = () => {
      using same = world;
      return same !== null;
    };
    world = new graze.World({ allow });
    {
      using box = new graze.Box([1, 1, 1]);
      body = world.add({ shape: box });
      world.add({ shape: box, translation: [0.5, 0, 0] });
    }
    throws(() => world.update(), /in use: another call changes it at this moment$/);
    ok(!world.disposed && world.contains(body), "that the world is still there");
    world.dispose();
  }],
];
