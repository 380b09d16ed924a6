import { ask } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, quatAbout, rotate, scale, sub, toWorld } from "../parts/vec.ts";
import { box, plane, sizeOf, type Body, type State, type Vec } from "../question.ts";
import { dragBody, drawBodies, moveHandle, sizeHandle, turnHandle, type Lesson, type Step } from "./lesson.ts";

const arms = { a: [0, 1.4, 0], b: [1.7, 0, 0] };
const situation = (translation: Vec, rotation: Vec, planeRotation: Vec = quatAbout([0, 0, 1], 0.15)): State => ({
  q: { query: "distance", a: { shape: plane(), rotation: planeRotation }, b: { shape: box(2, 1, 1.4), translation, rotation } },
});
function corners(body: Body): Vec[] {
  const h = scale(sizeOf(body.shape), 0.5);
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => toWorld(body, [i & 1 ? h[0] : -h[0], i & 2 ? h[1] : -h[1], i & 4 ? h[2] : -h[2]]));
}

export const planesBoxes: Lesson = {
  id: "planes-boxes", number: 2, title: "Planes and boxes", question: "Is the box above the plane?",
  intro: "A plane is a unit normal and a distance. Put a point into it and out comes the point's signed distance. A box has eight corners, and yet needs none of them.",
  dimension: 3, view: { center: [0.2, 0.7, 0], reach: 2.4, from: [0.25, 0.22, 1] }, start: situation([0.3, 1.3, 0.1], quatAbout([0.3, 0.2, 1], 0.7)),
  handles: (s) => [{ ...moveHandle(s, "a"), label: "A point of the plane" }, { ...turnHandle(s, "a", arms.a), label: "Turn the plane's normal" }, moveHandle(s, "b"), turnHandle(s, "b", arms.b), sizeHandle(s, "b")],
  drag: (s, id, to) => dragBody(s, id, to, arms),
  steps(state) {
    const { q } = state, answer = ask(q), b = q.b!;
    const n = rotate(q.a.rotation, [0, 1, 0]);
    const points = corners(b), measured = points.map((p) => ask({ query: "closest", a: q.a, point: p }));
    const axis = answer.trace.axes.find((x) => x.name === "normal");
    const [low, high] = [Number(axis?.b[0]), Number(axis?.b[1])], top = Number(axis?.a[1]);
    const base = (d: Drawing): void => {
      drawBodies(d, q);
      d.arrow(q.a.translation ?? [0, 0, 0], add(q.a.translation ?? [0, 0, 0], n), "axis", { wide: true, label: "n" });
    };
    const best = measured.reduce((m, x, i) => (x.distance! < measured[m].distance! ? i : m), 0);
    const steps: Step[] = [{
      title: "Three ways to a plane",
      text: "By its normal and a point: drag both. By its normal and its distance from the origin. By three points that do not lie on a line: the cross product of two sides is the normal, to be made a unit. All say the same.",
      formula: ["n*x = w", "n = frac((q - p) × (r - p), |(q - p) × (r - p)|)", `n = [${n.map((x) => digits(x, 4)).join(", ")}]`],
      says: `A plane with normal ${vector(n, 3)} and a box.`, draw: base,
    }];
    points.forEach((p, i) => steps.push({
      title: `Corner ${i + 1}`,
      text: "Its signed distance from the plane: positive above, negative below. The smallest of the eight is the box's." + (i === 7 ? ` It is that of corner ${best + 1}.` : ""),
      formula: ["d = n*x - w", `d_${i + 1} = ${digits(measured[i].distance, 5)}`],
      numbers: { caption: "Corners", columns: ["corner", "point", "distance"], rows: points.slice(0, i + 1).map((x, k) => ({ cells: [String(k + 1), vector(x, 3), measured[k].distance!], key: `corner-${k}`, mark: i === 7 && k === best ? "winner" as const : k === i ? "now" as const : undefined })) },
      says: `Corner ${i + 1}: ${digits(measured[i].distance, 4)}.`,
      draw(d) {
        base(d);
        points.slice(0, i + 1).forEach((x, k) => d.point(x, measured[k].distance! <= 0 ? "touch" : "b", { key: `corner-${k}`, wide: k === i }));
        d.line(p, measured[i].point!, "made", { wide: true });
      },
    }));
    const center = (low + high) / 2 - top, radius = (high - low) / 2;
    steps.push({
      title: "The projected radius",
      text: "No corner is needed. Seen along the normal, the box reaches to both sides of its centre by the sum of its half sizes, each weighted by how far its edge points along the normal. The centre's distance minus that radius is the same number.",
      formula: ["r = h_x |n*e_x| + h_y |n*e_y| + h_z |n*e_z|", `d = ${digits(center, 5)} - ${digits(radius, 5)} = ${digits(answer.distance, 5)}`],
      numbers: { caption: "Both ways", columns: ["", "distance"], rows: [{ cells: ["centre", center] }, { cells: ["radius", radius] }, { cells: ["centre − radius", answer.distance!], mark: "winner" }, { cells: ["smallest corner", measured[best].distance!], mark: "winner" }] },
      says: `Distance ${digits(answer.distance, 5)}: centre ${digits(center, 4)} minus radius ${digits(radius, 4)}.`,
      draw(d) {
        base(d);
        const c = b.translation!;
        d.line(c, sub(c, scale(n, radius)), "b", { wide: true, label: "r" });
        d.line(sub(c, scale(n, radius)), sub(c, scale(n, center)), "touch", { wide: true, label: "d" });
        d.point(answer.b as unknown as Vec, "b", { wide: true });
        d.point(answer.a as unknown as Vec, "touch", { wide: true });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Flat above it", note: "Four corners are equally near.", state: situation([0, 0.8, 0], [0, 0, 0, 1], [0, 0, 0, 1]) },
    { label: "Through it", note: "Some corners below: the distance is negative, and is the depth.", state: situation([0.3, 0.4, 0.1], quatAbout([0.3, 0.2, 1], 0.7)) },
  ],
  wrong: [{ label: "Just a corner", note: "The plane passes through a corner: the distance is zero up to rounding, and zero counts as touching. Nobody may depend on its sign.", state: situation([0, Math.SQRT2 / 2 * 1.5, 0], quatAbout([0, 0, 1], Math.PI / 4), [0, 0, 0, 1]) }],
  sources: ["C. Ericson: Real-Time Collision Detection (2005), section 5.2.3", "L. O. Hesse: Vorlesungen über analytische Geometrie (1861)"],
};
