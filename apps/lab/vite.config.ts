// Static files that work from any folder of any host: no address outside themselves, no inline script or style.

import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const package_ = fileURLToPath(new URL("../../bindings/js/dist/", import.meta.url));

export default defineConfig({
  base: "./",
  resolve: { alias: { "graze/double": `${package_}double.js`, graze: `${package_}index.js` } },
  server: { fs: { allow: ["../.."] } },
  build: { target: "es2022", modulePreload: { polyfill: false }, assetsInlineLimit: 0, chunkSizeWarningLimit: 1200 },
});
