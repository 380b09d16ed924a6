import "./style.css";
import { load } from "./graze.ts";
import { lessons } from "./lessons/index.ts";
import { h } from "./parts/dom.ts";
import { keepOffline } from "./parts/offline.ts";
import { address, readPlace } from "./parts/state.ts";
import { choose, isDark, startTheme } from "./parts/theme.ts";
import { Home } from "./rooms/home.ts";
import { LessonRoom } from "./rooms/lesson.ts";
import { CaptureRoom } from "./rooms/capture.ts";
import { SceneRoom } from "./rooms/scene.ts";
import type { Room } from "./rooms/room.ts";
import type { Scene } from "./scene/model.ts";
import { packed } from "./scene/moment.ts";

const main = h("main", { id: "main", tabindex: -1 });
let room: Room | null = null;
let shownPath = "";

/** Shows another page at the same address. */
function enter(next: Room): void {
  room?.dispose();
  room = next;
  main.replaceChildren(next.element);
}

function viewer(values: Record<string, string>): SceneRoom {
  const enterScene = (scene: Scene): void => {
    const text = packed(scene);
    if (text) location.hash = address("/scene", { s: text });
    else enter(viewer({ s: JSON.stringify(scene) }));
  };
  return new SceneRoom(values, (name, captured, served) => enter(new CaptureRoom(name, captured, { served, at: values.at, view: values.view }, enterScene, openFiles)));
}
function open(): void {
  const { path, values } = readPlace();
  const lesson = lessons.find((l) => path === `/lesson/${l.id}`);
  room?.dispose();
  if (lesson) room = new LessonRoom(lesson, values);
  else if (path === "/scene") room = viewer(values);
  else room = new Home();
  document.title = lesson ? `${lesson.title} · Graze lab` : path === "/scene" ? "Viewer and playground · Graze lab" : "Graze lab";
  main.replaceChildren(room.element);
  for (const a of document.querySelectorAll<HTMLAnchorElement>("header.top a")) {
    const here = a.getAttribute("href") === `#${path}` || (a.dataset.room === "lessons" && path.startsWith("/lesson"));
    if (here) a.setAttribute("aria-current", "page");
    else a.removeAttribute("aria-current");
  }
  if (shownPath && shownPath !== path) {
    main.focus({ preventScroll: true });
    window.scrollTo(0, 0);
  }
  shownPath = path;
}

function frame(): Node[] {
  const themeButton = h("button", {
    type: "button", class: "theme",
    onclick: () => {
      choose(isDark() ? "light" : "dark");
      label();
    },
  });
  const label = (): void => {
    themeButton.textContent = isDark() ? "Light" : "Dark";
    themeButton.setAttribute("aria-label", `Switch to ${isDark() ? "light" : "dark"} colours`);
  };
  label();
  return [
    h("a", { class: "skip", href: "#main", onclick: (event: Event) => (event.preventDefault(), main.focus()) }, "To the content"),
    h("header", { class: "top" },
      h("a", { href: "#/", class: "brand" }, "Graze lab"),
      h("nav", { "aria-label": "Rooms" },
        h("a", { href: "#/", "data-room": "lessons" }, "Lessons"),
        h("a", { href: "#/scene" }, "Viewer")),
      themeButton),
    main,
  ];
}

/** Opens files in the viewer, whichever page is shown. */
function openFiles(files: File[]): void {
  if (files.length === 0) return;
  if (!(room instanceof SceneRoom)) {
    history.pushState(null, "", address("/scene", {}));
    open();
  }
  (room as SceneRoom).openFiles(files);
}

/** Opens files that are dropped on any page: left to itself, a browser would leave the lab for them. */
function takeDrops(): void {
  const files = ({ dataTransfer }: DragEvent): boolean => dataTransfer?.types.includes("Files") ?? false;
  window.addEventListener("dragover", (event) => files(event) && event.preventDefault());
  window.addEventListener("drop", (event) => {
    if (!files(event)) return;
    event.preventDefault();
    openFiles([...event.dataTransfer!.files]);
  });
}

startTheme();
takeDrops();
window.addEventListener("hashchange", open);
window.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
  if (event.target instanceof HTMLInputElement || event.target instanceof HTMLTextAreaElement) return;
  event.preventDefault();
  if (event.shiftKey) room?.redo?.();
  else room?.undo?.();
});
Object.defineProperty(window, "lab", { get: () => room });

try {
  await load();
  document.getElementById("app")!.replaceChildren(...frame());
  open();
  keepOffline();
} catch (error) {
  document.getElementById("app")!.replaceChildren(
    h("p", { class: "trouble", role: "alert" }, `The library could not be loaded: ${(error as Error).message}`));
}
