/** The checker's page. */

import { Catalogue } from "./catalogue";
import { byId, element, settled } from "./elements";
import { Engine, Stopped, TooLong } from "./engine";
import { EXAMPLES } from "./examples";
import { FormulaField } from "./formula_field";
import { fromLink, toLink } from "./link";
import { Pairs } from "./pairs";
import { Paper } from "./paper";
import type { Failure, Found, Question, Suggestion, Verdict } from "./question";
import { formula, typeset } from "./typeset";
import { Details } from "./verdict";

const STATES: Record<string, string> = {
  loading: "Python is being loaded; the first time takes some seconds.",
  python: "The derivations are being loaded.",
  ready: "",
};

const loading = byId("loading");
const engine = new Engine((state) => {
  loading.textContent = STATES[state] ?? `Python does not start here: ${state.replace("failed: ", "")}. `;
  if (state === "ready") {
    read();
    catalogue.ready();
    keepForLater();
  }
});
const field = new FormulaField(() => {
  read();
  stale();
});
const catalogue = new Catalogue(engine);
const given = new Pairs(byId("given"), "condition", stale);
const definitions = new Pairs(byId("let"), "definition", stale);
const paper = new Paper(engine, (text, kind) => {
  byId("details").replaceChildren();
  byId("link-line").hidden = true;
  say(text, kind);
});
let asked = 0; // questions so far; an answer to an older one is not shown

/* What is asked. */

function question(): Question {
  return {
    quantity: catalogue.value,
    formula: field.value,
    notation: field.notation,
    given: given.value,
    let: definitions.value,
  };
}

function put(one: Question): void {
  field.set(one.formula, one.notation);
  catalogue.value = one.quantity;
  given.value = one.given;
  definitions.value = one.let;
  if (Object.keys({ ...one.given, ...one.let }).length) byId<HTMLDetailsElement>("more").open = true;
}

function say(text: string, kind: string, rest = ""): void {
  byId("answer").hidden = false;
  const status = byId("verdict");
  status.className = `verdict ${kind}`;
  status.replaceChildren(element("strong", {}, text), rest);
}

/** A verdict is not that of what stands there now. */
function stale(): void {
  byId("answer").classList.toggle("stale", !byId("answer").hidden);
}

/* How it is read, while it is typed. */

let reading = 0;
const readSoon = settled(250, () => {
  const { formula: text, notation } = question();
  const mine = ++reading;
  const box = byId("reading");
  if (!text) {
    box.replaceChildren();
    return;
  }
  engine.ask<{ mathml: string } | Failure>({ ask: "read", formula: text, notation }, () => {}, 5).then(
    (answer) => {
      if (mine !== reading) return;
      if ("error" in answer) {
        box.replaceChildren(element("pre", { class: "fault" }, answer.error));
      } else {
        const shown = typeset(answer.mathml);
        box.replaceChildren(...(shown ? [formula(answer.mathml, text)] : []));
      }
    },
    () => {
      if (mine === reading) box.replaceChildren(element("p", { class: "fault" }, "This formula takes too long to read."));
    },
  );
});

function read(): void {
  if (engine.ready) readSoon();
}

/* Checking and finding. */

async function check(): Promise<void> {
  const one = question();
  if (!one.formula) {
    say("A formula is missing.", "undecided");
    byId("formula").focus();
    return;
  }
  if (!one.quantity) {
    await find();
    return;
  }
  const mine = begin(one, "Checking …");
  const details = new Details(byId("details"), engine, one, apply);
  let known: Verdict | null = null;
  const show = (answer: Verdict | Failure): void => {
    if (mine !== asked) return;
    if ("error" in answer) {
      cannotRead(answer);
      return;
    }
    if (known?.headline !== answer.headline || known.rest !== answer.rest) say(answer.headline, answer.verdict, answer.rest);
    known = answer;
    details.show(answer);
    linked(one);
  };
  try {
    await engine.ask<Verdict | Failure>({ ask: "check", ...one }, show);
  } catch (error) {
    if (mine === asked) ended(error, known);
  } finally {
    finish(mine);
  }
}

async function find(): Promise<void> {
  const one = question();
  if (!one.formula) {
    say("A formula is missing.", "undecided");
    byId("formula").focus();
    return;
  }
  const mine = begin({ ...one, quantity: "" }, "Looking for it …");
  const show = (answer: { quantities: Found[]; near: Found[] } | Failure): void => {
    if (mine !== asked) return;
    if ("error" in answer) {
      cannotRead(answer);
      return;
    }
    const [first] = answer.quantities;
    if (first) say("found", "equal", `: this is ${first.quantity}${when(first)}, ${first.words}`);
    else if (answer.near.length) say("not found", "undecided", ": no quantity is this formula; these are near");
    else say("not found", "undecided", ": no quantity is this formula, nor near it");
    const list = [...answer.quantities, ...answer.near].map(foundItem);
    byId("details").replaceChildren(element("ul", { class: "suggestions" }, ...list));
    linked({ ...one, quantity: "" });
  };
  try {
    await engine.ask({ ask: "find", formula: one.formula, notation: one.notation }, show, 40);
  } catch (error) {
    if (mine === asked) ended(error, null);
  } finally {
    finish(mine);
  }
}

function when({ given: conditions, convention }: Found): string {
  const said = Object.entries(conditions).map(([name, value]) => `${name} = ${value}`);
  return `${said.length ? ` when ${said.join(" and ")}` : ""}${convention ? ` ${convention}` : ""}`;
}

