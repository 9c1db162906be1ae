"""Labels in, a detector out: `train`, `import-labels`, `export` of samples and labels."""

from __future__ import annotations

import csv
import json
import shutil
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
from command_line import Trackwright

from app.features.parts.training_set import source_at
from tracking.editing import plan_label_part
from tracking.failure import FEATURE_NAMES, SAMPLE_COLUMNS, load_detector, training
from tracking.failure.training import Candidate
from tracking.formats import read_samples
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import PART_COLUMNS, PartLabel, Run
from tracking.truth import TRUE_PARTS

_SHARES = ((0.0, 0.14), (0.17, 0.5), (0.55, 0.75))
"""Top and bottom of the parts in a person's box."""


def with_parts(run: Run) -> tuple[Run, np.ndarray]:
    """The run with parts in everybody's box, and which rows of them were lost."""
    tracks, rows = run.tracks, len(run.tracks["frame"])
    random = np.random.default_rng(11)
    parts = {name: np.zeros(rows * 3, dtype) for name, dtype in PART_COLUMNS.items()}
    for name in ("frame", "track"):
        parts[name][:] = np.repeat(tracks[name], 3)
    parts["part"][:] = np.tile(np.arange(3), rows)
    top, bottom = np.array(_SHARES)[parts["part"]].T
    box = {name: np.repeat(tracks[name], 3) for name in ("left", "top", "width", "height")}
    parts["cx"][:] = box["left"] + box["width"] / 2
    parts["cy"][:] = box["top"] + box["height"] * (top + bottom) / 2
    parts["width"][:], parts["height"][:] = box["width"] * 0.5, box["height"] * (bottom - top)
    turn = parts["frame"] // 6
    lost = (turn % 2 == 1) & ((turn // 2 + parts["track"]) % 3 == parts["part"])
    parts["cx"][lost] += box["height"][lost] * random.uniform(0.02, 0.5, int(lost.sum()))
    for name in ("cx", "cy"):
        parts[name][:] += random.normal(0, 0.01, rows * 3) * box["height"]
    return replace(run, parts=parts), lost


def labels_of(run: Run, lost: np.ndarray) -> Iterator[PartLabel]:
    parts = run.parts
    for row in np.flatnonzero(parts["frame"] % 2 == 0).tolist():
        x, y, width, height = (float(parts[n][row]) for n in ("cx", "cy", "width", "height"))
        frame, track, part = (int(parts[n][row]) for n in ("frame", "track", "part"))
        box = (x - width / 2, y - height / 2, width, height)
        yield PartLabel(frame, track, part, box, not lost[row], "tracker", "Ann", "unsure")


@pytest.fixture(scope="module")
def labelled(footage: Path, tiny_run: Run, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session with tracked parts, all labelled in every second frame; not to be changed."""
    place = tmp_path_factory.mktemp("labelled") / "square.h5"
    run, lost = with_parts(tiny_run)
    with (
        open_recording(footage) as recording,
        closing(Session.create(recording, [run], place)) as s,
    ):
        s.apply(plan_label_part(s.labels, labels_of(run, lost)))
        s.save()
    return place


@pytest.fixture(autouse=True)
def quick_search(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two of the grid's candidates: what is tested here is not the search."""
    plan = training.TrainingPlan
    grid = (Candidate(1.0, 0.3), Candidate(10.0, 1.0))
    monkeypatch.setattr(
        "app.cli.train.TrainingPlan",
        lambda **given: plan(**given, grid=grid, folds=2, searched=200, learnt=300),
    )


def test_labels_become_a_detector_and_a_report(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    words = ["train", labelled, "-o", tmp_path / "d.h5", "--report", tmp_path / "r", "--json"]
    status, out, err = trackwright(*words, "--allow-outside")
    assert status == 0, err
    said = json.loads(out)
    detector = load_detector(tmp_path / "d.h5")
    assert said["detector"] == detector.fingerprint
    assert set(said["questions"]) >= {"head", "torso", "hip-leg"}
    assert all(said["questions"][part]["false_alarms"] <= 0.02 for part in said["samples"])
    assert detector.origin.counts.sum() == sum(
        counts[side] for counts in said["samples"].values() for side in ("on", "off")
    )
    page = (tmp_path / "r" / "index.html").read_text(encoding="utf-8")
    mistakes = sum(len(question["mistakes"]) for question in said["questions"].values())
    assert page.count("data:image/jpeg") == mistakes > 0
    assert json.loads((tmp_path / "r" / "report.json").read_text()).keys() < said.keys()


def test_a_folder_is_told_to_be_none(trackwright: Trackwright, tmp_path: Path) -> None:
    status, _, err = trackwright("train", tmp_path, "-o", tmp_path / "d.h5")
    assert status == 1
    assert "name a session file" in err


def test_a_report_never_takes_the_place_of_anything_but_a_report(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "r"
    folder.mkdir()
    (folder / "thesis.txt").write_text("years of work")
    words = ["train", labelled, "-o", tmp_path / "d.h5", "--report", folder, "--allow-outside"]
    status, _, err = trackwright(*words)
    assert (status, err.count("\n")) == (1, 1)
    assert "holds thesis.txt, which is no earlier report" in err
    assert not (tmp_path / "d.h5").exists()
    (folder / "thesis.txt").unlink()
    assert [trackwright(*words)[0] for _ in range(2)] == [0, 0]
    assert sorted(each.name for each in folder.iterdir()) == ["index.html", "report.json"]
    assert "would lie in the report's folder" in trackwright(*words, "-o", folder / "d.h5")[2]


def test_more_false_alarms_find_more(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    found = []
    for share in ("0.01", "0.2"):
        words = ["train", labelled, "-o", tmp_path / "d.h5", "--false-alarms", share, "--json"]
        said = json.loads(trackwright(*words)[1])
        found.append(sum(said["questions"][part]["found"] for part in said["samples"]))
    assert found[1] > found[0]


def test_a_detector_no_better_than_chance_is_told(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    table, drawn = tmp_path / "s.csv", tmp_path / "drawn.csv"
    assert trackwright("export", labelled, "-o", table, "--format", "samples")[0] == 0
    with table.open(newline="") as source, drawn.open("w", newline="") as out:
        rows = list(csv.DictReader(source))
        lots = np.random.default_rng(4110).integers(0, 2, len(rows)).tolist()
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(row | {"label": lot} for row, lot in zip(rows, lots, strict=True))
    status, _, err = trackwright("train", drawn, "-o", tmp_path / "d.h5")
    assert status == 0
    assert "area under the curve 0." in err
    assert "no better than chance: " in err
    told = trackwright("train", labelled, "-o", tmp_path / "good.h5")[2]
    assert "no better than chance: head" not in told


@pytest.mark.parametrize("ending", [".csv", ".h5"])
def test_exported_samples_train_the_same_detector(
    trackwright: Trackwright, labelled: Path, tmp_path: Path, ending: str
) -> None:
    table = tmp_path / f"s{ending}"
    assert trackwright("export", labelled, "-o", table, "--format", "samples")[0] == 0
    detectors = []
    for source in (labelled, table):
        assert trackwright("train", source, "-o", tmp_path / "d.h5")[0] == 0
        detectors.append(load_detector(tmp_path / "d.h5"))
    assert detectors[0].fingerprint == detectors[1].fingerprint
    assert detectors[0].origin.samples == detectors[1].origin.samples


def test_samples_are_exported_by_the_ending(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    words = ["export", labelled, "--format", "samples", "--json", "-o"]
    made = json.loads(trackwright(*words, tmp_path / "s.libsvm")[1])
    assert [Path(path).name for path in made["written"]] == [
        *("s-head.libsvm", "s-torso.libsvm", "s-hip-leg.libsvm")
    ]
    for _ in range(2):  # what it wrote it may replace
        assert trackwright(*words, tmp_path / "s.h5")[0] == 0
    with h5py.File(tmp_path / "s.h5") as file:
        assert file["features"].shape == (made["rows"], 60)
    status, _, err = trackwright(*words, tmp_path / "s.xlsx")
    assert status == 2
    assert ".libsvm" in err


def _would_be_lost(trackwright: Trackwright, labelled: Path, hdf5: Path, text: Path) -> None:
    """A detector and samples are refused in the place of one file, labels in that of another."""
    for words in (
        ["train", labelled, "-o", hdf5],
        ["export", labelled, "-o", hdf5, "--format", "samples"],
        ["export", labelled, "-o", text, "--format", "labels"],
    ):
        status, _, err = trackwright(*words)
        assert (status, "would be lost" in err) == (1, True)


def test_a_session_is_not_lost_to_a_detector_or_samples(
    trackwright: Trackwright, labelled: Path, session: Path
) -> None:
    before = session.read_bytes()
    _would_be_lost(trackwright, labelled, session, session)
    assert session.read_bytes() == before


def test_a_video_is_not_lost_to_a_detector_or_what_is_exported_of_parts(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    video = tmp_path / "victim.h5"
    video.write_bytes(bytes(9000))
    other = Path(shutil.copy(video, tmp_path / "victim.mp4"))
    _would_be_lost(trackwright, labelled, video, other)
    assert video.read_bytes() == other.read_bytes() == bytes(9000)


def test_labels_go_out_and_come_in_again(
    trackwright: Trackwright, labelled: Path, footage: Path, tiny_run: Run, tmp_path: Path
) -> None:
    table, other = tmp_path / "l.csv", tmp_path / "other.h5"
    assert trackwright("export", labelled, "-o", table, "--format", "labels")[0] == 0
    with open_recording(footage) as recording:
        Session.create(recording, [with_parts(tiny_run)[0]], other).close()
    status, out, _ = trackwright("import-labels", table, other, "--json")
    assert status == 0
    counts = json.loads(out)
    assert counts["new"] == counts["read"] > 100
    with closing(Session.open(labelled)) as one, closing(Session.open(other)) as two:
        assert one.labels.parts == two.labels.parts
    assert json.loads(trackwright("import-labels", table, other, "--json")[1])["new"] == 0


def test_labels_without_a_rectangle_get_the_trackers(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    copy, table = tmp_path / "s.h5", tmp_path / "l.csv"
    copy.write_bytes(labelled.read_bytes())
    with closing(Session.open(labelled)) as session:
        parts = session.runs[0].parts
        row = int(np.flatnonzero(parts["frame"] % 2 == 1)[0])
    frame, track, part = (int(parts[name][row]) for name in ("frame", "track", "part"))
    table.write_text(f"frame,track,part,on\n{frame},{track},{part},off\n", encoding="utf-8")
    assert trackwright("import-labels", table, copy, "--author", "Cy")[0] == 0
    with closing(Session.open(copy)) as session:
        label = session.labels.parts[frame, track, part]
    assert (label.on_part, label.author, label.source) == (False, "Cy", "tracker")
    assert label.box[2:] == (parts["width"][row], parts["height"][row])


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("100000,1,head,on", "line 2: frame 100000; the recording has 0 to"),
        ("0,77,head,on", "line 2: track 77 is not there in frame 0"),
        ("0,1,arm,on", "line 2: the part 'arm'"),
    ],
)
def test_a_label_that_does_not_fit_the_session_is_named_by_its_line(
    trackwright: Trackwright, labelled: Path, tmp_path: Path, line: str, why: str
) -> None:
    table = tmp_path / "l.csv"
    table.write_text(f"frame,track,part,on\n{line}\n", encoding="utf-8")
    before = labelled.read_bytes()
    status, _, err = trackwright("import-labels", table, labelled)
    assert (status, why in err) == (1, True)
    assert labelled.read_bytes() == before


def test_truth_beside_the_recording_labels_by_itself(labelled: Path) -> None:
    samples = source_at(labelled, from_truth=True, allow_outside=True).samples
    assert set(samples.columns["source"].tolist()) == {"truth"}
    assert set(samples.columns["label"].tolist()) == {0, 1}
    by_hand = source_at(labelled).samples
    assert set(by_hand.columns["source"].tolist()) == {"label"}


def test_a_recording_elsewhere_is_told_with_the_option_train_has(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    status, _, err = trackwright("train", labelled, "-o", tmp_path / "d.h5", "--from-truth")
    assert (status, err.count("\n")) == (1, 1)
    assert "--allow-outside" in err
    assert "--recording" not in err


def test_without_truth_beside_it_a_recording_does_not_label_itself(
    trackwright: Trackwright, labelled: Path, recording: Path, tmp_path: Path
) -> None:
    (recording / TRUE_PARTS).unlink()
    with closing(Session.open(labelled)) as session, open_recording(recording) as footage:
        Session.create(footage, [session.runs[0]], recording / "s.h5").close()
    words = ["train", recording / "s.h5", "-o", tmp_path / "d.h5", "--from-truth"]
    status, _, err = trackwright(*words)
    assert (status, f"is no {TRUE_PARTS}; label by hand" in err) == (1, True)


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["train", "{made}", "-o", "{out}"], "no body parts; track it with three-part"),
        (["export", "{made}", "-o", "{out}", "--format", "samples"], "track it with three-part"),
        (["export", "{made}", "-o", "{out}", "--format", "labels"], "no labels of body parts"),
        (["export", "{made}", "-o", "{out}", "--format", "samples", "--run", "0"], "leave it out"),
        (["train", "{missing}", "-o", "{out}"], "there is no such session"),
        (["train", "{made}", "-o", "d0.txt"], "a part-failure detector's name ends in .h5"),
        (["import-labels", "{samples}", "{made}"], "holds samples, which are labels no more"),
        (["train", "{labels}", "-o", "{out}"], "take them into the session they belong to"),
    ],
)
def test_what_cannot_be_is_told_in_one_line(
    trackwright: Trackwright, made: Path, tmp_path: Path, words: list[str], why: str
) -> None:
    places = {"made": made, "out": tmp_path / "o.h5", "missing": tmp_path / "m.h5"}
    for name, header in (
        ("samples", ",".join((*SAMPLE_COLUMNS, *FEATURE_NAMES))),
        ("labels", "frame,track,part,on"),
    ):
        places[name] = tmp_path / f"{name}.csv"
        places[name].write_text(header + "\n", encoding="utf-8")
    status, out, err = trackwright(*(word.format(**places) for word in words))
    misused = "leave" in why or "ends in" in why
    assert (status, out, why in err, err.count("\n")) == (1 + misused, "", True, 1)
    assert not (tmp_path / "o.h5").exists()


def test_a_session_named_as_a_detector_is_told_what_it_is(
    trackwright: Trackwright, recording: Path, made: Path, tmp_path: Path
) -> None:
    words = ["track", recording, "-o", tmp_path / "o.h5", "--tracker", "three-part"]
    status, _, err = trackwright(*words, "--detector", made)
    assert (status, err.count("\n")) == (1, 1)
    assert f"{made} is a trackwright session, no detector; train a detector from it" in err


def test_a_table_beside_its_session_names_the_same_people(
    trackwright: Trackwright, labelled: Path, tmp_path: Path
) -> None:
    table = tmp_path / "s.csv"
    trackwright("export", labelled, "-o", table, "--format", "samples")
    people = len(set(read_samples(table).people().tolist()))
    trackwright("train", labelled, table, "-o", tmp_path / "d.h5")
    detector = load_detector(tmp_path / "d.h5")
    with table.open(encoding="utf-8") as stream:
        assert next(csv.reader(stream))[0] == "recording"
    assert detector.origin.people == people
    assert len(detector.origin.recordings) == 1
