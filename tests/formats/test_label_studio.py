"""Label Studio's JSON of video in and out."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import BOX, assert_same, known_rows, table, tracks

from tests.pace import spent
from tracking.errors import FormatError
from tracking.formats.filled_rows import MOST_FILLED
from tracking.formats.label_studio import LABEL_STUDIO
from tracking.formats.label_studio_reader import import_label_studio
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported, no_progress
from tracking.tracks import TrackLabel, TrackTable

SIZE = (640, 480)
FILMED = Filmed(frames=20, fps=25.0, size_px=SIZE)


def key(frame: Any, enabled: Any = True, x: Any = 10, **changed: Any) -> dict[str, Any]:
    box = {"x": x, "y": 25, "width": 5, "height": 50, "rotation": 0}
    return {"frame": frame, "enabled": enabled, **box, **changed}


def region(*keys: Any, name: str = "a", frames: Any = 12, **changed: Any) -> dict[str, Any]:
    value = {"framesCount": frames, "sequence": list(keys), "labels": ["person"]}
    return {"id": name, "type": "videorectangle", "value": value, **changed}


def task(*regions: Any, **said: Any) -> dict[str, Any]:
    return {"data": {"video": "yard.mp4"}, "annotations": [{"result": list(regions), **said}]}


def imported(folder: Path, document: Any, filmed: Filmed = FILMED) -> Imported:
    path = folder / "task.json"
    path.write_text(json.dumps(document), encoding="utf-8")
    assert LABEL_STUDIO.recognises(path, path.read_bytes()[: 1 << 16])
    return import_label_studio(path, filmed)


def lefts(found: Imported) -> dict[tuple[int, int], float]:
    columns = (found.columns[name].tolist() for name in ("frame", "track", "left"))
    return {(frame, track): left for frame, track, left in zip(*columns, strict=True)}


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(tracks())
def test_what_has_a_box_comes_back(tmp_path: Path, made: TrackTable) -> None:
    boxed = known_rows(made.columns(), "left")
    exported = Exported.of_table(made, frames=41, fps=12.5, size_px=SIZE, name='a "b"')
    path = tmp_path / "t.json"
    assert LABEL_STUDIO.write is not None
    if not len(boxed["frame"]):
        with pytest.raises(FormatError, match="nobody has a box"):
            LABEL_STUDIO.write(path, exported, no_progress)
        return
    LABEL_STUDIO.write(path, exported, no_progress)
    back = import_label_studio(path, Filmed())
    assert (back.fps, back.frames, back.size_px) == (12.5, 41, SIZE)
    assert_same(back.columns, boxed, ())
    for name in BOX:  # a box between keyframes may be off by what nobody sees
        np.testing.assert_allclose(back.columns[name], boxed[name], rtol=1e-12, atol=0.0051)


def test_names_classes_and_ids_travel(tmp_path: Path) -> None:
    made = table([(0, 3), (0, 8), (1, 3)], [(1, 2, 3, 4)] * 3)
    labels = {
        3: TrackLabel("Zoë: Z", {"bag": "yes: red"}),
        8: TrackLabel(attributes={"class": "dog", "leash": "no"}),
    }
    exported = Exported.of_table(made, frames=2, size_px=SIZE, labels=labels)
    assert LABEL_STUDIO.write is not None
    LABEL_STUDIO.write(tmp_path / "t.json", exported, no_progress)
    back = import_label_studio(tmp_path / "t.json", Filmed())
    assert back.labels == labels
    assert sorted(set(back.columns["track"].tolist())) == [3, 8]


def test_a_region_holds_until_it_is_not_enabled_and_the_last_one_to_the_end(tmp_path: Path) -> None:
    first = region(key(1), key(3, x=20), key(4, False, x=30), key(8, False, x=50))
    last = region(key(11), name="b")
    assert lefts(imported(tmp_path, [task(first, last)])) == pytest.approx(
        {
            (0, 1): 64,
            (1, 1): 96,
            (2, 1): 128,
            (3, 1): 192,
            (7, 1): 320,
            (10, 2): 64,
            (11, 2): 64,
        }
    )


def test_the_recording_ends_what_is_held_beyond_it(tmp_path: Path) -> None:
    found = imported(tmp_path, [task(region(key(19), frames=400))])
    assert found.columns["frame"].tolist() == [18, 19]
    assert found.frames == 400


def test_of_several_annotations_the_newest_is_read_unless_one_is_ground_truth(
    tmp_path: Path,
) -> None:
    parts = [
        {"result": [region(key(1, False, x=10))], "updated_at": "2024-01-01"},
        {"result": [region(key(1, False, x=20))], "updated_at": "2024-01-03"},
        {"result": [region(key(1, False, x=30))], "updated_at": "2024-01-02"},
        {"result": [region(key(1, False, x=40))], "updated_at": "2024-09", "was_cancelled": True},
    ]
    document = {"annotations": parts, "data": {}}
    found = imported(tmp_path, [document])
    assert lefts(found) == {(0, 1): 128}
    assert "of 3 annotations" in found.notes[0]
    parts[0]["ground_truth"] = True
    assert lefts(imported(tmp_path, [document])) == {(0, 1): 64}


def test_drafts_are_passed_over_however_long_they_are(tmp_path: Path) -> None:
    draft = {"result": [region(*(key(at + 1, x=77) for at in range(50_000)))]}
    found = imported(tmp_path, [{**task(region(key(1, False))), "drafts": [draft]}])
    assert lefts(found) == {(0, 1): 64}


def test_predictions_are_read_where_nobody_annotated_and_are_a_tracker_s(tmp_path: Path) -> None:
    predicted = {"annotations": [], "predictions": [{"result": [region(key(1), score=0.25)]}]}
    found = imported(tmp_path, predicted)  # a task alone, without an array around it
    assert found.columns["source"][:2].tolist() == [0, 2]
    assert found.columns["confidence"][0] == 0.25


def test_a_region_that_is_told_by_two_results_is_one_track(tmp_path: Path) -> None:
    box = {**region(key(1, False)), "value": {"sequence": [key(1, False)]}}
    label = {"id": "a", "type": "labels", "value": {"labels": ["Dog"], "framesCount": 3}}
    found = imported(tmp_path, [task(box, label)])
    assert lefts(found) == {(0, 1): 64}
    assert found.labels == {1: TrackLabel(attributes={"class": "Dog"})}


def test_a_turned_box_becomes_the_upright_one_around_it(tmp_path: Path) -> None:
    turned = [key(1, True, rotation=170), key(3, False, rotation=-170)]
    found = imported(tmp_path, [task(region(*turned))])
    widths = found.columns["width"].tolist()
    # In between it is turned by 180 degrees: the shorter way round.
    assert widths[1] == pytest.approx(32)
    assert widths[::2] == pytest.approx([32 * 0.984808 + 240 * 0.173648] * 2, abs=1e-3)
    assert any("turned" in note for note in found.notes)


@pytest.mark.parametrize(
    ("keyframe", "reason"),
    [
        (7, "is no object"),
        (key(0), "its frame"),
        (key(1.5), "its frame"),
        (key("1"), "its frame"),
        (key(2, x=None), "five numbers"),
        (key(2, x=True), "five numbers"),
        (key(2, x=1e300), "five numbers"),
        (key(2, width=-1), "negative size"),
        (key(5), "stands there twice"),
    ],
)
def test_an_invalid_keyframe_is_told_with_its_place(
    tmp_path: Path, keyframe: Any, reason: str
) -> None:
    found = imported(tmp_path, [task(region(key(5, False), keyframe))])
    assert found.columns["frame"].tolist() == [4]
    (bad,) = found.bad_rows
    assert bad.place == "[0].annotations[0].result[0], sequence[1]"
    assert reason in bad.reason


@pytest.mark.parametrize(
    "other",
    [
        {"id": "b", "type": "choices", "value": {"choices": ["sunny"]}},
        region(name="b"),
        region(key(0), name="b"),
    ],
    ids=["no box", "no keyframes", "invalid keyframes"],
)
def test_a_region_without_keyframes_is_passed_over(tmp_path: Path, other: dict[str, Any]) -> None:
    for regions in ([other, region(key(2, False))], [region(key(2, False)), other]):
        assert lefts(imported(tmp_path, [task(*regions)])) == {(1, 1): 64}


def test_a_sequence_that_is_no_list_is_told(tmp_path: Path) -> None:
    wrong = {"id": "b", "type": "videorectangle", "value": {"sequence": {"frame": 1}}}
    found = imported(tmp_path, [task(region(key(2, False)), wrong)])
    assert lefts(found) == {(1, 1): 64}
    assert [bad.reason for bad in found.bad_rows] == ["its sequence is no list"]


def test_percent_without_the_size_of_the_picture_are_refused(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="import it with its recording"):
        imported(tmp_path, [task(region(key(1)))], Filmed())
    sized = region(key(1, False), original_width=1000, original_height=100)
    assert lefts(imported(tmp_path, [task(sized)], Filmed())) == {(0, 1): 100}


@pytest.mark.parametrize(
    ("document", "reason"),
    [
        ([task(region(key(1))), task(region(key(1)))], "tracks of 2 videos"),
        (
            [task(*(region(key(1), name=str(at), frames=9_000_000) for at in range(90)))],
            "check its frame numbers",
        ),
    ],
)
def test_what_is_no_one_video_is_refused(tmp_path: Path, document: Any, reason: str) -> None:
    with spent() as time, pytest.raises(FormatError, match=reason) as told:
        imported(tmp_path, document, Filmed(size_px=SIZE))
    assert "\n" not in str(told.value)
    assert time.paces < 80


def test_many_regions_with_few_far_keyframes_are_refused_before_the_file_is_read_through(
    tmp_path: Path,
) -> None:
    regions = [region(key(1), key(1200), name=f"track-{n}", frames=1200) for n in range(1, 20_001)]
    path = tmp_path / "t.json"
    path.write_text(json.dumps([task(*regions)]))
    parts: list[float] = []
    with pytest.raises(FormatError, match=f"more than {MOST_FILLED} boxes between them"):
        import_label_studio(
            path,
            Filmed(frames=1200, size_px=SIZE),
            lambda done, size: parts.append(done / size),
        )
    assert max(parts) < 0.5


def test_no_row_is_filled_beyond_the_recording(tmp_path: Path) -> None:
    found = imported(tmp_path, [task(region(key(19), key(9_000_000), frames=9_000_000))])
    assert found.columns["frame"].tolist() == [18, 19, 8_999_999]


@pytest.mark.parametrize("text", ["[" * 100_000, '[{"annotations": [{"result": [', '[{"a": 1} x'])
def test_what_is_no_such_json_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "t.json"
    path.write_text(text)
    with spent() as time, pytest.raises(FormatError, match=r"t\.json"):
        import_label_studio(path, FILMED)
    assert time.paces < 80


def test_a_track_of_many_keyframes_is_read_piece_by_piece(tmp_path: Path) -> None:
    many = 60_000  # more characters than one element may have
    found = imported(
        tmp_path,
        [task(region(*(key(at + 1) for at in range(many)), frames=many))],
        Filmed(size_px=SIZE),
    )
    assert len(found.columns["frame"]) == many
