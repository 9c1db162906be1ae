"""Labelling body parts: what a key says, of one frame or of a range, and how often it was said."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace

from app.core.document.document import Document
from app.core.editing import EditScope
from app.core.i18n import tr
from app.core.keymap import shown_key
from app.core.scenes import ChoiceRow
from app.core.scenes.labels import SAID, SuggestedPart
from app.core.scenes.part_names import part_name
from app.features.labelling.parts import parts_of, parts_over
from app.features.labelling.scene import PartLine
from tracking.editing import Change, plan_label_part, plan_unlabel_part
from tracking.errors import EditError
from tracking.tracks import PART_NAMES, Box, Labels, PartLabel, PartLabels, Run

SCOPES = (EditScope.FRAME, EditScope.RANGE)
_Counts = Counter[tuple[int, bool | None]]


@dataclass(slots=True)
class PartChoice:
    """What the user has chosen of parts.

    Attributes:
        part: that the keys speak of. step: frames to go on after the last part; 0 stays.
        scope: how far an answer goes: this frame, or the range that is set.
        suggested: what is looked at because the detector is unsure of it; None: own choice.
    """

    part: int = 0
    step: int = 1
    scope: EditScope = EditScope.FRAME
    suggested: SuggestedPart | None = None


class PartLabeller:
    """Plans labels of the selected person's parts and counts all there are."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self.choice = PartChoice()
        self._counted: tuple[PartLabels, _Counts] = (PartLabels(), Counter())

    @property
    def _labels(self) -> Labels:
        session = self._document.session
        return Labels() if session is None else session.labels

    @property
    def _run(self) -> Run | None:
        session = self._document.session
        return None if session is None else session.corrected_run

    @property
    def _track(self) -> int:
        return self._document.selection.track

    @property
    def _author(self) -> str:
        session = self._document.session
        return "" if session is None else session.author

    def parts(self, frame: int) -> dict[int, tuple[PartLabel, bool]]:
        """The parts of the selected person and whether somebody labelled them."""
        session = self._document.session
        if session is None or not self._track:
            return {}
        return parts_of(session.labels, session.tracks, self._run, self._track, frame)

    def person_box(self, frame: int) -> Box | None:
        """Around all parts of the selected person; None where they have none."""
        boxes = [label.box for label, _ in self.parts(frame).values()]
        if not boxes:
            return None
        left, top = (min(box[at] for box in boxes) for at in (0, 1))
        right, bottom = (max(box[at] + box[at + 2] for box in boxes) for at in (0, 1))
        return left, top, right - left, bottom - top

    # what the keys say

    def plan_say(self, frame: int, on_part: bool | None) -> Change:
        """Say whether the chosen part's rectangle lies on its part.

        Raises EditError where the person has no rectangle in the frame, or in the range.
        """
        return plan_label_part(self._labels, self._said(frame, on_part))

    def is_said(self, frame: int, on_part: bool | None) -> bool:
        """Whether that was said of all it is about: an answer changes nothing.

        Raises EditError as `plan_say`.
        """
        given = self._labels.parts
        meant = self._meant(frame)
        return all(one.key in given and given[one.key].on_part is on_part for one in meant)

    def _said(self, frame: int, on_part: bool | None) -> list[PartLabel]:
        return [
            replace(one, on_part=on_part, author=self._author, reason=self._reason(one))
            for one in self._meant(frame)
        ]

    def _meant(self, frame: int) -> list[PartLabel]:
        """The rectangles an answer is about."""
        if self.choice.scope is EditScope.RANGE:
            return self._in_range()
        there = self.parts(frame).get(self.choice.part)
        if there is None:
            raise EditError(
                "{track} has no box in frame {frame}: draw one", track=self._track, frame=frame
            )
        return [there[0]]

    def _in_range(self) -> list[PartLabel]:
        marked, session = self._document.correcting.marked, self._document.session
        if marked is None:
            raise EditError("No range is set: [ sets its start, ] its end")
        found: list[PartLabel] = []
        if session is not None and self._track:
            person = (self._track, self.choice.part)
            found = parts_over(session.labels, session.tracks, self._run, person, marked)
        if not found:
            raise EditError(
                "{track} has no {part} in frames {first} to {last}: set another range",
                track=self._track,
                part=part_name(self.choice.part),
                first=marked[0],
                last=marked[1] - 1,
            )
        return found

    def _reason(self, label: PartLabel) -> str:
        """Why it was looked at, where it was suggested."""
        suggested = self.choice.suggested
        return str(suggested.reason) if suggested and suggested.key == label.key else ""

    def plan_box(self, frame: int, part: int, box: Box) -> Change:
        """Put a part's rectangle where a person drew it: it lies on its part, or is unsure."""
        there = self.parts(frame).get(part)
        unsure = there is not None and there[1] and there[0].on_part is None
        drawn = PartLabel(frame, self._track, part, box, None if unsure else True, "person")
        signed = replace(drawn, author=self._author, reason=self._reason(drawn))
        return plan_label_part(self._labels, signed)

    def plan_forget(self, frame: int) -> Change:
        """Take back what was said of the chosen part in the frame, or in the range."""
        if self.choice.scope is EditScope.FRAME:
            return plan_unlabel_part(self._labels, (frame, self._track, self.choice.part))
        keys = [one.key for one in self._in_range() if one.key in self._labels.parts]
        return plan_unlabel_part(self._labels, *keys)

    def next_scope(self) -> None:
        """R: this frame, then the range, and around again."""
        self.choice.scope = SCOPES[(SCOPES.index(self.choice.scope) + 1) % len(SCOPES)]

    # what the panel shows

    def lines(self, frame: int) -> tuple[PartLine, ...]:
        """A line a part: what was said of it in the frame, and how often in all."""
        there, counts = self.parts(frame), self.counts()
        return tuple(
            PartLine(
                part_name(part),
                SAID[there[part][0].on_part] if part in there and there[part][1] else "",
                part == self.choice.part,
                (counts[part, True], counts[part, False], counts[part, None]),
            )
            for part in range(len(PART_NAMES))
        )

    def scope_row(self) -> ChoiceRow:
        """How far an answer goes."""
        marked = self._document.correcting.marked
        over = tr("this range")
        if marked is not None:
            over = tr("frames {first} to {last}", first=marked[0], last=marked[1] - 1)
        options = (tr("this frame"), over)
        return ChoiceRow(
            0, tr("Scope"), options, SCOPES.index(self.choice.scope), shown_key("tracks.scope")
        )

    def counts(self) -> _Counts:
        """How often each part was said to be on, off and unsure; counted on from the last time."""
        before, counts = self._counted
        parts = self._labels.parts
        if parts is not before:
            gone, come = before.unlike(parts)
            counts = Counter(counts)
            counts.subtract((label.part, label.on_part) for label in gone)
            counts.update((label.part, label.on_part) for label in come)
            self._counted = (parts, counts)
        return counts
