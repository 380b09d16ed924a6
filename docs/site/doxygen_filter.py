#!/usr/bin/env python3
"""What Doxygen reads of a header: the house's comments as those that Doxygen knows.

Three things differ. The comment at the head of a file is one about the file. graze.h, which is C, has `//` where the
headers of C++ have `///` (behind a declaration `///<`). And a comment behind `T x, y, z;` means all three, of which
Doxygen would give it to the last. Lines keep their numbers, so that what Doxygen complains of is found.
"""

import re
import sys

RULE = re.compile(r"^\s*// ?-{3}.*|^// .* -{20,}$|^// </?\w+>$")
# Code, then two blanks or more and a comment: no `//` within text in quotes stands like this.
BEHIND = re.compile(r"^(?P<code>.*\S)  ?(?P<mark>///<|//) (?P<text>.*)$")
CONTINUED = re.compile(r"^\s+///?<? ?(?P<text>.*)$")


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


def moved_before(lines):
    """Comments behind declarations put before them in their lines."""
    out = list(lines)
    at = 0
    while at < len(out):
        found = re.match(r"^(\s*)(\S.*?[;,{}\])])?(\s*)///< (.*)$", out[at])
        if not found or not found.group(2) or out[at].lstrip().startswith("//"):
            at += 1
            continue
        text, end = found.group(4), at + 1
        while end < len(out) and re.match(r"^\s+///< ", out[end]):
            text += " " + out[end].split("///< ", 1)[1]
            out[end] = ""
            end += 1
        begin = at
        # A declaration of several lines has its comment behind the last one.
        while begin > 0 and out[begin - 1].strip() and not re.search(r"[;{}:/]\s*$|,\s*$|//|/\*\*|\*/|^#", out[begin - 1]):
            begin -= 1
        out[at] = found.group(1) + found.group(2)
        out[begin] = re.sub(r"^(\s*)", lambda m: f"{m.group(1)}/** {text} */ ", out[begin], count=1)
        at = end
    return out


def about_the_file(lines):
    """The comment that begins the file as one about it."""
    end = 0
    while end < len(lines) and lines[end].startswith("//"):
        end += 1
    if end == 0:
        return lines
    head = ["/// " + line.lstrip("/").strip() for line in lines[:end]]
    head[0] = "/// @file " + "\n" + head[0] if False else "/** @file */ " + head[0]
    return head + lines[end:]


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    if path.endswith(".dox"):
        print("\n".join(lines))
        return
    head = about_the_file(lines)
    if path.endswith(".h"):
        end = next(i for i, line in enumerate(lines) if not line.startswith("//"))
        head = head[:end] + commented_as_c(lines[end:])
    print("\n".join(moved_before(head)))


main()
