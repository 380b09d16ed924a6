// An entry with all parts: traces, blows, simulation and the plane on top of queries and worlds.

import { drawings, spaceDrawings } from "./draw.js";
import { queriesEntry } from "./entry.js";
import { replays } from "./replay.js";
import { plane } from "./plane.js";
import { blows, simulationClasses } from "./simulation.js";

export function wholeEntry(scalar, address) {
  const { names, parts } = queriesEntry(scalar, address);
  const { core, layout, args, Handle, shapes, ask, worlds } = parts;
  const simulations = simulationClasses(core, layout, args, shapes, worlds, Handle);
  return {
    core,
    names: {
      ...names,
      ...blows(core, layout, args, shapes),
      ...simulations,
      ...replays(core, layout, worlds),
      traced: ask.traced(),
      draw: ask.framed({
        ...drawings(core, layout, ask, { prefix: "", of: shapes.of, pose: args.pose }),
        ...spaceDrawings(core, layout, args, simulations, worlds, Handle),
      }),
      plane: plane(core, layout, args, Handle),
    },
  };
}
