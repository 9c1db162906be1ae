"""Who a row belongs to: swapped, split, merged, given to another; and where two changed over."""
