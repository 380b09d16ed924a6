"""The lab's lessons, in the order of apps/lab/src/lessons/index.ts, with what they say."""

import re
from typing import NamedTuple


class Lesson(NamedTuple):
    number: str
    title: str
    id: str
    text: str


# Everything in TypeScript that a text may begin or end in, or that only looks so.
MARK = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|[`{}]|\$\{|\\.""", re.DOTALL)


def texts_of(source):
    """The texts in quotes and the own words of templates, in whose place an expression becomes a dash."""
    found = []
    templates = []  # the open ones: their words, and how many braces are open in their present expression
    at = 0
    for mark in MARK.finditer(source):
        token = mark.group(0)
        words = bool(templates) and templates[-1][1] == 0
        if words:
            templates[-1][0].append(source[at : mark.start()])
        at = mark.end()
        if words and token == "`":
            found.append("".join(templates.pop()[0]))
        elif words and token == "${":
            templates[-1][0].append("–")
            templates[-1][1] = 1
        elif words:
            templates[-1][0].append(token)
        elif token == "`":
            templates.append([[], 0])
        elif token[0] == '"':
            found.append(re.sub(r"\\(.)", r"\1", token[1:-1]))
        elif templates and token in ("{", "${", "}"):
            templates[-1][1] += -1 if token == "}" else 1
    return found


def _prose(source):
    """The texts that are sentences or names of several words, each once."""
    said = (text.strip() for text in texts_of(source) if len(re.findall(r"[^\W\d_]{2,}", text)) > 1)
    return " ".join(dict.fromkeys(said))


def lessons_of(tree):
    """All lessons in their order."""
    folder = tree / "apps/lab/src/lessons"
    found = {}
    for path in sorted(folder.glob("*.ts")):
        text = path.read_text(encoding="utf-8")
        whole = re.compile(r"^export const (\w+): Lesson = \{(.*?)^\};", re.DOTALL | re.MULTILINE)
        # The functions of a file are those of all its lessons.
        shared = re.sub(r"^import .*$", "", whole.sub("", text), flags=re.MULTILINE)
        for name, body in whole.findall(text):
            parts = [re.search(p, body) for p in (r"\bnumber: (\d+)", r'\btitle: "([^"]*)"', r'\bid: "([^"]*)"')]
            if not all(parts):
                raise ValueError(f"{path}: {name} has no number, title or id that can be read")
            found[name] = Lesson(*(part.group(1) for part in parts), _prose(body + shared))
    index = (folder / "index.ts").read_text(encoding="utf-8")
    order = re.search(r"lessons: Lesson\[\] = \[(.*?)\]", index, re.DOTALL).group(1)
    return [found[name] for name in re.findall(r"\w+", order)]
