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
function callbackImports(core, layout) {
  const id = (index, generation) => ({ index, generation });
  /** The direction itself is the point where the function has thrown: the answer is thrown away. */
  const supported = (vector) => (key, direction, point) => {
    core.memory();
    const from = vector.read(direction);
    core.copy(direction, point, vector.size);
    core.called(key, undefined, (support) => {
      const found = support(from);
      core.memory();
      vector.write(point, found, "support");
    });
  };
  return {
    allow: (key, a, generationA, b, generationB) =>
      core.called(key, 1, (allow) => (allow(id(a >>> 0, generationA >>> 0), id(b >>> 0, generationB >>> 0)) ? 1 : 0)),
    accept: (key, index, generation) =>
      core.called(key, 1, (accept) => (accept(id(index >>> 0, generation >>> 0)) ? 1 : 0)),
    support: supported(layout.vec3),
    planeSupport: supported(layout.vec2),
    release: (key) => core.callbacks.delete(key),
    ...drawImports(core),
    ...captureImports(core),
  };
}

export function queriesEntry(scalar, address) {
  const core = new Core(scalar, address);
  const layout = layouts(core);
  core.callbackImports = callbackImports(core, layout);
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
