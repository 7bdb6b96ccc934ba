"""What effects cost and change, for a terminal and for machines: sentences first, then two tables."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator
from typing import Any

from graphic_tmm.accuracy.answer_text import busy
from graphic_tmm.accuracy.effects.effect_study import Change, EffectStudy, Hidden, Weighed
from graphic_tmm.accuracy.measure import NOISE
from graphic_tmm.accuracy.report_json import figure
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.readers.text import Framed
from graphic_tmm.scene.packaged import scene_name


def effects_text(study: EffectStudy, width: int) -> list[Any]:
    """Return what is printed of the effects of a scene, lines of so many characters."""
    from textwrap import fill

    from rich.text import Text

    _ = speaking(study.scene.language)
    heading = _("{title}. What its effects cost and change", title=study.scene.title)
    made: list[Any] = [Text(fill(heading, width), style="bold")]
    made += [Text(fill(line, width)) for line in sentences(study)]
    if study.effects:
        made.append(_costs(study))
        made += [Text(fill(line, width)) for line in _columns(study)]
    if any(effect.changes for effect in study.effects):
        made.append(_changes(study))
        made += [Text(fill(line, width)) for line in _letters(study)]
    return made


def sentences(study: EffectStudy) -> Iterator[str]:
    """Yield the answer: the effect that matters most, those not worth drawing, those not called for."""
    _ = speaking(study.scene.language)
    there = [one for one in study.effects if one.called and not one.refused]
    most = max((one for one in there if one.changes), key=lambda one: one.percent, default=None)
    if not study.effects:
        yield _("The scene calls for no effect that it could do without: nothing to leave out.")
    elif most is None:
        yield _("The scene calls for no effect that changes anything.")
    else:
        change = max(most.changes, key=lambda one: one.percent)
        yield _(
            "Most matters: {effect}. Without it {result} changes by up to {percent} % of the largest{place}.",
            effect=_(most.name),
            result=_result(study, change),
            percent=number(change.percent, study.scene.language, 2),
            place=_place(study, change),
        )
    yield from _needless(study, there)
    if idle := [_(one.name) for one in study.effects if not one.called]:
        yield _(
            "Not called for, so no step is recorded, drawn or computed: {effects}.",
            effects=", ".join(idle),
        )
    for one in study.effects:
        if one.refused:
            yield _(
                "{effect}: cannot be left out: {reason}.", effect=_(one.name), reason=_(one.refused)
            )


def _needless(study: EffectStudy, there: Iterable[Weighed]) -> Iterator[str]:
    """Yield what is not worth drawing by the hand that draws, and by a student's."""
    _ = speaking(study.scene.language)
    small = [one for one in there if not one.worth]
    faint = [one for one in there if one.worth and not one.worth_pencil]
    if small:
        yield _(
            "Not worth drawing, as it changes nothing above the drawing's own error: {effects}.",
            effects="; ".join(_detail(study, one, pencil=False) for one in small),
        )
        yield from _hidden(study, study.hidden, pencil=False)
    elif there:
        yield _("Each effect changes something by more than the drawing's own error.")
    if faint:
        yield _(
            "That is by a hand without slips. A student's slips hide also: {effects}.",
            effects="; ".join(_detail(study, one, pencil=True) for one in faint),
        )
        yield from _hidden(study, study.hidden_by_pencil, pencil=True)


def _hidden(study: EffectStudy, several: Hidden | None, *, pencil: bool) -> Iterator[str]:
    """Yield which of the effects that are not worth drawing can be left out together."""
    _ = speaking(study.scene.language)
    if several is None:
        return
    if len(several.names) < 2:
        yield _("Leave out one of them only: together they are seen.")
        return
    form = said("Nor are they seen all together ({change}; {minutes} min).")
    if not several.all:
        form = said("Together leave out only: {effects} ({change}; {minutes} min).")
    one = several.weighed
    yield _(
        form,
        effects=", ".join(map(_, several.names)),
        change=_change_of(study, one, pencil=pencil) if one.changes else _("no change"),
        minutes=fixed(one.cost.minutes, 0, study.scene.language),
    )


def _detail(study: EffectStudy, effect: Weighed, *, pencil: bool) -> str:
    """Return an effect with the change that comes nearest to being seen, and what leaving it out saves."""
    _ = speaking(study.scene.language)
    minutes = fixed(effect.cost.minutes, 0, study.scene.language)
    told = _change_of(study, effect, pencil=pencil) if effect.changes else _("no change")
    return _(
        "{effect} ({change}; {minutes} min)", effect=_(effect.name), change=told, minutes=minutes
    )


def _change_of(study: EffectStudy, effect: Weighed, *, pencil: bool) -> str:
    """Return the change that stands out most of the error: the result, how much, the error."""
    language = study.scene.language

    def error(one: Change) -> float:
        return one.pencil if pencil and one.pencil is not None else one.error

    change = max(effect.changes, key=lambda one: one.percent / max(error(one), NOISE))
    _ = speaking(language)
    return _(
        "{result} by {percent} %, error {error} %",
        result=_result(study, change),
        percent=number(change.percent, language, 2),
        error=number(error(change), language, 2),
    )


def _result(study: EffectStudy, change: Change) -> str:
    name = WORDS[study.scene.language][change.quantity]
    return f"{name} {change.segment}".rstrip()


def _place(study: EffectStudy, change: Change) -> str:
    _ = speaking(study.scene.language)
    return _(" (position {name})", name=change.position) if change.position else ""


