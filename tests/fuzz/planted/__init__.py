"""Faults that are planted to be found: a fuzzer that finds none of them finds nothing else either."""
