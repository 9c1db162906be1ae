"""States of a change that were written or read a moment ago, by their text."""

from __future__ import annotations

import threading
from collections import OrderedDict

from tracking.editing.core.change import State

_MOST, _CHARACTERS = 8, 32_000_000
"""How many, and of how many characters in all: some 500,000 rows."""


class RecentStates:
    """A few states, so that an edit of a whole track is not unpacked again while it is made.

    Whoever is given one must not write into its arrays. Used from any thread.
    """

    def __init__(self) -> None:
        """None is known."""
        self._states: OrderedDict[str, State] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, text: str) -> State | None:
        """The state of a text, where it is known."""
        if len(text) > _CHARACTERS:
            return None
        with self._lock:
            state = self._states.get(text)
            if state is not None:
                self._states.move_to_end(text)
        return state

    def put(self, text: str, state: State) -> None:
        """Know the state a text stands for, and forget the one asked for longest ago."""
        if len(text) > _CHARACTERS:
            return
        for array in (state.stretches, *state.rows.values()):
            array.flags.writeable = False
        with self._lock:
            self._states[text] = state
            self._states.move_to_end(text)
            while len(self._states) > _MOST or sum(map(len, self._states)) > _CHARACTERS:
                self._states.popitem(last=False)
