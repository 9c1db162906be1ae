"""What each cue did, person by person, in sentences."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise

from tests.benchmarks.pages import Figures
from tests.benchmarks.stereo import reasons
from tests.benchmarks.stereo.columns import COLOUR, CUES, DIRECTION
from tracking.synthesis import SCENES

_NAMED = {COLOUR: "colour", DIRECTION: "direction"}

_HAPPENED = {
    reasons.SWAPPED: "exchanged tracks with somebody",
    reasons.TAKEN: "shared a track that went from one person to another",
    reasons.INHERITED: "got the track of somebody gone or lost",
    reasons.FALSE: "counted for a moment under a track that stood on somebody else",
    reasons.DOUBLED: "changed to a second track",
    reasons.RENAMED: "came back under a new id",
    reasons.LOST: "followed for less than half of the time",
    reasons.NEVER: "never detected",
}


def sentences(figures: Figures) -> Iterator[str]:
    """A sentence for each scene and cue that did not raise the share of people kept."""
    for scene, columns in figures.items():
        for before, after in pairwise(CUES):
            if _share(columns[after]) <= _share(columns[before]):
                title = SCENES[scene].title
                yield f"{title}, {_NAMED[after]}: {_why(columns[before], columns[after])}"


def _share(column: Figures) -> float:
    return len(column["kept"]) / max(len(column["detected"]), 1)


def _why(before: Figures, after: Figures) -> str:
    """What became of the people that only one of the two columns keeps, and of the rest."""
    gained = set(after["kept"]) - set(before["kept"])
    spoilt = set(before["kept"]) - set(after["kept"])
    rest = [row for row in after["not_kept"] if row["name"] not in spoilt]
    if not gained and not spoilt:
        return f"it changed nothing. {_of_the_rest(rest)}"
    worse = [row for row in after["not_kept"] if row["name"] in spoilt]
    found = f"it kept {len(gained)} of those not kept without it, lost {len(spoilt)} of the kept"
    told = f" ({happened(worse)})" if worse else ""
    return f"{found}{told}. {_of_the_rest(rest)}"


def _of_the_rest(rows: Sequence[Figures]) -> str:
    if not rows:
        return "Nobody is left whom it could keep."
    return f"Kept neither way: {happened(rows)}."


def happened(rows: Sequence[Figures]) -> str:
    """What went wrong first for some people and where, the most frequent first."""
    often = Counter(row["what"] for row in rows)
    told = []
    for what, number in often.most_common():
        places = Counter(row["where"] for row in rows if row["what"] == what)
        where = ", ".join(f"{n} {place}" for place, n in places.most_common())
        told.append(f"{number} {_HAPPENED[what]}: {where}")
    return "; ".join(told)
