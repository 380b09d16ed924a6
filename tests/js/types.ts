// The package as TypeScript sees it: each exported name of index.d.ts once, in a program that is checked strictly and then
// runs. What is declared for the answers is what they are annotated with here; calls that must be refused say so.

import {
  advance, alongPlanes, angularVelocity, applyImpulse, Box, BroadPhase, Capsule, captureHead, cast, castAll, castBatch, closest,
  closestBatch, compactContactsBatch, compose, Compound, contactMargin, contacts, contactsBatch, ConvexHull, Cylinder, distance,
  distanceBatch, distanceUpTo, draw, Ellipsoid, explain, featureCorners, freeBody, HalfSpace, Handle, HeightField, hullLayers,
  init, InvalidValue, inverse, inverseTransform, mayOverlap, memoryInUse, Mesh, meshOfFile, nearPieces, nearPiecesBatch, Numbers, overlap, overlapBatch,
  PairChanges, passOn, plane, planeScene, poseAt, protocolShape, query, raycast, raycastAll, raycastAny, raycastBatch, Rectangle,
  relative, replay, response, Segment, Shape, shapeOfProtocol, Simulation, Sphere, State, tessellate, traced, transform, Triangle, turned, UserConvex, version, within, World,
} from "graze/double";
import type {
  Aabb, Batch, Blow, Bodies, Body, BodyId, BroadPhaseKind, Capture, CastHit, CastOptions, Certainty, Child, Closest, Combine,
  CompactManifold, CompactPoint, ContactEvent, ContactPoint, Contacts, Distance, DrawLayer, DrawMeaning, DrawnContact,
  DrawnElement, DrawnSupport, DrawnTrace, Dynamics, Explained, Filter, FreeBody, HullLayer, Impact, Joint, JointDrive, JointId,
  JointLimit, Manifold, MassProperties, Mat3, Material, MeshFindings, ModuleSource, Motion, Moving, PairContacts, PassedOn,
  PassOnOptions, PieceDistance, Places, PlaneScene, Points, Polygons, Pose, PoseLike, ProtocolShape, Quat, QueryFilter, Ray,
  RayHit, RayOptions, Renderer, ReplayReport, Response, Rows, Scalars, ShapeKind, ShapeMeasures, Sides, SimulationQueries, SimulationSettings, SolverPoint,
  StepReport, StruckBody, StruckContact, SupportTrace, Trace, TraceAxis, TraceCut, Traced, TraceEpa, TraceGjk, TraceSpan,
  TraceStep, TraceSupport, Vec2, Vec3, Vec3Like, WorldManifold, WorldPair, WorldQueries, WorldSettings,
} from "graze/double";
import * as whole from "graze";
import * as small from "graze/queries";

function expect(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Error(what);
}
function given<T>(value: T | null | undefined, what: string): T {
  if (value === null || value === undefined) throw new Error(what);
  return value;
}
/** Called with what the types refuse; the library refuses it, too. */
function refused(call: () => unknown): void {
  try {
    call();
  } catch (error) {
    expect(error instanceof InvalidValue || error instanceof TypeError, String(error));
    return;
  }
  throw new Error(`not refused: ${call}`);
}

const source: ModuleSource | undefined = undefined;
await init(source);
expect(/^\d/.test(version()), "a version");
const before: number = memoryInUse();
const given_back: Handle[] = [];
function kept<T extends Handle>(handle: T): T {
  given_back.push(handle);
  return handle;
}

