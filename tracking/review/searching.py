"""Looks through tracks for places where they are likely wrong."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tracking.geometry import View
from tracking.review.costs import costs
from tracking.review.evidence import Rows, gathered
from tracking.review.joining import Places, Reasons, joined_places, stacked
from tracking.review.likelihood import LEAST_WEIGHT, WEIGHTS, likelihoods
from tracking.review.material import Material
from tracking.review.queue import ranked
from tracking.review.reasons import REASONS
from tracking.review.stretches import stretches
from tracking.review.suspicion import Suspicion
from tracking.review.wording import fix, sentence
from tracking.tracks import Labels, Run, TrackTable

Progress = Callable[[int, int], None]
"""Told steps done and steps in all; may raise to cancel."""

JOINED_S = 0.75
"""Reasons about the same people so near in time are one suspicion."""
_LEAST = 0.02
"""Less likely suspicions are not mentioned."""


def find_suspicions(
    table: TrackTable,
    run: Run | None,
    fps: float,
    labels: Labels | None = None,
    view: View | None = None,
    progress: Progress | None = None,
    *,
    size: tuple[int, int] | None = None,
) -> tuple[Suspicion, ...]:
    """Places where the tracks are likely wrong, the most worth looking at first.

    Verdicts and reviewed ranges are not looked at here: see `open_suspicions`.

    Args:
        table: the corrected tracks; not changed, so a snapshot can be handed to another thread.
        run: the one they began as, for what its tracker noticed; None, or one without signals:
            what needs them is not looked for.
        fps: frames a second.
        labels: whose occluders explain why tracks end; None for none.
        view: the camera, whose picture's borders do so too; None where it is not known.
        progress: told how far it is; what it raises ends the search.
        size: of the picture in px, where there is no view.
    """
    tell = progress or _untold
    total = len(REASONS) + 3
    tell(0, total)
    if not len(table):
        return ()
    evidence = gathered(table, run, fps)
    tell(1, total)
    picture = view.camera.size if view else size
    material = Material.of(evidence, picture, labels.occluders if labels else ())
    found = []
    for number, look in enumerate(REASONS.values()):
        tell(2 + number, total)
        found.append(look(material))
    tell(total - 1, total)
    reasons = stacked(found, [max(WEIGHTS[each.kind], LEAST_WEIGHT) for each in found])
    suspicions = _suspicions(material, reasons)
    tell(total, total)
    return ranked(suspicions)


def _untold(done: int, total: int) -> None:
    """Nobody asked."""


def _suspicions(material: Material, reasons: Reasons) -> list[Suspicion]:
    evidence = material.evidence
    places = joined_places(reasons, evidence.frames_of(JOINED_S))
    leader = places.leader
    likely = likelihoods(reasons.kinds, places.strength, reasons.second[leader] > 0)
    first, second, frame = reasons.first[leader], reasons.second[leader], reasons.frame[leader]
    cost = costs(material, first, second, frame)
    start, end = stretches(reasons, places, evidence)
    spoken = _spoken(reasons, places)
    told = np.flatnonzero(likely >= _LEAST)
    figures = (column[told].tolist() for column in (start, end, likely, cost))
    return [
        _suspicion(reasons, int(leader[place]), spoken[place], evidence.fps, *numbers)
        for place, *numbers in zip(told.tolist(), *figures, strict=True)
    ]


def _spoken(reasons: Reasons, places: Places) -> list[Rows]:
    """For each place its reasons, the weightiest first."""
    order = np.lexsort((-reasons.weight[places.reason], places.place))
    place, reason = places.place[order], places.reason[order]
    cuts = np.searchsorted(place, np.arange(1, len(places.leader)))
    return np.split(reason, cuts)


def _suspicion(
    reasons: Reasons,
    leader: int,
    rows: Rows,
    fps: float,
    start: int,
    end: int,
    likelihood: float,
    cost: float,
) -> Suspicion:
    first, second = int(reasons.first[leader]), int(reasons.second[leader])
    kind = reasons.kinds[int(reasons.kind[leader])]
    strongest: dict[int, int] = {}
    for row in (leader, *rows.tolist()):
        strongest.setdefault(int(reasons.kind[row]), row)
    texts = tuple(_said(reasons, row, fps) for row in strongest.values())
    return Suspicion(
        kind=kind,
        tracks=tuple(sorted({first, second} - {0})),
        frame=int(reasons.frame[leader]),
        start=start,
        end=end,
        likelihood=likelihood,
        cost=cost,
        text=texts[0],
        fix=fix(kind, second),
        others=texts[1:],
    )


def _said(reasons: Reasons, row: int, fps: float) -> str:
    kind = reasons.kinds[int(reasons.kind[row])]
    first, second = int(reasons.first[row]), int(reasons.second[row])
    return sentence(kind, first, second, float(reasons.figure[row]), reasons.frame[row] / fps)
