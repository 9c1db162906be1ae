"""Where this user had recordings last: the user's own knowledge, not a session file's word."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Mapping
from pathlib import Path

from tracking.atomic_output import replace_with
from tracking.errors import OutputError, SessionError
from tracking.owned_files import read_file
from tracking.session.reference import RecordingReference

_MOST = 2000
_LARGEST_FILE = 4 << 20


class KnownRecordings:
    """A small file in the user's own folder: fingerprint of a recording -> where it stood.

    It only saves the user a question. A file that is damaged or cannot be written is as good as
    none, and nobody is bothered with it.
    """

    def __init__(self, folder: Path) -> None:
        """The folder is the program's own, e.g. `platformdirs.user_data_path("trackwright")`."""
        self._file = folder / "recordings.json"

    def find(self, reference: RecordingReference) -> Path | None:
        """Where the recording stood when it was last used, or None; it may have moved since."""
        place = self._read().get(reference.key)
        return None if place is None else Path(place)

    def remember(self, reference: RecordingReference, place: Path) -> None:
        """Note where the recording stands."""
        self.remember_all({reference.key: place})

    def remember_all(self, found: Mapping[str, Path]) -> None:
        """Note where recordings stand, by the keys of their references."""
        if not found:
            return
        places = {key: place for key, place in self._read().items() if key not in found}
        places |= {key: str(place.resolve()) for key, place in found.items()}
        text = json.dumps(dict(list(places.items())[-_MOST:]), indent=1)
        with contextlib.suppress(OSError, OutputError):
            self._file.parent.mkdir(parents=True, exist_ok=True)
            replace_with(self._file, text.encode())

    def _read(self) -> Mapping[str, str]:
        try:
            places = json.loads(read_file(self._file, _LARGEST_FILE))
        except (OSError, SessionError, ValueError, RecursionError):
            return {}
        if not isinstance(places, dict):
            return {}
        return {str(key): place for key, place in places.items() if isinstance(place, str)}
