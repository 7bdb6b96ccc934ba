"""A class marked: from a folder of hand-ins to a row and a mark of each, and what only all of them tell.

How large the plans of a variant are drawn decides what is due in mm. A composition that stands beside the scene
holds for all its variants (one beside a variant's own scene goes before it), and nothing is searched; without
one scale factors are searched for each variant, as `check` does of its scene alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.checking.photo.picture import PHOTOGRAPH
from graphic_tmm.checking.readings.csv_cells import READINGS
from graphic_tmm.classroom.batch.record import digest_of
from graphic_tmm.classroom.batch.run import USUAL, Ran, run
from graphic_tmm.classroom.batch.work import Work
from graphic_tmm.classroom.marks import judging
from graphic_tmm.classroom.marks.copies import Alike, Other, alike, copied, is_suspect, looks_like
from graphic_tmm.classroom.marks.judging import (
    ROWS,
    By,
    Given,
    Task,
    scene_of,
    work,
)
from graphic_tmm.classroom.marks.names import HandIn, Skipped, hand_ins
from graphic_tmm.classroom.marks.row import Row, faults, known, plans_due, plans_of
from graphic_tmm.classroom.marks.rule import Mark, Rule, marked
from graphic_tmm.classroom.variants.start import nearby_composition, start_of
from graphic_tmm.classroom.variants.variant import Base, Variant, source_of, text_of
from graphic_tmm.classroom.variants.variant import scene_of as variant_of
from graphic_tmm.errors import SceneError, SheetError, TmmError, printable
from graphic_tmm.files import read
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

Tell = Callable[[int, int, str], None]


class Table(NamedTuple):
    """A table of variants: its file, the variants in their order."""

    file: Path
    variants: tuple[Variant, ...]


class Class(NamedTuple):
    """What is to be marked: the folder of a class, its scene, its table of variants if it has one; by what.

    ``language``: that is asked for, "" for the scene's. ``where``, ``limit``: as for `batch.run.run`; of
    processes what is only one piece of work needs none, unless a limit is asked for.
    """

    folder: Path
    base: Base
    table: Table | None
    rule: Rule
    by: By = By()
    language: str = ""
    where: int | str = 0
    limit: float | None = None


class Entry(NamedTuple):
    """A hand-in that could be read: its row, its mark, the variant that it looks like if not its own."""

    hand_in: HandIn
    row: Row
    mark: Mark
    other: Other | None


class Marked(NamedTuple):
    """A class: the scene's title, its entries, those that are alike, what was skipped; the plans asked for."""

    title: str
    language: str
    rule: Rule
    plans: tuple[str, ...]
    entries: tuple[Entry, ...]
    pairs: tuple[Alike, ...]
    skipped: tuple[Skipped, ...]


def mark_class(of: Class, out: Path, tell: Tell = lambda done, count, name: None) -> Marked:
    """Mark a class; reports and rows are written into a folder, and kept there while nothing changes.

    Raises
    ------
    TmmError
        If the scene or a variant that is handed in is not good, there is no folder or nothing in it, the rule
        names a plan that the scene does not have, or the folder cannot be written into.
    """
    scene = _scene(of)
    names = None if of.table is None else [one.name for one in of.table.variants]
    found, skipped = hand_ins(of.folder, names)
    if not found and not skipped:
        says = said(
            "--class: {folder}: nothing was handed in here; put files of readings into it, named by variant "
            "and student",
            folder=printable(str(of.folder)),
        )
        raise SheetError(says)
    if of.rule.plans:
        of = of._replace(rule=_with_plans(of.rule, scene))
    tasks = _tasks(of, {one.variant for one in found})
    works, lost = [], dict[str, str]()
    for one in found:
        try:
            works.append(work(_given(one, tasks[one.variant], of)))
        except TmmError as error:
            lost[one.file] = error.in_language(speaking(scene.language))
    rows = _done(of, works, out, tell)
    rows |= {name: Row(skipped=why) for name, why in lost.items()}
    return _marked(of, scene, found, rows, skipped, out, tell)


def _marked(
    of: Class,
    scene: Scene,
    found: Sequence[HandIn],
    rows: Mapping[str, Row],
    skipped: Sequence[Skipped],
    out: Path,
    tell: Tell,
) -> Marked:
    speech = speaking(scene.language)
    good = [one for one in found if not rows[one.file].skipped]
    bad = [Skipped(one.name, rows[one.file].skipped) for one in found if one not in good]
    others = _other_variants(of, good, rows, out, tell)
    entries = tuple(
        Entry(one, row, marked(of.rule, lost._replace(other=other is not None)), other)
        for one in good
        for row in (rows[one.file],)
        for lost, other in ((faults(of.rule, row), others.get(one.file)),)
    )
    plans = tuple(one.plan for one in plans_due(of.rule, entries[0].row)) if entries else ()
    pairs = alike([one.row for one in entries])
    entries = _with_copied(entries, pairs)
    told = tuple(sorted([*bad, *(Skipped(one.name, speech(one.why)) for one in skipped)]))
    return Marked(scene.title, scene.language, of.rule, plans, entries, pairs, told)


