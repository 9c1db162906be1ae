"""How an annotator works: box after box, edits without a preview, a copied box."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from app.core.editing.flow import EditFlow
from app.core.editing.suggested_boxes import Ghost
from app.core.i18n import count_text, tr
from app.core.keymap import key_or_title
from tracking.tracks import Box, Source, TrackTable


class NextBox(Enum):
    """Which track the next drawn box belongs to."""

    AUTO = "the selected person's, unless theirs is drawn in this frame already"
    NEW = "a new person's"
    SELECTED = "the selected person's"


@dataclass(slots=True)
class AnnotationMode:
    """What an annotator has switched on.

    Attributes:
        drawing: boxes are drawn one after the other, until Esc.
        step: frames the playhead goes on after each box; 0: it stays.
        at_once: edits of one person are done without a preview. two_at_once: those of two people,
            too.
        next_box: whose the next box is. copied: the box that can be put elsewhere.
        attribute: which digit keys set; "": none.
        dismissed: tracks whose ghost is not shown any more, each with the frame of its last box.
    """

    drawing: bool = False
    step: int = 0
    at_once: bool = False
    two_at_once: bool = False
    next_box: NextBox = NextBox.AUTO
    copied: Box | None = None
    attribute: str = ""
    dismissed: dict[int, int] = field(default_factory=dict)

    def does_at_once(self, flow: EditFlow) -> bool:
        """Whether an edit is done as soon as it can be; one that puts a box waits for that."""
        if flow.spec.at_once:
            return True
        if flow.places:
            return False
        return self.two_at_once if flow.spec.of_two else self.at_once

    def begins_new(self, table: TrackTable, track: int, frame: int) -> bool:
        """Whether the next box begins a new track; track: who is selected, 0 for nobody."""
        if not track or self.next_box is NextBox.NEW:
            return True
        if self.next_box is NextBox.SELECTED:
            return False
        row = table.of_track(track, frame, frame + 1)
        return len(row["source"]) > 0 and row["source"][0] == Source.PERSON

    def is_waited_for(self, ghost: Ghost) -> bool:
        """Whether somebody without a box may still come; a later box of theirs says so anew."""
        return self.dismissed.get(ghost.track) != ghost.frame

    def words(self, name: str, *, guesses: bool = False) -> str:
        """What the next drag over the picture does.

        Args:
            name: of whom the box will be, "": somebody new.
            guesses: it is given to who is expected where it lies.
        """
        whose = tr("Drag to draw {name}", name=name) if name else tr("Drag to draw a new person")
        if guesses and name:
            whose = tr("Drag to draw who is expected there, else {name}", name=name)
        elif guesses:
            whose = tr("Drag to draw who is expected there, else a new person")
        on = count_text(self.step, "then {n} frame on", "then {n} frames on") if self.step else ""
        parts = (whose, on, tr("{key} ends drawing", key=key_or_title("tracks.none")))
        return "  \u00b7  ".join(part for part in parts if part)
