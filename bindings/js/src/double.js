// graze/double: everything, in double, and the query protocol.

import { wholeEntry } from "./whole.js";

const { names, core } = wholeEntry("d", () => new URL("./graze-double.wasm", import.meta.url));

export const {
  init, version, memoryInUse, InvalidValue, Handle, Numbers, turned, Shape, Sphere, Capsule, Box, Rectangle, Cylinder,
  Ellipsoid, Segment, Triangle, HalfSpace, ConvexHull, UserConvex, Mesh, HeightField, Compound, overlap, mayOverlap,
  distance, distanceUpTo, within, nearPieces, alongPlanes, contacts, contactMargin, featureCorners, closest, raycast,
  raycastAny, raycastAll, cast, castAll, poseAt, compose, inverse, relative, transform, inverseTransform, overlapBatch,
  distanceBatch, contactsBatch, compactContactsBatch, closestBatch, raycastBatch, castBatch, nearPiecesBatch,
  BroadPhase, PairChanges, World, hullLayers, tessellate, protocolShape, shapeOfProtocol, traced, draw, response,
  applyImpulse, passOn, freeBody, advance, angularVelocity, Simulation, State, captureHead, replay, plane,
} = names;

const encoder = new TextEncoder();
const decoder = new TextDecoder();
/** The answer of a function of the module to a text. */
const answered = (name, text, ...more) =>
  core.frame(() => {
    const bytes = encoder.encode(text);
    const place = core.room(Math.max(1, bytes.length));
    new Uint8Array(core.memory().buffer).set(bytes, place);
    const count = core.room(4);
    const answer = core.exports[name](place, bytes.length, ...more, count);
    const { buffer } = core.memory();
    return decoder.decode(new Uint8Array(buffer, answer, core.data.getUint32(count, true)));
  });

export const query = (line) => answered("graze_js_answer", line, 0);
export const explain = (line) => answered("graze_js_answer", line, 1);

/** An element of a DOM as the module reads it. */
const elements = ({ localName, line = 0, attributes, children }) => [
  localName, line, Object.fromEntries(Array.from(attributes, ({ name, value }) => [name, value])), Array.from(children, elements)];

export function planeScene(root) {
  const { error, ...scene } = JSON.parse(answered("graze_js_plane_scene", JSON.stringify(elements(root))));
  if (error !== undefined) throw new InvalidValue(error);
  return scene;
}

const meshFormats = ["obj", "ply", "stl"];
export function meshOfFile(bytes, format) {
  if (!(bytes instanceof Uint8Array)) throw new InvalidValue("bytes: expected a Uint8Array");
  const kind = meshFormats.indexOf(format);
  if (kind < 0) throw new InvalidValue(`format: expected "obj", "ply" or "stl", got ${JSON.stringify(format)}`);
  const pointer = core.frame(() => {
    const [place, shape] = [core.room(Math.max(1, bytes.length)), core.room(4)];
    new Uint8Array(core.memory().buffer).set(bytes, place);
    core.check(core.exports.graze_js_mesh_of_file_d(place, bytes.length, kind, shape));
    return core.data.getUint32(shape, true);
  });
  return new Shape(pointer);
}
