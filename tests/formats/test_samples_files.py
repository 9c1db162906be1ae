"""Samples come back from the files they were written to, which may come from anywhere."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

from tracking.errors import FormatError
from tracking.failure import BESIDES, SAMPLE_COLUMNS, Samples
from tracking.failure.core.samples import samples_from_rows
from tracking.formats import read_part_labels, read_samples, samples_at, write_samples


@pytest.fixture
def samples() -> Samples:
    random = np.random.default_rng(4112)
    rows = [
        ("yard, 2", 1 + at // 6, at, at % 3, at % 2, "Zoë", "unsure", "label") for at in range(12)
    ]
    time_s = np.arange(12) / 7.0
    time_s[3] = np.nan
    person = np.array([0, 5, -1] * 4, np.int32)
    return samples_from_rows(rows, random.normal(size=(12, 60)), person=person, time_s=time_s)


@pytest.mark.parametrize("ending", [".csv", ".h5"])
def test_samples_come_back_as_they_were(tmp_path: Path, samples: Samples, ending: str) -> None:
    path = tmp_path / f"s{ending}"
    write_samples(path, samples)
    for back in (read_samples(path), samples_at(path)):
        assert back is not None
        assert np.array_equal(back.features, samples.features)
        assert np.array_equal(back.people(), samples.people())
        assert np.array_equal(back.columns["time_s"], samples.columns["time_s"], equal_nan=True)
        for name, dtype in SAMPLE_COLUMNS.items():
            assert back.columns[name].dtype == dtype
            assert back.columns[name].tolist() == samples.columns[name].tolist()


def test_files_of_older_programs_say_nothing_of_persons(tmp_path: Path, samples: Samples) -> None:
    table, arrays = tmp_path / "s.csv", tmp_path / "s.h5"
    write_samples(arrays, samples)
    with h5py.File(arrays, "a") as file:
        file.attrs["format_version"] = "1.0"
        del file["person"], file["time_s"]
    write_samples(table, samples)
    lines = [line.split(",") for line in table.read_text(encoding="utf-8").splitlines()]
    # The recording's name holds a comma of its own in all lines but the header.
    older = [
        ",".join(line[:at] + line[at + 2 :]) for line, at in zip(lines, [8] + [9] * 12, strict=True)
    ]
    table.write_text("\n".join(older) + "\n", encoding="utf-8")
    for path in (table, arrays):
        back = read_samples(path)
        assert back.columns["person"].tolist() == [0] * 12
        assert np.isnan(back.columns["time_s"]).all()
        assert len(set(back.people().tolist())) == 2


def test_libsvm_text_is_refused_for_what_it_does_not_say(tmp_path: Path, samples: Samples) -> None:
    written = write_samples(tmp_path / "s.libsvm", samples)[0]
    with pytest.raises(FormatError, match="whose samples they are") as told:
        read_samples(written)
    assert "export them as .csv or .h5" in str(told.value)


def test_hdf5_of_another_kind_holds_no_samples(tmp_path: Path, samples: Samples) -> None:
    path = tmp_path / "s.h5"
    write_samples(path, samples)
    with h5py.File(path, "a") as file:
        file.attrs["format"] = "trackwright-session"
    assert samples_at(path) is None
    with pytest.raises(FormatError, match="holds no samples"):
        read_samples(path)


def test_labels_and_samples_are_not_taken_for_each_other(tmp_path: Path, samples: Samples) -> None:
    labels, table = tmp_path / "l.csv", tmp_path / "s.csv"
    labels.write_text("frame,track,part,on\n3,1,head,off\n", encoding="utf-8")
    write_samples(table, samples)
    with pytest.raises(FormatError, match=r"labels of parts.*import-labels"):
        read_samples(labels)
    with pytest.raises(FormatError, match=r"holds samples.*trackwright train"):
        read_part_labels(table)


def put(name: str, data: object) -> Callable[[h5py.File], None]:
    def spoil(file: h5py.File) -> None:
        del file[name]
        file[name] = data

    return spoil


def elsewhere(file: h5py.File) -> None:
    del file["label"]
    file["label"] = h5py.ExternalLink("other.h5", "/label")


def one_long_text(file: h5py.File) -> None:
    """Every row the same text, which the file holds once for each."""
    del file["author"]
    file.create_dataset("author", data=["a" * 1000] * 12, dtype=h5py.string_dtype())


SPOILT = [
    (lambda file: file.attrs.__setitem__("format_version", "2.0"), "made by a newer trackwright"),
    (lambda file: file.__delitem__("track"), "has no column track"),
    (lambda file: file.__delitem__("features"), "no table of 36 or 60 features"),
    (put("features", np.zeros((12, 35))), "no table of 36 or 60 features"),
    (put("features", np.full((12, 36), np.nan)), "row 0: a feature is not a finite number"),
    (put("frame", np.zeros(11, np.int32)), "has 11 rows of frame and 12 of features"),
    (put("frame", np.full(12, -1)), "row 0: the frame is not"),
    (put("track", np.zeros(12, np.int32)), "row 0: the track is not a positive number"),
    (put("part", np.full(12, 7)), "row 0: the part is not 0"),
    (put("label", np.full(12, 2)), "row 0: the label is not 1"),
    (put("label", np.ones(12)), "has float64 in 1 dimensions at label"),
    (put("person", np.full(12, -2)), "row 0: the person is not"),
    (put("time_s", np.full(12, np.inf)), "row 0: the time is not"),
    (put("source", np.array(["guess"] * 12, object)), "row 0: the source is not one of"),
    (
        lambda file: file["features"].attrs.__setitem__("names", ["a"] * 60),
        "the samples are damaged; export them again",
    ),
    (elsewhere, "has a link to somewhere else at label"),
]


@pytest.mark.parametrize(("spoil", "why"), SPOILT)
def test_what_cannot_be_samples_is_refused_in_one_line(
    tmp_path: Path, samples: Samples, spoil: Callable[[h5py.File], object], why: str
) -> None:
    path = tmp_path / "s.h5"
    write_samples(path, samples)
    with h5py.File(path, "a") as file:
        spoil(file)
    with pytest.raises(FormatError, match=why) as told:
        samples_at(path)
    assert str(told.value).startswith(str(path))
    assert "\n" not in str(told.value)


def test_more_text_than_any_is_refused(
    tmp_path: Path, samples: Samples, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tracking.formats import samples_inspection
    from tracking.untrusted import Refused

    path = tmp_path / "s.h5"
    write_samples(path, samples)
    samples_inspection.inspect(path)
    with h5py.File(path, "a") as file:
        one_long_text(file)
    monkeypatch.setattr(samples_inspection, "MOST_TEXT", 10_000)
    with pytest.raises(Refused, match="more text than any") as told:
        samples_inspection.inspect(path)
    assert told.value.held == "trackwright-samples"


def test_a_file_cut_short_is_no_samples(tmp_path: Path, samples: Samples) -> None:
    path = tmp_path / "s.h5"
    write_samples(path, samples)
    path.write_bytes(path.read_bytes()[:600])
    assert samples_at(path) is None


def test_what_is_known_besides_has_its_types(samples: Samples) -> None:
    bare = Samples({name: samples.columns[name] for name in SAMPLE_COLUMNS}, samples.features)
    assert {name: bare.columns[name].dtype for name in BESIDES} == {
        name: one.dtype for name, one in BESIDES.items()
    }
    assert bare.times_s()[4] == samples.columns["frame"][4] / 20.0


@pytest.mark.parametrize("ending", [".csv", ".h5"])
def test_evidence_that_is_not_known_stays_so(tmp_path: Path, samples: Samples, ending: str) -> None:
    features = samples.features.copy()
    features[2, 40:] = np.nan
    path = tmp_path / f"s{ending}"
    write_samples(path, Samples(samples.columns, features))
    back = read_samples(path)
    assert np.array_equal(back.features, features, equal_nan=True)
    assert back.has_evidence.tolist() == [row != 2 for row in range(12)]


def test_samples_of_older_programs_have_no_evidence(tmp_path: Path, samples: Samples) -> None:
    path = tmp_path / "s.h5"
    write_samples(path, samples)
    with h5py.File(path, "a") as file:
        names = file["features"].attrs["names"][:36]
        del file["features"]
        file["features"] = samples.features[:, :36]
        file["features"].attrs["names"] = names
    back = read_samples(path)
    assert np.array_equal(back.features[:, :36], samples.features[:, :36])
    assert not back.has_evidence.any()
