"""Detector files: the same detector back, and nothing hostile taken."""

from __future__ import annotations

import io
import shutil
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_parts import made_up_samples

from tracking.errors import FormatError, OutputError
from tracking.failure import (
    Detector,
    TrainingPlan,
    detector_file,
    load_detector,
    save_detector,
    train,
)
from tracking.failure.inspection import inspect
from tracking.failure.training import Candidate
from tracking.untrusted import verdict_by


@pytest.fixture(scope="module")
def detector() -> Detector:
    plan = TrainingPlan(grid=(Candidate(1.0, 0.3), Candidate(0.1, 0.0)), folds=2, searched=200)
    return train(made_up_samples(3, people=6), plan, random=np.random.default_rng(1)).detector


@pytest.fixture(scope="module")
def good(detector: Detector, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("detector") / "d.h5"
    save_detector(path, detector)
    return path


@pytest.fixture
def copy(good: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy that is looked over in this process: the same check, without another Python."""
    monkeypatch.setattr(
        detector_file, "verdicts_of", lambda _, __, paths: [verdict_by(inspect, p) for p in paths]
    )
    return Path(shutil.copy(good, tmp_path / "d.h5"))


def test_a_detector_comes_back_as_it_was(detector: Detector, good: Path) -> None:
    back = load_detector(good)
    features = made_up_samples(4, people=2).features
    ours, theirs = detector.judge(features), back.judge(features)
    assert np.array_equal(ours.score, theirs.score)
    assert np.array_equal(ours.several, theirs.several)
    assert back.fingerprint == detector.fingerprint
    assert back.origin.recordings == ("yard",)
    assert back.origin.counts.tolist() == detector.origin.counts.tolist()
    for name in ("people", "samples", "made", "software", "chosen"):
        assert getattr(back.origin, name) == getattr(detector.origin, name)
    assert np.array_equal(back.with_operating_point(0.1).rates(), back_rates(detector))


def back_rates(detector: Detector) -> np.ndarray:
    return detector.with_operating_point(0.1).rates()


def test_the_same_detector_gives_the_same_bytes(
    detector: Detector, good: Path, tmp_path: Path
) -> None:
    save_detector(tmp_path / "again.h5", detector)
    assert (tmp_path / "again.h5").read_bytes() == good.read_bytes()


def test_the_file_says_how_good_it_is(detector: Detector, good: Path) -> None:
    with h5py.File(good) as file:
        rates = [
            (file["operating"][part].attrs["false_alarms"], file["operating"][part].attrs["found"])
            for part in ("head", "torso", "hip-leg")
        ]
    assert np.allclose(rates, detector.rates())


def spoiled(path: Path, spoil: Callable[[h5py.File], object]) -> Path:
    with h5py.File(path, "a") as file:
        spoil(file)
    return path


def replaced(file: h5py.File, name: str, data: object) -> None:
    del file[name]
    file[name] = data


SPOILT = [
    (
        lambda f: f.attrs.__setitem__("format", "trackwright-session"),
        "is a trackwright session, no",
    ),
    (lambda f: f.attrs.__setitem__("format", "other"), "no trackwright detector"),
    (lambda f: f.attrs.__setitem__("format_version", "9.0"), "newer trackwright"),
    (lambda f: f.__delitem__("machines/torso"), "no array machines/torso/support"),
    (lambda f: f.__delitem__("machines/head/coefficient"), "no array"),
    (lambda f: f.__setitem__("more", h5py.ExternalLink("/etc/passwd", "/")), "somewhere else"),
    (lambda f: f.__setitem__("more", h5py.SoftLink("/machines")), "somewhere else"),
    (lambda f: f.create_dataset("big", (1 << 28,), "f8", chunks=True), "cannot hold"),
    (lambda f: replaced(f, "preparation/centre", np.zeros(36, "S3")), "numbers or text"),
    (lambda f: replaced(f, "preparation/centre", np.zeros(9)), "has the shape"),
    (lambda f: replaced(f, "preparation/scale", np.zeros(36)), "damaged"),
    (lambda f: replaced(f, "machines/head/support", np.zeros((0, 36))), "damaged"),
    (lambda f: replaced(f, "machines/head/support", np.full((2, 36), np.nan)), "damaged"),
    (lambda f: replaced(f, "operating/head/on", np.array([2.0, 1.0])), "not ascending"),
    (lambda f: f["machines/head"].attrs.__setitem__("gamma", -1.0), "is no machine"),
    (lambda f: f["machines/head"].attrs.__setitem__("gamma", np.nan), "no number"),
    (lambda f: f["operating/head"].attrs.__delitem__("threshold"), "damaged"),
    (lambda f: replaced(f, "origin/counts", np.zeros((2, 2), int)), "another shape"),
]


@pytest.mark.parametrize(("spoil", "why"), SPOILT)
def test_what_is_no_detector_is_refused(
    copy: Path, spoil: Callable[[h5py.File], object], why: str
) -> None:
    with pytest.raises(FormatError, match=why) as told:
        load_detector(spoiled(copy, spoil))
    assert str(copy) in str(told.value)
    assert "\n" not in str(told.value)


@pytest.mark.parametrize("content", [b"", b"no detector at all", b"\x89HDF\r\n\x1a\n" + b"\0" * 90])
def test_other_files_are_refused(copy: Path, content: bytes) -> None:
    copy.write_bytes(content)
    with pytest.raises(FormatError, match=r"empty|not an HDF5|damaged"):
        load_detector(copy)


def test_the_verdict_of_another_program_is_told(good: Path, tmp_path: Path) -> None:
    path = Path(shutil.copy(good, tmp_path / "d.h5"))
    spoiled(path, lambda file: file.attrs.__setitem__("format_version", "3.0"))
    with pytest.raises(FormatError, match="newer trackwright"):
        load_detector(path)


def test_spoilt_bytes_never_end_in_anything_but_an_error(copy: Path) -> None:
    chance, data, refused = np.random.default_rng(5), copy.read_bytes(), 0
    for _ in range(40):
        spoilt = bytearray(data)
        for place in chance.integers(0, len(data), chance.integers(1, 60)):
            spoilt[place] = int(chance.integers(0, 256))
        copy.write_bytes(spoilt)
        try:
            judged = load_detector(copy).judge(np.zeros((2, 36)))
        except FormatError:
            refused += 1
        else:
            assert judged.failed.shape == judged.score.shape == (2, 3)
    assert refused > 0


def test_a_missing_file_and_a_folder_are_told(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="no such detector"):
        load_detector(tmp_path / "d.h5")
    with pytest.raises(FormatError, match="this is a folder"):
        load_detector(tmp_path)


def test_nothing_is_written_where_it_cannot_be(detector: Detector, tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="cannot write"):
        save_detector(tmp_path / "missing" / "d.h5", detector)
    assert not list(tmp_path.iterdir())


def test_a_file_holds_arrays_and_nothing_that_runs(good: Path) -> None:
    kinds = set()
    with h5py.File(io.BytesIO(good.read_bytes())) as file:
        file.visititems(
            lambda _, node: kinds.add(node.dtype.kind) if isinstance(node, h5py.Dataset) else None
        )
    assert kinds <= {"f", "i", "O"}
