// A page of one entry, whose bundle has that entry's module alone.
import { init, Box, overlap } from "graze/queries";

await init();
using box = new Box([2, 2, 2]);
await fetch("/answers", { method: "POST", body: JSON.stringify(overlap(box, {}, box, { translation: [1, 1, 1] })) });
