// Answers of the package to some questions, in Node and in a page.
import { init, Box, Sphere, distance } from "graze";
import * as queries from "graze/queries";
import * as double from "graze/double";

/** What the float entries say of a pair, and `graze/double` to each line of the query protocol. */
export async function answers(lines) {
  await Promise.all([init(), queries.init(), double.init()]);
  const apart = (entry) => {
    const box = new entry.Box([2, 2, 2]);
    const ball = new entry.Sphere(0.5);
    const { distance: far } = entry.distance(box, {}, ball, { translation: [2, 0, 0] });
    for (const shape of [box, ball]) shape.dispose();
    return far;
  };
  return { distances: [{ Box, Sphere, distance }, queries, double].map(apart), lines: lines.map(double.query) };
}
