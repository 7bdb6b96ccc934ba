"""Ways in which people write the same readings of tests/cases/check/six.toml, with what is meant by them.

Thought of before the parser was written that reads them.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import NamedTuple

V, A = "velocities", "accelerations"
Due = dict[tuple[str, str, str], tuple[str, float]]
"""By plan, segment and position "mm" or "v" (a value) and the figure."""
REFUSED: Due = {}


class W(NamedTuple):
    """A way of writing: its name, the file, what is meant; ``letters``: those of the option."""

    name: str
    file: bytes
    due: Due
    letters: str = ""


def mm(plan: str, position: str, **of: float) -> Due:
    return {(plan, segment, position): ("mm", figure) for segment, figure in of.items()}


def value(segment: str, position: str, figure: float) -> Due:
    return {(V, segment, position): ("v", figure)}


def sv(*rows: str, sep: str = ";") -> bytes:
    return ("\n".join(rows).replace(";", sep) + "\n").encode()


def book(*sheets: tuple[str, Sequence[Sequence[object]], Sequence[str]]) -> bytes:
    from openpyxl import Workbook

    made = Workbook()
    made.remove(made.worksheets[0])
    for title, rows, merged in sheets:
        sheet = made.create_sheet(title)
        for row in rows:
            sheet.append(list(row))
        for area in merged:
            sheet.merge_cells(area)
    out = io.BytesIO()
    made.save(out)
    return out.getvalue()


HEAD = "план;положение;отрезок;мм"


def rows(*some: str) -> bytes:
    return sv(HEAD, *some)


PD = mm(V, "1", pa=82.5, pd=25.1) | mm(V, "3", pa=82.5, pd=30.0)
ONE = mm(V, "1", pd=25.1)
FIRST: tuple[W, ...] = (
    W(
        "plain",
        rows(
            "velocities;1;pa;82,5",
            "velocities;1;pd;25,1",
            "velocities;3;pa;82,5",
            "velocities;3;pd;30,0",
        ),
        PD,
    ),
    W(
        "plan blank filled down",
        rows("скорости;1;pa;82,5", ";1;pd;25,1", ";3;pa;82,5", ";3;pd;30"),
        PD,
    ),
    W(
        "plan and position blank",
        rows("скорости;1;pa;82,5", ";;pd;25,1", ";3;pa;82,5", ";;pd;30"),
        PD,
    ),
    W(
        "position blank only",
        rows("скорости;1;pa;82,5", "скорости;;pd;25,1", "скорости;3;pa;82,5", "скорости;;pd;30"),
        PD,
    ),
    W(
        "ditto marks",
        rows("скорости;1;pa;82,5", "-//-;-//-;pd;25,1", "скорости;3;pa;82,5", "-//-;-//-;pd;30"),
        PD,
    ),
    W(
        "ditto quotes 〃",
        rows("скорости;1;pa;82,5", "〃;〃;pd;25,1", "скорости;3;pa;82,5", "〃;〃;pd;30"),
        PD,
    ),
    W(
        "no position column for one position",
        sv("план;№;отрезок;мм", "скорости;1;pd;25,1"),
        ONE,
    ),
    W("dash for empty cell", rows("скорости;1;pa;-", "скорости;1;pd;25,1"), ONE),
    W("em dash for empty", rows("скорости;1;pa;—", "скорости;1;pd;25,1"), ONE),
    W("en dash for empty", rows("скорости;1;pa;–", "скорости;1;pd;25,1"), ONE),
    W("нет", rows("скорости;1;pa;нет", "скорости;1;pd;25,1"), ONE),
    W("n/a", rows("velocities;1;pa;n/a", "velocities;1;pd;25,1"), ONE),
    W("question mark", rows("скорости;1;pa;?", "скорости;1;pd;25,1"), ONE),
    W("about ≈", rows("скорости;1;pd;≈25,1"), ONE),
    W("about ~", rows("скорости;1;pd;~25,1"), ONE),
    W("about ~ with space", rows("скорости;1;pd;~ 25,1 мм"), ONE),
    W("ок. 25", rows("скорости;1;pd;ок. 25,1"), ONE),
    W("ca. 25", rows("velocities;1;pd;ca. 25,1"), ONE),
    W("equals sign in cell", rows("скорости;1;pd;pd = 25,1"), ONE),
    W("range 25-26", rows("скорости;1;pd;25-26"), REFUSED),
    W("plus minus", rows("скорости;1;pd;25,1±0,5"), ONE),
    W(
        "title значение",
        sv("план;положение;отрезок;значение;единица", "скорости;1;pd;1,004;м/с"),
        value("pd", "1", 1.004),
    ),
    W(
        "title величина, м/с",
        sv("план;положение;отрезок;величина, м/с", "скорости;1;pd;1,004"),
        value("pd", "1", 1.004),
    ),
    W(
        "title значение, м/с",
        sv("план;положение;отрезок;значение, м/с", "скорости;1;pd;1,004"),
        value("pd", "1", 1.004),
    ),
    W(
        "title скорость, м/с",
        sv("план;положение;отрезок;скорость, м/с", "скорости;1;pd;1,004"),
        value("pd", "1", 1.004),
    ),
    W(
        "title ед. изм.",
        sv("план;положение;отрезок;значение;ед. изм.", "скорости;1;pd;1,004;м/с"),
        value("pd", "1", 1.004),
    ),
    W("title длина, мм", sv("план;положение;отрезок;длина, мм", "скорости;1;pd;25,1"), ONE),
    W(
        "title длина отрезка, мм",
        sv("план;положение;отрезок;длина отрезка, мм", "скорости;1;pd;25,1"),
        ONE,
    ),
    W("title № положения", sv("план;№ положения;отрезок;мм", "скорости;1;pd;25,1"), ONE),
    W("title № пол.", sv("план;№ пол.;отрезок;мм", "скорости;1;pd;25,1"), ONE),
    W("title Вектор", sv("план;положение;вектор;мм", "скорости;1;pd;25,1"), ONE),
    W("title обозначение", sv("план;положение;обозначение;мм", "скорости;1;pd;25,1"), ONE),
    W("titles capitals and colons", sv("План:;Положение:;Отрезок:;ММ", "скорости;1;pd;25,1"), ONE),
    W("titles English synonyms", sv("diagram,pos,vector,length (mm)", "velocities,1,pd,25.1"), ONE),
    W(
        "title value [m/s]",
        sv("plan,position,segment,value [m/s]", "velocities,1,pd,1.004"),
        value("pd", "1", 1.004),
    ),
    W(
        "unknown column note",
        sv("план;положение;отрезок;мм;примечание", "скорости;1;pd;25,1;криво"),
        ONE,
    ),
    W(
        "ignored column of figures",
        sv("план;положение;отрезок;мм;итого", "скорости;1;pd;25,1;3"),
        ONE,
    ),
    W("roman I", rows("скорости;I;pd;25,1"), ONE),
    W("roman III small", rows("скорости;iii;pd;30"), mm(V, "3", pd=30.0)),
    W("roman Cyrillic І", rows("скорости;ІІІ;pd;30"), mm(V, "3", pd=30.0)),
    W("roman Unicode Ⅲ", rows("скорости;Ⅲ;pd;30"), mm(V, "3", pd=30.0)),
    W("degrees 45°", rows("скорости;45°;pd;25,1"), ONE),
    W("φ=45", rows("скорости;φ=45;pd;25,1"), ONE),
    W("φ = 45°", rows("скорости;φ = 45°;pd;25,1"), ONE),
    W("45 град.", rows("скорости;45 град.;pd;25,1"), ONE),
    W("φ1=135", rows("скорости;φ1=135°;pd;30"), mm(V, "3", pd=30.0)),
    W("degrees of no position", rows("скорости;37°;pd;25,1"), REFUSED),
    W("bare 45", rows("скорости;45;pd;25,1"), REFUSED),
    W("пол. 1", rows("скорости;пол. 1;pd;25,1"), ONE),
    W("положение 1", rows("скорости;положение 1;pd;25,1"), ONE),
    W("position 1", rows("скорости;position 1;pd;25,1"), ONE),
    W("1-е", rows("скорости;1-е;pd;25,1"), ONE),
    W("1.", rows("скорости;1.;pd;25,1"), ONE),
    W("position (1)", rows("скорости;(1);pd;25,1"), ONE),
    W("V_D", rows("скорости;1;V_D;25,1"), ONE),
    W("VD", rows("скорости;1;VD;25,1"), ONE),
    W("Vd", rows("скорости;1;Vd;25,1"), ONE),
    W("v_A3A", rows("скорости;1;V_A3A;49,2"), mm(V, "1", aa3=49.2)),
    W("VA3A2 by whole letters", rows("скорости;1;VA3A;49,2"), mm(V, "1", aa3=49.2)),
    W("v_CD turned", rows("скорости;1;V_CD;3,7"), mm(V, "1", cd=3.7)),
    W("a_DC^n", rows("ускорения;1;a_DC^n;0,1"), mm(A, "1", cn4=0.1)),
    W("a^n_DC", rows("ускорения;1;a^n_DC;0,1"), mm(A, "1", cn4=0.1)),
    W("aDCn", rows("ускорения;1;aDCn;0,1"), mm(A, "1", cn4=0.1)),
    W("anDC", rows("ускорения;1;anDC;0,1"), mm(A, "1", cn4=0.1)),
    W("a_DC^τ", rows("ускорения;1;a_DC^τ;2,8"), mm(A, "1", n4d=2.8)),
    W("aτDC", rows("ускорения;1;aτDC;2,8"), mm(A, "1", n4d=2.8)),
    W("a_A3A^к", rows("ускорения;1;a_A3A^к;19,5"), mm(A, "1", ak2=19.5)),
    W("a_кор", rows("ускорения;1;a_кор;19,5"), mm(A, "1", ak2=19.5)),
    W("pi d", rows("ускорения;1;π d;14,9"), mm(A, "1", πd=14.9)),
    W("arrow over", rows("скорости;1;p→d;25,1"), ONE),
    W("vector bar", rows("скорости;1;p̅d̅;25,1"), ONE),
    W("brackets [pd]", rows("скорости;1;[pd];25,1"), ONE),
    W("(pd)", rows("скорости;1;(pd);25,1"), ONE),
    W("|pd|", rows("скорости;1;|pd|;25,1"), ONE),
    W("p-d", rows("скорости;1;p-d;25,1"), ONE),
    W("pd, мм in segment", rows("скорости;1;pd, мм;25,1"), ONE),
    W("crosstab seg down", sv("скорости;1;3", "pa;82,5;82,5", "pd;25,1;30"), PD),
    W("crosstab pos down", sv("скорости;pa;pd", "1;82,5;25,1", "3;82,5;30"), PD),
    W("crosstab titled", sv("План скоростей;;", "отрезок;1;3", "pa;82,5;82,5", "pd;25,1;30"), PD),
    W(
        "crosstab two blocks",
        sv("скорости;1;3", "pa;82,5;82,5", "pd;25,1;30", "ускорения;1;3", "πd;14,9;13"),
        PD | mm(A, "1", πd=14.9) | mm(A, "3", πd=13.0),
    ),
    W(
        "crosstab two blocks with blank lines",
        sv(
            "План скоростей",
            "отрезок;1;3",
            "pa;82,5;82,5",
            "pd;25,1;30",
            ";;",
            "План ускорений",
            "отрезок;1;3",
            "πd;14,9;13",
        ),
        PD | mm(A, "1", πd=14.9) | mm(A, "3", πd=13.0),
    ),
    W(
        "crosstab with dash",
        sv("скорости;1;3", "pa;82,5;82,5", "pd;25,1;-"),
        mm(V, "1", pa=82.5, pd=25.1) | mm(V, "3", pa=82.5),
    ),
    W("crosstab roman", sv("скорости;I;III", "pa;82,5;82,5", "pd;25,1;30"), PD),
    W("crosstab degrees", sv("скорости;45°;135°", "pa;82,5;82,5", "pd;25,1;30"), PD),
    W("crosstab пол. 1", sv("скорости;пол. 1;пол. 3", "pa;82,5;82,5", "pd;25,1;30"), PD),
    W("crosstab commas", sv("velocities,1,3", "pa,82.5,82.5", "pd,25.1,30"), PD),
    W("crosstab tabs", sv("velocities;1;3", "pa;82,5;82,5", "pd;25,1;30", sep="\t"), PD),
    W(
        "crosstab plan column",
        sv("план;отрезок;1;3", "скорости;pa;82,5;82,5", "скорости;pd;25,1;30"),
        PD,
    ),
    W(
        "crosstab plan column blank",
        sv("план;отрезок;1;3", "скорости;pa;82,5;82,5", ";pd;25,1;30", "ускорения;πd;14,9;13"),
        PD | mm(A, "1", πd=14.9) | mm(A, "3", πd=13.0),
    ),
    W(
        "crosstab omega",
        sv("скорости;1;3", "pd;25,1;30", "ω3;4,965;-4"),
        mm(V, "1", pd=25.1)
        | mm(V, "3", pd=30.0)
        | value("omega3", "1", 4.965)
        | value("omega3", "3", -4.0),
    ),
    W(
        "crosstab segment titles with mm",
        sv("скорости;pa, мм;pd, мм", "1;82,5;25,1", "3;82,5;30"),
        PD,
    ),
    W(
        "crosstab of values",
        sv("скорости;V_D, м/с", "1;1,004", "3;1,2"),
        value("pd", "1", 1.004) | value("pd", "3", 1.2),
    ),
    W("crosstab without plan", sv("отрезок;1;3", "pa;82,5;82,5", "pd;25,1;30"), PD),
    W(
        "crosstab of velocities and accelerations no plan",
        sv("отрезок;1;3", "pd;25,1;30", "πd;14,9;13"),
        mm(V, "1", pd=25.1) | mm(V, "3", pd=30.0) | mm(A, "1", πd=14.9) | mm(A, "3", πd=13.0),
    ),
    W("own letters row", sv("letters;K=A", HEAD, "скорости;1;pk;82,5"), mm(V, "1", pa=82.5)),
    W(
        "own letters буквы",
        sv("буквы;K=A;E=D", HEAD, "скорости;1;pk;82,5", "скорости;1;pe;25,1"),
        mm(V, "1", pa=82.5, pd=25.1),
    ),
    W("own letters exchanged", sv("буквы;C=D;D=C", HEAD, "скорости;1;pc;25,1"), ONE),
    W("own letters in one cell", sv('letters;"K=A, E=D"', HEAD, "скорости;1;pe;25,1"), ONE),
    W("own letters option", rows("скорости;1;pe;25,1"), ONE, "E=D"),
    W("own letters of quantities", sv("буквы;E=D", HEAD, "скорости;1;V_E;25,1"), ONE),
    W("own letter unknown", sv("буквы;E=Q", HEAD, "скорости;1;pe;25,1"), REFUSED),
    W("own letter without a word", rows("скорости;1;pe;25,1"), REFUSED),
    W(
        "xlsx plain",
        book(("Лист1", [["план", "положение", "отрезок", "мм"], ["скорости", 1, "pd", 25.1]], [])),
        ONE,
    ),
    W(
        "xlsx merged plan and position",
        book(
            (
                "Лист1",
                [
                    ["план", "положение", "отрезок", "мм"],
                    ["скорости", 1, "pa", 82.5],
                    [None, None, "pd", 25.1],
                    [None, 3, "pa", 82.5],
                    [None, None, "pd", 30],
                ],
                ["A2:A5", "B2:B3", "B4:B5"],
            )
        ),
        PD,
    ),
    W(
        "xlsx sheets as plans",
        book(
            ("Скорости", [["положение", "отрезок", "мм"], [1, "pd", 25.1]], []),
            ("Ускорения", [["положение", "отрезок", "мм"], [1, "πd", 14.9]], []),
        ),
        ONE | mm(A, "1", πd=14.9),
    ),
    W(
        "xlsx crosstab sheets",
        book(
            ("План скоростей", [["отрезок", 1, 3], ["pa", 82.5, 82.5], ["pd", 25.1, 30]], []),
            ("План ускорений", [["отрезок", 1, 3], ["πd", 14.9, 13]], []),
        ),
        PD | mm(A, "1", πd=14.9) | mm(A, "3", πd=13.0),
    ),
    W(
        "xlsx merged title row",
        book(
            (
                "Лист1",
                [
                    ["Положения", None, None],
                    ["скорости", 1, 3],
                    ["pa", 82.5, 82.5],
                    ["pd", 25.1, 30],
                ],
                ["A1:C1"],
            )
        ),
        PD,
    ),
    W(
        "xlsx two sheets both full",
        book(
            ("Иванов", [["план", "положение", "отрезок", "мм"], ["скорости", 1, "pd", 25.1]], []),
            ("Петров", [["план", "положение", "отрезок", "мм"], ["скорости", 1, "pd", 26]], []),
        ),
        REFUSED,
    ),
    W("no reading at all", rows("скорости;1;pd;"), REFUSED),
    W("only ignored figures", sv("план;положение;отрезок;мм;итого", "скорости;1;pd;;3"), REFUSED),
)
