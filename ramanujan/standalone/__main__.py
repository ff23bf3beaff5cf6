"""Write the standalone file: `python -m ramanujan.standalone --language hu --output oscillator.html`."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

from ramanujan.text.translation import LANGUAGE, language_ids


def main() -> None:
    """Write the file in a language. A process has one language, so another language requires another process."""
    parser = argparse.ArgumentParser(prog="python -m ramanujan.standalone", description=__doc__)
    parser.add_argument("--language", choices=language_ids(), default=LANGUAGE, help="the language of the file")
    parser.add_argument("--output", type=Path, metavar="FILE", help="the file to write; without it, print the file")
    options = parser.parse_args()
    if options.language != LANGUAGE:
        command = [sys.executable, "-m", "ramanujan.standalone", *sys.argv[1:]]
        environment = os.environ | {"RAMANUJAN_LANGUAGE": options.language}
        sys.exit(subprocess.run(command, env=environment, check=False).returncode)
    from ramanujan.standalone import html

    content = f"{html()}\n"
    if options.output is None:
        sys.stdout.write(content)
        return
    try:
        options.output.write_text(content, encoding="ascii")
    except OSError as error:
        sys.exit(f"{options.output} could not be written: {error.strerror}.")


if __name__ == "__main__":
    main()
