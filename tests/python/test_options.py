"""The keyword arguments of decimate are the options of `aomd decimate`; the stub has them all."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import pytest

import aomd

PYTHON = pathlib.Path(__file__).parents[2] / "tools" / "python"


#: What says where words and files of the program go: here a mesh comes back, and its report.
WITHOUT_USE = {"format", "quiet", "blocks", "pieces", "json", "to", "jobs"}


def options_of_program():
    text = subprocess.run([os.environ["AOMD_PROGRAM"], "decimate", "--help"], check=True,
                          capture_output=True, text=True).stdout
    return set(re.findall(r"^  (?:-\w,)?--([a-z-]+)", text, re.M)) - {"help"}


def test_every_option_of_the_program_is_an_argument():
    names = {option["name"].replace("_", "-") for option in aomd.decimate_options()}
    assert names == options_of_program() - WITHOUT_USE


def test_other_arguments_are_refused():
    with pytest.raises(TypeError, match=r"decimate\(\) has no option 'target'"):
        aomd.decimate(aomd.sample("sphere"), target=3)
    with pytest.raises(TypeError, match="no option 'quiet'"):
        aomd.decimate(aomd.sample("sphere"), quiet=True)
    with pytest.raises(TypeError, match="no_swap is True or False, not 3"):
        aomd.decimate(aomd.sample("sphere"), no_swap=3)


@pytest.mark.parametrize("options, words", [
    ({"factor": -1}, "--factor: must be a number above 0, not -1"),
    ({"target_faces": "many"}, "--target-faces: must be a whole number from 1 to 4294967294, or a "
                               "share such as 10%, not many"),
    ({"strategy": "best"}, "--strategy: "),
    ({"target_tets": 5}, "--target-tets is for volumes, and mesh has no regions"),
    ({"factor": 2, "coarsest": True}, "excludes"),
    ({"spacing": "x +"}, "--spacing: "),
])
def test_values_that_make_no_sense_are_refused_in_the_words_of_the_program(options, words):
    with pytest.raises(aomd.UsageError) as error:
        aomd.decimate(aomd.sample("sphere"), **options)
    assert words in str(error.value) and error.value.exit_code == 2
    assert isinstance(error.value, ValueError)


def test_the_stub_is_what_its_maker_makes():
    made = subprocess.run([sys.executable, "-B", PYTHON / "stubs.py"], check=True,
                          capture_output=True, text=True).stdout
    assert (PYTHON / "package" / "__init__.pyi").read_text() == made


def test_the_stub_has_every_public_name_and_option():
    tree = ast.parse((PYTHON / "package" / "__init__.pyi").read_text())
    names = {node.name for node in tree.body if hasattr(node, "name")}
    assert set(aomd.__all__) <= names
    decimate = next(node for node in tree.body if getattr(node, "name", "") == "decimate")
    arguments = {argument.arg for argument in decimate.args.kwonlyargs}
    assert {option["name"] for option in aomd.decimate_options()} | {"progress"} == arguments


def public_members():
    """What has a docstring of its own."""
    for name in aomd.__all__:
        thing = getattr(aomd, name)
        if inspect.isclass(thing) and issubclass(thing, Exception):
            continue
        yield name, thing
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            documented = callable(value) or isinstance(value, (property, classmethod))
            if documented and not member.startswith("_"):
                yield f"{name}.{member}", value


@pytest.mark.parametrize("name, thing", public_members())
def test_everything_says_what_it_is(name, thing):
    text = inspect.getdoc(thing) or ""
    assert len(text.split()) > 2 and "." in text, name
