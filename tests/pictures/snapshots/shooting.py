"""Takes the snapshots of one language at one scaling, in both looks, and says what is cut off.

A process of its own for each scaling and language, as both are of a whole program:
`python -m tests.pictures.snapshots.shooting MATERIAL FOLDER SIZE [NAME ...]`
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

from PySide6.QtCore import QMessageLogContext, QtMsgType, qInstallMessageHandler
from PySide6.QtWidgets import QApplication, QFileDialog, QMenu, QWidget

from app.core.look.theme import Look
from app.shell import language_choice
from app.shell.application import borrowed_window
from tests.fitting import beyond, cut_off
from tests.pictures.snapshots.catalogue import SNAPSHOTS
from tests.pictures.snapshots.material import Material, copied
from tests.pictures.snapshots.snapshot import On, Snapshot
from tests.pictures.snapshots.stage import Stage
from tests.pseudo import Longer
from tracking.translation import use_catalogue

LOOKS = (Look.LIGHT, Look.DARK)
LONGER = "longer"
"""A made-up language in which nothing is pictured; it is looked for what is cut off."""
RECORD = "record.json"


@dataclass(slots=True)
class Record:
    """What came of it: faults by picture, snapshots that failed, classes that were seen."""

    cut: dict[str, list[str]] = field(default_factory=dict)
    failed: dict[str, str] = field(default_factory=dict)
    seen: set[type[QWidget]] = field(default_factory=set)

    def save(self, path: Path) -> None:
        """Keep it for whoever asked."""
        seen = sorted(f"{kind.__module__}.{kind.__name__}" for kind in self.seen)
        path.write_text(json.dumps({"cut": self.cut, "failed": self.failed, "seen": seen}))


def shoot(
    material: Material, folder: Path, size: tuple[int, int], wanted: Sequence[Snapshot]
) -> Record:
    """Take snapshots in the language and the scaling in use."""
    record = Record()
    for on in On:
        chosen = [one for one in wanted if one.on is on]
        if not chosen:
            continue
        with borrowed_window(LOOKS[0].value, size) as window:
            window.files.leaving.agree()
            stage = Stage(window, material)
            _open(stage, on)
            for one in chosen:
                _take(one, stage, folder, record)
            window.files.close_without_asking()
    return record


def _open(stage: Stage, on: On) -> None:
    if on is On.NOTHING:
        stage.window.show()
        stage.rest()
    elif on is On.SESSION:
        stage.open_session()
    else:
        stage.open_project()


def _take(one: Snapshot, stage: Stage, folder: Path, record: Record) -> None:
    """One that fails leaves the others be."""
    called = f"{one.group}-{one.name}"
    try:
        showing = one.show(stage)
        shown = next(showing)
        stage.settle()
        _check_covered(one, shown, record)
        record.cut[called] = list(_cut_off(shown))
        if os.environ["LANGUAGE"] != LONGER:
            for look in _from_the_present(stage):
                shown.grab().save(str(folder / f"{called}-{look.value}.png"))
        next(showing, None)
    except Exception:
        record.failed[called] = traceback.format_exc()
        print(f"{called}: failed", file=sys.stderr)
    stage.tidy()


def _from_the_present(stage: Stage) -> Iterator[Look]:
    """Both looks, the one in use first: to change it is what takes longest."""
    choice = stage.window.look_choice
    for look in sorted(LOOKS, key=lambda look: look is not choice.look):
        if look is not choice.look:
            choice.choose(look)
            stage.rest(120)
        yield look


def _check_covered(one: Snapshot, shown: QWidget, record: Record) -> None:
    """What is said to be seen must be. Raises LookupError where it is not."""
    seen = {
        type(widget)
        for widget in (shown, *shown.findChildren(QWidget))
        if widget.isVisibleTo(shown) or widget is shown
    }
    record.seen |= seen
    missing = [kind.__name__ for kind in one.classes if kind not in seen]
    if missing:
        raise LookupError(f"not seen: {', '.join(missing)}")


def _cut_off(shown: QWidget) -> Iterator[str]:
    """Texts that are cut off in what is seen; Qt's own dialog of files is its own matter."""
    if isinstance(shown, (QMenu, QFileDialog)):
        return
    window = shown.window()
    inside = {id(widget) for widget in (shown, *shown.findChildren(QWidget))}
    yield from cut_off(window, lambda widget: id(widget) in inside)
    if shown is window:
        yield from beyond(window)


def _say(kind: QtMsgType, _: QMessageLogContext, text: str) -> None:
    """Say what Qt says, but not what a screen that is nowhere cannot do."""
    if "This plugin does not support" not in text:
        print(f"{kind.name}: {text}", file=sys.stderr)


def main() -> int:
    """Take the snapshots named on the command line, or all."""
    made, folder, size = Material(Path(sys.argv[1])), Path(sys.argv[2]), sys.argv[3]
    names = set(sys.argv[4:])
    qInstallMessageHandler(_say)
    wanted = [
        one for one in SNAPSHOTS if not names or names & {one.group, f"{one.group}-{one.name}"}
    ]
    if os.environ["LANGUAGE"] == LONGER:
        language_choice.use_language = lambda *_: use_catalogue(Longer())
    folder.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix="trackwright-") as own:
        os.environ |= {"HOME": own, "XDG_DATA_HOME": own, "XDG_CONFIG_HOME": own}
        os.environ |= {"XDG_CACHE_HOME": own, "XDG_STATE_HOME": own}
        wide, high = map(int, size.split("x"))
        material = copied(made, Path(own) / "material") if made.folder.is_dir() else made
        shoot(material, folder, (wide, high), wanted).save(folder / RECORD)
    QApplication.closeAllWindows()
    return 0


if __name__ == "__main__":
    sys.exit(main())
