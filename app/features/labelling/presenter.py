"""Labelling the open document: which tool is at work, on what, and what the views show of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.core.document.document import Document
from app.core.i18n import tr
from app.core.projection.right_image import boxes_in_right_image
from app.core.scenes import Side
from app.core.scenes.labels import (
    PART_COLOURS,
    CountText,
    FloorLabels,
    Outline,
    PartMark,
    PictureLabels,
    Tool,
    with_texts,
)
from app.features.labelling.outlines import Drawn, DrawnLabels
from app.features.labelling.part_labeller import PartLabeller
from app.features.labelling.scene import LabellingScene, RangeLine
from app.features.labelling.shape_planner import shapes_of_tool
from tracking.tracks import Box, Labels, PartLabel


@dataclass(slots=True)
class Choice:
    """What the user has chosen while labelling.

    Attributes:
        tool: at work, None for none.
        picked: number of the thing drawn that is chosen, -1 for none.
    """

    tool: Tool | None = None
    picked: int = -1


class LabellingPresenter:
    """Plans labels and makes the scenes that show them; it changes nothing but the choice."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self.choice = Choice()
        self.parts = PartLabeller(document)
        self._drawn = DrawnLabels(document.recording)

    @property
    def labels(self) -> Labels:
        """Those of the session; nothing without one."""
        session = self._document.session
        return Labels() if session is None else session.labels

    @property
    def track(self) -> int:
        """The selected track; 0 for nobody."""
        return self._document.selection.track

    # what the views show

    def outlines(self, side: Side) -> tuple[Outline, ...]:
        """All that was drawn, in one camera."""
        return self._drawn.picture(side, self.labels, (Tool.PARTS, -1))

    def picture(self, side: Side, frame: int, count_text: CountText) -> PictureLabels:
        """Everything drawn and said, in one camera; `count_text` tells what is counted at it."""
        outlines = with_texts(self._drawn.picture(side, self.labels, self._picked), count_text)
        labelling = self.choice.tool is not None
        return PictureLabels(self._part_marks(side, frame), outlines, labelling)

    def floor_outlines(self) -> FloorLabels:
        """All that was drawn, on the floor."""
        return FloorLabels(self._drawn.floor(self.labels, (Tool.PARTS, -1)))

    def floor(self, count_text: CountText) -> FloorLabels:
        """What was drawn on the floor, with what is counted at it."""
        return FloorLabels(with_texts(self._drawn.floor(self.labels, self._picked), count_text))

    @property
    def _picked(self) -> Drawn:
        return (self.choice.tool or Tool.PARTS, self.choice.picked)

    def _part_marks(self, side: Side, frame: int) -> tuple[PartMark, ...]:
        """Those of the selected person while they are labelled; else what was said of anybody."""
        labelling = self.choice.tool is Tool.PARTS
        if labelling:
            shown = list(self.parts.parts(frame).values())
        else:
            shown = [(label, True) for label in self.labels.parts.of_frame(frame)]
        marks = []
        for label, given in shown:
            box = label.box if side is not Side.RIGHT else self._in_right_image(label)
            if box is not None:
                marks.append(self._mark(label, given, box))
        return tuple(marks)

    def _mark(self, label: PartLabel, given: bool, box: Box) -> PartMark:
        asked = self.choice.tool is Tool.PARTS
        colour = PART_COLOURS[label.part] if asked else self._document.colour_of(label.track)
        chosen = asked and label.part == self.parts.choice.part
        track, part = label.track, label.part
        return PartMark(track, part, box, colour, given, label.on_part, asked, chosen)

    def _in_right_image(self, label: PartLabel) -> Box | None:
        session, recording = self._document.session, self._document.recording
        if session is None or recording.rectification is None or recording.ground is None:
            return None
        row = session.tracks.of_track(label.track, label.frame, label.frame + 1)
        if not len(row["frame"]):
            return None
        floor = np.array([[row["x"][0], row["y"][0]]], np.float64)
        box = boxes_in_right_image(recording.rectification, np.array([label.box]), floor)[0]
        if not np.isfinite(box).all():
            return None
        left, top, width, height = box.tolist()
        return left, top, width, height

    # the panel

    def scene(self, frame: int) -> LabellingScene | None:
        """The panel; None where nothing is being labelled."""
        tool = self.choice.tool
        if tool is None:
            return None
        if tool is Tool.PARTS:
            return self._parts_scene(frame)
        if tool is Tool.REVIEWED:
            return self._reviewed_scene(frame)
        names = tuple(item.name for item in shapes_of_tool(tool, self.labels))
        title, hint = _drawing_words(tool)
        return LabellingScene(tool, title, hint, names=names, picked=self.choice.picked)

    def _parts_scene(self, frame: int) -> LabellingScene:
        of_parts = self.parts
        step, scope = of_parts.choice.step, of_parts.scope_row()
        if not self.track:
            title, hint = tr("Body parts"), tr("Click a person to label their parts.")
            return LabellingScene(Tool.PARTS, title, hint, step=step)
        title = tr("Body parts of {who}", who=self._who())
        hint = (
            tr("Say whether each rectangle lies on its part, or drag it there; Esc leaves.")
            if of_parts.parts(frame)
            else tr("Nobody is tracked here: draw the part, or go to another frame; Esc leaves.")
        )
        lines = of_parts.lines(frame)
        return LabellingScene(Tool.PARTS, title, hint, lines, step, scope=scope)

    def _reviewed_scene(self, frame: int) -> LabellingScene:
        names = self.labels
        ranges = tuple(
            RangeLine(
                tr(
                    "{who}: frames {start} to {last}",
                    who=names.title(seen.track) if seen.track else tr("Everybody"),
                    start=seen.start,
                    last=seen.end - 1,
                ),
                seen.track,
                seen.start,
                seen.end,
            )
            for seen in names.reviewed
        )
        return LabellingScene(
            Tool.REVIEWED,
            tr("Reviewed ranges"),
            tr("Choose the frames you have checked, and mark them; click a range to go there."),
            ranges=ranges,
            proposed=self._proposed(frame),
            selected=self._who() if self.track else "",
        )

    def _proposed(self, frame: int) -> tuple[int, int]:
        """First and last frame to be marked: the range that is set, else a second from here."""
        start, end = self._document.correcting.marked or (
            frame,
            frame + max(1, round(self._document.recording.fps)),
        )
        return start, max(start, min(end, self._document.recording.frame_count) - 1)

    def _who(self) -> str:
        return self.labels.title(self.track)


def _drawing_words(tool: Tool) -> tuple[str, str]:
    """Title of the panel, and what to do in a line."""
    if tool is Tool.OCCLUDERS:
        return tr("Occluders"), tr(
            "Click the corners in the left image; Enter or a double click closes; drag corners to "
            "correct them; Esc leaves."
        )
    if tool is Tool.LINES:
        return tr("Counting lines"), tr(
            "Click both ends on the floor, or in the left image; the arrow shows which way is "
            "forward; Esc leaves."
        )
    return tr("Regions"), tr(
        "Click the corners on the floor, or in the left image; Enter or a double click closes; "
        "drag corners to correct them; Esc leaves."
    )
