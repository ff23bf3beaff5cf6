"""Response times and server load for a class that uses the app at the same time.

    python -m tests.benchmarks.classroom [--sessions 100] [--page oscillator | … | spread | every] [--seconds 30]
    python -m tests.benchmarks.classroom --processes 2
    python -m tests.benchmarks.classroom --measuring 1 --sessions 50
    python -m tests.benchmarks.classroom --looking 1 --sessions 50 --seconds 15
    python -m tests.benchmarks.classroom --voting 60 --browsers 8

Each session opens the page over a websocket like a browser, and sets the slider m to a random step about every two
seconds. A bare page with three sliders is measured in the same run, so that the ratios are meaningful on a busy
machine. The clients run on the same machine.

--processes    run the app behind the proxy, as in .deploy
--measuring    number of additional sessions that measure the diagram of the speed page; the duration and the longest
               delay of the others meanwhile are printed
--looking      number of additional sessions that open all pages once, without cached results
--voting       number of phones that vote once; the delays until the wall counts the votes are printed
--browsers     number of pages in real browsers, with --voting: the wall, and phones
"""

import argparse
import asyncio
import os
import random
import resource
import statistics
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter

from playwright.async_api import async_playwright

from ramanujan.classroom.rules import shared
from ramanujan.lesson import STOPS
from ramanujan.pages.classroom.phone import PHONE_INTERVAL
from ramanujan.shell.menu import PAGES as EVERY_PAGE
from tests.benchmarks.app import BARE
from tests.benchmarks.visitor import VisitError, Visitor
from tests.checks.browser import CHROMIUM, FLAGS, ROOT, running
from tests.checks.deployed import deployed

PAGES = {page.name: page.path for page in EVERY_PAGE.values()}
CHANGE_INTERVAL = 2.0
"""Average time between two changes of the slider in one session [s]."""

LONGEST_MEASUREMENT = 60.0
"""Timeout of a measurement [s]."""

AT_ONCE = 20
"""Number of sessions that are opened at the same time."""


@dataclass
class Lesson:
    """Results: seconds of openings and answers, times of answers and measurements, errors, load of the server."""

    opened: list[float] = field(default_factory=list)
    waits: list[float] = field(default_factory=list)
    waits_ended: list[float] = field(default_factory=list)
    measured: list[tuple[float, float]] = field(default_factory=list)
    errors: Counter[str] = field(default_factory=Counter)
    processor: float = 0.0
    memory: float = 0.0
    bytes: int = 0
    messages: int = 0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--sessions", type=int, default=100)
    parser.add_argument("--page", default="oscillator", choices=[*PAGES, "spread", "every"])
    parser.add_argument("--slider", default="m", help="the widget key of the slider that is moved (default: m)")
    parser.add_argument("--seconds", type=float, default=30, help="how long the class works (default: 30)")
    parser.add_argument("--seed", type=int, default=1729)
    parser.add_argument("--processes", type=int, default=0, help="run 1 or 2 processes behind HAProxy, by the recipe")
    parser.add_argument("--measuring", type=int, default=0, help="number of further sessions that measure the speed")
    parser.add_argument("--looking", type=int, default=0, help="number of further sessions that open every page once")
    parser.add_argument("--voting", type=int, default=0, help="number of phones that vote in a class")
    parser.add_argument("--browsers", type=int, default=8, help="pages in browsers while others vote (default: 8)")
    arguments = parser.parse_args()
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    if arguments.voting:
        with running(ROOT / "app.py") as address:
            asyncio.run(_vote(address, arguments))
        return
    load, _five_minutes, _fifteen_minutes = os.getloadavg()
    print(f"{os.cpu_count()} cores, load {load:.1f}, {arguments.sessions} sessions, {arguments.seconds:g} s\n")
    with tempfile.TemporaryDirectory() as folder:
        bare = Path(folder) / "bare.py"
        bare.write_text(BARE)
        print(HEAD)
        lessons = {"bare page": lesson(bare, [""], arguments)}
        report("bare page", lessons["bare page"])
        others = [_measure] * arguments.measuring + [_look] * arguments.looking
        for name in PAGES if arguments.page == "every" else [arguments.page]:
            pages = list(PAGES.values()) if name == "spread" else [PAGES[name]]
            lessons[name] = lesson(ROOT / "app.py", pages, arguments, others)
            report(name, lessons[name], lessons["bare page"])


def lesson(script: Path, pages: list[str], arguments: argparse.Namespace, others: Sequence[Callable] = ()) -> Lesson:
    """Run the sessions of a class on these pages, together with the other coroutines, and return the results."""
    if arguments.processes and script == ROOT / "app.py":
        with deployed(arguments.processes) as hall:
            return asyncio.run(
                _lesson(hall.address, [process.pid for process in hall.processes.values()], pages, arguments, others)
            )
    server = running(script)
    with server as address:
        return asyncio.run(_lesson(address, [server.process.pid], pages, arguments, others))


