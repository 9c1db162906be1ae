"""`score` of body parts, where the truth tells of them."""

from __future__ import annotations

import json
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import Trackwright

from app.cli.score_inputs import part_rates
from app.cli.tracks import tracks_at
from tracking.editing import plan_delete, plan_label_part
from tracking.recording import open_recording
from tracking.scoring.parts import judge, read_part_truth, tracked_parts
from tracking.session import Session
from tracking.tracks import PART_COLUMNS, TRACK_COLUMNS, Columns, PartLabel, Run
from tracking.truth import TRUE_PARTS, read_true_parts

TORSO = 1
ASIDE = (0.0, 0.0, 9.0, 9.0)


def _exact(footage: Path, run: Run) -> Run:
    """The run of a tracker that follows everybody's parts exactly."""
    true = read_true_parts(footage / TRUE_PARTS)
    middle = true.box[:, :2] + true.box[:, 2:] / 2
    known = {"frame": true.frame, "track": true.person, "part": true.part}
    known |= {"cx": middle[:, 0], "cy": middle[:, 1]}
    known |= {"width": true.box[:, 2], "height": true.box[:, 3]}
    parts = _columns(PART_COLUMNS, known)
    head = true.part == 0
    boxes = {"left": true.box[head, 0], "top": true.box[head, 1]}
    boxes |= {"width": true.box[head, 2], "height": np.full(head.sum(), 60.0)}
    people = {"frame": true.frame[head], "track": true.person[head], **boxes}
    tracks = _columns(TRACK_COLUMNS, people)
    return replace(run, tracks=tracks, parts=parts)


def _columns(kinds: dict[str, np.dtype], known: dict[str, np.ndarray]) -> Columns:
    count = len(known["frame"])
    order = np.lexsort((known.get("part", np.zeros(count)), known["track"], known["frame"]))
    return {
        name: known.get(name, np.zeros(count))[order].astype(kind) for name, kind in kinds.items()
    }


@pytest.fixture
def followed(recording: Path, tiny_run: Run, tmp_path: Path) -> Path:
    """A session in which all parts are where they really are."""
    place = tmp_path / "followed.h5"
    with open_recording(recording) as footage:
        Session.create(footage, [_exact(recording, tiny_run)], place).close()
    return place


def test_parts_that_are_where_they_are_have_full_rates(
    trackwright: Trackwright, followed: Path, recording: Path
) -> None:
    status, out, _ = trackwright("score", followed, "--truth", recording, "--json")
    parts = json.loads(out)["parts"]
    assert status == 0
    assert parts["people_judged"] > 1
    assert parts["people_from_start"][0] == parts["people_judged"]
    for subject in ("head", "torso", "hip_leg", "person"):
        assert parts[subject]["right"] == 1.0
        assert set(parts[subject]["unbroken_from_start"]) == {1.0}


def test_rates_stand_below_the_other_measures(
    trackwright: Trackwright, followed: Path, recording: Path
) -> None:
    plain, whole = (
        trackwright("score", followed, "--truth", truth)[1]
        for truth in (followed, recording / "truth.txt")
    )
    assert "body parts" not in plain
    above, table = whole.split("\n\n")
    assert "\nposition error" in above
    assert table.splitlines()[0].split() == [
        *("body", "parts", "head", "torso", "hip-leg", "person", "people")
    ]
    assert "100.0 %" in table.splitlines()[1]


def test_what_people_put_right_counts_and_the_deleted_is_gone(
    followed: Path, recording: Path
) -> None:
    followed_by = tracks_at(followed).parts
    assert followed_by is not None
    true = read_part_truth(recording, 200, followed_by.size_px)
    one = judge(true, tracked_parts(followed_by.columns), followed_by.fps)[0]
    last = one.first_frame + len(one.parts) - 1
    with closing(Session.open(followed)) as session:
        aside = [PartLabel(frame, one.track, TORSO, ASIDE) for frame in (last - 1, last)]
        session.apply(plan_label_part(session.labels, aside))
        session.apply(plan_delete(session.tracks, 2))
        session.save()
    tracks = tracks_at(followed)
    assert tracks.parts is not None
    assert 2 not in tracks.parts.columns["track"]
    rates = part_rates(tracks, recording)
    assert rates is not None
    assert rates.untracked == 1
    frames = sum(rates.people)
    assert (rates.overall[0] - rates.overall[TORSO]) * frames == pytest.approx(2)


def test_parts_are_judged_in_the_frames_that_are_asked_for(
    trackwright: Trackwright, followed: Path, recording: Path
) -> None:
    tracks = tracks_at(followed)
    assert tracks.parts is not None
    true = read_part_truth(recording, tracks.frames, tracks.parts.size_px)
    first = judge(true, tracked_parts(tracks.parts.columns), tracks.parts.fps)[0].first_frame
    words = ("score", followed, "--truth", recording, "--json")
    status, out, _ = trackwright(*words, "--frames", f"{first}:{first + 8}")
    parts = json.loads(out)["parts"]
    assert status == 0
    assert 0 < len(parts["people_from_start"]) <= 8
    assert parts["head"]["right"] == 1.0


def test_nothing_is_said_of_parts_that_nobody_followed(
    trackwright: Trackwright, session: Path, recording: Path
) -> None:
    assert "parts" not in json.loads(
        trackwright("score", session, "--truth", recording, "--json")[1]
    )


def test_nothing_is_said_of_parts_that_truth_does_not_tell(
    trackwright: Trackwright, followed: Path, recording: Path
) -> None:
    (recording / TRUE_PARTS).unlink()
    told = trackwright("score", followed, "--truth", recording, "--json")[1]
    assert "parts" not in json.loads(told)


def test_without_visibility_everybody_is_seen(
    trackwright: Trackwright, followed: Path, recording: Path
) -> None:
    words = ("score", followed, "--truth", recording, "--json")
    before = json.loads(trackwright(*words)[1])["parts"]["people_judged"]
    (recording / "visibility.csv").write_text("frame,id,visibility\n")
    assert json.loads(trackwright(*words)[1])["parts"]["people_judged"] == 0
    (recording / "visibility.csv").unlink()
    assert json.loads(trackwright(*words)[1])["parts"]["people_judged"] >= before


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        (TRUE_PARTS, "0,1,head\n", "line 1: the columns are not frame,id,part"),
        (TRUE_PARTS, "{head}0,1,nose,1,1,2,2,3\n", "line 2: '0,1,nose,1,1,2,2,3' is no true part"),
        (TRUE_PARTS, "{head}999999,1,head,1,1,2,2,3\n", "frame 999999; the recording has 0 to"),
        (TRUE_PARTS, "\x00\xff", "is no table of truth"),
        ("visibility.csv", "frame,id\n", "line 1: the columns are not frame,id,visibility"),
        ("visibility.csv", "frame,id,visibility\n0,1,2.5\n", "'0,1,2.5' is no visibility"),
        ("visibility.csv", "frame,id,visibility\n0,1\n", "'0,1' is no visibility"),
        ("visibility.csv", "frame,id,visibility\n0,1,nan\n", "'0,1,nan' is no visibility"),
    ],
)
def test_an_invalid_truth_of_parts_is_one_line(
    trackwright: Trackwright, followed: Path, recording: Path, name: str, content: str, reason: str
) -> None:
    head = "frame,id,part,left,top,width,height,visible_pixels\n"
    (recording / name).write_text(content.replace("{head}", head), encoding="latin-1")
    status, out, err = trackwright("score", followed, "--truth", recording, "--json")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert name in err
    assert reason in err
