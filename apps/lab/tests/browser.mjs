// The lab in a real browser: every lesson loads, its steps run to the end, a drag changes the numbers to those of the
// library, permalinks restore, nothing is written to the console, and axe finds nothing. Settings are listed in
// browser/harness.mjs.
//
//   node tests/browser.mjs

import { runAll } from "./browser/harness.mjs";
import "./browser/every-lesson.mjs";
import "./browser/scenes.mjs";
import "./browser/viewer.mjs";
import "./browser/questions.mjs";
import "./browser/time.mjs";
import "./browser/files.mjs";
import "./browser/captures.mjs";
import "./browser/stages.mjs";
import "./browser/offline.mjs";
import "./browser/animations.mjs";
import "./browser/hostile-addresses.mjs";
import "./browser/axes-lessons.mjs";
import "./browser/formulas.mjs";
import "./browser/iterations-lessons.mjs";
import "./browser/other-lessons.mjs";

await runAll();
