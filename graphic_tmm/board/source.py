"""The source of an operation as a tree, for whoever writes it down in another language."""

from __future__ import annotations

import ast
import inspect
import textwrap
import types
from collections.abc import Callable
from typing import Any


class NotCompiled(Exception):
    """A function cannot be written down in another language."""


class Plain(ast.NodeTransformer):
    """An operation's source without what only arrays or people need."""

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """Drop decorators and annotations; choices stand among the other arguments."""
        self.generic_visit(node)
        node.decorator_list, node.returns = [], None
        signature = node.args
        signature.args = [*signature.args, *signature.kwonlyargs]
        signature.kwonlyargs, signature.kw_defaults, signature.defaults = [], [], []
        for argument in signature.args:
            argument.annotation = None
        return node

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST:
        """Drop the annotation of a variable."""
        self.generic_visit(node)
        assert node.value is not None
        return ast.copy_location(ast.Assign([node.target], node.value), node)


def plain_source(function: Callable[..., Any], by: Plain) -> ast.FunctionDef:
    """Return the source of a function as a tree, made plain ``by`` a transformer.

    Raises
    ------
    NotCompiled
        Of what is no function of its module: what is built in, bound or encloses values.
    """
    if not isinstance(function, types.FunctionType) or function.__closure__:
        raise NotCompiled(repr(function))
    try:
        tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    except (OSError, TypeError, SyntaxError) as error:
        raise NotCompiled(repr(function)) from error
    if not isinstance(tree.body[0], ast.FunctionDef):
        raise NotCompiled(repr(function))
    found: ast.FunctionDef = by.visit(tree.body[0])
    return ast.fix_missing_locations(found)


def globals_of(function: Callable[..., Any]) -> list[str]:
    """Return the names of its module that a function uses."""
    return [name for name in function.__code__.co_names if name in function.__globals__]


def defaults(function: Callable[..., Any], choice: dict[str, int]) -> tuple[int, ...]:
    """Return the values of a function's keyword-only arguments, in order."""
    given = {**(getattr(function, "__kwdefaults__", None) or {}), **choice}
    code = getattr(function, "__code__", None)
    if code is None:
        return ()
    first = code.co_argcount
    return tuple(given[name] for name in code.co_varnames[first : first + code.co_kwonlyargcount])
