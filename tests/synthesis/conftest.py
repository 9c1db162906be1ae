"""Small scenes, rendered once for all tests of the room."""

from __future__ import annotations

import pytest

from tracking.synthesis import SCENES, Scene

SMALL = (320, 240)


@pytest.fixture(scope="session")
def plaza() -> Scene:
    """Eight people on the plaza for twelve seconds."""
    return Scene(SCENES["plaza"], people=8, seed=3, seconds=12.0, size=SMALL)


@pytest.fixture(scope="session")
def pillars() -> Scene:
    """Eight people among pillars for twelve seconds."""
    return Scene(SCENES["pillars"], people=8, seed=5, seconds=12.0, size=SMALL)
