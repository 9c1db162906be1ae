"""Both papers' tables: their methods as we built them, beside their figures and our own tracker."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from tests.benchmarks.pages import Figures, table
from tests.benchmarks.stereo import cues, losses, words
from tests.benchmarks.stereo.columns import COLUMNS, CUES, OWN, PAPER_2012
from tests.benchmarks.stereo.shares import interval, percent
from tracking.synthesis import SCENES

PAPER = {
    "indoor": (87.5, 92.5, None),
    "outdoor": (81.5, 88.0, None),
    "lobby": (None, 88.0, 90.0),
    "plaza": (None, 88.0, 94.0),
    "square": (None, 86.0, 92.0),
}
"""[Kawashita2012] and [Kawashita2014]: distance; with colour; with direction; in per cent."""

_HEAD = ("scene", "cues", "kept", "by box, %", "by place, %", "paper, %")


def written(figures: Figures) -> str:
    """The section: a table a paper, both compared in a sentence, and what cues did and why."""
    parts = [words.TABLES.strip()]
    of_2012 = {scene: rows for scene, rows in figures.items() if scene in PAPER_2012}
    of_2014 = {scene: rows for scene, rows in figures.items() if scene not in PAPER_2012}
    for said, scenes in ((words.OF_2012, of_2012), (words.OF_2014, of_2014)):
        if scenes:
            parts += [said.strip(), _table(scenes)]
    parts += [said for said in (summary(figures), _cues(figures)) if said]
    return "\n\n".join(parts)


def _table(figures: Figures) -> str:
    """A row a method, the scene's name on the first of its rows."""
    rows = []
    for scene, columns in figures.items():
        titles = (_titled(scene), *[""] * (len(COLUMNS) - 1))
        papers = (*PAPER.get(scene, (None,) * len(CUES)), None)
        for title, name, paper in zip(titles, COLUMNS, papers, strict=True):
            rows.append([title, name, *_cells(columns[name]), _said(paper)])
    return table(_HEAD, rows)


def _cells(column: Figures) -> list[str]:
    kept, detected = _counts(column)
    low, high = interval(kept, detected)
    return [
        f"{kept} of {detected}",
        f"{percent(kept, detected)} ({100 * low:.0f} to {100 * high:.0f})",
        percent(*_counts(column, "_by_place")),
    ]


def _counts(column: Figures, ending: str = "") -> tuple[int, int]:
    return len(column[f"kept{ending}"]), len(column[f"detected{ending}"])


def _said(paper: float | None) -> str:
    return "" if paper is None else f"{paper:g}"


def summary(figures: Figures) -> str:
    """How the papers' methods and our tracker stand to the papers' figures; "" without any."""
    pairs = [*_pairs(figures)]
    if not pairs:
        return ""
    by_box, by_place = (
        sum(_per_cent(column, ending) >= paper for _, _, column, paper in pairs)
        for ending in ("", "_by_place")
    )
    said = (
        f"The papers' methods, as we built them and on our clips, reach the papers' figures in "
        f"{by_box} of {len(pairs)} places where both exist by box ({by_place} by place)"
    )
    said += _gap(pairs)
    within = sum(_reaches(column, paper) for _, _, column, paper in pairs)
    said += f". In {within} of them the paper's figure lies within or below our interval."
    return " ".join(part for part in (said, _lost(figures), _ours(figures)) if part)


def _gap(pairs: Sequence[tuple[str, str, Figures, float]]) -> str:
    """The greatest distance below a paper's figure."""
    scene, name, column, paper = max(pairs, key=lambda pair: pair[3] - _per_cent(pair[2]))
    below = paper - _per_cent(column)
    if below <= 0:
        return ""
    return f"; the greatest gap is {below:.1f} points ({_titled(scene)}, {name})"


def _lost(figures: Figures) -> str:
    """What went wrong with those whom all cues together do not keep in the papers' scenes."""
    rows = [
        row for scene in figures if scene in PAPER for row in figures[scene][CUES[-1]]["not_kept"]
    ]
    if not rows:
        return ""
    often = Counter(row["what"] for row in rows).most_common()
    kinds = ", ".join(f"{number} {what}" for what, number in often)
    return f"Whom {CUES[-1]} cues do not keep there, {len(rows)} people: {kinds}."


def _pairs(figures: Figures) -> Iterator[tuple[str, str, Figures, float]]:
    """Scene, cues, our column and the paper's figure, where there is one."""
    for scene, columns in figures.items():
        for name, paper in zip(CUES, PAPER.get(scene, ()), strict=False):
            if paper is not None:
                yield scene, name, columns[name], paper


def _per_cent(column: Figures, ending: str = "") -> float:
    kept, detected = _counts(column, ending)
    return 100 * kept / max(detected, 1)


def _reaches(column: Figures, paper: float) -> bool:
    return paper <= 100 * interval(*_counts(column))[1]


def _ours(figures: Figures) -> str:
    """In which scenes our own tracker is above the best the paper has."""
    compared = [scene for scene in figures if scene in PAPER]
    below = [scene for scene in compared if _per_cent(figures[scene][OWN]) <= _best(PAPER[scene])]
    number = len(compared)
    every = "the only scene" if number == 1 else f"all {number} scenes"
    where = every if not below else f"{number - len(below)} of {number} scenes"
    missed = f", not in {'; '.join(map(_titled, below))}" if below else ""
    return f"`{OWN}` is above the paper's best figure in {where}{missed}."


def _best(paper: Sequence[float | None]) -> float:
    return max(value for value in paper if value is not None)


def _cues(figures: Figures) -> str:
    told = [*cues.sentences(figures)]
    if not told:
        return ""
    parts = [words.CUES.strip(), "\n".join(f"- {line}" for line in told)]
    parts += [words.WORDS.strip(), losses.meanings(cues.words_used(figures))]
    why = [words.WHY[what].strip().replace("\n", " ") for what in cues.to_explain(figures)]
    if why:
        parts += [words.WHY_HEAD.strip(), "\n".join(f"- {line}" for line in why)]
    return "\n\n".join(parts)


def _titled(scene: str) -> str:
    return SCENES[scene].title.lower()
