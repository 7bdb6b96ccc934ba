"""What the house weighs: files and lines, what a reader has to pass, who imports whom in a circle.

python tests/benchmarks/house.py                # of this checkout
python tests/benchmarks/house.py OTHER .        # beside another one, a column each
"""

from __future__ import annotations

import argparse
import ast
import re
import statistics
from collections.abc import Iterator, Mapping
from pathlib import Path

from clock import ROOT

PACKAGE = "graphic_tmm"


def texts(folder: Path, end: str) -> dict[Path, str]:
    """Return the files of a folder with an ending, in order."""
    paths = sorted(p for p in folder.rglob(f"*{end}") if "node_modules" not in p.parts)
    return {path: path.read_text(encoding="utf-8") for path in paths}


def lines(files: Mapping[Path, str]) -> int:
    """Return how many lines they have."""
    return sum(len(text.splitlines()) for text in files.values())


def code(text: str) -> int:
    """Return how many lines hold code: no blank ones, no comments, no docstrings."""
    tree = ast.parse(text)
    spared = {
        line
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
        for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)
    }
    return sum(
        bool(line.strip()) and not line.lstrip().startswith("#") and number not in spared
        for number, line in enumerate(text.splitlines(), 1)
    )


def before_substance(text: str) -> int:
    """Return how many lines stand before the first that is no docstring, import or blank."""
    for node in ast.parse(text).body:
        said = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        typing = isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        if not (said or typing or isinstance(node, ast.Import | ast.ImportFrom)):
            first = min([node.lineno, *(d.lineno for d in getattr(node, "decorator_list", []))])
            return first - 1
    return len(text.splitlines())


def functions(files: Mapping[Path, str]) -> list[int]:
    """Return how long every function is, its docstring among it."""
    return [
        (node.end_lineno or node.lineno) - node.lineno + 1
        for text in files.values()
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]


def imports(files: Mapping[Path, str], root: Path) -> dict[str, set[str]]:
    """Return which modules a module imports: in functions and for types, too."""
    dotted = {
        ".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__"): text
        for path, text in files.items()
    }
    found: dict[str, set[str]] = {}
    for name, text in dotted.items():
        named = set[str]()
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.ImportFrom) and node.module:
                whole = (f"{node.module}.{one.name}" for one in node.names)
                named |= {one if one in dotted else node.module for one in whole}
            elif isinstance(node, ast.Import):
                named |= {one.name for one in node.names}
        found[name] = {one for one in named if one in dotted and one != name}
    return found


def circles(graph: Mapping[str, set[str]]) -> Iterator[list[str]]:
    """Yield the modules that reach each other, circle by circle (strong components, Kosaraju)."""
    order, seen = list[str](), set[str]()
    for start in graph:
        _walk(start, graph, seen, order)
    back: dict[str, set[str]] = {name: set() for name in graph}
    for name, others in graph.items():
        for other in others:
            back[other].add(name)
    seen.clear()
    for start in reversed(order):
        circle = list[str]()
        _walk(start, back, seen, circle)
        if len(circle) > 1:
            yield sorted(circle)


def _walk(start: str, graph: Mapping[str, set[str]], seen: set[str], left: list[str]) -> None:
    """Write down what is reached from a module that was not seen yet, each when all behind it are done."""
    if start in seen:
        return
    seen.add(start)
    stack = [(start, iter(sorted(graph[start])))]
    while stack:
        name, others = stack[-1]
        ahead = next((one for one in others if one not in seen), None)
        if ahead is None:
            left.append(name)
            stack.pop()
        else:
            seen.add(ahead)
            stack.append((ahead, iter(sorted(graph[ahead]))))


def fields_of(text: str, name: str) -> int:
    """Return how many fields a record has."""
    for node in ast.parse(text).body:
        if isinstance(node, ast.ClassDef) and node.name == name:
            return sum(isinstance(one, ast.AnnAssign) for one in node.body)
    return 0


def weighed(root: Path) -> dict[str, float]:
    """Return what a checkout weighs, by what it is called in the table."""
    product, tests = texts(root / PACKAGE, ".py"), texts(root / "tests", ".py")
    chapters = [p for p in product if "chapters" in p.relative_to(root).parts]
    found = list(circles(imports(product, root)))
    declared = next(t for t in product.values() if re.search(r"^class Chapter:", t, re.MULTILINE))
    rooms = [p for p in (root / PACKAGE).iterdir() if (p / "__init__.py").exists()]
    long = [len(line) for text in product.values() for line in text.splitlines() if line.strip()]
    return {
        "Python, lines": lines(product),
        "of them code": sum(map(code, product.values())),
        "Python, files": len(product),
        "of them in chapters": len(chapters),
        "JavaScript, lines": lines(texts(root / PACKAGE, ".js")),
        "tests, lines": lines(tests),
        "of them support": lines(texts(root / "tests" / "support", ".py")),
        "rooms at the top": len(rooms),
        "fields of Chapter": fields_of(declared, "Chapter"),
        "files in circles": sum(map(len, found)),
        "lines before the first of substance": sum(map(before_substance, product.values())),
        "a file, median": statistics.median(len(t.splitlines()) for t in product.values()),
        "a function, median": statistics.median(functions(product)),
        "a line, median": statistics.median(long),
    }


def main() -> None:
    """Print a table, a column a checkout."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("roots", nargs="*", type=Path, default=[ROOT])
    roots = parser.parse_args().roots
    columns = [weighed(root.resolve()) for root in roots]
    print("| what |", " | ".join(map(str, roots)), "|")
    print("|---|" + "---:|" * len(roots))
    for name in columns[0]:
        print(f"| {name} |", " | ".join(f"{one[name]:,.0f}" for one in columns), "|")


if __name__ == "__main__":
    main()
