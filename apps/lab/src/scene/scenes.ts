// The scenes to choose from. Lengths in metres, masses in kilograms.

import { box, sphere, type Shape, type Vec } from "../question.ts";
import { turned, type Scene, type SceneBody, type SceneJoint } from "./model.ts";

const body = (name: string, shape: Shape, translation: Vec, more: Partial<SceneBody> = {}): SceneBody => ({
  name, shape, translation, rotation: turned, moves: true, ...more });
const joint = (kind: SceneJoint["kind"], a: number, b: number, at: Vec): SceneJoint => ({
  a, b, kind, frames: [{ translation: at, rotation: turned }, { translation: at, rotation: turned }] });
const floor = (size = 20): SceneBody => body("floor", box(size, 1, size), [0, -0.5, 0], { moves: false });
const about = (axis: Vec, angle: number): Vec => [...axis.map((x) => x * Math.sin(angle / 2)), Math.cos(angle / 2)];
const range = <T>(count: number, make: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => make(i));

function pyramid(base: number): SceneBody[] {
  const made: SceneBody[] = [];
  for (let row = 0; row < base; row++)
    for (let i = 0; i < base - row; i++) made.push(body(`box ${row}.${i}`, box(1, 1, 1), [(i - (base - row - 1) / 2) * 1.05, 0.5 + row, 0]));
  return made;
}
/** Boxes on each other, the one beside the other by up to `off` to either side. */
const tower = (count: number, off = 0): SceneBody[] => range(count, (i) =>
  body(`box ${i + 1}`, box(1, 1, 1), [off * (i % 2 ? 1 : -1), 0.5 + i, off * (i % 4 < 2 ? 1 : -1)]));
/** A light box and a heavy one on it, or on several: the boxes' masses are as one to `ratio`. */
const pressed = (ratio: number, light = 1): SceneBody[] => [floor(),
  ...range(light, (i) => body(light > 1 ? `light ${i + 1}` : "light", box(1, 1, 1), [0, 0.5 + i, 0], { mass: 1 })),
  body("heavy", box(1, 1, 1), [0, 0.5 + light, 0], { mass: ratio })];
