"""What the commands of the View menu do."""

from __future__ import annotations

from dataclasses import replace

from app.views.desk import Desk
from app.views.runnable.on_desk import OnDesk


def _toggle(name: str) -> OnDesk:
    def toggle(desk: Desk) -> None:
        now: bool = getattr(desk.pictured, name)
        desk.set_pictured(replace(desk.pictured, **{name: not now}))

    return toggle


VIEWING: dict[str, OnDesk] = {
    "view.left": lambda desk: desk.set_eyes("left"),
    "view.both": lambda desk: desk.set_eyes("both"),
    "view.anaglyph": lambda desk: desk.set_eyes("anaglyph"),
    "view.grid": _toggle("grid"),
    "view.particles": _toggle("particles"),
    "view.trails": _toggle("trails"),
    "view.foreground": _toggle("foreground"),
    "view.disparity": _toggle("disparity"),
    "view.labels": _toggle("labels"),
}
