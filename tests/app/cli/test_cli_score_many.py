"""`trackwright score` on several results, on folders of sequences, and with a report."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.editing import plan_lines
from tracking.session import Session
from tracking.tracks import CountingLine


def _rows(track: int, frames: range, left: float = 10.0, conf: float = 1) -> str:
    return "".join(f"{n},{track},{left + n},20,30,60,{conf},{n / 10},5,0\n" for n in frames)


TRUTH = _rows(1, range(1, 41))
RIGHT = _rows(4, range(1, 41))
SWITCHED = _rows(4, range(1, 21)) + _rows(5, range(21, 41))


@pytest.fixture
def challenge(tmp_path: Path) -> tuple[Path, Path]:
    """Truths as MOTChallenge lays them out, and a tracker's folder as TrackEval does."""
    truths, tracker = tmp_path / "train", tmp_path / "mine"
    (tracker / "data").mkdir(parents=True)
    for name, result in (("B-02", RIGHT), ("A-01", SWITCHED)):
        (truths / name / "gt").mkdir(parents=True)
        (truths / name / "gt" / "gt.txt").write_text(TRUTH)
        (tracker / "data" / f"{name}.txt").write_text(result)
    return truths, tracker


@pytest.fixture
def single(tmp_path: Path) -> tuple[Path, Path, Path]:
    """A truth and two results of it."""
    paths = tuple(tmp_path / name for name in ("truth.txt", "right.txt", "switched.txt"))
    for path, text in zip(paths, (TRUTH, RIGHT, SWITCHED), strict=True):
        path.write_text(text)
    return paths  # type: ignore[return-value]  # three paths


def test_a_folder_of_sequences_gives_a_row_each_and_one_together(
    trackwright: Trackwright, challenge: tuple[Path, Path]
) -> None:
    truths, tracker = challenge
    status, out, _ = trackwright("score", tracker, "--truth", truths)
    assert status == 0
    lines = out.splitlines()
    assert [line.split()[0] for line in lines] == ["mine", "A-01", "B-02", "COMBINED"]
    said = json.loads(trackwright("score", tracker, "--truth", truths, "--json")[1])
    assert list(said["sequences"]) == ["A-01", "B-02"]
    assert said["sequences"]["A-01"]["id_switches"] == said["combined"]["id_switches"] == 1
    assert said["combined"]["frames"] == 80
    assert said["left_out"] == []


