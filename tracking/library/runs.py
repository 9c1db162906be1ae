"""Tracking a recording from beginning to end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from tracking.library.paths import AnyPath
from tracking.library.recordings import opened
from tracking.pipeline import track as begin_tracking
from tracking.progress import Progress, no_progress
from tracking.recording import Recording
from tracking.session import Session
from tracking.settings import SettingValue, settings_from
from tracking.trackers import best_tracker, require, tracker_named


def track(
    recording: Recording | AnyPath,
    tracker: str | None = None,
    *,
    settings: Mapping[str, SettingValue] | None = None,
    frames: tuple[int, int] | None = None,
    seed: int = 0,
    progress: Progress | None = None,
) -> Session:
    """Track the people in a recording; a session that is not saved yet.

    Args:
        recording: open, or where it is.
        tracker: a name that `trackwright trackers` lists; None: the best one for the recording.
        settings: some of its settings by their names, e.g. {"particles": 500}.
        frames: half-open range; None: all.
        seed: of all random numbers; the same seed gives the same tracks.
        progress: told after each frame how many are done, of how many; may raise to cancel.

    Returns:
        The session: `tracks` is the table that is corrected, `runs[0]` what the tracker found,
        with its `notes`. `save(path)` writes it.

    Raises:
        SettingsError: unknown tracker or setting, a value out of range, or no such frames.
        RecordingError, CalibrationError: the tracker cannot work on the recording.
        PluginError: a plug-in failed.
    """
    with opened(recording) as footage:
        spec = tracker_named(tracker or best_tracker(footage))
        require(spec, footage)
        values = settings_from(spec.settings_type, settings or {})
        report = progress or no_progress
        with begin_tracking(footage, spec.name, values, seed, frames) as work:
            first, stop = work.frames
            for step in work:
                report(step.frame + 1 - first, stop - first)
            told = footage.notes
            run = replace(work.run(), notes=tuple(note for note in work.notes if note not in told))
        return Session.create(footage, [run])
