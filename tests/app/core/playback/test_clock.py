import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.playback.clock import PlaybackClock


@pytest.fixture
def clock() -> PlaybackClock:
    return PlaybackClock(frame_count=100, fps=20.0)


def test_a_second_of_wall_time_plays_as_many_frames_as_the_recording_has_a_second(clock):
    clock.play()
    for _ in range(10):
        clock.advance(0.1)
    assert clock.frame == 20


def test_frames_are_dropped_when_a_tick_comes_late(clock):
    clock.play()
    assert clock.advance(0.25)
    assert clock.frame == 5


def test_after_a_long_stall_playback_goes_on_where_it_was(clock):
    clock.play()
    clock.advance(3.0)
    assert clock.frame == 10


def test_a_paused_clock_stands_still(clock):
    assert not clock.advance(1.0)
    assert clock.frame == 0


def test_playback_stops_at_the_last_frame_and_plays_again_from_the_start(clock):
    clock.seek(97)
    clock.play()
    clock.advance(0.5)
    assert (clock.frame, clock.playing) == (99, False)
    clock.play()
    assert (clock.frame, clock.playing) == (0, True)


def test_playing_waits_at_a_frame_without_pausing(clock):
    clock.play()
    clock.advance(0.5, wait_at=3)
    assert (clock.frame, clock.playing) == (3, True)


def test_a_playhead_past_the_waiting_place_is_not_pulled_back(clock):
    clock.seek(50)
    clock.play()
    clock.advance(0.1, wait_at=3)
    assert clock.frame == 50


def test_stepping_pauses(clock):
    clock.play()
    clock.step(10)
    assert (clock.frame, clock.playing) == (10, False)
    clock.step(-1)
    assert clock.frame == 9


def test_the_shuttle_doubles_its_pace_with_each_press_and_turns_round(clock):
    clock.seek(50)
    clock.shuttle(1)
    assert clock.rate == 1.0
    clock.shuttle(1)
    assert clock.rate == 2.0
    clock.shuttle(-1)
    assert clock.rate == -1.0
    clock.advance(0.5)
    assert clock.frame == 40
    clock.shuttle(0)
    assert not clock.playing


def test_shuttling_back_stops_at_the_start(clock):
    clock.seek(5)
    clock.shuttle(-1)
    clock.advance(0.5)
    assert (clock.frame, clock.playing) == (0, False)


def test_speed_goes_up_and_down_the_steps_and_stays_in_range(clock):
    clock.change_speed(1)
    assert clock.speed == 2.0
    clock.change_speed(-6)
    assert clock.speed == 0.1
    clock.set_speed(99)
    assert clock.speed == 8.0


@given(
    st.lists(
        st.one_of(
            st.tuples(st.just("advance"), st.floats(0, 2)),
            st.tuples(st.just("seek"), st.integers(-500, 500)),
            st.tuples(st.just("shuttle"), st.sampled_from([-1, 0, 1])),
            st.tuples(st.just("step"), st.integers(-50, 50)),
        ),
        max_size=30,
    ),
    st.integers(1, 200),
)
def test_the_frame_is_always_within_the_recording(steps, frame_count):
    clock = PlaybackClock(frame_count, 25.0)
    for name, value in steps:
        getattr(clock, name)(value)
        assert 0 <= clock.frame < frame_count


def test_a_loop_begins_again_where_it_ends_and_loses_no_time(clock):
    clock.loop = (10, 20)
    clock.play()
    assert clock.frame == 10  # it began outside
    clock.advance(0.45)
    assert clock.frame == 19
    clock.advance(0.1)
    assert (clock.frame, clock.playing) == (11, True)


def test_a_loop_backwards_goes_on_at_its_end(clock):
    clock.loop = (10, 20)
    clock.seek(12)
    clock.shuttle(-1)
    clock.advance(0.2)
    assert (clock.frame, clock.playing) == (18, True)


def test_a_loop_over_the_whole_recording_never_stops(clock):
    clock.loop = (0, 100)
    clock.seek(95)
    clock.play()
    frames = []
    for _ in range(20):
        clock.advance(0.05)
        frames.append(clock.frame)
    assert clock.playing
    assert frames[:5] == [96, 97, 98, 99, 0]


def test_who_plays_behind_a_loop_plays_on(clock):
    clock.loop = (10, 20)
    clock.play()
    clock.seek(50)
    clock.advance(0.5)
    assert clock.frame == 60


def test_motion_is_slow_near_an_event_and_as_chosen_before_and_after(clock):
    clock.event, clock.speed = 50, 2.0
    clock.seek(20)
    clock.play()
    assert clock.pace == 2.0
    clock.advance(0.25)
    assert clock.frame == 30
    clock.seek(50)
    assert clock.pace == 0.25
    clock.advance(0.4)
    assert clock.frame == 52
    clock.seek(80)
    clock.advance(0.5)
    assert clock.frame == 99


def test_a_late_tick_does_not_leap_over_an_event(clock):
    clock.event = 50
    clock.seek(34)
    clock.play()
    clock.advance(0.5)  # it would be frame 44 without: slow from frame 35 on
    assert 35 <= clock.frame <= 38


def test_slow_motion_never_makes_faster(clock):
    clock.event, clock.speed = 50, 0.1
    clock.seek(50)
    clock.play()
    assert clock.pace == 0.1
