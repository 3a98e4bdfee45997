#!/usr/bin/env python3
"""Puts the verdicts that a command printed into a page, in place of those that it shows, with their date and commit.

Usage: COMMAND | docs/printed_lines.py PAGE

The page has one block of indented lines that begins with a verdict, after a paragraph with "(DATE, commit HASH)".
"""
import datetime
import pathlib
import re
import subprocess
import sys

VERDICT = r"(pass|violated|inconclusive|validated|watched, not validated|limits kept) |[A-Z]+: |\d+ of \d+ "
printed = [line for line in sys.stdin.read().splitlines() if re.match(VERDICT, line)]
commit = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
page = pathlib.Path(sys.argv[1])
text, found = re.subn(r"\(\d+ \w+ \d{4}, commit \w+\)(:\n\n)    (?:pass|violated|inconclusive) (?:.*\n)(?:    .*\n)*",
                      lambda old: f"({datetime.date.today():%-d %B %Y}, commit {commit}){old[1]}"
                      + "".join(f"    {line}\n" for line in printed), page.read_text())
if found != 1 or not printed:
    sys.exit(f"{page}: expected one block of verdicts, and printed ones; there are {found} and {len(printed)}")
page.write_text(text)
