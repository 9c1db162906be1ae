"""`count`: passages and occupancy of a session's tracks, as the contract names them."""

from __future__ import annotations

import csv
import json
import shutil
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import Trackwright

from tracking.editing import plan_delete, plan_lines, plan_regions
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import TRACK_COLUMNS, CountingLine, Region, Run

GATE = "gate:0,4:0,6"
HALL = "hall:-1,4:1,4:1,6:-1,6"
FPS = 8.0


def two_walkers(*, on_floor: bool = True) -> dict[str, np.ndarray]:
    """Track 1 walks to the right through x = 0 at 1.25 s, track 2 to the left at the same time."""
    frame = np.repeat(np.arange(21), 2)
    columns = {name: np.zeros(42, dtype) for name, dtype in TRACK_COLUMNS.items()}
    columns["frame"], columns["track"] = (
        frame.astype(np.int32),
        np.tile([1, 2], 21).astype(np.int32),
    )
    x = (frame - 10) * 0.1 * np.tile([1.0, -1.0], 21) + 1e-4
    columns["x"], columns["y"] = x if on_floor else np.full(42, np.nan), np.tile([4.5, 5.5], 21)
    columns["left"], columns["top"] = 160.0 + 50 * x - 5, np.full(42, 100.0)
    columns["width"], columns["height"] = np.full(42, 10.0), np.full(42, 40.0)
    return columns


@pytest.fixture
def walkers(footage: Path, tiny_run: Run, tmp_path: Path) -> Callable[..., Path]:
    """Makes a session of two people who pass each other."""

    def make(*, on_floor: bool = True) -> Path:
        path = tmp_path / "walkers.h5"
        run = replace(tiny_run, tracks=two_walkers(on_floor=on_floor))
        with open_recording(footage) as recording:
            Session.create(recording, [run], path).close()
        return path

    return make


def test_the_contracts_document_is_printed(
    trackwright: Trackwright, walkers: Callable[..., Path]
) -> None:
    status, printed, said = trackwright(
        "count", walkers(), "--line", GATE, "--region", HALL, "--json"
    )
    assert status == 0
    # In frames 0, 4, 8, 12, 16, 20 both stand within 1 m but for the first and the last frame.
    assert json.loads(printed) == {
        "lines": {"gate": {"forward": 1, "backward": 1}},
        "regions": {"hall": {"person_steps": 10}},
    }
    assert "the corrected tracks" in said
    assert "as named" in said


def test_tables_are_printed_for_people(
    trackwright: Trackwright, walkers: Callable[..., Path]
) -> None:
    status, printed, _ = trackwright("count", walkers(), "--line", GATE, "--region", HALL)
    assert status == 0
    assert printed.splitlines() == [
        "line  forward  backward",
        "gate        1         1",
        "region  person-steps  most people  mean people",
        "hall              10            2         0.50",
    ]


def test_steps_go_into_a_csv(
    trackwright: Trackwright, walkers: Callable[..., Path], tmp_path: Path
) -> None:
    out = tmp_path / "steps.csv"
    words = ["--line", GATE, "--region", HALL, "--step", "1", "--csv", out]
    assert trackwright("count", walkers(), *words)[0] == 0
    with out.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["start_s"] for row in rows[:6:2]] == ["0", "1", "2"]
    assert [(row["forward"], row["backward"]) for row in rows[:6:2]] == [
        ("0", "0"),
        ("1", "1"),
        ("0", "0"),
    ]
    assert (rows[3]["name"], rows[3]["people"], rows[3]["density_per_m2"]) == ("hall", "2", "0.5")
    assert rows[3]["mean_speed_m_s"] == "0.8"
    assert rows[1]["forward"] == rows[0]["people"] == rows[-1]["mean_speed_m_s"] == ""


def test_what_is_drawn_in_the_session_counts_where_nothing_is_named(
    trackwright: Trackwright, walkers: Callable[..., Path]
) -> None:
    path = walkers()
    with closing(Session.open(path)) as session:
        lines = [CountingLine("drawn", (0.0, 6.0), (0.0, 4.0))]
        session.apply(plan_lines(session.labels, lines))
        corners = ((155.0, 130.0), (165.0, 130.0), (165.0, 150.0), (155.0, 150.0))
        session.apply(plan_regions(session.labels, [Region("spot", corners, in_picture=True)]))
        session.save()
    status, printed, said = trackwright("count", path, "--json")
    assert status == 0
    assert json.loads(printed)["lines"] == {"drawn": {"forward": 1, "backward": 1}}
    assert list(json.loads(printed)["regions"]) == ["spot"]
    assert "lines drawn; regions spot, drawn in the session" in said


