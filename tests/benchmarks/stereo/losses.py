"""Tables of what goes wrong, by scene."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from tests.benchmarks.pages import Figures, table
from tests.benchmarks.stereo import words
from tests.benchmarks.stereo.loss_context import CLOSE, WHERE
from tests.benchmarks.stereo.pictures import caption
from tests.benchmarks.stereo.reasons import WHAT
from tracking.synthesis import SCENES


def written(figures: Figures) -> str:
    """The section: what and where, a line a scene, and pictures of one or two."""
    people = figures["people"]
    where = _that_happen(people, "where", WHERE)
    beside = words.BESIDE.strip() if CLOSE in where else ""
    parts = [
        words.LOST.strip(),
        by_scene(people, "what", WHAT),
        meanings(_that_happen(people, "what", WHAT)),
        words.WHERE.format(beside=beside).strip().replace("  ", " "),
        by_scene(people, "where", WHERE),
    ]
    parts = [part for part in parts if part]
    if figures["shown"]:
        captions = " ".join(caption(one) for one in figures["shown"])
        parts.append(words.PICTURE.format(captions=captions).strip())
    return "\n\n".join(parts)


def by_scene(people: Figures, named: str, kinds: Sequence[str]) -> str:
    """How many of each kind, of those kinds that happen at all; people by scene."""
    happens = _that_happen(people, named, kinds)
    rows = []
    for scene, not_kept in people.items():
        often = Counter(row[named] for row in not_kept)
        counts = [str(often[kind] or "") for kind in happens]
        rows.append([SCENES[scene].title.lower(), str(len(not_kept)), *counts])
    return table(("scene", "not kept", *happens), rows)


def meanings(kinds: Sequence[str]) -> str:
    """What some kinds of failure mean, a line each; "" for none."""
    return "\n".join(f"- {what}: {words.MEANINGS[what]}" for what in kinds)


def _that_happen(people: Figures, named: str, kinds: Sequence[str]) -> list[str]:
    found = {row[named] for rows in people.values() for row in rows}
    return [kind for kind in kinds if kind in found]
