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


def digest(*parts: str | bytes) -> str:
    """Texts and bytes as 32 hexadecimal digits. Only the last of them may hold a NUL, or one text would be taken for two."""
    data = (part if isinstance(part, bytes) else part.encode("utf-8", "surrogatepass") for part in parts)
    return blake2b(b"\0".join(data), digest_size=16).hexdigest()


def counted(keys: Iterable[tuple[str, str]]) -> Iterator[str]:
    """The fingerprints of findings in their order; each is given as its file and its key."""
    times: Counter[tuple[str, str]] = Counter()
    for each in keys:
        times[each] += 1
        yield f"{each[1]}:{times[each]}"
