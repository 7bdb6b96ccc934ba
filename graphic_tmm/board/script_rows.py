"""Operations on rows of positions, written down in JavaScript from their own sources as those on numbers are.

A row is an array of numpy's axes, (trial, position), of one trial. What adds, compares, cuts and joins arrays
is an object ``$$`` of the page's program (`page/web/live/rows.js`), by numpy's own names; what an operation
takes and leaves is a mark at all positions.
"""

from __future__ import annotations

import ast
import inspect
import types
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any, NewType

import numpy as np

from graphic_tmm.board import geometry
from graphic_tmm.board.operations import curve, graph_curves, graphs
from graphic_tmm.board.record import Step
from graphic_tmm.board.script import Script, Written
from graphic_tmm.board.source import NotCompiled, defaults

ROWS = "$$"
"""What does the arithmetic of arrays is called so, and names of functions on rows begin so."""
_SIGNS: Mapping[type, str] = {
    ast.Add: "plus",
    ast.Sub: "minus",
    ast.Mult: "times",
    ast.Div: "over",
    ast.Pow: "power",
    ast.Mod: "mod",
    ast.BitAnd: "and",
    ast.BitOr: "or",
    ast.Eq: "equal",
    ast.NotEq: "unequal",
    ast.Lt: "less",
    ast.LtE: "less_equal",
    ast.Gt: "greater",
    ast.GtE: "greater_equal",
}
_ALONG = ("axis", "keepdims")
_NAMED: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(("sum", "mean", "max", "min", "ptp", "all", "any", "argmax", "argmin"), _ALONG),
    **dict.fromkeys(("cumsum", "concatenate"), ("axis",)),
    **dict.fromkeys(("real", "imag", "conj", "abs", "sign", "sqrt", "sin", "floor", "rint"), ()),
    **dict.fromkeys(("degrees", "copysign", "maximum", "minimum", "clip", "isfinite"), ()),
    **dict.fromkeys(("isnan", "where", "append", "array", "full", "full_like", "arctan2"), ()),
    **dict.fromkeys(("zeros_like", "broadcast_to", "broadcast_arrays", "arange", "split"), ()),
    "flatnonzero": (),
    "nan_to_num": ("nan",),
    "roll": ("shift", "axis"),
    "diff": ("axis", "append"),
    "take_along_axis": ("indices", "axis"),
}
"""What numpy does to arrays, and what it takes by name behind the array."""
_METHODS = {"sum", "max", "min", "all", "any", "argmax", "argmin", "cumsum"}
_SAME: frozenset[Any] = frozenset({np.asarray, np.ascontiguousarray, int, float, list, tuple})
"""What these take they return."""
_HELPERS: Mapping[Any, str] = {
    geometry.vector: "vector",
    geometry.reverse: "opposite",
    geometry.quadrant: "quadrant",
    geometry.sine: "sin",
    geometry.some: "any",
    geometry.pick: "where",
    graphs.alike: "alike",
    graphs.knot_before: "knot_before",
    curve.periodic: "periodic",
    curve.natural: "natural",
    graph_curves.free_ends: "free_ends",
    abs: "abs",
    range: "arange",
    sum: "total",
}


class RowScript(Script):
    """Functions written down in JavaScript, those that work across positions among them."""

    def __init__(self) -> None:
        super().__init__()
        self.on_rows: dict[Callable[..., Any], str] = {}
        self.row_texts: dict[Callable[..., Any], str] = {}

    def add_rows(self, function: Callable[..., Any]) -> str:
        """Write a function of rows down if it is not yet; return its name.

        Raises
        ------
        NotCompiled
            If it does what arrays of the page cannot be asked for.
        """
        if function not in self.on_rows:
            written = _OnRows(self, function)
            text = written.text()
            name = f"{ROWS}{function.__name__}"
            while name in self.on_rows.values():
                name += "_"
            self.on_rows[function] = name
            self.row_texts[function] = f"function {name}({written.takes}) {{\n{text}}}"
        return self.on_rows[function]

    def written(self, step: Step, *, rows: bool = True) -> bool:
        """Whether a step can be written down, on single numbers or on ``rows``."""
        ways = [] if step.op.across else [self.add]
        for add in (*ways, self.add_rows) if rows else ways:
            try:
                add(step.op.run)
            except NotCompiled:
                continue
            return True
        return False

    @property
    def functions(self) -> list[str]:
        """The functions that are written down, those on rows behind the others."""
        return [*super().functions, *self.row_texts.values()]

    @property
    def needs(self) -> dict[str, str]:
        """What does the arithmetic of the functions that are written down, by what these call it."""
        return super().needs | ({ROWS: "ROWS"} if self.on_rows else {})

    def across(self, steps: Iterable[Step]) -> str:
        """Return steps as a function of the values of marks in all positions, P: an M for each, as in `log`."""
        parts = []
        for single, some in groupby(steps, key=lambda step: step.op.run in self.texts):
            if single:
                parts.append(f"for (const M of P) {{\n{''.join(map(self._line, some))}}}\n")
            else:
                parts += map(self._row_line, some)
        return f"(P) => {{\n{''.join(parts)}}}"

    def _row_line(self, step: Step) -> str:
        uses = [f"{ROWS}.take(P, {mark.slot})" for mark in step.uses]
        choice = map(str, defaults(step.op.run, dict(step.choice)))
        told = f"{self.add_rows(step.op.run)}({', '.join([*uses, *choice])})"
        return f"{ROWS}.put(P, {step.it.slot}, {told});\n"


