"""The words of sheets, tables and protocols in Russian and English; the names of links and of units."""

from __future__ import annotations

from graphic_tmm.language.captions.english import ENGLISH
from graphic_tmm.language.captions.russian import RUSSIAN

CAPTIONS = {"ru": RUSSIAN, "en": ENGLISH}
LINK_NAMES = {
    "ru": {
        "crank": "кривошип",
        "rocker": "коромысло",
        "slotted rocker": "кулиса",
        "coupler": "шатун",
        "slider": "ползун",
        "stone": "кулисный камень",
        "frame": "стойка",
        "link": "звено",
    },
    "en": {
        "crank": "crank",
        "rocker": "rocker",
        "slotted rocker": "slotted rocker",
        "coupler": "connecting rod",
        "slider": "slider",
        "stone": "sliding block",
        "frame": "frame",
        "link": "link",
    },
}
UNITS_RU = {
    "mm": "мм",
    "m": "м",
    "m/mm": "м/мм",
    "m/s": "м/с",
    "m/s²": "м/с²",
    "(m/s)/mm": "(м/с)/мм",
    "(m/s²)/mm": "(м/с²)/мм",
    "s": "с",
    "rad": "рад",
    "s/mm": "с/мм",
    "Pa/mm": "Па/мм",
    "Pa": "Па",
    "N": "Н",
    "N/mm": "Н/мм",
    "kgf": "кгс",
    "°/mm": "°/мм",
    "(1/m)/mm": "(1/м)/мм",
    "1/m": "1/м",
    "m/rad": "м/рад",
    "1/mm": "1/мм",
    "(1/s)/mm": "(1/с)/мм",
    "kgf·m": "кгс·м",
    "kgf/mm": "кгс/мм",
    "(kgf·m)/mm": "(кгс·м)/мм",
    "N/kgf": "Н/кгс",
    "N·mm": "Н·мм",
    "N·m": "Н·м",
    "(N·m)/mm": "(Н·м)/мм",
    "J": "Дж",
    "J/mm": "Дж/мм",
    "kg": "кг",
    "kg·m²": "кг·м²",
    "(kg·m²)/mm": "(кг·м²)/мм",
    "kg/m³": "кг/м³",
    "mm²": "мм²",
    "m²": "м²",
    "rad/mm": "рад/мм",
    "%": "%",
    "1/s": "1/с",
    "1/s²": "1/с²",
    "°": "°",
    "": "",
}
