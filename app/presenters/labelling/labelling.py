"""Labelling the open document: which tool is at work, on what, and what the views show of it."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace

import numpy as np

from app.presenters.document.document import Document
from app.presenters.labelling.drawing import drawn_with
from app.presenters.labelling.drawn import Drawn, DrawnLabels
from app.presenters.labelling.labelling_scene import (
    FloorLabels,
    LabellingScene,
    PartLine,
    PartMark,
    PictureLabels,
    RangeLine,
    Tool,
)
from app.presenters.labelling.parts import Box, parts_of
from app.presenters.pictures.right_eye import boxes_in_right_eye
from app.presenters.scenes import Eye
from app.presenters.words import tr
from tracking.editing import Change, plan_label_part, plan_unlabel_part
from tracking.errors import EditError
from tracking.tracks import PART_NAMES, Labels, PartLabel, PartLabels

_SAID: dict[bool | None, str] = {True: "on", False: "off", None: "unsure"}
_Counts = Counter[tuple[int, bool | None]]


@dataclass(slots=True)
class Choice:
    """What the user has chosen while labelling.

    Attributes:
        tool: at work, None for none. part: that the keys speak of.
        picked: number of the thing drawn that is chosen, -1 for none.
        step: frames to go on after the last part; 0 stays.
    """

    tool: Tool | None = None
    part: int = 0
    picked: int = -1
    step: int = 1


class LabellingPresenter:
    """Plans labels and makes the scenes that show them; it changes nothing but the choice."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self.choice = Choice()
        self._drawn = DrawnLabels(document.recording)
        self._counted: tuple[PartLabels, _Counts] = (PartLabels(), Counter())

    @property
    def labels(self) -> Labels:
        """Those of the session; nothing without one."""
        session = self._document.session
        return Labels() if session is None else session.labels

    @property
    def track(self) -> int:
        """The selected track; 0 for nobody."""
        return self._document.selection.track

    # body parts

    def parts(self, frame: int) -> dict[int, tuple[PartLabel, bool]]:
        """The parts of the selected person and whether somebody labelled them."""
        session = self._document.session
        if session is None or not self.track:
            return {}
        adopted = session.adopted_run
        run = session.runs[adopted] if adopted is not None else None
        return parts_of(session.labels, session.tracks, run, self.track, frame)

    def plan_say(self, frame: int, on_part: bool | None) -> Change:
        """Say whether the chosen part's rectangle lies on its part.

        Raises EditError where the person has no rectangle in the frame.
        """
        there = self.parts(frame).get(self.choice.part)
        if there is None:
            raise EditError(
                tr("{track} has no box in frame {frame}: draw one", track=self.track, frame=frame)
            )
        return plan_label_part(self.labels, replace(there[0], on_part=on_part))

    def plan_box(self, frame: int, part: int, box: Box) -> Change:
        """Put a part's rectangle where a person drew it: it lies on its part, or is unsure."""
        there = self.parts(frame).get(part)
        unsure = there is not None and there[1] and there[0].on_part is None
        drawn = PartLabel(frame, self.track, part, box, None if unsure else True, "person")
        return plan_label_part(self.labels, drawn)

    def plan_forget(self, frame: int) -> Change:
        """Take back what was said of the chosen part in the frame."""
        return plan_unlabel_part(self.labels, (frame, self.track, self.choice.part))

    # what the views show

    def picture(self, eye: Eye, frame: int) -> PictureLabels:
        """Everything drawn and said, in one eye."""
        outlines = self._drawn.picture(eye, self.labels, self._picked)
        labelling = self.choice.tool is not None
        return PictureLabels(self._part_marks(eye, frame), outlines, labelling)

    def floor(self) -> FloorLabels:
        """What was drawn on the floor."""
        return self._drawn.floor(self.labels, self._picked)

    @property
    def _picked(self) -> Drawn:
        return (self.choice.tool or Tool.PARTS, self.choice.picked)

    def _part_marks(self, eye: Eye, frame: int) -> tuple[PartMark, ...]:
        """Those of the selected person while they are labelled; else what was said of anybody."""
        labelling = self.choice.tool is Tool.PARTS
        if labelling:
            shown = list(self.parts(frame).values())
        else:
            shown = [(label, True) for label in self.labels.parts.of_frame(frame)]
        marks = []
        for label, given in shown:
            box = label.box if eye is not Eye.RIGHT else self._in_right_eye(label)
            if box is not None:
                chosen = labelling and label.part == self.choice.part
                text = _mark_text(label, given)
                marks.append(PartMark(label.part, box, text, given, label.on_part, chosen))
        return tuple(marks)

    def _in_right_eye(self, label: PartLabel) -> Box | None:
        session, recording = self._document.session, self._document.recording
        if session is None or recording.rectification is None or recording.ground is None:
            return None
        row = session.tracks.of_track(label.track, label.frame, label.frame + 1)
        if not len(row["frame"]):
            return None
        floor = np.array([[row["x"][0], row["y"][0]]], np.float64)
        box = boxes_in_right_eye(recording.rectification, np.array([label.box]), floor)[0]
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
        names = tuple(item.name for item in drawn_with(tool, self.labels))
        title, hint = _drawing_words(tool)
        return LabellingScene(tool, title, hint, names=names, picked=self.choice.picked)

    def _parts_scene(self, frame: int) -> LabellingScene:
        if not self.track:
            title, hint = tr("Body parts"), tr("Click a person to label their parts.")
            return LabellingScene(Tool.PARTS, title, hint, step=self.choice.step)
        there, counts = self.parts(frame), self._counts()
        lines = tuple(
            PartLine(
                tr(name),
                _SAID[there[part][0].on_part] if part in there and there[part][1] else "",
                part == self.choice.part,
                (counts[part, True], counts[part, False], counts[part, None]),
            )
            for part, name in enumerate(PART_NAMES)
        )
        title = tr("Body parts of {who}", who=self._who())
        hint = (
            tr("Say whether each rectangle lies on its part, or drag it there; Esc leaves.")
            if there
            else tr("Nobody is tracked here: draw the part, or go to another frame; Esc leaves.")
        )
        return LabellingScene(Tool.PARTS, title, hint, lines, self.choice.step)

    def _counts(self) -> _Counts:
        """How often each part was said to be on, off and unsure; counted on from the last time."""
        before, counts = self._counted
        parts = self.labels.parts
        if parts is not before:
            gone, come = before.unlike(parts)
            counts = Counter(counts)
            counts.subtract((label.part, label.on_part) for label in gone)
            counts.update((label.part, label.on_part) for label in come)
            self._counted = (parts, counts)
        return counts

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
            tr("Mark what you have looked at and found right; click a range to go there."),
            ranges=ranges,
            proposed=(frame, max(frame, self._document.recording.frame_count - 1)),
            selected=self._who() if self.track else "",
        )

    def _who(self) -> str:
        return self.labels.title(self.track)


def _mark_text(label: PartLabel, given: bool) -> str:
    name = tr(PART_NAMES[label.part])
    said = tr(_SAID[label.on_part])
    return tr("{part}: {said}", part=name, said=said) if given else name


def _drawing_words(tool: Tool) -> tuple[str, str]:
    """Title of the panel, and what to do in a line."""
    if tool is Tool.OCCLUDERS:
        return tr("Occluders"), tr(
            "Click the corners in the left eye; Enter or a double click closes; drag corners to "
            "correct them; Esc leaves."
        )
    if tool is Tool.LINES:
        return tr("Counting lines"), tr(
            "Click both ends on the floor; the arrow shows which way is forward; Esc leaves."
        )
    return tr("Regions"), tr(
        "Click the corners on the floor; Enter or a double click closes; drag corners to correct "
        "them; Esc leaves."
    )
