"""Logs of edits as older programs kept them, brought up to date when they are read.

The only place where anything is told from the words of an edit.
"""

from __future__ import annotations

import re
from dataclasses import replace

from tracking.editing.core.scope import Scope
from tracking.editing.log.history import Entry

_FROM_HERE_ON = re.compile(r"\bfrom frame \d+ on\b")
"""What logs that keep no scope say of a swap from here on."""


def up_to_date(entry: Entry) -> Entry:
    """The entry with the scope of a swap from here on where the program that made it kept none."""
    if entry.scope is None and entry.kind == "swap" and _FROM_HERE_ON.search(entry.text):
        return replace(entry, scope=Scope(entry.frame))
    return entry
