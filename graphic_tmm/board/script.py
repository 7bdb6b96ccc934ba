"""The operations of the board on single numbers, written down in JavaScript from their own sources.

A number is a number, a point {re, im}, a line {at, along}, an arc {centre, radius}. What adds, multiplies,
compares them is an object ``$`` of the page's program (`page/web/practice/arithmetic.js`), which looks at what
they are; a result that Python has NaN for is NaN.
"""

from __future__ import annotations

import ast
import builtins
import json
import math
import re
import types
from collections.abc import Callable, Iterable, Mapping
from textwrap import indent
from typing import Any, NewType

import numpy as np

from graphic_tmm.board import geometry
from graphic_tmm.board.record import Step
from graphic_tmm.board.source import NotCompiled, Plain, defaults, globals_of, plain_source

_ABOUT_SIGNS = re.compile(r" ?([-,=?:{}<>&|]+) ")
OWN = "$"
"""What does the arithmetic is called so, and names of functions begin so: no name of Python's does."""
_RESERVED = frozenset(
    {
        "arguments",
        "case",
        "catch",
        "const",
        "default",
        "delete",
        "do",
        "enum",
        "eval",
        "export",
        "extends",
    }
    | {
        "function",
        "instanceof",
        "let",
        "new",
        "static",
        "super",
        "switch",
        "this",
        "throw",
        "typeof",
    }
    | {"var", "void"}
)
_BINARY = {
    ast.Add: "plus",
    ast.Sub: "minus",
    ast.Mult: "times",
    ast.Div: "over",
    ast.Pow: "power",
}
_BITS = {ast.BitAnd: "&&", ast.BitOr: "||"}
_ORDER = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
_MATH = ("sin", "cos", "tan", "sqrt", "floor", "ceil", "sign", "log", "exp", "hypot", "pow")
_NUMPY: Mapping[str, str] = {
    **{name: f"Math.{name}" for name in _MATH},
    "arcsin": "Math.asin",
    "arccos": "Math.acos",
    "arctan": "Math.atan",
    "arctan2": "Math.atan2",
    "maximum": "Math.max",
    "minimum": "Math.min",
    **{
        name: f"$.{name}"
        for name in ("abs", "rint", "round", "conj", "radians", "degrees", "copysign", "fmin")
    },
    "nan_to_num": "$.known",
    "negative": "$.opposite",
    "isnan": "$.missing",
    "asarray": "",
}
"""Functions of numpy (and of ``math``) that are called alike; "": what they take is what they return."""
_CONSTANTS = {"pi": "Math.PI", "nan": "NaN", "inf": "Infinity"}
_HELPERS: Mapping[Any, str] = {
    geometry.vector: "$.complex",
    geometry.reverse: "$.opposite",
    geometry.quadrant: "$.quadrant",
    geometry.sine: "Math.sin",
    geometry.some: "",
    abs: "$.abs",
    max: "Math.max",
    min: "Math.min",
    float: "",
    bool: "",
}
_CHOOSE = (np.where, geometry.pick)
_FIELDS = {"real": "$.real", "imag": "$.imag"}


