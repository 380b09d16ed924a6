// Checks of the package that run in Node and in a browser alike: each is a name and a function of the three entries.

import { close, equal, ok, throws } from "./assert.js";

/** Numbers that are the same on every machine (a linear congruential generator, Numerical Recipes). */
function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
const vector = (next, reach) => [0, 1, 2].map(() => (2 * next() - 1) * reach);
function rotation(next) {
  const q = [next() - 0.5, next() - 0.5, next() - 0.5, next() - 0.5];
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
}

/** One of each shape: how it is made, and what the query protocol calls it. */
function zoo(graze) {
  const points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
  const heights = [0, 0.25, 0, null, 0.5, 0.25, 0, 0.125, 0];
  return [
    [new graze.Sphere(0.5), { type: "sphere", sphere: { radius: 0.5 } }],
    [new graze.Capsule(1, 0.25, 0.5), { type: "capsule", capsule: { height: 1, radiusBottom: 0.25, radiusTop: 0.5 } }],
    [new graze.Box([1, 2, 0.5]), { type: "box", box: { size: [1, 2, 0.5] } }],
    [new graze.Rectangle(1, 2), { type: "plane", plane: { sizeX: 1, sizeZ: 2 } }],
    [new graze.Cylinder(1, 0.5), { type: "cylinder", cylinder: { height: 1, radiusBottom: 0.5, radiusTop: 0.5 } }],
    [new graze.Ellipsoid([1, 0.5, 0.25]), { type: "ellipsoid", ellipsoid: { radii: [1, 0.5, 0.25] } }],
    [new graze.Triangle(...points.slice(0, 3)), { type: "triangle", triangle: { points: points.slice(0, 3) } }],
    [new graze.ConvexHull(points), { type: "convex", convex: { points } }],
    [new graze.HalfSpace(), { type: "plane" }],
    [new graze.Mesh(points, triangles, { solid: true }), { type: "mesh", mesh: { points, triangles, solid: true } }],
    [
      new graze.HeightField(heights, 3, 3, { spacing: [1, 0.5] }),
      { type: "heightfield", heightfield: { columns: 3, rows: 3, spacing: [1, 0.5], heights } },
    ],
    [new graze.Box([1, 1, 1]).rounded(0.125), { type: "box", margin: 0.125, box: { size: [1, 1, 1] } }],
  ];
}

/** What the protocol's answer has of a status, in the words of the package. */
const status = (answer) => ("bounded" in answer ? { certainty: "bounded", error: answer.bounded } : { certainty: "converged" });

