"""Who is selected: one selection for all views."""

from __future__ import annotations

from collections.abc import Sequence


class Selection:
    """The selected track; 0 is nobody."""

    def __init__(self) -> None:
        self.track = 0

    def __bool__(self) -> bool:
        """Whether anybody is selected."""
        return self.track > 0

    def choose(self, track: int) -> bool:
        """Select a track, or nobody (0); True where that is another than before."""
        changed = track != self.track
        self.track = track
        return changed

    def cycle(self, tracks: Sequence[int], step: int = 1, skip: int = 0) -> int:
        """The next (1) or previous (-1) of the tracks after the selected one, wrapping around.

        `skip` is never given: the person an edit already holds. 0 where nobody is left.
        """
        choices = sorted(set(tracks) - {skip})
        if not choices:
            return 0
        if self.track in choices:
            return choices[(choices.index(self.track) + step) % len(choices)]
        later = [track for track in choices if track > self.track]
        if step > 0:
            return later[0] if later else choices[0]
        earlier = [track for track in choices if track < self.track]
        return earlier[-1] if earlier else choices[-1]