def _with_copied(entries: Sequence[Entry], pairs: Sequence[Alike]) -> tuple[Entry, ...]:
    """Return entries, those that are alike one of another variant, and nearer to that, with it.

    No mark hangs on that.
    """
    found = list(entries)
    for pair in pairs:
        for k, j in ((pair.one, pair.other), (pair.other, pair.one)):
            own, other = entries[k], entries[j]
            variant = other.hand_in.variant
            if variant != own.hand_in.variant and found[k].other is None:
                found[k] = own._replace(other=copied(own.row, variant, other.row.dues))
    return tuple(found)


def _scene(of: Class) -> Scene:
    """Return the scene of a class, by which its plans and its language are known."""
    return scene_of(Task(of.base.text, str(of.base.file), of.language))


def _tasks(of: Class, wanted: set[str]) -> dict[str, Task]:
    """Return the tasks of variants by name; "" for the scene itself. A bad one is told at its line."""
    own = Task(of.base.text, str(of.base.file), of.language, nearby_composition(str(of.base.file)))
    if of.table is None:
        return {"": own}
    made, begun = {}, _begun(of, own)
    for one in of.table.variants:
        if one.name in wanted:
            made[one.name] = _task(of, one, begun)
            try:
                scene_of(made[one.name])
            except SceneError:
                variant_of(of.base, one, str(of.table.file))  # tells it where its author wrote it
                raise
    return made


def _begun(of: Class, own: Task) -> Task:
    """Return the task with which the variants of a class begin: keys are composed so, too."""
    return own._replace(composition=start_of(of.base), lent=True)


def _task(of: Class, variant: Variant, begun: Task) -> Task:
    """Return the task of a variant; what stands beside its own scene goes before what it begins with."""
    assert of.table is not None
    source = str(source_of(of.base, variant))
    task = begun._replace(text=text_of(of.base, variant, str(of.table.file)), source=source)
    composition = nearby_composition(source)
    return task._replace(composition=composition, lent=False) if composition else task


def _given(one: HandIn, task: Task, of: Class) -> Given:
    """Return what the judgement of a hand-in hangs on; raises SceneError if a file cannot be read."""
    tables = tuple(
        (path.relative_to(of.folder).as_posix(), read(path, READINGS)) for path in one.tables
    )
    photographs = tuple(
        (str(path), sheet, digest_of(read(path, PHOTOGRAPH)))
        for path, sheet in (one.photographs if not tables else ())
    )
    return Given(one.file, task, of.by, tables, photographs)


def _run(of: Class, works: Sequence[Work], out: Path, tell: Tell) -> Ran:
    """Do works; one alone is done in this process if that is as good."""
    here = len(works) < 2 and not isinstance(of.where, str) and of.limit is None
    limit = USUAL if of.limit is None else of.limit
    return run(works, out, executor=0 if here else of.where, limit=limit, tell=tell)


def _done(of: Class, works: Sequence[Work], out: Path, tell: Tell) -> dict[str, Row]:
    """Return the rows of works by their names."""
    ran = _run(of, works, out, tell)
    found = dict[str, Row]()
    for one in works:
        file, failed = out / ROWS / f"{one.name}.json", ran.failed.get(one.name)
        found[one.name] = Row(skipped=failed) if failed else known(file.read_bytes())
    return found


def _other_variants(
    of: Class, good: Sequence[HandIn], rows: Mapping[str, Row], out: Path, tell: Tell
) -> dict[str, Other]:
    """Return, by their names, the hand-ins that look like another variant of the table."""
    suspects = [one for one in good if is_suspect(rows[one.file])]
    if of.table is None or not suspects:
        return {}
    dues = {one.variant: rows[one.file].dues for one in good}
    missing = [one for one in of.table.variants if one.name not in dues]
    begun = _begun(of, _tasks(of._replace(table=None), set())[""])
    tried = []
    for one in missing:
        try:
            tried.append(judging.work_of_dues(one.name, _task(of, one, begun)))
        except SceneError:
            continue  # of a variant that is not good nobody can have drawn anything
    _run(of, tried, out, tell)
    for name, _ in (one.given for one in tried):
        dues[name] = known((out / judging.place(name)).read_bytes()).dues
    found = {}
    for suspect in suspects:
        rest = {name: one for name, one in dues.items() if name != suspect.variant}
        if (other := looks_like(rows[suspect.file], rest)) is not None:
            found[suspect.file] = other
    return found


def _with_plans(rule: Rule, scene: Scene) -> Rule:
    """Return a rule with its plans called as the scene calls them; refused before anything is judged."""
    known = plans_of(make(scene, exact=True))
    names = {name.casefold(): name for name in known}
    for tongue in ("en", scene.language):
        names |= {captions(tongue)[name].casefold(): name for name in known}
    strange = [plan for plan in rule.plans if plan.casefold() not in names]
    if strange:
        says = said(
            '--marks: there is no plan "{plan}"; there are {known}',
            plan=printable(strange[0])[:30],
            known=", ".join(sorted(known)),
        )
        raise SheetError(says)
    plans = dict.fromkeys(names[plan.casefold()] for plan in rule.plans)
    return rule._replace(plans=tuple(plans))
