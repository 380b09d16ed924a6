import { graze } from "../graze.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing, Look, Meaning } from "../parts/drawing.ts";
import { add, scale, sub, unit } from "../parts/vec.ts";
import { convex, plane, type Question, type State, type Vec } from "../question.ts";
import { numberOf, type Lesson, type Step } from "./lesson.ts";
import { supportPrograms } from "./programs.ts";

/** `count` points on an ellipsoid in a golden spiral: all of them are vertices of their hull. */
function points(count: number, radii: Vec): Vec[] {
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count, r = Math.sqrt(1 - y * y), angle = i * Math.PI * (3 - Math.sqrt(5));
    return [radii[0] * r * Math.cos(angle), radii[1] * y, radii[2] * r * Math.sin(angle)];
  });
}
const counts = [20, 100, 1000, 10000];
const shapes: Record<string, Vec> = { egg: [1.3, 0.9, 0.9], needle: [2, 0.02, 0.02] };

interface Layers { vertices: Vec[]; layers: graze.HullLayer[] }
interface Built { hull: graze.ConvexHull; layers: Layers; micros: number; built: number }
const kept = new Map<string, Built>();
/** The hull, and the time of one of its support queries on this machine. */
function built(count: number, form: string): Built {
  const key = `${count} ${form}`;
  let made = kept.get(key);
  if (!made) {
    const list = points(count, shapes[form]);
    const start = performance.now();
    const hull = new graze.ConvexHull(list);
    const done = performance.now(), rounds = 4000;
    const directions = points(rounds, [1, 1, 1]);
    for (const d of directions) hull.support(d); // once to warm up
    const again = performance.now();
    for (const d of directions) hull.support(d);
    made = { hull, layers: graze.hullLayers(hull), built: done - start, micros: ((performance.now() - again) * 1000) / rounds };
    kept.set(key, made);
  }
  return made;
}
/** The number of points above which a layer's edges are drawn only where the search comes by. */
const legible = 450;
/** The edges of a layer, or those of them that have an end among some vertices. */
function drawLayer(d: Drawing, { vertices, layers }: Layers, at: number, meaning: Meaning, look: Look, near?: Set<number>): void {
  const { edges } = layers[at];
  for (let e = 0; e < edges.length; e += 2)
    if (!near || near.has(edges[e]) || near.has(edges[e + 1])) d.line(vertices[edges[e]], vertices[edges[e + 1]], meaning, look);
}
const named = (layer: number, of: number): string => (layer === of - 1 ? "the hull" : `layer ${layer + 1}`);
const many = (n: number): string => n.toLocaleString("en");
const situation = (count: number, form: string, direction: Vec): State => ({
  q: { query: "distance", a: { shape: convex(points(20, shapes.egg)) }, b: { shape: plane() } },
  choice: { count, form, x: direction[0], y: direction[1], z: direction[2] },
});
const chosen = (state: State): { count: number; form: string; u: Vec } => {
  const c = state.choice ?? {}, count = Number(c.count), form = String(c.form);
  return { count: counts.includes(count) ? count : 1000, form: Object.hasOwn(shapes, form) ? form : "egg", u: unit(["x", "y", "z"].map((k, i) => numberOf(state, k, i === 0 ? 1 : 0))) };
};

