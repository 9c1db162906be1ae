"""What every tracker must do."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.session import Session
from tracking.settings import settings_fields, settings_from, settings_from_text, settings_values
from tracking.synthesis import render_recording
from tracking.testing.rules import at_the_door, leaving_nothing_open, obeying, require
from tracking.trackers import TRACKERS, Bodies, Resume, TrackerSpec
from tracking.tracks import Run, TrackTable

_SCENE, _SIZE, _FPS, _SECONDS, _PEOPLE = "lobby", (320, 240), 10.0, 6.0, 3
_RESUMED = 45
_MOST_OFFERED = 20


def check_tracker(spec: TrackerSpec, folder: Path) -> None:
    """Check all that the program relies on, on a small rendered recording.

    Args:
        spec: the tracker's entry. folder: to write in, empty; pytest's `tmp_path`.

    Raises BrokenRule for the first rule that it breaks.
    """
    with at_the_door(TRACKERS, spec), obeying():
        known = TRACKERS[spec.name]
        check_settings(known)
        clip = render_recording(
            folder / "clip", _SCENE, _SECONDS, _PEOPLE, 5, size=_SIZE, fps=_FPS,
            cameras=2 if spec.needs_stereo else 1,
        )  # fmt: skip
        with leaving_nothing_open("the tracker"):
            run = _tracked(clip, known)
        _check_people(run)
        _check_repeatable(run, _tracked(clip, known))
        _check_range(clip, known)
        _check_resumption(clip, known, run)
        _check_session(clip, run, folder / "session.h5")
        _check_overlays(clip, known)


def check_settings(spec: TrackerSpec) -> None:
    """Check that form, command line and session can hold the settings."""
    fields = settings_fields(spec.settings_type)
    usual = settings_values(spec.settings_type())
    json.dumps(usual, allow_nan=False)
    same = settings_from(spec.settings_type, usual) == spec.settings_type()
    require(same, "settings made of their own values must equal the defaults")
    for field in fields:
        help_ = field.help
        named = {"name": field.name, "help": help_}
        require(help_[:1].isupper(), "setting {name}: its help must begin with a capital", **named)
        require("\n" not in help_, "setting {name}: its help must be one line", **named)
        text = str(field.default).lower() if field.type is bool else str(field.default)
        read = settings_values(settings_from_text(spec.settings_type, {field.name: text}))
        require(
            read[field.name] == field.default, "setting {name}: {text!r} is not read back",
            name=field.name, text=text,
        )  # fmt: skip
    offered = sum(not field.expert for field in fields)
    require(
        offered <= _MOST_OFFERED,
        "{offered} settings are offered, and 20 at most: mark the others expert=True",
        offered=offered,
    )


def _tracked(clip: Path, spec: TrackerSpec, **asked: Any) -> Run:
    with open_recording(clip) as recording, track(recording, spec.name, **asked) as work:
        for _ in work:
            pass
        return work.run()


def _check_people(run: Run) -> None:
    found = len(set(run.tracks["track"].tolist()))
    require(
        found > 0,
        "nobody of {people} people who walk through the picture was found",
        people=_PEOPLE,
    )


def _check_repeatable(run: Run, again: Run) -> None:
    for name in ("tracks", "detections", "associations", "signals", "parts"):
        one, other = getattr(run, name), getattr(again, name)
        same = all(np.array_equal(one[key], other[key], equal_nan=True) for key in one)
        require(
            same,
            "{name} of two runs with the same seed differ: take all random numbers from a "
            "generator made of the seed, and order nothing by sets",
            name=name,
        )


def _check_range(clip: Path, spec: TrackerSpec) -> None:
    run = _tracked(clip, spec, frames=(8, 14))
    require(run.frames == (8, 14), "frames 8:14 gave the range {frames}", frames=run.frames)
    require(set(run.tracks["frame"].tolist()) <= set(range(8, 14)), "rows of other frames came")


def _check_resumption(clip: Path, spec: TrackerSpec, run: Run) -> None:
    """Tracking again after a correction: ids go on, nobody new takes one that was used."""
    table = TrackTable(run.tracks, highest_track=900)
    resume = Resume.of(table, _RESUMED, _FPS)
    again = _tracked(clip, spec, resume=resume, frames=(_RESUMED, _RESUMED + 8))
    known = set(table.columns()["track"].tolist())
    for track_id in sorted(set(again.tracks["track"].tolist())):
        require(
            track_id in known or track_id > 900,
            "tracking again from frame {frame} gave somebody new the id {id}, though ids up to 900 "
            "were used: begin after resume.highest_track",
            frame=_RESUMED,
            id=track_id,
        )


def _check_session(clip: Path, run: Run, path: Path) -> None:
    """The run goes into a session and comes back; it can be scored."""
    with open_recording(clip) as recording:
        session = Session.create(recording, [run], path)
        session.close()
    read = Session.look_into(path)
    kept = read.runs[0].tracks
    for name, column in run.tracks.items():
        require(
            np.allclose(kept[name], column, equal_nan=True, atol=1e-3),
            "column {name} does not come back from a session",
            name=name,
        )
    read.close()


def _check_overlays(clip: Path, spec: TrackerSpec) -> None:
    """What it offers to views can be drawn."""
    overlays, settings = spec.overlays, spec.settings_type()
    with open_recording(clip) as recording:
        view = recording.view
    if view is None:
        return
    places = np.array([[0.0, 5.0], [1.0, 7.0]])
    bodies = Bodies(places, np.array([np.nan, 1.7]))
    if overlays.outlines is not None:
        drawn = overlays.outlines(view, settings, bodies, 20)
        require(drawn.shape == (2, 20, 2), "outlines must be (n, points, 2)")
    if overlays.kernel is not None:
        require(overlays.kernel(view, settings, places).shape == (2, 4, 2), "kernels: (n, 4, 2)")
