"""Make the oracle and the strategies importable from every test folder; set hypothesis up."""

import gc
import os
import sys
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import settings

sys.path.insert(0, str(Path(__file__).parent))

# What is said to nobody in particular is in the terminal's language: English here, on every machine.
os.environ["LC_ALL"] = "C.UTF-8"
# Byte code is kept, whatever the machine says: else each process that a test begins compiles the package again.
os.environ["PYTHONDONTWRITEBYTECODE"] = ""
# Nothing is kept in the cache of whoever runs the tests.
os.environ["GRAPHIC_TMM_CACHE"] = ""

from support.examples import FEW
from support.once import install
from support.turns import TURN, Wanted, waiting

install()
sys.dont_write_bytecode = False

# Machines are noisy: no example is timed. CI draws the same examples each time, a person new ones;
# the everyday run a few.
settings.register_profile("measured", deadline=None, max_examples=50)
settings.register_profile("person", deadline=None, max_examples=20)
settings.register_profile("ci", deadline=None, derandomize=True, database=None, max_examples=20)
settings.register_profile("everyday", deadline=None, max_examples=FEW)


def pytest_addoption(parser):
    parser.addoption("--redraw", action="store_true", help="accept the sheets as drawn now")
    parser.addoption("--measured", action="store_true", help="as many as the README's tables tell")
    parser.addoption("--cpu", type=int, help="tell what the tests cost, and the dearest of them")


@pytest.fixture
def many(request):
    """How many random cases: as many as the tables of `tests/README.md` tell, if asked for; else fewer."""
    measured = request.config.getoption("--measured")
    return lambda told, usual: told if measured else usual


@pytest.fixture(scope="session")
def browser():
    """One Chromium a session, for pages and for the studio: one process has room for one driver."""
    from support.browser import launched

    with launched() as found:
        yield found


BEGUN = pytest.StashKey[float]()


def _seconds() -> float:
    """Return the seconds of the processor that were spent here and in processes that have ended."""
    return sum(os.times()[:4])


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    item.stash[BEGUN] = _seconds()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    report = yield
    if call.when == "teardown":
        report.user_properties.append(("cpu", _seconds() - item.stash[BEGUN]))
    return report


def pytest_terminal_summary(terminalreporter, config):
    """What tests cost with ``--cpu N``: seconds of the processor, all together and the N dearest."""
    if config.getoption("--cpu") is None:
        return
    reports = [one for some in terminalreporter.stats.values() for one in some]
    cost = Counter()
    for one in reports:
        cost[getattr(one, "nodeid", "")] += dict(getattr(one, "user_properties", ())).get("cpu", 0)
    terminalreporter.section(f"{sum(cost.values()):.0f} s of the processor in {len(cost)} tests")
    for name, seconds in cost.most_common(config.getoption("--cpu")):
        terminalreporter.write_line(f"{seconds:7.2f} {name}")


def pytest_report_header(config):
    return "" if config.getoption("--measured") else f"cases by turns: GRAPHIC_TMM_TURN={TURN}"


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    """Tests of one scene or part run of some scenes; of all with ``--measured`` or where they are marked so.

    A scene may be given by its name or its file. Of cases that take turns those run whose turn it is.
    """
    from support import gallery, parts

    files = {folder / "scene.toml": folder.name for folder in gallery.FOLDERS}

    known, everyday = {*gallery.ALL, *parts.PARTS}, {*gallery.EVERYDAY, *parts.EVERYDAY}
    left_out = set()
    for item in items:
        values = item.callspec.params.values() if hasattr(item, "callspec") else ()
        called = [
            files.get(one) if isinstance(one, Path) else getattr(one, "name", one) for one in values
        ]
        name = next((one for one in called if isinstance(one, str) and one in known), None)
        if name is not None and name not in everyday:
            item.add_marker(pytest.mark.slow)
            if item.get_closest_marker("every") is None:
                left_out.add(item)
    left_out |= waiting(item for item in items if item not in left_out)
    if left_out and not config.getoption("--measured"):
        config.hook.pytest_deselected(items=list(left_out))
        items[:] = [item for item in items if item not in left_out]


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Tests of one scene or part run in one worker, which draws it once."""
    from support.groups import ByScene

    return ByScene(config, log) if config.getvalue("dist") == "load" else None


def pytest_collection_finish(session):
    """Nothing is drawn while tests are collected: each worker collects them all, and waits for it.

    What is there stays until the end, as scenes do that are drawn once: it is not looked through for garbage
    again and again.
    """
    from support import gallery

    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 20, 50)
    if gallery.made.cache_info().currsize or gallery.composed.cache_info().currsize:
        raise pytest.UsageError(
            "a test module draws a scene where it is imported: draw in the test"
        )


def pytest_configure(config):
    Wanted.all = config.getoption("--measured")
    everyday = config.option.markexpr == "not slow"
    usual = "measured" if Wanted.all else "person"
    settings.load_profile("everyday" if everyday else "ci" if os.environ.get("CI") else usual)
