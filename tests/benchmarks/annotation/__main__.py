"""Keys and mouse actions for ground truth: `python -m tests.benchmarks.annotation`.

A scripted annotator sees the people of a labelled recording where its ground truth has them and
draws them in the real window (offscreen), on a copy without the ground truth: with the recording's
detections as suggestions, and without. All keys and mouse actions count; the copy opens at its
first frame. Beside it stands what the same keyframes take in CVAT's track mode, counted by its
documentation (see `plans.count_cvat`). Each box overlaps the true one by at least `--least`
(intersection over union); the fewest keyframes with straight lines between them are drawn.
"""

from __future__ import annotations

import os
import shutil
from collections import Counter
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from tests.benchmarks.annotation.plans import (
    TrueTrack,
    by_frame,
    count_cvat,
    keyframes_of,
    true_tracks_of,
)
from tests.benchmarks.command import parser_of, real_data, tell

_NAME = "tud-campus-real"
_DRAWN_TO = 0.005
"""Boxes are drawn to a pixel of the window: those between must fit a little better than needed."""
_PATIENCE_MS = 60_000
_KINDS = "drags", "accepted", "frames", "named", "dismissed", "modes"
_COLUMNS = ("least overlap", "suggestions", "keyframes", *_KINDS, "all", "CVAT", "share")


def main() -> None:
    """Read the command line, label and print a Markdown table."""
    parser = parser_of("annotation", __doc__)
    parser.add_argument("--recording", default=_NAME, help="folder below the data's")
    parser.add_argument("--least", nargs="+", type=float, default=[0.5, 0.7, 0.8])
    parser.add_argument("--by-keys", action="store_true", help="go to frames by keys, not clicks")
    parser.add_argument("--data", type=Path, default=real_data(), help="folder of recordings")
    asked = parser.parse_args()
    folder = asked.data / asked.recording
    if not (folder / "truth.txt").is_file():
        tell(f"{asked.recording}: no ground truth at {asked.data}")
        return
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    print("|", " | ".join(_COLUMNS), "|")
    print("|", " | ".join("---" for _ in _COLUMNS), "|")
    ways = [(least, seen) for least in asked.least for seen in (True, False)]
    for least, suggestions in ways:
        with TemporaryDirectory(prefix="trackwright-") as own:
            os.environ |= {"HOME": own, "XDG_DATA_HOME": own, "XDG_CONFIG_HOME": own}
            print(_row(folder, Path(own), least, suggestions, asked.by_keys), flush=True)


def _row(folder: Path, own: Path, least: float, suggestions: bool, by_keys: bool) -> str:
    """Label a copy and compare."""
    copy = own / "copy"
    left_out = ["truth*", *([] if suggestions else ["det*"])]
    shutil.copytree(folder, copy, ignore=shutil.ignore_patterns(*left_out))
    true_tracks = true_tracks_of(folder / "truth.txt")
    plans = keyframes_of(true_tracks, least + _DRAWN_TO)
    actions = _labelled(copy, true_tracks, plans, least, by_keys)
    cvat = count_cvat(true_tracks, plans, least)
    tell(str(cvat))
    here, there = sum(actions.values()), cvat.total(by_keys=by_keys)
    keys = sum(len(frames) for frames in plans.values())
    counts = (keys, *(actions[kind] for kind in _KINDS), here, there)
    cells = f"{least:.2f}", "yes" if suggestions else "no", *map(str, counts), f"{here / there:.2f}"
    return "| " + " | ".join(cells) + " |"


def _labelled(
    copy: Path,
    true_tracks: Mapping[int, TrueTrack],
    plans: Mapping[int, list[int]],
    least: float,
    by_keys: bool,
) -> Counter[str]:
    """Label it in the window; the actions. Fails where a box does not fit or is nobody's."""
    from app.shell.application import borrowed_window, wait_until
    from tests.benchmarks.annotation.user import Annotator

    with borrowed_window("dark", (2560, 1440)) as window:
        window.show()
        window.activateWindow()
        window.files.open_path(copy)
        wait_until(
            lambda: window.controller is not None and window.controller.playback.frame is not None,
            _PATIENCE_MS,
        )
        wait = partial(wait_until, patience_ms=_PATIENCE_MS)
        user = Annotator(window, true_tracks, least, wait, by_keys=by_keys)
        user.label(by_frame(plans))
        fits = np.concatenate([user.fit(person) for person in true_tracks])
        tell(f"{len(fits)} boxes overlap by {fits.mean():.3f}, at least {fits.min():.3f}")
        assert fits.min() >= least, "every box fits"
        assert user.extra == 0, f"{user.extra} boxes are nobody's"
        return user.actions


if __name__ == "__main__":
    main()
