// Static files that work from any folder of any host: no address outside themselves, no inline script or style.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { offline } from "./offline.ts";

const package_ = fileURLToPath(new URL("../../bindings/js/dist/", import.meta.url));

export default defineConfig({
  base: "./",
  plugins: [offline(fileURLToPath(new URL("./service-worker.js", import.meta.url)))],
  resolve: { alias: { "graze/double": `${package_}double.js`, graze: `${package_}index.js` } },
  server: { fs: { allow: ["../.."] } },
  build: { target: "es2022", modulePreload: { polyfill: false }, assetsInlineLimit: 0, chunkSizeWarningLimit: 1200 },
});
