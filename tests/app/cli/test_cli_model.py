"""`track --model`: a network finds people, and the session keeps which one it was."""

from __future__ import annotations

import json
import sys
from contextlib import closing
from pathlib import Path

import cv2
import numpy as np
import pytest
from command_line import Trackwright

sys.path.insert(0, str(Path(__file__).parents[2] / "networks"))

from small_networks import bright_rectangles, written

from tracking.session import Session

FRAMES = 30
WIDTH, HEIGHT = 24, 60
SIZE_PX = (192, 144)
KEYS = {"decoder": "yolo", "classes": ["person"], "head": "v8", "min_score": 0.8}
ONLY = ("--tracker", "three-part", "--set", "detections.use=only")


def left_of(frame: int) -> int:
    """Where somebody is in a frame."""
    return 20 + 3 * frame


@pytest.fixture
def footage(tmp_path: Path) -> Path:
    """Somebody bright who walks through the dark."""
    folder = tmp_path / "walk"
    (folder / "left").mkdir(parents=True)
    (folder / "recording.toml").write_text('format = 1\nfps = 25.0\n[left]\nsource = "left"\n')
    rng = np.random.default_rng(0)
    for frame in range(FRAMES):
        picture = rng.integers(20, 40, (*SIZE_PX[::-1], 3), np.uint8)
        left = left_of(frame)
        picture[50 : 50 + HEIGHT, left : left + WIDTH] = 250
        cv2.imwrite(str(folder / "left" / f"{frame:04}.png"), picture)
    return folder


@pytest.fixture
def network(tmp_path: Path) -> Path:
    """One that finds people of that size."""
    return written(tmp_path / "network", bright_rectangles(8, 20, cell=2), **KEYS)


def test_a_network_finds_who_is_tracked(
    trackwright: Trackwright, footage: Path, network: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    status, _, err = trackwright("track", footage, "--model", network.parent, "-o", out, *ONLY)
    assert status == 0, err
    assert "people.toml (network test network, MIT): 30 boxes in 30 pictures" in err
    with closing(Session.open(out)) as session:
        tracks = session.tracks
        assert len(tracks.track_ids) == 1
        rows = session.runs[0].tracks
        kept = session.runs[0].network_boxes
        boxes = [kept.of_frame(frame) for frame in range(FRAMES)]
        (used,) = session.runs[0].detections_input
    assert [len(box["score"]) for box in boxes] == [1] * FRAMES
    found = np.array([box["left"][0] for box in boxes])
    assert np.abs(found - [left_of(frame) for frame in range(FRAMES)]).max() < 6
    frames = rows["frame"].astype(int)
    assert set(range(5, FRAMES)) <= set(frames.tolist())
    middle = rows["left"] + rows["width"] / 2
    true = np.array([left_of(frame) + WIDTH / 2 for frame in frames])
    assert np.abs(middle - true).mean() < 6
    assert (used.network, used.decoder, used.licence) == ("test network", "yolo", "MIT")
    assert (used.file, used.format, used.count) == ("people.toml", "network", FRAMES)
    (told,) = json.loads(trackwright("info", out, "--json")[1])["runs"][0]["detections_input"]
    assert told["fingerprint"] == used.fingerprint
    assert "30 boxes of test network (people.toml, MIT" in trackwright("info", out)[1]


def test_tracking_again_refuses_a_network_that_changed(
    trackwright: Trackwright, footage: Path, network: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    assert trackwright("track", footage, "--model", network, "-o", out, *ONLY)[0] == 0
    again = ("track", "--again", out, "--from", "20", "--until", "24", "--allow-outside")
    assert trackwright(*again)[0] == 0
    network.write_text(network.read_text().replace("0.8", "0.7"))
    status, _, err = trackwright(*again)
    assert status != 0
    assert "people.toml" in err
    assert "made with" in err
    assert err.count("\n") == 2  # what is done, and why not


def test_tracking_again_runs_no_network_that_only_the_session_names(
    trackwright: Trackwright, footage: Path, network: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    assert trackwright("track", footage, "--model", network, "-o", out, *ONLY)[0] == 0
    status, _, err = trackwright("track", "--again", out, "--from", "20", "--until", "24")
    assert status != 0
    assert "not in the folder of the recording" in err


def test_a_network_beside_a_file_of_detections_is_refused(
    trackwright: Trackwright, footage: Path, network: Path, tmp_path: Path
) -> None:
    boxes = tmp_path / "det.txt"
    boxes.write_text("1,-1,10,10,20,40,1\n")
    both = ("--model", network, "--detections", boxes)
    status, _, err = trackwright("track", footage, *both, "-o", tmp_path / "s.h5")
    assert status != 0
    assert "leave out --model or --detections" in err


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "decoder is missing"),
        ("decoder = 3\n", "decoder must be yolox or yolo"),
        ("x = ", "not readable as TOML"),
        ('decoder = "yolo"\nsize = [64, 64]\nlicense = "MIT"\n', "license is no key"),
        ('decoder = "yolo"\nhead = "v3"\n', "head must be v5"),
        ('decoder = "yolo"\ndecoded = true\n', "decoded is of decoder yolox"),
        ('decoder = "yolo"\nsize = [64, 9]\n', "size must be 2 numbers"),
        ('decoder = "yolo"\nsize = [64, 64]\nclasses = ["dog"]\n', "none of its classes is person"),
        ('decoder = "yolo"\nsize = [64, 64]\nclasses = "coco"\n', "licence is missing"),
        (
            'decoder = "yolo"\nsize = [64, 64]\nclasses = "coco"\nlicence = "MIT"\n'
            'file = "../people.onnx"\n',
            "file must be the name of a file in the same folder",
        ),
        (
            'decoder = "yolo"\nsize = [64, 64]\nclasses = "coco"\nlicence = "MIT"\n'
            f'sha256 = "{"0" * 64}"\n',
            "its SHA-256 is another one",
        ),
        (
            'decoder = "yolo"\nsize = [64, 64]\nclasses = "coco"\nlicence = "MIT"\n'
            'file = "linked.onnx"\n',
            "cannot read",
        ),
    ],
)
def test_a_toml_that_is_wrong_is_refused_in_one_line(
    trackwright: Trackwright, footage: Path, network: Path, tmp_path: Path, text: str, said: str
) -> None:
    (network.parent / "linked.onnx").symlink_to(network.with_suffix(".onnx"))
    network.write_text(text or "# nothing\n")
    out = tmp_path / "s.h5"
    status, _, err = trackwright("track", footage, "--model", network, "-o", out, *ONLY)
    assert status == 1
    assert said in err
    assert err.count("\n") <= 2
    assert not out.exists()


def test_help_imports_no_networks() -> None:
    import subprocess

    script = (
        "import sys; sys.argv = ['trackwright', '--help']\n"
        "from app.__main__ import run\n"
        "run(['--help'])\n"
        "assert not [name for name in sys.modules if 'networks' in name]\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
