"""A run laid over the corrected tracks: what stays, what would change, taking it."""
