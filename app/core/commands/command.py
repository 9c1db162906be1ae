"""A command, and what says whether it can be done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace


@dataclass(frozen=True, slots=True)
class CommandContext:
    """What commands depend on.

    Attributes:
        recording, session: open. tracks: there is something to select. selected: somebody is.
        editing: a preview waits for Enter. placing: it is one of a box.
        live: a tracker is at work. in_the_way: what is to be done before tracks can be corrected,
            as its people are shown; "" for nothing. further: they are shown until the playhead is
            moved. busy: other long work is going on.
        labelling: something is being labelled. saying: it is body parts. suggesting: those of
            which the detector is least sure are walked.
        review_items: the review queue lists some. review_item: one of them is looked at;
            fixable: an edit would put it right. watched: a stretch was just watched. unflagged:
            no tracker made the tracks, and nobody has asked for review items.
        comparing: two versions of the tracks are compared. unkept: what a tracker found is in
            memory alone.
        parts: body parts were tracked. parts_elsewhere: in another run alone. part_truth:
            where they really are is known.
        trained: a detector was trained here. detector: the name of the one in use; "" for the
            built-in one.
        scored: tracks were compared with a truth.
        stereo, truth: the recording has a right camera, a truth file.
        can_track: a tracker exists for the recording; else `why_no_tracking` says why.
        read_only: the session cannot be saved under its name, e.g. as another window has it open.
    """

    recording: bool = False
    session: bool = False
    tracks: bool = False
    selected: bool = False
    editing: bool = False
    labelling: bool = False
    saying: bool = False
    suggesting: bool = False
    review_items: bool = False
    review_item: bool = False
    unflagged: bool = False
    fixable: bool = False
    watched: bool = False
    comparing: bool = False
    unkept: bool = False
    placing: bool = False
    live: bool = False
    in_the_way: str = ""
    further: bool = False
    busy: bool = False
    can_undo: bool = False
    can_redo: bool = False
    parts: bool = False
    parts_elsewhere: bool = False
    part_truth: bool = False
    trained: bool = False
    scored: bool = False
    detector: str = ""
    stereo: bool = False
    truth: bool = False
    calibrated: bool = False
    can_track: bool = False
    why_no_tracking: str = ""
    read_only: bool = False

    def while_busy(self) -> CommandContext:
        """The same while other long work is going on."""
        return replace(self, busy=True)


Check = Callable[[CommandContext], str]
"""Why a command cannot be done now; "" where it can."""


@dataclass(frozen=True, slots=True)
class Command:
    """One command.

    Attributes:
        name: e.g. "edit.swap". menu: one of `MENUS`. submenu: a menu inside it; "" for none.
        title: English, translated when shown. keys: default keys, in Qt's portable text.
        check: why it cannot be done now.
        checkable: it is on or off.
        separated: a line stands above it, or above the submenu that begins with it.
        icon: of the drawings that ship with the program; "" for none.
        now: what stands in brackets behind the title, e.g. a file in use; "" for nothing.
        alone: the title where the recording has one camera; "" for the same.
        also: further words that the search finds it by.
    """

    name: str
    menu: str
    title: str
    keys: tuple[str, ...] = ()
    check: Check = lambda _: ""
    checkable: bool = False
    separated: bool = False
    icon: str = ""
    submenu: str = ""
    now: Callable[[CommandContext], str] = lambda _: ""
    alone: str = ""
    also: str = ""
