"""Where truth and results are from: in words and as plain values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tracking.scoring.report.findings import Finding
from tracking.scoring.report.subject import Source
from tracking.translation import Message, joined, msg


def sources_said(finding: Finding) -> Iterator[tuple[str, str, str]]:
    """Result and truth, as far as they are known: which of them, its place, what is known of it."""
    subject = finding.subject
    named = (
        (msg("Result"), subject.result_sources.get(finding.result)),
        (msg("Truth"), subject.true_source),
    )
    for title, source in named:
        if source is not None:
            yield title, source.place, _said(source)


def sources_data(finding: Finding) -> dict[str, Any]:
    """The same for programs; empty where nothing is known."""
    subject = finding.subject
    named = (("result", subject.result_sources.get(finding.result)), ("truth", subject.true_source))
    known = {title: _data(source) for title, source in named if source is not None}
    return {"sources": known} if known else {}


def _said(source: Source) -> Message:
    """What is known beside the place, with a comma before each part of it."""
    parts = (
        source.recording and msg("recording {name}", name=source.recording),
        source.frames and msg("{frames:,} frames", frames=source.frames),
        source.fps and msg("{fps:g} frames per second", fps=source.fps),
        source.tracker and msg("tracker {tracker}", tracker=source.tracker),
        source.detections and msg("detections {names}", names=joined(", ", source.detections)),
        source.rough and msg("rough calibration: metres may be off by a tenth and more"),
    )
    known = list(filter(None, parts))
    return joined(", ", ("", *known)) if known else Message()


def _data(source: Source) -> dict[str, Any]:
    return {
        "path": source.place,
        "recording": source.recording,
        "frames": source.frames,
        "fps": source.fps,
        "tracker": source.tracker,
        **({"rough": True} if source.rough else {}),
        **({"detections": list(source.detections)} if source.detections else {}),
    }