async def _lesson(
    address: str, processes: list[int], pages: list[str], arguments: argparse.Namespace, others: Sequence[Callable]
) -> Lesson:
    results = Lesson()
    # Warm up each process.
    for page in pages:
        for _ in processes:
            await _warm(address, page, arguments)
    before = memory(processes)
    visitors = [Visitor(address, pages[number % len(pages)]) for number in range(arguments.sessions)]
    gate = asyncio.Semaphore(AT_ONCE)
    opened = await asyncio.gather(*(_open(visitor, gate, results) for visitor in visitors))
    visitors = [visitor for visitor in opened if visitor]
    results.memory = (memory(processes) - before) / max(len(visitors), 1)
    received = [(visitor.received, visitor.messages) for visitor in visitors]
    start = processor_time(processes)
    end = perf_counter() + arguments.seconds
    await asyncio.gather(
        *(_work(visitor, end, number, results, arguments) for number, visitor in enumerate(visitors)),
        *(other(address, end, results) for other in others),
    )
    results.processor = processor_time(processes) - start
    results.bytes = sum(visitor.received - bytes_ for visitor, (bytes_, _) in zip(visitors, received, strict=True))
    results.messages = sum(visitor.messages - count for visitor, (_, count) in zip(visitors, received, strict=True))
    await asyncio.gather(*(visitor.close() for visitor in visitors))
    return results


async def _warm(address: str, page: str, arguments: argparse.Namespace) -> None:
    visitor = Visitor(address, page)
    await visitor.open()
    await visitor.move(arguments.slider, random.Random(arguments.seed))
    await visitor.close()


async def _open(visitor: Visitor, gate: asyncio.Semaphore, results: Lesson) -> Visitor | None:
    async with gate:
        try:
            results.opened.append(await visitor.open())
        except (VisitError, OSError) as problem:
            results.errors[f"opening: {problem}"] += 1
            return None
        return visitor


async def _work(visitor: Visitor, end: float, number: int, results: Lesson, arguments: argparse.Namespace) -> None:
    """Move the slider at random times until the end."""
    chance = random.Random(arguments.seed * 100_003 + number)
    due = perf_counter() + chance.uniform(0, CHANGE_INTERVAL)
    while due < end:
        await asyncio.sleep(max(0.0, due - perf_counter()))
        due = perf_counter() + chance.uniform(0.75, 1.25) * CHANGE_INTERVAL
        try:
            results.waits.append(await visitor.move(arguments.slider, chance))
            results.waits_ended.append(perf_counter())
        except (VisitError, OSError) as problem:
            results.errors[str(problem)] += 1
            return


async def _look(address: str, _end: float, results: Lesson) -> None:
    """Open every page once."""
    for page in PAGES.values():
        visitor = Visitor(address, page)
        try:
            await visitor.open()
        except (VisitError, OSError) as problem:
            results.errors[f"looking: {problem}"] += 1
        await visitor.close()


async def _measure(address: str, end: float, results: Lesson) -> None:
    """Measure the diagram of the speed page. The first measurement computes the errors, too; the others only times."""
    visitor = Visitor(address, "speed?topic=price")
    try:
        await visitor.open()
        await asyncio.sleep(CHANGE_INTERVAL)
        while perf_counter() < end:
            seconds = await visitor.press("measure", LONGEST_MEASUREMENT)
            results.measured.append((perf_counter() - seconds, perf_counter()))
    except (VisitError, OSError) as problem:
        results.errors[f"measuring: {problem}"] += 1
    await visitor.close()


COUNTED = """() => {
  window.counted = [];
  const look = () => {
    const match = document.querySelector(".st-key-class_wall_foot")?.textContent.match(/^\\d+/);
    if (match && window.counted.length <= match[0]) window.counted[match[0]] ??= Date.now() / 1000;
  };
  new MutationObserver(look).observe(document.body, { childList: true, subtree: true, characterData: true });
}"""
"""Script in the wall's page that records when each number of votes is first shown."""


