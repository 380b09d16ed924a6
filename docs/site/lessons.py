"""The lab's lessons, in the order of apps/lab/src/lessons/index.ts."""

import re


def lessons_of(tree):
    """(number, title, id) of each."""
    folder = tree / "apps/lab/src/lessons"
    found = {}
    for path in sorted(folder.glob("*.ts")):
        text = path.read_text(encoding="utf-8")
        for name, body in re.findall(r"^export const (\w+): Lesson = \{(.*?)^\};", text, re.DOTALL | re.MULTILINE):
            parts = [re.search(p, body) for p in (r"\bnumber: (\d+)", r'\btitle: "([^"]*)"', r'\bid: "([^"]*)"')]
            if not all(parts):
                raise ValueError(f"{path}: {name} has no number, title or id that can be read")
            found[name] = tuple(part.group(1) for part in parts)
    index = (folder / "index.ts").read_text(encoding="utf-8")
    order = re.search(r"lessons: Lesson\[\] = \[(.*?)\]", index, re.DOTALL).group(1)
    return [found[name] for name in re.findall(r"\w+", order)]
