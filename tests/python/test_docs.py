"""What the pages and docstrings show is what Python prints."""

import ast
import doctest
import importlib.util
import pathlib

import numpy as np

import graze
import graze._graze

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_the_page(monkeypatch):
    monkeypatch.chdir(ROOT)  # scenes are named from there
    result = doctest.testfile(str(ROOT / "docs" / "python.md"), module_relative=False)
    assert result.attempted > 15 and result.failed == 0


def test_the_docstrings():
    """pybind11's functions are no functions to doctest's finder: their texts are read one by one."""
    parser, runner = doctest.DocTestParser(), doctest.DocTestRunner()
    texts = {"graze": graze.__doc__}
    for module in (graze._graze, graze._graze.batch, graze.plane):
        for name, thing in vars(module).items():
            for text in (thing, *vars(thing).values()) if isinstance(thing, type) else (thing,):
                doc = getattr(text, "__doc__", None)
                if isinstance(doc, str) and ">>>" in doc:
                    texts[f"{module.__name__}.{name}.{getattr(text, '__name__', '')}"] = doc
    for name, text in texts.items():
        runner.run(parser.get_doctest(text, {"np": np}, name, None, 0))
    assert len(texts) > 5 and runner.summarize().failed == 0


def test_the_stubs_are_those_of_the_module():
    spec = importlib.util.spec_from_file_location("write_python_stubs", ROOT / "scripts" / "write_python_stubs.py")
    writer = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(writer)
    for file, text in writer.stubs():
        assert file.read_text(encoding="utf-8") == text, f"{file} is stale: run scripts/write_python_stubs.py"
        ast.parse(text)
