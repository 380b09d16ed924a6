// Graze for JavaScript: collision detection as WebAssembly. The words are those of the C++ library.
//
// Three entries, which differ in what their module holds and in its scalar:
//   graze           float: queries, worlds, simulation, the plane, traces
//   graze/queries   float: queries in space and worlds alone, the smallest
//   graze/double    double: all of `graze`, and the query protocol (`query`, `explain`), with the bits of `graze query`
//
//   import { init, Box, Sphere, distance } from "graze";
//   await init();
//   using box = new Box([2, 2, 2]), ball = new Sphere(0.5);
//   distance(box, {}, ball, { translation: [1.4, 0, 0] });  // { distance: -0.1, normal: [1, 0, 0], ... }
//
// Units are the caller's own, angles radians, quaternions [x, y, z, w]. Normals are unit vectors from A to B. Distances
// are signed: negative when shapes overlap. A value that is refused throws `InvalidValue`, whose message names it.
//
// Shapes, worlds, simulations and arrays lie in the module's memory: `dispose()` or `using` gives it back at once, and
// what was forgotten is given back after it was garbage collected. A world and a compound keep their shapes themselves.

declare global {
  /** Declared also where the language's own library does not have it yet. */
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
}

// --- Start ---

/** The source of the module, if it is not beside the script: its address, its bytes, or compiled. */
export type ModuleSource = string | URL | Response | BufferSource | WebAssembly.Module;
/** Loads the module. Everything else may be used once the promise is fulfilled; a second call does nothing more. */
export function init(source?: ModuleSource | Promise<ModuleSource>): Promise<void>;
/** The version of the library: "0.1.0". */
export function version(): string;
/** Bytes that live objects hold in the module's memory; `memoryInUse` returns to what it was when all are disposed. */
export function memoryInUse(): number;

/** The error of a value that was refused: the message is "path: expected this, got that". */
export class InvalidValue extends RangeError {}

/** An object that lies in the module's memory. */
export abstract class Handle {
  /** Gives the memory back. Using the object afterwards throws; disposing it again does nothing. Throws an `Error` ("in
   * use: ...") in a callback of a call that uses the object, as every change of it does, and every use of one that the
   * call changes. */
  dispose(): void;
  readonly disposed: boolean;
  [Symbol.dispose](): void;
}

// --- Numbers ---

/** The numbers of the entry: Float64Array in graze/double, else Float32Array. */
export type Scalars = Float32Array | Float64Array;
/** A vector as an argument: any three numbers. */
export type Vec3Like = ArrayLike<number>;
export type Vec3 = [x: number, y: number, z: number];
export type Quat = [x: number, y: number, z: number, w: number];
/** A matrix as its rows. */
export type Mat3 = [Vec3, Vec3, Vec3];
/** Many points: numbers one behind the other, or an array of points. */
export type Points = ArrayLike<number> | readonly ArrayLike<number>[];

/** The place of a body and its rotation. Absent: at the origin, not turned. The quaternion has unit length. */
export interface PoseLike {
  readonly translation?: Vec3Like;
  readonly rotation?: ArrayLike<number>;
}
export interface Pose {
  translation: Vec3;
  rotation: Quat;
}
/** A pose turned by `angle` about `axis`, which need not be unit. */
export function turned(translation: Vec3Like, axis: Vec3Like, angle: number): Pose;
/** The pose `b`, given in the frame of `a`, in the world: the motion `b` followed by `a`. */
export function compose(a: PoseLike, b: PoseLike): Pose;
/** The motion that undoes a pose. */
export function inverse(pose: PoseLike): Pose;
/** The pose `b` in the frame of `a`. Made of the difference of the translations: no digits are lost far from the origin. */
export function relative(a: PoseLike, b: PoseLike): Pose;
/** A point of the body's frame, in the world. */
export function transform(pose: PoseLike, point: Vec3Like): Vec3;
/** A point of the world, in the body's frame. */
export function inverseTransform(pose: PoseLike, point: Vec3Like): Vec3;

export interface Aabb {
  lower: Vec3;
  upper: Vec3;
}

/** Numbers in the module's memory, which batches read and write where they stand. */
export class Numbers extends Handle {
  constructor(length: number);
  readonly length: number;
  /** The memory itself. Ask again after any call of the library: memory that grows leaves older views empty. */
  readonly array: Scalars;
}

/** Structs one behind the other in the module's memory. */
export interface Rows<T> extends Iterable<T> {
  readonly length: number;
  /** A copy of the i-th as an object. */
  at(i: number): T;
  /** The memory itself: `stride` numbers for each struct, its members at `offset`. Valid until the next call. */
  readonly view: Scalars;
  readonly stride: number;
  readonly offset: Readonly<Record<string, number>>;
}

// --- Shapes ---

export type ShapeKind =
  | "sphere" | "capsule" | "box" | "rectangle" | "cylinder" | "ellipsoid" | "segment" | "triangle" | "convexHull"
  | "userConvex" | "halfSpace" | "mesh" | "heightField" | "compound";

export interface MassProperties {
  volume: number;
  center: Vec3;
  /** The inertia at density one, about `center`. */
  inertia: Mat3;
}

/** The measures that a shape was made of, without its rounding, by its kind: `if (measures.kind === "box") ...size`. All
 * are `convex`, a half-space too, but meshes, height fields and compounds. */
export type ShapeMeasures = { readonly convex: boolean } & (
  | { readonly kind: "sphere"; readonly radius: number; readonly center: Vec3 }
  | {
      readonly kind: "capsule" | "cylinder"; readonly height: number; readonly radiusBottom: number;
      readonly radiusTop: number }
  | { readonly kind: "box"; readonly size: Vec3 }
  | { readonly kind: "rectangle"; readonly sizeX: number; readonly sizeZ: number }
  | { readonly kind: "ellipsoid"; readonly radii: Vec3 }
  /** No point that the hull was made of lies further outside than `tolerance`. */
  | { readonly kind: "convexHull"; readonly tolerance: number }
  /** `closed`: each edge is in two triangles, which run through it in opposite directions. */
  | { readonly kind: "mesh"; readonly closed: boolean; readonly solid: boolean; readonly sides: Sides }
  | {
      readonly kind: "heightField"; readonly columns: number; readonly rows: number; readonly spacing: Vec2;
      readonly sides: Sides }
  /** The number of children. */
  | { readonly kind: "compound"; readonly children: number }
  | { readonly kind: "segment" | "triangle" | "halfSpace" | "userConvex" });

/** A shape, which never changes. Made by the classes below. */
export class Shape extends Handle {
  protected constructor();
  readonly kind: ShapeKind;
  readonly rounding: number;
  /** The measures that the shape was made of, in constant time. */
  measures(): ShapeMeasures;
  /** A copy of the vertices of a convex hull or a mesh, the corners of a triangle or the ends of a segment, three numbers
   * each. Throws `InvalidValue` for other kinds, as the next three do for kinds that have none. */
  points(): Scalars;
  /** A copy of a mesh's triangles, three indices each. */
  triangles(): Uint32Array;
  /** A copy of the heights of a height field, row by row, with NaN for holes. */
  heights(): Scalars;
  /** The children of a compound and their poses; each shape is a share, to be disposed of. */
  children(): (Pose & { shape: Shape })[];
  bounds(pose?: PoseLike): Aabb;
  /** The point of a bounded convex shape furthest along `direction`, in the shape's frame. */
  support(direction: Vec3Like): Vec3;
  massProperties(): MassProperties;
  /** The Minkowski sum with a ball of that radius; of convex shapes. */
  rounded(rounding: number): Shape;
  /** The space that a bounded convex shape sweeps while it moves by `motion` without turning. */
  swept(pose: PoseLike, motion: Vec3Like): Shape;
}
export class Sphere extends Shape {
  constructor(radius: number, center?: Vec3Like);
}
/** A capsule with `height` between the centres of its end balls, along Y. */
export class Capsule extends Shape {
  constructor(height: number, radiusBottom: number, radiusTop?: number);
}
/** A box by its full edge lengths. */
export class Box extends Shape {
  constructor(size: Vec3Like);
}
/** A rectangle in the XZ plane, without thickness. */
export class Rectangle extends Shape {
  constructor(sizeX: number, sizeZ: number);
}
/** A cylinder along Y; a radius of 0 makes a cone. */
export class Cylinder extends Shape {
  constructor(height: number, radiusBottom: number, radiusTop?: number);
}
export class Ellipsoid extends Shape {
  constructor(radii: Vec3Like);
}
export class Segment extends Shape {
  constructor(a: Vec3Like, b: Vec3Like);
}
export class Triangle extends Shape {
  constructor(a: Vec3Like, b: Vec3Like, c: Vec3Like);
}
/** All points with y <= 0. */
export class HalfSpace extends Shape {
  constructor();
}
export class ConvexHull extends Shape {
  constructor(points: Points);
}
/** A convex shape of your own: `support` returns a point furthest along a direction, which is not zero. What it throws, and
 * an `InvalidValue` for what is no point, comes out of the call that asked it. */
