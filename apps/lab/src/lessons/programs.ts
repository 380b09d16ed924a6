// Programs of lessons whose question is none of the query protocol, with the lesson's values: a support point of a
// large hull, broad phases over many frames, bodies with filters, and a stack that is simulated.

import type { Programs } from "../parts/code.ts";
import type { Vec } from "../question.ts";

const braces = (v: readonly (number | string)[]): string => `{${v.join(", ")}}`;
const brackets = (v: readonly (number | string)[]): string => `[${v.join(", ")}]`;
const tuple = (v: readonly (number | string)[]): string => `(${v.join(", ")})`;

/** The furthest point along `direction` of a hull of `count` points in a golden spiral on an ellipsoid. */
export const supportPrograms = (count: number, radii: Vec, direction: Vec): Programs => ({
  "C++": `#include <graze/graze.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

int main() {
  // Points of an ellipsoid along a golden spiral.
  std::vector<graze::Vec3d> points;
  for (int i = 0; i < ${count}; ++i) {
    const double y = 1 - (2 * i + 1) / ${count}.0, r = std::sqrt(1 - y * y);
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    points.push_back({${radii[0]} * r * std::cos(angle), ${radii[1]} * y, ${radii[2]} * r * std::sin(angle)});
  }
  const graze::Shaped hull = graze::ConvexHull<double>(points);
  const graze::Vec3d direction${braces(direction)};
  const graze::Vec3d furthest = graze::support(hull, direction);
  std::printf("furthest (%.9g, %.9g, %.9g), reach %.9g\\n", furthest.x, furthest.y, furthest.z,
              graze::dot(furthest, direction));
}`,
  Python: `import graze
import numpy as np

# Points of an ellipsoid along a golden spiral.
i = np.arange(${count})
y = 1 - (2 * i + 1) / ${count}
r = np.sqrt(1 - y * y)
angle = i * np.pi * (3 - np.sqrt(5))
points = np.stack([${radii[0]} * r * np.cos(angle), ${radii[1]} * y, ${radii[2]} * r * np.sin(angle)], axis=1)
hull = graze.ConvexHull(points)
direction = ${tuple(direction)}
furthest = hull.support(direction)
print("furthest", *furthest, "reach", np.dot(furthest, direction))`,
  JavaScript: `import { init, ConvexHull } from "graze/double";

await init();
// Points of an ellipsoid along a golden spiral.
const points = Array.from({ length: ${count} }, (_, i) => {
  const y = 1 - (2 * i + 1) / ${count}, r = Math.sqrt(1 - y * y), angle = i * Math.PI * (3 - Math.sqrt(5));
  return [${radii[0]} * r * Math.cos(angle), ${radii[1]} * y, ${radii[2]} * r * Math.sin(angle)];
});
const hull = new ConvexHull(points);
const direction = ${brackets(direction)};
const furthest = hull.support(direction);
console.log("furthest", furthest, "reach", furthest.reduce((sum, x, k) => sum + x * direction[k], 0));`,
});

interface Crowd {
  kind: string;
  count: number;
  frames: number;
  /** The centres of the bodies begin in a cube of this edge. */
  spread: number;
  /** The half edge of the first body, if it is larger than all others. */
  giant?: number;
  /** Bodies are somewhere else in each frame, instead of moving. */
  teleport: boolean;
}
const snake = (name: string): string => name.replace(/[A-Z]/g, (x) => `_${x.toLowerCase()}`);

