"""What the site itself says, in both languages; all else it takes from the package and its documents."""

from __future__ import annotations

from typing import Literal, get_args

Language = Literal["en", "ru"]
LANGUAGES: tuple[Language, ...] = get_args(Language)
NAMES = {"en": "English", "ru": "Русский"}

WORDS: dict[str, dict[Language, str]] = {
    "home": {"en": "Home", "ru": "Начало"},
    "guides": {"en": "Guides", "ru": "Руководства"},
    "theory": {"en": "Theory", "ru": "Теория"},
    "keys": {"en": "Keys of a scene", "ru": "Ключи задания"},
    "commands": {"en": "Commands", "ru": "Команды"},
    "python": {"en": "In Python", "ru": "Python"},
    "gallery": {"en": "Gallery", "ru": "Галерея"},
    "project": {"en": "Project", "ru": ""},
    "worked": {"en": "Worked: {}", "ru": "Пример: {}"},
    "keys of it": {"en": "Keys", "ru": "Ключи"},
    "shown by": {"en": "Scenes that show it", "ru": "Где это начерчено"},
    "chapters of it": {"en": "Chapters", "ru": "Главы"},
    "scene": {"en": "The scene", "ru": "Задание"},
    "builds on": {"en": "Builds on", "ru": "Опирается на главы"},
    "option": {"en": "Option", "ru": "Параметр"},
    "what for": {"en": "What for", "ru": "Назначение"},
    "chapter": {"en": "Chapter", "ru": "Глава"},
    "draw it": {"en": "Draw it:", "ru": "Вычертить:"},
    "draws": {"en": "Draws", "ru": "Чертит"},
    "sources": {"en": "Sources", "ru": "Источники"},
    "each chapter": {
        "en": "Each chapter of the book: its theory and sources, a worked example with its figures, its keys.",
        "ru": "Каждая глава: теория и источники, пример с чертежами и вычислениями, ключи задания.",
    },
    "a scene each": {
        "en": "",
        "ru": "Задания, которые идут вместе с программой, и листы, вычерченные по ним.",
    },
    "names": {"en": "", "ru": "Имена"},
    "in English": {
        "en": "",
        "ru": "Справка по каждому имени, взятая из самой программы, — по-английски.",
    },
    "more": {
        "en": "",
        "ru": "Проверка чертежей, устройство программы (по-английски)",
    },
    "whole note": {"en": "The whole note of this scene", "ru": "Вся записка этого задания"},
}


def word(name: str, language: Language) -> str:
    """Return a word of the site."""
    return WORDS[name][language]
