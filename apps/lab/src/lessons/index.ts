// The lessons in the order of the lectures. To add one: a file beside this one, and its line here.

import type { Lesson } from "./lesson.ts";
import { separatingAxesPlane } from "./separating-axes-plane.ts";

export const lessons: Lesson[] = [separatingAxesPlane];
