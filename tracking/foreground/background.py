"""What one camera sees where nobody is: learnt, adapted, and subtracted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Mask, Picture
from tracking.foreground.background_modes import (
    SecondaryMode,
    primary_and_secondary_mode,
    primary_mode,
)
from tracking.foreground.difference import (
    ChannelDifference,
    Channels,
    channels_of,
    split_into,
)
from tracking.foreground.gain import channel_ratios, scaled
from tracking.foreground.local_light import MUCH_CHANGED, change_of_light, patches_of_light
from tracking.foreground.overexposure import Overexposure
from tracking.foreground.recurrence import Recurrence
from tracking.foreground.settings import ForegroundSettings

_SMALLEST_GAIN_STEP = 0.012
_USUAL_EXPOSURE = (0.75, 1.33)
"""Ratios to the background's own exposure at which it may learn at once."""
_READABLE_EXPOSURE = (0.5, 1.8)
"""Ratios beyond which dimmed or overexposed detail makes the comparison worthless."""
_PATIENCE_S = 2.0
"""How long a change of the whole scene or of exposure lasts before a learnt background yields."""
_LIT_AFTER_S = (0.8, 1.6)
"""How long a patch of more light, or of less, keeps still before it joins the background. Shadows
of people who walk by keep still for less, and less light is told from people anyway."""
_PATCHES_EVERY = 2
"""Updates of the background between two searches for such patches."""
_LEARN_S = 1.5
"""How long changes become background ten times faster where nothing was learnt beforehand, so that
people who stand in the first frames leave a ghost for less time."""
_UNSEEN_ELSEWHEN = 10.0
"""What the rest of the recording does not show must keep still for so many times as long."""
_NOISE_AT_FIRST = 2.0
_UNCHANGED = np.ones(3, np.float32)
_OPENING = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))


@dataclass(frozen=True, slots=True)
class Subtraction:
    """One camera's picture beside its background.

    Attributes:
        picture: (height, width, 3) the lightly smoothed picture.
        background: (height, width, 3) what would be seen without people, at the same exposure.
        mask: (height, width) uint8, 255 where the two differ, else 0.
        scene_changed: too much differs for people to be told from the change; mask is empty.
    """

    picture: Picture
    background: Picture
    mask: Mask
    scene_changed: bool


