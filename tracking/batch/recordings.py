"""Which recordings words on a command line mean: paths, folders of recordings, patterns, lists."""

from __future__ import annotations

import glob
import hashlib
import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from tracking.batch.order import BatchOrder
from tracking.errors import RecordingError, TrackwrightError
from tracking.translation import Message, message_of, msg

VIDEO_ENDINGS = frozenset(
    {".mp4", ".avi", ".mkv", ".mov", ".m4v", ".mpg", ".mpeg", ".webm", ".wmv", ".ts", ".mts"}
)
_OTHER_ENDINGS = frozenset({".bag", ".mcap", ".db3", ".tar", ".svo", ".svo2"})
"""Of files that hold the pictures of several cameras."""
MANIFEST = "recording.toml"
"""As in `tracking.recording`, which takes longer to import than all this needs."""
_PATTERN = re.compile(r"[*?[]")
_LIST_ENDINGS = (".txt", ".lst")
_MOST_LIST_BYTES = 64 << 20
DEEPEST = 6
"""Folders within folders that are searched for recordings."""
_LONGEST_NAME = 120
_SAID_DIGITS = 8
_RESERVED = ("index.html",)
"""What stands beside the folders of recordings in a report."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One recording of a batch.

    Attributes:
        name: of its session, without the ending; unlike all others, also where case counts not.
        path: what is opened.
    """

    name: str
    path: Path


@dataclass(slots=True)
class Found:
    """What the words mean.

    Attributes:
        paths: of recordings, in order, each once.
        missing: words that mean no recording, and why. empty: folders without one, and why.
    """

    paths: list[Path] = field(default_factory=list)
    missing: dict[Path, Message] = field(default_factory=dict)
    empty: dict[Path, Message] = field(default_factory=dict)


def find_recordings(
    words: Sequence[str], leave_out: Path | None = None, listed: Path | None = None
) -> Found:
    """The recordings that words mean.

    A recording's folder or a video is itself; any other folder is searched, and so is what a
    pattern (`*`, `?`, `[...]`) fits; a text file is a list of such words, one a line.

    Args:
        words: paths, patterns and lists.
        leave_out: a folder that is not searched, for what is made there.
        listed: a list of more words, whatever it is called.

    Raises RecordingError where a list cannot be read.
    """
    found = Found()
    search = _Search(found, leave_out.resolve() if leave_out is not None else None)
    for word in words:
        search.add_word(Path(word), word)
    if listed is not None:
        search.add_list(listed)
    return found


def named_entries(paths: Sequence[Path], known: Mapping[Path, str] | None = None) -> list[Entry]:
    """Recordings with names, which are the same whatever the order and however many start.

    A recording is called after its folder or file, and where several would have one name also
    after the folders above it.

    Args:
        known: names that recordings have already; these stay, and no other one gets them.
    """
    known = known or {}
    taken = {name.casefold() for name in (*known.values(), *_RESERVED)}
    names = dict(zip(paths, _short_names(paths), strict=True))
    for path, name in names.items():
        if path not in known and name.casefold() in taken:
            names[path] = f"{name}-{_said(path)}"
    return [Entry(known.get(path) or names[path], path) for path in paths]


def is_name(text: str) -> bool:
    """Whether a text can be a recording's name: what is read from a file may be anything."""
    longest = _LONGEST_NAME + len("-") + _SAID_DIGITS
    return _file_name(text) == text and len(text) <= longest and text.casefold() not in _RESERVED


def is_recording(path: Path) -> bool:
    """Whether something at a path would be opened as one recording; nothing of it is read."""
    try:
        if path.is_dir():
            if (path / MANIFEST).exists():
                return True
            return not _holds_recordings(path) and _is_located(path)
        return path.suffix.lower() in VIDEO_ENDINGS or _has_sources(path)
    except (TrackwrightError, OSError):
        return False


def _holds_recordings(folder: Path) -> bool:
    """Whether a folder has recordings in it, and so is none itself."""
    with os.scandir(folder) as held:
        return any(each.is_dir() and os.path.exists(f"{each.path}/{MANIFEST}") for each in held)  # noqa: PTH110