/** The number of pairs of boxes that a broad phase finds in each frame. Python has worlds, and no broad phase alone. */
export function broadPhasePrograms({ kind, count, frames, spread, giant, teleport }: Crowd): Programs {
  const motion = teleport ? "Bodies are somewhere else in each frame" : "Bodies move there and back between walls";
  return {
    "C++": `#include <graze/graze.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

struct Body {
  double center[3], half[3], velocity[3];
};
// A linear congruential generator: the same bodies for everybody.
std::uint32_t seed = 7;
double next_random() { return (seed = seed * 1664525u + 1013904223u) / 4294967296.0; }
${teleport ? "" : `// Walls throw back what leaves [-3, 3].
double between_walls(double x) {
  const double y = std::fmod(x + 9, 12);
  return y < 6 ? y - 3 : 9 - y;
}
`}
int main() {
  std::vector<Body> bodies(${count});
  for (Body& body : bodies) {
    for (double& x : body.center) x = (next_random() - 0.5) * ${spread};
${giant === undefined ? "    for (double& x : body.half) x = 0.12 + next_random() * 0.2;"
    : `    for (double& x : body.half) x = &body == &bodies[0] ? ${giant} : 0.12 + next_random() * 0.2;`}
    for (double& x : body.velocity) x = (next_random() - 0.5) * 0.12;
  }
  // ${motion}.
  const auto broad_phase = graze::make_${snake(kind)}<double>();
  std::vector<graze::IdPair> pairs;
  for (std::uint32_t frame = 0; frame < ${frames}; ++frame) {
    for (std::uint32_t id = 0; id < bodies.size(); ++id) {
      const Body& body = bodies[id];
      double place[3];
      for (std::uint32_t k = 0; k < 3; ++k)
        place[k] = ${teleport ? "((id * 3 + k + 1) * (2654435761u + frame * 40503u) / 4294967296.0 - 0.5) * 6"
    : "between_walls(body.center[k] + body.velocity[k] * frame)"};
      const graze::Vec3d center{place[0], place[1], place[2]}, half{body.half[0], body.half[1], body.half[2]};
      const graze::Aabbd box{center - half, center + half};
      frame == 0 ? broad_phase->insert(id, box) : broad_phase->move(id, box);
    }
    pairs.clear();
    broad_phase->pairs(pairs);
    std::printf("%zu pairs\\n", pairs.size());
  }
}`,
    JavaScript: `import { init, BroadPhase } from "graze/double";

await init();
// A linear congruential generator: the same bodies for everybody.
let seed = 7;
const random = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
const three = (make) => [make(0), make(1), make(2)];
const bodies = Array.from({ length: ${count} }, (_, i) => ({
  center: three(() => (random() - 0.5) * ${spread}),
  half: ${giant === undefined ? "" : `i === 0 ? three(() => ${giant}) : `}three(() => 0.12 + random() * 0.2),
  velocity: three(() => (random() - 0.5) * 0.12),
}));
${teleport ? "" : `// Walls throw back what leaves [-3, 3].
const betweenWalls = (x) => {
  const y = (x + 9) % 12;
  return y < 6 ? y - 3 : 9 - y;
};
`}// ${motion}.
const broadPhase = new BroadPhase("${kind}");
for (let frame = 0; frame < ${frames}; frame++) {
  bodies.forEach((body, id) => {
    const place = three((k) => ${teleport
    ? "((Math.imul(id * 3 + k + 1, 2654435761 + frame * 40503) >>> 0) / 2 ** 32 - 0.5) * 6"
    : "betweenWalls(body.center[k] + body.velocity[k] * frame)"});
    const lower = place.map((x, k) => x - body.half[k]), upper = place.map((x, k) => x + body.half[k]);
    if (frame === 0) broadPhase.insert(id, lower, upper);
    else broadPhase.move(id, lower, upper);
  });
  console.log(broadPhase.pairs().length / 2, "pairs");
}`,
  };
}

interface Filtered { name: string; category: number; mask: number; group: number; at: Vec }

/** The pairs of several balls of one radius that collide, as their filters and places decide. */
export function filterPrograms(radius: number, bodies: Filtered[]): Programs {
  const bits = (x: number): string => (x > 15 ? String(x) : `0b${x.toString(2).padStart(4, "0")}`);
  const rows = (row: (b: Filtered) => string): string => bodies.map((b) => `${row(b)},\n`).join("");
  return {
    "C++": `#include <graze/graze.hpp>

#include <cstdio>
#include <vector>

struct Ball {
  const char* name;
  graze::Filter filter;
  graze::Posed pose;
};

int main() {
  const graze::Shaped ball = graze::Sphere<double>(${radius});
  // Category, mask, group; and where it is.
  const std::vector<Ball> balls{
${rows((b) => `      {"${b.name}", {${bits(b.category)}, ${bits(b.mask)}, ${b.group}}, {${braces(b.at)}, {}}}`)}  };
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const Ball &a = balls[i], &b = balls[j];
      const bool collide = graze::may_collide(a.filter, b.filter) && graze::overlap(ball, a.pose, ball, b.pose);
      std::printf("%s and %s collide: %s\\n", a.name, b.name, collide ? "true" : "false");
    }
}`,
    Python: `import graze

ball = graze.Sphere(${radius})
# Name; category, mask, group; and where it is.
balls = [
${rows((b) => `    ("${b.name}", graze.Filter(${bits(b.category)}, ${bits(b.mask)}, ${b.group}), ${tuple(b.at)})`)}]
world = graze.World()
for name, filter, at in balls:
    world.add(ball, at, filter=filter)
world.update()
reported = {(pair["a"], pair["b"]) for pair in world.pairs if pair["overlap"]}
for i in range(len(balls)):
    for j in range(i + 1, len(balls)):
        print(balls[i][0], "and", balls[j][0], "collide:", (i, j) in reported)`,
    JavaScript: `import { init, Sphere, World } from "graze/double";

await init();
const ball = new Sphere(${radius});
const balls = [
${rows((b) => `  { name: "${b.name}", filter: { category: ${bits(b.category)}, mask: ${bits(b.mask)}, group: ${b.group} }, translation: ${brackets(b.at)} }`)}];
const world = new World();
for (const { filter, translation } of balls) world.add({ shape: ball, translation, filter });
world.update();
const reported = new Set(world.contacts().filter((pair) => pair.overlap).map((pair) => \`\${pair.a} \${pair.b}\`));
for (let i = 0; i < balls.length; i++)
  for (let j = i + 1; j < balls.length; j++)
    console.log(balls[i].name, "and", balls[j].name, "collide:", reported.has(\`\${i} \${j}\`));`,
  };
}

