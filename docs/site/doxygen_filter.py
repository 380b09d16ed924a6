#!/usr/bin/env python3
"""What Doxygen reads of a header: the house's comments as those that Doxygen knows.

Five things differ. The comment at the head of a file is one about the file. graze.h, which is C, has `//` where the
headers of C++ have `///` (behind a declaration `///<`). A comment on `T x, y, z;` means all three, of which Doxygen would
give it to one. And words that mean the same in every header are explained in `common_words.py`, once. What is in a
namespace `detail` is left out. Lines keep their numbers, so that what Doxygen complains of is found.
"""

import re
import sys

sys.dont_write_bytecode = True

from common_words import EVERYWHERE, OF_C, OF_HEADERS  # noqa: E402

RULE = re.compile(r"^\s*// ?-{3}.*|^// .* -{20,}$|^// </?\w+>$")
SEVERAL = re.compile(
    r"^(?P<type>(?:const |static |constexpr |inline )*(?:typename )?[\w:]+(?:<[^()]*>)?(?: const)? ?[*&]?) ?"
    r"(?P<names>\*?\w+(?:\[[^\]]*\])*(?:\{[^{}]*\}| = [^,;()]+(?:\([^()]*\))?)?"
    r"(?:, \*?\w+(?:\[[^\]]*\])*(?:\{[^{}]*\}| = [^,;()]+(?:\([^()]*\))?)?)+);(?P<rest>.*)$"
)


def commented_as_c(lines):
    """`//` of a C header as `///`; behind a declaration, with the lines that go on below it, as `///<`."""
    out, column = [], None
    for line in lines:
        if RULE.match(line):
            out.append("")
            column = None
            continue
        bare = re.match(r"^(\s*)// ?(.*)$", line)
        behind = None if bare else re.match(r"^(.*?\S)(\s+)// (.*)$", line)
        if bare:
            below = column is not None and len(bare.group(1)) == column
            out.append(f"{bare.group(1)}{'///<' if below else '///'} {bare.group(2)}")
        elif behind:
            column = len(behind.group(1) + behind.group(2))
            out.append(f"{behind.group(1)}{behind.group(2)}///< {behind.group(3)}")
        else:
            column = None
            out.append(line)
    return out


def for_float(lines):
    """The part of graze.h for float, which has no comments there, with those of the part for double."""
    begin, end = (next(i for i, line in enumerate(lines) if line == f"// <{mark}>") for mark in ("double", "/double"))
    out, at = [], begin
    while at <= end:
        line = lines[at]
        code, mark, text = line.partition("//")
        code = re.sub(r"\b(Graze[A-Za-z0-9]+)d\b", r"\1f", code)
        code = re.sub(r"\b(Graze[A-Za-z]+(I|Kin))f\b", r"\1d", code)
        code = re.sub(r"\bdouble\b", "float", re.sub(r"\b(graze_[a-z_0-9]+)_d\b", r"\1_f", code))
        out.append(code + mark + text)
        at += 1
    first, last = (next(i for i, line in enumerate(lines) if line == f"// <{mark}>") for mark in ("float", "/float"))
    return lines[:first] + out + lines[last:]


def without_details(lines):
    """Without what users need not see: namespaces `detail`, and initializers that have lines of their own."""
    out, inside, value = [], False, False
    for line in lines:
        inside = inside or re.match(r"namespace detail \{", line) is not None
        hidden = inside or value
        begins = not hidden and re.match(r"(inline constexpr .*\w) =$", line)
        out.append("" if hidden else begins.group(1) + ";" if begins else line)
        inside = inside and not re.match(r"\}  // namespace detail", line)
        value = bool(begins) or (value and not line.endswith(";"))
    return out


