// graze/queries: queries in space and worlds, in float.

import { queriesEntry } from "./entry.js";

const { names } = queriesEntry("f", () => new URL("./graze-queries.wasm", import.meta.url));

export const {
  init, version, memoryInUse, InvalidValue, Handle, Numbers, turned, Shape, Sphere, Capsule, Box, Rectangle, Cylinder,
  Ellipsoid, Segment, Triangle, HalfSpace, ConvexHull, UserConvex, Mesh, HeightField, Compound, overlap, mayOverlap,
  distance, distanceUpTo, within, nearPieces, alongPlanes, contacts, contactMargin, featureCorners, closest, raycast,
  raycastAny, raycastAll, cast, castAll, poseAt, compose, inverse, relative, transform, inverseTransform, overlapBatch,
  distanceBatch, contactsBatch, compactContactsBatch, closestBatch, raycastBatch, castBatch, nearPiecesBatch,
  BroadPhase, PairChanges, World,
} = names;
