"""The texts of the stage: templates that the page fills with numbers, and the texts of stage.html."""

from ramanujan.text.names import BODIES, CONTACTS, SHAPES, SPRING
from ramanujan.text.translation import _, pgettext

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
    "close": _("Now the hands agree to {least} turns."),
    "ahead": _("Now the machine is {turns} turns ahead."),
    "behind": _("Now the machine is {turns} turns behind."),
    # TRANSLATORS: {sentence} is one about the hands. {periods} is the number of periods in the question of the lesson.
    "counting": _("{done} of {periods} periods. {sentence}"),
    "energy_share": _("Energy: {share} of that at release."),
    # TRANSLATORS: turns of the machine's hand, a whole number, compared with the other hand.
    "meets_ahead": _("Now the hands meet. Full turns gained: {turns}."),
    "meets_behind": _("Now the hands meet. Full turns lost: {turns}."),
    "stays_ahead": _("The machine stays {turns} turns ahead, until both start together."),
    "stays_behind": _("The machine stays {turns} turns behind, until both start together."),
    # TRANSLATORS: the clock hand of the machine, compared with that of the plain mass; periods of the plain mass.
    "gains": _("The machine gains one full turn in {periods} periods."),
    "loses": _("The machine loses one full turn in {periods} periods."),
    "never_parts": _("In step: the hands never part."),
    "in_step": _("In step: the drift is less than {least} turns in a million periods."),
    # TRANSLATORS: legend of an arrow on the clock face, which shows the angle gained in so many periods.
    "drift": _("drift in {periods} periods"),
    "beats": _("{beats} beats a second: in one beat the hands part by one full turn."),
    # TRANSLATORS: {ratio} is a number such as 1.32.
    "two_tones": _("Two different tones: their frequencies have the ratio {ratio}."),
    "one_tone": _("One tone: no beat, however long you listen."),
    "sped_up": _("You hear both motions {factor} times as fast as they are."),
    "no_sound": _("This browser plays no sound here."),
    "same_drift_k": _("k makes both {factor} times as fast, so the drift stays the same."),
    "same_drift_m": _("m and m′ make both {factor} times as fast, so the drift stays the same."),
    # TRANSLATORS: {run} is the name of a method with its number of steps per period.
    "counted": _("Dashed: {run}. After {period} of {periods} periods: {evaluations} evaluations of the force."),
    "computed_dial": _(
        "A clock with two hands, seen once a period: the exact hand is at the top, and the computed hand is ahead or "
        "behind by the phase error. The errors allowed are marked."
    ),
    "computed_hand": _("computed"),
    "exact_hand": _("exact"),
    "computed_agrees": _("Both hands agree to {least} of a turn."),
    "computed_ahead": _("The computed machine is {turns} turns ahead."),
    "computed_behind": _("The computed machine is {turns} turns behind."),
    "once_a_period": _("After each full period, the exact hand is back at the top. Gray band: the error allowed."),
    # TRANSLATORS: the distance between the exact and the computed machine, such as 3.4 cm.
    "gap": _("{gap} apart"),
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
    "bound": _("x₀ must be between {least} and {most}."),
    "restored": _("x₀ is {value} again."),
    "slab_slider": _("Slab: compression x₀"),
    "each": _("mass m′ each"),
    "relative": _("{speed}, relative to the block"),
    "strength": _("{force}: friction on the rollers"),
    "from_ground": _("Seen from the ground."),
    "from_block": _(
        "Seen from the block: the block stands still, and the ground moves. Velocities and traces are relative to the "
        "block, energies still relative to the ground."
    ),
}
"""Key → template of a sentence; the page fills the slots."""

_SLIP = _("The contact {between} would slip: the model no longer holds.")
SLIPS = {contact: _SLIP.format(between=names.between) for contact, names in CONTACTS.items()}
"""Contact → warning when it slips."""

BODY_WORDS = {
    "block": BODIES["block"].label,
    "slab": BODIES["slab"].label,
    "spring": SPRING,
    **SHAPES,
    # TRANSLATORS: {body} is hoop, spherical shell, cylinder or sphere.
    "left": _("left {body}"),
    "right": _("right {body}"),
    "lower": _("lower {body}"),
    "top": _("top {body}"),
}
"""The names of the bodies, and templates for two bodies of the same shape."""

TEXTS = {
    "animated": _("The machine, animated"),
    "displacement_scale": _("arrows: displacements, to scale"),
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
    "energy_bar": _("Energy by body. The parts of the bar change; its length is the total energy."),
    "dial": _("Two clock hands: each makes one full turn in one period. They stay together if both periods are equal."),
    "dial_start": pgettext("place at the top of a clock", "start"),
    "machine_hand": _("machine, Ω"),
    "plain_hand": _("plain mass, √(k/m)"),
    "together": _("Start together"),
    "listen": _("Listen"),
    "listen_hint": _("Hear both oscillations as two tones (L)"),
    "together_hint": _("Set both hands to the start (Home)"),
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
    "save": _("Save picture"),
}
"""Slot of stage.html → its text."""

LAYERS = {
    "energy": (_("Energy"), _("Energy by body")),
    "displacements": (_("Displacements"), _("Displacement of each body from its place before the compression")),
    "arrows": (_("Velocities"), _("Velocity arrows")),
    "forces": (_("Friction"), _("Friction on each roller at its contacts")),
    "traces": (_("Traces"), _("Traces of the rims")),
    "coordinates": (_("Coordinates"), _("Coordinates, and what the bodies share")),
}
"""Layer with a tick box → its title and a short description.

In stage.html, a layer's groups have its name as class or as `data-of`.
"""
GONE_LAYERS = ("weights",)
"""Layers of earlier versions, which links can contain."""
