// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The page of a live run: it is told what is new, and draws it as often as it can be seen.
import { Store } from "../store.js";
import { followTheme } from "../theme.js";
import { makeCommands } from "./commands.js";
import { addLiveHeader } from "./live_header.js";
import { LiveRun } from "./live_run.js";
import { addLiveViews } from "./live_views.js";

/** The action, so many milliseconds after it was first asked for. */
function within(milliseconds, action) {
  let due;
  return () => {
    due ??= setTimeout(() => {
      due = undefined;
      action();
    }, milliseconds);
  };
}

const page = document.getElementById("live");
const store = new Store({
  run: 0,
  cursor: null, // [s] the instant that all views mark
  playing: false,
  axis: "time",
  range: null,
  shade: "run",
  themeWish: "auto",
  theme: "light",
});
followTheme(store);

const live = new LiveRun();
let run = live.run;
const context = {
  store,
  run: () => run,
  recording: () => ({ name: "live", truth: null }),
  companions: () => [run],
};
const commands = makeCommands();
const header = addLiveHeader(page, store, commands.element);
const views = addLiveViews(page, context);
const drawPaths = within(400, () => {
  run = live.run;
  views.drawPaths();
});
const drawCharts = within(1000, views.drawCharts);

const events = new EventSource("events");
events.onopen = () => header.say("as it runs");
events.onerror = () => header.say("no word from the run: it has ended, or cannot be reached");
events.onmessage = ({ data }) => {
  live.take(JSON.parse(data));
  header.show(live);
  commands.show(live.state);
  drawPaths();
  drawCharts();
  document.documentElement.dataset.ready = "true";
};
window.surefootLive = { live, store }; // for the console
