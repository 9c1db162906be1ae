"""What a kind of recording is: how it is recognised, and what it is made of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from tracking.recording.depth_pictures import USUAL_SCALE_M
from tracking.recording.image_pairs import Layout
from tracking.translation import Message


@dataclass(frozen=True, slots=True)
class FoundSources:
    """What a folder or file of another program holds.

    Attributes:
        left: the left (or only) camera's source. right, depth: None where there is none.
        calibration: its files, none, one or two.
        fps: frames a second where the kind has one rate and its files do not tell theirs.
        layout: how both cameras lie in `left`; None: it holds one.
        depth_scale_m: metres of a unit of depth.
        topics: of left, right and depth, where the source is a bag.
        name: for people; "": that of the folder.
        notes: what was taken for granted, in words.
    """

    left: Path
    right: Path | None = None
    depth: Path | None = None
    calibration: tuple[Path, ...] = ()
    fps: float | None = None
    layout: Layout | None = None
    depth_scale_m: float = USUAL_SCALE_M
    topics: tuple[str, str, str] = ("", "", "")
    name: str = ""
    notes: tuple[Message, ...] = ()


@dataclass(frozen=True, slots=True)
class RecordingKind:
    """One entry of the catalogue.

    Attributes:
        name: in lower case, for lists. about: a line for people.
        find: what stands at a path, a file or a folder, told by its contents; None where it is not
            of this kind. It raises RecordingError where it is, and cannot be opened.
    """

    name: str
    about: str
    find: Callable[[Path], FoundSources | None]
