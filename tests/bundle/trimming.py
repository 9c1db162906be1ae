"""What the folder with the program does not need; the spec and the build leave it out.

Entries are PyInstaller's: where a file goes in the folder, where it comes from, and its kind.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable, Iterable
from pathlib import Path

Entry = tuple[str, str, str]

MODULES = (
    *("tkinter", "matplotlib", "pandas", "IPython", "pytest", "setuptools", "pip"),
    "PySide6.QtNetwork",
    "zstandard._cffi",  # of PyPy
    *(f"scipy.{name}" for name in ("cluster", "datasets", "io", "odr", "signal")),
    *(
        f"sklearn.{name}"
        for name in (
            *("cluster", "compose", "cross_decomposition", "datasets", "decomposition"),
            *("ensemble", "feature_selection", "gaussian_process", "impute", "inspection"),
            *("manifold", "mixture", "naive_bayes", "neighbors", "neural_network"),
            *("semi_supervised", "tree"),
        )
    ),
)
"""Not imported by anything of ours, nor by what trains a detector (`sklearn.svm`)."""
_FILES = re.compile(
    # GTK's theme would drag GTK of the building machine along.
    r"libqgtk3|libgtk|libgdk|libatk|libpango|libcairo|libthai|libdatrie|libgraphite"
    # Screens of machines without a window system are none of ours.
    r"|libqeglfs|libQt6EglF|egldeviceintegrations|libqlinuxfb|libqvnc|libqvkkhr|plugins/generic"
    r"|libqminimalegl"
    # Nothing is fetched from a network.
    r"|Qt6?Network|plugins/tls|plugins/networkinformation"
    # The program loads the catalogues of Qt's base alone; those of English and Japanese stay whole.
    r"|PySide6/.*translations/(?!qtbase_|.*_(en|ja)\.qm)"
)
_FFMPEG = re.compile(
    r"(?P<folder>[\w.]+)/(?P<name>lib(?:av|sw)\w+)-\w+\.so\.(?P<major>\d+)\.(?P<minor>\d+)"
)
_BORROWS, _LENDS = "opencv_python_headless.libs", "av.libs"
_LINK, _BINARY = "SYMLINK", "BINARY"


def is_left_out(name: str) -> bool:
    """Whether a file of the folder is not needed."""
    return _FILES.search(name) is not None


def trimmed(entries: Iterable[Entry]) -> list[Entry]:
    """The entries that are needed of those of binaries and of links to them."""
    entries = [*entries]
    kept = with_one_ffmpeg([one for one in entries if not is_left_out(one[0])])
    return without_orphans(entries, kept, libraries_needed)


def with_one_ffmpeg(entries: list[Entry]) -> list[Entry]:
    """OpenCV uses the libraries of FFmpeg that av brings, where these can stand for its own.

    They do if the major version is the same, and the minor one no older: so FFmpeg promises. No
    video is read or written by OpenCV in the program, but it is linked with them.
    """
    lent = {
        (found["name"], found["major"]): (int(found["minor"]), name)
        for name, _, kind in entries
        if kind == _BINARY and (found := _FFMPEG.match(name)) and found["folder"] == _LENDS
    }
    made = []
    for name, source, kind in entries:
        found = _FFMPEG.match(name)
        if kind == _BINARY and found and found["folder"] == _BORROWS:
            minor, other = lent.get((found["name"], found["major"]), (-1, ""))
            if minor >= int(found["minor"]):
                source, kind = f"../{other}", _LINK
        made.append((name, source, kind))
    return made


def without_orphans(
    before: list[Entry], kept: list[Entry], needed_by: Callable[[str], Iterable[str]]
) -> list[Entry]:
    """What is kept, without libraries that only those needed that are kept no more.

    needed_by: the names of the libraries that the binary at a path needs itself.
    """
    needs = {
        source: {*needed_by(source)} for _, source, kind in before if kind not in (_LINK, "DATA")
    }
    lost = {source for _, source, _ in before} - {source for _, source, _ in kept}
    while True:
        here = {source for _, source, _ in kept}
        wanted = {name for source in here for name in needs.get(source, ())}
        once = {name for source in lost for name in needs.get(source, ())}
        orphans = {
            source
            for _, source, _ in kept
            if Path(source).name in once - wanted and source in needs
        }
        if not orphans:
            break
        lost |= orphans
        kept = [one for one in kept if one[1] not in orphans]
    return _without_dangling(kept)


def _without_dangling(entries: list[Entry]) -> list[Entry]:
    """Entries without links to what is not there."""
    names = {name for name, _, _ in entries}
    return [
        (name, source, kind)
        for name, source, kind in entries
        if kind != _LINK or _target(name, source) in names
    ]


def _target(name: str, source: str) -> str:
    """Where a link in the folder leads, seen from the folder."""
    parts = [*Path(name).parent.parts]
    for part in Path(source).parts:
        if part == "..":
            parts.pop()
        else:
            parts.append(part)
    return "/".join(parts)


def libraries_needed(binary: str) -> list[str]:
    """The names of the libraries that a binary names itself; none where they cannot be told."""
    try:
        told = subprocess.run(("objdump", "-p", binary), capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return []
    return re.findall(r"^ +NEEDED +(\S+)$", told.stdout, re.MULTILINE)


def strip_libraries(folder: Path) -> int:
    """Take what only debuggers read out of the libraries in a folder; gives the bytes saved.

    A library that would not be laid out as a loader expects it afterwards stays as it is: that
    happens to those that other tools have changed before.
    """
    saved = 0
    for file in folder.rglob("*.so*"):
        if file.is_symlink() or not file.is_file():
            continue
        small = file.with_name(f"{file.name}.small")
        shutil.copy(file, small)
        done = subprocess.run(
            ("strip", "--strip-unneeded", small), capture_output=True, check=False
        )
        if done.returncode == 0 and is_loadable(small):
            saved += file.stat().st_size - small.stat().st_size
            small.replace(file)
        else:
            small.unlink()
    return saved


def is_loadable(library: Path) -> bool:
    """Whether the parts of a library lie where a loader can map them."""
    told = subprocess.run(("readelf", "-lW", library), capture_output=True, text=True, check=False)
    parts = re.findall(
        r"^ +LOAD +(0x[0-9a-f]+) (0x[0-9a-f]+) .* (0x[0-9a-f]+)$", told.stdout, re.MULTILINE
    )
    numbers = [[int(word, 16) for word in part] for part in parts]
    return bool(numbers) and all((at - place) % align == 0 for at, place, align in numbers)
