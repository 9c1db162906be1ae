"""Which results belong to which truths: single files, or folders of many sequences."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import FormatError
from tracking.formats import FORMATS, track_endings
from tracking.translation import msg, some_of

RESULT, TRUTH = "result.txt", "truth.txt"
_CHALLENGE = Path("gt") / "gt.txt"
_DATA = "data"
"""The folder that TrackEval keeps a tracker's files in."""
_NAMED = 5


@dataclass(frozen=True, slots=True)
class Pairing:
    """What is measured against what.

    Attributes:
        truths: by name of the sequence, sorted.
        results: by name of the result, in the order they were named, then of the sequence.
        is_batch: folders of sequences were named; else one truth.
        unmatched: sequences that are left out, and why, a line each.
    """

    truths: Mapping[str, Path]
    results: Mapping[str, Mapping[str, Path]]
    is_batch: bool
    unmatched: tuple[str, ...] = ()


def pair_results(results: Sequence[Path], truth: Path) -> Pairing:
    """Put results to truths.

    A folder with truth.txt or gt/gt.txt in it is one truth, one with result.txt one result, and one
    of a format that keeps a file a frame is one file of tracks. Any other folder holds sequences:
    files, or such folders, that are named after them.

    Raises:
        FormatError: one is missing, no names agree, or folders and files do not go together.
    """
    for path in (*results, truth):
        if not path.exists():
            raise FormatError(
                "cannot read {path}: No such file or directory; check the path", path=path
            )
    if truth.is_dir() and _truth_in(truth) is None and not _is_tracks(truth):
        return _batch(results, truth)
    names = _short_names(results)
    single = {name: _result_at(path) for name, path in zip(names, results, strict=True)}
    sequence = _printable(truth.absolute().name) if truth.is_dir() else _name_of(truth)
    found = {name: {sequence: path} for name, path in single.items()}
    return Pairing({sequence: _truth_in(truth) or truth}, found, is_batch=False)


def _batch(results: Sequence[Path], truth: Path) -> Pairing:
    truths = _sequences(truth, truths=True)
    if not truths:
        raise FormatError(
            "{truth} has no {file}, nor folders or files of sequences; name a ground truth",
            truth=truth,
            file=TRUTH,
        )
    folders = [path for path in results if path.is_dir() and _result_in(path) is None]
    files = [path for path in results if path not in folders]
    found = [_sequences(folder, truths=False) for folder in folders]
    if files:  # all of them together are one result
        found.append(_by_name([_result_at(each) for each in files]))
        folders = [*folders, files[0].absolute().parent]
    by_name = dict(zip(_short_names(folders), found, strict=True))
    shared = sorted(set(truths).intersection(*by_name.values()))
    if not shared:
        raise _nothing_shared(truth, truths, by_name)
    return Pairing(
        {name: truths[name] for name in shared},
        {result: {name: found[name] for name in shared} for result, found in by_name.items()},
        is_batch=True,
        unmatched=tuple(_unmatched(truths, by_name)),
    )


def _sequences(folder: Path, *, truths: bool) -> dict[str, Path]:
    """The sequences of a folder by name; of a file and a folder of one name truths take that."""
    if not folder.is_dir():
        raise FormatError(
            "{folder} is no folder; name one with a file each sequence", folder=folder
        )
    inner = folder / _DATA
    if not truths and inner.is_dir():
        folder = inner
    entries = sorted(each for each in folder.iterdir() if not each.name.startswith("."))
    endings = track_endings()
    files = [each for each in entries if each.is_file() and each.suffix.lower() in endings]
    held = ((each, _sequence_in(each, truths=truths)) for each in entries)
    inside = _called((_printable(each.name), path) for each, path in held if path is not None)
    named = _by_name([each for each in files if not (truths and _name_of(each) in inside)])
    return {**inside, **named}


def _sequence_in(folder: Path, *, truths: bool) -> Path | None:
    """The tracks of one sequence in a folder; None where it holds none."""
    if not truths:
        return _result_in(folder)
    return _truth_in(folder) or (folder if _is_tracks(folder) else None)