// Shapes.
const corners: Points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const sides: Sides = "both";
const ball: Shape = kept(new Sphere(0.5, [0, 0, 0]));
const box: Shape = kept(new Box([2, 2, 2]));
const hull = kept(new ConvexHull(corners));
const mesh = kept(new Mesh(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], { sides, solid: true }));
const floor = kept(new HalfSpace());
const user = kept(new UserConvex((direction: Vec3): Vec3Like => direction.map(Math.sign)));
const child: Child = { shape: ball, translation: [0, 1, 0] };
const kinds: ShapeKind[] = [
  kept(new Capsule(1, 0.25)), kept(new Rectangle(1, 2)), kept(new Cylinder(1, 0.5)), kept(new Ellipsoid([1, 0.5, 0.25])),
  kept(new Segment([0, 0, 0], [1, 0, 0])), kept(new Triangle([0, 0, 0], [1, 0, 0], [0, 1, 0])), user,
  kept(new HeightField([0, 0.25, 0.5, 0, 0, null], 3, 2, { spacing: [1, 1] })), kept(new Compound([child])),
  kept(ball.rounded(0.25)), kept(box.swept({}, [1, 0, 0])),
].map((shape: Shape) => shape.kind);
expect(kinds.length === 11, "kinds");
const findings: MeshFindings = mesh.findings();
const mass: MassProperties = box.massProperties();
const inertia: Mat3 = mass.inertia;
const bounds: Aabb = box.bounds();
const upper: Vec3 = bounds.upper;
expect(findings.triangles === 4 && inertia[0][0] > 0 && upper[1] >= 1, "what is known of shapes");
const made: ShapeMeasures = box.measures();
const size: Vec3 | null = made.kind === "box" ? made.size : null;
// @ts-expect-error a box has no radius
expect(made.kind !== "box" || made.radius === undefined, "a box");
const cornersOf: Scalars = mesh.points();
const trianglesOf: Uint32Array = mesh.triangles();
const parted = kept(new Compound([child])).children().map(({ shape, translation }) => [kept(shape).kind, translation[1]]);
const heightsOf: Scalars = kept(new HeightField([0, 0, 0, 0], 2, 2)).heights();
expect(size?.[1] === 2 && cornersOf.length + trianglesOf.length + heightsOf.length === 28, "what shapes are made of");
expect(parted.join() === "sphere,1", "children");
// @ts-expect-error a size has three numbers
refused(() => new Box(2));
// @ts-expect-error a shape is made by one of its classes
refused(() => new Shape());

// Questions.
const here: PoseLike = {};
const there: Pose = turned([1.4, 0, 0], [0, 1, 0], 0.5);
const rotation: Quat = there.rotation;
const seen: Pose = relative(there, compose(there, { translation: [0, 1, 0] }));
const back: Vec3 = inverseTransform(there, transform(there, [1, 2, 3]));
expect(Math.abs(seen.translation[1] - 1) + Math.abs(back[2] - 3) < 1e-9 && inverse(there).translation.length === 3, "poses");
const touch: boolean = overlap(box, here, ball, there) && mayOverlap(box, here, ball, there) && within(box, here, ball, there, 1);
const apart: Distance = distance(box, here, ball, there);
const certainty: Certainty = apart.certainty;
expect(touch && rotation.length === 4 && certainty === "converged" && apart.distance < 0, "the ball is in the box");
expect(distanceUpTo(box, here, ball, { translation: [9, 0, 0] }, 1) === null, "further than the limit");
// @ts-expect-error null where the shapes are further apart
expect(distanceUpTo(box, here, ball, there, 1).distance < 0, "near");
const pieces: PieceDistance[] = nearPieces(box, here, ball, there, 1);
const found: Contacts = contacts(box, here, ball, there, 0, 4);
const manifold: Manifold = given(found.manifolds[0], "a manifold");
const point: ContactPoint = given(manifold.points[0], "a point");
const named: Vec3[] = featureCorners(box, point.feature >>> 16);
const nearest: Closest = closest(box, here, [0, 3, 0]);
const left: Vec3 = alongPlanes([1, -1, 0], [[0, 1, 0]]);
const faces: Polygons = tessellate(box, here, { center: [0, 0, 0], size: 2 });
expect(left[0] === 1 && faces.loops.length === 6, "what is left of a motion, and faces");
expect(pieces.length === 1 && named.length <= 4 && nearest.distance === 2 && contactMargin(box, ball) > 0, "answers");
const ray: Ray = { origin: [-3, 0, 0], direction: [1, 0, 0], length: 10 };
const rayOptions: RayOptions = { backFaces: "ignored" };
const hit: RayHit = given(raycast(box, here, ray, rayOptions), "a hit");
expect(hit.t === 2 && raycastAny(box, here, ray) && raycastAll(box, here, ray).length === 1, "rays");
const moving: Moving = { shape: ball, translation: [-4, 0, 0], linear: [4, 0, 0] };
const castOptions: CastOptions = { duration: 2, separating: "hit" };
const met: CastHit = given(cast({ shape: box }, moving, castOptions), "a meeting");
expect(met.t > 0 && castAll({ shape: box }, moving, castOptions).length === 1, "casts");
const at: Pose = poseAt(moving, met.t);
expect(at.translation[0] > -4, "it has moved");

