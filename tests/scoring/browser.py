"""A headless Chromium, spoken to through two pipes: no package and no port is needed."""

from __future__ import annotations

import base64
import json
import os
import shutil
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

_NAMES = ("chromium", "chromium-browser", "google-chrome")
_FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-dev-shm-usage",
    "--disable-extensions",
    "--disable-sync",
    "--hide-scrollbars",
    "--no-first-run",
    "--remote-debugging-pipe",
)


class Browser:
    """One page of it.

    Attributes:
        asked: addresses the page asked for. told: errors and warnings it had.
    """

    def __init__(self, requests: int, answers: int) -> None:
        """The ends of the two pipes."""
        self._requests, self._answers = requests, answers
        self._rest, self._number, self._session = b"", 0, None
        self.asked: list[str] = []
        self.told: list[str] = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Have something done; its answer."""
        self._number += 1
        request: dict[str, Any] = {"id": self._number, "method": method, "params": parameters}
        if self._session is not None:
            request["sessionId"] = self._session
        os.write(self._requests, json.dumps(request).encode() + b"\0")
        while True:
            message = self._next()
            if message.get("id") == self._number:
                assert "error" not in message, message
                return dict(message["result"])
            self._note(message)

    def open(self, path: Path) -> None:
        """Go to a page and wait until it is there."""
        self.asked.clear()
        self.told.clear()
        self.call("Page.navigate", url=path.as_uri())
        while True:
            message = self._next()
            self._note(message)
            if message.get("method") == "Page.loadEventFired":
                return

    def value(self, expression: str) -> Any:
        """What an expression of JavaScript has for a value in the page."""
        found = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        return found["result"].get("value")

    def shape(self, width: int, scheme: str = "light", media: str = "") -> None:
        """How wide the window is, whether its user likes it dark, and "print" for paper."""
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width, height=900, deviceScaleFactor=1, mobile=False,
        )  # fmt: skip
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.call("Emulation.setEmulatedMedia", media=media, features=features)

    def screenshot(self) -> bytes:
        """What is in the window, as PNG."""
        found = self.call("Page.captureScreenshot")
        return base64.b64decode(found["data"])

    def printed(self) -> bytes:
        """The page as PDF."""
        return base64.b64decode(self.call("Page.printToPDF", printBackground=True)["data"])

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            piece = os.read(self._answers, 1 << 20)
            assert piece, "the browser has gone"
            self._rest += piece
        message, _, self._rest = self._rest.partition(b"\0")
        return dict(json.loads(message))

    def _note(self, message: dict[str, Any]) -> None:
        method, said = message.get("method", ""), message.get("params", {})
        if method == "Network.requestWillBeSent":
            self.asked.append(said["request"]["url"])
        elif method == "Runtime.exceptionThrown":
            self.told.append(str(said["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled":
            self.told.append(str(said["args"]))
        elif method == "Log.entryAdded":
            self.told.append(str(said["entry"]["text"]))


@contextmanager
def browser(profile: Path) -> Iterator[Browser]:
    """A browser with a new profile in a folder; skips the test where there is none."""
    program = next(filter(None, map(shutil.which, _NAMES)), None)
    if program is None or not hasattr(os, "posix_spawn"):
        pytest.skip("no Chromium to look at the page with (apt-get install chromium)")
    to_read, requests = os.pipe()
    answers, to_write = os.pipe()
    pid = _start(program, profile, to_read, to_write)
    try:
        yield Browser(requests, answers)
    finally:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        os.close(requests)
        os.close(answers)


def _start(program: str, profile: Path, to_read: int, to_write: int) -> int:
    """Start it; it expects its ends of the pipes as files 3 and 4."""
    import fcntl  # Unix only, as is the way they are handed over

    ends = [fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in (to_read, to_write)]
    os.close(to_read)
    os.close(to_write)
    actions = [
        *((os.POSIX_SPAWN_DUP2, end, number) for number, end in enumerate(ends, start=3)),
        *((os.POSIX_SPAWN_OPEN, number, os.devnull, os.O_WRONLY, 0) for number in (1, 2)),
    ]
    command = [program, *_FLAGS, f"--user-data-dir={profile}"]
    pid = os.posix_spawn(program, command, os.environ, file_actions=actions)
    for end in ends:
        os.close(end)
    return pid
