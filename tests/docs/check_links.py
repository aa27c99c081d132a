#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Whether every link and picture of the documents leads to a file of the project, and every anchor
to a heading or an `<a id>` there. Addresses elsewhere are not asked for.

    check_links.py [PAGE...]        README.md, CHANGELOG.md, CONTRIBUTING.md and docs/*.md if none is named
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LINK = re.compile(r"\]\(([^)\s]+)\)|(?:href|src)=\"([^\"]+)\"")
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)


def anchors_of(page):
    """As GitHub makes them of headings: small letters, without marks, spaces as hyphens."""
    text = page.read_text()
    headings = re.findall(r"^#+ +(.+)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL), re.MULTILINE)
    plain = (re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading) for heading in headings)
    slugs = {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-") for heading in plain}
    return slugs | set(re.findall(r"<a id=\"([^\"]+)\"", text))


def broken(page):
    for match in LINK.finditer(CODE.sub("", page.read_text())):
        target = match[1] or match[2]
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        if not file.exists():
            yield f"{page.relative_to(ROOT)}: {target}: there is no such file"
        elif anchor and file.suffix == ".md" and anchor not in anchors_of(file):
            yield f"{page.relative_to(ROOT)}: {target}: there is no such heading"


def main():
    named = [pathlib.Path(page).resolve() for page in sys.argv[1:]]
    pages = named or [*map(ROOT.joinpath, ("README.md", "CHANGELOG.md", "CONTRIBUTING.md")),
                      *sorted((ROOT / "docs").glob("*.md"))]
    found = [line for page in pages for line in broken(page)]
    print(*found or [f"every link of {len(pages)} pages leads somewhere"], sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
