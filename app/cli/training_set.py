"""Samples from whatever `train` is pointed at: sessions, and exported samples."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from app.features.parts.training_set import Source, TrainingSet, build_training_set, source_at
from tracking.session import RecordingMissing
from tracking.translation import Message, message_of


def read_training_set(
    paths: Sequence[Path], *, from_truth: bool, allow_outside: bool
) -> TrainingSet:
    """The samples of sessions and tables, different recordings under different names.

    Args:
        from_truth: labels are made from the truth beside rendered recordings.
        allow_outside: a recording outside of its session's folder may be opened.

    Raises as `source_at`; where a recording is missing it says what `train` can be told.
    """
    return build_training_set([_source(path, from_truth, allow_outside) for path in paths])


def _source(path: Path, from_truth: bool, allow_outside: bool) -> Source:
    try:
        return source_at(path, from_truth=from_truth, allow_outside=allow_outside)
    except RecordingMissing as missing:
        raise RecordingMissing(
            "{path}: {why}", path=path, why=with_advice(missing, allow_outside)
        ) from missing


def with_advice(error: Exception, allow_outside: bool) -> Message:
    """The message of an error; how to find a recording as a command that takes no place for it."""
    if not isinstance(error, RecordingMissing):
        return message_of(error)
    if allow_outside:
        return error.advising("put it beside the session").message
    return error.advising("allow it", option="--allow-outside").message
