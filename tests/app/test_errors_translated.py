"""What goes wrong is told in the user's language, at the command line and in the window."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.cli.failure import run_reporting_errors
from app.cli.output import say
from app.cli.restore import _line
from app.cli.sessions import print_notes
from app.core.error_messages import explain
from app.core.tracking_process.messages import (
    packed_error,
    packed_notes,
    unpacked_error,
    unpacked_notes,
)
from tests.pseudo import TRANSLATED
from tracking.atomic_output import check_target
from tracking.editing.core.label_state import LabelState, apply_label_state
from tracking.errors import EditError, FormatError, OutputError, UnsafeFileError
from tracking.formats import format_of
from tracking.owned_files import check_folder
from tracking.session import session_reader
from tracking.session.backups import Backup
from tracking.session.journal_faults import CANNOT_WRITE, translate_errors
from tracking.session.notes import note_of_change, note_of_missing_seal, tell_damage
from tracking.session.session_reader import check_file
from tracking.tracks import Labels, Occluder
from tracking.translation import Message, msg, tr


@pytest.fixture
def empty(tmp_path: Path) -> Path:
    path = tmp_path / "empty.txt"
    path.touch()
    return path


@pytest.mark.usefixtures("pseudo")
def test_the_line_of_an_error_at_the_command_line(empty: Path, capsys) -> None:
    assert run_reporting_errors(lambda: format_of(empty), debug=False) == 1
    assert capsys.readouterr().err == f"trackwright: ⟦{empty} is empty; name a file with tracks⟧\n"


@pytest.mark.usefixtures("pseudo")
def test_a_note_at_the_command_line(capsys) -> None:
    say(msg("note: {note}", note=msg("{n} rows are left out", n=3)))
    assert capsys.readouterr().err == "⟦note: ⟦3 rows are left out⟧⟧\n"


@pytest.mark.usefixtures("pseudo")
def test_the_message_of_an_error_in_the_window(empty: Path) -> None:
    with pytest.raises(FormatError) as caught:
        format_of(empty)
    assert explain(caught.value) == f"⟦{empty} is empty; name a file with tracks⟧"


def test_the_window_leaves_out_what_is_typed_at_the_command_line() -> None:
    error = FormatError("a is unknown", "choose one", option="--format")
    assert explain(error) == "a is unknown; choose one"


@pytest.mark.usefixtures("pseudo")
def test_what_a_program_of_its_own_finds_in_a_file(tmp_path: Path) -> None:
    path = tmp_path / "session.h5"
    path.write_bytes(b"no HDF5")
    with pytest.raises(Exception, match="is not an HDF5 file") as caught:
        check_file(path)
    assert f"{TRANSLATED}is not an HDF5 file" in explain(caught.value)


@pytest.mark.usefixtures("pseudo")
def test_errors_and_notes_of_a_tracker_in_a_process_of_its_own() -> None:
    error = FormatError("{path} is empty", "name {what}", option="--x", path="a", what=msg("one"))
    same = unpacked_error(packed_error(error, ""))
    assert (str(same), explain(same)) == (str(error), explain(error))
    (note,) = unpacked_notes(packed_notes([msg("{n} frames are broken", n=2)]))
    assert isinstance(note, Message)
    assert tr(note) == "⟦2 frames are broken⟧"


@pytest.mark.usefixtures("pseudo")
def test_what_is_damaged_of_a_session_is_told_at_the_command_line(capsys) -> None:
    with print_notes():
        for note_of in (note_of_change, note_of_missing_seal):
            tell_damage(note_of(Path("100 %s")))
    first, second = capsys.readouterr().err.splitlines()
    assert first.startswith("⟦note: ⟦100 %s is damaged: its checksum")
    assert second.startswith("⟦note: ⟦100 %s is damaged at its end")


@pytest.mark.usefixtures("pseudo")
def test_a_backup_is_listed_with_its_counts() -> None:
    backup = Backup(1, Path("a"), 3 << 20, "2024-05-01T10:00:00.000Z", 1, 0, 2)
    listed = "1  saved 2024-05-01 10:00:00 UTC  1 edit, 2 tracks  3.0 MB"
    assert _line(backup) == listed
    assert tr(_line(backup)) == f"⟦{listed}⟧".replace("1 edit, 2 tracks", "⟦1 edit⟧, ⟦2 tracks⟧")


def test_the_way_out_hangs_on_what_is_known_of_a_file_and_not_on_its_sentence(
    empty: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    verdict = {"refused": msg(" is odd")}
    monkeypatch.setattr(session_reader, "inspect_files", lambda _: [verdict])
    with pytest.raises(Exception, match=r"is odd$"):
        check_file(empty)
    verdict["unreadable"] = True
    with pytest.raises(Exception, match="bring a copy of it"):
        check_file(empty)


@pytest.mark.usefixtures("pseudo")
def test_what_stands_in_the_place_of_a_file_is_told_in_the_language(tmp_path: Path) -> None:
    with pytest.raises(OutputError) as caught:
        check_target(tmp_path)
    assert "⟦it is ⟦a folder⟧⟧" in explain(caught.value)


@pytest.mark.usefixtures("pseudo")
def test_what_is_no_folder_is_told_in_the_language(empty: Path) -> None:
    with pytest.raises(UnsafeFileError) as caught:
        check_folder(empty)
    assert f"⟦{empty} is ⟦a file⟧, not ⟦a folder⟧" in explain(caught.value)


@pytest.mark.usefixtures("pseudo")
def test_what_an_edit_was_not_planned_on_is_told_in_the_language() -> None:
    left = LabelState(occluders=(Occluder("", ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))),))
    with pytest.raises(EditError) as caught:
        apply_label_state(Labels(), left, LabelState())
    assert "the ⟦occluders⟧ are not" in explain(caught.value)


@pytest.mark.usefixtures("pseudo")
def test_what_a_journal_refuses_is_told_in_the_language(tmp_path: Path) -> None:
    with pytest.raises(OutputError) as caught, translate_errors(tmp_path, CANNOT_WRITE):
        raise OSError("full")
    assert "⟦the journal of edits cannot be written⟧ (full)" in explain(caught.value)
