// Counts, into window.lags, the animation frames from each move of the m′ slider to the stage's readout.
() => {
  const input = document.querySelector('.st-key-m_prime input[type=range]');
  const stage = document.querySelector('.st-key-stage [data-testid=stBidiComponentIsolated]');
  const readout = stage.shadowRoot.querySelector('[data-read=normalized]');
  let value = input.value, shown = readout.textContent, since = null;
  window.lags = [];
  const watch = () => {
    if (input.value !== value) {
      value = input.value;
      since ??= 0;
    }
    if (readout.textContent !== shown) {
      shown = readout.textContent;
      if (since !== null) window.lags?.push(since);
      since = null;
    } else if (since !== null) since += 1;
    if (window.lags) requestAnimationFrame(watch);
  };
  requestAnimationFrame(watch);
}