// Many at a time.
const numbers = kept(new Numbers(14));
const scalars: Scalars = numbers.array;
scalars.set([0, 0, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0, 0, 1]);
const many: Bodies = { shapes: box, poses: numbers };
const places: Places = [0, 0, 0, 1];
expect(overlapBatch(many, many, places).join() === "1,0", "one of two touches");
const distances: Batch<Distance> = distanceBatch(many, many, places);
const rows: Rows<Distance> = distances;
expect(rows.at(1).distance === 3 && [...distances].length === 2, "rows");
const compact = compactContactsBatch(many, many, 0, places);
const compactManifolds: Rows<CompactManifold> = compact.manifolds;
const compactPoints: Rows<CompactPoint> = compact.points;
expect(compactManifolds.at(0).pair === 0 && compactPoints.at(0).distance === -2, "in few bytes");
const together: PairContacts[] = contactsBatch(many, many, 0, places, 4);
const piecesOf: PieceDistance[][] = nearPiecesBatch(many, many, 9, places);
const closestOnes: Batch<Closest> = closestBatch(box, here, [[0, 3, 0], [0, 4, 0]]);
const hits = raycastBatch(box, here, [-3, 0, 0, 1, 0, 0], rayOptions);
const meetings = castBatch([{ shape: box }], [moving], castOptions);
expect(together.length === 2 && piecesOf.length === 2 && closestOnes.length === 2, "as many answers as questions");
expect(hits.found[0] === 1 && meetings.found[0] === 1, "found");
for (const batch of [distances, closestOnes, hits, meetings]) batch.dispose();

// What a question did.
const explained: Traced<Distance> = traced.distance(hull, here, ball, there);
const trace: Trace = explained.trace;
const simplices: TraceGjk[] = trace.gjk;
const expansions: TraceEpa[] = trace.epa;
const supports: TraceSupport[] = trace.difference;
const axes: TraceAxis[] = traced.overlap(box, here, box, there).trace.axes;
const cuts: TraceCut[] = traced.contacts(box, here, box, { translation: [0, 1.9, 0] }).trace.cuts;
const spans: TraceSpan[] = traced.raycast(box, here, ray).trace.spans;
const steps: TraceStep[] = traced.cast({ shape: box }, moving, castOptions).trace.steps;
expect(axes.length > 0 && spans.length > 0 && steps.length >= 0, "what the questions did");
expect(simplices.length + expansions.length + supports.length + cuts.length > 0, "how they were answered");
const support: SupportTrace = traced.support(hull, [1, 0, 0]).trace;
const layers: HullLayer[] = hullLayers(hull).layers;
expect(support.layers.length === layers.length, "a layer for each");

// The protocol.
const words: ProtocolShape = protocolShape(box);
kept(shapeOfProtocol(words));
expect(query('{"query": "overlap", "a": {"shape": {"type": "box"}}, "b": {"shape": {"type": "box"}}}') === '{"overlap":true}', "query");
expect(explain('{"query": "overlap", "a": {"shape": {"type": "box"}}, "b": {"shape": {"type": "box"}}}').includes("trace"), "explain");
const drawing: DrawnElement = {
  localName: "svg", attributes: [],
  children: [{ localName: "circle", attributes: [{ name: "r", value: "1" }], children: [] }] };
