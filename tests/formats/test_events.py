"""Events as lines of JSON: what is read, what is refused and where."""

import pytest

from deburr.formats.events import read


def test_an_event_with_its_places() -> None:
    (event, other), faults = read('{"section": "LINE", "set": {"MOV": 1, "S1": "two"}}\n\n{"set": {}}')
    assert not faults
    assert (event.line, event.section, event.span) == (0, "LINE", (12, 18))
    assert [given[:2] for given in event.values] == [("MOV", 1.0), ("S1", "two")]
    assert [(given.span, given.value_span) for given in event.values] == [((28, 33), (35, 36)), ((38, 42), (44, 49))]
    assert (other.line, other.section, other.values) == (2, "", ())


@pytest.mark.parametrize(
    ("line", "cols", "said"),
    [
        ('{"section": "LINE"', (17, 18), "no JSON object"),
        ("LINE", (0, 1), "no JSON object"),
        ('["LINE"]', (0, 8), "no JSON object"),
        ('{"section": 1}', (12, 13), "`section` takes"),
        ('{"section": ""}', (12, 14), "`section` takes"),
        ('{"sections": "LINE"}', (1, 11), "did you mean `section`?"),
        ('{"set": ["XPOS"]}', (8, 9), "`set` takes"),
        ('{"set": {"XPOS": null}}', (17, 21), "a number or a text"),
        ('{"set": {"XPOS": true}}', (17, 21), "a number or a text"),
        ('{"set": {"XPOS": NaN}}', (17, 20), "a number or a text"),
        ('{"set": {"XPOS": 1, "XPOS": 2}}', (20, 26), "twice"),
        ('{"set": {"XPOS": 1' + "0" * 400 + "}}", (17, 418), "a number or a text"),
        ('{"a":' * 3000, (0, 15000), "no JSON object"),
    ],
)
def test_faults(line: str, cols: tuple[int, int], said: str) -> None:
    events, (fault,) = read(f"\n{line}")
    assert not events
    assert (fault.line, fault.span) == (1, cols)
    assert said in fault.message
