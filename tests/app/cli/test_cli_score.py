"""`trackwright score` from end to end."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from app.__main__ import run

TRUTH = "".join(f"{n},1,{10 + n},20,30,60,1,{n / 10},5,0\n" for n in range(1, 21))
RESULT = "".join(f"{n},4,{10 + n},22,30,60,1,{n / 10 + 0.1},5,0\n" for n in range(1, 21))


@pytest.fixture
def pair(tmp_path: Path) -> tuple[str, str]:
    (tmp_path / "truth.txt").write_text(TRUTH)
    (tmp_path / "result.txt").write_text(RESULT)
    return str(tmp_path / "result.txt"), str(tmp_path / "truth.txt")


def test_json_is_the_only_thing_on_stdout(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["score", pair[0], "--truth", pair[1], "--json"]) == 0
    out, err = capsys.readouterr()
    numbers = json.loads(out)
    assert (numbers["MOTA"], numbers["frames"], numbers["people_kept"]) == (1, 20, 1)
    assert numbers["position_error_m"]["mean"] == pytest.approx(0.1)
    assert err == ""


def test_people_get_a_table(pair: tuple[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["score", pair[0], "--truth", pair[1]]) == 0
    assert "tracking_accuracy" in capsys.readouterr().out


def test_floor_distance_can_be_asked_for(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["score", pair[0], "--truth", pair[1], "--json", "--match", "floor", "--radius"]
    assert run([*command, "0.2"]) == 0
    assert json.loads(capsys.readouterr().out)["misses"] == 0
    assert run([*command, "0.05"]) == 0
    assert json.loads(capsys.readouterr().out)["misses"] == 20


def test_a_recordings_folder_stands_for_its_truth(
    pair: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["score", pair[0], "--truth", str(Path(pair[1]).parent), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["misses"] == 0


@pytest.mark.parametrize(
    ("options", "status", "reason"),
    [
        (["--match", "sound"], 2, "'sound' is not one of"),
        (["--report", "here"], 2, "not built yet"),
        (["--match", "floor", "--radius", "-1"], 1, "radius -1.0 m is not above 0"),
    ],
)
def test_wrong_options_are_told(
    pair: tuple[str, str],
    capsys: pytest.CaptureFixture[str],
    options: list[str],
    status: int,
    reason: str,
) -> None:
    assert run(["score", pair[0], "--truth", pair[1], *options]) == status
    assert reason in " ".join(capsys.readouterr().err.split())


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("missing.txt", None, "No such file"),
        ("notes.txt", b"dear diary, today\n", "line 1: 2 values"),
        ("picture.png", bytes(range(256)), "not text"),
    ],
)
def test_a_wrong_result_is_one_line_and_status_1(
    pair: tuple[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    name: str,
    content: bytes | None,
    reason: str,
) -> None:
    if content is not None:
        (tmp_path / name).write_bytes(content)
    assert run(["score", str(tmp_path / name), "--truth", pair[1], "--json"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("trackwright: ")
    assert err.count("\n") == 1
    assert name in err
    assert reason in err


def test_a_folder_without_truth_is_told(
    pair: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "empty").mkdir()
    assert run(["score", pair[0], "--truth", str(tmp_path / "empty")]) == 1
    assert "has no truth.txt" in capsys.readouterr().err
