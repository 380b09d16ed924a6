// The layers of scenes and captures.

import type { Layer } from "../parts/layers.ts";

const bodies: Layer = { id: "bodies", label: "Bodies", entries: [
  { meaning: "a", sign: "■", says: "moves" }, { meaning: "out", sign: "■", says: "stands" }, { meaning: "made", sign: "■", says: "selected, A" },
  { meaning: "b", sign: "■", says: "selected, B" }, { meaning: "trigger", sign: "■", says: "trigger" }] };
/** The poses at which the contacts of a step were found. */
export const whenStepped = "before this step moved the bodies";
const contacts: Layer = { id: "contacts", label: "Contacts", entries: [
  { meaning: "touch", sign: "●", says: "touches" }, { meaning: "axis", sign: "●", says: "nearly touches" },
  { meaning: "touch", sign: "□", says: "reaches into another" }],
  says: `In a simulation, and in a capture of one, contacts were found ${whenStepped}; else where the bodies are.` };
const normals: Layer = { id: "normals", label: "Normals", entries: [{ meaning: "axis", sign: "→", says: "from A to B" }] };
const pair: Layer = { id: "pair", label: "Selected pair", entries: [
  { meaning: "made", sign: "—", says: "feature of A" }, { meaning: "b", sign: "—", says: "feature of B" }, { meaning: "axis", sign: "┄", says: "distance" }] };

const shots: Layer = { id: "shots", label: "Rays and casts", entries: [{ meaning: "made", sign: "→", says: "way" }, { meaning: "touch", sign: "●", says: "hit" }] };

export const sceneLayers: Layer[] = [
  bodies, contacts, normals, pair,
  { id: "joints", label: "Joints", entries: [{ meaning: "ink", sign: "—", says: "to the anchors" }, { meaning: "touch", sign: "—", says: "gap" }] },
  shots,
  { id: "sleep", label: "Sleep", entries: [{ meaning: "asleep", sign: "■", says: "sleeps, with a z" }] },
  { id: "broad", label: "Broad phase", off: true, entries: [{ meaning: "ink", sign: "□", says: "box of a body" }, { meaning: "out", sign: "□", says: "box of the tree" }] },
  { id: "grid", label: "Grid", entries: [] },
];
/** The layers of captures: what the broad phase did is not kept. */
export const captureLayers: Layer[] = sceneLayers.filter(({ id }) => id !== "broad");
