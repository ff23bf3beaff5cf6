"""Print the standalone file: `python -m ramanujan.browser.standalone --language hu > oscillator.html`."""

import argparse
import os
import sys

from ramanujan.translation import LANGUAGE, language_ids


def main() -> None:
    """Print the file in a language. A process has one language, so another language requires another process."""
    parser = argparse.ArgumentParser(prog="python -m ramanujan.browser.standalone", description=__doc__)
    parser.add_argument("--language", choices=language_ids(), default=LANGUAGE, help="the language of the file")
    language = parser.parse_args().language
    if language != LANGUAGE:
        environment = os.environ | {"RAMANUJAN_LANGUAGE": language}
        os.execve(sys.executable, [sys.executable, "-m", "ramanujan.browser.standalone"], environment)
    from ramanujan.browser.standalone import html

    sys.stdout.buffer.write(f"{html()}\n".encode())


if __name__ == "__main__":
    main()