export class UserConvex extends Shape {
  constructor(support: (direction: Vec3) => Vec3Like);
}
export type Sides = "both" | "front";
export class Mesh extends Shape {
  /** Three indices for each triangle, counter-clockwise seen from outside. */
  constructor(points: Points, triangles: Points, options?: { sides?: Sides; solid?: boolean });
  findings(): MeshFindings;
}
/** Findings about a mesh, in numbers of triangles and edges. Each edge is in one of five classes. None is an error. */
export interface MeshFindings {
  triangles: number;
  /** Triangles with the corners of an earlier one in the same turn. */
  repeatedTriangles: number;
  withoutArea: number;
  /** Triangles lower than 1/1000 of their longest side. */
  slivers: number;
  repeatedPoints: number;
  flatEdges: number;
  convexEdges: number;
  concaveEdges: number;
  /** Edges of one triangle only: rims, and seams that do not meet. */
  openEdges: number;
  /** Edges of more than two triangles, or run through twice in one direction. */
  irregularEdges: number;
  /** Open edges on whose inside the corner of another triangle lies. */
  tJunctions: number;
}
export class HeightField extends Shape {
  /** heights[r * columns + c]; NaN (or a hole, null in an array) is a hole. `spacing` defaults to [1, 1]. */
  constructor(
    heights: ArrayLike<number | null>, columns: number, rows: number,
    options?: { spacing?: ArrayLike<number>; sides?: Sides });
}
export interface Child extends PoseLike {
  readonly shape: Shape;
}
export class Compound extends Shape {
  constructor(children: readonly Child[]);
}

// --- Queries ---

/** `bounded`: right within `error`; `unbounded`: two half-spaces that overlap without a finite depth. */
export type Certainty = "converged" | "bounded" | "unbounded";
export interface Distance {
  distance: number;
  normal: Vec3;
  /** The points on the surfaces: b - a = distance * normal. */
  a: Vec3;
  b: Vec3;
  certainty: Certainty;
  error: number;
}
export interface Closest {
  distance: number;
  point: Vec3;
  normal: Vec3;
  certainty: Certainty;
  error: number;
}
export interface PieceDistance {
  pieceA: number;
  pieceB: number;
  distance: Distance;
}
export interface ContactPoint {
  a: Vec3;
  b: Vec3;
  distance: number;
  /** A number that stays the same while the same features touch. */
  feature: number;
  /** The weight of the point for a solver: a + (b - a) * weight. */
  weight: number;
}
export interface Manifold {
  normal: Vec3;
  pieceA: number;
  pieceB: number;
  points: ContactPoint[];
}
export interface PairContacts {
  overlap: boolean;
  manifolds: Manifold[];
}
/** Contacts in few bytes: points that share a normal, and what a solver wants of a point. */
export interface CompactManifold {
  normal: Vec3;
  /** The place of the pair in the batch. */
  pair: number;
  firstPoint: number;
  pointCount: number;
}
export interface CompactPoint {
  position: Vec3;
  distance: number;
}
export interface Contacts extends PairContacts {
  certainty: Certainty;
  error: number;
}
export interface Ray {
  readonly origin: Vec3Like;
  /** The direction, of any length. */
  readonly direction: Vec3Like;
  /** The length in units of length; default: no end. */
  readonly length?: number;
}
export interface RayHit {
  t: number;
  point: Vec3;
  normal: Vec3;
  piece: number;
}
export interface RayOptions {
  backFaces?: "hit" | "ignored";
}
export interface Moving extends PoseLike {
  readonly shape: Shape;
  readonly linear?: Vec3Like;
  readonly angular?: Vec3Like;
}
export interface CastHit {
  t: number;
  point: Vec3;
  normal: Vec3;
  /** The depth of shapes that overlap at the start, else 0. */
  depth: number;
  certainty: Certainty;
  pieceA: number;
  pieceB: number;
}
export interface CastOptions {
  /** The time of the cast; default 1. */
  duration?: number;
  separating?: "hit" | "ignored";
}

