"""The API reference: Doxygen writes it, and its pages are put into the site's look.

Of each of Doxygen's pages the text is kept. Its scripts and inline styles are not, which the site's policy would refuse.
"""

import html
import re
import subprocess
import xml.etree.ElementTree as ElementTree


class Failed(Exception):
    """Doxygen found something to complain of."""


KINDS = {"class", "struct", "union", "namespace", "file"}
INDEXES = [("Classes", "annotated.html"), ("Namespaces", "namespaces.html"), ("Headers", "files.html")]


def run_doxygen(tree, work):
    """Doxygen's own pages, below `work`; its tag file names every symbol."""
    work.mkdir(parents=True, exist_ok=True)
    settings = (tree / "docs/site/Doxyfile").read_text(encoding="utf-8")
    settings += f'\nOUTPUT_DIRECTORY = "{work}"\nGENERATE_TAGFILE = "{work}/graze.tag"\n'
    done = subprocess.run(["doxygen", "-"], input=settings, capture_output=True, text=True, cwd=tree)
    complaints = done.stderr.strip()
    if done.returncode != 0 or complaints:
        lines = complaints.split("\n")
        shown = "\n".join(lines[:40]) + (f"\n... and {len(lines) - 40} lines more" if len(lines) > 40 else "")
        raise Failed(f"Doxygen, on the comments of the public headers:\n{shown}")


def _text_of(page):
    """What stands between Doxygen's head and foot, without what the policy refuses."""
    title = re.search(r'<div class="title">(.*?)</div>', page, re.DOTALL)
    begin = page.index('<div class="contents">')
    end = page.index("<!-- start footer part -->")
    body = page[begin:end]
    body = re.sub(r"<script.*?</script>", "", body, flags=re.DOTALL)
    body = re.sub(r'<span onclick="[^"]*".*?</span>', "", body, flags=re.DOTALL)
    body = re.sub(r'<div class="levels">.*?</div>', "", body, flags=re.DOTALL)
    body = re.sub(r' (?:onclick|style|align|valign|width)="[^"]*"', "", body)
    body = re.sub(r"<img [^>]*>", "", body)
    body = re.sub(r'<a class="anchor" id="([^"]*)"></a>', r'<a id="\1"></a>', body)
    # Doxygen's frames close later than the text.
    spare = body.count("</div>") - body.count("<div")
    for _ in range(max(0, spare)):
        body = "".join(body.rsplit("</div>", 1))
    name = re.sub(r"<[^>]+>", "", title.group(1)).strip() if title else "Graze"
    return html.unescape(name), body


def write(work, out, look):
    """The pages below `out`/api; what can be searched comes back."""
    (out / "api").mkdir(parents=True, exist_ok=True)
    for page in sorted((work / "html").glob("*.html")):
        if page.name == "index.html":
            continue
        name, body = _text_of(page.read_text(encoding="utf-8"))
        at = f"api/{page.name}"
        text = f"<h1>{html.escape(name)}</h1>\n{body}"
        (out / at).write_text(look.page(at, name, text, "page api"), encoding="utf-8")
    links = "".join(f'<li><a href="{address}">{text}</a></li>' for text, address in INDEXES)
    body = f"<h1>API reference</h1><p>What the public headers say of every name. C++ begins in <code>namespace graze</code>, "
    body += f"C in <code>graze.h</code>.</p><ul>{links}</ul>"
    (out / "api/index.html").write_text(look.page("api/index.html", "API reference", body), encoding="utf-8")
    return _entries(work / "graze.tag")


def _entries(tag_file):
    entries, seen = [], set()
    for compound in ElementTree.parse(tag_file).getroot().findall("compound"):
        kind, name = compound.get("kind"), compound.findtext("name")
        if kind not in KINDS:
            continue
        page = compound.findtext("filename")
        page = page if page.endswith(".html") else page + ".html"
        entries.append({"name": name, "in": kind, "at": f"api/{page}"})
        for member in compound.findall("member"):
            short = member.findtext("name")
            entry = (short, member.findtext("anchorfile"), member.findtext("anchor"))
            if entry in seen or not entry[1]:
                continue
            seen.add(entry)
            where = "" if kind == "file" else name
            entries.append({"name": short, "in": where or name, "at": f"api/{entry[1]}#{entry[2]}"})
    return entries
