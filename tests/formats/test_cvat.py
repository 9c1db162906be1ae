"""CVAT for video in and out."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import BOX, assert_same, known_rows, table, through, tracks
from numpy.testing import assert_allclose

from tests.pace import spent
from tracking.errors import FormatError
from tracking.formats.cvat import CVAT, import_cvat
from tracking.formats.cvat_track import MOST_EMPTY
from tracking.formats.filled_rows import MOST_FILLED
from tracking.formats.read_result import Filmed
from tracking.formats.track_writer import Exported
from tracking.tracks import Source, TrackLabel, TrackTable

META = """<meta><task><id>5</id><size>100</size><start_frame>0</start_frame>
<stop_frame>99</stop_frame><original_size><width>640</width><height>480</height></original_size>
</task></meta>"""


def box(frame: object, left: float = 0.0, *, outside: int = 0, key: int = 1, more: str = "") -> str:
    return (
        f'<box frame="{frame}" outside="{outside}" occluded="0" keyframe="{key}" xtl="{left}" '
        f'ytl="2" xbr="{left + 10}" ybr="22" {more}></box>'
    )


def track(number: object, *boxes: str, more: str = 'label="person" source="manual"') -> str:
    return f'<track id="{number}" {more}>{"".join(boxes)}</track>'


def written(folder: Path, *tracks: str, meta: str = META) -> Path:
    path = folder / "annotations.xml"
    path.write_text(
        '<?xml version="1.0" encoding="utf-8"?>\n<annotations><version>1.1</version>'
        f"{meta}\n" + "\n".join(tracks) + "</annotations>",
        encoding="utf-8",
    )
    return path


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(tracks())
def test_what_has_a_box_comes_back(tmp_path: Path, made: TrackTable) -> None:
    boxed = known_rows(made.columns(), "left")
    exported = Exported.of_table(made, frames=41, size_px=(640, 480), name="<a> & 'b'")
    if not len(boxed["frame"]):
        with pytest.raises(FormatError, match="nobody has a box"):
            through(CVAT, tmp_path / "t.xml", exported)
        return
    back = through(CVAT, tmp_path / "t.xml", exported)
    assert_same(back.columns, boxed, BOX)
    assert np.isnan(back.columns["x"]).all()
    # A row nobody interpolated is a keyframe.
    assert not np.any((back.columns["source"] == 2) & (boxed["source"] != 2))
    assert (back.size_px, back.frames, back.bad_count) == ((640, 480), 41, 0)


def test_rows_on_the_straight_way_are_no_keyframes_and_others_are(tmp_path: Path) -> None:
    made = table(
        [(frame, 3) for frame in range(9)],
        [(left, 0, 10, 20) for left in (0, 1, 2, 3, 4, 9, 6, 7, 8)],
        source=[1, 2, 2, 1, 2, 2, 1, 2, 2],
    )
    back = through(CVAT, tmp_path / "t.xml", Exported.of_table(made, frames=20))
    assert back.columns["source"].tolist() == [1, 2, 2, 1, 1, 1, 1, 2, 1]


def test_a_tracker_s_rows_stay_a_tracker_s_where_nobody_corrected(tmp_path: Path) -> None:
    made = table([(0, 1), (0, 2), (1, 1), (1, 2)], [(0, 0, 5, 5)] * 4, source=[0, 0, 0, 1])
    back = through(CVAT, tmp_path / "t.xml", Exported.of_table(made))
    assert back.columns["source"].tolist() == [0, 1, 0, 1]


def test_a_gap_and_an_end_are_told_by_outside(tmp_path: Path) -> None:
    made = table([(2, 1), (3, 1), (7, 1)], [(0, 0, 5, 5)] * 3)
    path = tmp_path / "t.xml"
    through(CVAT, path, Exported.of_table(made, frames=9))
    boxes = [line.split('"')[1:6:2] for line in path.read_text().splitlines() if "<box" in line]
    assert boxes == [
        ["2", "1", "0"],
        ["3", "1", "0"],
        ["4", "1", "1"],
        ["7", "1", "0"],
        ["8", "1", "1"],
    ]


def test_names_kinds_attributes_and_occlusion_come_back(tmp_path: Path) -> None:
    made = table([(0, 1), (0, 4), (1, 4)], [(0, 0, 2, 2)] * 3, visibility=[0.9, 0.2, 1.0])
    labels = {
        1: TrackLabel('red "coat" <x>', {"bag": "yes & no"}),
        4: TrackLabel("", {"class": "bicycle"}),
    }
    back = through(CVAT, tmp_path / "t.xml", Exported.of_table(made, labels=labels))
    assert back.labels == labels
    assert back.columns["visibility"].tolist() == [1, 0, 1]


def test_edges_are_those_of_the_box(tmp_path: Path) -> None:
    made = table([(0, 1)], [(0, 3, 10, 20)])
    path = tmp_path / "t.xml"
    through(CVAT, path, Exported.of_table(made))
    assert 'xtl="0.0" ytl="3.0" xbr="10.0" ybr="23.0"' in path.read_text()


def test_ids_survive_a_way_through_cvat(tmp_path: Path) -> None:
    kept = '<attribute name="track_id">41</attribute></box>'
    tracks = (
        track(0, box(0).replace("</box>", kept), box(1).replace("</box>", kept)),
        track(1, box(0)),
    )
    found = import_cvat(written(tmp_path, *tracks), Filmed())
    assert found.columns["track"].tolist() == [41, 42, 41]
    assert found.labels == {}
    assert len(found.notes) == 1


def test_ids_of_cvat_are_kept_but_zero(tmp_path: Path) -> None:
    found = import_cvat(written(tmp_path, track(0, box(0)), track(6, box(0))), Filmed())
    assert found.columns["track"].tolist() == [6, 7]


def test_a_track_told_by_keyframes_alone_is_filled_in_as_cvat_shows_it(tmp_path: Path) -> None:
    boxes = (box(10, 0), box(14, 8), box(16, 8, outside=1), box(96, 1))
    found = import_cvat(written(tmp_path, track(1, *boxes)), Filmed()).columns
    assert found["frame"].tolist() == [10, 11, 12, 13, 14, 15, 96, 97, 98, 99]
    assert_allclose(found["left"], [0, 2, 4, 6, 8, 8, 1, 1, 1, 1])
    person, between = Source.PERSON, Source.INTERPOLATED
    expected = [person, between, between, between, person, between, person, *[between] * 3]
    assert found["source"].tolist() == expected


def test_a_task_of_every_fifth_frame_is_filled_in_at_its_own_frames(tmp_path: Path) -> None:
    meta = META.replace("<size>", "<frame_filter>step=5</frame_filter><size>")
    boxes = (box(10, 0), box(25, 15), box(30, outside=1))
    found = import_cvat(written(tmp_path, track(1, *boxes), meta=meta), Filmed()).columns
    assert found["frame"].tolist() == [10, 15, 20, 25]
    assert_allclose(found["left"], [0, 5, 10, 15])


def test_a_track_that_lists_every_frame_ends_where_it_ends(tmp_path: Path) -> None:
    found = import_cvat(written(tmp_path, track(1, box(3), box(4), box(5))), Filmed())
    assert found.columns["frame"].tolist() == [3, 4, 5]


def test_an_archive_is_read_as_cvat_exports_it(tmp_path: Path) -> None:
    archive = tmp_path / "task.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("annotations.xml", written(tmp_path, track(1, box(3))).read_text())
    assert CVAT.recognises(archive, archive.read_bytes())
    assert import_cvat(archive, Filmed()).columns["frame"].tolist() == [3]
    with zipfile.ZipFile(archive, "w") as made:
        made.writestr("other.txt", "")
    with pytest.raises(FormatError, match=r"without a annotations\.xml|without annotations\.xml"):
        import_cvat(archive, Filmed())


@pytest.mark.parametrize(
    ("bad", "reason"),
    [
        (box(-1), "not a whole number"),
        (box("x"), "not a whole number"),
        (box(10**7), "not one of"),
        (box("9" * 400), "not a whole number"),
        (box(1, float("nan")), "finite"),
        (box(1, float("inf")), "finite"),
        (box(1).replace("xbr", "q"), "four numbers"),
        (box(1).replace('xbr="10.0"', 'xbr="-3"'), "negative size"),
        (box(1, 1e9), "outside any image"),
        (box(0), "twice"),
        (box(1, more='rotation="30"'), "turned by 30"),
        ('<polygon frame="1" points="1,2;3,4"/>', "polygon"),
    ],
)
def test_a_bad_row_is_told_by_its_line(tmp_path: Path, bad: str, reason: str) -> None:
    path = written(tmp_path, track(1, box(0, key=0), "\n", bad))
    line = next(n for n, text in enumerate(path.read_text().splitlines(), 1) if bad in text)
    found = import_cvat(path, Filmed())
    assert [row.place for row in found.bad_rows] == [f"line {line}"]
    assert reason in found.bad_rows[0].reason
    assert found.columns["frame"].tolist() == [0]


@pytest.mark.parametrize("number", ["", "-1", "a", str(10**12)])
def test_a_track_without_an_id_is_bad(tmp_path: Path, number: str) -> None:
    found = import_cvat(written(tmp_path, track(number, box(0)), track(2, box(0))), Filmed())
    assert found.bad_count == 1
    assert found.columns["track"].tolist() == [2]


BOMBS = [
    '<!DOCTYPE a [<!ENTITY b "cc"><!ENTITY d "&b;&b;">]><annotations>&d;</annotations>',
    '<!DOCTYPE a SYSTEM "file:///etc/passwd"><annotations/>',
    "<annotations>" + "<a>" * 100_000,
    "<annotations>" + "a" * 200_000 + "</annotations>",
    '<annotations><track id="1" label="' + "a" * 2_000_000 + '"/></annotations>',
    "<annotations><" + "a" * 3_000_000,
    "<annotations><track>",
    "<annotations>" + " " * 2_000_000 + "</annotations>",
    "<annotations>&undefined;</annotations>",
    "<svg/>",
    "",
    "<annotations><image id='0'><box/></image></annotations>",
    "<annotations><meta><project><tasks><task/><task/></tasks></project></meta></annotations>",
]


@pytest.mark.parametrize("text", BOMBS)
def test_hostile_and_broken_xml_is_refused_in_one_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "t.xml"
    path.write_text(text, encoding="utf-8")
    with spent() as time, pytest.raises(FormatError) as told:
        import_cvat(path, Filmed())
    assert str(path) in str(told.value)
    assert time.paces < 300
    assert "\n" not in str(told.value)
    assert len(str(told.value)) < 400


def test_keyframes_that_stand_for_more_rows_than_any_footage_are_refused(tmp_path: Path) -> None:
    far = [track(n, box(0), box(MOST_FILLED - 1)) for n in range(1, 4)]
    with pytest.raises(FormatError, match="stand for more than"):
        import_cvat(written(tmp_path, *far), Filmed())


def test_a_file_of_many_tracks_with_few_far_keyframes_is_refused_before_it_is_read_through(
    tmp_path: Path,
) -> None:
    far = (track(n, box(0), box(1199)) for n in range(20_000))
    meta = META.replace("100<", "1200<").replace("99<", "1199<")
    path = written(tmp_path, *far, meta=meta)
    parts: list[float] = []
    with pytest.raises(FormatError, match=f"more than {MOST_FILLED} boxes between them"):
        import_cvat(path, Filmed(), lambda done, size: parts.append(done / size))
    assert max(parts) < 0.5


def test_no_row_is_filled_beyond_the_recording(tmp_path: Path) -> None:
    far = track(1, box(5), box(9_000_000))
    found = import_cvat(written(tmp_path, far), Filmed(frames=8))
    assert found.columns["frame"].tolist() == [5, 6, 7, 9_000_000]


def test_a_file_of_tracks_without_boxes_is_refused_soon(tmp_path: Path) -> None:
    path = tmp_path / "tracks.xml"
    empty = '<track id="1"/>' * (MOST_EMPTY + 1)
    path.write_text(f"<annotations>{empty}</annotations>")
    with pytest.raises(FormatError, match="hardly more than tracks without boxes"):
        CVAT.read(path, Filmed())  # type: ignore[misc] # it reads
