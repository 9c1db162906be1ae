"""What goes through the pipe to a program of its own that reads what is not trusted, and back.

Each message is a line of JSON and then bytes.
"""

from __future__ import annotations

import json
from typing import IO, Any

_LONGEST_LINE = 1 << 20


def send(stream: IO[bytes], head: dict[str, Any], *parts: bytes | memoryview) -> None:
    """Write a message. Raises OSError where nobody reads any more."""
    stream.write(json.dumps(head).encode() + b"\n")
    for part in parts:
        stream.write(part)
    stream.flush()


def receive_head(stream: IO[bytes]) -> dict[str, Any] | None:
    """The line of JSON of a message; None where there is no other. Raises ValueError."""
    line = stream.readline(_LONGEST_LINE)
    if not line:
        return None
    head = json.loads(line)
    if not line.endswith(b"\n") or not isinstance(head, dict):
        raise ValueError("no line of a message")
    return head


def receive_bytes(stream: IO[bytes], count: int) -> bytes:
    """The bytes after it. Raises ValueError where there are fewer."""
    held = stream.read(count)
    if len(held) != count:
        raise ValueError("a message that was cut short")
    return held