async def _vote(address: str, arguments: argparse.Namespace) -> None:
    """Vote once from each phone, and print the delays until the wall has counted the votes."""
    opened, stop, chance = shared().open_class(), STOPS[0], random.Random(arguments.seed)
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        pages = [await (await browser.new_context(bypass_csp=True)).new_page() for _ in range(arguments.browsers)]
        await pages[0].goto(f"{address}/lesson?class={opened.code}&wall=on&view=projector")
        for page in pages[1:]:
            await page.goto(f"{address}/lesson?class={opened.code}")
            await page.locator(".st-key-class_phone").wait_for(timeout=60_000)
        shared().ask(opened.key, stop.id, list(stop.options))
        await pages[0].locator(".st-key-wall_asked").wait_for(timeout=60_000)
        await pages[0].evaluate(COUNTED)
        gate, results = asyncio.Semaphore(AT_ONCE), Lesson()
        phones = [Visitor(address, f"lesson?class={opened.code}") for _ in range(arguments.voting)]
        opened_phones = await asyncio.gather(*(_open(phone, gate, results) for phone in phones))
        phones = [phone for phone in opened_phones if phone]
        vote_times = []

        async def answer(phone: Visitor) -> None:
            start, due = perf_counter(), chance.uniform(1, arguments.seconds)
            while perf_counter() - start < arguments.seconds + 5:
                if due and perf_counter() - start > due:
                    due = None
                    vote_times.append(time.time())
                    await phone.choose(chance.randrange(len(stop.options)))
                results.waits.append(await phone.poll())
                await asyncio.sleep(chance.uniform(0, 2 * PHONE_INTERVAL))

        await asyncio.gather(*map(answer, phones))
        count_times = await pages[0].evaluate("counted")
        await browser.close()
    shared().close(opened.key)
    # A number that the wall skipped was counted with the next one.
    delays = []
    for number, vote_time in enumerate(sorted(vote_times), start=1):
        first_count = min(count_time for count_time in count_times[number:] if count_time)
        delays.append(first_count - vote_time)
    p50, p95, _ = quantiles(delays)
    print(f"{len(delays)} votes on the wall after p50 {p50:.2f} s, p95 {p95:.2f} s, longest {max(delays):.2f} s")
    print(f"a phone’s look took p95 {1000 * quantiles(results.waits)[1]:.0f} ms; {dict(results.errors) or 'no errors'}")


HEAD = (
    f"{'':<14}{'p50':>9}{'p95':>9}{'p99':>9}{'longest':>9}{'answers':>9}{'errors':>8}{'CPU a run':>11}{'bytes':>9}"
    f"{'messages':>10}{'a session':>12}{'opening p95':>13}"
)


def report(name: str, results: Lesson, bare: Lesson | None = None) -> None:
    """Print one line for a lesson, and its processor time relative to the bare page."""
    runs = max(len(results.waits), 1)
    p50, p95, p99 = quantiles(results.waits)
    columns = [f"{1000 * value:>6.0f} ms" for value in (p50, p95, p99, max(results.waits, default=float("nan")))]
    columns += [f"{len(results.waits):>9}", f"{sum(results.errors.values()):>8}"]
    columns += [
        f"{1000 * results.processor / runs:>8.1f} ms",
        f"{results.bytes / runs:>9.0f}",
        f"{results.messages / runs:>10.0f}",
    ]
    columns += [f"{results.memory / 2**20:>8.2f} MiB", f"{1000 * quantiles(results.opened)[1]:>10.0f} ms"]
    print(f"{name:<14}{''.join(columns)}", flush=True)
    if bare:
        ratio = (results.processor / runs) / (bare.processor / max(len(bare.waits), 1))
        print(f"{'':<14}{ratio:.2f} × the bare page’s processor time a run")
    if results.measured:
        begin, end = results.measured[0]
        print(f"{'':<14}the diagram took {end - begin:.1f} s")
        waits = [
            wait
            for wait, ended in zip(results.waits, results.waits_ended, strict=True)
            if ended > begin and ended - wait < end
        ]
        print(f"{'':<14}{len(waits)} answers during it, the longest after {1000 * max(waits, default=0):.0f} ms")
    for error, count in results.errors.most_common(5):
        print(f"{'':<14}{count} × {error}")


def quantiles(values: list[float]) -> tuple[float, float, float]:
    """Return the median, the 95th and the 99th percentile."""
    if len(values) < 2:
        return (float("nan"),) * 3
    cuts = statistics.quantiles(values, n=100, method="inclusive")
    return cuts[49], cuts[94], cuts[98]


def processor_time(processes: Iterable[int]) -> float:
    """Return the processor time of the processes [s]."""
    ticks = os.sysconf("SC_CLK_TCK")
    # The fields after the name in brackets: 11 and 12 are utime and stime.
    fields = (Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split() for process in processes)
    return sum((int(stat[11]) + int(stat[12])) / ticks for stat in fields)


def memory(processes: Iterable[int]) -> float:
    """Return the memory of the processes [bytes]."""
    pages = (int(Path(f"/proc/{process}/statm").read_text().split()[1]) for process in processes)
    return sum(pages) * os.sysconf("SC_PAGE_SIZE")


if __name__ == "__main__":
    main()
