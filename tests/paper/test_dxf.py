"""DXF: read back by ezdxf without faults, millimetres, layers, the check line, the same bytes."""

from __future__ import annotations

import io

import pytest
from support.gallery import paper

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.write.dxf import WEIGHTS, dxf

ezdxf = pytest.importorskip("ezdxf")


@pytest.fixture(scope="module")
def sheet():
    return paper("engine")[1][0]


@pytest.fixture(scope="module")
def document(sheet):
    return ezdxf.read(io.StringIO(dxf(sheet)))


@pytest.mark.slow
def test_no_faults_and_millimetres(document) -> None:
    auditor = document.audit()
    assert not auditor.errors
    assert document.dxfversion == "AC1024"
    assert document.units == 4


@pytest.mark.slow
def test_layers_by_plan_and_line_type(document) -> None:
    layers = {layer.dxf.name: layer for layer in document.layers}
    assert {"positions_rod", "velocities_main", "velocities_medium", "frame_main"} <= set(layers)
    assert layers["velocities_main"].dxf.lineweight == 80
    assert all(layer.dxf.lineweight in (*WEIGHTS, -3) for layer in layers.values())


def test_the_check_line_is_100_mm(document) -> None:
    long = [
        abs(p[1][1] - p[0][1])
        for p in (list(e.get_points("xy")) for e in document.modelspace().query("LWPOLYLINE"))
        if len(p) == 2 and p[0][0] == p[1][0] == 5.5
    ]
    assert any(abs(length - 100.0) < 1e-9 for length in long)


def test_everything_stands_on_the_sheet(document, sheet) -> None:
    for entity in document.modelspace().query("LWPOLYLINE"):
        for x, y in entity.get_points("xy"):
            assert -1e-6 <= x <= sheet.width + 1e-6
            assert -1e-6 <= y <= sheet.height + 1e-6


@pytest.mark.slow
def test_the_same_bytes(sheet) -> None:
    assert dxf(sheet) == dxf(sheet)


def test_without_ezdxf_the_remedy_is_told(sheet, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "ezdxf", None)
    with pytest.raises(SheetError, match=r"pip install 'graphic-tmm\[dxf\]'"):
        dxf(sheet)
