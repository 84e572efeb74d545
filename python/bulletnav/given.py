# SPDX-License-Identifier: MIT
"""Arguments as the extension takes them; what is none of them raises Error, in one line."""
import json
import operator
import os

from bulletnav import _core


def _shown(value):
    text = repr(value).replace("\n", " ")
    return text if len(text) < 80 else text[:76] + " ..."


def _refuse(value, rule):
    return _core.Error(f"bulletnav {rule}, not {_shown(value)}")


def path(value, rule):
    """A path as a str. `rule`: "CALL: what it takes", for the complaint."""
    try:
        text = os.fspath(value)
    except TypeError:
        raise _refuse(value, rule) from None
    return os.fsdecode(text)


def whole(value, rule, least=0, most=2**31 - 1):
    """A whole number of any kind (numpy's too) as an int."""
    try:
        number = operator.index(value)
    except TypeError:
        raise _refuse(value, rule) from None
    if not least <= number <= most:
        raise _refuse(value, rule)
    return number


def seed(value, call):
    return whole(value, f"{call}: a seed is a whole number from 0 on", most=2**64 - 1)


def numbers(value, size, rule):
    """`size` numbers, from any sequence or array, as floats."""
    try:
        row = [float(number) for number in value]
    except (TypeError, ValueError):
        row = []
    if len(row) != size or isinstance(value, (str, bytes, dict)):
        raise _refuse(value, rule)
    return row


def point(value, call):
    return numbers(value, 3, f"{call}: a point is [x, y, z], metres")


def _plain(value):
    """What JSON can say of an argument."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError


def config(options, call, plain=_plain):
    """Arguments by name as JSON. `import_` is `import`, a word of Python's own without the line.
    `plain`: for what JSON does not know; raises TypeError where it does not, either."""
    options = dict(options)
    if "import_" in options:
        if "import" in options:
            raise _core.Error(f"bulletnav {call}: give import_ or import, not both")
        options["import"] = options.pop("import_")
    for name, value in options.items():
        try:
            json.dumps(value, default=plain)
        except (TypeError, ValueError):
            raise _core.Error(f"bulletnav {call}: {name}={_shown(value)} cannot be an argument; "
                              "give plain values, lists and dicts") from None
    return json.dumps(options, default=plain)
