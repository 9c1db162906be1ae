"""Where the parts of people were half a second ago, whatever the frame rate and the gaps.

One rule, for a tracker frame by frame and for a whole run at once. A part's state runs straight
from each frame in which it is known to the next. Its state `FEATURE_SPAN_S` ago is read off that
line, between the nearest known frames on both sides of that moment. A person known for a shorter
time is taken to have been before as in the first frame, so that a difference never reaches
farther back than the track; and what is older than `LONGEST_GAP_S` is forgotten, so that somebody
found again after a long while begins anew.
"""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.features import FEATURE_SPAN_S, NUMBERS
from tracking.tracks import PARTS

Tracks = NDArray[np.integer]
Rows = NDArray[np.int64]

LONGEST_GAP_S = 2.0
"""How a person was longer ago says nothing of how they moved."""

_SLACK_S = 1e-6
"""Frame times are sums of fractions: moments closer than this are one."""


class PastStates:
    """The states of the last seconds, for a tracker that goes frame by frame.

    `before` gives the states half a second ago; `remember` then keeps what is true of the frame,
    after any adjustment.
    """

    def __init__(self) -> None:
        self._frames: deque[tuple[float, Rows, Floats]] = deque()

    def remember(self, time_s: float, tracks: Tracks, states: Floats) -> None:
        """Keep a frame's states (n, 3, 6) of tracks (n,); the last word on a frame counts."""
        if self._frames and self._frames[-1][0] >= time_s - _SLACK_S:
            self._frames.pop()
        order = np.argsort(tracks, kind="stable")
        self._frames.append((time_s, np.asarray(tracks, np.int64)[order], states[order]))
        while self._frames[0][0] < time_s - LONGEST_GAP_S - _SLACK_S:
            self._frames.popleft()

    def before(self, time_s: float, tracks: Tracks, now: Floats) -> Floats:
        """The states (n, 3, 6) half a second before `time_s` of people who stand so `now`."""
        moment, wanted = time_s - FEATURE_SPAN_S, np.asarray(tracks, np.int64)
        known = [frame for frame in self._frames if _between(frame[0], time_s)]
        early_s, early = _nearest(wanted, [f for f in reversed(known) if _is_early(f[0], moment)])
        late_s, late = _nearest(wanted, [f for f in known if not _is_early(f[0], moment)])
        unseen = np.isnan(late_s)
        late_s, late = np.where(unseen, time_s, late_s), np.where(unseen[:, None, None], now, late)
        return _on_line(np.full(len(wanted), moment), early_s, early, late_s, late)


def states_before(
    times_s: Floats, tracks: Tracks, states: Floats, asked: Rows, now: Floats | None = None
) -> Floats:
    """The same of a whole run.

    Args:
        times_s: (n,) of each row. tracks: (n,). states: (n, 3, 6). Rows in any order.
        asked: (k,) rows whose states half a second earlier are wanted.
        now: (k, 3, 6) how those people stand, where not as in the run.

    Returns:
        (k, 3, 6).
    """
    now = states[asked] if now is None else now
    if not len(asked):
        return now
    first_s = float(times_s.min())
    lane_s = float(times_s.max()) - first_s + 2 * LONGEST_GAP_S
    own = np.unique(tracks, return_inverse=True)[1] * lane_s + (times_s - first_s)
    order = np.argsort(own, kind="stable")
    line, at = own[order], own[asked]
    moment = at - FEATURE_SPAN_S
    late = np.searchsorted(line, moment + _SLACK_S, "right")
    early = late - 1
    known = (early >= 0) & (line[early] >= at - LONGEST_GAP_S - _SLACK_S)
    early_s = np.where(known, line[early], np.nan)
    passed = line[np.minimum(late, len(line) - 1)] < at - _SLACK_S
    late_s = np.where(passed, line[np.minimum(late, len(line) - 1)], at)
    after = np.where(passed[:, None, None], states[order[np.minimum(late, len(line) - 1)]], now)
    return _on_line(moment, early_s, states[order[early]], late_s, after)


def _between(frame_s: float, time_s: float) -> bool:
    """Whether a frame is before the moment and not forgotten yet."""
    return time_s - LONGEST_GAP_S - _SLACK_S <= frame_s < time_s - _SLACK_S


def _is_early(frame_s: float, moment_s: float) -> bool:
    return frame_s <= moment_s + _SLACK_S


def _nearest(wanted: Rows, frames: list[tuple[float, Rows, Floats]]) -> tuple[Floats, Floats]:
    """Time (n,) and states of each track in the first of the frames that has it; NaN in none."""
    states = np.full((len(wanted), PARTS, NUMBERS), np.nan)
    times = np.full(len(wanted), np.nan)
    for frame_s, there, held in frames:
        missing = np.isnan(times)
        if not missing.any():
            break
        at = np.searchsorted(there, wanted)
        at[at == len(there)] = 0
        found = missing & (there[at] == wanted) if len(there) else np.zeros(len(wanted), bool)
        states[found], times[found] = held[at[found]], frame_s
    return times, states


def _on_line(
    moment_s: Floats, early_s: Floats, early: Floats, late_s: Floats, late: Floats
) -> Floats:
    """States (k, 3, 6) at a moment (k,); the later ones where there are none before (NaN)."""
    lone = np.isnan(early_s)
    share = np.where(lone, 1.0, (moment_s - early_s) / (late_s - np.where(lone, 0.0, early_s)))
    share = np.clip(share, 0.0, 1.0)[:, None, None]
    return np.where(
        share == 1.0, late, (1.0 - share) * np.where(share == 1.0, 0.0, early) + share * late
    )
