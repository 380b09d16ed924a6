// A step of the build: the service worker, with the names of all files and a hash of what they hold.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative, sep } from "node:path";
import type { Plugin } from "vite";

const worker = "service-worker.js";

/** The files below a folder, by their paths from there. */
const filesBelow = (folder: string): string[] =>
  readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => relative(folder, join(parentPath, name)).split(sep).join("/")).sort();

export function offline(source: string): Plugin {
  let folder = "";
  return {
    name: "graze-offline",
    apply: "build",
    configResolved: ({ build }) => void (folder = build.outDir),
    closeBundle() {
      const files = filesBelow(folder).filter((file) => file !== worker), hash = createHash("sha256");
      for (const file of files) hash.update(file).update("\0").update(readFileSync(join(folder, file)));
      const text = readFileSync(source, "utf8");
      // What it does is a part of the version too.
      const version = hash.update(text).digest("hex").slice(0, 16);
      writeFileSync(join(folder, worker), text.replace('"VERSION"', JSON.stringify(version)).replace('["FILES"]', JSON.stringify(files)));
    },
  };
}