def _costs(study: EffectStudy) -> Framed:
    """Return the table of what each effect costs."""
    language = study.scene.language
    _ = speaking(language)
    heads = [_("effect"), _("steps"), _("min")]
    whole = [_("all drawn"), f"{study.whole.steps}", fixed(study.whole.minutes, 0, language)]
    timed = study.whole.seconds is not None
    if study.whole.seconds is not None:
        heads.append(_("ms"))
        whole.append(_milliseconds(study, study.whole.seconds))
    rows = [[*heads, _("worth drawing")], [*whole, " "]]
    for one in study.effects:
        row = [_(one.name), f"{one.cost.steps}", fixed(one.cost.minutes, 0, language)]
        if timed:
            row.append(_milliseconds(study, one.cost.seconds, one.unsure))
        rows.append([*row, _verdict(study, one)])
    return Framed(_("What each effect costs"), rows)


def _milliseconds(study: EffectStudy, seconds: float | None, unsure: float = 0.0) -> str:
    if seconds is None:
        return "—"
    if seconds < unsure:
        return f"<{number(1e3 * unsure, study.scene.language, 1)}"
    return number(1e3 * seconds, study.scene.language, 2 if seconds > 1e-3 else 1)


def _verdict(study: EffectStudy, effect: Weighed) -> str:
    _ = speaking(study.scene.language)
    if effect.refused:
        return _("cannot be left out")
    if not effect.called:
        return _("not called for")
    if not effect.cost.steps:
        return _("adds no step")
    if not effect.worth:
        return _("no")
    return _("yes") if effect.worth_pencil else _("not by a student")


def _changes(study: EffectStudy) -> Framed:
    """Return the table of what each effect changes."""
    language = study.scene.language
    _ = speaking(language)
    heads = [_("without"), _("result"), "Δ, %", _("pos."), "E, %"]
    rows = [heads + (["Eₛ, %"] if study.pencil else [])]
    for effect in study.effects:
        for k, one in enumerate(effect.changes):
            row = [" " if k else _(effect.name), _result(study, one)]
            row += [number(one.percent, language, 2), one.position or "—"]
            row.append(number(one.error, language, 2))
            if study.pencil:
                row.append(number(math.nan if one.pencil is None else one.pencil, language, 2))
            rows.append(row)
    return Framed(_("What changes without it"), rows)


def _columns(study: EffectStudy) -> Iterator[str]:
    """Yield what the columns of the table of costs mean."""
    _ = speaking(study.scene.language)
    yield _(
        "steps, min, ms: what the log, the board and the machine (one run of the log, without drawing "
        "sheets) have more with the effect; each view counts at the positions that the scene draws."
    )
    if any(effect.name.startswith("masses") for effect in study.effects):
        yield _("masses of a link: its mass and moment of inertia, in all that they bring about.")
    if told := busy(study.load, study.scene.language):
        yield told


def _letters(study: EffectStudy) -> Iterator[str]:
    """Yield what the columns and letters of the table of changes mean."""
    _, words = speaking(study.scene.language), WORDS[study.scene.language]
    yield _(
        "Δ: the largest change without the effect alone, by the exact hand, in % of the largest value of the "
        "turn with everything; pos.: the position where it is. E: the error of the drawing itself ({hand}), "
        "which nine readings of ten keep within, in % of the same.",
        hand=words[study.hand],
    )
    if study.pencil:
        yield _("Eₛ: that of a student's drawing.")
    for name in study.names:
        key = f"letter {name}"
        if (meaning := words[key]) != key:
            yield f"{words[name]}: {meaning}."


def effects_json(study: EffectStudy) -> str:
    """Return the same as JSON text."""
    told = {
        "scene": scene_name(study.scene.source),
        "hand": study.hand,
        "trials": study.trials,
        "steps": study.whole.steps,
        "minutes": _figure(study.whole.minutes),
        "seconds": _figure(study.whole.seconds),
        "effects": [_effect(study, one) for one in study.effects],
        "unseen_together": _together(study, study.hidden),
        "unseen_together_student": _together(study, study.hidden_by_pencil),
        "sentences": list(sentences(study)),
    }
    return json.dumps(told, ensure_ascii=False, indent=1) + "\n"


def _together(study: EffectStudy, several: Hidden | None) -> dict[str, Any] | None:
    """Return what can be left out together without being seen."""
    if several is None:
        return None
    one = several.weighed
    return {
        "effects": list(map(str, several.names)),
        "steps": one.cost.steps,
        "minutes": _figure(one.cost.minutes),
        "changes": [_change(study, change) for change in one.changes],
    }


def _effect(study: EffectStudy, effect: Weighed) -> dict[str, Any]:
    found: dict[str, Any] = {
        "effect": str(effect.name),
        "called_for": effect.called,
        "steps": effect.cost.steps,
        "minutes": _figure(effect.cost.minutes),
        "seconds": _figure(effect.cost.seconds),
        "seconds_unsure": _figure(effect.unsure),
        "refused": str(effect.refused) or None,
        "worth_drawing": effect.worth,
        "changes": [_change(study, one) for one in effect.changes],
    }
    return found | ({"worth_drawing_by_student": effect.worth_pencil} if study.pencil else {})


def _change(study: EffectStudy, one: Change) -> dict[str, Any]:
    found: dict[str, Any] = {
        "quantity": one.quantity,
        "segment": one.segment or None,
        "position": one.position or None,
        "change_percent": _figure(one.percent),
        "error_percent": _figure(one.error),
        "above_error": one.seen,
    }
    if study.pencil:
        found["error_percent_student"] = _figure(one.pencil)
    return found


def _figure(value: float | None) -> float | None:
    return None if value is None else figure(value)
