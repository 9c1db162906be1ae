"""Costs of links between tracklets, appearance aside.

A cost is the negative log-likelihood ratio of one person against an exit and an entry.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.borders import birth_costs, death_costs
from tracking.trackers.linking.doubts import Doubt
from tracking.trackers.linking.links import Links
from tracking.trackers.linking.motion import fresh_likelihood, walk_likelihood
from tracking.trackers.linking.occlusion import hidden_shares
from tracking.trackers.linking.seen_rows import Floats, Integers, SeenRows
from tracking.trackers.linking.tracklets import Tracklets
from tracking.tracks.columns import Columns

Rows = NDArray[np.intp]

_LONGEST_S = 6.0
"""Who is not re-identified by then is somebody new."""
_MISSED, _MISSED_S = 0.1, 0.1
"""Share of gaps that are no short failure to detect, and how long those are."""
_LOST_S = 1.5
"""How long others are, while nothing is known that hides the person."""
_HIDING, _HIDDEN_S = 0.8, 5.0
"""How much likelier a long gap is behind others, and how long those are."""
_TRACKER = 2.0
"""Log-odds of the tracker's own link, which rests on more of every frame."""
_KEPT_APART = 1.5
"""Log-odds that a new id it gave is a new person; an exchange of ids makes nobody new."""
_GAP_S = 0.25
"""From which on somebody counts as lost, and not as missed for a moment."""
_HOPELESS = 12.0
"""What costs more, appearance does not make up for."""
_AT_ONCE = 100_000
"""Pairs that are weighed in one go: memory is the same for minutes and for hours of footage."""


def find_links(
    seen: SeenRows,
    pieces: Tracklets,
    tracks: Columns,
    view: View,
    fps: float,
    frames: tuple[int, int],
    fixed: NDArray[np.bool_],
) -> Links:
    """The pairs of tracklets that may be one person's, with their costs.

    A link costs less than nothing where one person who goes on is likelier than one who leaves
    and another who comes.

    Args:
        tracks: of the run. frames: half-open range of the run.
        fixed: (t,) tracklets that begin as somebody known.
    """
    costs = _Costs(
        pieces,
        born=fresh_likelihood(pieces.first)
        - birth_costs(seen, pieces, tracks, view, fps, frames[0]),
        died=-death_costs(seen, pieces, tracks, view, fps, frames[1]),
    )
    portions = []
    for end, start in _pairs(pieces, round(_LONGEST_S * fps)):
        free = ~fixed[start]
        portions.append(costs.of(end[free], start[free], tracks, view, fps))
    return Links.concatenate(portions)


def _pairs(pieces: Tracklets, longest: int) -> Iterator[tuple[Rows, Rows]]:
    """Tracklets (k,) that end and (k,) that begin later, within so many frames, in portions."""
    order = np.argsort(pieces.first.frame, kind="stable")
    begins = pieces.first.frame[order]
    low = np.searchsorted(begins, pieces.last.frame, side="right")
    high = np.searchsorted(begins, pieces.last.frame + longest, side="right")
    upto = np.cumsum(high - low)
    portions = np.unique(np.searchsorted(upto, np.arange(0, upto.max(initial=0), _AT_ONCE)))
    for first, stop in pairwise([*portions.tolist(), len(pieces)]):
        count = (high - low)[first:stop]
        end = np.repeat(np.arange(first, stop), count)
        nth = np.arange(len(end)) - np.repeat(np.cumsum(count) - count, count)
        yield end, order[low[end] + nth]


@dataclass(frozen=True, slots=True)
class _Costs:
    """What is known of each tracklet alone, for the costs of pairs of them.

    Attributes:
        born: (t,) log-density of somebody new who begins there. died: (t,) of one who ends there.
    """

    pieces: Tracklets
    born: Floats
    died: Floats

    def of(self, end: Rows, start: Rows, tracks: Columns, view: View, fps: float) -> Links:
        """The links of pairs that are not hopeless."""
        pieces = self.pieces
        gap_s = (pieces.first.frame[start] - pieces.last.frame[end]) / fps
        together = walk_likelihood(pieces.last, pieces.first, end, start, gap_s)
        same = (pieces.track[end] == pieces.track[start]) & (start > end)
        other = (pieces.track[end] != pieces.track[start]) & (pieces.doubt[start] != Doubt.MET)
        named_anew = other & (pieces.doubt[start] != Doubt.LOST)
        together += _TRACKER * same - _KEPT_APART * named_anew
        cost = self.born[start] + self.died[end] - together
        hidden = np.zeros(len(end))
        lost = np.flatnonzero((gap_s > _GAP_S) & (cost < _HOPELESS))
        hidden[lost] = hidden_shares(tracks, *_gaps(pieces, end[lost], start[lost]), view)
        cost -= _log_gap_density(gap_s, hidden, fps)
        return Links(end, start, cost).select(cost < _HOPELESS)


def _gaps(
    pieces: Tracklets, end: Rows, start: Rows
) -> tuple[tuple[Floats, Floats], tuple[Integers, Integers], tuple[Integers, Integers]]:
    """From where to where people would have gone unseen; see `hidden_shares`."""
    last, first = pieces.last, pieces.first
    return (
        (last.place[end], first.place[start]),
        (last.frame[end], first.frame[start]),
        (pieces.track[end], pieces.track[start]),
    )


def _log_gap_density(gap_s: Floats, hidden: Floats, fps: float) -> Floats:
    """(k,) log-density, in 1/s, of being seen again after these gaps.

    Args:
        hidden: (k,) share of each in which others stood in front.
    """
    unseen_s = np.maximum(gap_s - 1.0 / fps, 0.0)
    missed = _MISSED + _HIDING * hidden
    rate = hidden / _HIDDEN_S + (1.0 - hidden) / _LOST_S
    short = np.log((1.0 - missed) / _MISSED_S) - unseen_s / _MISSED_S
    long = np.log(missed * rate) - unseen_s * rate
    return np.asarray(np.logaddexp(short, long))
