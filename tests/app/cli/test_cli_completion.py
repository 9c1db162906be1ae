"""What shells propose, by the protocols of their completion scripts."""

from __future__ import annotations

import pytest
from command_line import Trackwright

from tracking.formats import FORMATS
from tracking.trackers import TRACKERS

READ = {each.name for each in FORMATS.values() if each.read is not None}
WRITTEN = {each.name for each in FORMATS.values() if each.write is not None}


@pytest.fixture(params=["bash", "zsh", "fish"])
def proposed(
    request: pytest.FixtureRequest, trackwright: Trackwright, monkeypatch: pytest.MonkeyPatch
):
    """Gives what the shell is told for the last, unfinished word of a line."""

    def asked(words: str) -> str:
        line = f"trackwright {words}"
        monkeypatch.setenv("_TRACKWRIGHT_COMPLETE", f"complete_{request.param}")
        monkeypatch.setenv("COMP_WORDS", line)
        monkeypatch.setenv("COMP_CWORD", str(len(line.split(" ")) - 1))
        monkeypatch.setenv("_TYPER_COMPLETE_ARGS", line)
        monkeypatch.setenv("_TYPER_COMPLETE_FISH_ACTION", "get-args")
        return trackwright()[1]

    return asked


def test_names_of_trackers_are_proposed(proposed) -> None:
    found = proposed("track lobby --tracker s")
    assert [name for name in TRACKERS if name in found] == [
        name for name in TRACKERS if name.startswith("s")
    ]
    assert "three-part" in proposed("trackers three")


def test_settings_of_the_tracker_that_was_typed_are_proposed(proposed) -> None:
    found = proposed("track lobby --tracker spheroid --set smo")
    assert "smooth=" in found
    growth = "particle_growth="
    assert growth not in proposed("track lobby --tracker flow --set particle_g")
    found = proposed("track lobby --tracker three-part --set particle_g")
    assert growth in found
    assert len(found.splitlines()) == 1


def test_formats_and_commands_are_proposed(proposed) -> None:
    export, imported = (proposed(f"{command} x --format ") for command in ("export", "import"))
    assert all(name in export for name in (*WRITTEN, "labels", "samples"))
    assert all(name in imported for name in READ)
    assert "import-labels" in proposed("imp")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_of_every_shell_is_shown(
    trackwright: Trackwright, monkeypatch: pytest.MonkeyPatch, shell: str
) -> None:
    monkeypatch.setattr("shellingham.detect_shell", lambda *_: (shell, f"/bin/{shell}"))
    status, printed, _ = trackwright("--show-completion")
    assert status == 0
    assert "_TRACKWRIGHT_COMPLETE=complete_" in printed
