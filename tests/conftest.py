"""Make the oracle and the strategies importable from every test folder."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))


def pytest_addoption(parser):
    parser.addoption("--redraw", action="store_true", help="accept the sheets as drawn now")