const scene: PlaneScene = planeScene(drawing);
expect(scene.bodies.length === 1, "a circle");
kept(meshOfFile(new TextEncoder().encode("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "obj"));

// Worlds.
const kind: BroadPhaseKind = "sortAndSweep";
const broad = kept(new BroadPhase(kind));
broad.insert(3, [0, 0, 0], [1, 1, 1]);
expect(broad.query([0, 0, 0], [2, 2, 2]).join() === "3", "a box is found");
const changes = kept(new PairChanges(kind));
changes.insert(3, [0, 0, 0], [1, 1, 1]);
const { begun, ended }: { begun: Uint32Array; ended: Uint32Array } = changes.find();
expect(begun.length + ended.length === 0, "a box alone");
const filter: Filter = { category: 1, mask: 0xffn };
const body: Body = { shape: ball, translation: [0, 0.4, 0], filter };
const settings: WorldSettings = { margin: 0.1, pointsPerPair: 4, allow: (a: BodyId, b: BodyId) => a.index !== b.index };
const world = kept(new World(settings));
const ground: BodyId = world.add({ shape: floor, fixed: true });
const resting: BodyId = world.add(body);
world.setAllow((a: BodyId, b: BodyId) => a.index !== b.index);
world.update();
const asked: WorldQueries = world;
const pairs: WorldPair[] = asked.contacts();
const manifolds: WorldManifold[] = given(pairs[0], "a pair").manifolds;
const solved: SolverPoint = given(manifolds[0]?.points[0], "a point");
const events: ContactEvent[] = asked.events();
const impacts: Impact[] = asked.impacts();
const questions: QueryFilter = { triggers: true, accept: (id: BodyId) => id.index === resting.index };
const slid: Vec3 = asked.slide(ball, { translation: [5, 2, 0] }, [0, -1, 0], { casts: 2 }).end.translation;
expect(slid[1] === 1, "a slide");
expect(solved.impulse[1] === 0 && events[0]?.kind === "begin" && impacts.length === 0, "what touches");
expect(asked.overlapping(box, here, questions).length === 1 && asked.contains(ground), "what is there");
// @ts-expect-error a handle, not an index
refused(() => world.remove(0));

// What a blow does.
const struck: StruckBody = { mass: 1, shape: ball, linear: [0, -1, 0] };
const wall: StruckBody = { mass: Infinity };
const tilted: StruckBody = { mass: 1, inertia: [[2, 0.5, 0], [0.5, 2, 0], [0, 0, 1]] };
expect(applyImpulse(tilted, [0, 0, 1], [0, 0, 0]).angular[2] === 0, "a tensor");
const struckAt: StruckContact = { point: [0, -0.5, 0], normal: [0, 1, 0], restitution: 1 };
const bounced: Response = response(struckAt, wall, struck);
const motion: Motion = applyImpulse(struck, [0, 2, 0], [0, 0, 0]);
const blow: Blow = { a: 0, b: 1, normal: [0, 1, 0], points: [[0, -0.5, 0]], restitution: 1 };
const passOnOptions: PassOnOptions = { restingSpeed: 0, most: 10 };
const passed: PassedOn = passOn([wall, struck], [blow], passOnOptions);
expect(bounced.normalImpulse > 0 && motion.linear[1] === 1 && passed.struck === 1, "blows");
const free: FreeBody = advance(freeBody({ inertia: [1, 2, 3], angular: [0, 1, 0] }), 0.1, [0, -9.81, 0]);
expect(angularVelocity(free)[1] === 1 && free.linear[1] < 0, "free motion");

// Simulation.
const parts: Uint8Array[] = [];
const capture: Capture = (bytes) => parts.push(bytes);
const simulationSettings: SimulationSettings = { gravity: [0, -10, 0], capture };
const simulation = kept(new Simulation(simulationSettings));
const combine: Combine = "average";
const dynamics: Dynamics = { mass: 2 };
const material: Material = { staticFriction: 0.5, frictionCombine: combine };
const [first, second] = [0, 2].map((x) => simulation.add({ shape: ball, translation: [x, 3, 0] }, dynamics, material));
const limit: JointLimit = { space: "linear", axes: ["x"], min: 0, max: 3 };
const drive: JointDrive = { space: "linear", axis: "x", velocityTarget: 1 };
const joint: Joint = { a: given(first, "a"), b: given(second, "b"), limits: [limit], drives: [drive] };
const id: JointId = simulation.addJoint(joint);
const state: State = kept(simulation.save());
const unwritten: Simulation = kept(new Simulation());
const written: Uint8Array = kept(unwritten.save()).bytes();
unwritten.restore(kept(State.fromBytes(written)));
simulation.step(1 / 60);
const report: StepReport = simulation.report();
expect(report.awake === 2 && simulation.jointImpulses(id).length > 0, "a step");
const known: Joint = simulation.joint(given(simulation.joints()[0], "a joint"));
const set: SimulationSettings = simulation.settings();
const pull: Vec3 = simulation.settings().gravity;
expect(set.sleep === true && pull[1] === -10, "settings");
const hash: bigint = simulation.stateHash();
const subSteps: number = simulation.subSteps(joint.a);
const spin: Vec3 = simulation.angularMomentum(joint.a);
expect(known.limits?.length === 1 && hash >= 0n && subSteps > 0 && spin.length === 3, "what is known of a simulation");
simulation.restore(state);
const rope: Joint = { a: joint.a, b: joint.b, kind: "distance", max: 3 };
const tied: JointId = simulation.addJoint(rope);
simulation.setJoint(tied, { ...rope, max: 4 });
simulation.setFilter(joint.a, { category: 2n });
simulation.removeJoint(tied);
const played: ReplayReport = replay(parts.reduce((all, bytes) => new Uint8Array([...all, ...bytes])), (world, _, __, simulation: SimulationQueries | plane.SimulationQueries | null) => {
  const energy: number | undefined = simulation?.report().kineticEnergy, { filter } = world.body(world.bodyAt(0)!);
  return [energy, filter.mask];
});
expect(played.difference === null && captureHead(given(parts[0], "a head")).simulation, "the run again");

// Debug draw.
const layer: DrawLayer = "contacts";
const meanings: DrawMeaning[] = [];
const renderer: Renderer = { layers: [layer, "shapes", "distances"], line: (_from, _to, _layer, meaning) => meanings.push(meaning) };
const drawn: DrawnContact = { a: [0, 0, 0], b: [0, 1, 0] };
draw.contacts({ normal: [0, 1, 0], points: [drawn] }, renderer);
draw.shape(box, here, renderer);
draw.body(world, resting, renderer);
const spanned: DrawnTrace = traced.raycast(box, here, ray).trace;
draw.span(spanned, 0, ray, renderer);
const asking: Explained = draw.explained(renderer);
expect(asking.overlap(box, here, ball, there) && meanings.length > 0 && draw.color("a").length === 3, "lines");
const supported: DrawnSupport = { a: [0, 0, 0], b: [0, 1, 0] };
const searched: DrawnTrace = { gjk: [{ simplex: [supported], direction: [0, -1, 0], found: supported }], difference: [supported] };
draw.trace(searched, renderer, { step: 0 });

// The plane.
const flat: Vec2 = [2, 2];
const square: plane.Shape = kept(new plane.Box(flat));
const disk = kept(new plane.Circle(0.5));
const outline: Points = [[0, 0], [1, 0], [0, 1]];
const planeChild: plane.PoseLike & { shape: plane.Shape } = { shape: disk };
const planeKinds: plane.ShapeKind[] = [
  kept(new plane.Capsule(1, 0.25)), kept(new plane.Segment([0, 0], [1, 0])), kept(new plane.Convex(outline)),
  kept(new plane.Ellipse([1, 2])), kept(new plane.HalfPlane()), kept(new plane.Polygon(outline)), kept(new plane.Chain(outline)),
  kept(new plane.Compound([planeChild])), kept(new plane.UserConvex((direction: Vec2) => direction.map(Math.sign))),
].map((shape: plane.Shape) => shape.kind);
expect(planeKinds.length === 9, "kinds of the plane");
const planeMade: plane.ShapeMeasures = square.measures();
const planeSize: Vec2 | null = planeMade.kind === "box" ? planeMade.size : null;
const planeParts = kept(new plane.Compound([planeChild])).children().map(({ shape, rotation }) => [kept(shape).kind, rotation]);
expect(planeSize?.[0] === 2 && planeParts.join() === "circle,0", "what shapes of the plane are made of");
const planeCorners: Scalars = kept(new plane.Polygon(outline)).points();
expect(planeCorners.length === 6, "corners");
const beside: plane.Pose = { translation: [1.4, 0], rotation: 0.5 };
const planeSeen: plane.Pose = plane.relative(beside, plane.compose(beside, plane.inverse(beside)));
const planeBack: Vec2 = plane.inverseTransform(beside, plane.transform(beside, [1, 2]));
expect(Math.abs(planeSeen.rotation + 0.5) + Math.abs(planeBack[1] - 2) < 1e-9, "poses of the plane");
const planeApart: plane.Distance = plane.distance(square, {}, disk, beside);
const planeFound: plane.Contacts = plane.contacts(square, {}, disk, beside, 0, 1);
const planePoint: plane.ContactPoint = given(planeFound.manifolds[0]?.points[0], "a point");
const planeNearest: plane.Closest = plane.closest(square, {}, [0, 3]);
const planeRay: plane.Ray = { origin: [-3, 0], direction: [1, 0] };
const planeHit: plane.RayHit = given(plane.raycast(square, {}, planeRay), "a hit");
const planeMoving: plane.Moving = { shape: disk, translation: [-4, 0], linear: [4, 0] };
const planeMet: plane.CastHit = given(plane.cast({ shape: square }, planeMoving, castOptions), "a meeting");
expect(planeApart.distance < 0 && planePoint.distance < 0 && planeNearest.distance === 2, "answers of the plane");
expect(planeHit.t === 2 && planeMet.t > 0 && plane.overlap(square, {}, disk, beside), "hits of the plane");
expect(plane.raycastAny(square, {}, planeRay) && plane.raycastAll(square, {}, planeRay).length === 1, "rays of the plane");
expect(plane.castAll({ shape: square }, planeMoving, castOptions).length === 1, "casts of the plane");
expect(plane.poseAt(planeMoving, 1).translation[0] === 0 && plane.contactMargin(square, disk) > 0, "poses of the plane");
const planePieces: plane.PieceDistance[] = plane.nearPieces(square, {}, disk, beside, 1);
const planeNear: plane.Distance | null = plane.distanceUpTo(square, {}, disk, beside, 1);
const planeLeft: Vec2 = plane.alongLines([1, -1], [[0, 1]]);
const planeOutline: Polygons = plane.tessellate(square, beside);
const planeWay: plane.Shape = kept(disk.swept({}, [1, 0]));
const planeTip: Vec2 = square.support([1, 1]);
expect(plane.within(square, {}, disk, beside, 0) && planePieces.length === 1 && planeNear !== null, "near in the plane");
expect(planeLeft[0] === 1 && planeOutline.loops.length === 1 && planeWay.kind === "segment" && planeTip[0] === 1, "its words");
expect(plane.featureCorners(square, planePoint.feature >>> 16).length > 0, "corners of the plane");
const planeMany: plane.Bodies = { shapes: square, poses: [0, 0, 1, 0, 5, 0, 1, 0] };
expect(plane.overlapBatch(planeMany, planeMany, places).join() === "1,0", "a batch of the plane");
expect(plane.contactsBatch(planeMany, planeMany, 0, places, 1).length === 2, "contacts of the plane");
const planePiecesOf: plane.PieceDistance[][] = plane.nearPiecesBatch(planeMany, planeMany, 9, places);
expect(planePiecesOf.map((pieces) => pieces[0]?.distance.distance).join() === "-2,3", "near pieces of the plane");
const planeBatches = [
  plane.distanceBatch(planeMany, planeMany, places), plane.closestBatch(square, {}, [[0, 3]]),
  plane.raycastBatch(square, {}, [-3, 0, 1, 0]), plane.castBatch([{ shape: square }], [planeMoving], castOptions)];
for (const batch of planeBatches) batch.dispose();
const planeTrace: Trace = plane.traced.distance(square, {}, disk, beside).trace;
const planeWords: ProtocolShape = plane.protocolShape(square);
kept(plane.shapeOfProtocol(planeWords));
expect(planeTrace.method !== "", "how the plane was asked");
const planeBody: plane.Body = { shape: disk, translation: [0, 3] };
const planeWorld = kept(new plane.World());
planeWorld.add(planeBody);
planeWorld.add({ shape: square });
planeWorld.update();
const planeAsked: plane.WorldQueries = planeWorld;
const planePairs: plane.WorldPair[] = planeAsked.contacts();
const planePoints: Rows<plane.SolverPoint> = planeAsked.points();
const planeImpacts: plane.Impact[] = planeAsked.impacts();
const planeSlid: Vec2 = planeAsked.slide(disk, { translation: [9, 9] }, [0, -1]).end.translation;
expect(planeSlid[1] === 8, "a slide in the plane");
expect(planePairs.length + planePoints.length + planeImpacts.length === 0, "nothing touches");
const planeStruck: plane.StruckBody = { mass: 1, shape: disk, linear: [0, -1] };
const planeMotion: plane.Motion = plane.applyImpulse(planeStruck, [0, 2], [0, 0]);
const planeBlow: plane.Blow = { a: 0, b: 1, normal: [0, 1], points: [[0, -0.5]] };
expect(plane.passOn([{ mass: Infinity }, planeStruck], [planeBlow]).struck === 1 && planeMotion.linear[1] === 1, "a blow");
const planeFree: plane.FreeBody = plane.advance(plane.freeBody({ inertia: 1, angular: 2 }), 0.1);
expect(plane.angularVelocity(planeFree) === 2, "free motion of the plane");
const planeSettings: plane.SimulationSettings = { gravity: [0, -10] };
const planeSimulation = kept(new plane.Simulation(planeSettings));
const planeDynamics: plane.Dynamics = { mass: 1 };
const planeMaterial: plane.Material = { restitution: 0.5 };
const falling: BodyId = planeSimulation.add(planeBody, planeDynamics, planeMaterial);
const hanging: BodyId = planeSimulation.add({ shape: disk, fixed: true });
const planeJoint: plane.Joint = { a: hanging, b: falling, kind: "ball" };
planeSimulation.setJoint(planeSimulation.addJoint(planeJoint), planeJoint);
planeSimulation.setFilter(falling, { category: 1n });
const planeState: plane.State = kept(plane.State.fromBytes(kept(planeSimulation.save()).bytes()));
planeSimulation.step(1 / 60);
const planeReport: plane.StepReport = planeSimulation.report();
const planeKnown: plane.Joint = planeSimulation.joint(given(planeSimulation.joints()[0], "a joint"));
const planeHash: bigint = planeSimulation.stateHash();
expect(planeKnown.a.index === hanging.index && planeHash >= 0n && planeSimulation.subSteps(falling) > 0, "what is known");
planeSimulation.restore(planeState);
expect(planeReport.awake === 1, "a step of the plane");
plane.draw.distance(planeApart, renderer);
plane.draw.body(planeSimulation, falling, renderer);
plane.draw.span(plane.traced.raycast(square, {}, planeRay).trace, 0, planeRay, renderer);
const planeAsking: plane.Explained = plane.draw.explained(renderer);
expect(planeAsking.overlap(square, {}, disk, beside), "a question of the plane, drawn");
// @ts-expect-error a shape of the plane is none of space
refused(() => overlap(box, here, disk, {}));

for (const handle of given_back.reverse()) handle.dispose();
// The module keeps tables and room for answers that its first calls make; what is left over for each call has tests of its own.
expect(memoryInUse() - before < 1 << 16, `what was made is given back, but ${memoryInUse() - before} bytes`);
