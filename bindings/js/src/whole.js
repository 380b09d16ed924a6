// An entry with all parts: traces, blows, simulation and the plane on top of queries and worlds.

import { queriesEntry } from "./entry.js";
import { plane } from "./plane.js";
import { blows, simulationClasses } from "./simulation.js";

export function wholeEntry(scalar, address) {
  const { names, parts } = queriesEntry(scalar, address);
  const { core, layout, args, Handle, shapes, ask, worlds } = parts;
  return {
    core,
    names: {
      ...names,
      ...blows(core, layout, args, shapes),
      ...simulationClasses(core, layout, args, shapes, worlds, Handle),
      traced: ask.traced(),
      plane: plane(core, layout, args, Handle),
    },
  };
}
