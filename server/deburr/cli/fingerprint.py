"""By what a finding is known again when its program has changed elsewhere. Knows no report.

The rule and the text of the line decide, blanks apart: neither the number of the line nor the message,
which may name other lines. Findings that have both in common are counted: `…:1`, `…:2`.
"""

from collections import Counter
from collections.abc import Iterable, Iterator
from hashlib import blake2b

from deburr.finding import Finding


def key(finding: Finding, text: str) -> str:
    """What a rule says of a line with that text, as 32 hexadecimal digits."""
    return digest(finding.rule, " ".join(text.split()))


def digest(*parts: str) -> str:
    """Texts as 32 hexadecimal digits; other parts, other digits."""
    return blake2b("\0".join(parts).encode("utf-8", "surrogatepass"), digest_size=16).hexdigest()


def counted(keys: Iterable[tuple[str, str]]) -> Iterator[str]:
    """The fingerprints of findings in their order; each is given as its file and its key."""
    times: Counter[tuple[str, str]] = Counter()
    for each in keys:
        times[each] += 1
        yield f"{each[1]}:{times[each]}"
