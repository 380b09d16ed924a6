// The question of a page as a call in C++, Python and JavaScript, with the present numbers.

import { measures, pointsOf, radiusOf, sizeOf, type Body, type Question, type Shape, type Vec } from "../question.ts";

export type Language = "C++" | "Python" | "JavaScript";

interface Words {
  list(items: string[]): string;
  make(kind: string, args: string[]): string;
}

const number = (x: number): string => String(Number(x.toPrecision(9)));

function shapeText(shape: Shape, words: Words, flat: boolean): string {
  const v = (x: Vec): string => words.list(x.map(number));
  const m = measures<{ height: number; radiusBottom: number; radiusTop: number; radii: Vec }>(shape);
  const text = ((): string => {
    switch (shape.type) {
      case "box": return words.make("Box", [v(sizeOf(shape))]);
      case "sphere": return words.make("Sphere", [number(radiusOf(shape) ?? 0.5)]);
      case "circle": return words.make("Circle", [number(radiusOf(shape))]);
      case "capsule": return words.make("Capsule", [m.height, m.radiusBottom, m.radiusTop].map(number));
      case "cylinder": return words.make("Cylinder", [m.height, m.radiusBottom, m.radiusTop].map(number));
      case "ellipsoid": return words.make("Ellipsoid", [v(m.radii)]);
      case "plane": return words.make(flat ? "HalfPlane" : "HalfSpace", []);
      case "segment": return words.make("Segment", pointsOf(shape).map(v));
      case "triangle": return words.make("Triangle", pointsOf(shape).map(v));
      case "convex": {
        const points = pointsOf(shape);
        const shown = points.length > 12 ? "points" : words.list(points.map(v));
        return words.make(flat ? "Convex" : "ConvexHull", [shown]);
      }
      default: return words.make(shape.type, ["..."]);
    }
  })();
  return text;
}

const nothing = (v?: Vec | number): boolean =>
  v === undefined || (typeof v === "number" ? v === 0 : v.every((x, i) => x === (v.length === 4 && i === 3 ? 1 : 0)));

function javascript(q: Question): string {
  const flat = q.dimension === 2, where = flat ? "plane." : "";
  const words: Words = {
    list: (x) => `[${x.join(", ")}]`,
    make: (kind, args) => `new ${where}${kind}(${args.join(", ")})`,
  };
  const value = (v: Vec | number): string => (typeof v === "number" ? number(v) : words.list(v.map(number)));
  const keys = (body: Body, extra: string[]): string => {
    const list = [...extra];
    for (const key of ["translation", "rotation", "linear", "angular"] as const)
      if (!nothing(body[key]) && (q.query === "cast" || key === "translation" || key === "rotation"))
        list.push(`${key}: ${value(body[key]!)}`);
    return list.length ? `{ ${list.join(", ")} }` : "{}";
  };
  const names = `init, ${flat ? "plane" : q.query}`;
  const lines = [`import { ${names} } from "graze/double";`, "await init();",
    `const a = ${shapeText(q.a.shape, words, flat)};`];
  if (q.b) lines.push(`const b = ${shapeText(q.b.shape, words, flat)};`);
  const f = `${where}${q.query}`;
  if (q.query === "cast")
    lines.push(`${f}(${keys(q.a, ["shape: a"])},`, `  ${keys(q.b!, ["shape: b"])}, { duration: ${number(q.duration ?? 1)} });`);
  else if (q.query === "raycast")
    lines.push(`${f}(a, ${keys(q.a, [])}, { origin: ${value(q.ray!.origin)}, direction: ${value(q.ray!.direction)} });`);
  else if (q.query === "closest") lines.push(`${f}(a, ${keys(q.a, [])}, ${value(q.point!)});`);
  else if (q.query === "response")
    lines.push(`response({ point: ${value(q.contact!.point)}, normal: ${value(q.contact!.normal)}, restitution: ${q.restitution ?? 0}, friction: ${q.friction ?? 0.6} },`,
      `  { mass: ${q.a.mass}, shape: a, linear: ${value(q.a.linear ?? [0, 0, 0])} }, { mass: ${q.b!.mass}, shape: b, linear: ${value(q.b!.linear ?? [0, 0, 0])} });`);
  else lines.push(`${f}(a, ${keys(q.a, [])}, b, ${keys(q.b!, [])});`);
  return lines.join("\n");
}

