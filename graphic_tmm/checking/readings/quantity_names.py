"""Names of quantities as textbooks write them otherwise: a^n_BA, aτBA, a_кор, v_AB for v_BA, F_и2, R_43."""

from __future__ import annotations

import re
from collections.abc import Iterator

_COMPONENTS = {**dict.fromkeys("nн", "n"), **dict.fromkeys("tτт", "t"), **dict.fromkeys("rр", "r")}
_COMPONENTS |= dict.fromkeys(("k", "к", "кор", "cor", "c"), "k")
_POINTS = r"(?:[A-ZА-Я]\d*′*)"
_FRONT = re.compile(rf"([av])({'|'.join(_COMPONENTS)})({_POINTS}+)")
_BACK = re.compile(rf"([av])({_POINTS}+)({'|'.join(_COMPONENTS)})")
_PAIR = re.compile(rf"([vVa])({_POINTS})({_POINTS})([ntrk]?)")
_INERTIA = re.compile(r"[FФ](?:и|i|ин|in)(\d.*)")
_REACTION = re.compile(r"([RFNQ])(\d)(\d)(.*)")
_CORIOLIS = re.compile(rf"a({'|'.join(c for c, to in _COMPONENTS.items() if to == 'k')})")
_BETWEEN = re.compile(r"([^\W\d_]\d*′*)-([^\W\d_]\d*′*)")


def respelt(word: str) -> Iterator[str]:
    """Yield other spellings of the same name; ``word``: without spaces and what sets an index.

    >>> list(respelt("anDC")), list(respelt("aτDC")), list(respelt("p-d")), list(respelt("Fи2"))
    (['aDCn'], ['aDCt'], ['pd'], ['Pи2'])
    >>> list(respelt("vτNG"))
    ['vNGt']
    """
    if found := _FRONT.fullmatch(word):
        yield f"{found[1]}{found[3]}{_COMPONENTS[found[2]]}"
    elif (found := _BACK.fullmatch(word)) and found[3] != _COMPONENTS[found[3]]:
        yield f"{found[1]}{found[2]}{_COMPONENTS[found[3]]}"
    if found := _BETWEEN.fullmatch(word):
        yield found[1] + found[2]
    if len(word) > 2 and word[0] == word[-1] == "|":
        yield word[1:-1]
    if found := _INERTIA.fullmatch(word):
        yield f"Pи{found[1]}"


def turned_round(word: str) -> Iterator[str]:
    """Yield the name of what is as long and goes the other way: v_AB of v_BA, R_43 of R_34.

    >>> list(turned_round("VCD")), list(turned_round("aCDn")), list(turned_round("R43"))
    (['VDC'], ['aDCn'], ['R34'])
    """
    for one in (word, *respelt(word)):
        if found := _PAIR.fullmatch(one):
            yield f"{found[1]}{found[3]}{found[2]}{found[4]}"
        if found := _REACTION.fullmatch(one):
            yield f"{found[1]}{found[3]}{found[2]}{found[4]}"


def is_coriolis(word: str) -> bool:
    """Whether a name is of the Coriolis acceleration of whatever points: a_к, a_кор."""
    return _CORIOLIS.fullmatch(word) is not None
