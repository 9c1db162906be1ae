"""What all trackers share: the protocol, continuing from corrected people, smoothing, occluders."""
