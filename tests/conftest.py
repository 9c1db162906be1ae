"""Fixtures shared by all rooms' tests."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

from tests.pseudo import Pseudo
from tracking.translation import use_catalogue

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
os.environ["LANGUAGE"] = "en"  # of whoever runs the tests

# The same examples at every run, so that what passes here passes elsewhere;
# HYPOTHESIS_PROFILE=search looks for new ones. No deadlines: machines are shared.
settings.register_profile("steady", derandomize=True, deadline=None)
settings.register_profile("search", deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "steady"))


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """The folder of test recordings that stands beside the checkout; skips where it is missing."""
    named = os.environ.get("TRACKWRIGHT_DATA")
    folder = Path(named) if named else Path(__file__).parents[2] / "shared" / "data"
    if not folder.is_dir():
        pytest.skip(f"no test recordings at {folder} (TRACKWRIGHT_DATA names another place)")
    return folder


@pytest.fixture(scope="session", autouse=True)
def own_key(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Sessions are sealed with a key of the tests' own, not with that of whoever runs them."""
    folder = tmp_path_factory.mktemp("own")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("tracking.session.seal.user_data_path", lambda *_, **__: folder)
        yield


@pytest.fixture
def pseudo() -> Iterator[None]:
    """Texts are in a made-up language."""
    use_catalogue(Pseudo())
    yield
    use_catalogue(None)
