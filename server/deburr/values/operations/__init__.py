"""Operations on ranges of doubles, lifted from a language's own on numbers. Knows no language."""

from deburr.values.operations.comparisons import at_most, equal, less, logical, negated, swapped
from deburr.values.operations.functions import falling, magnitude, negative, rising, rounded, within
from deburr.values.operations.lifting import Lifted, One, Two, finite, lifted, union
from deburr.values.operations.sums import divided, minus, modulo, plus, power, times

__all__ = [
    "Lifted",
    "One",
    "Two",
    "at_most",
    "divided",
    "equal",
    "falling",
    "finite",
    "less",
    "lifted",
    "logical",
    "magnitude",
    "minus",
    "modulo",
    "negated",
    "negative",
    "plus",
    "power",
    "rising",
    "rounded",
    "swapped",
    "times",
    "union",
    "within",
]
