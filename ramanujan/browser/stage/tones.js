// Two tones that beat: the oscillations of the plain mass and of the machine, sped up by the same factor. One beat is
// therefore one full turn between the clock hands.

const AMPLITUDE = 0.12; // of each tone; both together stay below 0.25, which is −12 dB of full scale
const RAMP = 0.03; // s, for a change of the volume: a jump would click
const GLIDE = 0.02; // s, for a change of the frequency
const BRIGHTNESS = 1200; // Hz; a filter damps the higher partials, so that the tones are soft

/**
 * Play the tone of the plain mass at a frequency [Hz]. Return `tune(ratio)`, which plays that of the machine, too, at
 * `ratio` times this frequency, and `stop()`, which also closes the context.
 *
 * In step (ratio 1), both tones would be equal, but loud or silent as their phases happen to be. So the machine's tone
 * then fades into that of the plain mass, which becomes twice as loud.
 */
export function playTones(plainFrequency, context) {
  const volume = new GainNode(context, { gain: 0 });
  const filter = new BiquadFilterNode(context, { type: "lowpass", frequency: BRIGHTNESS });
  filter.connect(volume).connect(context.destination);
  const plain = addTone(plainFrequency, filter), machine = addTone(plainFrequency, filter);
  const approach = (parameter, value, duration) =>
    parameter.setTargetAtTime(value, context.currentTime, duration / 3);

  function tune(ratio) {
    approach(machine.oscillator.frequency, plainFrequency * ratio, GLIDE);
    approach(machine.amplitude, ratio === 1 ? 0 : AMPLITUDE, RAMP);
    approach(plain.amplitude, ratio === 1 ? 2 * AMPLITUDE : AMPLITUDE, RAMP);
  }

  function stop() {
    approach(volume.gain, 0, RAMP);
    setTimeout(() => context.close?.(), 10 * RAMP * 1000);
  }

  approach(volume.gain, 1, RAMP);
  return { tune, stop };
}

/** Start a silent tone that is played through a filter. */
function addTone(frequency, filter) {
  const oscillator = new OscillatorNode(filter.context, { type: "triangle", frequency });
  const gain = new GainNode(filter.context, { gain: 0 });
  oscillator.connect(gain).connect(filter);
  oscillator.start();
  return { oscillator, amplitude: gain.gain };
}
