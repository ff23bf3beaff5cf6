// The button that copies the address of the page. Browsers keep the clipboard from pages that are not served securely:
// there the text itself is offered.

export default ({ parentElement }) => {
  const [button, output, input] = parentElement.querySelectorAll("button, output, input");
  button.onclick = async () => {
    try {
      await navigator.clipboard.writeText(location.href);
      output.textContent = "Copied.";
    } catch {
      output.textContent = "Copy it from here:";
      input.hidden = false;
      input.value = location.href;
      input.select();
    }
  };
};
