"""The questions about the derivation, and the judge of a student's answers.

>>> from ramanujan.answers import judge
>>> judge("potential_energy", "½k(Rφ)²").kind
'wrong'
"""

from ramanujan.answers.judge import Verdict, judge
from ramanujan.answers.questions import QUESTIONS, Question, find_answer_equations, find_question
