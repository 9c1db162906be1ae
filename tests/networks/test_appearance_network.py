"""Appearance networks: crops in, embeddings of unit length out, in the limited child process."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from small_networks import (
    SIZE,
    bright_rectangles,
    damaged,
    mean_colours,
    saying,
    written,
    written_appearance,
)

from tracking.errors import FormatError
from tracking.networks.appearance_network import AppearanceNetwork
from tracking.networks.model_file import is_appearance, read_model
from tracking.networks.network_process import NetworkProcess
from tracking.trackers.shared.known_embeddings import KnownEmbeddings

RED, GREEN, BLUE = (30, 30, 220), (40, 200, 40), (220, 40, 30)


@pytest.fixture
def networks() -> Iterator[list[AppearanceNetwork]]:
    """Those to be closed."""
    held: list[AppearanceNetwork] = []
    yield held
    for network in held:
        network.close()


def street() -> np.ndarray:
    """Three people of 20 x 60 px on grey: red, green, red."""
    drawn = np.full((120, 200, 3), 128, np.uint8)
    for left, colour in ((10, RED), (80, GREEN), (150, RED)):
        drawn[30:90, left : left + 20] = colour
    return drawn


BOXES = np.array([[10, 30, 20, 60], [80, 30, 20, 60], [150, 30, 20, 60]], float)


@pytest.mark.parametrize("engine", ["opencv", "onnxruntime"])
@pytest.mark.parametrize("batch", ["n", 1])
def test_people_dressed_alike_have_embeddings_alike(
    tmp_path: Path, networks: list[AppearanceNetwork], engine: str, batch: int | str
) -> None:
    path = written_appearance(tmp_path, mean_colours(batch=batch), engine=engine)
    network = AppearanceNetwork(read_model(path))
    networks.append(network)
    if engine == "onnxruntime":  # OpenCV's runs any number of crops where layers allow it
        assert network._process.batches == (batch == "n")
    network.look(street())
    found = network.embed(BOXES)
    assert found.shape == (3, 6)
    assert np.linalg.norm(found, axis=1) == pytest.approx(np.ones(3), abs=1e-5)
    assert found[0] @ found[2] > 0.999
    assert found[0] @ found[1] < 0.5
    assert network.inputs[0].count == 3


def test_boxes_that_show_too_little_have_no_embedding(
    tmp_path: Path, networks: list[AppearanceNetwork]
) -> None:
    networks.append(AppearanceNetwork(read_model(written_appearance(tmp_path, mean_colours()))))
    networks[0].look(street())
    boxes = np.array([BOXES[0], [-15, 30, 20, 60], [10, 30, 2, 60], [np.nan] * 4])
    found = networks[0].embed(boxes)
    assert np.isfinite(found).all(axis=1).tolist() == [True, False, False, False]
    assert networks[0].embed(np.zeros((0, 4))).shape == (0, 6)


def test_a_table_in_the_toml_of_a_detecting_network_names_one_beside_it(tmp_path: Path) -> None:
    path = written(tmp_path, bright_rectangles(10, 20), decoder="yolo", classes=["person"])
    (tmp_path / "who.onnx").write_bytes(mean_colours())
    lines = ("[appearance]", 'file = "who.onnx"', 'licence = "MIT"', f"size = [{SIZE}, {SIZE}]")
    path.write_text(path.read_text() + "\n".join(lines) + "\n")
    read = read_model(path)
    assert read.appearance is not None
    assert read.appearance.is_appearance
    assert read.appearance.spec.fit == "stretch"
    assert not read.is_appearance
    assert not is_appearance(path)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ({"decoder": "yolo"}, "decoder is no key"),
        ({"min_score": 0.3}, "min_score is no key"),
        ({"kind": "pose"}, "kind must be appearance"),
        ({"size": [4, 64]}, "size must be"),
        ({"outputs": {"boxes": "x"}}, "outputs must be a table of embedding"),
    ],
)
def test_a_toml_that_is_wrong_is_refused(
    tmp_path: Path, keys: dict[str, object], said: str
) -> None:
    with pytest.raises(FormatError, match=said):
        read_model(written_appearance(tmp_path, mean_colours(), **keys))


@pytest.mark.parametrize(
    ("outputs", "said"),
    [
        ({"a": np.zeros(8, np.float32)}, "no direction"),
        ({"a": np.full(8, np.nan, np.float32)}, "no direction"),
        ({"a": np.ones(8, np.float32), "b": np.ones(9, np.float32)}, "2 of its outputs"),
        ({"a": np.ones((8, 8), np.float32)}, "0 of its outputs"),
        ({"a": np.ones(1, np.float32)}, "0 of its outputs"),
        ({"a": np.ones(8, np.int64)}, "0 of its outputs"),
    ],
)
def test_outputs_that_are_no_embedding_are_refused_in_one_line(
    tmp_path: Path, outputs: dict[str, np.ndarray], said: str
) -> None:
    path = written_appearance(tmp_path, saying(outputs))
    with pytest.raises(FormatError, match=said) as refused:
        NetworkProcess(read_model(path))
    assert "\n" not in str(refused.value)


def test_tracks_are_told_apart_by_what_was_learnt_of_them() -> None:
    rng = np.random.default_rng(0)
    people = rng.normal(size=(4, 32))

    def looks() -> np.ndarray:
        seen = people + rng.normal(scale=0.4, size=people.shape)
        return (seen / np.linalg.norm(seen, axis=1, keepdims=True)).astype(np.float32)

    known, ids = KnownEmbeddings(), np.arange(1, 5)
    assert known.log_likelihood_ratio(ids, looks()) == pytest.approx(np.zeros((4, 4)))
    for _ in range(20):
        known.learn(ids, looks(), np.ones(4, bool))
    ratio = known.log_likelihood_ratio(ids, looks())
    same = np.eye(4, dtype=bool)
    assert ratio[same].min() > 1.0
    assert ratio[~same].max() < -1.0
    assert np.abs(ratio).max() < 4.0
    unknown = known.log_likelihood_ratio(np.array([0, 9]), looks())
    assert unknown == pytest.approx(np.zeros((2, 4)))


def test_a_network_that_tells_nobody_apart_says_nothing() -> None:
    rng = np.random.default_rng(0)
    known, ids = KnownEmbeddings(), np.arange(1, 5)

    def looks() -> np.ndarray:
        seen = rng.normal(size=(4, 32))
        return (seen / np.linalg.norm(seen, axis=1, keepdims=True)).astype(np.float32)

    for _ in range(300):
        known.learn(ids, looks(), np.ones(4, bool))
    assert np.abs(known.log_likelihood_ratio(ids, looks())).max() < 0.5


def test_nothing_is_learnt_or_said_before_the_first_usable_crop(
    tmp_path: Path, networks: list[AppearanceNetwork]
) -> None:
    networks.append(AppearanceNetwork(read_model(written_appearance(tmp_path, mean_colours()))))
    networks[0].look(street())
    known, ids, clear = KnownEmbeddings(), np.arange(1, 4), np.ones(3, bool)
    for boxes in (np.full((3, 4), np.nan), BOXES):
        found = networks[0].embed(boxes)
        assert known.log_likelihood_ratio(ids, found) == pytest.approx(np.zeros((3, 3)))
        known.learn(ids, found, clear)
    assert known.log_likelihood_ratio(ids, found)[0, 0] > 1.0


@pytest.mark.slow
def test_damaged_appearance_networks_end_in_one_line_or_a_sound_answer(tmp_path: Path) -> None:
    for number in range(9, 209, 10):
        assert damaged(tmp_path, number) in ("refused", "answered")
