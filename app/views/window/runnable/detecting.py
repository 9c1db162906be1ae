"""What the commands of the Detector menu do on the open desk."""

from __future__ import annotations

from app.views.window.runnable.on_desk import OnDesk

DETECTING: dict[str, OnDesk] = {
    "detector.next": lambda desk: desk.parts.jump(1),
    "detector.previous": lambda desk: desk.parts.jump(-1),
    "detector.suggest": lambda desk: desk.labelling.suggest(),
}
