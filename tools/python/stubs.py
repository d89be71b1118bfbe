#!/usr/bin/env python3
"""stubs.py: prints package/__init__.pyi, made from package/__init__.py and the options of `aomd decimate`.

It imports aomd, which therefore must be built: PYTHONPATH=build/python tools/python/stubs.py.
"""

import ast
import pathlib

import aomd

PACKAGE = pathlib.Path(__file__).parent / "package"
#: What the values of options are, by how the help calls them.
TYPES = {"N": "int", "F": "float", "W": "float", "G": "float", "DEG": "float", "PCT": "float",
         "N|P%": "int | str", "DEG|off": "float | str", "[TOL|P%]": "bool | float | str",
         "FILE": "str | os.PathLike", "IDEA,...": "str | Sequence[str]",
         "NAME[=WEIGHT],...|none": "str | Sequence[str]",
         "FILE|EXPR|curvature|surface": "str | os.PathLike | np.ndarray"}


def type_of(option):
    if option["name"] == "keep":
        return "str | os.PathLike | np.ndarray | Sequence[int]"
    if option["flag"]:
        return "bool"
    words = ", ".join(map(repr, option["value"].split("|")))
    return TYPES.get(option["value"], f"Literal[{words}]")


def with_options(function):
    """The keyword arguments that **options stands for."""
    for option in aomd.decimate_options():
        function.args.kwonlyargs.append(
            ast.arg(option["name"], ast.parse(type_of(option) + " | None", mode="eval").body))
        function.args.kw_defaults.append(ast.Constant(None))
    function.args.kwarg = None


def without_body(node):
    """Documentation, signatures and fields alone."""
    if isinstance(node, ast.ClassDef):
        node.body = [without_body(each) for each in node.body if wanted(each)]
    elif isinstance(node, ast.FunctionDef):
        if node.args.kwarg:
            with_options(node)
        text = ast.get_docstring(node, clean=False)
        node.body = [ast.Expr(ast.Constant(text if text else ...))]
    return node


def wanted(node):
    if isinstance(node, ast.FunctionDef):
        return not node.name.startswith("_") or node.name in ("__init__", "_repr_png_")
    return isinstance(node, (ast.ClassDef, ast.AnnAssign, ast.Expr))


def errors():
    """One class for each kind of failure."""
    yield "class Error(Exception):\n    exit_code: int\n"
    for name in aomd.__all__:
        kind = getattr(aomd, name)
        if isinstance(kind, type) and issubclass(kind, aomd.Error) and kind is not aomd.Error:
            bases = ", ".join(base.__name__ for base in kind.__bases__)
            yield f"class {name}({bases}): ...\n"


def definitions(file):
    """The public classes and functions of a file."""
    for node in ast.parse((PACKAGE / file).read_text()).body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and node.name in aomd.__all__:
            yield ast.unparse(without_body(node)) + "\n"


def stub():
    parts = ["# Made by tools/python/stubs.py.\nimport dataclasses\nimport os\n"
             "from typing import Callable, Literal, Mapping, Sequence\n\nimport numpy as np\n\n"
             "__version__: str\nProgress = Callable[[str, float | None], bool | None]\n",
             *errors(), *definitions("options.py"), *definitions("__init__.py")]
    return "\n".join(parts)


if __name__ == "__main__":
    print(stub(), end="")
