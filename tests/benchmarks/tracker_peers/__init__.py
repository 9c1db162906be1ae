"""Our stereo trackers beside those of others, on the same detections."""
