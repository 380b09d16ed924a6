"""The one look of all pages: head, navigation, foot. No script stands in a page, and nothing comes from elsewhere."""

import html
import posixpath

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'self'"
)


class Look:
    """`groups`: the navigation, as (heading, [(text, address from the root of the site)])."""

    def __init__(self, groups):
        self.groups = groups

    def page(self, at, title, body, kind="page"):
        """A whole page that stands at `at` (from the root of the site)."""
        root = "../" * at.count("/")
        return f"""<!doctype html>
<html lang="en" data-root="{root}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="color-scheme" content="light dark">
<title>{html.escape(title)} · Graze</title>
<link rel="icon" href="{root}assets/icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="{root}assets/code.css">
<link rel="stylesheet" href="{root}assets/site.css">
<script src="{root}assets/theme.js"></script>
<script src="{root}assets/search.js" defer></script>
<script src="{root}assets/site.js" defer></script>
</head>
<body class="{kind}">
<a class="skip" href="#main">To the text</a>
<header class="top">
<a class="brand" href="{root}index.html">Graze</a>
<form class="search" role="search" action="{root}search.html">
<input type="search" name="q" placeholder="Search ( / )" aria-label="Search pages and names" autocomplete="off">
<div class="found" hidden></div>
</form>
<button type="button" class="theme" hidden>Dark</button>
</header>
<div class="columns">
<details class="menu" open><summary>Contents</summary><nav aria-label="Pages">{self._navigation(at)}</nav></details>
<main id="main" tabindex="-1">
{body}
</main>
</div>
</body>
</html>
"""

    def _navigation(self, at):
        root = "../" * at.count("/")
        parts = []
        for heading, links in self.groups:
            parts.append(f"<h2>{html.escape(heading)}</h2><ul>")
            for text, address in links:
                here = ' aria-current="page"' if posixpath.normpath(address) == at else ""
                parts.append(f'<li><a href="{root}{html.escape(address)}"{here}>{html.escape(text)}</a></li>')
            parts.append("</ul>")
        return "".join(parts)
