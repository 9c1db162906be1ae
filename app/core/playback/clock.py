"""The playback clock: which frame is now."""

from __future__ import annotations

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
LONGEST_STALL_S = 0.5
SLOW_SPEED = 0.25
SLOW_S = 0.75
"""So long before and after an event, in the recording's time, slow motion is slow."""
LEAD_S = 1.5
"""So long before an event slow motion begins to play."""
_SLOW_STEP_S = 0.02


class PlaybackClock:
    """Turns elapsed wall time into a frame number; frames are dropped rather than played late.

    `speed` is the rate chosen (0.1 to 8); `rate` is what plays now, negative while the shuttle
    runs backwards. Playback stops at either end of the recording, unless it loops.

    Attributes:
        loop: the half-open range of frames that is played again and again; None: all, once.
        event: the frame around which motion is slow; None: nowhere.
    """

    def __init__(self, frame_count: int, fps: float) -> None:
        self.frame_count = frame_count
        self.fps = fps
        self.playing = False
        self.speed = 1.0
        self.rate = 1.0
        self.loop: tuple[int, int] | None = None
        self.event: int | None = None
        self._position = 0.0

    @property
    def pace(self) -> float:
        """How fast it plays at this frame: the rate, but slower around an event."""
        return self._slowed(self.rate)

    @property
    def frame(self) -> int:
        """The frame that is due now."""
        return int(self._position)

    @property
    def last_frame(self) -> int:
        """The recording's last frame."""
        return max(0, self.frame_count - 1)

    def seek(self, frame: int) -> None:
        """Go to a frame, or to the nearest end of the recording."""
        self._position = float(min(max(0, frame), self.last_frame))

    def step(self, frames: int) -> None:
        """Stop and go some frames on or back."""
        self.pause()
        self.seek(self.frame + frames)

    def play(self) -> None:
        """Play on at the chosen speed; from the start where the recording has ended.

        Outside of a loop it begins at the start of that.
        """
        if self.loop is not None and not self.loop[0] <= self.frame < self.loop[1]:
            self.seek(self.loop[0])
        elif self.loop is None and self.frame >= self.last_frame:
            self.seek(0)
        self.rate = self.speed
        self.playing = self.frame_count > 1

    def pause(self) -> None:
        """Stay at the frame."""
        self.playing = False
        self.rate = self.speed

    def toggle(self) -> None:
        """Play or pause."""
        if self.playing:
            self.pause()
        else:
            self.play()

    def set_speed(self, speed: float) -> None:
        """Choose a speed, within 0.1 to 8; the direction stays."""
        self.speed = min(max(speed, SPEEDS[0]), SPEEDS[-1])
        self.rate = -self.speed if self.rate < 0 and self.playing else self.speed

    def change_speed(self, steps: int) -> None:
        """Choose the next faster (1) or slower (-1) of `SPEEDS`."""
        nearest = min(range(len(SPEEDS)), key=lambda i: abs(SPEEDS[i] - self.speed))
        self.set_speed(SPEEDS[min(max(0, nearest + steps), len(SPEEDS) - 1)])

    def shuttle(self, direction: int) -> None:
        """J (-1), K (0), L (1): the first press plays that way, each further one doubles it."""
        if direction == 0:
            self.pause()
            return
        same_way = self.playing and self.rate * direction > 0
        pace = min(2 * abs(self.rate), SPEEDS[-1]) if same_way else 1.0
        self.rate = pace * direction
        self.playing = self.frame_count > 1

    def advance(self, elapsed_s: float, wait_at: int | None = None) -> bool:
        """Let wall time pass; True where another frame is due.

        `wait_at` holds forward playback at that frame, e.g. the last one tracked so far, without
        pausing it. After a stall longer than `LONGEST_STALL_S` playback goes on where it was
        rather than leaping over what nobody could see.
        """
        if not self.playing:
            return False
        before, start = self.frame, self._position
        self._move(min(elapsed_s, LONGEST_STALL_S))
        self._begin_again(start)
        if wait_at is not None and self.rate > 0:
            self._position = min(self._position, max(float(wait_at), float(before)))
        self._stop_at_the_ends()
        return self.frame != before

    def _move(self, elapsed_s: float) -> None:
        """Let time pass: in small steps where motion is slow in some places only."""
        left_s = elapsed_s
        while left_s > 0:
            step_s = left_s if self.event is None else min(left_s, _SLOW_STEP_S)
            self._position += step_s * self.fps * self._slowed(self.rate)
            left_s -= step_s

    def _slowed(self, rate: float) -> float:
        if self.event is None or abs(self._position - self.event) > SLOW_S * self.fps:
            return rate
        return max(-SLOW_SPEED, min(rate, SLOW_SPEED))

    def _begin_again(self, before: float) -> None:
        """At the end of the loop go on at its start, or backwards the other way round."""
        if self.loop is None:
            return
        start, stop = self.loop
        length = max(1, stop - start)
        passed_end = self.rate > 0 and before < stop <= self._position
        passed_start = self.rate < 0 and before >= start > self._position
        if passed_end or passed_start:
            self._position = start + (self._position - start) % length

    def _stop_at_the_ends(self) -> None:
        if self.loop is not None and self.loop[0] <= self._position < self.loop[1]:
            return
        if self.rate > 0 and self._position >= self.last_frame:
            self._position = float(self.last_frame)
            self.pause()
        elif self.rate < 0 and self._position <= 0:
            self._position = 0.0
            self.pause()