/** A bowl of triangles, open above: half of a ball's surface about its middle. */
function bowl(radius: number, rings: number, sides: number): Shape {
  const points: Vec[] = [[0, -radius, 0]], triangles: number[][] = [], at = (ring: number, side: number): number => 1 + (ring - 1) * sides + (side % sides);
  for (let ring = 1; ring <= rings; ring++)
    for (let side = 0; side < sides; side++) {
      const down = (ring / rings) * (Math.PI / 2), turn = (2 * Math.PI * side) / sides;
      points.push([radius * Math.sin(down) * Math.cos(turn), -radius * Math.cos(down), radius * Math.sin(down) * Math.sin(turn)]);
      const [here, next] = [at(ring, side), at(ring, side + 1)];
      // Counter-clockwise as seen from within.
      if (ring === 1) triangles.push([0, next, here]);
      else triangles.push([at(ring - 1, side), at(ring - 1, side + 1), next], [at(ring - 1, side), next, here]);
    }
  return { type: "mesh", mesh: { points, triangles } };
}
/** Towers of five boxes, each of another size, from a millimetre to a hundred metres. */
function sizes(): SceneBody[] {
  const all = [0.001, 0.01, 0.1, 1, 10, 100];
  let x = 0;
  const made = all.flatMap((size, k) => {
    x += k === 0 ? 0 : 2 * (all[k - 1] + size);
    const at = x;
    return range(5, (i) => body(`${size} m, box ${i + 1}`, box(size, size, size), [at, size * (0.5 + i), 0]));
  });
  return [body("floor", { type: "plane" }, [0, 0, 0], { moves: false }), ...made];
}
/** A house of cards: two metres long, two centimetres thick, leaning by 25 degrees, in so many storeys. */
function cards(storeys: number): SceneBody[] {
  const long = 2, thick = 0.02, lean = 0.4363323129985824, c = Math.cos(lean), s = Math.sin(lean), high = 2 * (c + (thick / 2) * s);
  const made: SceneBody[] = [], material = { staticFriction: 0.7, dynamicFriction: 0.7 };
  const card = (at: Vec, angle: number): unknown =>
    made.push(body(`card ${made.length + 1}`, box(thick, long, 1), at, { rotation: about([0, 0, 1], angle), material }));
  for (let storey = storeys, level = 0; storey > 0; storey--, level += high + thick) {
    for (let i = 0; i < storey; i++)
      for (const side of [-1, 1]) card([(i - (storey - 1) / 2) * (long + 0.005) + side * (s + (thick / 2) * c), level + high / 2, 0], side * lean);
    for (let i = 0; i + 1 < storey; i++) card([(i - (storey - 2) / 2) * (long + 0.005), level + high + thick / 2, 0], Math.PI / 2);
  }
  return made;
}
/** A half circle of wedges on the floor, from 1.5 to 2.1 m about the middle. */
function arch(count: number): SceneBody[] {
  const rim = (angle: number, radius: number, z: number): Vec => [radius * Math.cos(angle), radius * Math.sin(angle), z];
  return range(count, (i) => {
    const from = (i * Math.PI) / count, to = ((i + 1) * Math.PI) / count, middle = rim((from + to) / 2, 1.8, 0);
    const points = [from, to].flatMap((angle) => [1.5, 2.1].flatMap((radius) => [-0.4, 0.4].map((z) => rim(angle, radius, z).map((x, k) => x - middle[k]))));
    return body(i === (count - 1) / 2 ? "keystone" : `wedge ${i + 1}`, { type: "convex", convex: { points } }, middle);
  });
}
function chain(links: number): Pick<Scene, "bodies" | "joints"> {
  const link: Shape = { type: "capsule", capsule: { height: 0.2, radiusBottom: 0.05, radiusTop: 0.05 } }, step = 0.25, top = 6;
  const bodies = [floor(), body("hook", box(0.3, 0.3, 0.3), [0, top, 0], { moves: false }),
    ...range(links, (i) => body(`link ${i + 1}`, link, [(i + 0.5) * step, top, 0], { rotation: about([0, 0, 1], Math.PI / 2), mass: 0.5 })),
    body("ball", sphere(0.4), [links * step + 0.4, top, 0], { mass: 50 })];
  return { bodies, joints: range(links + 1, (i) => joint("ball", i + 1, i + 2, [i * step, top, 0])) };
}
function bridge(planks: number): Pick<Scene, "bodies" | "joints"> {
  const step = 0.5, y = 2, x = (i: number): number => (i - planks / 2) * step;
  const bodies = [floor(), ...range(2, (i) => body(i ? "right post" : "left post", box(0.4, y, 1.4), [x(i * planks) + (i ? 0.2 : -0.2), y / 2, 0], { moves: false })),
    ...range(planks, (i) => body(`plank ${i + 1}`, box(step * 0.94, 0.08, 1.2), [x(i + 0.5), y, 0])), body("crate", box(0.6, 0.6, 0.6), [0.3, y + 0.5, 0])];
  const at = (i: number): number => (i === 0 ? 1 : i === planks + 1 ? 2 : i + 2);
  return { bodies, joints: range(planks + 1, (i) => joint("ball", at(i), at(i + 1), [x(i), y, -0.5])).concat(range(planks + 1, (i) => joint("ball", at(i), at(i + 1), [x(i), y, 0.5]))) };
}
const cylinder: Shape = { type: "cylinder", cylinder: { height: 1, radiusBottom: 0.4, radiusTop: 0.4 } };
const kinds: Shape[] = [
  box(0.9, 0.6, 0.7), sphere(0.45), { type: "capsule", capsule: { height: 0.7, radiusBottom: 0.3, radiusTop: 0.3 } },
  { type: "cylinder", cylinder: { height: 0.8, radiusBottom: 0.4, radiusTop: 0.4 } }, { type: "cylinder", cylinder: { height: 0.9, radiusBottom: 0.5, radiusTop: 0 } },
  { type: "ellipsoid", ellipsoid: { radii: [0.6, 0.35, 0.4] } },
  { type: "convex", convex: { points: [[-0.5, -0.4, -0.4], [0.5, -0.4, -0.4], [0, -0.4, 0.6], [0, 0.5, 0]] } },
];

