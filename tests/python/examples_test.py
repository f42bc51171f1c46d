"""The scripts of data/python: they run, are short, and make a picture."""

import subprocess
import sys
from pathlib import Path

import pytest

from conftest import DATA

SCRIPTS = sorted((DATA / "python").glob("*.py"))
LINES = 40


def test_there_are_scripts():
    named = (DATA / "python/README.md").read_text()
    assert len(SCRIPTS) >= 6 and all(f"({script.name})" in named for script in SCRIPTS)


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda p: p.stem)
def test_script(script: Path, tmp_path):
    pytest.importorskip("matplotlib")
    assert len(script.read_text().splitlines()) < LINES
    picture = tmp_path / "picture.png"
    done = subprocess.run([sys.executable, script, picture], cwd=tmp_path, capture_output=True,
                          text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 10_000
    assert list(tmp_path.iterdir()) == [picture]
