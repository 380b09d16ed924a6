// The lessons in the order of the lectures. To add one: a file beside this one, and its line here.

import { appendix } from "./appendix.ts";
import { broadPhases } from "./broad-phases.ts";
import { contactSet } from "./contact-set.ts";
import { epaPlane, epaSpace } from "./epa.ts";
import { fifteenAxes } from "./fifteen-axes.ts";
import { filters } from "./filters.ts";
import { gjkPlane, gjkSpace } from "./gjk.ts";
import { hulls } from "./hulls.ts";
import type { Lesson } from "./lesson.ts";
import { minkowski } from "./minkowski.ts";
import { planesBoxes } from "./planes-boxes.ts";
import { resolution } from "./resolution.ts";
import { separatingAxesPlane } from "./separating-axes-plane.ts";
import { spheres } from "./spheres.ts";
import { stack } from "./stack.ts";
import { timeOfImpact } from "./time-of-impact.ts";

export const lessons: Lesson[] = [
  spheres, planesBoxes, separatingAxesPlane, fifteenAxes, contactSet, minkowski, gjkPlane, gjkSpace, epaPlane, epaSpace,
  hulls, broadPhases, filters, timeOfImpact, resolution, stack, appendix,
];
