"""Help: grouped options, whole sentences, in the user's language."""

import re

from typer.main import get_command

from app.cli.commands.program import program
from tests.pseudo import TRANSLATED


def test_options_stand_by_their_groups(trackwright):
    page = trackwright("track", "--help")[1]
    again, _, bare = page.partition("For input without recording.toml:")
    assert "--accept" in again.partition("Again, after corrections:")[2]
    assert "--calibration" in bare


def test_each_command_has_its_whole_sentence(trackwright):
    page = " ".join(trackwright("--help")[1].split())
    assert "..." not in page.partition("Commands:")[2]
    assert "Import tracks of other programs into a session, with a report of invalid rows." in page


def test_every_help_is_translated(pseudo, trackwright):
    commands = get_command(program).commands
    for name, command in commands.items():
        page = " ".join(trackwright(name, "--help")[1].split())
        assert f"{TRANSLATED}Options⟧" in page
        helps = [" ".join(one.help.split()) for one in command.params if getattr(one, "help", "")]
        plain, *said = (re.sub(r"-\s+", "-", text) for text in (page, *helps))
        assert [one for one in said if f"{TRANSLATED}{one}⟧" not in plain] == []


def test_what_may_be_given_several_times_is_told_without_names_of_types(trackwright):
    page = trackwright("track", "--help")[1]
    assert "--set <str>..." in page
    assert "--calibration <path>..." in page
    assert "list[" not in page
