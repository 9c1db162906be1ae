"""What files of other tools say of whole tracks, put into lines this program keeps."""

from __future__ import annotations

from collections.abc import Mapping

from tracking.tracks import LONGEST_NAME, TrackLabel

PERSON = "person"
CLASS = "class"
"""The attribute that says what kind of thing a track is; a person's has none."""

_MOST_ATTRIBUTES = 64
_OF_PEOPLE = frozenset({"", "person", "pedestrian", "people", "human"})


def label_of(
    name: str = "", kind: str = "", attributes: Mapping[str, str] | None = None
) -> TrackLabel:
    """The label of a track: one line each, however long or odd the file's texts are.

    Args:
        name: of the person. kind: what kind of thing it is; nothing is kept of people's.
        attributes: further ones; those beyond `_MOST_ATTRIBUTES` are left out.
    """
    kept = {line(key): line(value) for key, value in list((attributes or {}).items())}
    kept = {key: value for key, value in kept.items() if key and value}
    if line(kind).lower() not in _OF_PEOPLE:
        kept = {CLASS: line(kind), **kept}
    return TrackLabel(line(name), dict(list(kept.items())[:_MOST_ATTRIBUTES]))


def kind_of(label: TrackLabel) -> str:
    """What kind of thing a track is, as other tools call it."""
    return line(label.attributes.get(CLASS, "")) or PERSON


def is_person(label: TrackLabel) -> bool:
    """Whether a track is of a person, as far as its label says."""
    return label.attributes.get(CLASS, "").strip().lower() in _OF_PEOPLE


def left_out(count: int, one: str, many: str) -> str:
    """A note that so many things of a file are not taken."""
    return f"1 {one} is left out" if count == 1 else f"{count} {many} are left out"


def line(text: object) -> str:
    """A text as one line of printable signs, at most as long as names are."""
    signs = " ".join(str(text)[: 8 * LONGEST_NAME].split())
    return "".join(sign for sign in signs if sign.isprintable())[:LONGEST_NAME].strip()
