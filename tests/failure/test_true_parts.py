"""Labels from rendered truth: on, off, or neither."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_up_parts import FPS, as_parts, box_of, walk

from tracking.failure import labels_from_truth, people_followed, samples_of
from tracking.tracks import PART_WORDS
from tracking.truth import read_true_parts

HEADER = "frame,id,part,left,top,width,height,visible_pixels\n"


def write_truth(path: Path, people: dict[int, np.ndarray], seen: int = 50) -> Path:
    lines = [
        f"{frame},{person},{name},{','.join(map(repr, box_of(states[frame, part])))},{seen}\n"
        for person, states in people.items()
        for frame in range(len(states))
        for part, name in enumerate(PART_WORDS)
    ]
    path.write_text(HEADER + "".join(lines), encoding="utf-8")
    return path


@pytest.fixture
def people() -> dict[int, np.ndarray]:
    random = np.random.default_rng(2)
    two = {3: walk(random, 60, loses=False)[0], 8: walk(random, 60, loses=False)[0]}
    two[8][..., 0] += 300
    return two


def joined_parts(people: dict[int, np.ndarray]) -> dict[str, np.ndarray]:
    """A run that follows them under ids of its own."""
    each = [as_parts(states, track) for track, states in enumerate(people.values(), start=1)]
    return {name: np.concatenate([one[name] for one in each]) for name in each[0]}


def test_rectangles_on_their_parts_are_labelled_on(tmp_path: Path, people) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    labels = labels_from_truth(truth, joined_parts(people), FPS)
    assert {label.track for label in labels} == {1, 2}
    assert all(label.on_part for label in labels)
    assert sorted({label.frame for label in labels}) == list(range(0, 60, 3))
    assert {(label.source, label.author) for label in labels} == {("truth", "truth")}


@pytest.mark.parametrize(
    ("share", "said"), [(0.2, {True}), (0.45, set()), (0.55, set()), (0.8, {False}), (5.0, {False})]
)
def test_a_rectangle_is_off_where_clearly_most_of_it_lies_outside(
    tmp_path: Path, people, share: float, said: set[bool]
) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts = joined_parts(people)
    moved = (parts["part"] == 1) & (parts["track"] == 1) & (parts["frame"] >= 30)
    parts["cx"][moved] += share * parts["width"][moved]
    labels = labels_from_truth(truth, parts, FPS)
    assert {
        label.on_part
        for label in labels
        if (label.track, label.part) == (1, 1) and label.frame >= 30
    } == said


def test_whoever_a_track_follows_first_is_meant_ever_after(tmp_path: Path, people) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts = joined_parts(people)
    late = (parts["frame"] >= 30) & (parts["part"] != 1)
    parts["track"][late] = 3 - parts["track"][late]
    labels = labels_from_truth(truth, parts, FPS)
    assert {label.on_part for label in labels if label.frame < 30 or label.part == 1} == {True}
    astray = [label for label in labels if label.frame >= 30 and label.part != 1]
    assert {label.on_part for label in astray} == {False}
    assert people_followed(truth, parts, FPS) == {1: 3, 2: 8}


def test_nothing_is_said_of_a_track_that_changed_hands(tmp_path: Path, people) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts = joined_parts(people)
    late = parts["frame"] >= 30
    parts["track"][late] = 3 - parts["track"][late]
    labels = labels_from_truth(truth, parts, FPS)
    assert {label.frame < 30 for label in labels} == {True}


def test_two_tracks_of_one_person_are_one_person(tmp_path: Path, people) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts = joined_parts(people)
    parts["track"][(parts["track"] == 2) & (parts["frame"] >= 20)] = 9
    who = people_followed(truth, parts, FPS)
    assert who == {1: 3, 2: 8, 9: 8}
    samples = samples_of(labels_from_truth(truth, parts, FPS), parts, FPS, "yard", who)
    by_track = dict(zip(samples.columns["track"].tolist(), samples.people().tolist(), strict=True))
    assert by_track[2] == by_track[9] != by_track[1]


def test_a_track_on_nobody_follows_nobody(tmp_path: Path, people) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts = joined_parts(people)
    parts["cy"][parts["track"] == 2] += 5000
    assert people_followed(truth, parts, FPS) == {1: 3}


def test_a_dot_inside_a_part_is_not_on_it(tmp_path: Path, people) -> None:
    truth = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts = joined_parts(people)
    dots = (parts["part"] == 2) & (parts["frame"] >= 30)
    for name in ("width", "height"):
        parts[name][dots] *= 0.1
    labels = labels_from_truth(truth, parts, FPS)
    assert not [label for label in labels if label.part == 2 and label.frame >= 30]


def test_hidden_and_occluded_parts_are_not_labelled(tmp_path: Path, people) -> None:
    parts = joined_parts(people)
    hidden = read_true_parts(write_truth(tmp_path / "t.csv", people, seen=0))
    assert labels_from_truth(hidden, parts, FPS) == []
    seen = read_true_parts(write_truth(tmp_path / "t.csv", people))
    parts["occluded"][(parts["track"] == 1) & (parts["part"] == 0)] = True
    assert {label.track for label in labels_from_truth(seen, parts, FPS)} == {2}
