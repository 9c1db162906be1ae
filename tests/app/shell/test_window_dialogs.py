"""File dialogs begin where a file of the same kind was chosen last."""

from PySide6.QtWidgets import QFileDialog


def _dialog(window, ask):
    """The dialog that is asked for, which the caller closes."""
    ask()
    (dialog,) = [one for one in window.findChildren(QFileDialog) if one.isVisible()]
    return dialog


def _folder(window, ask):
    dialog = _dialog(window, ask)
    folder = dialog.directory().absolutePath()
    dialog.reject()
    return folder


def _choose(window, ask, path):
    dialog = _dialog(window, ask)
    dialog.fileSelected.emit(str(path))
    dialog.reject()


def test_a_dialog_begins_in_the_folder_of_the_last_file_of_its_kind(
    window, controller, qtbot, tmp_path, monkeypatch
):
    tracks, elsewhere = tmp_path / "tracks", tmp_path / "elsewhere"
    for folder in (tracks, elsewhere):
        folder.mkdir()
    monkeypatch.setattr(window.files.importing, "read", lambda _: None)
    ask_import, ask_save = window.files.importing.ask, window.files.saving.save_as
    before = _folder(window, ask_save)
    _choose(window, ask_import, tracks / "gt.txt")
    assert _folder(window, ask_import) == str(tracks)
    assert _folder(window, ask_save) == before  # another kind
    _choose(window, ask_save, elsewhere / "mine.h5")
    qtbot.waitUntil(lambda: (elsewhere / "mine.h5").is_file() and not window.work.busy)
    assert _folder(window, ask_save) == str(elsewhere)
    assert _folder(window, ask_import) == str(tracks)


def test_a_dialog_that_opens_a_file_begins_beside_what_is_open(window, controller):
    beside = str(controller.document.session.path.parent)
    assert _folder(window, window.files.ask_open) == beside
    assert _folder(window, window.files.importing.ask) == beside


def test_a_dialog_begins_at_home_where_nothing_was_opened_yet(window, tmp_path, monkeypatch):
    monkeypatch.setattr("pathlib.Path.home", lambda: tmp_path)
    assert _folder(window, window.files.ask_open) == str(tmp_path)


def test_a_dialog_begins_where_the_latest_file_is_that_is_left(window, tmp_path):
    window.remembered.add_recent(tmp_path / "kept.h5")
    window.remembered.add_recent(tmp_path / "gone" / "session.h5")
    assert _folder(window, window.files.ask_open) == str(tmp_path)


def test_a_dialog_begins_at_the_session_where_its_last_folder_has_gone(
    window, controller, tmp_path
):
    gone = tmp_path / "gone"
    window.remembered.last_folder("session").note(gone / "old.h5")
    proposed = controller.document.session.path.parent
    assert _folder(window, window.files.saving.save_as) == str(proposed)


def test_a_session_is_proposed_under_the_name_of_its_recording(
    window, controller, tiny_recording, qtbot
):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None and window.controller is not controller)
    dialog = _dialog(window, window.files.saving.save_as)
    (name,) = dialog.selectedFiles()
    dialog.reject()
    assert name.endswith("/plaza-3-session.h5")
