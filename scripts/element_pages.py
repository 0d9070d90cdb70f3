#!/usr/bin/python3
"""Writes the manual pages docs/elements/<type>.md: circuit and equations from the comment at the top of the element's
header, keys from docs/keys.md. A test checks that the pages are up to date.

    element_pages.py ROOT [--check]       --check writes nothing; exit code 1 if a page is out of date
"""
import pathlib
import re
import sys


def head_comment(header):
    """The comment at the top of a header, without the slashes."""
    lines = []
    for line in header.read_text().splitlines():
        if not line.startswith("//"):
            break
        lines.append(line[2:].removeprefix(" "))
    return "\n".join(lines)


def header_of(root, element_type):
    """windkessel3 and windkessel4 share windkessel.hpp."""
    return next((root / "src" / "lumped").rglob(re.sub(r"\d$", "", element_type) + ".hpp"))


def pages(root):
    """(element type, text of its page), in the order of docs/keys.md."""
    keys = (root / "docs" / "keys.md").read_text()
    sections = re.findall(r'^### `type = "(\w+)"`\n(.*?)(?=^##|\Z)', keys, re.MULTILINE | re.DOTALL)
    for element_type, table in sections:
        header = header_of(root, element_type)
        yield element_type, (f"# {element_type}\n\nWritten by `scripts/element_pages.py` from "
                             f"[{header.name}](../../{header.relative_to(root)}) and [keys.md](../keys.md).\n\n"
                             f"```\n{head_comment(header)}\n```\n\n## Keys\n{table.rstrip()}\n")


def main(root, check):
    folder, stale = root / "docs" / "elements", []
    for element_type, text in pages(root):
        page = folder / f"{element_type}.md"
        if page.is_file() and page.read_text() == text:
            continue
        stale.append(page.name)
        if not check:
            folder.mkdir(exist_ok=True)
            page.write_text(text)
    if check and stale:
        print(f"docs/elements: {', '.join(stale)} out of date; update them with\nscripts/element_pages.py .")
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), "--check" in sys.argv[2:]))
