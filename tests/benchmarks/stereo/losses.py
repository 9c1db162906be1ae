"""Tables of what goes wrong, by scene."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from tests.benchmarks.pages import Figures, table
from tests.benchmarks.stereo import words
from tests.benchmarks.stereo.circumstance import WHERE
from tests.benchmarks.stereo.pictures import caption
from tests.benchmarks.stereo.reasons import WHAT
from tracking.synthesis import SCENES


def written(figures: Figures) -> str:
    """The section: what and where, a line a scene, and pictures of one or two."""
    people = figures["people"]
    meanings = "\n".join(f"- {what}: {words.MEANINGS[what]}" for what in WHAT)
    parts = [
        words.LOST.format(meanings=meanings).strip(),
        by_scene(people, "what", WHAT),
        words.WHERE.strip(),
        by_scene(people, "where", WHERE),
    ]
    if figures["shown"]:
        captions = " ".join(caption(one) for one in figures["shown"])
        parts.append(words.PICTURE.format(captions=captions).strip())
    return "\n\n".join(parts)


def by_scene(people: Figures, named: str, kinds: Sequence[str]) -> str:
    """How many of each kind, of those kinds that happen at all; people by scene."""
    happens = [
        kind
        for kind in kinds
        if any(row[named] == kind for rows in people.values() for row in rows)
    ]
    rows = []
    for scene, not_kept in people.items():
        often = Counter(row[named] for row in not_kept)
        counts = [str(often[kind] or "") for kind in happens]
        rows.append([SCENES[scene].title.lower(), str(len(not_kept)), *counts])
    return table(("scene", "not kept", *happens), rows)
