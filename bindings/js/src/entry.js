// The exports of an entry of the package, made for one module.

import { Core, handleClass, InvalidValue } from "./core.js";
import { drawImports } from "./draw.js";
import { captureImports } from "./capture.js";
import { layouts } from "./layout.js";
import { argumentsOf, shapeClasses } from "./shapes.js";
import { spaceQuestions } from "./questions.js";
import { batches, rowsClass } from "./batches.js";
import { worldClasses } from "./world.js";
import { broadPhases } from "./broad.js";

/** Functions of JavaScript that the module calls. */
function callbackImports(core) {
  const id = (index, generation) => ({ index, generation });
  const supported = (dimensions) => (key, direction, point) => {
    const from = Array.from(core.numbers(direction, dimensions));
    const to = core.called(key, from, (support) => support(from));
    core.numbers(point, dimensions).set(to);
  };
  return {
    allow: (key, a, generationA, b, generationB) =>
      core.called(key, 1, (allow) => (allow(id(a >>> 0, generationA >>> 0), id(b >>> 0, generationB >>> 0)) ? 1 : 0)),
    accept: (key, index, generation) =>
      core.called(key, 1, (accept) => (accept(id(index >>> 0, generation >>> 0)) ? 1 : 0)),
    support: supported(3),
    planeSupport: supported(2),
    release: (key) => core.callbacks.delete(key),
    ...drawImports(core),
    ...captureImports(core),
  };
}

export function queriesEntry(scalar, address) {
  const core = new Core(scalar, address);
  core.callbackImports = callbackImports(core);
  const layout = layouts(core);
  const args = argumentsOf(core, layout);
  const Handle = handleClass(core);
  const Rows = rowsClass(core);
  const shapes = shapeClasses(core, layout, args, Handle);
  const { ask, plain } = spaceQuestions(core, layout, args, shapes);
  const dimension = {
    prefix: "", types: layout, args, of: shapes.of, Shape: shapes.classes.Shape, pose: args.pose, shown: (pose) => pose,
    turning: args.vec3, numbersOf: shapes.numbersOf, ask };
  const worlds = worldClasses(core, layout, dimension, Rows, Handle);
  const parts = { core, layout, args, Rows, Handle, shapes, dimension, worlds };
  const names = {
    init: (source) => core.init(source),
    version: () => core.frame(() => core.string(core.exports.graze_version_string())),
    memoryInUse: () => core.frame(() => core.exports.graze_js_memory_in_use()),
    InvalidValue,
    Handle,
    ...shapes.classes,
    ...plain,
    ...ask.framed(batches(core, layout, dimension, Rows, Handle)),
    ...broadPhases(core, layout, args, ask, Handle),
    World: worlds.World,
  };
  return { names, parts };
}