def _by_name(files: Sequence[Path]) -> dict[str, Path]:
    return _called((_name_of(path), path) for path in files)


def _called(named: Iterable[tuple[str, Path]]) -> dict[str, Path]:
    """Paths by their names, of which no two may be alike."""
    found: dict[str, Path] = {}
    for name, path in named:
        if name in found:
            raise FormatError(
                "{other} and {path} are both called {name}; remove one",
                other=found[name],
                path=path,
                name=name,
            )
        found[name] = path
    return found


def _truth_in(folder: Path) -> Path | None:
    """The truth of a folder that holds one; the folder itself where it is a recording."""
    if not folder.is_dir():
        return None
    if (folder / TRUTH).is_file():
        return folder
    return folder / _CHALLENGE if (folder / _CHALLENGE).is_file() else None


def _result_in(path: Path) -> Path | None:
    """The tracks of a folder that holds one result; the folder itself where it is that."""
    if (path / RESULT).is_file():
        return path / RESULT
    return path if _is_tracks(path) else None


def _is_tracks(path: Path) -> bool:
    """Whether a folder is one file of tracks, of a format that keeps a file a frame."""
    return path.is_dir() and any(
        each.recognises_folder is not None and each.recognises_folder(path)
        for each in FORMATS.values()
    )


def _result_at(path: Path) -> Path:
    """The file of one result."""
    if not path.is_dir():
        return path
    found = _result_in(path)
    if found is None:
        raise FormatError(
            "{path} is a folder and the ground truth is one sequence; name a session or a "
            "file, or a folder of ground truths",
            path=path,
        )
    return found


def _name_of(path: Path) -> str:
    """What a sequence or a result is called after."""
    whole = path.absolute()
    if whole.parts[-2:] == _CHALLENGE.parts:
        path = whole.parent.parent
    elif path.name in (RESULT, TRUTH):
        path = whole.parent
    return _printable(path.stem if path.suffix.lower() in track_endings() else path.name)


def _printable(name: str) -> str:
    """A name from a disk, fit to be written anywhere: nothing in it steers a terminal."""
    return "".join(letter if letter.isprintable() else "?" for letter in name)


def _short_names(paths: Sequence[Path]) -> list[str]:
    """A name each, all different: as many of the last parts of a path as that takes."""
    whole = [path.absolute() for path in paths]
    ends = [path.parent if path.name in (RESULT, _DATA) else path for path in whole]
    parts = [(*map(_printable, each.parts[:-1]), _name_of(each)) for each in ends]
    for taken in range(1, max(map(len, parts), default=0) + 1):
        names = ["/".join(each[-taken:]) for each in parts]
        if len(set(names)) == len(names):
            return names
    counts: Counter[str] = Counter()
    for number, name in enumerate(names):
        counts[name] += 1
        if counts[name] > 1:
            names[number] = f"{name} ({counts[name]})"
    return names


def _nothing_shared(
    truth: Path, truths: Mapping[str, Path], results: Mapping[str, Mapping[str, Path]]
) -> FormatError:
    return FormatError(
        "no result is named like a ground truth of {truth}: truths {truths}; results {results}; "
        "name them alike",
        truth=truth,
        truths=_listed(truths),
        results=_listed({name for found in results.values() for name in found}),
    )


def _unmatched(truths: Mapping[str, Path], results: Mapping[str, Mapping[str, Path]]) -> list[str]:
    said: list[str] = []
    for result, found in results.items():
        if lacking := sorted(set(truths) - set(found)):
            said.append(
                msg("{result} has no file for {names}", result=result, names=_listed(lacking))
            )
        if strange := sorted(set(found) - set(truths)):
            said.append(
                msg(
                    "{result} has files without ground truth: {names}",
                    result=result,
                    names=_listed(strange),
                )
            )
    return said


def _listed(names: Mapping[str, Path] | Sequence[str] | set[str]) -> str:
    return some_of(sorted(names), _NAMED) or msg("none")