export const checks = [
  ["versions and refusals", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries]) {
      ok(/^\d+\.\d+\.\d+$/.test(entry.version()), "a version");
      throws(() => new entry.Box([1, -2, 1]), "size[1]: expected a finite number >= 0, got -2", entry.InvalidValue);
      throws(() => new entry.Box([1, 2]), "box.size: expected 3 numbers, got 2", entry.InvalidValue);
      throws(() => entry.overlap({}, {}, {}, {}), "a: expected a Shape, got Object", entry.InvalidValue);
      const ball = new entry.Sphere(1);
      throws(
        () => entry.overlap(ball, { rotation: [0, 0, 0, 2] }, ball, {}),
        "pose_a.rotation: expected a quaternion of unit length, got [0, 0, 0, 2]", entry.InvalidValue);
      ball.dispose();
      ball.dispose();
      ok(ball.disposed, "disposed");
      throws(() => entry.overlap(ball, {}, ball, {}), "a: expected a live object, got a disposed one", entry.InvalidValue);
    }
    throws(() => graze.overlap(new queries.Sphere(1), {}, new graze.Sphere(1), {}), "a: expected a Shape, got Sphere");
  }],

  ["every pair has the answer of the query protocol", ({ double: graze }) => {
    const next = random(7);
    const shapes = zoo(graze);
    let asked = 0;
    for (const [a, shapeA] of shapes)
      for (const [b, shapeB] of shapes) {
        const poseA = { translation: vector(next, 0.5), rotation: rotation(next) };
        const poseB = { translation: vector(next, 1.5), rotation: rotation(next) };
        const pair = { a: { shape: shapeA, ...poseA }, b: { shape: shapeB, ...poseB } };
        const ask = (question) => JSON.parse(graze.query(JSON.stringify({ ...pair, ...question })));
        // The protocol normalises what it reads, which is of unit length already: one rounding apart.
        equal(graze.overlap(a, poseA, b, poseB), ask({ query: "overlap" }).overlap, "overlap");
        const told = ask({ query: "distance" });
        const near = graze.distance(a, poseA, b, poseB);
        if ("error" in told) equal(near.certainty, "unbounded", "certainty");
        else {
          close(near.distance, told.distance, 1e-9, JSON.stringify(pair));
          // Along a smooth surface the nearest point shifts by the root of what its distance does.
          const apart = near.b.map((x, i) => x - near.a[i]);
          close(apart, told.normal.map((x) => x * told.distance), 1e-6, JSON.stringify(pair));
        }
        asked += 1;
      }
    equal(asked, shapes.length ** 2, "pairs");
  }],

  ["the same bits as the protocol where poses are not turned", ({ double: graze }) => {
    const next = random(11);
    for (const [a, shapeA] of zoo(graze))
      for (const [b, shapeB] of zoo(graze)) {
        const at = { translation: vector(next, 1.25) };
        const pair = { a: { shape: shapeA }, b: { shape: shapeB, ...at } };
        const ask = (question) => JSON.parse(graze.query(JSON.stringify({ ...pair, ...question })));
        const told = ask({ query: "distance" });
        const { error, certainty, ...distance } = graze.distance(a, {}, b, at);
        if ("error" in told) continue;
        const { bounded, ...rest } = told;
        // JSON has no -0.
        const plain = (value) => JSON.parse(JSON.stringify(value), (_, v) => (v === 0 ? 0 : v));
        equal(plain(distance), rest, JSON.stringify(pair));
        equal(certainty, status(told).certainty, "certainty");
        const found = graze.contacts(a, {}, b, at, 0.25);
        const listed = ask({ query: "contacts", margin: 0.25 });
        equal(found.overlap, listed.overlap, "overlap of contacts");
        const seen = found.manifolds.map((m) => ({
          normal: m.normal, points: m.points.map((p) => ({ a: p.a, b: p.b, distance: p.distance })) }));
        const wanted = listed.manifolds.map((m) => ({
          normal: m.normal, points: m.points.map((p) => ({ a: p.a, b: p.b, distance: p.distance })) }));
        equal(plain(seen), wanted, "manifolds");
      }
  }],

  ["rays, casts and closest points", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries]) {
      const box = new entry.Box([2, 2, 2]);
      const ball = new entry.Sphere(0.5);
      const hit = entry.raycast(box, {}, { origin: [-5, 0, 0], direction: [2, 0, 0] });
      equal([hit.t, hit.point, hit.normal], [4, [-1, 0, 0], [-1, 0, 0]], "ray");
      equal(entry.raycast(box, {}, { origin: [-5, 0, 0], direction: [2, 0, 0], length: 3 }), null, "short ray");
      equal(entry.raycastAny(box, {}, { origin: [-5, 3, 0], direction: [1, 0, 0] }), false, "ray beside");
      equal(entry.raycastAll(box, {}, { origin: [-5, 0, 0], direction: [1, 0, 0] }).length, 1, "hits");
      // A surface of one triangle is met as the triangle alone, along whichever axis the ray is longest.
      const corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0]];
      const triangle = new entry.Triangle(...corners), mesh = new entry.Mesh(corners, [[0, 1, 2]]);
      const field = new entry.HeightField([0, 0, 0, 0], 2, 2);
      for (const direction of [[3, 0.5, -1], [-3, 0.5, -1], [0.5, 3, -1], [0.5, -3, -1], [0.5, 0.5, -1]]) {
        const ray = { origin: direction.map((d, i) => (i < 2 ? 0.5 : 0) - d), direction };
        const t = entry.raycast(triangle, {}, ray).t;
        close(entry.raycast(mesh, {}, ray)?.t, t, 1e-6, `mesh, ray along ${direction}`);
        equal(entry.raycastAny(mesh, {}, ray), true, `any of a mesh, ray along ${direction}`);
        const [x, y, z] = ray.origin;
        const level = { origin: [x - 0.25, z, y - 0.6], direction: [direction[0], direction[2], direction[1]] };
        const onField = entry.raycast(field, {}, level);
        close(onField?.t, t, 1e-6, `height field, ray along ${direction}`);
      }
      const near = entry.closest(box, {}, [3, 0, 0]);
      equal([near.distance, near.point, near.normal], [2, [1, 0, 0], [1, 0, 0]], "closest");
      const cast = entry.cast({ shape: box }, { shape: ball, translation: [9, 0, 0], linear: [-15, 0, 0] });
      close(cast.t, 0.5, 1e-6, "time");
      close(cast.normal, [1, 0, 0], 1e-6, "normal");
      equal(entry.cast({ shape: box }, { shape: ball, translation: [9, 0, 0], linear: [15, 0, 0] }), null, "parting");
      equal(entry.castAll({ shape: box }, { shape: ball, translation: [9, 0, 0], linear: [-15, 0, 0] }).length, 1);
      const there = entry.poseAt({ translation: [1, 0, 0], linear: [2, 0, 0], angular: [0, Math.PI, 0] }, 0.5);
      close([there.translation, there.rotation], [[2, 0, 0], [0, Math.SQRT1_2, 0, Math.SQRT1_2]], 1e-6, "pose");
      equal(entry.distanceUpTo(box, {}, ball, { translation: [9, 0, 0] }, 2), null, "far");
      equal(entry.within(box, {}, ball, { translation: [3, 0, 0] }, 2), true, "within");
      equal(entry.mayOverlap(box, {}, ball, {}), true, "may overlap");
      equal(entry.alongPlanes([1, -1, -1], [[0, 1, 0], [0, 0, 1]]), [1, 0, 0], "along two planes");
      equal(entry.alongPlanes([1, -1, 0], []), [1, -1, 0], "along none");
      ok(entry.contactMargin(box, ball) > 0, "a margin");
      for (const { a, feature } of entry.contacts(box, {}, box, { translation: [0.5, 1.75, 0.25] }).manifolds[0].points) {
        const corners = entry.featureCorners(box, feature >>> 16);
        ok(corners.length > 0 && corners.every((c) => c[1] === a[1]), "a feature of the upper face");
      }
      equal(entry.featureCorners(box, 3 * 2 ** 14 + 3).length, 4, "corners of a face");
      equal(entry.featureCorners(ball, 1 << 14).length, 0, "corners of a ball");
      equal(entry.nearPieces(box, {}, ball, { translation: [2, 0, 0] }, 1)[0].distance.distance, 0.5, "piece");
      equal(entry.contacts(box, {}, box, { translation: [0, 1.75, 0] }).manifolds[0].points.length, 4, "points");
      equal(entry.contacts(box, {}, box, { translation: [0, 1.75, 0] }, 0, 2).manifolds[0].points.length, 2, "two points");
      const pose = entry.turned([1, 2, 3], [0, 2, 0], Math.PI / 2);
      close([pose.translation, pose.rotation], [[1, 2, 3], [0, Math.SQRT1_2, 0, Math.SQRT1_2]], 1e-6, "turned");
    }
  }],

  ["what is known of a shape", ({ graze }) => {
    const capsule = new graze.Capsule(2, 0.5);
    equal([capsule.kind, capsule.rounding], ["capsule", 0], "capsule");
    const { lower, upper } = capsule.bounds({ translation: [1, 0, 0] });
    close([lower, upper], [[0.5, -1.5, -0.5], [1.5, 1.5, 0.5]], 1e-5, "bounds");
    equal(capsule.support([0, 1, 0]), [0, 1.5, 0], "support");
    const mass = new graze.Box([1, 2, 3]).massProperties();
    close([mass.volume, mass.center, mass.inertia[0][0]], [6, 0, 0, 0, 6.5], 1e-5, "mass");
    equal(new graze.Box([1, 1, 1]).rounded(0.25).rounding, 0.25, "rounding");
    const swept = new graze.Sphere(1).swept({}, [3, 0, 0]);
    close(swept.bounds().upper, [4, 1, 1], 1e-4, "swept");
    const both = new graze.Compound([
      { shape: capsule, translation: [-2, 0, 0] },
      { shape: new graze.Sphere(1), translation: [2, 0, 0] }]);
    equal(both.kind, "compound", "kind");
    close([both.bounds().lower, both.bounds().upper], [[-2.5, -1.5, -1], [3, 1.5, 1]], 1e-4, "compound");
    equal(new graze.Segment([0, 0, 0], [1, 0, 0]).kind, "segment", "segment");
    const faces = graze.tessellate(new graze.Box([1, 2, 4]), { translation: [9, 0, 0] });
    equal([faces.points.length, faces.loops.map((loop) => loop.length)], [8, [4, 4, 4, 4, 4, 4]], "the faces of a box");
    ok(faces.closed && !faces.smooth && faces.points.every((p) => Math.abs(p[0] - 9) === 0.5 && Math.abs(p[2]) === 2), "its corners");
    ok(graze.tessellate(new graze.Sphere(2), {}).points.every((p) => Math.abs(Math.hypot(...p) - 2) < 1e-6), "on the ball");
    throws(() => new graze.HeightField([0, 0, 0], 2, 2), "heightField.heights: expected 2 * 2 numbers, got 3");
    throws(() => new graze.Mesh([0, 0], [0, 1, 2]), "mesh.points: expected a multiple of 3 numbers, got 2");
  }],

  ["a shape tells what it was made of", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries]) {
      const { memoryInUse, InvalidValue } = entry;
      const points = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
      const triangles = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
      const heights = [0, 0.25, 0, null, 0.5, 0.25];
      const rows = [[0, 0, 0], [1, 0, 0], [0, 1, 0]];
      const made = [
        [new entry.Sphere(0.5, [1, 2, 3]), { kind: "sphere", convex: true, radius: 0.5, center: [1, 2, 3] }],
        [new entry.Capsule(1, 0.25, 0.5), { kind: "capsule", convex: true, height: 1, radiusBottom: 0.25, radiusTop: 0.5 }],
        [new entry.Box([1, 2, 3]).rounded(0.25), { kind: "box", convex: true, size: [1, 2, 3] }],
        [new entry.Rectangle(1, 2), { kind: "rectangle", convex: true, sizeX: 1, sizeZ: 2 }],
        [new entry.Cylinder(2, 0.5, 0), { kind: "cylinder", convex: true, height: 2, radiusBottom: 0.5, radiusTop: 0 }],
        [new entry.Ellipsoid([1, 2, 3]), { kind: "ellipsoid", convex: true, radii: [1, 2, 3] }],
        [new entry.Segment(...rows.slice(1)), { kind: "segment", convex: true }],
        [new entry.Triangle(...rows), { kind: "triangle", convex: true }],
        [new entry.HalfSpace(), { kind: "halfSpace", convex: true }],
        [new entry.UserConvex((d) => d.map(Math.sign)), { kind: "userConvex", convex: true }],
        [new entry.Mesh(points, triangles, { solid: true }), { kind: "mesh", convex: false, closed: true, solid: true, sides: "both" }],
        [new entry.Mesh(points, triangles.slice(0, 9), { sides: "front" }),
         { kind: "mesh", convex: false, closed: false, solid: false, sides: "front" }],
        [new entry.HeightField(heights, 3, 2, { spacing: [1, 0.5], sides: "front" }),
         { kind: "heightField", convex: false, columns: 3, rows: 2, spacing: [1, 0.5], sides: "front" }]];
      for (const [shape, measures] of made) equal(shape.measures(), measures, "measures");
      const shapeOf = (kind) => made.find(([, measures]) => measures.kind === kind)[0];
      const hull = new entry.ConvexHull(points);
      const { tolerance, ...rest } = hull.measures();
      ok(rest.kind === "convexHull" && tolerance > 0 && tolerance < 1e-3, "a tolerance");
      equal([hull.points().length, [...shapeOf("segment").points()], [...shapeOf("triangle").points()]],
            [12, rows.slice(1).flat(), rows.flat()], "points");
      const mesh = shapeOf("mesh");
      equal([[...mesh.points()], [...mesh.triangles()]], [points, triangles], "a mesh");
      const again = new entry.Mesh(mesh.points(), mesh.triangles(), { solid: true });
      equal(again.findings(), mesh.findings(), "a mesh of what it was made of");
      const field = shapeOf("heightField").heights();
      equal([...field].map((h) => (Number.isNaN(h) ? null : h)), heights, "heights");
      ok(field instanceof (entry === double ? Float64Array : Float32Array), "in the entry's numbers");
      const box = shapeOf("box");
      const both = new entry.Compound([{ shape: box, translation: [1, 2, 3] }, { shape: again, rotation: [0, 0, 1, 0] }]);
      equal(both.measures(), { kind: "compound", convex: false, children: 2 }, "a compound");
      const before = memoryInUse();
      const children = both.children();
      equal(children.map(({ shape, ...at }) => [shape.kind, shape.rounding, at]), [
        ["box", 0.25, { translation: [1, 2, 3], rotation: [0, 0, 0, 1] }],
        ["mesh", 0, { translation: [0, 0, 0], rotation: [0, 0, 1, 0] }]], "children");
      for (const { shape } of children) shape.dispose();
      equal(memoryInUse(), before, "memory of shares");
      const refused = (act, message) => throws(act, message, InvalidValue);
      refused(() => box.points(), "shape: expected a convex hull, a mesh, a triangle or a segment, got box");
      refused(() => box.triangles(), "mesh: expected a mesh, got box");
      refused(() => mesh.heights(), "field: expected a height field, got mesh");
      refused(() => box.children(), "compound: expected a compound, got box");
      for (const [shape] of made) shape.dispose();
      refused(() => box.measures(), "shape: expected a live object, got a disposed one");
      for (const shape of [hull, again, both]) shape.dispose();
      if (entry.plane === undefined) continue;

      const { plane } = entry;
      const corners = [0, 0, 1, 0, 0, 1];
      const flat = [
        [new plane.Circle(0.5), { kind: "circle", convex: true, radius: 0.5 }],
        [new plane.Capsule(1, 0.25, 0.5), { kind: "capsule", convex: true, height: 1, radiusBottom: 0.25, radiusTop: 0.5 }],
        [new plane.Box([1, 2]), { kind: "box", convex: true, size: [1, 2] }],
        [new plane.Ellipse([1, 2]), { kind: "ellipse", convex: true, radii: [1, 2] }],
        [new plane.Segment([0, 0], [1, 0]), { kind: "segment", convex: true }],
        [new plane.Convex(corners), { kind: "convex", convex: true }],
        [new plane.UserConvex((d) => d.map(Math.sign)), { kind: "userConvex", convex: true }],
        [new plane.HalfPlane(), { kind: "halfPlane", convex: true }],
        [new plane.Polygon(corners), { kind: "polygon", convex: false }],
        [new plane.Chain(corners, { closed: true }), { kind: "chain", convex: false, closed: true, sides: "both" }],
        [new plane.Chain(corners, { sides: "front" }), { kind: "chain", convex: false, closed: false, sides: "front" }]];
      for (const [shape, measures] of flat) equal(shape.measures(), measures, "measures in the plane");
      for (const place of [5, 8, 9, 10]) equal([...flat[place][0].points()], corners, "corners");
      const circle = flat[0][0];
      const two = new plane.Compound([{ shape: circle, translation: [1, 2], rotation: 0.5 }]);
      const [child] = two.children();
      equal([two.measures().children, child.shape.kind, child.translation], [1, "circle", [1, 2]], "a child");
      close(child.rotation, 0.5, 1e-6, "its rotation");
      refused(() => circle.points(), "shape: expected a segment, a convex polygon, a polygon or a chain, got circle");
      refused(() => circle.children(), "compound: expected a compound, got circle");
      for (const shape of [child.shape, two, ...flat.map(([shape]) => shape)]) shape.dispose();
    }
  }],

  // The numbers are those of compose, relative, inverse, transform and inverse_transform of C++.
  ["poses are composed and applied with the bits of C++", ({ graze, double, queries }) => {
    const a = { translation: [1, -2.5, 3.25], rotation: [0.1, -0.3, 0.7, 0.64] };
    const b = { translation: [-7.125, 0.3, 11], rotation: [0.5, 0.4, -0.2, 0.74] };
    const point = [0.1, 20.7, -3.3];
    const pose = (translation, rotation) => ({ translation, rotation });
    const inDouble = {
      composed: pose([-0.8308, -14.484500000000001, 8.2289], [0.17400000000000004, 0.404, 0.5800000000000001, 0.6836]),
      seen: pose([7.701799999999998, 5.5045, 6.648100000000002],
                 [0.46599999999999997, 0.10799999999999998, -0.8360000000000001, 0.26360000000000006]),
      undone: pose([0.547, 1.905, -3.726], [-0.1, 0.3, -0.7, 0.64]),
      there: [-17.999999999999996, -0.6079999999999934, -5.3819999999999979],
      back: [16.107, 2.7730000000000032, -17.733999999999998],
      flat: [[-4.642765890573288, -6.860598365383202], [-4.410533247420934, 7.375826833202807],
             [-12.258821907091754, 13.396655045512679], [14.257492375358392, 18.324134663514055]] };
    const inFloat = {
      composed: pose([-0.83080101013183594, -14.484498977661133, 8.2288990020751953],
                     [0.17399999499320984, 0.40399998426437378, 0.57999998331069946, 0.68360000848770142]),
      seen: pose([7.7017998695373535, 5.5045008659362793, 6.6481003761291504],
                 [0.46599999070167542, 0.10800004005432129, -0.83600002527236938, 0.26359999179840088]),
      undone: pose([0.54699993133544922, 1.9050000905990601, -3.7259998321533203],
                   [-0.10000000149011612, 0.30000001192092896, -0.69999998807907104, 0.63999998569488525]),
      there: [-18, -0.608001708984375, -5.3820009231567383],
      back: [16.107000350952148, 2.7730026245117188, -17.734001159667969],
      flat: [[-4.642765998840332, -6.860598087310791], [-4.4105339050292969, 7.3758268356323242],
             [-12.258821487426758, 13.396656036376953], [14.257492065429688, 18.324134826660156]] };
    for (const [entry, wanted] of [[graze, inFloat], [double, inDouble], [queries, inFloat]]) {
      const { compose, inverse, relative, transform, inverseTransform, InvalidValue } = entry;
      equal(compose(a, b), wanted.composed, "composed");
      equal(relative(a, b), wanted.seen, "seen from a");
      equal(inverse(a), wanted.undone, "undone");
      equal([transform(a, point), inverseTransform(a, point)], [wanted.there, wanted.back], "points");
      // A rotation of exactly unit length and a place in a few bits: nothing is rounded.
      const turn = { translation: [4, 5, 6], rotation: [0, 0, 1, 0] };
      equal(compose(turn, { translation: [1, 2, 3] }), { translation: [3, 3, 9], rotation: [0, 0, 1, 0] }, "half a turn");
      equal(transform(turn, inverseTransform(turn, [1, 2, 3])), [1, 2, 3], "there and back");
      equal(inverse(), { translation: [0, 0, 0], rotation: [0, 0, 0, 1] }, "of no pose");
      const refused = (act, message) => throws(act, message, InvalidValue);
      refused(() => compose(a, { rotation: [0, 0, 0, 2] }), "b.rotation: expected a quaternion of unit length, got [0, 0, 0, 2]");
      refused(() => inverse({ rotation: [0, NaN, 0, 1] }), "pose.rotation: expected a quaternion of unit length, got [0, NaN, 0, 1]");
      refused(() => relative({ rotaton: [0, 0, 0, 1] }, b), "a: expected translation, rotation, got rotaton");
      refused(() => transform(a, [1, 2]), "point: expected 3 numbers, got 2");
      refused(() => inverseTransform(a, [1, 2, "3"]), 'point[2]: expected a number, got "3"');
      if (entry.plane === undefined) continue;

      const { plane } = entry;
      const c = { translation: [1, -2.5], rotation: 0.7 };
      const d = { translation: [-7.125, 0.3], rotation: -2.2 };
      const [composed, seen] = [plane.compose(c, d), plane.relative(c, d)];
      const points = [plane.transform(c, point.slice(0, 2)), plane.inverseTransform(c, point.slice(0, 2))];
      equal([composed.translation, seen.translation, ...points], wanted.flat, "places of the plane");
      close([composed.rotation, seen.rotation], [-1.5, -2.9], 1e-6, "angles");
      const home = plane.compose(plane.inverse(c), c);
      close([home.translation, home.rotation], [0, 0, 0], 1e-6, "and back");
      refused(() => plane.inverse({ rotation: [1, 0] }), "pose.rotation: expected a finite number, got Array");
    }
  }],

  ["the last decision on pairs is replaced", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries])
      for (const library of [entry, entry.plane].filter(Boolean)) {
        const held = entry.memoryInUse();
        const box = new library.Box(library === entry ? [1, 1, 1] : [1, 1]);
        let asked = 0;
        const world = new library.World({ allow: () => { asked += 1; return false; } });
        const [a, b] = [world.add({ shape: box }), world.add({ shape: box })];
        const pairs = () => {
          for (const id of [a, b]) world.move(id, {});
          world.update();
          return world.contacts().length;
        };
        equal([pairs(), asked > 0], [0, true], "none is allowed");
        world.setAllow((first, second) => first.index !== second.index);
        asked = 0;
        equal([pairs(), asked], [1, 0], "the other decides");
        throws(() => world.setAllow("no"), 'allow: expected a function, got "no"', entry.InvalidValue);
        // Whoever decides may not have itself replaced in the middle of it, and nothing is lost by that.
        world.setAllow(() => { world.setAllow(undefined); return true; });
        throws(pairs, /in use: another call changes it at this moment$/);
        world.setAllow(undefined);
        equal(pairs(), 1, "all are allowed");
        for (const thing of [world, box]) thing.dispose();
        ok(entry.memoryInUse() - held < 4096, "memory");
      }
  }],

  ["a convex shape of one's own", ({ graze }) => {
    let calls = 0;
    const cube = new graze.UserConvex((d) => {
      calls += 1;
      return d.map((x) => (x < 0 ? -1 : 1));
    });
    const ball = new graze.Sphere(0.5);
    close(graze.distance(cube, {}, ball, { translation: [3, 0, 0] }).distance, 1.5, 1e-5, "distance");
    ok(calls > 0, "that it was called");
    const broken = new graze.UserConvex((d) => d);
    broken.dispose();
    const angry = new graze.UserConvex((d) => {
      if (calls < 0) throw new Error("angry");
      return d.map((x) => (x < 0 ? -1 : 1));
    });
    calls = -1;
    throws(() => graze.distance(angry, {}, ball, { translation: [3, 0, 0] }), "angry", Error);
    calls = 0;
    equal(graze.overlap(angry, {}, ball, {}), true, "that it works afterwards");
  }],

  ["a convex shape of one's own in the plane", ({ graze, double }) => {
    for (const { plane, InvalidValue } of [graze, double]) {
      let calls = 0;
      const square = new plane.UserConvex((d) => {
        equal(d.length, 2, "a direction of the plane");
        calls += 1;
        return d.map((x) => (x < 0 ? -1 : 1));
      });
      const box = new plane.Box([2, 2]);
      const disk = new plane.Circle(0.5);
      for (const there of [{ translation: [3, 0.25] }, { translation: [2, 2] }, { translation: [0.5, 1.25] }]) {
        const own = plane.distance(square, { rotation: 0.25 }, disk, there);
        close(own.distance, plane.distance(box, { rotation: 0.25 }, disk, there).distance, 1e-5, "distance");
      }
      ok(calls > 0, "that it was called");
      equal(square.kind, "userConvex", "kind");
      throws(() => new plane.UserConvex(7), "userConvex.support: expected a function, got 7", InvalidValue);
      for (const shape of [square, box, disk]) shape.dispose();
    }
  }],

  ["a support function that gives no point is refused", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries])
      for (const library of entry.plane === undefined ? [entry] : [entry, entry.plane]) {
        const n = library === entry ? 3 : 2;
        const refused = (message) => (answer) => throws(() => new library.UserConvex(() => answer), message, entry.InvalidValue);
        for (const [answer, got] of [[undefined, "undefined"], [null, "null"], [new Array(n - 1).fill(1), n - 1], ["abc", '"abc"'], [{}, "Object"]])
          refused(`support: expected ${n} numbers, got ${got}`)(answer);
        // One that does so later throws from the query, which works again afterwards.
        let answer = (d) => d.map(Math.sign);
        const cube = new library.UserConvex((d) => answer(d));
        const at = { translation: [4, 0, 0].slice(0, n) };
        const before = library.distance(cube, {}, cube, at);
        const good = answer;
        answer = () => undefined;
        throws(() => library.distance(cube, {}, cube, at), `support: expected ${n} numbers, got undefined`, entry.InvalidValue);
        answer = good;
        equal(library.distance(cube, {}, cube, at), before, "afterwards");
        cube.dispose();
        const held = entry.memoryInUse();
        for (let i = 0; i < 20; ++i)
          throws(() => new library.UserConvex(() => { throw new Error("mine"); }), "mine", Error);
        equal(entry.memoryInUse(), held, "memory of shapes that were not made");
      }
  }],

  ["what is no number, and what is no whole number, is refused as it was given", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries]) {
      const { InvalidValue } = entry;
      const refuses = (act, message) => throws(act, message, InvalidValue);
      const index = (got, path) => `${path}: expected an integer from 0 to 4294967295, got ${got}`;
      const box = new entry.Box([1, 1, 1]);
      const broad = new entry.BroadPhase();
      const whole = [-1, 1.5, 2 ** 33, NaN, null, "1"];
      const shown = (value) => (typeof value === "string" ? JSON.stringify(value) : String(value));
      const world = new entry.World();
      const body = world.add({ shape: box });
      const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]];
      for (const value of whole) {
        const got = shown(value);
        for (const act of [(id) => broad.insert(id, [0, 0, 0], [1, 1, 1]), (id) => broad.move(id, [0, 0, 0], [1, 1, 1]), (id) => broad.remove(id)])
          refuses(() => act(value), index(got, "id"));
        refuses(() => world.nearest(box, {}, value), index(got, "most"));
        refuses(() => entry.contacts(box, {}, box, {}, 0, value), index(got, "most"));
        refuses(() => world.reduce(value), index(got, "most"));
        refuses(() => world.bodyAt(value), index(got, "index"));
        refuses(() => world.pose({ ...body, index: value }), index(got, "body.index"));
        refuses(() => new entry.Numbers(value), index(got, "numbers.length"));
        refuses(() => new entry.Mesh(corners, [[0, 1, value]]), index(got, "mesh.triangles[0][2]"));
        refuses(() => new entry.Mesh(corners, [0, value, 2]), index(got, "mesh.triangles[1]"));
        if (value !== null) refuses(() => world.slide(box, {}, [1, 0, 0], { casts: value }), index(got, "casts"));
      }
      refuses(() => new entry.Mesh(corners, new Int32Array([0, 1, -1])), index(-1, "mesh.triangles[2]"));
      equal(new entry.Mesh(corners, new Uint8Array([0, 1, 2])).kind, "mesh", "indices in few bytes");
      for (const [category, got] of [[2n ** 64n, "18446744073709551616"], [-1, "-1"], [-1n, "-1"], [0.5, "0.5"], ["1", '"1"']])
        refuses(() => world.setFilter(body, { category }),
          `filter.category: expected an integer or a bigint from 0 to 2^64 - 1, got ${got}`);
      world.setFilter(body, { category: 2n ** 64n - 1n, mask: 7 });
      refuses(() => world.setFilter(body, { group: 2 ** 31 }),
        "filter.group: expected an integer from -2147483648 to 2147483647, got 2147483648");
      refuses(() => new entry.Sphere(null), "sphere.radius: expected a number, got null");
      refuses(() => new entry.Capsule(1, true), "capsule.radiusBottom: expected a number, got true");
      refuses(() => new entry.Box(["1", 1, 1]), 'box.size[0]: expected a number, got "1"');
      refuses(() => new entry.ConvexHull([0, 0, null]), "convexHull.points[2]: expected a number, got null");
      refuses(() => world.update(null), "world_update: expected a number, got null");
      refuses(() => entry.within(box, {}, box, {}, "far"), 'within: expected a number, got "far"');
      for (const thing of [broad, world, box]) thing.dispose();
    }
    for (const { plane, InvalidValue } of [graze, double])
      throws(() => new plane.Circle(undefined), "circle.radius: expected a number, got undefined", InvalidValue);
  }],

  ["options, rays and settings that are not understood are refused, and none is passed over", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries]) {
      for (const library of [entry, entry.plane].filter(Boolean)) {
        const refuses = (act, message) => throws(act, message, entry.InvalidValue);
        const flat = library !== entry;
        const [box, zero, along] =
          flat ? [new library.Box([2, 2]), [0, 0], [1, 0]] : [new library.Box([2, 2, 2]), [0, 0, 0], [1, 0, 0]];
        const ray = { origin: zero, direction: along };
        const still = { shape: box };
        const world = new library.World();
        const body = world.add({ shape: box });
        const filter = "category, mask, group, triggers, accept";
        const casts = "duration, separating";
        for (const act of [(r) => library.raycast(box, {}, r), (r) => library.raycastAny(box, {}, r), (r) => world.raycast(r)]) {
          refuses(() => act(zero), "ray: expected an object with origin, direction, length, got Array");
          refuses(() => act(null), "ray: expected an object with origin, direction, length, got null");
          refuses(() => act({ origin: zero, dir: along }), "ray: expected origin, direction, length, got dir");
          refuses(() => act({ origin: zero }), `ray.direction: expected ${zero.length} numbers, got undefined`);
        }
        for (const act of [(o) => library.cast(still, still, o), (o) => library.castAll(still, still, o),
                           (o) => library.castBatch([still], [still], o)]) {
          refuses(() => act(5), `options: expected an object with ${casts}, got 5`);
          refuses(() => act({ duraton: 5 }), `options: expected ${casts}, got duraton`);
        }
        refuses(() => library.raycast(box, {}, ray, { length: 1 }), `options: expected ${flat ? "no members" : "backFaces"}, got length`);
        refuses(() => world.raycast(ray, { maxLength: 1 }), /, got maxLength$/);
        refuses(() => world.overlapping(box, {}, 3), `options: expected an object with ${filter}, got 3`);
        refuses(() => world.overlapping(box, {}, { catgory: 3 }), `options: expected ${filter}, got catgory`);
        refuses(() => world.overlapping(box, {}, { accept: 3 }), "accept: expected a function, got 3");
        refuses(() => world.nearest(box, {}, 1, { limt: 3 }), `options: expected ${filter}, limit, got limt`);
        refuses(() => world.slide(box, {}, along, { cast: 2 }), `options: expected ${filter}, casts, got cast`);
        refuses(() => world.cast(still, { duraton: 1 }), `options: expected ${filter}, ${casts}, got duraton`);
        refuses(() => world.move(body, {}, { liner: along }), "velocity: expected linear, angular, got liner");
        refuses(() => world.setFilter(body, { cat: 1 }), "filter: expected category, mask, group, got cat");
        refuses(() => world.add({ shape: box, filter: { cat: 1 } }), "body.filter: expected category, mask, group, got cat");
        refuses(() => world.add(), "body.shape: expected a Shape, got undefined");
        refuses(() => new library.World({ alow: () => true }), "settings: expected margin, pointsPerPair, allow, capture, got alow");
        refuses(() => new library.World({ allow: 3 }), "settings.allow: expected a function, got 3");
        refuses(() => new library.World(0.1), "settings: expected an object with margin, pointsPerPair, allow, capture, got 0.1");
        refuses(() => new library.Compound(null), "compound.children: expected an array, got null");
        const poses = flat ? [0, 0, 1, 0] : [0, 0, 0, 0, 0, 0, 1];
        refuses(() => library.overlapBatch({ shapes: box, poses, translations: zero }, { shapes: box, poses }),
          "a.translations: expected none beside poses, got Array");
        refuses(() => library.overlapBatch({ shape: box }, { shapes: box }), "a: expected shapes, poses, translations, rotations, got shape");
        for (const thing of [world, box]) thing.dispose();
      }
      throws(() => new entry.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], true),
        "mesh.options: expected an object with sides, solid, got true", entry.InvalidValue);
      // eslint-disable-next-line no-sparse-arrays
      throws(() => new entry.ConvexHull([[0, 0, 0], , [1, 0, 0]]), "convexHull.points[1]: expected 3 numbers, got undefined",
        entry.InvalidValue);
      throws(() => new entry.Numbers(2 ** 32 - 1), /^graze: no memory for \d+ bytes$/, RangeError);
      throws(() => new entry.ConvexHull(new BigInt64Array(3)), "convexHull.points[0]: expected a number, got 0", entry.InvalidValue);
    }
  }],
  ["what a simulation does not understand is refused", ({ graze, double }) => {
    for (const entry of [graze, double])
      for (const library of [entry, entry.plane]) {
        const refuses = (act, message) => throws(act, message, entry.InvalidValue);
        const simulation = new library.Simulation();
        const box = new library.Box(library === entry ? [1, 1, 1] : [1, 1]);
        const [a, b] = [0, 1].map(() => simulation.add({ shape: box }));
        const joint = (more) => () => simulation.addJoint({ a, b, ...more });
        refuses(() => new library.Simulation({ substeps: 4 }),
          "settings: expected gravity, subSteps, mostSubSteps, sleep, continuous, warmStart, longestStep, capture, got substeps");
        refuses(() => simulation.add({ shape: box }, { mas: 1 }), /^dynamics: expected mass, .*, got mas$/);
        refuses(() => simulation.add({ shape: box }, { hasMass: true }), /, got hasMass$/);
        refuses(() => simulation.add({ shape: box }, {}, { friction: 1 }), /^material: expected staticFriction, .*, got friction$/);
        refuses(() => simulation.setVelocity(a, { liner: 1 }), "velocity: expected linear, angular, got liner");
        refuses(joint({ type: "ball" }), /^joint: expected a, b, frameA, .*, got type$/);
        refuses(joint({ limits: [{ space: "linear", axes: ["x"], lower: 0 }] }), /^joint.limits\[0\]: .*, got lower$/);
        refuses(joint({ limits: [{ space: "linear", axes: ["w"] }] }), 'joint.limits[0].axes: expected one of x, y, z, got "w"');
        refuses(joint({ limits: [{ space: "linear" }] }), "joint.limits[0].axes: expected an array, got undefined");
        refuses(joint({ drives: [{ space: "linear", axis: "x", target: 0 }] }), /^joint.drives\[0\]: .*, got target$/);
        refuses(joint({ limits: [{ axes: ["x"] }] }), "joint.limits[0].space: expected one of linear, angular, got undefined");
        refuses(joint({ limits: { space: "linear", axes: ["x"] } }), "joint.limits: expected an array, got Object");
        refuses(joint({ drives: [{ space: "linear" }] }), "joint.drives[0].axis: expected one of x, y, z, got undefined");
        equal(simulation.joints().length, 0, "none was added");
        refuses(() => library.State.fromBytes(null), "bytes: expected an ArrayBuffer or a view of one, got null");
        const normal = library === entry ? [1, 0, 0] : [1, 0];
        const struck = { mass: 1, inertia: library === entry ? [1, 1, 1] : 1 };
        const pass = (body, blow, options) => () => library.passOn([struck, body], [{ a: 0, b: 1, normal, points: [], ...blow }], options);
        pass(struck)();
        refuses(pass({ ...struck, velocity: normal }), /^bodies\[1\]: expected mass, inertia, .*, got velocity$/);
        refuses(pass(struck, { bounce: 1 }), "blows[0]: expected a, b, normal, points, restitution, got bounce");
        refuses(pass(struck, { normal: undefined }), "blows[0].normal: expected a value, got undefined");
        refuses(pass(struck, { points: undefined }), "blows[0].points: expected an array, got undefined");
        refuses(pass(struck, {}, { limit: 3 }), "options: expected restingSpeed, most, got limit");
        refuses(() => library.passOn(null, []), "bodies: expected an array, got null");
        refuses(() => library.freeBody({ ...struck }), /^body: expected .*, got mass$/);
        refuses(() => library.freeBody({}), "body.inertia: expected a value, got undefined");
        refuses(() => library.tessellate(box, {}, { detail: 3 }), "options: expected center, size, got detail");
        refuses(() => library.draw.shape(box, {}, null), "renderer: expected an object with methods that draw, got null");
        refuses(() => library.draw.shape(box, {}, { layers: "shapes" }), 'renderer.layers: expected an array, got "shapes"');
        refuses(() => library.draw.shape(box, {}, { line: 3 }), "renderer.line: expected a function, got 3");
        refuses(() => library.draw.explained({}, { steps: 3 }), "options: expected step, got steps");
        const made = simulation.addJoint({ a, b, limits: [{ space: "linear", axes: ["x", "y"], min: 0 }], drives: [{ space: "angular", axis: "z", damping: 1 }] });
        simulation.addJoint(simulation.joint(made));
        for (const thing of [simulation, box]) thing.dispose();
      }
  }],
  ["what a blow does not understand is refused", ({ graze, double }) => {
    for (const { response, turned, InvalidValue } of [graze, double]) {
      const body = { mass: 1, inertia: [1, 1, 1] };
      const contact = { point: [0, 0, 0], normal: [1, 0, 0] };
      response(contact, body, body);
      throws(() => response({ ...contact, fricton: 3 }, body, body),
        "contact: expected point, normal, restitution, friction, got fricton", InvalidValue);
      throws(() => response({ normal: [1, 0, 0] }, body, body), "contact.point: expected 3 numbers, got undefined", InvalidValue);
      throws(() => response(contact, { ...body, liner: [1, 0, 0] }, body), /^a: expected mass, .*, got liner$/, InvalidValue);
      throws(() => turned([0, 0, 0], null, 1), "axis: expected an array, got null", InvalidValue);
    }
  }],
  ["what is no pose is not taken for the origin", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries])
      for (const library of entry.plane === undefined ? [entry] : [entry, entry.plane]) {
        const box = library === entry ? new entry.Box([2, 2, 2]) : new library.Box([2, 2]);
        const refuses = (act, message) => throws(act, message, entry.InvalidValue);
        const expected = "expected an object with a translation and a rotation, got";
        for (const [pose, got] of [[[1, 2, 3], "Array"], [new Float32Array(7), "Float32Array"], [null, "null"], [3, "3"]])
          refuses(() => library.overlap(box, pose, box, {}), `poseA: ${expected} ${got}`);
        refuses(() => library.overlap(box, {}, box, { translaton: [9, 9, 9] }), "poseB: expected translation, rotation, got translaton");
        const still = library === entry ? [0, 0, 0] : [0, 0];
        const movement = "translation, rotation, shape, linear, angular";
        refuses(() => library.cast({ shape: box, velocity: still }, { shape: box }), `a: expected ${movement}, got velocity`);
        refuses(() => library.poseAt({ position: still }, 1), `pose: expected ${movement}, got position`);
        refuses(() => new library.Compound([{ shape: box, at: still }]),
          "compound.children[0]: expected translation, rotation, shape, got at");
        const world = new library.World();
        refuses(() => world.add({ shape: box, fixd: true }), `body: expected ${movement}, filter, fixed, trigger, fast, got fixd`);
        equal(library.overlap(box, undefined, box, world.pose(world.add({ shape: box, linear: still, fast: true }))), true, "a pose");
        world.dispose();
        box.dispose();
      }
    // Each entry has a memory of its own.
    const box = new graze.Box([1, 1, 1]);
    for (const other of [queries, double])
      throws(() => graze.overlapBatch({ shapes: box, poses: [0, 0, 0, 0, 0, 0, 1] }, { shapes: box, poses: new other.Numbers(7) }),
        "b.poses: expected an array, or Numbers of this entry, got Numbers", graze.InvalidValue);
    box.dispose();
  }],

  ["angles that are not finite are refused", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries])
      for (const angle of [NaN, Infinity, "x", null])
        throws(() => entry.turned([0, 0, 0], [0, 0, 1], angle),
          `angle: expected a finite number, got ${angle === "x" ? '"x"' : angle}`, entry.InvalidValue);
    for (const { plane, InvalidValue } of [graze, double]) {
      const box = new plane.Box([1, 1]);
      for (const rotation of [NaN, -Infinity, "x", null])
        throws(() => plane.overlap(box, { rotation }, box, {}),
          `poseA.rotation: expected a finite number, got ${rotation === "x" ? '"x"' : rotation}`, InvalidValue);
      box.dispose();
    }
  }],

  ["an object that a call uses is not changed by the call's callbacks", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries])
      for (const library of entry.plane === undefined ? [entry] : [entry, entry.plane]) {
        const at = (x) => ({ translation: library === entry ? [x, 0, 0] : [x, 0] });
        const box = library === entry ? new entry.Box([2, 2, 2]) : new library.Box([2, 2]);
        let tried = [];
        let meddle = () => {};
        const attempt = (...actions) => {
          const tries = actions.map(() => null);
          tried.push(tries);
          return actions.forEach((action, i) => {
            try {
              action();
            } catch (error) {
              tries[i] = error.message;
            }
          });
        };
        const cube = new library.UserConvex((d) => {
          const act = meddle;
          meddle = () => {}; // once a call
          act();
          return d.map((x) => (x < 0 ? -1 : 1));
        });
        const held = (use, ...actions) => {
          tried = [];
          meddle = () => attempt(...actions);
          const answer = use();
          ok(tried.length > 0, "that the callback ran");
          return answer;
        };
        const reason = (what, how) => `${what}: in use: another call ${how} it at this moment`;
        let world = new library.World({
          allow: () => {
            meddle();
            return true;
          },
        });
        const ids = [world.add({ shape: box }), world.add({ shape: cube, ...at(1.5) })];
        held(() => world.update(), () => world.dispose(), () => world.remove(ids[0]), () => {
          for (let i = 0; i < 2000; ++i) world.add({ shape: box, ...at(3 * i) });
        }, () => world.contacts());
        equal(tried[0], [reason("dispose", "changes"), ...Array(3).fill(reason("world", "changes"))], "an update");
        equal([world.size, world.contacts().length], [2, 1], "nothing lost");
        held(() => world.overlapping(box, {}, { accept: () => { meddle(); return true; } }),
          () => world.dispose(), () => world.move(ids[0], at(9)), () => world.update(), () => world.pose(ids[0]));
        equal(tried[0], [reason("dispose", "reads"), reason("world", "reads"), reason("world", "reads"), null], "a query");
        // Refused where it is not caught: what the call was about has been done.
        meddle = () => world.dispose();
        throws(() => world.overlapping(cube, {}), reason("dispose", "reads"), Error);
        world.update();
        world.dispose();

        held(() => library.distance(cube, {}, box, at(4)), () => cube.dispose(), () => box.dispose());
        equal(tried[0], Array(2).fill(reason("dispose", "reads")), "shapes");
        // A query inside a query's callback does not disturb it.
        let inner;
        const outer = held(() => library.contacts(cube, {}, box, at(1.75)), () => {
          inner = library.contacts(box, {}, box, at(1.5));
        });
        equal(outer, library.contacts(cube, {}, box, at(1.75)), "the outer query");
        equal(inner, library.contacts(box, {}, box, at(1.5)), "the inner query");
        const poses = new entry.Numbers(library === entry ? 7 : 4);
        poses.array[library === entry ? 6 : 2] = 1;
        held(() => library.overlapBatch({ shapes: cube, poses }, { shapes: box, poses }), () => poses.dispose());
        equal(tried[0], [reason("dispose", "reads")], "numbers");
        poses.dispose();

        if (library.Simulation !== undefined) {
          const simulation = new library.Simulation();
          const body = simulation.add({ shape: box });
          simulation.add({ shape: cube, ...at(1.5) });
          held(() => simulation.step(1 / 60), () => simulation.dispose(), () => simulation.remove(body),
            () => simulation.world.events());
          equal(tried[0], [reason("dispose", "changes"), ...Array(2).fill(reason("simulation", "changes"))], "a step");
          held(() => simulation.world.raycast({ origin: [-9, 0, 0].slice(0, at(0).translation.length),
              direction: [1, 0, 0].slice(0, at(0).translation.length) }, { accept: () => { meddle(); return true; } }),
            () => simulation.dispose(), () => simulation.step(1 / 60), () => simulation.pose(body));
          equal(tried[0], [reason("dispose", "reads"), reason("simulation", "reads"), null], "a query of its world");
          simulation.dispose();
        }
        for (const shape of [box, cube]) shape.dispose();
      }
  }],

  ["at most so many points of a pair", ({ graze, double }) => {
    for (const { Box, contacts, plane, InvalidValue } of [graze, double]) {
      const box = new Box([1, 1, 1]);
      const square = new plane.Box([1, 1]);
      const step = new plane.Chain([[1, 0], [0, 0], [-1, 0.125]]);
      const points = ({ manifolds }) => manifolds.flatMap((m) => m.points);
      const reduced = (most) => contacts(box, {}, box, { translation: [0, 0.75, 0] }, 0, most);
      equal([undefined, 3, 1].map((most) => points(reduced(most)).length), [4, 3, 1], "in space");
      const inPlane = (most) => points(plane.contacts(step, {}, square, { translation: [0, 0.375] }, 0, most));
      const all = inPlane();
      ok(all.length > 2, "two pieces, each with points");
      const two = inPlane(2);
      equal(two.length, 2, "in the plane");
      ok(two.every((p) => all.some((q) => q.feature === p.feature && q.distance === p.distance)), "some of all");
      equal(Math.min(...two.map((p) => p.distance)), Math.min(...all.map((p) => p.distance)), "the deepest stays");
      throws(() => inPlane(0), "most: expected a number >= 1, got 0", InvalidValue);
      for (const shape of [box, square, step]) shape.dispose();
    }
  }],

  ["many at a time have the bits of each alone", ({ graze, double }) => {
    for (const entry of [graze, double]) {
      const next = random(3);
      const shapes = [new entry.Box([1, 2, 3]), new entry.Sphere(1), new entry.Capsule(1, 0.5), new entry.Cylinder(1, 1)];
      const count = 64;
      const poses = new entry.Numbers(7 * count);
      const list = [];
      for (let i = 0; i < count; ++i) {
        poses.array.set([...vector(next, 3), ...rotation(next)], 7 * i);
        const at = poses.array.slice(7 * i, 7 * i + 7);
        list.push({ translation: at.slice(0, 3), rotation: at.slice(3) });
      }
      const bodies = { shapes: list.map((_, i) => shapes[i % 4]), poses };
      const places = [];
      for (let i = 0; i < count; ++i) places.push(i, (i * 7 + 1) % count);
      const touch = entry.overlapBatch(bodies, bodies, places);
      const distances = entry.distanceBatch(bodies, bodies, places);
      const contacts = entry.contactsBatch(bodies, bodies, 0.25, places);
      const fewer = entry.contactsBatch(bodies, bodies, 0.25, places, 2);
      equal([touch.length, distances.length, contacts.length], [count, count, count], "lengths");
      const compact = entry.compactContactsBatch(bodies, bodies, 0.25, places);
      const [compactManifolds, compactPoints] = [[...compact.manifolds], [...compact.points]];
      equal(compactManifolds.length, contacts.flatMap((c) => c.manifolds).length, "manifolds in few bytes");
      contacts.forEach(({ manifolds }, i) => {
        const own = compactManifolds.filter(({ pair }) => pair === i);
        equal(own.map((m) => m.normal), manifolds.map((m) => m.normal), "normals in few bytes");
        equal(own.map((m) => compactPoints.slice(m.firstPoint, m.firstPoint + m.pointCount).map((p) => p.distance)),
              manifolds.map((m) => m.points.map((p) => p.distance)), "distances in few bytes");
      });
      let touching = 0;
      for (let i = 0; i < count; ++i) {
        const [a, b] = places.slice(2 * i, 2 * i + 2);
        const pair = [bodies.shapes[a], list[a], bodies.shapes[b], list[b]];
        equal(touch[i] === 1, entry.overlap(...pair), "overlap");
        const alone = entry.distance(...pair);
        equal(distances.at(i), alone, "distance");
        equal(distances.view[i * distances.stride + distances.offset.distance], alone.distance, "distance in memory");
        const { overlap, manifolds } = entry.contacts(...pair, 0.25);
        equal(contacts[i], { overlap, manifolds }, "contacts");
        equal(fewer[i].manifolds, entry.contacts(...pair, 0.25, 2).manifolds, "at most two points");
        touching += touch[i];
      }
      ok(touching > 0 && touching < count, "that some touch and some do not");
      equal([...distances].length, count, "iteration");
      distances.dispose();
      throws(() => distances.at(0), "batch: expected a live object, got a disposed one");

      const rays = [];
      for (let i = 0; i < count; ++i) rays.push(...vector(next, 4), ...vector(next, 1));
      const hits = entry.raycastBatch(shapes[0], list[0], rays);
      for (let i = 0; i < count; ++i) {
        const [origin, direction] = [rays.slice(6 * i, 6 * i + 3), rays.slice(6 * i + 3, 6 * i + 6)];
        const hit = entry.raycast(shapes[0], list[0], { origin, direction });
        equal(hits.found[i] === 1, hit !== null, "hit");
        if (hit !== null) equal(hits.at(i), hit, "ray");
      }
      const near = entry.closestBatch(shapes[3], list[1], rays.slice(0, 30));
      equal(near.at(2), entry.closest(shapes[3], list[1], rays.slice(6, 9)), "closest");
      const movers = list.map((at, i) => ({ shape: shapes[i % shapes.length], ...at, linear: vector(next, 3) }));
      const others = movers.map((body) => ({ ...body, translation: body.translation.map((x) => x + 1), linear: [0, 0, 0] }));
      const met = entry.castBatch(movers, others, { duration: 2 });
      for (let i = 0; i < movers.length; ++i) {
        const alone = entry.cast(movers[i], others[i], { duration: 2 });
        equal(met.found[i] === 1, alone !== null, "meeting");
        if (alone !== null) equal(met.at(i), alone, "cast");
      }
      throws(() => entry.castBatch(movers, []), `b: expected ${movers.length} moving bodies, as many as in a, got 0`,
             entry.InvalidValue);
      const pieces = entry.nearPiecesBatch({ shapes: shapes[0], poses }, { shapes: shapes[1], poses }, 0.5);
      equal(pieces.length, count, "pieces of each pair");
      list.slice(0, 20).forEach((at, i) =>
        equal(pieces[i], entry.nearPieces(shapes[0], at, shapes[1], at, 0.5), "near pieces"));
      met.dispose(), hits.dispose(), near.dispose(), poses.dispose();
      throws(
        () => entry.overlapBatch({ shapes, poses: new Float32Array(14) }, { shapes, poses: new Float32Array(14) }),
        "batch.a.pose_count: expected as many as shapes, or one, got 2", entry.InvalidValue);
    }
  }],

  ["traces change no bit and show what was done", ({ double: graze }) => {
    const box = new graze.Box([2, 2, 2]);
    const hull = new graze.ConvexHull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    const at = graze.turned([1.75, 0.25, 0.125], [1, 2, 3], 0.5);
    const boxes = graze.traced.contacts(box, {}, box, at, 0.125);
    equal(boxes.answer, graze.contacts(box, {}, box, at, 0.125), "contacts");
    equal(boxes.trace.method, "separating axes", "method");
    equal(boxes.trace.axes.map((axis) => axis.name).slice(0, 6), ["A0", "A1", "A2", "B0", "B1", "B2"], "axes");
    const first = boxes.trace.axes[0];
    close(first.overlap, first.a[1] - first.b[0], 0, "overlap");
    const far = graze.traced.distance(hull, {}, new graze.Cylinder(1, 1), { translation: [3, 1, 0] });
    ok(far.trace.gjk.length > 0, "steps of GJK");
    const last = far.trace.gjk.at(-1);
    close(last.upper, last.lower, 1e-9, "bounds that closed");
    const shapes = { a: { shape: { type: "box", box: { size: [2, 2, 2] } } } };
    const told = JSON.parse(graze.explain(JSON.stringify({
      query: "raycast", ...shapes, ray: { origin: [-4, 0, 0], direction: [1, 0, 0] } })));
    const ray = graze.traced.raycast(box, {}, { origin: [-4, 0, 0], direction: [1, 0, 0] });
    equal(ray.trace.method, told.trace.method, "method of a ray");
    const length = { infinity: Infinity, "-infinity": -Infinity };
    equal(ray.trace.spans.map((s) => [s.name, s.enter, s.leave]),
          told.trace.spans.map((s) => [s.name, ...s.span.map((x) => length[x] ?? x)]), "spans");
    const steps = graze.traced.cast({ shape: box }, { shape: hull, translation: [5, 0, 0], linear: [-8, 0, 0], angular: [1, 2, 3] });
    ok(steps.trace.steps.length > 0, "steps of a cast");
    equal(graze.traced.overlap(box, {}, box, {}).answer, true, "overlap");
    equal(graze.traced.closest(box, {}, [3, 0, 0]).answer.distance, 2, "closest");
  }],

  ["shapes in the words of the query protocol", ({ graze, double, queries }) => {
    const sorted = (value) => (typeof value === "object" && value !== null && !Array.isArray(value)
      ? Object.fromEntries(Object.keys(value).sort().map((key) => [key, sorted(value[key])])) : value);
    for (const entry of [graze, double]) {
      for (const [shape, words] of zoo(entry)) {
        if (words.type === "compound") continue;
        if (entry === double) {
          const read = double.shapeOfProtocol(words);
          equal(sorted(double.protocolShape(read)), sorted(double.protocolShape(shape)), `${words.type}, read`);
          read.dispose();
        }
        const written = entry.protocolShape(shape);
        if (words.type === "convex") for (const { convex } of [written, words]) convex.points = [...convex.points].sort(); // a hull has an order of its own
        equal(sorted(written), sorted(words), words.type);
      }
      const { compound } = entry.protocolShape(new entry.Compound([
        { shape: new entry.Box([1, 2, 3]), translation: [1, 0, 0] }, { shape: new entry.Sphere(0.25, [0, 4, 0]) }]));
      equal(compound.children.map((child) => [child.shape.type, child.translation, child.rotation]),
        [["box", [1, 0, 0], [0, 0, 0, 1]], ["compound", [0, 0, 0], [0, 0, 0, 1]]], "children");
      equal(compound.children[1].shape.compound.children[0].translation, [0, 4, 0], "a ball beside its origin");
      throws(() => entry.protocolShape(new entry.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], { sides: "front" })),
        "shape: expected a shape that a question can hold, got a mesh that is seen from its front alone", entry.InvalidValue);
      equal(entry.plane.protocolShape(new entry.plane.Chain([[0, 0], [1, 0], [1, 2]], { sides: "front" })),
        { type: "chain", chain: { points: [[0, 0], [1, 0], [1, 2]], sides: "one" } }, "a chain");
    }
    // All bits of a float, widened.
    equal(graze.protocolShape(new graze.Sphere(0.1)).sphere.radius, Math.fround(0.1), "a float's radius");
    equal(queries.protocolShape, undefined, "not in graze/queries");
    // What is not said is as the protocol has it.
    equal(double.protocolShape(double.shapeOfProtocol({ type: "cylinder" })),
      { type: "cylinder", cylinder: { height: 0.5, radiusBottom: 0.25, radiusTop: 0.25 } }, "a cylinder");
    const read = double.plane.shapeOfProtocol({ type: "circle", circle: { radius: 2 }, margin: 1 });
    ok(read instanceof double.plane.Shape, "a shape of the plane");
    close(read.bounds().upper, [3, 3], 1e-12, "a rounded circle");
    throws(() => double.shapeOfProtocol({ type: "ball" }),
      'shape.type: expected one of sphere, box, capsule, cylinder, plane, ellipsoid, convex, triangle, mesh, heightfield, compound, got "ball"',
      double.InvalidValue);
    equal([graze.shapeOfProtocol, graze.plane.shapeOfProtocol], [undefined, undefined], "in graze/double alone");
  }],

  ["a hull's support query, layer by layer", ({ graze, double, queries }) => {
    for (const entry of [graze, double]) {
      const next = random(9);
      const points = Array.from({ length: 900 }, () => {
        const p = vector(next, 1);
        const length = Math.hypot(...p);
        return p.map((x) => x / length);
      });
      const hull = new entry.ConvexHull(points);
      const { vertices, layers } = entry.hullLayers(hull);
      ok(layers.length > 1, "several layers");
      equal(layers.at(-1).vertices.length, vertices.length, "the last is the hull");
      layers.slice(0, -1).forEach((layer, i) => {
        const finer = new Set(layers[i + 1].vertices);
        ok([...layer.vertices].every((v) => finer.has(v)), "vertices of the next layer");
        equal(layer.edges.length / 2, 3 * layer.vertices.length - 6, "edges of a triangulated sphere");
      });
      for (let i = 0; i < 20; ++i) {
        const direction = vector(next, 1);
        const along = (v) => vertices[v].reduce((sum, x, k) => sum + x * direction[k], 0);
        const { answer, trace } = entry.traced.support(hull, direction);
        equal(answer, hull.support(direction), "the answer");
        equal(vertices[trace.vertex], answer, "the vertex");
        const most = Math.max(...vertices.map((_, v) => along(v)));
        close(along(trace.vertex), most, 1e-6, "brute force");
        equal(trace.layers.map((layer) => layer.vertices), layers.map((layer) => layer.vertices.length), "layers");
        equal(trace.layers.reduce((sum, layer) => sum + layer.lookedAt.length, 0), trace.products, "products");
        for (const { winner, lookedAt, along: products } of trace.layers) {
          equal(products.length, lookedAt.length, "a product each");
          equal(products[lookedAt.indexOf(winner)], Math.max(...products), "the winner's is the greatest");
        }
        ok(trace.products < vertices.length / 2, "few products");
        equal(trace.scanned, false, "a descent");
      }
      const small = new entry.ConvexHull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);
      const { trace } = entry.traced.support(small, [1, 2, 3]);
      equal([trace.scanned, trace.products, trace.layers.length], [true, 4, 1], "a scan");
      throws(() => entry.hullLayers(new entry.Sphere(1)), "shape: expected a convex hull, got sphere", entry.InvalidValue);
    }
    equal(queries.hullLayers, undefined, "not in graze/queries");
  }],

  ["what a blow does", ({ double: graze }) => {
    const ball = new graze.Sphere(0.5);
    const told = graze.response(
      { point: [0, 0, 0], normal: [0, 1, 0], restitution: 0.5 },
      { mass: Infinity },
      { mass: 2, shape: ball, translation: [0, 0.5, 0], linear: [0, -4, 0] });
    close([told.normalImpulse, told.impulse, told.b.linear], [12, 0, 12, 0, 0, 2, 0], 1e-12, "response");
    equal(told.atFault, "b", "who moves into whom");
    const moved = graze.applyImpulse({ mass: 2, inertia: [1, 1, 1] }, [0, 4, 0], [1, 0, 0]);
    close([moved.linear, moved.angular], [0, 2, 0, 0, 0, 4], 1e-12, "impulse");
    const tensor = [[2, 1, 0], [1, 2, 0], [0, 0, 4]];
    const turned = graze.applyImpulse({ mass: 2, inertia: tensor }, [0, 0, 3], [1, 0, 0]);
    close(turned.angular, [1, -2, 0], 1e-12, "a tensor times the change of the turning is the angular impulse");
    throws(() => graze.response({ point: [0, 0, 0], normal: [0, 1, 0] }, { mass: 1 }, { mass: 1 }),
           "a.inertia: expected three numbers, or a shape, got undefined");
  }],

  ["blows that are passed on, and free motion", ({ graze, double }) => {
    for (const entry of [graze, double])
      for (const [words, axis, shape] of [
        [entry, [1, 0, 0], new entry.Sphere(0.5)], [entry.plane, [1, 0], new entry.plane.Circle(0.5)]]) {
        const at = (x) => axis.map((unit) => unit * x);
        const balls = [0, 1, 2, 3].map((i) => ({ mass: 1, shape, translation: at(i), linear: at(i === 0 ? 4 : 0) }));
        const blows = [0, 1, 2].map((a) => ({ a, b: a + 1, normal: axis, points: [at(a + 0.5)], restitution: 1 }));
        const passed = words.passOn(balls, blows, { restingSpeed: 0.01 });
        close(passed.bodies.map((body) => body.linear[0]), [0, 0, 0, 4], 1e-5, "a cradle");
        close(passed.impulses.flat(), [4, 4, 4], 1e-5, "impulses");
        equal(passed.struck, 3, "blows");
        equal(words.passOn(balls, blows, { most: 1 }).struck, 1, "at most one");
        throws(() => words.passOn(balls, [{ ...blows[0], b: 7 }]),
               "touching.blows[0].b: expected a place among the bodies, another than a, got 7", entry.InvalidValue);
        const moved = words.applyImpulse({ mass: 2, inertia: words === entry ? [4, 4, 4] : 4 }, at(3), at(0));
        close(moved.linear, at(1.5), 1e-6, "an impulse");
      }
    let book = double.freeBody({ inertia: [1, 2, 3], linear: [1, 0, 0], angular: [0.01, 5, 0] });
    const { angularMomentum } = book;
    for (let i = 0; i < 60; ++i) book = double.advance(book, 1 / 60, [0, -10, 0]);
    equal(book.angularMomentum, angularMomentum, "momentum stays bit for bit");
    close(book.center, [1, -5, 0], 1e-12, "it falls");
    close(double.angularVelocity(double.freeBody({ inertia: [1, 2, 3], angular: [1, 2, 3] })), [1, 2, 3], 1e-12, "turning");
    const wheel = double.plane.advance(double.plane.freeBody({ inertia: 2, angular: 3 }), 0.5);
    close([...wheel.rotation, wheel.angularMomentum, double.plane.angularVelocity(wheel)],
          [Math.cos(1.5), Math.sin(1.5), 6, 3], 1e-12, "in the plane");
    throws(() => double.freeBody({ inertia: [-1, 1, 1] }), "body.inverse_inertia[0]: expected a finite number >= 0, got -1");
  }],

  ["batches of the plane are each alone, and a mesh says what it found", ({ graze, double }) => {
    for (const entry of [graze, double]) {
      const { plane } = entry;
      const next = random(9);
      const vec2 = (reach) => vector(next, reach).slice(0, 2);
      const shapes = [new plane.Box([1, 2]), new plane.Circle(0.5), new plane.Ellipse([1, 0.5])];
      const translations = Array.from({ length: 60 }, () => vec2(2));
      const turned = Array.from({ length: 60 }, () => next() * 6);
      const each = translations.map((_, i) => shapes[i % 3]);
      const here = { shapes: shapes[0], translations: [0, 0] };
      const moved = { shapes: each, translations: translations.flat() };
      const touch = plane.overlapBatch(here, moved);
      const distances = plane.distanceBatch(here, moved);
      const contacts = plane.contactsBatch(here, moved, 0.25);
      const deepest = plane.contactsBatch(here, moved, 0.25, undefined, 1);
      translations.forEach((translation, i) => {
        const pair = [shapes[0], {}, each[i], { translation }];
        equal(touch[i] === 1, plane.overlap(...pair), "overlap");
        equal(distances.at(i), plane.distance(...pair), "distance");
        equal(contacts[i].manifolds, plane.contacts(...pair, 0.25).manifolds, "contacts");
        equal(deepest[i].manifolds, plane.contacts(...pair, 0.25, 1).manifolds, "at most one point");
      });
      ok(touch.includes(1) && touch.includes(0), "that some touch and some do not");
      const chain = new plane.Chain([[-1, 0], [0, 0.5], [1, 0], [1, -2]]);
      const pieces = plane.nearPiecesBatch({ shapes: chain, translations: [0, 0] }, moved, 0.5);
      translations.forEach((translation, i) =>
        equal(pieces[i], plane.nearPieces(chain, {}, each[i], { translation }, 0.5), "near pieces"));
      ok(pieces.some((near) => near.length > 1) && pieces.some((near) => near.length === 0), "several pieces, and none");
      throws(() => plane.nearPiecesBatch(moved, moved, -1), /^margin: expected/, entry.InvalidValue);
      chain.dispose();
      const numbers = turned.flatMap((angle, i) => [...translations[i], Math.cos(angle), Math.sin(angle)]);
      equal(plane.overlapBatch(here, { shapes: each, poses: numbers }).length, 60, "poses of four numbers");
      const rays = translations.flatMap((from) => [...from.map((x) => 2 * x), ...vec2(1)]);
      const hits = plane.raycastBatch(shapes[2], { rotation: 0.5 }, rays, { length: 5 });
      const near = plane.closestBatch(shapes[0], { rotation: 0.5 }, translations);
      const bodies = translations.map((translation, i) => ({ shape: each[i], translation, linear: vec2(3), angular: 1 }));
      const met = plane.castBatch(bodies, bodies.map(() => ({ shape: shapes[0] })));
      translations.forEach((point, i) => {
        const [origin, direction] = [rays.slice(4 * i, 4 * i + 2), rays.slice(4 * i + 2, 4 * i + 4)];
        const hit = plane.raycast(shapes[2], { rotation: 0.5 }, { origin, direction, length: 5 });
        equal(hits.found[i] === 1 ? hits.at(i) : null, hit, "ray");
        equal(near.at(i), plane.closest(shapes[0], { rotation: 0.5 }, point), "closest");
        equal(met.found[i] === 1 ? met.at(i) : null, plane.cast(bodies[i], { shape: shapes[0] }), "cast");
      });
      ok(hits.found.includes(1) && hits.found.includes(0), "that some rays hit and some do not");
      distances.dispose(), hits.dispose(), near.dispose(), met.dispose();
      const mesh = new entry.Mesh([[0, 0, 0], [2, 0, 0], [0, 0, 2]], [[0, 1, 2]]);
      const { triangles, openEdges, flatEdges, tJunctions } = mesh.findings();
      equal([triangles, openEdges, flatEdges, tJunctions], [1, 3, 0, 0], "findings");
      mesh.dispose(), shapes.forEach((shape) => shape.dispose());
    }
  }],

  ["every broad phase finds the pairs of brute force", ({ graze, queries }) => {
    for (const entry of [graze, queries])
      for (const kind of ["dynamicTree", "sortAndSweep", "sweepAndPrune", "hashedGrid", "looseOctree", "bsp"]) {
        const next = random(5);
        const broad = new entry.BroadPhase(kind);
        const boxes = [];
        for (let id = 0; id < 100; ++id) {
          const lower = vector(next, 4).map(Math.fround);
          boxes.push([lower, lower.map((x) => Math.fround(x + next() * 2))]);
          broad.insert(id, ...boxes[id]);
        }
        const touch = ([a, b], [c, d]) => [0, 1, 2].every((k) => a[k] <= d[k] && c[k] <= b[k]);
        const wanted = [];
        for (let i = 0; i < 100; ++i)
          for (let j = i + 1; j < 100; ++j) if (touch(boxes[i], boxes[j])) wanted.push(i, j);
        equal([...broad.pairs()], wanted, `pairs of ${kind}`);
        const counts = broad.counts();
        equal([counts.boxes, counts.pairs], [100, wanted.length / 2], "counts");
        ok(counts.tests >= counts.pairs && counts.tests < 100 * 100, "tests");
        ok(counts.memory > 0, "memory");
        boxes[3] = [[-1, -1, -1], [1, 1, 1]];
        broad.move(3, ...boxes[3]);
        const around = boxes.map((_, id) => id).filter((id) => touch(boxes[id], boxes[3]));
        equal([...broad.query(...boxes[3])], around, "query");
        equal(broad.movedPairs().length / 2, around.length - 1, "moved pairs");
        const parts = broad.parts();
        equal(parts.length > 0, !kind.startsWith("s"), "parts");
        if (parts.length > 0) {
          equal(parts[0].depth, 0, "the root");
          ok(boxes.every((box) => parts.some(({ lower, upper }) => touch(box, [lower, upper]))), "every box is in a part");
        }
        ok(broad.sweep([-9, 0, 0], [-9, 0, 0], [18, 0, 0]).length > 0, "sweep");
        broad.remove(3);
        throws(() => broad.remove(3), "id: expected an id that was inserted, got 3", entry.InvalidValue);
        broad.dispose();
      }
  }],

  ["changes of pairs are the differences of all pairs", ({ graze, queries }) => {
    for (const entry of [graze, queries]) {
      const next = random(8);
      const [changes, broad] = [new entry.PairChanges("hashedGrid"), new entry.BroadPhase()];
      const box = () => {
        const lower = vector(next, 4);
        return [lower, lower.map((x) => x + next() * 2)];
      };
      let before = new Set();
      let all = 0;
      for (let frame = 0; frame < 4; ++frame) {
        for (let id = frame; id < 100; id += frame === 0 ? 1 : 7) {
          const where = box();
          for (const one of [changes, broad]) frame === 0 ? one.insert(id, ...where) : one.move(id, ...where);
        }
        if (frame === 2) for (const one of [changes, broad]) one.remove(50);
        const texts = (pairs) => Array.from({ length: pairs.length / 2 }, (_, i) => `${pairs[2 * i]} ${pairs[2 * i + 1]}`);
        const now = new Set(texts(broad.pairs()));
        const { begun, ended } = changes.find();
        equal(texts(begun), [...now].filter((pair) => !before.has(pair)), "begun");
        equal(texts(ended), [...before].filter((pair) => !now.has(pair)), "ended");
        all += begun.length + ended.length;
        before = now;
      }
      ok(all > 100, "that pairs begin and end");
      throws(() => changes.remove(50), "id: expected an id that was inserted, got 50", entry.InvalidValue);
      throws(
        () => new entry.PairChanges("tree"),
        "pairChanges.kind: expected one of dynamicTree, sortAndSweep, sweepAndPrune, hashedGrid, looseOctree, bsp, got \"tree\"",
        entry.InvalidValue);
      changes.dispose(), broad.dispose();
    }
  }],

  ["a world", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries]) {
      const box = new entry.Box([1, 1, 1]);
      const world = new entry.World({ margin: 0.125 });
      const floor = world.add({ shape: new entry.HalfSpace(), fixed: true });
      const crate = world.add({ shape: box, translation: [0, 0.5, 0] });
      const ghost = world.add({ shape: box, translation: [0, 0.25, 0], trigger: true, filter: { category: 2, mask: 1 } });
      box.dispose(); // the world has its own share
      world.update();
      equal(world.size, 3, "bodies");
      equal(world.events().map((e) => [e.kind, e.trigger, e.a.index, e.b.index]),
            [["begin", false, 0, 1], ["begin", true, 0, 2], ["begin", true, 1, 2]], "events");
      const pair = world.contacts().find(({ a, b }) => a === floor.index && b === crate.index);
      equal([pair.manifolds.length, pair.manifolds[0].normal, pair.manifolds[0].points.length], [1, [0, 1, 0], 4], "pair");
      equal(world.points().at(0), world.contacts()[0].manifolds[0].points[0], "a point");
      world.move(crate, { translation: [0, 5, 0] }, { linear: [0, -300, 0] });
      world.setFast(crate, true);
      world.update(1 / 60);
      equal(world.events().map((e) => e.kind), ["end", "stay", "end"], "kinds");
      // First with the trigger, whose upper side stands at 0.75.
      close(world.impacts()[0].hit.t, 3.75 / 300, 1e-5, "impact");
      equal(world.pose(crate).translation, [0, 5, 0], "pose");
      equal([...world.poses().slice(7, 10)], [0, 5, 0], "poses");
      world.moveBatch([crate, ghost], [0, 0.5, 0, 0, 0, 0, 1, 4, 0, 0, 0, 0, 0, 1]);
      equal(world.pose(ghost).translation, [4, 0, 0], "moved");
      world.moveBatch([ghost], [4, 0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 0]);
      throws(() => world.moveBatch([ghost], [4, 0, 0, 0, 0, 0, 1], []), "velocities: expected 1 of them, got 0", entry.InvalidValue);
      throws(() => world.moveBatch([ghost], [9, 9, 9, 0, 0, 0, 1], [Infinity, 0, 0, 0, 0, 0]),
        "velocities[0].linear[0]: expected a finite number, got inf", entry.InvalidValue);
      equal(world.pose(ghost).translation, [4, 0, 0], "not moved");
      const ray = { origin: [0, 9, 0], direction: [0, -1, 0] };
      equal(world.raycast(ray).body, crate, "ray");
      equal(world.raycast(ray, { accept: (id) => id.index !== crate.index }).body, floor, "ray past");
      equal(world.raycastAll(ray).map(({ body }) => body.index), [1, 0], "all");
      equal(world.raycastAny(ray, { mask: 0 }), false, "a mask of nothing");
      throws(() => world.raycast(ray, { accept: () => { throw new Error("no"); } }), "no", Error);
      const ball = new entry.Sphere(0.5);
      equal(world.overlapping(ball, { translation: [0, 1, 0] }), [crate], "overlapping");
      equal(world.overlapsAny(ball, { translation: [9, 9, 9] }), false, "nothing there");
      equal(world.nearest(ball, { translation: [0, 3, 0] }, 1)[0].body, crate, "nearest");
      equal(world.cast({ shape: ball, translation: [0, 9, 0], linear: [0, -9, 0] }).body, crate, "cast");
      equal(world.castAll({ shape: ball, translation: [0, 9, 0], linear: [0, -9, 0] }).length, 2, "casts");
      const slide = world.slide(ball, { translation: [3, 2, 0] }, [0, -4, 1]);
      close([slide.end.translation[1], slide.end.translation[2]], [0.5, 1], 0.01, "slide");
      equal(world.bodyAt(1), crate, "body at");
      equal(world.bodyAt(77), null, "no body");
      world.remove(crate);
      equal(world.contains(crate), false, "contains");
      ok(world.memory() > 0, "memory");
      world.dispose();
      throws(() => world.update(), "world: expected a live object, got a disposed one");
      const asked = [];
      const other = new entry.World({ allow: (a, b) => { asked.push([a.index, b.index]); return false; } });
      other.add({ shape: ball });
      other.add({ shape: ball });
      other.update();
      equal([asked.length > 0, other.contacts().length], [true, 0], "allow");
    }
  }],

  ["a slide takes six casts, as in C++", ({ graze, double, queries }) => {
    // Ten floors round a bowl of radius 5: from one the ball goes on to the next, of which it meets seven.
    const angles = Array.from({ length: 10 }, (_, i) => ((i - 1) * Math.PI) / 18);
    const floors = angles.map((a) => ({ a, translation: [5 * Math.sin(a), 5 - 5 * Math.cos(a)] }));
    const start = [-1, 1];
    const checked = (world, ball, slide, InvalidValue) => {
      equal(slide(undefined), slide({ casts: 6 }), "the usual number");
      ok(JSON.stringify(slide({ casts: 4 })) !== JSON.stringify(slide({ casts: 6 })), "that it matters");
      equal(slide({ casts: 4 }).touched.length, 4, "one obstacle a cast");
      const { end, left } = slide(undefined);
      ok(Math.hypot(...left) > 0.1, "there is more to go");
      close(world.nearest(ball, end, 1)[0].distance.distance, 0, 1e-4, "at a floor, and in none");
      throws(() => slide({ casts: 0 }), "casts: expected a number >= 1, got 0", InvalidValue);
    };
    for (const { World, HalfSpace, Sphere, InvalidValue } of [graze, double, queries]) {
      const world = new World();
      const ball = new Sphere(0.5);
      for (const { a, translation } of floors)
        world.add({
          shape: new HalfSpace(), fixed: true, translation: [...translation, 0],
          rotation: [0, 0, Math.sin(a / 2), Math.cos(a / 2)] });
      checked(world, ball, (options) => world.slide(ball, { translation: [...start, 0] }, [20, -2, 0], options), InvalidValue);
    }
    for (const { plane, InvalidValue } of [graze, double]) {
      const world = new plane.World();
      const ball = new plane.Circle(0.5);
      for (const { a, translation } of floors)
        world.add({ shape: new plane.HalfPlane(), fixed: true, translation, rotation: a });
      checked(world, ball, (options) => world.slide(ball, { translation: start }, [20, -2], options), InvalidValue);
    }
  }],

  ["a simulation", ({ graze, double }) => {
    for (const entry of [graze, double]) {
      const simulation = new entry.Simulation({ gravity: [0, -10, 0] });
      const floor = simulation.add({ shape: new entry.HalfSpace(), fixed: true });
      const crate = simulation.add(
        { shape: new entry.Box([1, 1, 1]), translation: [0, 2, 0] }, { mass: 3 }, { restitution: 0, dynamicFriction: 0.5 });
      equal([simulation.mass(crate), simulation.mass(floor)], [3, Infinity], "masses");
      const start = simulation.save();
      for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
      close(simulation.pose(crate).translation, [0, 0.5, 0], 0.01, "at rest");
      close(Array.from(simulation.poses().slice(7, 10)), [0, 0.5, 0], 0.01, "poses");
      equal(simulation.world.contacts().length, 1, "contacts");
      const impulse = simulation.world.contacts()[0].manifolds.flatMap((m) => m.points).reduce((sum, p) => sum + p.impulse[1], 0);
      ok(Math.abs(impulse) > 0 || simulation.asleep(crate), "an impulse");
      const end = simulation.pose(crate);
      const report = simulation.report();
      close(report.potentialEnergy, 3 * 10 * 0.5, 1, "energy");
      simulation.restore(start);
      close(simulation.pose(crate).translation, [0, 2, 0], 0, "restored");
      for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
      equal(simulation.pose(crate), end, "the same bits again");
      const bytes = start.bytes();
      simulation.restore(entry.State.fromBytes(bytes));
      for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
      equal(simulation.pose(crate), end, "the same bits from bytes");
      throws(() => entry.State.fromBytes(bytes.slice(1)), "state: expected the bytes of a state, got other bytes", entry.InvalidValue);
      throws(() => entry.plane.State.fromBytes(bytes), 
        "state: expected a state of version 2 or 3 of this precision and dimension, got another one", entry.InvalidValue);
      simulation.applyImpulse(crate, [3, 0, 0], end.translation);
      close(simulation.motion(crate).linear[0], 1, 1e-5, "pushed");
      simulation.applyAngularImpulse(crate, [0, 0.25, 0]);
      close(simulation.angularMomentum(crate), [0, 0.25, 0], 1e-5, "angular momentum");
      simulation.setVelocity(crate, { linear: [0, 1, 0] });
      close(simulation.motion(crate).linear, [0, 1, 0], 1e-6, "velocity");
      throws(() => simulation.step(-1), "dt: expected a number > 0 and at most longest_step, got -1", entry.InvalidValue);

      const hinge = simulation.addJoint({
        a: floor, b: crate, kind: "hinge", frameA: { translation: [0, 5, 0] }, frameB: { translation: [0, 1, 0] },
        drives: [{ space: "angular", axis: "x", velocityTarget: 1, damping: 10 }] });
      simulation.setPose(crate, { translation: [0, 4, 0] });
      for (let i = 0; i < 60; ++i) simulation.step(1 / 60);
      const { translation, rotation: turn } = simulation.pose(crate);
      // The body's frame stays at the hinge, wherever it swings.
      const [x, , , w] = turn;
      close([translation[1] + (w * w - x * x), translation[2] + 2 * w * x], [5, 0], 0.02, "hinge");
      ok(simulation.jointImpulses(hinge).length >= 5, "rows");
      const known = simulation.joint(hinge);
      equal([simulation.joints(), known.a, known.b, known.frameA.translation], [[hinge], floor, crate, [0, 5, 0]], "the joint");
      equal(known.limits.map(({ space, axes, min, max }) => [space, axes.join(""), min, max]),
            [["linear", "xyz", 0, 0], ["angular", "yz", 0, 0]], "the limits of a hinge");
      equal(known.drives.map(({ axis, mode, velocityTarget }) => [axis, mode, velocityTarget]), [["x", "force", 1]], "drive");
      const again = simulation.addJoint(known);
      simulation.setJoint(again, { ...known, limits: [] });
      equal(simulation.joint(again).limits.length, 0, "a joint that was set");
      throws(() => simulation.setJoint(again, { ...known, b: known.a }), /another body than a/, entry.InvalidValue);
      simulation.removeJoint(again);
      simulation.setFilter(crate, { category: 1n, mask: 0n });
      equal(simulation.world.body(crate).filter.mask, 0n, "a filter that was set");
      simulation.setFilter(crate, {});
      ok(simulation.subSteps(crate) >= 4, "sub-steps");
      const [here, hash] = [simulation.save(), simulation.stateHash()];
      simulation.step(1 / 60);
      ok(typeof hash === "bigint" && simulation.stateHash() !== hash, "another state");
      simulation.restore(here);
      equal(simulation.stateHash(), hash, "the hash of the state again");
      here.dispose();
      simulation.removeJoint(hinge);
      simulation.remove(crate);
      equal(simulation.world.size, 1, "bodies");
      simulation.dispose(), start.dispose();
      throws(() => simulation.world.events(), "simulation: expected a live object, got a disposed one");
    }
  }],

  ["sliders and distances have bounds, and a simulation its settings", ({ graze, double }) => {
    for (const entry of [graze, double])
      for (const library of [entry, entry.plane]) {
        const n = library === entry ? 3 : 2;
        const cut = (...v) => v.slice(0, n);
        const { InvalidValue } = entry;
        const settings = { gravity: cut(0, -10, 0), subSteps: 8, sleep: false, longestStep: 0.5 };
        const simulation = new library.Simulation(settings);
        const { gravity, subSteps, sleep, longestStep, continuous, ...rest } = simulation.settings();
        equal([gravity, subSteps, sleep, longestStep, continuous, rest.warmStart, Object.keys(rest)],
              [cut(0, -10, 0), 8, false, 0.5, true, true, ["mostSubSteps", "warmStart"]], "settings");
        const cold = new library.Simulation({ warmStart: false });
        equal(cold.settings().warmStart, false, "the last setting");
        cold.dispose();
        const same = new library.Simulation(simulation.settings());
        equal(same.settings(), simulation.settings(), "settings of the settings");
        simulation.setGravity(cut(0, -5, 0));
        equal(simulation.settings().gravity, cut(0, -5, 0), "gravity as it is now");

        const ball = n === 3 ? new library.Sphere(0.25) : new library.Circle(0.25);
        const post = simulation.add({ shape: ball, fixed: true });
        const bob = simulation.add({ shape: ball, translation: cut(0, -1, 0) }, { mass: 1 });
        const between = { a: post, b: bob };
        const limits = (joint) => {
          const id = simulation.addJoint(joint);
          const found = simulation.joint(id).limits.map(({ space, axes, min, max }) => [space, axes.join(""), min, max]);
          simulation.removeJoint(id);
          return found;
        };
        const own = { space: "linear", axes: ["x"], min: -1, max: 1 };
        const apart = limits({ ...between, kind: "distance", min: 0.5, max: 2, limits: [own] });
        equal([apart[0][0], ...apart[0].slice(2), apart[1]], ["linear", 0.5, 2, ["linear", "x", -1, 1]], "a distance");
        equal(limits({ ...between, kind: "distance", max: 2 })[0].slice(2), [0, 2], "no least distance");
        const free = limits({ ...between, kind: "slider" });
        const along = limits({ ...between, kind: "slider", max: 3 });
        equal(along.length, free.length + 1, "one more limit");
        ok(along.some(([space, axes, min, max]) => space === "linear" && axes === "x" && min === -Infinity && max === 3), "along x");
        const refused = (joint, message) => throws(() => simulation.addJoint({ ...between, ...joint }), message, InvalidValue);
        refused({ kind: "hinge", max: 3 }, "joint.max: expected none of the kind hinge, got 3");
        equal(limits({ ...between, kind: "hinge", min: null, max: undefined }), limits({ ...between, kind: "hinge" }), "no bounds");
        refused({ min: null, max: 3 }, "joint.kind: expected slider or distance, whose bounds are min and max, got undefined");
        refused({ kind: "rope" }, 'joint.kind: expected one of fixed, ball, hinge, slider, distance, got "rope"');
        refused({ kind: "distance", min: 2, max: 1 }, /max/);
        refused({ kind: "distance", min: "2" }, /expected a number, got "2"/);

        // The bob falls to the end of its rope, and no further.
        simulation.addJoint({ ...between, kind: "distance", max: 1.5 });
        for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
        close(simulation.pose(bob).translation, cut(0, -1.5, 0), 0.02, "at the end of its rope");
        for (const thing of [simulation, same, ball]) thing.dispose();
      }
  }],

  ["forces, torques, ways of kinematic bodies, materials and sleep", ({ graze, double }) => {
    for (const entry of [graze, double])
      for (const library of [entry, entry.plane]) {
        const n = library === entry ? 3 : 2;
        const cut = (...v) => v.slice(0, n);
        const turn = (z) => (n === 3 ? [0, 0, z] : z);
        const box = new library.Box(cut(1, 1, 1));
        const simulation = new library.Simulation({ gravity: cut(0, 0, 0) });
        const crate = simulation.add({ shape: box }, { mass: 2 });
        const inertia = 2 / 6; // of a cube and of a square alike
        // A force of one step: v = F dt / m, and a torque: w = T dt / I.
        simulation.applyForce(crate, cut(12, 0, 0));
        simulation.applyTorque(crate, turn(6));
        simulation.step(1 / 16);
        const { linear, angular } = simulation.motion(crate);
        close([linear, angular], [cut(12 / 16 / 2, 0, 0), turn(6 / 16 / inertia)], 1e-4, "a force and a torque");
        simulation.step(1 / 16);
        close(simulation.motion(crate).linear, cut(12 / 16 / 2, 0, 0), 1e-4, "which last for one step");

        const lift = simulation.add({ shape: box, translation: cut(0, -9, 0) }, { kinematic: true });
        const goal = { translation: cut(0, -8.5, 0) };
        simulation.moveTo(lift, goal, 1 / 16);
        simulation.step(1 / 16);
        close([simulation.pose(lift).translation, simulation.motion(lift).linear], [goal.translation, cut(0, 8, 0)], 1e-4, "a lift");

        // On a belt a crate goes with it; without friction it stays.
        const belt = simulation.add({ shape: new library.Box(cut(40, 1, 40)), translation: cut(0, -20.5, 0), fixed: true });
        const rider = simulation.add({ shape: box, translation: cut(0, -19.5, 0) }, { mass: 1 });
        simulation.setGravity(cut(0, -10, 0));
        const ridden = (material) => {
          simulation.setMaterial(belt, material);
          simulation.setPose(rider, { translation: cut(0, -19.5, 0) });
          simulation.setVelocity(rider, { linear: cut(0, 0, 0) });
          for (let i = 0; i < 30; ++i) simulation.step(1 / 60);
          return simulation.pose(rider).translation[0];
        };
        const surfaceVelocity = cut(1, 0, 0);
        ok(ridden({ staticFriction: 1, dynamicFriction: 1, surfaceVelocity }) > 0.3, "a belt");
        ok(Math.abs(ridden({ staticFriction: 0, dynamicFriction: 0, frictionCombine: "minimum", surfaceVelocity })) < 0.01, "a smooth one");
        simulation.setMaterial(belt, {});
        for (let i = 0; i < 300 && !simulation.asleep(rider); ++i) simulation.step(1 / 60);
        ok(simulation.asleep(rider), "asleep");
        simulation.wake(rider);
        ok(!simulation.asleep(rider), "awake");
        simulation.dispose(), box.dispose();
      }
  }],

  ["shapes and ways of bodies of a world", ({ graze, double, queries }) => {
    for (const entry of [graze, double, queries])
      for (const library of [entry, entry.plane].filter(Boolean)) {
        const n = library === entry ? 3 : 2;
        const cut = (...v) => v.slice(0, n);
        const [small, large] = [new library.Box(cut(1, 1, 1)), new library.Box(cut(3, 3, 3))];
        const world = new library.World();
        const wall = world.add({ shape: small, fixed: true });
        const flyer = world.add({ shape: small, translation: cut(-4, 0, 0), linear: cut(8, 0, 0) });
        world.update();
        equal([world.contacts().length, world.memory() > 0], [0, true], "apart");
        world.findImpacts(1);
        equal(world.impacts(), [], "none is fast");
        world.setFast(flyer, true);
        world.findImpacts(1);
        const [{ a, b, hit }, ...others] = world.impacts();
        equal([[a.index, b.index].sort(), others.length], [[wall.index, flyer.index], 0], "an impact");
        close(hit.t, 3 / 8, 1e-5, "its time");
        world.setShape(wall, large);
        world.setShape(flyer, large.rounded(1));
        world.move(flyer, { translation: cut(-3.5, 0, 0) });
        world.update();
        equal(world.contacts().length, 1, "with larger shapes they touch");
        for (const thing of [world, small, large]) thing.dispose();
      }
  }],

  ["what questions of the plane do, and margins and areas of it", ({ graze, double }) => {
    for (const { plane } of [graze, double]) {
      const box = new plane.Box([2, 2]).rounded(0.25);
      equal(box.rounding, 0.25, "rounding");
      ok(plane.contactMargin(box, box) > 0, "a margin");
      const [there, far] = [{ translation: [1, 0.5], rotation: 0.5 }, { shape: box, translation: [9, 0], linear: [-10, 0] }];
      const asked = [
        ["overlap", box, {}, box, there], ["distance", box, {}, box, there], ["contacts", box, {}, box, there, 0.5],
        ["closest", box, there, [4, 5]], ["raycast", box, {}, { origin: [-5, 0], direction: [1, 0] }], ["cast", { shape: box }, far]];
      for (const [name, ...question] of asked) {
        const { answer, trace } = plane.traced[name](...question);
        equal(answer, plane[name](...question), name);
        ok(trace.method !== "" || trace.pieces > 0, `what ${name} did`);
      }
      const world = new plane.World();
      for (const x of [-3, 5]) world.add({ shape: box, translation: [x, 1] });
      const { center, size } = plane.draw.area(world);
      close(center, [1, 1, 0], 1e-5, "the middle of a world");
      ok(size >= 2 * (4 + 1.25) - 1e-5, "its size");
      world.dispose(), box.dispose();
    }
  }],

  ["the plane", ({ double: graze }) => {
    const { plane } = graze;
    const next = random(9);
    const points = [[0, 0], [2, 0], [1, 2]];
    const shapes = [
      [new plane.Circle(0.5), { type: "circle", circle: { radius: 0.5 } }],
      [new plane.Box([1, 2]), { type: "box", box: { size: [1, 2] } }],
      [new plane.Capsule(1, 0.25, 0.5), { type: "capsule", capsule: { height: 1, radiusBottom: 0.25, radiusTop: 0.5 } }],
      [new plane.Convex(points), { type: "convex", convex: { points } }],
      [new plane.Segment(points[0], points[1]), { type: "segment", segment: { points: points.slice(0, 2) } }]];
    for (const [a, shapeA] of shapes)
      for (const [b, shapeB] of shapes) {
        const at = { translation: vector(next, 2).slice(0, 2), rotation: next() * 6 };
        const told = JSON.parse(graze.query(JSON.stringify({
          query: "distance", dimension: 2, a: { shape: shapeA }, b: { shape: shapeB, ...at } })));
        const near = plane.distance(a, {}, b, at);
        equal([near.distance, near.normal.map((x) => x + 0), near.a.map((x) => x + 0), near.b.map((x) => x + 0)],
              [told.distance, told.normal, told.a, told.b], "distance in the plane");
        equal(plane.overlap(a, {}, b, at), told.distance <= 0, "overlap in the plane");
      }
    const [[circle], [box]] = shapes;
    const found = plane.contacts(box, {}, box, { translation: [0, 1.75] });
    equal(found.manifolds[0].points.length, 2, "points in the plane");
    equal(found.manifolds[0].points.flatMap((p) => plane.featureCorners(box, p.feature >>> 16)).map(([, y]) => y), [1, 1],
          "both corners of the upper side");
    equal(plane.featureCorners(box, 2 * 2 ** 14 + 1), [[0.5, -1], [0.5, 1]], "a side");
    equal(plane.featureCorners(circle, 2 ** 14), [], "corners of a circle");
    equal(plane.raycast(box, {}, { origin: [-3, 0], direction: [1, 0] }).t, 2.5, "ray in the plane");
    close(plane.cast({ shape: box }, { shape: circle, translation: [5, 0], linear: [-8, 0] }).t, 0.5, 1e-6, "cast");
    const both = new plane.Compound([{ shape: box, translation: [3, 0] }, { shape: box }]);
    const along = { origin: [-3, 0], direction: [1, 0] };
    equal(plane.raycastAll(both, {}, along).map(({ t, piece }) => [t, piece]), [[2.5, 1], [5.5, 0]], "all hits");
    equal([plane.raycastAny(both, {}, along), plane.raycastAny(both, {}, { ...along, length: 2 })], [true, false], "any hit");
    const times = plane.castAll({ shape: both }, { shape: circle, translation: [9, 0], linear: [-8, 0] }).map(({ t }) => t);
    close(times, [5 / 8, 1], 1e-6, "all casts");
    close(Object.values(box.massProperties()), [2, [0, 0], 2 * 5 / 12], 1e-12, "mass in the plane");
    equal(plane.closest(box, {}, [3, 0]).distance, 2.5, "closest in the plane");
    close(plane.poseAt({ linear: [2, 0], angular: 1 }, 0.5).rotation, 0.5, 1e-12, "pose in the plane");
    const beside = { translation: [2, 0] };
    equal([plane.within(box, {}, circle, beside, 1), plane.within(box, {}, circle, beside, 0.5)], [true, false], "within");
    equal(plane.distanceUpTo(box, {}, circle, beside, 0.5), null, "further than the limit");
    equal(plane.distanceUpTo(box, {}, circle, beside, 1), plane.distance(box, {}, circle, beside), "within the limit");
    equal(plane.nearPieces(both, {}, circle, beside, 1.25).map(({ pieceA, pieceB, distance }) => [pieceA, pieceB, distance.distance]),
          [[0, 0, 0], [1, 0, 1]], "pieces");
    close(circle.support([3, 4]), [0.3, 0.4], 1e-12, "support");
    equal(box.support([1, 1]), [0.5, 1], "a corner");
    const path = circle.swept({}, [2, 0]);
    equal(path.kind, "segment", "a disc sweeps a rounded segment");
    close(plane.distance(path, {}, circle, { translation: [1, 2] }).distance, 1, 1e-12, "from the middle of the way");
    throws(() => both.support([1, 0]), "shape: expected a bounded convex shape, got compound", graze.InvalidValue);
    equal(plane.alongLines([1, -1], [[0, 1]]), [1, 0], "along a line");
    equal(plane.tessellate(box, { translation: [3, 0] }).points.map(([x, , z]) => [Math.abs(x - 3), z]), Array(4).fill([0.5, 0]), "outline");
    ok(plane.traced.distance(shapes[3][0], {}, box, { translation: [5, 5] }).trace.gjk.length > 0, "trace in the plane");
    const { lower, upper } = new plane.Compound([{ shape: circle, translation: [2, 0] }, { shape: box }]).bounds();
    close([lower, upper], [[-0.5, -1], [2.5, 1]], 1e-12, "compound in the plane");
    equal([new plane.Chain(points, { closed: true }).kind, new plane.Polygon(points).kind, new plane.Ellipse([1, 2]).kind,
           new plane.HalfPlane().kind, circle.rounded(1).kind], ["chain", "polygon", "ellipse", "halfPlane", "circle"]);
  }],

  ["worlds of the plane", ({ graze, double }) => {
    for (const { plane, Numbers, InvalidValue } of [graze, double]) {
      const world = new plane.World();
      const box = new plane.Box([1, 1]), circle = new plane.Circle(0.5);
      const ground = world.add({ shape: new plane.HalfPlane(), fixed: true });
      const crate = world.add({ shape: box, translation: [3, 0.49], filter: { category: 2 } });
      const ball = world.add({ shape: circle, translation: [-2, 3], linear: [0, -4], fast: true });
      equal([world.size, world.contains(ball), world.bodyAt(1)], [3, true, crate], "bodies");
      world.update(1);
      const [pair] = world.contacts();
      equal([pair.a, pair.b, pair.overlap, pair.manifolds[0].points.length], [0, 1, true, 2], "the crate on the ground");
      close(pair.manifolds[0].points.map((p) => p.distance), [-0.01, -0.01], 1e-6, "depths");
      close(pair.manifolds[0].normal, [0, 1], 0, "upwards");
      equal([world.points().length, world.points().at(0).impulse], [2, [0, 0]], "points without a copy");
      equal(world.events().map((e) => e.kind), ["begin"], "events");
      equal(world.impacts().map((i) => [i.a.index, i.b.index]), [[0, 2]], "the ball would fall through the ground");
      close(world.impacts()[0].hit.t, 2.5 / 4, 1e-5, "when");
      world.move(ball, { translation: [-2, 5], rotation: 0.5 }, { linear: [1, 0], angular: 2 });
      close(world.pose(ball).rotation, 0.5, 1e-6, "an angle");
      close(Array.from(world.poses()).slice(8), [-2, 5, Math.cos(0.5), Math.sin(0.5)], 1e-6, "four numbers");
      const poses = new Numbers(8);
      poses.array.set([3, 2, 1, 0, -2, 6, 0, 1]);
      world.moveBatch([crate, ball], poses);
      close([world.pose(crate).translation, world.pose(ball).rotation], [[3, 2], Math.PI / 2], 1e-6, "moved together");
      throws(() => world.moveBatch([crate], [0, 0, 0, 0]), "poses[0].rotation: expected a unit vector of cosine and sine, got [0, 0]", InvalidValue);
      world.update();
      equal(world.events().map((e) => [e.kind, e.pair]), [["end", -1]], "nothing touches any more");

      const ray = { origin: [3, 5], direction: [0, -1] };
      close(world.raycast(ray).hit.t, 2.5, 1e-6, "ray");
      equal(world.raycastAll(ray).map((hit) => hit.body.index), [1, 0], "all on the way");
      equal(world.raycast(ray, { mask: 1 }).body, ground, "filtered");
      equal(world.raycastAny({ ...ray, length: 2 }), false, "short");
      equal(world.overlapping(circle, { translation: [3, 2.9] }), [crate], "overlapping");
      equal(world.overlapsAny(circle, { translation: [6, 2] }), false, "nothing there");
      close(world.nearest(circle, { translation: [3, 4] }, 2).map((n) => n.distance.distance), [1, 3.5], 1e-6, "nearest");
      const falling = { shape: circle, translation: [3, 4], linear: [0, -2] };
      close(world.cast(falling).hit.t, 0.5, 1e-5, "cast");
      equal(world.castAll(falling, { duration: 3 }).map((hit) => hit.body.index), [1, 0], "casts");
      equal(world.cast(falling, { accept: (body) => body.index !== 1 }), null, "refused by the caller");
      const kind = world.shape(crate);
      equal(kind.kind, "box", "shape");
      kind.dispose();
      const slide = world.slide(circle, { translation: [-2, 2] }, [1, -4]);
      close([slide.end.translation, slide.end.rotation, slide.left], [[-1, 0.5], 0, [0, 0]], 1e-4, "slide");
      equal(slide.touched.map(({ body }) => body), [ground], "along the ground");
      let lines = 0;
      plane.draw.world(world, { size: 5, line: () => ++lines });
      ok(lines > 4, "drawn");
      world.remove(crate);
      equal(world.contains(crate), false, "removed");
      world.dispose();
      throws(() => world.update(), "world: expected a live object, got a disposed one", InvalidValue);
    }
  }],

  ["simulations of the plane", ({ graze, double }) => {
    for (const { plane, InvalidValue } of [graze, double]) {
      const simulation = new plane.Simulation({ gravity: [0, -10] });
      const floor = simulation.add({ shape: new plane.HalfPlane(), fixed: true });
      const crate = simulation.add({ shape: new plane.Box([1, 1]), translation: [0, 2] }, { mass: 3, inertia: 0.5 }, { restitution: 0 });
      equal([simulation.mass(crate), simulation.mass(floor)], [3, Infinity], "masses");
      const start = simulation.save();
      for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
      close(simulation.pose(crate).translation, [0, 0.5], 0.01, "at rest");
      close(Array.from(simulation.poses()).slice(4), [0, 0.5, 1, 0], 0.01, "poses");
      equal(simulation.world.contacts()[0].manifolds[0].points.length, 2, "points");
      equal(simulation.asleep(crate), true, "asleep");
      close(simulation.report().potentialEnergy, 3 * 10 * 0.5, 0.5, "energy");
      const end = simulation.pose(crate);
      simulation.restore(plane.State.fromBytes(start.bytes()));
      for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
      equal(simulation.pose(crate), end, "the same bits again");

      simulation.applyImpulse(crate, [3, 0], end.translation);
      close(simulation.motion(crate).linear[0], 1, 1e-5, "pushed");
      simulation.applyAngularImpulse(crate, 0.25);
      close(simulation.motion(crate).angular, 0.5, 1e-5, "turned");
      close(simulation.angularMomentum(crate), 0.25, 1e-5, "angular momentum");
      simulation.setVelocity(crate, { linear: [0, 1], angular: -1 });
      close([simulation.motion(crate).linear, simulation.motion(crate).angular], [[0, 1], -1], 1e-6, "velocity");
      throws(() => simulation.add({ shape: new plane.Box([1, 1]) }, { inertia: -1 }), "inertia: expected a number > 0 with a finite inverse, got -1", InvalidValue);

      const hinge = simulation.addJoint({
        a: floor, b: crate, kind: "hinge", frameA: { translation: [0, 5] }, frameB: { translation: [0, 1] },
        drives: [{ space: "angular", axis: "z", velocityTarget: 1, damping: 10 }] });
      simulation.setPose(crate, { translation: [0, 4] });
      for (let i = 0; i < 60; ++i) simulation.step(1 / 60);
      const { translation, rotation } = simulation.pose(crate);
      close([translation[0] - Math.sin(rotation), translation[1] + Math.cos(rotation)], [0, 5], 0.02, "hinge");
      ok(simulation.jointImpulses(hinge).length >= 2, "rows");
      const known = simulation.joint(hinge);
      equal([simulation.joints(), known.frameB, known.limits[0].axes], [[hinge], { translation: [0, 1], rotation: 0 }, ["x", "y"]], "the joint");
      ok(simulation.subSteps(crate) >= 4 && typeof simulation.stateHash() === "bigint", "sub-steps and a hash");
      simulation.setJoint(hinge, simulation.joint(hinge));
      simulation.setFilter(simulation.joint(hinge).b, {});
      simulation.removeJoint(hinge);
      simulation.remove(crate);
      equal(simulation.world.size, 1, "bodies");
      simulation.dispose(), start.dispose();
    }
  }],

  ["materials of pieces", ({ graze, double }) => {
    for (const entry of [graze, double])
      for (const library of [entry, entry.plane]) {
        const space = library === entry;
        const at = (side, height) => (space ? [0, height, side * 20] : [0, side * 200 + height]);
        const [slab, slider] = [[80, 1, 40], [2, 1, 1]].map((sizes) => new library.Box(space ? sizes : sizes.slice(0, 2)));
        const simulation = new library.Simulation({ gravity: space ? [0, -10, 0] : [0, -10] });
        const floor = simulation.add({
          fixed: true, shape: new library.Compound([-1, 1].map((side) => ({ shape: slab, translation: at(side, -0.5) }))) });
        const rubbing = (friction) => ({ staticFriction: friction, dynamicFriction: friction, frictionCombine: "minimum" });
        const materials = [rubbing(0), rubbing(0.3)];
        simulation.setMaterials(floor, materials, [0, 1]);
        const [onIce, onFelt] = [-1, 1].map((side) => simulation.add(
          { shape: slider, translation: at(side, 0.5), linear: space ? [6, 0, 0] : [6, 0] }, {}, rubbing(1)));
        for (let i = 0; i < 60; ++i) simulation.step(1 / 60);
        close(simulation.motion(onIce).linear[0], 6, 1e-3, "on ice");
        close(simulation.motion(onFelt).linear[0], 3, 0.1, "on felt");
        simulation.setMaterials(floor, materials, new Uint32Array([1, 0]));
        const refuses = (act, message) => throws(act, message, entry.InvalidValue);
        refuses(() => simulation.setMaterials(floor, materials, [0]), "of_piece: expected a number for each of the 2 pieces, got 1");
        refuses(() => simulation.setMaterials(floor, materials, [0, 2]),
          "of_piece[1]: expected the place of one of the 2 materials, got 2");
        refuses(() => simulation.setMaterials(floor, materials, [0, 0.5]), /^ofPiece\[1\]: expected /);
        refuses(() => simulation.setMaterials(floor, [{ friction: 1 }], [0, 0]), /^materials\[0\]: expected staticFriction, /);
        refuses(() => simulation.setMaterials(floor, {}, [0, 0]), /^materials: expected an array, /);
        refuses(() => simulation.setMaterials(onIce, materials, [0, 1]), /^body: expected one whose shape has pieces/);
        simulation.dispose();
      }
  }],

  ["a simulation without warm starting", ({ graze, double }) => {
    for (const entry of [graze, double])
      for (const library of [entry, entry.plane]) {
        const space = library === entry;
        const sunk = (settings) => {
          const simulation = new library.Simulation({ sleep: false, subSteps: 4, mostSubSteps: 4, ...settings });
          simulation.add({ shape: space ? new library.HalfSpace() : new library.HalfPlane(), fixed: true });
          const box = new library.Box(space ? [1, 1, 1] : [1, 1]);
          let top;
          for (let i = 0; i < 10; ++i) top = simulation.add({ shape: box, translation: [0, 0.5 + i, 0].slice(0, space ? 3 : 2) });
          for (let i = 0; i < 120; ++i) simulation.step(1 / 60);
          const { translation } = simulation.pose(top);
          simulation.dispose();
          return 9.5 - translation[1];
        };
        const warm = sunk({});
        equal(sunk({ warmStart: true }), warm, "as usual");
        ok(warm > 0 && warm < 0.05 && sunk({ warmStart: false }) > 4 * warm, "a stack sinks");
      }
  }],

  ["debug draw", ({ graze, queries }) => {
    const drawn = [];
    const renderer = {
      center: [0, 0, 0],
      size: 4,
      ...Object.fromEntries(["point", "line", "triangle", "text"].map((kind) => [
        kind, (...given) => drawn.push({ kind, meaning: given.pop(), layer: given.pop(), places: given })])),
    };
    const drawing = (body) => {
      drawn.length = 0;
      body();
      return [...drawn];
    };
    const kinds = (all, of) => [...new Set(all.map((d) => d[of]))].sort();

    const box = new graze.Box([2, 2, 2]);
    const faces = drawing(() => graze.draw.shape(box, { translation: [5, 0, 0] }, renderer, "moving"))
      .filter((d) => d.kind === "triangle");
    equal(faces.length, 12, "triangles of a box");
    equal([kinds(faces, "layer"), kinds(faces, "meaning")], [["shapes"], ["moving"]], "of a shape that moves");
    for (const { places: [a, b, c] } of faces) {
      for (const p of [a, b, c]) equal(p.map((x, i) => Math.abs(x - [5, 0, 0][i])), [1, 1, 1], "a corner");
      const [u, v] = [b.map((x, i) => x - a[i]), c.map((x, i) => x - a[i])];
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      ok(normal.reduce((s, x, i) => s + x * (a[i] - [5, 0, 0][i]), 0) > 0, "counter-clockwise from outside");
    }

    const world = new graze.World();
    world.add({ shape: new graze.HalfSpace(), fixed: true });
    world.add({ shape: box, translation: [0, 0.9, 0] });
    world.update();
    equal(graze.draw.area(world).center.length, 3, "an area");
    const all = drawing(() => graze.draw.world(world, renderer));
    equal(kinds(all, "layer").filter((l) => ["shapes", "contacts", "bounds"].includes(l)), ["bounds", "contacts", "shapes"]);
    const contacts = drawing(() => graze.draw.world(world, { ...renderer, layers: ["contacts"] }));
    equal(kinds(contacts, "layer"), ["contacts"], "the layers that are wanted");
    const points = contacts.filter((d) => d.kind === "point").map((d) => d.places[0]);
    equal(points.length, 4, "points of contact");
    equal(drawing(() => graze.draw.world(world, { size: 4 })), [], "a renderer without methods");

    const simulation = new graze.Simulation();
    const [a, b] = [0, 3].map((x) => simulation.add({ shape: box, translation: [x, 0, 0] }));
    simulation.addJoint({ a, b, kind: "ball", frameA: { translation: [1.5, 0, 0] }, frameB: { translation: [-1.5, 0, 0] } });
    ok(kinds(drawing(() => graze.draw.simulation(simulation, renderer)), "layer").includes("joints"), "joints");

    const near = graze.distance(box, {}, box, { translation: [4, 0, 0] });
    ok(kinds(drawing(() => graze.draw.distance(near, renderer)), "meaning").includes("gap"), "a gap");
    let told = null;
    const explained = drawing(() => { told = graze.draw.explained(renderer).distance(box, {}, box, { translation: [4, 0, 0] }); });
    equal(told, near, "the same answer");
    ok(explained.length > 0 && kinds(explained, "layer").includes("trace"), "what the question did");
    const overlapping = [box, {}, box, { translation: [1, 0, 0] }];
    const step = drawing(() => graze.draw.explained(renderer, { step: 0 }).overlap(...overlapping));
    equal(step.map((d) => d.kind), ["line", "line", "line", "text"], "one axis: its intervals, the overlap, its name");
    const { length } = graze.traced.overlap(...overlapping).trace.axes;
    throws(() => graze.draw.explained(renderer, { step: length }).overlap(...overlapping),
      `step: expected a number below ${length}, got ${length}`, graze.InvalidValue);

    // A trace as data draws what drew it when it was asked, whole and step by step; also where the plane has two numbers.
    const corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]], two = (v) => v.slice(0, 2);
    const tilted = { translation: [0.2, 1.8, 0.3], rotation: [0, 0, Math.sin(0.1), Math.cos(0.1)] };
    const inPlane = [new graze.plane.Box([2, 1]), {}, new graze.plane.Ellipse([1, 0.6]), { translation: [0.5, 0.3] }];
    for (const [library, query, args] of [
      [graze, "contacts", [box, {}, box, tilted]], [graze, "distance", [new graze.ConvexHull(corners), {}, box, { translation: [0.5, 0.4, 0.1] }]],
      [graze.plane, "distance", inPlane]]) {
      const { trace } = library.traced[query](...args), { axes, gjk, epa, cuts } = trace;
      const count = axes.length + gjk.length + epa.length + cuts.length;
      ok(count > 0, `${query} has steps`);
      for (const step of [undefined, ...Array.from({ length: count }, (_, i) => i)]) {
        const asked = drawing(() => library.draw.explained(renderer, { step })[query](...args));
        equal(drawing(() => library.draw.trace(trace, renderer, { step })), asked, `${query}, step ${step}, as data`);
      }
      throws(() => library.draw.trace(trace, renderer, { step: count }), `step: expected a number below ${count}, got ${count}`, graze.InvalidValue);
    }
    const { gjk: [iteration] } = graze.plane.traced.distance(...inPlane.slice(0, 3), { translation: [3, 0.3] }).trace;
    const flatly = { simplex: iteration.simplex.map(({ a, b }) => ({ a: two(a), b: two(b) })), direction: two(iteration.direction),
      found: { a: two(iteration.found.a), b: two(iteration.found.b) } };
    equal(drawing(() => graze.draw.trace({ gjk: [flatly] }, renderer)), drawing(() => graze.draw.trace({ gjk: [{ ...iteration, polygon: [] }] }, renderer)), "two numbers");
    equal(drawing(() => graze.draw.trace({}, renderer)), [], "a trace of nothing");
    throws(() => graze.draw.trace({ triangles: [[0, 1, 2]] }, renderer), "view.triangles[0]: expected numbers of vertices of the polytope, got 0", graze.InvalidValue);
    throws(() => graze.draw.trace({ faceA: [[0, NaN, 0]] }, renderer), "view.face_a[1]: expected a finite number, got nan", graze.InvalidValue);
    throws(() => graze.draw.trace({ cuts: [{ to: [0, 0, 0], left: [] }] }, renderer), "cuts[0].from: expected numbers, got undefined", graze.InvalidValue);

    // Answers, of space and of the plane: from vectors of three numbers or of two.
    const flat = (v) => v.slice(0, 2);
    for (const [library, cut] of [[graze, (v) => v], [graze.plane, flat]]) {
      const manifold = { normal: cut([0, 1, 0]), points: [{ a: cut([0, 0, 0]), b: cut([0, 1, 0]), weight: 0.25 }, { a: cut([1, 0, 0]), b: cut([1, 1, 0]) }] };
      const touching = drawing(() => library.draw.contacts(manifold, renderer));
      equal(touching.filter((d) => d.kind === "point").map((d) => d.places[0]), [[0, 0.25, 0], [1, 0.5, 0]], "points by their weights");
      equal(kinds(touching, "meaning"), ["contact", "normal"], "and their normal");
      const arrows = [];
      library.draw.contacts(manifold, { arrow: (...given) => arrows.push(given) });
      equal(arrows, [[[0.5, 0.375, 0], [0, 1, 0], "contacts", "normal"]], "an arrow from the middle");
      const gap = drawing(() => library.draw.distance({ a: cut([1, 0, 0]), b: cut([2, 0, 0]) }, renderer));
      equal(gap.map((d) => d.meaning), ["gap", "a", "b"], "a distance");
      const ray = { origin: cut([3, 0, 0]), direction: cut([-1, 0, 0]) };
      const hit = { t: 2, point: cut([1, 0, 0]), normal: cut([1, 0, 0]) };
      equal(drawing(() => library.draw.ray(ray, hit, renderer))[0].places, [[3, 0, 0], [1, 0, 0]], "a ray up to its hit");
      equal(kinds(drawing(() => library.draw.ray({ ...ray, length: 1 }, null, renderer)), "meaning"), ["path"], "one that hits nothing");
      const moving = { shape: library === graze ? box : new graze.plane.Box([2, 2]), linear: cut([3, 0, 0]) };
      const thrown = drawing(() => library.draw.cast(moving, null, renderer, { duration: 2 }));
      equal(thrown.filter((d) => d.meaning === "path").map((d) => d.places), [[[0, 0, 0], [6, 0, 0]]], "the way of a cast");
      ok(kinds(thrown, "meaning").includes("ghost") && kinds(thrown, "layer").join() === "casts", "places along it");
      throws(() => library.draw.ray(ray, { ...hit, t: NaN }, renderer), "hit.t: expected a finite number, got nan", graze.InvalidValue);
    }
    equal(drawing(() => graze.draw.bounds({ lower: [0, 0, 0], upper: [1, 2, 3] }, renderer)).length, 12, "edges of a box");
    const tree = new graze.BroadPhase();
    for (let i = 0; i < 40; i++) tree.insert(i, [i, 0, 0], [i + 0.5, 1, 1]);
    const parts = tree.parts(), boxes = drawing(() => graze.draw.tree(parts, renderer));
    equal([boxes.length, kinds(boxes, "layer")], [12 * parts.length, ["tree"]], "the boxes of a tree");
    tree.dispose();
    for (const [library, cut] of [[graze, (v) => v], [graze.plane, flat]]) {
      const tied = { frameA: { translation: cut([1, 0, 0]) }, frameB: { translation: cut([-1, 0, 0]) } };
      const joint = drawing(() => library.draw.joint(tied, {}, { translation: cut([4, 0, 0]) }, renderer));
      equal(joint.filter((d) => d.kind === "line").map((d) => d.places),
        [[[0, 0, 0], [1, 0, 0]], [[4, 0, 0], [3, 0, 0]], [[1, 0, 0], [3, 0, 0]]], "a joint by itself");
    }

    // One body of a world and of a simulation, and one span of a ray.
    for (const [library, cut] of [[graze, (v) => v], [graze.plane, flat]]) {
      const one = new library.Box(cut([1, 1, 1]));
      const [here, there] = [new library.World(), new library.Simulation()];
      const places = [[0, 0, 0], [5, 0, 0]].map(cut);
      const ids = [here, there].map((owner) => places.map((translation) => owner.add({ shape: one, translation })));
      here.update();
      const body = (owner, id) => drawing(() => library.draw.body(owner, id, renderer));
      const whole = drawing(() => library.draw.world(here, renderer)).filter((d) => d.layer !== "tree");
      const alone = ids[0].map((id) => body(here, id));
      equal(alone.flat().length, whole.length, "bodies one by one");
      ok(alone[1].length > 0 && alone[1].every((d) => d.places.every((p) => p[0] > 4)), "the second body");
      ok(body(there, ids[1][0]).length > 0 && body(there.world, ids[1][1]).length > 0, "bodies of a simulation");
      here.remove(ids[0][1]);
      throws(() => body(here, ids[0][1]), /^id: expected a body of this world/, graze.InvalidValue);
      throws(() => body({}, ids[0][0]), "world: expected a World, got Object", graze.InvalidValue);
      const ray = { origin: cut([-3, 0.25, 0]), direction: cut([1, 0, 0]) };
      const { trace } = library.traced.raycast(one, {}, ray);
      const spans = trace.spans.map((_, i) => drawing(() => library.draw.span(trace, i, ray, renderer)));
      ok(spans.length > 0 && spans.every((d) => d.length > 0 && kinds(d, "layer").join() === "trace"), "spans");
      const winner = trace.spans.findIndex(({ name }) => name === trace.winner);
      equal(spans.map((d) => d.some(({ kind }) => kind === "text")), spans.map((_, i) => i === winner), "the winner has its name");
      const own = { spans: [{ name: "mine", normal: cut([1, 0, 0]), enter: 1, leave: 2 }] };
      ok(drawing(() => library.draw.span(own, 0, ray, renderer)).flatMap((d) => d.places).some((p) => p[0] === -2), "one's own span");
      throws(() => library.draw.span(trace, 99, ray, renderer), /^span/, graze.InvalidValue);
      throws(() => library.draw.span({ spans: [{ name: "x", normal: cut([1, 0, 0]) }] }, 0, ray, renderer),
             "spans[0].enter: expected numbers, got undefined", graze.InvalidValue);
      throws(() => library.draw.span(trace, 0, { ...ray, direction: undefined }, renderer), /^ray.direction: expected/, graze.InvalidValue);
      for (const thing of [here, there, one]) thing.dispose();
    }

    const outline = drawing(() => graze.plane.draw.shape(new graze.plane.Box([2, 1]), {}, renderer));
    ok(outline.some((d) => d.kind === "line") && outline.every((d) => d.places.every((p) => p[2] === 0)), "in the plane");
    ok(drawing(() => graze.plane.draw.explained(renderer).distance(
      new graze.plane.Box([1, 1]), {}, new graze.plane.Box([1, 1]), { translation: [3, 0] })).length > 0, "a trace of the plane");

    const rgb = graze.draw.color("contact");
    ok(rgb.length === 3 && rgb.every((x) => Number.isInteger(x) && x >= 0 && x <= 255), "a colour");
    throws(
      () => graze.draw.color("pretty"),
      "meaning: expected one of a, b, fixed, touched, moving, touching, asleep, trigger, contact, normal, gap, " +
        'ruledOut, bounds, path, ghost, joint, got "pretty"', graze.InvalidValue);
    throws(
      () => graze.draw.shape(box, {}, { layers: ["all"] }),
      "renderer.layers: expected one of shapes, bounds, tree, contacts, distances, rays, casts, trace, joints, " +
        'got "all"', graze.InvalidValue);
    throws(() => graze.draw.shape(box, {}, { size: 0 }), "on.size: expected a size > 0, got 0", graze.InvalidValue);
    throws(() => graze.draw.shape(box, {}, { triangle: () => { throw new Error("out of ink"); } }), "out of ink", Error);
    equal(queries.draw, undefined, "graze/queries draws nothing");
  }],

  ["the runs have the bits of every other build", ({ longRun }) => {
    for (const [run, name] of ["batches", "single questions", "what moves", "the plane"].entries())
      for (const inDouble of [0, 1])
        equal(longRun.hash(run, inDouble), longRun.golden(run, inDouble), `${name} in ${inDouble ? "double" : "float"}`);
  }],

  ["nothing leaks", ({ graze }) => {
    const round = () => {
      const box = new graze.Box([1, 1, 1]);
      const hull = new graze.ConvexHull(Array.from({ length: 60 }, (_, i) => Math.sin(i * i)));
      const both = new graze.Compound([{ shape: box }, { shape: hull }]);
      const user = new graze.UserConvex((d) => d);
      const world = new graze.World({ allow: () => true });
      for (const shape of [box, hull, both]) world.add({ shape });
      world.update();
      world.pose(world.bodyAt(0));
      const simulation = new graze.Simulation();
      simulation.add({ shape: box });
      simulation.step(0.01);
      const state = simulation.save();
      const batch = graze.distanceBatch({ shapes: box, poses: [0, 0, 0, 0, 0, 0, 1] }, { shapes: hull, poses: [0, 0, 0, 0, 0, 0, 1] });
      const broad = new graze.BroadPhase();
      broad.insert(0, [0, 0, 0], [1, 1, 1]);
      graze.draw.explained({ size: 3 }).distance(both, {}, box, { translation: [3, 0, 0] });
      graze.draw.world(world, { text: () => {} });
      graze.traced.distance(both, {}, user, { translation: [3, 0, 0] });
      const numbers = new graze.Numbers(100000); // more than the scratch arena
      graze.overlapBatch({ shapes: box, poses: new Float32Array(70000).map((_, i) => (i % 7 === 6 ? 1 : 0)) }, { shapes: box, poses: [0, 0, 0, 0, 0, 0, 1] });
      try {
        new graze.ConvexHull([]);
      } catch (error) {
        ok(error instanceof graze.InvalidValue, "a refusal");
      }
      const circle = new graze.plane.Circle(1);
      for (const handle of [batch, both, box, broad, circle, hull, numbers, simulation, state, user, world]) handle.dispose();
    };
    round();
    const before = graze.memoryInUse();
    for (let i = 0; i < 20; ++i) round();
    equal(graze.memoryInUse() - before, 0, "bytes that twenty rounds leave");
  }],
];