export const scenes: Record<string, () => Scene> = {
  shapes: () => ({ name: "One of each", view: { center: [0, 1, 0], reach: 4 }, note: "Every kind of shape in a small heap. Drag one, or press play.",
    bodies: [floor(12), ...kinds.map((shape, i) => body(shape.type, shape, [(i % 3 - 1) * 0.95, 0.6 + Math.floor(i / 3) * 0.8, (i % 2) * 0.5 - 0.25], { rotation: about([0, 0, 1], 0.2 * i) }))] }),
  tower: () => ({ name: "Ten boxes", view: { center: [0, 5, 0], reach: 7 }, bodies: [floor(), ...tower(10)], note: "A tower stands when impulses are kept from frame to frame." }),
  forty: () => ({ name: "Forty boxes", view: { center: [0, 20, 0], reach: 24 }, note: "The lowest box carries thirty-nine: watch the depth.", bodies: [floor(), ...tower(40)] }),
  crooked: () => ({ name: "Forty boxes, each off by 2 cm", view: { center: [0, 20, 0], reach: 24 }, note: "Every box lies two centimetres beside the middle, to one side or the other.", bodies: [floor(), ...tower(40, 0.02)] }),
  pyramid: () => ({ name: "Pyramid", view: { center: [0, 9, 0], reach: 13 }, note: "Twenty boxes carry nineteen, and so on.", bodies: [floor(40), ...pyramid(20)] }),
  ten: () => ({ name: "Ten to one", view: { center: [0, 1, 0], reach: 3 }, bodies: pressed(10) }),
  heavy: () => ({ name: "A hundred to one", view: { center: [0, 1.5, 0], reach: 3.5 }, note: "The upper box weighs a hundred times the lower one: watch the depth.",
    bodies: [floor(), body("light", box(1, 1, 1), [0, 0.5, 0], { mass: 1 }), body("heavy", box(1.6, 1.6, 1.6), [0, 1.8, 0], { mass: 100 })] }),
  thousandfold: () => ({ name: "A thousand to one", view: { center: [0, 1, 0], reach: 3 }, note: "The upper box weighs a thousand times the lower one.", bodies: pressed(1000) }),
  five: () => ({ name: "A hundred on five light ones", view: { center: [0, 3, 0], reach: 5 }, note: "Five boxes of a kilogram each carry a hundred.", bodies: pressed(100, 5) }),
  domino: () => ({ name: "Dominoes", view: { center: [0, 1, 0], reach: 6 }, bodies: [floor(), ...range(18, (i) => body(`domino ${i + 1}`, box(0.2, 1.6, 0.8), [i * 0.6 - 5.2, 0.8, 0], i ? {} : { angular: [0, 0, -2.5] }))] }),
  cradle: () => ({ name: "Newton's cradle", view: { center: [0, 1.6, 0], reach: 3.5 }, note: "Restitution 1, passed on through bodies that touch.",
    bodies: [body("beam", box(5, 0.2, 0.2), [0, 3.2, 0], { moves: false }), ...range(5, (i) => body(`ball ${i + 1}`, sphere(0.4), [(i - 2) * 0.8, 1, 0], { mass: 1, material: { restitution: 1, staticFriction: 0, dynamicFriction: 0, restitutionCombine: "maximum" }, ...(i ? {} : { linear: [-3.5, 0, 0] }) }))],
    joints: range(5, (i) => joint("ball", 0, i + 1, [(i - 2) * 0.8, 3.2, 0])) }),
  slope: () => ({ name: "Friction on a slope", view: { center: [0, 1.5, 0], reach: 4.5 }, note: "30°: a coefficient of 0.6 holds, 0.5 slides.",
    bodies: [body("slope", box(10, 0.4, 5), [0, 1, 0], { moves: false, rotation: about([0, 0, 1], Math.PI / 6), material: { staticFriction: 1, dynamicFriction: 1 } }),
      ...[0.7, 0.6, 0.5, 0.2].map((mu, i) => body(`μ = ${mu}`, box(0.7, 0.7, 0.7), [2.1 - 0.275, 2.6, (i - 1.5) * 1.1], { rotation: about([0, 0, 1], Math.PI / 6), material: { staticFriction: mu, dynamicFriction: mu, frictionCombine: "minimum" } }))] }),
  cards: () => ({ name: "House of cards", view: { center: [0, 4, 0], reach: 6.5 }, note: "Five storeys, each card held by nothing but friction.",
    bodies: [{ ...floor(), material: { staticFriction: 0.7, dynamicFriction: 0.7 } }, ...cards(5)] }),
  arch: () => ({ name: "Arch", view: { center: [0, 1.5, 0], reach: 3.2 }, note: "Wedges that hold each other up. Take the keystone away.", bodies: [floor(), ...arch(11)] }),
  bounce: () => ({ name: "Bouncing balls", view: { center: [0, 2, 0], reach: 4 }, note: "Restitution 0, 0.5, 0.8 and 1: a ball comes up to e² of its height.",
    bodies: [{ ...floor(), material: { restitution: 1 } }, ...[0, 0.5, 0.8, 1].map((restitution, i) =>
      body(`e = ${restitution}`, sphere(0.4), [(i - 1.5) * 1.4, 4, 0], { material: { restitution, restitutionCombine: "minimum" } }))] }),
  flat: () => ({ name: "A box that falls flat", view: { center: [0, 2, 0], reach: 4 }, note: "Restitution 1 for a whole face: it comes up to where it fell from, and stays level.",
    bodies: [{ ...floor(), material: { restitution: 1 } }, body("box", box(1, 1, 1), [0, 3, 0], { material: { restitution: 1, staticFriction: 0, dynamicFriction: 0 } })] }),
  cylinders: () => ({ name: "Cylinders, lying, standing and dropped", view: { center: [0, 1, 0], reach: 7 }, note: "Ten of each come to rest, and sleep.",
    bodies: [floor(30), ...range(10, (i) => body(`lying ${i + 1}`, cylinder, [(i - 4.5) * 1.2, 0.4, -3], { rotation: about([1, 0, 0], Math.PI / 2) })),
      ...range(10, (i) => body(`standing ${i + 1}`, cylinder, [(i - 4.5) * 1.2, 0.5, 0])),
      ...range(10, (i) => body(`dropped ${i + 1}`, cylinder, [(i - 4.5) * 1.2, 2, 3], { rotation: about([1, 0, 0], 0.3 + i * 0.1) }))] }),
  bowl: () => ({ name: "Balls in a bowl", view: { center: [0, 0.5, 0], reach: 4 }, note: "Twenty balls in a bowl of triangles come to rest.",
    bodies: [body("bowl", bowl(3, 8, 24), [0, 3, 0], { moves: false }),
      ...range(20, (i) => body(`ball ${i + 1}`, sphere(0.35), [(i % 3 - 1) * 0.8, 2 + Math.floor(i / 6) * 0.8, (Math.floor(i / 3) % 2 - 0.5) * 0.9]))] }),
  book: () => ({ name: "A spinning book", gravity: [0, 0, 0], view: { center: [0, 0, 0], reach: 1.6 },
    note: "Turned about its middle axis it tumbles over, again and again (Euler 1765; Dzhanibekov 1985). Energy and angular momentum stay.",
    bodies: [body("book", box(1.4, 0.2, 1), [0, 0, 0], { angular: [0.05, 0.02, 6] })] }),
  chain: () => ({ name: "Ball on a chain", view: { center: [1.5, 3, 0], reach: 5 }, note: "Twenty links, and a ball of a hundred times their mass.", ...chain(20) }),
  bridge: () => ({ name: "Hanging bridge", view: { center: [0, 2, 0], reach: 5 }, note: "Planks on hinges, and a crate on them.", ...bridge(14) }),
  bullets: () => ({ name: "Bullets and a thin wall", view: { center: [-2, 1.5, 0], reach: 5 }, note: "300 m/s against a centimetre: in a step a bullet goes five metres. None gets through.",
    bodies: [floor(), body("wall", box(0.01, 3, 3), [0, 1.5, 0], { moves: false }),
      ...range(5, (i) => body(`bullet ${i + 1}`, box(0.2, 0.2, 0.2), [-4, 0.5 + i * 0.5, (i - 2) * 0.5], { linear: [300, 0, 0] }))] }),
  rod: () => ({ name: "A rod and a thin post", gravity: [0, 0, 0], view: { center: [0, 0, 0], reach: 3.5 }, note: "Four metres long, forty radians a second: in a step its end goes more than a metre, and the post is four centimetres thick.",
    bodies: [body("post", box(0.04, 2, 0.04), [1.5, 0, 0.9], { moves: false }), body("rod", box(4, 0.1, 0.1), [0, 0, 0], { angular: [0, 40, 0] })] }),
  moving: () => ({ name: "Bullets and a wall that comes", gravity: [0, 0, 0], view: { center: [0, 0, 0], reach: 5 }, note: "A wall of a centimetre flies towards the bullets, both at 150 m/s.",
    bodies: [body("wall", box(0.01, 3, 3), [4, 0, 0], { mass: 1000, linear: [-150, 0, 0] }),
      ...range(5, (i) => body(`bullet ${i + 1}`, box(0.2, 0.2, 0.2), [-4, (i - 2) * 0.5, (i - 2) * 0.5], { mass: 1, linear: [150, 0, 0] }))] }),
  sizes: () => ({ name: "From a millimetre to a hundred metres", view: { center: [140, 150, 0], reach: 330 }, note: "Five boxes of each size. Select one, and look closer with the wheel: gravity is the same for all.", bodies: sizes() }),
  far: () => ({ name: "Far from the origin", view: { center: [1e5, 2.5, 1e5], reach: 4.5 }, note: "Five boxes a hundred kilometres away stand as they do at the origin.",
    bodies: [body("floor", box(20, 1, 20), [1e5, -0.5, 1e5], { moves: false }), ...range(5, (i) => body(`box ${i + 1}`, box(1, 1, 1), [1e5, 0.5 + i, 1e5]))] }),
  thousand: () => ({ name: "A thousand boxes", view: { center: [0, 4, 0], reach: 13 }, bodies: [floor(60), ...range(1000, (i) => body(`box ${i + 1}`, box(0.8, 0.8, 0.8), [(i % 10 - 4.5) * 1.05, 0.6 + Math.floor(i / 100) * 1.05, (Math.floor(i / 10) % 10 - 4.5) * 1.05]))] }),
};
