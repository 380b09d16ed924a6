// graze: everything but the query protocol, in float.

import { wholeEntry } from "./whole.js";

const { names } = wholeEntry("f", () => new URL("./graze.wasm", import.meta.url));

export const {
  init, version, memoryInUse, InvalidValue, Handle, Numbers, turned, Shape, Sphere, Capsule, Box, Rectangle, Cylinder,
  Ellipsoid, Segment, Triangle, HalfSpace, ConvexHull, UserConvex, Mesh, HeightField, Compound, overlap, mayOverlap,
  distance, distanceUpTo, within, nearPieces, alongPlanes, contacts, contactMargin, featureCorners, closest, raycast,
  raycastAny, raycastAll, cast, castAll, poseAt, compose, inverse, relative, transform, inverseTransform, overlapBatch,
  distanceBatch, contactsBatch, compactContactsBatch, closestBatch, raycastBatch, castBatch, nearPiecesBatch,
  BroadPhase, PairChanges, World, hullLayers, tessellate, protocolShape, traced, draw, response, applyImpulse, passOn,
  freeBody, advance, angularVelocity, Simulation, State, captureHead, replay, plane,
} = names;
