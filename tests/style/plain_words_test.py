#!/usr/bin/python3
"""plain_words.py finds known bad sentences, in prose only, and accepts their plain versions."""
import sys

sys.dont_write_bytecode = True
from plain_words import offences_in

BAD = [
    "Convection is found anew before the CFL numbers of the steps since the last time sum up to more, at the latest in every "
    "eighth step; between, it is extrapolated in time.",
    "While it closed 7.6 ml flowed back; closed, it held, which leaves a stroke volume of 82.9 ml.",
    "0.021 ul entered the 3D domain and did not leave it",
    "A negative leak is the ring's last swing, not a flow through the valve.",
    "The beat under way and the ends of the files; reading, cuts the files back to there and goes on behind.",
    "planes that halve the domain again and again so that the work on both sides is in proportion to the ranks",
    "the circulation does not answer to the 3D flow: 0.1 mmHg are left",
    "1 a mistake of the program; 3 the numbers went bad",
    "the books of a beat; besides; what is left out; ill valves; goes on",
    "the default anatomy (the design's \"set B\")",
    "in vain", "design notes", "a prototype", "takes arguments through", "a fiber near the center",
]
GOOD = [
    "Recompute convection when the accumulated CFL number would exceed this value, and at least every eighth step; "
    "extrapolate in between.",
    "7.6 ml regurgitated during closure and none once closed; net stroke volume 82.9 ml.",
    "Mass-balance error over the last beat: 0.021 ul.",
    "A negative leak is residual ringing after closure, not flow through the valve.",
    "Saves the current beat's samples and each CSV's length; on restore truncates to those lengths and appends.",
    "weighted recursive coordinate bisection",
    "3D-0D coupling did not converge: residual 0.1 mmHg after 40 iterations",
    "1 internal error (please report); 3 the solver diverged",
    "beat statistics; other quantities; skipped; diseased valves; continues",
    "`root.center_cm`, `FiberNetwork`, a valve ring, between the leaflets",
]
CPP = '''#include "ib3d/structure/fiber force.hpp"
double center = anew(fiber);  // the centre, found
                              // anew
throw Error("the numbers "
            "went bad");
char c = '"'; /* in vain */ const char* one = R"(what is
left out)";
int vain = in(vain), besides = 0;
'''
PYTHON = '''"""The fiber.

Found anew."""
import center
print(f"it goes on at {center} s", ha="center")  # in vain
besides = anew
'''
offences = [f"not found: {text}" for text in BAD if not offences_in("page.md", text)]
offences += [f"{offences_in('page.md', text)} in: {text}" for text in GOOD if offences_in("page.md", text)]
for name, source, expected in [
        ("a.cpp", CPP, [(1, "fiber"), (3, "anew"), (4, "numbers went bad"), (6, "in vain"), (7, "left out")]),
        ("a.py", PYTHON, [(1, "fiber"), (3, "anew"), (5, "goes on"), (5, "in vain")])]:
    found = [(line, words) for line, words, _ in offences_in(name, source)]
    if found != expected:
        offences.append(f"{name}: found {found}, expected {expected}")
print("\n".join(offences))
sys.exit(1 if offences else 0)
