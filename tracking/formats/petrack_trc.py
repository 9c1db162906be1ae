"""PeTrack's own `.trc` files, read: for each person the points of the picture they were at.

The first line is `version N` (2 to 5; version 1 has none), the second the number of people. A
person is a line of numbers (`nr height firstFrame lastFrame colCount r g b markerID n`; no
`markerID` before version 4), from version 3 on a line of comment that may be empty, and n lines of
points, one a frame (`x y spX spY spZ qual colX colY r g b markerID`; no `spX spY spZ` in version 1,
no `markerID` before version 3). Frames count from 0. PeTrack writes `nr` 0 for everybody and
numbers people by their order in the file, from 1: so do ids here, as in its text exports.

A point is a box without size: it tells where a head is, and nothing of how large anybody is. It is
in pixels of the picture as PeTrack shows it, which is without lens distortion where PeTrack has a
calibration; the file does not say whether it had. `qual` is percent of confidence (below 100: not
recognised but followed), the comment, the height in cm and the marker are attributes of the track.
Places on the floor are not in the file: PeTrack tells them in its text and HDF5 exports. Where the
file has the height of a person and the recording a floor, the place is that of the head at this
height, as PeTrack tells it.

Source: PeTrack's parseTrackPerson and TrcLineParser, and its writers in trackPerson and trackPoint.
"""

from __future__ import annotations

import re
from array import array
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.label_text import label_of
from tracking.formats.line_survey import MOST_ROWS
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import MAX_FRAME
from tracking.formats.text_fields import number_in, numbered_lines, whole_in
from tracking.formats.track_format import TrackFormat
from tracking.progress import Progress, no_progress
from tracking.tracks import TrackLabel
from tracking.translation import msg

_VERSION = re.compile(
    rb"(?:\xef\xbb\xbf)?version +(\d{1,9})\r?\n\s*\d+\s*(?:\r?\n|$)", re.IGNORECASE
)
_VERSION_LINE = re.compile(r"version +(\d{1,9})\s*", re.IGNORECASE)
_FIRST_VERSION = re.compile(
    rb"(?:\xef\xbb\xbf)?\d{1,9}\s*\n\s*-?\d+ -?[\d.eE+]+ \d+ \d+ -?\d+ -?\d+ -?\d+ -?\d+ \d+\s*\n"
)
_NEWEST = 5
_HAS_COMMENT, _HAS_PERSON_MARKER, _HAS_POINT_MARKER, _HAS_STEREO = 3, 4, 3, 2
"""The first version with each."""
_UNKNOWN_HEIGHT = -99_999.0
"""PeTrack's MIN_HEIGHT and 1: below it nobody measured a height."""
_TALLEST_CM = 300.0
"""A height beyond that, or not above 0, is no person's: no place is told by it."""
_NO_MARKER = -1
_FULL_QUALITY = 100.0
"""PeTrack gives 110 to points that a person sets, and cuts that to 100 later on."""
_MOST_PEOPLE = 200_000


@dataclass(frozen=True, slots=True)
class _Person:
    """What the line of a person says: where the track begins, and how many points follow."""

    first_frame: int
    points: int
    height_cm: float
    marker: int


def looks_like_trc(_path: Path, head: bytes) -> bool:
    """Whether a file begins as PeTrack's own, with a version or as its first version does."""
    return _VERSION.match(head) is not None or _FIRST_VERSION.match(head) is not None


