"""The playback clock and the reader of frames."""