def first_line(lines, at):
    """Where the declaration begins that goes on, or ends, in line `at`."""
    while at > 0 and lines[at - 1].strip() and not re.search(
        r"[;{}:/]\s*$|^\s*//|^#", lines[at - 1]
    ) and not re.match(r"^\s*[A-Z_0-9]+( = \d+)?,", lines[at - 1]) and "///<" not in lines[at - 1] and "/**" not in lines[at - 1]:
        at -= 1
    return at


def moved_before(lines):
    """Comments behind declarations put before them in their lines."""
    out = list(lines)
    at = 0
    while at < len(out):
        found = re.match(r"^(\s*)(\S.*?)(\s+)///< (.*)$", out[at])
        if not found or out[at].lstrip().startswith("//"):
            at += 1
            continue
        text, end = found.group(4), at + 1
        while end < len(out) and re.match(r"^\s+///< ", out[end]):
            text += " " + out[end].split("///< ", 1)[1]
            out[end] = ""
            end += 1
        begin = first_line(out, at)
        out[at] = found.group(1) + found.group(2)
        out[begin] = re.sub(r"^(\s*)", lambda m: f"{m.group(1)}/** {text} */ ", out[begin], count=1)
        at = end
    return out


def apart(names):
    """`a, b{1, 2}` taken apart at the commas outside of brackets."""
    parts, depth = [""], 0
    for letter in names:
        depth += (letter in "{([<") - (letter in "})]>")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def each_for_itself(lines):
    """`T a, b;` as two declarations, each with the comment of both."""
    out = list(lines)
    for at, line in enumerate(lines):
        before = re.match(r"^(\s*)(/\*\* (.*?) \*/ )?(.*)$", line)
        found = SEVERAL.match(before.group(4))
        if not found:
            continue
        text = before.group(3)
        if text is None:
            above = []
            while at - len(above) > 0 and re.match(r"^\s*/// ", lines[at - len(above) - 1]):
                above.insert(0, lines[at - len(above) - 1].strip()[4:])
            text = " ".join(above)
        if not text:
            continue
        first, *others = apart(found.group("names"))
        kind = found.group("type").strip()
        whole = f"{kind} {first};" + "".join(f" /** {text} */ {kind} {name};" for name in others)
        out[at] = f"{before.group(1)}{before.group(2) or ''}{whole}{found.group('rest')}"
    return out


def with_common_words(lines, words):
    """What has no comment, and means the same everywhere, with its words."""
    out = list(lines)
    for at, line in enumerate(lines):
        begin = at
        while begin > 0 and re.match(r"^\s*(template|requires|\[\[)", lines[begin - 1]) and not lines[begin - 1].rstrip().endswith((";", "}")):
            begin -= 1
        if "/**" in line or "/**" in lines[begin] or (begin > 0 and re.match(r"^\s*///", lines[begin - 1])):
            continue
        for pattern, text in words:
            found = re.match(pattern, line)
            if found:
                said = found.expand(text)
                out[begin] = re.sub(r"^(\s*)", lambda m: f"{m.group(1)}/** {said} */ ", out[begin], count=1)
                break
    return out


def about_the_file(lines):
    """The comment that begins the file as one about it."""
    end = 0
    while end < len(lines) and lines[end].startswith("//"):
        end += 1
    if end == 0:
        return ["/** @file */"] + lines[1:] if lines[0] == "" else ["/** @file */ " + lines[0]] + lines[1:]
    head = ["/// " + line.lstrip("/").strip() for line in lines[:end]]
    return ["/** @file */ " + head[0]] + head[1:] + lines[end:]


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    if not path.endswith(".dox"):
        end = next(i for i, line in enumerate(lines) if not line.startswith("//"))
        is_c = path.endswith(".h")
        lines = about_the_file(lines[:end]) + (commented_as_c(for_float(lines[end:])) if is_c else lines[end:])
        words = [(pattern, text) for header, pattern, text in OF_HEADERS if re.search(header, path)]
        lines = without_details(lines)
        lines = each_for_itself(with_common_words(moved_before(lines), OF_C if is_c else words + EVERYWHERE))
    print("\n".join(lines))


main()
