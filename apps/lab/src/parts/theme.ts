// Light and dark: the system's choice unless the reader made one. Colours are those of style.css, by meaning.

export type Theme = "light" | "dark" | "system";

const listeners = new Set<() => void>();
let cache = new Map<string, string>();

export function theme(): Theme {
  try {
    const kept = localStorage.getItem("theme");
    return kept === "light" || kept === "dark" ? kept : "system";
  } catch {
    return "system"; // storage is forbidden: nothing is kept
  }
}
export function isDark(): boolean {
  const chosen = theme();
  return chosen === "system" ? matchMedia("(prefers-color-scheme: dark)").matches : chosen === "dark";
}
function apply(): void {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  cache = new Map();
  for (const listener of listeners) listener();
}
export function choose(next: Theme): void {
  try {
    if (next === "system") localStorage.removeItem("theme");
    else localStorage.setItem("theme", next);
  } catch {
    // The choice lasts as long as the page then.
  }
  apply();
}
export function startTheme(): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", apply);
  apply();
}
/** Calls `listener` whenever colours change; the result ends that. */
export function onTheme(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}
export function color(meaning: string): string {
  let value = cache.get(meaning);
  if (!value) {
    value = getComputedStyle(document.documentElement).getPropertyValue(`--${meaning}`).trim() || "#888";
    cache.set(meaning, value);
  }
  return value;
}