def _is_located(folder: Path) -> bool:
    """The same of a folder without a manifest. Raises RecordingError."""
    from tracking.recording.locate import locate  # brings what reads pictures
    from tracking.recording.options import OpenOptions

    locate(folder, OpenOptions())
    return True


def _has_sources(path: Path) -> bool:
    if path.suffix.lower() not in _OTHER_ENDINGS:
        return False
    from tracking.recording.kinds.catalogue import find_sources  # brings what reads pictures

    return find_sources(path) is not None


def _is_pattern(text: str) -> bool:
    return _PATTERN.search(text) is not None


class _Search:
    def __init__(self, found: Found, leave_out: Path | None) -> None:
        self._found, self._leave_out = found, leave_out
        self._seen: set[Path] = set()
        self._lists: set[Path] = set()

    def add_word(self, path: Path, word: str) -> None:
        """Add what a word means; path: the same, from where it is meant."""
        if not path.exists() and _is_pattern(word):
            fitting = sorted(glob.glob(word, recursive=True))  # noqa: PTH207 - absolute ones, too
            for each in fitting:
                self._add_path(Path(each), named=False)
            if not fitting:
                self._found.missing[path] = msg("nothing fits {word}; check it", word=word)
        elif path.suffix.lower() in _LIST_ENDINGS and path.is_file():
            self.add_list(path)
        else:
            self._add_path(path, named=True)

    def add_list(self, path: Path) -> None:
        """Add what a list names, relative to its folder."""
        if path.resolve() in self._lists:
            return
        self._lists.add(path.resolve())
        for word in read_list(path):
            place = path.parent / word
            self.add_word(place, str(place))

    def _add_path(self, path: Path, *, named: bool) -> None:
        """named: a word means it, not only a pattern that fits."""
        if not path.exists():
            self._found.missing[path] = msg("{path}: no such recording; check the path", path=path)
        elif path.is_dir() and not is_recording(path):
            if not self._search(path, 0):
                told = self._found.missing if named else self._found.empty
                told[path] = msg("no recording is in this folder")
        elif path.is_dir() or named or is_recording(path):
            self._keep(path)

    def _search(self, folder: Path, depth: int) -> int:
        """Add what is below a folder; how many recordings there are."""
        if depth > DEEPEST or folder.resolve() == self._leave_out:
            return 0
        count = 0
        for each in _entries(folder):
            if is_recording(each):
                if each.resolve() != self._leave_out:
                    self._keep(each)
                    count += 1
            elif each.is_dir() and not each.is_symlink():
                inside = self._search(each, depth + 1)
                count += inside
                if not inside and depth == 0 and each.resolve() != self._leave_out:
                    self._found.empty[each] = msg("no recording is in this folder")
        return count

    def _keep(self, path: Path) -> None:
        if path.name == MANIFEST:
            path = path.parent
        real = path.resolve()
        if real not in self._seen:
            self._seen.add(real)
            self._found.paths.append(Path(os.path.abspath(path)))  # noqa: PTH100 - links stay


def read_list(path: Path) -> list[str]:
    """The words of a list: a line each, without empty lines and those that begin with #.

    Raises RecordingError where it cannot be read.
    """
    try:
        if path.stat().st_size > _MOST_LIST_BYTES:
            raise RecordingError("{path} is too large for a list of recordings", path=path)
        lines = path.read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise RecordingError(
            "cannot read {path}: {reason}; check the path", path=path, reason=error.strerror
        ) from error
    except UnicodeDecodeError as error:
        raise RecordingError(
            "{path} is no list of recordings: it is not UTF-8 text; give one path a line", path=path
        ) from error
    words = (line.strip() for line in lines)
    return [word for word in words if word and not word.startswith("#")]


