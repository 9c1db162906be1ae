"""Whether undo and redo have to take anybody elsewhere."""

from __future__ import annotations

from app.core.tracks.track_reader import TrackReader
from tracking.editing import Change


def is_seen_at(change: Change, frame: int, tracks: TrackReader) -> bool:
    """Whether somebody at a frame sees what a change is about, and need not go elsewhere.

    Rows are looked at where they change. Labels are seen in all frames they are about: of a track
    where it stands, what is drawn into picture and floor everywhere.
    """
    if frame == change.frame:
        return True
    sides = (change.before, change.after)
    if change.kind == "import" and any(frame in side.rows["frame"] for side in sides):
        return True  # of many people in many frames, of which this is one
    if any(len(side.stretches) or len(side.rows["frame"]) for side in sides):
        return False
    if change.scope is not None:
        end = change.scope.end
        return change.scope.start <= frame and (end is None or frame < end)
    if any(side.labels.verdicts for side in sides):
        return False
    labelled = {track for side in sides for track in side.labels.tracks}
    return not labelled or not labelled.isdisjoint(tracks.of_frame(frame)["track"].tolist())
