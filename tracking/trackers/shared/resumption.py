"""Tracking again after a correction: what the corrected tracks say before the frame to go on at."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.errors import SettingsError
from tracking.trackers.shared.corrected_rows import is_apart, is_seen, only
from tracking.tracks.columns import CORRECTED_COLUMNS, Columns
from tracking.tracks.run import DetectionsInput
from tracking.tracks.table import TrackTable

Frames = NDArray[np.int32]
Flags = NDArray[np.bool_]

_WALKED_S = 2.0
"""How far back the way somebody walked is told; more than what walking direction remembers."""
_GONE_S = 4.0
"""Who has no row for longer than this, and comes back later, is not looked for."""
_EARLIER_S = 20.0
"""How far back better views of somebody are searched for."""
_VIEWS = 8
"""Good views of each person that suffice."""
_EARLIER_LOOKS = 40
"""Frames before the last ones that are looked at for all people together."""
CLEAR = 0.75
"""Share of a body in sight from which a view is a good one."""


@dataclass(frozen=True, slots=True, eq=False)
class Resume:
    """Where tracking goes on, as plain values.

    Attributes:
        frame: the first frame to be tracked again.
        rows: `CORRECTED_COLUMNS` of frames before it, sorted by frame then track: those needed of
            the people who are followed on.
        colour_frames: the frames, ascending, in which these people are looked at first, to learn
            their colours: the last ones before `frame` and earlier ones that show somebody well.
        highest_track: the highest id ever used; new people get higher ones.
        fps: frames a second.
        detections_input: files of other programs' detections that these tracks were made with.
    """

    frame: int
    rows: Columns
    colour_frames: tuple[int, ...]
    highest_track: int
    fps: float
    detections_input: tuple[DetectionsInput, ...] = ()

    @classmethod
    def of(
        cls,
        table: TrackTable,
        frame: int,
        fps: float,
        learn_s: float = 1.0,
        detections_input: tuple[DetectionsInput, ...] = (),
    ) -> Resume:
        """What tracking again from a frame on starts with.

        People are followed on who stand in the frame before, and those who have no row there but
        had one a few seconds ago and have one later: they are hidden.

        Args:
            fps: frames a second. learn_s: how much footage before the frame is looked at whole.
            detections_input: of the run that the corrected tracks began as.

        Raises `SettingsError` for a frame that has none before it.
        """
        if frame < 1:
            raise SettingsError(
                "frame {frame}: nothing stands before it; track from the start", frame=frame
            )
        rows = _rows_before(table, frame, fps)
        first = max(0, frame - max(1, round(learn_s * fps)))
        colour_frames = np.union1d(np.arange(first, frame), _earlier_frames(rows, first))
        kept = (rows["frame"] >= frame - round(_WALKED_S * fps)) | np.isin(
            rows["frame"], colour_frames
        )
        kept |= _last_of_each(rows, np.ones_like(kept)) | _last_of_each(rows, is_seen(rows))
        return cls(
            frame,
            only(rows, kept),
            tuple(colour_frames.tolist()),
            table.highest_track,
            fps,
            detections_input,
        )

    def require_same(self, detections_input: tuple[DetectionsInput, ...]) -> None:
        """Refuse to go on with other detections than the tracks were made with.

        Going on without any, or with some after tracks that needed none, is the user's choice.
        Raises SettingsError that names both files.
        """
        known = self.detections_input
        for given in detections_input if known else ():
            if not given.is_among(known):
                same_camera = [one.file for one in known if one.camera == given.camera]
                raise SettingsError(
                    "{file} is not the file of detections that the tracks were made with, {known}: "
                    "give that one, or track the recording anew",
                    file=given.file,
                    known=same_camera[0] if same_camera else known[0].file,
                )

    def last(self, seconds: float) -> Columns:
        """The rows of the last seconds before the frame."""
        return only(self.rows, self.rows["frame"] >= self.frame - round(seconds * self.fps))


def _rows_before(table: TrackTable, frame: int, fps: float) -> Columns:
    """The last rows before a frame of those who are there at it."""
    parts: list[Columns] = []
    for track in table.track_ids:
        frames = table.frames_of_track(track)
        place = int(np.searchsorted(frames, frame))
        if place == 0 or frames[place - 1] < frame - round(_GONE_S * fps):
            continue
        if frames[place - 1] == frame - 1 or place < len(frames):
            parts.append(table.of_track(track, max(0, frame - round(_EARLIER_S * fps)), frame))
    names = CORRECTED_COLUMNS.items()
    rows = {n: np.concatenate([np.zeros(0, t), *(part[n] for part in parts)]) for n, t in names}
    return only(rows, np.lexsort((rows["track"], rows["frame"])))


def _earlier_frames(rows: Columns, first: int) -> Frames:
    """Frames before the first that show well who is seldom seen well from there on."""
    good = is_seen(rows) & (rows["visibility"] >= CLEAR) & is_apart(rows)
    late = rows["frame"] >= first
    people, number = np.unique(rows["track"], return_inverse=True)
    shown = np.bincount(number[good & late], minlength=len(people))
    chosen = np.flatnonzero(good & ~late & (shown[number] < _VIEWS))
    latest = chosen[np.lexsort((-rows["frame"][chosen], number[chosen]))]
    began = np.searchsorted(number[latest], number[latest])
    turn = np.arange(len(latest)) - began
    latest = latest[turn < _VIEWS]
    # The first views of all people go before anybody's second.
    latest = latest[np.argsort(turn[turn < _VIEWS], kind="stable")]
    once = np.unique(rows["frame"][latest], return_index=True)[1]
    return np.asarray(rows["frame"][latest[np.sort(once)[:_EARLIER_LOOKS]]])


def _last_of_each(rows: Columns, eligible: Flags) -> Flags:
    """Marks every track's last row among the eligible ones."""
    last = np.zeros(len(eligible), bool)
    backwards = np.flatnonzero(eligible)[::-1]
    last[backwards[np.unique(rows["track"][backwards], return_index=True)[1]]] = True
    return last