def detections_of(pattern: str, entry: Entry) -> Path:
    """The file of boxes that a pattern means for a recording.

    `{folder}` stands for the recording's folder, `{name}` for its name in the batch, `{stem}` for
    the name of its file or folder. A pattern without any of them is looked for in the folder; `*`
    and `?` fit one file.

    Raises RecordingError where no file, or more than one, is there; a wrong `{...}` stays as it is.
    """
    folder = entry.path if entry.path.is_dir() else entry.path.parent
    values = {"{folder}": folder, "{name}": entry.name, "{stem}": entry.path.stem}
    text = pattern
    for place, value in values.items():
        literal = glob.escape(str(value)) if _is_pattern(pattern) else str(value)
        text = text.replace(place, literal)
    if text == pattern and not os.path.isabs(pattern):  # noqa: PTH117 - a pattern is no path
        base = glob.escape(str(folder)) if _is_pattern(pattern) else str(folder)
        text = os.path.join(base, pattern)  # noqa: PTH118
    if not _is_pattern(pattern):
        fitting = [text] if Path(text).exists() else []
    else:
        fitting = sorted(glob.glob(text))  # noqa: PTH207 - absolute ones, too
    if len(fitting) != 1:
        raise RecordingError(
            "no detections are at {text}; check --detections"
            if not fitting
            else "{n} files fit {text}: detections of a recording are one; check --detections",
            text=text,
            n=len(fitting),
        )
    return Path(fitting[0]).absolute()


def boxes_of_entry(entry: Entry, order: BatchOrder) -> tuple[Path, ...]:
    """The files of boxes that a recording is tracked with: the left camera's, the right one's.

    Raises RecordingError as `detections_of`.
    """
    patterns = (order.detections, order.detections_right)
    return tuple(detections_of(pattern, entry) for pattern in patterns if pattern)


def reason_of(error: BaseException) -> Message:
    """Why a recording failed, as a message."""
    return error.message if isinstance(error, TrackwrightError) else message_of(error)


def _entries(folder: Path) -> Iterator[Path]:
    try:
        yield from sorted(each for each in folder.iterdir() if not each.name.startswith("."))
    except OSError:
        return


def _short_names(paths: Sequence[Path]) -> list[str]:
    """As few of the last parts of each path as make its name unlike all others."""
    parts = [_parts(path) for path in paths]
    taken = [1] * len(parts)
    names = [_joined(each, 1) for each in parts]
    while True:
        counts = Counter(name.casefold() for name in names)
        longer = [
            number
            for number, name in enumerate(names)
            if counts[name.casefold()] > 1 and taken[number] < len(parts[number])
        ]
        if not longer:
            break
        for number in longer:
            taken[number] += 1
            names[number] = _joined(parts[number], taken[number])
    counts = Counter(name.casefold() for name in names)
    return [
        f"{name}-{_said(path)}" if counts[name.casefold()] > 1 else name
        for name, path in zip(names, paths, strict=True)
    ]


def _parts(path: Path) -> list[str]:
    whole = Path(os.path.abspath(path))  # noqa: PTH100 - links stay as they are named
    last = whole.stem if whole.suffix.lower() in VIDEO_ENDINGS else whole.name
    return [_file_name(part) for part in (*whole.parts[1:-1], last)]


def _joined(parts: Sequence[str], taken: int) -> str:
    return "-".join(parts[-taken:])[-_LONGEST_NAME:].lstrip(". ")  # where it is cut


def _file_name(name: str) -> str:
    """A name that any disk takes and nothing hides: no separators, controls or leading dots."""
    clean = "".join(
        sign if sign.isprintable() and sign not in '/\\:*?"<>|' else "_" for sign in name
    )
    return clean.strip(". ") or "recording"


def _said(path: Path) -> str:
    whole = os.path.abspath(path)  # noqa: PTH100
    return hashlib.sha256(os.fsencode(whole)).hexdigest()[:_SAID_DIGITS]


def shard_of(entries: Iterable[Entry], number: int, count: int) -> list[Entry]:
    """Every count-th entry from the number-th on, counted from 1."""
    return list(entries)[number - 1 :: count]
