"""Keyword arguments from and to what the command line calls its options."""

from __future__ import annotations

import numpy as np

from . import _aomd

_TABLE = {entry["name"].replace("-", "_"): entry for entry in _aomd.decimate_options()}

#: Options of `aomd decimate` that say where its words go. A program gets a mesh and notes instead.
_WITHOUT_USE = ("format", "quiet", "blocks", "pieces")


def decimate_options() -> list[dict]:
    """The options of `decimate`, which are those of `aomd decimate`.

    Each is a dictionary: `name` (of the keyword argument), `flag` (whether it is True or False),
    `value` (what it takes, such as "DEG"), `default`, `group` and `help`.
    """
    return [{**entry, "name": name} for name, entry in _TABLE.items() if name not in _WITHOUT_USE]


def _text(value) -> str:
    if isinstance(value, (list, tuple)):
        return ",".join(map(str, value))
    return str(value)


def _word(name: str, value) -> str | None:
    option = "--" + name.replace("_", "-")
    if value is None or value is False:
        return None
    if value is True:
        return option if _TABLE[name]["flag"] else option + "=0" if name == "weld" else None
    if _TABLE[name]["flag"]:
        raise TypeError(f"{name} is True or False, not {value!r}")
    return f"{option}={_text(value)}"


def _is_array(value) -> bool:
    return isinstance(value, (list, tuple, np.ndarray))


def told(function: str, options: dict) -> tuple[list[str], object, object]:
    """The words of the command line, and the arrays for `keep` and `spacing` beside them."""
    arrays = {name: options.pop(name) for name in ("keep", "spacing")
              if _is_array(options.get(name))}
    for name in options:
        if name not in _TABLE or name in _WITHOUT_USE:
            raise TypeError(f"{function}() has no option {name!r}: decimate_options() lists them")
    words = [_word(name, value) for name, value in options.items()]
    return [word for word in words if word is not None], arrays.get("keep"), arrays.get("spacing")
