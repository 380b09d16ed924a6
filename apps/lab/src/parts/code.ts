// Programs in C++, Python and JavaScript that ask the question of a page, with its very numbers, and print the answer.
//
// Each is complete: C++ is compiled as it stands and linked with the library, Python needs the package `graze` and
// JavaScript the npm package. `tests/snippets.mjs` runs all of them and compares what they print with the answer of the
// query protocol.

import { whole } from "../graze.ts";
import {
  measures, pointsOf, radiusOf, sizeOf, type Body, type Question, type Shape, type Vec,
} from "../question.ts";

export type Language = "C++" | "Python" | "JavaScript";
/** The programs, without those in languages that have no call for the question. */
export type Programs = Partial<Record<Language, string>>;

// --- The parts that all three languages share ---

/** A shape as the call that makes it, under the names of C++. */
interface Made {
  kind: string;
  args: (number | Vec | Vec[])[];
  rounding: number;
}

/** Shapes of space whose measures the protocol has defaults for. */
const withDefaults = ["box", "sphere", "capsule", "cylinder"];
/** The call that makes a shape, with the protocol's defaults. Nothing for a shape that takes more than one call. */
function made(shape: Shape, flat: boolean): Made | undefined {
  const said = withDefaults.includes(shape.type) && !flat ? whole(shape) : shape;
  const m = measures<{ height: number; radiusBottom: number; radiusTop: number; radii: Vec; sizeX?: number; sizeZ?: number }>(said);
  const tall = [m.height, m.radiusBottom, m.radiusTop];
  const call = (kind: string, ...args: Made["args"]): Made => ({ kind, args, rounding: shape.margin ?? 0 });
  switch (shape.type) {
    case "box": return call("Box", sizeOf(said));
    case "sphere": return call("Sphere", radiusOf(said));
    case "circle": return call("Circle", radiusOf(shape));
    case "capsule": return call("Capsule", ...tall);
    case "cylinder": return call("Cylinder", ...tall);
    case "ellipsoid": return call("Ellipsoid", m.radii);
    case "ellipse": return call("Ellipse", m.radii);
    case "plane":
      if (flat) return call("HalfPlane");
      return m.sizeX === undefined ? call("HalfSpace") : call("Rectangle", m.sizeX, m.sizeZ ?? 0);
    case "segment": return call("Segment", ...pointsOf(shape));
    case "triangle": return call("Triangle", ...pointsOf(shape));
    case "convex": return call(flat ? "ConvexPolygon" : "ConvexHull", pointsOf(shape));
    case "polygon": return call("Polygon", pointsOf(shape));
    default: return undefined;
  }
}

const isZero = (v?: Vec | number): boolean => v === undefined || (typeof v === "number" ? v === 0 : v.every((x) => x === 0));
const isTurned = (rotation: Body["rotation"]): boolean =>
  Array.isArray(rotation) ? rotation.slice(0, 3).some((x) => x !== 0) : !isZero(rotation);
/** Whether a vector or quaternion is unit up to twelve digits; the protocol makes all others unit. */
const isUnit = (v: Vec): boolean => Math.abs(Math.hypot(...v) - 1) < 4e-12;
const unit = (v: Vec): Vec => (isUnit(v) ? v : v.map((x) => x / Math.hypot(...v)));
const zeros = (flat: boolean): Vec => (flat ? [0, 0] : [0, 0, 0]);
const massOf = (body: Body): number => (body.mass === "infinity" ? Infinity : Number(body.mass));

/** The way in which a language breaks a list over lines: the indent of items, and whether its end has its own line. */
interface Breaks { step: string; ends: boolean }
/** Items between brackets, on as many lines as they need; `indent` is that of the line on which they begin. */
function list(items: string[], [open, close]: string, { step, ends }: Breaks, indent = "", space = ""): string {
  const line = `${open}${space}${items.join(", ")}${space}${close}`;
  if (line.length <= 80) return line;
  const lines: string[] = [];
  for (const item of items) {
    const last = lines[lines.length - 1];
    if (last !== undefined && last.length + item.length < 90) lines[lines.length - 1] = `${last}, ${item}`;
    else lines.push(item);
  }
  const inner = lines.map((x) => `${indent}${step}${x}`).join(",\n");
  return ends ? `${open}\n${inner},\n${indent}${close}` : `${open}\n${inner}${close}`;
}

// --- JavaScript ---

