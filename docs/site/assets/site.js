// The theme's button, the menu of a narrow window, and the search field, which shows what it finds while one types.
"use strict";
{
  const root = document.documentElement.dataset.root;
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };

  const theme = document.querySelector("button.theme");
  const name = () => { theme.textContent = document.documentElement.dataset.theme === "dark" ? "Light" : "Dark"; };
  theme.hidden = false;
  theme.addEventListener("click", () => { grazeTheme.toggle(); name(); });
  name();

  // On a narrow window the contents would stand before the text.
  const menu = document.querySelector("details.menu");
  const narrow = matchMedia("(max-width: 60rem)");
  const fold = () => { menu.open = !narrow.matches; };
  narrow.addEventListener("change", fold);
  fold();

  // The index is fetched when somebody searches: as a script, which also a page opened from the disk may have.
  let index = null;
  const load = () => index ??= new Promise((done, failed) => {
    document.head.append(make("script", { src: `${root}assets/search-index.js`, onload: () => done(grazeIndex), onerror: failed }));
  });
  const link = (entry, question) => make("a", { href: root + entry.at },
    make("b", { textContent: entry.name }), " ", make("small", { textContent: entry.in ?? "" }),
    make("span", { textContent: entry.text === undefined ? "" : grazeExcerpt(entry, question) }));

  const form = document.querySelector("form.search"), field = form.querySelector("input"), box = form.querySelector(".found");
  field.addEventListener("focus", load, { once: true });
  field.addEventListener("input", async () => {
    const question = field.value, entries = grazeFind(await load(), question, 8);
    if (question !== field.value) return;
    box.replaceChildren(...entries.map((entry) => link(entry, question)));
    box.hidden = entries.length === 0;
  });
  // Arrows go through what was found, Escape closes it, Enter in the field opens the page of all results.
  form.addEventListener("keydown", (event) => {
    const links = [...box.querySelectorAll("a")], here = links.indexOf(document.activeElement);
    if (event.key === "Escape") { box.hidden = true; field.focus(); }
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    const next = here + (event.key === "ArrowDown" ? 1 : -1);
    if (next < 0) field.focus(); else links[Math.min(next, links.length - 1)]?.focus();
  });
  document.addEventListener("click", (event) => { if (!form.contains(event.target)) box.hidden = true; });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|TEXTAREA)$/.test(event.target.tagName)) return;
    event.preventDefault();
    field.focus();
  });

  const results = document.querySelector("ol.results");
  const question = new URLSearchParams(location.search).get("q");
  if (results && question) {
    field.value = question;
    load().then((entries) => {
      const found = grazeFind(entries, question);
      document.querySelector(".count").textContent = `${found.length === 60 ? "The first 60" : found.length} for “${question}”`;
      results.replaceChildren(...found.map((entry) => make("li", {}, link(entry, question))));
    });
  }
}
