"""Samples and labels of body parts in files of other programs."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tracking.errors import FormatError
from tracking.failure import FEATURE_NAMES, SAMPLE_COLUMNS, SAMPLE_SOURCES, Samples
from tracking.failure.core.samples import samples_from_rows
from tracking.formats import (
    read_part_labels,
    read_samples,
    write_part_labels,
    write_samples,
)
from tracking.tracks import PartLabel

SHARED = settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=20, deadline=None
)
TEXT = st.text(
    st.characters(categories=("L", "N", "P", "S", "Zs"), max_codepoint=0x2FFF), max_size=12
)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False, width=64)
ROWS = st.lists(
    st.tuples(
        TEXT,
        st.integers(1, 2**31 - 1),
        st.integers(0, 2**31 - 1),
        st.integers(0, 2),
        st.integers(0, 1),
        TEXT,
        TEXT,
        st.sampled_from(SAMPLE_SOURCES),
    ),
    max_size=6,
)


@st.composite
def any_samples(draw) -> Samples:
    rows = draw(ROWS)
    seed = draw(st.integers(0, 2**32))
    features = np.random.default_rng(seed).normal(0, 1e3, (len(rows), 60))
    if rows:
        features[0, 0] = draw(NUMBERS)
    return samples_from_rows(rows, features)


@SHARED
@given(any_samples())
def test_samples_come_back_from_csv_as_they_were(tmp_path: Path, samples: Samples) -> None:
    path = tmp_path / "s.csv"
    assert write_samples(path, samples) == [path]
    back = read_samples(path)
    assert np.array_equal(back.features, samples.features)
    for name, dtype in SAMPLE_COLUMNS.items():
        assert back.columns[name].dtype == dtype
        assert back.columns[name].tolist() == samples.columns[name].tolist()


@SHARED
@given(any_samples())
def test_samples_stand_in_hdf5_with_groups_to_split_by(tmp_path: Path, samples: Samples) -> None:
    path = tmp_path / "s.h5"
    write_samples(path, samples)
    with h5py.File(path) as file:
        assert np.array_equal(file["features"][()], samples.features)
        assert tuple(file["features"].attrs["names"]) == FEATURE_NAMES
        assert file["group"][()].tolist() == samples.people().tolist()
        assert file["label"][()].tolist() == samples.columns["label"].tolist()
        assert list(file["author"].asstr()[()]) == samples.columns["author"].tolist()


def test_libsvm_text_is_a_file_a_part_that_the_library_reads(tmp_path: Path) -> None:
    from sklearn.datasets import load_svmlight_file

    random = np.random.default_rng(1)
    rows = [("yard", 1, at, at % 2 * 2, at % 3 == 0, "", "", "label") for at in range(12)]
    samples = samples_from_rows(rows, random.normal(size=(12, 60)))
    made = write_samples(tmp_path / "s.libsvm", samples)
    assert [path.name for path in made] == ["s-head.libsvm", "s-hip-leg.libsvm"]
    features, signs = load_svmlight_file(str(made[1]), n_features=60)
    of_part = samples[samples.columns["part"] == 2]
    assert np.array_equal(features.toarray(), of_part.features)
    assert ((signs > 0) == (of_part.columns["label"] == 1)).all()


def test_an_ending_that_names_no_form_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match=r"end in \.csv"):
        write_samples(tmp_path / "s.xlsx", samples_from_rows((), np.zeros((0, 36))))


GOOD = ("yard", "1", "3", "0", "1", "", "", "label", *("1.5",) * 60)


@pytest.mark.parametrize(
    ("column", "value", "why"),
    [
        ("track", "0", "track is not a positive"),
        ("frame", "-1", "frame is not"),
        ("part", "3", "part is not 0"),
        ("label", "2", "label is not 1"),
        ("source", "guess", "source is not one of"),
        ("frame", "1.5", "frame is '1.5', not a whole number"),
        ("head_x", "far", "head_x is 'far', not a number"),
        ("head_x", "nan", "not a finite number"),
    ],
)
def test_a_sample_that_is_invalid_is_named_by_its_line(
    tmp_path: Path, column: str, value: str, why: str
) -> None:
    names = (*SAMPLE_COLUMNS, *FEATURE_NAMES)
    bad = [value if name == column else good for name, good in zip(names, GOOD, strict=True)]
    path = tmp_path / "s.csv"
    path.write_text("\n".join(map(",".join, (names, GOOD, bad))) + "\n", encoding="utf-8")
    with pytest.raises(FormatError, match=f"line 3: .*{why}"):
        read_samples(path)


LABELS = st.lists(
    st.builds(
        PartLabel,
        frame=st.integers(0, 2**31 - 1),
        track=st.integers(1, 2**31 - 1),
        part=st.integers(0, 2),
        box=st.tuples(
            *(st.floats(-1e6, 1e6) for _ in range(2)), *(st.floats(1e-6, 1e6) for _ in range(2))
        ),
        on_part=st.sampled_from([True, False, None]),
        source=st.sampled_from(["tracker", "person", "truth"]),
        author=TEXT.filter(str.isprintable),
        reason=TEXT.filter(str.isprintable),
    ),
    unique_by=lambda label: label.key,
    max_size=8,
)


@SHARED
@given(LABELS)
def test_labels_come_back_as_they_were(tmp_path: Path, labels: list[PartLabel]) -> None:
    path = tmp_path / "l.csv"
    write_part_labels(path, labels)
    back = read_part_labels(path)
    assert [one.label for one in back] == labels
    assert all(one.has_box for one in back)


def test_the_shortest_table_of_labels_is_read(tmp_path: Path) -> None:
    path = tmp_path / "l.csv"
    path.write_text("frame,track,part,on\n3,1,head,on\n\n4,1,2,0\n5,1,Torso,\n", encoding="utf-8")
    given_labels = read_part_labels(path, author="Bo")
    said = [(one.line, one.label.part, one.label.on_part) for one in given_labels]
    assert said == [(2, 0, True), (4, 2, False), (5, 1, None)]
    assert {one.label.author for one in given_labels} == {"Bo"}
    assert {one.label.source for one in given_labels} == {"tracker"}
    assert not any(one.has_box for one in given_labels)


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("3,1,arm,on", "the part 'arm' is none"),
        ("3,1,head,maybe", "'maybe' in column on"),
        ("3,0,head,on", "track 0 in a label"),
        ("-1,1,head,on", "frame -1 in a label"),
        ("x,1,head,on", "the frame 'x' is no whole number"),
        ("3,1,head", "3 values where the header names 4"),
        ("2,1,head,off", "line 2 speaks of the same part"),
    ],
)
def test_a_label_that_is_invalid_is_named_by_its_line(tmp_path: Path, line: str, why: str) -> None:
    path = tmp_path / "l.csv"
    path.write_text(f"frame,track,part,on\n2,1,head,on\n{line}\n", encoding="utf-8")
    with pytest.raises(FormatError, match=f"line 3: .*{why}"):
        read_part_labels(path)


@pytest.mark.parametrize(
    ("box", "why"),
    [
        ("1,2,3,", "not four numbers"),
        ("1,2,inf,4", "not four finite numbers"),
        ("1,2,0,4", "positive"),
        ("1,2,1e308,4", "within a billion"),
    ],
)
def test_half_a_box_is_refused(tmp_path: Path, box: str, why: str) -> None:
    path = tmp_path / "l.csv"
    header = "frame,track,part,on,left,top,width,height"
    path.write_text(f"{header}\n2,1,head,on,{box}\n", encoding="utf-8")
    with pytest.raises(FormatError, match=f"line 2: .*{why}"):
        read_part_labels(path)


@pytest.mark.parametrize(
    ("header", "why"),
    [
        ("frame,track,part", "no column 'on'"),
        ("frame;track;part;on", "separated by semicolons"),
        ("frame,track,part,on,colour", "'colour' is none of ours"),
        ("frame,track,part,on,on", "'on' stands there twice"),
    ],
)
def test_a_header_that_is_none_is_refused(tmp_path: Path, header: str, why: str) -> None:
    path = tmp_path / "l.csv"
    path.write_text(f"{header}\n", encoding="utf-8")
    with pytest.raises(FormatError, match=f"line 1: .*{why}"):
        read_part_labels(path)


def test_what_is_no_text_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "l.csv"
    path.write_bytes(b"frame,track,part,on\n\xff\xfe")
    with pytest.raises(FormatError, match="not text"):
        read_part_labels(path)
    with pytest.raises(FormatError, match="cannot read"):
        read_part_labels(tmp_path / "missing.csv")


SAMPLE_HEAD = (",".join((*SAMPLE_COLUMNS, *FEATURE_NAMES)) + "\n").encode()
HEAD = b"frame,track,part,on\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"ab," * 2_000_000, "line 1: longer than 64 kB"),
        (HEAD + b"1,1,head," + b"on" * 3_000_000, "line 2: longer than 64 kB"),
        (b'"\n",' * 1_000_000, "longer than 64 kB"),
        (HEAD + b"\n" * 6_000_000, "hardly more than empty lines"),
        (HEAD + b",,,\n" * 1_000_000, "hardly more than empty lines"),
    ],
    ids=["header", "row", "lines in quotes", "empty lines", "empty rows"],
)
@pytest.mark.parametrize("read", [read_part_labels, read_samples])
def test_a_table_of_hardly_any_rows_is_refused_in_little_memory(
    tmp_path: Path, read: Callable[[Path], object], text: bytes, message: str
) -> None:
    path = tmp_path / "t.csv"
    path.write_bytes(text if read is read_part_labels else text.replace(HEAD, SAMPLE_HEAD))
    tracemalloc.start()
    try:
        with pytest.raises(FormatError, match=message):
            read(path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 8 << 20
