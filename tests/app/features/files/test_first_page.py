"""The first page lists what was opened before by names that tell it apart."""

from pathlib import Path

from app.features.files.first_page import first_page


def _titles(*recent):
    return [item.title for item in first_page(dict(recent)).recent]


def test_a_session_goes_by_the_name_of_its_recording():
    lobby, hall = Path("/a/lobby/session.h5"), Path("/a/hall/session.h5")
    assert _titles((lobby, "Lobby"), (hall, "Hall")) == ["Lobby", "Hall"]


def test_of_several_on_one_recording_each_is_told_apart():
    first, second = Path("/a/lobby/first.h5"), Path("/a/lobby/second.h5")
    titles = _titles((first, "Lobby"), (second, "Lobby"))
    assert titles == ["Lobby \u2013 first", "Lobby \u2013 second"]


def test_those_whose_recording_is_not_known_are_told_apart_by_their_folder():
    paths = [Path(f"/a/{name}/session.h5") for name in ("lobby", "hall", "street", "yard")]
    titles = _titles(*((path, "") for path in paths))
    assert titles == [f"session \u2013 {path.parent.name}" for path in paths]


def test_what_is_there_says_its_kind_and_day_and_what_has_gone_is_marked(tmp_path):
    there, gone = tmp_path / "there.h5", tmp_path / "gone.h5"
    there.write_bytes(b"")
    one, other = first_page({there: "Lobby", gone: "Hall"}).recent
    assert one.exists
    assert one.detail.startswith("session")
    assert one.detail[-10:].count("-") == 2
    assert not other.exists


def test_the_folder_of_a_project_is_told_as_one(tmp_path, remembered):
    remembered.add_recent(tmp_path / "one", "One")
    remembered.add_recent(tmp_path, "all", project=True)
    for path in remembered.recent:
        path.mkdir(exist_ok=True)
    projects = [path for path in remembered.recent if remembered.is_recent_project(path)]
    scene = first_page(dict.fromkeys(remembered.recent, ""), projects)
    assert [item.detail.split()[0] for item in scene.recent] == ["project", "recording"]
    remembered.add_recent(tmp_path, "all")
    assert not remembered.is_recent_project(tmp_path)


def test_a_path_that_no_file_can_have_is_marked_as_gone():
    odd = [Path("/a/with\0nothing.h5"), Path("/a") / ("long" * 100)]
    assert [item.exists for item in first_page(dict.fromkeys(odd, "Lobby")).recent] == [False] * 2


def test_a_folder_that_was_opened_as_a_project_is_called_one(tmp_path):
    (item,) = first_page({tmp_path: "walks"}, projects=[tmp_path]).recent
    assert item.detail.startswith("project")