export interface Stack {
  boxes: number;
  /** Steps a second, and how many are taken. */
  rate: number;
  steps: number;
  /** The sub-steps of each step; null for the library's own choice. */
  subSteps: number | null;
  /** Whether sub-steps begin with the impulses of the last one. */
  warm: boolean;
  /** Of the top box, and where it begins. */
  mass: number;
  top: Vec;
  friction: number;
}
/** The deepest contact of a stack of boxes, and where its top box comes to. */
export function stackPrograms({ boxes, rate, steps, subSteps, warm, mass, top, friction }: Stack): Programs {
  const last = boxes - 1;
  const settings = {
    cpp: (warm ? "" : "  settings.warm_start = false;\n") + (subSteps === null ? "" : `  settings.sub_steps = settings.most_sub_steps = ${subSteps};\n`),
    python: (warm ? "" : ", warm_start=False") + (subSteps === null ? "" : `, sub_steps=${subSteps}, most_sub_steps=${subSteps}`),
    js: (warm ? "" : ", warmStart: false") + (subSteps === null ? "" : `, subSteps: ${subSteps}, mostSubSteps: ${subSteps}`),
  };
  return {
    "C++": `#include <graze/graze.hpp>

#include <cstdio>

int main() {
  graze::SimulationSettings<double> settings;
  settings.sleep = false;
${settings.cpp}  graze::Simulationd simulation(settings);
  graze::Material<double> rough;
  rough.static_friction = rough.dynamic_friction = ${friction};
  graze::Body<double> floor{graze::HalfSpace<double>()};
  floor.fixed = true;
  simulation.add(floor, {}, rough);
  // Each box stands a little beside the one below.
  const graze::Shaped box = graze::Box<double>({1, 1, 1});
  graze::BodyId top;
  for (int i = 0; i < ${boxes}; ++i) {
    graze::Dynamics<double> dynamics;
    dynamics.mass = i == ${last} ? ${mass} : 1;
    graze::Vec3d place{i % 2 == 0 ? 0.04 : -0.04, 0.5 + i, 0};
    if (i == ${last}) place = ${braces(top)};
    top = simulation.add({box, {place, {}}}, dynamics, rough);
  }
  for (int step = 0; step < ${steps}; ++step) simulation.step(1.0 / ${rate});
  const graze::Vec3d place = simulation.poses()[top.index].translation;
  std::printf("deepest contact %.9g, top box at (%.9g, %.9g, %.9g)\\n", simulation.report().deepest, place.x, place.y,
              place.z);
}`,
    Python: `import graze

simulation = graze.Simulation(sleep=False${settings.python})
rough = graze.Material(static_friction=${friction}, dynamic_friction=${friction})
simulation.add(graze.HalfSpace(), fixed=True, material=rough)
# Each box stands a little beside the one below.
box = graze.Box((1, 1, 1))
for i in range(${boxes}):
    place = (0.04 if i % 2 == 0 else -0.04, 0.5 + i, 0)
    if i == ${last}:
        place = ${tuple(top)}
    top = simulation.add(box, place, mass=${mass} if i == ${last} else 1, material=rough)
for _ in range(${steps}):
    simulation.step(1 / ${rate})
print("deepest contact", simulation.report["deepest"], "top box at", *simulation.pose(top).translation)`,
    JavaScript: `import { init, Box, HalfSpace, Simulation } from "graze/double";

await init();
const simulation = new Simulation({ sleep: false${settings.js} });
const rough = { staticFriction: ${friction}, dynamicFriction: ${friction} };
simulation.add({ shape: new HalfSpace(), fixed: true }, {}, rough);
// Each box stands a little beside the one below.
const box = new Box([1, 1, 1]);
let top;
for (let i = 0; i < ${boxes}; i++) {
  const beside = [i % 2 === 0 ? 0.04 : -0.04, 0.5 + i, 0];
  const translation = i === ${last} ? ${brackets(top)} : beside;
  top = simulation.add({ shape: box, translation }, { mass: i === ${last} ? ${mass} : 1 }, rough);
}
for (let step = 0; step < ${steps}; step++) simulation.step(1 / ${rate});
console.log("deepest contact", simulation.report().deepest, "top box at", simulation.pose(top).translation);`,
  };
}
