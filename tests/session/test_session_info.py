"""What is told of a session: what people said in it, and how its runs were made."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import pytest
from made_up_sessions import make_recording, make_run

from tracking.editing import plan_label_part, plan_mark_reviewed, plan_occluders
from tracking.errors import SessionError
from tracking.session import Session, describe
from tracking.trackers import settings_values, tracker_named
from tracking.tracks import Occluder, PartLabel

BOX = (1.0, 2.0, 3.0, 4.0)
HEAD, TORSO = 0, 1


def _said(session: Session) -> None:
    """Parts, a pillar and a reviewed range."""
    labels = [PartLabel(frame, 1, HEAD, BOX, on) for frame, on in ((10, True), (11, True))]
    labels += [PartLabel(10, 1, TORSO, BOX, False), PartLabel(11, 1, TORSO, BOX, None)]
    session.apply(plan_label_part(session.labels, labels))
    pillar = Occluder("pillar", ((0.0, 0.0), (9.0, 0.0), (9.0, 9.0)))
    session.apply(plan_occluders(session.labels, [pillar]))
    session.apply(plan_mark_reviewed(session.labels, 0, 0, 20))


EXPECTED = {
    "parts": {
        "head": {"on": 2, "off": 0, "unsure": 0},
        "torso": {"on": 0, "off": 1, "unsure": 1},
        "hip_leg": {"on": 0, "off": 0, "unsure": 0},
    },
    "occluders": 1,
    "lines": 0,
    "regions": 0,
    "reviewed_ranges": 1,
    "described_tracks": 0,
    "decided_review_items": 0,
}


def test_labels_are_counted_whether_they_are_saved_or_wait_in_the_journal(
    session: Session,
) -> None:
    path = session.save()
    _said(session)
    assert describe(path)["labels"] == EXPECTED
    session.save()
    assert describe(path)["labels"] == EXPECTED


def _with_run(tmp_path: Path, **how: Any) -> dict[str, Any]:
    run = replace(make_run(), **how)
    recording = make_recording(tmp_path / "yard")
    with closing(Session.create(recording, [run], tmp_path / "s.h5")) as made:
        (told,) = describe(made.save())["runs"]
    return dict(told)


def test_a_run_tells_the_settings_that_are_not_the_defaults(tmp_path: Path) -> None:
    settings = settings_values(tracker_named("three-part").settings_type())
    settings |= {"adjust": False}
    told = _with_run(tmp_path, tracker="three-part", settings=settings, detector="ab12")
    assert told["settings"] == {"adjust": False}
    assert (told["detector"], told["detector_from"]) == ("ab12", "built-in")


def test_a_run_tells_that_its_detector_was_a_file(tmp_path: Path) -> None:
    settings = {"detector": "mine.h5"}
    told = _with_run(tmp_path, tracker="three-part", settings=settings, detector="cd34")
    assert (told["detector"], told["detector_from"]) == ("cd34", "file")
    assert told["settings"] == settings


def test_of_a_tracker_that_is_not_known_all_settings_are_told(tmp_path: Path) -> None:
    told = _with_run(tmp_path, tracker="of-tomorrow", settings={"depth": 3})
    assert told["settings"] == {"depth": 3}


def test_damaged_labels_are_told_as_damage(session: Session, tmp_path: Path) -> None:
    _said(session)
    spoilt = tmp_path / "spoilt.h5"
    spoilt.write_bytes(session.save().read_bytes())
    with h5py.File(spoilt, "r+") as file:
        file["labels/reviewed/end"][:] = 0
    with pytest.raises(SessionError, match="the session file is damaged"):
        describe(spoilt)
