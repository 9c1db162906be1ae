"""`seqinfo.ini`: what MOTChallenge says of a sequence, in the folder that holds `gt` and `det`."""

from __future__ import annotations

import configparser
from dataclasses import dataclass
from pathlib import Path

from tracking.formats.read_result import Reading
from tracking.formats.track_writer import Exported
from tracking.translation import msg

NAME = "seqinfo.ini"
_INSIDE = ("gt", "det")
"""Folders of a sequence in which its texts stand."""
_SECTION = "Sequence"
_MOST_BYTES = 1 << 16
_MOST_FRAMES, _MOST_FPS, _MOST_PIXELS = 10_000_000, 10_000.0, 1_000_000


@dataclass(frozen=True, slots=True)
class Sequence:
    """What is said of the footage; None where nothing is.

    Attributes:
        name: of the sequence. fps: frames a second. frames: how many. size_px: width and height.
    """

    name: str = ""
    fps: float | None = None
    frames: int | None = None
    size_px: tuple[int, int] | None = None


def place_for(text: Path) -> Path:
    """Where the description of a text's sequence stands."""
    folder = text.parent
    return (folder.parent if folder.name in _INSIDE else folder) / NAME


def sequence_of(text: Path, reading: Reading) -> Sequence:
    """What stands beside a MOT text; a description that cannot be read is noted and left out."""
    path = place_for(text)
    if not path.is_file():
        return Sequence()
    try:
        if path.stat().st_size > _MOST_BYTES:
            raise ValueError("it is far too long")
        parser = configparser.ConfigParser(interpolation=None)
        parser.read_string(path.read_text(encoding="utf-8-sig"))
        return _checked(parser[_SECTION])
    except (OSError, ValueError, KeyError, configparser.Error) as why:
        reason = str(why).splitlines()[0] if str(why) else type(why).__name__
        reading.notes.append(msg("{path} is left out: {reason}", path=path, reason=reason))
        return Sequence()


def sequence_text(exported: Exported) -> str:
    """The description of what is exported."""
    width, height = exported.size_px or (0, 0)
    return (
        f"[{_SECTION}]\n"
        f"name={' '.join(exported.name.split()) or 'sequence'}\n"
        "imDir=img1\n"
        f"frameRate={exported.fps or 0:g}\n"
        f"seqLength={exported.frames}\n"
        f"imWidth={width}\n"
        f"imHeight={height}\n"
        "imExt=.jpg\n"
    )


def _checked(section: configparser.SectionProxy) -> Sequence:
    """Raises ValueError for invalid numbers; 0 is as good as none."""
    fps, frames = section.getfloat("frameRate", 0.0), section.getint("seqLength", 0)
    size = section.getint("imWidth", 0), section.getint("imHeight", 0)
    for value, most, key in (
        (fps, _MOST_FPS, "frameRate"),
        (frames, _MOST_FRAMES, "seqLength"),
        (size[0], _MOST_PIXELS, "imWidth"),
        (size[1], _MOST_PIXELS, "imHeight"),
    ):
        if not 0 <= value <= most:
            raise ValueError(msg("{key} is {value:g}", key=key, value=value))
    return Sequence(
        section.get("name", ""), fps or None, frames or None, size if all(size) else None
    )
