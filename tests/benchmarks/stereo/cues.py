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

_DECIDED = (reasons.SWAPPED, reasons.TAKEN, reasons.DOUBLED)
"""Which track gets which detection: all that a cue has a say in."""


def sentences(figures: Figures) -> Iterator[str]:
    """A sentence for each scene and cue that did not raise the share of people kept."""
    for scene, after, without, with_it in _without_gain(figures):
        kept = f"{len(without['kept'])} kept without it, {len(with_it['kept'])} with it"
        by_place = " and ".join(str(len(one["kept_by_place"])) for one in (without, with_it))
        of = f"of {len(with_it['detected'])} (by place {by_place})"
        said = f"**{SCENES[scene].title}, {_NAMED[after]}**: {kept}, {of}."
        yield f"{said} {_what_changed(without, with_it)}"


def to_explain(figures: Figures) -> tuple[str, ...]:
    """What went wrong through cues, the most frequent first, and with those not kept either way."""
    often: Counter[str] = Counter()
    for _, _, without, with_it in _without_gain(figures):
        spoilt, rest = _apart(without, with_it)
        often.update(row["what"] for row in spoilt)
        if any(row["what"] not in _DECIDED for row in rest):
            often[reasons.FALSE] += 0
    kinds = [_KIND.get(what, what) for what, _ in often.most_common()]
    return tuple(dict.fromkeys(kind for kind in kinds if kind in EXPLAINED))


EXPLAINED = (reasons.DOUBLED, reasons.SWAPPED, reasons.FALSE)
_KIND = {reasons.TAKEN: reasons.SWAPPED, reasons.RENAMED: reasons.FALSE}
_KIND |= dict.fromkeys((reasons.INHERITED, reasons.LOST, reasons.NEVER), reasons.FALSE)
"""Kinds that have a reason in common with another one."""


def _without_gain(figures: Figures) -> Iterator[tuple[str, str, Figures, Figures]]:
    """Scene, cue, and the columns without and with it."""
    for scene, columns in figures.items():
        for before, after in pairwise(CUES):
            if _share(columns[after]) <= _share(columns[before]):
                yield scene, after, columns[before], columns[after]


def _share(column: Figures) -> float:
    return len(column["kept"]) / max(len(column["detected"]), 1)


def _apart(without: Figures, with_it: Figures) -> tuple[list[Figures], list[Figures]]:
    """Those not kept with a cue: who had been kept without it, and the rest."""
    kept = set(without["kept"])
    rows = with_it["not_kept"]
    spoilt = [row for row in rows if row["name"] in kept]
    return spoilt, [row for row in rows if row["name"] not in kept]


def _what_changed(without: Figures, with_it: Figures) -> str:
    """What became of the people that only one of the two columns keeps, and of the rest."""
    gained = len(set(with_it["kept"]) - set(without["kept"]))
    spoilt, rest = _apart(without, with_it)
    if not gained and not spoilt:
        said = "It changed nobody's lot."
    else:
        lost = f"{len(spoilt)} ({happened(spoilt)})" if spoilt else "nobody"
        said = f"It won {gained or 'nobody'} and lost {lost}."
    return f"{said} {_of_the_rest(rest)}"


def _of_the_rest(rows: Sequence[Figures]) -> str:
    """How many of those not kept either way a cue might have helped."""
    if not rows:
        return "Nobody is left whom it could keep."
    decided = sum(row["what"] in _DECIDED for row in rows)
    often = Counter(row["what"] for row in rows).most_common()
    kinds = ", ".join(f"{number} {what}" for what, number in often)
    yes = f"{decided or 'none'} of them a cue's to decide"
    return f"Not kept either way: {len(rows)} ({kinds}), {yes}."


def happened(rows: Sequence[Figures]) -> str:
    """What went wrong first for some people and where, the most frequent first."""
    often = Counter((row["what"], row["where"]) for row in rows)
    return "; ".join(f"{number} {what}, {where}" for (what, where), number in often.most_common())


def words_used(figures: Figures) -> tuple[str, ...]:
    """What goes wrong in the sentences, and what a cue decides, in the order of `reasons.WHAT`."""
    used = {
        row["what"] for _, _, _, with_it in _without_gain(figures) for row in with_it["not_kept"]
    }
    return tuple(what for what in reasons.WHAT if what in used or what in _DECIDED)