function javascript(q: Question): string | undefined {
  const breaks: Breaks = { step: "  ", ends: true };
  const flat = q.dimension === 2, { query } = q, where = flat ? "plane." : "";
  const value = (v: Vec | number): string => (typeof v === "number" ? String(v) : `[${v.join(", ")}]`);
  const names = new Set(["init"]);
  const shape = (s: Shape): string | undefined => {
    const call = made(s, flat);
    if (!call) return undefined;
    const kind = call.kind === "ConvexPolygon" ? "Convex" : call.kind;
    names.add(flat ? "plane" : kind);
    const args = call.args.map((x) =>
      Array.isArray(x) && Array.isArray(x[0]) ? list((x as Vec[]).map(value), "[]", breaks) : value(x as Vec | number));
    return `new ${where}${kind}(${args.join(", ")})${call.rounding ? `.rounded(${call.rounding})` : ""}`;
  };
  const pose = (body: Body): string[] => {
    const keys: string[] = [];
    if (!isZero(body.translation)) keys.push(`translation: ${value(body.translation!)}`);
    if (isTurned(body.rotation))
      keys.push(`rotation: ${value(flat ? body.rotation! : unit(body.rotation as Vec))}`);
    return keys;
  };
  const moving = (body: Body): string[] => {
    const keys = pose(body);
    for (const key of ["linear", "angular"] as const) if (!isZero(body[key])) keys.push(`${key}: ${value(body[key]!)}`);
    return keys;
  };
  const object = (keys: string[]): string => (keys.length ? list(keys, "{}", breaks, "", " ") : "{}");

  const a = shape(q.a.shape), b = q.b && shape(q.b.shape);
  if (!a || (q.b && !b) || (query === "response" && flat)) return undefined;
  names.add(flat ? "plane" : query);
  const lines: string[] = [];
  const put = (name: string, text: string): void => { lines.push(`const ${name} = ${text};`); };
  put("a", a);
  if (b) put("b", b);
  const f = `${where}${query}`;
  const show = (...names: [label: string, member: string][]): string =>
    `console.log(${names.map(([label, member]) => `"${label}", ${member}`).join(", ")});`;
  if (query === "overlap" || query === "distance" || query === "contacts") {
    put("poseA", object(pose(q.a)));
    put("poseB", object(pose(q.b!)));
    const asked = `${f}(a, poseA, b, poseB`;
    if (query === "overlap") lines.push(`console.log(${asked}));`);
    else if (query === "distance") {
      put("found", `${asked})`);
      lines.push(show(["distance", "found.distance"], ["normal", "found.normal"]));
      lines.push(show(["on A", "found.a"], ["on B", "found.b"]));
    } else {
      lines.push(`const { overlap, manifolds } = ${asked}, ${q.margin ?? 0});`, 'console.log("overlap", overlap);');
      lines.push("for (const { normal, points } of manifolds) {", '  console.log("normal", normal);');
      lines.push('  for (const p of points) console.log("on A", p.a, "on B", p.b, "distance", p.distance);', "}");
    }
  } else if (query === "closest") {
    put("found", `${f}(a, ${object(pose(q.a))}, ${value(q.point!)})`);
    lines.push(show(["distance", "found.distance"], ["point", "found.point"], ["normal", "found.normal"]));
  } else if (query === "raycast") {
    const { origin, direction, length } = q.ray!;
    const keys = [`origin: ${value(origin)}`, `direction: ${value(direction)}`];
    if (length !== undefined) keys.push(`length: ${length}`);
    put("hit", `${f}(a, ${object(pose(q.a))}, ${object(keys)})`);
  } else if (query === "cast") {
    put("movingA", object(["shape: a", ...moving(q.a)]));
    put("movingB", object(["shape: b", ...moving(q.b!)]));
    put("hit", `${f}(movingA, movingB, { duration: ${q.duration ?? 1} })`);
  } else {
    const keys = [`point: ${value(q.contact!.point)}`, `normal: ${value(unit(q.contact!.normal))}`];
    put("contact", object([...keys, `restitution: ${q.restitution ?? 0}`, `friction: ${q.friction ?? 0.6}`]));
    put("struckA", object([`mass: ${massOf(q.a)}`, "shape: a", ...moving(q.a)]));
    put("struckB", object([`mass: ${massOf(q.b!)}`, "shape: b", ...moving(q.b!)]));
    put("found", "response(contact, struckA, struckB)");
    lines.push(show(["normal impulse", "found.normalImpulse"], ["impulse", "found.impulse"]));
    for (const w of ["a", "b"])
      lines.push(show([`${w.toUpperCase()} moves on with`, `found.${w}.linear`], ["turning", `found.${w}.angular`]));
  }
  if (query === "raycast" || query === "cast")
    lines.push(`if (hit) ${show(["t", "hit.t"], ["point", "hit.point"], ["normal", "hit.normal"])}`,
      'else console.log("no hit");');
  return [`import { ${[...names].join(", ")} } from "graze/double";`, "", "await init();", ...lines].join("\n");
}

