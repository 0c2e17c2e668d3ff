// SPDX-License-Identifier: GPL-3.0-or-later
// A button on every block of text or commands that copies it, without the prompts.
"use strict";

for (const block of document.querySelectorAll("pre")) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "copy";
  button.textContent = "copy";
  button.addEventListener("click", async () => {
    const text = block.cloneNode(true);
    for (const prompt of text.querySelectorAll(".prompt")) prompt.remove();
    await navigator.clipboard.writeText(text.textContent);
    button.textContent = "copied";
    setTimeout(() => { button.textContent = "copy"; }, 1200);
  });
  const frame = document.createElement("div");
  frame.className = "copied";
  block.replaceWith(frame);
  frame.append(block, button);
}
