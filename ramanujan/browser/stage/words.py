"""The texts of the stage: templates that the page fills with numbers, and the texts of stage.html."""

from ramanujan.translation import _

SENTENCES = {
    "picture": _(
        "A stepped block carries two rollers: a {left} on the left and a {right} on the right. A slab lies on both and "
        "is tied to the block by a spring. On the upper step of the block a {top} rolls freely."
    ),
    "faster": _(
        "The slab oscillates relative to the block with a period of {period}. The machine is faster than the plain "
        "mass: its clock hand gains one full turn in {turns} periods of the plain mass."
    ),
    "slower": _(
        "The slab oscillates relative to the block with a period of {period}. The machine is slower than the plain "
        "mass: its clock hand loses one full turn in {turns} periods of the plain mass."
    ),
    "together": _(
        "The slab oscillates relative to the block with a period of {period}. The machine is in step with the plain "
        "mass."
    ),
    "moment": _("{periods} periods after release, t = {time}."),
    "turned": _("{periods} periods after release."),
    "paused": _("Paused."),
    "playing": _("Playing."),
    "play": _("Play"),
    "pause": _("Pause"),
    "in_slow_motion": _("Shown in slow motion."),
    "slowed": _("Shown at {factor} times its real speed, so that the eye can follow."),
    "lapsed": _("Shown at {factor} times its real speed."),
    "start": _("Both hands start together."),
    "close": _("The hands agree to {least} turns after {periods} periods of the plain mass."),
    "ahead": _("The machine is {turns} turns ahead after {periods} periods of the plain mass."),
    "behind": _("The machine is {turns} turns behind after {periods} periods of the plain mass."),
    "before": _("The hands are {turns} turns apart {periods} periods before they meet."),
    "parting": _("After {periods} plain-mass periods the hands are one full turn apart."),
    "nearly": _("Nearly in step: after {periods} plain-mass periods the hands are one full turn apart."),
    "in_step": _("In step: after a million periods the hands are less than {least} turns apart."),
    "counted": _(
        "Dashed: the computed machine. Period {period} of {periods}: {evaluations} evaluations of the force, {turns} "
        "of a turn off."
    ),
    "shared": _(
        "Mass m: {block}, {slab}, {top}. Mass m′: {hoop}, {cylinder}. All rollers have the radius R. The arrows at X, "
        "φ and Φ point in the positive direction."
    ),
    "edge": _("The top roller reached the edge of the block. The machine was released again."),
    "struck": _("The slab hit the block. The machine was released again."),
    "ended": _("The computed motion ends here. The machine was released again."),
    "edge_ahead": _("Before this time the top roller reaches the edge of the block. The picture stops there."),
    "struck_ahead": _("Before this time the slab hits the block. The picture stops there."),
    "dragged": _("x₀ = {value}"),
    "drag": _("↔ drag: x₀ = {value}"),
    "bound": _("x₀ must be between {least} and {most}. It will be {value} when you let go."),
    "restored": _("x₀ is {value} again."),
    "undo": _("Back to x₀ = {value}"),
    "slab_slider": _("Slab: compression x₀"),
    "each": _("mass m′ each"),
    "relative": _("{speed}, relative to the block"),
    "from_ground": _("Seen from the ground."),
    "from_block": _(
        "Seen from the block: the block stands still, and the ground moves. Velocities and traces are relative to the "
        "block, energies still relative to the ground."
    ),
}
"""Key → template of a sentence; the page fills the slots."""

SLIPS = {
    "hoop_slab": _("The hoop would slip on the slab: the model no longer holds."),
    "cylinder_slab": _("The lower cylinder would slip on the slab: the model no longer holds."),
    "hoop_block": _("The hoop would slip on the block: the model no longer holds."),
    "cylinder_block": _("The lower cylinder would slip on the block: the model no longer holds."),
    "top_block": _("The top cylinder would slip on the block: the model no longer holds."),
}
"""Contact → warning when it slips."""

BODIES = {
    # TRANSLATORS: bodies without an article, also inside of a sentence.
    "block": _("block"),
    "slab": _("slab"),
    "spring": _("spring"),
    "hoop": _("hoop"),
    "shell": _("spherical shell"),
    "cylinder": _("cylinder"),
    "sphere": _("sphere"),
    # TRANSLATORS: {body} is hoop, spherical shell, cylinder or sphere.
    "left": _("left {body}"),
    "right": _("right {body}"),
    "lower": _("lower {body}"),
    "top": _("top {body}"),
}
"""The names of the bodies, and templates for two bodies of the same shape."""

TEXTS = {
    "animated": _("The machine, animated"),
    "machine": _("The machine"),
    "plain": _("A plain mass m on the same spring k"),
    "plain_caption": _("plain mass m, same spring k"),
    "block": _("Block, mass m"),
    "spring": _("Spring, stiffness k"),
    "left_roller": _("Left roller, mass m′"),
    "right_roller": _("Right roller, mass m′"),
    "top_roller": _("Top roller, mass m"),
    "slab": _("Slab, mass m"),
    "stiffness": "k",
    "centre": _("Centre of mass of the whole machine"),
    "centre_caption": _("centre of mass"),
    "energy_bar": _("Energy by body. The parts of the bar change; its length, the total energy, stays the same."),
    "dial": _("Two clock hands: each makes one full turn in one period. They stay together if both periods are equal."),
    "machine_hand": _("machine, Ω"),
    "plain_hand": _("plain mass, √(k/m)"),
    "gauge": _("Gauge of Ω²m/k: at 1 the machine is in step with the plain mass."),
    "in_step": _("in step"),
    "period": _("Period"),
    "playback": _("Playback"),
    "restart_hint": _("Release again (Home)"),
    "restart": _("Release again"),
    "back_hint": _("Step back (←)"),
    "back": _("Step back"),
    "play_hint": _("Play or pause (space)"),
    "pause": _("Pause"),
    "forward_hint": _("Step forward (→)"),
    "forward": _("Step forward"),
    "scrub": _("Position in the period"),
    "speed": _("Speed"),
    "viewpoint": _("From the block"),
    "viewpoint_hint": _("Seen from the block, which then stands still"),
    "show": _("Steps, speed, view"),
    "save": _("Save the picture:"),
    "svg": "SVG",
    "png": "PNG",
    "tikz": "TikZ",
}
"""Slot of stage.html → its text."""

LAYERS = {
    "energy": (_("Energy"), _("Energy by body")),
    "arrows": (_("Velocities"), _("Velocity arrows")),
    "forces": (_("Forces"), _("Contact forces and spring forces")),
    "weights": (_("Weights"), _("Weights and normal forces")),
    "traces": (_("Traces"), _("Traces of the rims")),
    "coordinates": (_("Coordinates"), _("Coordinates, and what the bodies share")),
}
"""Layer with a tick box → its title and a short description.

In stage.html, a layer's groups have its name as class or as `data-of`.
"""
