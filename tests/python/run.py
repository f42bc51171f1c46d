#!/usr/bin/env python3
"""Runs the tests beside it with pytest; 77 where there is no pytest: run.py [ARGUMENTS OF PYTEST]"""

import sys
from pathlib import Path

try:
    import pytest
except ModuleNotFoundError:
    print("skipped: needs python3-pytest")
    sys.exit(77)

sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", str(Path(__file__).parent), *sys.argv[1:]]))
