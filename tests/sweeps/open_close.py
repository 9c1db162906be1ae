"""Open and close a session again and again in the window, and watch the memory.

`python -m tests.sweeps.open_close [CYCLES] [--session FILE] [--most MIB]`. Each time the session
opens, a second and a half of it plays, and it closes. A line after every
tenth says what the process has in memory. The exit status says whether that stayed below `--most`
and, from the first tenth of the cycles on, grew by less than 0.05 MiB a cycle.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from tests.sweeps.command import resident_bytes
from tests.sweeps.runner import Worker, sweep
from tests.sweeps.sessions import LOBBY, tracked_session

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

MOST_MIB = 450
"""The window with nothing open has 280 MiB."""
MOST_GROWTH_MIB = 0.05
FRAMES_PLAYED = 30


def attack(worker: Worker) -> Iterator[str]:
    """A cycle a run, in one window."""
    session = worker.asked.session or tracked_session(worker.folder, **LOBBY)
    from PySide6.QtCore import QObject

    from app.core.memory import map_large_blocks
    from app.shell.application import borrowed_window

    sizes = list[float]()
    map_large_blocks()
    with borrowed_window("dark", (1600, 1000)) as window:
        window.show()
        for cycle in worker.numbers:
            open_and_close(window, session)
            sizes.append(resident_bytes() / 2**20)
            if cycle % 10 == 9:
                count = len(window.findChildren(QObject))
                print(
                    f"after {cycle + 1:4} cycles {sizes[-1]:6.1f} MiB, {count} objects", flush=True
                )
    begun, growth = len(sizes) // 10, 0.0
    if len(sizes) > begun + 10:
        growth = float(np.polyfit(np.arange(begun, len(sizes)), sizes[begun:], 1)[0])
    worker.count("cycles", len(sizes))
    worker.count("MiB at most", round(max(sizes)))
    worker.count("KiB more with each cycle", round(1024 * growth))
    if max(sizes) > worker.asked.most:
        yield f"took {max(sizes):.0f} MiB; {worker.asked.most} are allowed"
    if growth > MOST_GROWTH_MIB:
        yield f"took {growth:.3f} MiB more with each cycle; {MOST_GROWTH_MIB} are allowed"


def open_and_close(window: MainWindow, session: Path) -> None:
    """One cycle; nothing holds the controller after it."""
    from app.shell.application import wait_until
    from app.shell.files import GIVE_BACK_MS

    window.files.open_path(session)
    assert wait_until(lambda: window.controller is not None), "the session did not open"
    play(window)
    window.files.close_without_asking()
    window.show_welcome()
    gone_s = time.monotonic() + 3 * GIVE_BACK_MS / 1000
    wait_until(lambda: time.monotonic() > gone_s and threading.active_count() == 1)


def play(window: MainWindow) -> None:
    """Play the first frames."""
    from app.shell.application import wait_until

    controller = window.controller
    assert controller is not None
    controller.playback.toggle()
    played = wait_until(lambda: controller.playback.clock.frame >= FRAMES_PLAYED)
    assert played, "it does not play"


if __name__ == "__main__":
    options = {
        "--session": {"type": Path, "help": "made of a rendered recording if left out"},
        "--most": {"type": int, "default": MOST_MIB, "help": "MiB that are allowed"},
    }
    sys.exit(sweep(attack, 200, workers=1, options=options))
