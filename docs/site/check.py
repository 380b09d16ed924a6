"""What every page of the site has to keep: links lead somewhere, nothing is fetched elsewhere, no script stands in it."""

import posixpath
from html.parser import HTMLParser
from urllib.parse import unquote


class _Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.names, self.links, self.faults = set(), [], []
        self.policy = False

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for key in ("id", "name"):
            if key in values and (key == "id" or tag == "a"):
                self.names.add(values[key])
        for key in ("href", "src", "srcset", "action", "poster", "data"):
            if values.get(key) is not None:
                self.links.append(values[key])
        if tag == "script" and "src" not in values:
            self.faults.append("a script stands in the page")
        for key in values:
            if key.startswith("on") or key == "style":
                self.faults.append(f"<{tag} {key}=...>, which the policy refuses")
        if tag == "meta" and values.get("http-equiv") == "Content-Security-Policy":
            self.policy = True


def faults_of(site):
    """A line for each fault of any page below `site`; the lab, which is tested for itself, is only led to."""
    pages = {}
    for path in sorted(site.rglob("*.html")):
        at = path.relative_to(site).as_posix()
        if at.startswith("lab/"):
            continue
        pages[at] = page = _Page()
        page.feed(path.read_text(encoding="utf-8"))
    faults = []
    for at, page in pages.items():
        faults += [f"{at}: {fault}" for fault in page.faults]
        if not page.policy:
            faults.append(f"{at}: no Content-Security-Policy")
        for link in page.links:
            fault = _fault_of(site, pages, at, link)
            if fault:
                faults.append(f"{at}: {fault}")
    return faults


def _fault_of(site, pages, at, link):
    if ":" in link.split("/")[0] or link.startswith("//"):
        return f"{link} leads out of the site"
    path, _, name = link.partition("#")
    target = posixpath.normpath(posixpath.join(posixpath.dirname(at), unquote(path.split("?")[0]))) if path else at
    if target.startswith(("..", "/")) or not (site / target).is_file():
        return f"{link} is not there"
    if name and target in pages and unquote(name) not in pages[target].names:
        return f"{link}: no such place on the page"
    return None
