"""Markdown to HTML: cmark-gfm reads it as GitHub does, Pygments colours the code, and links lead within the site.

A link to another page becomes one to its HTML, a picture is copied, and any other file or folder of the tree that is
linked gets a page that shows it. A link that leads nowhere is an error.
"""

import html
import posixpath
import re
import shutil
import subprocess

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name, get_lexer_for_filename
from pygments.util import ClassNotFound

PICTURES = (".svg", ".png", ".jpg", ".gif")
TAG = re.compile(r"<[^>]+>")


class BrokenLink(Exception):
    """What a page links to is not there."""


def address_of(source):
    """Where the page of a file of the tree stands in the site."""
    if source == "README.md":
        return "index.html"
    return source[: -len(".md")] + ".html" if source.endswith(".md") else source + ".html"


def slug(text, taken):
    """The name of a heading in addresses, as GitHub makes it."""
    name = re.sub(r"[^\w\- ]", "", html.unescape(TAG.sub("", text)).strip().lower()).replace(" ", "-")
    count = taken.get(name, 0)
    taken[name] = count + 1
    return f"{name}-{count}" if count else name


def coloured(code, lexer):
    return highlight(code, lexer, HtmlFormatter(nowrap=True))


def _code_block(found):
    language, code = found.group(1), html.unescape(found.group(2))
    try:
        body = coloured(code, get_lexer_by_name(language or "text"))
    except ClassNotFound:
        body = html.escape(code)
    return f'<pre class="code" tabindex="0"><code>{body}</code></pre>'


class Pages:
    """Renders the files `sources` (from the root of the tree) into the folder `out`, and notes what can be searched."""

    def __init__(self, tree, out, look, sources):
        self.tree, self.out, self.look = tree, out, look
        self.sources = sources
        self.shown = set()  # files and folders that a page links to
        self.entries = []  # for search

    def write_all(self):
        for source in self.sources:
            self._write(source)
        done = set()
        while self.shown - done:
            for source in sorted(self.shown - done):
                self._show(source)
                done.add(source)

    def _put(self, at, title, body, kind="page"):
        path = self.out / at
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(self.look.page(at, title, body, kind), encoding="utf-8")

    def _write(self, source):
        text = (self.tree / source).read_text(encoding="utf-8")
        body = subprocess.run(
            ["cmark-gfm", "-e", "table", "-e", "strikethrough", "-e", "autolink", "--unsafe"],
            input=text, capture_output=True, text=True, check=True,
        ).stdout
        at = address_of(source)
        body = re.sub(
            r'<pre><code(?: class="language-([\w+-]+)")?>(.*?)</code></pre>', _code_block, body, flags=re.DOTALL
        )
        taken = {}
        body = re.sub(
            r"<h([1-6])>(.*?)</h\1>",
            lambda m: f'<h{m.group(1)} id="{(s := slug(m.group(2), taken))}">{m.group(2)}'
            f'<a class="anchor" href="#{s}" aria-label="Link to this section">#</a></h{m.group(1)}>',
            body,
            flags=re.DOTALL,
        )
        body = re.sub(r"(<table>.*?</table>)", r'<div class="table" tabindex="0" role="region" aria-label="Table">\1</div>', body, flags=re.DOTALL)
        # What is written in a page as HTML may have a look of its own, which the policy does not let through.
        body = re.sub(r"<!--.*?-->", "", body, flags=re.DOTALL)
        body = re.sub(
            r'<a href="([^"]*)"([^>]*)>(.*?)</a>', lambda m: self._link(source, at, m), body, flags=re.DOTALL
        )
        body = re.sub(r'(<img [^>]*?src=")([^"]*)(")', lambda m: self._picture(source, at, m), body)
        title = html.unescape(TAG.sub("", re.search(r"<h1[^>]*>(.*?)<a class", body, re.DOTALL).group(1))).strip()
        self._note_sections(at, title, body)
        self._put(at, title, body)

    def _inside(self, source, address):
        """The path from the root of the tree of what `source` names."""
        path = posixpath.normpath(posixpath.join(posixpath.dirname(source), html.unescape(address)))
        if path.startswith("..") or not (self.tree / path).exists():
            raise BrokenLink(f"{source}: {address} is not in the tree")
        return path

    def _link(self, source, at, found):
        address, rest, text = found.groups()
        if address.startswith("#"):
            return found.group(0)
        if re.match(r"[a-z]+:", address):
            # The site names no other one: the address is there to be read.
            shown = "" if address in text else f" ({html.escape(address)})"
            return f'<span class="elsewhere">{text}{shown}</span>'
        path, mark, anchor = address.partition("#")
        path = self._inside(source, path)
        if path.lower().endswith(PICTURES):
            target = self._copied(path)
        else:
            target = address_of(path)
            if path not in self.sources:
                self.shown.add(path)
        return f'<a href="{posixpath.relpath(target, posixpath.dirname(at) or ".")}{mark}{anchor}"{rest}>{text}</a>'

    def _picture(self, source, at, found):
        path = self._copied(self._inside(source, found.group(2)))
        return f"{found.group(1)}{posixpath.relpath(path, posixpath.dirname(at) or '.')}{found.group(3)}"

    def _copied(self, path):
        (self.out / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(self.tree / path, self.out / path)
        return path

    def _show(self, source):
        """A page that shows a file of the tree, or lists a folder."""
        path = self.tree / source
        if path.is_dir():
            rows = "".join(f"<li>{html.escape(p.name)}</li>" for p in sorted(path.iterdir()))
            body = f"<h1><code>{html.escape(source)}/</code></h1><ul>{rows}</ul>"
        else:
            text = path.read_text(encoding="utf-8")
            try:
                code = coloured(text, get_lexer_for_filename(path.name))
            except ClassNotFound:
                code = html.escape(text)
            body = f'<h1><code>{html.escape(source)}</code></h1><pre class="code" tabindex="0"><code>{code}</code></pre>'
        self._put(address_of(source), source, body, "page source")

    def _note_sections(self, at, title, body):
        parts = re.split(r'<h[1-6] id="([^"]*)">(.*?)<a class="anchor".*?</h[1-6]>', body, flags=re.DOTALL)
        for anchor, heading, text in zip(parts[1::3], parts[2::3], parts[3::3]):
            name = html.unescape(TAG.sub("", heading)).strip()
            words = " ".join(html.unescape(TAG.sub(" ", text)).split())
            where = "" if name == title else title
            self.entries.append({"name": name, "in": where, "at": f"{at}#{anchor}", "text": words})
