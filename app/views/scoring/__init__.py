"""Truth beside a result: the panel of figures, lanes of errors, marks on pictures and floor."""