function python(q: Question): string {
  const flat = q.dimension === 2, module = flat ? "graze.plane" : "graze";
  const words: Words = {
    list: (x) => `(${x.join(", ")})`,
    make: (kind, args) => `${module}.${kind === "Convex" ? "Convex" : kind}(${args.join(", ")})`,
  };
  const value = (v: Vec | number): string => (typeof v === "number" ? number(v) : words.list(v.map(number)));
  const pose = (body: Body): string => {
    if (nothing(body.translation) && nothing(body.rotation)) return "None";
    const t = value(body.translation ?? (flat ? [0, 0] : [0, 0, 0]));
    return nothing(body.rotation) ? t : `(${t}, ${value(body.rotation!)})`;
  };
  const lines = [`import ${module}`, `a = ${shapeText(q.a.shape, words, flat)}`];
  if (q.b) lines.push(`b = ${shapeText(q.b.shape, words, flat)}`);
  if (q.query === "raycast") lines.push(`${module}.raycast(a, ${pose(q.a)}, ${value(q.ray!.origin)}, ${value(q.ray!.direction)})`);
  else if (q.query === "closest") lines.push(`${module}.closest(a, ${pose(q.a)}, ${value(q.point!)})`);
  else if (q.query === "cast" || q.query === "response") return "";
  else lines.push(`${module}.${q.query}(a, ${pose(q.a)}, b, ${pose(q.b!)})`);
  return lines.join("\n");
}

function cpp(q: Question): string {
  const flat = q.dimension === 2, space = flat ? "graze::plane" : "graze";
  const words: Words = {
    list: (x) => `{${x.join(", ")}}`,
    make: (kind, args) => `${space}::${kind === "Convex" ? "ConvexPolygon" : kind}<double>(${args.join(", ")})`,
  };
  const value = (v: Vec): string => words.list(v.map(number));
  const pose = (body: Body): string => {
    const t = value(body.translation ?? (flat ? [0, 0] : [0, 0, 0]));
    if (nothing(body.rotation)) return `{${t}, {}}`;
    if (typeof body.rotation === "number") return `{${t}, ${space}::Rot2d(${number(body.rotation)})}`;
    return `{${t}, graze::Quatd${value(body.rotation!)}}`;
  };
  if (q.query === "cast" || q.query === "response") return "";
  const lines = [flat ? "#include <graze/plane/query.hpp>" : "#include <graze/graze.hpp>",
    `const ${space}::Shaped a = ${shapeText(q.a.shape, words, flat)};`];
  if (q.b) lines.push(`const ${space}::Shaped b = ${shapeText(q.b.shape, words, flat)};`);
  if (q.query === "contacts")
    lines.push(`${space}::Manifolds<double> manifolds;`,
      `${space}::contacts(a, ${pose(q.a)}, b, ${pose(q.b!)}, ${number(q.margin ?? 0)}, manifolds);`);
  else if (q.query === "closest") lines.push(`${space}::closest(a, ${pose(q.a)}, ${value(q.point!)});`);
  else if (q.query === "raycast")
    lines.push(`${space}::raycast(a, ${pose(q.a)}, {${value(q.ray!.origin)}, ${value(q.ray!.direction)}});`);
  else lines.push(`${space}::${q.query}(a, ${pose(q.a)}, b, ${pose(q.b!)});`);
  return lines.join("\n");
}

/** Empty where the language has another form for the question than a single call. */
export const codeOf = (q: Question): Record<Language, string> => ({ "C++": cpp(q), Python: python(q), JavaScript: javascript(q) });
