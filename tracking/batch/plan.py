"""What is left to do: which recordings are finished as they are asked for, and which are not."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from tracking.batch.ledger import Row
from tracking.batch.order import BatchOrder, Limits, digest_of
from tracking.batch.outcome import Cause, Outcome, State
from tracking.batch.publication import score_page
from tracking.batch.recordings import Entry, boxes_of_entry
from tracking.batch.signature import file_state, signature_of
from tracking.errors import RecordingError


@dataclass(frozen=True, slots=True)
class Planned:
    """A recording that is to be worked on.

    Attributes:
        entry: which one. signature: of its files. known: what became of it before.
        size_bytes: of its files, by which the time left is told.
    """

    entry: Entry
    signature: str
    known: Outcome | None
    size_bytes: int


@dataclass(slots=True)
class Plan:
    """What is to do, in order, and what is finished already, by name."""

    to_do: list[Planned] = field(default_factory=list)
    finished: dict[str, Outcome] = field(default_factory=dict)


class Planner:
    """Compares what is asked for with what the ledger knows and what is on disk.

    It reads no recording: where files may have changed, a worker looks at them.
    """

    def __init__(
        self, order: BatchOrder, limits: Limits, out: Path, *, retry: bool = False
    ) -> None:
        """retry: what failed before is tried once more, also where nothing has changed."""
        self._order, self._limits, self._out, self._retry = order, limits, out, retry
        patterns = (order.detections, order.detections_right)
        self.asked = digest_of([order.tracking_digest(), patterns])

    def plan(self, entries: Iterable[Entry], rows: Mapping[str, Row]) -> Plan:
        """What is left of the recordings."""
        plan = Plan()
        for entry in entries:
            row = rows.get(entry.name)
            seen = self._signature(entry, row)
            if row is not None and self._is_finished(entry, row, seen):
                plan.finished[entry.name] = row.outcome
            else:
                known = None if row is None else row.outcome
                plan.to_do.append(Planned(entry, seen, known, size_of(entry.path)))
        return plan

    def _signature(self, entry: Entry, row: Row | None) -> str:
        outside = () if row is None else tuple(map(Path, row.outcome.outside))
        try:
            boxes = boxes_of_entry(entry, self._order)
        except RecordingError:
            boxes = ()
        return signature_of(entry.path, boxes, outside, self._out)

    def _is_finished(self, entry: Entry, row: Row, seen: str) -> bool:
        if row.asked != self.asked or row.signature != seen:
            return False
        if row.outcome.state is State.DONE:
            return self._is_in_place(entry, row.outcome)
        if self._retry:
            return False
        if row.outcome.cause is Cause.LIMIT:
            return not self._has_more(row.limits)
        # What lies outside is not known of a recording that was not opened.
        fixed = row.outcome.cause in (Cause.INPUT, Cause.BUG)
        return fixed and not self._order.allow_outside

    def _is_in_place(self, entry: Entry, outcome: Outcome) -> bool:
        """Whether all results that are asked for are there, untouched."""
        order, out = self._order, self._out
        if file_state(out / f"{entry.name}.h5") != outcome.session_state:
            return False
        exports = outcome.exports or {}
        known = exports.keys() | (outcome.export_problems or {}).keys()
        if not known >= set(order.exports):
            return False
        files = [file for name in order.exports for file in exports.get(name, ())]
        if not all((out / file).exists() for file in files):
            return False
        wants_page = order.report and outcome.score is not None
        return not wants_page or (outcome.page and score_page(out, entry.name).is_file())

    def _has_more(self, limits: str) -> bool:
        """Whether a recording may cost more now than when it went beyond its limits."""
        before = json.loads(limits)
        now = (self._limits.time_s, self._limits.stall_s, self._limits.memory_bytes)
        return any(
            then is not None and (most is None or most > then)
            for most, then in zip(now, before, strict=True)
        )


def size_of(path: Path) -> int:
    """Bytes of a file, or of the files in a folder and those right below it; at least 1."""
    total = 0
    try:
        if not path.is_dir():
            return max(1, path.stat().st_size)
        for each in os.scandir(path):
            if each.is_dir(follow_symlinks=False):
                inside = (one for one in os.scandir(each.path) if one.is_file())
                total += sum(one.stat().st_size for one in inside)
            elif each.is_file():
                total += each.stat().st_size
    except OSError:
        return max(1, total)
    return max(1, total)
