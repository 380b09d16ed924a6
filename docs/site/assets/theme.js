// Before the first drawing: the reader's choice, else the system's.
"use strict";
{
  let kept = null;
  try { kept = localStorage.getItem("graze-theme"); } catch { /* private windows */ }
  const system = matchMedia("(prefers-color-scheme: dark)");
  const show = () => { document.documentElement.dataset.theme = kept ?? (system.matches ? "dark" : "light"); };
  globalThis.grazeTheme = {
    toggle() {
      kept = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
      try { localStorage.setItem("graze-theme", kept); } catch { /* private windows */ }
      show();
    },
  };
  system.addEventListener("change", show);
  show();
}
