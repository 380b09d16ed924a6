#!/usr/bin/env python3
"""Builds the site's pages and looks at them: python3 tests/site/run.py WORK. Exits with 77 where a tool is missing.

The API reference is built too where Doxygen is there, and searched by the page's own script where Node is there.
"""

import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys

TREE = pathlib.Path(__file__).resolve().parents[2]
BUILD = TREE / "docs/site/build.py"


def skip_without_tools():
    if not shutil.which("cmark-gfm") or not importlib.util.find_spec("pygments"):
        print("skipped: needs cmark-gfm and Pygments (scripts/setup.sh site)")
        sys.exit(77)


def check(holds, what):
    if not holds:
        sys.exit(f"tests/site/run.py: {what}")


def built(site, *arguments):
    return subprocess.run(
        [sys.executable, str(BUILD), "--out", str(site), *arguments], capture_output=True, text=True, check=False
    )


def build(site, *arguments):
    done = built(site, *arguments)
    check(done.returncode == 0, done.stderr)


def every_page_is_there(site):
    for source in sorted((TREE / "docs").glob("*.md")):
        check((site / "docs" / (source.stem + ".html")).is_file(), f"{source} has no page")
        heading = next(line for line in source.read_text().split("\n") if line.startswith("# "))[2:].replace("`", "")
        check(heading in (site / "index.html").read_text(), f"{source} is not in the navigation")
    for source in ("index.html", "CHANGELOG.html", "CONTRIBUTING.html", "search.html", "bench/RESULTS.html"):
        check((site / source).is_file(), f"{source} is missing")


def nothing_comes_from_elsewhere(site):
    """By another way than the build's own check: no attribute, style sheet or script names another host."""
    for path in [*site.rglob("*.html"), *site.rglob("*.css"), *site.glob("assets/s*e.js"), *site.glob("assets/t*.js")]:
        text = path.read_text(encoding="utf-8")
        foreign = re.search(r"""(?:=\s*["']?|url\(\s*["']?|@import\s*["'])(?:https?:)?//[^\s"']*""", text)
        check(foreign is None, f"{path} names {foreign and foreign.group(0)}")


def faults_are_found(site):
    """The check itself: each page that breaks a rule is reported."""
    sys.path.insert(0, str(BUILD.parent))
    import check as rules  # noqa: E402, the site's own

    whole = (site / "search.html").read_text(encoding="utf-8")
    check(rules.faults_of(site) == [], "the site as built has faults")
    broken = {
        '<a href="nowhere.html">x</a>': "nowhere.html is not there",
        '<a href="index.html#no-such">x</a>': "no such place",
        '<img src="https://example.org/x.png">': "leads out of the site",
        '<img src="//example.org/x.png">': "leads out of the site",
        '<a href="../../outside.html">x</a>': "is not there",
        "<script>alert(1)</script>": "a script stands in the page",
        '<p style="color: red">x</p>': "which the policy refuses",
    }
    for text, expected in broken.items():
        (site / "broken.html").write_text(whole.replace("<h1>", text + "<h1>"), encoding="utf-8")
        faults = rules.faults_of(site)
        check(len(faults) == 1 and expected in faults[0], f"{text}: {faults}")
    (site / "broken.html").unlink()


def finder(site):
    """The function that answers a search as the page does: the addresses, the best first."""
    script = (
        "for (const f of ['search.js', 'search-index.js']) (0, eval)(require('fs').readFileSync(process.argv[1] + '/assets/' + f, 'utf8'));"
        "for (const e of grazeFind(grazeIndex, process.argv[2])) console.log(e.at);"
    )

    def found(question):
        return subprocess.run(
            [shutil.which("node"), "-e", script, str(site), question], capture_output=True, text=True, check=True
        ).stdout.split("\n")[:-1]

    return found


def search_finds(site):
    if not shutil.which("node"):
        print("without search: no node")
        return
    found = finder(site)
    check("index.html#what-it-answers" in found("support function"), "'support function' is not found")
    check(found("broad phases")[0] == "docs/broad-phases.html#broad-phases", "'broad phases' does not lead to its page")
    check(found("SUPPORT  function") == found("support function"), "capitals or blanks change what is found")
    check(found("xyzzy-nowhere") == [] and found("  ") == [], "what is nowhere is found")
    if (site / "api").exists():
        check(found("WorldSettings")[0].startswith("api/"), "WorldSettings is not found in the API")
        check(any("graze_8h" in at for at in found("graze_world_step_d") + found("graze_distance_d")), "nothing of C is found")


def lessons_are_read_from_the_lab(work):
    """With a stand-in for the built lab: each lesson's id is that of a file, and leads into the lab."""
    lab = work / "lab"
    lab.mkdir(exist_ok=True)
    (lab / "index.html").write_text("<!doctype html><title>stand-in</title>")
    site = work / "with-lab"
    build(site, "--lab", str(lab), "--api", "no")
    home = (site / "index.html").read_text(encoding="utf-8")
    led_to = re.findall(r'href="lab/index.html#/lesson/([^"]+)"', home)
    ids = []
    for path in sorted((TREE / "apps/lab/src/lessons").glob("*.ts")):
        if path.name not in ("index.ts", "lesson.ts"):
            ids += re.findall(r'^  id: "([^"]+)",(?: number|$)', path.read_text(), re.MULTILINE)
    check(sorted(led_to) == sorted(ids), f"lessons in the navigation {sorted(led_to)}, in the lab {sorted(ids)}")
    what_lessons_say_is_found(site)


def what_lessons_say_is_found(site):
    """Words of the sentences, steps and sources of lessons lead to these, and nothing of the program around them."""
    index = (site / "assets/search-index.js").read_text(encoding="utf-8")
    entries = json.loads(index[index.index("[") : index.rindex("]") + 1])
    texts = {entry["at"].split("/")[-1]: entry["text"] for entry in entries if "#/lesson/" in entry["at"]}
    for name, words in {
        "spheres": "a small ball deep in a big one", "gjk": "what was found (units of length)",
        "gjk-space": "A fast procedure for computing the distance", "filters": "Two ANDs decide",
        "stack": "a warm start",
    }.items():
        check(words in texts[name], f"{words!r} is not in what the lesson {name} says: {texts[name]}")
    for name, text in texts.items():
        check(len(text) > 1000 and not re.search(r"\$\{|import |\.ts\b|=>", text), f"the lesson {name} says {text}")
    if shutil.which("node"):
        found = finder(site)
        check("lab/index.html#/lesson/hulls" in found("descent brute force"), "a lesson is not found by its words")


def what_is_asked_for_wrongly_is_refused(work):
    done = built(work / "none", "--lab", str(work / "no-lab"))
    check(done.returncode != 0 and "holds no built lab" in done.stderr, done.stderr)
    kept = work / "kept"
    kept.mkdir(exist_ok=True)
    (kept / "mine.txt").write_text("mine")
    done = built(kept, "--lab", "none", "--api", "no")
    check(done.returncode != 0 and (kept / "mine.txt").exists(), "a folder that is no site was overwritten")


def main():
    skip_without_tools()
    work = pathlib.Path(sys.argv[1])
    work.mkdir(parents=True, exist_ok=True)
    site = work / "site"
    doxygen = shutil.which("doxygen") is not None
    if not doxygen:
        print("without the API reference: no doxygen")
    build(site, "--lab", "none", "--api", "yes" if doxygen else "no")
    every_page_is_there(site)
    nothing_comes_from_elsewhere(site)
    search_finds(site)
    faults_are_found(site)
    lessons_are_read_from_the_lab(work)
    what_is_asked_for_wrongly_is_refused(work)


main()
