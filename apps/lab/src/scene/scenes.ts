// The scenes to choose from. Lengths in metres, masses in kilograms.

import { box, sphere, type Shape, type Vec } from "../question.ts";
import { turned, type Scene, type SceneBody, type SceneJoint } from "./model.ts";
import { Random } from "./random.ts";

const body = (name: string, shape: Shape, translation: Vec, more: Partial<SceneBody> = {}): SceneBody => ({
  name, shape, translation, rotation: turned, moves: true, ...more });
const joint = (kind: SceneJoint["kind"], a: number, b: number, at: Vec): SceneJoint => ({
  a, b, kind, frames: [{ translation: at, rotation: turned }, { translation: at, rotation: turned }] });
const floor = (size = 20): SceneBody => body("floor", box(size, 1, size), [0, -0.5, 0], { moves: false });
/** A floor without an end. */
const level = (material?: SceneBody["material"]): SceneBody => body("floor", { type: "plane" }, [0, 0, 0], { moves: false, ...(material ? { material } : {}) });
const about = (axis: Vec, angle: number): Vec => [...axis.map((x) => x * Math.sin(angle / 2)), Math.cos(angle / 2)];
const range = <T>(count: number, make: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => make(i));

function pyramid(base: number): SceneBody[] {
  const made: SceneBody[] = [];
  for (let row = 0; row < base; row++)
    for (let i = 0; i < base - row; i++) made.push(body(`box ${row}.${i}`, box(1, 1, 1), [(i - (base - row - 1) / 2) * 1.05, 0.5 + row, 0]));
  return made;
}
/** Boxes on each other, each beside the middle by up to `off` along X and Z. */
function tower(count: number, off = 0): SceneBody[] {
  const random = new Random(1);
  return range(count, (i) => {
    const [x, z] = [0, 1].map(() => random.number(-off, off));
    return body(`box ${i + 1}`, box(1, 1, 1), [off && x, 0.5 + i, off && z]);
  });
}
/** Boxes in layers of 16 by 16 above each other, each put and turned by chance, between a floor and four walls. */
function bin(count: number): SceneBody[] {
  const random = new Random(3), half = 10;
  const wall = (name: string, at: Vec, size: Vec): SceneBody => body(name, box(...size), at, { moves: false, clear: true });
  return [level(),
    ...[-1, 1].flatMap((side) => [wall(side < 0 ? "left wall" : "right wall", [side * (half + 0.5), 20, 0], [1, 40, 2 * half + 2]),
      wall(side < 0 ? "back wall" : "front wall", [0, 20, side * (half + 0.5)], [2 * half + 2, 40, 1])]),
    ...range(count, (i) => {
      const x = i % 16, z = Math.floor(i / 16) % 16, y = Math.floor(i / 256), by = random.inCube(0.05), angle = random.number(-0.3, 0.3);
      return body(`box ${i + 1}`, box(1, 1, 1), [(x - 7.5) * 1.23 + by[0], 1 + y * 1.3 + by[1], (z - 7.5) * 1.23 + by[2]], { rotation: about(random.direction(), angle) });
    })];
}
const rough = (friction: number): SceneBody["material"] => ({ staticFriction: friction, dynamicFriction: friction, frictionCombine: "minimum" });
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
  return [level(), ...made];
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

/** A scene of the list, which is made when it is opened. */
interface Listed {
  name: string;
  make: () => Scene;
}
const listed = (name: string, make: () => Omit<Scene, "name">): Listed => ({ name, make: () => ({ name, ...make() }) });