function foundItem(one: Found): HTMLElement {
  const letters = Object.entries(one.read).map(([letter, symbol]) => `${letter} for ${symbol}`);
  const words = `${when(one)}: ${one.words}${letters.length ? `, with ${letters.join(", ")}` : ""}`;
  const take = (): void => {
    catalogue.value = one.quantity;
    given.value = { ...given.value, ...one.given };
    void check();
  };
  return element(
    "li",
    {},
    element("p", {}, element("code", {}, one.quantity), words),
    element("p", { class: "hint" }, one.meaning),
    formula(one.mathml, one.formula),
    element("button", { type: "button", class: "apply", click: take }, "Check against this"),
  );
}

function begin(one: Question, words: string): number {
  engine.start();
  byId("answer").classList.remove("stale");
  byId("details").replaceChildren();
  byId("link-line").hidden = true;
  byId("stop").hidden = false;
  say(words, "working");
  const hash = toLink(one);
  if (hash !== location.hash) history.pushState(null, "", hash);
  return ++asked;
}

function finish(mine: number): void {
  if (mine === asked) byId("stop").hidden = true;
}

function cannotRead(failure: Failure): void {
  say("cannot read", "undecided", `: ${failure.message ?? failure.error.split("\n")[0]}`);
  byId("details").replaceChildren(...(failure.error.includes("\n") ? [element("pre", { class: "fault" }, failure.error)] : []));
  if (failure.span) field.point(...failure.span);
}

function ended(error: unknown, known: Verdict | null): void {
  if (error instanceof Stopped) {
    if (!known) say("stopped", "undecided", ": nothing was decided");
  } else if (error instanceof TooLong) {
    if (!known) say("cannot decide", "undecided", " in 20 s; one entry, or a condition such as rho = 0, is less work");
    else byId("details").append(element("p", { class: "hint" }, "What else is said beside a verdict was not found in time."));
  } else {
    throw error;
  }
}

function linked(one: Question): void {
  byId<HTMLInputElement>("link").value = new URL(toLink(one), location.href).href;
  byId("link-line").hidden = false;
}

/** One click on what was perhaps meant. */
function apply({ applied }: Suggestion): void {
  const one = question();
  if (applied.quantity) one.quantity = applied.quantity;
  if (applied.let) one.let = { ...one.let, ...applied.let };
  if (applied.text !== undefined) {
    one.formula = one.notation === "latex" ? (applied.latex ?? applied.text) : applied.text;
    if (one.notation === "python") one.notation = "text";
  }
  put(one);
  void check();
}

/* The page itself. */

function fromAddress(): void {
  const one = fromLink(location.hash);
  if (!one) return;
  put(one);
  if (one.formula) void check();
}

function isFile(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") ?? false;
}

async function audit(file: File | undefined): Promise<void> {
  if (!file) return;
  ++asked;
  byId("stop").hidden = false;
  byId("answer").classList.remove("stale");
  byId("paper").scrollIntoView({ block: "nearest" });
  try {
    await paper.audit(file);
  } catch (error) {
    if (!(error instanceof Stopped)) throw error;
    say("stopped", "undecided");
  } finally {
    byId("stop").hidden = true;
  }
}

/** After this visit the page needs no network. */
function keepForLater(): void {
  if (!("serviceWorker" in navigator)) return;
  navigator.serviceWorker.register("service_worker.js").then(
    async () => {
      await navigator.serviceWorker.ready;
      byId("offline").textContent = "From now on it works without a network, too.";
    },
    () => {}, // a private window, or a file: it works as long as there is a network
  );
}

byId("question").addEventListener("submit", (event) => {
  event.preventDefault();
  void check();
});
byId("formula").addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
    event.preventDefault();
    void check();
  }
});
byId("find").addEventListener("click", () => void find());
byId("stop").addEventListener("click", () => engine.stop());
byId("copy").addEventListener("click", () => {
  const link = byId<HTMLInputElement>("link");
  link.select();
  void navigator.clipboard?.writeText(link.value).then(() => (byId("copy").textContent = "Copied"));
  setTimeout(() => (byId("copy").textContent = "Copy"), 2000);
});
byId("file").addEventListener("change", (event) => {
  const input = event.target as HTMLInputElement;
  void audit(input.files?.[0]).then(() => (input.value = ""));
});
byId("shipped").addEventListener("click", () => {
  void fetch("example.toml").then(async (response) => audit(new File([await response.blob()], "gao.toml")));
});
addEventListener("hashchange", fromAddress);
addEventListener("dragover", (event) => {
  if (!isFile(event)) return;
  event.preventDefault();
  byId("drop").hidden = false;
});
addEventListener("dragleave", (event) => {
  if (!event.relatedTarget) byId("drop").hidden = true;
});
addEventListener("drop", (event) => {
  if (!isFile(event)) return;
  event.preventDefault();
  byId("drop").hidden = true;
  void audit(event.dataTransfer?.files[0]);
});
byId("examples").append(
  ...EXAMPLES.map(([words, one]) =>
    element("li", {}, element("a", { href: toLink(one) }, words), element("code", {}, one.quantity || "find")),
  ),
);

loading.textContent = STATES.loading ?? "";
engine.start();
void catalogue.load();
fromAddress();
document.documentElement.dataset.usable = "true";
