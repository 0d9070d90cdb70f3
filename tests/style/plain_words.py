#!/usr/bin/python3
"""Rejects words that a native reader would trip over, in pages, scripts, messages and comments.

    plain_words.py ROOT        exit code 1 and one line per offence: file:line: the words: what to write instead

Markdown, TOML and shell scripts are read whole, C++ and Python in their comments and strings only. Names of the program
(center_cm, FiberNetwork) are not words; strings without a space are not prose.
"""
import io
import pathlib
import re
import sys
import tokenize

PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
FOLDERS = ["docs", "cases", "validation", "scripts", "src"]

# words, as a regular expression in which a space stands for any white space -> what to write instead
PLAIN = [
    # British spelling
    (r"fibers?", "fibre"),
    (r"centers?|centered|centering", "centre, centred, centring"),
    (r"colors?|colored|coloring", "colour"),
    (r"gray", "grey"),
    (r"neighbors?|behavior|favorable", "-our: neighbour, behaviour"),
    (r"modeled|modeling|labeled|labeling", "modelled, labelled"),
    # documents and stages of the project that a reader does not have
    (r"design notes|design's|of the design|project's notes", "cite something that a reader can open, or nothing"),
    (r"set B", "the default anatomy"),
    (r"prototypes?|prototype's|throw-?away", "cite something that a reader can open, or nothing"),
    # the field's terms
    (r"(?:no|the|its) ring|the ring's|ring after", "ringing (a valve ring is the annulus)"),
    (r"(?:last |let )?swings?", "oscillation, residual ringing"),
    (r"flowed back|closed, it held", "regurgitated, none once closed"),
    (r"entered the 3D domain and did not leave(?: it)?", "mass-balance error"),
    (r"ill (?:valves?|leaflets?)", "diseased"),
    (r"grown (?:together|to)", "fused"),
    (r"largest orifice", "maximum orifice area"),
    (r"least flow", "minimum flow"),
    (r"books of|the books|coupled books", "beat statistics, balance"),
    (r"again and again", "recursively, repeatedly"),
    (r"sets? out|setting out", "is released (markers)"),
    (r"(?:does|do|not|that) answers? to|answers? to (?:the 3D|a change)", "responds to; of a solver: did not converge"),
    (r"(?:mmHg|ml|mJ) are left", "residual"),
    (r"divergence left|left of div u", "remaining divergence"),
    (r"sums? up to", "accumulated"),
    (r"shak(?:e|es|en|ing)|shook|to tatters", "oscillates"),
    (r"numbers? (?:go|goes|went|that go) bad|went bad", "diverged"),
    (r"blown? to pieces|torn about", "diverged, flung about"),
    (r"root of the quadratic", "solution of the quadratic"),
    (r"on the root rank|root rank|on root", "on rank 0"),
    # plain English
    (r"anew", "again; recompute, restart, reassign"),
    (r"in vain", "without success"),
    (r"besides(?: that)?", "also, other"),
    (r"mistakes? of the program|every mistake|mistakes are", "internal error; error"),
    (r"left out", "omitted, skipped, removed"),
    (r"takes? (?:\w+ )?(?:arguments )?through", "passes"),
    (r"(?:go|goes|went|going) on(?: behind)?", "continue"),
    (r"at the latest", "at least"),
    (r"[;.,] between,", "in between,"),
    (r"(?:beat|those|ones?) under way", "current, in progress"),
    (r"a hair", "slightly"),
    (r"made-?up", "synthetic"),
    (r"passed over", "skipped"),
    (r"cuts? (?:\w+ ){0,2}back", "truncates"),
    (r"takes? note of", "records"),
    (r"renew(?:s|ed|al|ing)?", "update, recompute, refill"),
    (r"who may include whom", "include rules"),
    (r"held against|holds? [^.;:]{1,60} against", "checks, compares with"),
    (r"mends?|mended|mending", "fix"),
    (r"no word of", "does not report"),
    (r"carried off", "leaving as"),
    (r"tells? (?:what|which|where|how|of|when|why)|told from", "reports, shows, distinguishes"),
    (r"for its sake", "because of it"),
    (r"the steps? to come", "the next step"),
    (r"none of ours|(?:is|are) ours", "not of the program; added here"),
    (r"for people", "human-readable, as text"),
    (r"from (?:the )?commissures? on", "starting at the commissure"),
    (r"twins?", "0D version"),
    (r"over and over", "repeatedly"),
    (r"ends of the files", "lengths of the files"),
]
PATTERNS = [(re.compile(r"(?<!\w)(?:" + words.replace(" ", r"\s+") + r")(?!\w)", re.IGNORECASE), plain)
            for words, plain in PLAIN]

CODE = "\0"  # stands for what is not prose, so that no phrase reaches across it
CPP_PROSE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?P<raw>.*?)\)"|"(?:\\.|[^"\\\n])*"' + r"|'(?:\\.|[^'\\\n])'", re.DOTALL)


def blanked(text):
    """Code: white space stays, so that wrapped comments and split strings remain one phrase."""
    return re.sub(r"\S", CODE, text)


def prose_of_literal(literal):
    """A comment without its marks, or a string without its quotes; a string without a space is code."""
    is_comment = literal.startswith(("//", "/*", "#"))
    if not is_comment and " " not in literal:
        return blanked(literal)
    marks = r"^(?:///?<?|/\*|#)|\*/$" if is_comment else r'^\w{0,2}(?:"""|\'\'\'|"\(|"|\')|(?:"""|\'\'\'|\)"|"|\')$'
    bare = re.sub(marks, lambda found: " " * len(found.group()), literal)
    if re.match(r"\w?f", literal):
        bare = re.sub(r"\{[^{}]*\}", lambda found: CODE * len(found.group()), bare)
    return re.sub(r"\\[nt]", "  ", bare)


def prose_of_cpp(text):
    pieces, end = [], 0
    for found in CPP_PROSE.finditer(text):
        pieces += [blanked(text[end:found.start()]), prose_of_literal(found.group())]
        end = found.end()
    return "".join(pieces) + blanked(text[end:])


def prose_of_python(text):
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    wanted = {tokenize.COMMENT, tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", None)}
    pieces, end = [], 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in wanted:
            first, last = (starts[row - 1] + column for row, column in (token.start, token.end))
            pieces += [blanked(text[end:first]), prose_of_literal(text[first:last])]
            end = last
    return "".join(pieces) + blanked(text[end:])


def prose_of(name, text):
    """The text with everything that is not prose blanked out; lines and columns stay."""
    if name.endswith((".cpp", ".hpp")):
        return prose_of_cpp(text)
    return prose_of_python(text) if name.endswith(".py") else text


def offences_in(name, text):
    """[(line, words found, what to write instead)], in order."""
    prose = prose_of(name, text)
    found = []
    for pattern, plain in PATTERNS:
        for match in pattern.finditer(prose):
            found.append((prose.count("\n", 0, match.start()) + 1, " ".join(match.group().split()), plain))
    return sorted(found)


def files(root):
    yield from (root / page for page in PAGES)
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            has_prose = path.suffix in {".md", ".py", ".toml", ".txt", ".js", ".cpp", ".hpp", ""}
            if path.is_file() and has_prose and "__pycache__" not in path.parts:
                yield path


def main(root):
    count = 0
    for path in files(root):
        name = path.relative_to(root).as_posix()
        for line, words, plain in offences_in(name, path.read_text()):
            print(f'{name}:{line}: "{words}": {plain}')
            count += 1
    print(f"{count} offences" if count else "the words are plain")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
