"""What a person wrote into a recording.toml, kept where it is written anew."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

_TABLE = re.compile(r"^\s*(\[{1,2}[^\[\]]+\]{1,2})\s*(#.*)?$")
_KEY = re.compile(r"^\s*([A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*')\s*[=.]")
_TABLES = {"left", "right", "depth", "stereo", "calibration", "ground", "region"}
_OURS = {
    "": {"format", "name", "fps", *_TABLES},
    "[left]": {"source", "topic"},
    "[right]": {"source", "topic", "lag"},
    "[depth]": {"source", "topic", "scale"},
    "[stereo]": {"source", "layout", "first", "lag"},
    "[calibration]": {"file"},
    "[ground]": {"height", "tilt", "roll", "R", "t"},
    "[region]": {"look", "mask"},
}
"""Keys that are written anew; all else is somebody's own.

A table may be written as a key, `left = { ... }` or `ground.height = ...`: it is written anew, too.
"""


@dataclass(slots=True)
class _Part:
    """A table's lines: its heading ("" for what stands before any), comments above, the rest."""

    heading: str
    line: str = ""
    above: list[str] = field(default_factory=list)
    inside: list[list[str]] = field(default_factory=list)
    """A key with the lines of its value, or a comment, or an empty line, each."""


def with_old_text(new: str, old: str, headings: Mapping[str, str]) -> str:
    """The new text with the old one's comments, unknown keys and unknown tables.

    Args:
        new: as `format_manifest` makes it. old: TOML that was read. headings: comments over tables
            that the old text has not.
    """
    kept = {part.heading: part for part in _parts(old)}
    lines: list[str] = []
    for part in _parts(new):
        before = kept.pop(part.heading, None)
        if before is not None and before.above:
            lines += before.above
        elif before is None and part.heading in headings:
            lines.append(headings[part.heading])
        if part.heading:
            lines.append(before.line if before is not None else part.line)
        lines += _body(part, before)
        lines.append("")
    for part in kept.values():
        lines += [*_left_over(part), ""]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip("\n") + "\n"


def _body(part: _Part, before: _Part | None) -> list[str]:
    """The new values at the places of the old ones, with what stands around these."""
    if before is None:
        return [line for item in part.inside for line in item]
    new = {_key(item): item for item in part.inside if _key(item)}
    lines: list[str] = []
    for item in before.inside:
        key = _key(item)
        if key in _OURS.get(part.heading, set()):
            lines += _with_comment(new.pop(key, []), item)
        else:
            lines += item
    while lines and not lines[-1].strip():
        lines.pop()
    return [*lines, *(line for item in new.values() for line in item)]


def _with_comment(new: list[str], old: list[str]) -> list[str]:
    """The new value with the comment behind the old one, where both are a line each."""
    _, sign, comment = _cut(old[-1])
    if len(new) != 1 or len(old) != 1 or not sign:
        return new
    return [f"{new[0]}  #{comment}"]


def _left_over(part: _Part) -> list[str]:
    """The lines of a table that the new text has not.

    Of one of ours only somebody's own keys, as comments: by itself the table could not be read.
    """
    if part.heading not in _OURS:
        return [*part.above, part.line, *(line for item in part.inside for line in item)]
    own = [item for item in part.inside if _key(item) and _key(item) not in _OURS[part.heading]]
    return [f"# {part.heading} {line}" for item in own for line in item]


def _key(item: list[str]) -> str:
    found = _KEY.match(item[0])
    return found.group(1).strip("\"'") if found else ""


def _parts(text: str) -> list[_Part]:
    parts = [_Part("")]
    waiting: list[str] = []
    for item in _items(text):
        table = _TABLE.match(item[0]) if len(item) == 1 else None
        if table is not None:
            # A comment right above a table belongs to it.
            inside = parts[-1].inside
            while inside and inside[-1][0].lstrip().startswith("#") and parts[-1].inside:
                waiting.insert(0, inside.pop()[0])
            parts.append(_Part(table.group(1).replace(" ", ""), item[0], waiting))
            waiting = []
        else:
            parts[-1].inside.append(item)
    return parts


def _items(text: str) -> Iterator[list[str]]:
    """Lines, those of one value together."""
    item: list[str] = []
    depth, quoted = 0, ""
    for line in text.splitlines():
        item.append(line)
        if not depth and not quoted and _TABLE.match(line):
            yield item
            item = []
            continue
        depth, quoted = _state(line, depth, quoted)
        if depth <= 0 and not quoted:
            yield item
            item, depth = [], 0
    if item:
        yield item


def _state(line: str, depth: int, quoted: str) -> tuple[int, str]:
    """Open brackets, and the quotes of a text that goes on in the next line."""
    rest = line
    while rest:
        if quoted:
            _, sign, rest = rest.partition(quoted)
            quoted = "" if sign else quoted
            continue
        found = re.search(r'"""|\'\'\'|"(?:[^"\\]|\\.)*"|\'[^\']*\'|[\[\]{}#]', rest)
        if found is None or found.group() == "#":
            break
        sign, rest = found.group(), rest[found.end() :]
        depth += (sign in "[{") - (sign in "]}") if len(sign) == 1 else 0
        quoted = sign if sign in ('"""', "'''") else ""
    return depth, quoted


def _cut(line: str) -> tuple[str, str, str]:
    """A line before and behind the sign of its comment."""
    bare = re.sub(r'"(?:[^"\\]|\\.)*"|\'[^\']*\'', lambda text: "x" * len(text.group()), line)
    place = bare.find("#")
    return (line, "", "") if place < 0 else (line[:place], "#", line[place + 1 :])