class _OnRows(Written):
    """A function of rows while it is written down."""

    script: RowScript

    def __init__(self, script: RowScript, function: Callable[..., Any]) -> None:
        super().__init__(script, function)
        names = {node.id for node in ast.walk(self.tree) if isinstance(node, ast.Name)}
        mine = {*self.own, *self.arguments}
        self.globals = {
            name: function.__globals__[name] for name in names & {*function.__globals__} - mine
        }

    def statement(self, node: ast.stmt) -> str:
        """Return a statement as lines."""
        match node:
            case ast.Assert():
                return ""
            case ast.Expr(value=ast.Call() as value):
                return f"{self.value(value)};\n"
            case ast.Continue():
                return "continue;\n"
            case ast.Assign(targets=[ast.Subscript(value=of, slice=index)], value=value):
                told = ", ".join(self.index(index))
                return f"{ROWS}.enter({self.value(of)}, [{told}], {self.value(value)});\n"
            case ast.Assign(targets=[ast.Attribute(value=of, attr=attr)], value=value):
                parts = {part: f"{ROWS}.{part}({self.value(of)})" for part in ("real", "imag")}
                parts[attr] = self.value(value)
                return f"{self.value(of)} = {ROWS}.vector({parts['real']}, {parts['imag']});\n"
            case ast.Assign(targets=[ast.Tuple() as target], value=value):
                return f"{self.value(target)} = {self.value(value)};\n"
            case ast.For(target=target, iter=over, body=body, orelse=[]):
                inner = "".join(map(self.statement, body))
                return f"for ({self.value(target)} of {self.value(over)}) {{\n{inner}}}\n"
        return super().statement(node)

    def value(self, node: ast.expr) -> str:
        """Return an expression."""
        match node:
            case ast.Subscript(value=of, slice=index):
                return f"{ROWS}.at({', '.join([self.value(of), *self.index(index)])})"
            case ast.Tuple(elts=parts) | ast.List(elts=parts):
                return f"[{', '.join(map(self.value, parts))}]"
            case ast.Starred(value=of):
                return f"...{self.value(of)}"
            case ast.ListComp() | ast.GeneratorExp():
                return self.each(node)
            case ast.Call(func=function, args=arguments, keywords=named):
                return self.row_call(function, arguments, named)
        return super().value(node)

    def each(self, node: ast.ListComp | ast.GeneratorExp) -> str:
        """Return a list that is made of another."""
        if len(node.generators) > 1:
            raise self.unknown(node)
        (over,) = node.generators
        found = f"[{self.value(node.elt)}]"
        if over.ifs:
            test = " && ".join(map(self.value, over.ifs))
            found = f"(({test}) ? {found} : [])"
        return f"{self.value(over.iter)}.flatMap(({self.value(over.target)}) => {found})"

    def index(self, node: ast.expr) -> Iterator[str]:
        """Yield the parts of an index, one for each axis."""
        for part in node.elts if isinstance(node, ast.Tuple) else [node]:
            match part:
                case ast.Slice(lower=lower, upper=upper, step=None):
                    ends = ["null" if end is None else self.value(end) for end in (lower, upper)]
                    yield f"{{ from: {ends[0]}, to: {ends[1]} }}"
                case ast.Constant(value=None):
                    yield "null"
                case ast.Constant(value=value) if value is Ellipsis:
                    yield '"..."'
                case _:
                    yield self.value(part)

    def constant(self, value: object) -> str:
        """Return a number, or a list of numbers."""
        if isinstance(value, list | tuple):
            return f"[{', '.join(map(self.constant, value))}]"
        if isinstance(value, complex):
            return f"{ROWS}.complex({self.constant(value.real)}, {self.constant(value.imag)})"
        return super().constant(value)

    def binary(self, left: ast.expr, op: ast.operator, right: ast.expr) -> str:
        """Return what an operator makes of two."""
        return self.signed(op, self.value(left), self.value(right))

    def signed(self, op: ast.AST, first: str, second: str) -> str:
        """Return what a sign makes of two."""
        if type(op) not in _SIGNS:
            raise NotCompiled(f"{self.function.__name__}: {op!r}")
        return f"{ROWS}.{_SIGNS[type(op)]}({first}, {second})"

    def unary(self, op: ast.unaryop, of: ast.expr) -> str:
        """Return what an operator makes of one."""
        if isinstance(of, ast.Constant) and isinstance(of.value, int) and isinstance(op, ast.USub):
            return f"-{of.value}"
        if isinstance(op, ast.USub):
            return f"{ROWS}.opposite({self.value(of)})"
        if isinstance(op, ast.Invert):
            return f"{ROWS}.not({self.value(of)})"
        return super().unary(op, of)

    def comparison(self, values: list[ast.expr], ops: list[ast.cmpop]) -> str:
        """Return where values stand in an order."""
        told = list(map(self.value, values))
        parts = [self.signed(op, told[k], told[k + 1]) for k, op in enumerate(ops)]
        return parts[0] if len(parts) == 1 else f"({' && '.join(parts)})"

    def attribute(self, of: ast.expr, attr: str) -> str:
        """Return a part of a value, its shape or its size, or what a module of numbers has."""
        if attr in ("real", "imag", "shape", "size"):
            return f"{ROWS}.{attr}({self.value(of)})"
        return super().attribute(of, attr)

    def row_call(
        self, function: ast.expr, arguments: list[ast.expr], named: list[ast.keyword]
    ) -> str:
        """Return what a function makes of its arguments."""
        by_name = {one.arg or "": self.value(one.value) for one in named}
        taken = [self.value(one) for one in arguments]
        if isinstance(function, ast.Attribute) and function.attr in _METHODS:
            of = function.value
            if not isinstance(of, ast.Name) or of.id not in self.globals:
                taken = [self.value(of), *taken]
                return self.call_of(
                    f"{ROWS}.{function.attr}", taken, by_name, _NAMED[function.attr]
                )
        called = self.called(function)
        if called in _SAME or isinstance(called, NewType):
            return taken[0]
        if isinstance(called, type) and issubclass(called, tuple):
            fields: Sequence[str] = called._fields  # type: ignore[attr-defined]
            return f"({{ {', '.join(map(': '.join, zip(fields, taken, strict=True)))} }})"
        if called in _HELPERS:
            return self.call_of(f"{ROWS}.{_HELPERS[called]}", taken, by_name, ())
        for name, further in _NAMED.items():
            if called is getattr(np, name):
                return self.call_of(f"{ROWS}.{name}", taken, by_name, further)
        if isinstance(called, types.FunctionType):
            names = [*inspect.signature(called).parameters][len(taken) :]
            given = {
                name: self.constant(one.default)
                for name, one in inspect.signature(called).parameters.items()
                if one.default is not inspect.Parameter.empty
            }
            return self.call_of(self.script.add_rows(called), taken, given | by_name, names)
        raise self.unknown(function)

    def call_of(
        self, name: str, taken: Sequence[str], by_name: Mapping[str, str], names: Sequence[str]
    ) -> str:
        """Return a call whose arguments stand in their order."""
        own = list(names)[max(len(taken) - 1, 0) :] if name.startswith(f"{ROWS}.") else list(names)
        if left := set(by_name) - set(names):
            raise NotCompiled(f"{self.function.__name__}: {name}({left})")
        behind = [by_name.get(one, "undefined") for one in own]
        while behind and behind[-1] == "undefined":
            behind.pop()
        return f"{name}({', '.join([*taken, *behind])})"
