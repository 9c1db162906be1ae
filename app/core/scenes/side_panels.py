"""What the panels at the side show: a track, the history, an edit that waits."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes.attribute_fields import AttributeField
from app.core.scenes.frame_scenes import Colour


@dataclass(frozen=True, slots=True)
class TrackCard:
    """The selected track in words; with `others` who are selected too.

    Attributes:
        frames_seen: in which it was seen, or drawn by hand; the other frames are counted apart: a
            tracker `predicted` it there, somebody had it `interpolated`, or said it is `occluded`.
        attributes: the person's own. fields: those of the schema.
    """

    track: int
    name: str
    colour: Colour
    first_frame: int
    last_frame: int
    frames_seen: int
    frames_predicted: int
    mean_confidence: float
    attributes: tuple[tuple[str, str], ...]
    notes: str
    others: tuple[int, ...] = ()
    frames_interpolated: int = 0
    frames_occluded: int = 0
    fields: tuple[AttributeField, ...] = ()


@dataclass(frozen=True, slots=True)
class HistoryItem:
    """One edit in the history panel; undone edits are shown greyed.

    Attributes:
        kind: one word, e.g. "swap".
        taken_by: the later edit that takes this one back alone; 0: none.
        moved: how it moved the score, e.g. "HOTA ▲ +0.012"; "" where that is not known.
    """

    edit: int
    text: str
    when: str
    author: str
    frame: int
    undone: bool
    kind: str = ""
    taken_by: int = 0
    moved: str = ""


@dataclass(frozen=True, slots=True)
class ChoiceRow:
    """Something of an edit that can be chosen.

    Attributes:
        row: its number. title: e.g. "Scope". options: e.g. "from here on", "this range".
        chosen: the number of the one in force. key: the one that goes on to the next.
    """

    row: int
    title: str
    options: tuple[str, ...]
    chosen: int
    key: str


@dataclass(frozen=True, slots=True)
class Proposal:
    """Something the program found that may be meant: a person, a frame.

    Attributes:
        number: an id, or which of the proposals it is. chosen: it is the one in force.
        colour: of the person, None for a frame. why: said when the mouse rests on it.
    """

    number: int
    text: str
    chosen: bool
    colour: Colour | None = None
    why: str = ""


@dataclass(frozen=True, slots=True)
class EditPreview:
    """An edit that waits for Enter.

    Attributes:
        title: e.g. "Swap 4 and 7 from frame 834 on".
        details: lines that say what will change.
        frame: the cut, moved by the arrow keys, where it `has_cut`.
        begins: the edit begins at that frame; else it is one inside of what is changed.
        gives: the second person takes over from the first, as in giving rows to an id.
        end: one past the last frame of a range; None where the edit goes over none.
        choices: what can be chosen.
        other: id of the second person, 0 while they are to be picked, None where none is needed.
        others: who may be meant. cuts: frames where two people may have changed over.
        ready: False while the other person is still to be picked; Enter does nothing then.
        hint: the keys that work now beside Enter and Esc, e.g. "Left / Right move the frame".
    """

    title: str
    details: tuple[str, ...]
    frame: int
    end: int | None = None
    choices: tuple[ChoiceRow, ...] = ()
    other: int | None = None
    others: tuple[Proposal, ...] = ()
    cuts: tuple[Proposal, ...] = ()
    has_cut: bool = True
    begins: bool = True
    gives: bool = False
    ready: bool = True
    hint: str = ""