class BackgroundModel:
    """A running mean and deviation per pixel and channel of one fixed camera.

    Slow changes are followed, a change of exposure is taken out at once as one factor, and what
    stays still without being a person is absorbed after a while. Pixels protected by the caller
    (people, as told by stereo) are left alone, so that standing people do not melt.

    Frames are given in order: `subtract`, then `update` with the same frame's verdict.

    Args:
        fps: frames a second. settings: None for the usual ones.
        looked_at: uint8, non-zero where foreground counts, of any size that shows the same
            picture; None: everywhere.
    """

    def __init__(
        self,
        fps: float,
        settings: ForegroundSettings | None = None,
        looked_at: Mask | None = None,
    ) -> None:
        self._settings = settings or ForegroundSettings()
        self._looked_at = looked_at
        self._every = max(1, round(fps / self._settings.updates_hz))
        self._period_s = self._every / fps
        self._primed = False
        self._frames = 0
        self._odd_s = self._time_s = 0.0
        self._exposure = _UNCHANGED
        self._recurrence: Recurrence | None = None
        self._explained = False
        self._channels: Channels = []

    def learn(
        self,
        pictures: Sequence[Picture],
        later: Sequence[Picture] = (),
        times_s: Sequence[float] = (),
    ) -> None:
        """Start from the primary mode of pictures spread over some time, people or not.

        Args:
            pictures: at least one (height, width, 3), in order of time, evenly spread.
            later: of each the picture a moment later; empty: it is not known what moves.
            times_s: of each, on the clock of `subtract`; empty: nothing is told of what stays.
        """
        self._begin_with(*primary_mode(pictures, later))
        self._recurrence = Recurrence(pictures, later, times_s) if times_s else None

    def learn_both_modes(
        self,
        pictures: Sequence[Picture],
        later: Sequence[Picture] = (),
        times_s: Sequence[float] = (),
    ) -> SecondaryMode:
        """Start as `learn` does; returns the secondary mode, for `restore_secondary`.

        Args:
            pictures, later, times_s: see `learn`.
        """
        picture, deviation, other = primary_and_secondary_mode(pictures, later)
        self._begin_with(picture, deviation)
        self._recurrence = Recurrence(pictures, later, times_s) if times_s else None
        return other

    def _begin_with(self, picture: Picture, deviation: NDArray[np.float32]) -> None:
        self._start(picture)
        self._noise = np.maximum(deviation, _NOISE_AT_FIRST).astype(np.float32)
        self._refresh()
        self._primed = True

    def restore_secondary(self, other: SecondaryMode, people: Mask) -> None:
        """Take the secondary mode of what was learnt where somebody stood for most of the time.

        Args:
            other: as `learn_both_modes` gave it.
            people: (height, width) uint8, non-zero where they stood.
        """
        here = (people != 0) & (other.where != 0)
        self._mean[here] = other.picture[here]
        self._noise[here] = _NOISE_AT_FIRST
        for channel, one in zip(self._candidate, channels_of(other.picture), strict=True):
            channel[here] = one[here]
        self._stillness_s[here] = 0
        self._refresh()

    def subtract(self, picture: Picture, time_s: float = 0.0) -> Subtraction:
        """Compare a picture with the background, its exposure taken out.

        Args:
            picture: (height, width, 3) uint8. time_s: of the picture, on the clock of `learn`.
        """
        self._time_s = time_s
        smooth = np.asarray(cv2.blur(picture, (3, 3)), np.uint8)
        if self._frames == 0 and not self._primed:
            self._start(smooth)
        self._follow_exposure(smooth)
        if self._overexposure.is_uncovered:
            self._expose()
            self._show(self._overexposure.seen_through(smooth, self._background))
        mask, differs = self._threshold(smooth)
        if differs > MUCH_CHANGED and self._take_light(smooth, mask):
            mask, differs = self._threshold(smooth)
        changed = differs > self._settings.scene_change
        self._explained = differs < MUCH_CHANGED
        if changed or not _within(self._brightness, _READABLE_EXPOSURE):
            return Subtraction(smooth, self._background, np.zeros(mask.shape, np.uint8), True)
        return Subtraction(smooth, self._background, self.within_region(mask), False)

    def within_region(self, mask: Mask) -> Mask:
        """A mask, or another picture (height, width), that is 0 where nothing is looked for."""
        if self._looked_at is None:
            return mask
        if self._looked_at.shape != mask.shape:
            size = (mask.shape[1], mask.shape[0])
            shown = cv2.resize(self._looked_at, size, interpolation=cv2.INTER_NEAREST)
            self._looked_at = np.asarray(shown, np.uint8)
        return np.asarray(cv2.copyTo(mask, self._looked_at), np.uint8)

    def _threshold(self, picture: Picture) -> tuple[Mask, float]:
        """Where a picture differs from the background, and in how large a share of it."""
        # Both are kept for the update with the same frame, the difference until `_absorb`.
        self._channels = split_into(self._channels, picture)
        self._difference = self._compare.largest(self._channels, self._usual)
        mask = cv2.compare(self._difference, self._limit, cv2.CMP_GT)
        mask = cv2.morphologyEx(mask, cv2.MORPH_OPEN, _OPENING)
        return np.asarray(mask, np.uint8), cv2.countNonZero(mask) / mask.size

    def _take_light(self, picture: Picture, mask: Mask) -> bool:
        """Whether light changed on a part of the scene; the background then has it, too."""
        ratio = change_of_light(picture, self.background, mask)
        if ratio is None:
            return False
        self._mean *= ratio
        self._expose()
        return True

    @property
    def background(self) -> Picture:
        """(height, width, 3) what the camera would see without people."""
        return self._background

    @property
    def limit(self) -> Picture:
        """(height, width) the smallest difference that is foreground, a pixel each."""
        return self._limit

    @property
    def update_is_due(self) -> bool:
        """Whether the next `update` will use its frame."""
        return self._frames % self._every == 0

    def skip(self) -> None:
        """Let a frame pass of which nothing is to be learnt."""
        self._frames += 1

    def update(self, seen: Subtraction, people: Mask | None = None) -> None:
        """Let the background follow what was seen; does its work only every few frames.

        Args:
            seen: of this frame.
            people: (height, width) uint8, non-zero where the picture must not be learnt.
        """
        due = self.update_is_due
        self._frames += 1
        if not due:
            return
        odd = seen.scene_changed or not _within(self._brightness, _USUAL_EXPOSURE)
        self._odd_s = self._odd_s + self._period_s if odd else 0.0
        if odd and self._primed and self._odd_s < _PATIENCE_S:
            return
        if seen.scene_changed:
            self._begin_anew(seen.picture)
            return
        self._take_exposure_in()
        self._adapt(seen)
        self._absorb(seen, people)
        self._refresh()

    def _begin_anew(self, picture: Picture) -> None:
        """The scene is another one; unless it is the same in very different light.

        What is still to come tells what it looks like without the people who are there now.
        """
        if not self._explained:
            pictures, later = self._pictures_to_come()
            if pictures:
                self._begin_with(*primary_mode(pictures, later))
            else:
                self._start(picture)
            return
        self._take_exposure_in()
        self._odd_s = 0.0
        self._refresh()

    def _pictures_to_come(self) -> tuple[list[Picture], list[Picture]]:
        """Those learnt from that show the scene since it changed, and those a moment later."""
        if self._recurrence is None:
            return [], []
        return self._recurrence.after(self._time_s - _PATIENCE_S)

    def _start(self, picture: Picture) -> None:
        self._mean = picture.astype(np.float32)
        self._noise = np.full(picture.shape[:2], _NOISE_AT_FIRST, np.float32)
        self._channels, self._candidate = channels_of(picture), channels_of(picture)
        self._compare = ChannelDifference(picture.shape)
        self._overexposure = Overexposure(picture)
        self._stillness_s = np.zeros(picture.shape[:2], np.float32)
        self._exposure, self._odd_s = _UNCHANGED, 0.0
        self._refresh()

    def _refresh(self) -> None:
        """Make the 8-bit pictures that subtraction compares with."""
        self._expose()
        limit = cv2.convertScaleAbs(self._noise, alpha=self._settings.noise_factor)
        lowest = np.full(limit.shape, round(self._settings.threshold), np.uint8)
        self._limit = np.asarray(cv2.max(np.asarray(limit, np.uint8), lowest), np.uint8)

    def _follow_exposure(self, picture: Picture) -> None:
        """Scale what is compared with where the whole picture became brighter, darker or bluer.

        The mean itself keeps its own exposure, unclipped, so that errors do not pile up and what
        was overexposed comes back as it was.
        """
        ratio = channel_ratios(picture, self._background)
        if np.abs(ratio - 1).max() > _SMALLEST_GAIN_STEP:
            self._exposure = self._exposure * ratio
            self._overexposure.follow(ratio)
            self._expose()

    @property
    def _brightness(self) -> float:
        """Of the present exposure, beside the background's own."""
        return float(self._exposure[1])

    def _expose(self) -> None:
        """Show the mean at the present exposure."""
        self._show(scaled(self._mean, self._exposure))

    def _show(self, background: Picture) -> None:
        """Compare with this from now on."""
        self._background = background
        self._usual = channels_of(background)

    def _take_exposure_in(self) -> None:
        """Make the present exposure the background's own."""
        if (self._exposure != 1.0).any():
            self._mean *= self._exposure
            self._exposure = _UNCHANGED

    def _adapt(self, seen: Subtraction) -> None:
        """Follow slow changes where there is no foreground."""
        rate = 1 - np.exp(-self._period_s / self._settings.adapt_s)
        still = cv2.bitwise_not(cv2.dilate(seen.mask, _OPENING))
        cv2.accumulateWeighted(seen.picture, self._mean, rate, mask=still)
        cv2.accumulateWeighted(self._difference, self._noise, rate, mask=still)

    def _absorb(self, seen: Subtraction, people: Mask | None) -> None:
        """Take foreground that keeps still and is nobody into the background."""
        changed = self._compare.largest(self._channels, self._candidate)
        moved = np.asarray(cv2.compare(changed, self._limit, cv2.CMP_GT), np.uint8)
        for channel, candidate in zip(self._channels, self._candidate, strict=True):
            cv2.copyTo(channel, moved, candidate)
        still = cv2.bitwise_and(seen.mask, cv2.bitwise_not(moved))
        longer_s = self._stillness_s + np.float32(self._period_s)
        self._stillness_s = np.asarray(cv2.copyTo(longer_s, still), np.float32)
        if self._frames % (_PATCHES_EVERY * self._every) == 1:
            self._take_patches(seen)
        settled = self._stillness_s > np.float32(self._absorb_after_s())
        box = _around(settled)
        if box is None:
            return
        settled = self._staying(seen, settled[box], box)
        if people is not None:
            lasting = self._stillness_s[box] > np.float32(self._settings.absorb_person_s)
            settled &= (people[box] == 0) | lasting
        self._mean[box][settled] = seen.picture[box][settled]
        self._noise[box][settled] = _NOISE_AT_FIRST

    def _staying(self, seen: Subtraction, settled: Flags, box: tuple[slice, slice]) -> Flags:
        """What of the settled pixels of a box is there to stay, or has been there for long.

        Each is looked for at later times when it settles, and then from time to time.
        """
        if self._recurrence is None or not self._recurrence.tells:
            return settled
        still_s = self._stillness_s[box]
        due = settled & (np.fmod(still_s, self._absorb_after_s()) <= self._period_s)
        here = still_s > np.float32(_UNSEEN_ELSEWHEN * self._settings.absorb_s)
        if due.any():
            since_s = self._time_s - self._settings.absorb_s
            stays = self._recurrence.stays(seen.picture, seen.background, box, since_s)
            here |= due & stays
        return np.asarray(settled & here, np.bool_)

    def _take_patches(self, seen: Subtraction) -> None:
        """Give the background the light of patches that keep still.

        It is believed whoever seems to be there; but less light is not where it is as before later
        on: plain dark clothes over a plain floor look like shade.
        """
        found = patches_of_light(seen.picture, self._background, self._stillness_s, _LIT_AFTER_S)
        if found is not None:
            box, ratio = found
            if self._recurrence is not None:
                since_s = self._time_s - _LIT_AFTER_S[1]
                passes = self._recurrence.passes(seen.picture, seen.background, box, since_s)
                ratio[passes & (ratio.max(axis=2) < 1.0)] = 1.0
            self._mean[box] *= ratio

    def _absorb_after_s(self) -> float:
        elapsed_s = self._frames * self._period_s / self._every
        learning = not self._primed and elapsed_s < _LEARN_S
        return self._settings.absorb_s / 10 if learning else self._settings.absorb_s


def _around(where: NDArray[np.bool_]) -> tuple[slice, slice] | None:
    """The box round everything that is true; None without anything."""
    x, y, width, height = cv2.boundingRect(where.view(np.uint8))
    return (slice(y, y + height), slice(x, x + width)) if width else None


def _within(value: float, bounds: tuple[float, float]) -> bool:
    return bounds[0] <= value <= bounds[1]
