"""Writes the package's type stubs from the module itself: graze/__init__.pyi and graze/batch.pyi, and of
graze/plane/__init__.pyi, whose beginning is written by hand, what stands behind MARK.

pybind11 puts each function's signature into its docstring; this reads them back, so that stubs cannot differ from
what they describe. `make python` has a test compare them: run

    PYTHONPATH=build/release/python /usr/bin/python3 scripts/write_python_stubs.py

after a change of the module.
"""

import inspect
import re
import sys
from pathlib import Path

from graze import _graze

PACKAGE = Path(__file__).resolve().parents[1] / "bindings" / "python" / "graze"
HEAD = '''"""Written by scripts/write_python_stubs.py from the module: do not edit."""

import os
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Literal, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
'''
POSE_LIKE = 'PoseLike = Union["Pose", tuple[ArrayLike, ArrayLike], ArrayLike, None]\n'
MARK = "# Written by scripts/write_python_stubs.py from the module: do not edit what follows.\n"
PLANE_CLASSES = [
    "Collider", "Scene", "StruckBody", "Blow", "FreeBody", "WorldView", "World", "CapturedWorld", "Material", "State", "Simulation", "CapturedState", "CapturedSimulation"]
PLANE_FUNCTIONS = [
    "along_lines", "cast_all", "draw_cast", "draw_joint", "draw_ray", "feature_corners", "pass_on", "pose_at", "raycast_all",
    "raycast_any", "tessellate", "load", "simulate"]
# What pybind11 calls things, and what they are called in Python.
NAMES = [
    (r"\bgraze\.(_graze|plane)\.", ""),
    (r"\bnumpy\.ndarray\[numpy\.(\w+)\]", r"NDArray[np.\1]"),
    (r"\bnumpy\.ndarray\b", "NDArray[Any]"),
    (r"\bnumpy\.dtype\b", "np.dtype[Any]"),
    (r"\bTuple\b", "tuple"),
    (r"\bList\b", "list"),
    (r"\bDict\b", "dict"),
    (r"\bOptional\[((?:[^\[\]]|\[[^\[\]]*\])*)\]", r"\1 | None"),
    (r"\bhandle\b|\bobject\b", "Any"),
    (r"\bfunction\b", "Callable[..., Any]"),
    (r"\biterable\b", "Iterable[Any]"),
    (r"\bsequence\b", "Sequence[Any]"),
    (r"\bcapsule\b", "Any"),
    (r"\bos\.PathLike\b", "str | os.PathLike[str]"),
]
# What the module returns as an object of no one type, since a question may be one of several forms.
ANSWERS = {
    "cast": "CastHit | None",
    "cast_all": "list[CastHit]",
    "closest": "Closest",
    "collide": "list[tuple[int, int, list[Manifold]]]",
    "collide_frames": "list[tuple[float, str, int, int, bool, float | None]]",
    "contacts": "list[Manifold]",
    "distance": "Distance",
    "distance_up_to": "Distance | None",
    "near_pieces": "list[tuple[int, int, Distance]]",
    "overlap": "bool",
    "raycast": "RayHit | None",
    "raycast_all": "list[RayHit]",
}
RECORDS, FLAGS = "NDArray[np.void]", "NDArray[np.bool_]"
BATCH_ANSWERS = {
    "cast": RECORDS,
    "closest": RECORDS,
    "compact_contacts": f"tuple[{RECORDS}, {RECORDS}]",
    "contacts": f"tuple[{RECORDS}, {RECORDS}, {RECORDS}]",
    "distance": RECORDS,
    "near_pieces": f"tuple[{RECORDS}, NDArray[np.uint64]]",
    "overlap": FLAGS,
    "raycast": RECORDS,
    "raycast_any": FLAGS,
}
TRACED = "trace: Any = False"
SIGNATURE = re.compile(r"^(?:\d+\. )?(\w+)\((.*)\) -> (.+)$")


def split(arguments):
    """The parameters of a signature, apart where a comma is in no brackets."""
    parts, depth, start = [], 0, 0
    for i, c in enumerate(arguments):
        depth += c in "[(<{"
        depth -= c in "])>}" and arguments[i - 1 : i + 1] != "->"
        if c == "," and depth == 0:
            parts.append(arguments[start:i].strip())
            start = i + 1
    return [p for p in parts + [arguments[start:].strip()] if p]


def type_of(text):
    for pattern, name in NAMES:
        text = re.sub(pattern, name, text)
    return text


