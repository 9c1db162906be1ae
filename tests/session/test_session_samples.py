"""The samples in a session: made of labels, tracks and run, under the ids people have by now."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from made_up_sessions import make_recording, make_run

from tracking.editing import plan_label_part, plan_swap
from tracking.errors import SessionError
from tracking.failure import FEATURE_NAMES, Samples, samples_of
from tracking.session import Session, places_of, samples_with_boxes, session_samples
from tracking.session.notes import LOGGER
from tracking.tracks import PART_COLUMNS, PartLabel


def parts_of(tracks) -> dict[str, np.ndarray]:
    """Three parts for each row of a run's tracks, each at a place of its own."""
    rows = len(tracks["frame"])
    columns = {name: np.zeros(rows * 3, dtype) for name, dtype in PART_COLUMNS.items()}
    for name in ("frame", "track"):
        columns[name][:] = np.repeat(tracks[name], 3)
    columns["part"][:] = np.tile(np.arange(3), rows)
    columns["cx"][:] = np.arange(rows * 3) % 97
    columns["cy"][:] = 50 + 40.0 * columns["part"] + np.arange(rows * 3) % 7
    columns["width"][:], columns["height"][:] = 10, 12
    return columns


@pytest.fixture
def session(tmp_path: Path) -> Session:
    run = make_run()
    run = replace(run, parts=parts_of(run.tracks))
    made = Session.create(make_recording(tmp_path / "yard"), [run], tmp_path / "s.h5")
    yield made
    made.close()


def label(session: Session, frame: int, track: int, part: int, on: bool) -> PartLabel:
    parts = session.runs[0].parts
    at = (parts["frame"] == frame) & (parts["track"] == track) & (parts["part"] == part)
    x, y, width, height = (float(parts[n][at][0]) for n in ("cx", "cy", "width", "height"))
    box = (x - width / 2, y - height / 2, width, height)
    return PartLabel(frame, track, part, box, on, "tracker", "Ann", "unsure")


def frames_of_both(session: Session) -> list[int]:
    one, two = (session.tracks.frames_of_track(track).tolist() for track in (1, 2))
    return sorted(set(one) & set(two))


def test_labels_are_samples_in_the_file(session: Session) -> None:
    frame = frames_of_both(session)[20]
    labels = [label(session, frame, 1, part, part > 0) for part in range(3)]
    session.apply(plan_label_part(session.labels, labels))
    with h5py.File(session.save()) as file:
        kept = {name: file["samples"][name][()] for name in file["samples"]}
    samples = session_samples(session)
    assert kept["label"].tolist() == [0, 1, 1]
    assert kept["author"].tolist() == [b"Ann"] * 3
    assert kept["recording"].tolist() == [b"Lobby, camera 3"] * 3
    assert kept["frame"].tolist() == [frame] * 3
    features = np.stack([kept[name] for name in FEATURE_NAMES], axis=1)
    assert np.array_equal(features, samples.features)
    assert np.isfinite(features).all()


def test_samples_of_two_who_were_swapped_go_with_the_person(session: Session) -> None:
    frame = frames_of_both(session)[20]
    session.apply(plan_label_part(session.labels, label(session, frame, 1, 1, False)))
    before = session_samples(session)
    session.apply(plan_swap(session.tracks, 1, 2, frames_of_both(session)[2]))
    after = session_samples(session)
    assert after.columns["track"].tolist() == [2]
    assert np.array_equal(after.features, before.features)


def test_a_session_without_labels_has_no_samples_and_opens(session: Session) -> None:
    path = session.save()
    with h5py.File(path) as file:
        assert not len(file["samples"])
    session.close()
    again = Session.open(path)
    assert len(session_samples(again)) == 0
    again.close()


def test_samples_that_cannot_be_made_are_logged_and_the_session_is_saved(
    session: Session, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken(*_: object) -> None:
        raise ValueError("no features")

    frame = frames_of_both(session)[20]
    session.apply(plan_label_part(session.labels, label(session, frame, 1, 1, False)))
    with monkeypatch.context() as broke:
        broke.setattr("tracking.session.samples.samples_of", broken)
        path = session.save()
    assert "samples of the part labels could not be made" in caplog.text
    with h5py.File(path) as file:
        assert not len(file["samples"])
    session.save()
    session.close()
    again = Session.open(path)
    assert list(again.labels.parts) == [(frame, 1, 1)]
    with h5py.File(path) as file:
        assert len(file["samples/label"]) == 1
    again.close()


def test_a_damaged_run_whose_samples_cannot_be_made_is_told_without_a_traceback(
    session: Session, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def damaged(*_: object) -> None:
        raise SessionError("s.h5: the file is damaged")

    frame = frames_of_both(session)[20]
    session.apply(plan_label_part(session.labels, label(session, frame, 1, 1, False)))
    with monkeypatch.context() as broke:
        broke.setattr("tracking.session.samples.samples_of", damaged)
        path = session.save()
    (told,) = [record for record in caplog.records if "could not be made" in record.message]
    assert told.message.endswith("the file has none: s.h5: the file is damaged")
    assert (told.name, told.exc_info) == (LOGGER, None)
    with h5py.File(path) as file:
        assert not len(file["samples"])


def test_samples_are_made_anew_only_where_labels_or_tracks_changed(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = []

    def counted(*given: Any) -> Samples:
        made.append(given)
        return samples_of(*given)

    monkeypatch.setattr("tracking.session.samples.samples_of", counted)
    frame = frames_of_both(session)[20]
    session.save()
    assert len(made) == 0
    session.apply(plan_label_part(session.labels, label(session, frame, 1, 1, False)))
    session.save()
    kept = session.save()
    assert len(made) == 1
    session.apply(plan_swap(session.tracks, 1, 2, frames_of_both(session)[2]))
    session.save(kept)
    assert len(made) == 2
    with h5py.File(kept) as file:
        assert file["samples/track"][()].tolist() == [2]


def test_a_file_with_half_a_table_of_samples_is_refused(session: Session) -> None:
    frame = frames_of_both(session)[20]
    session.apply(plan_label_part(session.labels, label(session, frame, 1, 1, False)))
    path = session.save()
    session.close()
    with h5py.File(path, "a") as file:
        del file["samples/head_x"]
    with pytest.raises(SessionError, match="no column head_x in samples"):
        Session.open(path)


def test_a_part_put_right_teaches_with_the_rectangle_of_either_side(session: Session) -> None:
    frame = frames_of_both(session)[20]
    judged, wrong = label(session, frame, 1, 0, True), label(session, frame, 1, 1, True)
    right = replace(wrong, box=(300.0, 200.0, 20.0, 30.0), source="person")
    session.apply(plan_label_part(session.labels, [judged, right]))
    run, footage = session.corrected_run, session.recording
    samples, boxes = samples_with_boxes(
        session.labels, session.tracks, run, footage.fps, footage.name
    )
    told = dict(zip(places_of(samples), boxes.tolist(), strict=True))
    assert told == {
        ((frame, 1, 0), True): pytest.approx(judged.box),
        ((frame, 1, 1), True): pytest.approx(right.box),
        ((frame, 1, 1), False): pytest.approx(wrong.box),
    }
