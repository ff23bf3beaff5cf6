// The button that copies the address of the page. Browsers keep the clipboard from pages that are not served securely:
// there the text itself is offered.

export default ({ data, parentElement }) => {
  const [button, told, input] = parentElement.querySelectorAll("button, .told, input");
  const tell = (sentence) => {
    told.textContent = sentence;
    bus.publish("say", { sentence, urgent: true });
  };
  button.onclick = async () => {
    try {
      await navigator.clipboard.writeText(location.href);
      tell(data.copied);
    } catch {
      tell(data.by_hand);
      input.hidden = false;
      input.value = location.href;
      input.select();
    }
  };
};
