"""What CVAT's XML says of a task before its tracks."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tracking.formats.cvat_schema import CvatSchema
from tracking.formats.row_rules import MAX_FRAME

_NUMBER = re.compile(r"\d{1,9}")
_STEP = re.compile(r"step\s*=\s*(\d{1,6})")
_WIDEST_PX = 1 << 20


class Meta:
    """Collects the numbers of the task (or of the one job a file is of).

    Attributes:
        tasks: how many the file describes. step: frames between two that are annotated.
        labels: the attributes of its labels.
    """

    def __init__(self) -> None:
        self.tasks, self.step = 0, 1
        self.labels = CvatSchema()
        self._attribute: dict[str, str] = {}
        self._numbers: dict[str, int] = {}

    def end(self, inside: Sequence[str], name: str, text: str) -> None:
        """An element ended inside others."""
        parent = inside[-1] if inside else ""
        if parent == "attribute" and "label" in inside:
            self._attribute.setdefault(name, text)
            return
        text = text.strip()
        if name == "attribute" and parent == "attributes":
            self.labels.add(self._attribute)
            self._attribute = {}
        elif name == "task":
            self.tasks += 1
        elif parent in ("task", "job"):
            if name == "frame_filter" and (found := _STEP.search(text)):
                self.step = max(int(found[1]), 1)
            elif name in ("size", "start_frame", "stop_frame"):
                self._number(name, text)
        elif parent == "original_size" and name in ("width", "height"):
            self._number(name, text)

    def _number(self, name: str, text: str) -> None:
        if _NUMBER.fullmatch(text):
            self._numbers.setdefault(name, int(text))

    @property
    def size_px(self) -> tuple[int, int] | None:
        """Of the frames."""
        width, height = (self._numbers.get(name, 0) for name in ("width", "height"))
        known = min(width, height) > 0 and max(width, height) <= _WIDEST_PX
        return (width, height) if known else None

    @property
    def last_frame(self) -> int | None:
        """The last frame that is annotated, as the footage counts."""
        last = self._numbers.get("stop_frame")
        if last is None and "size" in self._numbers:
            first = self._numbers.get("start_frame", 0)
            last = first + (self._numbers["size"] - 1) * self.step
        return last if last is not None and 0 <= last < MAX_FRAME else None
