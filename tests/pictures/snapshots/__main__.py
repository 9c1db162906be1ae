"""Snapshots of every panel, dialog and page, in both looks, at 100 and 200 %, in two languages.

`python -m tests.pictures.snapshots FOLDER [--only NAME ...] [--material FOLDER]`
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.pictures.snapshots.shooting import LONGER, RECORD

SCREENS = {100: (1280, 800), 200: (3840, 2160)}
"""Of the desktop by scaling, in pixels: a small one, and 4K."""
WINDOWS = {100: "1280x800", 200: "1920x1080"}
"""Of the window, in the program's own pixels: all of the screen."""
LANGUAGES = ("en", "ja")


@dataclass(frozen=True, slots=True)
class Setting:
    """A language at a scaling in percent."""

    language: str
    scaling: int

    @property
    def name(self) -> str:
        """Of its folder."""
        return f"{self.language}-{self.scaling}"


SETTINGS = (
    *(Setting(language, scaling) for scaling in SCREENS for language in LANGUAGES),
    Setting(LONGER, 100),
)


def main(given: Sequence[str] | None = None) -> int:
    """Take them all; the exit status is 1 where one failed or a text is cut off."""
    options = _options(given)
    options.folder.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix="trackwright-") as own:
        material = options.material or Path(own) / "material"
        if not material.is_dir() and not options.bare:
            _run_apart(Path(own), Setting("en", 100), ["-m", f"{__package__}.material", material])
        chosen = [one for one in SETTINGS if not options.settings or one.name in options.settings]
        for setting in chosen:
            print(f"{setting.name} ...", file=sys.stderr)
            folder = options.folder / setting.name
            arguments = [material, folder, WINDOWS[setting.scaling], *options.only]
            _run_apart(Path(own), setting, ["-m", f"{__package__}.shooting", *arguments])
    return _tell(options.folder, chosen)


def _options(given: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where the pictures go")
    parser.add_argument("--only", nargs="*", default=[], help="groups or pictures: dialogs-runs")
    parser.add_argument("--settings", nargs="*", default=[], help="of: en-100 ja-200 longer-100")
    parser.add_argument("--material", type=Path, help="what was rendered before")
    parser.add_argument("--bare", action="store_true", help="render nothing: the first page alone")
    return parser.parse_args(given)


def _run_apart(own: Path, setting: Setting, arguments: Iterable[object]) -> None:
    """Run in a process of its own, on a screen that is nowhere. Raises SystemExit if it fails."""
    width, height = SCREENS[setting.scaling]
    screen = {
        "name": "screen",
        "x": 0,
        "y": 0,
        "width": width,
        "height": height,
        "logicalDpi": 96,
        "logicalBaseDpi": 96,
        "dpr": 1.0,
    }
    place = own / f"screen-{setting.scaling}.json"
    place.write_text(json.dumps({"screens": [screen]}))
    environment = {
        **os.environ,
        "QT_QPA_PLATFORM": f"offscreen:configfile={place}",
        "QT_SCALE_FACTOR": str(setting.scaling / 100),
        "LANGUAGE": setting.language,
    }
    done = subprocess.run([sys.executable, *map(str, arguments)], env=environment)
    if done.returncode:
        raise SystemExit(f"{setting.name}: the pictures were not made")


def _tell(folder: Path, settings: Sequence[Setting]) -> int:
    """Sheets, the page that lists them, and what went wrong."""
    from PySide6.QtWidgets import QApplication

    from tests.pictures.snapshots.catalogue import SNAPSHOTS
    from tests.pictures.snapshots.sheet import write_index, write_sheets

    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    application = QApplication.instance() or QApplication([])
    groups = tuple(dict.fromkeys(one.group for one in SNAPSHOTS))
    sheets = {one.name: write_sheets(folder / one.name, groups) for one in settings}
    told = [line for one in settings for line in _faults(folder / one.name, one.name)]
    index = write_index(folder, sheets, told)
    print("\n".join([*told, str(index)]))
    del application
    return int(bool(told))


def _faults(folder: Path, name: str) -> Iterable[str]:
    record = json.loads((folder / RECORD).read_text())
    for picture, why in record["failed"].items():
        yield f"{name} {picture}: {why}"
    for picture, cut in record["cut"].items():
        yield from (f"{name} {picture}: {one}" for one in cut)


if __name__ == "__main__":
    sys.exit(main())
