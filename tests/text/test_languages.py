"""An app in another language: pages, stops and tasks contain no English text, and use the decimal mark."""

import json
import os
import re
import subprocess
import sys

from ramanujan.shell.menu import PAGES
from ramanujan.text.catalogue import COMPLETE
from tests.catalogue import strings, template, texts, translated
from tests.checks.browser import ROOT

ENGLISH = re.compile(r"\b(the|of|and|with|are|this|from|to|not|has|it|which)\b", re.IGNORECASE)
"""Words of English sentences that do not occur in other languages."""
POINT = re.compile(r"(?<![\w./×-])\d+\.\d+(?![\w./])")
PLACES = [
    *((name, {}) for name in PAGES),
    ("lesson", {"stop": "steps", "chosen": "steps.euler"}),
    ("lesson", {"part": "tasks"}),
    ("lesson", {"part": "notes"}),
]
SENT = """
import json, sys
from ramanujan import lesson
from tests.checks.scenes import opened, sent
texts = [sent(opened(name, address)) for name, address in json.loads(sys.argv[1])]
texts += [
    json.dumps([stop.heading, stop.question, *stop.hints, *stop.options.values(), stop.explanation(), stop.onward.label,
                *(stop.reply(option) for option in stop.options if option != stop.answer())])
    for stop in lesson.STOPS
]
texts += [json.dumps([task.heading, task.text, *task.hints]) for task in lesson.TASKS]
print(json.dumps(texts))
"""
"""Prints the messages of some pages, and the texts of all stops and tasks."""


def sent_texts(language: str) -> set[str]:
    """Return all strings in the messages of an app in this language."""
    command = [sys.executable, "-c", SENT, json.dumps(PLACES)]
    environment = os.environ | {"RAMANUJAN_LANGUAGE": language}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=300, check=True)
    return {text for page in json.loads(done.stdout) for line in page.splitlines() for text in inside(json.loads(line))}


def inside(value: object) -> set[str]:
    """Return the strings of a value, also of JSON in a string."""
    if isinstance(value, dict | list):
        return {text for each in (value.values() if isinstance(value, dict) else value) for text in inside(each)}
    if isinstance(value, str) and value[:1] in ("{", "["):
        try:
            return inside(json.loads(value))
        except ValueError:
            pass
    return {value} if isinstance(value, str) else set()


def test_no_text_of_a_german_app_is_english():
    """One language suffices: a text without gettext is English in all. test_words checks the catalogues."""
    language = COMPLETE[0]
    messages = [each for each in translated(language) if each.id]
    english = {text for message in messages for text in texts(message)} - {
        text for message in messages for text in strings(message)
    }
    sent = sent_texts(language)
    # Keys of values are words without a capital; an array's bytes have no spaces.
    labels = {text for text in sent & english if not text.islower() or " " in text}
    assert sorted({text for text in sent if " " in text and ENGLISH.search(text)} | labels) == []
    # A text that is only a number is for a program.
    assert sorted(text for text in sent if POINT.search(text) and not text.replace(".", "").isdecimal()) == []
    assert sum(bool(re.search(r"\d,\d", text)) for text in sent) > 30


def test_negative_control_an_english_sentence_is_detected():
    long = [text for message in template() if message.id for text in texts(message) if len(text.split()) > 7]
    assert sum(bool(ENGLISH.search(text)) for text in long) > 0.95 * len(long) > 500
