"""Looks through tracks for places where they are likely wrong."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracking.arrays import Floats
from tracking.geometry import View
from tracking.progress import Progress
from tracking.review.block import Block, Scene, search_block
from tracking.review.core.evidence import Rows
from tracking.review.footage import Footage
from tracking.review.queue import rank
from tracking.review.review_item import ReviewItem, ReviewItemKey
from tracking.review.seams import corrected_items
from tracking.tracks import Labels, Occluder, Run, TrackTable, row_keys

MOST = 10_000
"""Of more than these, more than anybody ever looks through, those worth most are kept."""
_OWN_S = 1.0
"""A meeting this soon belongs to the same review item."""


def find_review_items(
    table: TrackTable,
    run: Run | None,
    fps: float,
    labels: Labels | None = None,
    view: View | None = None,
    progress: Progress | None = None,
    *,
    size: tuple[int, int] | None = None,
    hand_made: bool = False,
) -> tuple[ReviewItem, ...]:
    """Places where the tracks are likely wrong, those that are worth most first.

    A jump between two boxes that a person made or kept is not flagged, see `jumps`, nor what shows
    nothing but such boxes, see `made_by_hand`. Verdicts and reviewed ranges are not looked at here:
    see `filter_undecided`.

    Args:
        table: the corrected tracks; not changed, so a snapshot can be handed to another thread.
        run: the one they began as, for what its tracker noticed; None, or one without signals:
            what needs them is not looked for.
        fps: frames a second.
        labels: whose occluders explain why tracks end; None for none.
        view: the camera, whose picture's borders do so too; None where it is not known.
        progress: told how far it is; what it raises ends the search.
        size: of the picture in px, where there is no view.
        hand_made: flag also what shows nothing but boxes that a person made.
    """
    asked = table, run, fps, labels, view, progress
    finder = ReviewItemFinder()
    return finder.find(*asked, size=size, hand_made=hand_made, with_begun=False).items


@dataclass(frozen=True, slots=True)
class ReviewFinding:
    """What was found in tracks, and what it is held against.

    Attributes:
        items: of the tracks as they are now.
        begun: of the tracks as their run left them, where these were asked for.
        corrected: the items where an edit has joined, parted or exchanged their tracks.
    """

    items: tuple[ReviewItem, ...] = ()
    begun: tuple[ReviewItem, ...] = ()
    corrected: frozenset[ReviewItemKey] = frozenset()


class _Asked(NamedTuple):
    """What a search depends on beside the tracks: see `find_review_items`."""

    fps: float
    extent: tuple[int, int] | None
    occluders: tuple[Occluder, ...]
    hand_made: bool


class ReviewItemFinder:
    """Looks through tracks again after each edit, anew only where something is another.

    The footage is looked through block after block, each with some seconds around it; a block
    whose rows hold what they held is not looked through again. What is found does not depend on
    what was looked through before.
    """

    def __init__(self) -> None:
        self._run: Run | None = None
        self._known: dict[tuple[object, ...], Block] = {}
        self._begun: tuple[_Asked, TrackTable, tuple[ReviewItem, ...]] | None = None

    def find(
        self,
        table: TrackTable,
        run: Run | None,
        fps: float,
        labels: Labels | None = None,
        view: View | None = None,
        progress: Progress | None = None,
        *,
        size: tuple[int, int] | None = None,
        hand_made: bool = False,
        with_begun: bool = True,
    ) -> ReviewFinding:
        """See `find_review_items`. Work done before progress raised is kept for next time.

        with_begun: look through the tracks as the run found them, too; once, as they stay.
        """
        extent = view.camera.size if view else size
        asked = _Asked(fps, extent, labels.occluders if labels else (), hand_made)
        tell = progress or _untold
        if run is not self._run:
            self._run, self._known, self._begun = run, {}, None
        if run is None or not with_begun:
            return ReviewFinding(self._items(table, asked, tell))
        if self._begun is None or self._begun[0] != asked:
            first = TrackTable(run.tracks)
            self._begun = asked, first, self._items(first, asked, _part_of(tell, 0))
            tell = _part_of(tell, 1)
        _, first, begun = self._begun
        found = self._items(table, asked, tell)
        return ReviewFinding(found, begun, corrected_items(found, first, table))

    def _items(self, table: TrackTable, asked: _Asked, tell: Progress) -> tuple[ReviewItem, ...]:
        footage = Footage.of(table)
        if not len(footage.key):
            tell(1, 1)
            return ()
        fps, extent, occluders, hand_made = asked
        scene = Scene.of(footage, self._run, fps, extent, occluders, hand_made=hand_made)
        blocks = self._blocks(footage, scene, tell)
        return rank(_worth_most(blocks, footage, fps), "worth")

    def _blocks(self, footage: Footage, scene: Scene, tell: Progress) -> list[Block]:
        length = footage.length(scene.stop, scene.fps)
        starts = range(0, scene.stop, length)
        now: dict[tuple[object, ...], Block] = {}
        for number, start in enumerate(starts):
            tell(number, len(starts))
            end = start + length
            rows = footage.around(start, end, scene.around)
            known = (start, end, scene, footage.fingerprint(rows))
            now[known] = self._known.get(known) or search_block(
                footage, rows, self._run, scene, start, end
            )
            self._known[known] = now[known]
        self._known = now
        tell(len(starts), len(starts))
        return list(now.values())


def _part_of(tell: Progress, number: int) -> Progress:
    """Tells of the first (0) or the second (1) half of the work."""
    return lambda done, total: tell(number * total + done, 2 * total)


def _untold(done: int, total: int) -> None:
    """Nobody asked."""


def _worth_most(blocks: Sequence[Block], footage: Footage, fps: float) -> list[ReviewItem]:
    """What is worth most of all blocks, with what it costs where it is right."""
    meeting = np.sort(np.concatenate([block.meeting for block in blocks]))
    frame, likely, tracks = (
        np.concatenate([getattr(block, name) for block in blocks])
        for name in ("frame", "likelihood", "tracks")
    )
    cost = costs(footage.key, meeting, tracks, frame, fps)
    told = np.argsort(-(likely * cost), kind="stable")[:MOST]
    place = [(block, row) for block in blocks for row in range(len(block.items))]
    return [
        place[number][0].with_cost(place[number][1], worth)
        for number, worth in zip(told.tolist(), cost[told].tolist(), strict=True)
    ]


def costs(key: Rows, meeting: Rows, tracks: Rows, frame: Rows, fps: float) -> Floats:
    """(k,) rows of the tracks from each frame on until they end or are next near somebody.

    There they may be looked at anyhow.

    Args:
        key: (n,) of all rows, ascending, see `tracking.review.core.evidence.keys`.
        meeting: those of rows near somebody. tracks: (k, 2), 0 for none.
    """
    own = max(1, round(_OWN_S * fps))
    return np.asarray(sum(_rows_of(key, meeting, side, frame, own) for side in tracks.T))


def _rows_of(key: Rows, meeting: Rows, track: Rows, frame: Rows, own: int) -> Floats:
    start = np.searchsorted(key, row_keys(track, frame))
    end = np.searchsorted(key, row_keys(track + 1, np.zeros_like(frame)))
    padded = np.append(np.searchsorted(key, meeting), len(key))
    following = padded[np.searchsorted(meeting, row_keys(track, frame + own))]
    return np.where(track > 0, np.minimum(end, following) - start, 0).astype(np.float64)
