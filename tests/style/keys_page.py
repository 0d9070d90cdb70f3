#!/usr/bin/python3
"""Compares docs/keys.md with what the program prints.

    keys_page.py ROOT VALSALVA        exit code 1 if they differ
"""
import pathlib
import subprocess
import sys


def main(root, program):
    printed = subprocess.run([program, "keys", "--markdown"], capture_output=True, text=True, check=True).stdout
    page = pathlib.Path(root, "docs", "keys.md")
    if page.is_file() and page.read_text() == printed:
        return 0
    print("docs/keys.md is not what the program prints; update it with:\nbuild/release/valsalva keys --markdown > docs/keys.md")
    return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
