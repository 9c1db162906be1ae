"""Part of a session file copied into a new one, packed pieces as they are."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import h5py

from tracking.session.hdf5 import open_readonly
from tracking.session.image_file import ImageFile

_SMALL_BYTES = 1 << 16


def copy_group(path: Path, name: str, image: ImageFile, target: h5py.Group) -> None:
    """Copy all of a group; long columns go piece by piece, the rest the library copies.

    Raises SessionError where the file that is read is damaged, OSError where the disk of the new
    one refuses: what is read and what is written fail apart from each other.
    """
    long = []
    with open_readonly(path) as file:
        source = file[name]
        _copy_attributes(source, target)
        for key, node in source.items():
            if isinstance(node, h5py.Group):
                target.create_group(key)
            elif _is_long(node):
                long.append(key)
            else:
                file.copy(node, target, key)
        columns = {key: _alike(source[key], target, key) for key in long}
        groups = [key for key, node in source.items() if isinstance(node, h5py.Group)]
    for key, column in columns.items():
        for start, piece in _pieces(path, f"{name}/{key}"):
            image.put(column, start, piece)
    for key in groups:
        copy_group(path, f"{name}/{key}", image, target[key])


def _is_long(dataset: h5py.Dataset) -> bool:
    """Whether all pieces of a column are there to be copied, and it is worth while."""
    if dataset.chunks is None or dataset.ndim != 1:
        return False
    pieces = -(-len(dataset) // dataset.chunks[0])
    stored: int = dataset.id.get_storage_size()
    return stored > _SMALL_BYTES and dataset.id.get_num_chunks() == pieces


def _alike(source: h5py.Dataset, target: h5py.Group, name: str) -> h5py.Dataset:
    """An empty column of the same type, length and packing."""
    space, how = source.id.get_space(), source.id.get_create_plist()
    made = h5py.h5d.create(target.id, name.encode(), source.id.get_type(), space, how)
    column = h5py.Dataset(made)
    _copy_attributes(source, column)
    return column


def _copy_attributes(source: h5py.HLObject, target: h5py.HLObject) -> None:
    for name, value in source.attrs.items():
        target.attrs.create(name, value, dtype=source.attrs.get_id(name).dtype)


def _pieces(path: Path, name: str) -> Iterator[tuple[int, bytes]]:
    with open_readonly(path) as file:
        dataset = file[name]
        for start in range(0, len(dataset), dataset.chunks[0]):
            _, piece = dataset.id.read_direct_chunk((start,))
            yield start, piece
