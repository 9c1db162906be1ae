"""The playback clock: which frame is now."""

from __future__ import annotations

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0)
LONGEST_STALL_S = 0.5


class PlaybackClock:
    """Turns elapsed wall time into a frame number; frames are dropped rather than played late.

    `speed` is the rate chosen (0.25 to 8); `rate` is what plays now, negative while the shuttle
    runs backwards. Playback stops at either end of the recording; there is no loop.
    """

    def __init__(self, frame_count: int, fps: float) -> None:
        self.frame_count = frame_count
        self.fps = fps
        self.playing = False
        self.speed = 1.0
        self.rate = 1.0
        self._position = 0.0

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
        """Play on at the chosen speed; from the start where the recording has ended."""
        if self.frame >= self.last_frame:
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
        """Choose a speed, within 0.25 to 8; the direction stays."""
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
        before = self.frame
        self._position += min(elapsed_s, LONGEST_STALL_S) * self.fps * self.rate
        if wait_at is not None and self.rate > 0:
            self._position = min(self._position, max(float(wait_at), float(before)))
        self._stop_at_the_ends()
        return self.frame != before

    def _stop_at_the_ends(self) -> None:
        if self.rate > 0 and self._position >= self.last_frame:
            self._position = float(self.last_frame)
            self.pause()
        elif self.rate < 0 and self._position <= 0:
            self._position = 0.0
            self.pause()
