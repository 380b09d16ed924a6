// The lab in a real browser: every lesson loads, its steps run to the end, a drag changes the numbers to those of the
// library, permalinks restore, nothing is written to the console, and axe finds nothing. Settings are listed in
// browser/harness.mjs.
//
//   node tests/browser.mjs

import { runAll } from "./browser/harness.mjs";
import "./browser/every-lesson.mjs";
import "./browser/axes-lessons.mjs";
import "./browser/scenes.mjs";
import "./browser/viewer.mjs";
import "./browser/files.mjs";
import "./browser/offline.mjs";
// What one lesson or one way through the viewer has of its own: as much time again.
if (!process.env.QUICK)
  for (const own of ["captures", "animations", "time", "questions", "stages", "hostile-addresses", "formulas", "iterations-lessons", "other-lessons"])
    await import(`./browser/${own}.mjs`);

await runAll();
