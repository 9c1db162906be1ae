"""What is said of tracks comes back from files of other tools, or is told not to."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from made_tracks import table

from tracking.formats import FORMATS, Exported, Filmed, TrackFormat, losses, no_progress
from tracking.tracks import TrackLabel

KINDS = [FORMATS[name] for name in ("viame", "label-studio", "x-anylabeling", "cvat", "coco")]
by_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)

_texts = st.text(st.sampled_from("a_:%20235A 'n=;()\"\n\t,<é\u200b"), max_size=6)
_keys = st.one_of(_texts, st.sampled_from(["name", "name_", "track_id", "class", "class "]))
_labels = st.builds(TrackLabel, _texts, st.dictionaries(_keys, _texts, max_size=4))


def exported(label: TrackLabel) -> Exported:
    made = table([(0, 7), (1, 7)], [(1, 2, 3, 4)] * 2)
    return Exported.of_table(made, size_px=(640, 480), labels={7: label})


def back(kind: TrackFormat, path: Path, label: TrackLabel) -> TrackLabel:
    assert kind.write is not None
    assert kind.read is not None
    kind.write(path, exported(label), no_progress)
    return kind.read(path, Filmed()).labels.get(7, TrackLabel())


def told(kind: TrackFormat, path: Path, label: TrackLabel) -> list[str]:
    return [note for note in losses(kind, exported(label), path) if "comes back" in note]


@by_kind
@pytest.mark.parametrize(
    "label",
    [
        TrackLabel("Ada", {"name": "the other", "name_": "third", "track_id": "5"}),
        TrackLabel("", {"name": "nobody's"}),
        TrackLabel("A", {"a b": "1", "a_b": "2", "a%20b": "3", "50%": "4"}),
        TrackLabel("Ada", {"a: b": "c: d", "e:": "f"}),
        TrackLabel("A" * 200, {"k" * 100: "v" * 2000, "class": "c" * 200}),
        TrackLabel("Ada", {f"key {number}": "yes" for number in range(64)}),
    ],
    ids=["name", "name alone", "blanks", "colons", "long", "many"],
)
def test_a_label_comes_back_as_it_is(tmp_path: Path, kind: TrackFormat, label: TrackLabel) -> None:
    assert back(kind, tmp_path / "t", label) == label
    assert not told(kind, tmp_path / "t", label)


@by_kind
@pytest.mark.parametrize(
    ("label", "what"),
    [
        (TrackLabel("Ada", {"class": "Pedestrian"}), "the attribute 'class' of track 7"),
        (TrackLabel("two\nlines"), "the name of track 7"),
        (TrackLabel("Ada", {"bag": ""}), "the attribute 'bag' of track 7"),
        (TrackLabel("Ada", {"long": "v" * 2001}), "the attribute 'long' of track 7"),
    ],
)
def test_what_comes_back_otherwise_is_told(
    tmp_path: Path, kind: TrackFormat, label: TrackLabel, what: str
) -> None:
    assert back(kind, tmp_path / "t", label) != label
    (note,) = told(kind, tmp_path / "t", label)
    assert note.startswith(what)


def test_several_changed_labels_are_one_note(tmp_path: Path) -> None:
    changed = dict.fromkeys((3, 5, 9), TrackLabel(attributes={"class": "human"}))
    made = table([(0, track) for track in changed], [(1, 2, 3, 4)] * 3)
    (note,) = losses(FORMATS["coco"], Exported.of_table(made, labels=changed), tmp_path / "t")
    assert note.endswith("of track 3 comes back changed or not at all, as do those of 2 others")


def test_what_has_no_room_in_a_line_of_viame_is_told_and_the_file_is_read(tmp_path: Path) -> None:
    label = TrackLabel("Ada", {f"key{number:02d}": "\u5165" * 2000 for number in range(20)})
    kept = back(FORMATS["viame"], tmp_path / "t", label)
    assert list(kept.attributes) == list(label.attributes)[:8]
    assert told(FORMATS["viame"], tmp_path / "t", label)[0].startswith("the attribute 'key08'")


@by_kind
@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=60
)
@given(_labels)
def test_a_label_comes_back_or_is_told(
    tmp_path_factory: pytest.TempPathFactory, kind: TrackFormat, label: TrackLabel
) -> None:
    path = tmp_path_factory.mktemp("label") / "t"
    assert bool(told(kind, path, label)) == (back(kind, path, label) != label)
