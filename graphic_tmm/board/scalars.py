"""The operations of the board on single numbers, compiled by numba.

No operation is described anew: its own source is compiled, with numpy's functions, and the few helpers of
`geometry` that speak of arrays, replaced by those of a single number.
"""

from __future__ import annotations

import ast
import math
import types
from collections.abc import Callable
from functools import cache, partial
from typing import Any, NamedTuple, NewType

import numpy as np

from graphic_tmm.board import geometry
from graphic_tmm.board.source import Plain, globals_of, plain_source
from graphic_tmm.errors import ConstructionError


def numba() -> Any:
    """Return numba.

    Raises
    ------
    ConstructionError
        If it is not installed.
    """
    try:
        import numba as found
    except ImportError as error:
        raise ConstructionError(
            "a compiled log needs numba: install it (pip install 'graphic-tmm[fast]'), or run without fast"
        ) from error
    return found


# One number instead of an array: what numpy's functions, and the array helpers of `geometry`, are then.


def _where(mask: Any, first: Any, second: Any) -> Any:
    return first if mask else second


def _itself(value: Any) -> Any:
    return value


def _length(z: Any) -> Any:
    return math.sqrt(z.real * z.real + z.imag * z.imag)


_SINE = (
    1.58969099521155010221e-10,
    -2.50507602534068634195e-08,
    2.75573137070700676789e-06,
    -1.98412698298579493134e-04,
    8.33333333332248946124e-03,
    -1.66666666666666324348e-01,
)


def _sine(x: Any) -> Any:
    """Return the sine of angles up to 45°: the usual minimax polynomial of degree 13.

    A polynomial runs at several positions in step, which a call of the system's sine does not.
    """
    square = x * x
    s5, s4, s3, s2, s1, s0 = _SINE
    series = square * (
        s0 + square * (s1 + square * (s2 + square * (s3 + square * (s4 + square * s5))))
    )
    return x + x * series


def _vector(x: Any, y: Any) -> Any:
    return complex(x, y)


def _reverse(z: Any) -> Any:
    return -z


def _quadrant(quarters: Any) -> Any:
    rest = quarters - 4.0 * np.floor(quarters * 0.25)
    x = 1.0 if rest == 0.0 else (-1.0 if rest == 2.0 else 0.0)
    y = 1.0 if rest == 1.0 else (-1.0 if rest == 3.0 else 0.0)
    return complex(x, y)


def _sign(x: Any) -> Any:
    if x > 0.0:
        return 1.0
    if x < 0.0:
        return -1.0
    return x


class _Names(NamedTuple):
    """What stands for numpy's functions and for other functions in a compiled operation."""

    numpy: types.ModuleType
    functions: dict[Any, Any]


@cache
def _names() -> _Names:
    njit = partial(numba().njit, error_model="numpy", forceinline=True)
    space = types.ModuleType("numbers_of_one_position")
    for name in dir(np):
        if not name.startswith("_"):
            setattr(space, name, getattr(np, name))
    where, itself = njit(_where), njit(_itself)
    space.where, space.asarray, space.sign = where, itself, njit(_sign)  # type: ignore[attr-defined]
    space.abs = _absolute()  # type: ignore[attr-defined]
    functions = {
        geometry.sine: njit(_sine),
        geometry.vector: njit(_vector),
        geometry.reverse: njit(_reverse),
        geometry.quadrant: njit(_quadrant),
        geometry.some: itself,
        geometry.pick: where,
    }
    return _Names(space, functions)


def _absolute() -> Any:
    """Return |x|, of a real number as of a complex one."""
    extending = numba()

    def absolute(x: Any) -> Any:
        return abs(x)

    from numba.core.extending import overload

    njit = partial(extending.njit, error_model="numpy")
    length = njit(_length)

    @overload(absolute, jit_options={"error_model": "numpy"})
    def of_kind(x: Any) -> Any:
        # numba wants the arguments of all three named and annotated alike
        def of_vector(x: Any) -> Any:
            return length(x)

        def of_number(x: Any) -> Any:
            return abs(x)

        return of_vector if isinstance(x, extending.types.Complex) else of_number

    return absolute


class _Dividing(Plain):
    """An operation's source made plain; a quotient by 0 is no error."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """Divide as numpy does."""
        self.generic_visit(node)
        if not isinstance(node.op, ast.Div):
            return node
        return ast.copy_location(
            ast.Call(ast.Name("_divide", ast.Load()), [node.left, node.right], []), node
        )

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        """Divide as numpy does, here too."""
        if not isinstance(node.op, ast.Div) or not isinstance(node.target, ast.Name):
            self.generic_visit(node)
            return node
        whole = ast.BinOp(ast.Name(node.target.id, ast.Load()), ast.Div(), node.value)
        found: ast.AST = self.visit(ast.copy_location(ast.Assign([node.target], whole), node))
        return found


@cache
def scalar(function: Callable[..., Any]) -> Any:
    """Return a function of arrays as a compiled function of single numbers, from its own source."""
    names = _names()
    if function in names.functions:
        return names.functions[function]
    plain = ast.Module([plain_source(function, _Dividing())], [])
    space = {name: _one(function.__globals__[name]) for name in globals_of(function)}
    space["_divide"] = np.divide
    exec(compile(plain, f"<{function.__name__}>", "exec"), space)
    return numba().njit(error_model="numpy", forceinline=True)(space[function.__name__])


def _one(value: Any) -> Any:
    """Return what a global name of an operation stands for on single numbers."""
    if value is np:
        return _names().numpy
    if isinstance(value, NewType):
        return _names().numpy.asarray
    if isinstance(value, types.FunctionType):
        return scalar(value)
    return value