def test_names_of_folders_and_files_are_printed_as_plain_letters(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    odd = "A\x1b[31m\udcff"
    (tmp_path / odd / "gt").mkdir(parents=True)
    (tmp_path / odd / "gt" / "gt.txt").write_text(TRUTH)
    results = [tmp_path / f"{part}{odd}" / "mine" for part in ("old", "new")]
    for folder in results:
        (folder / odd).mkdir(parents=True)
        (folder / odd / "result.txt").write_text(RIGHT)
    singles = [folder / odd for folder in results]
    for truth, given in ((tmp_path, results), (tmp_path / odd, singles)):
        status, out, _ = trackwright("score", *given, "--truth", truth, "--per-person")
        assert status == 0
        assert "oldA?[31m?" in out
        assert "on A?[31m?" in out
        assert "\x1b" not in out
        out.encode("utf-8")


def test_results_and_truths_may_stand_in_one_folder_named_alike(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    for name, result in (("one", RIGHT), ("two", SWITCHED)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "truth.txt").write_text(TRUTH)
        (tmp_path / name / "result.txt").write_text(result)
    said = json.loads(trackwright("score", tmp_path, "--truth", tmp_path, "--json")[1])
    assert [one["id_switches"] for one in said["sequences"].values()] == [0, 1]


def test_names_without_a_partner_are_told_and_left_out(
    trackwright: Trackwright, challenge: tuple[Path, Path]
) -> None:
    truths, tracker = challenge
    (tracker / "data" / "B-02.txt").rename(tracker / "data" / "C-03.txt")
    status, out, err = trackwright("score", tracker, "--truth", truths, "--json")
    assert status == 0
    assert "mine has no file for B-02" in err
    assert "mine has files without ground truth: C-03" in err
    assert list(json.loads(out)["sequences"]) == ["A-01"]


def test_nothing_named_alike_is_one_line(
    trackwright: Trackwright, challenge: tuple[Path, Path], tmp_path: Path
) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "X.txt").write_text(RIGHT)
    status, out, err = trackwright("score", tmp_path / "other", "--truth", challenge[0])
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert "truths A-01, B-02; results X; name them alike" in err


def test_files_named_one_by_one_are_one_result_of_a_folder_of_truths(
    trackwright: Trackwright, challenge: tuple[Path, Path]
) -> None:
    truths, tracker = challenge
    files = sorted((tracker / "data").iterdir())
    said = json.loads(trackwright("score", *files, "--truth", truths, "--json")[1])
    assert list(said["sequences"]) == ["A-01", "B-02"]
    both = json.loads(trackwright("score", *files, tracker, "--truth", truths, "--json")[1])
    assert len(both["results"]) == 2
    assert all(one["combined"]["frames"] == 80 for one in both["results"].values())


def test_what_is_missing_or_called_alike_is_one_line(
    trackwright: Trackwright, challenge: tuple[Path, Path]
) -> None:
    truths, tracker = challenge
    (tracker / "data" / "A-01.csv").write_text("x")
    for words, reason in (
        ((tracker / "gone", "--truth", truths), "gone: No such file or directory"),
        ((tracker, "--truth", truths / "gone"), "gone: No such file or directory"),
        ((tracker, "--truth", truths), "are both called A-01; remove one"),
        ((tracker, "--truth", truths / "A-01"), "the ground truth is one sequence"),
        ((tracker, "--truth", tracker / "data" / "A-01.txt"), "the ground truth is one sequence"),
    ):
        status, out, err = trackwright("score", *words)
        assert (status, out, err.count("\n")) == (1, "", 1)
        assert reason in err


def test_several_results_are_compared_under_names_that_differ(
    trackwright: Trackwright, single: tuple[Path, Path, Path], tmp_path: Path
) -> None:
    truth, right, switched = single
    (tmp_path / "old").mkdir()
    (tmp_path / "old" / "right.txt").write_text(SWITCHED)
    words = ["score", right, switched, tmp_path / "old" / "right.txt", "--truth", truth]
    said = json.loads(trackwright(*words, "--json")[1])
    assert [one["id_switches"] for one in said["results"].values()] == [0, 1, 1]
    assert list(said["results"])[2] == "old/right"
    table = trackwright(*words)[1]
    assert next(line for line in table.splitlines() if line.startswith("IDF1")).count("*") == 1


def test_people_and_ranges_are_told_where_they_are_asked_for(
    trackwright: Trackwright, single: tuple[Path, Path, Path]
) -> None:
    truth, _, switched = single
    words = [
        "score",
        switched,
        "--truth",
        truth,
        "--per-person",
        "--range",
        "0:20",
        "--range",
        "9:",
    ]
    said = json.loads(trackwright(*words, "--json")[1])
    assert [row["tracks"] for row in said["per_person"]] == [[4, 5]]
    assert [row["id_switches"] for row in said["ranges"]] == [0, 1]
    assert [(row["start"], row["stop"]) for row in said["ranges"]] == [(0, 20), (9, 40)]
    text = trackwright(*words)[1]
    assert "0 to 39" in text
    assert "9:40" in text


def test_distances_from_the_camera_are_told_where_they_are_asked_for(
    trackwright: Trackwright, single: tuple[Path, Path, Path]
) -> None:
    truth, _, switched = single
    words = ["score", switched, "--truth", truth, "--distances", "0,5.5,6"]
    found = json.loads(trackwright(*words, "--json")[1])["distances"]
    assert [(one["from_m"], one["to_m"]) for one in found] == [(0, 5.5), (5.5, 6), (6, None)]
    assert [(one["truth_rows"], one["id_switches"]) for one in found] == [(22, 1), (11, 0), (7, 0)]
    assert "6 and more" in trackwright(*words)[1]


def test_distances_without_places_on_the_floor_are_one_line(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    path = tmp_path / "flat.txt"
    path.write_text("1,1,10,20,30,60,1,-1,-1,-1\n")
    words = ["score", path, "--truth", path, "--distances", "0,5"]
    status, out, _ = trackwright(*words)
    assert status == 0
    assert out.splitlines()[-1] == "By distance: the ground truth has no positions on the floor."
    assert json.loads(trackwright(*words, "--json")[1])["distances"] == []


def test_definitions_of_another_program_can_be_asked_for(
    trackwright: Trackwright, single: tuple[Path, Path, Path]
) -> None:
    truth, right, _ = single
    words = ["score", right, "--truth", truth, "--json"]
    found = [
        json.loads(trackwright(*words, *more)[1])["MOTP"]
        for more in ([], ["--as", "py-motmetrics"])
    ]
    assert found == [1.0, 0.0]


def test_a_switch_is_no_match_as_py_motmetrics_counts_matches(
    trackwright: Trackwright, single: tuple[Path, Path, Path]
) -> None:
    truth, _, switched = single
    words = ["score", switched, "--truth", truth, "--distances", "0,5", "--json"]
    usual = json.loads(trackwright(*words)[1])
    theirs = json.loads(trackwright(*words, "--as", "py-motmetrics")[1])
    assert usual["id_switches"] == theirs["id_switches"] > 0
    assert theirs["matches"] == usual["matches"] - usual["id_switches"]
    assert theirs["recall"] == usual["recall"]
    assert sum(one["matches"] for one in theirs["distances"]) == theirs["matches"]


def test_passages_over_a_line_are_compared_with_those_that_happened(
    trackwright: Trackwright, single: tuple[Path, Path, Path]
) -> None:
    truth, right, switched = single
    (truth.parent / "seqinfo.ini").write_text("[Sequence]\nframeRate=10\nseqLength=40\n")
    words = ["score", right, switched, "--truth", truth, "--line", "door:1.05,0:1.05,9", "--json"]
    said = json.loads(trackwright(*words)[1])["results"]
    assert said["right"]["passages"]["door"]["hit"] == 1
    assert said["switched"]["passages"]["door"] == {
        "happened": 1, "found": 1, "hit": 1, "recall": 1.0, "precision": 1.0,
    }  # fmt: skip
    (truth.parent / "seqinfo.ini").unlink()
    status, _, err = trackwright(*words)
    assert (status, err.splitlines()[-1].count("frames per second")) == (1, 1)


def test_lines_drawn_in_a_session_count_where_places_are_known(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    with closing(Session.open(session)) as opened:
        line = CountingLine("gate", (-20.0, 4.0), (20.0, 4.0))
        opened.apply(plan_lines(opened.labels, [line]))
        opened.save()
    said = json.loads(trackwright("score", session, "--truth", session, "--json")[1])
    gate = said["passages"]["gate"]
    assert gate["happened"] == gate["found"] == gate["hit"]
    boxes = tmp_path / "boxes.txt"
    boxes.write_text("1,1,10,10,20,40,1,-1,-1,-1\n")
    status, out, err = trackwright("score", boxes, "--truth", session, "--json")
    assert (status, json.loads(out)["passages"]) == (0, {})
    assert "no passages of boxes" in err


def test_a_report_is_written_beside_what_is_printed(
    trackwright: Trackwright, challenge: tuple[Path, Path], tmp_path: Path
) -> None:
    truths, tracker = challenge
    words = ["score", tracker, "--truth", truths, "--report", tmp_path / "report"]
    status, out, err = trackwright(*words)
    assert (status, err) == (0, "scoring ...\n")
    assert out.splitlines()[-1] == str(tmp_path / "report" / "report.html")
    data = json.loads((tmp_path / "report" / "report.json").read_text())
    assert list(data["results"]["mine"]["sequences"]) == ["A-01", "B-02"]
    (tmp_path / "report" / "thesis.txt").write_text("years of work")
    status, out, err = trackwright(*words)
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert "holds thesis.txt" in err


def test_switches_are_shown_from_the_sessions_recording(
    trackwright: Trackwright, session: Path, recording: Path, tmp_path: Path
) -> None:
    broken = tmp_path / "broken.txt"
    truth = (recording / "truth.txt").read_text().splitlines()
    rows = [line.split(",") for line in truth]
    later = [[r[0], str(int(r[1]) + 50 * (int(r[0]) > 60)), *r[2:]] for r in rows]
    broken.write_text("\n".join(",".join(row) for row in later))
    words = ["score", broken, session, "--truth", recording, "--report", tmp_path / "r", "--json"]
    status, out, err = trackwright(*words)
    assert status == 0, err
    assert json.loads(out)["report"] == str(tmp_path / "r" / "report.html")
    page = (tmp_path / "r" / "report.html").read_text(encoding="utf-8")
    switches = json.loads(out)["results"]["broken"]["id_switches"]
    assert page.count("<figure>") >= switches > 0
    assert "the camera" in page


def test_files_of_other_tools_are_scored_as_they_are(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    for name, ending in (("cvat", "xml"), ("pedpy-h5", "h5"), ("csv", "csv")):
        out = tmp_path / f"elsewhere.{ending}"
        assert trackwright("export", session, "-o", out, "--format", name)[0] == 0
        words = ["score", out, "--truth", session, "--json", "--match", "floor"]
        if name == "cvat":
            words = words[:-2]
        said = json.loads(trackwright(*words)[1])
        assert (said["misses"], said["false_positives"], said["id_switches"]) == (0, 0, 0)
        assert said["matches"] > 0


def test_tracks_that_are_no_people_are_left_out_of_a_truth_and_told(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    row = "{} {} {} 0 0 -10 {}0 20 {}9 80 -1 -1 -1 -1000 -1000 -1000 -10\n"
    kinds = {1: "Pedestrian", 2: "Car", 3: "Cyclist"}
    truth = tmp_path / "0000.txt"
    rows = [row.format(f, who, kind, who, who) for f in range(5) for who, kind in kinds.items()]
    truth.write_text("".join(rows))
    status, out, err = trackwright("score", truth, "--truth", truth, "--json")
    assert (status, json.loads(out)["truth_people"]) == (0, 1)
    assert f"note: {truth}: 2 tracks that are no people are left out" in err


def test_an_empty_side_is_told_in_a_line(
    trackwright: Trackwright, single: tuple[Path, Path, Path]
) -> None:
    truth, right, _ = single
    for emptied, word in (
        (right, "everybody counts as missed"),
        (truth, "shares of the ground truth are 0"),
    ):
        emptied.write_text("")
        status, out, err = trackwright("score", right, "--truth", truth, "--json")
        assert status == 0
        assert word in err.splitlines()[-1 if emptied is right else 0]
        assert json.loads(out)["MOTA"] == 0


def test_classes_of_the_later_challenges_say_what_counts(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    kinds = {1: (1, 1), 2: (1, 0), 3: (8, 0), 4: (3, 0)}
    truth = "".join(
        f"{n},{who},{200 * who},20,30,60,{conf},{kind},1\n"
        for n in range(1, 11)
        for who, (kind, conf) in kinds.items()
    )
    result = "".join(
        f"{n},{who},{200 * who},20,30,60,1,-1,-1,-1\n" for n in range(1, 11) for who in kinds
    )
    (tmp_path / "gt.txt").write_text(truth)
    (tmp_path / "result.txt").write_text(result)
    words = ["score", tmp_path / "result.txt", "--truth", tmp_path / "gt.txt", "--json"]
    said = json.loads(trackwright(*words)[1])
    # A distractor takes its box along; a person who does not count, and a car, leave theirs.
    assert (said["truth_people"], said["misses"], said["false_positives"]) == (1, 0, 20)


@pytest.mark.parametrize("name", ["label-studio", "x-anylabeling"])
@pytest.mark.parametrize("of", ["recording", "session"])
def test_percent_and_folders_are_scored_on_either_side(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path, name: str, of: str
) -> None:
    exported = tmp_path / "theirs"
    assert trackwright("export", made, "-o", exported, "--format", name)[0] == 0
    other = footage if of == "recording" else made
    for result, truth in ((exported, other), (made, exported)):
        status, out, _ = trackwright("score", result, "--truth", truth, "--json")
        assert status == 0
        said = json.loads(out)
        assert "sequences" not in said
        assert said["MOTA"] > (0.99 if footage not in (result, truth) else 0.3)


def test_folders_of_a_file_a_frame_are_sequences_among_others(
    trackwright: Trackwright, made: Path, tmp_path: Path
) -> None:
    truths, results = tmp_path / "truths", tmp_path / "results"
    for folder in (truths, results):
        folder.mkdir()
        assert trackwright("export", made, "-o", folder / "a", "--format", "x-anylabeling")[0] == 0
    (truths / "b.txt").write_text(TRUTH)
    (results / "b.txt").write_text(RIGHT)
    status, out, _ = trackwright("score", results, "--truth", truths, "--json")
    assert status == 0
    said = json.loads(out)
    assert {each: said["sequences"][each]["MOTA"] for each in "ab"} == {"a": 1, "b": 1}
    assert trackwright("score", results / "a", "--truth", truths, "--json")[0] == 0
