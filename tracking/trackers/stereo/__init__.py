"""The stereo trackers of [Kawashita2012] and [Kawashita2014], and what they share."""