def import_trc(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a file. Raises FormatError where it is no such file, or ends too early."""
    reading = Reading(path, report)
    file = _File(reading)
    for number, text in numbered_lines(path, report):
        file.take(number, text)
    return file.imported()


class _File:
    """Takes a file in, line by line."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading
        self._version = 0
        self._people: int | None = None
        self._labels: dict[int, TrackLabel] = {}
        self._heights_m: dict[int, float] = {}
        self._met = 0
        self._person: _Person | None = None
        self._awaits_comment = False
        self._comment = ""
        self._at = 0
        self._whole, self._numbers = array("q"), array("d")  # frame, id, line; x, y, confidence

    def take(self, number: int, text: str) -> None:
        """One line. Raises FormatError where what follows cannot be told without it."""
        if self._awaits_comment:
            self._comment, self._awaits_comment = text.replace("<br>", " "), False
            self._keep_label()
        elif not text.strip():
            return
        elif self._people is None:
            self._begin(number, text)
        elif self._person is None:
            self._take_person(number, text)
        else:
            self._take_point(number, text)

    def imported(self) -> Imported:
        """The tracks. Raises FormatError where the file ends within them."""
        path = self._reading.path
        if self._people is None:
            raise FormatError(
                "{path} is cut short: it ends before the number of people; export it again",
                path=path,
            )
        if self._person is not None or self._met < self._people:
            raise FormatError(
                "{path} is cut short: it ends within person {person} of {people}; export it again",
                path=path,
                person=max(self._met, 1),
                people=self._people,
            )
        self._reading.notes.append(
            msg("boxes have no size: PeTrack's file tells points of heads alone")
        )
        frame, track, line = np.asarray(self._whole, np.int64).reshape(-1, 3).T
        x, y, confidence = np.asarray(self._numbers).reshape(-1, 3).T
        rows: dict[str, NDArray[Any]] = {
            "frame": frame,
            "track": track,
            "left": x,
            "top": y,
            "width": np.zeros(len(x)),
            "height": np.zeros(len(x)),
            "confidence": confidence,
        }
        return self._reading.imported(
            rows,
            lambda row: msg("line {line}", line=line[row]),
            labels=self._labels,
            boxes_reach_feet=False,
            head_heights_m=self._heights_m,
        )

    def _begin(self, number: int, text: str) -> None:
        """The version, or the number of people."""
        if not self._version and (found := _VERSION_LINE.fullmatch(text)):
            self._version = int(found[1])
            if not _HAS_STEREO <= self._version <= _NEWEST:
                raise FormatError(
                    "{path} is of version {version}; versions 1 to {newest} are read, export "
                    "PeTrack's text instead",
                    path=self._reading.path,
                    version=self._version,
                    newest=_NEWEST,
                )
            return
        count = whole_in(text)
        if count is None or count > _MOST_PEOPLE:
            raise self._wrong(number, msg("{text!r} is no number of people", text=text[:40]))
        self._version, self._people = self._version or 1, count

    def _take_person(self, number: int, text: str) -> None:
        if self._met == self._people:
            raise self._wrong(
                number,
                msg("there is more than the {people} people it announces", people=self._people),
            )
        fields = text.split()
        expected = 9 + (self._version >= _HAS_PERSON_MARKER)
        if len(fields) != expected:
            raise self._wrong(
                number,
                msg(
                    "{count} values where a person has {expected}",
                    count=len(fields),
                    expected=expected,
                ),
            )
        first, points = whole_in(fields[2]), whole_in(fields[-1])
        height = number_in(fields[1])
        marker = number_in(fields[8]) if expected > 9 else _NO_MARKER
        if first is None or points is None or height is None or marker is None:
            raise self._wrong(number, msg("the line of a person is not all numbers"))
        if points < 1 or first >= MAX_FRAME:
            raise self._wrong(
                number,
                msg("{points} points from frame {first} on cannot be", points=points, first=first),
            )
        self._person, self._at = _Person(first, points, height, int(marker)), 0
        self._met += 1
        if 0 < height <= _TALLEST_CM:
            self._heights_m[self._met] = height / 100
        self._comment, self._awaits_comment = "", self._version >= _HAS_COMMENT
        self._keep_label()

    def _keep_label(self) -> None:
        person = self._person
        assert person is not None
        said = {"comment": self._comment}
        said["height_cm"] = f"{person.height_cm:g}" if person.height_cm > _UNKNOWN_HEIGHT else ""
        said["marker"] = str(person.marker) if person.marker != _NO_MARKER else ""
        label = label_of(attributes=said)
        if not label.is_empty:
            self._labels[self._met] = label

    def _take_point(self, number: int, text: str) -> None:
        person = self._person
        assert person is not None
        frame = person.first_frame + self._at
        self._at += 1
        if self._at == person.points:
            self._person = None
        point = self._point_of(text)
        if isinstance(point, str):
            self._reading.bad(msg("line {number}", number=number), point)
            return
        self._whole.extend((frame, self._met, number))
        self._numbers.extend(point)
        self._reading.good += 1
        if self._reading.good > MOST_ROWS:
            raise FormatError(
                "{path} has more than {most} points; split it",
                path=self._reading.path,
                most=MOST_ROWS,
            )

    def _point_of(self, text: str) -> tuple[float, float, float] | str:
        """Place and confidence; why they are none as text."""
        fields = text.split()
        stereo = 3 * (self._version >= _HAS_STEREO)
        expected = 8 + stereo + (self._version >= _HAS_POINT_MARKER)
        if len(fields) != expected:
            return msg(
                "{count} values where a point has {expected}", count=len(fields), expected=expected
            )
        x, y = number_in(fields[0]), number_in(fields[1])
        quality = number_in(fields[2 + stereo])
        if x is None or y is None or quality is None:
            return msg("its place or quality is not a number")
        if quality < 0:
            return msg("its quality is {quality:g}, below 0", quality=quality)
        return x, y, min(quality, _FULL_QUALITY) / _FULL_QUALITY

    def _wrong(self, number: int, reason: str) -> FormatError:
        return FormatError(
            "{path}, line {number}: {reason}; export it again",
            path=self._reading.path,
            number=number,
            reason=reason,
        )


PETRACK_TRC = TrackFormat(
    "petrack-trc", "PeTrack's own trajectories, .trc", (".trc",), looks_like_trc, import_trc
)
