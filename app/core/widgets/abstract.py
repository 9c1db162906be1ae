"""Qt classes of which only kinds are made, each with what its kind defines."""

from __future__ import annotations

from abc import ABCMeta
from typing import Any

from PySide6.QtCore import QObject


class AbstractQt(ABCMeta, type(QObject)):  # type: ignore[misc]  # Qt's metaclass bears no name
    """Metaclass that knows Qt's classes and abstract methods: to forget one is an error at once.

    Python's own check is made where plain objects are, which Qt's are not.
    """

    def __call__(cls, *args: Any, **named: Any) -> Any:
        """Make one; TypeError where a method is still abstract."""
        if cls.__abstractmethods__:
            missing = ", ".join(sorted(cls.__abstractmethods__))
            raise TypeError(f"{cls.__name__} does not define {missing}")
        return super().__call__(*args, **named)
