// Pages in headless Chromium that post what came of them. CHROMIUM names the browser; the distribution's otherwise.

import { createServer } from "node:http";
import { readFile, mkdtemp, rm } from "node:fs/promises";
import { spawn } from "node:child_process";
import { tmpdir } from "node:os";
import path from "node:path";

const types = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };

/** Opens an address in a browser of its own while `body`, which gets a promise that fails when the browser ends. */
async function browsing(address, body) {
  const profile = await mkdtemp(path.join(tmpdir(), "graze-chromium-"));
  let browser;
  try {
    return await body(new Promise((_, reject) => {
      // Without a sandbox, which root may not have; the page is ours.
      const flags = [
        "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
        `--user-data-dir=${profile}`, address];
      browser = spawn(process.env.CHROMIUM ?? "chromium-headless-shell", flags, { stdio: "ignore", detached: true });
      browser.on("error", reject);
      browser.on("exit", (code) => reject(new Error(`the browser ended with ${code} before the page had`)));
    }));
  } finally {
    if (browser?.pid !== undefined && browser.exitCode === null) {
      const ended = new Promise((resolve) => browser.on("close", resolve));
      process.kill(-browser.pid, "SIGKILL"); // and its own processes
      await ended;
    }
    await rm(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

/** The JSON that the page at "/" posts to any address, within so many seconds. `fileOf` returns the file behind the path of
 * an address; one that throws, or is not there, is not found. */
export async function postedByPage(fileOf, seconds) {
  let posted;
  let limit;
  const page = new Promise((resolve, reject) => {
    posted = resolve;
    limit = setTimeout(() => reject(new Error(`the page has posted nothing in ${seconds} s`)), 1000 * seconds);
  });
  const server = createServer(async (request, response) => {
    if (request.method === "POST") {
      let body = "";
      for await (const part of request) body += part;
      response.end();
      posted(JSON.parse(body));
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
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  try {
    return await browsing(`http://127.0.0.1:${server.address().port}/`, (ended) => Promise.race([page, ended]));
  } finally {
    clearTimeout(limit);
    server.closeAllConnections();
    server.close();
  }
}
