"""The settings of trackers that say how detections of another program are used."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from tracking.errors import SettingsError
from tracking.setting import setting

BESIDE: Final = "beside"
ONLY: Final = "only"
AUTO: Final = "auto"
_GROUP = "Detections of another program"


@dataclass(frozen=True, slots=True)
class DetectionSettings:
    """Whose boxes people are seen by; see the `help` of each field."""

    file: str = setting(
        "",
        "",
        None,
        "Boxes of another program: MOT text, COCO JSON or a folder of YOLO text, its path from "
        "the folder of the recording; empty: none",
        group=_GROUP,
        expert=True,
    )
    file_right: str = setting(
        "",
        "",
        None,
        "The same of the right camera; empty: none",
        group=_GROUP,
        expert=True,
    )
    model: str = setting(
        "",
        "",
        None,
        "A network that detects people in the images of all cameras, in place of a file: its TOML "
        "or the folder of it, its path from the folder of the recording; empty: none",
        group=_GROUP,
        expert=True,
    )
    appearance: str = setting(
        "",
        "",
        None,
        "A network that tells people apart by their appearance, beside colours and body height: its"
        " TOML or the folder of it, its path from the folder of the recording; empty: the one "
        "that the TOML of detections.model describes, if it does",
        group=_GROUP,
        expert=True,
    )
    use: str = setting(
        BESIDE,
        "",
        None,
        "What people are detected by; beside: by these boxes and by the foreground; only: by the "
        "boxes alone",
        group=_GROUP,
        expert=True,
    )
    min_score: str = setting(
        AUTO,
        "",
        None,
        "Smallest score of a box that is used, a number; auto: learnt from the scores of the file, "
        "or what the TOML of a network says",
        group=_GROUP,
        expert=True,
    )
    max_overlap: float = setting(
        0.65,
        "",
        (0.0, 1.0),
        "Overlap (intersection over union) of two boxes above which the one with the lower score "
        "is dropped; higher: people close together keep their boxes, but one person may have two",
        group=_GROUP,
        expert=True,
    )

    def __post_init__(self) -> None:
        """Check the words, before any work; raises `SettingsError`."""
        if self.use not in (BESIDE, ONLY):
            raise SettingsError(
                "setting detections.use={use}: must be {beside} or {only}",
                use=self.use,
                beside=BESIDE,
                only=ONLY,
            )
        if self.model and (self.file or self.file_right):
            raise SettingsError(
                "setting detections.model={model}: people are detected by a network or by a file "
                "of detections; give one of them",
                model=self.model,
            )
        if self.use == ONLY and not (self.file or self.model):
            raise SettingsError(
                "setting detections.use={use}: there are no detections; give a file of them in "
                "detections.file, or a network in detections.model",
                use=self.use,
            )
        if self.file_right and not self.file:
            raise SettingsError(
                "setting detections.file_right={file_right}: detections of the right camera alone "
                "are not enough; give those of the left one in detections.file",
                file_right=self.file_right,
            )
        _score_in(self.min_score)

    @property
    def least_score(self) -> float | None:
        """The smallest score of a box that is used; None: to be learnt."""
        return _score_in(self.min_score)


def _score_in(text: str) -> float | None:
    if text == AUTO:
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise SettingsError(
            "setting detections.min_score={text}: must be a number or {auto}", text=text, auto=AUTO
        )
    return value
