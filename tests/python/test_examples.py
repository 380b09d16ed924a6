"""The example that draws: it runs, and its picture is the one in docs/."""

import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_the_picture_is_what_the_example_draws(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    drawn = tmp_path / "contacts.svg"
    example = ROOT / "examples" / "python" / "contacts.py"
    said = subprocess.run([sys.executable, example, drawn], check=True, capture_output=True, text=True).stdout
    assert len(said.splitlines()) == 6 and all("touches" in line for line in said.splitlines())
    kept = (ROOT / "docs" / "python-contacts.svg").read_text(encoding="utf-8")
    # Another version of matplotlib draws the same things by other lines.
    if f"Matplotlib v{matplotlib.__version__}," in kept:
        assert drawn.read_text(encoding="utf-8") == kept
    assert len(re.findall("#c1121f", drawn.read_text(encoding="utf-8"))) == len(re.findall("#c1121f", kept))
