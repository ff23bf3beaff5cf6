"""Page 1: the machine, the Ω² curve, the derivation in six steps."""