export const hulls: Lesson = {
  id: "hulls", number: 9, title: "Large hulls", question: "Which of ten thousand points is furthest?",
  intro: "GJK asks a hull for its furthest point along a direction, again and again. Looking at every point takes ten thousand products. " +
    "A hierarchy of ever simpler hulls inside each other needs a few dozen. Turn the direction.",
  dimension: 3, view: { center: [0.2, 0, 0], reach: 2 }, start: situation(1000, "egg", [0.8, 0.5, 0.35]),
  choices: [
    { key: "count", label: "Points", usual: 1000, options: [20, 100, 1000, 10000].map((value) => ({ value, label: value.toLocaleString("en") })) },
    { key: "form", label: "Shape", options: [{ value: "egg", label: "egg" }, { value: "needle", label: "needle" }] },
  ],
  handles: (s) => [{ id: "direction", label: "Turn the direction", kind: "turn", meaning: "axis", at: scale(chosen(s).u, 1.9) }],
  drag(s, _id, to) {
    const [x, y, z] = unit(to);
    return { ...s, choice: { ...s.choice, x, y, z } };
  },
  asks(state): Question | undefined {
    const { count, form, u } = chosen(state);
    // Ten thousand points make a line of half a megabyte.
    if (count > 1000) return undefined;
    return { query: "distance", a: { shape: convex(points(count, shapes[form])) },
      b: { shape: plane(), translation: scale(u, 10), rotation: turnedDown(u) } };
  },
  code(state) {
    const { count, form, u } = chosen(state);
    return {
      programs: supportPrograms(count, shapes[form], u),
      prints() {
        const p = built(count, form).hull.support(u);
        return [...p, p[0] * u[0] + p[1] * u[1] + p[2] * u[2]];
      },
    };
  },
  steps(state) {
    const { count, form, u } = chosen(state), hull = built(count, form), found = hull.hull.support(u) as Vec;
    const { layers } = hull, levels = layers.layers.length;
    const { trace } = graze.traced.support(hull.hull, u);
    const whole = (d: Drawing, ghost = false): void => {
      if (count <= (ghost ? 100 : 1000)) d.shape({ shape: convex(layers.vertices) }, "a", { ghost });
      else d.shape({ shape: { type: "ellipsoid", ellipsoid: { radii: shapes[form] } } }, "a", { ghost });
      d.arrow([0, 0, 0], scale(u, 1.8), "axis", { label: "d" });
    };
    const plane = (d: Drawing, at: Vec): void => {
      const side = unit(Math.abs(u[1]) < 0.9 ? [u[2], 0, -u[0]] : [1, 0, 0]);
      d.line(add(at, scale(side, 0.7)), sub(at, scale(side, 0.7)), "touch", { dashed: true });
    };
    const reach = Math.max(...trace.layers[levels - 1].along);
    const steps: Step[] = [{
      title: `${many(count)} points`,
      text: "The support point is the one with the largest scalar product with d. Without further thought that is one product for every point.",
      formula: ["s(d) = max_i p_i*d", `s(d) = ${digits(reach, 5)}`],
      numbers: { caption: "Support (units of length)", columns: ["quantity", "value"], rows: [{ cells: ["direction", vector(u, 4)] }, { cells: ["furthest point", vector(found, 5)], mark: "winner" }, { cells: ["reach", reach] }] },
      says: `The furthest point is ${vector(found, 3)}.`,
      draw(d) {
        whole(d);
        if (count <= 100) for (const p of layers.vertices) d.point(p, "a");
        d.point(found, "touch", { wide: true, label: "s(d)" });
        plane(d, found);
      },
    }, {
      title: levels > 1 ? "Hulls inside hulls" : "One layer",
      text: levels > 1
        ? "Dobkin and Kirkpatrick take away, again and again, points no two of which are neighbours and none of which has many neighbours. What is left has a hull inside the one before. Each round loses at least a fixed share, so there are few. The library keeps of several rounds one, about a quarter of the next: fewer layers, a few more points to look at in each. The innermost is drawn as a body, the next ones as lines."
        : "Up to 64 points the library has no hierarchy: it looks at all of them, several side by side in the lanes of the processor. No descent is as fast.",
      formula: levels > 1 ? [layers.layers.map((l) => l.vertices.length).join(" -> ")] : undefined,
      numbers: { caption: "Layers, from the coarsest (numbers)", columns: ["layer", "points", "edges"], rows: layers.layers.map((l, i) => ({ cells: [named(i, levels), l.vertices.length, l.edges.length / 2], key: `layer-${i}` })) },
      says: `${levels} ${levels > 1 ? "layers" : "layer"} of ${layers.layers.map((l) => many(l.vertices.length)).join(", ")} points.`,
      draw(d) {
        whole(d, levels > 1);
        if (levels > 1) d.shape({ shape: convex([...layers.layers[0].vertices].map((v) => layers.vertices[v])) }, "made");
        layers.layers.forEach((l, i) => {
          if (l.vertices.length > legible || (levels > 1 && i === levels - 1)) return;
          if (i > 0) drawLayer(d, layers, i, i === 1 ? "axis" : "out", { ghost: i > 1, key: `layer-${i}` });
          if (i < 2 && l.vertices.length <= 100) for (const v of l.vertices) d.point(layers.vertices[v], i === 0 ? "made" : "axis", { key: `layer-${i}` });
        });
      },
    }];
    trace.layers.forEach((layer, i) => {
      const name = named(i, levels), seen = [...layer.lookedAt], size = layers.layers[i].vertices.length;
      const best = seen.map((_, k) => Math.max(...layer.along.slice(0, k + 1)));
      const climb = seen.filter((_, k) => k === 0 || best[k] > best[k - 1]);
      const last = i === levels - 1, first = i === 0;
      steps.push({
        title: trace.scanned ? "All of them" : `${name[0].toUpperCase()}${name.slice(1)}: ${seen.length} of ${many(size)}`,
        text: trace.scanned ? "Every point is looked at once, and the furthest wins."
          : (first ? "The coarsest layer is small. The search begins at its first point and looks at neighbours: the first that lies further along d is the next to stand on. Where no neighbour lies further, none of the layer does, for it is convex. "
            : "The answer of the layer inside is a point of this one too: there the search goes on. Only what this layer has added around it can lie further. ") +
            `${seen.length} products, ${climb.length - 1 === 1 ? "one step" : `${climb.length - 1} steps`} to a better point` + (last ? ", and this layer is the hull itself: the furthest of all." : "."),
        formula: [`max p*d = ${digits(best[best.length - 1], 6)}`],
        numbers: {
          caption: "Looked at, layer by layer (numbers, and units of length)", columns: ["layer", "points", "looked at", "furthest so far"],
          rows: trace.layers.map((l, k) => ({ cells: k <= i ? [named(k, levels), l.vertices, l.lookedAt.length, Math.max(...l.along)] : [named(k, levels), l.vertices, "", ""],
            mark: k === i ? (last ? "winner" as const : "now" as const) : undefined })),
        },
        graph: { caption: "product with d of each point (length)", close: true, at: seen.length - 1, series: [{ name: "the best", meaning: "touch", values: best }, { name: "looked at", meaning: "axis", values: [...layer.along] }] },
        says: `${seen.length} of ${many(size)} points of ${name} are looked at; the furthest is ${vector(layers.vertices[layer.winner], 3)}.`,
        draw(d) {
          whole(d, !trace.scanned);
          if (!trace.scanned) drawLayer(d, layers, i, "made", { ghost: size > 100 }, size > legible ? new Set(seen) : undefined);
          for (const v of new Set(seen)) d.point(layers.vertices[v], v === layer.winner ? "touch" : "axis", { wide: v === layer.winner });
          if (!trace.scanned) for (let k = 1; k < climb.length; k++) d.line(layers.vertices[climb[k - 1]], layers.vertices[climb[k]], "touch", { wide: true });
          d.text(layers.vertices[layer.winner], last ? "s(d)" : "best", "touch");
          plane(d, layers.vertices[layer.winner]);
        },
      });
    });
    const sizes = counts.map((c) => ({ c, vertices: built(c, form).layers.vertices.length, levels: built(c, form).layers.layers.length, products: graze.traced.support(built(c, form).hull, u).trace.products }));
    steps.push({
      title: `${trace.products} instead of ${many(count)}`,
      text: "The same direction asked of hulls of four sizes. Brute force takes a product a point. The descent takes a handful a layer, and ten times the points are about two layers more.",
      formula: ['"products" = O(log n)'],
      numbers: { caption: "Products for one direction (numbers)", columns: ["points", "layers", "looked at", "brute force"], rows: sizes.map((m) => ({ cells: [many(m.c), m.levels, m.products, m.vertices], mark: m.c === count ? "now" as const : undefined })) },
      graph: { caption: "products for 20, 100, 1,000, 10,000 points", at: counts.indexOf(count), series: [{ name: "descent", meaning: "made", values: sizes.map((m) => m.products) }] },
      says: `${trace.products} products instead of ${many(count)}.`,
      draw(d) {
        whole(d);
        for (const l of trace.layers) for (const v of new Set(l.lookedAt)) d.point(layers.vertices[v], "axis");
        d.point(found, "touch", { wide: true, label: "s(d)" });
        plane(d, found);
      },
    });
    const measured = counts.map((c) => ({ c, ...built(c, form) }));
    steps.push({
      title: "Measured here and now",
      text: "4,000 support queries by the library in your browser, for hulls of four sizes. Five hundred times the points do not cost five hundred times the time. Each number has the call from JavaScript in it, which is most of it for the small ones.",
      numbers: { caption: "One support query (microseconds), and building the hull (milliseconds)", columns: ["points", "query", "build"], rows: measured.map((m) => ({ cells: [m.c.toLocaleString("en"), Number(m.micros.toPrecision(3)), Number(m.built.toPrecision(3))], mark: m.c === count ? "now" as const : undefined })) },
      graph: { caption: "microseconds for 20, 100, 1,000, 10,000 points", at: counts.indexOf(count), series: [{ name: "a query", meaning: "made", values: measured.map((m) => m.micros) }] },
      says: `A support query takes ${digits(hull.micros, 3)} microseconds.`,
      draw(d) {
        whole(d);
        d.point(found, "touch", { wide: true });
      },
    });
    return steps;
  },
  tryThis: [
    { label: "Ten thousand points", note: "The time of a query grows with the logarithm.", state: situation(10000, "egg", [0.8, 0.5, 0.35]) },
    { label: "Twenty points", note: "So small that looking at all of them is the best there is.", state: situation(20, "egg", [0.1, 1, 0.2]) },
  ],
  wrong: [{ label: "A needle", note: "Nearly all points lie nearly on a line: neighbours differ by less than rounding in their products, and a walk from neighbour to neighbour that stops when it gets no better can stop too early.", state: situation(1000, "needle", [0.02, 1, 0.1]) }],
  sources: ["D. Dobkin, D. Kirkpatrick: Determining the separation of preprocessed polyhedra, a unified approach, ICALP 1990", "J. O'Rourke: Computational Geometry in C (1998), section 7.10"],
};

/** The rotation that turns +Y to −u: a half-space that faces the hull. */
function turnedDown(u: Vec): Vec {
  const w = 1 - u[1];
  if (w < 1e-9) return [1, 0, 0, 0];
  return unit([-u[2], 0, u[0], w]);
}
