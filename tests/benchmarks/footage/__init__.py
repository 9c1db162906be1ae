"""All trackers over all footage: real recordings, rendered ones of others, our own."""
