"""Sentences on both papers' tables: their methods as we built them, cue by cue, beside ours."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise

from tests.benchmarks.intervals import interval
from tests.benchmarks.pages import Figures, titled
from tests.benchmarks.stereo import reasons
from tests.benchmarks.stereo.clips import COLOUR, CUES, DIRECTION, OWN
from tracking.synthesis import SCENES

PAPER = {
    "indoor": (87.5, 92.5, None),
    "outdoor": (81.5, 88.0, None),
    "lobby": (None, 88.0, 90.0),
    "plaza": (None, 88.0, 94.0),
    "square": (None, 86.0, 92.0),
}
"""[Kawashita2012] and [Kawashita2014]: distance; with colour; with direction; in per cent."""
_NOTHING = (None,) * len(CUES)

_NAMED = {COLOUR: "colour", DIRECTION: "direction"}
_DECIDED = (reasons.SWAPPED, reasons.TAKEN, reasons.DOUBLED)
"""Which track gets which detection: all that a cue has a say in."""
_EXPLAINED = {
    **dict.fromkeys((reasons.SWAPPED, reasons.TAKEN), reasons.SWAPPED),
    reasons.DOUBLED: reasons.DOUBLED,
    **dict.fromkeys(
        (reasons.FALSE, reasons.INHERITED, reasons.RENAMED, reasons.LOST, reasons.NEVER),
        reasons.FALSE,
    ),
}
"""Kinds of failure by the one they have an explanation in common with."""


def percent(column: Figures, ending: str = "") -> float:
    """Tracking accuracy in per cent; ending: "_by_place", or "" by box."""
    return 100 * len(column[f"kept{ending}"]) / max(len(column[f"detected{ending}"]), 1)


def paper(scene: str, column: int) -> str:
    """The paper's figure beside one of our columns; "" where there is none."""
    value = (*PAPER.get(scene, _NOTHING), None)[column]
    return "" if value is None else f"{value:g}"


def summary(figures: Figures) -> str:
    """How the papers' methods and our tracker stand to the papers' figures; "" without any."""
    pairs = [*_pairs(figures)]
    if not pairs:
        return ""
    by_box, by_place = (
        sum(percent(column, ending) >= paper for _, _, column, paper in pairs)
        for ending in ("", "_by_place")
    )
    within = sum(
        paper <= 100 * interval(len(column["kept"]), len(column["detected"]))[1]
        for _, _, column, paper in pairs
    )
    said = (
        f"The papers' methods, as we built them and on our clips, reach the papers' figures in "
        f"{by_box} of {len(pairs)} places where both exist by box ({by_place} by place)"
        f"{_gap(pairs)}. In {within} of them the paper's figure lies within or below our interval."
    )
    return " ".join(part for part in (said, _lost(figures), _ours(figures)) if part)


def _pairs(figures: Figures) -> Iterator[tuple[str, str, Figures, float]]:
    """Scene, cues, our column and the paper's figure, where there is one."""
    for scene, columns in figures.items():
        for name, paper in zip(CUES, PAPER.get(scene, ()), strict=False):
            if paper is not None:
                yield scene, name, columns[name], paper


def _gap(pairs: Sequence[tuple[str, str, Figures, float]]) -> str:
    """The greatest distance below a paper's figure."""
    scene, name, column, paper = max(pairs, key=lambda pair: pair[3] - percent(pair[2]))
    below = paper - percent(column)
    if below <= 0:
        return ""
    return f"; the greatest gap is {below:.1f} points ({titled(scene)}, {name})"


def _lost(figures: Figures) -> str:
    """What went wrong with those whom all cues together do not keep in the papers' scenes."""
    rows = [
        row for scene in figures if scene in PAPER for row in figures[scene][CUES[-1]]["not_kept"]
    ]
    kinds = _kinds(rows)
    return f"Whom {CUES[-1]} cues do not keep there, {len(rows)} people: {kinds}." if rows else ""


