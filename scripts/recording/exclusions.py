"""All that is recorded but not compared, because it measures the machine or names a place, and why.

Files are given as patterns of their path in a recipe's folder, columns, keys and datasets as patterns of their name.
"""
import re
from fnmatch import fnmatch

FILES = {
    "*.png": "pictures are drawn from what is compared", "*.svg": "pictures", "*.gif": "pictures", "*.html": "pages",
}

NAMES = [  # file, column / key / dataset
    ("*step.csv", "wall_s"),                 # wall-clock time of a step
    ("*run.json", "wall_s"),                 # wall-clock time of the run
    ("*run.json", "peak_memory_mb"),         # memory
    ("*run.json", "written"),                # date
    ("*run.json", "host"),
    ("*surrogate.toml", "extends"),          # absolute path
    ("*checkpoint_*.h5", "wall_s"),          # wall-clock time of the run
    ("*checkpoint_*.h5", "traces/step_bytes"),  # length of step.csv, in which wall_s has more digits or less
]

# Numbers that are names: of a format, whose version changes when what it calls its values changes.
WORDS = [("*checkpoint_*.h5", "@version"), ("*checkpoint_*.h5", "@format")]

# In printed text, one line at a time. What matches is taken out before the numbers are read.
PRINTED = [
    re.compile(pattern) for pattern in [
        r"[\d.]+ ms\b",                                                    # progress and check: time of a step
        r"ETA .*",                                                         # progress: time left
        r"[\d.]+ MB\b.*",                                                  # check: memory, to the end of its line
        r"(?:\d+ d |\d+ h |\d+ min )*\d+ (?:s|min|h)(?= without output)",  # check: how long the run will take
        r"valsalva (run|fit|calibrate|compare|report|check) .*",           # a command to type
        r"(?<![\w/])(?=[\w.+/-]*[A-Za-z])(?:[\w.+-]*/)+[\w.+-]*",           # a path (or a unit with a slash)
    ]
]
# The table of timings at the end of a run: from the first line of a pair to the second.
TIMINGS = (re.compile(r"\bms/call\b"), re.compile(r"^wall\b"))


def file_is_excluded(file):
    return any(fnmatch(file, pattern) for pattern in FILES)


def name_is_excluded(file, name):
    return any(fnmatch(file, pattern) and fnmatch(name, excluded) for pattern, excluded in NAMES)


def is_a_word(file, name):
    return any(fnmatch(file, pattern) and fnmatch(name, word) for pattern, word in WORDS)


def without_machine(text):
    """The lines of a printed text as (number of the line, line) without what measures the machine."""
    lines, in_table = [], False
    for number, line in enumerate(text.splitlines(), 1):
        in_table = in_table or bool(TIMINGS[0].search(line))
        if not in_table:
            for pattern in PRINTED:
                line = pattern.sub("~", line)
            lines.append((number, line))
        in_table = in_table and not TIMINGS[1].search(line)
    return lines
