"""What is typed wrongly ends with status 2, whatever else is wrong, and prints nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from command_line import Trackwright

R, S, OUT = "RECORDING", "SESSION", "OUT.h5"
TRACK = ("track", R, "-o", OUT)
SYNTH = ("synth", "OUT")
MISUSES = [
    *[(*TRACK, *words) for words in (
        ("--tracker", "nonsense"), ("--set", "nonsense=1"), ("--set", "nonsense"),
        ("--tracker", "stereo-joint", "--set", "agility=1"),
        ("--tracker", "spheroid", "--set", "smooth=perhaps"),
        ("--set", "smooth=1", "--set", "smooth=1"),
        ("--tracker", "three-part", "--detector", "none.h5"),
        ("--tracker", "three-part", "--set", "detector=none.h5"),
        ("--tracker", "flow", "--detector", S), ("--frames", "a:b"), ("--frames", "5:5"),
        ("--frames", "0:99999"), ("--seed", "-1"), ("--seed", "1.5"), ("--fps", "0"),
        ("--fps", "nan"), ("--height", "-1"), ("--height", "inf"), ("--tilt", "nan"),
        ("--tilt", "900"), ("--roll", "inf"), ("--layout", "diagonal"), ("--first", "middle"),
        ("--right", "right.mp4", "--from", "3"), ("--until", "0"), ("--nonsense",),
    )],
    ("track", "nowhere", "-o", OUT, "--tracker", "nonsense"),
    ("track", R, "-o", "session.txt"), ("track", R, "-o", "-"), ("track", R),
    ("track", "--again", S),
    ("track", "--again", S, "--from", "3", "--tracker", "nonsense"),
    *[(*SYNTH, *words) for words in (
        ("--scene", "nonsense"), ("--scene", "plaza", "--seconds", "0"),
        ("--scene", "plaza", "--seconds", "nan"), ("--scene", "plaza", "--people", "-1"),
        ("--scene", "plaza", "--seed", "-1"), ("--scene", "plaza", "--begin", "-1"),
        ("--scene", "plaza", "--dim", "nan"), ("--scene", "plaza", "--bump", "-5"),
    )],
    ("trackers", "nonsense"),
    *[("score", S, "--truth", R, *words) for words in (
        ("--match", "smell"), ("--as", "nobody"), ("--radius", "1"),
        ("--match", "floor", "--radius", "0"), ("--match", "floor", "--radius", "nan"),
        ("--frames", "x"), ("--range", "9:1"), ("--distances", "near"), ("--distances", "5,1"),
        ("--line", "nonsense"), ("--picture-line", "a:1,2"),
    )],
    *[("compare", S, S, "--match", "floor", "--radius", r) for r in ("0", "nan", "wide")],
    ("compare", S, S, "--match", "smell"),
    *[("review", S, *words) for words in (("--order", "smell"), ("--most", "0"))],
    *[("count", S, *words) for words in (
        ("--step", "0"), ("--step", "nan"), ("--jitter", "-1"), ("--line", "a"),
        ("--line", "a:1,2"), ("--region", "a:0,0:1,1"), ("--picture-region", "x"),
        ("--jitter-px", "nan"),
        ("--run", "-1"),
        ("--line", "a:0,0:1,1", "--csv", "-", "--json"),
    )],
    ("export", S, "-o", "out.txt", "--format", "nonsense"),
    ("export", S, "-o", "out.txt", "--format", "idtracker"),
    ("export", S, "-o", "-", "--format", "pedpy-h5"), ("export", S, "-o", "out.txt"),
    ("export", S, "-o", "-", "--format", "mot", "--json"),
    ("export", S, "-o", "out.txt", "--format", "labels", "--run", "0"),
    ("export", S, "-o", "out.docx", "--format", "samples"),
    ("import", f"{R}/truth.txt", "-r", R, "-o", OUT, "--format", "nonsense"),
    ("import", f"{R}/truth.txt", "-r", R, "-o", OUT, "--thin", "nan"),
    ("import", f"{R}/truth.txt", "-r", R, "-o", OUT, "--thin", "-1"),
    ("import", f"{R}/truth.txt"), ("import", f"{R}/truth.txt", "--into", S, "-o", OUT),
    ("restore", S, "--generation", "0"),
    ("train", S, "-o", "detector.txt"), ("train", S, "-o", OUT, "--false-alarms", "0.9"),
    ("train", S, "-o", OUT, "--false-alarms", "nan"), ("train", S, "-o", OUT, "--seed", "-1"),
    ("log", S, "--csv", "-", "--json"),
]  # fmt: skip


@pytest.mark.parametrize("words", MISUSES, ids=" ".join)
def test_what_is_typed_wrongly_is_status_2_and_one_line(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path, words: tuple[str, ...]
) -> None:
    places = {R: str(footage), S: str(made)}
    typed = [places.get(word, word.replace(R, str(footage))) for word in words]
    typed = [str(tmp_path / word) if word.startswith(("OUT", "out.")) else word for word in typed]
    status, printed, err = trackwright(*typed)
    assert (status, printed) == (2, "")
    assert err.splitlines()[-1].startswith("trackwright: ")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "words",
    [
        ("info", "nowhere"),
        ("track", "nowhere", "-o", OUT),
        ("score", "nowhere", "--truth", R),
        ("export", "nowhere", "-o", "out.txt", "--format", "mot"),
        ("import", "nowhere", "-r", R, "-o", OUT),
        ("count", "nowhere", "--line", "a:0,0:1,1"),
        ("log", "nowhere"),
        ("restore", "nowhere"),
        ("train", "nowhere", "-o", OUT),
        ("review", "nowhere"),
        ("compare", "nowhere", S),
    ],
    ids=" ".join,
)
def test_an_input_that_fails_is_status_1_and_puts_nothing_on_stdout(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path, words: tuple[str, ...]
) -> None:
    places = {R: footage, S: made, OUT: tmp_path / OUT, "nowhere": tmp_path / "nowhere"}
    typed = [places.get(word, word) for word in words]
    assert trackwright(*typed, "--json")[:2] == (1, "")