export const scenes: Record<string, Listed> = {
  shapes: listed("One of each", () => ({ view: { center: [0, 1, 0], reach: 4 }, note: "Every kind of shape in a small heap. Drag one, or press play.",
    bodies: [floor(12), ...kinds.map((shape, i) => body(shape.type, shape, [(i % 3 - 1) * 0.95, 0.6 + Math.floor(i / 3) * 0.8, (i % 2) * 0.5 - 0.25], { rotation: about([0, 0, 1], 0.2 * i) }))] })),
  tower: listed("Ten boxes", () => ({ view: { center: [0, 5, 0], reach: 7 }, bodies: [floor(), ...tower(10)], note: "A tower stands when impulses are kept from frame to frame." })),
  forty: listed("Forty boxes", () => ({ view: { center: [0, 20, 0], reach: 24 }, note: "The lowest box carries thirty-nine: watch the depth.", bodies: [floor(), ...tower(40)] })),
  hundred: listed("A hundred boxes", () => ({ view: { center: [0, 50, 0], reach: 56 }, note: "The lowest box carries ninety-nine. So high a tower bends at each of its contacts, and takes more sub-steps.", bodies: [floor(), ...tower(100)] })),
  crooked: listed("Forty boxes, each off by 2 cm", () => ({ view: { center: [0, 20, 0], reach: 24 }, note: "Every box lies up to two centimetres beside the middle, by chance.", bodies: [floor(), ...tower(40, 0.02)] })),
  sixty: listed("Sixty boxes, each off by 2 cm", () => ({ view: { center: [0, 30, 0], reach: 35 }, note: "Half as high again as the forty, and as crooked.", bodies: [floor(), ...tower(60, 0.02)] })),
  pyramid: listed("Pyramid", () => ({ view: { center: [0, 9, 0], reach: 13 }, note: "Twenty boxes carry nineteen, and so on.", bodies: [floor(40), ...pyramid(20)] })),
  ten: listed("Ten to one", () => ({ view: { center: [0, 1, 0], reach: 3 }, bodies: pressed(10) })),
  heavy: listed("A hundred to one", () => ({ view: { center: [0, 1.5, 0], reach: 3.5 }, note: "The upper box weighs a hundred times the lower one: watch the depth.",
    bodies: [floor(), body("light", box(1, 1, 1), [0, 0.5, 0], { mass: 1 }), body("heavy", box(1.6, 1.6, 1.6), [0, 1.8, 0], { mass: 100 })] })),
  thousandfold: listed("A thousand to one", () => ({ view: { center: [0, 1, 0], reach: 3 }, note: "The upper box weighs a thousand times the lower one.", bodies: pressed(1000) })),
  five: listed("A hundred on five light ones", () => ({ view: { center: [0, 3, 0], reach: 5 }, note: "Five boxes of a kilogram each carry a hundred.", bodies: pressed(100, 5) })),
  domino: listed("Dominoes", () => ({ view: { center: [0, 1, 0], reach: 6 }, bodies: [floor(), ...range(18, (i) => body(`domino ${i + 1}`, box(0.2, 1.6, 0.8), [i * 0.6 - 5.2, 0.8, 0], i ? {} : { angular: [0, 0, -2.5] }))] })),
  cradle: listed("Newton's cradle", () => ({ view: { center: [0, 1.6, 0], reach: 3.5 }, note: "Restitution 1, passed on through bodies that touch.",
    bodies: [body("beam", box(5, 0.2, 0.2), [0, 3.2, 0], { moves: false }), ...range(5, (i) => body(`ball ${i + 1}`, sphere(0.4), [(i - 2) * 0.8, 1, 0], { mass: 1, material: { restitution: 1, staticFriction: 0, dynamicFriction: 0, restitutionCombine: "maximum" }, ...(i ? {} : { linear: [-3.5, 0, 0] }) }))],
    joints: range(5, (i) => joint("ball", 0, i + 1, [(i - 2) * 0.8, 3.2, 0])) })),
  struck: listed("Five balls in a row, and a sixth", () => ({ gravity: [0, 0, 0], view: { center: [0.5, 0, 0], reach: 3.5 }, note: "5 m/s into five balls that touch: the last one leaves with 5 m/s, the others stay.",
    bodies: range(6, (i) => body(`ball ${i + 1}`, sphere(0.5), [i === 0 ? -2 : i - 1, 0, 0], { material: { restitution: 1, staticFriction: 0, dynamicFriction: 0 }, ...(i ? {} : { linear: [5, 0, 0] }) })) })),
  slope: listed("Friction on a slope", () => ({ view: { center: [0, 1.5, 0], reach: 4.5 }, note: "30°: a coefficient of 0.6 holds, 0.5 slides.",
    bodies: [body("slope", box(10, 0.4, 5), [0, 1, 0], { moves: false, rotation: about([0, 0, 1], Math.PI / 6), material: { staticFriction: 1, dynamicFriction: 1 } }),
      ...[0.7, 0.6, 0.5, 0.2].map((mu, i) => body(`μ = ${mu}`, box(0.7, 0.7, 0.7), [2.1 - 0.275, 2.6, (i - 1.5) * 1.1], { rotation: about([0, 0, 1], Math.PI / 6), material: { staticFriction: mu, dynamicFriction: mu, frictionCombine: "minimum" } }))] })),
  incline: listed("Cubes and plates at the edge of sliding", () => ({ gravity: [10 * Math.sin(Math.PI / 6), -10 * Math.cos(Math.PI / 6), 0], view: { center: [1, 0.5, 0], reach: 4.5 },
    note: "A slope of 30° where gravity leans in place of the floor. With 1.02 of the friction that holds they stay, with 0.98 they creep away, with half of it they slide five metres in two seconds.",
    bodies: [level({ staticFriction: 1, dynamicFriction: 1 }), ...[1.02, 0.98, 0.5].flatMap((share, i) => [["cube", 1, -4], ["plate", 0.1, 0.7]].map(([kind, high, z]) =>
      body(`${kind}, ${share}`, box(1, Number(high), 1), [0, Number(high) / 2, Number(z) + 1.4 * i], { material: rough(share * Math.tan(Math.PI / 6)) })))] })),
  stop: listed("A plate that slides to a stop", () => ({ gravity: [0, -10, 0], view: { center: [5, 0.5, 0], reach: 6 }, note: "10 m/s and a coefficient of 0.5: it stops after two seconds and ten metres, v²/2μg.",
    bodies: [level(rough(0.5)), body("plate", box(1, 0.1, 1), [0, 0.05, 0], { linear: [10, 0, 0], material: rough(0.5) })] })),
  cards: listed("House of cards", () => ({ view: { center: [0, 4, 0], reach: 6.5 }, note: "Five storeys, each card held by nothing but friction.",
    bodies: [{ ...floor(), material: { staticFriction: 0.7, dynamicFriction: 0.7 } }, ...cards(5)] })),
  arch: listed("Arch", () => ({ view: { center: [0, 1.5, 0], reach: 3.2 }, note: "Wedges that hold each other up. Take the keystone away.", bodies: [floor(), ...arch(11)] })),
  bounce: listed("Bouncing balls", () => ({ view: { center: [0, 2, 0], reach: 4 }, note: "Restitution 0, 0.5, 0.8 and 1: a ball comes up to e² of its height.",
    bodies: [{ ...floor(), material: { restitution: 1 } }, ...[0, 0.5, 0.8, 1].map((restitution, i) =>
      body(`e = ${restitution}`, sphere(0.4), [(i - 1.5) * 1.4, 4, 0], { material: { restitution, restitutionCombine: "minimum" } }))] })),
  flat: listed("A box that falls flat", () => ({ view: { center: [0, 2, 0], reach: 4 }, note: "Restitution 1 for a whole face: it comes up to where it fell from, and stays level.",
    bodies: [{ ...floor(), material: { restitution: 1 } }, body("box", box(1, 1, 1), [0, 3, 0], { material: { restitution: 1, staticFriction: 0, dynamicFriction: 0 } })] })),
  fall: listed("A box that falls freely", () => ({ gravity: [0, -10, 0], view: { center: [0, -2.5, 0], reach: 4 }, note: "Nothing below it: after a second, sixty steps, it is five metres lower, to rounding.", bodies: [body("box", box(1, 1, 1), [0, 0, 0])] })),
  cylinders: listed("Cylinders, lying, standing and dropped", () => ({ view: { center: [0, 1, 0], reach: 7 }, note: "Ten of each come to rest, and sleep.",
    bodies: [floor(30), ...range(10, (i) => body(`lying ${i + 1}`, cylinder, [(i - 4.5) * 1.2, 0.4, -3], { rotation: about([1, 0, 0], Math.PI / 2) })),
      ...range(10, (i) => body(`standing ${i + 1}`, cylinder, [(i - 4.5) * 1.2, 0.5, 0])),
      ...range(10, (i) => body(`dropped ${i + 1}`, cylinder, [(i - 4.5) * 1.2, 2, 3], { rotation: about([1, 0, 0], 0.3 + i * 0.1) }))] })),
  bowl: listed("Balls in a bowl", () => ({ view: { center: [0, 0.5, 0], reach: 4 }, note: "Twenty balls in a bowl of triangles come to rest.",
    bodies: [body("bowl", bowl(3, 8, 24), [0, 3, 0], { moves: false }),
      ...range(20, (i) => body(`ball ${i + 1}`, sphere(0.35), [(i % 3 - 1) * 0.8, 2 + Math.floor(i / 6) * 0.8, (Math.floor(i / 3) % 2 - 0.5) * 0.9]))] })),
  book: listed("A spinning book", () => ({ gravity: [0, 0, 0], view: { center: [0, 0, 0], reach: 1.6 },
    note: "Turned about its middle axis it tumbles over, again and again (Euler 1765; Dzhanibekov 1985). Energy and angular momentum stay.",
    bodies: [body("book", box(1.4, 0.2, 1), [0, 0, 0], { angular: [0.05, 0.02, 6] })] })),
  chain: listed("Ball on a chain", () => ({ view: { center: [1.5, 3, 0], reach: 5 }, note: "Twenty links, and a ball of a hundred times their mass.", ...chain(20) })),
  bridge: listed("Hanging bridge", () => ({ view: { center: [0, 2, 0], reach: 5 }, note: "Planks on hinges, and a crate on them.", ...bridge(14) })),
  bullets: listed("Bullets and a thin wall", () => ({ view: { center: [-2, 1.5, 0], reach: 5 }, note: "300 m/s against a centimetre: in a step a bullet goes five metres. None gets through.",
    bodies: [floor(), body("wall", box(0.01, 3, 3), [0, 1.5, 0], { moves: false }),
      ...range(5, (i) => body(`bullet ${i + 1}`, box(0.2, 0.2, 0.2), [-4, 0.5 + i * 0.5, (i - 2) * 0.5], { linear: [300, 0, 0] }))] })),
  rod: listed("A rod and a thin post", () => ({ gravity: [0, 0, 0], view: { center: [0, 0, 0], reach: 3.5 }, note: "Four metres long, forty radians a second: in a step its end goes more than a metre, and the post is four centimetres thick.",
    bodies: [body("post", box(0.04, 2, 0.04), [1.5, 0, 0.9], { moves: false }), body("rod", box(4, 0.1, 0.1), [0, 0, 0], { angular: [0, 40, 0] })] })),
  post: listed("A rod and a post that comes", () => ({ gravity: [0, 0, 0], view: { center: [0.5, 0, 0], reach: 3 }, note: "The rod turns by forty radians a second, and the post comes towards it with a metre a second.",
    bodies: [body("post", box(0.04, 0.04, 2), [1.9, 0.02, 0], { mass: 3200, linear: [0, -1, 0] }), body("rod", box(4, 0.04, 0.04), [0, 0, 0], { rotation: about([0, 0, 1], -0.6), angular: [0, 0, 40] })] })),
  moving: listed("Bullets and a wall that comes", () => ({ gravity: [0, 0, 0], view: { center: [0, 0, 0], reach: 5 }, note: "A wall of a centimetre flies towards the bullets, both at 150 m/s.",
    bodies: [body("wall", box(0.01, 3, 3), [4, 0, 0], { mass: 1000, linear: [-150, 0, 0] }),
      ...range(5, (i) => body(`bullet ${i + 1}`, box(0.2, 0.2, 0.2), [-4, (i - 2) * 0.5, (i - 2) * 0.5], { mass: 1, linear: [150, 0, 0] }))] })),
  sizes: listed("From a millimetre to a hundred metres", () => ({ view: { center: [140, 150, 0], reach: 330 }, note: "Five boxes of each size. Select one, and look closer with the wheel: gravity is the same for all.", bodies: sizes() })),
  far: listed("Far from the origin", () => ({ view: { center: [1e5, 2.5, 1e5], reach: 4.5 }, note: "Five boxes a hundred kilometres away stand as they do at the origin.",
    bodies: [body("floor", box(20, 1, 20), [1e5, -0.5, 1e5], { moves: false }), ...range(5, (i) => body(`box ${i + 1}`, box(1, 1, 1), [1e5, 0.5 + i, 1e5]))] })),
  thousand: listed("A thousand boxes", () => ({ view: { center: [0, 4, 0], reach: 13 }, bodies: [floor(60), ...range(1000, (i) => body(`box ${i + 1}`, box(0.8, 0.8, 0.8), [(i % 10 - 4.5) * 1.05, 0.6 + Math.floor(i / 100) * 1.05, (Math.floor(i / 10) % 10 - 4.5) * 1.05]))] })),
  bin: listed("Five thousand boxes fall into a bin", () => ({ gravity: [0, -10, 0], view: { center: [0, 11, 0], reach: 17, from: [0.5, 0.6, 1] }, note: "Twenty layers of boxes, each a little turned, between walls that one sees through. A step takes a while.", bodies: bin(5000) })),
};
