"""Shares of the window, kept by screen and scaling: never absolute pixels."""

from __future__ import annotations

from PySide6.QtGui import QScreen
from PySide6.QtWidgets import QSplitter

from app.core.widgets.user_settings import UserSettings

_WHOLE = 10_000


def screen_key(screen: QScreen) -> str:
    """What tells a screen and its scaling from others, e.g. "1920x1080 at 200 %"."""
    size, ratio = screen.size(), screen.devicePixelRatio()
    return f"{size.width()}x{size.height()} at {round(100 * ratio)} %"


class LayoutShares:
    """How the parts of some splitters share their room.

    Attributes:
        splitters: by name.
    """

    def __init__(self) -> None:
        self.splitters: dict[str, QSplitter] = {}
        self._first: dict[str, tuple[int, ...]] = {}

    def add(self, name: str, splitter: QSplitter, shares: tuple[int, ...]) -> None:
        """Keep those of one more splitter, which are these at the first start."""
        self.splitters[name], self._first[name] = splitter, shares
        splitter.setSizes([_WHOLE * share for share in shares])

    def remember(self, remembered: UserSettings, screen: QScreen) -> None:
        """Keep the shares; a part that is hidden has the one it had last."""
        for name, splitter in self.splitters.items():
            key, sizes = f"shares/{screen_key(screen)}/{name}", splitter.sizes()
            before, whole = _shares(remembered.text(key)), max(1, sum(sizes))
            if len(before) != len(sizes):
                before = [0.0] * len(sizes)
            shares = (size / whole or last for size, last in zip(sizes, before, strict=True))
            if any(sizes):
                remembered.set_text(key, " ".join(f"{share:.4f}" for share in shares))

    def restore(self, remembered: UserSettings, screen: QScreen) -> None:
        """Share the room as it was on such a screen; what was kept of other parts is left."""
        for name, splitter in self.splitters.items():
            shares = _shares(remembered.text(f"shares/{screen_key(screen)}/{name}"))
            if len(shares) == splitter.count():
                splitter.setSizes([round(_WHOLE * share) for share in shares])

    def reset(self) -> None:
        """Share the room as at the first start."""
        for name, splitter in self.splitters.items():
            if len(self._first[name]) == splitter.count():
                splitter.setSizes([_WHOLE * share for share in self._first[name]])


def _shares(text: str) -> list[float]:
    try:
        shares = [float(part) for part in text.split()]
    except ValueError:
        return []
    return shares if all(0.0 <= share <= 1.0 for share in shares) else []