export function overlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): boolean;
/** A cheaper test: false only where they do not touch. */
export function mayOverlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): boolean;
export function distance(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Distance;
/** The distance of shapes no further apart than `limit`, else null. */
export function distanceUpTo(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, limit: number): Distance | null;
export function within(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, limit: number): boolean;
export function nearPieces(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin: number): PieceDistance[];
/** All points of contact up to `margin` apart; with `most`, at most so many of them, which span most. */
export function contacts(
  a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin?: number, most?: number): Contacts;
/** A margin with which a body at rest keeps its points from frame to frame. */
export function contactMargin(a: Shape, b: Shape): number;
/** The part of a motion that planes leave: the nearest motion that leads into none of them. `normals` are unit and
 * point away from the obstacles. */
export function alongPlanes(motion: Vec3Like, normals: Points): Vec3;
/** The corners of a feature in the shape's frame: one of a vertex, two of an edge, those of a face in order; none of a
 * round part. `feature` is `point.feature >>> 16` for A and `point.feature & 0xffff` for B, `piece` that of the
 * manifold. */
export function featureCorners(shape: Shape, feature: number, piece?: number): Vec3[];
export function closest(shape: Shape, pose: PoseLike, point: Vec3Like): Closest;
export function raycast(shape: Shape, pose: PoseLike, ray: Ray, options?: RayOptions): RayHit | null;
export function raycastAny(shape: Shape, pose: PoseLike, ray: Ray, options?: RayOptions): boolean;
export function raycastAll(shape: Shape, pose: PoseLike, ray: Ray, options?: RayOptions): RayHit[];
/** The first contact while both move for a `duration`. */
export function cast(a: Moving, b: Moving, options?: CastOptions): CastHit | null;
export function castAll(a: Moving, b: Moving, options?: CastOptions): CastHit[];
/** The pose of a moving body at time t. */
export function poseAt(moving: Omit<Moving, "shape">, t: number): Pose;

// --- Many at a time: the bits are those of each pair alone ---

/**
 * Shapes and poses, as many of one as of the other, or a single one of either. `poses` has seven numbers each:
 * translation and quaternion; or give `translations` and, where they are turned, `rotations`. A `Numbers` is read where
 * it stands, any other array is copied in.
 */
export interface Bodies {
  readonly shapes: Shape | readonly Shape[];
  readonly poses?: Numbers | ArrayLike<number>;
  readonly translations?: Numbers | ArrayLike<number>;
  readonly rotations?: Numbers | ArrayLike<number>;
}
/** Places in both, two for each pair. Without them: first with first and so on, or a single one with all. */
export type Places = ArrayLike<number>;

/** 1 or 0 for each pair. */
export function overlapBatch(a: Bodies, b: Bodies, places?: Places): Uint8Array;
export function distanceBatch(a: Bodies, b: Bodies, places?: Places): Batch<Distance>;
/** The contacts of each pair; with `most` at most so many points of it, as `contacts` has them. */
export function contactsBatch(
  a: Bodies, b: Bodies, margin?: number, places?: Places, most?: number): PairContacts[];
/** Contacts in few bytes, of the pairs that have any, without a copy: valid until the next call. The manifolds of a
 * pair are contiguous; pairs may come in another order than in the batch. */
export function compactContactsBatch(
  a: Bodies, b: Bodies, margin?: number,
  places?: Places): { manifolds: Rows<CompactManifold>; points: Rows<CompactPoint> };
export function closestBatch(shape: Shape, pose: PoseLike, points: Numbers | Points): Batch<Closest>;
/** Casts rays of six numbers: origin and direction. `found` is 1 or 0 for each; where 0, its hit is all zeros. */
export function raycastBatch(
  shape: Shape, pose: PoseLike, rays: Numbers | ArrayLike<number>,
  options?: RayOptions & { length?: number }): Batch<RayHit> & { readonly found: Uint8Array };
/** Casts the first of A and the first of B, and so on. */
export function castBatch(
  a: readonly Moving[], b: readonly Moving[], options?: CastOptions): Batch<CastHit> & { readonly found: Uint8Array };
/** The near pieces of each pair. */
export function nearPiecesBatch(a: Bodies, b: Bodies, margin: number, places?: Places): PieceDistance[][];
/** Answers in the module's memory, until disposed. */
export interface Batch<T> extends Rows<T> {
  dispose(): void;
  [Symbol.dispose](): void;
}

// --- Traces: the steps of a query; the answer has the same bits ---

export interface TraceSupport {
  a: Vec3;
  b: Vec3;
}
export interface TraceAxis {
  /** The name: "A0", "A1×B0", "A face 12", ... */
  name: string;
  direction: Vec3;
  /** The intervals that the shapes cover. */
  a: [lower: number, upper: number];
  b: [lower: number, upper: number];
  /** The overlap; a gap is negative. */
  overlap: number;
}
export interface TraceGjk {
  simplex: TraceSupport[];
  direction: Vec3;
  found: TraceSupport;
  lower: number;
  upper: number;
  /** In the plane: all vertices, counter-clockwise. */
  polygon: TraceSupport[];
}
export interface TraceEpa {
  normal: Vec3;
  faceDepth: number;
  foundDepth: number;
  found: TraceSupport;
  faces: number;
  polygon: TraceSupport[];
}
export interface TraceSpan {
  name: string;
  normal: Vec3;
  enter: number;
  leave: number;
}
export interface TraceStep {
  t: number;
  distance: number;
  normal: Vec3;
}
/** One cut of a face by the plane through a side of the other: the side, and the rest of the face. */
export interface TraceCut {
  from: Vec3;
  to: Vec3;
  left: Vec3[];
}
export interface Trace {
  /** One of "closed form", "separating axes", "gjk", "gjk + epa", "slabs", "conservative advancement". */
  method: string;
  /** The axis or span that the answer stands on, and why; empty where there is none. */
  winner: string;
  reason: string;
  axes: TraceAxis[];
  gjk: TraceGjk[];
  epa: TraceEpa[];
  /** In the plane: the outline of the difference of the cores. */
  difference: TraceSupport[];
  rounding: number;
  polytope: TraceSupport[];
  triangles: [number, number, number][];
  spans: TraceSpan[];
  steps: TraceStep[];
  /** The faces that contacts stand on, and the clipping of one by the other; empty where they stand on none. */
  faceA: Vec3[];
  faceB: Vec3[];
  cuts: TraceCut[];
  nodes: number;
  pieces: number;
}
export interface Traced<Answer> {
  answer: Answer;
  trace: Trace;
}
/** Not in graze/queries. In the plane vectors of a trace have a third number, which is 0. */
export const traced: {
  overlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Traced<boolean>;
  distance(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Traced<Distance>;
  contacts(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin?: number): Traced<Contacts>;
  closest(shape: Shape, pose: PoseLike, point: Vec3Like): Traced<Closest>;
  raycast(shape: Shape, pose: PoseLike, ray: Ray, options?: RayOptions): Traced<RayHit | null>;
  cast(a: Moving, b: Moving, options?: CastOptions): Traced<CastHit | null>;
  /** The support query of a convex hull, layer by layer; the answer is that of `hull.support(direction)`. */
  support(hull: Shape, direction: Vec3Like): { answer: Vec3; trace: SupportTrace };
};

/** The steps of one support query of a hull. Vertices are numbers of those that `hullLayers` lists. */
export interface SupportTrace {
  vertex: number;
  /** Whether every vertex was looked at: hulls of up to 64 vertices, and flat ones. */
  scanned: boolean;
  /** The number of scalar products, of all layers together. */
  products: number;
  /** The layers, the coarsest first, the hull itself last. */
  layers: {
    /** The number of vertices of the layer. */
    vertices: number;
    /** The furthest of the layer. */
    winner: number;
    /** The vertices in the order of the search: the one from the coarser layer, then neighbours of the best so far. */
    lookedAt: Uint32Array;
    /** The product of each of these with the direction. */
    along: Float64Array;
  }[];
}
/** The hull of some vertices of a hull, or of all of them. */
export interface HullLayer {
  /** Numbers of the hull's vertices. */
  vertices: Uint32Array;
  /** Two numbers an edge. */
  edges: Uint32Array;
}
/** The layers of Dobkin and Kirkpatrick's hierarchy, the coarsest first and the hull itself last. Not in
 * graze/queries. */
export function hullLayers(hull: Shape): { vertices: Vec3[]; layers: HullLayer[] };

/** A shape of the query protocol: its type, and under that name its measures. */
export interface ProtocolShape {
  type: string;
  margin?: number;
  [measures: string]: unknown;
}
/** A shape as a question of the protocol has it, with the same measures. Throws `InvalidValue` for a shape that the
 * protocol cannot express: a UserConvex, and a mesh or a height field that is seen from its front alone. A ball beside
 * its origin becomes a compound of one child, a segment the hull of its ends. Not in graze/queries. */
export function protocolShape(shape: Shape): ProtocolShape;
/** The shape that a question of the protocol describes, with the protocol's defaults. Throws `InvalidValue` that names
 * the fault in it. graze/double alone. */
export function shapeOfProtocol(words: ProtocolShape): Shape;

/** Faces as loops of points. */
export interface Polygons {
  /** In the world. */
  points: Vec3[];
  /** Indices of points, counter-clockwise seen from outside. */
  loops: number[][];
  /** Whether edges come from the sampling, not from the shape. */
  smooth: boolean;
  /** Whether there is an inside, so that faces seen from behind are hidden. */
  closed: boolean;
}
/** The faces of a shape, curved ones sampled for the eye; a half-space is a square whose sides are twice `size`,
 * default 1, about the foot of `center`. Not in graze/queries. */
export function tessellate(
  shape: Shape, pose: PoseLike, options?: { readonly center?: Vec3Like; readonly size?: number }): Polygons;

// --- Debug draw ---

/** A group of things that a reader switches on and off together. */
export type DrawLayer = "shapes" | "bounds" | "tree" | "contacts" | "distances" | "rays" | "casts" | "trace" | "joints";
/** The meaning of a colour: `a` and `b` are the first and the second of two, `ruledOut` decided nothing. */
export type DrawMeaning =
  | "a" | "b" | "fixed" | "touched" | "moving" | "touching" | "asleep" | "trigger" | "contact" | "normal" | "gap"
  | "ruledOut" | "bounds" | "path" | "ghost" | "joint";
/** A renderer of yours. Places are three numbers in the world, of the plane with 0 as the third; a method that is not
 * there draws nothing. An exception of a method is thrown by the function that draws. */
export interface Renderer {
  /** The layers that are drawn; by default all. */
  layers?: DrawLayer[];
  /** The point that is looked at, the origin by default; things without an end are drawn as far as `size` around it. */
  center?: Vec3Like;
  size?: number;
  point?(at: number[], layer: DrawLayer, meaning: DrawMeaning): void;
  line?(from: number[], to: number[], layer: DrawLayer, meaning: DrawMeaning): void;
  /** A triangle, counter-clockwise seen from outside. */
  triangle?(a: number[], b: number[], c: number[], layer: DrawLayer, meaning: DrawMeaning): void;
  text?(at: number[], words: string, layer: DrawLayer, meaning: DrawMeaning): void;
  /** A direction of unit length at a place; without it, lines as long as a twelfth of `size`. */
  arrow?(from: number[], direction: number[], layer: DrawLayer, meaning: DrawMeaning): void;
}
/** A point of contact as far as it is drawn; the weight is a half by default. */
export interface DrawnContact {
  readonly a: ArrayLike<number>;
  readonly b: ArrayLike<number>;
  readonly weight?: number;
}
/** Drawing of the library's objects and answers through a renderer. Not in graze/queries. */
export const draw: {
  shape(shape: Shape, pose: PoseLike, renderer: Renderer, meaning?: DrawMeaning): void;
  /** A box by its edges. */
  bounds(box: Aabb, renderer: Renderer): void;
  /** The boxes of a tree, as `BroadPhase.parts` has them, in the layer of trees. */
  tree(boxes: readonly Aabb[], renderer: Renderer): void;
  /** A joint of bodies at these poses: from either origin to its anchor, and how far these are apart. */
  joint(
    joint: { readonly frameA?: PoseLike; readonly frameB?: PoseLike }, poseA: PoseLike, poseB: PoseLike,
    renderer: Renderer): void;
  distance(distance: Pick<Distance, "a" | "b">, renderer: Renderer): void;
  /** A manifold: its points, each between `a` and `b` by its weight, and its normal from their middle. */
  contacts(manifold: { readonly normal: Vec3Like; readonly points: readonly DrawnContact[] }, renderer: Renderer): void;
  /** A ray up to its hit, and the normal there; one that hits nothing as far as its length or the renderer's size. */
  ray(ray: Ray, hit: Pick<RayHit, "t" | "point" | "normal"> | null, renderer: Renderer): void;
  /** A moving body, up to its hit or for the duration: its path, places along it, the last, and the hit. */
  cast(
    moving: Moving, hit: Pick<CastHit, "t" | "point" | "normal"> | null, renderer: Renderer,
    options?: { duration?: number }): void;
  /** Bodies, bounds, the tree, and the contacts of the last update. */
  world(world: WorldQueries, renderer: Renderer): void;
  /** A simulation: its world with sleeping bodies marked, and joints. */
  simulation(simulation: SimulationQueries, renderer: Renderer): void;
  /** One body of a world or a simulation as the drawing of the whole has it, with its bounds. The time grows with the pairs
   * of the last update. */
  body(owner: WorldQueries | SimulationQueries, id: BodyId, renderer: Renderer): void;
  /** The area of a renderer that shows all of a world. */
  area(world: WorldQueries): { center: number[]; size: number };
  /** The colour that the project's own pictures give a meaning: red, green and blue, 0 to 255. */
  color(meaning: DrawMeaning): [number, number, number];
  /** What a query did, whole or in part: what is absent is not drawn. `step` is one step of it, counted as in
   *  `explained`. */
  trace(trace: DrawnTrace, renderer: Renderer, options?: { readonly step?: number }): void;
  /** One of the trace's spans, counted from 0: the stretch of the query's ray that meets this condition on the points of a
   * convex shape; the one that is the trace's winner with its name and its normal. */
  span(trace: DrawnTrace, span: number, ray: Ray, renderer: Renderer): void;
  /** Asks, draws what the question did, or one step of it (axes, iterations of GJK, expansions of EPA, cuts, counted from
   *  0 in this order), and answers. */
  explained(renderer: Renderer, options?: { readonly step?: number }): Explained;
};
export interface DrawnSupport {
  readonly a: ArrayLike<number>;
  readonly b: ArrayLike<number>;
}
/** The parts of a `Trace` that are drawn, also from elsewhere. Places of the plane may have two numbers. */
export interface DrawnTrace {
  readonly winner?: string;
  readonly axes?: readonly {
    readonly name: string;
    readonly direction: ArrayLike<number>;
    readonly a: ArrayLike<number>;
    readonly b: ArrayLike<number>;
  }[];
  readonly gjk?: readonly {
    readonly simplex: readonly DrawnSupport[];
    /** Zero where the simplex holds the origin: nothing was looked for and found. */
    readonly direction: ArrayLike<number>;
    readonly found?: DrawnSupport;
    readonly polygon?: readonly DrawnSupport[];
  }[];
  readonly epa?: readonly {
    readonly normal: ArrayLike<number>;
    readonly faceDepth: number;
    readonly found?: DrawnSupport;
    readonly polygon?: readonly DrawnSupport[];
  }[];
  readonly spans?: readonly {
    readonly name: string;
    readonly normal: ArrayLike<number>;
    readonly enter: number;
    readonly leave: number;
  }[];
  readonly difference?: readonly DrawnSupport[];
  readonly polytope?: readonly DrawnSupport[];
  readonly triangles?: readonly ArrayLike<number>[];
  readonly faceA?: readonly ArrayLike<number>[];
  readonly faceB?: readonly ArrayLike<number>[];
  readonly cuts?: readonly {
    readonly from: ArrayLike<number>;
    readonly to: ArrayLike<number>;
    readonly left: readonly ArrayLike<number>[];
  }[];
}
export interface Explained {
  overlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): boolean;
  distance(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Distance;
  contacts(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin?: number): Contacts;
  closest(shape: Shape, pose: PoseLike, point: Vec3Like): Closest;
  raycast(shape: Shape, pose: PoseLike, ray: Ray, options?: RayOptions): RayHit | null;
  cast(a: Moving, b: Moving, options?: CastOptions): CastHit | null;
}

// --- The response to a blow ---

export interface StruckContact {
  readonly point: Vec3Like;
  /** A unit vector from A to B. */
  readonly normal: Vec3Like;
  /** The restitution; default 0. */
  readonly restitution?: number;
  /** The friction; default 0.6. */
  readonly friction?: number;
}
export interface StruckBody {
  /** The mass; Infinity for a body that does not move. */
  readonly mass: number;
  /** The diagonal of the inertia in the frame `rotation`, or the tensor by rows; absent: that of `shape`, which is then
   * needed unless the mass is infinite. */
  readonly inertia?: Vec3Like | Mat3;
  readonly shape?: Shape;
  /** The place of the centre of mass. */
  readonly translation?: Vec3Like;
  readonly rotation?: ArrayLike<number>;
  readonly linear?: Vec3Like;
  readonly angular?: Vec3Like;
}
export interface Motion {
  linear: Vec3;
  angular: Vec3;
  center: Vec3;
}
/** The quantities of a blow in the order in which they are computed. */
export interface Response {
  approach: Vec3;
  approachAlongNormal: number;
  approachTangential: Vec3;
  atFault: "neither" | "a" | "b" | "both";
  effectiveMass: number;
  normalImpulse: number;
  sliding: Vec3;
  stoppingImpulse: Vec3;
  frictionLimit: number;
  frictionImpulse: Vec3;
  /** The impulse on B; that on A is its opposite. */
  impulse: Vec3;
  a: Motion;
  b: Motion;
}
export function response(contact: StruckContact, a: StruckBody, b: StruckBody): Response;
/** The motion of a body after `impulse` at `point`. */
export function applyImpulse(body: StruckBody, impulse: Vec3Like, point: Vec3Like): Motion;
/** Points of two bodies that share a normal, struck together. */
export interface Blow {
  /** Places among the bodies. */
  readonly a: number;
  readonly b: number;
  /** A unit vector from a to b. */
  readonly normal: Vec3Like;
  readonly points: readonly Vec3Like[];
  /** The restitution from 0 to 1; default 0. */
  readonly restitution?: number;
}
/** The end of passing on: until none approaches faster than `restingSpeed` (0), or `most` (1000) were struck. */
export interface PassOnOptions {
  readonly restingSpeed?: number;
  readonly most?: number;
}
/** The result of passing on: the number of blows struck, and the fastest approach that is left. */
export interface PassedOn {
  struck: number;
  approach: number;
  /** The impulses at the points of each blow. */
  impulses: number[][];
  bodies: Motion[];
}
/** The motion of bodies that touch each other while one of them is struck, as in a cradle. */
export function passOn(bodies: readonly StruckBody[], blows: readonly Blow[], options?: PassOnOptions): PassedOn;
/** A body that nothing touches. Its frame has the principal axes of inertia, about the centre of mass. */
export interface FreeBody {
  center: Vec3;
  rotation: Quat;
  linear: Vec3;
  /** The angular momentum in the world. */
  angularMomentum: Vec3;
  inverseInertia: Vec3;
}
/** A free body with `inertia` about the axes of `rotation`; infinite where the body does not turn. */
export function freeBody(
  body: PoseLike & { readonly inertia: Vec3Like; readonly linear?: Vec3Like; readonly angular?: Vec3Like }): FreeBody;
/** The body after `duration`, of either sign, under a constant acceleration. */
export function advance(body: FreeBody, duration: number, acceleration?: Vec3Like): FreeBody;
export function angularVelocity(body: FreeBody): Vec3;

// --- Broad phases ---

export type BroadPhaseKind =
  | "dynamicTree" | "sortAndSweep" | "sweepAndPrune" | "hashedGrid" | "looseOctree" | "bsp";
export class BroadPhase extends Handle {
  constructor(kind?: BroadPhaseKind);
  readonly kind: BroadPhaseKind;
  insert(id: number, lower: Vec3Like, upper: Vec3Like): void;
  move(id: number, lower: Vec3Like, upper: Vec3Like): void;
  remove(id: number): void;
  /** All overlapping pairs, sorted: two ids each. A copy. */
  pairs(): Uint32Array;
  /** The overlapping pairs of which one box was inserted or moved since the last call. */
  movedPairs(): Uint32Array;
  query(lower: Vec3Like, upper: Vec3Like): Uint32Array;
  sweep(lower: Vec3Like, upper: Vec3Like, motion: Vec3Like): Uint32Array;
  /**
   * The structure as it is now, parents before their children: bounds of nodes, or cells, with their depth below the
   * root. Sorted axes have none.
   */
  parts(): (Aabb & { depth: number })[];
  /**
   * The numbers of boxes, of pairs that the last `pairs` or `movedPairs` found, and of comparisons that it made; and
   * the bytes held.
   */
  counts(): { boxes: number; pairs: number; tests: number; memory: number };
}
/** Changes of overlapping pairs from call to call, for data that is kept for each pair. Boxes are inserted, moved and
 * removed as in a `BroadPhase`. */
export class PairChanges extends Handle {
  constructor(kind?: BroadPhaseKind);
  readonly kind: BroadPhaseKind;
  insert(id: number, lower: Vec3Like, upper: Vec3Like): void;
  move(id: number, lower: Vec3Like, upper: Vec3Like): void;
  remove(id: number): void;
  /** The pairs that overlap and did not at the last call, and those that did and do not any more: two ids each. */
  find(): { begun: Uint32Array; ended: Uint32Array };
}

// --- Worlds ---

export interface BodyId {
  readonly index: number;
  readonly generation: number;
}
export interface Filter {
  /** Bits, as numbers up to 2^53 or bigints. Default 1, all, 0. */
  readonly category?: number | bigint;
  readonly mask?: number | bigint;
  readonly group?: number;
}
export interface QueryFilter extends Filter {
  readonly triggers?: boolean;
  readonly accept?: (body: BodyId) => boolean;
}
export interface Body extends PoseLike {
  readonly shape: Shape;
  readonly linear?: Vec3Like;
  readonly angular?: Vec3Like;
  readonly filter?: Filter;
  readonly fixed?: boolean;
  readonly trigger?: boolean;
  /** Whether the world finds what the body would pass through before the next update. */
  readonly fast?: boolean;
}
export interface WorldSettings {
  /** Contacts are reported up to this far apart; default: `contactMargin` of the two. */
  readonly margin?: number;
  readonly pointsPerPair?: number;
  /** Decides last on a pair that its filters allow. */
  readonly allow?: (a: BodyId, b: BodyId) => boolean;
  readonly capture?: Capture;
}
/** Gets all changes of a world or a simulation, a frame at a call: one behind the other they are the capture that
 * `replay` plays. Its exceptions are thrown by the call that ended the frame. Things that a file cannot hold are
 * refused: functions (`allow`, a UserConvex), and `reduce`. A captured simulation has at most 16 states at a time. Not
 * in graze/queries. */
export type Capture = (bytes: Uint8Array) => void;
export interface SolverPoint extends ContactPoint {
  impulse: Vec3;
}
export interface WorldManifold {
  normal: Vec3;
  pieceA: number;
  pieceB: number;
  points: SolverPoint[];
}
export interface WorldPair {
  /** Indices of bodies, a < b. */
  a: number;
  b: number;
  overlap: boolean;
  manifolds: WorldManifold[];
}
export interface ContactEvent {
  kind: "begin" | "stay" | "end";
  trigger: boolean;
  a: BodyId;
  b: BodyId;
  /** The place among the pairs; -1 at an end. */
  pair: number;
}
export interface Impact {
  a: BodyId;
  b: BodyId;
  trigger: boolean;
  hit: CastHit;
}
/** Bodies, the pairs that touch, and queries of them. */
export interface WorldQueries {
  readonly size: number;
  contains(id: BodyId): boolean;
  /** The handle of the body that has the index, or null. */
  bodyAt(index: number): BodyId | null;
  pose(id: BodyId): Pose;
  /** The body as it is now, with a share of its shape, to be disposed of. */
  body(id: BodyId): Required<Body>;
  /** A share of the body's shape, to be disposed of. */
  shape(id: BodyId): Shape;
  /** All poses by index, seven numbers each, without a copy: valid until the next call. To be read
   * alone: bodies are moved by `move`, which keeps the tree of their bounds in step. */
  poses(): Scalars;
  /** The name of the body in a replay, otherwise empty. */
  name(id: BodyId): string;
  contacts(): WorldPair[];
  /** Points of all pairs, without a copy: members a, b, distance, weight, impulse. */
  points(): Rows<SolverPoint>;
  events(): ContactEvent[];
  impacts(): Impact[];
  overlapping(shape: Shape, pose: PoseLike, filter?: QueryFilter): BodyId[];
  overlapsAny(shape: Shape, pose: PoseLike, filter?: QueryFilter): boolean;
  nearest(
    shape: Shape, pose: PoseLike, most: number,
    options?: QueryFilter & { limit?: number }): { body: BodyId; distance: Distance }[];
  raycast(ray: Ray, options?: QueryFilter & RayOptions): { body: BodyId; hit: RayHit } | null;
  raycastAny(ray: Ray, options?: QueryFilter & RayOptions): boolean;
  raycastAll(ray: Ray, options?: QueryFilter & RayOptions): { body: BodyId; hit: RayHit }[];
  cast(moving: Moving, options?: QueryFilter & CastOptions): { body: BodyId; hit: CastHit } | null;
  castAll(moving: Moving, options?: QueryFilter & CastOptions): { body: BodyId; hit: CastHit }[];
  /** Moves a shape by `motion` until it touches, then along the surface, by at most `casts` casts; default 6. */
  slide(
    shape: Shape, pose: PoseLike, motion: Vec3Like,
    options?: QueryFilter & { casts?: number }): {
      end: Pose; left: Vec3; touched: { body: BodyId; hit: CastHit }[] };
  memory(): number;
}
export class World extends Handle implements WorldQueries {
  body(id: BodyId): Required<Body>;
  shape(id: BodyId): Shape;
  constructor(settings?: WorldSettings);
  add(body: Body): BodyId;
  remove(id: BodyId): void;
  move(id: BodyId, pose: PoseLike, velocity?: { linear?: Vec3Like; angular?: Vec3Like }): void;
  /** Moves bodies to poses of seven numbers, with velocities of six, linear and angular, or the ones they have. Where
   * one is refused none is moved. */
  moveBatch(ids: readonly BodyId[], poses: Numbers | ArrayLike<number>, velocities?: Numbers | ArrayLike<number>): void;
  setShape(id: BodyId, shape: Shape): void;
  setFilter(id: BodyId, filter: Filter): void;
  /** Replaces the final decision on pairs of the settings; undefined allows all. */
  setAllow(allow: ((a: BodyId, b: BodyId) => boolean) | undefined): void;
  setFast(id: BodyId, fast: boolean): void;
  /** Sets the name of the body in a replay of the capture; without a capture it is not kept. */
  setName(id: BodyId, name: string): void;
  /** Finds the pairs that touch now, and the bodies that fast ones would pass through in `duration`. */
  update(duration?: number): void;
  findImpacts(duration: number): void;
  reduce(most: number): void;
  readonly size: number;
  contains(id: BodyId): boolean;
  bodyAt(index: number): BodyId | null;
  pose(id: BodyId): Pose;
  poses(): Scalars;
  /** The name of the body in a replay, otherwise empty. */
  name(id: BodyId): string;
  contacts(): WorldPair[];
  points(): Rows<SolverPoint>;
  events(): ContactEvent[];
  impacts(): Impact[];
  overlapping(shape: Shape, pose: PoseLike, filter?: QueryFilter): BodyId[];
  overlapsAny(shape: Shape, pose: PoseLike, filter?: QueryFilter): boolean;
  nearest(
    shape: Shape, pose: PoseLike, most: number,
    options?: QueryFilter & { limit?: number }): { body: BodyId; distance: Distance }[];
  raycast(ray: Ray, options?: QueryFilter & RayOptions): { body: BodyId; hit: RayHit } | null;
  raycastAny(ray: Ray, options?: QueryFilter & RayOptions): boolean;
  raycastAll(ray: Ray, options?: QueryFilter & RayOptions): { body: BodyId; hit: RayHit }[];
  cast(moving: Moving, options?: QueryFilter & CastOptions): { body: BodyId; hit: CastHit } | null;
  castAll(moving: Moving, options?: QueryFilter & CastOptions): { body: BodyId; hit: CastHit }[];
  slide(
    shape: Shape, pose: PoseLike, motion: Vec3Like,
    options?: QueryFilter & { casts?: number }): {
      end: Pose; left: Vec3; touched: { body: BodyId; hit: CastHit }[] };
  memory(): number;
}

// --- Simulation (not in graze/queries) ---

export interface SimulationSettings {
  readonly capture?: Capture;
  readonly gravity?: Vec3Like;
  readonly subSteps?: number;
  readonly mostSubSteps?: number;
  readonly sleep?: boolean;
  readonly continuous?: boolean;
  /** Sub-steps begin with the impulses of the last one; without it stacks sink and lean. */
  readonly warmStart?: boolean;
  readonly longestStep?: number;
}
export interface Dynamics {
  /** The mass; absent: from the shape and `density`. */
  readonly mass?: number;
  readonly centerOfMass?: Vec3Like;
  readonly inertiaDiagonal?: Vec3Like;
  readonly inertiaOrientation?: ArrayLike<number>;
  readonly density?: number;
  readonly gravityFactor?: number;
  readonly linearDamping?: number;
  readonly angularDamping?: number;
  readonly kinematic?: boolean;
  readonly maySleep?: boolean;
}
export type Combine = "unset" | "average" | "minimum" | "maximum" | "multiply";
export interface Material {
  readonly staticFriction?: number;
  readonly dynamicFriction?: number;
  readonly restitution?: number;
  readonly rollingFriction?: number;
  readonly frictionCombine?: Combine;
  readonly restitutionCombine?: Combine;
  readonly surfaceVelocity?: Vec3Like;
}
export interface JointId {
  readonly index: number;
  readonly generation: number;
}
export interface JointLimit {
  readonly space: "linear" | "angular";
  readonly axes: readonly ("x" | "y" | "z")[];
  /** The bounds; default none. Equal: held. */
  readonly min?: number;
  readonly max?: number;
  /** The stiffness; 0: hard. */
  readonly stiffness?: number;
  readonly damping?: number;
}
export interface JointDrive {
  readonly space: "linear" | "angular";
  readonly axis: "x" | "y" | "z";
  readonly mode?: "force" | "acceleration";
  readonly positionTarget?: number;
  readonly velocityTarget?: number;
  readonly stiffness?: number;
  readonly damping?: number;
  readonly maxForce?: number;
}
export interface Joint {
  readonly a: BodyId;
  readonly b: BodyId;
  readonly frameA?: PoseLike;
  readonly frameB?: PoseLike;
  /** The limits of a joint with a name: hinge and slider about and along x, and `distance`, which keeps the origins of the
   * frames from `min` to `max` apart. `limits` come on top. */
  readonly kind?: "fixed" | "ball" | "hinge" | "slider" | "distance";
  /** The bounds of a distance, default 0 and none, or of a slider along x, default none. */
  readonly min?: number;
  readonly max?: number;
  readonly limits?: readonly JointLimit[];
  readonly drives?: readonly JointDrive[];
  readonly enableCollision?: boolean;
}
export interface StepReport {
  awake: number;
  islands: number;
  contacts: number;
  colors: number;
  mostSubSteps: number;
  stopped: number;
  deepest: number;
  meanDepth: number;
  residual: number;
  kineticEnergy: number;
  potentialEnergy: number;
  momentum: Vec3;
  angularMomentum: Vec3;
  /** The time by the clock, in milliseconds. */
  collideMs: number;
  prepareMs: number;
  solveMs: number;
  continuousMs: number;
  wholeMs: number;
}
/** Bodies that move, and queries of them; also in a replay. */
export interface SimulationQueries {
  pose(id: BodyId): Pose;
  /** All poses by index, seven numbers each, without a copy: valid until the next call. To be read
   * alone: bodies are moved by `move`, which keeps the tree of their bounds in step. */
  poses(): Scalars;
  /** The velocity of the centre of mass, the turning about it, and its place. */
  motion(id: BodyId): Motion;
  mass(id: BodyId): number;
  /** The angular momentum about the centre of mass. */
  angularMomentum(id: BodyId): Vec3;
  asleep(id: BodyId): boolean;
  /** The sub-steps of the body's island in the last step; 0 before its first. */
  subSteps(id: BodyId): number;
  joints(): JointId[];
  /** A joint as it was added; the limits of a `kind` among its `limits`. */
  joint(id: JointId): Joint;
  jointImpulses(id: JointId): number[];
  /** The settings as they are now, with the gravity that was set last. */
  settings(): SimulationSettings & { readonly gravity: Vec3 };
  report(): StepReport;
  /** Contacts, events and queries. It belongs to the simulation. */
  readonly world: WorldQueries;
  /** A hash of all bits that the next step depends on: equal runs have equal hashes, also after `restore`. */
  stateHash(): bigint;
}
/** The state of a simulation, to go back to. */
export class State extends Handle {
  private constructor();
  /** The state whose `bytes` these are; throws InvalidValue for others, and for those of the other scalar. */
  static fromBytes(bytes: Uint8Array | ArrayBuffer): State;
  /** The state as bytes, for a file or another computer; throws InvalidValue for one of a captured simulation. */
  bytes(): Uint8Array;
}
export interface Simulation extends SimulationQueries {}
export class Simulation extends Handle {
  constructor(settings?: SimulationSettings);
  add(body: Body, dynamics?: Dynamics, material?: Material): BodyId;
  remove(id: BodyId): void;
  addJoint(joint: Joint): JointId;
  /** Replaces the frames, limits and drives of a joint of the same bodies from the next step on, as of a motor that gets
   * another target. Its bodies wake. */
  setJoint(id: JointId, joint: Joint): void;
  removeJoint(id: JointId): void;
  step(dt: number): void;
  applyImpulse(id: BodyId, impulse: Vec3Like, point: Vec3Like): void;
  applyAngularImpulse(id: BodyId, impulse: Vec3Like): void;
  applyForce(id: BodyId, force: Vec3Like): void;
  applyTorque(id: BodyId, torque: Vec3Like): void;
  setVelocity(id: BodyId, velocity: { linear?: Vec3Like; angular?: Vec3Like }): void;
  setPose(id: BodyId, pose: PoseLike): void;
  moveTo(id: BodyId, pose: PoseLike, dt: number): void;
  /** Replaces the filter of a body from the next step on. What it touches wakes. */
  setFilter(id: BodyId, filter: Filter): void;
  setMaterial(id: BodyId, material: Material): void;
  /** Gives the pieces of the body's shape materials of their own from now on: `ofPiece[i]` is the place among `materials`
   * of that of piece i, a child of a compound or a triangle of a mesh or a height field (two for each cell, holes
   * included). A point of contact has the material of the piece whose surface is nearest to it, at the cost of a search
   * of the pieces in each step. */
  setMaterials(id: BodyId, materials: readonly Material[], ofPiece: ArrayLike<number>): void;
  setGravity(gravity: Vec3Like): void;
  /** Sets the name of the body in a replay of the capture; without a capture it is not kept. */
  setName(id: BodyId, name: string): void;
  wake(id: BodyId): void;
  save(): State;
  /** Goes back, or on from a state of another simulation with the same bodies and joints, added in the same order. */
  restore(state: State): void;
}

// --- The plane (not in graze/queries) ---

export type Vec2 = [x: number, y: number];
export declare namespace plane {
  /** The rotation is an angle. */
  interface PoseLike {
    readonly translation?: ArrayLike<number>;
    readonly rotation?: number;
  }
  interface Pose {
    translation: Vec2;
    rotation: number;
  }
  type ShapeKind =
    | "circle" | "capsule" | "box" | "segment" | "convex" | "ellipse" | "userConvex" | "halfPlane" | "polygon" | "chain"
    | "compound";
  /** The measures of a shape by its kind, as in space. Polygons, chains and compounds are not `convex`, whatever their
   * corners. */
  type ShapeMeasures = { readonly convex: boolean } & (
    | { readonly kind: "circle"; readonly radius: number }
    | { readonly kind: "capsule"; readonly height: number; readonly radiusBottom: number; readonly radiusTop: number }
    | { readonly kind: "box"; readonly size: Vec2 }
    | { readonly kind: "ellipse"; readonly radii: Vec2 }
    /** `closed`: it goes on from its last point to the first. */
    | { readonly kind: "chain"; readonly closed: boolean; readonly sides: Sides }
    | { readonly kind: "compound"; readonly children: number }
    | { readonly kind: "segment" | "convex" | "userConvex" | "halfPlane" | "polygon" });
  class Shape extends Handle {
    protected constructor();
    readonly kind: ShapeKind;
    readonly rounding: number;
    /** The measures that the shape was made of, in constant time. */
    measures(): ShapeMeasures;
    /** A copy of the vertices of a convex polygon, the corners of a polygon or a chain without those on straight lines, or
     * the ends of a segment, two numbers each. Throws `InvalidValue` for other kinds, as `children` does. */
    points(): Scalars;
    /** The children of a compound and their poses; each shape is a share, to be disposed of. */
    children(): (Pose & { shape: Shape })[];
    bounds(pose?: PoseLike): { lower: Vec2; upper: Vec2 };
    /** Area, centre and inertia at density one, about `center`; area 0 of a shape without one. */
    massProperties(): { area: number; center: Vec2; inertia: number };
    /** The point of a bounded convex shape furthest along `direction`, in the shape's frame. */
    support(direction: ArrayLike<number>): Vec2;
    /** The Minkowski sum with a disc of that radius, beside the present rounding; of a compound each child grows. */
    rounded(rounding: number): Shape;
    /** The region that a bounded convex shape sweeps while it moves by `motion` without turning. */
    swept(pose: PoseLike, motion: ArrayLike<number>): Shape;
  }
  class Circle extends Shape {
    constructor(radius: number);
  }
  class Capsule extends Shape {
    constructor(height: number, radiusBottom: number, radiusTop?: number);
  }
  class Box extends Shape {
    constructor(size: ArrayLike<number>);
  }
  class Segment extends Shape {
    constructor(a: ArrayLike<number>, b: ArrayLike<number>);
  }
  class Convex extends Shape {
    constructor(points: Points);
  }
  class Ellipse extends Shape {
    constructor(radii: ArrayLike<number>);
  }
  /** A convex shape of your own: `support` returns a point furthest along a direction, which is not zero. */
  class UserConvex extends Shape {
    constructor(support: (direction: Vec2) => ArrayLike<number>);
  }
  /** The half-plane y <= 0. */
  class HalfPlane extends Shape {
    constructor();
  }
  /** A solid polygon, convex or not. */
  class Polygon extends Shape {
    constructor(points: Points);
  }
  class Chain extends Shape {
    constructor(points: Points, options?: { closed?: boolean; sides?: Sides });
  }
  class Compound extends Shape {
    constructor(children: readonly (PoseLike & { readonly shape: Shape })[]);
  }
  interface Distance {
    distance: number;
    normal: Vec2;
    a: Vec2;
    b: Vec2;
    certainty: Certainty;
    error: number;
  }
  interface PieceDistance {
    pieceA: number;
    pieceB: number;
    distance: Distance;
  }
  interface Closest {
    distance: number;
    point: Vec2;
    normal: Vec2;
    certainty: Certainty;
    error: number;
  }
  interface ContactPoint {
    a: Vec2;
    b: Vec2;
    distance: number;
    feature: number;
    weight: number;
  }
  interface Contacts {
    overlap: boolean;
    certainty: Certainty;
    error: number;
    manifolds: { normal: Vec2; pieceA: number; pieceB: number; points: ContactPoint[] }[];
  }
  interface Ray {
    readonly origin: ArrayLike<number>;
    readonly direction: ArrayLike<number>;
    readonly length?: number;
  }
  interface RayHit {
    t: number;
    point: Vec2;
    normal: Vec2;
    piece: number;
    certainty: Certainty;
  }
  interface Moving extends PoseLike {
    readonly shape: Shape;
    readonly linear?: ArrayLike<number>;
    readonly angular?: number;
  }
  interface CastHit {
    t: number;
    point: Vec2;
    normal: Vec2;
    depth: number;
    certainty: Certainty;
    pieceA: number;
    pieceB: number;
  }
  /** `Bodies` of the plane, with four numbers for a pose: its place, and the cosine and sine of its rotation. */
  interface Bodies {
    readonly shapes: Shape | readonly Shape[];
    readonly poses?: Numbers | ArrayLike<number>;
    readonly translations?: Numbers | ArrayLike<number>;
    readonly rotations?: Numbers | ArrayLike<number>;
  }
  function overlapBatch(a: Bodies, b: Bodies, places?: Places): Uint8Array;
  function distanceBatch(a: Bodies, b: Bodies, places?: Places): Batch<Distance>;
  function contactsBatch(
    a: Bodies, b: Bodies, margin?: number, places?: Places, most?: number): Pick<Contacts, "overlap" | "manifolds">[];
  function closestBatch(shape: Shape, pose: PoseLike, points: Numbers | Points): Batch<Closest>;
  /** Casts rays of four numbers: origin and direction. */
  function raycastBatch(
    shape: Shape, pose: PoseLike, rays: Numbers | ArrayLike<number>,
    options?: { length?: number }): Batch<RayHit> & { readonly found: Uint8Array };
  function castBatch(
    a: readonly Moving[], b: readonly Moving[], options?: CastOptions): Batch<CastHit> & { readonly found: Uint8Array };
  /** The near pieces of each pair. */
  function nearPiecesBatch(a: Bodies, b: Bodies, margin: number, places?: Places): PieceDistance[][];
  interface StruckBody {
    /** The mass; Infinity for a body that does not move. */
    readonly mass: number;
    /** The inertia; absent: that of `shape`, and without one the body does not turn. */
    readonly inertia?: number;
    readonly shape?: Shape;
    /** The place of the centre of mass. */
    readonly translation?: ArrayLike<number>;
    readonly linear?: ArrayLike<number>;
    readonly angular?: number;
  }
  interface Motion {
    linear: Vec2;
    angular: number;
    center: Vec2;
  }
  interface Blow {
    readonly a: number;
    readonly b: number;
    readonly normal: ArrayLike<number>;
    readonly points: readonly ArrayLike<number>[];
    readonly restitution?: number;
  }
  function applyImpulse(body: StruckBody, impulse: ArrayLike<number>, point: ArrayLike<number>): Motion;
  function passOn(
    bodies: readonly StruckBody[], blows: readonly Blow[],
    options?: PassOnOptions): Omit<PassedOn, "bodies"> & { bodies: Motion[] };
  interface FreeBody {
    center: Vec2;
    /** The cosine and sine of the angle. */
    rotation: Vec2;
    linear: Vec2;
    angularMomentum: number;
    inverseInertia: number;
  }
  function freeBody(
    body: PoseLike & { readonly inertia: number; readonly linear?: ArrayLike<number>; readonly angular?: number }): FreeBody;
  function advance(body: FreeBody, duration: number, acceleration?: ArrayLike<number>): FreeBody;
  function angularVelocity(body: FreeBody): number;
  interface Body extends PoseLike {
    readonly shape: Shape;
    readonly linear?: ArrayLike<number>;
    /** The velocity of turning, counter-clockwise, in radians per unit of time. */
    readonly angular?: number;
    readonly filter?: Filter;
    readonly fixed?: boolean;
    readonly trigger?: boolean;
    readonly fast?: boolean;
  }
  interface SolverPoint extends ContactPoint {
    impulse: Vec2;
  }
  interface WorldPair {
    /** Indices of bodies, a < b. */
    a: number;
    b: number;
    overlap: boolean;
    manifolds: { normal: Vec2; pieceA: number; pieceB: number; points: SolverPoint[] }[];
  }
  interface Impact {
    a: BodyId;
    b: BodyId;
    trigger: boolean;
    hit: CastHit;
  }
  /** Bodies, the pairs that touch, and queries of them, as in space. */
  interface WorldQueries {
    readonly size: number;
    contains(id: BodyId): boolean;
    bodyAt(index: number): BodyId | null;
    pose(id: BodyId): Pose;
    /** The body as it is now, with a share of its shape, to be disposed of. */
    body(id: BodyId): Required<Body>;
    /** A share of the body's shape, to be disposed of. */
    shape(id: BodyId): Shape;
    /** All poses by index, four numbers each: place, and turned X axis. No copy: valid until the next call. */
    poses(): Scalars;
    /** The name of the body in a replay, otherwise empty. */
    name(id: BodyId): string;
    contacts(): WorldPair[];
    points(): Rows<SolverPoint>;
    events(): ContactEvent[];
    impacts(): Impact[];
    overlapping(shape: Shape, pose: PoseLike, filter?: QueryFilter): BodyId[];
    overlapsAny(shape: Shape, pose: PoseLike, filter?: QueryFilter): boolean;
    nearest(
      shape: Shape, pose: PoseLike, most: number,
      options?: QueryFilter & { limit?: number }): { body: BodyId; distance: Distance }[];
    raycast(ray: Ray, filter?: QueryFilter): { body: BodyId; hit: RayHit } | null;
    raycastAny(ray: Ray, filter?: QueryFilter): boolean;
    raycastAll(ray: Ray, filter?: QueryFilter): { body: BodyId; hit: RayHit }[];
    cast(moving: Moving, options?: QueryFilter & CastOptions): { body: BodyId; hit: CastHit } | null;
    castAll(moving: Moving, options?: QueryFilter & CastOptions): { body: BodyId; hit: CastHit }[];
    /** Moves a shape by `motion` until it touches, then along the outline, by at most `casts` casts; default 6. */
    slide(
      shape: Shape, pose: PoseLike, motion: ArrayLike<number>,
      options?: QueryFilter & { casts?: number }): {
        end: Pose; left: Vec2; touched: { body: BodyId; hit: CastHit }[] };
    memory(): number;
  }
  interface World extends WorldQueries {}
  class World extends Handle {
    constructor(settings?: WorldSettings);
    add(body: Body): BodyId;
    remove(id: BodyId): void;
    move(id: BodyId, pose: PoseLike, velocity?: { linear?: ArrayLike<number>; angular?: number }): void;
    /** Moves bodies to poses of four numbers, as `poses` has them, with velocities of three, linear and angular, or the
     * ones they have. Where one is refused none is moved. */
    moveBatch(ids: readonly BodyId[], poses: Numbers | ArrayLike<number>, velocities?: Numbers | ArrayLike<number>): void;
    setShape(id: BodyId, shape: Shape): void;
    setFilter(id: BodyId, filter: Filter): void;
    setAllow(allow: ((a: BodyId, b: BodyId) => boolean) | undefined): void;
    setFast(id: BodyId, fast: boolean): void;
    /** Sets the name of the body in a replay of the capture; without a capture it is not kept. */
    setName(id: BodyId, name: string): void;
    /** Finds the pairs that touch now, and the bodies that fast ones would pass through in `duration`. */
    update(duration?: number): void;
    findImpacts(duration: number): void;
    reduce(most: number): void;
  }
  interface SimulationSettings {
    readonly capture?: Capture;
    readonly gravity?: ArrayLike<number>;
    readonly subSteps?: number;
    readonly mostSubSteps?: number;
    readonly sleep?: boolean;
    readonly continuous?: boolean;
    /** Sub-steps begin with the impulses of the last one; without it stacks sink and lean. */
    readonly warmStart?: boolean;
    readonly longestStep?: number;
  }
  interface Dynamics {
    /** The mass; absent: from the shape and `density`, a mass per area. */
    readonly mass?: number;
    readonly centerOfMass?: ArrayLike<number>;
    /** The inertia about the centre of mass. */
    readonly inertia?: number;
    readonly density?: number;
    readonly gravityFactor?: number;
    readonly linearDamping?: number;
    readonly angularDamping?: number;
    readonly kinematic?: boolean;
    readonly maySleep?: boolean;
  }
  interface Material {
    readonly staticFriction?: number;
    readonly dynamicFriction?: number;
    readonly restitution?: number;
    readonly rollingFriction?: number;
    readonly frictionCombine?: Combine;
    readonly restitutionCombine?: Combine;
    readonly surfaceVelocity?: ArrayLike<number>;
  }
  /** Frames move along x and y and turn about z: limits and drives name those axes. */
  interface Joint {
    readonly a: BodyId;
    readonly b: BodyId;
    readonly frameA?: PoseLike;
    readonly frameB?: PoseLike;
    /** The limits of a joint with a name; a ball is a hinge, a slider goes along x, and `distance` keeps the origins of the
     * frames from `min` to `max` apart. `limits` come on top. */
    readonly kind?: "fixed" | "ball" | "hinge" | "slider" | "distance";
    readonly min?: number;
    readonly max?: number;
    readonly limits?: readonly JointLimit[];
    readonly drives?: readonly JointDrive[];
    readonly enableCollision?: boolean;
  }
  interface StepReport {
    awake: number;
    islands: number;
    contacts: number;
    colors: number;
    mostSubSteps: number;
    stopped: number;
    deepest: number;
    meanDepth: number;
    residual: number;
    kineticEnergy: number;
    potentialEnergy: number;
    momentum: Vec2;
    angularMomentum: number;
    /** The time by the clock, in milliseconds. */
    collideMs: number;
    prepareMs: number;
    solveMs: number;
    continuousMs: number;
    wholeMs: number;
  }
  /** Bodies that move, and queries of them; also in a replay. */
  interface SimulationQueries {
    pose(id: BodyId): Pose;
    /** All poses by index, in the form of a world's. */
    poses(): Scalars;
    /** The velocity of the centre of mass, the turning about it, and its place. */
    motion(id: BodyId): { linear: Vec2; angular: number; center: Vec2 };
    mass(id: BodyId): number;
    /** The angular momentum about the centre of mass. */
    angularMomentum(id: BodyId): number;
    asleep(id: BodyId): boolean;
    /** The sub-steps of the body's island in the last step; 0 before its first. */
    subSteps(id: BodyId): number;
    joints(): JointId[];
    /** A joint as it was added; the limits of a `kind` among its `limits`. */
    joint(id: JointId): Joint;
    jointImpulses(id: JointId): number[];
    /** The settings as they are now, with the gravity that was set last. */
    settings(): SimulationSettings & { readonly gravity: Vec2 };
    report(): StepReport;
    /** Contacts, events and queries. It belongs to the simulation. */
    readonly world: WorldQueries;
    /** A hash of all bits that the next step depends on: equal runs have equal hashes, also after `restore`. */
    stateHash(): bigint;
  }
  /** The state of a simulation, to go back to. */
  class State extends Handle {
    private constructor();
    static fromBytes(bytes: Uint8Array | ArrayBuffer): State;
    bytes(): Uint8Array;
  }
  interface Simulation extends SimulationQueries {}
  class Simulation extends Handle {
    constructor(settings?: SimulationSettings);
    add(body: Body, dynamics?: Dynamics, material?: Material): BodyId;
    remove(id: BodyId): void;
    addJoint(joint: Joint): JointId;
    /** Replaces the frames, limits and drives of a joint of the same bodies, as in space. */
    setJoint(id: JointId, joint: Joint): void;
    removeJoint(id: JointId): void;
    step(dt: number): void;
    applyImpulse(id: BodyId, impulse: ArrayLike<number>, point: ArrayLike<number>): void;
    applyAngularImpulse(id: BodyId, impulse: number): void;
    applyForce(id: BodyId, force: ArrayLike<number>): void;
    applyTorque(id: BodyId, torque: number): void;
    setVelocity(id: BodyId, velocity: { linear?: ArrayLike<number>; angular?: number }): void;
    setPose(id: BodyId, pose: PoseLike): void;
    moveTo(id: BodyId, pose: PoseLike, dt: number): void;
    setFilter(id: BodyId, filter: Filter): void;
    setMaterial(id: BodyId, material: Material): void;
    /** Gives the pieces of the body's shape materials of their own from now on, as in space: children of a compound,
     * segments of a chain. */
    setMaterials(id: BodyId, materials: readonly Material[], ofPiece: ArrayLike<number>): void;
    setGravity(gravity: ArrayLike<number>): void;
    /** Sets the name of the body in a replay of the capture; without a capture it is not kept. */
    setName(id: BodyId, name: string): void;
    wake(id: BodyId): void;
    save(): State;
    restore(state: State): void;
  }
  function overlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): boolean;
  function distance(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Distance;
  /** The distance of shapes no further apart than `limit`, else null. */
  function distanceUpTo(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, limit: number): Distance | null;
  function within(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, limit: number): boolean;
  /** The pairs of convex pieces within `margin`: children, pieces of a polygon, segments of a chain. */
  function nearPieces(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin: number): PieceDistance[];
  /** The part of a motion that lines leave, as `alongPlanes`. */
  function alongLines(motion: ArrayLike<number>, normals: Points): Vec2;
  /** The outline of a shape: points have three numbers, the last of which is 0. */
  function tessellate(
    shape: Shape, pose: PoseLike, options?: { readonly center?: ArrayLike<number>; readonly size?: number }): Polygons;
  function contacts(
    a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin?: number, most?: number): Contacts;
  function contactMargin(a: Shape, b: Shape): number;
  /** The corners of a feature as in space: one of a vertex, two of an edge. */
  function featureCorners(shape: Shape, feature: number, piece?: number): Vec2[];
  function closest(shape: Shape, pose: PoseLike, point: ArrayLike<number>): Closest;
  function raycast(shape: Shape, pose: PoseLike, ray: Ray): RayHit | null;
  function raycastAny(shape: Shape, pose: PoseLike, ray: Ray): boolean;
  function raycastAll(shape: Shape, pose: PoseLike, ray: Ray): RayHit[];
  function cast(a: Moving, b: Moving, options?: CastOptions): CastHit | null;
  function castAll(a: Moving, b: Moving, options?: CastOptions): CastHit[];
  function poseAt(moving: Omit<Moving, "shape">, t: number): Pose;
  /** Poses of the plane, as in space; angles of answers are from -pi to pi. */
  function compose(a: PoseLike, b: PoseLike): Pose;
  function inverse(pose: PoseLike): Pose;
  function relative(a: PoseLike, b: PoseLike): Pose;
  function transform(pose: PoseLike, point: ArrayLike<number>): Vec2;
  function inverseTransform(pose: PoseLike, point: ArrayLike<number>): Vec2;
  /** A shape of the plane as a question of the protocol has it. Throws `InvalidValue` for a UserConvex. */
  function protocolShape(shape: Shape): ProtocolShape;
  /** The shape that a question of the protocol describes. graze/double alone. */
  function shapeOfProtocol(words: ProtocolShape): Shape;
  const traced: {
    overlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Traced<boolean>;
    distance(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Traced<Distance>;
    contacts(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin?: number): Traced<Contacts>;
    closest(shape: Shape, pose: PoseLike, point: ArrayLike<number>): Traced<Closest>;
    raycast(shape: Shape, pose: PoseLike, ray: Ray): Traced<RayHit | null>;
    cast(a: Moving, b: Moving, options?: CastOptions): Traced<CastHit | null>;
  };
  const draw: {
    shape(shape: Shape, pose: PoseLike, renderer: Renderer, meaning?: DrawMeaning): void;
    distance(distance: Pick<Distance, "a" | "b">, renderer: Renderer): void;
    contacts(
      manifold: { readonly normal: ArrayLike<number>; readonly points: readonly DrawnContact[] }, renderer: Renderer): void;
    ray(ray: Ray, hit: Pick<RayHit, "t" | "point" | "normal"> | null, renderer: Renderer): void;
    cast(
      moving: Moving, hit: Pick<CastHit, "t" | "point" | "normal"> | null, renderer: Renderer,
      options?: { duration?: number }): void;
    joint(
      joint: { readonly frameA?: PoseLike; readonly frameB?: PoseLike }, poseA: PoseLike, poseB: PoseLike,
      renderer: Renderer): void;
    trace(trace: DrawnTrace, renderer: Renderer, options?: { readonly step?: number }): void;
    span(trace: DrawnTrace, span: number, ray: Ray, renderer: Renderer): void;
    explained(renderer: Renderer, options?: { readonly step?: number }): Explained;
    world(world: WorldQueries, renderer: Renderer): void;
    simulation(simulation: SimulationQueries, renderer: Renderer): void;
    body(owner: WorldQueries | SimulationQueries, id: BodyId, renderer: Renderer): void;
    /** The centre and the size of all bounded bodies. */
    area(world: WorldQueries): { center: number[]; size: number };
  };
  interface Explained {
    overlap(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): boolean;
    distance(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike): Distance;
    contacts(a: Shape, poseA: PoseLike, b: Shape, poseB: PoseLike, margin?: number): Contacts;
    closest(shape: Shape, pose: PoseLike, point: ArrayLike<number>): Closest;
    raycast(shape: Shape, pose: PoseLike, ray: Ray): RayHit | null;
    cast(a: Moving, b: Moving, options?: CastOptions): CastHit | null;
  }
}

// --- Captures ---

/** The kind of a capture, and the scalar of the entry in which `replay` plays it. Throws `InvalidValue` for bytes that
 * do not begin as a capture does. Not in graze/queries. */
export function captureHead(bytes: ArrayBuffer | ArrayBufferView): {
  /** Whether it is of a simulation, or of a world. */
  simulation: boolean;
  plane: boolean;
  scalar: "float" | "double";
};
/** The result of a replay. */
export interface ReplayReport {
  simulation: boolean;
  plane: boolean;
  /** Whether the bytes end within a frame, which was left out. */
  cut: boolean;
  /** The number of frames and calls with the same results. */
  frames: number;
  calls: number;
  /** The first result that differs from the run that was captured; frames and calls are counted from 1. */
  difference: { frame: number; call: number; what: string } | null;
}
/** Plays a capture again, as `graze capture` or a program in C++ wrote it, in the scalar of this entry. `each` gets the
 * world after every frame, whether it is one of the plane, and the simulation where it is the world of one; both can be
 * queried until the function returns. Not in graze/queries. */
export function replay(
  bytes: ArrayBuffer | ArrayBufferView,
  each?: (
    world: WorldQueries | plane.WorldQueries, frame: number, plane: boolean,
    simulation: SimulationQueries | plane.SimulationQueries | null) => void): ReplayReport;

// --- The query protocol (graze/double alone) ---

/** The answer to one line of the query protocol, as `graze query` writes it, without the end of the line. */
export function query(line: string): string;
/** The answer with its trace, whatever the question says. */
export function explain(line: string): string;

/** A scene of the plane as `graze collide` and `graze simulate` read it as JSON (docs/plane.md). Y points up. */
export interface PlaneScene {
  dimension: 2;
  gravity?: Vec2;
  bodies: {
    name?: string;
    shape: ProtocolShape;
    translation?: Vec2;
    rotation?: number;
    /** Shapes of the same body move as one. */
    body?: string;
    /** The motion; absent: fixed. */
    motion?: "kinematic" | "dynamic";
    trigger?: boolean;
    systems?: string[];
    collideWith?: string[];
    notCollideWith?: string[];
    linear?: Vec2;
    angular?: number;
    mass?: number;
    inertia?: number;
    gravityFactor?: number;
    friction?: number;
    restitution?: number;
  }[];
}
/** The members of an element of a DOM that are read: a browser's has all of them but the line, for messages. */
export interface DrawnElement {
  readonly localName: string;
  readonly line?: number;
  readonly attributes: Iterable<{ readonly name: string; readonly value: string }>;
  readonly children: Iterable<DrawnElement>;
}
/** The scene that an `<svg>` element draws, read as `graze collide` reads a drawing. Throws `InvalidValue` that names
 * the element. graze/double alone. */
export function planeScene(svg: DrawnElement): PlaneScene;
/** The mesh of an OBJ, PLY (text or binary) or STL file (text or binary), with the triangles that `graze collide` reads:
 * polygons are cut into triangles, points at one place are one. Throws `InvalidValue` that names the line or the place
 * in the file. graze/double alone. Cost n log n. */
export function meshOfFile(bytes: Uint8Array, format: "obj" | "ply" | "stl"): Shape;
