"""Truth beside a result: where it comes from, where the result errs, and how good it is."""
