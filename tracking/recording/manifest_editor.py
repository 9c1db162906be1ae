"""Values put into a recording.toml that is somebody's own text; everything else stays."""

from __future__ import annotations

import re
from collections.abc import Mapping

_VALUE = r"""("(?:[^"\\]|\\.)*"|'[^']*'|\[[^\]]*\]|[^#\s]+)"""
_ANY_TABLE = re.compile(r"^\s*\[")


def with_values(text: str, values: Mapping[tuple[str, str], str]) -> str:
    """The text with values of keys, each by its table and its name; comments stay.

    Args:
        values: as TOML writes them. A key that is not there is added, and so is a table.

    Who writes the result reads it first: a text may hold what no line says.
    """
    lines = text.rstrip("\n").split("\n")
    for (table, key), value in values.items():
        lines = _with_value(lines, table, key, value)
    return "\n".join(lines) + "\n"


def _with_value(lines: list[str], table: str, key: str, value: str) -> list[str]:
    header = re.compile(rf"^\s*\[\s*{re.escape(table)}\s*\]\s*(#.*)?$")
    begin = next((row for row, line in enumerate(lines) if header.match(line)), None)
    if begin is None:
        return [*lines, "", f"[{table}]", f"{key} = {value}"]
    said = re.compile(rf"^(\s*{re.escape(key)}\s*=\s*){_VALUE}(.*)$")
    for row in range(begin + 1, len(lines)):
        if _ANY_TABLE.match(lines[row]):
            break
        if found := said.match(lines[row]):
            return [*lines[:row], f"{found[1]}{value}{found[3]}", *lines[row + 1 :]]
    return [*lines[: begin + 1], f"{key} = {value}", *lines[begin + 1 :]]
