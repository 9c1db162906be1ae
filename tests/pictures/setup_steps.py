"""Pictures of the set-up's steps, small and large, dark and light, to be looked at.

`xvfb-run -s "-screen 0 1600x1000x24" python -m tests.pictures.setup_steps FOLDER [SIZES]`
"""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PySide6.QtCore import QSize

from app.cli.display import why_no_window
from app.core.look.theme import Look
from app.features.setup import floor_presenter, region_presenter
from app.features.setup.calibration_presenter import with_board, with_method, with_rough
from app.features.setup.dialog import SetupDialog
from app.features.setup.scene import BoardForm, Step
from app.shell.application import borrowed_window, wait_until
from app.shell.main_window import MainWindow
from tracking.synthesis import render_recording

SIZES = ((1000, 640), (1400, 900))
LOOKS = (Look.DARK, Look.LIGHT)
_PATIENCE_MS = 120_000
_SCENE_S, _SEED, _PEOPLE = 8.0, 5, 5


def main() -> int:
    """Make all pictures in a folder."""
    if missing := why_no_window():
        sys.exit(missing)
    folder, sizes = Path(sys.argv[1]), SIZES[: int(sys.argv[2])] if len(sys.argv) > 2 else SIZES
    folder.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix="trackwright-") as own:
        os.environ |= {"HOME": own, "XDG_DATA_HOME": own, "XDG_CONFIG_HOME": own}
        videos = camera_card(Path(own) / "card", Path(own) / "made")
        for size in sizes:
            for look in LOOKS:
                name = f"{size[0]}-{look.value}"
                with borrowed_window(look.value, size) as window:
                    shoot_steps(
                        window, videos, lambda step, name=name: folder / f"{name}-{step}.png"
                    )
    return 0


def camera_card(card: Path, made: Path) -> list[Path]:
    """Two bare videos of a rendered pair, named as a camera names them, the right one first."""
    render_recording(made, "lobby", _SCENE_S, _PEOPLE, _SEED)
    card.mkdir(parents=True)
    for side, name in (("left", "GX010035"), ("right", "GX010034")):
        source = next(made.glob(f"{side}.*"))
        shutil.copyfile(source, card / (name + source.suffix))
    return sorted(card.iterdir())


def shoot_steps(window: MainWindow, videos: list[Path], place: Callable[[str], Path]) -> None:
    """The steps in their order, with what a user would have entered by then."""
    window.show()
    window.files.setup.ask()
    dialog = window.files.setup.dialog
    assert dialog is not None
    editor = dialog.editor
    shot = _Shot(dialog, place)
    shot("0-empty")
    editor.take_paths(videos)
    shot("1-cameras")
    dialog.go_to(Step.CALIBRATION)
    shot("2-file")
    editor.change(with_method(editor.state, "board"))
    editor.change(with_board(editor.state, BoardForm(left="left*.png", right="right*.png")))
    dialog.calibration.calibrate_board()
    shot("2-board")
    editor.change(with_method(editor.state, "rough"))
    editor.change(with_rough(editor.state, 64.0, 120.0))
    dialog.calibration.calibrate_rough()
    shot("2-rough")
    dialog.calibration.shown.setCurrentIndex(1)
    shot("2-rectified")
    dialog.go_to(Step.FLOOR)
    dialog.floor.measure.click()
    shot("3-floor")
    dialog.floor.method.setCurrentIndex(2)
    for u, v in ((120, 300), (500, 310), (560, 440), (60, 430)):
        editor.change(floor_presenter.with_point(editor.state, u, v))
    shot("3-points")
    dialog.go_to(Step.REGION)
    state = editor.state
    outline = ((40.0, 120.0), (600.0, 120.0), (600.0, 470.0), (40.0, 470.0))
    state = region_presenter.with_outline(state, "look", outline)
    mask = tuple((float(x), float(y)) for x, y in np.array([(300, 200), (400, 200), (350, 300)]))
    editor.change(region_presenter.with_outline(state, "mask", mask))
    dialog.region.choose_handle(1)
    shot("4-region")
    dialog.go_to(Step.WRITE)
    shot("5-write")
    editor.forget_draft()
    dialog.reject()


class _Shot:
    """Waits until nothing is at work, and takes a picture."""

    def __init__(self, dialog: SetupDialog, place: Callable[[str], Path]) -> None:
        self._dialog, self._place = dialog, place

    def __call__(self, step: str) -> None:
        dialog = self._dialog
        quiet = QSize(0, 0)
        wait_until(lambda: not dialog.editor.busy and dialog.size() != quiet, _PATIENCE_MS)
        wait_until(lambda: not dialog.calibration.busy, _PATIENCE_MS)
        dialog.grab().save(str(self._place(step)))


if __name__ == "__main__":
    sys.exit(main())