class Script:
    """Functions written down in JavaScript, each once, with those that they call before them."""

    def __init__(self) -> None:
        self.texts: dict[Callable[..., Any], str] = {}
        self.names: dict[Callable[..., Any], str] = {}

    def add(self, function: Callable[..., Any]) -> str:
        """Write a function down if it is not yet; return its name.

        Raises
        ------
        NotCompiled
            If it does what single numbers cannot be asked for.
        """
        if function not in self.texts:
            written = Written(self, function)
            text = written.text()
            self.names[function] = self._free(function.__name__)
            self.texts[function] = f"function {self.names[function]}({written.takes}) {{\n{text}}}"
        return self.names[function]

    def _free(self, name: str) -> str:
        found, taken = f"{OWN}{name}", set(self.names.values())
        while found in taken:
            found += "_"
        return found

    def log(self, steps: Iterable[Step]) -> str:
        """Return steps as a function of the values of marks by their slots, M: it enters what each step leaves.

        What they use stands there already. It is straight: a line for each step, in their order.
        """
        return f"(M) => {{\n{''.join(map(self._line, steps))}}}"

    def _line(self, step: Step) -> str:
        uses = [f"M[{mark.slot}]" for mark in step.uses]
        choice = map(str, defaults(step.op.run, dict(step.choice)))
        return f"M[{step.it.slot}] = {self.add(step.op.run)}({', '.join([*uses, *choice])});\n"

    def program(
        self,
        tables: Mapping[str, Mapping[str, Callable[..., Any]]],
        taken: str,
        logs: Mapping[str, str] | None = None,
    ) -> str:
        """Return the program that hands tables of functions to the function ``taken`` of the page.

        ``logs``: functions of steps (`log`) that it hands over in one more table, "log", by their names. The
        same tables, the same text.
        """
        rows = {
            name: ", ".join(f"{key}: {self.add(one)}" for key, one in functions.items())
            for name, functions in tables.items()
        }
        if logs:
            rows["log"] = ", ".join(map(": ".join, logs.items()))
        told = ", ".join(f"{name}: {{ {row} }}" for name, row in rows.items())
        body = indent("\n".join(self.functions), " ")
        takes, needs = ", ".join(self.needs), ", ".join(self.needs.values())
        return _tight(f"{taken}((({takes}) => {{\n{body}\nreturn {{ {told} }};\n}})({needs}));\n")

    @property
    def functions(self) -> list[str]:
        """The functions that are written down."""
        return [*self.texts.values()]

    @property
    def needs(self) -> dict[str, str]:
        """What does the arithmetic of the functions that are written down, by what these call it."""
        return {OWN: "ARITHMETIC"}