// --- Python ---

function python(q: Question): string | undefined {
  const breaks: Breaks = { step: "    ", ends: true };
  if (q.query === "response") {
    // The package answers this query as a question of the protocol.
    const value = (x: unknown, indent = "    "): string => {
      if (Array.isArray(x)) return `[${x.join(", ")}]`;
      if (typeof x !== "object" || x === null) return JSON.stringify(x);
      return list(entries(x, `${indent}    `), "{}", breaks, indent);
    };
    const entries = (x: object, indent?: string): string[] =>
      Object.entries(x).filter(([, y]) => y !== undefined).map(([key, y]) => `"${key}": ${value(y, indent)}`);
    return ["import json", "", "import graze", "", "question = {", ...entries(q).map((x) => `    ${x},`), "}",
      "print(graze.answer(json.dumps(question)))"].join("\n");
  }
  const flat = q.dimension === 2, { query } = q, module = flat ? "plane" : "graze";
  const value = (v: Vec | number): string => (typeof v === "number" ? String(v) : `(${v.join(", ")})`);
  const shape = (s: Shape): string | undefined => {
    const call = made(s, flat);
    if (!call) return undefined;
    const ball = call.kind === "Sphere" || call.kind === "Circle";
    const args = call.args.map((x) => Array.isArray(x) && Array.isArray(x[0])
      ? list((x as Vec[]).map(value), "[]", breaks)
      : value(ball ? (x as number) + call.rounding : (x as Vec | number)));
    if (call.rounding && !ball) args.push(`rounding=${call.rounding}`);
    return `${module}.${call.kind}(${args.join(", ")})`;
  };
  const pose = (body: Body): string => {
    const args: string[] = [];
    if (!isZero(body.translation) || isTurned(body.rotation)) args.push(value(body.translation ?? zeros(flat)));
    if (isTurned(body.rotation)) args.push(value(body.rotation!));
    return `${module}.Pose${list(args, "()", breaks)}`;
  };
  const a = shape(q.a.shape), b = q.b && shape(q.b.shape);
  if (!a || (q.b && !b)) return undefined;
  const lines = [flat ? "from graze import plane" : "import graze", "", `a = ${a}`];
  if (b) lines.push(`b = ${b}`);
  lines.push(`pose_a = ${pose(q.a)}`);
  if (b) lines.push(`pose_b = ${pose(q.b!)}`);
  const f = `${module}.${query}`;
  if (query === "overlap") lines.push(`print(${f}(a, pose_a, b, pose_b))`);
  else if (query === "distance") {
    lines.push(`found = ${f}(a, pose_a, b, pose_b)`);
    lines.push('print("distance", found.distance, "normal", *found.normal)');
    lines.push('print("on A", *found.a, "on B", *found.b)');
  } else if (query === "contacts") {
    lines.push(`manifolds = ${f}(a, pose_a, b, pose_b, margin=${q.margin ?? 0})`, 'print("manifolds:", len(manifolds))');
    lines.push("for manifold in manifolds:", '    print("normal", *manifold.normal)', "    for p in manifold.points:");
    lines.push('        print("on A", *p.a, "on B", *p.b, "distance", p.distance)');
  } else if (query === "closest") {
    lines.push(`found = ${f}${list(["a", "pose_a", value(q.point!)], "()", breaks)}`);
    lines.push('print("distance", found.distance, "point", *found.point, "normal", *found.normal)');
  } else {
    if (query === "raycast") {
      const { origin, direction, length } = q.ray!;
      const end = length === undefined ? [] : [`length=${length}`];
      lines.push(`hit = ${f}${list(["a", "pose_a", `origin=${value(origin)}`, `direction=${value(direction)}`, ...end], "()", breaks)}`);
    } else {
      const linear = (body: Body): string => value(body.linear ?? zeros(flat));
      const turning = ([["angular_a", q.a], ["angular_b", q.b!]] as const)
        .filter(([, body]) => !isZero(body.angular)).map(([name, body]) => `, ${name}=${value(body.angular!)}`).join("");
      lines.push(`linear_a, linear_b = ${linear(q.a)}, ${linear(q.b!)}`);
      lines.push(`hit = ${f}(a, pose_a, linear_a, b, pose_b, linear_b, duration=${q.duration ?? 1}${turning})`);
    }
    lines.push("if hit:", '    print("t", hit.t, "point", *hit.point, "normal", *hit.normal)');
    lines.push("else:", '    print("no hit")');
  }
  return lines.join("\n");
}

