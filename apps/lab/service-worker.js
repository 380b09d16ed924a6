// Keeps the built lab in the browser, for when there is no network. The build writes the version, a hash of all files,
// and their names in place of the first two lines' values (offline.ts).

const version = "VERSION";
const files = ["FILES"];

const cacheName = (of) => `graze-lab ${of}`;
const page = new URL("./index.html", self.location).href;
const kept = new Set(files.map((file) => new URL(file, self.location).href));

// Files whose names are hashes never change; the page is asked for anew.
const request = (file) => new Request(file, { cache: file.startsWith("assets/") ? "default" : "reload" });

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(cacheName(version)).then((cache) => cache.addAll(files.map(request))));
});

// Not before the last page of the version before is closed, whose files are needed until then.
self.addEventListener("activate", (event) => {
  const old = (name) => name.startsWith(cacheName("")) && name !== cacheName(version);
  event.waitUntil(caches.keys().then((names) => Promise.all(names.filter(old).map((name) => caches.delete(name)))));
});

/** A file as this version has it. */
const own = (asked) => caches.match(asked, { cacheName: cacheName(version), ignoreVary: true });
/** The page as the network has it, which may be of a new version, else as it was kept. */
const newest = (asked) => fetch(asked).catch(() => own(page));

self.addEventListener("fetch", (event) => {
  const { request: asked } = event, { origin, pathname } = new URL(asked.url), address = origin + pathname;
  if (asked.method !== "GET") return;
  if (asked.mode === "navigate" && (address === page || address === new URL("./", page).href)) event.respondWith(newest(asked));
  else if (kept.has(asked.url) && asked.mode !== "navigate") event.respondWith(own(asked).then((known) => known ?? fetch(asked)));
});
