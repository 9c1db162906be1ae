from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from tracking.session.image_file import ImageFile
from tracking.session.table_writer import Packer

KINDS = st.sampled_from([np.uint8, np.int32, np.float32, np.float64]).map(np.dtype)


def written(path: Path, values: np.ndarray, *, noisy: bool) -> int:
    """Bytes that a column takes, which reads back by the library alone."""
    image = ImageFile(path)
    with h5py.File(image, "w") as file:
        Packer(image).column(file, "x", values, values.dtype, noisy=noisy)
    image.finish()
    image.close()
    with h5py.File(path) as file:
        assert file["x"][()].tobytes() == values.tobytes()
        return file["x"].id.get_storage_size()


@settings(deadline=None, max_examples=40)
@given(KINDS.flatmap(lambda kind: arrays.arrays(kind, st.integers(0, 300))), st.booleans())
def test_any_column_reads_back_by_the_library(
    tmp_path_factory: pytest.TempPathFactory, values: np.ndarray, noisy: bool
):
    written(tmp_path_factory.mktemp("packed") / "s.h5", values, noisy=noisy)


@pytest.mark.parametrize("rows", [65_535, 65_536, 150_000])
def test_ids_of_particles_take_hardly_any_room(tmp_path: Path, rows: int):
    people = np.repeat(np.arange(1, rows // 500 + 2, dtype=np.int32), 500)[:rows]
    assert written(tmp_path / "s.h5", people, noisy=True) < 0.02 * rows


def test_places_in_steps_take_half_the_room_of_those_as_they_were_drawn(tmp_path: Path):
    places = np.random.default_rng(3105).normal(4, 0.2, 1 << 16).astype(np.float32)
    drawn = written(tmp_path / "drawn.h5", places, noisy=False)
    steps = np.rint(places * 1024) / np.float32(1024)
    assert written(tmp_path / "steps.h5", steps, noisy=True) < 0.51 * drawn
