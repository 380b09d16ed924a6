// Scenes of the plane, drawings and JSON, as scenes of the lab.

import { SaxesParser } from "saxes";
import { graze } from "../graze.ts";
import { rotate, sub } from "../parts/vec.ts";
import type { Body, Shape, Vec } from "../question.ts";
import { filtersOf } from "./filters.ts";
import type { Scene, SceneBody } from "./model.ts";
import { about } from "./run.ts";

type Drawn = graze.PlaneScene["bodies"][number];

/** A body's shapes as one in the frame of the first. */
function together(parts: Drawn[]): Shape {
  const [first] = parts, turn = first.rotation ?? 0;
  if (parts.length === 1) return first.shape;
  const place = (part: Drawn): Vec => part.translation ?? [0, 0];
  const children = parts.map((part): Body => ({
    shape: part.shape, translation: rotate(-turn, sub(place(part), place(first))), rotation: (part.rotation ?? 0) - turn }));
  return { type: "compound", compound: { children } };
}

/** A scene from the JSON of `graze collide` or from `graze.planeScene`. Shapes of a body that moves are one. */
export function sceneOfPlane(read: graze.PlaneScene, name: string): Scene {
  const filter = filtersOf(read.bodies), groups = new Map<string, Drawn[]>();
  for (const [i, body] of read.bodies.entries()) {
    // Triggers push nothing, and a fixed shape needs no other to stand with.
    const key = body.body !== undefined && body.motion && !body.trigger ? `body ${body.body}` : `shape ${i}`;
    groups.set(key, [...(groups.get(key) ?? []), body]);
  }
  const bodies = [...groups.values()].map((parts, i): SceneBody => {
    const [own] = parts, inSpace = (v: Vec): Vec => [v[0], v[1], 0];
    const { inertia, gravityFactor, mass, friction = 0.6, restitution = 0 } = own;
    return {
      name: own.body ?? own.name ?? `body ${i}`, shape: together(parts), translation: inSpace(own.translation ?? [0, 0]), rotation: about(own.rotation ?? 0),
      moves: own.motion !== undefined && !own.trigger, mass, trigger: own.trigger, filter: filter(own),
      dynamics: { inertia, gravityFactor, kinematic: own.motion === "kinematic" },
      linear: own.linear && inSpace(own.linear), angular: own.angular === undefined ? undefined : [0, 0, own.angular],
      material: { staticFriction: friction, dynamicFriction: friction, restitution },
    };
  });
  return { name, dimension: 2, bodies, gravity: read.gravity && [...read.gravity, 0] };
}

/** The deepest nesting, that of the library's own reader. */
const mostNested = 100;

/** The root element of an XML document, by a parser that only reads, unlike the browser's. */
function rootOf(text: string): graze.DrawnElement {
  interface Element { localName: string; line: number; attributes: { name: string; value: string }[]; children: Element[] }
  const open: Element[] = [{ localName: "", line: 0, attributes: [], children: [] }];
  const parser = new SaxesParser({ xmlns: true, position: true });
  parser.on("error", (error) => {
    throw new Error(`expected an XML document: ${error.message}`);
  });
  parser.on("opentag", ({ local, attributes }) => {
    const all = Object.entries(attributes).map(([name, { value }]) => ({ name, value }));
    open.push({ localName: local, line: parser.line, attributes: all, children: [] });
    if (open.length > mostNested) throw new Error(`line ${parser.line}: expected elements nested at most ${mostNested} deep`);
  });
  parser.on("closetag", () => {
    const done = open.pop()!;
    open.at(-1)!.children.push(done);
  });
  parser.write(text).close();
  return open[0].children[0];
}

/** A drawing as a scene. Throws an error that names its fault. */
export const readSvg = (text: string, name: string): Scene => sceneOfPlane(graze.planeScene(rootOf(text)), name);
