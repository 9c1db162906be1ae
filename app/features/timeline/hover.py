"""What is under the mouse, in words."""

from __future__ import annotations

import numpy as np

from app.core.i18n import N_, time_text, tr
from app.core.scenes import Lane, SpanKind, TimelineMark, TimelineScene

_WORDS = {
    SpanKind.MEASURED: N_("measured"),
    SpanKind.PREDICTED: N_("predicted: the person was not detected"),
    SpanKind.INTERPOLATED: N_("interpolated between keyframes"),
}


def words_at(
    scene: TimelineScene, lane: Lane | None, frame: int | None, mark: TimelineMark | None
) -> str:
    """Lines about a lane, a frame and a mark; `frame` None: over the names."""
    lines = []
    if lane is not None:
        lines.append(lane.label)
    if frame is not None:
        lines.append(
            tr("frame {frame}, {time}", frame=frame, time=time_text(frame / max(scene.fps, 1e-6)))
        )
    if lane is not None:
        lines.append(_state(lane, frame) if frame is not None else _life(lane))
    if mark is not None and mark.text:
        lines.append(mark.text)
    if lane is not None and frame is not None and _inside(frame, (*lane.reviewed, *scene.reviewed)):
        lines.append(tr("reviewed"))
    return "\n".join(lines)


def kind_at(lane: Lane, frame: int) -> SpanKind | None:
    """What the row of a frame is; None where there is none."""
    at = int(np.searchsorted(lane.spans[:, 0], frame, side="right")) - 1
    if at < 0 or frame >= lane.spans[at, 1]:
        return None
    return SpanKind(int(lane.spans[at, 2]))


def _state(lane: Lane, frame: int) -> str:
    at = int(np.searchsorted(lane.keyframes, frame))
    if at < len(lane.keyframes) and lane.keyframes[at] == frame:
        return tr("keyframe: a person put it there")
    kind = kind_at(lane, frame)
    if kind is not None:
        return tr(_WORDS[kind])
    first, end = int(lane.spans[0, 0]), int(lane.spans[-1, 1])
    return tr("gap: not there") if first <= frame < end else tr("not there")


def _life(lane: Lane) -> str:
    first, last = int(lane.spans[0, 0]), int(lane.spans[-1, 1]) - 1
    return tr("frames {first} to {last}", first=first, last=last)


def _inside(frame: int, ranges: tuple[tuple[int, int], ...]) -> bool:
    return any(start <= frame < end for start, end in ranges)