// --- C++ ---

function cpp(q: Question): string | undefined {
  const breaks: Breaks = { step: "    ", ends: false };
  const flat = q.dimension === 2, { query } = q, space = flat ? "graze::plane" : "graze";
  const vec = (v: Vec): string => `{${v.join(", ")}}`;
  /** A number whose type a template is deduced from. */
  const real = (x: number): string => (/^-?\d+$/.test(String(x)) ? `${x}.0` : String(x));
  const lines: string[] = [];
  const includes = new Set(["<cstdio>"]);
  const shape = (name: string, s: Shape): boolean => {
    const call = made(s, flat);
    if (!call) return false;
    const args = call.args.map((x) => {
      if (typeof x === "number") return String(x);
      if (!Array.isArray(x[0])) return vec(x as Vec);
      includes.add("<vector>");
      const points = list((x as Vec[]).map(vec), "{}", breaks, "  ");
      lines.push(`  const std::vector<${space}::${flat ? "Vec2d" : "Vec3d"}> points_${name}${points};`);
      return `points_${name}`;
    });
    const text = `${space}::${call.kind}<double>(${args.join(", ")})`;
    const given = call.rounding ? `{${text}, ${call.rounding}}` : ` = ${text}`;
    lines.push(`  const ${space}::Shaped ${name}${given};`);
    return true;
  };
  const rotation = (body: Body): string => {
    if (flat) return `${space}::Rot2d::from_angle(${real(body.rotation as number)})`;
    const given = vec(body.rotation as Vec);
    return isUnit(body.rotation as Vec) ? given : `graze::normalized(graze::Quatd${given})`;
  };
  const pose = (name: string, body: Body): void => {
    const at = vec(body.translation ?? zeros(flat));
    const given = isTurned(body.rotation) ? list([at, rotation(body)], "{}", breaks, "  ") : isZero(body.translation) ? "{}" : `{${at}, {}}`;
    lines.push(`  const ${space}::${flat ? "Pose2d" : "Posed"} ${name}${given};`);
  };
  const axes = flat ? ["x", "y"] : ["x", "y", "z"];
  const format = `(${axes.map(() => "%.9g").join(", ")})`;
  const parts = (v: string): string => axes.map((x) => `${v}.${x}`).join(", ");
  /** A line of output: words with a value each, which is a number or a vector. */
  const show = (indent: string, ...values: [label: string, member: string, kind: "number" | "vector"][]): void => {
    const text = values.map(([label, , kind]) => `${label} ${kind === "vector" ? format : "%.9g"}`).join(", ");
    const args = values.map(([, member, kind]) => (kind === "vector" ? parts(member) : member));
    const line = `${indent}std::printf("${text}\\n", ${args.join(", ")});`;
    if (line.length <= 110) lines.push(line);
    else lines.push(`${indent}std::printf("${text}\\n",`,
      ...args.map((x, i) => `${indent}            ${x}${i + 1 < args.length ? "," : ");"}`));
  };

  if (query === "response" && flat) return undefined;
  const [a, b] = query === "response" ? ["shape_a", "shape_b"] : ["a", "b"];
  if (!shape(a, q.a.shape) || (q.b && !shape(b, q.b.shape))) return undefined;
  const f = `${space}::${query}`;
  if (query !== "response") {
    pose("pose_a", q.a);
    if (q.b) pose("pose_b", q.b);
    lines.push("");
  }
  if (query === "overlap")
    lines.push(`  std::printf("%s\\n", ${f}(a, pose_a, b, pose_b) ? "true" : "false");`);
  else if (query === "distance") {
    lines.push(`  const ${space}::Distance<double> found = ${f}(a, pose_a, b, pose_b);`);
    show("  ", ["distance", "found.distance", "number"], ["normal", "found.normal", "vector"]);
    show("  ", ["on A", "found.a", "vector"], ["on B", "found.b", "vector"]);
  } else if (query === "contacts") {
    lines.push(`  ${space}::Manifolds<double> manifolds;`);
    lines.push(`  const bool overlap = ${f}(a, pose_a, b, pose_b, ${real(q.margin ?? 0)}, manifolds);`);
    lines.push('  std::printf("overlap: %s\\n", overlap ? "true" : "false");', "  for (const auto& manifold : manifolds) {");
    show("    ", ["normal", "manifold.normal", "vector"]);
    lines.push("    for (const auto& p : manifold.points)");
    show("      ", ["on A", "p.a", "vector"], ["on B", "p.b", "vector"], ["distance", "p.distance", "number"]);
    lines.push("  }");
  } else if (query === "closest") {
    lines.push(`  const ${space}::Closest<double> found = ${f}(a, pose_a, ${vec(q.point!)});`);
    show("  ", ["distance", "found.distance", "number"], ["point", "found.point", "vector"],
      ["normal", "found.normal", "vector"]);
  } else if (query === "response") {
    for (const [name, body] of [["a", q.a], ["b", q.b!]] as const) {
      const motion = ["linear", "angular"].map((key) => `.${key} = ${vec((body[key as "linear"]) ?? zeros(flat))}`);
      motion.push(`.center = ${vec(body.translation ?? zeros(flat))}`);
      const mass = massOf(body), turned = isTurned(body.rotation) ? `, ${rotation(body)}` : "";
      lines.push(`  const graze::StruckBody<double> ${name}{`, `      .motion = ${list(motion, "{}", breaks, "      ")},`);
      lines.push(mass === Infinity ? "      .mass = {}};"
        : `      .mass = graze::inverse_mass(${real(mass)}, graze::inertia_of(shape_${name}, ${real(mass)})${turned})};`);
    }
    const { point, normal } = q.contact!;
    lines.push("  const graze::StruckContact<double> contact{", `      .point = ${vec(point)}, .normal = ${vec(unit(normal))},`
      + ` .restitution = ${q.restitution ?? 0}, .friction = ${q.friction ?? 0.6}};`, "");
    lines.push("  const graze::Response<double> found = graze::response(contact, a, b);");
    show("  ", ["normal impulse", "found.normal_impulse", "number"], ["impulse", "found.impulse", "vector"]);
    for (const w of ["a", "b"])
      show("  ", [`${w.toUpperCase()} moves on with`, `found.${w}.linear`, "vector"], ["turning", `found.${w}.angular`, "vector"]);
  } else {
    if (query === "raycast") {
      const { origin, direction, length } = q.ray!;
      lines.push(`  const ${space}::Ray<double> ray{${vec(origin)}, ${vec(direction)}};`);
      lines.push(`  const auto hit = ${f}(a, pose_a, ray${length === undefined ? "" : `, ${real(length)}`});`);
    } else {
      for (const [name, body] of [["velocity_a", q.a], ["velocity_b", q.b!]] as const) {
        const angular = body.angular ?? (flat ? 0 : zeros(flat));
        const turning = typeof angular === "number" ? String(angular) : vec(angular);
        lines.push(`  const ${space}::Velocity<double> ${name}{${vec(body.linear ?? zeros(flat))}, ${turning}};`);
      }
      lines.push(`  const auto hit = ${f}(a, pose_a, velocity_a, b, pose_b, velocity_b, ${real(q.duration ?? 1)});`);
    }
    lines.push("  if (hit)");
    show("    ", ["t", "hit->t", "number"], ["point", "hit->point", "vector"], ["normal", "hit->normal", "vector"]);
    lines.push("  else", '    std::printf("no hit\\n");');
  }
  return ["#include <graze/graze.hpp>", "", ...[...includes].map((x) => `#include ${x}`), "", "int main() {", ...lines, "}"]
    .join("\n");
}

export function codeOf(q: Question): Programs {
  const programs: Programs = {};
  for (const [language, write] of [["C++", cpp], ["Python", python], ["JavaScript", javascript]] as const) {
    const text = write(q);
    if (text) programs[language] = text;
  }
  return programs;
}
