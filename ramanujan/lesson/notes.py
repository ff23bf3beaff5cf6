"""What the lecturer's notes begin with, and their sources; what each stop is for stands with the stop."""

from __future__ import annotations

from ramanujan.translation import _

SOURCES = (
    "C. H. Crouch, A. P. Fagen, J. P. Callan, E. Mazur, “Classroom demonstrations: Learning tools or entertainment?”, "
    "Am. J. Phys. 72, 835 (2004).",
    "E. Mazur, Peer Instruction: A User’s Manual (Prentice Hall, 1997).",
    "R. White, R. Gunstone, Probing Understanding (Falmer, 1992).",
    "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration (Springer, 2006).",
)
"""Students who only watch a demonstration understand it no better than those who never saw it [1]; voting twice, with a
discussion between the votes, is from [2]; predict, observe, explain from [3]."""


INTRODUCTION = _(
    "Let everyone commit to an answer before the machine runs. Students who only watch a demonstration understand it "
    "no better than students who never saw it [1]. Where the answers differ, let neighbours discuss and vote again "
    "[2]. The order predict, observe, explain is from [3]. What students are expected to answer is a guess, except "
    "where a source is named."
)
