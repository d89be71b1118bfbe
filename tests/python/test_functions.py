"""What the public headers declare can be reached from Python, or functions.txt says why not."""

import functools
import pathlib
import re

import pytest

import aomd

CORE = pathlib.Path(__file__).parents[2] / "core"
TABLE = pathlib.Path(__file__).with_name("functions.txt")

SCOPE = re.compile(r"\s*(?:template\s*<[^{]*>\s*)?(?:inline\s+)?(namespace|class|struct|enum|extern)\b"
                   r"\s*(?:class\s+)?(?:\[\[.*?\]\]\s*)?([\w:]*)")


def headers():
    """Those that are meant to be included, as core/CMakeLists.txt lists them."""
    text = (CORE / "CMakeLists.txt").read_text()
    listed = text[text.index("# To be included"):text.index("# What these need")]
    return re.findall(r"[\w/]+\.h", listed)


def code_of(header):
    """Without comments, texts and lines of the preprocessor."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", (CORE / header).read_text(), flags=re.S)
    text = re.sub(r'"(?:\\.|[^"\\])*"', '""', text)
    return re.sub(r"^\s*#(?:.*\\\n)*.*$", "", text, flags=re.M)


def without_template(statement):
    """Without `template <...>` at its beginning."""
    while re.match(r"\s*template\s*<", statement):
        depth = 0
        for end in range(statement.index("<"), len(statement)):
            depth += (statement[end] == "<") - (statement[end] == ">")
            if depth == 0:
                break
        statement = statement[end + 1:]
    return statement


def name_of(statement):
    """The name of the function that a statement declares; None where it declares none."""
    statement = without_template(re.sub(r"\[\[[^\]]*\]\]", "", statement))
    found = re.match(r"[^(=]*?([\w~]+)\s*\(", statement)
    if not found or "operator" in statement.split("(")[0] or found[1].startswith("~"):
        return None
    other = re.match(r"\s*(friend|using|typedef|static_assert)\b", statement)
    return None if other else found[1]


class Reader:
    """Finds the public functions of a header, constructors and operators left out."""

    def __init__(self, header):
        self.names, self.scopes, self.statement, parens = set(), [], "", 0
        for sign in code_of(header):
            parens += (sign == "(") - (sign == ")")
            if parens == 0 and sign in "{};:":
                self.at(sign)
            else:
                self.statement += sign

    def at(self, sign):
        if sign == ":":
            if re.fullmatch(r"\s*(public|private|protected)\s*", self.statement):
                self.scopes[-1][2], self.statement = self.statement.strip(), ""
            else:
                self.statement += sign
            return
        if sign == "{":
            self.open()
        elif sign == "}":
            self.scopes.pop()
        else:
            self.take()
        self.statement = ""

    def open(self):
        found = SCOPE.match(self.statement)
        kind = found[1] if found else "block"
        if kind in ("class", "struct") and "(" not in self.statement:
            self.scopes.append(["class", found[2], "private" if kind == "class" else "public"])
        elif kind in ("namespace", "extern"):
            hidden = found[2].endswith("detail")
            self.scopes.append(["namespace", found[2], "private" if hidden else "public"])
        else:
            self.take()
            self.scopes.append(["block", "", "public"])

    def take(self):
        if any(kind == "block" or access != "public" for kind, _, access in self.scopes):
            return
        name = name_of(self.statement)
        owners = [name for kind, name, _ in self.scopes if kind == "class"]
        if name and name not in owners[-1:]:
            self.names.add("::".join([*owners, name]))


@functools.cache
def table():
    """By header: by function what has it in Python, or None."""
    found, header = {}, None
    for line in TABLE.read_text().splitlines():
        if line.startswith("["):
            header = found.setdefault(line.strip("[]"), {})
        elif line and not line.startswith("#"):
            name, sign, rest = line.split(" ", 2)
            assert sign in "=-" and rest and name not in header, line
            header[name] = rest if sign == "=" else None
    return found


def test_the_reader_knows_functions():
    assert {"Mesh::create_vertex", "Mesh::find_attached", "to_data"} <= Reader("mesh/mesh.h").names
    assert "Mesh::take_list" not in Reader("mesh/mesh.h").names  # private
    assert len(Reader("c/aomd.h").names) == 35  # docs/INSTALL.md


@pytest.mark.parametrize("header", headers())
def test_each_function_of_a_header_stands_in_the_table(header):
    assert set(table().get(header, {})) == Reader(header).names


def test_the_table_has_no_other_headers():
    assert set(table()) <= set(headers())


@pytest.mark.parametrize("name", sorted({name for functions in table().values()
                                         for name in functions.values() if name}))
def test_what_the_table_names_is_there(name):
    thing = functools.reduce(getattr, name.split("."), aomd)
    assert name.split(".")[0] in aomd.__all__ + ["__version__"] and thing is not None


def test_all_of_the_interface_for_c_is_reachable():
    assert all(table()["c/aomd.h"].values())
