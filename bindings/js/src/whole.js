// An entry with all parts: traces, blows, simulation and the plane on top of queries and worlds.

import { drawings, spaceDrawings, tessellations, worldDrawings } from "./draw.js";
import { queriesEntry } from "./entry.js";
import { replays } from "./capture.js";
import { hullLayering } from "./hulls.js";
import { plane } from "./plane.js";
import { protocolShapes, shapesOfProtocol } from "./protocol_shapes.js";
import { blows, simulationClasses } from "./simulation.js";

export function wholeEntry(scalar, address) {
  const { names, parts } = queriesEntry(scalar, address);
  const { core, layout, args, Rows, Handle, shapes, dimension, worlds } = parts;
  const { ask } = dimension;
  const simulations = simulationClasses(core, layout, dimension, worlds, Handle);
  const { hullLayers, tracedSupport } = hullLayering(core, layout, args, ask, shapes);
  const ofPlane = plane(core, layout, args, shapes.numbersOf, Rows, Handle);
  const readsProtocol = scalar === "d"; // which that module alone has
  const planeReads = readsProtocol ? { shapeOfProtocol: shapesOfProtocol(core, "plane_shape_of_text", ofPlane.names.Shape) } : {};
  return {
    core,
    names: {
      ...names,
      ...blows(core, layout, dimension, shapes),
      ...simulations.names,
      ...replays(core, layout, { worlds, simulations }, ofPlane),
      hullLayers,
      ...ask.framed(tessellations(core, layout, dimension)),
      protocolShape: protocolShapes(core, "shape_text", shapes.of),
      ...(readsProtocol ? { shapeOfProtocol: shapesOfProtocol(core, "shape_of_text", names.Shape) } : {}),
      traced: { ...ask.traced(), support: tracedSupport },
      draw: ask.framed({
        ...drawings(core, layout, dimension),
        ...worldDrawings(core, layout, dimension, worlds, simulations),
        ...spaceDrawings(core, layout, args),
      }),
      plane: { ...ofPlane.names, ...planeReads },
    },
  };
}
