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
const kinds: Shape[] = [
  box(0.9, 0.6, 0.7), sphere(0.45), { type: "capsule", capsule: { height: 0.7, radiusBottom: 0.3, radiusTop: 0.3 } },
  { type: "cylinder", cylinder: { height: 0.8, radiusBottom: 0.4, radiusTop: 0.4 } }, { type: "cylinder", cylinder: { height: 0.9, radiusBottom: 0.5, radiusTop: 0 } },
  { type: "ellipsoid", ellipsoid: { radii: [0.6, 0.35, 0.4] } },
  { type: "convex", convex: { points: [[-0.5, -0.4, -0.4], [0.5, -0.4, -0.4], [0, -0.4, 0.6], [0, 0.5, 0]] } },
];

export const scenes: Record<string, () => Scene> = {
  shapes: () => ({ name: "One of each", view: { center: [0, 1, 0], reach: 4 }, note: "Every kind of shape in a small heap. Drag one, or press play.",
    bodies: [floor(12), ...kinds.map((shape, i) => body(shape.type, shape, [(i % 3 - 1) * 0.95, 0.6 + Math.floor(i / 3) * 0.8, (i % 2) * 0.5 - 0.25], { rotation: about([0, 0, 1], 0.2 * i) }))] }),
  tower: () => ({ name: "Ten boxes", view: { center: [0, 5, 0], reach: 7 }, bodies: [floor(), ...range(10, (i) => body(`box ${i + 1}`, box(1, 1, 1), [0, 0.5 + i, 0]))], note: "A tower stands when impulses are kept from frame to frame." }),
  pyramid: () => ({ name: "Pyramid", view: { center: [0, 4.5, 0], reach: 7 }, bodies: [floor(30), ...pyramid(10)] }),
  heavy: () => ({ name: "A hundred to one", view: { center: [0, 1.5, 0], reach: 3.5 }, note: "The upper box weighs a hundred times the lower one: watch the depth.",
    bodies: [floor(), body("light", box(1, 1, 1), [0, 0.5, 0], { mass: 1 }), body("heavy", box(1.6, 1.6, 1.6), [0, 1.8, 0], { mass: 100 })] }),
  domino: () => ({ name: "Dominoes", view: { center: [0, 1, 0], reach: 6 }, bodies: [floor(), ...range(18, (i) => body(`domino ${i + 1}`, box(0.2, 1.6, 0.8), [i * 0.6 - 5.2, 0.8, 0], i ? {} : { angular: [0, 0, -2.5] }))] }),
  cradle: () => ({ name: "Newton's cradle", view: { center: [0, 1.6, 0], reach: 3.5 }, note: "Restitution 1, passed on through bodies that touch.",
    bodies: [body("beam", box(5, 0.2, 0.2), [0, 3.2, 0], { moves: false }), ...range(5, (i) => body(`ball ${i + 1}`, sphere(0.4), [(i - 2) * 0.8, 1, 0], { mass: 1, material: { restitution: 1, staticFriction: 0, dynamicFriction: 0, restitutionCombine: "maximum" }, ...(i ? {} : { linear: [-3.5, 0, 0] }) }))],
    joints: range(5, (i) => joint("ball", 0, i + 1, [(i - 2) * 0.8, 3.2, 0])) }),
  slope: () => ({ name: "Friction on a slope", view: { center: [0, 1.5, 0], reach: 4.5 }, note: "30°: a coefficient of 0.6 holds, 0.5 slides.",
    bodies: [body("slope", box(10, 0.4, 5), [0, 1, 0], { moves: false, rotation: about([0, 0, 1], Math.PI / 6), material: { staticFriction: 1, dynamicFriction: 1 } }),
      ...[0.7, 0.6, 0.5, 0.2].map((mu, i) => body(`μ = ${mu}`, box(0.7, 0.7, 0.7), [2.1 - 0.275, 2.6, (i - 1.5) * 1.1], { rotation: about([0, 0, 1], Math.PI / 6), material: { staticFriction: mu, dynamicFriction: mu, frictionCombine: "minimum" } }))] }),
  thousand: () => ({ name: "A thousand boxes", view: { center: [0, 4, 0], reach: 13 }, bodies: [floor(60), ...range(1000, (i) => body(`box ${i + 1}`, box(0.8, 0.8, 0.8), [(i % 10 - 4.5) * 1.05, 0.6 + Math.floor(i / 100) * 1.05, (Math.floor(i / 10) % 10 - 4.5) * 1.05]))] }),
};
