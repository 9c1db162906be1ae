"""A session whose file cannot be reached any more shows every frame whole all the same."""


def test_pictures_and_floor_show_the_same_frame_when_the_session_file_is_out_of_reach(
    window, controller, qtbot, tiny_session
):
    away = tiny_session.rename(tiny_session.with_suffix(".away"))
    floor = window.workspace.overhead
    last = controller.playback.clock.last_frame
    for frame in (last - 1, last):
        controller.playback.go(frame)
        qtbot.waitUntil(lambda frame=frame: controller.playback.number == frame)
        assert floor._scene.frame == frame
        people = {person.track for person in floor._scene.people}
        assert people == set(controller.document.tracks.of_frame(frame)["track"].tolist())
    assert not len(floor._scene.particles)
    assert "out of reach" in window.notice.text
    away.rename(tiny_session)
    controller.playback.go(last - 2)
    qtbot.waitUntil(lambda: controller.playback.number == last - 2)
    assert len(floor._scene.particles)
