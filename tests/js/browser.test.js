// The package in headless Chromium, from a plain <script type="module">: a page runs the checks and posts what came of
// them. CHROMIUM names the browser; the distribution's otherwise.

import { createServer } from "node:http";
import { readFile, mkdtemp, rm } from "node:fs/promises";
import { spawn } from "node:child_process";
import { tmpdir } from "node:os";
import path from "node:path";
import test from "node:test";
import assert from "node:assert/strict";
import { fileURLToPath } from "node:url";
import { checks } from "./checks.js";

const here = path.dirname(fileURLToPath(import.meta.url));
const project = path.resolve(here, "../..");
const dist = path.resolve(process.env.GRAZE_PACKAGE ?? path.join(project, "bindings/js/dist"));
const longRun = process.env.GRAZE_LONG_RUN ?? path.join(project, "build/npm/long-run.wasm");
const types = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };

/** The file behind an address, or null. */
function fileOf(address) {
  if (address === "/") return path.join(here, "browser.html");
  if (address === "/long-run.wasm") return longRun;
  const [, folder, name, ...rest] = address.split("/");
  if (rest.length > 0 || !/^[\w-]+\.\w+$/.test(name ?? "")) return null;
  return { package: path.join(dist, name), tests: path.join(here, name) }[folder] ?? null;
}

test("the checks in headless Chromium", { timeout: 240000 }, async () => {
  const profile = await mkdtemp(path.join(tmpdir(), "graze-chromium-"));
  let browser;
  let server;
  try {
    const results = await new Promise((resolve, reject) => {
      server = createServer(async (request, response) => {
        if (request.method === "POST") {
          let body = "";
          for await (const part of request) body += part;
          response.end();
          resolve(JSON.parse(body));
          return;
        }
        try {
          const file = fileOf(new URL(request.url, "http://localhost").pathname);
          const content = await readFile(file);
          response.writeHead(200, { "Content-Type": types[path.extname(file)] ?? "text/plain" });
          response.end(content);
        } catch {
          response.writeHead(404);
          response.end();
        }
      });
      server.listen(0, "127.0.0.1", () => {
        // Without a sandbox, which root may not have; the page is ours.
        const flags = [
          "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
          `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/`];
        browser = spawn(process.env.CHROMIUM ?? "chromium-headless-shell", flags, { stdio: "ignore", detached: true });
        browser.on("error", reject);
        browser.on("exit", (code) => reject(new Error(`the browser ended with ${code} before the page had`)));
      });
    });
    const failed = results.filter(({ error }) => error !== undefined);
    assert.deepEqual(failed, []);
    assert.equal(results.length, checks.length);
  } finally {
    server?.closeAllConnections();
    server?.close();
    if (browser?.pid !== undefined && browser.exitCode === null) {
      const ended = new Promise((resolve) => browser.on("close", resolve));
      process.kill(-browser.pid, "SIGKILL"); // and its own processes
      await ended;
    }
    await rm(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
});
