"""All features that the window loops over: every folder of `app.features` that declares one."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules
from typing import Final

import app.features as folder
from app.core.feature import Feature


def _declared() -> Iterator[Feature]:
    """In the order of their folders' names, which is the order of menus and of F6."""
    for module in sorted(
        iter_modules(folder.__path__, f"{folder.__name__}."), key=lambda m: m.name
    ):
        name = f"{module.name}.feature"
        if module.ispkg and find_spec(name) is not None:
            yield import_module(name).FEATURE


FEATURES: Final = tuple(_declared())
