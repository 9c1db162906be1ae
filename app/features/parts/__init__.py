"""Body parts that a tracker saw: curves, failures, training of the failure detector."""
