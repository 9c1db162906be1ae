"""What a user is told of an imported file that does not fit its recording."""

from __future__ import annotations

import numpy as np

from tracking.formats import Filmed, Imported
from tracking.formats.row_rules import BOX
from tracking.tracks import Columns
from tracking.translation import Message, count_msg, msg


def differing_footage(imported: Imported, filmed: Filmed) -> list[Message]:
    """What the file says otherwise of the footage than the recording does."""
    notes = []
    if None not in (imported.size_px, filmed.size_px) and imported.size_px != filmed.size_px:
        (width, height), own = imported.size_px or (0, 0), filmed.size_px or (0, 0)
        notes.append(
            msg(
                "the file is of images of {width} x {height} px, the recording's are "
                "{own_width} x {own_height}; boxes are imported unchanged",
                width=width,
                height=height,
                own_width=own[0],
                own_height=own[1],
            )
        )
    if imported.fps and filmed.fps and abs(imported.fps - filmed.fps) > 0.01 * filmed.fps:
        notes.append(
            msg(
                "the file is of {fps:g} frames per second, the recording of "
                "{filmed_fps:g}; frames are matched by their number",
                fps=imported.fps,
                filmed_fps=filmed.fps,
            )
        )
    if imported.frames and filmed.frames and imported.frames != filmed.frames:
        notes.append(
            msg(
                "the file is of {frames} frames, the recording has {filmed_frames}",
                frames=imported.frames,
                filmed_frames=filmed.frames,
            )
        )
    return notes


def note_on_outside(rows: Columns, size_px: tuple[int, int]) -> Message:
    """How many boxes lie wholly outside of images of that size; "" where none does."""
    left, top, width, height = (rows[name] for name in BOX)
    outside = (left >= size_px[0]) | (top >= size_px[1]) | (left + width <= 0) | (top + height <= 0)
    count, boxes = int(outside.sum()), int(np.isfinite(left).sum())
    if not count:
        return Message()
    return count_msg(
        count,
        "{n} of {boxes} boxes lies outside of the image: are these tracks of this recording?",
        "{n} of {boxes} boxes lie outside of the image: are these tracks of this recording?",
        boxes=boxes,
    )