def _kinds(rows: Sequence[Figures]) -> str:
    often = Counter(row["what"] for row in rows).most_common()
    return ", ".join(f"{number} {what}" for what, number in often)


def _ours(figures: Figures) -> str:
    """In which scenes our own tracker is above the best the paper has."""
    compared = [scene for scene in figures if scene in PAPER]
    below = [
        scene
        for scene in compared
        if percent(figures[scene][OWN]) <= max(filter(None, PAPER[scene]))
    ]
    number = len(compared)
    every = "the only scene" if number == 1 else f"all {number} scenes"
    where = f"{number - len(below)} of {number} scenes" if below else every
    missed = f", not in {'; '.join(map(titled, below))}" if below else ""
    return f"`{OWN}` is above the paper's best figure in {where}{missed}."


def sentences(figures: Figures) -> Iterator[str]:
    """A sentence for each scene and cue that did not raise the share of people kept."""
    for scene, after, without, with_it in _without_gain(figures):
        kept = f"{len(without['kept'])} kept without it, {len(with_it['kept'])} with it"
        by_place = " and ".join(str(len(one["kept_by_place"])) for one in (without, with_it))
        of = f"of {len(with_it['detected'])} (by place {by_place})"
        said = f"**{SCENES[scene].title}, {_NAMED[after]}**: {kept}, {of}."
        yield f"{said} {_what_changed(without, with_it)}"


def explained(figures: Figures) -> tuple[str, ...]:
    """What went wrong through cues, the most frequent first, and with those not kept either way."""
    often: Counter[str] = Counter()
    for _, _, without, with_it in _without_gain(figures):
        spoilt, rest = _apart(without, with_it)
        often.update(row["what"] for row in spoilt)
        if any(row["what"] not in _DECIDED for row in rest):
            often[reasons.FALSE] += 0
    return tuple(dict.fromkeys(_EXPLAINED[what] for what, _ in often.most_common()))


def words_used(figures: Figures) -> tuple[str, ...]:
    """What goes wrong in the sentences, and what a cue decides, in the order of `reasons.WHAT`."""
    used = {
        row["what"] for _, _, _, with_it in _without_gain(figures) for row in with_it["not_kept"]
    }
    return tuple(what for what in reasons.WHAT if what in used or what in _DECIDED)


def _without_gain(figures: Figures) -> Iterator[tuple[str, str, Figures, Figures]]:
    """Scene, cue, and the columns without and with it."""
    for scene, columns in figures.items():
        for before, after in pairwise(CUES):
            if percent(columns[after]) <= percent(columns[before]):
                yield scene, after, columns[before], columns[after]


def _apart(without: Figures, with_it: Figures) -> tuple[list[Figures], list[Figures]]:
    """Those not kept with a cue: who had been kept without it, and the rest."""
    kept, rows = set(without["kept"]), with_it["not_kept"]
    spoilt = [row for row in rows if row["name"] in kept]
    return spoilt, [row for row in rows if row["name"] not in kept]


def _what_changed(without: Figures, with_it: Figures) -> str:
    """What became of the people that only one of the two columns keeps, and of the rest."""
    gained = len(set(with_it["kept"]) - set(without["kept"]))
    spoilt, rest = _apart(without, with_it)
    if not gained and not spoilt:
        said = "It changed nobody's lot."
    else:
        often = Counter((row["what"], row["where"]) for row in spoilt).most_common()
        happened = "; ".join(f"{number} {what}, {where}" for (what, where), number in often)
        lost = f"{len(spoilt)} ({happened})" if spoilt else "nobody"
        said = f"It won {gained or 'nobody'} and lost {lost}."
    if not rest:
        return f"{said} Nobody is left whom it could keep."
    decided = sum(row["what"] in _DECIDED for row in rest)
    left = f"Not kept either way: {len(rest)} ({_kinds(rest)})"
    return f"{said} {left}, {decided or 'none'} of them a cue's to decide."
