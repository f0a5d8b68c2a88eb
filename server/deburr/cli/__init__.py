"""The command line: a thin face of the analysis. Each command loads what it needs and no more."""
