"""Which failure detector is used: the built-in one, or one from a file."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from app.core.i18n import tr
from tracking.failure import Detector, built_in_detector, load_detector
from tracking.trackers import occluders_as_setting, settings_fields, settings_from
from tracking.tracks import Occluder

KEPT = re.compile(r"trained-[0-9a-f]+\.h5")
"""Files of detectors that were trained in the window and given no place by the user."""
DETECTOR, OCCLUDERS = "detector", "occluders"
"""Settings of trackers that follow parts; the window fills them in by itself."""


@dataclass(frozen=True, slots=True)
class DetectorChoice:
    """The detector that is used.

    Attributes:
        path: of its file; "" for the built-in one.
    """

    path: str = ""

    @property
    def name(self) -> str:
        """For people: of one that was trained and kept here, when; else of its file."""
        if not self.path:
            return tr("built-in detector")
        path = Path(self.path)
        if KEPT.fullmatch(path.name) and path.is_file():
            made = datetime.fromtimestamp(path.stat().st_mtime)
            return tr("detector trained {when}", when=f"{made:%Y-%m-%d %H:%M}")
        return path.name

    @property
    def name_in_text(self) -> str:
        """As a score is said to be its."""
        named_by_file = self.name == Path(self.path).name
        return self.name if named_by_file else tr("the {detector}", detector=self.name)

    def load(self) -> Detector:
        """The detector; reading a file takes a moment.

        Raises FormatError where it is missing or no detector.
        """
        return load_detector(Path(self.path)) if self.path else built_in_detector()

    def settings(self, settings_type: type, occluders: tuple[Occluder, ...]) -> Mapping[str, Any]:
        """What the window fills into the settings of a tracker; nothing where it has no use."""
        known = {field.name for field in settings_fields(settings_type)}
        values = {DETECTOR: self.path, OCCLUDERS: occluders_as_setting(occluders)}
        return {name: value for name, value in values.items() if name in known and value}


def restore_choice(path: str) -> DetectorChoice:
    """The choice that was remembered; the built-in one where its file is gone."""
    return DetectorChoice(path if path and Path(path).is_file() else "")


@dataclass(frozen=True, slots=True)
class PartSettings:
    """What trackers that follow parts are told beside their own settings.

    Attributes:
        choice: the detector. occluders: what people drew in the picture.
    """

    choice: DetectorChoice = DetectorChoice()
    occluders: tuple[Occluder, ...] = ()

    def filled(self, settings_type: type, values: Mapping[str, Any] | None = None) -> Any:
        """The settings of a tracker with these filled in.

        Raises SettingsError for a value that is none.
        """
        own = self.choice.settings(settings_type, self.occluders)
        return settings_from(settings_type, {**(values or {}), **own})
