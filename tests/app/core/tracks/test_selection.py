from app.core.tracks.selection import Selection


def test_choosing_says_whether_something_changed():
    selection = Selection()
    assert selection.choose(4)
    assert not selection.choose(4)
    assert selection
    selection.choose(0)
    assert not selection


def test_cycling_goes_through_the_tracks_and_around():
    selection = Selection()
    seen = []
    for _ in range(4):
        selection.choose(selection.cycle([7, 2, 5]))
        seen.append(selection.track)
    assert seen == [2, 5, 7, 2]
    assert selection.cycle([7, 2, 5], step=-1) == 7


def test_cycling_goes_on_from_a_track_that_is_gone():
    selection = Selection()
    selection.choose(4)
    assert selection.cycle([2, 5, 7]) == 5
    assert selection.cycle([2, 5, 7], step=-1) == 2


def test_cycling_skips_the_person_an_edit_holds_already():
    selection = Selection()
    selection.choose(2)
    assert selection.cycle([2, 5], skip=2) == 5
    assert selection.cycle([2], skip=2) == 0