def parameter(text, bound):
    """`name: type = default` as a stub has it: which value the default is stands in the docstring."""
    match = re.match(r"^(\*{0,2}\w+)(?:: (.*?))?(?: = (.*))?$", text)
    name, kind, default = match.groups()
    if text in ("*", "/"):
        return text
    if name == "self" or (bound and name == "arg0"):
        return "self"
    value = ""
    if default is not None:
        value = f" = {default}" if re.fullmatch(r"None|True|False|-?[\d.e+-]+|'[^']*'", default) else " = ..."
    return f"{name}: {type_of(kind)}{value}" if kind else f"{name}{value}"


def signatures(function):
    lines = (function.__doc__ or "").splitlines()
    found = [SIGNATURE.match(line) for line in lines]
    # Of an overloaded function the first line, `name(*args, **kwargs)`, says nothing.
    return [m for m in found if m and m.group(2) != "*args, **kwargs"]


def functions(name, function, indent, bound, answers={}):
    """The lines of a function; one that takes a trace also has a form that returns it beside the answer."""
    out = []
    found = signatures(function)
    for match in found:
        parts = [parameter(p, bound and i == 0) for i, p in enumerate(split(match.group(2)))]
        if len(found) > 1:
            out.append(f"{indent}@overload")
        static = bound and (not parts or parts[0] != "self")
        if static:
            out.append(f"{indent}@staticmethod")
        answer = answers.get(name, type_of(match.group(3)))
        if TRACED in parts:
            with_trace = ", ".join(parts).replace(TRACED, "*, trace: Literal[True]")
            out += [
                f"{indent}@overload",
                f"{indent}def {name}({with_trace}) -> tuple[{answer}, dict[str, Any]]: ...",
                f"{indent}@overload",
            ]
        out.append(f"{indent}def {name}({', '.join(parts)}) -> {answer}: ...")
    return out


DUNDERS = {"__init__", "__eq__", "__hash__", "__len__", "__contains__", "__matmul__", "__getitem__", "__iter__"}


def class_lines(cls):
    bases = [b.__name__ for b in cls.__bases__ if b.__name__ != "pybind11_object" and b is not object]
    lines = [f"class {cls.__name__}{'(' + ', '.join(bases) + ')' if bases else ''}:"]
    for name, member in cls.__dict__.items():
        if name.startswith("_") and name not in DUNDERS:
            continue
        if isinstance(member, property):
            match = re.search(r"-> (.+)$", (member.fget.__doc__ or "").strip().splitlines()[0] if member.fget.__doc__ else "")
            kind = type_of(match.group(1)) if match else "Any"
            lines += ["    @property", f"    def {name}(self) -> {kind}: ..."]
        elif name == "__hash__" and member is None:
            lines.append("    __hash__: None  # type: ignore[assignment]")
        elif callable(getattr(cls, name)) or isinstance(member, staticmethod):
            lines += functions(name, getattr(cls, name), "    ", True)
    return lines if len(lines) > 1 else [lines[0] + " ..."]


def module_lines(module, answers):
    lines = []
    classes = [c for c in vars(module).values() if inspect.isclass(c)]
    for cls in sorted(classes, key=lambda c: (len(c.__mro__), c.__name__)):
        lines += class_lines(cls) + [""]
    for name, thing in sorted(vars(module).items()):
        if not name.startswith("_") and not inspect.isclass(thing) and callable(thing):
            lines += functions(name, thing, "", False, answers)
    return "\n".join(lines) + "\n"


def stubs():
    """The stubs as (file, text)."""
    space = HEAD + "\nfrom . import batch as batch\nfrom . import plane as plane\n\n" + POSE_LIKE
    space += "\n__version__: str\n\n" + module_lines(_graze, ANSWERS)
    names = sorted(c.__name__ for c in vars(_graze).values() if inspect.isclass(c))
    batch = HEAD + f"\nfrom . import {', '.join(names)}, PoseLike\n\n" + module_lines(_graze.batch, BATCH_ANSWERS)
    file = PACKAGE / "plane" / "__init__.pyi"
    plane = file.read_text(encoding="utf-8").split(MARK)[0] + MARK
    plane += "".join("\n" + "\n".join(class_lines(getattr(_graze._plane, name))) + "\n" for name in PLANE_CLASSES)
    functions_of_plane = [functions(name, getattr(_graze._plane, name), "", False, ANSWERS) for name in PLANE_FUNCTIONS]
    plane += "\n" + "".join(line + "\n" for lines in functions_of_plane for line in lines)
    return [(PACKAGE / "__init__.pyi", space), (PACKAGE / "batch.pyi", batch), (file, plane)]


if __name__ == "__main__":
    for file, text in stubs():
        file.write_text(text, encoding="utf-8")
        print(file, len(text.splitlines()), "lines", file=sys.stderr)
