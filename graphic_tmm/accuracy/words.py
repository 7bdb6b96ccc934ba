"""The words of the study of accuracy, in Russian and English."""

from __future__ import annotations

WORDS: dict[str, dict[str, str]] = {
    "en": {
        "title": "{title}. What accuracy costs",
        "measure": "Error in % of the largest value that nine readings of ten keep within "
        "({trials} drawings by each hand that slips); work of that quantity at all positions.",
        "error": "error, %",
        "axis": "varied",
        "value": "value",
        "positions": "positions",
        "parts": "parts of a phase",
        "steps": "rolling steps",
        "slip": "single slip of the student",
        "ruler": "ruler, mm",
        "size": "drawing, times as large",
        "method": "differentiation",
        "start": "taken from the plans",
        "pole": "pole distance H, times",
        "passes": "passes of friction",
        "rod": "mass of the rod",
        "inertia": "inertia force",
        "trials": "drawings by the student",
        "others": "One thing varied about the scene's own setting ({hand}); in brackets minutes "
        "where the work changes",
        "exact": "exact",
        "cad": "CAD",
        "careful": "careful",
        "student": "student",
        "scene": "as in the scene",
        "prick": "prick",
        "compass": "compass",
        "swing": "square and protractor",
        "reading": "reading",
        "digits": "digits",
        "chords": "chords",
        "tangents": "tangents",
        "displacement": "displacement",
        "velocity": "velocity",
        "lever rule": "by the lever rule",
        "plan": "plan of accelerations",
        "series": "series of two terms",
        "minutes": "min",
        "milliseconds": "ms",
        "quartiles": "ms (quartiles)",
        "board": "work at the board, minutes",
        "machine": "time on the machine, milliseconds",
        "front": "Pareto front of a hand",
        "other": "one thing varied",
        "count": "number of positions (parts, steps)",
        "quantity": "quantity",
        "step": "step",
        "share": "share",
        "shares": "Share of the variance per step, student, {count} positions",
        "step of": "{view}, step {number}: {text}",
        "slope": "{quantity}: with the exact hand the error falls as N^{error} ± {width}, the work "
        "grows as N^{minutes}.",
        "slope timed": "{quantity}: with the exact hand the error falls as N^{error} ± {width}, "
        "the work grows as N^{minutes}, the time on the machine as N^{seconds}.",
        "optimum": "{quantity}, {hand}: least with {best} ({error} %), as good from {low} to "
        "{high}.",
        "optimum sure": "{quantity}, {hand}: least with {best} ({error} %).",
        "optimum edge": "{quantity}, {hand}: least at the end of what was tried, {best} ({error} "
        "%).",
        "optimum flat": "{quantity}, {hand}: about {error} % at any number.",
        "advice": "{best}, {hand}: {quantity} to {error} %; {finer} cost {times} times the work "
        "and give {other} %.",
        "advice flat": "{quantity}, {hand}: to {error} % with any number of {unit}; {finer} "
        "instead of {number} only cost {times} times the work.",
        "advice last": "{best}, {hand}: {quantity} to {error} %, the more the better: {finer} take "
        "{times} of the work and give {other} %.",
        "most": "{quantity}: most of the student's error comes from {step} ({share} % of the "
        "variance).",
        "slopes": "Slopes",
        "optima": "Best numbers",
        "advices": "Advice",
        "left out": "Not drawn: {text}",
        "unit positions": "position|positions|positions",
        "unit parts": "part|parts|parts",
        "unit steps": "step|steps|steps",
        "v": "v by plans",
        "a": "a by plans",
        "V_diagram": "V by diagram",
        "a_diagram": "a by diagram",
        "P_bal": "P_bal",
        "M_bal": "M_bal",
        "M_engine": "M of the engine",
        "J_fly": "J of the flywheel",
        "J_fly_energy_mass": "J, energy–mass",
        "r0_min": "r₀ min of the cam",
        "contact_ratio": "contact ratio, line",
        "contact_arc": "contact ratio, arc",
        "budget": "budget {percent} %: {setting}; {minutes} min at the board; {errors}",
        "budget size": "{times} times as large",
        "budget pole": "H {times} times as far",
        "budget none": "--budget {percent} %: no setting keeps within it; the best found: "
        "{setting}; {errors}. Allow more, or let a better hand draw (--hand)",
        "advice same": "{quantity}, {hand}: to {error} % with any number of {unit}.",
        "slope flat": "{quantity}: with the exact hand the error is the same at any number "
        "(N^{error}), the work grows as N^{minutes}.",
    },
    "ru": {
        "title": "{title}. Чего стоит точность",
        "measure": "Погрешность в % наибольшего значения, в которую укладываются девять отсчётов "
        "из десяти ({trials} чертежей каждой неточной рукой); работа — на эту величину во всех "
        "положениях.",
        "error": "погрешность, %",
        "axis": "меняется",
        "value": "значение",
        "positions": "положений",
        "parts": "частей фазы",
        "steps": "шагов обкатки",
        "slip": "одна из погрешностей студента",
        "ruler": "линейка, мм",
        "size": "чертёж крупнее, раз",
        "method": "дифференцирование",
        "start": "взято с планов",
        "pole": "полюсное расстояние H, раз",
        "passes": "проходов трения",
        "rod": "масса шатуна",
        "inertia": "сила инерции",
        "trials": "чертежей студента",
        "others": "Меняется что-то одно относительно задания ({hand}); в скобках минуты, если "
        "работа меняется",
        "exact": "точная",
        "cad": "САПР",
        "careful": "аккуратный",
        "student": "студент",
        "scene": "как в задании",
        "prick": "укол",
        "compass": "циркуль",
        "swing": "угольник и транспортир",
        "reading": "отсчёт",
        "digits": "цифры",
        "chords": "хорды",
        "tangents": "касательные",
        "displacement": "перемещение",
        "velocity": "скорость",
        "lever rule": "по правилу рычага",
        "plan": "план ускорений",
        "series": "ряд из двух членов",
        "minutes": "мин",
        "milliseconds": "мс",
        "quartiles": "мс (квартили)",
        "board": "работа за доской, мин",
        "machine": "время на машине, мс",
        "front": "граница Парето для руки",
        "other": "изменено что-то одно",
        "count": "число положений (частей, шагов)",
        "quantity": "величина",
        "step": "шаг",
        "share": "доля",
        "shares": "Доля дисперсии по шагам, студент, положений: {count}",
        "step of": "{view}, шаг {number}: {text}",
        "slope": "{quantity}: при точной руке погрешность убывает как N^{error} ± {width}, работа "
        "растёт как N^{minutes}.",
        "slope timed": "{quantity}: при точной руке погрешность убывает как N^{error} ± {width}, "
        "работа растёт как N^{minutes}, время на машине — как N^{seconds}.",
        "optimum": "{quantity}, {hand}: наименьшая — {best} ({error} %), не хуже от {low} до "
        "{high}.",
        "optimum sure": "{quantity}, {hand}: наименьшая — {best} ({error} %).",
        "optimum edge": "{quantity}, {hand}: наименьшая на краю испытанного — {best} ({error} %).",
        "optimum flat": "{quantity}, {hand}: около {error} % при любом числе.",
        "advice": "{best}, {hand}: {quantity} до {error} %; {finer} — работы в {times} раза "
        "больше, а погрешность {other} %.",
        "advice flat": "{quantity}, {hand}: до {error} % при любом числе {unit}; {finer} вместо "
        "{number} — лишь работы в {times} раза больше.",
        "advice last": "{best}, {hand}: {quantity} до {error} %, чем больше, тем лучше: {finer} — "
        "{times} той же работы и {other} %.",
        "most": "{quantity}: больше всего погрешности студента даёт {step} ({share} % дисперсии).",
        "slopes": "Наклоны",
        "optima": "Наилучшее число",
        "advices": "Советы",
        "left out": "Не построено: {text}",
        "unit positions": "положение|положения|положений",
        "unit parts": "часть|части|частей",
        "unit steps": "шаг|шага|шагов",
        "v": "v по планам",
        "a": "a по планам",
        "V_diagram": "V по диаграмме",
        "a_diagram": "a по диаграмме",
        "P_bal": "P_ур",
        "M_bal": "M_ур",
        "M_engine": "M двигателя",
        "J_fly": "J маховика",
        "J_fly_energy_mass": "J, энергомасса",
        "r0_min": "r₀ min кулачка",
        "contact_ratio": "ε_α по линии",
        "contact_arc": "ε_α по дуге",
        "budget": "допуск {percent} %: {setting}; за доской {minutes} мин; {errors}",
        "budget size": "крупнее в {times} раза",
        "budget pole": "H дальше в {times} раза",
        "budget none": "--budget {percent} %: ни одна постановка не укладывается; лучшая из "
        "найденных: {setting}; {errors}. Допустите больше или доверьте чертёж лучшей руке "
        "(--hand)",
        "advice same": "{quantity}, {hand}: до {error} % при любом числе {unit}.",
        "slope flat": "{quantity}: при точной руке погрешность от числа не зависит (N^{error}), "
        "работа растёт как N^{minutes}.",
    },
}


def counted(number: int, axis: str, language: str) -> str:
    """Return a number of positions, parts or steps with its noun.

    >>> counted(24, "positions", "ru"), counted(1, "steps", "en")
    ('24 положения', '1 step')
    """
    one, few, many = WORDS[language][f"unit {axis}"].split("|")
    if language == "ru":
        teens = 11 <= number % 100 <= 14
        last = 0 if teens else number % 10
        form = one if last == 1 else few if 2 <= last <= 4 else many
    else:
        form = one if number == 1 else many
    return f"{number} {form}"
