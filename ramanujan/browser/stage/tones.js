// Two tones that beat: the oscillations of the plain mass and of the machine, sped up by the same factor. One beat is
// therefore one full turn between the clock hands.

const AMPLITUDE = 0.12; // of each tone; both together stay below 0.25, which is −12 dB of full scale
const RAMP = 0.03; // s, for a change of the amplitudes: a jump would click
const GLIDE = 0.02; // s, for a change of the frequency
const BRIGHTNESS = 1200; // Hz; a filter damps the higher partials, so that the tones are soft

/**
 * Return `play(ratio, isOn)`: it plays the tone of the plain mass at a frequency [Hz], and that of the machine at
 * `ratio` times this frequency, or fades both out.
 *
 * In step (ratio 1), both tones would be equal, but loud or silent as their phases happen to be. So the machine's tone
 * then fades into that of the plain mass, which becomes twice as loud.
 */
export function makeTones(plainFrequency, context) {
  const filter = new BiquadFilterNode(context, { type: "lowpass", frequency: BRIGHTNESS });
  filter.connect(context.destination);
  const plain = addTone(plainFrequency, filter), machine = addTone(plainFrequency, filter);
  const approach = (parameter, value, duration) =>
    parameter.setTargetAtTime(value, context.currentTime, duration / 3);

  return function play(ratio, isOn) {
    const amplitude = isOn ? AMPLITUDE : 0;
    approach(machine.frequency, plainFrequency * ratio, GLIDE);
    approach(machine.amplitude, ratio === 1 ? 0 : amplitude, RAMP);
    approach(plain.amplitude, ratio === 1 ? 2 * amplitude : amplitude, RAMP);
  };
}

/** Start a silent tone that is played through a filter. Return its parameters. */
function addTone(frequency, filter) {
  const oscillator = new OscillatorNode(filter.context, { type: "triangle", frequency });
  const gain = new GainNode(filter.context, { gain: 0 });
  oscillator.connect(gain).connect(filter);
  oscillator.start();
  return { frequency: oscillator.frequency, amplitude: gain.gain };
}
