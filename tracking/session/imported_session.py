"""Imported tracks in a session: a new one of their own, or one that is there already."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tracking.editing import Change, Entry, plan_import
from tracking.editing.core.scope import tracks_text
from tracking.errors import EditError
from tracking.session.document import Session
from tracking.session.track_import import IMPORTED, Importable, ImportOrigin
from tracking.stamps import software
from tracking.tracks import (
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Labels,
    Particles,
    Run,
    Source,
    empty,
)
from tracking.translation import Message, msg

if TYPE_CHECKING:
    from tracking.recording import Recording


def session_of_import(recording: Recording, found: Importable, origin: ImportOrigin) -> Session:
    """A session of imported tracks, not saved yet: one run, and what a run cannot say as an edit.

    The run says what the file says but for keyframes, names and attributes: those are corrections.
    """
    run = Run(
        tracker=IMPORTED,
        settings=origin.as_json(),
        seed=0,
        frames=(0, recording.frame_count),
        tracks={name: found.rows[name] for name in TRACK_COLUMNS},
        detections=empty(DETECTION_COLUMNS),
        particles=Particles.none(PARTICLE_COLUMNS),
        software=software(),
    )
    session = Session.create(recording, [run], labels=Labels(schema=found.schema))
    if found.labels or (found.rows["source"] != Source.TRACKER).any():
        change = _plan_import(session, found, origin, vouched=True)
        if change is not None:
            session.apply(replace(change, text=_beyond_the_run(found, origin)))
    return session


def _beyond_the_run(found: Importable, origin: ImportOrigin) -> Message:
    """What the edit after the run is called: the tracks themselves are there without it."""
    who = tracks_text(np.unique(found.rows["track"]).tolist())
    if not found.labels:
        return msg("Make keyframes of {who}", who=who)
    source = " ".join(origin.file.source.split())
    return msg(
        "Take keyframes, names and attributes of {who} from {source}", who=who, source=source
    )


def take_into(session: Session, found: Importable, origin: ImportOrigin) -> Entry | None:
    """Take imported tracks into a session as one edit; None where they say nothing else.

    Tracks the file does not have stay as they are.
    """
    change = _plan_import(session, found, origin)
    return None if change is None else session.apply(change)


def _plan_import(
    session: Session, found: Importable, origin: ImportOrigin, *, vouched: bool = False
) -> Change | None:
    """The edit; None where the session says the same already. vouched: see `plan_import`."""
    source, view = origin.file.source, found.view
    try:
        return plan_import(
            session.tracks,
            session.labels,
            found.rows,
            found.labels,
            source,
            view=view,
            vouched=vouched,
            seen_as=found.seen_as,
            schema=found.schema,
        )
    except EditError:  # it says what is there already
        return None
