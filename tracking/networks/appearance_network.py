"""An appearance network as trackers ask it: embeddings of people in the left picture."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.detections import DetectionSettings, place_of
from tracking.errors import FormatError
from tracking.networks.letterbox import Picture
from tracking.networks.model_file import Model, read_model
from tracking.networks.network_process import NetworkProcess
from tracking.people.appearance_source import Embeddings
from tracking.recording import Recording
from tracking.tracks import DetectionsInput
from tracking.translation import Message, count_msg, msg

APPEARANCE = "appearance"
"""The format of such a network among the inputs of a run."""
_LEAST_SHARE = 0.5
"""Of a box that has to be in the picture."""
_LEAST_PX = (4, 8)
"""Width and height of a crop: smaller ones show no clothes."""


class AppearanceNetwork:
    """Describes people in the left picture that was looked at last.

    Raises FormatError where the network cannot be run; it is to be closed.
    """

    def __init__(self, model: Model) -> None:
        self._model = model
        self._process = NetworkProcess(model)
        self._picture: Picture | None = None
        self._width = 0
        self._crops = 0

    def look(self, picture: Picture) -> None:
        """Take the left picture as recorded, (height, width, 3) BGR."""
        self._picture = picture

    def embed(self, box: NDArray[Any]) -> Embeddings:
        """See `Embed`. Raises FormatError where the network fails."""
        assert self._picture is not None, "a picture is looked at first"
        corners, usable = _crops_of(box, self._picture)
        crops = [self._picture[top:bottom, left:right] for left, top, right, bottom in corners]
        found = self._process.embed(crops) if crops else np.zeros((0, self._width), np.float32)
        if self._width and found.shape[1] != self._width:
            raise FormatError("{path}: its embeddings differ in length", path=self._model.path)
        self._width = found.shape[1]
        self._crops += len(crops)
        embeddings = np.full((len(box), self._width), np.nan, np.float32)
        embeddings[usable] = found
        return embeddings

    def close(self) -> None:
        """End the program that runs the network."""
        self._process.close()

    @property
    def inputs(self) -> tuple[DetectionsInput, ...]:
        """Which network it is, as a run keeps it; the number of crops so far."""
        return (self._model.as_input(APPEARANCE, self._crops),)

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should know of it."""
        return (
            msg(
                "{file} (appearance network {name}, {licence}): {crops} described",
                file=self._model.path.name,
                name=self._model.name,
                licence=self._model.licence,
                crops=count_msg(self._crops, "{n} crop", "{n} crops"),
            ),
        )


def appearance_network(
    recording: Recording, settings: DetectionSettings, beside: Model | None
) -> AppearanceNetwork | None:
    """The appearance network that settings name, or else the one beside the detecting network.

    Raises FormatError where it cannot be read or run, or is none.
    """
    model = beside
    if settings.appearance:
        model = read_model(place_of(recording, settings.appearance))
        model = model.appearance or model
        if not model.is_appearance:
            raise FormatError(
                '{path}: it is no appearance network; its TOML says kind = "appearance", or has a '
                "table of that name",
                path=model.path,
            )
    return None if model is None else AppearanceNetwork(model)


def _crops_of(
    box: NDArray[Any], picture: Picture
) -> tuple[list[tuple[int, int, int, int]], NDArray[np.bool_]]:
    """Left, top, right, bottom px of the boxes that show enough, and which these are."""
    height, width = picture.shape[:2]
    known = np.isfinite(box).all(axis=1)
    corners = np.where(known[:, None], box, 0.0)
    corners = np.concatenate((corners[:, :2], corners[:, :2] + corners[:, 2:]), axis=1)
    inside = np.clip(np.round(corners), 0, np.tile((width, height), 2)).astype(int)
    sides = inside[:, 2:] - inside[:, :2]
    area = np.maximum(np.prod(corners[:, 2:] - corners[:, :2], axis=1), 1e-9)
    usable = known & (sides >= _LEAST_PX).all(axis=1)
    usable &= np.prod(sides, axis=1) >= _LEAST_SHARE * area
    return [tuple(row) for row in inside[usable].tolist()], usable
