// `using` in a strict program, for TypeScript that knows it.
import { Box, distanceBatch, init, plane, Sphere, World } from "graze";
import { query } from "graze/double";
import { overlap } from "graze/queries";

await init();
{
  using box = new Box([2, 2, 2]), ball = new Sphere(0.5);
  using world = new World();
  world.add({ shape: box });
  using far = distanceBatch({ shapes: box, poses: [0, 0, 0, 0, 0, 0, 1] }, { shapes: ball, poses: [2, 0, 0, 0, 0, 0, 1] });
  using disk = new plane.Circle(1);
  const touch: boolean = overlap(box, {}, ball, {});
  console.log(far.at(0).distance.toFixed(2), disk.kind, touch, query("{}"));
  // @ts-expect-error an answer is no handle
  using wrong = world.contacts();
}
