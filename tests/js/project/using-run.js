// The checks of `using` as a compiler that lowers it made them: in Node a program, in a page a script that posts.
import * as graze from "graze";
import * as double from "graze/double";
import * as queries from "graze/queries";
import { usingChecks } from "./using.js";

const entries = { graze, double, queries };
await Promise.all(Object.values(entries).map(({ init }) => init()));
const failed = [];
for (const [name, check] of usingChecks)
  try {
    check(entries);
  } catch (error) {
    failed.push({ name, error: String(error?.stack ?? error) });
  }
const result = JSON.stringify({ checked: usingChecks.length, failed });
if (globalThis.document === undefined) console.log(result);
else await fetch("/answers", { method: "POST", body: result });