class Written:
    """A function while it is written down."""

    def __init__(self, script: Script, function: Callable[..., Any]) -> None:
        self.script, self.function = script, function
        self.tree = plain_source(function, Plain())
        self.arguments = [argument.arg for argument in self.tree.args.args]
        self.takes = ", ".join(map(_name, self.arguments))
        stored = {
            node.id
            for node in ast.walk(self.tree)
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
        }
        self.own = sorted(stored - set(self.arguments))
        known = set(globals_of(function)) - stored - set(self.arguments)
        self.globals = {name: function.__globals__[name] for name in known}

    def text(self) -> str:
        """Return its body."""
        begin = f"let {', '.join(map(_name, self.own))};\n" if self.own else ""
        return begin + "".join(map(self.statement, self.tree.body))

    def statement(self, node: ast.stmt) -> str:
        """Return a statement as lines."""
        match node:
            case ast.Expr(value=ast.Constant()):
                return ""
            case ast.Return(value=ast.expr() as value):
                return f"return {self.value(value)};\n"
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                return f"{_name(name)} = {self.value(value)};\n"
            case ast.Assign(targets=[ast.Tuple(elts=names)], value=ast.Tuple(elts=values)):
                left = ", ".join(map(self.value, names))
                return f"[{left}] = [{', '.join(map(self.value, values))}];\n"
            case ast.AugAssign(target=ast.Name() as target, op=op, value=value):
                return f"{self.value(target)} = {self.binary(target, op, value)};\n"
            case ast.If(test=test, body=body, orelse=rest):
                inner = "".join(map(self.statement, body))
                other = "".join(map(self.statement, rest))
                found = f"if ({self.value(test)}) {{\n{inner}}}"
                return f"{found} else {{\n{other}}}\n" if other else f"{found}\n"
        raise self.unknown(node)

    def value(self, node: ast.expr) -> str:
        """Return an expression."""
        match node:
            case ast.Constant(value=value):
                return self.constant(value)
            case ast.Name(id=name):
                return self.named(name)
            case ast.BinOp(left=left, op=op, right=right):
                return self.binary(left, op, right)
            case ast.UnaryOp(op=op, operand=of):
                return self.unary(op, of)
            case ast.BoolOp(op=op, values=values):
                sign = " && " if isinstance(op, ast.And) else " || "
                return f"({sign.join(map(self.value, values))})"
            case ast.IfExp(test=test, body=first, orelse=second):
                return self.chosen(test, first, second)
            case ast.Compare(left=left, ops=ops, comparators=others):
                return self.comparison([left, *others], ops)
            case ast.Attribute(value=of, attr=attr):
                return self.attribute(of, attr)
            case ast.Call(func=function, args=arguments, keywords=[]):
                return self.call(function, arguments)
        raise self.unknown(node)

    def constant(self, value: object) -> str:
        """Return a number."""
        if isinstance(value, complex):
            return f"$.complex({value.real!r}, {value.imag!r})"
        if isinstance(value, bool | int | float):
            if isinstance(value, float) and not math.isfinite(value):
                return str(value).replace("nan", "NaN").replace("inf", "Infinity")
            return json.dumps(float(value) if isinstance(value, float) else value)
        raise NotCompiled(f"{self.function!r}: {value!r}")

    def named(self, name: str) -> str:
        """Return what a name stands for: a variable, or a number of the module."""
        return self.constant(self.globals[name]) if name in self.globals else _name(name)

    def binary(self, left: ast.expr, op: ast.operator, right: ast.expr) -> str:
        """Return what an operator makes of two."""
        first, second = self.value(left), self.value(right)
        if type(op) in _BITS:
            return f"({first} {_BITS[type(op)]} {second})"
        if type(op) not in _BINARY:
            raise self.unknown(left)
        return f"$.{_BINARY[type(op)]}({first}, {second})"

    def unary(self, op: ast.unaryop, of: ast.expr) -> str:
        """Return what an operator makes of one."""
        if isinstance(op, ast.USub):
            return f"$.opposite({self.value(of)})"
        if isinstance(op, ast.UAdd):
            return self.value(of)
        return f"!({self.value(of)})"

    def comparison(self, values: list[ast.expr], ops: list[ast.cmpop]) -> str:
        """Return whether values stand in an order."""
        told = list(map(self.value, values))
        parts = []
        for k, op in enumerate(ops):
            first, second = told[k], told[k + 1]
            if isinstance(op, ast.Eq | ast.NotEq):
                parts.append(f"{'!' * isinstance(op, ast.NotEq)}$.equal({first}, {second})")
            elif type(op) in _ORDER:
                parts.append(f"{first} {_ORDER[type(op)]} {second}")
            else:
                raise self.unknown(values[k])
        return f"({' && '.join(parts)})"

    def chosen(self, test: ast.expr, first: ast.expr, second: ast.expr) -> str:
        """Return one of two."""
        return f"({self.value(test)} ? {self.value(first)} : {self.value(second)})"

    def attribute(self, of: ast.expr, attr: str) -> str:
        """Return a part of a value, or what a module of numbers has."""
        if isinstance(of, ast.Name) and self.globals.get(of.id) in (np, math):
            if attr not in _CONSTANTS:
                raise self.unknown(of)
            return _CONSTANTS[attr]
        if attr in _FIELDS:
            return f"{_FIELDS[attr]}({self.value(of)})"
        return f"{self.value(of)}.{attr}"

    def call(self, function: ast.expr, arguments: list[ast.expr]) -> str:
        """Return what a function makes of its arguments."""
        called = self.called(function)
        if called in _CHOOSE:
            return self.chosen(arguments[0], arguments[1], arguments[2])
        taken = list(map(self.value, arguments))
        if isinstance(called, type) and issubclass(called, tuple):
            fields: tuple[str, ...] = called._fields  # type: ignore[attr-defined]
            return f"{{ {', '.join(map(': '.join, zip(fields, taken, strict=True)))} }}"
        name = self.function_name(called, function)
        return f"{name}({', '.join(taken)})"

    def called(self, node: ast.expr) -> Any:
        """Return the function of a call."""
        if isinstance(node, ast.Name):
            known = self.globals.get(node.id, getattr(builtins, node.id, None))
            if known is not None:
                return known
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            found = getattr(self.globals.get(node.value.id), node.attr, None)
            if found is not None:
                return found
        raise self.unknown(node)

    def function_name(self, called: Any, node: ast.expr) -> str:
        """Return what a function is called in JavaScript; "" of one that returns what it takes."""
        if isinstance(called, NewType):
            return ""
        if called in _HELPERS:
            return _HELPERS[called]
        for key, told in _NUMPY.items():
            if called is getattr(np, key, None) or called is getattr(math, key, self):
                return told
        if isinstance(called, types.FunctionType):
            return self.script.add(called)
        raise self.unknown(node)

    def unknown(self, node: ast.AST) -> NotCompiled:
        """Return the fault that tells what cannot be written down."""
        return NotCompiled(f"{self.function.__name__}: {ast.unparse(node)}")


def _tight(text: str) -> str:
    """Return a program without the blanks about its signs: it has no texts in which they count."""
    return _ABOUT_SIGNS.sub(r"\1", text)


def _name(name: str) -> str:
    return f"{name}_" if name in _RESERVED else name
