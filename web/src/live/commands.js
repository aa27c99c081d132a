// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What may be asked of the run, by who came with the token.
import { el } from "../dom.js";

const kStore = "surefoot-token";

/** From the address, out of which it is taken: who is shown the address shall not have it. */
function takeToken() {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (token) {
    sessionStorage.setItem(kStore, token);
    history.replaceState(null, "", location.pathname);
  }
  return token ?? sessionStorage.getItem(kStore);
}

async function ask(command, token) {
  const response = await fetch(`commands/${command}`, {
    method: "POST",
    headers: { "X-Surefoot-Token": token },
  });
  const text = await response.text();
  if (!response.headers.get("content-type")?.startsWith("application/json")) return text.trim();
  const answer = JSON.parse(text);
  return answer.done ? answer.text : `not done: ${answer.text}`;
}

/** The buttons, and show(state), which names the first one and has those that the run knows. */
export function makeCommands() {
  let token = takeToken();
  // The address of a later run, opened where an earlier one was looked at, loads no page.
  addEventListener("hashchange", () => {
    const earlier = token;
    token = takeToken();
    if (token && !earlier) location.reload();
  });
  const said = el("span.note", { role: "status" });
  const element = el("div.controls.chosen", { role: "group", "aria-label": "Commands" });
  if (!token) {
    element.append(
      el(
        "p.note",
        {},
        "To look at only: the address that the program printed has the token with which the run can be told what to do.",
      ),
    );
    return { element, show: () => {} };
  }
  let paused = false;
  const button = (text, name, question) => {
    const made = el("button", { type: "button" }, text);
    made.addEventListener("click", async () => {
      if (question && !confirm(question)) return;
      said.textContent = "asked …";
      try {
        said.textContent = await ask(typeof name === "function" ? name() : name, token);
      } catch (error) {
        said.textContent = `not asked: ${error.message}`;
      }
    });
    return made;
  };
  const pause = button("Pause", () => (paused ? "resume" : "pause"));
  pause.dataset.command = "pause";
  const reset = button("Reset", "reset", "Begin the odometry anew, in a map of its own?");
  reset.dataset.command = "reset";
  const save = button("Save map", "save_map");
  save.dataset.command = "save_map";
  const localize = button("Find place in map", "localize");
  localize.dataset.command = "localize";
  localize.hidden = true;
  element.append(pause, reset, save, localize, said);
  return {
    element,
    show: (state) => {
      paused = state.paused;
      pause.textContent = paused ? "Resume" : "Pause";
      localize.hidden = !state.commands.includes("localize");
    },
  };
}
