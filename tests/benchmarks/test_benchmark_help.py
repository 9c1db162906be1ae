"""Benchmarks that are run by hand tell what they are for."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.benchmarks.parts import detector_speed
from tests.benchmarks.stereo import overview


@pytest.mark.parametrize(
    ("main", "told"),
    [
        (detector_speed.main, "judges 15 people"),
        (overview.main, "between two comments of docs/results.md"),
    ],
)
def test_help_is_the_modules_description_and_nothing_is_done(
    main: Callable[[], None],
    told: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("sys.argv", ["benchmark", "--help"])
    with pytest.raises(SystemExit) as left:
        main()
    assert left.value.code == 0
    assert told in capsys.readouterr().out