def test_corrections_count_and_a_run_is_as_it_was(
    trackwright: Trackwright, walkers: Callable[..., Path]
) -> None:
    path = walkers()
    with closing(Session.open(path)) as session:
        session.apply(plan_delete(session.tracks, 2))
        session.save()
    corrected = json.loads(trackwright("count", path, "--line", GATE, "--json")[1])
    run = json.loads(trackwright("count", path, "--line", GATE, "--run", "0", "--json")[1])
    assert corrected["lines"]["gate"] == {"forward": 1, "backward": 0}
    assert run["lines"]["gate"] == {"forward": 1, "backward": 1}


def test_lines_in_the_picture_need_no_calibration(
    trackwright: Trackwright, walkers: Callable[..., Path]
) -> None:
    path = walkers(on_floor=False)
    words = [
        "--picture-line",
        "seen:160,150:160,130",
        "--picture-region",
        "q:0,0:320,0:320,240:0,240",
    ]
    status, printed, _ = trackwright("count", path, *words, "--json")
    assert status == 0
    # Looking up the picture the left-hand side is on the left.
    assert json.loads(printed)["lines"]["seen"] == {"forward": 1, "backward": 1}
    assert json.loads(printed)["regions"]["q"] == {"person_steps": 12}
    status, printed, said = trackwright("count", path, "--line", GATE)
    assert (status, printed) == (1, "")
    assert "have no places" in said
    assert "--picture-line" in said


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--line", "gate"], "has no corners"),
        (["--line", "gate:0,4"], "has 1 end;"),
        (["--line", "gate:0,4:0,x"], "has no corners"),
        (["--line", "gate:0,x:0,4"], "is no corner"),
        (["--line", "gate:0,4:0,4"], "has no length"),
        (["--line", "gate:0,4:0,inf"], "is no place"),
        (["--line", ":0,4:0,6"], "needs a name"),
        (["--line", GATE, "--line", GATE], "named twice"),
        (["--line", GATE, "--picture-line", GATE], "--picture-line: 'gate' is named twice"),
        (["--region", "hall:0,0:1,1"], "three or more corners"),
        (["--region", "hall:0,0:1,1:1,0:0,1"], "edges cross"),
        (["--line", GATE, "--step", "0"], "step_s=0.0: must be a number from 0.001 to 3600 s"),
        (["--line", GATE, "--step", "nan"], "step_s=nan: must be a number"),
        (["--line", GATE, "--jitter", "-1"], "jitter_m=-1.0: must be a number from 0 to 5 m"),
    ],
)
def test_an_invalid_line_region_or_step_is_misuse(
    trackwright: Trackwright, made: Path, words: list[str], told: str
) -> None:
    status, printed, said = trackwright("count", made, *words)
    assert (status, printed) == (2, "")
    assert told in said
    assert said.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ([], "no lines or regions drawn in it; name some"),
        (["--line", GATE, "--step", "0.01"], "lasts a frame at least"),
        (["--line", GATE, "--run", "7"], "no run 7"),
    ],
)
def test_what_cannot_be_counted_is_told(
    trackwright: Trackwright, made: Path, words: list[str], told: str
) -> None:
    status, printed, said = trackwright("count", made, *words)
    assert (status, printed) == (1, "")
    assert told in said
    assert said.count("\n") == 1


def test_a_name_may_hold_a_colon(trackwright: Trackwright, walkers: Callable[..., Path]) -> None:
    printed = trackwright("count", walkers(), "--line", f"door: {GATE}", "--json")[1]
    assert list(json.loads(printed)["lines"]) == ["door: gate"]


def test_a_session_is_not_lost_under_the_csv(trackwright: Trackwright, session: Path) -> None:
    before = session.read_bytes()
    status, _, said = trackwright("count", session, "--line", GATE, "--csv", session)
    assert status == 1
    assert "would be lost" in said
    assert session.read_bytes() == before


def test_a_video_is_not_lost_under_the_csv(
    trackwright: Trackwright, made: Path, footage: Path, tmp_path: Path
) -> None:
    video = Path(shutil.copy(footage / "left.mp4", tmp_path / "victim.mp4"))
    before = video.read_bytes()
    status, _, said = trackwright("count", made, "--line", GATE, "--csv", video)
    assert (status, said.count("\n")) == (1, 1)
    assert "choose another name with --csv, or remove the file first" in said
    assert video.read_bytes() == before


def test_a_csv_that_cannot_be_written_is_told_before_the_work(
    trackwright: Trackwright, made: Path, tmp_path: Path
) -> None:
    status, _, said = trackwright("count", made, "--line", GATE, "--csv", tmp_path / "no" / "f.csv")
    assert status == 1
    assert "does not exist" in said
