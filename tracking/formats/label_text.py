"""What files of other tools say of whole tracks, put into lines this program keeps."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from tracking.tracks import LONGEST_NAME, LONGEST_VALUE, TrackLabel
from tracking.translation import Message, msg

PERSON = "person"
CLASS = "class"
"""The attribute that says what kind of thing a track is; a person's has none."""

_MOST_ATTRIBUTES = 64
_OF_PEOPLE = frozenset({"", "person", "pedestrian", "people", "human"})
_ESCAPED = "20|25|3A"
"""Signs that stand in keys as URLs have them: a blank, % itself and a colon."""


def label_of(
    name: str = "", kind: str = "", attributes: Mapping[str, str] | None = None
) -> TrackLabel:
    """The label of a track: one line each, however long or odd the file's texts are.

    Args:
        name: of the person. kind: what kind of thing it is; nothing is kept of people's.
        attributes: further ones; those beyond `_MOST_ATTRIBUTES` are left out.
    """
    kept = _lines(attributes or {})
    if line(kind).lower() not in _OF_PEOPLE:
        kept = {CLASS: line(kind), **kept}
    return TrackLabel(line(name), dict(list(kept.items())[:_MOST_ATTRIBUTES]))


def attributes_of(label: TrackLabel) -> dict[str, str]:
    """All attributes of a label but its class, one line each; those without text are left out."""
    return _lines({key: text for key, text in label.attributes.items() if key != CLASS})


def label_as_read(label: TrackLabel) -> TrackLabel:
    """What comes back of a label whose `kind_of`, name and `attributes_of` a file holds."""
    return label_of(label.name, kind_of(label), attributes_of(label))


def key_beside(own: Collection[str], key: str) -> str:
    """An attribute's key where a format has keys of its own: `_` stands behind one like these."""
    return f"{key}_" if key.rstrip("_") in own else key


def key_of(own: Collection[str], written: str) -> str:
    """What `key_beside` was given."""
    return written[:-1] if written.endswith("_") and written.rstrip("_") in own else written


def escaped(key: str, signs: str) -> str:
    """A key in which nothing fits `signs`, a pattern of one blank or colon: as URLs have them."""
    return re.sub(rf"%(?={_ESCAPED})|{signs}", lambda found: f"%{ord(found[0]):02X}", key)


def unescaped(key: str) -> str:
    """What `escaped` was given."""
    return re.sub(f"%({_ESCAPED})", lambda found: chr(int(found[1], 16)), key)


def kind_of(label: TrackLabel) -> str:
    """What kind of thing a track is, as other tools call it."""
    return line(label.attributes.get(CLASS, "")) or PERSON


def is_person(label: TrackLabel) -> bool:
    """Whether a track is of a person, as far as its label says."""
    return label.attributes.get(CLASS, "").strip().lower() in _OF_PEOPLE


def left_out(count: int, one: str, many: str) -> Message:
    """A note that so many things of a file are not taken."""
    return (
        msg("1 {one} is left out", one=one)
        if count == 1
        else msg("{count} {many} are left out", count=count, many=many)
    )


def line(text: object, longest: int = LONGEST_NAME) -> str:
    """A text as one line of printable signs, at most as long as names are."""
    signs = " ".join(str(text)[: 8 * longest].split())
    return "".join(sign for sign in signs if sign.isprintable())[:longest].strip()


def _lines(attributes: Mapping[str, str]) -> dict[str, str]:
    kept = {line(key): line(text, LONGEST_VALUE) for key, text in attributes.items()}
    return {key: text for key, text in kept.items() if key and text}
