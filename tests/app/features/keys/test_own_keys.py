"""Keys in layers: a change wins over the profile, the profile over what commands declare."""

import pytest

from app.core.scenes import CommandItem
from app.features.keys.presenter import KeysPresenter
from app.features.keys.profile_file import parse_profile, profile_text, read_profile
from app.features.keys.scene import SHIPPED, OwnKeys, profile_keys, resolved
from app.shell.commands import COMMANDS
from tracking.errors import FormatError

DECLARED = {"a": ("A",), "b": ("B", "Ctrl+B"), "c": ()}
ALSO = {"a": "", "b": "", "c": "as other tools call it"}
ITEMS = [
    CommandItem(name, "Edit", f"Do {name}", keys, True, also=ALSO[name])
    for name, keys in DECLARED.items()
]
ALL = {command.id: command.keys for command in COMMANDS}


@pytest.fixture
def presenter():
    return KeysPresenter(ITEMS, DECLARED, OwnKeys())


def test_a_key_that_is_given_to_one_command_is_taken_from_the_other():
    keys = resolved(DECLARED, OwnKeys(changes={"c": ("B",)}))
    assert keys == {"a": ("A",), "b": ("Ctrl+B",), "c": ("B",)}


def test_a_change_of_a_command_that_is_gone_does_nothing():
    assert resolved(DECLARED, OwnKeys(changes={"gone": ("X",)})) == DECLARED


@pytest.mark.parametrize("name", SHIPPED)
def test_a_profile_that_ships_names_commands_that_are_there_and_gives_no_key_twice(name):
    changes = profile_keys(name)
    assert set(changes) <= set(ALL)
    assert parse_profile(profile_text(OwnKeys(name, changes)), ALL).changes == changes
    given = [key for keys in resolved(ALL, OwnKeys(name)).values() for key in keys]
    assert len(given) == len(set(given))


@pytest.mark.parametrize("name", SHIPPED)
def test_in_a_profile_that_ships_no_command_loses_its_only_key_but_by_name(name):
    keys, named = resolved(ALL, OwnKeys(name)), profile_keys(name)
    lost = [one for one, had in ALL.items() if had and not keys[one] and one not in named]
    assert lost == []


def test_the_arrows_step_in_every_profile():
    for name in SHIPPED:
        keys = resolved(ALL, OwnKeys(name))
        assert "Right" in keys["play.next"]
        assert "Left" in keys["play.previous"]


def test_what_is_typed_finds_commands_by_title_menu_and_key(presenter):
    assert [row.command for row in presenter.rows("ctrl+b")] == ["b"]
    assert [row.command for row in presenter.rows("do c")] == ["c"]
    assert len(presenter.rows("edit")) == 3
    assert [row.command for row in presenter.rows("other tools")] == ["c"]


def test_the_command_of_a_key_stands_before_those_with_the_letter_in_their_words(presenter):
    assert [row.command for row in presenter.rows("b")] == ["b"]
    assert [row.command for row in presenter.rows("d")] == ["a", "b", "c"]
    presenter.add("c", "D")
    assert [row.command for row in presenter.rows("d")] == ["c", "a", "b"]


def test_who_has_a_key_is_told_and_loses_it_once_it_is_given_away(presenter):
    assert presenter.owner("c", "B") == "Do b"
    assert presenter.owner("b", "B") == ""
    presenter.add("c", "B")
    assert presenter.keys == {"a": ("A",), "b": ("Ctrl+B",), "c": ("B",)}
    assert [row.changed for row in presenter.rows()] == [False, True, True]


def test_resetting_one_command_gives_it_its_keys_back(presenter):
    presenter.add("c", "B")
    presenter.reset("b")
    assert presenter.keys == DECLARED
    assert presenter.own.changes == {}


def test_a_key_that_is_removed_stays_removed_until_all_is_reset(presenter):
    presenter.remove("b", "B")
    assert presenter.keys["b"] == ("Ctrl+B",)
    presenter.reset_all()
    assert presenter.keys == DECLARED


def test_a_profile_is_read_as_it_was_written(tmp_path):
    own = OwnKeys("cvat", {"tracks.swap": ("Ctrl+Alt+X", '"'), "help.keys": ()})
    path = tmp_path / "keys.toml"
    path.write_text(profile_text(own))
    assert read_profile(path, ALL) == own


def test_commands_of_another_version_are_left_out_and_named(tmp_path):
    path = tmp_path / "keys.toml"
    path.write_text('[keys]\n"tracks.swap" = ["ctrl+x"]\n"tracks.fly" = ["F"]\n')
    own = read_profile(path, ALL)
    assert (own.changes, own.unknown) == ({"tracks.swap": ("Ctrl+X",)}, ("tracks.fly",))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("keys", "is no profile of keys"),
        ("", "it has no table [keys]"),
        ('profile = "emacs"\n[keys]\n', "known profiles to build on"),
        ('[keys]\na = "X"', "a needs a list of at most 8 keys"),
        ('[keys]\na = ["Xylophone"]', "'Xylophone' of a is no key"),
        ("[keys]\na = [7]", "7 of a is no key"),
        ('[keys]\na = ["X"]\nb = ["X"]', "X is given to two commands"),
        ("[keys]\na = " + 600 * "[", "is no profile of keys"),
    ],
)
def test_what_is_no_profile_is_refused_in_one_line(text, said, tmp_path):
    path = tmp_path / "keys.toml"
    path.write_text(text)
    with pytest.raises(FormatError) as refused:
        read_profile(path, {"a", "b"})
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_file_that_is_not_there_or_is_a_link_is_refused(tmp_path):
    with pytest.raises(FormatError, match="cannot read"):
        read_profile(tmp_path / "none.toml", ALL)
    (tmp_path / "there.toml").write_text("[keys]\n")
    (tmp_path / "link.toml").symlink_to(tmp_path / "there.toml")
    with pytest.raises(Exception, match=r"link\.toml"):
        read_profile(tmp_path / "link.toml", ALL)
