#!/usr/bin/env python3
"""Writes the site: pages, API reference, tables, lab, search. Static files that any host can serve, from any path.

    docs/site/build.py --out build/site --lab apps/lab/dist       all of it
    docs/site/build.py --out build/site --lab none --api no       the pages alone: a second
"""

import argparse
import json
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True

import check  # noqa: E402
import lessons  # noqa: E402
import pages  # noqa: E402
import reference  # noqa: E402
from look import Look  # noqa: E402
from pygments.formatters import HtmlFormatter  # noqa: E402

TREE = pathlib.Path(__file__).resolve().parents[2]
TABLES = {"RESULTS": "Speed", "ACCURACY": "Accuracy", "RESOLUTION": "Solvers"}


def title_of(source):
    with open(TREE / source, encoding="utf-8") as file:
        return next(line for line in file if line.startswith("# "))[2:].strip().replace("`", "")


def groups_of(docs, tables, has_api, has_lab):
    """The navigation."""
    groups = [("Graze", [("Overview", "index.html"), ("Changes", "CHANGELOG.html"), ("Contributing", "CONTRIBUTING.html")])]
    groups.append(("Pages", [(title_of(source), pages.address_of(source)) for source in docs]))
    if has_api:
        links = [("Overview", "api/index.html")] + [(text, f"api/{address}") for text, address in reference.INDEXES]
        groups.append(("API reference", links + [("C: graze.h", "api/graze_8h.html")]))
    if tables:
        groups.append(("Measured", [(TABLES.get(pathlib.Path(s).stem, title_of(s)), pages.address_of(s)) for s in tables]))
    if has_lab:
        links = [("The lab", "lab/index.html")]
        links += [(f"{one.number} {one.title}", f"lab/index.html#/lesson/{one.id}") for one in lessons.lessons_of(TREE)]
        groups.append(("Lessons", links))
    return groups


def write_assets(out):
    shutil.copytree(TREE / "docs/site/assets", out / "assets")
    shutil.copyfile(TREE / "apps/lab/public/icon.svg", out / "assets/icon.svg")
    light = HtmlFormatter(style="default").get_style_defs("pre.code")
    dark = HtmlFormatter(style="monokai").get_style_defs(':root[data-theme="dark"] pre.code')
    lines = [line for line in (light + "\n" + dark).split("\n") if "linenos" not in line]
    (out / "assets/code.css").write_text("\n".join(lines) + "\n", encoding="utf-8")


def arguments():
    parser = argparse.ArgumentParser(description="Writes the site.")
    parser.add_argument("--out", type=pathlib.Path, default=TREE / "build/site", help="folder, written anew")
    parser.add_argument("--lab", default="none", metavar="DIR|none", help="the built lab")
    parser.add_argument("--api", choices=["yes", "no"], default="yes", help="with the API reference of Doxygen")
    return parser.parse_args()


def main():
    options = arguments()
    out = options.out.resolve()
    lab = None if options.lab == "none" else pathlib.Path(options.lab)
    if lab and not (lab / "index.html").is_file():
        sys.exit(f"docs/site/build.py: {lab} holds no built lab: build it (make lab) or leave it out (--lab none)")
    if out.exists() and any(out.iterdir()) and not (out / "assets/site.css").exists():
        sys.exit(f"docs/site/build.py: {out} is not empty and no site: it is left alone")
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)

    docs = sorted(path.relative_to(TREE).as_posix() for path in (TREE / "docs").glob("*.md"))
    tables = sorted(path.relative_to(TREE).as_posix() for path in (TREE / "bench").glob("*.md"))
    look = Look(groups_of(docs, tables, options.api == "yes", lab is not None))
    write_assets(out)
    written = pages.Pages(TREE, out, look, ["README.md", "CHANGELOG.md", "CONTRIBUTING.md"] + docs + tables)
    try:
        written.write_all()
        entries = written.entries
        if options.api == "yes":
            work = out.parent / (out.name + "-doxygen")
            shutil.rmtree(work, ignore_errors=True)
            reference.run_doxygen(TREE, work)
            entries += reference.write(work, out, look)
    except (pages.BrokenLink, reference.Failed) as fault:
        sys.exit(f"docs/site/build.py: {fault}")
    if lab:
        shutil.copytree(lab, out / "lab")
        entries += [
            {"name": one.title, "in": f"lesson {one.number}", "at": f"lab/index.html#/lesson/{one.id}", "text": one.text}
            for one in lessons.lessons_of(TREE)
        ]
    body = '<h1>Search</h1><p class="count" role="status">Type above what you look for.</p><ol class="results"></ol>'
    body += "<noscript><p>Search needs JavaScript.</p></noscript>"
    (out / "search.html").write_text(look.page("search.html", "Search", body), encoding="utf-8")
    # A script and not JSON, which a page that was opened from the disk could not fetch.
    index = json.dumps(entries, ensure_ascii=False, separators=(",", ":"))
    (out / "assets/search-index.js").write_text(f"globalThis.grazeIndex = {index};\n", encoding="utf-8")

    faults = check.faults_of(out)
    for fault in faults[:50]:
        print(f"docs/site/build.py: {fault}", file=sys.stderr)
    if faults:
        sys.exit(f"docs/site/build.py: {len(faults)} faults")
    count = sum(1 for _ in out.rglob("*.html"))
    left_out = "" if lab else ", without the lab"
    print(f"{count} pages, {len(entries)} entries to search{left_out}: {out}/index.html")


main()
