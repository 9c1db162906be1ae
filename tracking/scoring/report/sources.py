"""Where truth and results are from: in words and as plain values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tracking.scoring.report.findings import Finding
from tracking.scoring.report.subject import Source


def sources_said(finding: Finding) -> Iterator[tuple[str, str, str]]:
    """Result and truth, as far as they are known: which of them, its place, what is known of it."""
    subject = finding.subject
    named = (("Result", subject.result_sources.get(finding.result)), ("Truth", subject.true_source))
    for title, source in named:
        if source is not None:
            yield title, source.place, _said(source)


def sources_data(finding: Finding) -> dict[str, Any]:
    """The same for programs; empty where nothing is known."""
    subject = finding.subject
    named = (("result", subject.result_sources.get(finding.result)), ("truth", subject.true_source))
    known = {title: _data(source) for title, source in named if source is not None}
    return {"sources": known} if known else {}


def _said(source: Source) -> str:
    """What is known beside the place, with a comma before each part of it."""
    parts = (
        source.recording and f"recording {source.recording}",
        source.frames and f"{source.frames:,} frames",
        source.fps and f"{source.fps:g} frames per second",
        source.tracker and f"tracker {source.tracker}",
        source.detections and f"detections {', '.join(source.detections)}",
    )
    return "".join(f", {part}" for part in parts if part)


def _data(source: Source) -> dict[str, Any]:
    return {
        "path": source.place,
        "recording": source.recording,
        "frames": source.frames,
        "fps": source.fps,
        "tracker": source.tracker,
        **({"detections": list(source.detections)} if source.detections else {}),
    }
