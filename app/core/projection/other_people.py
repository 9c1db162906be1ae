"""The people of another version of the tracks, as the views draw them in front of one's own."""

from __future__ import annotations

import math

import numpy as np

from app.core.colours.track_colours import ColourOf
from app.core.projection.right_image import boxes_in_right_image
from app.core.projection.trails import floor_points, trails_by_track
from app.core.scenes import Side
from app.core.scenes.other_people import OtherMark, OtherPlace
from tracking.recording import Recording
from tracking.tracks import Columns, TrackTable

_TRAIL_S = 2.0


class OtherPeople:
    """Makes the marks of everybody another version has in a frame."""

    def __init__(
        self,
        recording: Recording,
        tracks: TrackTable,
        colour_of: ColourOf,
    ) -> None:
        self._recording = recording
        self._tracks = tracks
        self._colour_of = colour_of

    def rows(self, frame: int) -> Columns:
        """`TRACK_COLUMNS` of everybody."""
        return self._tracks.of_frame(frame)

    def picture(self, side: Side, frame: int) -> tuple[OtherMark, ...]:
        """Everybody in one camera."""
        rows = self._tracks.of_frame(frame)
        boxes = np.column_stack([rows[name] for name in ("left", "top", "width", "height")])
        if side is Side.RIGHT and len(boxes):
            rectification = self._recording.rectification
            if rectification is None or self._recording.ground is None:
                return ()
            places = np.column_stack((rows["x"], rows["y"]))
            boxes = boxes_in_right_image(rectification, boxes, places)
        return tuple(
            OtherMark((left, top, width, height), str(track), self._colour_of(track))
            for track, (left, top, width, height) in zip(
                rows["track"].tolist(), boxes.tolist(), strict=True
            )
            if math.isfinite(left + top + width + height)
        )

    def floor(self, frame: int) -> tuple[OtherPlace, ...]:
        """Where they come from on the floor."""
        start = max(0, frame - round(_TRAIL_S * self._recording.fps))
        here = self._tracks.of_frame(frame)["track"].tolist()
        rows = self._tracks.of_tracks(here, start, frame + 1)
        trails = trails_by_track(rows, floor_points(rows))
        return tuple(
            OtherPlace(trails[track], str(track), self._colour_of(track))
            for track in here
            if track in trails
        )
