"""What has to be known of a network to run it: its input, its outputs, its classes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final, Literal

OPENCV: Final = "opencv"
ONNXRUNTIME: Final = "onnxruntime"
LETTERBOX: Final = "letterbox"
STRETCH: Final = "stretch"
CENTRE: Final = "centre"
CORNER: Final = "corner"

EMBEDDING: Final = "embedding"
"""The decoder of appearance networks, which find nobody but describe who is in a crop."""

Decoder = Literal["yolox", "yolo", "detr", "boxes", "embedding"]


@dataclass(frozen=True, slots=True)
class NetworkSpec:
    """A network as its TOML describes it; docs/networks.md has the words.

    Attributes:
        decoder: how its outputs become boxes.
        size_px: (width, height) of its input.
        class_count: how many classes it knows. people: the numbers of those that are people.
        engine: what runs it.
        fit: whether a picture keeps its proportions in the input. align: where it lies then.
        pad: value of the pixels beside it, 0 to 255.
        channels: their order. divide_by, mean, std: a pixel becomes (pixel / divide_by - mean) /
            std, by channel in that order.
        min_score: of boxes that are used, unless settings say another.
        head: of decoder yolo: "v5", "v8" or "v10"; "": told by the output's shape.
        decoded: of decoder yolox: whether its boxes are in px already.
        activation: of decoder detr: "softmax", "sigmoid" or "none"; "": told by the shape.
        sides, unit: of decoder boxes: "corners", "centre" or "sides", in "pixels" or "shares".
        boxes_output, scores_output, labels_output: names; "": told by their shapes.
        embedding_output: its name, of an appearance network; "": the only one that fits.
        size_input: an input that is given the size of the picture; "": there is none.
    """

    decoder: Decoder
    size_px: tuple[int, int]
    class_count: int
    people: tuple[int, ...]
    engine: str = OPENCV
    fit: str = LETTERBOX
    align: str = CENTRE
    pad: float = 114.0
    channels: str = "rgb"
    divide_by: float = 255.0
    mean: tuple[float, float, float] = (0.0, 0.0, 0.0)
    std: tuple[float, float, float] = (1.0, 1.0, 1.0)
    min_score: float = 0.3
    head: str = ""
    decoded: bool = False
    activation: str = ""
    sides: str = "corners"
    unit: str = "pixels"
    boxes_output: str = ""
    scores_output: str = ""
    labels_output: str = ""
    embedding_output: str = ""
    size_input: str = ""

    def as_data(self) -> dict[str, Any]:
        """The same as JSON holds it."""
        return asdict(self)

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> NetworkSpec:
        """The inverse of `as_data`."""
        values: dict[str, Any] = {
            k: tuple(v) if isinstance(v, list) else v for k, v in data.items()
        }
        return cls(**values)
