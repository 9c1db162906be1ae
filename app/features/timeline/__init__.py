"""The timeline: a lane a track, errors, an overview of the recording."""
